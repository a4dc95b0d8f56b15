// SPDX-License-Identifier: MIT
#include "certificate.hpp"

#include <algorithm>

namespace stickslip_check {
namespace {

constexpr JsonLimits kCertificateLimits{std::uint64_t{1} << 30U, 8, 65536,
                                        std::uint64_t{1} << 22U, false};
constexpr std::size_t kMaxJsonInteger = 4000;
constexpr const char* kFormat = "stickslip-certificate/2";

}  // namespace

CertificateReader::CertificateReader(std::istream& in, const std::string& file,
                                     const Question& question)
    : json_(in, file, kCertificateLimits),
      dimension_(question.dimension()),
      limits_(question.limits),
      in_space_(question.in_space),
      claims_(question.claims()),
      several_(question.several),
      contacts_(question.contacts) {}

Claim CertificateReader::claim() {
  const Value format = take("format");
  json_.expect(format.is_text(kFormat), format, "format",
               std::string("\"") + kFormat + "\", the only one that this program knows");
  std::optional<std::string> name = json_.next_member();
  if (name == "producer") {
    const Value producer = json_.value();
    json_.expect(producer.kind == Value::Kind::kString, producer, *name, "a string");
    name = json_.next_member();
  }
  if (name != "question") {
    json_.fail(json_.line(), "top level", "expected the member \"question\"");
  }
  const Value question = json_.value();
  json_.expect(question.kind == Value::Kind::kObject, question, *name, "an object {...}");
  Claim claim = claim_of(question);
  margin_ = claim.asked.margin();
  plane_ = claim.asked.plane.has_value();
  rigid_ = claim.asked.rigid();
  statics_ = claim.asked.statics.has_value();
  states_ = claim.asked.states;
  robust_ = claim.asked.robustness.has_value();
  return claim;
}

std::string CertificateReader::verdict() {
  constexpr unsigned kLeastBits = 64;
  constexpr unsigned kMostBits = 4096;
  std::optional<std::string> name = json_.next_member();
  if (name == "bits" && !states_ && !robust_ && !plane_ && !rigid_ && !statics_ &&
      (!margin_ || claims_)) {
    const Value value = json_.value();
    const Rational bits = value.kind == Value::Kind::kNumber ? number(value, "bits") : 0;
    json_.expect(
        bits >= kLeastBits && bits <= kMostBits, value, "bits",
        "an integer from " + std::to_string(kLeastBits) + " to " + std::to_string(kMostBits));
    bits_ = static_cast<unsigned>(bits.get_num().get_ui());
    name = json_.next_member();
  }
  expect_name(name, "verdict");
  const Value verdict = json_.value();
  if (states_) {
    json_.expect(verdict.is_text("complete"), verdict, "verdict",
                 "\"complete\", as the question has states");
  } else if (robust_) {
    json_.expect(verdict.is_text("bounds"), verdict, "verdict",
                 "\"bounds\", as the question has a robustness");
  } else if (plane_) {
    json_.expect(verdict.is_text("region"), verdict, "verdict",
                 "\"region\", as the question has a plane");
  } else if (rigid_) {
    json_.expect(
        verdict.is_text("must move") || verdict.is_text("must hold") || verdict.is_text("open"),
        verdict, "verdict",
        "\"must move\", \"must hold\" or \"open\", as the question has an inertia");
  } else if (statics_ && !margin_) {
    json_.expect(verdict.is_text("may stand") || verdict.is_text("must move"), verdict,
                 "verdict", R"("may stand" or "must move", as the question is of statics)");
  } else if (margin_) {
    json_.expect(verdict.is_text("margin"), verdict, "verdict",
                 "\"margin\", as the question has a direction");
  } else {
    json_.expect(verdict.is_text("stable") || verdict.is_text("unstable"), verdict, "verdict",
                 "\"stable\" or \"unstable\", as the question has no direction");
  }
  return verdict.text;
}

Vector CertificateReader::twist() {
  return numbers(take("twist"), "twist", 0, dimension_ + limits_);
}

Vector CertificateReader::acceleration() {
  return numbers(take("acceleration"), "acceleration", 0, dimension_);
}

std::vector<RigidForce> CertificateReader::forces(const char* name) {
  return forces_of(take(name), name);
}

std::vector<RigidForce> CertificateReader::forces_of(const Value& value,
                                                     const std::string& place) const {
  std::vector<RigidForce> result;
  for (const Value& entry : list(value, place, "an array of forces")) {
    json_.expect(entry.is_array(3), entry, place, "a contact, a normal force and friction");
    const Integer contact = index(entry.items[0], place);
    result.push_back({contact, number(entry.items[1], place),
                      friction(entry.items[2], place, friction_numbers(contact))});
  }
  return result;
}

std::optional<StandPoint> CertificateReader::next_stand() {
  if (!next_element("stand")) return std::nullopt;
  const std::string place = "stand[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  json_.expect(value.is_array(2), value, place, "a load point and forces");
  return StandPoint{numbers(value.items[0], place, 0, plane_ ? 3 : 2),
                    forces_of(value.items[1], place)};
}

std::optional<Vector> CertificateReader::next_move() {
  if (!next_element("move")) return std::nullopt;
  return numbers(json_.value(), "move[" + std::to_string(elements_ - 1) + "]", 0,
                 dimension_ + limits_);
}

std::vector<std::vector<Vector>> CertificateReader::lines() {
  std::vector<std::vector<Vector>> result;
  const Value value = take("lines");
  const std::string what = "an array of lines, one or more, for each contact";
  for (const Value& entry : list(value, "lines", what)) {
    const std::string place = "lines[" + std::to_string(result.size()) + "]";
    json_.expect(entry.kind == Value::Kind::kArray && !entry.items.empty(), entry, place, what);
    std::vector<Vector>& lines = result.emplace_back();
    for (const Value& line : entry.items) {
      lines.push_back(numbers(line, place, 0, in_space_ ? 3 : 2));
    }
    signs_.push_back(lines.size());
  }
  return result;
}

/// STATE.
std::optional<State> CertificateReader::next_state() {
  if (!next_element("states")) return std::nullopt;
  const std::string place = "states[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  const auto expect = [&](bool good) {
    if (good) return;
    json_.expect(false, value, place,
                 "a string: signs of each contact, a colon, and " + std::to_string(dimension_) +
                     " integers");
  };
  expect(value.kind == Value::Kind::kString);
  const std::string& text = value.text;
  std::size_t at = 0;
  State state;
  const auto take = [&](char wanted) {
    expect(at < text.size() && text[at] == wanted);
    ++at;
  };
  const auto take_sign = [&] {
    expect(at < text.size() && (text[at] == '+' || text[at] == '-' || text[at] == '0'));
    state.signs += text[at++];
  };
  for (const std::size_t count : signs_) {
    if (has_normal_signs(*states_)) {
      take_sign();
      take('|');
    }
    for (std::size_t j = 0; j < count; ++j) take_sign();
    take(' ');
  }
  take(':');
  for (std::size_t j = 0; j < dimension_; ++j) {
    take(' ');
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t digits = at + (text[at] == '-' ? 1 : 0);
    expect(digits < end && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(digits),
                                       text.begin() + static_cast<std::ptrdiff_t>(end),
                                       [](char c) { return c >= '0' && c <= '9'; }));
    state.motion.emplace_back(text.substr(at, end - at), 10);
    at = end;
  }
  expect(at == text.size());
  return state;
}

