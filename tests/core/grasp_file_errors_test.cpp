// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input ends in an InputError that names the file, the place, the problem and the
// remedy; never in a crash, and never in a grasp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using testing::Random;

const std::string kCorpus = STICKSLIP_GRASP_CORPUS;

std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The error of `read`, or one that says there was none.
template <class Read>
InputError error_of(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error;
  }
  return InputError("", "", "no error", "");
}

struct BadFile {
  const char* name;
  const char* place;    ///< exactly
  const char* problem;  ///< part of it
  const char* remedy;   ///< part of it
};

const BadFile kBadFiles[] = {
    // Not JSON: line:column.
    {"empty", "1:1", "empty", "docs/grasp_file.md"},
    {"blank", "1:1", "empty", "docs/grasp_file.md"},
    {"truncated", "1:81", "unexpected end of input", "too early"},
    {"trailing_garbage", "2:1", "\"x\"", ""},
    {"nul_after_the_end", "2:1", "NUL byte", "nothing but blanks"},
    {"two_objects", "2:1", "expected end of input", "one JSON object"},
    {"single_quotes", "1:2", "\"'\"", "double quotes"},
    {"comment", "1:1", "\"/\"", ""},
    {"trailing_comma", "2:22", "a comma before \"}\"", "no comma follows"},
    {"missing_comma", "2:3", "\"wrench\"", ""},
    {"nan", "2:16", "must be finite, at \"NaN\"", "0.25"},
    {"minus_infinity", "1:121", "must be finite, at \"-Infinity\"", "0.25"},
    {"leading_zero", "1:121", "\"010\"", "numbers look like"},
    {"no_leading_digit", "1:118", "\".5\"", "numbers look like"},
    {"plus_sign", "1:118", "\"+5\"", "numbers look like"},
    {"bare_fraction", "1:118", "\"3\"", "a fraction is a string"},
    {"invalid_utf8", "1:42", "ill-formed UTF-8", "save the file as UTF-8"},
    {"utf16", "1:1", "invalid literal", "save the file as UTF-8"},
    {"raw_newline_in_string", "1:42", "control character", ""},
    {"lone_surrogate", "1:43", "surrogate", ""},
    {"huge_exponent", "1:121", "out of range, at \"1e999999999\"", "exponents reach 4096"},
    // The top level.
    {"not_an_object", "top level", "an array of 2 values", "expected an object"},
    {"number_alone", "top level", "the number 3", "expected an object"},
    {"missing_format", "top level", "\"format\" is missing", "\"stickslip-grasp/1\""},
    {"wrong_format", "format", "\"stickslip-grasp/3\"", "\"stickslip-grasp/2\""},
    {"format_number", "format", "the number 1", "\"stickslip-grasp/1\""},
    {"missing_contacts", "top level", "\"contacts\" is missing", "may be empty"},
    {"missing_wrench", "top level", "\"wrench\" is missing", "no load is [0, 0, 0]"},
    {"unknown_key", "top level", "unknown key \"frction\"",
     "the keys allowed here are format, name, defaults, contacts, wrench"},
    {"unknown_far_key", "top level", "unknown key \"gravity\"", "the keys allowed here are"},
    {"duplicate_key", "top level", "\"name\" appears twice", "keep one"},
    {"duplicate_contacts", "top level", "\"contacts\" appears twice", "keep one"},
    {"name_number", "name", "the number 1", "expected a string"},
    {"deep_nesting",
     "contacts[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]"
     "[0]"
     "[0][0][0]",
     "more than 32 levels", "no more than five"},
    // The wrench.
    {"long_wrench", "wrench", "an array of 4 values", "three numbers"},
    {"wrench_object", "wrench", "an object of 1 value", "three numbers"},
    {"nan_string", "wrench[1]", "\"nan\" is not a number", "\"3/5\""},
    {"tiny_exponent", "wrench[1]", "\"1e-999999999\" exceeds 4096", ""},
    {"huge_exponent_string", "wrench[1]", "\"1e999999999\" exceeds 4096", ""},
    {"exponent_4097", "wrench[1]", "\"1e4097\" exceeds 4096", ""},
    // Loads and cases.
    {"loads_in_version_1", "top level", "unknown key \"loads\"", "\"stickslip-grasp/2\""},
    {"cases_in_version_1", "top level", "unknown key \"cases\"", "\"stickslip-grasp/2\""},
    {"missing_loads", "top level", "\"wrench\" is missing", "or \"loads\": [...]"},
    {"wrench_and_loads", "top level", "both \"wrench\" and \"loads\"", "give one of them"},
    {"loads_object", "loads", "an object of 1 value", "an array of loads"},
    {"load_number", "loads[0]", "the number 3", "an object such as {\"force\": [x, y]"},
    {"load_empty", "loads[1]", "an object of 0 values", "{\"torque\": t}"},
    {"load_without_point", "loads[0]", "\"at\" is missing", "add \"at\": [x, y]"},
    {"load_misspelt", "loads[0]", "unknown key \"forse\"", "did you mean \"force\"?"},
    {"load_of_two_kinds", "loads[0]", "unknown key \"force\"", "keys allowed here are torque"},
    {"torque_vector", "loads[0].torque", "an array of 2 values", "expected a number"},
    {"force_number", "loads[0].force", "the number 1", "two numbers [x, y]"},
    {"negative_weight", "loads[0].weight", "the value is -1", "\"direction\": [x, y]"},
    {"weight_direction_zero", "loads[0].direction", "its length is 0", "such as [3, -4]"},
    {"weight_direction_irrational", "loads[0].direction", "irrational", "such as [3, -4]"},
    {"cases_object", "cases", "an object of 1 value", "an array of cases"},
    {"cases_empty", "cases", "the list is empty", "give a case, or no list"},
    {"case_without_name", "cases[0]", "\"name\" is missing", "add \"name\""},
    {"case_name_number", "cases[0].name", "the number 1", "expected a string"},
    {"case_name_empty", "cases[0].name", "the name is empty", "--case"},
    {"case_name_twice", "cases[1].name", "\"lift\" appears twice", "a name of its own"},
    {"case_without_load", "cases[0]", "neither \"wrench\" nor \"loads\"", "\"loads\": []"},
    {"case_with_both", "cases[0]", "both \"wrench\" and \"loads\"", "give one of them"},
    {"case_unknown_key", "cases[0]", "unknown key \"load\"", "did you mean \"loads\"?"},
    {"case_bad_load", "cases[1].loads[0].at[1]", "found null", "expected a number"},
    // The outline, and contacts on it.
    {"outline_in_version_1", "top level", "unknown key \"outline\"", "\"stickslip-grasp/2\""},
    {"outline_number", "outline", "the number 4", "a list of polygons"},
    {"outline_empty", "outline", "the list is empty", "give a polygon"},
    {"outline_of_numbers", "outline[0]", "the number 0", "two numbers [x, y]"},
    {"outline_polygon_empty", "outline[1]", "a polygon without a ring", "outer ring"},
    {"outline_two_vertices", "outline[0][0]", "a ring of 2 vertices", "at least three"},
    {"outline_no_area", "outline[0][0]", "the ring has no area", "in their order"},
    {"outline_same_vertex", "outline[0][0][1]", "the same as the next", "leave one"},
    {"outline_closed", "outline[0][0][3]", "the same as the first", "a ring closes by itself"},
    {"outline_bad_vertex", "outline[1][1]", "an array of 1 value", "two numbers [x, y]"},
    {"outline_too_deep", "outline[0][0][0]", "an array of 3 values", "two numbers [x, y]"},
    {"outline_hole_number", "outline[1]", "the number 7", "a ring is [[x, y], ...]"},
    {"on_in_version_1", "contacts[0]", "unknown key \"on\"", "\"stickslip-grasp/2\""},
    {"on_without_outline", "contacts[0].on", "no outline", "add \"outline\""},
    {"on_and_normal", "contacts[0]", "both \"on\" and \"normal\"", "remove one"},
    {"on_string", "contacts[0].on", "the string \"0, 1/2\"", "[edge, share]"},
    {"on_short", "contacts[0].on", "an array of 1 value", "[edge, share]"},
    {"on_unknown_key", "contacts[0].on", "unknown key \"shar\"", "did you mean \"share\"?"},
    {"on_without_share", "contacts[0].on", "\"share\" is missing", "\"share\": \"1/2\""},
    {"on_share_above_1", "contacts[0].on[1]", "101/100", "from 0, where it begins, to 1"},
    {"on_share_negative", "contacts[0].on.share", "-1", "from 0, where it begins, to 1"},
    {"on_edge_fraction", "contacts[0].on", "the value is 1/2", "4 edges, 0 to 3"},
    {"on_edge_too_large", "contacts[0].on", "the value is 4", "polygon 0 has 4 edges, 0 to 3"},
    {"on_edge_negative", "contacts[0].on", "the value is -1", "4 edges, 0 to 3"},
    {"on_polygon_too_large", "contacts[0].on", "the value is 1", "1 polygon, number 0"},
    // Units.
    {"units_in_version_1", "top level", "unknown key \"units\"", "\"stickslip-grasp/2\""},
    {"units_string", "units", "the string \"mm, N\"", "an object"},
    {"units_without_force", "units", "\"force\" is missing", "give both"},
    {"units_unknown_key", "units", "unknown key \"mass\"", "length, force"},
    {"units_number", "units.length", "the number 1", "such as \"mm\""},
    {"units_empty", "units.force", "the unit is \"\"", "1 to 16 bytes"},
    {"units_long", "units.length", "the unit is", "1 to 16 bytes"},
    // Contacts.
    {"contacts_object", "contacts", "an object of 0 values", "an array of contacts"},
    {"contact_array", "contacts[0]", "an array of 2 values", "expected an object"},
    {"contact_null", "contacts[0]", "found null", "expected an object"},
    {"missing_position", "contacts[0]", "\"position\" is missing", "add \"position\": [x, y]"},
    {"missing_normal", "contacts[0]", "\"normal\" is missing", "into the object"},
    {"missing_friction", "contacts[1]", "\"friction\" is missing", "\"defaults\""},
    {"unknown_contact_key", "contacts[0]", "unknown key \"frictoin\"",
     "did you mean \"friction\"? the keys allowed here are position, normal, on, friction"},
    {"duplicate_contact_key", "contacts[0]", "\"friction\" appears twice", "keep one"},
    {"short_position", "contacts[0].position", "an array of 1 value", "two numbers [x, y]"},
    {"long_normal", "contacts[0].normal", "an array of 3 values", "two numbers [x, y]"},
    {"position_string", "contacts[0].position", "the string \"1, 0\"", "two numbers [x, y]"},
    {"nested_number", "contacts[0].position[0]", "an array of 1 value", "expected a number"},
    {"zero_denominator", "contacts[0].position[0]", "\"1/0\" divides by zero", "\"3/5\""},
    {"fraction_of_decimals", "contacts[0].position[1]", "\"1.5/2\" is not a number", "\"3/5\""},
    {"blank_in_number", "contacts[0].position[1]", "\"3 / 5\" is not a number", "\"3/5\""},
    {"hexadecimal", "contacts[0].position[1]", "\"0x10\" is not a number", "\"3/5\""},
    {"zero_normal", "contacts[1].normal", "(0, 0)", "nonzero vector"},
    {"negative_friction", "contacts[0].friction", "-1/2", "0 or more"},
    {"empty_number", "contacts[0].friction", "\"\" is not a number", "\"3/5\""},
    {"boolean_friction", "contacts[0].friction", "found true", "expected a number"},
    {"zero_stiffness", "contacts[0].stiffness", "the value is 0", "above 0"},
    {"negative_stiffness", "contacts[0].stiffness", "-5/2", "above 0"},
    {"negative_preload", "contacts[0].preload", "-1", "0 or more"},
    {"null_preload", "contacts[0].preload", "found null", "expected a number"},
    // Defaults.
    {"defaults_array", "defaults", "an array of 0 values", "expected an object"},
    {"unknown_default", "defaults", "unknown key \"mu\"", "friction, stiffness, preload"},
    {"duplicate_default", "defaults", "\"friction\" appears twice", "keep one"},
    {"default_not_number", "defaults.friction", "an array of 1 value", "expected a number"},
    {"negative_default_friction", "defaults.friction", "-1", "0 or more"},
    {"zero_default_stiffness", "defaults.stiffness", "the value is 0", "above 0"},
    {"negative_default_preload", "defaults.preload", "-1/1000000000", "0 or more"},
    // Normals are snapped by a command.
    {"normals_exact", "top level", "unknown key \"normals\"", "stickslip snap GRASP -o FILE"},
    {"normals_snap", "top level", "unknown key \"normals\"", "stickslip snap GRASP -o FILE"},
};

