// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A JSON text as a small tree in which numbers keep their own characters, and functions that
/// take values out of it. A function with a parameter `path`, a JSON path, throws InputError at
/// that place. The path of the root is empty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip {

/// A JSON value.
struct JsonNode {
  /// The six kinds of value.
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;         ///< the kind, which says which of the following are in use
  std::string text;                ///< the characters of a number, or the content of a string
  std::vector<std::string> keys;   ///< the keys of an object, one per child, all different
  std::vector<JsonNode> children;  ///< the values of an array or an object

  /// Returns the value of `key`, or nullptr.
  const JsonNode* find(std::string_view key) const;
};

/// Returns the node in words, for messages: `the string "abc"`, `an array of 3 values`.
std::string describe(const JsonNode& node);

/// Returns `key` below `path`: "contacts[0]" and "normal" give "contacts[0].normal".
std::string member_path(const std::string& path, const std::string& key);
/// Returns element `index` below `path`: "contacts" and 0 give "contacts[0]".
std::string element_path(const std::string& path, std::size_t index);

/// Returns the path as an error names it: "top level" for the root, whose path is empty.
std::string place_name(const std::string& path);

/// \{ Limits on what is read, so that hostile input ends in an error and not after an hour.
inline constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 28;
inline constexpr std::size_t kMaxJsonDepth = 32;
/// The most values in one member of the top level, without streamed elements, and in each of
/// these.
inline constexpr std::size_t kMaxJsonNodes = std::size_t{1} << 16;
/// The most members of one object.
inline constexpr std::size_t kMaxJsonKeys = 32;
/// \}

/// An array that may be long: its elements are handed over one by one as they are parsed, and
/// are not kept in the tree.
struct JsonStream {
  /// The keys that lead to the array from the top level: "claim", "forces".
  std::vector<std::string> keys;
  /// Takes the elements.
  std::function<void(std::size_t index, const JsonNode& element)> sink;
};

/// Parses one JSON value. Throws InputError with a line:column for bad syntax, and with a JSON
/// path for a repeated key and beyond the limits. What a sink throws is passed on.
JsonNode parse_json(std::string_view text, const std::vector<JsonStream>& streams = {});

/// Returns a string as JSON writes it, quotes included. Throws InputError at `path` if it is
/// not UTF-8.
std::string json_string(const std::string& text, const std::string& path);

/// Reads a JSON Lines file one line at a time. Memory holds one line, of at most kMaxJsonBytes.
class TextLines {
 public:
  /// Reads from `in`, which must outlive this. So many lines and bytes were read before.
  explicit TextLines(std::istream& in, std::size_t lines_before = 0,
                     std::uintmax_t bytes_before = 0)
      : in_(in), number_(lines_before), end_(bytes_before) {}

  /// Reads the next line that is not blank into `line`; returns false at the end. Throws
  /// InputError for a line that is too long. That line has then been skipped: next() may be
  /// called again, and number() is its number.
  bool next(std::string& line);

  /// Returns the number of the last line read, from 1, blank ones counted.
  std::size_t number() const { return number_; }

  std::uintmax_t begin() const { return begin_; }  ///< the first byte of the last line read
  std::uintmax_t end() const { return end_; }      ///< the first byte of the next line

 private:
  std::istream& in_;
  std::size_t number_;
  std::uintmax_t begin_ = 0;
  std::uintmax_t end_;
};

/// Throws InputError at `path`.
[[noreturn]] void fail_at(const std::string& path, std::string problem, std::string remedy);

/// Returns what `read` returns. If `read` throws an InputError that names no file, its place is
/// taken to begin at the value at `path`, and the error is thrown with the whole path.
template <class Read>
auto within(const std::string& path, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    if (!error.file().empty()) throw;
    const std::string below = error.place() == place_name("") ? "" : error.place();
    fail_at(path + (below.empty() ? "" : "." + below), error.problem(), error.remedy());
  }
}

/// Throws InputError unless the node has this kind; `expected` says the kind in words.
void expect(const JsonNode& node, JsonNode::Kind kind, const std::string& path,
            const char* expected);

/// Throws InputError unless the node is an object without keys other than these. For a near
/// miss the error says which key may have been meant.
void expect_object(const JsonNode& node, const std::string& path,
                   const std::vector<std::string>& allowed);

/// Throws InputError unless the node is an array of `length` values; `form` describes it, "an
/// array of two numbers [x, y]".
void expect_array(const JsonNode& node, const std::string& path, std::size_t length,
                  const char* form);

/// Returns the value of a required key. Throws InputError with this remedy if there is none.
const JsonNode& member(const JsonNode& object, const std::string& path, const char* key,
                       const char* remedy);

/// Returns the number of a node that is a JSON number or a string that parse_rational reads.
Rational read_number(const JsonNode& node, const std::string& path);

/// Returns `length` numbers of an array; `form` describes them, "an array of two numbers [x,
/// y]".
std::vector<Rational> read_vector(const JsonNode& node, const std::string& path,
                                  std::size_t length, const char* form);

}  // namespace stickslip
