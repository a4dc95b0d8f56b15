// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/mechanism.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {
namespace {

constexpr std::size_t kPlanarTwist = 3;
constexpr std::size_t kSpatialTwist = 6;

/// Returns the twist of a unit of turning or sliding.
RationalRow twist_of(const Link& link) {
  const RationalRow& g = link.axis;
  const RationalRow& c = link.at;
  if (link.slides) {
    RationalRow twist = g;
    twist.resize(g.size() == 2 ? kPlanarTwist : kSpatialTwist);
    return twist;
  }
  if (c.size() == 2) return {c[1], -c[0], 1};
  return {c[1] * g[2] - c[2] * g[1],
          c[2] * g[0] - c[0] * g[2],
          c[0] * g[1] - c[1] * g[0],
          g[0],
          g[1],
          g[2]};
}

Rational rate_of(const LinkRates& rates, std::size_t link) {
  Rational sum = 0;
  for (const auto& [body, rate] : rates) {
    if (body == link) sum += rate;
  }
  return sum;
}

}  // namespace

std::size_t Mechanism::coordinates() const {
  return joint_coordinate(joints.size());
}

std::size_t Mechanism::first_coordinate(std::size_t body) const {
  std::size_t first = 0;
  for (std::size_t b = 0; b < body; ++b) {
    if (!bodies[b].link) first += in_space ? kSpatialTwist : kPlanarTwist;
  }
  return first;
}

std::size_t Mechanism::joint_coordinate(std::size_t joint) const {
  return first_coordinate(bodies.size()) + joint;
}

std::vector<RationalRow> Mechanism::motion_of(BodyIndex body) const {
  const std::size_t rows = in_space ? kSpatialTwist : kPlanarTwist;
  std::vector<RationalRow> motion(rows, RationalRow(coordinates()));
  while (body && bodies.at(*body).link) {
    const Link& link = *bodies[*body].link;
    const RationalRow twist = twist_of(link);
    for (std::size_t q = 0; q < joints.size(); ++q) {
      const Rational rate = rate_of(joints[q].turns, *body);
      for (std::size_t k = 0; k < rows; ++k) motion[k][joint_coordinate(q)] += rate * twist[k];
    }
    body = link.on;
  }
  if (body) {
    for (std::size_t k = 0; k < rows; ++k) motion[k][first_coordinate(*body) + k] = 1;
  }
  return motion;
}

SparseRow Mechanism::load_on(BodyIndex body, const RationalRow& wrench) const {
  RationalRow on_joints(joints.size());
  while (body && bodies.at(*body).link) {
    const Link& link = *bodies[*body].link;
    const Rational work = dot(twist_of(link), wrench);
    for (std::size_t q = 0; q < joints.size(); ++q) {
      on_joints[q] += rate_of(joints[q].turns, *body) * work;
    }
    body = link.on;
  }
  SparseRow load;
  const auto add = [&](std::size_t coordinate, const Rational& entry) {
    if (!entry.is_zero()) load.emplace_back(coordinate, entry);
  };
  if (body) {
    const std::size_t first = first_coordinate(*body);
    for (std::size_t k = 0; k < wrench.size(); ++k) add(first + k, wrench[k]);
  }
  for (std::size_t q = 0; q < joints.size(); ++q) add(joint_coordinate(q), on_joints[q]);
  return load;
}

std::vector<RationalRow> Mechanism::motion_between(BodyIndex of, BodyIndex by) const {
  std::vector<RationalRow> motion = motion_of(of);
  const std::vector<RationalRow> other = motion_of(by);
  for (std::size_t k = 0; k < motion.size(); ++k) {
    for (std::size_t j = 0; j < motion[k].size(); ++j) motion[k][j] -= other[k][j];
  }
  return motion;
}

RationalRow Mechanism::row_of(const LinkRates& over) const {
  RationalRow row(coordinates());
  for (const auto& [link, arm] : over) {
    for (std::size_t q = 0; q < joints.size(); ++q) {
      row[joint_coordinate(q)] += arm * rate_of(joints[q].turns, link);
    }
  }
  return row;
}

std::string Mechanism::coordinate_name(std::size_t coordinate) const {
  static constexpr const char* kPlanarNames[] = {".x", ".y", ".turn"};
  static constexpr const char* kSpatialNames[] = {".x",      ".y",      ".z",
                                                  ".turn x", ".turn y", ".turn z"};
  const std::size_t joints_from = joint_coordinate(0);
  if (coordinate >= joints_from) {
    const Joint& joint = joints.at(coordinate - joints_from);
    return joint.name.empty() ? "joint " + std::to_string(coordinate - joints_from)
                              : joint.name;
  }
  std::size_t body = 0;
  while (bodies[body].link || first_coordinate(body + 1) <= coordinate) ++body;
  const std::size_t part = coordinate - first_coordinate(body);
  return bodies[body].name + (in_space ? kSpatialNames[part] : kPlanarNames[part]);
}

bool Mechanism::is_rotation(std::size_t coordinate) const {
  const std::size_t joints_from = joint_coordinate(0);
  if (coordinate < joints_from) {
    return in_space ? coordinate % kSpatialTwist >= 3 : coordinate % kPlanarTwist == 2;
  }
  for (const auto& [link, rate] : joints.at(coordinate - joints_from).turns) {
    if (!bodies[link].link->slides) return true;
  }
  return false;
}

std::vector<std::string> coordinate_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t j = 0; j < mechanism.coordinates(); ++j) {
    names.push_back(mechanism.coordinate_name(j));
  }
  return names;
}

RationalRow moved_by(const RationalRow& row, const std::vector<RationalRow>& motion) {
  if (motion.empty()) return row;
  RationalRow result(motion.front().size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k].is_zero()) continue;
    for (std::size_t j = 0; j < result.size(); ++j) result[j] += row[k] * motion[k][j];
  }
  return result;
}

const char* force_name(const Spring& spring) {
  return spring.is_ratchet()                   ? "preload"
         : spring.kind == Spring::Kind::kJoint ? "torque"
                                               : "tension";
}

std::string Mechanism::name_of(BodyIndex body) const {
  return body ? bodies.at(*body).name : "ground";
}

std::size_t Mechanism::body_named(const std::string& name, const std::string& path) const {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].name == name) return b;
  }
  std::vector<std::string> names;
  for (const Body& body : bodies) names.push_back(body.name);
  fail_at(path, "there is no body " + quote(name),
          choice_of(name, names, "the bodies before this place are "));
}

}  // namespace stickslip
