// SPDX-License-Identifier: GPL-3.0-or-later
#include "node.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::equilibrium_detail {
namespace {

double sum_of_sizes(const Double5& a) {
  double sum = 0;
  for (const double entry : a) sum += std::fabs(entry);
  return sum;
}

}  // namespace

double DoubleModel::read(const Rational& value) {
  constexpr double kLargest = 0x1p200;
  const double rounded = to_double(value);
  const double size = std::fabs(rounded);
  is_moderate = is_moderate && (value.is_zero() || (size <= kLargest && size >= 1 / kLargest));
  return rounded;
}

DoubleModel::DoubleModel(const Problem& problem) {
  double arms = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactDoubles c{};
    c.normal = read(row.normal);
    c.friction = read(row.friction * row.tangent);
    const Double3 tangent = read(row.tangent);
    c.slip = {tangent[0], tangent[1], tangent[2], 0, 0};
    const Vector5& v = problem.separation(ContactId(i));
    for (std::size_t j = 0; j < 5; ++j) c.separation[j] = read(v[j]);
    c.stiffness = read(row.stiffness);
    c.frictionless = row.friction.is_zero();
    c.slip_error = rounding_bound(sum_of_sizes(c.slip));
    c.separation_error = rounding_bound(sum_of_sizes(c.separation));
    arms += std::hypot(c.normal[2], tangent[2]) / std::hypot(c.normal[0], c.normal[1]);
    contacts.push_back(c);
  }
  load = read(problem.wrench());
  growth = read(problem.load_growth());
  const double count = std::max<double>(1, static_cast<double>(problem.size()));
  length = arms > 0 ? arms / count : 1;
  const auto add_end = [&](double h, double l) {
    for (std::size_t j = 0; j < 3; ++j) start[j] = h * load[j] + l * growth[j];
    force += std::hypot(start[0], start[1]) + std::fabs(start[2]) / length;
    for (const ContactDoubles& c : contacts) {
      const double preload = h * c.separation[3] + l * c.separation[4];
      force += preload * std::hypot(c.normal[0], c.normal[1]) / count;
    }
  };
  const MultipleRange& range = problem.multiples();
  add_end(1, to_double(range.low));
  if (problem.is_family()) range.high ? add_end(1, to_double(*range.high)) : add_end(0, 1);
  if (!(force > 0) || !std::isfinite(force)) force = 1;
  if (!std::isfinite(length)) length = 1;
}

Double5 to_doubles(const IntegerVector5& x) {
  std::array<double, 5> mantissa{};
  std::array<long, 5> exponent{};
  long largest = 0;
  bool any = false;
  for (std::size_t j = 0; j < 5; ++j) {
    if (x[j].is_zero()) continue;
    mantissa[j] = mpz_get_d_2exp(&exponent[j], x[j].backend().data());
    largest = any ? std::max(largest, exponent[j]) : exponent[j];
    any = true;
  }
  Double5 result{};
  for (std::size_t j = 0; j < 5; ++j) {
    const long shift = std::max<long>(exponent[j] - largest, -2000);
    result[j] = std::ldexp(mantissa[j], static_cast<int>(shift));
  }
  return result;
}
namespace {

void decide(const Problem& problem, const DoubleModel& model, const UndecidedContact& u,
            DecidedContacts& decided) {
  const ContactDoubles& c = model.contacts[u.contact];
  for (std::size_t j = 0; j < 3; ++j) {
    const double edge = c.normal[j] - u.slip * c.friction[j];
    const double edge_magnitude = std::fabs(c.normal[j]) + std::fabs(c.friction[j]);
    for (std::size_t k = 0; k < 5; ++k) {
      decided.value[j][k] += edge * c.separation[k];
      decided.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
    }
  }
  ++decided.terms;
  const IntegerVector5& plane = problem.separation_plane(ContactId(u.contact));
  for (std::size_t k = 0; k < 5; ++k) decided.push[k] += plane[k];
}

}  // namespace

Node::Node(const Problem& problem, Region root) : region(std::move(root)) {
  std::vector<UndecidedContact> all(problem.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].contact = static_cast<std::uint32_t>(i);
  }
  undecided = std::make_shared<const std::vector<UndecidedContact>>(std::move(all));
}

Node Node::slip_child(const Problem& problem, ContactId contact, Sign slip) const {
  Node child = *this;
  child.region = std::move(child.region).slip_child(problem, contact, slip);
  return child;
}

Node Node::separation_child(const Problem& problem, ContactId contact, Separation side) const {
  Node child = *this;
  child.region = std::move(child.region).separation_child(problem, contact, side);
  return child;
}

