// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/certificate/certificate.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json_value.hpp"

namespace stickslip {
namespace {

/// Returns a NUMBER of FORMAT.md: a JSON integer if every JSON reader keeps it exact, else a
/// string.
std::string number(const Rational& value) {
  static const Integer kExactInDoubles = Integer(1) << 53;
  constexpr std::size_t kLongest = 65536;  // FORMAT.md, section 2
  const std::string text = to_string(value);
  if (text.size() > kLongest) {
    throw InputError("", "",
                     "the proof has a number of " + std::to_string(text.size()) +
                         " characters; certificates hold at most " + std::to_string(kLongest),
                     "shorter numbers in the grasp make it shorter");
  }
  if (denominator(value) == 1 && abs(numerator(value)) < kExactInDoubles) return text;
  return '"' + text + '"';
}

template <class Numbers>
std::string list(const Numbers& numbers) {
  std::string text;
  for (const auto& value : numbers) text += (text.empty() ? "" : ",") + number(Rational(value));
  return text;
}

std::string indexed(const char* kind, ContactId contact) {
  return std::string("[\"") + kind + "\"," + std::to_string(contact.index()) + "]";
}

/// Returns rows in brackets, in brackets.
template <class Matrix>
std::string rows(const Matrix& matrix) {
  std::string text = "[";
  for (const auto& row : matrix) text += (text.size() == 1 ? "[" : ",[") + list(row) + "]";
  return text + "]";
}

struct NodeText {
  bool margin;  ///< whether planes see the multiple as well

