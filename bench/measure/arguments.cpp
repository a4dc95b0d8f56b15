// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.hpp"

#include <iostream>

namespace stickslip::bench {

std::optional<int> Arguments::read(int argc, const char* const* argv) {
  const auto stopped = line_.run(argc, argv);
  if (!stopped) return std::nullopt;
  (stopped->asked_for_help ? std::cout : std::cerr) << stopped->text << '\n';
  constexpr int kBadArguments = 2;
  return stopped->asked_for_help ? 0 : kBadArguments;
}

}  // namespace stickslip::bench
