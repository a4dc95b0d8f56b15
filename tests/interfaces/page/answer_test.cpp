// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "interfaces/page/web_files.hpp"
#include "rounds.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/interfaces/html.hpp"

namespace stickslip {
namespace {

constexpr const char* kPinch = R"({"format": "stickslip-grasp/1", "name": "</script><!-- \" ü",
  "defaults": {"friction": "1/2", "preload": 1},
  "contacts": [{"position": [-1, 0], "normal": [1, 0]}, {"position": [1, 0], "normal": [-1, 0]}],
  "wrench": [0, "1/2", 0]})";

/// An answer as a page reads it.
using Json = nlohmann::ordered_json;

Json answer_about(const std::string& grasp, const PageParts& parts = all_page_parts(),
                  const PageLimits& limits = {}, const QuestionText& asked = {}) {
  return Json::parse(
      page_answer(parse_any_grasp(grasp, "test"), asked, parts, limits, "test").dump());
}

/// A grasp of contacts at these places, with these normals; certain and without preload.
std::string grasp_of(const std::vector<std::array<int, 4>>& contacts) {
  Json grasp{
      {"format", "stickslip-grasp/2"}, {"contacts", Json::array()}, {"wrench", {0, 0, 0}}};
  for (const auto& [x, y, nx, ny] : contacts) {
    grasp["contacts"].push_back({{"position", {x, y}}, {"normal", {nx, ny}}, {"friction", 1}});
  }
  return grasp.dump();
}

std::size_t count(const Json& cells, const std::string& kind) {
  std::size_t n = 0;
  for (const Json& cell : cells) n += cell["kind"] == kind ? 1 : 0;
  return n;
}

TEST(PageAnswer, WhatIsNotAskedForIsLeftOut) {
  const Json answer = answer_about(kPinch, {PagePart::kStates, PagePart::kWarnings});
  EXPECT_TRUE(answer.contains("states"));
  for (const char* part : {"decide", "certificate", "near", "region", "margin", "map",
                           "quality", "lost", "compare"}) {
    EXPECT_FALSE(answer.contains(part)) << part;
  }
}

TEST(PageAnswer, TheGraspIsOfVersion2AndTheSame) {
  for (const std::string& text :
       {std::string(kPinch),
        std::string(R"({"format": "stickslip-grasp/2", "name": "\"stickslip-grasp/1\"",
          "units": {"length": "m", "force": "N"}, "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
          "contacts": [{"on": [0, "1/2"], "friction": {"min": 0, "max": 1}}],
          "cases": [{"name": "a", "wrench": [0, 1, 2]}]})")}) {
    const std::string written = answer_about(text, {PagePart::kDecide})["grasp"];
    EXPECT_EQ(written.rfind("{\"format\": \"stickslip-grasp/2\",", 0), 0) << written;
    const auto first = parse_any_grasp(text, "first");
    const auto second = parse_any_grasp(written, "second");
    EXPECT_EQ(write_grasp_file(first), write_grasp_file(second));
  }
}

// Of arrangements of every rank: Euler's formula, and boundaries that are where the cells are.
TEST(PageAnswer, Cells) {
  struct Sphere {
    std::vector<std::array<int, 4>> contacts;
    std::array<std::size_t, 3> counts;  // of faces, edges, vertices
  };
  for (const Sphere& expected : std::vector<Sphere>{
           {{}, {1, 0, 0}},
           {{{1, 0, -1, 0}}, {2, 1, 0}},
           {{{1, 0, -1, 0}, {-1, 0, 1, 0}}, {4, 4, 2}},
           {{{1000, 7, -1, 0}, {-1000, 7, 1, 0}, {3, 900, 0, -1}}, {8, 12, 6}}}) {
    const Json answer = answer_about(grasp_of(expected.contacts));
    const Json& states = answer["states"];
    const Json& cells = states["cells"];
    EXPECT_EQ(count(cells, "face"), expected.counts[0]);
    EXPECT_EQ(count(cells, "edge"), expected.counts[1]);
    EXPECT_EQ(count(cells, "vertex"), expected.counts[2]);
    EXPECT_EQ(states["vertices"].size(), expected.counts[2]);
    for (const Json& cell : cells) {
      const auto d = cell["motion"].get<std::array<double, 3>>();
      EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-6);
      const std::string signs = cell["states"];
      for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
        const auto& [x, y, nx, ny] = expected.contacts[i];
        const double slip = -ny * (d[0] - d[2] * y) + nx * (d[1] + d[2] * x);
        EXPECT_EQ(signs[i], std::abs(slip) < 1e-6 ? '0' : slip > 0 ? '+' : '-') << cell;
      }
      // A contact that sticks in the cell does so on its boundary.
      for (const Json& vertex : cell["boundary"]) {
        const Json& corner =
            cells[cells.size() - expected.counts[2] + vertex.get<std::size_t>()];
        EXPECT_EQ(corner["motion"], states["vertices"][vertex.get<std::size_t>()]);
        const std::string at = corner["states"];
        for (std::size_t i = 0; i < at.size(); ++i) {
          EXPECT_TRUE(at[i] == '0' || at[i] == signs[i]) << cell << corner;
        }
      }
    }
  }
}