std::vector<Integer> CertificateReader::by_dimension() {
  const Value value = take("by_dimension");
  json_.expect(value.is_array(dimension_ + 1), value, "by_dimension",
               "an array of " + std::to_string(dimension_ + 1));
  std::vector<Integer> result;
  for (const Value& entry : value.items) result.push_back(index(entry, "by_dimension"));
  return result;
}

Rational CertificateReader::bound(const char* name) {
  return number(take(name), name);
}

std::optional<RobustCombination> CertificateReader::combination() {
  const std::string place = "combination";
  const Value value = take(place);
  if (value.kind == Value::Kind::kNull) return std::nullopt;
  json_.expect(value.kind == Value::Kind::kObject, value, place, "null or an object {...}");
  expect_order(value, place, {"distance", "inverse_square", "forces"});
  RobustCombination result{number(member(value, place, "distance"), place),
                           number(member(value, place, "inverse_square"), place),
                           {}};
  for (const Value& entry : list(member(value, place, "forces"), place, "an array of forces")) {
    json_.expect(entry.is_array(3) &&
                     (entry.items[1].is_text("stick") || entry.items[1].is_text("slip")),
                 entry, place, "a contact, \"stick\" or \"slip\", and a force");
    result.forces.push_back({index(entry.items[0], place), entry.items[1].is_text("stick"),
                             numbers(entry.items[2], place, 0, in_space_ ? 3 : 2)});
  }
  return result;
}

