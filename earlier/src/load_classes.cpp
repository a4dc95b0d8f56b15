// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/load_classes.hpp"

#include <array>

#include "contact_forces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/option_text.hpp"
#include "stickslip/equilibrium/search/region.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// The forces a N + b T with |b| <= mu a, or with b = 0.
enum class Friction { kCone, kNone };

Wrench edge(const Problem& problem, std::size_t contact, int side, Friction friction) {
  return problem.edge_wrench(ContactId(contact), friction == Friction::kCone ? side : 0);
}

UnopposedMotion checked(const Problem& problem, Friction friction, UnopposedMotion motion) {
  require(power(problem.wrench(), motion.twist).sign() > 0, "the load does no work");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const int side : {1, -1}) {
      require(power(edge(problem, i, side, friction), motion.twist).sign() >= 0,
              "a contact force opposes the motion");
    }
  }
  return motion;
}

LoadClass balance(const Problem& problem, Friction friction) {
  LinearProgram program;
  program.add_variables(2 * problem.size(), VariableKind::kNonNegative);
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Rational> coefficients;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (const int side : {1, -1}) {
        coefficients.push_back(coordinates(edge(problem, i, side, friction))[j]);
      }
    }
    program.add_row(std::move(coefficients), Relation::kEqual,
                    -coordinates(problem.wrench())[j]);
  }
  const LpResult result = solve(program);
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    const std::vector<Rational>& y = infeasible->farkas;
    return checked(problem, friction, {{-y[0], -y[1], -y[2]}});
  }
  const std::vector<Rational>& point = std::get<Optimal>(result).point;
  BalancingForces found;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    found.forces.push_back(force_of_edges(problem.rows()[i], point[2 * i], point[2 * i + 1]));
    if (friction == Friction::kNone) found.forces.back().tangential = 0;
  }
  require(balances_in_cones(problem, found.forces), "the forces do not balance the load");
  return found;
}

}  // namespace

LoadClass weakly_stable_load(const Problem& problem) {
  return balance(problem, Friction::kCone);
}

LoadClass frictionless_stable_load(const Problem& problem) {
  return balance(problem, Friction::kNone);
}

namespace {

/// What is known of one contact of the rigid-body model (load_classes.hpp).
enum class Label { kAny, kApart, kTouching, kSlipPlus, kSlipMinus, kStick };

/// M a, the wrench that gives the acceleration a.
Wrench times_mass(const Inertia& inertia, const Twist& a) {
  const Vector2& c = inertia.centre;
  const Rational fx = a.x - a.r * c.y;
  const Rational fy = a.y + a.r * c.x;
  return {fx, fy, c.x * fy - c.y * fx + inertia.gyration_squared * a.r};
}

IntegerVector5 plane_of(const Wrench& row) {
  return primitive_multiple<5>({row.x, row.y, row.torque, 0, 0});
}

/// The sign that the plane has on all accelerations of the region, if it has one.
std::optional<Sign> sign_on(const Region& region, const IntegerVector5& plane) {
  const ConeSigns signs(region.cone());
  const SignRange range = signs.on(plane);
  if (range.is_zero()) return Sign::kZero;
  if (range.is_mixed() || !region.is_barred(signs.rays_in(plane))) return std::nullopt;
  return range.negative ? Sign::kNegative : Sign::kPositive;
}

Region with_sign(const Region& region, const IntegerVector5& plane, Sign sign) {
  if (sign == Sign::kNegative) return region.plane_child(plane, Side::kNegative);
  if (sign == Sign::kPositive) return region.plane_child(negated(plane), Side::kNegative);
  return region.plane_child(plane, Side::kPositive)
      .plane_child(negated(plane), Side::kPositive);
}

/// Branch and bound over regions of accelerations. Every split parts a region into disjoint
/// ones by a plane N_i or T_i that does not have one sign on it, so there are at most as many
/// leaves as the arrangement of these planes has cells.
class AccelerationSearch {
 public:
  AccelerationSearch(const Problem& problem, const Inertia& inertia, std::size_t most_programs)
      : problem_(problem),
        inertia_(inertia),
        most_programs_(most_programs),
        labels_(problem.size(), Label::kAny) {
    for (const ContactRow& row : problem.rows()) normals_.push_back(plane_of(row.normal));
  }

  enum class Outcome { kNone, kFound, kLimit };

  Outcome run() {
    Region all;
    for (const IntegerVector5& normal : normals_) {
      all = all.plane_child(normal, Side::kPositive);
    }
    return run(all);
  }

  std::size_t cases() const { return cases_; }
  const Acceleration& found() const { return found_; }

