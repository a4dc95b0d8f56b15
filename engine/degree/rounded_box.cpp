// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounded_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stickslip {
namespace {

double between(const std::array<double, 2>& ends, double place) {
  return ends[0] + (1 + place) / 2 * (ends[1] - ends[0]);
}

/// Reads a place number by number, beginning with the one at `first`.
class Reader {
 public:
  Reader(const std::vector<ParameterId>& numbers, std::size_t first,
         const RoundedBox::Place& place)
      : numbers_(numbers), next_(first), place_(place) {}

  /// Returns the place of a parameter; nothing if the parameter is certain.
  std::optional<double> read(Parameter parameter, std::size_t index) {
    const bool is_next = next_ < numbers_.size() && numbers_[next_].parameter == parameter &&
                         numbers_[next_].index == index;
    if (!is_next) return std::nullopt;
    return place_[static_cast<Eigen::Index>(next_++)];
  }

 private:
  const std::vector<ParameterId>& numbers_;
  std::size_t next_;
  const RoundedBox::Place& place_;
};

}  // namespace

RoundedBox::RoundedBox(const GraspLaw& law)
    : law_(law),
      has_multiples_(law.is_family && law.multiples.high != law.multiples.low),
      first_(law.contacts.size() + 1) {
  std::size_t last = SIZE_MAX;
  for (const ParameterId& id : law.parameters()) {
    const bool is_load = id.parameter == Parameter::kWrench;
    const std::size_t owner = is_load ? law.contacts.size() : id.index;
    if (owner != last) first_[owner] = numbers_.size();
    last = owner;
    if (!law.interval(id).is_point()) numbers_.push_back(id);
  }
}

RoundedBox::Place RoundedBox::middle() const {
  const Place place =
      Place::Zero(static_cast<Eigen::Index>(numbers_.size() + (has_multiples_ ? 1 : 0)));
  if (!law_.ball) return place;
  const RationalRow nearest = law_.ball->nearest();
  return with_loads(place, [&](std::size_t component, double, double) {
    return to_double(nearest[component]);
  });
}

RoundedBox::Place RoundedBox::farthest(const Eigen::VectorXd& function) const {
  Place place = function.cwiseSign();
  // A normal in space is turned every way by no more than its slope.
  for (std::size_t n = 0; n + 1 < numbers_.size(); ++n) {
    if (numbers_[n].parameter != Parameter::kTurnU ||
        numbers_[n + 1].parameter != Parameter::kTurnV) {
      continue;
    }
    const auto turns = function.segment<2>(static_cast<Eigen::Index>(n));
    if (turns.norm() > 0) place.segment<2>(static_cast<Eigen::Index>(n)) = turns.normalized();
  }
  if (!law_.ball) return place;
  Eigen::VectorXd of_load =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(law_.ball->parts.size()));
  static_cast<void>(with_loads(function, [&](std::size_t component, double here, double half) {
    of_load[static_cast<Eigen::Index>(component)] = here / half;
    return 0;
  }));
  const Eigen::VectorXd z = law_.ball->farthest(of_load);
  return with_loads(place, [&](std::size_t component, double, double) {
    return z[static_cast<Eigen::Index>(component)];
  });
}

std::array<double, 2> RoundedBox::ends_of_part(std::size_t component) const {
  const Interval& part = law_.ball->parts[component];
  return {to_double(part.low), to_double(part.high)};
}

/// Returns the place with other components of a ball's z. Each is the function z of its index,
/// of its entry in the place, and of half the width of its part.
template <class Function>
RoundedBox::Place RoundedBox::with_loads(Place place, Function z) const {
  for (std::size_t n = first_.back(); n < numbers_.size(); ++n) {
    const std::size_t component = numbers_[n].index;
    const auto [low, high] = ends_of_part(component);
    double& at = place[static_cast<Eigen::Index>(n)];
    const double half = (high - low) / 2;
    at = (z(component, at, half) - (low + high) / 2) / half;
  }
  return place;
}

double RoundedBox::multiple_at(const Place& place) const {
  if (!law_.is_family) return 0;
  return between({to_double(law_.multiples.low), to_double(*law_.multiples.high)},
                 has_multiples_ ? place[place.size() - 1] : 0);
}

RoundedContact RoundedBox::contact_at(std::size_t contact, const Place& place) const {
  const LawContact& c = law_.contacts[contact];
  Reader reader(numbers_, first_[contact], place);
  std::vector<double> weights{1};  // weights of the corners
  for (const Parameter parameter : {Parameter::kX, Parameter::kY, Parameter::kTurn,
                                    Parameter::kZ, Parameter::kTurnU, Parameter::kTurnV}) {
    const auto at = reader.read(parameter, contact);
    if (!at) continue;
    const double upper = (1 + *at) / 2;
    const std::size_t half = weights.size();
    for (std::size_t k = 0; k < half; ++k) {
      weights.push_back(upper * weights[k]);
      weights[k] *= 1 - upper;
    }
  }
  const auto d = static_cast<Eigen::Index>(law_.motions);
  RoundedContact result{Reals::Zero(d),
                        SlipRows::Zero(static_cast<Eigen::Index>(c.slip_dimension()), d),
                        0,
                        0,
                        0,
                        c.size,
                        c.is_spring};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    result.normal += weights[k] * c.corners[k].normal_rounded;
    for (std::size_t r = 0; r < c.slip_dimension(); ++r) {
      result.slip.row(static_cast<Eigen::Index>(r)) +=
          weights[k] * c.corners[k].slip_rounded[r];
    }
  }
  result.slope = between(c.slopes, reader.read(Parameter::kFriction, contact).value_or(0));
  result.stiffness =
      between(c.stiffnesses, reader.read(Parameter::kStiffness, contact).value_or(0));
  const double preload = reader.read(Parameter::kPreload, contact).value_or(0);
  result.preload =
      between(c.preloads, preload) + multiple_at(place) * between(c.rates, preload);
  return result;
}