std::optional<RobustNode> CertificateReader::next_robust_node() {
  if (!next_element("tree")) return std::nullopt;
  const Value value = json_.value();
  const std::string place = "tree[" + std::to_string(elements_ - 1) + "]";
  const auto is = [&](const char* kind, std::size_t size) {
    return value.is_array(1 + size) && value.items[0].is_text(kind);
  };
  const std::size_t n = dimension_;
  if (is("state", 1)) return RobustNode{RobustNodeKind::kState, index(value.items[1], place)};
  if (is("distance", 1)) {
    return RobustNode{RobustNodeKind::kDistance, 0, number(value.items[1], place)};
  }
  const std::size_t triangle = n * (n + 1) / 2;
  const bool leaf = is("leaf", n + triangle);
  const bool combination = is("combination", 2 * n);
  json_.expect(leaf || combination || is("none", n), value, place,
               R"(["state", i], ["distance", a], ["leaf", y, Z], ["combination", y, z] or )"
               R"(["none", y])");
  RobustNode node{leaf          ? RobustNodeKind::kLeaf
                  : combination ? RobustNodeKind::kCombination
                                : RobustNodeKind::kNone};
  const Vector all = numbers(value, place, 1, value.items.size() - 1);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n);
  node.y.assign(all.begin(), middle);
  node.z.assign(middle, all.end());
  return node;
}

std::optional<RigidNode> CertificateReader::next_rigid_node() {
  if (!next_element("tree")) return std::nullopt;
  const Value value = json_.value();
  const std::string place = "tree[" + std::to_string(elements_ - 1) + "]";
  RigidNode node;
  if (value.is_array(5) && value.items[0].is_text("leaf")) {
    const auto pairs = [&](const Value& entries, const auto& add) {
      for (const Value& entry : list(entries, place, "an array of multipliers")) {
        json_.expect(entry.is_array(2), entry, place, "a contact and its multiplier");
        add(index(entry.items[0], place), entry.items[1]);
      }
    };
    node.weight = number(value.items[1], place);
    node.twist = numbers(value.items[2], place, 0, dimension_);
    pairs(value.items[3], [&](const Integer& i, const Value& g) {
      node.normal.emplace_back(i, number(g, place));
    });
    pairs(value.items[4], [&](const Integer& i, const Value& h) {
      node.tangent.emplace_back(i, friction(h, place, in_space_ ? 3 : 1));
    });
    return node;
  }
  const bool touch = value.is_array(2) && value.items[0].is_text("touch");
  const std::size_t size = in_space_ ? 3 : 2;
  json_.expect(touch || (value.is_array(size) && value.items[0].is_text("slip")), value, place,
               in_space_ ? R"(["touch", i], ["slip", i, d] or ["leaf", t, y, g, h])"
                         : R"(["touch", i], ["slip", i] or ["leaf", t, y, g, h])");
  node.kind = touch ? RigidNode::Kind::kTouch : RigidNode::Kind::kSlip;
  node.contact = index(value.items[1], place);
  if (!touch && size == 3) node.direction = numbers(value.items[2], place, 0, 3);
  return node;
}

bool CertificateReader::has_parts() {
  const std::optional<std::string> name = json_.next_member();
  if (name != "parts") expect_name(name, "twist");
  if (name == "parts") open_list_ = "parts";
  return name == "parts";
}

std::optional<Part> CertificateReader::next_part() {
  if (!next_element("parts")) return std::nullopt;
  return part(json_.value(), "parts[" + std::to_string(elements_ - 1) + "]");
}

Witness CertificateReader::witness() {
  Witness witness;
  witness.x = numbers(json_.value(), "twist", 0, dimension_);
  witness.x.insert(witness.x.end(), {1, 0});
  witness.shares = shares(take("shares"), "shares");
  return witness;
}

std::vector<Interval> CertificateReader::resisted() {
  std::vector<Interval> result;
  const Value value = take("resisted");
  for (const Value& entry : list(value, "resisted", "an array of intervals")) {
    const std::string place = "resisted[" + std::to_string(result.size()) + "]";
    json_.expect(entry.is_array(2), entry, place, "[low, high] or [low, null]");
    result.push_back({number(entry.items[0], place), number_or_null(entry.items[1], place)});
  }
  return result;
}

std::optional<Segment> CertificateReader::next_segment() {
  if (!next_element("segments")) return std::nullopt;
  const std::string place = "segments[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  if (value.kind == Value::Kind::kObject) {
    end_.reset();
    return segment_by_degree(value, place);
  }
  const bool goes_on = value.is_array(1) && end_ && end_->x[dimension_] != 0;
  json_.expect(goes_on || value.is_array(2), value, place,
               "two points, or one where the segment before ended with a number, or an object");
  Segment segment;
  segment.points.push_back(goes_on ? std::move(*end_) : point(value.items[0], false, place));
  end_ = point(value.items.back(), true, place);
  segment.points.push_back(*end_);
  return segment;
}

