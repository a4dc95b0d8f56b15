// SPDX-License-Identifier: MIT
#include "moving.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "enclosure.hpp"
#include "work.hpp"

namespace stickslip_check {
namespace {

// One text computes with Rational or with Enclosure. An enclosure that has numbers of both
// signs has no sign.

Rational larger(const Rational& a, const Rational& b) {
  return std::max(a, b);
}

Rational smaller(const Rational& a, const Rational& b) {
  return std::min(a, b);
}

/// "The bound" of a times the root of a square.
Rational times_root_above(const Rational& a, const Rational& square) {
  return root_above(Rational(a * abs(a) * square));
}

std::optional<int> sign_of(const Rational& a) {
  return sgn(a);
}

std::optional<int> sign_of(const Enclosure& a) {
  if (a.low() <= 0 && a.high() >= 0) return std::nullopt;
  return a.low() > 0 ? 1 : -1;
}

bool may_be_above(const Rational& a) {
  return a > 0;
}

bool may_be_above(const Enclosure& a) {
  return a.high() > 0;
}

/// Counts so many operations with it.
void count(const Rational& a, std::uint64_t operations) {
  const std::uint64_t words = mpz_size(a.get_num_mpz_t()) + mpz_size(a.get_den_mpz_t());
  spend(kStepsOfRational * operations);
  spend(4 * operations, words, words);  // numerators, denominators and what they have in common
}

void count(const Enclosure&, std::uint64_t operations) {
  spend(operations);
}

/// A generator as it is, or a positive multiple of it.
template <typename Number>
std::vector<Number> generator_of(const Form& x, long* halvings);

template <>
std::vector<Rational> generator_of(const Form& x, long* halvings) {
  *halvings = 0;
  return std::vector<Rational>(x.begin(), x.end());
}

/// Over a power of 2, so that its largest number is near 1.
template <>
std::vector<Enclosure> generator_of(const Form& x, long* halvings) {
  std::size_t most = 0;
  for (const Integer& c : x) most = std::max(most, mpz_sizeinbase(c.get_mpz_t(), 2));
  *halvings = static_cast<long>(most);
  std::vector<Enclosure> result;
  for (const Integer& c : x) result.emplace_back(c, *halvings);
  return result;
}

template <typename Number>
std::vector<Number> multiple(const Rational& factor, const Form& form) {
  const Number times(factor);
  std::vector<Number> result;
  for (const Integer& c : form) result.emplace_back(times * Number(c));
  return result;
}

/// The sum of products of as many numbers as the shorter one has.
Rational product(const Vector& a, const Vector& b) {
  Rational sum;
  const std::size_t size = std::min(a.size(), b.size());
  for (std::size_t j = 0; j < size; ++j) sum += a[j] * b[j];
  return sum;
}

/// That, and counts it.
template <typename Number>
Number counted_product(const std::vector<Number>& a, const std::vector<Number>& b) {
  const Number sum = product(a, b);
  count(sum, std::min(a.size(), b.size()));
  return sum;
}

/// B(r, r') of a leaf.
template <typename Number>
class PairBound {
 public:
  PairBound(const Box& box, const Generators& region, const MovingTwist& twist);

  /// 2 B of two generators, by their numbers, times something positive.
  Number twice(std::size_t r, std::size_t s) const;

 private:
  struct Ray {
    std::vector<Number> x;
    Number h;
    Number load;  ///< Lambda(y(r))
  };
  /// A contact at a ray.
  struct Work {
    Number low;   ///< v_min(r)
    Number high;  ///< v_max(r)
    Number most;  ///< A(r)
  };
  /// A contact at a corner: N and S, and what they make of y.
  struct Corner {
    std::vector<Number> normal;
    std::vector<std::vector<Number>> slip;
    Number work;
    std::vector<Number> motion;
  };
  /// The other numbers that the bound of friction takes.
  struct Friction {
    Number low;  ///< mu
    Number high;
    Number square;                ///< L^2, and in the plane 1
    std::vector<Number> weights;  ///< of the product of slips
    Number own;                   ///< c - kappa
    std::vector<Number> psi;      ///< psi*; empty if the contact is not listed
    Number stretch;               ///< 1 + delta/2
  };
  struct Contact {
    bool mixed;  ///< else it is closed
    std::vector<Work> at;
  };

  std::vector<Work> work_of(const BoxContact& contact, const OwnSlip* own) const;
  Corner corner_of(const Row& row, std::size_t c, bool rubs) const;
  Friction friction_of(const BoxContact& contact, const OwnSlip* own) const;
  Number most_friction(const Friction& friction, const Corner& corner, const Ray& ray) const;
  static int side_of(const Row& row, const std::vector<Work>& at, const Generators& region);