  std::string operator()(const SlipSplit& node) const { return indexed("slip", node.contact); }
  std::string operator()(const SeparationSplit& node) const {
    return indexed("separation", node.contact);
  }
  std::string operator()(const PlaneCut& node) const {
    const Row numbers(node.plane.begin(), node.plane.end() - (margin ? 0 : 1));
    return "[\"plane\"," + list(numbers) + "]";
  }
  std::string operator()(const TwistLeaf& node) const {
    return "[\"leaf\"," + list(node.twist) + "]";
  }
  std::string operator()(const MovingLeaf& node) const {
    std::string own;
    for (const auto& [contact, rate, slip] : node.own) {
      const std::string numbers = list(slip);
      own += (own.empty() ? "[" : ",[") + std::to_string(contact.index()) + "," +
             number(Rational(rate)) + "," + (slip.size() == 1 ? numbers : "[" + numbers + "]") +
             "]";
    }
    return "[\"moving\"," + list(node.twist) + "," + number(Rational(node.rate)) + ",[" + own +
           "]]";
  }
  std::string operator()(const TreeNode& node) const { return std::visit(*this, node); }
  std::string operator()(const LoadSplit& node) const {
    return "[\"plane\",0,0,0," + list(std::array{node.f[2], node.f[0], node.f[1]}) + "]";
  }
  std::string operator()(const HeldLeaf& node) const {
    return "[\"held\"," + std::to_string(node.piece) + "]";
  }
  std::string operator()(const PartSplit& node) const {
    return std::string("[\"part\",\"") + to_string(node.parameter) + "\"," +
           std::to_string(node.index) + "," + number(node.value) + "]";
  }
};

/// Returns `"uncertain": {...}` of the tolerances that were asked for.
std::string tolerances_text(const Tolerances& tolerances) {
  std::string text;
  for (const auto& [kind, tolerance] : given(tolerances)) {
    text += std::string(text.empty() ? "\"" : ", \"") + kind + "\": " +
            (tolerance.relative ? '"' + to_string(tolerance.spelled()) + "%\""
                                : number(tolerance.amount));
  }
  if (const auto& ball = tolerances.ball) {
    text += std::string(text.empty() ? "\"" : ", \"") +
            "wrench\": {\"ball\": " + number(ball->radius) +
            ", \"length\": " + number(ball->length) +
            (ball->about.empty() ? "" : ", \"about\": [" + list(ball->about) + "]") +
            (ball->body.empty() ? "" : ", \"body\": " + Json(ball->body).dump()) + "}";
  }
  return "\"uncertain\": {" + text + "}";
}

std::string wrench_text(const WrenchBox& wrench) {
  std::string text;
  for (const Interval& w : wrench) {
    text += text.empty() ? "" : ",";
    text += w.is_point() ? number(w.low) : "[" + number(w.low) + "," + number(w.high) + "]";
  }
  return text;
}

/// Returns all members up to the verdict, for contacts under this load. `member` follows the
/// law: a direction of the load, a plane of loads, an inertia.
std::string head(const Question& question, const std::string& wrench, const std::string& member,
                 const std::string& producer) {
  const GraspBox* box = question.box();
  const std::size_t contacts =
      box != nullptr ? box->elements() : question.loaded().grasp.size();
  std::string text =
      "{\"format\": \"stickslip-certificate/2\",\n \"producer\": " + Json(producer).dump() +
      ",\n \"question\": {\"contacts\": " + std::to_string(contacts) + ", \"wrench\": [" +
      wrench + "]";
  if (question.preload) text += ", \"preload\": " + number(*question.preload);
  text += ", \"normal_law\": \"" + std::string(to_string(question.law)) + "\"" + member;
  if (const auto& growth = question.preload_direction) {
    text += ", \"preload_direction\": " +
            (growth->scale ? "\"scale\"" : "[" + list(growth->preloads) + "]");
  }
  if (question.uncertain.any()) text += ", " + tolerances_text(question.uncertain);
  if (question.is_bounded()) {
    text += ", \"max_motion\": [" + list(question.box()->max_motion) + "]";
  }
  return text + "},\n ";
}

std::string head(const Question& question, const std::string& producer) {
  return head(question, wrench_text(question.wrench_as_asked.value_or(question.grasp.wrench())),
              question.direction ? ", \"direction\": [" + list(*question.direction) + "]" : "",
              producer);
}

std::string bits_text(unsigned bits) {
  return bits == kDefaultBits ? "" : "\"bits\": " + std::to_string(bits) + ",\n ";
}

const char kVerdict[] = "\"verdict\": ";

std::string shares_text(const ShortWitness& witness) {
  std::string text = "[";
  for (const auto& [contact, share] : witness.shares) {
    text += (text.size() == 1 ? "[" : ",[") + std::to_string(contact.index()) + "," +
            number(share) + "]";
  }
  return text + "]";
}

template <class Nodes>
void append_nodes(std::string& text, const Nodes& nodes, bool margin, std::string& separator) {
  for (const auto& node : nodes) {
    text += separator + std::visit(NodeText{margin}, node);
    separator = ",\n  ";
  }
}

template <class Nodes>
std::string nodes_text(const Nodes& nodes, bool margin) {
  std::string text = "[";
  std::string separator = "\n  ";
  append_nodes(text, nodes, margin, separator);
  return text + "]";
}

template <class Nodes>
std::string tree_text(const Nodes& nodes, bool margin = false) {
  return " \"tree\": " + nodes_text(nodes, margin);
}

std::string shape_text(const DegreeProof& proof, bool margin) {
  return std::string(proof.is_simplex ? "\"simplex\": " : "\"walls\": ") + rows(proof.walls) +
         ",\n \"direction\": " + rows(proof.direction) + ",\n" +
         tree_text(proof.trees, margin) + "}";
}

std::string degree_text(const DegreeProof& proof, bool margin = false) {
  std::string open;
  for (const ContactId id : proof.open) {
    open += (open.empty() ? "\"open\": [" : ",") + std::to_string(id.index());
  }
  if (!open.empty()) open += "],\n ";
  return "{\"twist\": [" + list(proof.twist) + "],\n " + open + shape_text(proof, margin);
}

std::string segment_text(const SegmentByDegree& proof, const std::optional<Rational>& high) {
  return "{\"to\": " + (high ? number(*high) : "null") + ", \"twists\": [[" +
         list(proof.twist) + "],[" + list(proof.end_twist) + "]],\n " + shape_text(proof, true);
}

/// Returns a share or F of FORMAT.md: in the plane a number.
std::string force_text(const RationalRow& force) {
  return force.size() == 1 ? number(force.front()) : "[" + list(force) + "]";
}

std::string witness_text(const ShareWitness& witness) {
  std::string text = "\"twist\": [" + list(witness.twist) + "],\n \"shares\": [";
  std::string separator;
  for (const auto& [contact, share] : witness.shares) {
    text += separator + "[" + std::to_string(contact.index()) + "," + force_text(share) + "]";
    separator = ",";
  }
  return text + "]";
}

using Friction = std::vector<std::pair<ContactId, RationalRow>>;

/// Returns the member `name`, a list of friction forces.
std::string friction_text(const char* name, const Friction& friction) {
  std::string text = std::string("\"") + name + "\": [";
  std::string separator;
  for (const auto& [contact, force] : friction) {
    text += separator + "[" + std::to_string(contact.index()) + "," + force_text(force) + "]";
    separator = ",";
  }
  return text + "]";
}

/// Returns the member `answers`.
std::string answers_text(const std::vector<RestProof::Answer>& answers) {
  std::string text = "\"answers\": [";
  std::string separator;
  for (const RestProof::Answer& answer : answers) {
    text += separator + "[" + std::to_string(answer.contact.index());
    std::string opening = ",[";
    for (const RationalRow& force : answer.forces) {
      text += opening + force_text(force);
      opening = ",";
    }
    text += "]]";
    separator = ",\n  ";
  }
  return text + "]";
}

std::string rest_text(const RestProof& proof) {
  return "{" + friction_text("rest", proof.friction) + ",\n " + answers_text(proof.answers) +
         ",\n \"reach\": [" + list(proof.reach) + "]}";
}

std::string sticking_text(const StickingProof& proof) {
  std::string presses;
  for (const StickingProof::Press& press : proof.presses) {
    presses += (presses.empty() ? "[" : ",\n  [") + std::to_string(press.contact.index()) +
               ",[" + list(press.forces) + "]]";
  }
  return "{\"sticking\": [" + list(proof.motion) + "],\n " +
         friction_text("friction", proof.friction) + ",\n \"presses\": [" + presses + "],\n " +
         answers_text(proof.answers) + ",\n \"reach\": [" + list(proof.reach) +
         "],\n \"energy\": " + number(proof.energy) + "}";
}

struct PartText {
  std::string operator()(const RestProof& proof) const { return rest_text(proof); }
  std::string operator()(const StickingProof& proof) const { return sticking_text(proof); }
  std::string operator()(const PartSplit& cut) const { return NodeText{false}(cut); }
  std::string operator()(const DegreeProof& proof) const { return degree_text(proof); }
};

template <class Parts>
std::string parts_text(const Parts& parts) {
  std::string text = " \"parts\": [";
  std::string separator = "\n  ";
  for (const auto& part : parts) {
    text += separator + std::visit(PartText{}, part);
    separator = ",\n  ";
  }
  return text + "]";
}

std::string point_text(const std::optional<Rational>& multiple, const ShortWitness& witness) {
  return "[" + (multiple ? number(*multiple) : "null") + ",[" +
         list(coordinates(witness.twist)) + "]," + shares_text(witness) + "]";
}

}  // namespace

namespace {

/// Writes the proof that a grasp is stable.
struct ProofText {
  const Question& question;

