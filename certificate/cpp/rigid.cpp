// SPDX-License-Identifier: MIT
#include "rigid.hpp"

#include <algorithm>

#include "work.hpp"

namespace stickslip_check {
namespace {

/// About what a contact costs in a node.
constexpr std::uint64_t kStepsOfContact = 20;

Vector plus(Vector a, const Rational& factor, const Vector& b) {
  add(a, factor, b);
  return a;
}

bool is_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x == 0; });
}

/// The sign of c if v = c u, else 0; neither is 0.
int factor_sign(const Vector& u, const Vector& v) {
  for (std::size_t j = 0; j < u.size(); ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      if (u[j] * v[k] != u[k] * v[j]) return 0;
    }
  }
  return sgn(dot(u, v));
}

/// Whether a sqrt(b) >= c sqrt(d), of b >= 0 and d >= 0.
bool at_least(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  return sgn(a) * a * a * b >= sgn(c) * c * c * d;
}

}  // namespace

Vector RigidRow::slip(const Vector& d) const {
  Vector u(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(point.size()));
  if (point.size() == 2) {
    u = plus(u, d[2], {-point[1], point[0]});
  } else {
    u = plus(u, 1, cross({d[3], d[4], d[5]}, point));
  }
  return plus(u, -dot(direction, u) / dot(direction, direction), direction);
}

Vector RigidRow::across(const Vector& friction) const {
  if (point.size() == 3) return friction;
  return {-friction[0] * direction[1], friction[0] * direction[0]};
}

/// Whether this and the other slip alike under every motion (in space with normals of one
/// direction, too).
bool RigidRow::slips_like(const RigidRow& other) const {
  if (point.size() == 3) return point == other.point && factor_sign(normal, other.normal) > 0;
  return factor_sign(at_point(point, across({1})), at_point(other.point, other.across({1}))) !=
         0;
}

/// The force of normal part 1 against a slip along `side` does no negative work on the motion.
bool RigidRow::resists(const Vector& motion, const Vector& side) const {
  return at_least(dot(motion, normal), dot(side, side), dot(side, slip(motion)), square);
}

RigidProof::RigidProof(const Question& question) : inertia_(*question.asked.inertia) {
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const Contact contact = question.contacts[i];
    RigidRow& row = rows_.emplace_back();
    for (const Bounds& p : contact.position) row.point.push_back(p.low);
    row.direction = contact.normal;
    row.normal = at_point(row.point, row.direction);
    row.square =
        contact.friction.low * contact.friction.low * dot(row.direction, row.direction);
  }
  for (const Bounds& w : question.wrench) wrench_.push_back(w.low);
  waiting_.push_back({std::vector<Label>(rows_.size()), {}});
}

/// M a.
Vector RigidProof::times_mass(const Vector& a) const {
  const Vector& m = inertia_;
  if (a.size() == kPlanar) {
    const Rational fx = a[0] - a[2] * m[1];
    const Rational fy = a[1] + a[2] * m[0];
    return {fx, fy, m[0] * fy - m[1] * fx + m[2] * a[2]};
  }
  const Vector centre{m[0], m[1], m[2]};
  const Vector turn{a[3], a[4], a[5]};
  const Vector gyration[]{{m[3], m[6], m[7]}, {m[6], m[4], m[8]}, {m[7], m[8], m[5]}};
  Vector result = at_point(centre, plus({a[0], a[1], a[2]}, 1, cross(turn, centre)));
  for (std::size_t j = 0; j < 3; ++j) result[3 + j] += dot(gyration[j], turn);
  return result;
}

/// Whether some force that the label allows does negative work on y.
bool RigidProof::opposes(const RigidRow& row, const Label& label, const Vector& y) const {
  if (label.touch == Touch::kApart) return false;
  const Vector slip = row.slip(y);
  if (!label.slip || label.slip->empty())
    return !row.resists(y, slip) || dot(y, row.normal) < 0;
  const std::vector<Vector>& sides = *label.slip;
  const Vector& n = row.direction;
  if (sides.size() == 2 && dot(n, cross(sides[0], slip)) >= 0 &&
      dot(n, cross(slip, sides[1])) >= 0) {
    return !row.resists(y, slip) || dot(y, row.normal) < 0;
  }
  return std::any_of(sides.begin(), sides.end(),
                     [&](const Vector& side) { return !row.resists(y, side); });
}

