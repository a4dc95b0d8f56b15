// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/part.hpp"

namespace stickslip {

const char* to_string(Parameter parameter) {
  constexpr const char* kNames[] = {"x",         "y",      "turn", "friction", "preload",
                                    "stiffness", "wrench", "z",    "turn_u",   "turn_v"};
  return kNames[static_cast<std::size_t>(parameter)];
}

}  // namespace stickslip
