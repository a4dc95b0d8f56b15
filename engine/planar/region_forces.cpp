// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::planar_detail {
namespace {

constexpr std::int8_t kUnsure = 2;

}  // namespace

void RegionForces::list_rays(const Region& region) {
  generators_ = region.generators(problem_);
  rays_.clear();
  short_rays_.clear();
  rays_are_moderate_ = true;
  for (const Ray& ray : generators_) {
    rays_.push_back(in_doubles(ray.x));
    short_rays_.emplace_back(ray.x);
    for (std::size_t j = 0; j < 5; ++j) {
      constexpr double kSmallest = 0x1p-300;
      rays_are_moderate_ =
          rays_are_moderate_ && (ray.x[j].is_zero() || std::fabs(rays_.back()[j]) >= kSmallest);
    }
  }
  const std::size_t block_count = (rays_.size() + kBlock - 1) / kBlock;
  blocks_.resize(block_count);
  sizes_.resize(block_count);
  values_.resize(block_count);
  slips_.resize(block_count);
  signs_.resize(block_count * kBlock);
  for (std::size_t r = 0; r < block_count * kBlock; ++r) {
    const Double5& x = rays_[r < rays_.size() ? r : 0];
    for (std::size_t j = 0; j < 5; ++j) {
      blocks_[r / kBlock][j].data()[r % kBlock] = x[j];
      sizes_[r / kBlock][j].data()[r % kBlock] = std::fabs(x[j]);
    }
  }
}

template <std::size_t n>
RegionForces::Signs RegionForces::signs(const CoefficientBox<n>& box) {
  Signs result;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockDoubles center = box.center[0] * blocks_[b][0];
    BlockDoubles radius = box.radius[0] * sizes_[b][0];
    for (std::size_t j = 1; j < n; ++j) {
      center += box.center[j] * blocks_[b][j];
      radius += box.radius[j] * sizes_[b][j];
    }
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const double middle = center.data()[lane];
      const double reach = radius.data()[lane];
      std::int8_t& sign = signs_[b * kBlock + lane];
      if (middle - reach > box.error) {
        sign = 1;
        result.positive = true;
      } else if (middle + reach < -box.error) {
        sign = -1;
        result.negative = true;
      } else {
        sign = kUnsure;
        if (rays_are_moderate_ && middle == 0 && reach == 0) {
          // Every product is 0, and exactly so.
          double sum = 0;
          for (std::size_t j = 0; j < n; ++j) {
            sum += (std::fabs(box.center[j]) + box.radius[j]) * sizes_[b][j].data()[lane];
          }
          if (sum == 0) sign = 0;
        }
        (sign == 0 ? result.zero : result.unsure) = true;
      }
    }
  }
  return result;
}

RegionForces::Signs RegionForces::settled(const ShortVector5& plane,
                                          const IntegerVector5& long_plane) {
  Signs result;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    std::int8_t& sign = signs_[r];
    if (sign == kUnsure) sign = static_cast<std::int8_t>(exact_sign(plane, long_plane, r));
    result.add(sign);
  }
  return result;
}

int RegionForces::exact_sign(const ShortVector5& plane, const IntegerVector5& long_plane,
                             std::size_t ray) const {
  if (const std::optional<int> sign = short_sign(plane, short_rays_[ray])) return *sign;
  static thread_local Integer sum;  // its memory is kept
  sum = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    mpz_addmul(sum.mutable_gmp(), long_plane[j].gmp(), generators_[ray].x[j].gmp());
  }
  return sum.sign();
}

template <std::size_t n>
int RegionForces::sign_at(const std::array<double, n>& function, double error, std::size_t ray,
                          double value, const ShortVector5& plane,
                          const IntegerVector5& long_plane) const {
  if (model_.is_moderate) {
    if (value > error) return 1;
    if (value < -error) return -1;
    if (value == 0 && rays_are_moderate_) {
      double magnitude = 0;
      for (std::size_t j = 0; j < n; ++j) {
        magnitude += std::fabs(function[j] * rays_[ray][j]);
      }
      if (magnitude == 0) return 0;  // every product is 0, and exactly so
    }
  }
  return exact_sign(plane, long_plane, ray);
}