  std::string operator()(const Witness& witness) const {
    return " \"twist\": [" + list(coordinates(witness.twist)) +
           "],\n \"shares\": " + shares_text(in_short(question.loaded().grasp, witness));
  }
  std::string operator()(const ShareWitness& witness) const {
    return " " + witness_text(witness);
  }
  std::string operator()(const StabilityProof& proof) const {
    require(question.box() != nullptr, "one grasp in the plane is proved by degree as a box");
    return parts_text(proof);
  }
};

}  // namespace

std::string certificate_text(const Question& question, const Verdict& verdict,
                             const std::string& producer, unsigned bits) {
  require(is_stable(verdict).has_value(),
          "what is neither stable nor unstable has no certificate");
  require(!question.is_margin(), "a verdict is on one member of a family");
  const GraspBox* box = question.box();
  const bool has_roots = box != nullptr && (box->in_space() || needs_enclosure(*box));
  std::string text = head(question, producer) + (has_roots ? bits_text(bits) : "") + kVerdict +
                     "\"" + name_of(verdict) + "\",\n";
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    text += std::visit(ProofText{question}, stable->proof);
  } else {
    text += tree_text(std::get<Unstable>(verdict).tree);
  }
  return text + "}\n";
}

namespace {

std::string multiplier(const Rational& x) {
  return number(x);
}
/// Returns one number in the plane, three in space.
std::string multiplier(const RationalRow& x) {
  return x.size() == 1 ? number(x.front()) : "[" + list(x) + "]";
}

std::string forces_text(const RigidForces& forces) {
  std::string text = "[";
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto& [normal, friction] = forces[i];
    if (normal.is_zero()) continue;
    text += (text.size() == 1 ? "[" : ",[") + std::to_string(i) + "," + number(normal) + "," +
            multiplier(friction) + "]";
  }
  return text + "]";
}