void RigidProof::check_twist(const Vector& twist) const {
  const bool unopposed = std::none_of(
      rows_.begin(), rows_.end(), [&](const RigidRow& row) { return opposes(row, {}, twist); });
  if (dot(twist, wrench_) <= 0 || !unopposed) {
    reject("class-twist", "",
           "the load does no work along it, or a force in a cone opposes it");
  }
}

void RigidProof::check_forces(const std::vector<RigidForce>& forces, const Vector& acceleration,
                              const std::string& place) const {
  Vector total = wrench_;
  Integer next = 0;
  for (const RigidForce& force : forces) {
    const std::string name = "contact " + force.contact.get_str();
    if (force.contact < next || force.contact >= rows_.size()) {
      reject("class-force", place, name + " is not there, or out of order");
    }
    next = force.contact + 1;
    const RigidRow& row = rows_[force.contact.get_ui()];
    const Vector friction = row.across(force.friction);
    if (force.normal < 0 || dot(friction, row.direction) != 0 ||
        dot(friction, friction) > row.square * force.normal * force.normal) {
      reject("class-force", place, "the force of " + name + " is not in its cone");
    }
    total = plus(plus(total, force.normal, row.normal), 1, at_point(row.point, friction));
  }
  if (total != times_mass(acceleration)) {
    reject("class-balance", place, "load and forces are " + show(total) + " together");
  }
}

void RigidProof::check_motion(const std::vector<RigidForce>& forces,
                              const Vector& acceleration) const {
  const auto refuse = [](const std::string& found) { reject("class-motion", "forces", found); };
  if (is_zero(acceleration)) refuse("the acceleration is 0");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (dot(rows_[i].normal, acceleration) < 0) {
      refuse("contact " + std::to_string(i) + " is penetrated");
    }
  }
  for (const RigidForce& force : forces) {
    const RigidRow& row = rows_[force.contact.get_ui()];
    const Vector slip = row.slip(acceleration);
    const Rational power = dot(row.across(force.friction), slip);
    if (force.normal * dot(row.normal, acceleration) != 0 || power > 0 ||
        power * power != row.square * force.normal * force.normal * dot(slip, slip)) {
      refuse("contact " + force.contact.get_str() +
             " parts, or its friction does not oppose its slip");
    }
  }
}

void RigidProof::visit(const RigidNode& node) {
  if (waiting_.empty()) throw Rejected{"tree-long", nodes_, "", "nodes after the end"};
  const Cell cell = std::move(waiting_.back());
  waiting_.pop_back();
  const auto refuse = [&](const char* rule, const std::string& found) {
    throw Rejected{rule, nodes_, cell.path(), found};
  };
  spend(kStepsOfContact * (rows_.size() + 1));
  if (cell.steps.size() > 2 * rows_.size() + 256) {
    refuse("node-depth", std::to_string(cell.steps.size()) + " nodes stand above this one");
  }
  if (node.kind == RigidNode::Kind::kLeaf) {
    if (const auto found = refusal(cell, node)) refuse("class-leaf", *found);
    ++leaves_;
  } else {
    if (node.contact >= rows_.size()) {
      refuse("node-contact", "contact " + node.contact.get_str() + ", but the grasp has " +
                                 std::to_string(rows_.size()));
    }
    if (node.kind == RigidNode::Kind::kSlip && !is_direction(cell, node)) {
      refuse("class-slip", "d is 0, not across n, or not inside of the slips that are known");
    }
    std::vector<Cell> found = children(cell, node);
    std::move(found.rbegin(), found.rend(), std::back_inserter(waiting_));
  }
  ++nodes_;
}

void RigidProof::finish() const {
  if (waiting_.empty()) return;
  throw Rejected{"tree-short", nodes_, waiting_.back().path(),
                 std::to_string(waiting_.size()) + " children are missing"};
}

std::string RigidProof::Cell::path() const {
  std::string text;
  for (const std::string& step : steps) text += (text.empty() ? "" : ", ") + step;
  return text.empty() ? "root" : text;
}

