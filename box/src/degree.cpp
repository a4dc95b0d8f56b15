// SPDX-License-Identifier: GPL-3.0-or-later
#include "degree.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "box_search.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::box_detail {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

Vector as_vector(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

/// A number of few bits near x.
Rational short_number(double x, int bits) {
  if (x == 0 || !std::isfinite(x)) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return rational_from_double(
      std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits));
}

/// d rounded to a small part of the parallelepiped.
Twist rounded_motion(const Vector3& exact, const Matrix3& walls) {
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    Rational steepest = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational size = abs(walls[j][k]);
      if (size > steepest) steepest = size;
    }
    // A power of two of which the walls see less than 1/256.
    const double grain = to_double(steepest);
    if (!(grain > 0) || !std::isfinite(grain)) return {exact[0], exact[1], exact[2]};
    const int bits = static_cast<int>(std::ceil(std::log2(grain))) + 8;
    const Rational unit = bits >= 0 ? Rational(1, Integer(1) << static_cast<unsigned>(bits))
                                    : Rational(Integer(1) << static_cast<unsigned>(-bits));
    const Rational steps = exact[k] / unit;
    Integer whole = numerator(steps) / denominator(steps);
    result[k] = Rational(whole) * unit;
  }
  return {result[0], result[1], result[2]};
}

/// Where the walls are to be, and which way the middle pulls, in doubles; lengths over
/// BoxModel::length.
class Walls {
 public:
  /// Of the model of the middle, and of the box, around an equilibrium.
  Walls(const ParameterBox& box, const BoxModel& model, const BoxModel& middle,
        const Witness& witness);

  /// Whether the shape is one: three walls that enclose.
  bool is_sound() const { return sound_; }
  /// Moves a wall outwards: by a quarter of its distance, and in larger steps later.
  void grow(std::size_t wall, int sign) {
    const auto j = static_cast<Eigen::Index>(wall);
    constexpr int kSmallSteps = 6;
    int& steps = steps_[2 * wall + (sign > 0 ? 1 : 0)];
    (sign > 0 ? above_ : below_)[j] *= steps++ < kSmallSteps ? 1.25 : 1.6;
  }

  /// d0, E and A in few bits.
  DegreeProof proof() const;

 private:
  struct Contact {
    Vector normal;
    Vector tangent;
    double preload;
    double stiffness;
    double slope;         ///< mu
    double normal_force;  ///< a, at the equilibrium
    double share;         ///< b / (mu a)
    bool sticks;
  };

  void find_generators(const ParameterBox& box);
  void choose_rows(const BoxModel& model);
  Vector force_at(const Vector& shift) const;

  double length_;
  double force_;  ///< a typical one
  Vector motion_;
  std::vector<Contact> contacts_;
  Vector load_;
  std::vector<Vector> generators_;     ///< how far the total wrench moves with each parameter
  Matrix stiffness_ = Matrix::Zero();  ///< C
  Matrix rows_ = Matrix::Zero();       ///< E, up to the widths
  Vector below_ = Vector::Ones();      ///< rows_ (d - motion_) goes from -below_
  Vector above_ = Vector::Ones();      ///< to above_
  std::array<int, 6> steps_{};         ///< by which each wall has grown
  bool sound_ = false;
};

Walls::Walls(const ParameterBox& box, const BoxModel& model, const BoxModel& middle,
             const Witness& witness)
    : length_(middle.length),
      force_(middle.force),
      motion_(to_double(witness.twist.x), to_double(witness.twist.y),
              to_double(witness.twist.r) * middle.length) {
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const ContactForce& force = witness.forces[i];
    const ContactNumbers<double>& c = middle.contacts[i].rounded;
    Contact contact{as_vector(c.normals.front()),
                    as_vector(c.tangents.front()),
                    c.preloads[0],
                    c.stiffnesses[0],
                    c.frictions[0],
                    to_double(force.normal),
                    0,
                    false};
    const double friction = contact.slope * contact.normal_force;
    if (friction > 0) {
      contact.share = to_double(force.tangential) / friction;
      const IntegerVector5& plane = middle.contacts[i].slips.front();
      const Rational slip = Rational(plane[0]) * witness.twist.x +
                            Rational(plane[1]) * witness.twist.y +
                            Rational(plane[2]) * witness.twist.r;
      contact.sticks = slip.is_zero();
    }
    if (force.normal.sign() > 0) {
      stiffness_ += contact.stiffness *
                    (contact.normal + contact.slope * contact.share * contact.tangent) *
                    contact.normal.transpose();
    }
    contacts_.push_back(contact);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    load_[static_cast<Eigen::Index>(j)] = middle.load[j][0];
  }
  find_generators(box);
  choose_rows(model);
}

