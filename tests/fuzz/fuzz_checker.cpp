// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ checker. An input is the letter b or u for the normal law, or B or U where the margin
// along (0, 1, 0) is asked for, a grasp file, a NUL byte and a certificate. The checker
// answers, whatever it is given; leaves judged with rounded bounds and without get the same
// answer; and a refusal says why.
#include <algorithm>
#include <sstream>

#include "check.hpp"
#include "fuzz_target.hpp"

namespace {

using stickslip::fuzz::broken;
using namespace stickslip_check;

std::string summary(const Answer& answer) {
  if (std::holds_alternative<Accepted>(answer)) return "accepted";
  if (const auto* rejected = std::get_if<Rejected>(&answer)) {
    if (rejected->found.empty()) broken("a rejection without a reason");
    return rejected->rule + " at " + (rejected->node ? std::to_string(*rejected->node) : "-") +
           " (" + rejected->path + ")";
  }
  if (std::get<Malformed>(answer).problem.empty()) broken("malformed without a reason");
  return "malformed";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  QuestionOptions options;
  options.bilateral = data[0] == 'b' || data[0] == 'B';
  if (data[0] == 'B' || data[0] == 'U') options.direction = Vector3{0, 1, 0};
  const std::uint8_t* const end = data + size;
  const std::uint8_t* const separator = std::find(data + 1, end, 0);
  const std::string grasp(data + 1, separator);
  const std::string certificate(std::min(separator + 1, end), end);
  try {
    std::string answers[2];
    for (const bool exact_only : {false, true}) {
      std::istringstream grasp_in(grasp);
      std::istringstream certificate_in(certificate);
      answers[exact_only ? 1 : 0] =
          summary(check(grasp_in, certificate_in, options, "grasp", "certificate", exact_only));
    }
    if (answers[0] != answers[1]) broken(answers[0] + ", or exactly: " + answers[1]);
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  const std::string ending = ".grasp.json";
  const std::vector<Seed> files = files_below(corpus / "certificates");
  std::vector<Seed> result;
  for (const Seed& grasp : files) {
    if (grasp.name.find(ending) == std::string::npos) continue;
    const std::string stem = grasp.name.substr(0, grasp.name.size() - ending.size());
    for (const Seed& certificate : files) {
      if (certificate.name != stem + ".certificate.json") continue;
      const bool margin = certificate.bytes.find("stickslip-margin/1") != std::string::npos;
      const char* laws = margin ? "UB" : "ub";
      const char law = laws[stem.rfind("bilateral_", 0) == 0 ? 1 : 0];
      result.push_back({stem, law + grasp.bytes + '\0' + certificate.bytes});
    }
  }
  return result;
}
