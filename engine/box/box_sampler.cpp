// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/box_sampler.hpp"

#include <random>

#include "examples.hpp"

namespace stickslip {

using namespace box_detail;

struct BoxSampler::State {
  Examples examples;
  std::mt19937_64 random;  // the standard says what it gives, unlike distributions

  /// Returns the middle of one of 2^17 steps from -1 to 1.
  Rational number() {
    constexpr unsigned kBits = 17;
    const auto step = static_cast<long long>(random() >> (64 - kBits));
    return {Integer(2 * step + 1 - (1LL << kBits)), Integer(1LL << kBits)};
  }
  /// Draws the numbers of these entries until they are in the unit ball.
  void draw_in_ball(Place& place, const std::vector<std::size_t>& entries) {
    Rational square = 2;
    while (square > 1) {
      square = 0;
      for (const std::size_t n : entries) {
        place[n] = number();
        square += place[n] * place[n];
      }
    }
  }
};

BoxSampler::BoxSampler(const GraspBox& box, NormalLaw law, std::uint64_t seed)
    : state_(std::make_unique<State>(State{Examples(box, law), std::mt19937_64(seed)})) {}

BoxSampler::~BoxSampler() = default;

GraspBox BoxSampler::next() {
  const Examples& examples = state_->examples;
  Place place = examples.middle();
  std::vector<std::size_t> load;
  for (std::size_t n = 0; n < place.size(); ++n) {
    const Parameter parameter = examples.numbers()[n].parameter;
    if (parameter == Parameter::kWrench && examples.box().ball) {
      load.push_back(n);
    } else if (parameter == Parameter::kTurnU) {
      state_->draw_in_ball(place, {n, n + 1});
    } else if (parameter != Parameter::kTurnV) {
      place[n] = state_->number();
    }
  }
  if (!load.empty()) state_->draw_in_ball(place, load);
  return examples.at(place);
}

}  // namespace stickslip
