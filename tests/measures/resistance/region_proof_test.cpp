// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/region_proof.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "both_checkers.hpp"
#include "grasps.hpp"
#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::CheckerAnswer;
using test::CheckerInput;
using test::RandomSource;
using Json = nlohmann::ordered_json;
using Pieces = std::vector<ResistiblePiece>;

/// A grasp file, a plane in it, and what a checker is given about them.
struct Proved {
  PlaneUnion region;  ///< as found without the pieces
  RegionProof proof;
  RegionProofWork work;
  CheckerInput input;
};

ResistibleSet set_with_pieces(const Problem& problem, const WrenchPlane& plane) {
  ResistibleOptions options;
  options.pieces = true;
  return std::get<ResistibleSet>(resistible_set(problem, plane, options));
}

Proved proved(const Grasp& grasp, NormalLaw law, const WrenchPlane& plane) {
  const Question question{LoadedGrasp{grasp, {0, 0, 0}}, law};
  const Problem problem = problem_of(question);
  const ResistibleSet set = set_with_pieces(problem, plane);
  Proved result{set.region, {}, {}, {}};
  auto found = prove_region(problem, plane, set.pieces, {}, &result.work);
  result.proof = std::move(std::get<RegionProof>(found));
  result.input.grasp = write_grasp(question.loaded());
  result.input.certificate = region_certificate_text(question, plane, result.proof, "tests");
  result.input.options.law = law;
  result.input.options.wrench = row_of(plane.origin());
  result.input.plane = {plane.u(), plane.v()};
  return result;
}

Proved proved(const Grasp& grasp, NormalLaw law = NormalLaw::kUnilateral) {
  return proved(grasp, law, WrenchPlane::forces());
}

/// The pieces together, by their points.
PlaneUnion union_of(const RegionProof& proof) {
  std::vector<PlaneCell> cells;
  for (const ProvedPiece& piece : proof.pieces) {
    std::vector<HomogeneousPoint> generators;
    for (const LoadPoint& point : piece) generators.push_back(point.load);
    cells.push_back(PlaneCell::hull(std::move(generators)));
  }
  return unite(cells);
}

/// Asks both checkers of all inputs, which must agree; of each the answer.
class BothCheckers {
 public:
  void add(CheckerInput input) { inputs_.push_back(std::move(input)); }

  std::vector<CheckerAnswer> ask() const {
    const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs_);
    std::vector<CheckerAnswer> answers;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      answers.push_back(test::ask_cpp_checker(inputs_[k]));
      EXPECT_TRUE(answers[k].agrees_with(python[k]))
          << "C++: " << describe(answers[k]) << "\nPython: " << describe(python[k]) << "\n"
          << describe(inputs_[k]);
    }
    return answers;
  }

  void expect_accepted() const {
    const std::vector<CheckerAnswer> answers = ask();
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      EXPECT_EQ(answers[k].result, "accepted") << describe(answers[k]) << "\n"
                                               << describe(inputs_[k]);
    }
  }

 private:
  std::vector<CheckerInput> inputs_;
};

Grasp grasp_of(std::vector<Contact> contacts) {
  return Grasp(std::move(contacts));
}

/// At (x, y), with a preload.
Contact contact(int x, int y, int nx, int ny, const Rational& friction,
                const Rational& preload) {
  Contact c;
  c.position = {x, y};
  c.normal = {nx, ny};
  c.friction = friction;
  c.stiffness = 1;
  c.preload = preload;
  return c;
}

Outline open_outline(const PlaneDirection& from, const std::vector<PlanePoint>& vertices,
                     const PlaneDirection& to) {
  return {vertices, from, to};
}