RegionForces::Signs RegionForces::separation_signs(std::uint32_t place) {
  const ContactRowDoubles& c = model_.groups.rows()[place];
  const Double5& f = c.separation;
  BlockDoubles least = BlockDoubles::Constant(HUGE_VAL);
  BlockDoubles most = -least;
  BlockDoubles nearest = least;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const RayBlock& x = blocks_[b];
    const BlockDoubles v = f[0] * x[0] + f[1] * x[1] + f[2] * x[2] + f[3] * x[3] + f[4] * x[4];
    least = least.min(v);
    most = most.max(v);
    nearest = nearest.min(v.abs());
    values_[b] = v;
  }
  if (model_.is_moderate && nearest.minCoeff() > c.separation_error) {
    return {least.minCoeff() < 0, false, most.maxCoeff() > 0, false};
  }
  const IntegerVector5& plane =
      problem_.separation_plane(ContactId(model_.groups.order()[place]));
  Signs result;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    double& value = values_[r / kBlock].data()[r % kBlock];
    const int sign = sign_at(f, c.separation_error, r, value,
                             model_.groups.planes()[place].separation, plane);
    const double size = std::isfinite(value) ? std::fabs(value) : 1;
    value = sign * std::max(size, std::numeric_limits<double>::min());
    result.add(sign);
  }
  return result;
}

ContactFreedom RegionForces::slip_freedom(const Region& region, const Signs& signs) {
  ContactFreedom freedom;
  if (signs.cuts()) return freedom;
  if (!signs.positive && !signs.negative) {
    freedom.slip_cuts = false;  // sticks everywhere: friction is free, and a split idle
    return freedom;
  }
  zero_rays_.clear();
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    if (signs_[r] == 0) zero_rays_.push_back(&generators_[r]);
  }
  if (region.bars(zero_rays_)) {
    freedom.slip = signs.positive ? 1 : -1;
    freedom.slip_cuts = false;
  }
  return freedom;
}

/// Returns what is known of the slip of all; nothing if it is not known to be the same.
std::optional<ContactFreedom> RegionForces::group_slip(const Region& region,
                                                       const ContactGroup& group) {
  if (group.is_frictionless) return ContactFreedom{Separation::kMixed, 1, false};
  Signs found = signs(group.slip);
  if (found.unsure && !found.cuts()) {
    if (!group.has_one_slip_plane) return std::nullopt;
    const ContactId first(model_.groups.order()[group.begin]);
    found = settled(model_.groups.planes()[group.begin].slip, problem_.slip_plane(first));
  }
  return slip_freedom(region, found);
}

ContactFreedom RegionForces::contact_slip(const Region& region, std::uint32_t place) {
  const ContactRowDoubles& c = model_.groups.rows()[place];
  // Without friction both edges are one.
  if (c.frictionless) return {Separation::kMixed, 1, false};
  const ContactId contact(model_.groups.order()[place]);
  if (const std::optional<Sign> label = region.label(contact)) {
    return {Separation::kMixed, static_cast<std::int8_t>(to_int(*label)), false};
  }
  BlockDoubles least = BlockDoubles::Constant(HUGE_VAL);
  BlockDoubles most = -least;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const RayBlock& x = blocks_[b];
    slips_[b] = c.slip[0] * x[0] + c.slip[1] * x[1] + c.slip[2] * x[2];
    least = least.min(slips_[b]);
    most = most.max(slips_[b]);
  }
  if (model_.is_moderate && least.minCoeff() < -c.slip_error &&
      most.maxCoeff() > c.slip_error) {
    return {};
  }
  Signs found;
  for (std::size_t r = 0; r < rays_.size() && !found.cuts(); ++r) {
    const int sign = sign_at(c.slip, c.slip_error, r, slips_[r / kBlock].data()[r % kBlock],
                             model_.groups.planes()[place].slip, problem_.slip_plane(contact));
    signs_[r] = static_cast<std::int8_t>(sign);
    found.add(sign);
  }
  return slip_freedom(region, found);
}

void RegionForces::decide(const ContactGroup& group, int slip) {
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 5; ++k) {
      decided_.value[j][k] += group.normal_work[j][k] - slip * group.friction_work[j][k];
      decided_.magnitude[j][k] += group.magnitude[j][k];
    }
  }
}

void RegionForces::decide(const ContactRowDoubles& c, int slip) {
  for (std::size_t j = 0; j < 3; ++j) {
    const double edge = c.normal[j] - slip * c.friction[j];
    const double edge_magnitude = std::fabs(c.normal[j]) + std::fabs(c.friction[j]);
    for (std::size_t k = 0; k < 5; ++k) {
      decided_.value[j][k] += edge * c.separation[k];
      decided_.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
    }
  }
}

void RegionForces::add_group(std::uint32_t index, const ContactFreedom& freedom) {
  const ContactGroup& group = model_.groups.groups()[index];
  undecided_.push_back({index, freedom});
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const RayBlock& x = blocks_[b];
    BlockForces& sums = block_forces_.emplace_back();
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      sums.pushes.data()[lane] = signs_[b * kBlock + lane] > 0 ? 1 : 0;
    }
    const auto at_rays = [&](const double(&form)[5]) -> BlockDoubles {
      return sums.pushes * (form[0] * x[0] + form[1] * x[1] + form[2] * x[2] + form[3] * x[3] +
                            form[4] * x[4]);
    };
    for (std::size_t j = 0; j < 3; ++j) {
      sums.normal[j] = at_rays(group.normal_work[j]);
      sums.friction[j] = at_rays(group.friction_work[j]);
    }
    sums.pressing = at_rays(group.law);
  }
}

