// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_refutation.hpp"

#include <set>
#include <sstream>
#include <stdexcept>

#include "engine/planar/region.hpp"
#include "naive_region.hpp"

namespace stickslip::test {
namespace {

constexpr int kMaxPlanes = 64;

class RuleBroken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a node of the tree inherits.
struct Place {
  Region region;
  NaiveRegion naive;
  std::set<std::size_t> slips;
  std::set<std::size_t> separations;
  int planes = 0;
};

class Walker {
 public:
  Walker(const Problem& problem, const Trees& refutation, RaysFrom rays_from)
      : problem_(problem), refutation_(refutation), rays_from_(rays_from) {}

  void walk_all() {
    walk({Region::root(problem_), NaiveRegion::root(problem_), {}, {}, 0});
    demand(next_ == refutation_.size(), "tree-long");
  }

 private:
  void demand(bool holds, const char* rule) const {
    if (!holds) throw RuleBroken("node " + std::to_string(node_) + ": " + rule);
  }

  void walk(const Place& place) {
    demand(next_ < refutation_.size(), "tree-short");
    node_ = next_++;
    std::visit([&](const auto& node) { visit(place, node); }, refutation_[node_]);
  }

  void visit(const Place& place, const SlipSplit& node) {
    const std::size_t contact = checked(node.contact);
    demand(place.slips.count(contact) == 0, "node-repeated");
    for (const int slip : {1, 0, -1}) {
      Place child = place;
      child.region = place.region.slip_child(problem_, node.contact, sign_of_int(slip));
      child.naive = place.naive.slip_child(problem_, contact, slip);
      child.slips.insert(contact);
      walk(child);
    }
  }

  void visit(const Place& place, const SeparationSplit& node) {
    const std::size_t contact = checked(node.contact);
    demand(problem_.law() == NormalLaw::kUnilateral, "node-law");
    demand(place.separations.count(contact) == 0, "node-repeated");
    for (const bool closed : {true, false}) {
      Place child = place;
      child.region = place.region.separation_child(
          problem_, node.contact, closed ? Separation::kClosed : Separation::kOpen);
      child.naive = place.naive.separation_child(problem_, contact, closed);
      child.separations.insert(contact);
      walk(child);
    }
  }

  void visit(const Place& place, const PlaneCut& node) {
    demand(place.planes < kMaxPlanes, "node-repeated");
    demand(!is_zero(node.plane), "node-plane");
    const auto plane = vector_of<5>(node.plane);
    for (const bool first : {true, false}) {
      Place child = place;
      child.region = place.region.plane_child(plane, first ? Side::kPositive : Side::kNegative);
      child.naive = place.naive.plane_child(to_rational(plane), first);
      ++child.planes;
      walk(child);
    }
  }

  void visit(const Place& place, const TwistLeaf& node) const {
    const Rays generators = rays(place);
    demand(place.region.is_barred() == naive_is_barred(place.naive, generators),
           "is_barred disagrees with its twin");
    const bool holds = naive_refutes(problem_, place.naive, generators, node);
    demand(refutes(problem_, place.region, node) == holds, "refutes disagrees with its twin");
    demand(holds, "leaf-bound");
  }

  void visit(const Place& /*place*/, const PartSplit& /*node*/) const {
    demand(false, "node-kind");
  }

  void visit(const Place& /*place*/, const MovingLeaf& /*node*/) const {
    demand(false, "node-kind");
  }

  std::size_t checked(ContactId contact) const {
    demand(contact.index() < problem_.size(), "node-contact");
    return contact.index();
  }

  Rays rays(const Place& place) const {
    if (rays_from_ == RaysFrom::kBruteForce) {
      return brute_force_generators(place.naive.constraints).directions();
    }
    Rays result;
    for (const Ray& ray : place.region.generators(problem_)) {
      result.push_back(to_rational(ray.x));
      for (const Constraint& c : place.naive.constraints) {
        demand(c.holds_at(result.back()), "a ray of the region breaks one of its constraints");
      }
    }
    return result;
  }

  const Problem& problem_;
  const Trees& refutation_;
  const RaysFrom rays_from_;
  std::size_t next_ = 0;
  std::size_t node_ = 0;
};

struct Printer {
  std::ostringstream& out;

  void operator()(const SlipSplit& node) const { out << "slip " << node.contact.index(); }
  void operator()(const SeparationSplit& node) const {
    out << "separation " << node.contact.index();
  }
  void operator()(const PlaneCut& node) const {
    out << "plane";
    for (const Integer& entry : node.plane) out << ' ' << entry;
  }
  void operator()(const PartSplit& node) const { out << "part " << node.index; }
  void operator()(const MovingLeaf& /*node*/) const { out << "moving"; }
  void operator()(const TwistLeaf& node) const {
    out << "leaf";
    for (const Integer& entry : node.twist) out << ' ' << entry;
  }
};

}  // namespace

std::optional<std::string> check_refutation(const Problem& problem, const Trees& refutation,
                                            RaysFrom rays_from) {
  try {
    Walker(problem, refutation, rays_from).walk_all();
  } catch (const RuleBroken& broken) {
    return broken.what();
  }
  return std::nullopt;
}

std::string to_text(const Trees& refutation) {
  std::ostringstream out;
  for (const TreeNode& node : refutation) {
    std::visit(Printer{out}, node);
    out << '\n';
  }
  return out.str();
}

}  // namespace stickslip::test
