// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A JSON text as a small tree in which numbers keep their own characters.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// A JSON value.
struct JsonNode {
  /// The six kinds of value.
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;         ///< says which of the following are in use
  std::string text;                ///< of a number, its characters; of a string, its content
  std::vector<std::string> keys;   ///< of an object, one per child, all different
  std::vector<JsonNode> children;  ///< of an array or an object

  /// The value of `key`, or nullptr.
  const JsonNode* find(std::string_view key) const;
};

/// The node in words, for messages: `the string "abc"`, `an array of 3 values`.
std::string describe(const JsonNode& node);

/// `key` below `path`: "contacts[0]" and "normal" give "contacts[0].normal".
std::string member_path(const std::string& path, const std::string& key);
/// Element `index` below `path`: "contacts" and 0 give "contacts[0]".
std::string element_path(const std::string& path, std::size_t index);

/// The path as an error's place: that of the root has no characters of its own.
std::string place_name(const std::string& path);

/// Receives element `index` of the streamed array.
using JsonElementSink = std::function<void(std::size_t index, const JsonNode& element)>;

/// Parses one JSON value. The elements of the top level's member `streamed_key`, if that is an
/// array, go to `sink` one by one and are not kept, so memory does not grow with the tree; with
/// an empty `sink` all are kept.
/// Throws InputError with a line:column for bad syntax, and with a JSON path for a repeated
/// key, nesting beyond kMaxJsonDepth and more than kMaxJsonNodes values elsewhere.
JsonNode parse_json(std::string_view text, const std::string& streamed_key,
                    const JsonElementSink& sink);

/// Largest number of values in one streamed element, and in the rest of the text.
inline constexpr std::size_t kMaxJsonNodes = 256;

}  // namespace stickslip
