// SPDX-License-Identifier: MIT
#include "robustness.hpp"

#include <algorithm>
#include <utility>

#include "work.hpp"

namespace stickslip_check {
namespace {

constexpr std::uint8_t kStick = 1;
constexpr std::uint8_t kSlip = 2;
constexpr std::uint8_t kDetached = 4;
constexpr std::uint8_t kStates[] = {kStick, kSlip, kDetached};

std::uint64_t longest(const Vector& v) {
  std::size_t most = 1;
  for (const Rational& x : v) {
    most = std::max({most, mpz_size(x.get_num_mpz_t()), mpz_size(x.get_den_mpz_t())});
  }
  return most;
}

/// The work of so many operations with numbers of two vectors.
void spend_on(std::uint64_t operations, const Vector& a, const Vector& b) {
  spend(kStepsOfRational * operations, longest(a), longest(b));
}

Square zeros(std::size_t n) {
  return Square(n, Vector(n));
}

void add_square(Square& to, const Rational& factor, const Vector& v) {
  spend_on(v.size() * v.size(), v, v);
  for (std::size_t j = 0; j < v.size(); ++j) add(to[j], factor * v[j], v);
}

Vector times(const Square& a, const Vector& v) {
  Vector result;
  for (const Vector& row : a) {
    spend_on(v.size(), row, v);
    result.push_back(dot(row, v));
  }
  return result;
}

Square squared(const Square& a) {
  Square result;
  for (const Vector& row : a) result.push_back(times(a, row));
  return result;
}

/// v.A v
Rational quadratic(const Square& a, const Vector& v) {
  return dot(times(a, v), v);
}

/// The rank of a symmetric matrix, by elimination without a choice of pivots; nothing if it is
/// not positive semidefinite.
std::optional<std::size_t> rank_if_semidefinite(Square a) {
  std::size_t rank = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k][k] < 0) return std::nullopt;
    if (a[k][k] == 0) {
      for (std::size_t j = k; j < a.size(); ++j) {
        if (a[k][j] != 0) return std::nullopt;
      }
      continue;
    }
    ++rank;
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      spend_on(2 * a.size(), a[i], a[k]);
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return rank;
}

bool is_single(std::uint8_t states) {
  return (states & (states - 1)) == 0;
}

}  // namespace

Vector RobustnessProof::wrench(const Vector& point, const Vector& force) const {
  Vector result = at_point(point, force);
  for (std::size_t j = point.size(); j < result.size(); ++j) result[j] /= length_;
  return result;
}

RobustnessProof::RobustnessProof(const Question& question, const Rational& lower,
                                 const Rational& upper)
    : length_(*question.asked.length),
      lower_(lower),
      upper_(upper),
      of_grasp_(*question.asked.robustness == "grasp") {
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    spend(100 * kStepsOfRational);
    const Contact contact = question.contacts[i];
    Row row;
    for (const Bounds& p : contact.position) row.point.push_back(p.low);
    const Rational norm = *exact_sqrt(dot(contact.normal, contact.normal));
    for (const Rational& x : contact.normal) row.normal.emplace_back(x / norm);
    row.wrench = wrench(row.point, row.normal);
    for (std::size_t j = 0; j < row.point.size(); ++j) {
      Vector axis(row.point.size());
      axis[j] = 1;
      row.axes.push_back(wrench(row.point, axis));
    }
    row.friction = contact.friction.low;
    row.stiffness = contact.stiffness.low;
    row.most = (*question.asked.max_force)[i];
    if (row.friction > 0) {
      row.offset =
          root_bounds(1 + row.friction * row.friction, kDefaultBits).low / row.friction;
    }
    const bool may_stick = row.friction > 0;
    states_.push_back(
        static_cast<States>((may_stick ? kStick : 0) | (of_grasp_ ? kSlip | kDetached : 0)));
    high_ = std::max(high_, Rational(row.most / 2));
    equally_stiff_ = equally_stiff_ && (i == 0 || row.stiffness == rows_[0].stiffness);
    rows_.push_back(std::move(row));
  }
  for (const Bounds& w : question.wrench) load_.push_back(w.low);
  for (std::size_t j = question.in_space ? 3 : 2; j < load_.size(); ++j) load_[j] /= length_;
  open_.push_back({0, "", std::nullopt, 0, low_, high_});
}

/// Adds `factor` times the part of M of a contact that sticks or slips.
void RobustnessProof::add_squares(Square& to, const Row& row, bool sticks,
                                  const Rational& factor) const {
  if (!sticks) {
    add_square(to, factor, row.wrench);
    return;
  }
  for (const Vector& axis : row.axes) add_square(to, factor, axis);
}

