// SPDX-License-Identifier: GPL-3.0-or-later
// Claims files of `stickslip crosscheck`. An input is such a file. Lines are those of the text,
// and a line that is read and written again is read as the same claim about the same question.
#include <sstream>

#include "fuzz_target.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/measures/claim.hpp"

namespace {

using stickslip::ClaimLine;
using stickslip::Rational;
using stickslip::fuzz::broken;

std::string list(const std::vector<Rational>& numbers) {
  std::string text;
  for (const Rational& number : numbers) {
    text += (text.empty() ? "[\"" : ", \"") + stickslip::to_string(number) + "\"";
  }
  return text + "]";
}

/// Everything that the line says, as a line.
std::string written(const ClaimLine& line) {
  std::string grasp = stickslip::write_grasp(line.question.grasp);
  for (char& c : grasp) c = c == '\n' ? ' ' : c;  // in a string it is spelled \n
  const stickslip::Claim& claim = line.claim;
  std::string text = "{\"grasp\": " + grasp + ", \"options\": {\"normal_law\": \"" +
                     stickslip::to_string(line.question.law) +
                     "\"}, \"claim\": {\"verdict\": \"" +
                     (claim.stable ? "stable" : "unstable") + "\"";
  if (claim.twist) text += ", \"twist\": " + list(*claim.twist);
  if (claim.forces) {
    text += ", \"force_vectors\": [";
    for (std::size_t i = 0; i < claim.forces->size(); ++i) {
      text += (i == 0 ? "" : ", ") + list((*claim.forces)[i]);
    }
    text += "]";
  }
  return text + "}}";
}

void read_line(const std::string& text) {
  ClaimLine line;
  try {
    line = stickslip::parse_claim_line(text, "no_such_folder");
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    return;
  }
  residuals_of(line.question.grasp.as_box(), line.question.law, line.claim);
  std::string again;
  try {
    again = written(line);
    if (written(stickslip::parse_claim_line(again, "")) != again) {
      broken("another claim is read back: " + again);
    }
  } catch (const stickslip::InputError& error) {
    // "1e4096" fits into a line, and its digits may not.
    if (std::string(error.what()).find("characters") == std::string::npos) throw;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    std::istringstream in(text);
    std::istringstream plain(text);
    stickslip::TextLines lines(in);
    std::string expected;
    std::size_t number = 0;
    for (std::string line; lines.next(line); read_line(line)) {
      while (number < lines.number() && std::getline(plain, expected)) ++number;
      if (number != lines.number() || line != expected) broken("another line is read");
    }
    while (std::getline(plain, expected)) {
      if (expected.find_first_not_of(" \t\r") < expected.size()) broken("a line is left out");
    }
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result = files_below(corpus / "claims");
  for (Seed& seed : hostile_texts()) {
    result.push_back({seed.name + ", grasp", "{\"grasp\": " + seed.bytes + "}"});
    result.push_back(std::move(seed));
  }
  return result;
}