TEST(RegionProof, ClosedForms) {
  BothCheckers checkers;
  const auto expect = [&](const Proved& found, const PlaneUnion& region) {
    EXPECT_EQ(found.region, region);
    EXPECT_EQ(union_of(found.proof), region);
    checkers.add(found.input);
  };
  // Its friction cone, upside down.
  const Grasp one = grasp_of({contact(0, 0, 0, 1, 1, 0)});
  expect(proved(one), {{{{open_outline({1, -1}, {{0, 0}}, {-1, -1})}}}, {}, {}});
  // At a distance no force has the torque 0 but 0.
  const WrenchPlane away({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  expect(proved(one, NormalLaw::kUnilateral, away), {});
  // Without friction a ray is left; without any contact 0 alone, or nothing.
  expect(proved(grasp_of({contact(0, 0, 0, 1, 0, 0)})),
         {{}, {PlaneCell::hull({{0, 0, 1}, {0, -1, 0}})}, {}});
  expect(proved(grasp_of({})), {{}, {}, {{0, 0}}});
  expect(proved(grasp_of({}), NormalLaw::kUnilateral, away), {});
  // Two fingers: w_y <= max(0, 1 - |w_x| / 2) and so on, of the paper.
  for (const int preload : {0, 1}) {
    for (const Grasp& grasp : {test::fig1_grasp(preload), test::fig4_grasp(preload)}) {
      const Proved found = proved(grasp);
      EXPECT_EQ(union_of(found.proof), found.region);
      checkers.add(found.input);
    }
  }
  // All round everything is resisted, and nothing is refuted.
  const Proved whole =
      proved(grasp_of({contact(-1, 0, 1, 0, 1, 1), contact(1, 0, -1, 0, 1, 1),
                       contact(0, -1, 0, 1, 1, 1), contact(0, 1, 0, -1, 1, 1)}));
  EXPECT_TRUE(whole.region.is_whole_plane());
  EXPECT_EQ(whole.work.cells, 0u);
  checkers.add(whole.input);
  checkers.expect_accepted();
}

WrenchPlane random_plane(RandomSource& random) {
  if (random.one_in(3)) return WrenchPlane::forces(Rational(random.between(-2, 2), 2));
  while (true) {
    try {
      return {test::small_wrench(random), test::small_wrench(random),
              test::small_wrench(random)};
    } catch (const InputError&) {  // dependent directions
    }
  }
}

TEST(RegionProof, OfRandomGraspsIsAccepted) {
  BothCheckers checkers;
  RandomSource random(1);
  for (int round = 0; round < 120; ++round) {
    const std::size_t m = static_cast<std::size_t>(random.between(0, round % 10 == 0 ? 5 : 3));
    const Grasp grasp = random.one_in(2) ? test::degenerate_grasp(random, m)
                        : random.one_in(2)
                            ? test::generic_grasp(random, m)
                            : test::near_degenerate_grasp(random, m, Rational(1, 1000));
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    SCOPED_TRACE(test::describe({{grasp, {0, 0, 0}}, law}));
    const Proved found = proved(grasp, law, random_plane(random));
    EXPECT_EQ(union_of(found.proof), found.region);
    checkers.add(found.input);
  }
  checkers.expect_accepted();
}

TEST(RegionProof, OfMeasuredGraspsIsAccepted) {
  BothCheckers checkers;
  for (const bench::Layout layout : {bench::Layout::kArc, bench::Layout::kVaried}) {
    const Proved found = proved(bench::make_grasp(layout, 4, true, 1));
    EXPECT_EQ(union_of(found.proof), found.region);
    checkers.add(found.input);
  }
  checkers.expect_accepted();
}

TEST(RegionProof, IsUndecidedAtTheLimit) {
  const Problem problem({test::fig1_grasp(1), {0, 0, 0}}, NormalLaw::kUnilateral);
  const WrenchPlane plane = WrenchPlane::forces();
  const Pieces pieces = set_with_pieces(problem, plane).pieces;
  RegionProofOptions options;
  options.node_limit = 5;
  EXPECT_TRUE(std::holds_alternative<Undecided>(prove_region(problem, plane, pieces, options)));
}

/// What the certificate says of its pieces.
PlaneUnion union_in(const Json& certificate) {
  const auto number = [](const Json& value) {
    return value.is_string() ? parse_rational(value.get<std::string>())
                             : Rational(value.get<std::int64_t>());
  };
  std::vector<PlaneCell> cells;
  for (const Json& piece : certificate["pieces"]) {
    std::vector<HomogeneousPoint> generators;
    bool has_point = false;
    for (const Json& point : piece) {
      const bool at = point[0] == "at";
      has_point = has_point || at;
      const HomogeneousPoint g = homogeneous(PlanePoint{number(point[1]), number(point[2])});
      if (at || !(g[0].is_zero() && g[1].is_zero())) {
        generators.push_back({g[0], g[1], at ? g[2] : Integer(0)});
      }
    }
    if (has_point) cells.push_back(PlaneCell::hull(std::move(generators)));
  }
  return unite(cells);
}

/// Changes one value somewhere in the pieces or the tree, or moves or drops one.
Json mutated(RandomSource& random, const Json& original) {
  Json edited = original;
  Json* at = &edited[random.one_in(2) ? "pieces" : "tree"];
  while (at->is_array() && !at->empty()) {
    const auto k =
        static_cast<std::size_t>(random.between(0, static_cast<int>(at->size()) - 1));
    if (random.one_in(12)) {
      if (random.one_in(2)) {
        at->erase(k);
      } else {
        std::swap((*at)[k], (*at)[0]);
      }
      return edited;
    }
    at = &(*at)[k];
  }
  if (at->is_number_integer()) {
    *at = random.one_in(2) ? -at->get<std::int64_t>()
                           : at->get<std::int64_t>() + random.between(-1, 1);
  } else if (at->is_string() && at->get<std::string>().find('/') != std::string::npos) {
    *at = to_string(parse_rational(at->get<std::string>()) + Rational(1, 1000000));
  } else if (*at == "at" || *at == "towards") {
    *at = *at == "at" ? "towards" : "at";
  } else if (*at == "slip" || *at == "separation") {
    *at = *at == "slip" ? "separation" : "slip";
  }
  return edited;
}

TEST(RegionProof, MutantsThatAreAcceptedAreTrue) {
  RandomSource random(7);
  std::map<std::string, int> tally;
  for (int round = 0; round < 12; ++round) {
    const Grasp grasp = round < 2 ? test::fig1_grasp(round)
                                  : test::degenerate_grasp(random, 1 + random.between(0, 2));
    const NormalLaw law = round % 3 == 2 ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const Proved found = proved(grasp, law, random_plane(random));
    const Json original = Json::parse(found.input.certificate);
    BothCheckers checkers;
    std::vector<Json> mutants;
    for (int k = 0; k < 80; ++k) {
      Json mutant = original;
      while (mutant == original) mutant = mutated(random, original);
      mutants.push_back(std::move(mutant));
      CheckerInput input = found.input;
      input.certificate = mutants.back().dump();
      checkers.add(std::move(input));
    }
    const std::vector<CheckerAnswer> answers = checkers.ask();
    for (std::size_t k = 0; k < mutants.size(); ++k) {
      ++tally[answers[k].result + " " + answers[k].rule];
      if (answers[k].result != "accepted") continue;
      EXPECT_EQ(union_in(mutants[k]), found.region) << mutants[k].dump();
    }
  }
  for (const char* rule : {"held-inside", "held-piece", "leaf-bound", "piece-mode",
                           "witness-balance", "witness-share", "tree-short"}) {
    EXPECT_GE(tally[std::string("rejected ") + rule], 1) << rule;
  }
  for (const auto& [answer, count] : tally)
    std::cout << "  " << answer << ": " << count << "\n";
}

}  // namespace
}  // namespace stickslip
