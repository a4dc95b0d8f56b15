// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning on both sides of its border, and the exact program of the preloads against a
// naive one.
#include "stickslip/measures/model_warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Rational kTiny = parse_rational("1e-18");

Question question(Grasp grasp, const Wrench& w = {}, std::vector<ContactId> assumed = {}) {
  Question asked;
  asked.grasp = LoadedGrasp{std::move(grasp), w};
  asked.assumed_stiffness = std::move(assumed);
  return asked;
}

std::vector<ModelWarning> model_warnings(const Question& asked, const Verdict& verdict) {
  Answer answer{asked, verdict};
  answer.problem = problem_of(asked);
  return stickslip::model_warnings(answer);
}

std::vector<ModelTrap> traps(const Question& asked, const Verdict& verdict) {
  std::vector<ModelTrap> found;
  for (const ModelWarning& warning : model_warnings(asked, verdict)) {
    EXPECT_EQ(warning.text.find('\n'), std::string::npos);
    found.push_back(warning.trap);
  }
  return found;
}

/// As `decide` answers.
std::vector<ModelTrap> traps(const Question& asked) {
  return traps(asked, decide(Problem(asked.loaded(), asked.law)).verdict);
}

/// Contacts at (-1, 0) and (1, 0), facing each other.
Grasp pinch(const Rational& preload = 0) {
  return Grasp({{{-1, 0}, {1, 0}, 1, 1, preload}, {{1, 0}, {-1, 0}, 1, 1, preload}});
}

Stable moved(const Twist& d, std::size_t contacts) {
  return Stable{Witness{d, std::vector<ContactForce>(contacts)}};
}

TEST(LargeMotion, BeginsBeyondOneRadian) {
  const Question asked = question(pinch());
  EXPECT_THAT(traps(asked, moved({0, 0, 1}, 2)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, 0, -1}, 2)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, 0, 1 + kTiny}, 2)), ElementsAre(ModelTrap::kLargeMotion));
  EXPECT_THAT(traps(asked, moved({0, 0, -1 - kTiny}, 2)), ElementsAre(ModelTrap::kLargeMotion));
}

TEST(LargeMotion, BeginsBeyondTheWidthOfTheGrasp) {
  const Question asked = question(pinch());
  EXPECT_THAT(traps(asked, moved({0, 2, 0}, 2)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, 2 + kTiny, 0}, 2)), ElementsAre(ModelTrap::kLargeMotion));
  // Contact 1 moves by (0, 1 + 1).
  EXPECT_THAT(traps(asked, moved({0, 1, 1}, 2)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, 1 + kTiny, 1}, 2)), ElementsAre(ModelTrap::kLargeMotion));
}

TEST(LargeMotion, IsThatOfTheContactsWhateverTheOrigin) {
  // The same motions of the pinch at (100, 0): the origin itself moves far.
  const Question asked =
      question(Grasp({{{99, 0}, {1, 0}, 1, 1, 0}, {{101, 0}, {-1, 0}, 1, 1, 0}}));
  EXPECT_THAT(traps(asked, moved({0, -99, 1}, 2)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, -99 + kTiny, 1}, 2)),
              ElementsAre(ModelTrap::kLargeMotion));
}

TEST(LargeMotion, OneContactHasNoWidth) {
  const Question asked = question(Grasp({{{0, 0}, {0, 1}, 1, 1, 0}}));
  EXPECT_THAT(traps(asked, moved({1000, 0, 1}, 1)), IsEmpty());
  EXPECT_THAT(traps(asked, moved({0, 0, 2}, 1)), ElementsAre(ModelTrap::kLargeMotion));
  EXPECT_THAT(traps(question(Grasp()), moved({1000, 0, 1}, 0)), IsEmpty());
}

TEST(LargeMotion, SaysHowLargeAndWhatStiffnessWasTaken) {
  const std::string text =
      "the motion found is too large for the model: a turn by 350 radians, contact 0 moves by "
      "351 in a grasp 2 wide";
  Question asked = question(pinch());
  // Of an unstable verdict nothing moves.
  EXPECT_THAT(model_warnings(asked, Unstable{}), IsEmpty());
  const auto given = model_warnings(asked, moved({0, -1, 350}, 2));
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given[0].text, text);
  asked.assumed_stiffness = {ContactId(1)};
  const auto assumed = model_warnings(asked, moved({0, -1, 350}, 2));
  ASSERT_EQ(assumed.size(), 1U);
  EXPECT_EQ(assumed[0].text, "stiffness that is not given was taken as 1, with which " + text);
}

