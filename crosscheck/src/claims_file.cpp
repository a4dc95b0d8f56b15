// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {
namespace {

using Kind = JsonNode::Kind;
using Pair = std::array<Rational, 2>;

constexpr const char* kThreeNumbers = "an array of three numbers";

/// A value of two spellings: whether it is the first.
bool is_first(const JsonNode& node, const std::string& path, const std::string& first,
              const std::string& second) {
  if (node.kind == Kind::kString && (node.text == first || node.text == second)) {
    return node.text == first;
  }
  fail_at(path, "found " + describe(node), "expected \"" + first + "\" or \"" + second + "\"");
}

GraspFile read_grasp(const JsonNode& node, StreamedGrasp& reader, const std::string& folder) {
  if (node.kind == Kind::kObject) {
    return within("grasp", [&] { return reader.finish(node); });
  }
  expect(node, Kind::kString, "grasp", "a grasp {...} or the name of a grasp file");
  // Never "-": standard input may be where the claims come from.
  const bool absolute = !node.text.empty() && node.text.front() == '/';
  return read_grasp_file(absolute ? node.text
                                  : (folder.empty() ? "." : folder) + "/" + node.text);
}

QuestionOptions read_options(const JsonNode& line) {
  QuestionOptions options;
  const JsonNode* node = line.find("options");
  if (node == nullptr) return options;
  expect_object(*node, "options", {"wrench", "case", "preload", "normal_law"});
  if (const JsonNode* wrench = node->find("wrench")) {
    const auto w = read_vector(*wrench, "options.wrench", 3, kThreeNumbers);
    options.wrench = {w.begin(), w.end()};
  }
  if (const JsonNode* name = node->find("case")) {
    expect(*name, Kind::kString, "options.case", "the name of a case of the grasp");
    options.case_name = name->text;
  }
  if (const JsonNode* preload = node->find("preload")) {
    options.preload = read_number(*preload, "options.preload");
  }
  if (const JsonNode* law = node->find("normal_law")) {
    options.law = is_first(*law, "options.normal_law", "unilateral", "bilateral")
                      ? NormalLaw::kUnilateral
                      : NormalLaw::kBilateral;
  }
  return options;
}

Rational length_of(const Vector2& normal, std::size_t contact) {
  const Rational square = normal.x * normal.x + normal.y * normal.y;
  if (const auto length = exact_sqrt(square)) return *length;
  fail_at(element_path("claim.forces", contact),
          "the normal of contact " + std::to_string(contact) +
              " has the irrational length sqrt(" + to_string(square) +
              "), so a force of rational magnitude is not a rational vector",
          std::string("give \"force_vectors\", [fx, fy] in the object frame, in place of "
                      "\"forces\"; or ") +
              kSnapRemedy);
}

/// Coefficients of the contacts' normals and tangents.
std::vector<ContactForce> coefficients(const std::vector<Pair>& given, bool are_vectors,
                                       const Grasp& grasp) {
  if (given.size() != grasp.size()) {
    fail_at(are_vectors ? "claim.force_vectors" : "claim.forces",
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

/// The elements of claim.forces or of claim.force_vectors.
struct ForceList {
  std::string path;
  const char* form;
  std::vector<Pair> forces;

  JsonStream stream(std::vector<std::string> keys) {
    return {std::move(keys), [this](std::size_t index, const JsonNode& force) {
              auto values = read_vector(force, element_path(path, index), 2, form);
              forces.push_back({std::move(values[0]), std::move(values[1])});
            }};
  }
};

Claim read_claim(const JsonNode& node, const ForceList& magnitudes, const ForceList& vectors,
                 const Grasp& grasp) {
  expect_object(node, "claim", {"verdict", "twist", "forces", "force_vectors"});
  Claim claim;
  claim.stable =
      is_first(member(node, "claim", "verdict", R"(add "verdict": "stable" or "unstable")"),
               "claim.verdict", "stable", "unstable");
  if (const JsonNode* twist = node.find("twist")) {
    const auto d = read_vector(*twist, "claim.twist", 3, kThreeNumbers);
    claim.solution.twist = Twist{d[0], d[1], d[2]};
  }
  const JsonNode* forces = node.find("forces");
  const JsonNode* force_vectors = node.find("force_vectors");
  if (forces != nullptr && force_vectors != nullptr) {
    fail_at("claim", "found both \"forces\" and \"force_vectors\"", "give one of them");
  }
  const bool are_vectors = force_vectors != nullptr;
  if (const JsonNode* list = are_vectors ? force_vectors : forces) {
    const ForceList& given = are_vectors ? vectors : magnitudes;
    expect(*list, Kind::kArray, given.path, "one force for each contact, [[...], ...]");
    claim.solution.forces = coefficients(given.forces, are_vectors, grasp);
  }
  return claim;
}

}  // namespace

ClaimLine parse_claim_line(std::string_view line, const std::string& folder) {
  StreamedGrasp contacts;
  ForceList magnitudes{"claim.forces", "an array of two numbers [normal, tangential]", {}};
  ForceList vectors{"claim.force_vectors", "an array of two numbers [fx, fy]", {}};
  const JsonNode root =
      parse_json(line, {{{"grasp", "contacts"},
                         [&](std::size_t index, const JsonNode& contact) {
                           within("grasp", [&] { contacts.add_contact(index, contact); });
                         }},
                        magnitudes.stream({"claim", "forces"}),
                        vectors.stream({"claim", "force_vectors"})});
  expect_object(root, "", {"grasp", "options", "claim"});
  const GraspFile file =
      read_grasp(member(root, "", "grasp", "add \"grasp\": {...} or \"grasp\": \"file.json\""),
                 contacts, folder);
  const QuestionOptions options = read_options(root);
  ClaimLine result{within("options", [&] { return ask(file, options); }), {}};
  // Preloaded contacts with normals of irrational length are an error of this line.
  within("grasp", [&] { return problem_of(result.question).size(); });
  result.claim = read_claim(
      member(root, "", "claim", R"(add "claim": {"verdict": "stable"} or "unstable")"),
      magnitudes, vectors, result.question.loaded().grasp);
  return result;
}

}  // namespace stickslip
