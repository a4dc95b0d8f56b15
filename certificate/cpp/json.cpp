// SPDX-License-Identifier: MIT
#include "json.hpp"

#include <algorithm>
#include <utility>

#include "answer.hpp"
#include "number.hpp"
#include "work.hpp"

namespace stickslip_check {
namespace {

constexpr int kEnd = std::istream::traits_type::eof();
/// No object of either file may have so many members.
constexpr std::size_t kTooManyMembers = 32;

bool is_digit(int c) {
  return c >= '0' && c <= '9';
}

void append_utf8(std::string& text, unsigned code) {
  const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
  if (code < 0x80U) {
    add(code);
  } else if (code < 0x800U) {
    add(0xC0U | code >> 6U);
    add(0x80U | (code & 0x3FU));
  } else if (code < 0x10000U) {
    add(0xE0U | code >> 12U);
    add(0x80U | (code >> 6U & 0x3FU));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xF0U | code >> 18U);
    add(0x80U | (code >> 12U & 0x3FU));
    add(0x80U | (code >> 6U & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

}  // namespace

const Value* Value::find(const std::string& key) const {
  const auto it = std::find(keys.begin(), keys.end(), key);
  return it == keys.end() ? nullptr : &items[static_cast<std::size_t>(it - keys.begin())];
}

std::string describe(const Value& value) {
  switch (value.kind) {
    case Value::Kind::kNumber:
      return "the number " + quote(value.text);
    case Value::Kind::kString:
      return "the string " + quote(value.text);
    case Value::Kind::kArray:
      return "an array of " + std::to_string(value.items.size());
    case Value::Kind::kObject:
      return "an object";
    default:
      return value.text;
  }
}

JsonReader::JsonReader(std::istream& in, std::string file, const JsonLimits& limits)
    : in_(in), file_(std::move(file)), limits_(limits) {
  next_ = in_.rdbuf() == nullptr ? kEnd : in_.rdbuf()->sbumpc();
  if (next_ == 0xEF) {
    if (!limits_.byte_order_mark) fail_here("a byte order mark; use UTF-8 without one");
    if (take() != 0xEF || take() != 0xBB || take() != 0xBF) fail_here("not UTF-8");
    column_ = 1;
  }
}

std::optional<std::string> JsonReader::next_member() {
  const bool first = depth_ == 0;
  if (first) {
    if (skip_blanks() == kEnd) fail_here("the file is empty");
    if (peek() != '{') fail_here("expected an object {...}");
    open('{');
  }
  if (next_item('}', first)) {
    members_.push_back(key());
    if (std::count(members_.begin(), members_.end(), members_.back()) > 1) {
      fail_here("the member " + quote(members_.back()) + " appears twice; keep one of them");
    }
    return members_.back();
  }
  if (skip_blanks() != kEnd) fail_here("text after the last brace");
  return std::nullopt;
}

bool JsonReader::next_element() {
  const bool first = !in_array_;
  if (first) {
    if (skip_blanks() != '[') fail_here("expected an array [...]");
    open('[');
  }
  in_array_ = next_item(']', first);
  return in_array_;
}

Value JsonReader::value() {
  std::size_t count = 0;
  return nested(count);
}

void JsonReader::fail(std::size_t line, const std::string& place,
                      const std::string& problem) const {
  throw Malformed{file_, "line " + std::to_string(line) + (place.empty() ? "" : ", " + place),
                  problem};
}

void JsonReader::expect(bool good, const Value& value, const std::string& place,
                        const std::string& what) const {
  if (!good) fail(value.line, place, "found " + describe(value) + ", expected " + what);
}

void JsonReader::fail_here(const std::string& problem) const {
  throw Malformed{
      file_, "line " + std::to_string(line_) + ", column " + std::to_string(column_), problem};
}

/// The byte to come, which must be there.
int JsonReader::take() {
  const int taken = next_;
  if (taken == kEnd) {
    fail_here(in_.bad() ? "the file cannot be read" : "the text ends here; is it complete?");
  }
  note_byte();
  if (++bytes_ > limits_.bytes)
    fail_here("more than " + std::to_string(limits_.bytes) + " bytes");
  if (taken == '\n') {
    ++line_;
    column_ = 0;
  }
  ++column_;
  next_ = in_.rdbuf()->sbumpc();
  return taken;
}

/// Returns the byte after the blanks, or kEnd.
int JsonReader::skip_blanks() {
  while (next_ == ' ' || next_ == '\t' || next_ == '\n' || next_ == '\r') take();
  return next_;
}

void JsonReader::open(char bracket) {
  if (depth_ == limits_.depth) {
    fail_here("nested more than " + std::to_string(limits_.depth) + " deep");
  }
  ++depth_;
  if (take() != bracket) fail_here(std::string("expected ") + bracket);
}

/// Whether the innermost array or object, which `bracket` closes, has another item.
bool JsonReader::next_item(char bracket, bool first) {
  if (skip_blanks() == bracket) {
    take();
    --depth_;
    return false;
  }
  if (first) return true;
  if (peek() != ',') fail_here(std::string("expected a comma or ") + bracket);
  take();
  if (skip_blanks() == bracket) fail_here("a comma after the last element; remove it");
  return true;
}

Value JsonReader::nested(std::size_t& count) {
  if (++count > limits_.values) {
    fail_here("more than " + std::to_string(limits_.values) + " values in one place");
  }
  Value value;
  const int c = skip_blanks();
  value.line = line_;
  if (c == '{' || c == '[') {
    value.kind = c == '{' ? Value::Kind::kObject : Value::Kind::kArray;
    const char close = c == '{' ? '}' : ']';
    open(static_cast<char>(c));
    while (next_item(close, value.items.empty())) {
      if (c == '{') {
        std::string name = key();
        if (value.find(name) != nullptr) {
          fail_here("the member " + quote(name) + " appears twice; keep one of them");
        }
        if (value.keys.size() == kTooManyMembers) fail_here("too many members in one object");
        value.keys.push_back(std::move(name));
      }
      value.items.push_back(nested(count));
    }
  } else if (c == '"') {
    value.kind = Value::Kind::kString;
    value.text = string();
  } else if (c == '-' || is_digit(c)) {
    value.kind = Value::Kind::kNumber;
    value.text = number();
  } else {
    word(value);
  }
  return value;
}

std::string JsonReader::key() {
  if (skip_blanks() != '"') fail_here("expected the name of a member, in double quotes");
  std::string name = string();
  if (skip_blanks() != ':') fail_here("expected a colon after the name of a member");
  take();
  return name;
}

std::string JsonReader::string() {
  std::string text;
  take();
  const std::uint64_t begin = bytes_;
  for (;;) {
    const int c = take();
    if (c == '"') return text;
    if (bytes_ - begin > limits_.string) {
      fail_here("a string of more than " + std::to_string(limits_.string) + " bytes");
    }
    if (c < ' ') fail_here("a control character in a string; write it as an escape");
    if (c == '\\') {
      escape(text);
    } else {
      rest_of_character(c, text);
    }
  }
}

void JsonReader::escape(std::string& text) {
  static const std::string kLetters = "\"\\/bfnrt";
  static const std::string kMeanings = "\"\\/\b\f\n\r\t";
  const int c = take();
  if (c != 'u') {
    const std::size_t at = kLetters.find(static_cast<char>(c));
    if (at == std::string::npos) fail_here("an unknown escape in a string");
    text += kMeanings[at];
    return;
  }
  unsigned code = hexadecimal();
  if (code >= 0xD800U && code < 0xE000U) {
    const bool pair = code < 0xDC00U && take() == '\\' && take() == 'u';
    const unsigned low = pair ? hexadecimal() : 0;
    if (low < 0xDC00U || low >= 0xE000U) {
      fail_here("a \\u escape that is half of a surrogate pair");
    }
    code = 0x10000U + (code - 0xD800U) * 0x400U + (low - 0xDC00U);
  }
  append_utf8(text, code);
}

unsigned JsonReader::hexadecimal() {
  unsigned code = 0;
  for (int k = 0; k < 4; ++k) {
    const int c = take();
    const int letter = c | 0x20;
    if (!is_digit(c) && (letter < 'a' || letter > 'f')) {
      fail_here("\\u must be followed by four hexadecimal digits");
    }
    code = 16 * code + static_cast<unsigned>(is_digit(c) ? c - '0' : letter - 'a' + 10);
  }
  return code;
}

/// The bytes of a character that begins with `lead`, in the shortest form that UTF-8 asks for.
void JsonReader::rest_of_character(int lead, std::string& text) {
  const int more = lead < 0x80 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
  if ((lead >= 0x80 && lead < 0xC2) || lead > 0xF4) fail_here("not UTF-8");
  text += static_cast<char>(lead);
  for (int k = 0; k < more; ++k) {
    const int c = take();
    const int low = k > 0 ? 0x80 : lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
    const int high = k > 0 ? 0xBF : lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    if (c < low || c > high) fail_here("not UTF-8");
    text += static_cast<char>(c);
  }
}

std::string JsonReader::number() {
  std::string text;
  const auto keep = [&] {
    text += static_cast<char>(take());
    if (text.size() > limits_.string) fail_here("a number of far too many digits");
  };
  const auto digits = [&] {
    if (!is_digit(peek())) fail_here("not a number; numbers look like 2, -0.25 or 1e-3");
    while (is_digit(peek())) keep();
  };
  if (peek() == '-') keep();
  if (peek() == '0') {
    keep();
    if (is_digit(peek())) fail_here("a number that begins with a zero too many");
  } else {
    digits();
  }
  if (peek() == '.') {
    keep();
    digits();
  }
  if (peek() == 'e' || peek() == 'E') {
    keep();
    if (peek() == '+' || peek() == '-') keep();
    digits();
  }
  return text;
}

void JsonReader::word(Value& value) {
  while (peek() >= 'a' && peek() <= 'z' && value.text.size() < 6) {
    value.text += static_cast<char>(take());
  }
  if (value.text == "true" || value.text == "false") {
    value.kind = Value::Kind::kBoolean;
  } else if (value.text != "null") {
    fail_here(peek() == kEnd && value.text.empty()
                  ? "the text ends here; is it complete?"
                  : "not JSON; strings take double quotes, numbers look like 2, -0.25 or 1e-3");
  }
}

}  // namespace stickslip_check