/// Adds a contact whose v are in values_.
void RegionForces::add_contact(const ContactRowDoubles& c, BlockForces* sums) const {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const BlockDoubles v = values_[b].max(0.0);
    for (std::size_t j = 0; j < 3; ++j) {
      sums[b].normal[j] += c.normal[j] * v;
      sums[b].friction[j] += c.friction[j] * v;
    }
    sums[b].pressing += v;
  }
}

/// Looks at contacts one by one; those that may do the same are put together.
void RegionForces::visit_contacts(const Region& region, std::uint32_t index,
                                  const std::optional<ContactFreedom>& slip) {
  const ContactGroup& group = model_.groups.groups()[index];
  const std::size_t first = undecided_.size();
  loose_.clear();
  for (std::uint32_t k = group.begin; k < group.end; ++k) {
    ++visits_;
    const std::uint32_t contact = model_.groups.order()[k];
    const Signs v = separation_signs(k);
    if (!v.positive) continue;  // open: no force
    ContactFreedom freedom = slip ? *slip : contact_slip(region, k);
    freedom.separation = v.negative ? Separation::kMixed : Separation::kClosed;
    if (freedom.is_closed() && freedom.slip != 0) {
      decide(model_.groups.rows()[k], freedom.slip);
      for (std::size_t r = 0; r < rays_.size(); ++r) {
        if (values_[r / kBlock].data()[r % kBlock] > 0) loaded_[r] = 1;
      }
      continue;
    }
    std::size_t same = first;
    while (same < undecided_.size() && !(undecided_[same].freedom == freedom)) ++same;
    if (same == undecided_.size()) {
      undecided_.push_back({index, freedom});
      const BlockDoubles zero = BlockDoubles::Zero();
      block_forces_.resize(block_forces_.size() + blocks_.size(),
                           {{zero, zero, zero}, {zero, zero, zero}, zero, zero});
    }
    add_contact(model_.groups.rows()[k], &block_forces_[same * blocks_.size()]);
    loose_.emplace_back(freedom, contact);
  }
  for (std::size_t k = first; k < undecided_.size(); ++k) {
    undecided_[k].begin = static_cast<std::uint32_t>(members_.size());
    for (const auto& [freedom, contact] : loose_) {
      if (freedom == undecided_[k].freedom) members_.push_back(contact);
    }
    undecided_[k].end = static_cast<std::uint32_t>(members_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      BlockForces& sums = block_forces_[k * blocks_.size() + b];
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        sums.pushes.data()[lane] = sums.pressing.data()[lane] > 0 ? 1 : 0;
      }
    }
  }
}

/// `slip` is given if it is known to be the same for all.
void RegionForces::visit_group(const Region& region, std::uint32_t index,
                               std::optional<ContactFreedom> slip) {
  const ContactGroup& group = model_.groups.groups()[index];
  // Fewer contacts take no longer one by one than all at once.
  constexpr std::uint32_t kFewest = 8;
  if (model_.is_moderate && group.end - group.begin >= kFewest) {
    ++visits_;
    if (!slip) slip = group_slip(region, group);
    const Signs v = signs(group.separation);
    if (!v.positive && !v.unsure) return;  // open: no force
    if (!v.unsure && slip) {
      slip->separation = v.negative ? Separation::kMixed : Separation::kClosed;
      if (!slip->is_closed() || slip->slip == 0) {
        add_group(index, *slip);
        return;
      }
      decide(group, slip->slip);
      for (std::size_t r = 0; r < rays_.size(); ++r) {
        if (signs_[r] > 0) loaded_[r] = 1;
      }
      return;
    }
  }
  if (group.second != 0) {
    visit_group(region, index + 1, slip);
    visit_group(region, group.second, slip);
  } else {
    visit_contacts(region, index, slip);
  }
}

void RegionForces::read(const Region& region) {
  list_rays(region);
  visits_ = 0;
  decided_ = {};
  undecided_.clear();
  block_forces_.clear();
  members_.clear();
  const bool load_grows = !(problem_.load_growth() == Wrench{});
  loaded_.assign(rays_.size(), 0);
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const IntegerVector5& x = generators_[r].x;
    const bool acts =
        !x[3].is_zero() || !region.has_height() || (load_grows && !x[4].is_zero());
    loaded_[r] = acts ? 1 : 0;
  }
  if (!model_.groups.groups().empty()) visit_group(region, 0, std::nullopt);
}

}  // namespace stickslip::planar_detail
