// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and wrenches: the values of options, and numbers in JSON. An input is such a text.
// All readers take and refuse the same and read the same value; what is written reads as the
// value it is of.
#include <algorithm>
#include <optional>

#include "arguments.hpp"
#include "fuzz_target.hpp"
#include "number.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/number.hpp"
#include "stickslip/core/box.hpp"
#include "stickslip/core/number_list.hpp"

namespace {

using stickslip::Rational;
using stickslip::fuzz::broken;

std::optional<Rational> parsed(const std::string& text) {
  try {
    return stickslip::parse_rational(text);
  } catch (const stickslip::NumberError& error) {
    if (std::string(error.what()).empty()) broken("a refusal without a reason");
    return std::nullopt;
  }
}

/// In the readers' common spelling: lowest terms.
std::string spelled(const std::optional<Rational>& number) {
  return number ? stickslip::to_string(*number) : "refused";
}

std::string spelled(const std::optional<stickslip_check::Rational>& number) {
  return number ? number->get_str() : "refused";
}

void expect_same(const std::string& a, const std::string& b, const char* what) {
  if (a != b) broken(std::string(what) + ": " + a.substr(0, 200) + ", " + b.substr(0, 200));
}

void expect_readable(const Rational& value) {
  const std::string text = stickslip::to_readable_string(value);
  const bool is_rounded = text.front() == stickslip::kRounded;
  const auto shown = parsed(text.substr(is_rounded ? 1 : 0));
  // Exponents of what is shown may be beyond those that are read.
  if (!shown) return;
  // Six digits: off by at most five in the seventh.
  const bool holds = is_rounded ? abs(*shown - value) * 200000 <= abs(value) : *shown == value;
  if (!holds) broken("shown as " + text);
}

void read_number(const std::string& text) {
  const std::optional<Rational> value = parsed(text);
  expect_same(spelled(value), spelled(stickslip_check::parse_decimal(text)), "the checker");
  const auto fraction = stickslip_check::parse_fraction(text);
  if (fraction && text.size() <= stickslip::kMaxNumberLength) {
    expect_same(spelled(value), spelled(fraction), "in a certificate");
  }
  if (!value) return;
  const std::string again = stickslip::to_string(*value);
  if (again.size() <= stickslip::kMaxNumberLength && parsed(again) != value) {
    broken("another value is read back");
  }
  expect_readable(*value);
}

void read_json_number(const std::string& text) {
  stickslip::JsonNode list;
  try {
    list = stickslip::parse_json("[" + text + "]");
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, "[" + text + "]");
    return;
  }
  if (list.children.size() != 1) return;
  const stickslip::JsonNode& node = list.children[0];
  if (node.kind != stickslip::JsonNode::Kind::kNumber) return;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const std::string bare = text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
  std::optional<Rational> value;
  try {
    value = stickslip::read_number(node, "x");
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
  }
  expect_same(spelled(value), spelled(parsed(bare)), "in JSON");
}

/// The number as it is and in percent.
void read_tolerances(const std::string& text) {
  std::optional<Rational> number = parsed(text);
  if (number && number->sign() < 0) number.reset();
  for (const bool relative : {false, true}) {
    std::optional<Rational> read;
    try {
      const stickslip::Tolerances all =
          stickslip::parse_tolerances("friction=" + text + (relative ? "%" : ""));
      read = all.friction->amount;
    } catch (const stickslip::InputError& error) {
      stickslip::fuzz::expect_useful(error, text);
    }
    if (number && read != (relative ? Rational(*number / 100) : *number)) {
      broken("another tolerance is read");
    }
  }
}

std::string wrench_of_stickslip(const std::string& text) {
  try {
    const auto w = stickslip::rationals_at("--wrench", text);
    using stickslip::to_string;
    if (w.size() != 3) return "refused";
    return to_string(w[0]) + "," + to_string(w[1]) + "," + to_string(w[2]);
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    return "refused";
  }
}

std::string wrench_of_checker(const std::string& text) {
  try {
    const auto w =
        *stickslip_check::parse_arguments({"--wrench", text, "g", "c"}).options.wrench;
    // How many there are to be is for the question, which knows the grasp.
    if (w.size() != 3) return "refused";
    return w[0].get_str() + "," + w[1].get_str() + "," + w[2].get_str();
  } catch (const stickslip_check::UsageError& error) {
    if (error.problem.empty()) broken("a refusal without a reason");
    return "refused";
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    read_number(text);
    read_json_number(text);
    read_tolerances(text);
    expect_same(wrench_of_stickslip(text), wrench_of_checker(text), "as a wrench");
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path&) {
  std::vector<Seed> result = hostile_texts();
  for (const char* text : {"0",
                           "-0",
                           "+7",
                           "-11/10",
                           "22/-7",
                           "1/0",
                           "007",
                           "0x1F",
                           "1.",
                           ".5",
                           "-0.25",
                           "1e-3",
                           "2.5E+2",
                           "1e4096",
                           "-1e4097",
                           "1e999999999",
                           "1e-999999999",
                           "9e",
                           "nan",
                           "inf",
                           "1 ",
                           "0,-11/10,0",
                           "1,2",
                           "1,2,3,4",
                           ",,",
                           "0,1e-3,+2/6",
                           "18446744073709551616",
                           "-9223372036854775809",
                           "0.00000000000000000001e30",
                           "1_000",
                           "1,5"}) {
    result.push_back({text, text});
  }
  for (const int digits : {4000, 16383, 16385}) {
    result.push_back({"long", std::string(static_cast<std::size_t>(digits), '7') + "/3"});
    result.push_back({"small", "0." + std::string(static_cast<std::size_t>(digits), '1')});
  }
  for (Seed& seed : result) std::replace(seed.name.begin(), seed.name.end(), '/', ':');
  return result;
}