  const MovingTwist& twist_;
  std::vector<Number> y_;
  Number c_;
  std::vector<Ray> rays_;
  std::vector<Contact> contacts_;  ///< but those that are open
};

template <typename Number>
PairBound<Number>::PairBound(const Box& box, const Generators& region, const MovingTwist& twist)
    : twist_(twist), c_(twist.c) {
  const std::size_t dimension = box.dimension();
  for (const Rational& c : twist.y) y_.emplace_back(c);
  for (const Generator& generator : region) {
    const Form& x = *generator.x;
    long halvings = 0;
    Ray ray{generator_of<Number>(x, &halvings), {}, {}};
    ray.h = ray.x[dimension];
    Vector moved(dimension);
    add(moved, Rational(x[dimension]), twist.y);
    for (std::size_t j = 0; j < dimension; ++j) moved[j] += twist.c * x[j];
    Rational work = box.load.work(moved).high;
    count(work, dimension * dimension);
    mpq_div_2exp(work.get_mpq_t(), work.get_mpq_t(), static_cast<mp_bitcnt_t>(halvings));
    ray.load = Number(work);
    ray.x.resize(dimension);
    rays_.push_back(std::move(ray));
  }
  std::map<std::size_t, const OwnSlip*> own;
  for (const OwnSlip& slip : twist.slips) own[slip.contact.get_ui()] = &slip;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const auto contact = box.passing(i);
    const auto listed = own.find(i);
    std::vector<Work> at = work_of(*contact, listed == own.end() ? nullptr : listed->second);
    const bool spring = is_spring(contact->box.sight);
    const int side = spring ? 1 : side_of(contact->row, at, region);
    if (side >= 0) contacts_.push_back({side == 0, std::move(at)});
  }
}

/// 1 of a contact that is closed, -1 of one that is open, else 0.
template <typename Number>
int PairBound<Number>::side_of(const Row& row, const std::vector<Work>& at,
                               const Generators& region) {
  bool closed = true;
  bool open = true;
  for (const Work& work : at) {
    const auto low = sign_of(work.low);
    const auto high = sign_of(work.high);
    if (!low || !high) return side(region, row.v);
    closed = closed && *low >= 0;
    open = open && *high <= 0;
  }
  return closed ? 1 : open ? -1 : 0;
}

template <typename Number>
typename PairBound<Number>::Corner PairBound<Number>::corner_of(const Row& row, std::size_t c,
                                                                bool rubs) const {
  Corner corner;
  corner.normal = multiple<Number>(row.scale, row.normals[c]);
  corner.work = counted_product(corner.normal, y_);
  for (std::size_t j = 0; rubs && j < row.slips[c].size(); ++j) {
    corner.slip.push_back(multiple<Number>(row.scale, row.slips[c][j]));
    corner.motion.push_back(counted_product(corner.slip.back(), y_));
  }
  return corner;
}

template <typename Number>
typename PairBound<Number>::Friction PairBound<Number>::friction_of(const BoxContact& contact,
                                                                    const OwnSlip* own) const {
  const ContactBox& box = contact.box;
  const std::size_t size = contact.row.slips[0].size();
  const auto all = [](const Vector& v) { return std::vector<Number>(v.begin(), v.end()); };
  return {Number(box[Parameter::kFriction].low),
          Number(box[Parameter::kFriction].high),
          Number(contact.row.has_edges() ? Rational(1) : dot(box.normal, box.normal)),
          all(conjugate(box, Vector(size, 1))),
          Number(own != nullptr ? Rational(twist_.c - own->kappa) : twist_.c),
          all(own != nullptr ? conjugate(box, own->psi) : Vector{}),
          Number(1 + contact.row.tilt / 2)};
}

/// The largest rho <psi, s> + (1 + delta/2) rho |S y(r) - kappa s| of both ends of mu.
template <typename Number>
Number PairBound<Number>::most_friction(const Friction& friction, const Corner& corner,
                                        const Ray& ray) const {
  std::vector<Number> slip;
  std::vector<Number> left;     // S y(r) - kappa s
  std::vector<Number> squares;  // of these
  for (auto* numbers : {&slip, &left, &squares}) numbers->reserve(corner.slip.size());
  for (std::size_t j = 0; j < corner.slip.size(); ++j) {
    slip.push_back(counted_product(corner.slip[j], ray.x));
    left.push_back(friction.own * slip[j] + ray.h * corner.motion[j]);
    squares.push_back(left[j] * left[j]);
  }
  const Number length =
      root_above(friction.square * counted_product(friction.weights, squares));
  Number work = friction.stretch * length;
  if (!friction.psi.empty()) {
    work = work + times_root_above(counted_product(friction.psi, slip), friction.square);
  }
  count(work, 20);
  return larger(friction.low * work, friction.high * work);
}

/// v_min, v_max and A of a contact at all rays.
template <typename Number>
std::vector<typename PairBound<Number>::Work> PairBound<Number>::work_of(
    const BoxContact& contact, const OwnSlip* own) const {
  const Row& row = contact.row;
  const Bounds& preload = contact.box[Parameter::kPreload];
  const Bounds& stiffness = contact.box[Parameter::kStiffness];
  const Number stiffnesses[]{Number(stiffness.low), Number(stiffness.high)};
  const bool rubs = contact.box[Parameter::kFriction].high > 0;
  const Friction friction = friction_of(contact, own);
  std::vector<Work> all(rays_.size());
  for (std::size_t c = 0; c < row.normals.size(); ++c) {
    const Corner corner = corner_of(row, c, rubs);
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      const Ray& ray = rays_[r];
      const Number height = counted_product(corner.normal, ray.x);
      Number most = c_ * height + ray.h * corner.work;
      if (rubs) most = most + most_friction(friction, corner, ray);
      // Until all corners are seen, what v_i loses by them.
      Work& work = all[r];
      for (const Number& k : stiffnesses) {
        const Number pull = k * height;
        const bool first = c == 0 && &k == stiffnesses;
        work.low = first ? pull : larger(work.low, pull);
        work.high = first ? pull : smaller(work.high, pull);
      }
      work.most = c == 0 ? most : larger(work.most, most);
      count(most, 8);
    }
  }
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    all[r].low = Number(preload.low) * rays_[r].h - all[r].low;
    all[r].high = Number(preload.high) * rays_[r].h - all[r].high;
  }
  return all;
}

