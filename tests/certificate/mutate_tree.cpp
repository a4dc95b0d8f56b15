// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

constexpr std::size_t kMoreDepth = 256;

std::size_t child_count(const Json& node) {
  const std::string kind = node[0].get<std::string>();
  if (kind == "slip") return 3;
  return kind == "separation" || kind == "plane" ? 2 : 0;
}

/// One past the last node of the subtree at `root`.
std::size_t end_of(const Json& tree, std::size_t root) {
  std::size_t open = 1;
  std::size_t at = root;
  while (open > 0) open += child_count(tree[at++]) - 1;
  return at;
}

/// The nodes above a node, from the root.
std::vector<std::size_t> ancestors(const Json& tree, std::size_t node) {
  std::vector<std::size_t> result;
  for (std::size_t at = 0; at < node; ++at) {
    if (node < end_of(tree, at)) result.push_back(at);
  }
  return result;
}

class TreeMutations {
 public:
  TreeMutations(RandomSource& random, const Certified& original, Mutants& mutants)
      : random_(random),
        original_(original),
        mutants_(mutants),
        json_(Json::parse(original.text)),
        contacts_(json_["question"]["contacts"].get<std::size_t>()) {}

  void run() {
    whole_lists();
    drop_and_double();
    swap_children();
    contacts();
    inserted();
    leaves();
    equivalent();
  }

 private:
  using Nodes = std::vector<Json>;

  void add(const std::string& kind, const Nodes& tree, Expectation expected = {}) {
    Json edited = json_;
    edited["tree"] = tree;
    mutants_.push_back(mutant(kind, original_, edited, std::move(expected)));
  }

  Nodes nodes() const { return json_["tree"].get<Nodes>(); }
  const Json& tree() const { return json_["tree"]; }

