// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <utility>

#include "certificate.hpp"
#include "degree.hpp"
#include "large.hpp"
#include "margin.hpp"
#include "plane.hpp"
#include "rigid.hpp"
#include "robustness.hpp"
#include "states.hpp"
#include "statics.hpp"
#include "work.hpp"

namespace stickslip_check {
namespace {

std::string in_words(const std::optional<Vector>& direction) {
  return direction ? "the direction " + show(*direction) : "no direction of wrenches";
}

std::string in_words(const std::optional<PreloadDirection>& direction) {
  if (!direction) return "no direction of preloads";
  return direction->scale ? "scaled preloads"
                          : "the preload direction " + show(direction->values);
}

std::string in_words(const std::optional<std::vector<Vector>>& plane) {
  return plane ? "the plane of " + show((*plane)[0]) + " and " + show((*plane)[1]) : "no plane";
}

std::string in_words_inertia(const std::optional<Vector>& inertia) {
  return inertia ? "the inertia " + show(*inertia) : "no inertia";
}

std::string in_words(const std::optional<Rational>& preload) {
  return preload ? "the preload " + show(*preload) : "the file's own preloads";
}

std::string in_words_statics(const std::optional<Rational>& factor) {
  return factor ? "statics with friction times " + show(*factor) : "no statics";
}

std::string in_words_states(const std::optional<std::string>& set) {
  return set ? "the states " + *set : "no states";
}

std::string in_words_robustness(const Options& options) {
  if (!options.robustness) return "no robustness";
  return "the robustness of the " + *options.robustness + " with length " +
         show(*options.length) + " and forces up to " + show(*options.max_force);
}

std::string in_words(const std::map<std::string, Tolerance>& uncertain) {
  std::string text;
  for (const auto& [kind, tolerance] : uncertain) {
    text += (text.empty() ? "" : ", ") + kind + "=" + show(tolerance);
  }
  return text.empty() ? "no tolerances" : "the tolerances " + text;
}

std::string in_words_max_motion(const std::optional<Vector>& bound) {
  return bound ? "motions up to " + show(*bound) : "motions without a bound";
}

/// The rules `question-...`.
void check_question(const Claim& claim, const Question& question) {
  const auto compare = [](const char* rule, bool equal, const std::string& claimed,
                          const std::string& asked) {
    if (equal) return;
    throw Rejected{rule, std::nullopt, "",
                   "the certificate is about " + claimed + ", the question about " + asked};
  };
  const Options& said = claim.asked;
  const Options& asked = question.asked;
  compare("question-states", said.states == asked.states, in_words_states(said.states),
          in_words_states(asked.states));
  compare("question-robustness",
          said.robustness == asked.robustness && said.length == asked.length &&
              said.max_force == asked.max_force,
          in_words_robustness(said), in_words_robustness(asked));
  compare("question-contacts", claim.contacts == question.contacts.size(),
          show(Rational(claim.contacts)) + " contacts",
          std::to_string(question.contacts.size()));
  compare("question-wrench", claim.wrench == question.wrench, show(claim.wrench),
          show(question.wrench));
  compare("question-preload", said.preload == asked.preload, in_words(said.preload),
          in_words(asked.preload));
  compare("question-law", said.bilateral == asked.bilateral, law_name(said.bilateral),
          law_name(asked.bilateral));
  compare("question-direction", said.direction == asked.direction, in_words(said.direction),
          in_words(asked.direction));
  compare("question-preload-direction", said.preload_direction == asked.preload_direction,
          in_words(said.preload_direction), in_words(asked.preload_direction));
  compare("question-plane", said.plane == asked.plane, in_words(said.plane),
          in_words(asked.plane));
  compare("question-inertia", said.inertia == asked.inertia, in_words_inertia(said.inertia),
          in_words_inertia(asked.inertia));
  compare("question-statics", said.statics == asked.statics, in_words_statics(said.statics),
          in_words_statics(asked.statics));
  compare("question-uncertain", said.uncertain == asked.uncertain, in_words(said.uncertain),
          in_words(asked.uncertain));
  compare("question-max-motion", said.max_motion == asked.max_motion,
          in_words_max_motion(said.max_motion), in_words_max_motion(asked.max_motion));
}

/// A rule that fails, or the limit of work, is remembered, and the rest of the file is still
/// read: what is malformed anywhere is malformed.
class FirstRejection {
 public:
  template <typename Action>
  void unless_rejected(Action action) {
    if (found) return;
    try {
      action();
    } catch (const Rejected& rejected) {
      found = rejected;
    } catch (const NotJudged& not_judged) {
      found = not_judged;
    }
  }

