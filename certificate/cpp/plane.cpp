// SPDX-License-Identifier: MIT
#include "plane.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "answer.hpp"

namespace stickslip_check {
namespace {

/// `piece-mode`: why these points share no mode, or nothing. By contact: the signs that v has,
/// and where friction acts, those of the slip, and of each share by which it is an end.
std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<std::vector<ContactForce>>& points) {
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const auto found = [&](const char* what) {
      return "contact " + std::to_string(i) + ": " + what;
    };
    bool closed = false;
    bool open = false;
    bool slips[2]{};  // -, +
    for (const auto& forces : points) {
      closed = closed || forces[i].v > 0;
      open = open || forces[i].v < 0;
      const int slip = sgn(forces[i].slip[0]);
      if (slip != 0) slips[slip > 0 ? 1 : 0] = true;
    }
    if (closed && open) return found("v has opposite signs");
    const Bounds& friction = question.box->contact(i)[Parameter::kFriction];
    if (!closed || friction == Bounds(0) || (!slips[0] && !slips[1])) continue;
    if (slips[0] && slips[1]) return found("it slips both ways");
    const int edge = slips[1] ? -1 : 1;
    for (const auto& forces : points) {
      if (forces[i].v > 0 && forces[i].share[0] != edge) {
        return found("it slips at one point, and at another its friction has another share");
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Form load_part(const Form& x) {
  return {x[kPlanar], x[kPlanar + 1], x[kPlanar + 2]};
}

Piece::Piece(const std::vector<Witness>& points) {
  for (const Witness& point : points) faces_ = faces_.cut(load_part(make_form(point.x)));
}

bool Piece::contains(const Form& load) const {
  const auto& lines = faces_.lines();
  const auto& rays = faces_.rays();
  return std::all_of(lines.begin(), lines.end(),
                     [&](const Form& line) { return sign_of_dot(line, load) == 0; }) &&
         std::all_of(rays.begin(), rays.end(),
                     [&](const auto& ray) { return sign_of_dot(ray->x, load) >= 0; });
}

void Pieces::visit(const std::vector<Witness>& points) {
  const std::string place = "piece " + std::to_string(pieces_.size());
  std::vector<std::vector<ContactForce>> forces;
  for (const Witness& point : points) {
    try {
      forces.push_back(check_witness(question_, point, sum_));
    } catch (const Rejected& rejected) {
      throw Rejected{rejected.rule, std::nullopt,
                     place + ", point " + std::to_string(forces.size()), rejected.found};
    }
  }
  if (const auto refusal = mode_refusal(question_, forces)) {
    throw Rejected{"piece-mode", std::nullopt, place, *refusal};
  }
  pieces_.emplace_back(points);
}

}  // namespace stickslip_check
