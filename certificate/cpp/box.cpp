// SPDX-License-Identifier: MIT
#include "box.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

void add_new(std::vector<Form>& forms, const Vector& v) {
  Form form = make_form(v);
  if (std::find(forms.begin(), forms.end(), form) == forms.end()) {
    forms.push_back(std::move(form));
  }
}

Vector ends(const Bounds& bounds) {
  return bounds.certain() ? Vector{bounds.low} : Vector{bounds.low, bounds.high};
}

Vector multiple(const Rational& factor, const Vector& v) {
  Vector result;
  for (const Rational& c : v) result.emplace_back(factor * c);
  return result;
}

constexpr std::size_t kGeometry = 6;  ///< parameters of the position and the turns

/// These parameters, the box of which has these corners.
std::vector<Vector> corners_of(const ContactBox& c) {
  std::vector<Vector> corners{{}};
  for (std::size_t k = 0; k < kGeometry; ++k) {
    const auto name = static_cast<Parameter>(k);
    std::vector<Vector> longer;
    for (const Vector& corner : corners) {
      for (const Rational& end : ends(c[name])) {
        longer.push_back(corner);
        longer.back().push_back(end);
      }
    }
    corners = std::move(longer);
  }
  return corners;
}

/// N and the rows of the slip at the corners: directions across n, taken to the point.
struct Functions {
  std::vector<Vector> normals;
  std::vector<Vector> slips;  ///< of all corners, one after another
  Rational tilt;
};

/// n at a corner.
Vector normal_at(const ContactBox& c, const Vector& corner) {
  const bool in_space = c.normal.size() == 3;
  auto e = corner.begin() +
           static_cast<std::ptrdiff_t>(in_space ? Parameter::kTurnU : Parameter::kTurn);
  Vector n = c.normal;
  for (const Turn& turn : turns_of(c.normal, 0)) {
    for (std::size_t j = 0; j < n.size(); ++j) n[j] += *e * turn.way[j];
    ++e;
  }
  return n;
}

Functions functions_of(const ContactBox& c) {
  if (!is_contact(c.sight)) {
    Vector normal = seen(c.sight, {1});
    Vector slip(normal.size());
    return {{std::move(normal)}, {std::move(slip)}, 0};
  }
  Functions rows;
  for (Vector p : corners_of(c)) {
    const Vector n = normal_at(c, p);
    std::vector<Vector> across;
    if (n.size() == 2) {
      across = {{Rational(-n[1]), n[0]}};
    } else {
      const Rational square = dot(c.normal, c.normal);
      for (std::size_t j = 0; j < 3; ++j) {
        across.push_back(multiple(-n[j] / square, c.normal));
        across.back()[j] += 1;
      }
      rows.tilt = std::max(rows.tilt, Rational(dot(n, n) / square - 1));
    }
    p.resize(n.size());
    rows.normals.push_back(seen(c.sight, at_point(p, n)));
    for (const Vector& t : across) rows.slips.push_back(seen(c.sight, at_point(p, t)));
    if (c.gamma != 0) rows.slips.push_back(seen(c.sight, {0, 0, 0, n[0], n[1], n[2]}));
  }
  return rows;
}

/// What only signs of slip need: tau_i, and the edges of the friction cone.
void add_edges(const Functions& at, const Bounds& friction, Row& row) {
  Rational edge_scale;
  for (Vector t : at.slips) {
    t.resize(t.size() + 2);
    add_new(row.tau, t);
  }
  const Rational ends[]{Rational(-friction.high), Rational(-friction.low), friction.low,
                        friction.high};
  std::vector<Vector> edges;
  for (std::size_t s = 0; s < 4; ++s) {
    for (std::size_t k = 0; k < at.normals.size(); ++k) {
      edges.push_back(at.normals[k]);
      Vector& edge = edges.back();
      for (std::size_t j = 0; j < edge.size(); ++j) edge[j] += ends[s] * at.slips[k][j];
    }
  }
  const std::vector<Form> forms = make_forms(edges, &edge_scale);
  for (std::size_t k = 0; k < forms.size(); ++k) {
    row.edges[k / at.normals.size()].push_back(forms[k]);
  }
  row.weight *= edge_scale;
}

/// P' and P^u': in a margin both are multiples of one number, 1/L.
std::vector<Vector> preload_ends(const ContactBox& c) {
  const Bounds& preload = c[Parameter::kPreload];
  std::vector<Vector> ends{{preload.low, c.growth.low}};
  if (!preload.certain() || !c.growth.certain()) ends.push_back({preload.high, c.growth.high});
  return ends;
}