/// At the equilibrium, to first order: half the difference between the ends of each interval.
void Walls::find_generators(const ParameterBox& box) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ParameterContact& contact = box.contacts()[i];
    std::array<double, 6> low{};
    std::array<double, 6> high{};
    std::array<double, 6> middle{};
    for (std::size_t p = 0; p < middle.size(); ++p) {
      const Interval& interval = contact.parameters[p];
      low[p] = to_double(interval.low);
      high[p] = to_double(interval.high);
      middle[p] = to_double(interval.middle());
    }
    const double share = contacts_[i].share;
    const auto wrench = [&](const std::array<double, 6>& at) -> Vector {
      const double x = at[0] / length_;
      const double y = at[1] / length_;
      const double e = at[2];
      const double nx = to_double(contact.normal.x);
      const double ny = to_double(contact.normal.y);
      const Vector normal(nx - e * ny, ny + e * nx, x * (ny + e * nx) - y * (nx - e * ny));
      const Vector tangent(-normal[1], normal[0], x * normal[0] + y * normal[1]);
      const double a = at[4] - at[5] * normal.dot(motion_);
      return std::max(0.0, a) * (normal + share * at[3] * tangent);
    };
    for (std::size_t p = 0; p < middle.size(); ++p) {
      if (!(high[p] > low[p])) continue;
      std::array<double, 6> below = middle;
      std::array<double, 6> above = middle;
      below[p] = low[p];
      above[p] = high[p];
      generators_.push_back((wrench(above) - wrench(below)) / 2);
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Interval& interval = box.wrench()[j];
    const double half = to_double(interval.high - interval.low) / 2;
    if (half > 0) {
      generators_.push_back(half / (j == 2 ? length_ : 1) *
                            Vector::Unit(static_cast<Eigen::Index>(j)));
    }
  }
}