/// Fig. 1, with this friction. The preloads add up to (0, P), and two contacts can bring up
/// friction of 2 mu P against it.
Grasp fig1_with_friction(const Rational& friction) {
  std::vector<Contact> contacts = test::fig1_grasp(3).contacts();
  for (Contact& c : contacts) c.friction = friction;
  return Grasp(std::move(contacts));
}

TEST(UnbalancedPreload, BeginsWhereFrictionCannotBalanceIt) {
  const Verdict unknown = Undecided{};
  EXPECT_THAT(traps(question(fig1_with_friction(Rational(1, 2))), unknown), IsEmpty());
  const Question asked = question(fig1_with_friction(Rational(1, 2) - kTiny));
  EXPECT_THAT(traps(asked, unknown), ElementsAre(ModelTrap::kUnbalancedPreload));
  // Whatever the load and the verdict.
  EXPECT_THAT(traps(question(asked.loaded().grasp, {0, -3, 0})),
              ElementsAre(ModelTrap::kUnbalancedPreload));
}

TEST(UnbalancedPreload, IsAboutTheMotionZero) {
  // Preloads 1 and 2 find their balance after a motion.
  const Question asked =
      question(Grasp({{{-1, 0}, {1, 0}, 1, 1, 1}, {{1, 0}, {-1, 0}, 1, 1, 2}}));
  EXPECT_TRUE(
      std::holds_alternative<Stable>(decide(Problem(asked.loaded(), asked.law)).verdict));
  EXPECT_THAT(traps(asked), ElementsAre(ModelTrap::kUnbalancedPreload));
}

/// The system itself: sum P_i N_i + b_i T_i = 0, |b_i| <= mu_i P_i, a variable per contact.
bool balances_naively(const Problem& problem) {
  LinearProgram program;
  program.add_variables(problem.size(), VariableKind::kFree);
  std::array<std::vector<Rational>, 3> balance;
  Vector3 preload{};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    for (std::size_t j = 0; j < 3; ++j) {
      balance[j].push_back(coordinates(row.tangent)[j]);
      preload[j] += row.preload * coordinates(row.normal)[j];
    }
    std::vector<Rational> one(i + 1);
    one[i] = 1;
    const Rational most = row.friction * row.preload;
    program.add_row(one, Relation::kLessEqual, most);
    program.add_row(one, Relation::kGreaterEqual, -most);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    program.add_row(balance[j], Relation::kEqual, -preload[j]);
  }
  return std::holds_alternative<Optimal>(solve(program));
}

TEST(UnbalancedPreload, AgreesWithTheNaiveProgram) {
  test::RandomSource random(20);
  std::size_t balanced = 0;
  std::size_t unbalanced = 0;
  for (int round = 0; round < 900; ++round) {
    const std::size_t contacts = 1 + static_cast<std::size_t>(round) % 10;
    Question asked =
        question(round % 3 == 0   ? test::degenerate_grasp(random, contacts)
                 : round % 3 == 1 ? test::near_degenerate_grasp(random, contacts, kTiny)
                                  : test::generic_grasp(random, contacts),
                 test::small_wrench(random));
    asked.law = round % 2 == 0 ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    const Problem problem(asked.loaded(), asked.law);
    const bool naive = balances_naively(problem);
    EXPECT_EQ(traps(asked, Undecided{}).empty(), naive) << round;
    const auto preloaded = [](const ContactRow& row) { return !row.preload.is_zero(); };
    if (std::none_of(problem.rows().begin(), problem.rows().end(), preloaded)) continue;
    ++(naive ? balanced : unbalanced);
  }
  EXPECT_GT(balanced, 20U);
  EXPECT_GT(unbalanced, 20U);
}

