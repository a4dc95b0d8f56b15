// SPDX-License-Identifier: MIT
#include "tree.hpp"

#include <algorithm>
#include <utility>

#include "leaf.hpp"

namespace stickslip_check {
namespace {

constexpr std::size_t kMoreDepth = 256;  // FORMAT.md `node-depth`
constexpr std::size_t kSettleEvery = 4;

/// FORMAT.md §4: d_j >= -B_j h for all j, and sum d_j / B_j <= D h.
std::vector<Condition> sides_of_simplex(const Vector& bound) {
  const std::size_t dimension = bound.size();
  std::vector<Condition> sides;
  Vector last(dimension + 2);
  last[dimension] = dimension;
  for (std::size_t j = 0; j < dimension; ++j) {
    Vector a(dimension + 2);
    a[j] = 1;
    a[dimension] = bound[j];
    sides.push_back({std::move(a)});
    last[j] = -1 / bound[j];
  }
  sides.push_back({std::move(last)});
  return sides;
}

/// d_j - B_j h and -d_j - B_j h for all j.
std::vector<Form> beyond(const Vector& bound) {
  std::vector<Form> functions;
  for (std::size_t j = 0; j < bound.size(); ++j) {
    for (const int sign : {1, -1}) {
      Vector a(bound.size() + 2);
      a[j] = sign;
      a[bound.size()] = -bound[j];
      functions.push_back(make_form(a));
    }
  }
  return functions;
}

/// FORMAT.md §4, "beyond the bound".
bool is_beyond(const std::vector<Form>& functions, const Generators& region) {
  return std::any_of(functions.begin(), functions.end(), [&](const Form& function) {
    bool barred = false;
    return side(region, {function}, &barred) > 0 && barred;
  });
}

}  // namespace

std::size_t most_depth(const Box& box) {
  return 2 * box.size() + kMoreDepth;
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

std::vector<Condition> conditions_of(const Range& range, std::size_t dimension) {
  const auto of_h_and_l = [&](const Rational& h, const Rational& l) {
    Vector a(dimension);
    a.insert(a.end(), {h, l});
    return a;
  };
  std::vector<Condition> conditions{{of_h_and_l(1, 0), false, true},
                                    {of_h_and_l(-range.low, 1), false, range.open_low}};
  if (range.high) {
    conditions.push_back({of_h_and_l(*range.high, -1), false, range.open_high});
  }
  return conditions;
}

std::vector<Root> roots_of(const Question& question, const std::vector<Range>& ranges) {
  const Vector bound = question.asked.max_motion.value_or(Vector{});
  std::vector<Root> roots;
  for (const Range& range : ranges) {
    roots.push_back(
        {question.box, conditions_of(range, question.dimension()), question.asked.bilateral});
    if (bound.empty()) continue;
    for (Condition& side : sides_of_simplex(bound)) roots.back().conditions.push_back(side);
    roots.back().beyond = beyond(bound);
  }
  return roots;
}

Root root_of(const Question& question, std::vector<Piece> pieces) {
  Vector height(question.dimension() + 1);
  height.back() = 1;
  Root root{question.box, {{height, false, true}}, question.asked.bilateral};
  root.pieces = std::make_shared<const std::vector<Piece>>(std::move(pieces));
  return root;
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
  const bool moves = node.kind == NodeKind::kMoving;
  if (node.kind != NodeKind::kLeaf && node.kind != NodeKind::kHeld && !moves) {
    push(node, std::move(region));
  } else {
    ++leaves_;
    try {
      if (node.kind == NodeKind::kHeld) {
        check_held(region, node.contact);
      } else if (moves) {
        check_moving(region, *node.moving);
      } else {
        check_leaf(std::move(region), node.numbers);
      }
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

TreeWalk::Region TreeWalk::begin(const Root& root) {
  const bool is_first = trees_ == 1;
  if (is_first || root.box != roots_[trees_ - 2].box) {
    doubles_ = make_doubles(*root.box);
    nothing_settled_ =
        doubles_ ? std::make_shared<const Settled>(*root.box, doubles_) : nullptr;
  }
  Region region{Cone(root.box->coordinates()), {}, root.box, nothing_settled_};
  for (const Condition& condition : root.conditions) {
    if (condition.strict) insert(region.strict.conditions, region.cone.cuts());
    region.cone = region.cone.cut(make_form(condition.a), condition.equality);
  }
  if (root.bilateral && doubles_) {
    region.cone = cut_by_normal_law(region.cone, *root.box, *doubles_);
  } else if (root.bilateral) {
    for (std::size_t i = 0; i < root.box->size(); ++i) {
      const Row& row = root.box->row(i);
      const bool may_open = !is_spring(root.box->contact(i).sight);
      if (may_open && row.v_certain) region.cone = region.cone.cut(row.v[0]);
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
            which == 0 ? parent.halves.low : parent.halves.high, nullptr};
  }
  if (!parent.slip.empty()) {
    Region region = parent.region;
    if (which == 1) {
      region.strict.slips.push_back(parent.node.contact.get_ui());
    } else {
      for (const Form& s : parent.slip) region.cone = region.cone.cut(s, true);
    }
    return region;
  }
  const bool middle = parent.children == 3 && which == 1;
  Region region{which == 0 || middle ? parent.region.cone.cut(parent.cut, middle)
                                     : parent.region.cone.cut(negative(parent.cut)),
                parent.region.strict, parent.region.box, parent.region.settled};
  const bool strict = parent.children == 3 ? !middle : which == 1;
  if (strict) insert(region.strict.conditions, parent.region.cone.cuts());
  return region;
}

/// What the region adds to what is settled above it, unless it is barred.
void TreeWalk::settle(Region& region, const Generators& generators) {
  if (!region.settled) return;
  contacts_visited_ += region.settled->unsettled().size();
  region.settled = std::make_shared<const Settled>(region.settled->within(generators));
}

/// Whether the region is barred or beyond the bound.
bool TreeWalk::stands_for_nothing(const Generators& generators) const {
  return generators.barred() || is_beyond(roots_[trees_ - 1].beyond, generators);
}

/// `leaf-bound`, `leaf-direction`.
void TreeWalk::check_leaf(Region region, const Vector& y) {
  const Generators generators(*region.box, region.cone, region.strict);
  if (stands_for_nothing(generators)) return;
  settle(region, generators);
  if (!region.settled || !region.settled->proves(generators, y)) {
    ++exact_leaves_;
    if (const auto found = leaf_refusal(*region.box, generators, y)) {
      throw rejection("leaf-bound", *found);
    }
  }
  const std::vector<Vector>& direction = roots_[trees_ - 1].direction;
  if (direction.empty()) return;
  Vector pull(y.size() + 2);
  for (std::size_t j = 0; j < y.size(); ++j) add(pull, y[j], direction[j]);
  if (side(generators, {make_form(pull)}) <= 0) {
    throw rejection("leaf-direction", "y.A(d - h d0) is below 0 somewhere");
  }
}

/// `moving-list`, `leaf-bound`, `leaf-direction`.
void TreeWalk::check_moving(const Region& region, const MovingTwist& twist) {
  if (const auto found = list_refusal(*region.box, twist)) throw rejection("moving-list", *found);
  const Generators generators(*region.box, region.cone, region.strict);
  if (stands_for_nothing(generators)) return;
  bool exact = false;
  const auto found = leaf_refusal(*region.box, generators, twist, &exact);
  if (exact) ++exact_leaves_;
  if (found) throw rejection("leaf-bound", *found);
  const std::vector<Vector>& direction = roots_[trees_ - 1].direction;
  if (direction.empty()) return;
  if (const auto below = direction_refusal(generators, twist, direction)) {
    throw rejection("leaf-direction", *below);
  }
}

/// `held-piece`, `held-inside`.
void TreeWalk::check_held(const Region& region, const Integer& piece) const {
  const std::vector<Piece>& pieces = *roots_[trees_ - 1].pieces;
  if (piece >= pieces.size()) {
    throw rejection("held-piece", "piece " + piece.get_str() + ", but there are " +
                                      std::to_string(pieces.size()));
  }
  for (const Generator& generator : Generators(*region.box, region.cone, region.strict)) {
    const Form& x = *generator.x;
    if (!pieces[piece.get_ui()].contains(load_part(x))) {
      throw rejection("held-inside", "the ray " + show(Vector(x.begin(), x.end())) +
                                         " has its load outside of piece " + piece.get_str());
    }
  }
}

void TreeWalk::push(const Node& node, Region region) {
  // At every node it would cost more than it saves.
  if (region.settled && stack_.size() % kSettleEvery == 0) {
    const Generators generators(*region.box, region.cone, region.strict);
    if (!generators.barred()) settle(region, generators);
  }
  Frame frame{node, {}, {}, {}, std::move(region), 2, 0};
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
    if (node.contact >= box.size()) {
      throw rejection("node-contact", "contact " + show(Rational(node.contact)) +
                                          ", but the grasp has " + std::to_string(box.size()));
    }
    const Row& row = box.row(node.contact.get_ui());
    const Sight& sight = box.contact(node.contact.get_ui()).sight;
    const bool slip = node.kind == NodeKind::kSlip;
    if (slip ? !is_contact(sight) : is_spring(sight)) {
      throw rejection("node-contact", node.contact.get_str() + " is " +
                                          (is_spring(sight) ? "a spring" : "a ratchet") +
                                          ", which does not " + (slip ? "slip" : "open"));
    }
    if (slip ? !row.slip_certain : !row.v_certain) {
      throw rejection("node-certain", (slip ? "T of contact " : "v of contact ") +
                                          node.contact.get_str() + " is uncertain");
    }
    if (slip && !row.has_edges()) {
      frame.slip = row.slips[0];
      frame.slip.erase(frame.slip.begin() + static_cast<std::ptrdiff_t>(row.product.left_out));
    } else {
      frame.cut = slip ? row.tau[0] : row.v[0];
      if (slip) frame.children = 3;
    }
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
    if (!frame.slip.empty()) {
      result += "slip " + frame.node.contact.get_str() + (child == 0 ? " 0" : " not 0");
    } else if (frame.node.kind == NodeKind::kSlip) {
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
