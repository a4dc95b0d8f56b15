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

/// 1 if f >= 0 on all generators, else -1 if f <= 0 on all, else 0. `zero` are those with f =
/// 0.
int side(const Cone& cone, const Form& f, Barring* zero = nullptr) {
  int found = 0;
  const bool one_sided = all_generators(cone, [&](const Form& x, const Ray* ray) {
    const int sign = sign_of_dot(f, x);
    if (sign != 0 && sign == -found) return false;
    if (sign != 0) found = sign;
    if (sign == 0 && zero != nullptr) zero->add(ray);
    return true;
  });
  if (!one_sided) return 0;
  return found == 0 ? 1 : found;
}

}  // namespace

TreeWalk::TreeWalk(const Question& question, std::vector<Range> ranges)
    : question_(question), ranges_(std::move(ranges)) {}

void TreeWalk::visit(const Node& node) {
  if (stack_.empty() && trees_ == ranges_.size()) {
    throw Rejected{"tree-long", nodes_, "", "everything was complete before this node"};
  }
  Region region = stack_.empty() ? root(ranges_[trees_++]) : child();
  const std::size_t most = 2 * question_.rows.size() + kMoreDepth;
  if (stack_.size() > most) {
    throw rejection("node-depth",
                    "more than " + std::to_string(most) + " nodes above this one");
  }
  std::optional<Rejected> rejected;
  if (node.kind != NodeKind::kLeaf) {
    push(node, std::move(region));
  } else {
    ++leaves_;
    std::optional<std::string> found = refusal(region, node.numbers, true);
    if (found) found = refusal(region, node.numbers, false);
    if (found) rejected = rejection("leaf-bound", *found);
  }
  ++nodes_;
  while (!stack_.empty() && stack_.back().next == stack_.back().children) stack_.pop_back();
  if (rejected) throw Rejected(*rejected);
}

void TreeWalk::finish() const {
  if (trees_ < ranges_.size() || !stack_.empty()) {
    throw Rejected{"tree-short", nodes_, path(1), "the list ends before this node"};
  }
}

/// The region {h >= 0, low h <= l <= high h}, and the bilateral law's conditions.
TreeWalk::Region TreeWalk::root(const Range& range) const {
  Region region{Cone(kCoordinates), {}};
  const auto cut = [&](Vector a, bool strict) {
    if (strict) insert(region.strict, region.cone.cuts());
    a.insert(a.begin(), kDimension, 0);
    region.cone = region.cone.cut(make_form(a));
  };
  cut({1, 0}, true);
  cut({Rational(-range.low), 1}, range.open_low);
  if (range.high) cut({*range.high, -1}, range.open_high);
  if (question_.asked.bilateral) {
    for (const Row& row : question_.rows) region.cone = region.cone.cut(row.v_form);
  }
  return region;
}

/// The region of the child that the innermost node has come to.
TreeWalk::Region TreeWalk::child() {
  Frame& parent = stack_.back();
  const unsigned which = parent.next++;
  const bool middle = parent.children == 3 && which == 1;
  Region region{which == 0 || middle ? parent.region.cone.cut(parent.cut, middle)
                                     : parent.region.cone.cut(negative(parent.cut)),
                parent.region.strict};
  const bool strict = parent.children == 3 ? !middle : which == 1;
  if (strict) insert(region.strict, parent.region.cone.cuts());
  return region;
}

/// `leaf-bound`: why it does not hold, or nothing. g grows with every alpha_i; with `rounded`
/// each is replaced by something shorter that is not smaller, so that nothing is as good as it
/// stands.
std::optional<std::string> TreeWalk::refusal(const Region& region, const Vector& twist,
                                             bool rounded) const {
  Barring all(region.strict);
  for (const auto& ray : region.cone.rays()) all.add(ray.get());
  if (all.barred()) return std::nullopt;

  Rational scale;
  const Form y = make_form(twist, &scale);
  // g is the sum of linear terms and of `bends`, factor max(0, v.x).
  PairwiseSum terms;
  Vector work(kCoordinates);
  work[kDimension] = dot(twist, question_.wrench);
  work[kDimension + 1] = dot(twist, question_.growth);
  terms.add(work);
  std::vector<std::pair<Rational, const Form*>> bends;
  for (const Row& row : question_.rows) {
    const int v_side = side(region.cone, row.v_form);
    if (v_side < 0) continue;  // max(0, v_i) = 0
    Barring zero(region.strict);
    const int slip = side(region.cone, row.slip_form, &zero);
    const int sign = zero.barred() ? slip : 0;
    const Integer plus = dot(row.edges[0], y);
    const Integer minus = dot(row.edges[1], y);
    const Integer alpha = sign > 0 || (sign == 0 && plus > minus) ? plus : minus;
    const Rational exact = scale * row.weight * alpha;
    const Rational factor = rounded ? short_above(exact) : exact;
    if (v_side > 0) {
      for (std::size_t j = 0; j < kCoordinates; ++j) work[j] = factor * row.v_form[j];
      terms.add(work);
    } else if (factor > 0) {
      bends.emplace_back(factor, &row.v_form);
    }
  }
  Rational unit;  // g = unit (linear.x) but for the bends
  const Form linear = make_form(terms.total(), &unit);
  Barring flat(region.strict);  // where g = 0
  std::optional<std::string> found;
  all_generators(region.cone, [&](const Form& x, const Ray* ray) {
    Rational g = unit * dot(linear, x);
    for (const auto& [factor, v] : bends) {
      const Integer at = dot(*v, x);
      if (at > 0) g += factor * at;
    }
    if (g > 0) found = "g = " + show(g) + " at " + show(Vector(x.begin(), x.end()));
    if (g == 0) flat.add(ray);
    if (!flat.barred()) found = "g = 0 on rays that are not barred together";
    return !found;
  });
  return found;
}

void TreeWalk::push(const Node& node, Region region) {
  Frame frame{node.kind, 0, {}, std::move(region), 2, 0};
  if (node.kind == NodeKind::kPlane) {
    frame.cut = make_form(node.numbers);
  } else {
    if (node.contact >= question_.rows.size()) {
      throw rejection("node-contact", "contact " + show(Rational(node.contact)) +
                                          ", but the grasp has " +
                                          std::to_string(question_.rows.size()));
    }
    frame.contact = node.contact.get_ui();
    const Row& row = question_.rows[frame.contact];
    const bool slip = node.kind == NodeKind::kSlip;
    frame.cut = slip ? row.slip_form : row.v_form;
    if (slip) frame.children = 3;
  }
  stack_.push_back(std::move(frame));
}

/// The path to the child that the innermost node has come to, or with `ahead` = 1 will come to.
std::string TreeWalk::path(unsigned ahead) const {
  std::string result;
  for (const Frame& frame : stack_) {
    const unsigned child = frame.next - 1 + (&frame == &stack_.back() ? ahead : 0);
    const std::string contact = std::to_string(frame.contact);
    const char* sign = child == 0 ? "+" : (frame.children == 3 && child == 1 ? "0" : "-");
    if (!result.empty()) result += ", ";
    if (frame.kind == NodeKind::kSlip) {
      result += "slip " + contact + " " + sign;
    } else if (frame.kind == NodeKind::kSeparation) {
      result += "separation " + contact + (child == 0 ? " closed" : " open");
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
