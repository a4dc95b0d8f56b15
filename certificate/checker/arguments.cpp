// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <optional>

namespace stickslip_check {
namespace {

Rational parse_number(const std::string& option, const std::string& text) {
  const std::optional<Rational> value = parse_decimal(text);
  if (!value) {
    throw UsageError{option + ": " + quote(text) +
                     " is not a number such as 2, -0.25, 1e-3 or 3/5"};
  }
  return *value;
}

}  // namespace

Vector3 parse_wrench(const std::string& option, const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 3) {
    throw UsageError{option + ": " + quote(text) + " is not WX,WY,T, such as 0,-11/10,0"};
  }
  return {parse_number(option, parts[0]), parse_number(option, parts[1]),
          parse_number(option, parts[2])};
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    std::optional<std::string> attached;
    const std::size_t equals = word.find('=');
    if (word.rfind("--", 0) == 0 && equals != std::string::npos) {
      attached = word.substr(equals + 1);
      word.resize(equals);
    }
    const auto value = [&]() -> std::string {
      if (attached) return *attached;
      if (i + 1 == words.size()) throw UsageError{word + " needs a value"};
      return words[++i];
    };
    if (word == "--wrench") {
      arguments.options.wrench = parse_wrench(word, value());
    } else if (word == "--direction") {
      arguments.options.direction = parse_wrench(word, value());
      if (arguments.options.direction == Vector3{}) {
        throw UsageError{"--direction must not be 0,0,0"};
      }
    } else if (word == "--preload") {
      arguments.options.preload = parse_number(word, value());
      if (*arguments.options.preload < 0) throw UsageError{"--preload must be 0 or more"};
    } else if (word == "--normal-law") {
      const std::string law = value();
      if (law != "unilateral" && law != "bilateral") {
        throw UsageError{"--normal-law: " + quote(law) + " is not unilateral or bilateral"};
      }
      arguments.options.bilateral = law == "bilateral";
    } else if (word == "--snap-normals") {
      const Rational tolerance = parse_number(word, value());
      if (tolerance <= 0 || tolerance >= 1) {
        throw UsageError{"--snap-normals must lie between 0 and 1, such as 1e-9"};
      }
      arguments.options.snap_tolerance = tolerance;
    } else if (!attached && word == "--json") {
      arguments.json = true;
    } else if (!attached && (word == "--help" || word == "-h")) {
      arguments.help = true;
    } else if (word.size() > 1 && word[0] == '-') {
      throw UsageError{"unknown option " + quote(words[i])};
    } else {
      arguments.files.push_back(word);
    }
  }
  if (arguments.help) return arguments;
  if (arguments.files.size() != 2) {
    throw UsageError{"expected two files, GRASP and CERTIFICATE, found " +
                     std::to_string(arguments.files.size())};
  }
  if (arguments.files[0] == "-" && arguments.files[1] == "-") {
    throw UsageError{"only one of GRASP and CERTIFICATE can be standard input"};
  }
  return arguments;
}

}  // namespace stickslip_check
