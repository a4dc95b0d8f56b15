// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/interfaces/answer.hpp"

namespace stickslip {
namespace {

/// The most that a snapped normal differs from the true unit normal.
const Rational kSnapWithin(1, 1000000000);

/// Returns the text of a number, or of a string.
std::string spelled(const JsonNode& node, const std::string& path, const char* expected) {
  if (node.kind != JsonNode::Kind::kNumber)
    expect(node, JsonNode::Kind::kString, path, expected);
  return node.text;
}

/// Returns "WX,WY,T", given as a string or as an array.
std::string wrench_text(const JsonNode& node, const std::string& path) {
  constexpr const char* kExpected = "a wrench, as in \"0,1,0\" or [0, 1, 0]";
  if (node.kind != JsonNode::Kind::kArray) return spelled(node, path, kExpected);
  std::string text;
  for (const JsonNode& entry : node.children) {
    text += (text.empty() ? "" : ",") + spelled(entry, path, kExpected);
  }
  return text;
}

bool truth(const JsonNode& node, const std::string& path) {
  expect(node, JsonNode::Kind::kBoolean, path, "true or false");
  return node.text == "true";
}

/// Turns normals of irrational length into rational unit vectors, as `stickslip snap` does.
void snap(GraspFile& file) {
  if (file.content.in_space()) return;
  if (LoadedGrasp* one = file.content.single()) {
    one->grasp = snap_normals(one->grasp, kSnapWithin).grasp;
    return;
  }
  GraspBox& box = *file.content.box();
  box = snap_normals(box, kSnapWithin).grasp;
}

struct Request {
  GraspFile grasp;
  QuestionText asked;
  PageParts parts = all_page_parts();
};

/// Reads the options. A member that is null counts as absent.
void read_options(const JsonNode& node, Request& request) {
  const std::string path = "options";
  expect_object(node, path,
                {"wrench", "case", "preload", "normal_law", "bilateral", "uncertain", "snap",
                 "warnings"});
  QuestionText& asked = request.asked;
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const std::string& key = node.keys[i];
    const JsonNode& value = node.children[i];
    const std::string place = member_path(path, key);
    if (value.kind == JsonNode::Kind::kNull) continue;
    if (key == "wrench") asked.wrench = wrench_text(value, place);
    if (key == "case") asked.case_name = spelled(value, place, "the name of a case");
    if (key == "preload") asked.preload = spelled(value, place, "a number");
    if (key == "uncertain") {
      asked.uncertain = spelled(value, place, "tolerances, as in \"friction=10%\"");
    }
    if (key == "normal_law") {
      asked.normal_law = spelled(value, place, "\"unilateral\" or \"bilateral\"");
      if (asked.normal_law != "unilateral" && asked.normal_law != "bilateral") {
        fail_at(place, "there is no law " + quote(asked.normal_law),
                "write \"unilateral\" or \"bilateral\"");
      }
    }
    if (key == "snap" && truth(value, place)) snap(request.grasp);
    if (key == "warnings" && !truth(value, place)) request.parts.erase(PagePart::kWarnings);
    if (key == "bilateral") asked.normal_law = truth(value, place) ? "bilateral" : "unilateral";
  }
}

void read_parts(const JsonNode& node, PageParts& parts) {
  expect(node, JsonNode::Kind::kArray, "parts", "an array of names");
  const std::map<std::string, PagePart> names{
      {"decide", PagePart::kDecide},  {"states", PagePart::kStates},
      {"region", PagePart::kRegion},  {"margin", PagePart::kMargin},
      {"map", PagePart::kMap},        {"quality", PagePart::kQuality},
      {"compare", PagePart::kCompare}};
  for (const auto& [name, part] : names) parts.erase(part);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const std::string path = element_path("parts", i);
    const std::string name = spelled(node.children[i], path, "a name");
    const auto found = names.find(name);
    if (found == names.end()) {
      fail_at(path, "there is no part " + quote(name),
              "the parts are decide, states, region, margin, map, quality, compare");
    }
    parts.insert(found->second);
  }
}

Request read_request(const std::string& text) {
  const JsonNode root = parse_json(text);
  expect_object(root, "", {"grasp", "options", "parts"});
  const JsonNode& grasp =
      member(root, "", "grasp", "give the text of a grasp file (docs/grasp_file.md)");
  expect(grasp, JsonNode::Kind::kString, "grasp", "the text of a grasp file");
  Request request{parse_any_grasp(grasp.text, "grasp"), {}};
  if (const JsonNode* options = root.find("options")) read_options(*options, request);
  if (const JsonNode* parts = root.find("parts")) read_parts(*parts, request.parts);
  return request;
}

Json error_json(const std::string& message, const std::string& place) {
  return {{"error", {{"message", message}, {"place", place}}}};
}

/// Returns the place of an error as a member of a request: words of a command line are renamed.
std::string place_of(const InputError& error) {
  const std::string& place = error.place();
  return place.rfind("--", 0) == 0 ? "options." + place.substr(2) : place;
}

}  // namespace

PageReply reply_to(const std::string& request, const PageLimits& limits) {
  try {
    const Request read = read_request(request);
    Json answer = page_answer(read.grasp, read.asked, read.parts, limits, "grasp");
    answer["live"] = true;
    return {200, answer.dump()};
  } catch (const InputError& error) {
    const std::string message =
        error.problem() + (error.remedy().empty() ? "" : "; " + error.remedy());
    return {400, error_json(message, place_of(error)).dump()};
  }
}

}  // namespace stickslip
