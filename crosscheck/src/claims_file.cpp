// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/crosscheck/claims_file.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json_members.hpp"
#include "stickslip/core/json_read.hpp"

namespace stickslip {
namespace {

using Kind = JsonNode::Kind;
using Pair = std::array<Rational, 2>;

constexpr const char* kThreeNumbers = "an array of three numbers";

bool is_position(const std::string& place) {
  return !place.empty() && place.front() >= '0' && place.front() <= '9';
}

/// What `read` returns; its errors get the path of what it reads in the line, unless they are
/// about another file or already say where in the line they are.
template <class Read>
auto within(const std::string& path, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    if (!error.file().empty() || is_position(error.place())) throw;
    const std::string below = error.place() == place_name("") ? "" : error.place();
    throw InputError("", path + (below.empty() ? "" : "." + below), error.problem(),
                     error.remedy());
  }
}

const JsonMember* find(const std::vector<JsonMember>& members, const char* key) {
  const auto it = std::find_if(members.begin(), members.end(),
                               [&](const JsonMember& m) { return m.key == key; });
  return it == members.end() ? nullptr : &*it;
}

const JsonMember& need(const std::vector<JsonMember>& members, const char* key,
                       const char* remedy) {
  const JsonMember* member = find(members, key);
  if (member == nullptr) fail_at("", std::string("the key \"") + key + "\" is missing", remedy);
  return *member;
}

void expect_keys(const std::vector<JsonMember>& members, const JsonKeys& allowed) {
  JsonNode object{Kind::kObject, {}, {}, {}};
  for (const JsonMember& member : members) object.keys.push_back(member.key);
  expect_object(object, "", allowed);
}

GraspFile read_grasp(const JsonMember& member, const std::string& folder) {
  return within("grasp", [&] {
    if (member.value.front() == '{') return parse_grasp(member.in_place(), "");
    const JsonNode name = parse_json(member.in_place(), "", {});
    expect(name, Kind::kString, "", "a grasp {...} or the name of a grasp file");
    // Never "-": standard input may be where the claims come from.
    const bool absolute = !name.text.empty() && name.text.front() == '/';
    return read_grasp_file(absolute ? name.text
                                    : (folder.empty() ? "." : folder) + "/" + name.text);
  });
}

QuestionOptions read_options(const std::vector<JsonMember>& members) {
  QuestionOptions options;
  const JsonMember* member = find(members, "options");
  if (member == nullptr) return options;
  return within("options", [&] {
    const JsonNode node = parse_json(member->in_place(), "", {});
    expect_object(node, "", {"wrench", "preload", "normal_law", "snap_normals"});
    if (const JsonNode* wrench = node.find("wrench")) {
      const auto w = read_vector(*wrench, "wrench", 3, kThreeNumbers);
      options.wrench = Wrench{w[0], w[1], w[2]};
    }
    if (const JsonNode* preload = node.find("preload")) {
      options.preload = read_number(*preload, "preload");
    }
    if (const JsonNode* tolerance = node.find("snap_normals")) {
      options.snap_tolerance = read_number(*tolerance, "snap_normals");
    }
    if (const JsonNode* law = node.find("normal_law")) {
      if (law->kind != Kind::kString ||
          (law->text != "unilateral" && law->text != "bilateral")) {
        fail_at("normal_law", "found " + describe(*law),
                "expected \"unilateral\" or \"bilateral\"");
      }
      if (law->text == "bilateral") options.law = NormalLaw::kBilateral;
    }
    return options;
  });
}

Rational length_of(const Vector2& normal, std::size_t contact) {
  const Rational square = normal.x * normal.x + normal.y * normal.y;
  if (const auto length = exact_sqrt(square)) return *length;
  fail_at(
      element_path("forces", contact),
      "the normal of contact " + std::to_string(contact) + " has the irrational length sqrt(" +
          to_string(square) + "), so a force of rational magnitude is not a rational vector",
      "give \"force_vectors\", [fx, fy] in the object frame, in place of \"forces\"; or give "
      "normals of rational length, as options.snap_normals makes them");
}

/// Coefficients of the contacts' normals and tangents.
std::vector<ContactForce> coefficients(const std::vector<Pair>& given, bool are_vectors,
                                       const Grasp& grasp) {
  if (given.size() != grasp.size()) {
    fail_at(are_vectors ? "force_vectors" : "forces",
            "found " + std::to_string(given.size()) + " forces",
            "the grasp has " + std::to_string(grasp.size()) +
                " contacts; give one force for each, in their order");
  }
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto& [first, second] = given[i];
    const Vector2& n = grasp.contacts()[i].normal;
    if (are_vectors) {
      const Rational square = n.x * n.x + n.y * n.y;
      forces.push_back(
          {(first * n.x + second * n.y) / square, (second * n.x - first * n.y) / square});
    } else if (first.is_zero() && second.is_zero()) {
      forces.push_back({0, 0});
    } else {
      const Rational length = length_of(n, i);
      forces.push_back({first / length, second / length});
    }
  }
  return forces;
}

