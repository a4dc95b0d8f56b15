// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/samples_answer.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/box_sampler.hpp"

namespace stickslip {
namespace {

constexpr double kError = 0.05;  // 1 - confidence
constexpr long long kGrain = 1000000;  // much coarser than what the function knows

/// Returns the one-sided lower bound, which is wrong with at most this probability.
Rational lower(double trials, double successes, double error) {
  using boost::math::binomial_distribution;
  const double p =
      successes > 0 ? binomial_distribution<>::find_lower_bound_on_p(trials, successes, error)
                    : 0;
  return {Integer(static_cast<long long>(std::floor(p * kGrain))), Integer(kGrain)};
}

}  // namespace

StableShare stable_share(const Samples& samples) {
  require(samples.count() > 0, "a share of samples is of some");
  const auto count = static_cast<double>(samples.count());
  const auto stable = static_cast<double>(samples.stable);
  const auto unstable = static_cast<double>(samples.unstable);
  return {lower(count, stable, kError / 2), 1 - lower(count, unstable, kError / 2),
          lower(count, stable, kError)};
}

void decide_samples(const Question& question, std::size_t count, const SearchOptions& options,
                    Samples& samples, const std::function<void()>& progress) {
  const GraspBox box = question.grasp.as_box();
  BoxSampler sampler(box, question.law, samples.seed);
  SearchOptions each = options;
  each.second = false;
  while (samples.count() < count) {
    GraspBox grasp = sampler.next();
    const std::size_t number = samples.count();
    // One that the time limit breaks off has no verdict.
    ++samples.undecided;
    QuestionOptions asked;
    asked.law = question.law;
    const Answer answer = decide(ask({grasp}, asked), each);
    if (const auto certificate = certificate_of(answer)) {
      const auto refusal = refusal_of(answer.question, *certificate);
      require(!refusal, "the checker accepts the proof of a sample");
      const bool stable = std::holds_alternative<Stable>(answer.verdict);
      auto& example = stable ? samples.stable_example : samples.unstable_example;
      if (!stable) samples.failures.push_back({number, {write_grasp(grasp), *certificate}});
      if (!example) example = std::move(grasp);
      --samples.undecided;
      ++(stable ? samples.stable : samples.unstable);
    }
    if (progress) progress();
  }
}

void add_samples(Verdict& verdict, const Samples& samples) {
  if (!std::holds_alternative<Undecided>(verdict)) return;
  if (!samples.stable_example || !samples.unstable_example) return;
  verdict = Fragile{*samples.stable_example, *samples.unstable_example};
}

Json samples_json(const Samples& samples) {
  Json json{{"count", samples.count()},         {"seed", samples.seed},
            {"stable", samples.stable},         {"unstable", samples.unstable},
            {"undecided", samples.undecided}};
  if (samples.count() == 0) return json;
  const StableShare share = stable_share(samples);
  json["share"] = {{"confidence", number_json(Rational(19, 20))},
                   {"low", number_json(share.low)},
                   {"high", number_json(share.high)},
                   {"at_least", number_json(share.at_least)}};
  return json;
}

}  // namespace stickslip
