// SPDX-License-Identifier: MIT
#include "bound.hpp"

#include <algorithm>

namespace stickslip_check {
namespace {

Integer sum_of_sizes(const Integer* begin, std::size_t count) {
  Integer sum;
  for (std::size_t i = 0; i < count; ++i) sum += abs(begin[i]);
  return sum;
}

Work make_work(const std::array<Rational, 4>& wrench, const Rational& v_scale) {
  Rational scale;
  const Vector primitive = make_vector(wrench, &scale);
  return {{primitive.x[0], primitive.x[1], primitive.x[2]}, Rational(scale * v_scale), {}};
}

/// Enough that 2^shift weight has at least 64 bits before the point.
std::size_t shift_for(const Rational& weight) {
  constexpr std::size_t kBits = 64;
  const std::size_t num = mpz_sizeinbase(weight.get_num_mpz_t(), 2);
  const std::size_t den = mpz_sizeinbase(weight.get_den_mpz_t(), 2);
  return kBits + (den > num ? den - num : 0);
}

}  // namespace

Problem make_problem(const std::vector<Row>& rows) {
  Problem problem;
  problem.contacts.reserve(rows.size());
  for (const Row& row : rows) {
    WalkContact contact;
    const Rational k = -row.stiffness;
    Rational v_scale;
    contact.v = make_vector({Rational(k * row.normal[0]), Rational(k * row.normal[1]),
                             Rational(k * row.normal[2]), row.preload},
                            &v_scale);
    contact.tau = make_vector({row.tangent[0], row.tangent[1], row.tangent[2], Rational(0)});
    for (const Integer& coordinate : contact.v.x) {
      if (abs(coordinate) > contact.v_max) contact.v_max = abs(coordinate);
    }
    std::array<Rational, 4> plus;
    std::array<Rational, 4> minus;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational friction = row.friction * row.tangent[j];
      plus[j] = row.normal[j] - friction;
      minus[j] = row.normal[j] + friction;
    }
    contact.plus = make_work(plus, v_scale);
    contact.minus = make_work(minus, v_scale);
    problem.shift = std::max(
        {problem.shift, shift_for(contact.plus.weight), shift_for(contact.minus.weight)});
    problem.contacts.push_back(std::move(contact));
  }
  for (WalkContact& contact : problem.contacts) {
    for (Work* work : {&contact.plus, &contact.minus}) {
      for (std::size_t j = 0; j < 3; ++j) {
        work->shifted[j] = floor_shifted(work->weight, work->row[j], problem.shift);
      }
    }
  }
  return problem;
}

void add(Aggregate& sum, const WalkContact& contact, SlipSign sign) {
  const Work& work = sign == SlipSign::kPlus ? contact.plus : contact.minus;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t l = 0; l < 4; ++l) sum.form[j][l] += work.shifted[j] * contact.v.x[l];
  }
  sum.slack += contact.v_max;
}

LeafBound::LeafBound(const Problem& problem, const Vector3& load,
                     const std::vector<Status>& status,
                     const std::vector<std::size_t>& undecided, const Aggregate& decided,
                     const Vector3& y, const std::map<std::size_t, Rational>& thetas)
    : problem_(problem), status_(status), thetas_(thetas) {
  scale_ = lcm(lcm(y[0].get_den(), y[1].get_den()), y[2].get_den());
  for (std::size_t j = 0; j < 3; ++j) y_[j] = y[j].get_num() * (scale_ / y[j].get_den());
  power_ = dot(y, load) * scale_;

  // For a decided contact, sum over j of y_j (2^shift weight row_j - shifted_j) (v.x) is at
  // most (sum of |y_j|) |v.x|.
  for (std::size_t l = 0; l < 4; ++l) {
    for (std::size_t j = 0; j < 3; ++j) linear_[l] += y_[j] * decided.form[j][l];
  }
  slack_ = sum_of_sizes(y_.data(), 3) * decided.slack;
  linear_[3] += ceil_shifted(power_, problem.shift);  // h >= 0 on every ray
  for (const std::size_t i : undecided) {
    const WalkContact& contact = problem.contacts[i];
    const Work& w = work(i);
    const Rational c = w.weight * dot(w.row, y_);  // alpha_i times the scale of v_i
    if (status[i].gap == Gap::kMixed && c >= 0) {
      mixed_.emplace_back(i, ceil_shifted(c, problem.shift));
      continue;
    }
    const Rational factor = status[i].gap == Gap::kMixed ? theta(i) : Rational(1);
    if (factor == 0) continue;
    const Integer rounded = floor_shifted(Rational(c * factor), problem.shift);
    for (std::size_t l = 0; l < 4; ++l) linear_[l] += rounded * contact.v.x[l];
    slack_ += contact.v_max;
  }
}

/// Without a sign, alpha_i = y.N + mu |y.T|.
const Work& LeafBound::work(std::size_t contact) const {
  const WalkContact& c = problem_.contacts[contact];
  if (status_[contact].sign == SlipSign::kPlus) return c.plus;
  if (status_[contact].sign == SlipSign::kMinus) return c.minus;
  return dot({c.tau.x[0], c.tau.x[1], c.tau.x[2]}, y_) < 0 ? c.plus : c.minus;
}

Rational LeafBound::theta(std::size_t contact) const {
  const auto it = thetas_.find(contact);
  return it == thetas_.end() ? Rational(0) : it->second;
}

Integer LeafBound::upper(const Vector& r) const {
  Integer sum = slack_ * sum_of_sizes(r.x.data(), 4);
  for (std::size_t l = 0; l < 4; ++l) sum += linear_[l] * r.x[l];
  for (const auto& [i, coefficient] : mixed_) {
    const Vector& v = problem_.contacts[i].v;
    if (sign_of_dot(v, r) > 0) sum += coefficient * dot(v, r);
  }
  return sum;
}

Rational LeafBound::exact(const Vector& r) const {
  Rational sum = power_ * r.x[3];
  for (std::size_t i = 0; i < problem_.contacts.size(); ++i) {
    if (status_[i].gap == Gap::kOpen) continue;
    const int sign = sign_of_dot(problem_.contacts[i].v, r);
    if (sign == 0) continue;
    const Work& w = work(i);
    const Integer alpha = dot(w.row, y_);
    Rational factor = w.weight;
    if (status_[i].gap == Gap::kMixed) {
      if (alpha >= 0 && sign < 0) continue;
      if (alpha < 0) factor *= theta(i);
    }
    const Integer product = alpha * dot(problem_.contacts[i].v, r);
    if (product != 0) sum += factor * product;
  }
  return sum;
}

}  // namespace stickslip_check
