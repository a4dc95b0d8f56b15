// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "paper_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;

const std::string kContact = R"({"position": [0, -1], "normal": [0, 1], "friction": "1/2"})";

std::string grasp_with(const std::string& contacts) {
  return R"({"format": "stickslip-grasp/1", "contacts": [)" + contacts +
         R"(], "wrench": [0, -1, 0]})";
}

std::string line_with(const std::string& claim, const std::string& options = "{}",
                      const std::string& contacts = kContact) {
  return "{\"grasp\": " + grasp_with(contacts) + ", \"options\": " + options +
         ", \"claim\": " + claim + "}";
}

const std::string kClaim = R"({"verdict": "stable"})";

TEST(ParseClaimLine, ReadsEveryNumberAsSpelled) {
  const ClaimLine line = parse_claim_line(
      line_with(R"({"verdict": "stable", "twist": [0.1, "-1/3", 1e-20],
                    "forces": [["2/3", 0.10000000000000000001]]})",
                R"({"wrench": [0, "-22/7", 1e-3], "preload": 0.3, "normal_law": "bilateral"})"),
      "");
  EXPECT_EQ(line.question.loaded().wrench, (Wrench{0, Rational(-22, 7), Rational(1, 1000)}));
  EXPECT_EQ(line.question.loaded().grasp.contacts()[0].preload, Rational(3, 10));
  EXPECT_EQ(line.question.law, NormalLaw::kBilateral);
  EXPECT_TRUE(line.claim.stable);
  EXPECT_EQ(line.claim.twist,
            (RationalRow{Rational(1, 10), Rational(-1, 3), parse_rational("1e-20")}));
  // Along the normal (0, 1) and the tangent (-1, 0).
  EXPECT_EQ(line.claim.forces->at(0),
            (RationalRow{-parse_rational("0.10000000000000000001"), Rational(2, 3)}));
}

TEST(ParseClaimLine, MagnitudesAndVectorsAreTheSameForces) {
  const std::string contact = R"({"position": [0, 0], "normal": [3, 4], "friction": 1})";
  // Normal force 10, tangential 5: 10 (3, 4)/5 + 5 (-4, 3)/5 = (2, 11).
  for (const char* forces : {R"("forces": [[10, 5]])", R"("force_vectors": [[2, 11]])"}) {
    const ClaimLine line = parse_claim_line(
        line_with(std::string(R"({"verdict": "stable", )") + forces + "}", "{}", contact), "");
    EXPECT_EQ(line.claim.forces->at(0), (RationalRow{2, 11})) << forces;
  }
}

TEST(ParseClaimLine, IrrationalNormals) {
  const std::string contact = R"({"position": [0, 0], "normal": [1, 1], "friction": 1})";
  const auto parse = [&](const std::string& forces) {
    return parse_claim_line(
        line_with(R"({"verdict": "stable", )" + forces + "}", "{}", contact), "");
  };
  const ClaimLine line = parse(R"("force_vectors": [[3, 1]])");
  EXPECT_EQ(line.claim.forces->at(0), (RationalRow{3, 1}));
  EXPECT_NO_THROW(parse(R"("forces": [[0, 0]])"));
  const ClaimLine pressed = parse_claim_line(
      line_with(kClaim, "{}",
                R"({"position": [0, 0], "normal": [1, 1], "friction": 1, "preload": 1})"),
      "");
  EXPECT_TRUE(pressed.question.box() != nullptr && pressed.question.box()->is_point());
  try {
    parse(R"("forces": [[1, 0]])");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "claim.forces[0]");
    EXPECT_THAT(error.problem(), HasSubstr("sqrt(2)"));
    EXPECT_THAT(error.remedy(), HasSubstr("force_vectors"));
    EXPECT_THAT(error.remedy(), HasSubstr("stickslip snap"));
  }
}