Reals RoundedBox::load_at(const Place& place) const {
  Reader reader(numbers_, first_.back(), place);
  if (law_.ball) {
    const auto n = static_cast<Eigen::Index>(law_.ball->parts.size());
    Eigen::VectorXd z(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto component = static_cast<std::size_t>(k);
      z[k] = between(ends_of_part(component),
                     reader.read(Parameter::kWrench, component).value_or(0));
    }
    Reals load = law_.ball->load(z);
    for (std::size_t j = 0; j < law_.motions; ++j) {
      load[static_cast<Eigen::Index>(j)] += law_.load[j][0];
    }
    return load;
  }
  Reals load(static_cast<Eigen::Index>(law_.motions));
  for (std::size_t j = 0; j < law_.motions; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    load[row] = between(law_.load[j], reader.read(Parameter::kWrench, j).value_or(0)) +
                multiple_at(place) * law_.growing[row];
  }
  return load;
}

RoundedGrasp RoundedBox::at(const Place& place) const {
  RoundedGrasp grasp{{}, load_at(place), law_.force, law_.reach, law_.rotates, law_.length};
  for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
    grasp.contacts.push_back(contact_at(i, place));
  }
  return grasp;
}

RoundedGrasp rounded_middle(const Law& law) {
  const auto d = static_cast<Eigen::Index>(law.motions);
  const auto middle = [](const std::array<double, 2>& ends) { return between(ends, 0); };
  const double multiple =
      law.is_family ? middle({to_double(law.multiples.low), to_double(*law.multiples.high)})
                    : 0;
  RoundedGrasp grasp{{}, multiple * law.growing, law.force, law.reach, law.rotates, law.length};
  for (Eigen::Index j = 0; j < d; ++j) {
    grasp.load[j] += middle(law.load[static_cast<std::size_t>(j)]);
  }
  grasp.contacts.reserve(law.contacts.size());
  for (const LawContact& c : law.contacts) {
    RoundedContact contact{Reals::Zero(d),
                           SlipRows::Zero(static_cast<Eigen::Index>(c.slip_dimension()), d),
                           middle(c.slopes),
                           middle(c.preloads) + multiple * middle(c.rates),
                           middle(c.stiffnesses),
                           c.size,
                           c.is_spring};
    const double weight = 1 / static_cast<double>(c.corners.size());
    for (const CornerRow& corner : c.corners) {
      contact.normal += weight * corner.normal_rounded;
      for (std::size_t r = 0; r < c.slip_dimension(); ++r) {
        contact.slip.row(static_cast<Eigen::Index>(r)) += weight * corner.slip_rounded[r];
      }
    }
    grasp.contacts.push_back(std::move(contact));
  }
  return grasp;
}

RoundedGrasp rounded_grasp(const Problem& problem) {
  const auto rounded = [](const Wrench& w) {
    return Eigen::Vector3d(to_double(w.x), to_double(w.y), to_double(w.torque));
  };
  RoundedGrasp grasp{{}, rounded(problem.wrench()), 0, 0, {0, 0, 1}, 0};
  grasp.contacts.reserve(problem.size());
  for (const ContactRow& row : problem.rows()) {
    const Eigen::Vector3d normal = rounded(row.normal);
    const Eigen::Vector3d tangent = rounded(row.tangent);
    grasp.contacts.push_back({normal, tangent.transpose(), to_double(row.friction),
                              to_double(row.preload), to_double(row.stiffness),
                              normal.head<2>().norm()});
    const double arm = std::max(std::fabs(normal[2]), std::fabs(tangent[2]));
    grasp.length = std::max(grasp.length, arm / normal.head<2>().norm());
  }
  if (!(grasp.length > 0) || !std::isfinite(grasp.length)) grasp.length = 1;
  grasp.load[2] /= grasp.length;
  grasp.force = grasp.load.lpNorm<Eigen::Infinity>();
  double stiffest = 0;
  for (RoundedContact& c : grasp.contacts) {
    c.normal[2] /= grasp.length;
    c.slip(0, 2) /= grasp.length;
    grasp.force = std::max(grasp.force, c.preload * c.size);
    stiffest = std::max(stiffest, c.stiffness * c.size * c.size);
  }
  if (!(grasp.force > 0) || !std::isfinite(grasp.force)) grasp.force = 1;
  grasp.reach = stiffest > 0 ? grasp.force / stiffest : 1;
  return grasp;
}

double Xorshift::next() {
  state_ ^= state_ << 13U;
  state_ ^= state_ >> 7U;
  state_ ^= state_ << 17U;
  return static_cast<double>(state_ >> 11U) / static_cast<double>(1ULL << 52U) - 1;
}

RoundedBox::Place RandomCorners::next() {
  RoundedBox::Place to = box_.middle();
  for (double& entry : to) entry = random_.next();
  return box_.farthest(to);
}

}  // namespace stickslip