void RobustnessProof::check(const std::optional<RobustCombination>& combination) const {
  if (upper_ < 0 || lower_ < 0 || (!combination && lower_ != 0)) {
    reject("robust-lower", "",
           "the bounds are " + show(lower_) + " and " + show(upper_) +
               (combination ? "" : ", without a combination"));
  }
  if (!combination) return;
  const std::size_t n = load_.size();
  const Rational& d = combination->distance;
  Vector sum = load_;
  Square m = zeros(n);
  Square a = zeros(n);
  Square b = zeros(n);
  if (d <= 0) reject("robust-distance", "", "the distance is " + show(d));
  Integer next = 0;
  for (const RobustForce& force : combination->forces) {
    const std::string place = "contact " + force.contact.get_str();
    if (force.contact < next || force.contact >= rows_.size()) {
      reject("robust-forces", place, "it is not there, or out of order");
    }
    next = force.contact + 1;
    const Row& row = rows_[force.contact.get_ui()];
    spend_on(100, force.force, row.wrench);
    const Rational pressing = dot(row.normal, force.force);
    const Rational square = dot(force.force, force.force) - pressing * pressing;
    if (!of_grasp_ && !force.sticks) {
      reject("robust-forces", place, "it slips, but PCR is about contacts that stick");
    }
    if (!force.sticks && square != 0) {
      reject("robust-forces", place, "it slips, and has friction");
    }
    if (pressing < d || row.most - pressing < d) {
      reject("robust-distance", place,
             "the normal force is " + show(pressing) + ", of at most " + show(row.most));
    }
    if (force.sticks) {
      // mu a >= b + c for the roots b and c of these squares.
      const Rational reach = row.friction * pressing;
      const Rational root_square = d * d * (1 + row.friction * row.friction);
      const Rational rest = reach * reach - square - root_square;
      if (rest < 0 || rest * rest < 4 * square * root_square) {
        reject("robust-distance", place, "the force is too near to the edge of its cone");
      }
    }
    add(sum, 1, wrench(row.point, force.force));
    add_squares(m, row, force.sticks, 1);
    add_squares(a, row, force.sticks, row.stiffness);
    add_squares(b, row, force.sticks, row.stiffness * row.stiffness);
  }
  if (!of_grasp_ && combination->forces.size() != rows_.size()) {
    reject("robust-forces", "", "not all contacts stick");
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (sum[j] == 0) continue;
    reject(
        "robust-balance", "",
        "load and forces are " + show(sum[j]) + " together at coordinate " + std::to_string(j));
  }
  if (rank_if_semidefinite(m) != n) reject("robust-stiffness", "", "M has not full rank");
  const Rational& c = combination->inverse_square;
  Square rest = equally_stiff_ ? std::move(m) : squared(a);
  for (std::size_t j = 0; j < n; ++j) {
    if (equally_stiff_) {
      rest[j][j] -= c;
    } else {
      add(rest[j], -c, b[j]);
    }
  }
  if (c < 0 || !rank_if_semidefinite(std::move(rest))) {
    reject("robust-stiffness", "", show(c) + " is below 0, or above 1/sigma^2");
  }
  if (lower_ * lower_ > d * d * c) {
    reject("robust-lower", "", show(lower_) + " is above the combination's value");
  }
}

RobustnessProof::Work RobustnessProof::work(const Row& row, const Vector& y,
                                            bool sticks) const {
  const std::size_t points = row.point.size();
  spend_on(4 * points * points, y, row.wrench);
  Work result{dot(y, row.wrench), 0};
  result.against = -result.along;
  if (sticks) {
    Rational square = -result.along * result.along;
    for (const Vector& axis : row.axes) {
      const Rational u = dot(y, axis);
      square += u * u;
    }
    result.against += row.friction * root_bounds(square, kDefaultBits).high;
  }
  result.against = std::max(result.against, Rational(0));
  return result;
}

/// Whether y and Z show that nothing at the node has a value above the upper bound.
bool RobustnessProof::is_leaf(const Vector& y, const Square& z) const {
  if (!rank_if_semidefinite(z)) return false;
  Rational trace;
  for (std::size_t j = 0; j < z.size(); ++j) trace += z[j][j];
  Rational psi = -dot(y, load_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    std::optional<Rational> most;
    const auto offer = [&](const Rational& value) {
      if (!most || value > *most) most = value;
    };
    if ((states_[i] & kDetached) != 0) offer(0);
    if ((states_[i] & kSlip) != 0 && 2 * low_ <= row.most) {
      const Rational along = work(row, y, false).along;
      offer(quadratic(z, row.wrench) - (along >= 0 ? low_ : Rational(row.most - low_)) * along);
    }
    const Rational room = row.most - low_ * (1 + row.offset);
    if ((states_[i] & kStick) != 0 && room >= 0) {
      const Work found = work(row, y, true);
      Rational value = room * found.against - low_ * row.offset * found.along;
      for (const Vector& axis : row.axes) value += quadratic(z, axis);
      offer(value);
    }
    if (!most) return true;
    psi += *most;
  }
  return psi < 0 || (trace > 0 && high_ * high_ * psi <= upper_ * upper_ * trace);
}