Segment CertificateReader::segment_by_degree(const Value& value,
                                             const std::string& place) const {
  expect_order(value, place, {"to", "twists", "walls", "direction", "tree"});
  Segment segment;
  segment.to = number_or_null(member(value, place, "to"), place + ".to");
  const std::string at_twists = place + ".twists";
  const Value& twists = member(value, place, "twists");
  json_.expect(twists.is_array(2), twists, at_twists, "two twists");
  Vector begin = numbers(twists.items[0], at_twists, 0, dimension_);
  Vector end = numbers(twists.items[1], at_twists, 0, dimension_);
  segment.part = shape(value, place, dimension_);
  segment.part.twist = std::move(begin);
  segment.part.end_twist = std::move(end);
  return segment;
}

std::optional<std::vector<Witness>> CertificateReader::next_piece() {
  if (!next_element("pieces")) return std::nullopt;
  const std::string place = "pieces[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  std::vector<Witness> points;
  for (const Value& entry : list(value, place, "an array of points")) {
    points.push_back(load_point(entry, place));
  }
  return points;
}

std::optional<Node> CertificateReader::next_node() {
  if (!next_element("tree")) return std::nullopt;
  return node(json_.value(), "tree[" + std::to_string(elements_ - 1) + "]");
}

/// CLAIM.
std::optional<RangeProof> CertificateReader::next_range() {
  if (!next_element("intervals")) return std::nullopt;
  const std::string place = "intervals[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  RangeProof claim;
  const bool by_points = value.is_array(5);
  claim.stable = (by_points || value.is_array(4)) && value.items[0].is_text("stable");
  json_.expect(claim.stable || (value.is_array(4) && value.items[0].is_text("unstable")), value,
               place,
               R"(["stable", low, high, part], ["stable", low, high, point, point] )"
               R"(or ["unstable", low, high, tree])");
  claim.range = {number(value.items[1], place), number_or_null(value.items[2], place)};
  if (!claim.stable) {
    claim.tree = nodes(value.items[3], place);
  } else if (by_points || value.items[3].find("shares") != nullptr) {
    const auto& [low, high] = claim.range;
    json_.expect(by_points == (high && *high != low), value, place,
                 "one point where low = high or high is null, else two");
    // Without an end 1 stands for all.
    claim.points = {point_at(high ? low : Rational(1), value.items[3], place)};
    if (by_points) claim.points.push_back(point_at(*high, value.items[4], place));
  } else {
    claim.part = part(value.items[3], place);
  }
  return claim;
}

void CertificateReader::finish() {
  if (json_.next_member()) json_.fail(json_.line(), "top level", "a member too many");
}

void CertificateReader::expect_member(const std::string& name) {
  expect_name(json_.next_member(), name);
}

void CertificateReader::expect_name(const std::optional<std::string>& found,
                                    const std::string& name) const {
  if (found != name) {
    json_.fail(json_.line(), "top level",
               (found ? "found the member " + quote(*found) : std::string("the object ends")) +
                   ", expected \"" + name + "\"");
  }
}

bool CertificateReader::next_element(const char* list) {
  if (open_list_ != list) {
    expect_member(list);
    open_list_ = list;
    elements_ = 0;
  }
  ++elements_;
  return json_.next_element();
}

Value CertificateReader::take(const std::string& name) {
  expect_member(name);
  return json_.value();
}

/// NUMBER.
Rational CertificateReader::number(const Value& value, const std::string& place) const {
  std::optional<Rational> read;
  const bool json_integer =
      value.kind == Value::Kind::kNumber && value.text.size() <= kMaxJsonInteger;
  if (json_integer || value.kind == Value::Kind::kString) read = parse_fraction(value.text);
  json_.expect(read.has_value(), value, place, "an integer, or a string such as \"-3/5\"");
  return *read;
}

std::optional<Rational> CertificateReader::number_or_null(const Value& value,
                                                          const std::string& place) const {
  if (value.kind == Value::Kind::kNull) return std::nullopt;
  return number(value, place);
}

/// CONTACT, and m.
Integer CertificateReader::index(const Value& value, const std::string& place) const {
  json_.expect(value.kind == Value::Kind::kNumber, value, place, "a contact, counted from 0");
  const Rational read = number(value, place);
  json_.expect(read >= 0, value, place, "a contact, counted from 0");
  return read.get_num();
}

/// The `size` numbers of an array behind the first `skipped` values.
Vector CertificateReader::numbers(const Value& value, const std::string& place,
                                  std::size_t skipped, std::size_t size) const {
  json_.expect(value.is_array(skipped + size), value, place,
               "an array of " + std::to_string(skipped + size));
  Vector result;
  for (std::size_t j = skipped; j < skipped + size; ++j) {
    result.push_back(number(value.items[j], place));
  }
  return result;
}