template <typename Number>
Number PairBound<Number>::twice(std::size_t r, std::size_t s) const {
  const Number zero;
  Number sum = rays_[r].h * rays_[s].load + rays_[s].h * rays_[r].load;
  for (const Contact& contact : contacts_) {
    for (const auto& [one, other] : {std::pair{r, s}, std::pair{s, r}}) {
      const Work& v = contact.at[one];
      const Number& most = contact.at[other].most;
      const Number work = contact.mixed ? Number(larger(zero, v.high) * larger(zero, most))
                                        : larger(v.high * most, v.low * most);
      sum = sum + work;
    }
    count(sum, 8);
  }
  return sum;
}

/// `leaf-bound`, by these numbers.
template <typename Number>
std::optional<std::string> refusal(const Box& box, const Generators& region,
                                   const MovingTwist& twist) {
  const PairBound<Number> bound(box, region, twist);
  Barring flat(region);  // where B(r, r) may be 0
  std::size_t r = 0;
  for (auto ray = region.begin(); ray != region.end(); ++ray, ++r) {
    std::size_t s = 0;
    for (auto other = region.begin(); s <= r; ++other, ++s) {
      const Number found = bound.twice(r, s);
      if (may_be_above(found)) {
        return "B is above 0 at " + show(Vector(ray->x->begin(), ray->x->end())) + " and " +
               show(Vector(other->x->begin(), other->x->end()));
      }
      if (s == r && sign_of(found).value_or(0) == 0) flat.add(*ray);
    }
  }
  if (!flat.barred()) return "B(r, r) = 0 on rays that are not barred together";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> list_refusal(const Box& box, const MovingTwist& twist) {
  Integer above = -1;
  for (const OwnSlip& own : twist.slips) {
    const std::string name = "contact " + own.contact.get_str() + ": ";
    if (own.contact <= above) return name + "not above the one before";
    if (own.contact >= box.size()) return name + "there is none";
    const ContactBox& contact = box.contact(own.contact.get_ui());
    if (!is_contact(contact.sight)) return name + "it does not slip";
    const Rational square = dot(conjugate(contact, own.psi), own.psi);
    if (own.kappa < 0 || square > own.kappa * own.kappa) {
      return name + "psi = " + show(own.psi) + " is longer than kappa = " + show(own.kappa);
    }
    above = own.contact;
  }
  return std::nullopt;
}

std::optional<std::string> leaf_refusal(const Box& box, const Generators& region,
                                        const MovingTwist& twist, bool* exact) {
  *exact = refusal<Enclosure>(box, region, twist).has_value();
  return *exact ? refusal<Rational>(box, region, twist) : std::nullopt;
}

std::optional<std::string> direction_refusal(const Generators& region, const MovingTwist& twist,
                                             const std::vector<Vector>& direction) {
  // y(x).A e(x') is the sum of x_k pull_k.x', k from 1 to D + 1.
  const std::size_t dimension = twist.y.size();
  std::vector<Vector> pulls(dimension + 1, Vector(direction[0].size()));
  for (std::size_t j = 0; j < dimension; ++j) {
    add(pulls[j], twist.c, direction[j]);
    add(pulls[dimension], twist.y[j], direction[j]);
  }
  const std::vector<Form> forms = make_forms(pulls);
  std::vector<Form> at;  // of each ray, pull_k.x'
  for (auto ray = region.begin(); ray != region.end(); ++ray) {
    at.emplace_back();
    for (const Form& pull : forms) at.back().push_back(dot(pull, *ray->x));
    auto before = at.begin();
    for (auto other = region.begin(); before != at.end(); ++other, ++before) {
      // at has D + 1 numbers, and those are the first of a point.
      if (dot(*before, *ray->x) + dot(at.back(), *other->x) < 0) {
        return "y.A(d - h d0) is below 0 at " + show(Vector(ray->x->begin(), ray->x->end())) +
               " and " + show(Vector(other->x->begin(), other->x->end()));
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