TEST(ParseClaimLine, InSpaceAllVectorsHaveTheirCoordinates) {
  // The claim may stand before the grasp, whose coordinates are not known then.
  const std::string grasp =
      R"("grasp": {"format": "stickslip-grasp/2", "contacts": [{"position": [0, 0, 1],
          "normal": [1, 1, 1], "friction": 1, "preload": 2}], "wrench": [0, 0, 0, 0, 0, 0]})";
  const auto parse = [&](const std::string& solution) {
    return parse_claim_line(R"({"claim": {"verdict": "stable", )" + solution +
                                R"(}, "options": {"wrench": [0, 0, -3, 0, 0, "1/7"]}, )" +
                                grasp + "}",
                            "");
  };
  const ClaimLine line =
      parse(R"("twist": [0.1, 0, 0, 0, 0, "2/3"], "force_vectors": [[1, "-1/3", 0.5]])");
  EXPECT_TRUE(line.question.in_space());
  EXPECT_EQ(line.question.box()->wrench[5], point_interval(Rational(1, 7)));
  EXPECT_EQ(line.claim.twist, (RationalRow{Rational(1, 10), 0, 0, 0, 0, Rational(2, 3)}));
  EXPECT_EQ(line.claim.forces,
            (std::vector<RationalRow>{{1, Rational(-1, 3), Rational(1, 2)}}));
}

TEST(ParseClaimLine, LongListsOfForcesAreRead) {
  std::string contacts = kContact;
  std::string forces = "[1, 0]";
  for (int i = 1; i < 2000; ++i) {
    contacts += ", " + kContact;
    forces += ", [1, 0]";
  }
  for (const char* key : {"forces", "force_vectors"}) {
    const ClaimLine line = parse_claim_line(
        line_with(R"({"verdict": "stable", ")" + std::string(key) + "\": [" + forces + "]}",
                  "{}", contacts),
        "");
    EXPECT_EQ(line.claim.forces->size(), 2000U);
  }
}

TEST(ParseClaimLine, FilesAreRelativeToTheFolder) {
  const std::string folder = ::testing::TempDir();
  std::ofstream(folder + "/referred.json") << grasp_with(kContact);
  const std::string line = R"({"grasp": "referred.json", "claim": {"verdict": "unstable"}})";
  EXPECT_EQ(parse_claim_line(line, folder).question.loaded().grasp.size(), 1U);
  const std::string absolute =
      "{\"grasp\": \"" + folder + "/referred.json\", \"claim\": " + kClaim + "}";
  EXPECT_EQ(parse_claim_line(absolute, "/nonexistent").question.loaded().grasp.size(), 1U);
  try {
    parse_claim_line(line, folder + "/nowhere");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.file(), HasSubstr("nowhere/referred.json"));
  }
  // Not standard input.
  EXPECT_THROW(parse_claim_line(R"({"grasp": "-", "claim": {"verdict": "stable"}})", ""),
               InputError);
}

struct Bad {
  std::string line;
  std::string place;
  std::string part;  ///< of the message
};