const std::vector<Value>& CertificateReader::list(const Value& value, const std::string& place,
                                                  const std::string& what) const {
  json_.expect(value.kind == Value::Kind::kArray, value, place, what);
  return value.items;
}

/// Members that are there must be among `names`, in their order.
void CertificateReader::expect_order(const Value& value, const std::string& place,
                                     const std::vector<const char*>& names) const {
  auto next = names.begin();
  for (const std::string& key : value.keys) {
    next = std::find(next, names.end(), key);
    if (next == names.end()) {
      json_.fail(value.line, place, "the member " + quote(key) + " is unknown or out of order");
    }
    ++next;
  }
}

const Value& CertificateReader::member(const Value& value, const std::string& place,
                                       const std::string& name) const {
  const Value* found = value.find(name);
  if (found == nullptr) {
    json_.fail(value.line, place, "the member \"" + name + "\" is missing");
  }
  return *found;
}

Claim CertificateReader::claim_of(const Value& value) const {
  if (const Value* states = value.find("states")) {
    expect_order(value, "question", {"contacts", "states"});
    Claim claim;
    claim.contacts = index(member(value, "question", "contacts"), "question.contacts");
    json_.expect(std::any_of(kStateSets.begin(), kStateSets.end(),
                             [&](const char* set) { return states->is_text(set); }),
                 *states, "question.states", "\"slip\", \"full\" or \"closed\"");
    claim.asked.states = states->text;
    claim.wrench = Wrench(dimension_);  // as of every question about states
    return claim;
  }
  if (const Value* robustness = value.find("robustness")) {
    expect_order(value, "question",
                 {"contacts", "wrench", "robustness", "length", "max_force"});
    Claim claim;
    claim.contacts = index(member(value, "question", "contacts"), "question.contacts");
    for (const Rational& w :
         numbers(member(value, "question", "wrench"), "question.wrench", 0, dimension_)) {
      claim.wrench.emplace_back(w);
    }
    json_.expect(std::any_of(kRobustnesses.begin(), kRobustnesses.end(),
                             [&](const char* kind) { return robustness->is_text(kind); }),
                 *robustness, "question.robustness", R"("contact" or "grasp")");
    claim.asked.robustness = robustness->text;
    claim.asked.length = number(member(value, "question", "length"), "question.length");
    const Value& most = member(value, "question", "max_force");
    claim.asked.max_force.emplace();
    for (const Value& f : list(most, "question.max_force", "an array of numbers")) {
      claim.asked.max_force->push_back(number(f, "question.max_force"));
    }
    return claim;
  }
  expect_order(value, "question",
               {"contacts", "wrench", "preload", "normal_law", "direction", "preload_direction",
                "plane", "inertia", "statics", "uncertain", "max_motion"});
  Claim claim;
  claim.contacts = index(member(value, "question", "contacts"), "question.contacts");
  const std::string at_wrench = "question.wrench";
  const Value& wrench = member(value, "question", "wrench");
  json_.expect(wrench.is_array(dimension_), wrench, at_wrench,
               "an array of " + std::to_string(dimension_));
  for (const Value& entry : wrench.items) {
    claim.wrench.push_back(wrench_component(entry, at_wrench));
  }
  Options& asked = claim.asked;
  if (const Value* preload = value.find("preload")) {
    asked.preload = number(*preload, "question.preload");
  }
  const Value& law = member(value, "question", "normal_law");
  asked.bilateral = law.is_text("bilateral");
  json_.expect(asked.bilateral || law.is_text("unilateral"), law, "question.normal_law",
               R"("unilateral" or "bilateral")");
  if (const Value* direction = value.find("direction")) {
    asked.direction = numbers(*direction, "question.direction", 0, dimension_);
  }
  if (const Value* growth = value.find("preload_direction")) {
    asked.preload_direction.emplace();
    asked.preload_direction->scale = growth->is_text("scale");
    if (!growth->is_text("scale")) {
      const std::string place = "question.preload_direction";
      for (const Value& entry : list(*growth, place, "\"scale\" or an array of numbers")) {
        asked.preload_direction->values.push_back(number(entry, place));
      }
    }
  }
  const Value* statics = value.find("statics");
  if (statics != nullptr) asked.statics = number(*statics, "question.statics");
  if (const Value* plane = value.find("plane")) {
    const std::string place = "question.plane";
    json_.expect(((!in_space_ && !several_) || statics != nullptr) && plane->is_array(2),
                 *plane, place,
                 "two directions, of a question about a planar grasp or statics");
    asked.plane.emplace();
    for (const Value& entry : plane->items) {
      asked.plane->push_back(numbers(entry, place, 0, dimension_));
    }
  }
  if (const Value* inertia = value.find("inertia")) {
    const std::string place = "question.inertia";
    json_.expect(!several_, *inertia, place, "none, of a question about several bodies");
    const bool is_short = in_space_ && inertia->is_array(6);
    asked.inertia = numbers(*inertia, place, 0, !in_space_ ? 3 : is_short ? 6 : 9);
    if (is_short) asked.inertia->resize(9);
  }
  if (const Value* uncertain = value.find("uncertain")) {
    asked.uncertain = tolerances(*uncertain);
  }
  if (const Value* bound = value.find("max_motion")) {
    asked.max_motion = numbers(*bound, "question.max_motion", 0, dimension_);
  }
  return claim;
}