/// Returns the motion of a load that must move.
const UnopposedMotion& motion_of(const LoadClass& found) {
  const auto* motion = std::get_if<UnopposedMotion>(&found);
  require(motion != nullptr, "an undecided question has no certificate");
  return *motion;
}

/// Writes the evidence of a class.
struct RigidText {
  std::string operator()(const UnopposedMotion& motion) const {
    return " \"twist\": [" + list(motion.twist) + "]";
  }
  std::string operator()(const StronglyStable& stable) const {
    std::string text = rest(stable.rest) + " \"tree\": [";
    std::string separator = "\n  ";
    for (const RigidNode& node : stable.tree) {
      text += separator + std::visit(*this, node);
      separator = ",\n  ";
    }
    return text + "]";
  }
  std::string operator()(const OpenLoad& open) const {
    return rest(open.rest) + " \"acceleration\": [" + list(open.motion.acceleration) +
           "],\n \"forces\": " + forces_text(open.motion.forces);
  }
  std::string operator()(const Undecided&) const {
    throw ContractError("an undecided question has no certificate");
  }

  std::string operator()(const RigidSplit& node) const {
    if (node.direction.empty()) return indexed(node.slip ? "slip" : "touch", node.contact);
    return "[\"slip\"," + std::to_string(node.contact.index()) + "," +
           multiplier(node.direction) + "]";
  }
  std::string operator()(const RigidLeaf& leaf) const {
    return "[\"leaf\"," + number(leaf.weight) + ",[" + list(leaf.twist) + "]," +
           multipliers(leaf.normal) + "," + multipliers(leaf.tangent) + "]";
  }

 private:
  static std::string rest(const RigidForces& forces) {
    return " \"rest\": " + forces_text(forces) + ",\n";
  }
  template <class Pairs>
  static std::string multipliers(const Pairs& pairs) {
    std::string text = "[";
    for (const auto& [contact, x] : pairs) {
      text += (text.size() == 1 ? "[" : ",[") + std::to_string(contact.index()) + "," +
              multiplier(x) + "]";
    }
    return text + "]";
  }
};

}  // namespace

std::string class_certificate_text(const Question& question, const Inertia& inertia,
                                   const RigidVerdict& verdict, const std::string& producer) {
  require(question.box() == nullptr || (question.in_space() && question.box()->is_point()),
          "a class is of one grasp");
  require(!question.is_margin(), "a class is of one load");
  return head(question, wrench_text(question.grasp.wrench()),
              ", \"inertia\": [" + list(numbers_of(inertia)) + "]", producer) +
         kVerdict + "\"" + name_of(verdict) + "\",\n" + std::visit(RigidText{}, verdict) +
         "}\n";
}

namespace {

std::string statics_head(const Question& question, const StaticsAsked& asked,
                         const std::string& producer) {
  const GraspBox box = question.grasp.as_box();
  require(box.is_point() && !question.is_margin(), "statics is of one grasp");
  std::string members;
  if (asked.directions.size() == 1) {
    members = ", \"direction\": [" + list(asked.directions[0]) + "]";
  } else if (asked.directions.size() == 2) {
    members = ", \"plane\": [[" + list(asked.directions[0]) + "], [" +
              list(asked.directions[1]) + "]]";
  }
  members += ", \"statics\": " + number(asked.friction_factor);
  return head(without_bound(question), wrench_text(box.wrench), members, producer);
}

}  // namespace

std::string statics_certificate_text(const Question& question, const StaticsAsked& asked,
                                     const LoadClass& found, const std::string& producer) {
  require(asked.directions.empty(), "one load has no directions");
  const std::string text = statics_head(question, asked, producer) + kVerdict;
  if (const auto* forces = std::get_if<RigidForces>(&found)) {
    return text + "\"may stand\",\n \"forces\": " + forces_text(*forces) + "}\n";
  }
  return text + "\"must move\",\n" + RigidText{}(motion_of(found)) + "}\n";
}