/// `class-slip`
bool RigidProof::is_direction(const Cell& cell, const RigidNode& node) const {
  if (node.direction.empty()) return true;
  const std::size_t i = node.contact.get_ui();
  const Vector& n = rows_[i].direction;
  const Vector& d = node.direction;
  const auto& known = cell.labels[i].slip;
  if (is_zero(d) || dot(n, d) != 0) return false;
  if (!known || known->empty()) return true;
  return dot(n, cross((*known)[0], d)) > 0 && dot(n, cross(d, (*known)[1])) > 0;
}

std::vector<RigidProof::Cell> RigidProof::children(const Cell& cell,
                                                   const RigidNode& node) const {
  std::vector<Cell> result;
  const RigidRow& row = rows_[node.contact.get_ui()];
  const auto add = [&](const std::string& step, const auto& set) {
    Cell child = cell;
    child.steps.push_back(step);
    for (std::size_t j = 0; j < rows_.size(); ++j) set(rows_[j], child.labels[j]);
    result.push_back(std::move(child));
  };
  const std::string contact = node.contact.get_str();
  if (node.kind == RigidNode::Kind::kTouch) {
    for (const Touch touch : {Touch::kTouching, Touch::kApart}) {
      add("touch " + contact + (touch == Touch::kTouching ? " touching" : " apart"),
          [&](const RigidRow& other, Label& label) {
            if (factor_sign(row.normal, other.normal) > 0) label.touch = touch;
          });
    }
    return result;
  }
  const auto add_slips = [&](const std::string& word, const std::vector<Vector>& sides) {
    add("slip " + contact + " " + word, [&](const RigidRow& other, Label& label) {
      if (row.slips_like(other)) label.slip = sides;
    });
  };
  const Vector& n = row.direction;
  if (n.size() == 2) {
    add_slips("+", {{-n[1], n[0]}});
    add_slips("0", {});
    add_slips("-", {{n[1], -n[0]}});
    return result;
  }
  const Vector& d = node.direction;
  const auto& known = cell.labels[node.contact.get_ui()].slip;
  if (known && !known->empty()) {
    add_slips("before", {(*known)[0], d});
    add_slips("after", {d, (*known)[1]});
    return result;
  }
  add_slips("0", {});
  Vector before = d;
  for (const char* quarter : {"1", "2", "3", "4"}) {
    Vector after = cross(n, before);
    add_slips(quarter, {before, after});
    before = std::move(after);
  }
  return result;
}

/// Why the leaf proves nothing.
std::optional<std::string> RigidProof::refusal(const Cell& cell, const RigidNode& leaf) const {
  const Rational& t = leaf.weight;
  const Rational work = dot(leaf.twist, wrench_);
  if (t < 0 || work < 0 || (t == 0 && work == 0)) {
    return "t or y.w is below 0, or both are 0";
  }
  Vector total = plus(times_mass(leaf.twist), t, wrench_);
  Integer next = 0;
  const auto wrong_name = [&](const Integer& contact) {
    const bool wrong = contact < next || contact >= rows_.size();
    next = contact + 1;
    return wrong;
  };
  for (const auto& [contact, g] : leaf.normal) {
    const std::string name = "contact " + contact.get_str();
    if (wrong_name(contact)) return name + " is not there, or out of order";
    if (g < 0 && cell.labels[contact.get_ui()].touch != Touch::kTouching) {
      return "g of " + name + " is below 0, but it may part";
    }
    total = plus(total, g, rows_[contact.get_ui()].normal);
  }
  next = 0;
  for (const auto& [contact, multiplier] : leaf.tangent) {
    const std::string name = "contact " + contact.get_str();
    if (wrong_name(contact)) return name + " is not there, or out of order";
    const RigidRow& row = rows_[contact.get_ui()];
    const auto& slip = cell.labels[contact.get_ui()].slip;
    const Vector h = row.across(multiplier);
    if (!slip || dot(h, row.direction) != 0 ||
        std::any_of(slip->begin(), slip->end(),
                    [&](const Vector& side) { return dot(h, side) < 0; })) {
      return "h of " + name + " is not of one sign with its slip";
    }
    total = plus(total, 1, at_point(row.point, h));
  }
  if (!is_zero(total)) return "the sum is " + show(total);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (opposes(rows_[i], cell.labels[i], leaf.twist)) {
      return "contact " + std::to_string(i) + " opposes y";
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
