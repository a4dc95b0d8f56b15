// SPDX-License-Identifier: GPL-3.0-or-later
// The results that `stickslip batch --resume` goes on from. An input is such a file. What
// stands in whole lines is read, whatever follows them; and written again it gives the same.
// And the head of a shard, if the first line is one.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz_target.hpp"
#include "stickslip/interfaces/results.hpp"
#include "stickslip/interfaces/shard.hpp"

namespace {

using stickslip::fuzz::broken;

struct Results {
  std::vector<std::string> keys;
  std::size_t bytes = 0;
  bool changed = false;
};

Results read(const std::string& text) {
  std::istringstream in(text);
  stickslip::FinishedResults finished(in, "fuzz");
  Results results;
  while (const auto result = finished.next()) {
    if (result->is_as_written) results.keys.push_back(result->key);
  }
  if (finished.lines() != results.keys.size()) broken("another number of lines");
  results.bytes = finished.bytes();
  results.changed = finished.changed().has_value();
  return results;
}

void expect_whole_lines(const std::string& text) {
  const Results results = read(text);
  const std::size_t last = text.rfind('\n');
  const std::size_t whole = last == std::string::npos ? 0 : last + 1;
  if (results.changed ? results.bytes >= whole : results.bytes != whole)
    broken("another length");
  if (read(text.substr(0, results.bytes)).keys != results.keys) broken("the rest counts");
  std::string again;
  for (const std::string& key : results.keys) {
    again += stickslip::with_check(nlohmann::json{{"key", key}}.dump() + "\n");
  }
  if (read(again).keys != results.keys) broken("other keys are read back");
}

/// As --merge reads it.
void expect_a_head_or_none(const std::string& text) {
  std::istringstream in(text);
  const auto head = stickslip::read_head(in, "fuzz");
  if (head && text.rfind(stickslip::head_text(*head), 0) != 0) broken("another head");
  if (!head && text.find('\n') != std::string::npos) broken("a line without an answer");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    expect_a_head_or_none(text);
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
  }
  try {
    expect_whole_lines(text);
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    const std::string line = error.place().substr(std::string("line ").size());
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (std::stol(line) < 1 || std::stol(line) > lines) broken("no " + error.place());
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result = files_below(corpus / "results");
  for (Seed& seed : hostile_texts()) result.push_back({seed.name, seed.bytes + "\n"});
  return result;
}
