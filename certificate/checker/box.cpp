// SPDX-License-Identifier: MIT
#include "box.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

/// Positive multiples of `vectors`, all by one factor, without denominators; `*scale` undoes
/// it.
std::vector<Form> make_forms(const std::vector<Vector>& vectors, Rational* scale) {
  Vector all;
  for (const Vector& v : vectors) all.insert(all.end(), v.begin(), v.end());
  const Form form = make_form(all, scale);
  std::vector<Form> forms;
  auto next = form.begin();
  for (const Vector& v : vectors) {
    const auto end = next + static_cast<std::ptrdiff_t>(v.size());
    forms.emplace_back(next, end);
    next = end;
  }
  return forms;
}

void add_new(std::vector<Form>& forms, const Vector& v) {
  Form form = make_form(v);
  if (std::find(forms.begin(), forms.end(), form) == forms.end()) {
    forms.push_back(std::move(form));
  }
}

Vector moment_row(const Vector& p, const Vector& n) {
  return {n[0], n[1], Rational(p[0] * n[1] - p[1] * n[0])};
}

Vector ends(const Bounds& bounds) {
  return bounds.certain() ? Vector{bounds.low} : Vector{bounds.low, bounds.high};
}

/// N and T at the corners.
std::pair<std::vector<Vector>, std::vector<Vector>> rows_at_corners(const ContactBox& c) {
  std::vector<Vector> corners{{}};  // of p_x, p_y and e
  for (const Parameter name : {Parameter::kX, Parameter::kY, Parameter::kTurn}) {
    std::vector<Vector> longer;
    for (const Vector& corner : corners) {
      for (const Rational& end : ends(c[name])) {
        longer.push_back(corner);
        longer.back().push_back(end);
      }
    }
    corners = std::move(longer);
  }
  std::pair<std::vector<Vector>, std::vector<Vector>> rows;
  for (const Vector& corner : corners) {
    const Rational& e = corner[2];
    const Vector n{Rational(c.normal[0] - e * c.normal[1]),
                   Rational(c.normal[1] + e * c.normal[0])};
    rows.first.push_back(moment_row(corner, n));
    rows.second.push_back(moment_row(corner, {Rational(-n[1]), n[0]}));
  }
  return rows;
}

Vector edge(const Vector& normal, const Vector& tangent, const Rational& s) {
  Vector result;
  for (std::size_t j = 0; j < kDimension; ++j) {
    result.emplace_back(normal[j] + s * tangent[j]);
  }
  return result;
}

Vector multiple(const Rational& factor, const Vector& v) {
  Vector result;
  for (const Rational& c : v) result.emplace_back(factor * c);
  return result;
}

}  // namespace

std::shared_ptr<const Row> make_row(const ContactBox& c) {
  const auto [normals, tangents] = rows_at_corners(c);
  const Bounds& friction = c[Parameter::kFriction];
  const Bounds& preload = c[Parameter::kPreload];
  const Bounds& stiffness = c[Parameter::kStiffness];
  Row row;
  row.frictionless = friction == Bounds(0);
  row.certain = std::all_of(c.bounds.begin(), c.bounds.end(),
                            [](const Bounds& bounds) { return bounds.certain(); });
  for (const Vector& t : tangents) {
    add_new(row.slip, {t[0], t[1], t[2], 0, 0});
  }
  Vector v;
  for (const Vector& n : normals) {
    for (const Rational& k : ends(stiffness)) {
      for (const Rational& p : ends(preload)) {
        v = multiple(-k, n);
        v.insert(v.end(), {p, c.growth});
        add_new(row.v, v);
      }
    }
  }
  Rational v_scale;
  Rational edge_scale;
  if (row.certain) {
    const std::vector<Form> edges =
        make_forms({edge(normals[0], tangents[0], Rational(-friction.high)),
                    edge(normals[0], tangents[0], friction.high)},
                   &edge_scale);
    row.edges[0] = edges[0];
    row.edges[1] = edges[1];
    make_form(v, &v_scale);
  } else {
    std::vector<Vector> edges;
    for (const Rational& s :
         {Rational(-friction.high), Rational(-friction.low), friction.low, friction.high}) {
      for (std::size_t k = 0; k < normals.size(); ++k) {
        edges.push_back(edge(normals[k], tangents[k], s));
      }
    }
    std::vector<Vector> parts{{preload.low, preload.high}};
    for (const Vector& n : normals) parts.push_back(multiple(-stiffness.low, n));
    for (const Vector& n : normals) parts.push_back(multiple(-stiffness.high, n));
    const auto part_of = [&](const std::vector<Form>& forms, std::size_t begin) {
      const auto first = forms.begin() + static_cast<std::ptrdiff_t>(begin);
      return std::vector<Form>(first, first + static_cast<std::ptrdiff_t>(normals.size()));
    };
    const std::vector<Form> edge_forms = make_forms(edges, &edge_scale);
    for (std::size_t s = 0; s < 4; ++s) {
      row.corner_edges[s] = part_of(edge_forms, s * normals.size());
    }
    const std::vector<Form> forms = make_forms(parts, &v_scale);
    row.preloads[0] = forms[0][0];
    row.preloads[1] = forms[0][1];
    row.pulls[0] = part_of(forms, 1);
    if (!stiffness.certain()) row.pulls[1] = part_of(forms, 1 + normals.size());
  }
  row.weight = v_scale * edge_scale;
  return std::make_shared<const Row>(std::move(row));
}

const Bounds* Box::find(Parameter name, const Integer& index) const {
  const bool of_wrench = name == Parameter::kWrench;
  if (index >= (of_wrench ? wrench.size() : contacts.size())) return nullptr;
  return of_wrench ? &wrench[index.get_ui()] : &contacts[index.get_ui()][name];
}

Box Box::with(Parameter name, std::size_t index, Bounds bounds) const {
  Box part = *this;
  if (name == Parameter::kWrench) {
    part.wrench[index] = std::move(bounds);
  } else {
    part.contacts[index].bounds[static_cast<std::size_t>(name)] = std::move(bounds);
    part.rows[index] = make_row(part.contacts[index]);
  }
  return part;
}

Box Box::middle() const {
  const auto shrink = [](Bounds& bounds) { bounds = (bounds.low + bounds.high) / 2; };
  Box point = *this;
  for (Bounds& w : point.wrench) shrink(w);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (rows[i]->certain) continue;
    for (Bounds& bounds : point.contacts[i].bounds) shrink(bounds);
    point.rows[i] = make_row(point.contacts[i]);
  }
  return point;
}

}  // namespace stickslip_check
