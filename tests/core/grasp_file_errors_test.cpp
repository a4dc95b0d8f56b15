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

#include "error_of.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {
namespace {

using test::error_of;
using ::testing::HasSubstr;

const std::string kCorpus = STICKSLIP_GRASP_CORPUS;

std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct BadFile {
  std::string name;     ///< or, in refused.txt, what is in it
  std::string place;    ///< exactly
  std::string problem;  ///< part of it
  std::string remedy;   ///< part of it
};

/// bad.txt or refused.txt of tests/corpus/grasps.
std::vector<BadFile> bad_files(const std::string& list) {
  std::ifstream in(kCorpus + "/" + list);
  std::vector<BadFile> files;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    BadFile& file = files.emplace_back();
    std::size_t begin = 0;
    for (std::string* part : {&file.name, &file.place, &file.problem, &file.remedy}) {
      const std::size_t end = std::min(line.find(" |", begin), line.size());
      *part = line.substr(begin, end - begin);
      begin = std::min(end + 3, line.size());
    }
  }
  return files;
}

void expect_says(const InputError& error, const std::string& path, const BadFile& bad) {
  SCOPED_TRACE(bad.name);
  EXPECT_EQ(error.file(), path);
  EXPECT_EQ(error.place(), bad.place);
  EXPECT_FALSE(bad.problem.empty());
  EXPECT_THAT(error.problem(), HasSubstr(bad.problem));
  EXPECT_THAT(error.remedy(), HasSubstr(bad.remedy));
  EXPECT_FALSE(error.remedy().empty());
  EXPECT_LT(std::string(error.what()).size(), path.size() + 500);
}

TEST(BadGraspFile, NamesFilePlaceProblemAndRemedy) {
  std::set<std::string> in_table;
  for (const BadFile& bad : bad_files("bad.txt")) {
    EXPECT_TRUE(in_table.insert(bad.name).second) << bad.name;
    const std::string path = kCorpus + "/bad/" + bad.name + ".json";
    expect_says(error_of([&] { read_grasp_file(path); }), path, bad);
  }
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus + "/bad")) {
    EXPECT_EQ(in_table.count(entry.path().stem().string()), 1U) << entry.path();
  }
}

TEST(BadGraspFile, OfAnyKindOfGrasp) {
  for (const BadFile& bad : bad_files("refused.txt")) {
    const auto read = [&] { parse_any_grasp(bad.name, "f", Intervals::kAllowed); };
    expect_says(error_of(read), "f", bad);
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

}  // namespace
}  // namespace stickslip