TEST(ParseClaimLine, BadLinesNameThePlace) {
  const std::string grasp = grasp_with(kContact);
  const std::vector<Bad> cases{
      {"nonsense", "1:1", "invalid literal"},
      {"[1]", "top level", "expected an object"},
      {"{", "1:2", "ends too early"},
      {"{\"grasp\": {", "1:12", "ends too early"},
      {"{\"grasp\" 3}", "1:10", "expected ':'"},
      {"{\"grasp\": }", "1:11", "unexpected '}'"},
      {"{\"grasp\": 3} x", "1:14", "\"x\""},
      {"{\"grasp\": 3}, {}", "1:13", "remove the comma"},
      {"{\"grasp: 3}", "1:12", "missing closing quote"},
      {"{\"grasp\": 3, \"grasp\": 4}", "top level", "twice"},
      {"{\"grasp\": 3, \"claim\": " + kClaim + "}", "grasp", "the number 3"},
      {"{\"claim\": " + kClaim + "}", "top level", "\"grasp\" is missing"},
      {"{\"grasp\": " + grasp + "}", "top level", "\"claim\" is missing"},
      {"{\"grasp\": " + grasp + ", \"claims\": " + kClaim + "}", "top level",
       "did you mean \"claim\""},
      {line_with(kClaim, "{}", R"({"position": [0, 0], "normal": [0, 1]})"),
       "grasp.contacts[0]", "friction"},
      {line_with(kClaim, "[]"), "options", "object"},
      {line_with(kClaim, R"({"": [1]})"), "options", "unknown key"},
      {line_with(kClaim, R"({"wrench": [1, 2]})"), "options.wrench", "2 values"},
      {line_with(kClaim, R"({"wrench": [1, 2, "x"]})"), "options.wrench[2]", "not a number"},
      {line_with(kClaim, R"({"preload": -1})"), "options.preload", "0 or more"},
      {line_with(kClaim, R"({"snap_normals": 1e-9})"), "options",
       "unknown key \"snap_normals\""},
      {line_with(kClaim, R"({"normal_law": "both"})"), "options.normal_law", "bilateral"},
      {line_with(kClaim + ", \"x\": [" + std::string(40, '[') + std::string(40, ']') + "]"),
       "x" + std::string(
                 "[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]"
                 "[0][0][0][0][0][0][0]"),
       "more than 32 levels"},
      {line_with("3"), "claim", "the number 3"},
      {line_with("{}"), "claim", "\"verdict\" is missing"},
      {line_with(R"({"verdict": "maybe"})"), "claim.verdict", "maybe"},
      {line_with(R"({"verdict": "stable", "twist": [0, 0]})"), "claim.twist", "2 values"},
      {line_with(R"({"verdict": "stable", "twist": [0, 0, null]})"), "claim.twist[2]", "null"},
      {line_with(R"({"verdict": "stable", "forces": 3})"), "claim.forces", "the number 3"},
      {line_with(R"({"verdict": "stable", "forces": [[1, 2, 3]]})"), "claim.forces[0]",
       "3 values"},
      {line_with(R"({"verdict": "stable", "forces": [[1, true]]})"), "claim.forces[0][1]",
       "true"},
      {line_with(R"({"verdict": "stable", "forces": []})"), "claim.forces", "0 forces"},
      {line_with(R"({"verdict": "stable", "forces": [[1, 0]], "force_vectors": [[1, 0]]})"),
       "claim", "both"},
      {line_with(R"({"verdict": "stable", "twits": [0, 0, 0]})"), "claim", "\"twist\""},
  };
  for (const Bad& bad : cases) {
    try {
      parse_claim_line(bad.line, "");
      ADD_FAILURE() << "accepted: " << bad.line;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), bad.place) << bad.line << "\n" << error.what();
      EXPECT_THAT(error.what(), HasSubstr(bad.part)) << bad.line;
      EXPECT_EQ(error.file(), "") << bad.line;
      EXPECT_NE(error.remedy(), "") << bad.line;
    }
  }
}

// Columns count from the beginning of the line, in characters.
TEST(ParseClaimLine, SyntaxErrorsHaveTheColumnOfTheLine) {
  for (const std::string name : {"a", "\u03bc"}) {
    const std::string start =
        R"({"grasp": {"format": "stickslip-grasp/1", "name": ")" + name + R"(", "contacts": [)";
    const std::size_t extra = name.size() - 1;
    try {
      parse_claim_line(start + "nul], \"wrench\": [0, 0, 0]}, \"claim\": {}}", "");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), "1:" + std::to_string(start.size() - extra + 1));
    }
  }
}

TEST(TextLines, NumbersLinesAndSkipsBlankOnes) {
  std::istringstream in("\n  \r\none\n\n\ttwo\r\n\nthree");
  TextLines lines(in);
  std::string line;
  std::vector<std::pair<std::size_t, std::string>> found;
  while (lines.next(line)) found.emplace_back(lines.number(), line);
  EXPECT_EQ(found, (std::vector<std::pair<std::size_t, std::string>>{
                       {3, "one"}, {5, "\ttwo\r"}, {7, "three"}}));
  EXPECT_FALSE(lines.next(line));
}

}  // namespace
}  // namespace stickslip