  std::optional<Answer> found;
};

/// FORMAT.md §13. Reads the syntax alone of a claim about another question, which is rejected.
void check_class(CertificateReader& certificate, const Question& question,
                 FirstRejection& rejection, Accepted& accepted) {
  const std::size_t dimension = question.dimension();
  std::optional<RigidProof> proof;
  rejection.unless_rejected([&] { proof.emplace(question); });
  if (accepted.verdict == "must move") {
    const Vector twist = certificate.twist();
    rejection.unless_rejected([&] { proof->check_twist(twist); });
    return;
  }
  const std::vector<RigidForce> rest = certificate.forces("rest");
  rejection.unless_rejected([&] { proof->check_forces(rest, Vector(dimension), "rest"); });
  if (accepted.verdict == "open") {
    const Vector acceleration = certificate.acceleration();
    const std::vector<RigidForce> forces = certificate.forces("forces");
    rejection.unless_rejected([&] {
      proof->check_forces(forces, acceleration, "forces");
      proof->check_motion(forces, acceleration);
    });
    return;
  }
  while (const std::optional<RigidNode> node = certificate.next_rigid_node()) {
    rejection.unless_rejected([&] { proof->visit(*node); });
  }
  rejection.unless_rejected([&] { proof->finish(); });
  if (!proof) return;
  accepted.nodes = proof->nodes();
  accepted.leaves = proof->leaves();
}

/// FORMAT.md §16.
void check_statics(CertificateReader& certificate, const Question& question,
                   FirstRejection& rejection, Accepted& accepted) {
  std::optional<StaticsProof> proof;
  const Rational factor = question.asked.statics.value_or(1);
  rejection.unless_rejected([&] { proof.emplace(question, factor); });
  if (accepted.verdict == "must move") {
    const Vector twist = certificate.twist();
    rejection.unless_rejected([&] { proof->check_twist(twist); });
    return;
  }
  if (accepted.verdict == "may stand") {
    const StandPoint point{{1}, certificate.forces("forces")};
    rejection.unless_rejected([&] { proof->check(point, "forces"); });
    return;
  }
  while (const std::optional<StandPoint> point = certificate.next_stand()) {
    const std::string place = "stand " + std::to_string(accepted.stands++);
    rejection.unless_rejected([&] { proof->check(*point, place); });
  }
  while (const std::optional<Vector> twist = certificate.next_move()) {
    const std::string place = "move " + std::to_string(accepted.moves++);
    rejection.unless_rejected([&] { proof->check(*twist, place); });
  }
  if (proof && accepted.verdict == "margin") accepted.standing = proof->standing();
}

/// FORMAT.md §17.
void check_states(CertificateReader& certificate, const Question& question,
                  FirstRejection& rejection, Accepted& accepted) {
  const std::vector<std::vector<Vector>> lines = certificate.lines();
  std::optional<StatesProof> proof;
  rejection.unless_rejected([&] { proof.emplace(question, lines); });
  while (const std::optional<State> state = certificate.next_state()) {
    rejection.unless_rejected([&] { proof->visit(*state); });
  }
  accepted.by_dimension = certificate.by_dimension();
  rejection.unless_rejected([&] { proof->finish(accepted.by_dimension); });
  if (proof) accepted.listed = proof->listed();
}

/// FORMAT.md §18.
void check_robustness(CertificateReader& certificate, const Question& question,
                      FirstRejection& rejection, Accepted& accepted) {
  const Rational lower = certificate.bound("lower");
  const Rational upper = certificate.bound("upper");
  const std::optional<RobustCombination> combination = certificate.combination();
  std::optional<RobustnessProof> proof;
  rejection.unless_rejected([&] {
    proof.emplace(question, lower, upper);
    proof->check(combination);
  });
  while (const std::optional<RobustNode> node = certificate.next_robust_node()) {
    rejection.unless_rejected([&] { proof->visit(*node); });
  }
  rejection.unless_rejected([&] { proof->finish(); });
  if (!proof) return;
  accepted.bounds = Bounds(lower, upper);
  accepted.nodes = proof->nodes();
  accepted.leaves = proof->leaves();
}

/// FORMAT.md §14, "Many coordinates".
void check_large(CertificateReader& certificate, const Question& question,
                 FirstRejection& rejection, Accepted& accepted) {
  if (accepted.verdict == "stable" && !certificate.has_parts()) {
    const Witness witness = certificate.witness();
    rejection.unless_rejected([&] { check_large_witness(question, witness); });
    return;
  }
  std::optional<Node> first;
  if (accepted.verdict == "stable") {
    while (certificate.next_part()) {
    }
  } else {
    while (std::optional<Node> node = certificate.next_node()) {
      if (++accepted.nodes == 1) first = std::move(node);
    }
    accepted.leaves = 1;
  }
  const bool is_leaf = first && accepted.nodes == 1 && first->kind == NodeKind::kLeaf;
  rejection.unless_rejected([&] { check_large_leaf(question, is_leaf ? &*first : nullptr); });
}

/// Reads the syntax alone of a claim about another question, which is rejected.
void read_proof(CertificateReader& certificate, const std::string& verdict, bool in_ranges) {
  if (verdict == "stable") {
    if (!certificate.has_parts()) {
      certificate.witness();
      return;
    }
    while (certificate.next_part()) {
    }
    return;
  }
  if (in_ranges) {
    while (certificate.next_range()) {
    }
    return;
  }
  if (verdict == "margin") {
    certificate.resisted();
    while (certificate.next_segment()) {
    }
  } else if (verdict == "region") {
    while (certificate.next_piece()) {
    }
  }
  while (certificate.next_node()) {
  }
}

Answer read_and_check(CertificateReader& certificate, Question question) {
  FirstRejection rejection;
  const Claim claim = certificate.claim();
  rejection.unless_rejected([&] { check_question(claim, question); });
  // Nothing more has to be read of a certificate of another kind.
  if ((question.asked.states && !claim.asked.states) ||
      (question.asked.robustness && !claim.asked.robustness)) {
    return *rejection.found;
  }
  Accepted accepted;
  accepted.verdict = certificate.verdict();
  if (claim.asked.states || claim.asked.robustness) {
    (claim.asked.states ? check_states : check_robustness)(certificate, question, rejection,
                                                           accepted);
    certificate.finish();
    if (rejection.found) return *rejection.found;
    accepted.question = std::move(question);
    return accepted;
  }
  const bool large = question.large();
  if (question.is_box && !large) enlarge(question, certificate.bits());
  const bool statics = claim.asked.statics.has_value();
  const bool in_ranges = accepted.verdict == "margin" && question.claims() && !statics;
  std::vector<Root> roots;
  const bool rigid = claim.asked.rigid();
  const bool of_another =
      !statics && (question.asked.statics || (large && claim.asked.family()));
  if (statics) {
    check_statics(certificate, question, rejection, accepted);
  } else if (rigid) {
    check_class(certificate, question, rejection, accepted);
  } else if (of_another) {
    read_proof(certificate, accepted.verdict, in_ranges);
  } else if (large) {
    check_large(certificate, question, rejection, accepted);
  } else if (accepted.verdict == "stable" && certificate.has_parts()) {
    PartWalk walk(question.asked, question.box);
    while (const std::optional<Part> part = certificate.next_part()) {
      rejection.unless_rejected([&] { walk.visit(*part); });
    }
    rejection.unless_rejected([&] { walk.finish(); });
    accepted.rests = walk.rests();
    accepted.stickings = walk.stickings();
    accepted.parts = walk.proofs();
    accepted.nodes = walk.nodes();
    accepted.leaves = walk.leaves();
  } else if (accepted.verdict == "stable") {
    const Witness witness = certificate.witness();
    ForceSum sum;
    rejection.unless_rejected([&] { check_witness(question, witness, sum); });
  } else if (in_ranges) {
    RangeProofs proofs(question, accepted);
    while (const std::optional<RangeProof> range = certificate.next_range()) {
      rejection.unless_rejected([&] { proofs.visit(*range); });
    }
  } else if (accepted.verdict == "margin") {
    accepted.resisted = certificate.resisted();
    rejection.unless_rejected([&] { check_order(accepted.resisted); });
    Segments segments(question, accepted);
    while (const auto segment = certificate.next_segment()) {
      rejection.unless_rejected([&] { segments.visit(*segment); });
      ++accepted.segments;
    }
    rejection.unless_rejected([&] { segments.finish(); });
    rejection.unless_rejected([&] { roots = roots_of(question, gaps(accepted.resisted)); });
    accepted.trees = roots.size();
  } else if (accepted.verdict == "region") {
    Pieces pieces(question);
    while (const auto piece = certificate.next_piece()) {
      rejection.unless_rejected([&] { pieces.visit(*piece); });
      ++accepted.pieces;
    }
    rejection.unless_rejected([&] { roots = {root_of(question, pieces.take())}; });
  } else {
    roots = roots_of(question, {{0, 0}});
  }
  if (accepted.verdict != "stable" && !in_ranges && !rigid && !statics && !of_another &&
      !large) {
    TreeWalk walk(std::move(roots));
    while (const std::optional<Node> node = certificate.next_node()) {
      rejection.unless_rejected([&] { walk.visit(*node); });
    }
    rejection.unless_rejected([&] { walk.finish(); });
    accepted.nodes += walk.nodes();
    accepted.leaves += walk.leaves();
  }
  certificate.finish();
  if (rejection.found) return *rejection.found;
  accepted.question = std::move(question);
  return accepted;
}

}  // namespace

Answer check(std::istream& grasp, std::istream& certificate, const Options& options,
             const std::string& grasp_name, const std::string& certificate_name) {
  const LimitedWork limited;
  try {
    Question question = pose(read_grasp(grasp, grasp_name), options, grasp_name);
    CertificateReader reader(certificate, certificate_name, question);
    return read_and_check(reader, std::move(question));
  } catch (const Malformed& malformed) {
    return malformed;
  } catch (const NotJudged& not_judged) {
    return not_judged;
  }
}

std::string law_name(bool bilateral) {
  return bilateral ? "bilateral" : "unilateral";
}

}  // namespace stickslip_check
