// SPDX-License-Identifier: MIT
// Deep, long and large input: bounded stack and memory, and an answer.
#include <gtest/gtest.h>

#include <streambuf>

#include "support.hpp"

namespace stickslip_check {
namespace {

/// A text that is a beginning, a piece repeated, and an end, without being in memory.
class Repeated : public std::streambuf {
 public:
  Repeated(std::string begin, std::string piece, std::uint64_t times, std::string end)
      : begin_(std::move(begin)),
        piece_(std::move(piece)),
        times_(times),
        end_(std::move(end)) {
    setg(begin_.data(), begin_.data(), begin_.data() + begin_.size());
  }

 protected:
  int_type underflow() override {
    if (times_ > 0) {
      --times_;
      setg(piece_.data(), piece_.data(), piece_.data() + piece_.size());
    } else if (!ended_) {
      ended_ = true;
      setg(end_.data(), end_.data(), end_.data() + end_.size());
    } else {
      return traits_type::eof();
    }
    return traits_type::to_int_type(*gptr());
  }

 private:
  std::string begin_;
  std::string piece_;
  std::uint64_t times_;
  std::string end_;
  bool ended_ = false;
};

Answer ask_stream(const std::string& grasp, Repeated certificate) {
  std::istringstream grasp_in(grasp);
  std::istream certificate_in(&certificate);
  return check(grasp_in, certificate_in, {});
}

TEST(Hostile, TooManyNodes) {
  const Answer answer = ask_stream(
      fig1("0", "0, 1, 0"),
      {header(3, "0, 1, 0") + "\"verdict\": \"unstable\", \"tree\": [[\"leaf\", 0, 0, 0]",
       ", [\"leaf\", 0, 0, 0]", 200000, "]}"});
  EXPECT_EQ(outcome(answer), "leaf-bound");
}

TEST(Hostile, LongTokensAndBlanks) {
  const std::string grasp = fig1("0", "0, 1, 0");
  const std::string million(1000000, ' ');
  EXPECT_EQ(
      outcome(ask_stream(grasp, {"{\"format\": \"", std::string(1000, 'a'), 100000, "\"}"})),
      "malformed");
  EXPECT_EQ(outcome(ask_stream(grasp, {"{\"format\": ", std::string(1000, '1'), 100000, "}"})),
            "malformed");
  EXPECT_EQ(outcome(ask_stream(grasp, {"{\"format\": [", "[],", 100000, "0]}"})), "malformed");
  // Blanks are not kept, so they are only counted.
  const std::string certificate = refutation(header(3, "0, 1, 0"), {"[\"leaf\", 0, 0, 0]"});
  const Answer answer = ask_stream(grasp, {certificate, million, 10, "\n"});
  EXPECT_EQ(outcome(answer), "leaf-bound") << explain(answer);
}

/// On the moment curve: so many planes bound a region of many more rays.
TEST(Hostile, MoreWorkThanTheFilesAllow) {
  std::string nodes;
  for (std::uint64_t t = 1; t <= 48; ++t) {
    nodes += nodes.empty() ? "[\"plane\"" : ", [\"plane\"";
    for (std::uint64_t k = 0, power = 1; k < 7; ++k, power *= t) {
      nodes += ", " + std::to_string(power);
    }
    nodes += "]";
  }
  const std::string grasp =
      R"({"format": "stickslip-grasp/2", "wrench": [0, 0, 0, 0, 0, 0], "contacts": []})";
  const std::string certificate =
      R"({"format": "stickslip-certificate/2",
 "question": {"contacts": 0, "wrench": [0, 0, 0, 0, 0, 0], "normal_law": "unilateral"},
 "verdict": "unstable", "tree": [)" +
      nodes + "]}";
  const Answer answer = ask(grasp, certificate);
  EXPECT_EQ(outcome(answer), "not judged") << explain(answer);
  // The limit is of one question, not of all.
  EXPECT_EQ(outcome(ask(fig1("0", "0, 1, 0"), refutation(header(3, "0, 1, 0"), {}))),
            "tree-short");
}

/// The walls of a parallelepiped in 30 coordinates have 2^29 vertices each.
TEST(Hostile, ManyCoordinates) {
  constexpr std::size_t kMany = 30;
  std::string bodies;
  std::string joints;
  std::string zeros;
  std::string unit;
  for (std::size_t i = 0; i < kMany; ++i) {
    const std::string comma = i == 0 ? "" : ", ";
    const std::string name = "\"l" + std::to_string(i) + "\"";
    bodies += comma + "{\"name\": " + name + ", \"slide\": [0, 1]}";
    joints += comma + "{\"turns\": {" + name + ": 1}, \"stiffness\": 1}";
    zeros += comma + "0";
    unit += comma + "[";
    for (std::size_t j = 0; j < kMany; ++j)
      unit += (j == 0 ? "" : ", ") + std::to_string(i == j);
    unit += "]";
  }
  const std::string grasp = R"({"format": "stickslip-grasp/3", "contacts": [], "bodies": [)" +
                            bodies + "], \"joints\": [" + joints + "]}";
  const Answer answer =
      ask(grasp, header(kMany, zeros) + R"("verdict": "stable", "parts": [{"twist": [)" +
                     zeros + "], \"walls\": [" + unit + "], \"direction\": [" + unit +
                     "], \"tree\": [[\"leaf\", " + zeros + "]]}]}");
  EXPECT_EQ(outcome(answer), "not judged") << explain(answer);
}

TEST(Hostile, StreamsThatFail) {
  std::istringstream grasp(fig1("0", "0, 1, 0"));
  std::istream broken(nullptr);
  EXPECT_EQ(outcome(check(grasp, broken, {})), "malformed");
}

}  // namespace
}  // namespace stickslip_check
