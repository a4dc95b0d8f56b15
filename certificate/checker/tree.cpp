// SPDX-License-Identifier: MIT
#include "tree.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace stickslip_check {
namespace {

constexpr unsigned kMaxPlanes = 64;

/// The cut and label of child number `child`.
Side side_of(NodeKind kind, unsigned child) {
  if (child == 0) return Side::kAtLeastZero;
  return kind == NodeKind::kSlip && child == 1 ? Side::kZero : Side::kAtMostZero;
}

std::string show_vector(const Vector& r) {
  return "(" + show(Rational(r.x[0])) + ", " + show(Rational(r.x[1])) + ", " +
         show(Rational(r.x[2])) + ", " + show(Rational(r.x[3])) + ")";
}

// In the next two, a line on which the form is not 0 has both signs by itself.

Gap gap_on(const Cone& region, const Vector& v) {
  for (const Vector& line : region.lines()) {
    if (sign_of_dot(v, line) != 0) return Gap::kMixed;
  }
  bool above = false;
  bool below = false;
  for (const auto& ray : region.rays()) {
    const int sign = sign_of_dot(v, ray->v);
    above = above || sign > 0;
    below = below || sign < 0;
    if (above && below) return Gap::kMixed;
  }
  return below ? Gap::kOpen : Gap::kClosed;
}

/// Whether a set of rays is barred: some strict function is zero on all of them. (On lines
/// every strict function is zero, as it has one sign on the region.)
bool barred(const std::vector<const Vector*>& rays, const std::vector<Vector>& strict) {
  return std::any_of(strict.begin(), strict.end(), [&](const Vector& s) {
    return std::all_of(rays.begin(), rays.end(),
                       [&](const Vector* r) { return sign_of_dot(s, *r) == 0; });
  });
}

bool barred(const Cone& region, const std::vector<Vector>& strict) {
  std::vector<const Vector*> rays;
  for (const auto& ray : region.rays()) rays.push_back(&ray->v);
  return barred(rays, strict);
}

/// The sign that a contact without a label has on a region that is not barred.
SlipSign sign_on(const Cone& region, const Vector& tau, const std::vector<Vector>& strict) {
  for (const Vector& line : region.lines()) {
    if (sign_of_dot(tau, line) != 0) return SlipSign::kNone;
  }
  bool plus = false;
  bool minus = false;
  std::vector<const Vector*> zero;
  for (const auto& ray : region.rays()) {
    const int sign = sign_of_dot(tau, ray->v);
    plus = plus || sign > 0;
    minus = minus || sign < 0;
    if (plus && minus) return SlipSign::kNone;
    if (sign == 0) zero.push_back(&ray->v);
  }
  if (!barred(zero, strict)) return SlipSign::kNone;
  return plus ? SlipSign::kPlus : SlipSign::kMinus;
}

}  // namespace

TreeWalk::TreeWalk(const std::vector<Row>& rows, Loads loads, bool bilateral)
    : problem_(make_problem(rows)),
      loads_(std::move(loads)),
      bilateral_(bilateral),
      status_(rows.size()),
      undecided_(rows.size()),
      undecided_count_(rows.size()),
      slip_on_path_(rows.size()),
      separation_on_path_(rows.size()) {
  std::iota(undecided_.begin(), undecided_.end(), std::size_t{0});
  strict_.push_back(make_vector(std::array<Integer, 4>{0, 0, 0, 1}));  // h
}

void TreeWalk::visit(const Node& node) {
  if (stack_.empty() && trees_ == loads_.ranges.size()) {
    throw Rejected{"tree-long", nodes_, "", "everything was complete before this node"};
  }
  Cone region;
  Aggregate decided;
  if (stack_.empty()) {
    begin_tree(region);
  } else {
    enter_child(region, decided);
  }
  const bool all_barred = barred(region, strict_);
  if (node.kind != NodeKind::kVoid && !all_barred) examine(region, decided);
  std::optional<Rejected> rejected;
  if (node.kind == NodeKind::kVoid) {
    if (!all_barred) {
      rejected = rejection("void-region", "no strict function is zero on the whole region");
    }
    ++voids_;
  } else if (node.kind == NodeKind::kLeaf) {
    std::optional<std::string> refusal = theta_refusal(node);
    if (refusal) {
      rejected = rejection("leaf-theta", *refusal);
    } else if (!all_barred && (refusal = leaf_refusal(node, region, decided))) {
      rejected = rejection("leaf-bound", *refusal);
    }
    ++leaves_;
  } else {
    push(node, std::move(region), std::move(decided));
  }
  ++nodes_;
  close_finished();
  if (rejected) throw Rejected(*rejected);
}