Claim read_claim(const JsonMember& member, const Grasp& grasp) {
  return within("claim", [&] {
    // Which of the two long lists there is must be known before one of them can be streamed.
    const std::string text = member.in_place();
    bool are_vectors = false;
    if (member.value.front() == '{') {
      const std::vector<JsonMember> parts = split_json_object(text);
      are_vectors = find(parts, "force_vectors") != nullptr;
      if (are_vectors && find(parts, "forces") != nullptr) {
        fail_at("", "found both \"forces\" and \"force_vectors\"", "give one of them");
      }
    }
    const std::string key = are_vectors ? "force_vectors" : "forces";
    const char* form = are_vectors ? "an array of two numbers [fx, fy]"
                                   : "an array of two numbers [normal, tangential]";
    std::vector<Pair> given;
    const JsonNode node = parse_json(text, key, [&](std::size_t index, const JsonNode& force) {
      auto values = read_vector(force, element_path(key, index), 2, form);
      given.push_back({std::move(values[0]), std::move(values[1])});
    });
    expect_object(node, "", {"verdict", "twist", "forces", "force_vectors"});
    const JsonNode& verdict =
        stickslip::member(node, "", "verdict", R"(add "verdict": "stable" or "unstable")");
    if (verdict.kind != Kind::kString ||
        (verdict.text != "stable" && verdict.text != "unstable")) {
      fail_at("verdict", "found " + describe(verdict), R"(expected "stable" or "unstable")");
    }
    Claim claim;
    claim.stable = verdict.text == "stable";
    if (const JsonNode* twist = node.find("twist")) {
      const auto d = read_vector(*twist, "twist", 3, kThreeNumbers);
      claim.solution.twist = Twist{d[0], d[1], d[2]};
    }
    if (const JsonNode* forces = node.find(key)) {
      expect(*forces, Kind::kArray, key, "one force for each contact, [[...], ...]");
      claim.solution.forces = coefficients(given, are_vectors, grasp);
    }
    return claim;
  });
}

}  // namespace

ClaimLine parse_claim_line(std::string_view line, const std::string& folder) {
  const std::vector<JsonMember> members = split_json_object(line);
  expect_keys(members, {"grasp", "options", "claim"});
  const GraspFile file = read_grasp(
      need(members, "grasp", "add \"grasp\": {...} or \"grasp\": \"file.json\""), folder);
  const QuestionOptions options = read_options(members);
  ClaimLine result{within("options", [&] { return ask(file, options); }), {}};
  // Preloaded contacts with normals of irrational length are an error of this line.
  within("grasp", [&] { return contact_rows(result.question.loaded.grasp).size(); });
  result.claim =
      read_claim(need(members, "claim", R"(add "claim": {"verdict": "stable"} or "unstable")"),
                 result.question.loaded.grasp);
  return result;
}

}  // namespace stickslip