/// Whether y and z show that a combination has no value above the upper bound; or, without z,
/// that y shows that it has no distance above 0.
bool RobustnessProof::is_combination(const std::vector<States>& states, const Vector& y,
                                     const std::optional<Vector>& z) const {
  const std::size_t n = load_.size();
  Rational constant = -dot(y, load_);
  Rational slope;
  Rational most = high_;
  Square m = zeros(n);
  Square a = zeros(n);
  Square b = zeros(n);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (states[i] == 0) return true;
    if (states[i] == kDetached) continue;
    const bool sticks = states[i] == kStick;
    const Rational offset = sticks ? row.offset : Rational(1);
    const Work found = work(row, y, sticks);
    constant += row.most * found.against;
    slope += offset * found.along + (1 + offset) * found.against;
    most = std::min(most, Rational(row.most / (1 + offset)));
    if (!z) continue;
    if (equally_stiff_) {
      add_squares(m, row, sticks, 1);
    } else {
      add_squares(a, row, sticks, row.stiffness);
      add_squares(b, row, sticks, row.stiffness * row.stiffness);
    }
  }
  if (constant < 0) return true;
  if (!z) return constant == 0 && slope > 0;
  if (slope > 0) most = std::min(most, Rational(constant / slope));
  if (dot(*z, *z) == 0) return false;
  const Rational p = equally_stiff_ ? quadratic(m, *z) : dot(times(a, *z), times(a, *z));
  const Rational q = equally_stiff_ ? dot(*z, *z) : quadratic(b, *z);
  return most * most * p <= upper_ * upper_ * q;
}

std::string RobustnessProof::path() const {
  std::string result;
  for (const Step& step : path_) result += (result.empty() ? "" : ", ") + step.name;
  return result.empty() ? "root" : result;
}

void RobustnessProof::reject_node(const char* rule, const std::string& found) const {
  throw Rejected{rule, nodes_ - 1, path(), found};
}

/// Goes to the next child: back to where it branches off, and one step on.
void RobustnessProof::enter() {
  Step next = std::move(open_.back());
  open_.pop_back();
  const auto swap = [&](Step& step) {
    if (step.contact) {
      std::swap(step.states, states_[*step.contact]);
    } else {
      std::swap(step.low, low_);
      std::swap(step.high, high_);
    }
  };
  while (path_.size() > next.above) {
    swap(path_.back());
    path_.pop_back();
  }
  swap(next);
  path_.push_back(std::move(next));
}

void RobustnessProof::visit(const RobustNode& node) {
  spend(100);
  if (open_.empty()) {
    throw Rejected{"tree-long", nodes_, "", "everything was complete before this"};
  }
  enter();
  ++nodes_;
  const std::size_t above = path_.size();
  if (node.kind == RobustNodeKind::kState) {
    const bool is_there = node.contact < rows_.size();
    const std::size_t i = is_there ? node.contact.get_ui() : 0;
    if (!is_there || is_single(states_[i])) {
      reject_node("robust-split",
                  "contact " + node.contact.get_str() + " has no choice of states");
    }
    const std::string name = "state " + std::to_string(i);
    constexpr const char* kNames[] = {" stick", " slip", " detached"};
    for (std::size_t s = 3; s-- > 0;) {
      if ((states_[i] & kStates[s]) == 0) continue;
      open_.push_back({above, name + kNames[s], i, kStates[s], 0, 0});
    }
    return;
  }
  if (node.kind == RobustNodeKind::kDistance) {
    if (node.distance <= low_ || node.distance >= high_) {
      reject_node("robust-split", show(node.distance) + " is not between the distances " +
                                      show(low_) + " and " + show(high_));
    }
    open_.push_back({above, "distance above", std::nullopt, 0, node.distance, high_});
    open_.push_back({above, "distance below", std::nullopt, 0, low_, node.distance});
    return;
  }
  ++leaves_;
  const std::size_t n = load_.size();
  if (node.kind == RobustNodeKind::kLeaf) {
    Square z = zeros(n);
    std::size_t next = 0;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = j; k < n; ++k) z[j][k] = z[k][j] = node.z[next++];
    }
    if (is_leaf(node.y, z)) return;
    reject_node("robust-leaf",
                "y and Z do not show that nothing has a value above " + show(upper_));
  }
  if (node.kind == RobustNodeKind::kCombination) {
    if (std::all_of(states_.begin(), states_.end(), is_single) &&
        is_combination(states_, node.y, node.z)) {
      return;
    }
    reject_node("robust-leaf",
                "it is no combination, or may have a value above " + show(upper_));
  }
  if (nodes_ == 1 && of_grasp_) {
    std::vector<States> first;
    for (const Row& row : rows_) first.push_back(row.friction > 0 ? kStick : kSlip);
    if (is_combination(first, node.y, std::nullopt)) return;
  }
  reject_node("robust-leaf", "y does not show that PGR is 0");
}

void RobustnessProof::finish() {
  if (open_.empty()) return;
  enter();
  throw Rejected{"tree-short", nodes_, path(), "the list ends before this node"};
}

}  // namespace stickslip_check
