// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/engine/newton_equilibria.hpp"
#include "stickslip/engine/second_question.hpp"

namespace stickslip {
namespace {

Answer about_box(Question question, BoxDecision decision) {
  return {std::move(question), std::move(decision.verdict), decision.work, decision.bits};
}

/// Returns the answer without a second one. If its search has found a proof within
/// natural_bound() on the way, `within` is that.
Answer first_answer(Question question, const SearchOptions& options,
                    std::optional<Unstable>& within) {
  if (const GraspBox* box = question.box()) {
    BoxDecision decision = decide_box(*box, question.law, options);
    within = std::move(decision.within);
    return about_box(std::move(question), std::move(decision));
  }
  Problem problem = problem_of(question);
  if (options.engine == Engine::kAuto && has_long_equilibria(problem)) {
    if (auto by_degree = prove_stable_by_degree(problem)) {
      question.grasp = question.grasp.as_box();
      return about_box(std::move(question), std::move(*by_degree));
    }
  }
  Decision decision = decide(problem, options);
  Answer answer{std::move(question), std::move(decision.verdict)};
  std::visit([&](const auto& work) { answer.work = work; }, decision.work);
  answer.problem = std::move(problem);
  return answer;
}

/// Returns the answer of a question that was given up for this reason. Throws what problem_of()
/// throws.
Answer unanswered(Question question, Undecided why) {
  if (question.box() != nullptr) {
    return {std::move(question), std::move(why), SearchWork{}};
  }
  Problem problem = problem_of(question);
  Answer answer{std::move(question), std::move(why), BranchWork{}};
  answer.problem = std::move(problem);
  return answer;
}

}  // namespace

const char* box_engine(const Question& question) {
  if (question.mechanism() != nullptr) return "bodies";
  return question.in_space() ? "space" : "intervals";
}

const char* Answer::engine() const {
  if (std::holds_alternative<StatesWork>(work)) return "states";
  return std::holds_alternative<BranchWork>(work) ? "branch-and-bound" : box_engine(question);
}

Undecided out_of_time(const TimeLimit& limit) {
  return {limit.in_words() + " was over first", "time", "a longer one may decide it"};
}

Answer decide_in_time(Question question, const SearchOptions& options, const TimeLimit& limit,
                      const std::function<void(const Answer&)>& then,
                      const std::function<bool(const std::function<void()>& work)>& finishes) {
  std::optional<Answer> answer;
  std::function<void(const Answer&)> keep;
  // Only a limit makes a copy of the question worth its memory.
  if (limit.seconds()) {
    answer = unanswered(question, out_of_time(limit));
    keep = [&](const Answer& first) { answer = first; };
  }
  const auto work = [&] {
    answer = decide(std::move(question), options, keep);
    if (then) then(*answer);
  };
  finishes ? finishes(work) : limit.finishes(work);
  return std::move(*answer);
}

Answer decide(Question question, const SearchOptions& options) {
  return decide(std::move(question), options, {});
}

Answer decide(Question question, const SearchOptions& options,
              const std::function<void(const Answer&)>& progress) {
  std::optional<Unstable> within;
  Answer answer = first_answer(std::move(question), options, within);
  if (!options.second) return answer;
  std::optional<Question> second = second_question(answer.question, answer.verdict);
  if (!second) return answer;
  if (within && second->is_bounded()) {
    answer.within = std::make_shared<const Answer>(
        Answer{std::move(*second), std::move(*within), {}, answer.bits});
    return answer;
  }
  if (progress) progress(answer);
  SearchOptions how = options;
  how.engine = Engine::kAuto;
  how.second = !second->is_bounded();
  Answer found = decide(std::move(*second), how);
  if (found.within) found = *found.within;
  // An equilibrium within a bound is one of all, and so is what proves it.
  if (std::holds_alternative<Undecided>(answer.verdict) && found.question.is_bounded() &&
      std::holds_alternative<Stable>(found.verdict)) {
    GraspBox box = found.question.grasp.as_box();
    box.max_motion.clear();
    found.question.grasp = std::move(box);
    return found;
  }
  // A second answer that says the same says nothing more.
  const bool is_same = answer.verdict.index() == found.verdict.index();
  if (is_same && !std::holds_alternative<Stable>(answer.verdict)) return answer;
  answer.within = std::make_shared<const Answer>(std::move(found));
  return answer;
}

std::vector<std::pair<std::string, std::size_t>> counters(const Answer& answer) {
  using Counters = std::vector<std::pair<std::string, std::size_t>>;
  if (const auto* states = std::get_if<StatesWork>(&answer.work)) return counters(*states);
  if (const auto* cone = std::get_if<BranchWork>(&answer.work)) return counters(*cone);
  const auto* search = std::get_if<SearchWork>(&answer.work);
  return search != nullptr ? counters(*search) : Counters{};
}

}  // namespace stickslip