/// v_i at each corner as a pull, a preload and its growth, all by one factor.
void add_pulls(const Functions& at, const ContactBox& c, Row& row) {
  const std::vector<Vector> loads = preload_ends(c);
  std::vector<Vector> parts{loads.front(), loads.back()};
  for (const Rational& k : ends(c[Parameter::kStiffness])) {
    for (const Vector& n : at.normals) parts.push_back(multiple(-k, n));
  }
  const std::vector<Form> forms = make_forms(parts, &row.weight);
  for (std::size_t end = 0; end < 2; ++end) {
    row.preloads[end] = forms[end][0];
    row.growths[end] = forms[end][1];
  }
  for (std::size_t k = 0; k + 2 < forms.size(); ++k) {
    row.pulls[k / at.normals.size()].push_back(forms[k + 2]);
  }
}

Integer whole(const Rational& x, const Integer& den) {
  return x.get_num() * (den / x.get_den());
}

/// One body in the plane, without uncertainty: what make_row says, in integers.
Row make_point_row(const ContactBox& c) {
  Rational length;
  const Vector& straight = c.normal;
  const Rational& turn = c[Parameter::kTurn].low;
  const Form n = make_form(
      {Rational(straight[0] - turn * straight[1]), Rational(straight[1] + turn * straight[0])},
      &length);
  const Rational& x = c[Parameter::kX].low;
  const Rational& y = c[Parameter::kY].low;
  const Integer den = lcm(x.get_den(), y.get_den());
  const Integer px = whole(x, den);
  const Integer py = whole(y, den);
  Form both{den * n[0],  den * n[1], px * n[1] - py * n[0],   // N
            -den * n[1], den * n[0], px * n[0] + py * n[1]};  // T
  Row row;
  row.scale = length * make_primitive(both) / den;
  const auto middle = both.begin() + kPlanar;
  row.normals.emplace_back(both.begin(), middle);
  row.slips.push_back({Form(middle, both.end())});
  const Form& normal = row.normals[0];
  const Form& slip = row.slips[0][0];

  row.tau = {slip};
  row.tau[0].resize(kPlanar + 2);
  make_primitive(row.tau[0]);

  const Rational& friction = c[Parameter::kFriction].low;
  for (std::size_t j = 0; j < kPlanar; ++j) {
    const Integer along = friction.get_num() * slip[j];
    both[j] = friction.get_den() * normal[j];
    both[j + kPlanar] = both[j] + along;
    both[j] -= along;
  }
  row.weight = row.scale * make_primitive(both) / friction.get_den();
  row.edges[0].emplace_back(both.begin(), middle);
  row.edges[3].emplace_back(middle, both.end());

  const Rational& preload = c[Parameter::kPreload].low;
  const Rational& growth = c.growth.low;
  const Rational pull = c[Parameter::kStiffness].low * row.scale;
  const Integer all = lcm(Integer(lcm(pull.get_den(), preload.get_den())), growth.get_den());
  const Integer times = -whole(pull, all);
  Form v;
  for (const Integer& entry : normal) v.emplace_back(times * entry);
  v.push_back(whole(preload, all));
  v.push_back(whole(growth, all));
  row.v_scale = Rational(make_primitive(v)) / all;
  row.v.push_back(std::move(v));
  row.weight *= row.v_scale;
  return row;
}

Row make_row(const ContactBox& c) {
  const bool certain =
      c.growth.certain() && std::all_of(c.bounds.begin(), c.bounds.end(),
                                        [](const Bounds& bounds) { return bounds.certain(); });
  if (certain && c.normal.size() == 2 && !c.sight) return make_point_row(c);
  const Functions at = functions_of(c);
  Row row;
  row.certain = certain;
  row.tilt = at.tilt;
  const std::size_t corners = at.normals.size();
  const std::vector<Vector> loads = preload_ends(c);
  const auto same = [](const std::vector<Vector>& vectors) {
    return vectors == std::vector<Vector>(vectors.size(), vectors[0]);
  };
  row.slip_certain = c.normal.size() == 3 ? corners == 1 : same(at.slips);
  row.v_certain =
      same(at.normals) && (loads == std::vector<Vector>{Vector(2)} ||
                           (loads.size() == 1 && c[Parameter::kStiffness].certain()));
  std::vector<Vector> all = at.normals;
  all.insert(all.end(), at.slips.begin(), at.slips.end());
  const std::vector<Form> forms = make_forms(all, &row.scale);
  row.slips.resize(corners);
  for (std::size_t k = 0; k < forms.size(); ++k) {
    if (k < corners) {
      row.normals.push_back(forms[k]);
    } else {
      row.slips[(k - corners) / (at.slips.size() / corners)].push_back(forms[k]);
    }
  }
  for (const Vector& n : at.normals) {
    for (const Rational& k : ends(c[Parameter::kStiffness])) {
      for (const Vector& load : loads) {
        Vector v = multiple(-k, n);
        v.insert(v.end(), load.begin(), load.end());
        if (row.v.empty()) make_form(v, &row.v_scale);
        add_new(row.v, v);
      }
    }
  }
  row.weight = row.v_scale;
  if (!row.certain) add_pulls(at, c, row);
  if (row.has_edges()) {
    add_edges(at, c[Parameter::kFriction], row);
  } else {
    row.product = SlipProduct(c.normal, c.gamma);
  }
  return row;
}

}  // namespace