  /// A random node of one of the kinds.
  std::optional<std::size_t> find(std::initializer_list<const char*> kinds) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < tree().size(); ++i) {
      const std::string kind = tree()[i][0].get<std::string>();
      if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) found.push_back(i);
    }
    if (found.empty()) return std::nullopt;
    return random_.pick(found);
  }

  /// The list with the node at `at` replaced by others.
  Nodes with(std::size_t at, const Nodes& others) const {
    Nodes result = nodes();
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(at));
    result.insert(result.begin() + static_cast<std::ptrdiff_t>(at), others.begin(),
                  others.end());
    return result;
  }

  void whole_lists() {
    add("empty tree", {}, Expectation::of_rule("tree-short", 0));
    Nodes longer = nodes();
    longer.push_back({"leaf", 0, 0, 0});
    add("extra node", longer, Expectation::of_rule("tree-long", tree().size()));
    Nodes shorter = nodes();
    shorter.pop_back();
    add("drop last node", shorter, Expectation::of_rule("tree-short", shorter.size()));
    add("zero leaf at the root", {Json{"leaf", 0, 0, 0}});
    std::reverse(longer.begin(), longer.end());
    add("reverse", longer, Expectation::rejected());  // has one node too many
  }

  // A list of nodes is a tree only if the numbers of children add up to one less than its
  // nodes; dropping or doubling a node or a subtree changes that.
  void drop_and_double() {
    const std::size_t at = any_of(random_, tree());
    add("drop node", with(at, {}), Expectation::rejected());
    add("double node", with(at, {tree()[at], tree()[at]}), Expectation::rejected());
    const std::size_t end = end_of(tree(), at);
    Nodes dropped = nodes();
    dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(at),
                  dropped.begin() + static_cast<std::ptrdiff_t>(end));
    add("drop child", dropped, Expectation::rejected());
    Nodes cut = nodes();
    cut.resize(at);
    add("cut list", cut, Expectation::of_rule("tree-short", at));
  }

  void swap_children() {
    const auto at = find({"slip", "separation", "plane"});
    if (!at) return;
    std::vector<Nodes> children;
    std::size_t next = *at + 1;
    for (std::size_t k = 0; k < child_count(tree()[*at]); ++k) {
      const std::size_t end = end_of(tree(), next);
      children.emplace_back(tree().begin() + static_cast<std::ptrdiff_t>(next),
                            tree().begin() + static_cast<std::ptrdiff_t>(end));
      next = end;
    }
    const auto last = static_cast<int>(children.size()) - 1;
    const auto a = static_cast<std::size_t>(random_.between(0, last - 1));
    std::swap(
        children[a],
        children[static_cast<std::size_t>(random_.between(static_cast<int>(a) + 1, last))]);
    Nodes result(tree().begin(), tree().begin() + static_cast<std::ptrdiff_t>(*at + 1));
    for (const Nodes& child : children) result.insert(result.end(), child.begin(), child.end());
    result.insert(result.end(), tree().begin() + static_cast<std::ptrdiff_t>(next),
                  tree().end());
    add("swap children", result);
  }

  void contacts() {
    if (const auto at = find({"slip", "separation"})) {
      Json node = tree()[*at];
      const auto contact = node[1].get<std::size_t>();
      node[1] = (contact + 1) % contacts_;
      add("shift contact", with(*at, {node}));
      node[1] = contacts_;
      add("contact beyond", with(*at, {node}), Expectation::of_rule("node-contact", *at));
      node[1] = std::int64_t{1} << random_.between(31, 62);
      add("contact far beyond", with(*at, {node}), Expectation::of_rule("node-contact", *at));
      node[1] = -1;
      add("negative contact", with(*at, {node}), Expectation::malformed());
      node = tree()[*at];
      node[0] = node[0] == "slip" ? "separation" : "slip";
      add("slip for separation", with(*at, {node}));
    }
    if (const auto at = find({"leaf"})) {
      const Json& leaf = tree()[*at];
      for (const std::size_t above : ancestors(tree(), *at)) {
        const Json& split = tree()[above];
        if (split[0] == "plane") continue;
        Nodes repeated(1 + child_count(split), leaf);
        repeated[0] = split;
        add("repeat contact", with(*at, repeated), Expectation::accepted());
        break;
      }
    }
  }

  /// Inner nodes in place of a leaf: all before them is as it was and holds.
  void inserted() {
    const auto at = find({"leaf"});
    if (!at) return;
    const Json& leaf = tree()[*at];
    add("zero plane", with(*at, {{"plane", 0, 0, "0/7", 0}, leaf, {"leaf", 0, 0, 0}}),
        Expectation::accepted());
    // The leaf's twist need not serve in a part of its region: what a contact does at most is
    // different there. So this is for the third opinion.
    add("split leaf by a plane", with(*at, {{"plane", 1, "-2/3", 5, -1}, leaf, leaf}));
    if (random_.one_in(12)) too_deep(*at);
  }

  void too_deep(std::size_t at) {
    const std::size_t above = ancestors(tree(), at).size();
    const std::size_t most = 2 * contacts_ + kMoreDepth;
    for (const std::size_t depth : {most, most + 1}) {
      Nodes chain(depth - above, Json{"plane", 0, 0, 0, 0});
      chain.push_back(tree()[at]);
      chain.insert(chain.end(), depth - above, Json{"leaf", 0, 0, 0});
      add("deep tree", with(at, chain),
          depth == most ? Expectation::accepted()
                        : Expectation::of_rule("node-depth", at + depth - above));
    }
  }

  void leaves() {
    if (const auto at = find({"plane"})) {
      Json plane = tree()[*at];
      const std::size_t j = 1 + static_cast<std::size_t>(random_.between(0, 3));
      plane[j] = json_of(-number_of(plane[j]));
      add("flip sign in plane", with(*at, {plane}));
      plane[j] = json_of(number_of(plane[j]) + Rational(1, 3));
      add("perturb plane", with(*at, {plane}));
    }
    if (const auto at = find({"leaf"})) {
      const Json& leaf = tree()[*at];
      const std::size_t j = 1 + static_cast<std::size_t>(random_.between(0, 2));
      Json edited = leaf;
      edited[j] = json_of(-number_of(edited[j]));
      add("flip sign in leaf", with(*at, {edited}));
      edited = leaf;
      for (const std::size_t k : {1, 2, 3}) edited[k] = json_of(-number_of(edited[k]));
      add("flip leaf", with(*at, {edited}));
      edited = leaf;
      const Rational step = random_.pick<Rational>({1, -1, Rational(1, 1000), Rational(-7, 3)});
      edited[j] = json_of(number_of(edited[j]) + step);
      add("perturb leaf", with(*at, {edited}));
      add("zero leaf", with(*at, {{"leaf", 0, 0, 0}}));
      const auto other = find({"leaf"});
      Nodes exchanged = nodes();
      std::swap(exchanged[*at], exchanged[*other]);
      add("exchange leaves", exchanged);
    }
  }

  void equivalent() {
    if (const auto at = find({"leaf", "plane"})) {
      const Rational factor = random_.pick<Rational>({2, Rational(3, 7), 1000000007});
      Json scaled = tree()[*at];
      Json unreduced = scaled;
      const std::size_t count = scaled[0] == "leaf" ? 3 : 4;
      for (std::size_t j = 1; j <= count; ++j) {
        const Rational value = number_of(scaled[j]);
        scaled[j] = json_of(factor * value);
        unreduced[j] = to_string(Rational(numerator(value) * 6)) + "/00" +
                       to_string(Rational(denominator(value) * 6));
      }
      add("scale by a positive number", with(*at, {scaled}), Expectation::accepted());
      add("fractions not in lowest terms", with(*at, {unreduced}), Expectation::accepted());
    }
  }

  RandomSource& random_;
  const Certified& original_;
  Mutants& mutants_;
  const Json json_;
  const std::size_t contacts_;
};

}  // namespace

void mutate_tree(RandomSource& random, const Certified& original, Mutants& mutants) {
  TreeMutations(random, original, mutants).run();
}

}  // namespace stickslip::test
