// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/contact_states.hpp"

#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {
namespace {

constexpr double kPi = 3.14159265358979323846;

Rational squared_length(const RationalRow& v) {
  return dot(v, v);
}

/// Returns the square root of a number above 0, off by less than its 2000th part.
Rational near_root(const Rational& value) {
  // sqrt(p/q) = sqrt(p q s^2) / (q s), and s is so large that the root has 12 bits or more.
  const Integer q = denominator(value);
  Integer square = numerator(value) * q;
  square <<= 24;
  Integer root;
  mpz_sqrt(root.mutable_gmp(), square.gmp());
  Integer scale = q;
  scale <<= 12;
  return Rational(root, scale);
}

/// Returns the row of a force in direction v at the contact, as a function of motions.
Row row_at(const GraspBox& grasp, const UncertainContact& contact, const RationalRow& v) {
  const RationalRow wrench = wrench_at(contact.point(), v);
  if (!grasp.mechanism) return primitive_multiple(wrench);
  return primitive_multiple(
      moved_by(wrench, grasp.mechanism->motion_between(contact.of, contact.by)));
}

std::string text_of(const RationalRow& v) {
  return NumberText(true)(v);
}

/// Checks the directions that are given for a contact.
void check_lines(std::size_t contact, const UncertainContact& of,
                 const std::vector<RationalRow>& lines) {
  const std::string list = "directions[" + std::to_string(contact) + "]";
  if (lines.empty() || lines.size() > kMostSlipLines) {
    throw InputError("", list, "a contact has " + std::to_string(lines.size()) + " directions",
                     "give from 1 to " + std::to_string(kMostSlipLines));
  }
  for (std::size_t j = 0; j < lines.size(); ++j) {
    const RationalRow& v = lines[j];
    const std::string place = list + "[" + std::to_string(j) + "]";
    if (v.size() != of.normal.size()) {
      throw InputError("", place,
                       "a direction with " + std::to_string(v.size()) + " coordinates",
                       "give as many as the normal has, " + std::to_string(of.normal.size()));
    }
    if (squared_length(v).is_zero()) {
      throw InputError("", place, "a direction that is 0",
                       "give a direction across the normal");
    }
    const Rational along = dot(v, of.normal);
    if (!along.is_zero()) {
      RationalRow across = v;
      const Rational share = along / squared_length(of.normal);
      for (std::size_t i = 0; i < across.size(); ++i) across[i] -= share * of.normal[i];
      const bool is_zero = squared_length(across).is_zero();
      throw InputError("", place,
                       "the direction is not across the normal of contact " +
                           std::to_string(contact) + ", " + text_of(of.normal),
                       is_zero ? "give a direction with v.n = 0"
                               : "the nearest that is, is " + text_of(across));
    }
    for (std::size_t i = 0; i < j; ++i) {
      const Rational product = dot(v, lines[i]);
      if (product * product == squared_length(v) * squared_length(lines[i])) {
        throw InputError(
            "", place,
            "the direction is along the one in " + list + "[" + std::to_string(i) + "]",
            "leave out one: a line of slip has both directions");
      }
    }
  }
}

std::vector<RationalRow> lines_of(const GraspBox& grasp, std::size_t contact,
                                  const SlipLines& lines) {
  const UncertainContact& of = grasp.contacts[contact];
  if (lines.given) {
    check_lines(contact, of, (*lines.given)[contact]);
    return (*lines.given)[contact];
  }
  if (!grasp.in_space()) {
    if (lines.count > 1) {
      throw InputError("", "lines", "a contact in the plane has one line of slip, its tangent",
                       "ask for one");
    }
    return {{-of.normal.at(1), of.normal.at(0)}};
  }
  std::vector<RationalRow> result;
  try {
    for (const Vector3& v :
         default_slip_lines(of.normal, lines.count == 0 ? 2 : lines.count, lines.snap)) {
      result.emplace_back(v.begin(), v.end());
    }
  } catch (const InputError& error) {
    throw InputError(error.file(), error.place(),
                     "contact " + std::to_string(contact) + ": " + error.problem(),
                     error.remedy());
  }
  return result;
}

}  // namespace

std::vector<Vector3> default_slip_lines(const RationalRow& normal, std::size_t count,
                                        bool snap) {
  require(normal.size() == 3 && count > 0, "a normal in space, and a line or more");
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 3; ++j) {
    if (abs(normal[j]) < abs(normal[axis])) axis = j;
  }
  Vector3 e{};
  e[axis] = 1;
  const Vector3 n = vector3(normal);
  const Vector3 a = cross(n, e);
  const Vector3 b = cross(n, a);
  std::vector<Vector3> lines{a};
  if (count == 1) return lines;
  // b is |n| times as long as a, so that the direction at an angle is |n| cos a + sin b.
  const Rational square = squared_length(normal);
  const std::optional<Rational> length = exact_sqrt(square);
  const bool is_rational = count == 2 || (count == 4 && length);
  if (!is_rational && !snap) {
    throw InputError("", "lines",
                     std::to_string(count) +
                         " lines of slip have irrational directions across the normal " +
                         text_of(normal),
                     "take 2" + std::string(length ? " or 4" : "") +
                         ", snap them to rational directions nearby, or give directions");
  }
  const Rational scale = length ? *length : near_root(square);
  for (std::size_t j = 1; j < count; ++j) {
    if (2 * j == count) {
      lines.push_back(b);
      continue;
    }
    const double angle = kPi * static_cast<double>(j) / static_cast<double>(count);
    constexpr double kSteps = 512;
    const bool diagonal = 4 * j == count || 4 * j == 3 * count;
    const long side = std::lround(kSteps * std::cos(angle));
    const Rational cosine = diagonal ? Rational(side > 0 ? 1 : -1) : Rational(side);
    const Rational sine =
        diagonal ? Rational(1) : Rational(std::lround(kSteps * std::sin(angle)));
    Vector3 v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = cosine * scale * a[i] + sine * b[i];
    lines.push_back(std::move(v));
  }
  return lines;
}

