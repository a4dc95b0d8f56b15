// SPDX-License-Identifier: MIT
#include "leaf.hpp"

#include <algorithm>
#include <utility>

#include "slip_cone.hpp"

namespace stickslip_check {
namespace {

/// x, or the least multiple of a power of 2 above it that keeps its first 64 bits.
Rational short_above(const Rational& x) {
  constexpr std::size_t kBits = 64;
  const std::size_t num = mpz_sizeinbase(x.get_num_mpz_t(), 2);
  const std::size_t den = mpz_sizeinbase(x.get_den_mpz_t(), 2);
  if (den <= kBits) return x;
  const std::size_t shift = kBits + (den > num ? den - num : 0);
  Integer scaled = x.get_num() << shift;
  mpz_cdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), x.get_den_mpz_t());
  Rational result(scaled, Integer(1) << shift);
  result.canonicalize();
  return result;
}

/// U_s of FORMAT.md §4 as the largest of linear functions of (d, h, l), up to a factor: adds
/// them. `alpha` is alpha_s by corner.
void add_bounds(const Row& row, const std::vector<Integer>& alpha, std::vector<Form>& bounds) {
  // Corners are numbered in binary, sums of two corners, k, by the same digits in base 3.
  const std::size_t corners = alpha.size();
  std::vector<std::size_t> digits{0};
  for (std::size_t unit = 1; digits.size() < corners; unit *= 3) {
    const std::size_t half = digits.size();
    for (std::size_t c = 0; c < half; ++c) digits.push_back(digits[c] + unit);
  }
  for (const std::vector<Form>& pulls : row.pulls) {
    if (pulls.empty()) continue;
    const std::size_t dimension = pulls[0].size();
    std::vector<Form> sums(digits.back() * 2 + 1, Form(dimension + 1));
    std::vector<unsigned> pairs(sums.size());
    for (std::size_t c = 0; c < corners; ++c) {
      for (std::size_t other = 0; other < corners; ++other) {
        const std::size_t k = digits[c] + digits[other];
        for (std::size_t j = 0; j < dimension; ++j) sums[k][j] += alpha[c] * pulls[other][j];
        sums[k][dimension] += alpha[c];
        ++pairs[k];
      }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      // h and l are nowhere below 0, and the ends of both preloads go together.
      const Integer most = sums[k].back();
      const std::size_t end = most >= 0 ? 1 : 0;
      sums[k].back() *= row.preloads[end];
      sums[k].push_back(most * row.growths[end]);
      for (Integer& c : sums[k]) c *= static_cast<unsigned>(corners) / pairs[k];
      bounds.push_back(std::move(sums[k]));
    }
  }
}

/// The same for the product of the largest alpha_s and the largest v_i. (Of a margin there is
/// one alpha_s, so this is about verdicts, where nothing grows.)
void add_products(const Row& row, const std::vector<Integer>& alpha,
                  std::vector<Form>& bounds) {
  const Integer most =
      *std::max_element(alpha.begin(), alpha.end()) * static_cast<unsigned>(alpha.size());
  for (const std::vector<Form>& pulls : row.pulls) {
    for (const Form& pull : pulls) {
      Form product;
      for (const Integer& c : pull) product.emplace_back(most * c);
      product.emplace_back(most * row.preloads[1]);
      bounds.push_back(std::move(product));
    }
  }
}

/// factor max_k bounds_k.x, or if it is larger and the contact is mixed, 0.
struct Bend {
  Rational factor;
  std::vector<Form> bounds;
  bool mixed;
};

/// g of a leaf: linear terms, bends, and factor max(0, v.x) of certain contacts that are mixed.
struct Bound {
  Rational unit;
  Form linear;  ///< 1/unit times the linear terms
  std::vector<std::pair<Rational, const Form*>> kinks;
  std::vector<Bend> bends;
};

