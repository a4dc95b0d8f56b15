// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_numbers.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/option_text.hpp"
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

std::string ball_text(const LoadBall& ball, NumberText& text) {
  const auto in_brackets = [](const std::string& number) {
    return number.find('/') == std::string::npos ? number : "(" + number + ")";
  };
  std::string result =
      "|force|^2 + " +
      (ball.length == 1 ? "|torque|^2" : "|torque/" + in_brackets(text(ball.length)) + "|^2") +
      " <= " + in_brackets(text(ball.radius)) + "^2";
  if (!ball.about.empty()) {
    WrenchBox point;
    for (const Rational& x : ball.about) point.push_back(point_interval(x));
    result += ", the torque about " + load_text(point, text);
  }
  return ball.body.empty() ? result : result + ", on " + ball.body;
}

std::string uncertain_text(const GraspBox& box, const std::vector<UncertainNumber>& numbers,
                           NumberText& text) {
  if (numbers.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"uncertain", "from", "to"}};
  for (const UncertainNumber& number : numbers) {
    rows.push_back({number.label(), text(number.interval.low), text(number.interval.high)});
  }
  if (box.ball) {
    return short_table(rows) +
           "  of the load what differs from w by a force and a torque with\n  " +
           ball_text(*box.ball, text) + "\n\n";
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

std::string rounded_text(const Rational& number, Round round, bool all_digits) {
  if (all_digits || number.is_zero()) return to_string(number);
  constexpr int kDigits = 4;
  const DecimalEnclosure near = enclose_sqrt(number, 1, kDigits);
  return round == Round::kDown ? near.lower : near.upper;
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

std::string bound_text(const GraspBox& box) {
  const RationalRow& bound = box.max_motion;
  const std::size_t half = box.in_space() ? 3 : 2;
  const bool has_joints = box.mechanism && !box.mechanism->joints.empty();
  RationalRow numbers = bound;
  if (!has_joints && bound == bound_of(box, {{bound.front(), bound[half]}})) {
    numbers = {bound.front(), bound[half]};
  }
  std::string text;
  for (const Rational& number : numbers) {
    char digits[32];  // two digits suffice for a natural bound
    std::snprintf(digits, sizeof digits, "%.2g", to_double(number));
    const bool is_short = denominator(number) != 1 && parse_rational(digits) == number;
    text += (text.empty() ? "" : ",") + (is_short ? std::string(digits) : to_string(number));
  }
  return text;
}

std::string motions_text(const Question& question) {
  if (!question.is_bounded()) return "";
  return "Motions up to " + bound_text(*question.box()) + " are asked about.\n";
}

}  // namespace stickslip
