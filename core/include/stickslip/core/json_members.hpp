// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A line that holds a JSON object, cut into the texts of its members, so that each can be
/// given to its own reader (parse_grasp, parse_json) as it stands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// One member of an object: a key, and the text of its value.
struct JsonMember {
  std::string key;         ///< unescaped
  std::string_view value;  ///< into the text that was split; not yet parsed
  std::size_t column;      ///< characters of the text before the value

  /// The value behind as many blanks: a reader's line:column is then that of the whole line.
  std::string in_place() const { return std::string(column, ' ').append(value); }
};

/// The members of the object that `text`, one line, consists of. Only what separates them is
/// checked here; the values are left to their readers. Throws InputError with a line:column for
/// bad syntax, and at "top level" for a repeated key and more than kMaxJsonNodes keys.
/// O(length) for each member.
std::vector<JsonMember> split_json_object(std::string_view text);

}  // namespace stickslip