void TreeWalk::finish() const {
  if (trees_ < loads_.ranges.size() || !stack_.empty()) {
    throw Rejected{"tree-short", nodes_, path(1), "the list ends before this node"};
  }
}

/// The root of the next tree: its region, and what is known there without looking, nothing.
void TreeWalk::begin_tree(Cone& region) {
  ++trees_;
  go_back(0, undecided_.size(), 1);
  region = Cone::half_space();
  if (!bilateral_) return;
  for (const WalkContact& contact : problem_.contacts) {
    region = region.cut(contact.v, Side::kAtLeastZero);
  }
}

/// Forgets what came to be known since the trail had that size.
void TreeWalk::go_back(std::size_t trail, std::size_t undecided, std::size_t strict) {
  while (trail_.size() > trail) {
    status_[trail_.back().first] = trail_.back().second;
    trail_.pop_back();
  }
  undecided_count_ = undecided;
  strict_.resize(strict);
}

/// Goes to the next child of the innermost frame: its region, its label, and the statuses.
void TreeWalk::enter_child(Cone& region, Aggregate& decided) {
  Frame& parent = stack_.back();
  go_back(parent.trail, parent.undecided, parent.strict);
  const Side side = side_of(parent.kind, parent.next);
  region = parent.region.cut(parent.cut, side);
  decided = parent.decided;
  const bool first = parent.next == 0;
  if (parent.kind == NodeKind::kSlip ? side != Side::kZero : !first)
    strict_.push_back(parent.cut);
  // A contact that has the sign already keeps it: the child of the other sign, as that of 0, is
  // barred.
  Status status;
  if (parent.kind == NodeKind::kSlip && side != Side::kZero &&
      status_[parent.contact].sign == SlipSign::kNone) {
    status = status_[parent.contact];
    status.sign = side == Side::kAtLeastZero ? SlipSign::kPlus : SlipSign::kMinus;
    set_status(parent.contact, status);
  }
  ++parent.next;
}

/// Brings the statuses of the undecided contacts up to date with a region.
void TreeWalk::examine(const Cone& region, Aggregate& decided) {
  for (std::size_t k = 0; k < undecided_count_;) {
    const std::size_t i = undecided_[k];
    const WalkContact& contact = problem_.contacts[i];
    Status status = status_[i];
    if (status.gap == Gap::kMixed) status.gap = gap_on(region, contact.v);
    if (status.sign == SlipSign::kNone && status.gap != Gap::kOpen) {
      status.sign = sign_on(region, contact.tau, strict_);
    }
    if (status.gap != status_[i].gap || status.sign != status_[i].sign) set_status(i, status);
    const bool aggregated = status.gap == Gap::kClosed && status.sign != SlipSign::kNone;
    if (aggregated) add(decided, contact, status.sign);
    if (aggregated || status.gap == Gap::kOpen) {
      std::swap(undecided_[k], undecided_[--undecided_count_]);
    } else {
      ++k;
    }
  }
}

void TreeWalk::set_status(std::size_t contact, Status status) {
  trail_.emplace_back(contact, status_[contact]);
  status_[contact] = status;
}

void TreeWalk::push(const Node& node, Cone region, Aggregate decided) {
  std::size_t contact = 0;
  Vector cut;
  unsigned children = 2;
  if (node.kind == NodeKind::kPlane) {
    cut = make_vector({node.numbers[0], node.numbers[1], node.numbers[2], node.numbers[3]});
    if (planes_on_path_ == kMaxPlanes) {
      throw rejection("node-repeated", "more than 64 plane nodes on the path");
    }
    if (cut.x == std::array<Integer, 4>{0, 0, 0, 0}) throw rejection("node-plane", "a = 0");
    ++planes_on_path_;
  } else {
    const bool slip = node.kind == NodeKind::kSlip;
    const std::string name = "contact " + show(Rational(node.contact));
    if (node.contact >= problem_.contacts.size()) {
      throw rejection("node-contact",
                      name + ", but the grasp has " + std::to_string(problem_.contacts.size()));
    }
    if (!slip && bilateral_) {
      throw rejection("node-law", "a separation under the bilateral law");
    }
    contact = node.contact.get_ui();
    std::vector<bool>& on_path = slip ? slip_on_path_ : separation_on_path_;
    if (on_path[contact]) {
      throw rejection("node-repeated", name + " has such a node on the path already");
    }
    on_path[contact] = true;
    cut = slip ? problem_.contacts[contact].tau : problem_.contacts[contact].v;
    if (slip) children = 3;
  }
  stack_.push_back({node.kind, contact, std::move(cut), std::move(region), std::move(decided),
                    undecided_count_, trail_.size(), strict_.size(), children, 0});
}

