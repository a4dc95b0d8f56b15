// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions, and of a family's multiples, as a node of a refutation sees it
/// (certificate/FORMAT.md, section 4): a cone, the labels of contacts, and the strict
/// functions; and the rules of leaves.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/strict_cone.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// A set of motions between the planes of its splits. A split makes new ones. For a family in
/// which only the load grows, cone() has the motions alone, at l = 0: any of them goes with any
/// multiple.
class Region : public StrictConeOf<IntegerVector5> {
 public:
  /// Returns all motions that the normal law allows: {h >= 0}, and v_i >= 0 for all i when
  /// bilateral; for a family, with all multiples in its range.
  static Region root(const Problem& problem);
  /// Returns the part of root() in which each contact is closed or open, and slips where it is
  /// closed and has friction, as in the mode, by ContactId.
  static Region of_mode(const Problem& problem, const std::vector<ContactMode>& mode);

  /// A half-space or plane that a region begins with.
  struct Cut {
    IntegerVector5 plane;  ///< a of a.x = 0
    Side side;             ///< the side that is kept
    bool strict = false;   ///< the plane is not 0 at solutions
  };
  /// Returns all of {h >= 0} between these planes, for any multiples; h itself may be 0.
  static Region between(const Problem& problem, const std::vector<Cut>& cuts);
  /// Returns the cone over a wall of the body (StrictConeOf::cut_to_wall), for one grasp.
  static Region wall(const Problem& problem, const ConvexBody& body, std::size_t wall);

  /// Returns points whose nonnegative combinations are the closure; lines give two points, one
  /// each way. Where only the load grows they are those of the motions, with l at either end of
  /// the range, and (0, 0, 1) if it has one end.
  std::vector<Ray> generators(const Problem& problem) const;
  /// Returns what slip splits have said of a contact: kZero is the label 0; nothing is no
  /// label.
  std::optional<Sign> label(ContactId contact) const { return labels_[contact.index()]; }

  /// \{ Returns the child of a slip, separation or plane split; of a temporary, made in its
  /// place.
  Region slip_child(const Problem& problem, ContactId contact, Sign slip) const&;
  Region slip_child(const Problem& problem, ContactId contact, Sign slip) &&;
  Region separation_child(const Problem& problem, ContactId contact,
                          Separation closed_or_open) const&;
  Region separation_child(const Problem& problem, ContactId contact,
                          Separation closed_or_open) &&;
  Region plane_child(const IntegerVector5& plane, Side side) const&;
  Region plane_child(const IntegerVector5& plane, Side side) &&;
  /// \}
  /// Returns all children of a split, in the order of a tree.
  std::vector<Region> children(const Problem& problem, const ContactSplit& at) const;

  /// Returns the intersection with all of a slip state at once: contact i has label state[i].
  Region with_slip_state(const Problem& problem, const std::vector<Sign>& state) const;

  /// Returns what the signs of v_i on the cone say; under the bilateral law always closed.
  Separation separation(const Problem& problem, ContactId contact) const;

  /// Returns the sign of slip that every solution in the region has, so that friction is on one
  /// edge of its cone; nothing when friction may lie anywhere in it ("has the sign",
  /// FORMAT.md).
  std::optional<Sign> slip_sign(const Problem& problem, ContactId contact) const;

  /// \{ Returns the same with the signs on cone(), for callers who ask for many.
  static Separation separation(const Problem& problem, ContactId contact,
                               const ConeSigns& signs);
  std::optional<Sign> slip_sign(const Problem& problem, ContactId contact,
                                const ConeSigns& signs) const;
  /// \}

  /// Returns whether some strict function is 0 on all of these generators or rays of cone()
  /// (StrictConeOf::bars).
  bool bars(const std::vector<const Ray*>& rays) const {
    return StrictConeOf::bars(
        rays, [](const Ray* ray) -> const auto& { return ray->tight; });
  }
  /// Returns whether no solution has h = 0, as in root() and its parts.
  bool has_height() const { return !strict_.empty() && strict_.front() == 0; }

 private:
  explicit Region(const Problem& problem, Multiples multiples = Multiples::kZero)
      : StrictConeOf(multiples), labels_(problem.size()) {}

  bool any_multiple_ = false;  ///< only the load of its family grows
  std::vector<std::optional<Sign>> labels_;
};

/// Returns whether the virtual twist proves, by the rule leaf-bound, that the region has no
/// equilibrium, for any of the problem's multiples. O(m * generators) rational operations.
bool refutes(const Problem& problem, const Region& region, const TwistLeaf& leaf);

/// Returns the bound g(r) of leaf-bound on each of region.generators().
std::vector<Rational> work_bounds(const Problem& problem, const Region& region,
                                  const TwistLeaf& leaf);

}  // namespace stickslip