TEST(BadGraspFile, NamesFilePlaceProblemAndRemedy) {
  for (const BadFile& bad : kBadFiles) {
    SCOPED_TRACE(bad.name);
    const std::string path = kCorpus + "/bad/" + bad.name + ".json";
    const InputError error = error_of([&] { read_grasp_file(path); });
    EXPECT_EQ(error.file(), path);
    EXPECT_EQ(error.place(), bad.place);
    EXPECT_THAT(error.problem(), HasSubstr(bad.problem));
    EXPECT_THAT(error.remedy(), HasSubstr(bad.remedy));
    EXPECT_FALSE(error.remedy().empty());
    EXPECT_LT(std::string(error.what()).size(), path.size() + 400);
  }
}

TEST(BadGraspFile, EveryCorpusFileIsInTheTable) {
  std::set<std::string> in_table;
  for (const BadFile& bad : kBadFiles) in_table.insert(bad.name);
  EXPECT_EQ(in_table.size(), std::size(kBadFiles));
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus + "/bad")) {
    EXPECT_EQ(in_table.count(entry.path().stem().string()), 1U) << entry.path();
  }
}

TEST(BadGraspFile, ThatCannotBeOpened) {
  const std::string missing = kCorpus + "/no_such_file.json";
  InputError error = error_of([&] { read_grasp_file(missing); });
  EXPECT_EQ(error.file(), missing);
  EXPECT_THAT(error.problem(), HasSubstr("No such file"));
  EXPECT_THAT(error.remedy(), HasSubstr("standard input"));

  error = error_of([&] { read_grasp_file(kCorpus); });
  EXPECT_EQ(error.file(), kCorpus);
  EXPECT_THAT(error.problem(), HasSubstr("directory"));

  EXPECT_THAT(error_of([] { read_grasp_file(""); }).problem(), HasSubstr("cannot open"));
}