/// A NUMBER, or an interval of the grasp file.
Bounds CertificateReader::wrench_component(const Value& value, const std::string& place) const {
  if (value.kind != Value::Kind::kArray) return number(value, place);
  const Vector ends = numbers(value, place, 0, 2);
  return {ends[0], ends[1]};
}

/// TOLERANCE.
std::map<std::string, Tolerance> CertificateReader::tolerances(const Value& value) const {
  const std::string place = "question.uncertain";
  json_.expect(value.kind == Value::Kind::kObject && !value.items.empty(), value, place,
               "an object of one tolerance or more");
  expect_order(value, place, {kUncertainKinds.begin(), kUncertainKinds.end()});
  std::map<std::string, Tolerance> result;
  for (std::size_t k = 0; k < value.items.size(); ++k) {
    Value size = value.items[k];
    const std::string at = place + "." + value.keys[k];
    if (value.keys[k] == "wrench" && size.kind == Value::Kind::kObject) {
      result["wrench"] = {0, false, ball(size, at)};
      continue;
    }
    const bool percent =
        size.kind == Value::Kind::kString && !size.text.empty() && size.text.back() == '%';
    if (percent) size.text.pop_back();
    result[value.keys[k]] = {number(size, at), percent};
  }
  return result;
}

/// BALL.
Ball CertificateReader::ball(const Value& value, const std::string& place) const {
  expect_order(value, place, {"ball", "length", "about", "body"});
  Ball ball{number(member(value, place, "ball"), place + ".ball"),
            number(member(value, place, "length"), place + ".length"),
            Vector(in_space_ ? 3 : 2), std::nullopt};
  if (const Value* about = value.find("about")) {
    ball.about = numbers(*about, place + ".about", 0, ball.about.size());
  }
  if (several_) {
    const Value& body = member(value, place, "body");
    json_.expect(body.kind == Value::Kind::kString, body, place + ".body", "a string");
    ball.body = body.text;
  } else if (const Value* body = value.find("body")) {
    json_.expect(false, *body, place + ".body", "none, of a question about one body");
  }
  return ball;
}

/// Of so many rows.
std::vector<Vector> CertificateReader::matrix(const Value& value, const std::string& place,
                                              std::size_t least, std::size_t most) const {
  const std::string what = "a matrix of " + std::to_string(least) +
                           (least < most ? " to " + std::to_string(most) : "") + " rows";
  const std::size_t count = list(value, place, what).size();
  json_.expect(count >= least && count <= most, value, place, what);
  std::vector<Vector> rows;
  for (const Value& row : value.items) rows.push_back(numbers(row, place, 0, dimension_));
  return rows;
}

/// PART.
Part CertificateReader::part(const Value& value, const std::string& place) const {
  Part part;
  part.cut = value.kind == Value::Kind::kArray;
  if (part.cut) {
    part.by = node(value, place);
    json_.expect(part.by.kind == NodeKind::kPart, value, place, "a part");
    return part;
  }
  json_.expect(value.kind == Value::Kind::kObject, value, place, "a part");
  if (value.find("rest") != nullptr) {
    part.at_rest = at_rest(value, place);
    return part;
  }
  if (value.find("sticking") != nullptr) {
    part.sticking = sticking(value, place);
    return part;
  }
  const char* walls = value.find("simplex") != nullptr ? "simplex" : "walls";
  expect_order(value, place, {"twist", "open", walls, "direction", "tree"});
  Vector twist = numbers(member(value, place, "twist"), place + ".twist", 0, dimension_);
  part = shape(value, place, 0);
  part.twist = part.end_twist = std::move(twist);
  if (const Value* open = value.find("open")) {
    for (const Value& entry : list(*open, place + ".open", "an array of contacts")) {
      part.open.push_back(index(entry, place + ".open"));
    }
  }
  return part;
}

