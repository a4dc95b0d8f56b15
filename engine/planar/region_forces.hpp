// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The freedom of the contacts on one region of the branch and bound. Those that are open are
/// gone, those closed and with a sign of slip are summed up, and the others are left, in groups
/// of which the same is known.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "double_model.hpp"
#include "region.hpp"
#include "region_program.hpp"

namespace stickslip::planar_detail {

/// The freedom of a contact on a region where it is not open.
struct ContactFreedom {
  Separation separation = Separation::kMixed;
  std::int8_t slip = 0;   ///< the sign that slip has, -1 or 1; 0: it may have any
  bool slip_cuts = true;  ///< a slip split would make progress

  bool is_closed() const { return separation == Separation::kClosed; }
  bool operator==(const ContactFreedom& other) const {
    return separation == other.separation && slip == other.slip && slip_cuts == other.slip_cuts;
  }
  /// Returns the edge of the cone on which the friction works most, by the sign of its work.
  double edge(double friction_work) const {
    return slip != 0 ? -slip : friction_work >= 0 ? 1.0 : -1.0;
  }
};

/// Contacts of one group that may do the same, and whose part in the bounds is not one linear
/// form on the region.
struct UndecidedGroup {
  std::uint32_t group = 0;  ///< its index in ContactGroups
  ContactFreedom freedom;
  /// \{ The range of those that are listed one by one; begin = end if they are all of the
  /// group.
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  /// \}
};

/// The decided contacts: the sum of (N + sigma mu T) (x) v, so that y.value.x is the work of
/// their forces at x on the virtual twist y.
struct DecidedContacts {
  double value[3][5] = {};
  double magnitude[3][5] = {};  ///< sums of absolute values, for error bounds
};

/// Rays are taken in blocks of this many: what is done with each is done with several at once.
inline constexpr std::size_t kBlock = 4;
using BlockDoubles = Eigen::Array<double, kBlock, 1>;

/// The forces of an undecided group at a block of rays.
struct BlockForces {
  std::array<BlockDoubles, 3> normal;    ///< sum of max(0, v) N
  std::array<BlockDoubles, 3> friction;  ///< sum of max(0, v) mu T
  BlockDoubles pressing;                 ///< sum of max(0, v)
  BlockDoubles pushes;                   ///< 1 where some v > 0, else 0; exact
};

/// The contacts on one region after another. Buffers are reused from region to region.
class RegionForces {
 public:
  /// Serves all regions of this problem.
  RegionForces(const Problem& problem, const DoubleModel& model)
      : problem_(problem), model_(model) {}

  /// Finds the freedom of all contacts on a region. O(rays) for each group and contact that is
  /// looked at; a group's parts are looked at if not the same is known of all its contacts.
  void read(const Region& region);
  /// Returns how many groups and single contacts the last read looked at.
  std::size_t visits() const { return visits_; }

  /// \{ Returns the region's generators, exactly or in doubles, and their number.
  std::size_t ray_count() const { return rays_.size(); }
  const std::vector<Ray>& exact_rays() const { return generators_; }
  const std::vector<Double5>& rays() const { return rays_; }
  /// \}
  /// The coordinates of a block's rays; the last block is filled up with the first ray.
  using RayBlock = std::array<BlockDoubles, 5>;
  const std::vector<RayBlock>& blocks() const { return blocks_; }

  const DecidedContacts& decided() const { return decided_; }

  const std::vector<UndecidedGroup>& undecided() const { return undecided_; }
  /// Returns whether all groups without parts are single contacts.
  bool all_are_single() const { return model_.groups.are_single(); }
  /// Returns the forces of the k-th undecided group, by blocks of rays.
  const BlockForces* block_forces(std::size_t k) const {
    return &block_forces_[k * blocks_.size()];
  }
  /// Calls `visit(contact)` for each contact of an undecided group, or of a part of it.
  template <class Visit>
  void for_each_contact(const UndecidedGroup& u, const Visit& visit) const {
    if (u.begin != u.end) {
      for (std::uint32_t k = u.begin; k < u.end; ++k) visit(members_[k]);
    } else {
      const ContactGroup& group = model_.groups.groups()[u.group];
      for (std::uint32_t k = group.begin; k < group.end; ++k) visit(model_.groups.order()[k]);
    }
  }

  /// Returns whether something acts at the ray, exactly: h > 0, or h may be 0 at solutions; or
  /// the growing load or a decided contact acts there.
  bool loaded(std::size_t ray) const { return loaded_[ray] != 0; }

 private:
  /// The signs of a function at the rays, by doubles, and by integers where these do not tell.
  struct Signs {
    bool negative = false;
    bool zero = false;
    bool positive = false;
    bool unsure = false;

    bool cuts() const { return negative && positive; }
    void add(int sign) { (sign > 0 ? positive : sign < 0 ? negative : zero) = true; }
  };

  void list_rays(const Region& region);
  /// Fills signs_ with what doubles tell of the contacts of a box; returns the signs there are.
  template <std::size_t n>
  Signs signs(const CoefficientBox<n>& box);
  /// Finds out in integers what is unsure in signs_; returns the signs there are.
  Signs settled(const ShortVector5& plane, const IntegerVector5& long_plane);
  int exact_sign(const ShortVector5& plane, const IntegerVector5& long_plane,
                 std::size_t ray) const;
  /// Returns the sign at a ray of a function whose value there is known in doubles.
  template <std::size_t n>
  int sign_at(const std::array<double, n>& function, double error, std::size_t ray,
              double value, const ShortVector5& plane, const IntegerVector5& long_plane) const;
  /// Fills values_ for the contact at a place of ContactGroups::order(); returns the signs of
  /// v.
  Signs separation_signs(std::uint32_t place);
  /// Returns what signs_ of a slip say, by the rule "has the sign" of certificate/FORMAT.md.
  ContactFreedom slip_freedom(const Region& region, const Signs& signs);
  std::optional<ContactFreedom> group_slip(const Region& region, const ContactGroup& group);
  ContactFreedom contact_slip(const Region& region, std::uint32_t place);
  void visit_group(const Region& region, std::uint32_t index,
                   std::optional<ContactFreedom> slip);
  void visit_contacts(const Region& region, std::uint32_t index,
                      const std::optional<ContactFreedom>& slip);
  void decide(const ContactGroup& group, int slip);
  void decide(const ContactRowDoubles& row, int slip);
  void add_group(std::uint32_t index, const ContactFreedom& freedom);
  void add_contact(const ContactRowDoubles& row, BlockForces* sums) const;

  const Problem& problem_;
  const DoubleModel& model_;
  std::size_t visits_ = 0;
  std::vector<Ray> generators_;
  std::vector<Double5> rays_;
  std::vector<ShortVector5> short_rays_;
  std::vector<RayBlock> blocks_;
  std::vector<RayBlock> sizes_;       ///< absolute values of blocks_
  bool rays_are_moderate_ = true;     ///< no entry but 0 is so small that products vanish
  std::vector<BlockDoubles> values_;  ///< v of one contact; the signs at rays are exact
  std::vector<BlockDoubles> slips_;   ///< tau of one contact
  std::vector<std::int8_t> signs_;    ///< signs of one function by ray; kUnsure if not known
  std::vector<const Ray*> zero_rays_;
  DecidedContacts decided_;
  std::vector<UndecidedGroup> undecided_;
  std::vector<BlockForces> block_forces_;
  std::vector<std::uint32_t> members_;
  std::vector<std::pair<ContactFreedom, std::uint32_t>> loose_;  ///< the contacts of one group
  std::vector<char> loaded_;
};

}  // namespace stickslip::planar_detail