/// Leaves the inner nodes whose children are all done.
void TreeWalk::close_finished() {
  while (!stack_.empty() && stack_.back().next == stack_.back().children) {
    const Frame& frame = stack_.back();
    if (frame.kind == NodeKind::kPlane) --planes_on_path_;
    if (frame.kind == NodeKind::kSlip) slip_on_path_[frame.contact] = false;
    if (frame.kind == NodeKind::kSeparation) separation_on_path_[frame.contact] = false;
    stack_.pop_back();
  }
}

std::optional<std::string> TreeWalk::theta_refusal(const Node& node) const {
  Integer above = -1;
  for (const auto& [contact, theta] : node.thetas) {
    const std::string name = "contact " + show(Rational(contact));
    if (contact <= above) return name + " is not above the one before";
    if (contact >= problem_.contacts.size()) return name + " does not exist";
    if (theta < 0 || theta > 1) {
      return name + " has theta = " + show(theta) + ", not in [0, 1]";
    }
    above = contact;
  }
  return std::nullopt;
}

std::optional<std::string> TreeWalk::leaf_refusal(const Node& node, const Cone& region,
                                                  const Aggregate& decided) {
  std::map<std::size_t, Rational> thetas;
  for (const auto& [contact, theta] : node.thetas) thetas.emplace(contact.get_ui(), theta);
  const std::vector<std::size_t> undecided(
      undecided_.begin(), undecided_.begin() + static_cast<std::ptrdiff_t>(undecided_count_));
  const Vector3 y{node.numbers[0], node.numbers[1], node.numbers[2]};
  const LoadRange& range = loads_.ranges[trees_ - 1];
  const int rise = sgn(dot(y, loads_.direction));
  if (rise > 0 && !range.high) return "y.u is above 0, and the multiples of u have no end";
  const Rational& worst = rise > 0 ? *range.high : range.low;
  const bool worst_is_a_load = rise == 0 || (rise < 0 && range.contains_low);
  const LeafBound bound(problem_, sum(loads_.wrench, worst, loads_.direction), status_,
                        undecided, decided, y, thetas);
  std::vector<const Vector*> flat;  // rays with g(r) = 0
  std::optional<std::string> refusal;
  const auto holds_on = [&](const Vector& r) {
    if (!exact_only_ && bound.upper(r) < 0) return true;
    ++exact_bounds_;
    const Rational g = bound.exact(r) / bound.scale();
    if (g > 0) refusal = "g = " + show(g) + " on the ray " + show_vector(r);
    return g < 0;
  };
  for (const Vector& line : region.lines()) {
    // Every strict function is zero on a line, so a line with g = 0 spoils no barred set.
    holds_on(line);
    holds_on(negative(line));
    if (refusal) return refusal;
  }
  for (const auto& ray : region.rays()) {
    if (!holds_on(ray->v)) flat.push_back(&ray->v);
    if (refusal) return refusal;
  }
  if (!worst_is_a_load || barred(flat, strict_)) return std::nullopt;
  return "g = 0 on rays that are not barred, of which one is " + show_vector(*flat.front());
}

/// The path to the child that the innermost frame has come to, or with `ahead` = 1 will come
/// to.
std::string TreeWalk::path(unsigned ahead) const {
  std::string result;
  for (const Frame& frame : stack_) {
    if (!result.empty()) result += ", ";
    const unsigned child = frame.next - 1 + (&frame == &stack_.back() ? ahead : 0);
    const char* sign = child == 0 ? "+" : (frame.children == 3 && child == 1 ? "0" : "-");
    if (frame.kind == NodeKind::kSlip) {
      result += "slip " + std::to_string(frame.contact) + " " + sign;
    } else if (frame.kind == NodeKind::kSeparation) {
      result +=
          "separation " + std::to_string(frame.contact) + (child == 0 ? " closed" : " open");
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