/// Two contacts with the rows N = (0, 1, 1) and (0, -1, 1), stiff, which a turn frees at once
/// and whose friction balances their torque.
Grasp pinwheel(const Rational& preload) {
  return Grasp({{{1, 1}, {0, 1}, 1, 1000, preload}, {{-1, -1}, {0, -1}, 1, 1000, preload}});
}

TEST(LostPreload, BeginsBelowOneHundredthAtEveryContact) {
  const Question asked = question(pinwheel(5));
  // v = 5 - 1000 (r + y) and 5 - 1000 (r - y).
  const auto keeping = [](const Rational& a, const Rational& b) {
    return Stable{Witness{{0, (b - a) / 2000, (10 - a - b) / 2000}, {{a, 0}, {b, 0}}}};
  };
  const Rational least(5, 100);
  EXPECT_THAT(traps(asked, keeping(0, least)), IsEmpty());
  EXPECT_THAT(traps(asked, keeping(least - kTiny, 0)), ElementsAre(ModelTrap::kLostPreload));
  EXPECT_THAT(traps(asked, keeping(0, 0)), ElementsAre(ModelTrap::kLostPreload));
  EXPECT_THAT(traps(question(pinwheel(0)), keeping(0, 0)), IsEmpty());
  EXPECT_EQ(model_warnings(asked, keeping(Rational(1, 50), 0))[0].text,
            "the preload is all but gone in this equilibrium: no contact keeps more than 0.4 % "
            "of its own");
}

/// Three contacts on a floor, friction 1 at the middle one alone, pressed down by 3 and pushed
/// by F. The middle one bears 3 k / (2 + k) if its stiffness is k and that of the others 1, so
/// the verdict is "stable" iff F <= 3 k / (2 + k): 1 for k = 1, 1/7 for k = 1/10 and 5/2 for
/// k = 10. Further contacts are on a ceiling that the body leaves.
Question floor(const Rational& push, std::size_t contacts = 3) {
  std::vector<Contact> all{
      {{-1, 0}, {0, 1}, 0, 1, 0}, {{0, 0}, {0, 1}, 1, 1, 0}, {{1, 0}, {0, 1}, 0, 1, 0}};
  while (all.size() < contacts) all.push_back({{0, 1}, {0, -1}, 1, 1, 0});
  return question(Grasp(std::move(all)), {push, -3, 0}, {ContactId(1)});
}

std::string first_text(const Question& asked) {
  const auto warnings =
      model_warnings(asked, decide(Problem(asked.loaded(), asked.law)).verdict);
  return warnings.empty() ? "" : warnings[0].text;
}

TEST(AssumedStiffness, FiresWhereAFactorOfTenChangesTheVerdict) {
  const std::string given = "no stiffness is given for contact 1, so 1 was taken; with ";
  EXPECT_EQ(first_text(floor(Rational(1, 7))), "");
  EXPECT_EQ(first_text(floor(Rational(1, 7) + kTiny)),
            given + "1/10 the verdict would be unstable");
  EXPECT_EQ(first_text(floor(1)), given + "1/10 the verdict would be unstable");
  EXPECT_EQ(first_text(floor(1 + kTiny)), given + "10 the verdict would be stable");
  EXPECT_EQ(first_text(floor(Rational(5, 2))), given + "10 the verdict would be stable");
  EXPECT_EQ(first_text(floor(Rational(5, 2) + kTiny)), "");
}

TEST(AssumedStiffness, TriesTheStiffnessOfOthers) {
  // The others have 1000. With 1 or 10 the middle one bears next to nothing, with
  // 1000 a third.
  Question asked = floor(Rational(1, 2));
  std::vector<Contact> contacts = asked.loaded().grasp.contacts();
  contacts[0].stiffness = 1000;
  contacts[2].stiffness = 1000;
  asked.grasp = LoadedGrasp{Grasp(contacts), asked.loaded().wrench};
  EXPECT_EQ(first_text(asked),
            "no stiffness is given for contact 1, so 1 was taken; with 1000 the verdict would "
            "be stable");
}

TEST(AssumedStiffness, IsSilentWhereTheFileGivesIt) {
  Question asked = floor(1);
  asked.assumed_stiffness = {};
  EXPECT_EQ(first_text(asked), "");
}

