// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rules that FORMAT.md names: each must be seen to fail.
#pragma once

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

namespace stickslip::test {

/// What is back-quoted with a hyphen in it between two headings of the document.
inline std::set<std::string> rules_between(const std::string& heading, const std::string& end) {
  std::ifstream file(STICKSLIP_FORMAT);
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const std::size_t from = all.find(heading);
  const std::size_t to = all.find("\n" + end);
  if (from == std::string::npos || to == std::string::npos || to < from) {
    throw std::runtime_error("FORMAT.md has no " + heading + " followed by " + end);
  }
  const std::string text = all.substr(from, to - from);
  const std::regex name("`([a-z]+(-[a-z]+)+)`");
  std::set<std::string> rules;
  for (std::sregex_iterator it(text.begin(), text.end(), name), last; it != last; ++it) {
    rules.insert((*it)[1]);
  }
  rules.erase("like-this");  // the example of the typography
  return rules;
}

}  // namespace stickslip::test