 private:
  Outcome run(const Region& region) {
    if (region.is_void()) return Outcome::kNone;
    if (programs_ == most_programs_) return Outcome::kLimit;
    ++programs_;
    for (std::size_t i = 0; i < problem_.size(); ++i) labels_[i] = label_on(region, i);
    const std::optional<Acceleration> relaxed = fastest();
    if (!relaxed) {
      ++cases_;
      return Outcome::kNone;
    }
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const ContactRow& row = problem_.rows()[i];
      const ContactForce& f = relaxed->forces[i];
      const Rational slip = power(row.tangent, relaxed->acceleration);
      const bool parts = !(f.normal * power(row.normal, relaxed->acceleration)).is_zero();
      const bool drives =
          !(row.friction * f.normal * abs(slip) + f.tangential * slip).is_zero();
      if (!parts && !drives) continue;
      if (labels_[i] == Label::kAny) {
        return split(region, normals_[i], {Sign::kZero, Sign::kPositive});
      }
      return split(region, problem_.slip_plane(ContactId(i)),
                   {Sign::kPositive, Sign::kNegative, Sign::kZero});
    }
    found_ = *relaxed;
    return Outcome::kFound;
  }

  Outcome split(const Region& region, const IntegerVector5& plane,
                std::initializer_list<Sign> signs) {
    for (const Sign sign : signs) {
      const Outcome outcome = run(with_sign(region, plane, sign));
      if (outcome != Outcome::kNone) return outcome;
    }
    return Outcome::kNone;
  }

  Label label_on(const Region& region, std::size_t contact) const {
    const std::optional<Sign> apart = sign_on(region, normals_[contact]);
    if (!apart) return Label::kAny;
    if (*apart == Sign::kPositive) return Label::kApart;
    const auto slip = sign_on(region, problem_.slip_plane(ContactId(contact)));
    if (!slip) return Label::kTouching;
    return *slip == Sign::kZero       ? Label::kStick
           : *slip == Sign::kPositive ? Label::kSlipPlus
                                      : Label::kSlipMinus;
  }

  /// A point of the relaxed program with w.a > 0, if there is one.
  std::optional<Acceleration> fastest() const {
    LinearProgram program;
    std::size_t count = program.add_variables(3, VariableKind::kFree) + 3;
    std::array<std::vector<Rational>, 3> balance;
    const std::array<Twist, 3> axes{Twist{1, 0, 0}, Twist{0, 1, 0}, Twist{0, 0, 1}};
    for (const Twist& axis : axes) {
      const Vector3 column = coordinates(times_mass(inertia_, axis));
      for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(column[j]);
    }
    std::vector<std::array<std::optional<std::size_t>, 2>> edges(problem_.size());
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const Label label = labels_[i];
      for (const int side : {1, -1}) {
        // Friction opposes slip.
        const Label allows_it = side > 0 ? Label::kSlipMinus : Label::kSlipPlus;
        if (label != Label::kAny && label != Label::kTouching && label != Label::kStick &&
            label != allows_it) {
          continue;
        }
        program.add_variable(VariableKind::kNonNegative);
        edges[i][side > 0 ? 0 : 1] = count++;
        const Vector3 column = coordinates(problem_.edge_wrench(ContactId(i), side));
        for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(-column[j]);
      }
      const ContactRow& row = problem_.rows()[i];
      const bool may_part = label == Label::kAny || label == Label::kApart;
      const Vector3 n = coordinates(row.normal);
      const Vector3 t = coordinates(row.tangent);
      program.add_row({n.begin(), n.end()},
                      may_part ? Relation::kGreaterEqual : Relation::kEqual, 0);
      if (label == Label::kSlipPlus || label == Label::kSlipMinus || label == Label::kStick) {
        program.add_row({t.begin(), t.end()},
                        label == Label::kSlipPlus    ? Relation::kGreaterEqual
                        : label == Label::kSlipMinus ? Relation::kLessEqual
                                                     : Relation::kEqual,
                        0);
      }
    }
    const Wrench& w = problem_.wrench();
    for (std::size_t j = 0; j < 3; ++j) {
      program.add_row(std::move(balance[j]), Relation::kEqual, coordinates(w)[j]);
    }
    program.minimize({-w.x, -w.y, -w.torque});
    const LpResult result = solve(program);
    std::vector<Rational> x;
    if (const auto* optimal = std::get_if<Optimal>(&result)) {
      if (optimal->value.sign() >= 0) return std::nullopt;
      x = optimal->point;
    } else if (const auto* unbounded = std::get_if<Unbounded>(&result)) {
      x = far_along(*unbounded, w);
    } else {
      return std::nullopt;
    }
    Acceleration point{{x[0], x[1], x[2]}, {}};
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const auto coefficient = [&](std::size_t side) {
        return edges[i][side] ? x[*edges[i][side]] : Rational(0);
      };
      point.forces.push_back(
          force_of_edges(problem_.rows()[i], coefficient(0), coefficient(1)));
    }
    return point;
  }

  /// A point of the ray with w.a > 0.
  static std::vector<Rational> far_along(const Unbounded& unbounded, const Wrench& w) {
    const auto work = [&](const std::vector<Rational>& x) {
      return power(w, {x[0], x[1], x[2]});
    };
    const Rational step = 1 + abs(work(unbounded.point)) / work(unbounded.ray);
    std::vector<Rational> x = unbounded.point;
    for (std::size_t v = 0; v < x.size(); ++v) x[v] += step * unbounded.ray[v];
    return x;
  }

  const Problem& problem_;
  const Inertia& inertia_;
  std::size_t most_programs_;
  std::size_t programs_ = 0;
  std::size_t cases_ = 0;
  std::vector<Label> labels_;  ///< of the region at hand
  std::vector<IntegerVector5> normals_;
  Acceleration found_;
};