Branch<RefutationNode, Node> Node::split(const Problem& problem, const ContactSplit& at) const {
  Branch<RefutationNode, Node> branch{
      std::visit([](const auto& split) { return RefutationNode(split); }, at), {}};
  if (const auto* slip = std::get_if<SlipSplit>(&at)) {
    for (const Sign sign : {Sign::kPositive, Sign::kZero, Sign::kNegative}) {
      branch.children.push_back(slip_child(problem, slip->contact, sign));
    }
  } else {
    const ContactId contact = std::get<SeparationSplit>(at).contact;
    for (const Separation side : {Separation::kClosed, Separation::kOpen}) {
      branch.children.push_back(separation_child(problem, contact, side));
    }
  }
  return branch;
}

namespace {

void append(const ContactDoubles& c, const UndecidedContact& u, std::size_t index,
            std::vector<UndecidedBlock>& blocks) {
  const std::size_t lane = index % kBlock;
  if (lane == 0) {
    const BlockDoubles zero = BlockDoubles::Zero();
    blocks.push_back({{zero, zero, zero}, {zero, zero, zero}, zero, zero, zero});
  }
  UndecidedBlock& block = blocks.back();
  for (std::size_t j = 0; j < 3; ++j) {
    block.normal[j].data()[lane] = c.normal[j];
    block.friction[j].data()[lane] = c.friction[j];
  }
  block.edge.data()[lane] = -u.slip;
  block.any_edge.data()[lane] = u.slip == 0 ? 1 : 0;
  block.least.data()[lane] = u.separation == Separation::kClosed ? -HUGE_VAL : 0;
}

/// The sign of plane.x in integers of the machine, if the numbers are short.
std::optional<int> short_sign(const IntegerVector5& plane, const IntegerVector5& x) {
  __extension__ using Wide = __int128;
  constexpr std::size_t kBits = 61;  // five products stay below 2^125
  Wide sum = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    const auto* a = plane[j].backend().data();
    const auto* b = x[j].backend().data();
    if (mpz_sizeinbase(a, 2) > kBits || mpz_sizeinbase(b, 2) > kBits) return std::nullopt;
    sum += static_cast<Wide>(mpz_get_si(a)) * mpz_get_si(b);
  }
  return (sum > 0) - (sum < 0);
}

/// The sign of plane.x.
int exact_sign(const IntegerVector5& plane, const IntegerVector5& x) {
  if (const std::optional<int> sign = short_sign(plane, x)) return *sign;
  static thread_local Integer sum;  // its memory is kept
  sum = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    mpz_addmul(sum.backend().data(), plane[j].backend().data(), x[j].backend().data());
  }
  return sum.sign();
}

}  // namespace

Sign RayTable::sign_at(const Double5& function, const IntegerVector5& plane, std::size_t ray,
                       double& value) const {
  const std::optional<Sign> sign = certain_sign(function, rays_[ray], value);
  if (sign && doubles_decide_) return *sign;
  const int exact = exact_sign(plane, generators_[ray].x);
  const double size = std::isfinite(value) ? std::fabs(value) : 1;
  value = exact * std::max(size, std::numeric_limits<double>::min());
  return sign_of_int(exact);
}

void RayTable::list_rays(const Problem& problem, const Node& node) {
  generators_ = node.region.generators(problem);
  rays_.clear();
  for (const Ray& ray : generators_) rays_.push_back(to_doubles(ray.x));
  const std::size_t block_count = (rays_.size() + kBlock - 1) / kBlock;
  blocks_.resize(block_count);
  values_.resize(block_count);
  for (std::size_t r = 0; r < block_count * kBlock; ++r) {
    const Double5& x = rays_[r < rays_.size() ? r : 0];
    for (std::size_t j = 0; j < 5; ++j) blocks_[r / kBlock][j].data()[r % kBlock] = x[j];
  }
}

/// Fills values_; returns the signs in it.
SignRange RayTable::find_separations(const Problem& problem, const ContactDoubles& c,
                                     ContactId contact) {
  BlockDoubles least = BlockDoubles::Constant(HUGE_VAL);
  BlockDoubles most = -least;
  BlockDoubles nearest = least;
  const Double5& f = c.separation;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& x = blocks_[b];
    const BlockDoubles v = f[0] * x[0] + f[1] * x[1] + f[2] * x[2] + f[3] * x[3] + f[4] * x[4];
    least = least.min(v);
    most = most.max(v);
    nearest = nearest.min(v.abs());
    values_[b] = v;
  }
  if (doubles_decide_ && nearest.minCoeff() > c.separation_error) {
    return {least.minCoeff() < 0, false, most.maxCoeff() > 0};
  }
  SignRange range;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const Sign sign = sign_at(c.separation, problem.separation_plane(contact), r,
                              values_[r / kBlock].data()[r % kBlock]);
    (sign == Sign::kNegative   ? range.negative
     : sign == Sign::kPositive ? range.positive
                               : range.zero) = true;
  }
  return range;
}

