// SPDX-License-Identifier: GPL-3.0-or-later
// What `stickslip batch` does with a line, and `stickslip margin` with a file. An input is a
// grasp file. Whatever question it asks, the certificate of the answer is accepted by the
// checker, which shares no code with what wrote it, as that of the same answer.
#include <algorithm>
#include <sstream>

#include "check.hpp"
#include "fuzz_target.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/measures/margin.hpp"

namespace {

using namespace stickslip;
using stickslip::fuzz::broken;

/// So that an input takes a moment.
constexpr std::size_t kMostContacts = 8;
constexpr std::size_t kNodeLimit = 200;
constexpr std::size_t kMostBytes = 4000;

stickslip_check::Vector checker_vector(const Wrench& w) {
  using stickslip_check::Rational;
  return {Rational(to_string(w.x)), Rational(to_string(w.y)), Rational(to_string(w.torque))};
}

void expect_accepted(const std::string& grasp, const std::string& certificate,
                     const stickslip_check::Options& options, const std::string& verdict) {
  std::istringstream grasp_in(grasp);
  std::istringstream certificate_in(certificate);
  const auto answer = stickslip_check::check(grasp_in, certificate_in, options);
  const auto* accepted = std::get_if<stickslip_check::Accepted>(&answer);
  if (accepted == nullptr || accepted->verdict != verdict) {
    broken("not accepted as " + verdict + ": " + certificate);
  }
}

void answer(const std::string& text, NormalLaw law) {
  QuestionOptions options;
  options.law = law;
  const Question question = ask(parse_grasp(text, "fuzz"), options);
  const Problem problem = problem_of(question);  // throws of irrational lengths
  if (problem.size() > kMostContacts) return;
  SearchOptions limit;
  limit.node_limit = kNodeLimit;
  stickslip_check::Options asked;
  asked.bilateral = law == NormalLaw::kBilateral;
  const Verdict verdict = branch_and_bound(problem, limit);
  if (!std::holds_alternative<Undecided>(verdict)) {
    expect_accepted(text, certificate_text(question, verdict, "fuzz"), asked, name_of(verdict));
  }
  const auto expect_margin = [&](const QuestionOptions& directions) {
    const Question along = ask(parse_grasp(text, "fuzz"), directions);
    const auto margin = find_margin(problem_of(along), limit);
    if (const auto* found = std::get_if<Margin>(&margin)) {
      expect_accepted(text, margin_certificate_text(along, *found, "fuzz"), asked, "margin");
    }
  };
  const Wrench& load = question.loaded().wrench;
  if (!(load == Wrench{})) {
    options.direction = stickslip::row_of(load);
    asked.direction = checker_vector(load);
    expect_margin(options);
  }
  const std::vector<Contact>& contacts = question.loaded().grasp.contacts();
  const bool has_preload = std::any_of(contacts.begin(), contacts.end(),
                                       [](const Contact& c) { return !c.preload.is_zero(); });
  if (!has_preload) return;
  options.direction.reset();
  asked.direction.reset();
  options.preload_direction = PreloadDirection{true, {}};
  asked.preload_direction.emplace();
  asked.preload_direction->scale = true;
  expect_margin(options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMostBytes) return 0;
  const std::string text(data, data + size);
  for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
    try {
      answer(text, law);
    } catch (const InputError& error) {
      stickslip::fuzz::expect_useful(error, text);
    } catch (const std::exception& error) {
      broken(std::string("an exception: ") + error.what());
    }
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result;
  for (const char* folder : {"grasps", "certificates", "hard"}) {
    for (Seed& seed : files_below(corpus / folder)) {
      const bool is_grasp = seed.bytes.find("stickslip-grasp/1") != std::string::npos;
      if (is_grasp && seed.bytes.size() <= kMostBytes) result.push_back(std::move(seed));
    }
  }
  return result;
}