TEST(PageAnswer, PartsAreGivenUpInTimeAndSaySo) {
  PageLimits limits;
  limits.time = std::chrono::milliseconds(1);
  limits.limits_verdict = true;
  std::vector<std::array<int, 4>> ring;
  const std::array<std::array<int, 2>, 5> normals{
      {{3, 4}, {-4, 3}, {5, -12}, {-8, -15}, {4, -3}}};
  for (std::size_t i = 0; i < 100; ++i) {
    const int x = static_cast<int>(i);
    ring.push_back({x - 50, 2 * (x % 7), normals[i % 5][0], normals[i % 5][1]});
  }
  Json grasp = Json::parse(grasp_of(ring));
  grasp["defaults"]["preload"] = 1;  // the region takes seconds
  const Json answer =
      answer_about(grasp.dump(), {PagePart::kRegion, PagePart::kWarnings}, limits);
  EXPECT_TRUE(answer["region"].is_null());
  ASSERT_EQ(answer["messages"].size(), 1U);
  EXPECT_EQ(answer["messages"][0], "region: not known within 0.001 seconds.");
}

// At first a witness is followed, which takes a moment, and then come hundreds of proofs by
// degree.
TEST(PageAnswer, AMarginInSpaceThatIsGivenUpKeepsWhatIsKnown) {
  Json grasp{{"format", "stickslip-grasp/2"},
             {"defaults", {{"friction", "1/2"}, {"preload", 1}}},
             {"contacts", Json::array()},
             {"wrench", {1, -3, 2, 1, 0, -2}}};
  const std::vector<std::array<int, 3>> normals{{3, 4, 0},  {0, -3, 4}, {-4, 0, 3},
                                                {1, 2, -2}, {-2, 1, 2}, {2, -2, -1}};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    Json position = Json::array();
    for (const int n : normals[i]) position.push_back(0.25 * static_cast<double>(i % 3) - n);
    grasp["contacts"].push_back({{"position", position}, {"normal", normals[i]}});
  }
  Json answer;
  PageLimits limits;
  for (limits.time = std::chrono::milliseconds(10); answer["margin"].is_null();
       limits.time *= 2) {
    answer = answer_about(grasp.dump(), {PagePart::kMargin, PagePart::kWarnings}, limits);
    ASSERT_EQ(answer["messages"].size(), 1U);
  }
  const std::string said = answer["messages"][0];
  EXPECT_EQ(said.rfind("margin: no more is known within ", 0), 0U) << said;
  const Json& resisted = answer["margin"]["resisted_float"];
  ASSERT_GE(resisted.size(), 1U);
  double end = -1;
  for (const Json& interval : resisted) {
    EXPECT_GT(interval[0].get<double>(), end);
    EXPECT_GT(interval[1], interval[0]);
    end = interval[1];
  }
}

constexpr const char* kCube = R"({"format": "stickslip-grasp/2",
  "body": {"vertices": [[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [1, 1, -1],
                        [-1, -1, 1], [1, -1, 1], [-1, 1, 1], [1, 1, 1]],
           "faces": [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]},
  "defaults": {"friction": "1/2", "preload": 4},
  "contacts": [{"position": [-1, 0, 0], "normal": [1, 0, 0]}, {"position": [1, 0, 0], "normal": [-1, 0, 0]}],
  "wrench": [0, 0, -1, 0, 0, 0]})";