/// Redirects standard input for a scope.
class FakeInput {
 public:
  explicit FakeInput(std::streambuf* buffer) : before_(std::cin.rdbuf(buffer)) {
    std::cin.clear();
  }
  ~FakeInput() {
    std::cin.rdbuf(before_);
    std::cin.clear();
  }
  FakeInput(const FakeInput&) = delete;
  FakeInput& operator=(const FakeInput&) = delete;

 private:
  std::streambuf* before_;
};

TEST(BadGraspFile, OnStandardInputIsNamedSo) {
  std::istringstream text("{");
  const FakeInput input(text.rdbuf());
  EXPECT_EQ(error_of([] { read_grasp_file("-"); }).file(), "<stdin>");
}

/// Blanks without end.
class EndlessBuffer : public std::streambuf {
 public:
  std::size_t given() const { return given_; }

 protected:
  int_type underflow() override {
    given_ += sizeof block_;
    std::fill(std::begin(block_), std::end(block_), ' ');
    setg(block_, block_, block_ + sizeof block_);
    return ' ';
  }

 private:
  char block_[1 << 16];
  std::size_t given_ = 0;
};

TEST(BadGraspFile, WithoutEndIsNotReadToTheEnd) {
  EndlessBuffer endless;
  const FakeInput input(&endless);
  const InputError error = error_of([] { read_grasp_file("-"); });
  EXPECT_THAT(error.problem(), HasSubstr("more than 268435456 bytes"));
  EXPECT_LT(endless.given(), kMaxJsonBytes + (std::size_t{1} << 20));
}