Acceleration checked(const Problem& problem, const Inertia& inertia, Acceleration solution) {
  const Twist& a = solution.acceleration;
  require(!(a == Twist{}), "an acceleration is zero");
  require(resultant(problem, solution.forces) == times_mass(inertia, a),
          "an acceleration breaks Newton's law");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& f = solution.forces[i];
    const Rational apart = power(row.normal, a);
    const Rational slip = power(row.tangent, a);
    require(is_in_cone(row, f), "a force of an accelerating body leaves its friction cone");
    require(apart.sign() >= 0 && (f.normal * apart).is_zero(),
            "an acceleration breaks complementarity");
    require((row.friction * f.normal * abs(slip) + f.tangential * slip).is_zero(),
            "friction does not oppose the acceleration");
  }
  return solution;
}

}  // namespace

std::variant<StronglyStable, Acceleration, Undecided> strongly_stable_load(
    const Problem& problem, const Inertia& inertia, std::size_t most_programs) {
  require(inertia.gyration_squared.sign() > 0, "the radius of gyration must not be zero");
  AccelerationSearch search(problem, inertia, most_programs);
  switch (search.run()) {
    case AccelerationSearch::Outcome::kLimit:
      return Undecided{"it takes more than " + std::to_string(most_programs) +
                       " linear programs"};
    case AccelerationSearch::Outcome::kFound:
      return checked(problem, inertia, search.found());
    default:
      break;
  }
  LoadClass weak = weakly_stable_load(problem);
  auto* forces = std::get_if<BalancingForces>(&weak);
  require(forces != nullptr, "the rigid-body model has no solution at all");
  return StronglyStable{std::move(*forces), search.cases()};
}

RigidVerdict rigid_verdict(const Problem& problem, const Inertia& inertia,
                           std::size_t most_programs) {
  LoadClass weak = weakly_stable_load(problem);
  if (auto* motion = std::get_if<UnopposedMotion>(&weak)) return std::move(*motion);
  auto strong = strongly_stable_load(problem, inertia, most_programs);
  if (auto* motion = std::get_if<Acceleration>(&strong)) {
    return OpenLoad{std::move(std::get<BalancingForces>(weak)), std::move(*motion)};
  }
  if (auto* undecided = std::get_if<Undecided>(&strong)) return std::move(*undecided);
  return std::get<StronglyStable>(std::move(strong));
}

std::string name_of(const RigidVerdict& verdict) {
  constexpr const char* kNames[] = {"must move", "must hold", "open", "undecided"};
  return kNames[verdict.index()];
}

Inertia inertia_of(const std::string& place, const std::vector<Rational>& numbers) {
  if (numbers.size() != 3 || numbers[2].sign() <= 0) {
    throw InputError("", place,
                     numbers.size() != 3
                         ? "there are " + std::to_string(numbers.size()) + " numbers"
                         : "the squared radius of gyration is " + to_string(numbers[2]),
                     "give the centre of mass, x and y, and the squared radius of gyration "
                     "about it, above 0, as in 0,1/2,1/6");
  }
  return {{numbers[0], numbers[1]}, numbers[2]};
}

Inertia inertia_option(const std::string& option, const std::string& value) {
  return inertia_of(option, numbers_option(option, value));
}

}  // namespace stickslip
