// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {
namespace {

using Kind = JsonNode::Kind;

constexpr const char* kThreeNumbers = "an array of three numbers";
constexpr const char* kSixNumbers = "an array of six numbers, the grasp being in space";

/// Reads a motion or a wrench.
RationalRow read_row(const JsonNode& node, const std::string& path, bool in_space) {
  return read_vector(node, path, in_space ? 6 : 3, in_space ? kSixNumbers : kThreeNumbers);
}

/// Reads a value of two spellings. Returns true if it is the first.
bool is_first(const JsonNode& node, const std::string& path, const std::string& first,
              const std::string& second) {
  if (node.kind == Kind::kString && (node.text == first || node.text == second)) {
    return node.text == first;
  }
  fail_at(path, "found " + describe(node), "expected \"" + first + "\" or \"" + second + "\"");
}

GraspFile read_grasp(const JsonNode& node, StreamedGrasp& reader, const std::string& folder) {
  if (node.kind == Kind::kObject) {
    return within("grasp", [&] { return reader.finish_any(node, Intervals::kRefused); });
  }
  expect(node, Kind::kString, "grasp", "a grasp {...} or the name of a grasp file");
  // A "-" is a file name here, as standard input may be where the claims come from.
  const bool absolute = !node.text.empty() && node.text.front() == '/';
  return read_any_grasp_file(
      absolute ? node.text : (folder.empty() ? "." : folder) + "/" + node.text,
      Intervals::kRefused);
}

QuestionOptions read_options(const JsonNode& line, bool in_space) {
  QuestionOptions options;
  const JsonNode* node = line.find("options");
  if (node == nullptr) return options;
  expect_object(*node, "options", {"wrench", "case", "preload", "normal_law"});
  if (const JsonNode* wrench = node->find("wrench")) {
    options.wrench = read_row(*wrench, "options.wrench", in_space);
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

/// The elements of claim.forces or of claim.force_vectors. It may not be known yet whether the
/// grasp is in space.
class ForceList {
 public:
  ForceList(std::string path, const char* form) : path_(std::move(path)), form_(form) {}

  JsonStream stream(std::vector<std::string> keys) {
    return {std::move(keys), [this](std::size_t index, const JsonNode& force) {
              const bool has_three = force.kind == Kind::kArray && force.children.size() == 3;
              forces_.push_back(
                  read_vector(force, element_path(path_, index), has_three ? 3 : 2, form_));
            }};
  }

  const std::string& path() const { return path_; }

  /// Returns the forces; checks that there is one for each contact, of so many numbers.
  const std::vector<RationalRow>& checked(std::size_t contacts, std::size_t numbers,
                                          const char* form) const {
    if (forces_.size() != contacts) {
      fail_at(path_, "found " + std::to_string(forces_.size()) + " forces",
              "the grasp has " + std::to_string(contacts) +
                  " contacts; give one force for each, in their order");
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      if (forces_[i].size() == numbers) continue;
      fail_at(element_path(path_, i),
              "found an array of " + std::to_string(forces_[i].size()) + " values",
              std::string("expected ") + form);
    }
    return forces_;
  }

 private:
  std::string path_;
  const char* form_;
  std::vector<RationalRow> forces_;
};

constexpr const char* kMagnitudes = "an array of two numbers [normal, tangential]";
constexpr const char* kVectors = "an array of two numbers [fx, fy]";
constexpr const char* kVectorsInSpace =
    "an array of three numbers [fx, fy, fz], the grasp being in space";

/// Returns normal and tangential forces as vectors, in the plane.
std::vector<RationalRow> vectors_of(const std::vector<RationalRow>& magnitudes,
                                    const Grasp& grasp) {
  std::vector<RationalRow> forces;
  for (std::size_t i = 0; i < magnitudes.size(); ++i) {
    const Rational& normal = magnitudes[i][0];
    const Rational& tangential = magnitudes[i][1];
    if (normal.is_zero() && tangential.is_zero()) {
      forces.push_back({0, 0});
      continue;
    }
    const Vector2& n = grasp.contacts()[i].normal;
    const Rational length = length_of(n, i);
    const Vector2 force = force_vector(n, {normal / length, tangential / length});
    forces.push_back({force.x, force.y});
  }
  return forces;
}

std::vector<RationalRow> read_forces(const ForceList& magnitudes, const ForceList& vectors,
                                     bool are_vectors, const Question& question) {
  const GraspBox* box = question.box();
  const std::size_t contacts =
      box != nullptr ? box->contacts.size() : question.loaded().grasp.size();
  if (question.in_space()) {
    if (are_vectors) return vectors.checked(contacts, 3, kVectorsInSpace);
    fail_at(magnitudes.path(),
            "the grasp is in space, where friction has no single direction for a magnitude "
            "to be along",
            "give \"force_vectors\", [fx, fy, fz] in the object frame, in place of "
            "\"forces\"");
  }
  if (are_vectors) return vectors.checked(contacts, 2, kVectors);
  if (box != nullptr) {
    return vectors_of(magnitudes.checked(contacts, 2, kMagnitudes), loaded_of(*box).grasp);
  }
  const Grasp& grasp = question.loaded().grasp;
  return vectors_of(magnitudes.checked(grasp.size(), 2, kMagnitudes), grasp);
}

Claim read_claim(const JsonNode& node, const ForceList& magnitudes, const ForceList& vectors,
                 const Question& question) {
  expect_object(node, "claim", {"verdict", "twist", "forces", "force_vectors"});
  Claim claim;
  claim.stable =
      is_first(member(node, "claim", "verdict", R"(add "verdict": "stable" or "unstable")"),
               "claim.verdict", "stable", "unstable");
  if (const JsonNode* twist = node.find("twist")) {
    claim.twist = read_row(*twist, "claim.twist", question.in_space());
  }
  const JsonNode* forces = node.find("forces");
  const JsonNode* force_vectors = node.find("force_vectors");
  if (forces != nullptr && force_vectors != nullptr) {
    fail_at("claim", "found both \"forces\" and \"force_vectors\"", "give one of them");
  }
  const bool are_vectors = force_vectors != nullptr;
  if (const JsonNode* list = are_vectors ? force_vectors : forces) {
    expect(*list, Kind::kArray, (are_vectors ? vectors : magnitudes).path(),
           "one force for each contact, [[...], ...]");
    claim.forces = read_forces(magnitudes, vectors, are_vectors, question);
  }
  return claim;
}

}  // namespace

ClaimLine parse_claim_line(std::string_view line, const std::string& folder) {
  StreamedGrasp contacts;
  ForceList magnitudes("claim.forces", kMagnitudes);
  ForceList vectors("claim.force_vectors",
                    "an array of two numbers [fx, fy], in space of three [fx, fy, fz]");
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
  const QuestionOptions options = read_options(root, file.content.in_space());
  ClaimLine result{within("options", [&] { return as_one_body(ask(file, options)); }), {}};
  // Uncertain numbers, and in the plane preloaded contacts with normals of irrational length,
  // are an error of this line.
  within("grasp", [&] {
    require_one_body(result.question, "crosscheck");
    require_one_grasp(result.question);
  });
  result.claim = read_claim(
      member(root, "", "claim", R"(add "claim": {"verdict": "stable"} or "unstable")"),
      magnitudes, vectors, result.question);
  return result;
}

}  // namespace stickslip