TEST(BadGraspFile, NestedMillionsDeepIsRefusedAtTheLimit) {
  for (const char* open : {"[", "{\"a\":", "{\"contacts\":[", "[{\"a\":"}) {
    std::string text;
    while (text.size() < 4'000'000) text += open;
    EXPECT_THAT(error_of([&] { parse_grasp(text, "deep"); }).problem(),
                HasSubstr("levels deep"));
  }
}

TEST(BadGraspFile, WithTooManyValuesInOnePlace) {
  // An array and its elements, itself included; a contact's likewise.
  const auto zeros = [](std::size_t n) {
    std::string text = "[0";
    for (std::size_t i = 1; i < n; ++i) text += ", 0";
    return text + "]";
  };
  const auto problem = [](const std::string& text) {
    return error_of([&] { parse_grasp(text, "many"); }).problem();
  };
  const std::string head = R"({"format": "stickslip-grasp/1", "contacts": [)";
  const std::string contact = R"({"friction": 1, "normal": [0, 1], "position": )";
  const std::string limit = "more than 65536 values in one place";
  EXPECT_THAT(problem(head + "], \"wrench\": " + zeros(kMaxJsonNodes - 1) + "}"),
              HasSubstr("an array of 65535 values"));
  EXPECT_EQ(problem(head + "], \"wrench\": " + zeros(kMaxJsonNodes) + "}"), limit);
  EXPECT_THAT(problem(head + contact + zeros(kMaxJsonNodes - 6) + "}], \"wrench\": [0, 0, 0]}"),
              HasSubstr("an array of 65530 values"));
  EXPECT_EQ(problem(head + contact + zeros(kMaxJsonNodes - 5) + "}], \"wrench\": [0, 0, 0]}"),
            limit);
  std::string keys = "{\"k\": 0";
  for (std::size_t i = 0; i < kMaxJsonKeys; ++i) keys += ", \"k" + std::to_string(i) + "\": 0";
  EXPECT_THAT(problem(keys + "}"), HasSubstr("more than 32 members"));
}