// Between two fingers a force s along them takes from one normal force, 4, what it gives to the
// other. Each has half of t, so that nothing turns, and friction of at most half of its normal
// force: |t| <= 4 - |s| / 2.
TEST(PageAnswer, ARegionInSpace) {
  PageLimits limits;
  if (test::kSanitized) limits.time = std::chrono::seconds(5);  // of a minute
  const Json region = answer_about(kCube, {PagePart::kRegion}, limits)["region"];
  EXPECT_EQ(region["plane"]["u"], (Json{"1", "0", "0", "0", "0", "0"}));
  EXPECT_EQ(region["plane"]["v"], (Json{"0", "0", "1", "0", "0", "0"}));
  EXPECT_EQ(region["plane"]["origin"], (Json{"0", "0", "0", "0", "0", "0"}));
  EXPECT_EQ(region["x"]["range"], (Json{"-8", "8"}));
  double stable = 0;
  double unstable = 0;
  for (const Json& cell : region["cells"]) {
    const auto ends = [&](const char* axis) {
      const double low = cell[axis + std::string("_float")][0];
      const double high = cell[axis + std::string("_float")][1];
      const double nearest =
          low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
      return std::array<double, 3>{nearest, std::max(std::abs(low), std::abs(high)),
                                   high - low};
    };
    const auto [least_s, most_s, width] = ends("x");
    const auto [least_t, most_t, height] = ends("y");
    if (cell["verdict"] == "stable") {
      stable += width * height;
      EXPECT_LE(most_t, 4 - most_s / 2) << cell;
    }
    if (cell["verdict"] == "unstable") {
      unstable += width * height;
      EXPECT_GE(least_t, 4 - least_s / 2) << cell;
    }
  }
  if (test::kSanitized) return;
  EXPECT_GT(stable, 32) << "half of all that is resisted";
  EXPECT_GT(unstable, 96) << "half of what is not";
}

TEST(PageAnswer, ARegionInSpaceIsAboutOneGrasp) {
  QuestionText asked;
  asked.uncertain = "friction=1%";
  const Json answer = answer_about(kCube, {PagePart::kRegion}, {}, asked);
  EXPECT_TRUE(answer["region"].is_null());
  EXPECT_NE(answer["messages"].dump().find("more than one grasp"), std::string::npos);
}

TEST(PageAnswer, WhoeverAskedMayBreakItOff) {
  const Cancellation cancellation([] { return true; });
  EXPECT_THROW(answer_about(kPinch), Cancelled);
  PageLimits limits;
  limits.time = std::chrono::hours(1);
  limits.limits_verdict = true;
  EXPECT_THROW(answer_about(kPinch, all_page_parts(), limits), Cancelled);
}

TEST(PageReply, NormalsAreSnappedOnRequest) {
  Json grasp = Json::parse(kPinch);
  grasp["contacts"][0]["normal"] = {3, 1};
  Json request{{"grasp", grasp.dump()}, {"parts", {"decide"}}};
  const Json as_it_is = Json::parse(reply_to(request.dump(), {}).body);
  EXPECT_EQ(as_it_is["decide"]["engine"], "intervals");
  EXPECT_FALSE(as_it_is["certificate"].is_null());
  request["options"] = {{"snap", true}};
  const Json snapped = Json::parse(reply_to(request.dump(), {}).body);
  EXPECT_EQ(snapped["decide"]["engine"], "branch-and-bound");
  EXPECT_EQ(snapped["decide"]["verdict"], as_it_is["decide"]["verdict"]);
  // It is the grasp of the answer that the certificate is about.
  EXPECT_NE(snapped["grasp"], as_it_is["grasp"]);
}

TEST(PageHtml, EveryScriptHasTheNonceAndTheAnswerIsThere) {
  const Json answer =
      answer_about(kPinch, {PagePart::kDecide, PagePart::kStates, PagePart::kRegion,
                            PagePart::kMargin, PagePart::kWarnings});
  const std::string html = page_html(stickslip::Json::parse(answer.dump()), "0123");
  std::size_t scripts = 0;
  for (std::size_t at = html.find("<script"); at != std::string::npos;
       at = html.find("<script", at + 1)) {
    const std::string tag = html.substr(at, html.find('>', at) - at);
    if (tag.find("application/json") == std::string::npos) {
      EXPECT_EQ(tag, "<script nonce=\"0123\"");
      ++scripts;
    } else {
      const std::size_t begin = html.find('>', at) + 1;
      EXPECT_EQ(Json::parse(html.substr(begin, html.find("</script>", at) - begin)), answer);
    }
  }
  EXPECT_GT(scripts, 0U);
  EXPECT_EQ(html.find("<!-- include"), std::string::npos);
}

TEST(PageHtml, FilesDoNotEndTheElementThatTheyStandIn) {
  for (const auto& [name, text] : page_detail::web_files()) {
    if (name == "page.html") continue;
    EXPECT_EQ(text.find("</script"), std::string::npos) << name;
    EXPECT_EQ(text.find("</style"), std::string::npos) << name;
    EXPECT_EQ(text.find("<!--"), std::string::npos) << name;
  }
}