std::size_t motion_coordinates(const GraspBox& grasp) {
  return grasp.mechanism ? grasp.mechanism->coordinates() : grasp.in_space() ? 6 : 3;
}

std::vector<std::vector<RationalRow>> slip_directions(const GraspBox& grasp,
                                                      const SlipLines& lines) {
  if (lines.given && lines.given->size() != grasp.contacts.size()) {
    throw InputError("", "directions",
                     "lists for " + std::to_string(lines.given->size()) + " contacts",
                     "give one for each of the " + std::to_string(grasp.contacts.size()) +
                         " contacts of the grasp");
  }
  std::vector<std::vector<RationalRow>> directions;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    directions.push_back(lines_of(grasp, i, lines));
  }
  return directions;
}

std::vector<ContactRows> contact_rows_for_states(const GraspBox& grasp,
                                                 const SlipLines& lines) {
  const std::vector<std::vector<RationalRow>> directions = slip_directions(grasp, lines);
  std::vector<ContactRows> rows;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    ContactRows contact;
    contact.normal = row_at(grasp, grasp.contacts[i], grasp.contacts[i].normal);
    for (const RationalRow& v : directions[i]) {
      contact.lines.push_back(row_at(grasp, grasp.contacts[i], v));
    }
    rows.push_back(std::move(contact));
  }
  return rows;
}

std::vector<std::string> slips_at(const GraspBox& grasp, const RationalRow& motion,
                                  const SlipLines& lines) {
  std::vector<std::string> slips;
  const Row multiple = primitive_multiple(motion);
  for (const ContactRows& rows : contact_rows_for_states(grasp, lines)) {
    std::string& slip = slips.emplace_back();
    for (const Row& line : rows.lines) slip += to_char(sign_of(dot(line, multiple)));
  }
  return slips;
}

std::string StatePlanes::text(const Face& face) const {
  std::string text;
  append_text(text, face);
  return text;
}

void StatePlanes::append_text(std::string& text, const Face& face) const {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i > 0) text += ' ';
    const Contact& contact = contacts[i];
    if (contact.normal) {
      const Sign sign = *face.sign(*contact.normal);
      if (set == StateSet::kFull) {
        text += to_char(sign);
        text += '|';
      } else if (sign != Sign::kZero) {
        text += 'o';
        continue;
      } else if (set == StateSet::kOpening) {
        text += 'c';
      }
    }
    for (const std::size_t line : contact.lines) text += to_char(*face.sign(line));
  }
}

StatePlanes state_planes(std::size_t coordinates, const std::vector<ContactRows>& contacts,
                         StateSet set) {
  if (coordinates > kMostFaceCoordinates) {
    throw InputError(
        "", "bodies", "motions have " + std::to_string(coordinates) + " coordinates",
        "states are enumerated of at most " + std::to_string(kMostFaceCoordinates) +
            ": two bodies in space, or four "
            "in the plane");
  }
  StatePlanes result;
  result.set = set;
  result.coordinates = coordinates;
  const auto add = [&](const Row& row, AllowedSigns side,
                       std::optional<std::size_t> where_zero) {
    result.planes.push_back({row, side, where_zero});
    return result.planes.size() - 1;
  };
  for (const ContactRows& rows : contacts) {
    StatePlanes::Contact contact;
    std::optional<std::size_t> owner;
    switch (set) {
      case StateSet::kSlip:
        break;
      case StateSet::kFull:
        contact.normal = add(rows.normal, AllowedSigns::kAny, {});
        break;
      case StateSet::kClosed:
        contact.normal = add(rows.normal, AllowedSigns::kZero, {});
        break;
      case StateSet::kOpening:
        contact.normal = add(rows.normal, AllowedSigns::kNotNegative, {});
        break;
      case StateSet::kContact:
        contact.normal = owner = add(rows.normal, AllowedSigns::kNotNegative, {});
        break;
    }
    if (set != StateSet::kOpening) {
      for (const Row& line : rows.lines)
        contact.lines.push_back(add(line, AllowedSigns::kAny, owner));
    }
    result.contacts.push_back(std::move(contact));
  }
  if (result.planes.size() > kMostFacePlanes) {
    throw InputError("", "contacts",
                     "the contacts have " + std::to_string(result.planes.size()) + " planes",
                     "states are enumerated of at most " + std::to_string(kMostFacePlanes) +
                         ": take fewer contacts or lines");
  }
  return result;
}

}  // namespace stickslip