std::string statics_certificate_text(const Question& question, const StaticsAsked& asked,
                                     const StandingLoads& found, const std::string& producer) {
  require(!asked.directions.empty(), "many loads have directions");
  std::string text = statics_head(question, asked, producer) + kVerdict +
                     (asked.directions.size() == 1 ? "\"margin\"" : "\"region\"") +
                     ",\n \"stand\": [";
  std::string separator = "\n  ";
  for (const StandPoint& stand : found.stand) {
    text += separator + "[[" + list(stand.point) + "]," + forces_text(stand.forces) + "]";
    separator = ",\n  ";
  }
  text += "],\n \"move\": [";
  separator = "\n  ";
  for (const RationalRow& y : found.move) {
    text += separator + "[" + list(y) + "]";
    separator = ",\n  ";
  }
  return text + "]}\n";
}

namespace {

/// Writes a node of a tree of FORMAT.md, section 18.
struct RobustnessNodeText {
  std::string operator()(const StateSplit& node) const {
    return "[\"state\"," + std::to_string(node.contact) + "]";
  }
  std::string operator()(const DistanceSplit& node) const {
    return "[\"distance\"," + number(node.distance) + "]";
  }
  std::string operator()(const MixtureLeaf& node) const {
    // Twist and matrix may have a common factor.
    RationalRow all = node.twist;
    for (std::size_t j = 0; j < node.matrix.size(); ++j) {
      const RationalRow& row = node.matrix[j];
      all.insert(all.end(), row.begin() + static_cast<std::ptrdiff_t>(j), row.end());
    }
    return "[\"leaf\"," + list(primitive_multiple(all)) + "]";
  }
  std::string operator()(const CombinationLeaf& node) const {
    return "[\"combination\"," + list(primitive_multiple(node.twist)) + "," +
           list(primitive_multiple(node.direction)) + "]";
  }
  std::string operator()(const NoDistanceLeaf& node) const {
    return "[\"none\"," + list(primitive_multiple(node.twist)) + "]";
  }
};

}  // namespace

std::string robustness_certificate_text(const Question& question, RobustnessKind kind,
                                        const RobustnessOptions& options,
                                        const Robustness& found, const std::string& producer) {
  require(!question.is_margin(), "a robustness is about one load");
  const GraspBox& grasp = question.grasp.as_box();
  std::vector<Rational> forces = options.most_forces;
  if (forces.size() == 1) forces.assign(grasp.contacts.size(), forces[0]);
  std::string text =
      "{\"format\": \"stickslip-certificate/2\",\n \"producer\": " + Json(producer).dump() +
      ",\n \"question\": {\"contacts\": " + std::to_string(grasp.contacts.size()) +
      ", \"wrench\": [" + wrench_text(question.grasp.wrench()) + "], \"robustness\": \"" +
      (kind == RobustnessKind::kContact ? "contact" : "grasp") +
      "\", \"length\": " + number(options.length) + ", \"max_force\": [" + list(forces) +
      "]},\n " + kVerdict + "\"bounds\", \"lower\": " + number(found.lower) +
      ", \"upper\": " + number(found.upper) + ",\n \"combination\": ";
  if (found.best) {
    text += "{\"distance\": " + number(found.best->distance) +
            ", \"inverse_square\": " + number(found.best->inverse_square) + ", \"forces\": [";
    std::string separator = "\n  ";
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const SpringState state = found.best->states[i];
      if (state == SpringState::kDetached) continue;
      text += separator + "[" + std::to_string(i) + ",\"" +
              (state == SpringState::kStick ? "stick" : "slip") + "\",[" +
              list(found.best->forces[i]) + "]]";
      separator = ",\n  ";
    }
    text += "]}";
  } else {
    text += "null";
  }
  text += ",\n \"tree\": [";
  std::string separator = "\n  ";
  for (const RobustnessNode& node : found.proof) {
    text += separator + std::visit(RobustnessNodeText{}, node);
    separator = ",\n  ";
  }
  return text + "]}\n";
}