TEST(PageAnswer, WhatElseThanAVerdictIsSaidOfABallIsAboutTheLoadInItsCentre) {
  QuestionText asked;
  asked.uncertain = "wrench=ball:1/10:length=2:about=1:0";
  const bool map = !test::kSanitized;  // half a minute each
  PageParts parts{PagePart::kDecide, PagePart::kRegion, PagePart::kMargin};
  if (map) parts.insert(PagePart::kMap);
  const Json plain = answer_about(kPinch, parts);
  parts.insert(PagePart::kQuality);
  const Json ball = answer_about(kPinch, parts, {}, asked);
  EXPECT_EQ(ball["decide"]["box"], true);
  EXPECT_EQ(ball["decide"]["ball"]["radius"], "1/10");
  std::vector<std::string> same{"region", "margin"};
  if (map) same.emplace_back("map");
  for (const std::string& part : same) {
    ASSERT_FALSE(plain[part].is_null()) << part;
    EXPECT_EQ(ball[part], plain[part]) << part;
  }
  EXPECT_EQ(ball["quality"]["ball"]["length"], "2");
  // With more than a ball there is more than one grasp in its centre.
  asked.uncertain += ",friction=1%";
  const Json more = answer_about(kPinch, all_page_parts(), {}, asked);
  for (const char* part : {"region", "margin", "map", "quality", "lost"}) {
    EXPECT_TRUE(more[part].is_null()) << part;
  }
}

// Forces up to 1 across the line of the pads are resisted, and the load is 1/2: so another 1/2
// is all that there can be.
TEST(PageAnswer, TheQualityIsBelowWhatIsLeftOfFriction) {
  const Json answer = answer_about(kPinch, {PagePart::kDecide, PagePart::kQuality});
  const Json& quality = answer["quality"];
  EXPECT_EQ(quality["ball"]["length"], "1");
  EXPECT_GT(quality["proved_float"], 0.1);
  EXPECT_LT(quality["proved_float"], quality["refuted_float"]);
  EXPECT_LE(quality["proved_float"], 0.5);
  EXPECT_EQ(answer["lost"]["decide"]["verdict"], "unstable");
  EXPECT_EQ(answer["lost"]["decide"]["wrench"], quality["not_resisted"]);
  EXPECT_TRUE(answer["lost"]["certificate"].is_string());
  EXPECT_FALSE(answer["lost"].contains("quality"));
}

const PageParts kCompare{PagePart::kCompare};

// A pinch leaves a turn about its line free in space. Its load is friction alone, of half of
// the normal force that each finger presses with at least.
TEST(PageAnswer, OtherMethodsHaveTheirRows) {
  for (const auto& [grasp, load, robustness] :
       {std::tuple{kPinch, 0.5, "of"}, std::tuple{kCube, 1.0, "0"}}) {
    QuestionText asked;
    asked.uncertain = grasp == kPinch ? "wrench=ball:1/10:length=2" : "";
    const Json compare = answer_about(grasp, kCompare, {}, asked)["compare"];
    EXPECT_EQ(compare["length"], grasp == kPinch ? "2" : "1");
    std::map<std::string, Json> rows;
    for (const Json& row : compare["methods"]) rows[row["method"]] = row;
    EXPECT_EQ(rows["passive equilibrium"]["verdict"], "stable");
    const Json& sum = rows["least normal forces"]["evidence"]["sum"];
    EXPECT_LE(sum["lower_float"], 2 * load + 1e-5);
    EXPECT_GE(sum["upper_float"], 2 * load - 1e-5);
    const std::string verdict = rows["potential grasp robustness"]["verdict"];
    EXPECT_EQ(verdict == "0", std::string(robustness) == "0") << verdict;
  }
}

TEST(PageAnswer, MethodsThatAreNotDoneInTimeSaySo) {
  PageLimits limits;
  limits.time = std::chrono::milliseconds(1);
  const Json answer = answer_about(kCube, kCompare, limits);
  EXPECT_TRUE(answer["messages"].empty());
  const Json& rows = answer["compare"]["methods"];
  EXPECT_GT(rows.size(), 10U);
  const Json& last = rows.back();
  EXPECT_EQ(last["verdict"], "not computed");
  EXPECT_EQ(last["why"].get<std::string>().rfind("the time limit of 0.001 s", 0), 0U) << last;
}

TEST(PageAnswer, OtherMethodsAreAboutOneGrasp) {
  for (const auto& [uncertain, said] :
       {std::pair{"friction=1%", "more than one grasp"},
        std::pair{"wrench=ball:1/10,friction=1%", "more than"}}) {
    QuestionText asked;
    asked.uncertain = uncertain;
    const Json answer = answer_about(kPinch, kCompare, {}, asked);
    EXPECT_TRUE(answer["compare"].is_null());
    EXPECT_NE(answer["messages"].dump().find(said), std::string::npos) << answer;
  }
}

}  // namespace
}  // namespace stickslip
