// SPDX-License-Identifier: GPL-3.0-or-later
// Json writes the same as the library that reads JSON.
#include "stickslip/core/json_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "random_numbers.hpp"
#include "rounds.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {
namespace {

using testing::Random;
using Twin = nlohmann::ordered_json;

struct Both {
  Json ours;
  Twin twin;
};

/// Bytes of which few are UTF-8, and many begin characters that do not end.
std::string any_bytes(Random& random) {
  constexpr const char* kPieces[] = {"a",
                                     "\"",
                                     "\\",
                                     "\n",
                                     "\x01",
                                     "\x7f",
                                     "\xc3\xa9",
                                     "\xe2\x82\xac",
                                     "\xf0\x9f\x98\x80",
                                     "\x80",
                                     "\xc0",
                                     "\xc3",
                                     "\xe2\x82",
                                     "\xe0\x80",
                                     "\xed\xa0\x80",
                                     "\xf0\x9f\x98",
                                     "\xf4\x90",
                                     "\xff",
                                     "\b\f\r\t"};
  std::string text;
  for (int i = random.integer(0, 5); i > 0; --i) text += kPieces[random.integer(0, 18)];
  return text;
}

double any_double(Random& random) {
  if (random.integer(0, 1) == 0)
    return std::ldexp(random.integer(-100, 100), random.integer(-9, 60));
  std::uint64_t bits = 0;
  for (int i = 0; i < 4; ++i)
    bits = bits << 16 | static_cast<unsigned>(random.integer(0, 0xFFFF));
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

Both any_value(Random& random, int depth) {
  switch (random.integer(0, depth == 0 ? 6 : 8)) {
    case 0:
      return {nullptr, nullptr};
    case 1:
      return {true, true};
    case 2: {
      const int n =
          random.integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
      return {n, n};
    }
    case 3: {
      const auto n = std::numeric_limits<std::uint64_t>::max() >> random.integer(0, 63);
      return {n, n};
    }
    case 4: {
      const double x = any_double(random);
      return {x, x};
    }
    case 5:
    case 6: {
      const std::string text = any_bytes(random);
      return {text, text};
    }
    case 7: {
      Both result{Json::array(), Twin::array()};
      for (int i = random.integer(0, 3); i > 0; --i) {
        Both value = any_value(random, depth - 1);
        result.ours.push_back(std::move(value.ours));
        result.twin.push_back(std::move(value.twin));
      }
      return result;
    }
    default: {
      Both result{Json::object(), Twin::object()};
      for (int i = random.integer(0, 3); i > 0; --i) {
        Both value = any_value(random, depth - 1);
        const std::string key(1, static_cast<char>('a' + random.integer(0, 3)));
        result.ours[key] = value.ours;
        result.twin[key] = value.twin;
      }
      return result;
    }
  }
}

TEST(Json, IsWrittenAsByAnotherLibrary) {
  Random random(3);
  for (int i = 0; i < test::rounds(5000); ++i) {
    const Both value = any_value(random, 4);
    const Json copy = value.ours;
    for (const int indent : {-1, 0, 1, 2}) {
      EXPECT_EQ(copy.dump(indent, Json::Utf8::kReplaced),
                value.twin.dump(indent, ' ', false, Twin::error_handler_t::replace));
    }
    std::string strict;
    try {
      strict = value.twin.dump();
    } catch (const Twin::type_error& error) {
      try {
        FAIL() << copy.dump();
      } catch (const JsonTextError& refused) {
        EXPECT_THAT(error.what(), ::testing::EndsWith(refused.what()));
      }
      continue;
    }
    EXPECT_EQ(copy.dump(), strict);
    EXPECT_EQ(Json::parse(strict).dump(), Twin::parse(strict).dump());
  }
}

TEST(Json, IsWrittenDownAsItLooks) {
  const Json json{{"a", 1}, {"b", {1, -2.5, "x", nullptr}}, {"c", {{"d", true}}}};
  EXPECT_EQ(json.dump(), R"({"a":1,"b":[1,-2.5,"x",null],"c":{"d":true}})");
  EXPECT_EQ(Json({{1, 2}, {"a", 2}}).dump(), R"([[1,2],["a",2]])");
  EXPECT_EQ(Json(std::vector<std::string>{"a", "b"}).dump(), R"(["a","b"])");
  EXPECT_EQ(Json(std::array<std::size_t, 2>{3, 4}).dump(), "[3,4]");
  EXPECT_EQ(Json().dump(), "null");
  EXPECT_EQ(Json::object().dump(1), "{}");
  EXPECT_EQ(Json::array().dump(1), "[]");
  EXPECT_EQ(Json(std::nan("")).dump(), "null");
}

TEST(Json, ChangesItsMembersAndValues) {
  Json json;
  json["b"] = 1;
  json["a"] = "x";
  json["b"] = 2;
  EXPECT_EQ(json.dump(), R"({"b":2,"a":"x"})");
  json.update({{"a", 3}, {"c", 4}});
  json.erase("b");
  json.erase("none");
  EXPECT_EQ(json.dump(), R"({"a":3,"c":4})");
  EXPECT_EQ(json.size(), 2);
  EXPECT_TRUE(json.contains("c"));
  EXPECT_EQ(json.find("b"), nullptr);
  EXPECT_EQ(json.at("c").count(), 4);
  Json list;
  list.push_back(json);
  list.emplace_back(Json::object())["k"] = Json::array({1});
  EXPECT_EQ(list[0].dump(), json.dump());
  EXPECT_EQ(list.back()["k"][0].count(), 1);
  list[0] = nullptr;
  EXPECT_EQ(list.dump(), R"([null,{"k":[1]}])");
  const Json moved = std::move(list);
  EXPECT_TRUE(list.is_null());
  EXPECT_EQ(moved.size(), 2);
}

TEST(Json, IsNotTakenForWhatItIsNot) {
  Json text = "x";
  EXPECT_THROW(text["a"], std::logic_error);
  EXPECT_THROW(text.push_back(1), std::logic_error);
  EXPECT_THROW(text.count(), std::logic_error);
  EXPECT_THROW(Json(-1).count(), std::logic_error);
  EXPECT_THROW(Json(1).text(), std::logic_error);
  EXPECT_THROW(Json::object().at("a"), std::logic_error);
  EXPECT_THROW(Json::array({1})[1], std::logic_error);
  EXPECT_THROW(Json::array().back(), std::logic_error);
  EXPECT_THROW(Json::exact("1/2").dump(), std::logic_error);
  EXPECT_EQ(Json::exact("1/2").text(), "1/2");
}

}  // namespace
}  // namespace stickslip