void RayTable::read(const Problem& problem, const DoubleModel& model, Node& node) {
  doubles_decide_ = model.is_moderate;
  list_rays(problem, node);
  undecided_.clear();
  separations_.resize(std::max(separations_.size(), blocks_.size()));
  for (auto& block : separations_) block.clear();
  std::vector<UndecidedContact> kept;
  kept.reserve(node.undecided->size());
  for (UndecidedContact u : *node.undecided) {
    const ContactDoubles& c = model.contacts[u.contact];
    const ContactId contact(u.contact);
    const SignRange range = find_separations(problem, c, contact);
    if (u.separation == Separation::kMixed) {
      if (range.is_nonpositive()) continue;  // open: no force
      if (range.is_nonnegative()) u.separation = Separation::kClosed;
    }
    if (const std::optional<Sign> label = node.region.label(contact)) {
      u.slip = static_cast<std::int8_t>(to_int(*label));
      u.slip_cuts = false;
    }
    if (u.slip == 0 && c.frictionless) u.slip = 1;  // both edges are one
    if (u.slip == 0 && u.slip_cuts) find_slip_sign(problem, model, node, u);
    if (u.separation == Separation::kClosed && u.slip != 0) {
      decide(problem, model, u, node.decided);
      continue;
    }
    append(c, u, kept.size(), undecided_);
    kept.push_back(u);
    for (std::size_t b = 0; b < blocks_.size(); ++b) separations_[b].push_back(values_[b]);
  }
  node.undecided = std::make_shared<const std::vector<UndecidedContact>>(std::move(kept));
  loaded_.assign(rays_.size(), 0);
  const Double5 push = to_doubles(node.decided.push);
  const bool load_grows = !(problem.load_growth() == Wrench{});
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    double value = 0;
    const IntegerVector5& x = generators_[r].x;
    const bool acts = !x[3].is_zero() || !node.region.has_height() ||
                      (load_grows && !x[4].is_zero()) ||
                      sign_at(push, node.decided.push, r, value) == Sign::kPositive;
    loaded_[r] = acts ? 1 : 0;
  }
}

bool RayTable::block_is_loaded(std::size_t block) const {
  const auto begin = loaded_.begin() + static_cast<std::ptrdiff_t>(block * kBlock);
  const std::size_t size = std::min(kBlock, loaded_.size() - block * kBlock);
  return std::all_of(begin, begin + static_cast<std::ptrdiff_t>(size),
                     [](char loaded) { return loaded != 0; });
}

/// The rule "has the sign" of certificate/FORMAT.md.
void RayTable::find_slip_sign(const Problem& problem, const DoubleModel& model,
                              const Node& node, UndecidedContact& u) {
  const ContactId contact(u.contact);
  const ContactDoubles& c = model.contacts[u.contact];
  BlockDoubles least = BlockDoubles::Constant(HUGE_VAL);
  BlockDoubles most = -least;
  for (const Block& x : blocks_) {
    const BlockDoubles slip = c.slip[0] * x[0] + c.slip[1] * x[1] + c.slip[2] * x[2];
    least = least.min(slip);
    most = most.max(slip);
  }
  if (doubles_decide_ && least.minCoeff() < -c.slip_error && most.maxCoeff() > c.slip_error) {
    return;
  }
  bool positive = false;
  bool negative = false;
  zero_rays_.clear();
  for (std::size_t r = 0; r < rays_.size() && !(positive && negative); ++r) {
    double value = 0;
    const Sign sign = sign_at(c.slip, problem.slip_plane(contact), r, value);
    positive = positive || sign == Sign::kPositive;
    negative = negative || sign == Sign::kNegative;
    if (sign == Sign::kZero) zero_rays_.push_back(&generators_[r]);
  }
  if (positive && negative) return;
  if (!positive && !negative) {
    u.slip_cuts = false;  // sticks everywhere: friction is free, and a split idle
  } else if (node.region.is_barred(zero_rays_)) {
    u.slip = positive ? 1 : -1;
  }
}

}  // namespace stickslip::equilibrium_detail