TEST(BadGraspFile, LongTokensGiveShortMessages) {
  const std::string long_text(1'000'000, '7');
  const std::string head = R"({"format": "stickslip-grasp/1", )";
  for (const std::string& text :
       {head + "\"" + long_text + "\": 1}", head + "\"name\": \"" + long_text,
        head + R"("wrench": [)" + long_text + ", 0, 0]}", "\"" + long_text + "\"",
        head + R"("wrench": [")" + long_text + R"(", 0, 0]})", long_text + "x",
        head + R"("contacts": [{")" + long_text + R"(": [1, [)"}) {
    const InputError error = error_of([&] { parse_grasp(text, "long"); });
    EXPECT_NE(error.problem(), "no error");
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
}

TEST(BadGraspFile, ColumnsCountCharacters) {
  EXPECT_EQ(error_of([] { parse_grasp("{\"\u00e9\u00e9\":\n {\"\u00e9\" 1", "f"); }).place(),
            "2:7");
}

TEST(BadGraspFile, EveryProperPrefixIsAnError) {
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus + "/good")) {
    std::string text = slurp(entry.path().string());
    text.erase(text.find_last_not_of(" \n") + 1);
    for (std::size_t length = 0; length < text.size(); ++length) {
      EXPECT_THROW(parse_grasp(text.substr(0, length), "prefix"), InputError)
          << entry.path() << ", " << length << " bytes";
    }
    EXPECT_NO_THROW(parse_grasp(text, "whole"));
  }
}

TEST(BadGraspFile, RandomChangesParseOrThrowInputError) {
  std::vector<std::string> seeds;
  for (const char* kind : {"/good", "/bad"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kCorpus + kind)) {
      seeds.push_back(slurp(entry.path().string()));
    }
  }
  std::sort(seeds.begin(), seeds.end());
  const std::string likely = "{}[]\",:0123456789.-+eE/ \n\\ntfu";
  Random random(51);
  int parsed = 0;
  for (int round = 0; round < 30000; ++round) {
    std::string text =
        seeds[static_cast<std::size_t>(random.integer(0, static_cast<int>(seeds.size()) - 1))];
    for (int change = random.integer(1, 4); change > 0 && !text.empty(); --change) {
      const auto at =
          static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
      const char byte = random.integer(0, 2) == 0
                            ? static_cast<char>(random.integer(0, 255))
                            : likely[static_cast<std::size_t>(
                                  random.integer(0, static_cast<int>(likely.size()) - 1))];
      switch (random.integer(0, 3)) {
        case 0:
          text.erase(at, 1);
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text += text.substr(at, 30);
          break;
        default:
          text[at] = byte;
      }
    }
    try {
      const GraspFile file = parse_grasp(text, "mutant");
      // What parses is a grasp, and can be written and read.
      parse_grasp(write_grasp(file.content), "rewritten");
      ++parsed;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.problem().empty());
      EXPECT_FALSE(error.remedy().empty());
    }
  }
  EXPECT_GT(parsed, 50);
}

}  // namespace
}  // namespace stickslip
