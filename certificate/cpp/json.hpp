// SPDX-License-Identifier: MIT
/// \file
/// Reading JSON (RFC 8259, UTF-8) from a stream, in bounded memory: the text is one object,
/// whose members are taken one by one, and a member that is an array may be taken element by
/// element. Numbers and strings keep their own characters. All throw Malformed, with the file's
/// name and the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
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
  bool is_text(const char* wanted) const { return kind == Kind::kString && text == wanted; }
};

/// The value in a few words, for messages.
std::string describe(const Value& value);

/// Exceeding any of these makes a file malformed.
struct JsonLimits {
  std::uint64_t bytes;
  std::size_t depth;     ///< of nested arrays and objects
  std::size_t string;    ///< bytes between the quotation marks; or of a number
  std::size_t values;    ///< in one call of JsonReader::value, arrays and objects included
  bool byte_order_mark;  ///< whether the text may begin with one
};

class JsonReader {
 public:
  JsonReader(std::istream& in, std::string file, const JsonLimits& limits);

  const std::string& file() const { return file_; }
  std::size_t line() const { return line_; }

  /// The name of the next member of the text's object; nothing when it, and the text, have
  /// ended. The member is to be read before the next call.
  std::optional<std::string> next_member();
  /// In a member that is to be taken as an array: whether there is another element. The element
  /// is to be read before the next call.
  bool next_element();
  /// Reads a value whole.
  Value value();

  /// Throws Malformed at the line.
  [[noreturn]] void fail(std::size_t line, const std::string& place,
                         const std::string& problem) const;
  /// Throws unless `good`, saying what was found instead of `what`.
  void expect(bool good, const Value& value, const std::string& place,
              const std::string& what) const;

 private:
  [[noreturn]] void fail_here(const std::string& problem) const;
  int peek() const { return next_; }
  int take();
  int skip_blanks();
  void open(char bracket);
  bool next_item(char bracket, bool first);
  Value nested(std::size_t& count);
  std::string key();
  std::string string();
  void escape(std::string& text);
  unsigned hexadecimal();
  void rest_of_character(int lead, std::string& text);
  std::string number();
  void word(Value& value);

  std::istream& in_;
  std::string file_;
  JsonLimits limits_;
  int next_ = 0;  ///< the byte to come, or EOF
  std::uint64_t bytes_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 1;
  std::size_t depth_ = 0;
  std::vector<std::string> members_;  ///< of the text's object, so far
  bool in_array_ = false;             ///< of next_element
};

}  // namespace stickslip_check
