// SPDX-License-Identifier: MIT
#include "rigid.hpp"

#include <algorithm>

#include "work.hpp"

namespace stickslip_check {
namespace {

/// About what a contact costs in a node.
constexpr std::uint64_t kStepsOfContact = 20;

Vector plus(Vector a, const Rational& factor, const Vector& b) {
  for (std::size_t j = 0; j < a.size(); ++j) a[j] += factor * b[j];
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

[[noreturn]] void reject(const char* rule, const std::string& place, const std::string& found) {
  throw Rejected{rule, std::nullopt, place, found};
}

}  // namespace

RigidProof::RigidProof(const Question& question) : inertia_(*question.asked.inertia) {
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const Contact contact = question.contacts[i];
    const Vector point{contact.position[0].low, contact.position[1].low};
    const Vector& n = contact.normal;
    rows_.push_back({at_point(point, n), at_point(point, {-n[1], n[0]}), contact.friction.low});
  }
  for (const Bounds& w : question.wrench) wrench_.push_back(w.low);
  waiting_.push_back({std::vector<Label>(rows_.size()), {}});
}

/// M a.
Vector RigidProof::times_mass(const Vector& a) const {
  const Rational& x = inertia_[0];
  const Rational& y = inertia_[1];
  const Rational fx = a[0] - a[2] * y;
  const Rational fy = a[1] + a[2] * x;
  return {fx, fy, x * fy - y * fx + inertia_[2] * a[2]};
}

void RigidProof::check_twist(const Vector& twist) const {
  bool good = dot(twist, wrench_) > 0;
  for (const RigidRow& row : rows_) {
    for (const int side : {1, -1}) {
      good = good && dot(twist, plus(row.normal, side * row.friction, row.tangent)) >= 0;
    }
  }
  if (!good) {
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
    if (force.normal < 0 || abs(force.friction) > row.friction * force.normal) {
      reject("class-force", place, "the force of " + name + " is not in its cone");
    }
    total = plus(plus(total, force.normal, row.normal), force.friction, row.tangent);
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
    const Rational slip = dot(row.tangent, acceleration);
    const Rational driven = row.friction * force.normal * abs(slip) + force.friction * slip;
    if (force.normal * dot(row.normal, acceleration) != 0 || driven != 0) {
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
  for (const int side : {1, 0, -1}) {
    add("slip " + contact +
            (side > 0    ? " +"
             : side == 0 ? " 0"
                         : " -"),
        [&](const RigidRow& other, Label& label) {
          const int along = factor_sign(row.tangent, other.tangent);
          if (along != 0) label.slip = along * side;
        });
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
  for (const bool normal : {true, false}) {
    Integer next = 0;
    for (const auto& [contact, x] : normal ? leaf.normal : leaf.tangent) {
      const std::string name = "contact " + contact.get_str();
      if (contact < next || contact >= rows_.size()) {
        return name + " is not there, or out of order";
      }
      next = contact + 1;
      const RigidRow& row = rows_[contact.get_ui()];
      const Label& label = cell.labels[contact.get_ui()];
      if (normal && x < 0 && label.touch != Touch::kTouching) {
        return "g of " + name + " is below 0, but it may part";
      }
      if (!normal && (!label.slip || *label.slip * x < 0)) {
        return "h of " + name + " has not the sign of its slip";
      }
      total = plus(total, x, normal ? row.normal : row.tangent);
    }
  }
  if (!is_zero(total)) return "the sum is " + show(total);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Label& label = cell.labels[i];
    for (const int side : {1, -1}) {
      const bool allowed = label.touch != Touch::kApart && label.slip != side;
      const RigidRow& row = rows_[i];
      if (allowed && dot(leaf.twist, plus(row.normal, side * row.friction, row.tangent)) < 0) {
        return "contact " + std::to_string(i) + " opposes y";
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