namespace {

struct ClaimText {
  std::string operator()(const ResistedMultiples& claim) const {
    return ends("stable", claim) + std::visit(*this, claim.proof) + "]";
  }
  std::string operator()(const RefutedMultiples& claim) const {
    return ends("unstable", claim) + nodes_text(claim.tree, true) + "]";
  }
  std::string operator()(const DegreeProof& proof) const { return degree_text(proof, true); }
  std::string operator()(const RestProof& proof) const { return rest_text(proof); }
  std::string operator()(const StickingProof& proof) const { return sticking_text(proof); }
  std::string operator()(const SpatialSegment& segment) const {
    return "{" + witness_text(segment.start) + "}" +
           (segment.end ? ",\n   {" + witness_text(*segment.end) + "}" : "");
  }

 private:
  template <class Claim>
  static std::string ends(const std::string& verdict, const Claim& claim) {
    return "[\"" + verdict + "\"," + number(claim.low) + "," +
           (claim.high ? number(*claim.high) : "null") + ",";
  }
};

}  // namespace

std::string margin_certificate_text(const Question& question, const SpatialMargin& margin,
                                    const std::string& producer) {
  require(question.is_margin(), "the certificate of a margin states its direction");
  std::string text = head(question, producer) + bits_text(margin.bits) + kVerdict +
                     "\"margin\",\n \"intervals\": [";
  std::string separator = "\n  ";
  for (const auto& claim : margin.claims) {
    text += separator + std::visit(ClaimText{}, claim);
    separator = ",\n  ";
  }
  return text + "]}\n";
}

std::string margin_certificate_text(const Question& question, const Margin& margin,
                                    const std::string& producer) {
  require(question.is_margin(), "the certificate of a margin states its direction");
  std::string text = head(question, producer) + kVerdict + "\"margin\",\n \"resisted\": [";
  std::string separator;
  for (const MarginInterval& interval : margin.resisted) {
    text += separator + "[" + number(interval.low) + "," +
            (interval.high ? number(*interval.high) : "null") + "]";
    separator = ",";
  }
  text += "],\n \"segments\": [";
  separator = "\n  ";
  std::string end;
  for (const MarginSegment& segment : margin.segments) {
    if (segment.proof) {
      text += separator + segment_text(*segment.proof, segment.high);
      separator = ",\n  ";
      end.clear();
      continue;
    }
    const std::string begin = point_text(segment.low, segment.start);
    text += separator + "[" + (begin == end ? "" : begin + ",\n   ");
    end = point_text(segment.high, segment.end);
    text += end + "]";
    separator = ",\n  ";
  }
  text += "],\n \"tree\": [";
  separator = "\n  ";
  for (const Trees& gap : margin.gaps) append_nodes(text, gap, true, separator);
  return text + "]}\n";
}

std::string region_certificate_text(const Question& question, const WrenchPlane& plane,
                                    const RegionProof& proof, const std::string& producer) {
  require(!question.is_margin() && question.box() == nullptr,
          "a region is one grasp's, in one plane");
  std::string text = head(question, list(coordinates(plane.origin())),
                          ", \"plane\": [[" + list(coordinates(plane.u())) + "],[" +
                              list(coordinates(plane.v())) + "]]",
                          producer) +
                     kVerdict + "\"region\",\n \"pieces\": [";
  std::string separator = "\n  ";
  for (const ProvedPiece& piece : proof.pieces) {
    text += separator + "[";
    std::string between;
    for (const LoadPoint& point : piece) {
      const bool at_infinity = is_at_infinity(point.load);
      text += between + (at_infinity ? "[\"towards\"," : "[\"at\",") +
              (at_infinity ? list(direction_of(point.load)) : list(point_of(point.load))) +
              ",[" + list(coordinates(point.witness.twist)) + "]," +
              shares_text(point.witness) + "]";
      between = ",\n   ";
    }
    text += "]";
    separator = ",\n  ";
  }
  return text + "],\n" + tree_text(proof.tree) + "}\n";
}

std::optional<std::string> certificate_of(const Answer& answer) {
  if (!is_stable(answer.verdict)) return std::nullopt;
  return certificate_text(answer.question, answer.verdict, producer_of(answer.engine()),
                          answer.bits);
}

std::string producer_of(const std::string& engine) {
  return "stickslip " STICKSLIP_VERSION ", engine " + engine;
}

}  // namespace stickslip
