// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of grasp files. An input is a grasp file. Whatever core reads, it writes and
// reads back as the same grasp and the same bytes; and core and the checker, which share no
// code, take and refuse the same.
#include <sstream>
#include <string_view>

#include "answer.hpp"
#include "fuzz_target.hpp"
#include "grasp.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace {

using stickslip::fuzz::broken;

bool same(const stickslip::Contact& a, const stickslip::Contact& b) {
  return a.position == b.position && a.normal == b.normal && a.friction == b.friction &&
         a.stiffness == b.stiffness && a.preload == b.preload;
}

void expect_round_trip(const stickslip::LoadedGrasp& grasp) {
  std::string text;
  try {
    text = write_grasp(grasp);
  } catch (const stickslip::InputError& error) {
    // "1e4096" fits into a file, and its digits may not.
    if (std::string(error.what()).find("characters") == std::string::npos) throw;
    return;
  }
  const stickslip::LoadedGrasp again = stickslip::parse_grasp(text, "written").content;
  const auto& before = grasp.grasp.contacts();
  const auto& after = again.grasp.contacts();
  bool equal = grasp.wrench == again.wrench && grasp.grasp.name() == again.grasp.name() &&
               before.size() == after.size();
  for (std::size_t i = 0; equal && i < before.size(); ++i) equal = same(before[i], after[i]);
  if (!equal) broken("another grasp is read back");
  if (write_grasp(again) != text) broken("other bytes are written the second time");
}

/// Why core refuses the text; empty if it does not.
std::string refusal_of_core(std::string_view text) {
  try {
    expect_round_trip(stickslip::parse_grasp(text, "fuzz").content);
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    return error.what();
  }
  return {};
}

std::string refusal_of_checker(const std::string& text) {
  std::istringstream in(text);
  try {
    stickslip_check::read_grasp(in, "fuzz");
  } catch (const stickslip_check::Malformed& malformed) {
    return malformed.place + ": " + malformed.problem;
  }
  return {};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    const std::string core = refusal_of_core(text);
    const std::string checker = refusal_of_checker(text);
    if (core.empty() != checker.empty()) {
      broken("core says \"" + core + "\", the checker \"" + checker + "\"");
    }
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result = files_below(corpus / "grasps");
  for (Seed& seed : hostile_texts()) result.push_back(std::move(seed));
  for (Seed& seed : files_below(corpus / "certificates")) {
    if (seed.name.find(".grasp.json") != std::string::npos) result.push_back(std::move(seed));
  }
  return result;
}