std::vector<Turn> turns_of(const Vector& normal, const Rational& slope) {
  if (normal.empty()) return {};
  if (normal.size() == 2) return {{{Rational(-normal[1]), normal[0]}, slope}};
  std::size_t least = 0;
  for (std::size_t j = 1; j < 3; ++j) {
    if (abs(normal[j]) < abs(normal[least])) least = j;
  }
  Vector axis(3);
  axis[least] = 1;
  Vector way = std::move(axis);
  std::vector<Turn> turns;
  for (std::size_t k = 0; k < 2; ++k) {
    way = cross(normal, way);
    turns.push_back({way, 0});
    if (slope == 0) continue;
    const Rational square = slope * slope * dot(normal, normal) / dot(way, way);
    turns.back().most = root_above(square);
  }
  return turns;
}

Vector conjugate(const ContactBox& contact, Vector s) {
  if (contact.gamma != 0) s.back() *= contact.gamma;
  return s;
}

Rational friction_square(const ContactBox& contact, const Vector& f) {
  Rational square = dot(f, f);
  if (contact.gamma != 0) square += f.back() * f.back() * (1 / contact.gamma - 1);
  return square;
}

BoxContact::BoxContact(ContactBox contact) : box(std::move(contact)), row(make_row(box)) {}

Box::Box(std::size_t size, Maker make, bool certain) : make_(std::move(make)), contacts_(size) {
  for (std::size_t i = 0; i < size && !certain; ++i) made(i);
}

std::shared_ptr<const BoxContact> Box::passing(std::size_t i) const {
  return contacts_[i] ? contacts_[i] : std::make_shared<const BoxContact>(make_(i));
}

const BoxContact& Box::made(std::size_t i) const {
  contacts_[i] = passing(i);
  return *contacts_[i];
}

bool Box::certain() const {
  return std::all_of(contacts_.begin(), contacts_.end(),
                     [](const auto& contact) { return !contact || contact->row.certain; }) &&
         load.certain();
}

const Bounds* Box::find(Parameter name, const Integer& index) const {
  const bool of_load = name == Parameter::kWrench;
  if (index >= (of_load ? load.numbers().size() : size())) return nullptr;
  if (of_load) return &load.numbers()[index.get_ui()];
  const ContactBox& c = contact(index.get_ui());
  const bool of_all = name == Parameter::kPreload || name == Parameter::kStiffness;
  return of_all || is_contact(c.sight) ? &c[name] : nullptr;
}

Box Box::with(Parameter name, std::size_t index, Bounds bounds) const {
  Box part = *this;
  if (name == Parameter::kWrench) {
    part.load = load.with(index, std::move(bounds));
  } else {
    ContactBox changed = contact(index);
    changed.bounds[static_cast<std::size_t>(name)] = std::move(bounds);
    part.contacts_[index] = std::make_shared<const BoxContact>(std::move(changed));
  }
  return part;
}

Box Box::middle() const {
  const auto shrink = [](Bounds& bounds) { bounds = (bounds.low + bounds.high) / 2; };
  Box point = *this;
  point.load = load.middle();
  for (auto& contact : point.contacts_) {
    if (!contact || contact->row.certain) continue;
    ContactBox changed = contact->box;
    for (Bounds& bounds : changed.bounds) shrink(bounds);
    shrink(changed.growth);
    contact = std::make_shared<const BoxContact>(std::move(changed));
  }
  return point;
}

Box Box::without(const std::vector<std::size_t>& contacts) const {
  Box rest = *this;
  rest.contacts_.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    if (std::binary_search(contacts.begin(), contacts.end(), i)) continue;
    made(i);
    rest.contacts_.push_back(contacts_[i]);
  }
  return rest;
}

}  // namespace stickslip_check