/// E, A and trees. A parallelepiped has `least_walls` pairs of walls or more.
Part CertificateReader::shape(const Value& value, const std::string& place,
                              std::size_t least_walls) const {
  Part part;
  part.simplex = value.find("simplex") != nullptr;
  const std::string walls = part.simplex ? "simplex" : "walls";
  part.walls = matrix(member(value, place, walls), place + "." + walls,
                      part.simplex ? 2 : least_walls, dimension_ + (part.simplex ? 1 : 0));
  part.direction =
      matrix(member(value, place, "direction"), place + ".direction", dimension_, dimension_);
  part.tree = nodes(member(value, place, "tree"), place + ".tree");
  return part;
}

/// A PART at rest.
RestProof CertificateReader::at_rest(const Value& value, const std::string& place) const {
  expect_order(value, place, {"rest", "answers", "reach"});
  RestProof proof;
  proof.rest = single(member(value, place, "rest"), place + ".rest");
  proof.answers = answers(member(value, place, "answers"), place + ".answers");
  proof.reach = numbers(member(value, place, "reach"), place + ".reach", 0, dimension_);
  return proof;
}

/// A PART that is sticking.
StickingProof CertificateReader::sticking(const Value& value, const std::string& place) const {
  expect_order(value, place, {"sticking", "friction", "presses", "answers", "reach", "energy"});
  StickingProof proof;
  proof.twist = numbers(member(value, place, "sticking"), place + ".sticking", 0, dimension_);
  proof.friction = single(member(value, place, "friction"), place + ".friction");
  const std::string at_presses = place + ".presses";
  for (const Value& entry : list(member(value, place, "presses"), at_presses,
                                 "an array [[contact, numbers], ...]")) {
    json_.expect(entry.is_array(2), entry, at_presses, "[contact, numbers]");
    proof.presses.emplace_back(index(entry.items[0], at_presses),
                               numbers(entry.items[1], at_presses, 0, dimension_));
  }
  proof.answers = answers(member(value, place, "answers"), place + ".answers");
  proof.reach = numbers(member(value, place, "reach"), place + ".reach", 0, dimension_);
  proof.energy = number(member(value, place, "energy"), place + ".energy");
  return proof;
}

/// [[CONTACT, F], ...]
ContactForces CertificateReader::single(const Value& value, const std::string& place) const {
  ContactForces result;
  for (auto& [contact, force] : shares(value, place)) result.push_back({contact, {force}});
  return result;
}

/// [[CONTACT, [F x D]], ...]
ContactForces CertificateReader::answers(const Value& value, const std::string& place) const {
  ContactForces result;
  for (const Value& entry : list(value, place, "an array [[contact, forces], ...]")) {
    json_.expect(entry.is_array(2) && entry.items[1].is_array(dimension_), entry, place,
                 "[contact, forces], with " + std::to_string(dimension_) + " forces");
    const Integer contact = index(entry.items[0], place);
    std::vector<Vector> forces;
    for (const Value& force : entry.items[1].items) {
      forces.push_back(friction(force, place, friction_numbers(contact)));
    }
    result.emplace_back(contact, std::move(forces));
  }
  return result;
}

/// Of a share, or an F: one, or in space three, and of a contact with torsion four.
std::size_t CertificateReader::friction_numbers(const Integer& contact) const {
  if (!in_space_) return 1;
  const bool soft =
      several_ && contact < contacts_.size() && contacts_[contact.get_ui()].torsion != 0;
  return soft ? 4 : 3;
}

Vector CertificateReader::friction(const Value& value, const std::string& place,
                                   std::size_t size) const {
  if (size > 1) return numbers(value, place, 0, size);
  return {number(value, place)};
}

std::vector<std::pair<Integer, Vector>> CertificateReader::shares(
    const Value& value, const std::string& place) const {
  std::vector<std::pair<Integer, Vector>> result;
  for (const Value& entry : list(value, place, "an array [[contact, share], ...]")) {
    json_.expect(entry.is_array(2), entry, place, "[contact, share]");
    const Integer contact = index(entry.items[0], place);
    result.emplace_back(contact, friction(entry.items[1], place, friction_numbers(contact)));
  }
  return result;
}

/// POINT.
Witness CertificateReader::point(const Value& value, bool may_be_ray,
                                 const std::string& place) const {
  json_.expect(value.is_array(3), value, place, "a point [lambda, twist, shares]");
  const std::optional<Rational> lambda =
      may_be_ray ? number_or_null(value.items[0], place) : number(value.items[0], place);
  Witness witness;
  witness.x = numbers(value.items[1], place, 0, dimension_);
  witness.x.push_back(lambda ? 1 : 0);
  witness.x.push_back(lambda.value_or(1));
  witness.shares = shares(value.items[2], place);
  return witness;
}