void Walls::choose_rows(const BoxModel& model) {
  // Sticking contacts whose slips are independent, those with most friction to spare first.
  std::vector<Vector> basis;
  std::vector<std::size_t> chosen;
  std::vector<bool> used(contacts_.size(), false);
  const auto beyond_basis = [&](Vector v) {
    for (const Vector& b : basis) v -= b.dot(v) * b;
    return v;
  };
  while (chosen.size() < 3) {
    double best = 0;
    std::size_t which = contacts_.size();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Contact& c = contacts_[k];
      if (!c.sticks || used[k]) continue;
      const Vector rest = beyond_basis(c.tangent);
      constexpr double kIndependent = 1e-3;
      if (rest.norm() <= kIndependent * c.tangent.norm()) continue;
      const double spare =
          c.slope * c.normal_force * (1.0000001 - std::fabs(c.share)) * rest.norm();
      if (spare > best) {
        best = spare;
        which = k;
      }
    }
    if (which == contacts_.size()) break;
    used[which] = true;
    basis.push_back(beyond_basis(contacts_[which].tangent).normalized());
    chosen.push_back(which);
  }
  // Virtual twists on which these contacts' friction does no work.
  std::vector<Vector> free;
  for (int j = 0; j < 3 && basis.size() < 3; ++j) {
    int axis = 0;
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      const double rest = beyond_basis(Vector::Unit(k)).norm();
      if (rest > most) {
        most = rest;
        axis = k;
      }
    }
    basis.push_back(beyond_basis(Vector::Unit(axis)).normalized());
    free.push_back(basis.back());
  }
  double largest_force = 0;
  for (const Contact& c : contacts_) {
    largest_force = std::max(largest_force, c.normal.norm() * c.stiffness * c.normal.norm());
  }
  const double scale = largest_force > 0 ? force_ / largest_force : 1;  // a typical motion
  // Walls that enclose the motions that the generators cause, as tightly as three pairs can:
  // virtual twists dual to the three that move the object farthest.
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd frame(3, count);
  for (Eigen::Index k = 0; k < count; ++k) frame.col(k) = free[static_cast<std::size_t>(k)];
  const Eigen::MatrixXd reduced = frame.transpose() * stiffness_ * frame;
  if (count > 0 && std::fabs(reduced.determinant()) > 0) {
    const Eigen::MatrixXd compliance = reduced.inverse();
    std::vector<Eigen::VectorXd> forces;
    std::vector<Eigen::VectorXd> motions;
    for (const Vector& g : generators_) {
      forces.push_back(frame.transpose() * g);
      motions.push_back(compliance * forces.back());
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      forces.push_back(1e-3 * force_ * Eigen::VectorXd::Unit(count, k));
      motions.push_back(compliance * forces.back());
    }
    Eigen::MatrixXd chosen_forces(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      std::size_t farthest = 0;
      for (std::size_t g = 1; g < motions.size(); ++g) {
        if (motions[g].norm() > motions[farthest].norm()) farthest = g;
      }
      chosen_forces.col(k) = forces[farthest];
      const Eigen::VectorXd direction = motions[farthest].normalized();
      for (Eigen::VectorXd& motion : motions) motion -= direction.dot(motion) * direction;
    }
    if (std::fabs(chosen_forces.determinant()) > 0) {
      const Eigen::MatrixXd dual = frame * chosen_forces.inverse().transpose();
      for (Eigen::Index k = 0; k < count; ++k) {
        free[static_cast<std::size_t>(k)] = dual.col(k).normalized();
      }
    }
  }
  const auto spread = [&](const Vector& y) {
    double sum = 0;
    for (const Vector& g : generators_) sum += std::fabs(y.dot(g));
    return sum;
  };
  constexpr double kLeast = 1e-3;
  Eigen::Index row = 0;
  for (const std::size_t contact : chosen) {
    const Vector& t = contacts_[contact].tangent;
    rows_.row(row) = t.transpose();
    double off = 0;
    for (const auto& corner : model.contacts[contact].rounded.tangents) {
      off = std::max(off, std::fabs(as_vector(corner).dot(motion_)));
    }
    above_[row++] = 1.5 * off + kLeast * scale * t.norm();
  }
  for (const Vector& y : free) {
    rows_.row(row) = (stiffness_.transpose() * y).transpose();
    above_[row++] = 1.1 * spread(y) + kLeast * force_;
  }
  below_ = above_;
  double product = 1;
  for (Eigen::Index j = 0; j < 3; ++j) product *= rows_.row(j).norm();
  sound_ = product > 0 && std::fabs(rows_.determinant()) > 1e-9 * product;
}

/// The sum of all wrenches on the middle at motion_ + shift. Where a contact sticks there, the
/// share of friction is that of the equilibrium.
Vector Walls::force_at(const Vector& shift) const {
  Vector sum = load_;
  for (const Contact& c : contacts_) {
    const double a = c.preload - c.stiffness * c.normal.dot(motion_ + shift);
    if (!(a > 0)) continue;
    const double slip = c.tangent.dot(c.sticks ? shift : Vector(motion_ + shift));
    constexpr double kStill = 1e-9;
    const bool sticks = c.sticks && std::fabs(slip) <= kStill * c.tangent.norm() * shift.norm();
    const double share = sticks ? c.share : slip > 0 ? -1 : 1;
    sum += a * (c.normal + c.slope * share * c.tangent);
  }
  return sum;
}

