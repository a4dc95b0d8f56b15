// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// JSON to write: answers, reports, pages. A text that is read becomes a JsonNode
/// (core/json.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stickslip {

/// The error that a text in a JSON tree is not UTF-8 and cannot be written.
class JsonTextError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A JSON value. Members of an object keep the order in which they were added. A value takes
/// two words; texts, arrays and objects own memory besides. Asking a value for what it is not
/// throws std::logic_error.
class Json {
  template <class Range>
  using IfRange = std::enable_if_t<
      !std::is_convertible_v<const Range&, std::string_view> && !std::is_same_v<Range, Json> &&
          std::is_convertible_v<decltype(*std::declval<const Range&>().begin()), Json>,
      int>;

 public:
  struct Member;

  /// \{ \brief Makes null, a truth value, a number or a string.
  Json() noexcept = default;
  Json(std::nullptr_t) noexcept {}
  template <class T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0>
  Json(T value) noexcept {
    if constexpr (std::is_same_v<T, bool>) {
      kind_ = Kind::kBoolean;
      word_.boolean = value;
    } else if constexpr (std::is_floating_point_v<T>) {
      kind_ = Kind::kReal;
      word_.real = static_cast<double>(value);
    } else if constexpr (std::is_signed_v<T>) {
      kind_ = Kind::kInteger;
      word_.integer = value;
    } else {
      kind_ = Kind::kNatural;
      word_.natural = value;
    }
  }
  Json(std::string text);
  Json(std::string_view text) : Json(std::string(text)) {}
  Json(const char* text) : Json(std::string(text)) {}
  /// \}
  /// Makes an object if each value is an array of a string and one more value; else an array.
  /// The values move.
  Json(std::initializer_list<Json> values);
  /// Makes an array of the values of a range.
  template <class Range, IfRange<Range> = 0>
  Json(const Range& range) : Json(array()) {
    for (const auto& value : range) push_back(value);
  }
  /// \{ Makes a copy, or takes another value, which becomes null.
  Json(const Json& other);
  Json(Json&& other) noexcept : kind_(other.kind_), word_(other.word_) {
    other.kind_ = Kind::kNull;
  }
  /// \}
  /// *this becomes the other value.
  Json& operator=(Json other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(word_, other.word_);
    return *this;
  }
  ~Json() {
    if (kind_ >= Kind::kString) release();
  }

  /// Returns an array of these values, which move.
  static Json array(std::initializer_list<Json> values = {});
  /// Returns an object without members.
  static Json object();
  /// Returns an exact number by its digits. It stands in a tree until finished()
  /// (core/number_text.hpp) writes it as a string; until then it cannot be written.
  static Json exact(std::string digits);
  /// Returns the value that a JSON text spells. Numbers become numbers of the machine. Throws
  /// ContractError if the text is no JSON: only texts that a program wrote itself may be
  /// parsed.
  static Json parse(std::string_view text);

  /// \{ Returns whether the value is of this kind; is_true() is true for `true` alone.
  bool is_null() const { return kind_ == Kind::kNull; }
  bool is_true() const { return kind_ == Kind::kBoolean && word_.boolean; }
  bool is_string() const { return kind_ == Kind::kString; }
  bool is_exact() const { return kind_ == Kind::kExact; }
  bool is_array() const { return kind_ == Kind::kArray; }
  bool is_object() const { return kind_ == Kind::kObject; }
  /// \}

  /// Returns the content of a string, or the digits of an exact number.
  const std::string& text() const;
  /// Returns the value of a natural number, such as a count.
  std::size_t count() const;

  /// Returns the number of values of an array, or of members of an object; 0 for null, else 1.
  std::size_t size() const;
  /// Returns whether size() is 0.
  bool empty() const { return size() == 0; }

  /// \{ Iterates over the values of an array; anything else has none.
  const Json* begin() const;
  const Json* end() const;
  /// \}
  /// Adds a value to an array; null becomes an array. O(1), on average.
  void push_back(Json value);
  /// Adds a value to an array and returns it; null becomes an array.
  template <class Value>
  Json& emplace_back(Value&& value) {
    push_back(Json(std::forward<Value>(value)));
    return back();
  }
  /// Returns the last value of an array that has one.
  Json& back();
  /// \{ Returns a value of an array.
  template <class Index, std::enable_if_t<std::is_integral_v<Index>, int> = 0>
  Json& operator[](Index index) {
    return const_cast<Json&>(at(static_cast<std::size_t>(index)));
  }
  template <class Index, std::enable_if_t<std::is_integral_v<Index>, int> = 0>
  const Json& operator[](Index index) const {
    return at(static_cast<std::size_t>(index));
  }
  /// \}

  /// Returns the members of an object; anything else has none.
  const std::vector<Member>& members() const;
  /// Returns the value of a member, or nullptr. It takes O(members), as do all functions that
  /// follow.
  const Json* find(std::string_view key) const;
  /// Returns whether there is a member of this name.
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// \{ Returns the value of a member that is there.
  const Json& at(std::string_view key) const;
  const Json& operator[](const char* key) const { return at(std::string_view(key)); }
  /// \}
  /// \{ Returns the value of a member of an object; null becomes an object. If there is no such
  /// member, it is added as the last one, with the value null.
  Json& operator[](std::string_view key);
  Json& operator[](const std::string& key) { return (*this)[std::string_view(key)]; }
  Json& operator[](const char* key) { return (*this)[std::string_view(key)]; }
  /// \}
  /// Removes a member, if it is there.
  void erase(std::string_view key);
  /// Sets all members of another object in this one.
  void update(Json other);

  /// The treatment of texts that are not UTF-8: they are refused, or written with U+FFFD in
  /// place of the wrong bytes.
  enum class Utf8 { kRequired, kReplaced };
  /// Returns the text of the value, on one line without blanks. With `indent` >= 0 each value
  /// is on a line of its own, with so many blanks before it for each level. Throws
  /// JsonTextError for a text that is not UTF-8, unless these are replaced.
  std::string dump(int indent = -1, Utf8 utf8 = Utf8::kRequired) const;

 private:
  enum class Kind : unsigned char {
    kNull,
    kBoolean,
    kInteger,
    kNatural,
    kReal,
    kString,
    kExact,
    kArray,
    kObject
  };
  union Word {
    bool boolean;
    std::int64_t integer;
    std::uint64_t natural;
    double real;
    std::string* text;
    std::vector<Json>* values;
    std::vector<Member>* members;
  };
  class Writer;

  void release() noexcept;
  const Json& at(std::size_t index) const;
  std::vector<Json>& values();

  // They are mutable because values in a std::initializer_list are constant and have to be
  // moved nevertheless.
  mutable Kind kind_ = Kind::kNull;
  mutable Word word_{};
};

/// A member of an object: `for (const auto& [key, value] : json.members())`.
struct Json::Member {
  std::string key;  ///< its name
  Json value;       ///< its value
};

}  // namespace stickslip
