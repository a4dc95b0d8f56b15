// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves of trees where they just hold and just do not: the search refutes a region by a twist
// where the checker, which shares nothing with it, accepts the leaf, and nowhere else.
#include <gtest/gtest.h>

#include <iostream>

#include "both_checkers.hpp"
#include "random_grasps.hpp"
#include "rounds.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/motion_region.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

/// What is uncertain, or rubs as a soft finger does.
struct Kind {
  const char* name;
  bool in_space = true;
  bool torsion = false;
  bool numbers = false;  ///< friction, preload and stiffness
  bool position = false;
  bool normal = false;
  bool close = false;        ///< planes that are nearly the same, and so are slips
  bool along_slips = false;  ///< planes where slips are half of all, or a quarter
  bool moving = false;       ///< twists that move, and bounded motions
};

std::string quoted(const Rational& value) {
  return "\"" + value.str() + "\"";
}

std::string number(const Rational& middle, const Rational& radius) {
  if (radius.is_zero()) return quoted(middle);
  return R"({"min": )" + quoted(middle - radius) + R"(, "max": )" + quoted(middle + radius) +
         "}";
}

std::string list(const std::vector<std::string>& entries) {
  std::string result;
  for (const std::string& entry : entries) result += (result.empty() ? "" : ", ") + entry;
  return "[" + result + "]";
}

/// Contacts that push upwards, and a load that pulls so.
std::string random_file(RandomSource& random, const Kind& kind) {
  const std::size_t d = kind.in_space ? 3 : 2;
  const Rational part(1, 50);
  std::vector<std::string> contacts;
  const int count = random.between(1, 3);
  for (int i = 0; i < count; ++i) {
    std::vector<std::string> position;
    std::vector<std::string> normal;
    for (std::size_t k = 0; k < d; ++k) {
      const bool is_up = k + 1 == d;
      position.push_back(
          number(Rational(random.between(-6, 6), 3), kind.position ? part : Rational(0)));
      normal.push_back(quoted(is_up ? random.between(2, 4) : random.between(-1, 1)));
    }
    const std::string direction = list(normal);
    const auto about = [&](const Rational& middle) {
      return number(middle, kind.numbers ? middle * 5 * part : Rational(0));
    };
    contacts.push_back(
        std::string("{") +
        (kind.torsion
             ? R"("of": "body", "torsion": )" + quoted(Rational(random.between(1, 4), 3)) + ", "
             : "") +
        R"("position": )" + list(position) + R"(, "normal": )" +
        (kind.normal ? R"({"direction": )" + direction + R"(, "slope": "1/20"})" : direction) +
        R"(, "friction": )" + about(Rational(random.between(0, 3), 4)) + R"(, "preload": )" +
        about(random.between(0, 2)) + R"(, "stiffness": )" + about(random.between(1, 3)) + "}");
  }
  const int aside = random.between(-1, 1);
  if (kind.torsion) {
    return R"({"format": "stickslip-grasp/3", "bodies": [{"name": "body"}], "contacts": )" +
           list(contacts) + R"(, "loads": [{"body": "body", "force": [)" + quoted(aside) +
           R"(, "0", "3"], "at": ["0", "0", "0"]}]})";
  }
  std::vector<std::string> wrench(kind.in_space ? 6 : 3, quoted(0));
  for (std::size_t j = 0; j < wrench.size(); ++j) {
    const int middle = j == 0 ? aside : j + 1 == d ? 3 : 0;
    wrench[j] = number(middle, kind.numbers ? part : Rational(0));
  }
  return R"({"format": "stickslip-grasp/2", "contacts": )" + list(contacts) +
         R"(, "wrench": )" + list(wrench) + "}";
}

/// First children all the way, so that what follows is missing only after the leaf.
MotionRegion descended(RandomSource& random, const Kind& kind, const GraspLaw& law,
                       Trees& tree) {
  const std::int64_t many = std::int64_t{1} << random.between(20, 50);
  MotionRegion region = MotionRegion::root(law);
  const int depth = random.between(0, law.motions == 3 ? 5 : 10);  // until slips are pointed
  for (int k = 0; k < depth; ++k) {
    const auto contact =
        static_cast<std::size_t>(random.between(0, static_cast<int>(law.contacts.size()) - 1));
    const LawContact& c = law.contacts[contact];
    if (random.between(0, 2) == 0 && c.has_certain_separation) {
      tree.emplace_back(SeparationSplit{ContactId(contact)});
      region = region.halves(c.separations.front()).front();
      continue;
    }
    Row plane(law.coordinates());
    if (kind.along_slips && random.between(0, 2) == 0) {
      const std::vector<Row>& slip = c.corners.front().slip;
      plane =
          slip[static_cast<std::size_t>(random.between(0, static_cast<int>(slip.size()) - 1))];
      plane.resize(law.coordinates());
      if (random.between(0, 1) == 0) plane = negated(plane);
      if (is_zero(plane)) continue;
      tree.emplace_back(PlaneCut{plane});
      region = region.halves(plane).front();
      continue;
    }
    const bool is_sparse = random.between(0, 1) == 0;  // so that cones are half a plane
    for (std::size_t j = 0; j < law.motions; ++j) {
      if (!is_sparse || random.between(0, 3) == 0) plane[j] = random.between(-2, 2);
      if (kind.close) plane[j] = plane[j] * many + random.between(-1, 1);
    }
    plane[law.motions] = random.between(-2, 1);
    if (is_zero(plane)) continue;
    plane = primitive(plane);
    tree.emplace_back(PlaneCut{plane});
    region = region.halves(plane).front();
  }
  return region;
}