TEST(AssumedStiffness, IsSilentWithoutAVerdict) {
  EXPECT_THAT(model_warnings(floor(1), Undecided{}), IsEmpty());
}

TEST(AssumedStiffness, IsLookedForInGraspsOfFewContacts) {
  EXPECT_NE(first_text(floor(1, kMostContactsToVary)), "");
  EXPECT_EQ(first_text(floor(1, kMostContactsToVary + 1)), "");
}

TEST(AssumedStiffness, IsKnownFromTheGraspFile) {
  const auto assumed = [](const std::string& defaults, const std::string& own) {
    const GraspFile file =
        parse_grasp(R"({"format": "stickslip-grasp/1", "defaults": {"friction": 1)" + defaults +
                        R"(}, "wrench": [0, 0, 0], "contacts": [
             {"position": [0, 0], "normal": [0, 1])" +
                        own + R"(}, {"position": [1, 0], "normal": [0, 1]}]})",
                    "test");
    return ask(file, {}).assumed_stiffness;
  };
  EXPECT_THAT(assumed("", ""), ElementsAre(ContactId(0), ContactId(1)));
  EXPECT_THAT(assumed("", R"(, "stiffness": 1)"), ElementsAre(ContactId(1)));
  EXPECT_THAT(assumed(R"(, "stiffness": 1)", ""), IsEmpty());
}

bool is_on_edge(const Grasp& grasp, const Wrench& w) {
  const Question asked = question(grasp, w);
  const std::vector<ModelTrap> found = traps(asked, moved({0, 0, 0}, grasp.size()));
  return std::find(found.begin(), found.end(), ModelTrap::kEdgeBalance) != found.end();
}

TEST(EdgeBalance, BeginsWithinABillionthOfAnEdge) {
  const Grasp feet({{{-1, 0}, {0, 1}, Rational(1, 2)}, {{1, 0}, {0, 1}, Rational(1, 2)}});
  for (const int side : {1, -1}) {
    for (const auto& [off, expected] :
         {std::pair("0", true), {"1e-12", true}, {"1e-7", false}, {"1", false}}) {
      const Rational off_edge = parse_rational(off);
      EXPECT_EQ(is_on_edge(feet, {0, -2, side * (2 - off_edge)}), expected) << off;
      EXPECT_EQ(is_on_edge(feet, {side * (1 - off_edge / 2), -2, 0}), expected) << off;
    }
  }
  EXPECT_FALSE(is_on_edge(feet, {0, 0, 0}));
}

TEST(EdgeBalance, IsThatOfTheConeOfWrenches) {
  test::RandomSource random(3);
  int facets = 0;
  int inside = 0;
  for (int round = 0; round < 200; ++round) {
    const Grasp grasp = test::degenerate_grasp(random, 2 + static_cast<std::size_t>(round % 3));
    const Problem problem({grasp, {}}, NormalLaw::kUnilateral);
    std::vector<Vector3> edges;
    Wrench middle{};
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (const int side : {1, -1}) {
        const Wrench edge = problem.edge_wrench(ContactId(i), side);
        edges.push_back(coordinates(edge));
        middle = middle + edge;
      }
    }
    // Motions that two edges do no work on, and all others work of one sign or none.
    bool is_solid = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Vector3 y = cross(edges[i], edges[k]);
        int most = 0;
        int least = 0;
        for (const Vector3& edge : edges) {
          most = std::max(most, dot(y, edge).sign());
          least = std::min(least, dot(y, edge).sign());
        }
        is_solid = is_solid || most != least;
        if (most * least < 0 || most == least) continue;
        Wrench border{};
        for (const Vector3& edge : {edges[i], edges[k]}) {
          border += Wrench{-edge[0], -edge[1], -edge[2]};
        }
        ++facets;
        EXPECT_TRUE(is_on_edge(grasp, border)) << round;
      }
    }
    if (!is_solid || middle == Wrench{}) continue;
    ++inside;
    EXPECT_FALSE(is_on_edge(grasp, Rational(-1) * middle)) << round;
  }
  EXPECT_GT(facets, 100);
  EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace stickslip
