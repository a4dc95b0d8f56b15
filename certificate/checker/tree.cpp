// SPDX-License-Identifier: MIT
#include "tree.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

constexpr std::size_t kCoordinates = kDimension + 2;  // of a point (d, h, l)
constexpr std::size_t kMoreDepth = 256;               // FORMAT.md `node-depth`

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

/// Whether `visit` is true of all generators of the cone: of a line as two rays, on which every
/// condition is zero, and which therefore take nothing away from a barred set.
template <typename Visit>
bool all_generators(const Cone& cone, Visit visit) {
  for (const Form& line : cone.lines()) {
    if (!visit(line, nullptr) || !visit(negative(line), nullptr)) return false;
  }
  return std::all_of(cone.rays().begin(), cone.rays().end(),
                     [&](const auto& ray) { return visit(ray->x, ray.get()); });
}

/// FORMAT.md "barred", of rays that are added one by one: the strict functions zero on all.
class Barring {
 public:
  explicit Barring(Set strict) : common_(std::move(strict)) {}
  void add(const Ray* ray) {
    if (ray != nullptr) common_ = intersection(common_, ray->zero);
  }
  bool barred() const {
    return std::any_of(common_.begin(), common_.end(), [](auto word) { return word != 0; });
  }

 private:
  Set common_;
};

/// 1 if all functions are >= 0 on all generators, else -1 if all are <= 0, else 0. `*barred` is
/// then whether for each of them the generators on which it is 0 are.
int side(const Cone& cone, const std::vector<Form>& functions, const Set& strict = {},
         bool* barred = nullptr) {
  std::vector<Barring> zeros(functions.size(), Barring(strict));
  bool possible[2]{true, true};
  all_generators(cone, [&](const Form& x, const Ray* ray) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const int sign = sign_of_dot(functions[k], x);
      if (sign < 0) possible[0] = false;
      if (sign > 0) possible[1] = false;
      if (sign == 0) zeros[k].add(ray);
    }
    return possible[0] || possible[1];
  });
  if (!possible[0] && !possible[1]) return 0;
  if (barred != nullptr) {
    *barred = std::all_of(zeros.begin(), zeros.end(), [](auto& zero) { return zero.barred(); });
  }
  return possible[0] ? 1 : -1;
}

/// U_s of FORMAT.md §6 as the largest of linear functions of (d, h), up to a factor: adds
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
    std::vector<Form> sums(digits.back() * 2 + 1, Form(kDimension + 1));
    std::vector<unsigned> pairs(sums.size());
    for (std::size_t c = 0; c < corners; ++c) {
      for (std::size_t other = 0; other < corners; ++other) {
        const std::size_t k = digits[c] + digits[other];
        for (std::size_t j = 0; j < kDimension; ++j) sums[k][j] += alpha[c] * pulls[other][j];
        sums[k][kDimension] += alpha[c];
        ++pairs[k];
      }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      Integer& last = sums[k].back();
      last *= row.preloads[last >= 0 ? 1 : 0];
      for (Integer& c : sums[k]) c *= static_cast<unsigned>(corners) / pairs[k];
      bounds.push_back(std::move(sums[k]));
    }
  }
}

/// The same for the product of the largest alpha_s and the largest v_i.
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

/// Of an uncertain contact with this sign.
void add_uncertain(const Row& row, int sign, bool mixed, const Form& y, const Rational& scale,
                   Bound& bound) {
  Bend bend{scale * row.weight / static_cast<unsigned>(row.pulls[0].size()), {}, mixed};
  const std::size_t ends[]{sign < 0 ? 2U : 0U, sign > 0 ? 1U : 3U};
  for (const std::size_t s : ends) {
    std::vector<Integer> alpha;
    for (const Form& edge : row.corner_edges[s]) alpha.push_back(dot(edge, y));
    const bool works = std::any_of(alpha.begin(), alpha.end(), [](auto& a) { return a > 0; });
    const bool resists = std::any_of(alpha.begin(), alpha.end(), [](auto& a) { return a < 0; });
    if (!mixed || (works && !resists)) add_bounds(row, alpha, bend.bounds);
    if (mixed && works && resists) add_products(row, alpha, bend.bounds);
  }
  if (!bend.bounds.empty()) bound.bends.push_back(std::move(bend));
}

/// The largest y.w.
Rational most_work(const Vector& y, const std::vector<Bounds>& wrench) {
  Rational work;
  for (std::size_t j = 0; j < kDimension; ++j) {
    work += y[j] * (y[j] > 0 ? wrench[j].high : wrench[j].low);
  }
  return work;
}

