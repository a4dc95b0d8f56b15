// SPDX-License-Identifier: MIT
/// \file
/// Reading JSON (RFC 8259) from a stream with bounded memory, using the SAX reader of
/// nlohmann/json. Numbers keep their own characters. The reader is iterative; long arrays can
/// be handed over element by element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace stickslip_check {

struct Value {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;
  std::string text;               ///< a number's characters, a string's content
  std::vector<std::string> keys;  ///< of an object, one per item, all different
  std::vector<Value> items;       ///< of an array or an object
  std::size_t line = 0;           ///< where it begins, from 1

  const Value* find(const std::string& key) const;
  bool is_array(std::size_t size) const { return kind == Kind::kArray && items.size() == size; }
};

/// The value in a few words, for messages.
std::string describe(const Value& value);

/// Exceeding any of these makes a file malformed.
struct JsonLimits {
  std::uint64_t bytes;
  std::size_t depth;     ///< of nested arrays and objects
  bool byte_order_mark;  ///< whether the text may begin with one
  std::uint64_t token;   ///< bytes of a number, or of a string between its quotation marks
};
inline constexpr std::size_t kMaxMembers = 16;        ///< of an object
inline constexpr std::size_t kMaxValues = 1U << 22U;  ///< held at a time

/// Receives the members of the object that the text is.
class JsonHandler {
 public:
  virtual ~JsonHandler() = default;
  /// A member begins. If the answer is true and its value is an array, the elements arrive one
  /// by one and the array itself arrives empty.
  virtual bool begin_member(const std::string& key, std::size_t line) = 0;
  virtual void element(const Value& value) = 0;
  virtual void end_member(const std::string& key, const Value& value) = 0;
};

/// Throws Malformed, with `file` in it, for everything that is not one JSON object within the
/// limits, and lets what the handler throws pass.
void read_json(std::istream& in, const std::string& file, const JsonLimits& limits,
               JsonHandler& handler);

}  // namespace stickslip_check