DegreeProof Walls::proof() const {
  constexpr int kBits = 12;
  DegreeProof result;
  const Matrix inverse = rows_.inverse();
  const Vector shift = inverse * (above_ - below_) / 2;
  const Vector halves = (above_ + below_) / 2;
  // The linear function that is most nearly against the force on the walls.
  Matrix moments = Matrix::Zero();
  Matrix pulls = Matrix::Zero();
  for (int p = 0; p < 27; ++p) {
    const Vector place(p % 3 - 1, p / 3 % 3 - 1, p / 9 - 1);
    if (p == 13) continue;
    const Vector from = inverse * place.cwiseProduct(halves);
    const Vector force = force_at(shift + from);
    const double size = force.squaredNorm();
    if (!(size > 0)) continue;
    moments += place * place.transpose() / size;
    pulls -= force * place.transpose() / size;
  }
  const Matrix walls = halves.cwiseInverse().asDiagonal() * rows_;
  const Matrix pull = pulls * moments.inverse() * walls;
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double column = k == 2 ? length_ : 1;
      const auto row = static_cast<std::size_t>(j);
      const auto entry = static_cast<std::size_t>(k);
      result.walls[row][entry] = short_number(walls(j, k) * column, kBits);
      result.direction[row][entry] =
          short_number(pull(j, k) * column * (j == 2 ? length_ : 1), kBits);
    }
  }
  const Vector centre = motion_ + shift;
  if (!centre.allFinite()) return {};  // no walls at all
  Vector3 d{rational_from_double(centre[0]), rational_from_double(centre[1]),
            rational_from_double(centre[2] / length_)};
  result.twist = rounded_motion(d, result.walls);
  return result;
}

Rational determinant(const Matrix3& m) {
  return dot(m[0], cross(m[1], m[2]));
}

/// `degree-law`.
bool all_closed_inside(const BoxModel& model, const DegreeProof& proof) {
  // The vertices are the rays of the walls' regions.
  for (std::size_t wall = 0; wall < 3; ++wall) {
    for (const int sign : {1, -1}) {
      const BoxRegion region = BoxRegion::wall(model, proof.walls, proof.twist, wall, sign);
      for (std::size_t i = 0; i < model.contacts.size(); ++i) {
        if (region.separation(i) != Separation::kClosed) return false;
      }
    }
  }
  return true;
}

}  // namespace

Problem problem_at(const ParameterBox& point) {
  std::vector<ContactRow> rows;
  for (const ParameterContact& c : point.contacts()) {
    const auto at = [&](Parameter parameter) -> const Rational& {
      return c.parameters[static_cast<std::size_t>(parameter)].low;
    };
    const Contact contact{{at(Parameter::kX), at(Parameter::kY)},
                          turned(c.normal, at(Parameter::kTurn))};
    rows.push_back({normal_row(contact), tangent_row(contact), at(Parameter::kFriction),
                    at(Parameter::kPreload), at(Parameter::kStiffness)});
  }
  const WrenchBox& w = point.wrench();
  return Problem(std::move(rows), {w[0].low, w[1].low, w[2].low}, point.law());
}

std::optional<DegreeProof> prove_stable(const ParameterBox& box, const Witness& witness,
                                        std::size_t node_limit, BoxWork& work) {
  const BoxModel model(box);
  const BoxModel middle(box.middle());
  Walls walls(box, model, middle, witness);
  if (!walls.is_sound()) return std::nullopt;
  // Equilibria that a box moves much farther than the first order says are lost at a fold.
  constexpr std::size_t kMostGrowths = 18;
  constexpr std::size_t kMostPulls = 4;  // growing seldom mends what list 2 refuses
  std::size_t pulls = 0;
  for (std::size_t growth = 0; growth <= kMostGrowths; ++growth) {
    ++work.proofs;
    DegreeProof proof = walls.proof();
    if (determinant(proof.walls).is_zero() || determinant(proof.direction).is_zero()) {
      return std::nullopt;
    }
    if (model.law == NormalLaw::kBilateral && !all_closed_inside(model, proof)) {
      return std::nullopt;
    }
    const Direction direction{proof.direction, proof.twist};
    const auto refute = [&](bool second, std::size_t wall, int sign) {
      const BoxModel& about = second ? middle : model;
      BoxSearch search(about, second ? &direction : nullptr, node_limit);
      const bool done = search.refute(
          BoxRegion::wall(about, proof.walls, proof.twist, wall, sign), proof.trees);
      work.nodes += search.nodes();
      return done;
    };
    bool failed = false;
    for (const bool second : {false, true}) {
      if (failed) break;
      for (std::size_t wall = 0; wall < 3; ++wall) {
        for (const int sign : {1, -1}) {
          if (refute(second, wall, sign)) continue;
          failed = true;
          walls.grow(wall, sign);
        }
      }
      if (failed && second && ++pulls > kMostPulls) return std::nullopt;
    }
    if (!failed) return proof;
  }
  return std::nullopt;
}

}  // namespace stickslip::box_detail