/// g. It grows with every alpha_i; with `rounded` each is replaced by something shorter that is
/// not smaller, so that nothing is as good as it stands.
Bound bound_of(const Box& box, const Cone& cone, const Set& strict, const Vector& twist,
               bool rounded) {
  Rational scale;
  const Form y = make_form(twist, &scale);
  Bound bound;
  PairwiseSum terms;
  Vector work(kCoordinates);
  work[kDimension] = most_work(twist, box.wrench);
  work[kDimension + 1] = dot(twist, box.growth);
  terms.add(work);
  for (const auto& pointer : box.rows) {
    const Row& row = *pointer;
    const int v_side = side(cone, row.v);
    if (v_side < 0) continue;  // max(0, v_i) = 0
    bool barred = false;
    const int slip = side(cone, row.slip, strict, &barred);
    const int sign = barred ? slip : 0;
    if (!row.certain) {
      add_uncertain(row, sign, v_side == 0, y, scale, bound);
      continue;
    }
    const Integer plus = dot(row.edges[0], y);
    const Integer minus = dot(row.edges[1], y);
    const Integer alpha = sign > 0 || (sign == 0 && plus > minus) ? plus : minus;
    const Rational exact = scale * row.weight * alpha;
    const Rational factor = rounded ? short_above(exact) : exact;
    if (v_side > 0) {
      for (std::size_t j = 0; j < kCoordinates; ++j) work[j] = factor * row.v[0][j];
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
std::optional<std::string> refusal(const Box& box, const Cone& cone, const Set& strict,
                                   const Vector& twist, bool rounded) {
  const Bound bound = bound_of(box, cone, strict, twist, rounded);
  Barring flat(strict);  // where g = 0
  std::optional<std::string> found;
  all_generators(cone, [&](const Form& x, const Ray* ray) {
    const Rational g = value_at(bound, x, rounded);
    if (g > 0) found = "g = " + show(g) + " at " + show(Vector(x.begin(), x.end()));
    if (g == 0) flat.add(ray);
    if (!flat.barred()) found = "g = 0 on rays that are not barred together";
    return !found;
  });
  return found;
}

/// A v_i or tau_i that a node splits, up to a positive factor.
const Form* certain_one(const std::vector<Form>& corners) {
  return corners.size() == 1 ? &corners[0] : nullptr;
}

}  // namespace

std::optional<std::string> leaf_refusal(const Box& box, const Cone& cone, const Set& strict,
                                        const Vector& y) {
  const auto found = refusal(box, cone, strict, y, true);
  return found ? refusal(box, cone, strict, y, false) : std::nullopt;
}

std::size_t most_depth(const Box& box) {
  return 2 * box.rows.size() + kMoreDepth;
}

Halves cut_in_two(const Box& box, const Node& part) {
  const Bounds* bounds = box.find(part.parameter, part.contact);
  const std::string name = kParameterNames[static_cast<std::size_t>(part.parameter)];
  if (bounds == nullptr) {
    throw Rejected{"part-contact", std::nullopt, "",
                   "there is no " + name + " " + show(Rational(part.contact))};
  }
  const Rational& c = part.numbers[0];
  if (c <= bounds->low || c >= bounds->high) {
    throw Rejected{
        "part-inside", std::nullopt, "",
        show(c) + " is not inside " + show(bounds->low) + " to " + show(bounds->high)};
  }
  const std::size_t index = part.contact.get_ui();
  const auto half = [&](const Rational& low, const Rational& high) {
    return std::make_shared<const Box>(box.with(part.parameter, index, Bounds(low, high)));
  };
  return {half(bounds->low, c), half(c, bounds->high)};
}

std::string half_name(const Node& part, bool high) {
  return std::string(kParameterNames[static_cast<std::size_t>(part.parameter)]) + " " +
         part.contact.get_str() + (high ? " high" : " low");
}

std::vector<Root> roots_of(const Question& question, const std::vector<Range>& ranges) {
  std::vector<Root> roots;
  for (const Range& range : ranges) {
    Root root{question.box, {}, question.asked.bilateral};
    root.conditions = {{{0, 0, 0, 1, 0}, false, true},
                       {{0, 0, 0, Rational(-range.low), 1}, false, range.open_low}};
    if (range.high) {
      root.conditions.push_back({{0, 0, 0, *range.high, -1}, false, range.open_high});
    }
    roots.push_back(std::move(root));
  }
  return roots;
}

TreeWalk::TreeWalk(std::vector<Root> roots, std::string place)
    : roots_(std::move(roots)), place_(std::move(place)) {}

void TreeWalk::visit(const Node& node) {
  if (stack_.empty() && trees_ == roots_.size()) {
    throw Rejected{"tree-long", nodes_, place_, "everything was complete before this node"};
  }
  Region region = stack_.empty() ? begin(roots_[trees_++]) : child();
  const std::size_t most = most_depth(*region.box);
  if (stack_.size() > most) {
    throw rejection("node-depth",
                    "more than " + std::to_string(most) + " nodes above this one");
  }
  std::optional<Rejected> rejected;
  if (node.kind != NodeKind::kLeaf) {
    push(node, std::move(region));
  } else {
    ++leaves_;
    try {
      check_leaf(region, node.numbers);
    } catch (const Rejected& leaf) {
      rejected = leaf;
    }
  }
  ++nodes_;
  while (!stack_.empty() && stack_.back().next == stack_.back().children) stack_.pop_back();
  if (rejected) throw Rejected(*rejected);
}

void TreeWalk::finish() const {
  if (trees_ < roots_.size() || !stack_.empty()) {
    throw Rejected{"tree-short", nodes_, path(1), "the list ends before this node"};
  }
}

TreeWalk::Region TreeWalk::begin(const Root& root) const {
  Region region{Cone(kCoordinates), {}, root.box};
  for (const Condition& condition : root.conditions) {
    if (condition.strict) insert(region.strict, region.cone.cuts());
    region.cone = region.cone.cut(make_form(condition.a), condition.equality);
  }
  if (root.bilateral) {
    for (const auto& row : root.box->rows) {
      if (const Form* v = certain_one(row->v)) region.cone = region.cone.cut(*v);
    }
  }
  return region;
}

/// The region of the child that the innermost node has come to.
TreeWalk::Region TreeWalk::child() {
  Frame& parent = stack_.back();
  const unsigned which = parent.next++;
  if (parent.node.kind == NodeKind::kPart) {
    return {parent.region.cone, parent.region.strict,
            which == 0 ? parent.halves.low : parent.halves.high};
  }
  const bool middle = parent.children == 3 && which == 1;
  Region region{which == 0 || middle ? parent.region.cone.cut(parent.cut, middle)
                                     : parent.region.cone.cut(negative(parent.cut)),
                parent.region.strict, parent.region.box};
  const bool strict = parent.children == 3 ? !middle : which == 1;
  if (strict) insert(region.strict, parent.region.cone.cuts());
  return region;
}

/// `leaf-bound`, `leaf-direction`.
void TreeWalk::check_leaf(const Region& region, const Vector& y) const {
  const Cone& cone = region.cone;
  Barring all(region.strict);
  for (const auto& ray : cone.rays()) all.add(ray.get());
  if (all.barred()) return;
  if (const auto found = leaf_refusal(*region.box, cone, region.strict, y)) {
    throw rejection("leaf-bound", *found);
  }
  const std::vector<Vector>& direction = roots_[trees_ - 1].direction;
  if (direction.empty()) return;
  Vector pull(kCoordinates);
  for (std::size_t j = 0; j < kDimension; ++j) {
    for (std::size_t k = 0; k < kCoordinates; ++k) pull[k] += y[j] * direction[j][k];
  }
  if (side(cone, {make_form(pull)}) <= 0) {
    throw rejection("leaf-direction", "y.A(d - h d0) is below 0 somewhere");
  }
}

void TreeWalk::push(const Node& node, Region region) {
  Frame frame{node, {}, {}, std::move(region), 2, 0};
  const Box& box = *frame.region.box;
  if (node.kind == NodeKind::kPlane) {
    frame.cut = make_form(node.numbers);
  } else if (node.kind == NodeKind::kPart) {
    try {
      frame.halves = cut_in_two(box, node);
    } catch (const Rejected& rejected) {
      throw rejection(rejected.rule.c_str(), rejected.found);
    }
  } else {
    if (node.contact >= box.rows.size()) {
      throw rejection("node-contact", "contact " + show(Rational(node.contact)) +
                                          ", but the grasp has " +
                                          std::to_string(box.rows.size()));
    }
    const Row& row = *box.rows[node.contact.get_ui()];
    const bool slip = node.kind == NodeKind::kSlip;
    const Form* cut = certain_one(slip ? row.slip : row.v);
    if (cut == nullptr) {
      throw rejection("node-certain", (slip ? "T of contact " : "v of contact ") +
                                          node.contact.get_str() + " is uncertain");
    }
    frame.cut = *cut;
    if (slip) frame.children = 3;
  }
  stack_.push_back(std::move(frame));
}

/// The path to the child that the innermost node has come to, or with `ahead` = 1 will come to.
std::string TreeWalk::path(unsigned ahead) const {
  const std::size_t begun = stack_.empty() ? trees_ + ahead : trees_;
  std::string result = roots_[begun - 1].path;
  for (const Frame& frame : stack_) {
    const unsigned child = frame.next - 1 + (&frame == &stack_.back() ? ahead : 0);
    const char* sign = child == 0 ? "+" : (frame.children == 3 && child == 1 ? "0" : "-");
    if (!result.empty()) result += ", ";
    if (frame.node.kind == NodeKind::kSlip) {
      result += "slip " + frame.node.contact.get_str() + " " + sign;
    } else if (frame.node.kind == NodeKind::kSeparation) {
      result +=
          "separation " + frame.node.contact.get_str() + (child == 0 ? " closed" : " open");
    } else if (frame.node.kind == NodeKind::kPart) {
      result += half_name(frame.node, child == 1);
    } else {
      result += std::string("plane ") + sign;
    }
  }
  return result.empty() ? "root" : result;
}

Rejected TreeWalk::rejection(const char* rule, std::string found) const {
  return {rule, nodes_, path(0), std::move(found)};
}

}  // namespace stickslip_check