/// In the plane, of an uncertain contact with this sign.
void add_edges(const Row& row, int sign, bool mixed, const Form& y, const Rational& scale,
               Bound& bound) {
  Bend bend{scale * row.weight / static_cast<unsigned>(row.pulls[0].size()), {}, mixed};
  const std::size_t ends[]{sign < 0 ? 2U : 0U, sign > 0 ? 1U : 3U};
  for (const std::size_t s : ends) {
    std::vector<Integer> alpha;
    for (const Form& edge : row.edges[s]) alpha.push_back(dot(edge, y));
    const bool works = std::any_of(alpha.begin(), alpha.end(), [](auto& a) { return a > 0; });
    const bool resists = std::any_of(alpha.begin(), alpha.end(), [](auto& a) { return a < 0; });
    if (!mixed || (works && !resists)) add_bounds(row, alpha, bend.bounds);
    if (mixed && works && resists) add_products(row, alpha, bend.bounds);
  }
  if (!bend.bounds.empty()) bound.bends.push_back(std::move(bend));
}

/// In space, of an uncertain contact: the largest alpha v_i, or 0 if it is mixed.
void add_spatial(const Row& row, const Rational& alpha, bool mixed, Bound& bound) {
  const int sign = sgn(alpha);
  if (sign == 0 || (mixed && sign < 0)) return;
  Bend bend{abs(alpha) * row.weight, {}, mixed};
  for (const std::vector<Form>& pulls : row.pulls) {
    for (Form v : pulls) {
      // h and l are nowhere below 0, so v_i is largest with the largest preload.
      v.push_back(row.preloads[sign > 0 ? 1 : 0]);
      v.push_back(row.growths[sign > 0 ? 1 : 0]);
      bend.bounds.push_back(sign > 0 ? std::move(v) : negative(std::move(v)));
    }
  }
  bound.bends.push_back(std::move(bend));
}

/// In the plane, alpha_i of a contact without uncertainty.
Rational planar_alpha(const Row& row, const Generators& region, const Form& y,
                      const Rational& scale) {
  bool barred = false;
  const int slip = side(region, row.tau, &barred);
  const int sign = barred ? slip : 0;
  const Integer plus = dot(row.edges[0][0], y);
  const Integer minus = dot(row.edges[3][0], y);
  return scale * (sign > 0 || (sign == 0 && plus > minus) ? plus : minus);
}

/// The slips of a contact in a region: by corner, at each generator.
using Slips = std::vector<std::vector<Form>>;

/// As products take it.
Form slip_at(const std::vector<Form>& rows, const Form& x, const SlipProduct& product) {
  Form slip;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (j != product.left_out) slip.push_back(dot(rows[j], x));
  }
  return slip;
}

/// FORMAT.md §7, "moves", of a contact whose slip is not strict.
bool must_move(const Slips& slips, const SlipCone& cone, const Generators& region) {
  return std::all_of(slips.begin(), slips.end(), [&](const std::vector<Form>& at_corner) {
    Barring opposed(region);
    auto slip = at_corner.begin();
    for (const Generator& generator : region) {
      if (cone.contains(negative(*slip++))) opposed.add(generator);
    }
    return opposed.barred();
  });
}

/// In space, alpha_i.
Rational spatial_alpha(const Box& box, std::size_t i, const Generators& region, const Form& y,
                       const Rational& scale) {
  const Row& row = box.row(i);
  const Bounds& friction = box.contact(i)[Parameter::kFriction];
  const Vector& normal = box.contact(i).normal;
  SlipCone cone(row.product);
  bool moves = false;
  if (friction.high > 0) {
    Slips slips;
    for (const std::vector<Form>& rows : row.slips) {
      slips.emplace_back();
      for (const Generator& generator : region) {
        slips.back().push_back(slip_at(rows, *generator.x, row.product));
        cone.add(slips.back().back());
      }
    }
    moves = region.slips(i) || must_move(slips, cone, region);
  }
  std::optional<Rational> alpha;
  for (std::size_t c = 0; c < row.normals.size(); ++c) {
    const Form z = slip_at(row.slips[c], y, row.product);
    const Rational whole = row.product.square(z);
    const Rational square = moves ? cone.most_along(z) : whole;
    for (const Rational& mu : {friction.low, friction.high}) {
      const Rational factor = scale * row.scale * mu;
      const Rational cone_square = factor * factor * dot(normal, normal);
      Rational at_corner =
          scale * row.scale * dot(row.normals[c], y) + root_above(cone_square * square);
      if (row.tilt > 0) at_corner += row.tilt * 3 / 2 * root_above(cone_square * whole);
      if (!alpha || at_corner > *alpha) alpha = at_corner;
      if (friction.certain()) break;
    }
  }
  return *alpha;
}

