// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A JSON text as a small tree in which numbers keep their own characters, and values taken out
/// of it. What is given a `path`, a JSON path, throws InputError there; that of the root is
/// empty.
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

/// \{ Limits on what is read, so that hostile input ends in an error and not in an hour.
inline constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 28;
inline constexpr std::size_t kMaxJsonDepth = 32;
/// Values in one member of the top level but for streamed elements, and in each of these.
inline constexpr std::size_t kMaxJsonNodes = std::size_t{1} << 16;
/// Members of one object.
inline constexpr std::size_t kMaxJsonKeys = 32;
/// \}

/// An array that may be long: its elements are handed over one by one as they are parsed, and
/// are not kept in the tree.
struct JsonStream {
  std::vector<std::string> keys;  ///< that lead to it from the top level: "claim", "forces"
  std::function<void(std::size_t index, const JsonNode& element)> sink;  ///< takes them
};

/// Parses one JSON value. Throws InputError with a line:column for bad syntax, and with a JSON
/// path for a repeated key and beyond the limits; what a sink throws is passed on.
JsonNode parse_json(std::string_view text, const std::vector<JsonStream>& streams = {});

/// A string as JSON writes it, quotes included. Throws InputError at `path` if it is not UTF-8.
std::string json_string(const std::string& text, const std::string& path);

/// The lines of a JSON Lines file one at a time; memory holds one, of at most kMaxJsonBytes.
class TextLines {
 public:
  /// Reads from `in`, which must outlive this; so many lines and bytes stood before.
  explicit TextLines(std::istream& in, std::size_t lines_before = 0,
                     std::uintmax_t bytes_before = 0)
      : in_(in), number_(lines_before), end_(bytes_before) {}

  /// The next line that is not blank, false at the end. Throws InputError for a line that is
  /// too long, which has been skipped, so that next() may be called again; number() is its
  /// number.
  bool next(std::string& line);

  /// Of the last line read, from 1, blank ones counted.
  std::size_t number() const { return number_; }

  std::uintmax_t begin() const { return begin_; }  ///< of the last line read: where it begins
  std::uintmax_t end() const { return end_; }      ///< and where the next one does

 private:
  std::istream& in_;
  std::size_t number_;
  std::uintmax_t begin_ = 0;
  std::uintmax_t end_;
};

/// Throws the InputError.
[[noreturn]] void fail_at(const std::string& path, std::string problem, std::string remedy);

/// What `read` returns; its errors, unless they are about another file, are about the value at
/// `path`, in which their own places begin.
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

/// The node has this kind; `expected` says so in words.
void expect(const JsonNode& node, JsonNode::Kind kind, const std::string& path,
            const char* expected);

/// An object without keys other than these; a near miss is told what was meant.
void expect_object(const JsonNode& node, const std::string& path,
                   const std::vector<std::string>& allowed);

/// An array of `length` values; `form` describes it, "an array of two numbers [x, y]".
void expect_array(const JsonNode& node, const std::string& path, std::size_t length,
                  const char* form);

/// The value of a required key.
const JsonNode& member(const JsonNode& object, const std::string& path, const char* key,
                       const char* remedy);

/// A JSON number or a string that parse_rational reads.
Rational read_number(const JsonNode& node, const std::string& path);

/// `length` numbers; `form` describes them, "an array of two numbers [x, y]".
std::vector<Rational> read_vector(const JsonNode& node, const std::string& path,
                                  std::size_t length, const char* form);

}  // namespace stickslip
