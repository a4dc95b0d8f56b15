// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_numbers.hpp"

#include <algorithm>

#include "terminal.hpp"

namespace stickslip {

std::string load_text(const WrenchBox& load, NumberText& text) {
  std::string result;
  for (const Interval& w : load) {
    result += (result.empty() ? "(" : ", ") +
              (w.is_point() ? text(w.low) : "[" + text(w.low) + ", " + text(w.high) + "]");
  }
  return result + ")";
}

std::string uncertain_text(const std::vector<UncertainNumber>& numbers, NumberText& text) {
  if (numbers.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"uncertain", "from", "to"}};
  for (const UncertainNumber& number : numbers) {
    rows.push_back({number.label(), text(number.interval.low), text(number.interval.high)});
  }
  return short_table(rows) + "\n";
}

std::string enclosure_text(const std::vector<std::size_t>& contacts, unsigned bits,
                           bool proved) {
  if (contacts.empty()) return "";
  constexpr std::size_t kMostNamed = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(contacts.size(), kMostNamed); ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(contacts[i]);
  }
  if (contacts.size() > kMostNamed) names += ", ...";
  return (contacts.size() == 1 ? "The normal of contact " : "The normals of contacts ") +
         names +
         (contacts.size() == 1 ? " has an irrational length" : " have irrational lengths") +
         " |n|: P/|n| was enclosed to " + std::to_string(bits) + " bits" +
         (proved ? ",\nand the verdict is proved for all numbers in there.\n" : ".\n");
}

std::string short_table(std::vector<std::vector<std::string>> rows) {
  constexpr std::size_t kMostRows = 12;
  const std::size_t left_out = rows.size() - 1 > kMostRows ? rows.size() - 1 - kMostRows : 0;
  rows.resize(rows.size() - left_out);
  std::string text;
  std::string table = format_table(rows, Align::kLeft);
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = table.find('\n', begin) + 1;
    text += "  " + table.substr(begin, end - begin);
    begin = end;
  }
  if (left_out > 0) text += "  and " + std::to_string(left_out) + " more, which --json lists\n";
  return text;
}

}  // namespace stickslip