/// POINT in space.
Witness CertificateReader::point_at(const Rational& multiple, const Value& value,
                                    const std::string& place) const {
  json_.expect(value.kind == Value::Kind::kObject, value, place,
               R"({"twist": [...], "shares": [...]})");
  expect_order(value, place, {"twist", "shares"});
  Witness witness;
  witness.x = numbers(member(value, place, "twist"), place + ".twist", 0, dimension_);
  witness.x.insert(witness.x.end(), {1, multiple});
  witness.shares = shares(member(value, place, "shares"), place + ".shares");
  return witness;
}

/// POINT of a region.
Witness CertificateReader::load_point(const Value& value, const std::string& place) const {
  json_.expect(
      value.is_array(5) && (value.items[0].is_text("at") || value.items[0].is_text("towards")),
      value, place, R"(["at", s, t, twist, shares] or ["towards", ...])");
  Witness witness;
  witness.x = numbers(value.items[3], place, 0, dimension_);
  witness.x.push_back(value.items[0].is_text("at") ? 1 : 0);
  witness.x.push_back(number(value.items[1], place));
  witness.x.push_back(number(value.items[2], place));
  witness.shares = shares(value.items[4], place);
  return witness;
}

std::vector<Node> CertificateReader::nodes(const Value& value, const std::string& place) const {
  std::vector<Node> result;
  for (const Value& entry : list(value, place, "an array of nodes")) {
    result.push_back(node(entry, place + "[" + std::to_string(result.size()) + "]"));
  }
  return result;
}

/// NODE.
Node CertificateReader::node(const Value& value, const std::string& place) const {
  json_.expect(value.kind == Value::Kind::kArray && !value.items.empty() &&
                   value.items[0].kind == Value::Kind::kString,
               value, place, "an array that begins with the kind of the node");
  const std::string& kind = value.items[0].text;
  Node node;
  if (kind == "leaf") {
    node.numbers = numbers(value, place, 1, dimension_);
  } else if (kind == "moving" && !margin_ && !plane_) {
    node.kind = NodeKind::kMoving;
    node.moving = std::make_shared<const MovingTwist>(moving(value, place));
  } else if (kind == "plane") {
    node.kind = NodeKind::kPlane;
    const std::size_t more = plane_ ? 3 : margin_ ? 2 : 1;  // than a motion has
    node.numbers = numbers(value, place, 1, dimension_ + more);
  } else if (kind == "held" && plane_) {
    node.kind = NodeKind::kHeld;
    json_.expect(value.is_array(2), value, place, "held, and a piece");
    node.contact = index(value.items[1], place);
  } else if (kind == "part" && !margin_ && !plane_) {
    node.kind = NodeKind::kPart;
    json_.expect(value.is_array(4), value, place, "part, a name, an index and a number");
    const auto name = std::find_if(kParameterNames.begin(), kParameterNames.end(),
                                   [&](auto known) { return value.items[1].is_text(known); });
    node.parameter = static_cast<Parameter>(name - kParameterNames.begin());
    json_.expect(name != kParameterNames.end() && is_parameter(node.parameter, in_space_),
                 value.items[1], place,
                 std::string("x, y, ") + (in_space_ ? "z, turn_u, turn_v" : "turn") +
                     ", friction, preload, stiffness or wrench");
    node.contact = index(value.items[2], place);
    node.numbers = {number(value.items[3], place)};
  } else {
    json_.expect(kind == "slip" || kind == "separation", value.items[0], place,
                 plane_    ? "slip, separation, plane, leaf or held"
                 : margin_ ? "slip, separation, plane or leaf"
                           : "slip, separation, plane, part, leaf or moving");
    node.kind = kind == "slip" ? NodeKind::kSlip : NodeKind::kSeparation;
    json_.expect(value.is_array(2), value, place, "a kind and a contact");
    node.contact = index(value.items[1], place);
  }
  return node;
}

MovingTwist CertificateReader::moving(const Value& value, const std::string& place) const {
  json_.expect(value.is_array(dimension_ + 3), value, place,
               R"(["moving", y1, ..., c, [[contact, kappa, psi], ...]])");
  MovingTwist twist;
  for (std::size_t j = 0; j < dimension_; ++j) {
    twist.y.push_back(number(value.items[1 + j], place));
  }
  twist.c = number(value.items[dimension_ + 1], place);
  for (const Value& entry :
       list(value.items.back(), place, "an array [[contact, kappa, psi], ...]")) {
    json_.expect(entry.is_array(3), entry, place, "[contact, kappa, psi]");
    const Integer contact = index(entry.items[0], place);
    twist.slips.push_back({contact, number(entry.items[1], place),
                           friction(entry.items[2], place, friction_numbers(contact))});
  }
  return twist;
}

}  // namespace stickslip_check
