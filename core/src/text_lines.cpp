// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/text_lines.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

bool TextLines::next(std::string& line) {
  std::streambuf& in = *in_.rdbuf();
  constexpr int kEnd = std::streambuf::traits_type::eof();
  for (int c = in.sbumpc(); c != kEnd;) {
    line.clear();
    ++number_;
    bool blank = true;
    bool too_long = false;
    for (; c != kEnd && c != '\n'; c = in.sbumpc()) {
      if (c != ' ' && c != '\t' && c != '\r') blank = false;
      too_long = too_long || line.size() == kMaxGraspFileBytes;
      if (!too_long) line.push_back(static_cast<char>(c));
    }
    if (too_long) {
      throw InputError("", "", "more than " + std::to_string(kMaxGraspFileBytes) + " bytes",
                       "longer lines are not read");
    }
    if (!blank) return true;
    if (c != kEnd) c = in.sbumpc();
  }
  return false;
}

}  // namespace stickslip