/// g. It grows with every alpha_i but those of springs, whose v may be below 0; with `rounded`
/// each that it grows with is replaced by something shorter that is not smaller, so that
/// nothing is as good as it stands.
Bound work_bound(const Box& box, const Generators& region, const Vector& twist, bool rounded) {
  const std::size_t dimension = box.dimension();
  Rational scale;
  const Form y = make_form(twist, &scale);
  Bound bound;
  bound.bends.reserve(box.size());
  PairwiseSum terms;
  Vector work(box.coordinates());
  work[dimension] = box.load.work(twist).high;
  for (std::size_t k = 0; k < box.growths.size(); ++k) {
    work[dimension + 1 + k] = dot(twist, box.growths[k]);
  }
  terms.add(work);
  work.assign(work.size(), 0);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Row& row = box.row(i);
    const bool spring = is_spring(box.contact(i).sight);
    const int v_side = spring ? 1 : side(region, row.v);
    if (v_side < 0) continue;  // max(0, v_i) = 0
    if (row.has_edges() && !row.certain) {
      bool barred = false;
      const int slip = side(region, row.tau, &barred);
      add_edges(row, barred ? slip : 0, v_side == 0, y, scale, bound);
      continue;
    }
    const Rational alpha = row.has_edges() ? planar_alpha(row, region, y, scale)
                                           : spatial_alpha(box, i, region, y, scale);
    if (!row.certain) {
      add_spatial(row, alpha, v_side == 0, bound);
      continue;
    }
    const Rational exact = alpha * row.weight;
    const Rational factor = rounded && !spring ? short_above(exact) : exact;
    if (v_side > 0) {
      for (std::size_t j = 0; j < row.v[0].size(); ++j) work[j] = factor * row.v[0][j];
      terms.add(work);
    } else if (factor > 0) {
      bound.kinks.emplace_back(factor, &row.v[0]);
    }
  }
  bound.linear = make_form(terms.total(), &bound.unit);
  return bound;
}

Rational value_at(const Bound& bound, const Form& x, bool rounded) {
  Rational g = bound.unit * dot(bound.linear, x);
  for (const auto& [factor, v] : bound.kinks) {
    const Integer at = dot(*v, x);
    if (at > 0) g += factor * at;
  }
  for (const Bend& bend : bound.bends) {
    Integer most = dot(bend.bounds[0], x);
    for (const Form& f : bend.bounds) most = std::max(most, dot(f, x));
    if (bend.mixed && most <= 0) continue;
    const Rational exact = bend.factor * most;
    g += rounded ? short_above(exact) : exact;
  }
  return g;
}

/// `leaf-bound`: why it does not hold, or nothing.
std::optional<std::string> refusal(const Box& box, const Generators& region,
                                   const Vector& twist, bool rounded) {
  const Bound bound = work_bound(box, region, twist, rounded);
  Barring flat(region);  // where g = 0
  for (const Generator& generator : region) {
    const Form& x = *generator.x;
    const Rational g = value_at(bound, x, rounded);
    if (g > 0) return "g = " + show(g) + " at " + show(Vector(x.begin(), x.end()));
    if (g == 0) flat.add(generator);
    if (!flat.barred()) return "g = 0 on rays that are not barred together";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> leaf_refusal(const Box& box, const Generators& region,
                                        const Vector& y) {
  const auto found = refusal(box, region, y, true);
  return found ? refusal(box, region, y, false) : std::nullopt;
}

}  // namespace stickslip_check