/// Returns random kappa and psi of each contact, then c, as multiples of those of a leaf.
RationalRow random_own(RandomSource& random, const GraspLaw& law) {
  RationalRow own;
  for (const LawContact& c : law.contacts) {
    Rational rate = Rational(random.between(0, 2), 8);
    RationalRow slip;
    for (std::size_t k = 0; k < c.slip_numbers(); ++k) {
      slip.push_back(Rational(random.between(-1, 1), 16));
      rate += abs(slip.back()) * (1 + c.spin_weight);
    }
    own.push_back(rate);
    own.insert(own.end(), slip.begin(), slip.end());
  }
  own.push_back(Rational(random.between(-1, 4), 8));
  return own;
}

/// Returns the leaf with these numbers, y first, in integers.
MovingLeaf moving_leaf(const GraspLaw& law, RationalRow y, const RationalRow& own) {
  y.insert(y.end(), own.begin(), own.end());
  const Row whole = primitive_multiple(y);
  auto next = whole.begin() + static_cast<std::ptrdiff_t>(law.motions);
  MovingLeaf leaf{{whole.begin(), next}, whole.back(), {}};
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    const auto end = next + 1 + static_cast<std::ptrdiff_t>(law.contacts[i].slip_numbers());
    leaf.own.push_back({ContactId(i), *next, {next + 1, end}});
    next = end;
  }
  return leaf;
}

struct Counts {
  int held = 0;
  int lost = 0;  ///< by the search alone
};

void expect_alike(RandomSource& random, const Kind& kind, Counts& counts) {
  const std::string file = random_file(random, kind);
  SCOPED_TRACE(file);
  QuestionOptions options;
  if (random.between(0, 3) == 0) options.law = NormalLaw::kBilateral;
  if (kind.moving) {
    options.max_motion = MotionBound{RationalRow(kind.in_space ? 6 : 3, Rational(1))};
  }
  const Question question = ask(parse_any_grasp(file, kind.name), options);
  const GraspLaw law(question.grasp.as_box(), question.law, kDefaultBits);
  Trees tree;
  const MotionRegion region = descended(random, kind, law, tree);
  if (region.is_barred()) return;
  RationalRow from(law.motions);
  from[kind.in_space ? 2 : 1] = -1;
  RationalRow along(law.motions);
  for (Rational& entry : along)
    entry = random.between(0, 1) * Rational(random.between(-9, 9), 8);
  const RationalRow own = kind.moving ? random_own(random, law) : RationalRow();
  const auto leaf_at = [&](const Rational& part) -> TreeNode {
    RationalRow y = from;
    for (std::size_t j = 0; j < y.size(); ++j) y[j] += part * along[j];
    if (kind.moving) return moving_leaf(law, std::move(y), own);
    return TwistLeaf{primitive_multiple(y)};
  };
  const auto is_refuted = [&](const Rational& part) {
    const TreeNode leaf = leaf_at(part);
    const auto* moving = std::get_if<MovingLeaf>(&leaf);
    if (moving != nullptr) return region.is_refuted(*moving, nullptr);
    return region.is_refuted(std::get<TwistLeaf>(leaf).twist, nullptr);
  };
  const auto holds = [&](const Rational& part) {
    Trees leaf = tree;
    leaf.push_back(leaf_at(part));
    const test::CheckerAnswer answer = test::ask_cpp_checker(
        {file, certificate_text(question, Unstable{std::move(leaf)}, "a test"), options});
    EXPECT_TRUE(answer.result == "accepted" || answer.rule == "leaf-bound" ||
                answer.rule == "tree-short")
        << describe(answer);
    return answer.rule != "leaf-bound";
  };
  if (!is_refuted(0)) {
    EXPECT_FALSE(holds(0));
    return;
  }
  Rational low = 0;
  Rational high = 4;
  if (is_refuted(high)) return;
  const int halvings = kind.close ? 90 : 30;
  for (int k = 0; k < halvings; ++k) {
    const Rational middle = (low + high) / 2;
    (is_refuted(middle) ? low : high) = middle;
  }
  ++counts.held;
  EXPECT_TRUE(holds(low)) << "at " << low;
  if (holds(high)) ++counts.lost;
}

TEST(Leaves, HoldWhereTheCheckerSaysSo) {
  RandomSource random(11);
  for (const Kind& kind :
       {Kind{"plane", false}, Kind{"plane box", false, false, true, true, true}, Kind{"space"},
        Kind{"numbers", true, false, true}, Kind{"positions", true, false, false, true},
        Kind{"normals", true, false, false, false, true}, Kind{"soft", true, true},
        Kind{"soft box", true, true, true, true},
        Kind{"close", true, false, false, false, false, true},
        Kind{"soft and close", true, true, false, false, false, true},
        Kind{"slips", true, false, false, false, false, false, true},
        Kind{"soft slips", true, true, false, false, false, false, true},
        Kind{"plane, moving", false, false, false, false, false, false, false, true},
        Kind{"plane box, moving", false, false, true, true, true, false, false, true},
        Kind{"space, moving", true, false, false, false, false, false, false, true},
        Kind{"space box, moving", true, false, true, true, true, false, false, true},
        Kind{"soft box, moving", true, true, true, true, false, false, false, true}}) {
    Counts counts;
    const int rounds = test::rounds(kind.along_slips ? 600 : kind.moving ? 400 : 200);
    for (int round = 0; round < rounds; ++round) expect_alike(random, kind, counts);
    std::cout << kind.name << ": " << counts.held << " thresholds, " << counts.lost
              << " below the checker's\n";
    EXPECT_GE(counts.held, test::rounds(kind.moving ? 8 : 30)) << kind.name;
    EXPECT_EQ(kind.close ? 0 : counts.lost, 0) << kind.name;
  }
}

}  // namespace
}  // namespace stickslip
