// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/json_value.hpp"

#include <algorithm>
#include <string>

#include "json_text.hpp"

namespace stickslip {
namespace {

[[noreturn]] void not_there(const char* what) {
  throw std::logic_error(std::string("a JSON value is not what it is taken for: ") + what);
}

/// A part of a text: a character of UTF-8, or bytes that begin none, or bytes that begin one
/// which does not end.
struct Character {
  std::size_t bytes;
  bool is_whole;
  std::size_t wrong;  ///< the first byte that does not fit
};

Character character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return {1, true, at};
  std::size_t length = 0;
  // The second byte has fewer values where others would be a surrogate, too large, or too long.
  unsigned low = 0x80;
  unsigned high = 0xBF;
  if (first >= 0xC2 && first <= 0xDF) {
    length = 2;
  } else if (first >= 0xE0 && first <= 0xEF) {
    length = 3;
    if (first == 0xE0) low = 0xA0;
    if (first == 0xED) high = 0x9F;
  } else if (first >= 0xF0 && first <= 0xF4) {
    length = 4;
    if (first == 0xF0) low = 0x90;
    if (first == 0xF4) high = 0x8F;
  }
  std::size_t bytes = 1;
  for (; bytes < length; ++bytes) {
    const unsigned next = byte(at + bytes);
    if (next < low || next > high) break;
    low = 0x80;
    high = 0xBF;
  }
  return {bytes, bytes == length, length == 0 ? at : at + bytes};
}

std::string hex(unsigned char byte, const char* digits) {
  return {digits[byte >> 4], digits[byte & 0xF]};
}

/// Returns the escape of an ASCII character; an empty string if it needs none.
std::string escape(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\b':
      return "\\b";
    case '\f':
      return "\\f";
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      break;
  }
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 ? "\\u00" + hex(byte, "0123456789abcdef") : std::string();
}

[[noreturn]] void refuse_byte(const std::string& text, std::size_t at) {
  const auto shown = [](char byte) {
    return ": 0x" + hex(static_cast<unsigned char>(byte), "0123456789ABCDEF");
  };
  throw JsonTextError(at == text.size()
                          ? "incomplete UTF-8 string; last byte" + shown(text.back())
                          : "invalid UTF-8 byte at index " + std::to_string(at) +
                                shown(text[at]));
}

}  // namespace

void core_detail::append_json_string(std::string& to, const std::string& text, bool replaces) {
  to += '"';
  std::size_t done = 0;  // all bytes before it are written
  for (std::size_t at = 0; at < text.size();) {
    const Character character = character_at(text, at);
    std::string instead;
    if (character.is_whole) {
      instead = character.bytes == 1 ? escape(text[at]) : std::string();
    } else if (replaces) {
      instead = "\xEF\xBF\xBD";
    } else {
      refuse_byte(text, character.wrong);
    }
    const std::size_t next = at + character.bytes;
    if (!instead.empty()) {
      to.append(text, done, at - done);
      to += instead;
      done = next;
    }
    at = next;
  }
  to.append(text, done);
  to += '"';
}

Json::Json(std::string text) : kind_(Kind::kString) {
  word_.text = new std::string(std::move(text));
}

Json::Json(std::initializer_list<Json> values) {
  const bool has_keys = std::all_of(values.begin(), values.end(), [](const Json& value) {
    return value.is_array() && value.size() == 2 && value.begin()->is_string();
  });
  if (!has_keys) {
    *this = array(values);
    return;
  }
  *this = object();
  word_.members->reserve(values.size());
  for (const Json& value : values) {
    std::vector<Json>& pair = *value.word_.values;
    word_.members->push_back({std::move(*pair[0].word_.text), std::move(pair[1])});
  }
}

Json::Json(const Json& other) : kind_(Kind::kNull), word_(other.word_) {
  switch (other.kind_) {
    case Kind::kString:
    case Kind::kExact:
      word_.text = new std::string(*other.word_.text);
      break;
    case Kind::kArray:
      word_.values = new std::vector<Json>(*other.word_.values);
      break;
    case Kind::kObject:
      word_.members = new std::vector<Member>(*other.word_.members);
      break;
    default:
      break;
  }
  kind_ = other.kind_;
}

void Json::release() noexcept {
  switch (kind_) {
    case Kind::kString:
    case Kind::kExact:
      delete word_.text;
      break;
    case Kind::kArray:
      delete word_.values;
      break;
    case Kind::kObject:
      delete word_.members;
      break;
    default:
      break;
  }
  kind_ = Kind::kNull;
}

Json Json::array(std::initializer_list<Json> values) {
  Json result;
  result.word_.values = new std::vector<Json>;
  result.kind_ = Kind::kArray;
  result.word_.values->reserve(values.size());
  for (const Json& value : values) {
    Json& moved = result.word_.values->emplace_back();
    std::swap(moved.kind_, value.kind_);
    std::swap(moved.word_, value.word_);
  }
  return result;
}

Json Json::object() {
  Json result;
  result.word_.members = new std::vector<Member>;
  result.kind_ = Kind::kObject;
  return result;
}

Json Json::exact(std::string digits) {
  Json result(std::move(digits));
  result.kind_ = Kind::kExact;
  return result;
}

const std::string& Json::text() const {
  if (kind_ != Kind::kString && kind_ != Kind::kExact) not_there("a text");
  return *word_.text;
}

std::size_t Json::count() const {
  if (kind_ == Kind::kInteger && word_.integer >= 0)
    return static_cast<std::size_t>(word_.integer);
  if (kind_ != Kind::kNatural) not_there("a count");
  return word_.natural;
}

std::size_t Json::size() const {
  switch (kind_) {
    case Kind::kNull:
      return 0;
    case Kind::kArray:
      return word_.values->size();
    case Kind::kObject:
      return word_.members->size();
    default:
      return 1;
  }
}

const Json* Json::begin() const {
  return is_array() ? word_.values->data() : nullptr;
}

const Json* Json::end() const {
  return is_array() ? word_.values->data() + word_.values->size() : nullptr;
}

std::vector<Json>& Json::values() {
  if (is_null()) *this = array();
  if (!is_array()) not_there("an array");
  return *word_.values;
}

void Json::push_back(Json value) {
  values().push_back(std::move(value));
}

Json& Json::back() {
  if (empty()) not_there("an array with values");
  return values().back();
}

const Json& Json::at(std::size_t index) const {
  if (!is_array() || index >= size()) not_there("an array so long");
  return (*word_.values)[index];
}

const std::vector<Json::Member>& Json::members() const {
  static const std::vector<Member> none;
  return is_object() ? *word_.members : none;
}

const Json* Json::find(std::string_view key) const {
  for (const Member& member : members()) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

const Json& Json::at(std::string_view key) const {
  const Json* const found = find(key);
  if (found == nullptr) not_there("an object with such a member");
  return *found;
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) *this = object();
  if (!is_object()) not_there("an object");
  for (Member& member : *word_.members) {
    if (member.key == key) return member.value;
  }
  word_.members->push_back({std::string(key), Json()});
  return word_.members->back().value;
}

void Json::erase(std::string_view key) {
  if (!is_object()) not_there("an object");
  std::vector<Member>& all = *word_.members;
  const auto is_it = [&](const Member& member) { return member.key == key; };
  all.erase(std::remove_if(all.begin(), all.end(), is_it), all.end());
}

void Json::update(Json other) {
  if (!other.is_object()) not_there("an object");
  for (Member& member : *other.word_.members) (*this)[member.key] = std::move(member.value);
}

/// Writes one tree.
class Json::Writer {
 public:
  Writer(int indent, Utf8 utf8) : indent_(indent), replaces_(utf8 == Utf8::kReplaced) {}

  void write(const Json& json, std::size_t depth) {
    switch (json.kind_) {
      case Kind::kNull:
        text_ += "null";
        return;
      case Kind::kBoolean:
        text_ += json.word_.boolean ? "true" : "false";
        return;
      case Kind::kInteger:
        text_ += std::to_string(json.word_.integer);
        return;
      case Kind::kNatural:
        text_ += std::to_string(json.word_.natural);
        return;
      case Kind::kReal:
        text_ += core_detail::json_double(json.word_.real);
        return;
      case Kind::kString:
        append_string(*json.word_.text);
        return;
      case Kind::kExact:
        not_there("a finished tree");
      case Kind::kArray:
        write_array(*json.word_.values, depth);
        return;
      case Kind::kObject:
        write_object(*json.word_.members, depth);
        return;
    }
  }

  std::string take_text() { return std::move(text_); }

 private:
  void append_string(const std::string& text) {
    core_detail::append_json_string(text_, text, replaces_);
  }

  void begin_line(std::size_t depth) {
    if (indent_ < 0) return;
    text_ += '\n';
    text_.append(depth * static_cast<std::size_t>(indent_), ' ');
  }

  void write_array(const std::vector<Json>& values, std::size_t depth) {
    text_ += '[';
    for (const Json& value : values) {
      if (&value != &values.front()) text_ += ',';
      begin_line(depth + 1);
      write(value, depth + 1);
    }
    if (!values.empty()) begin_line(depth);
    text_ += ']';
  }

  void write_object(const std::vector<Member>& members, std::size_t depth) {
    text_ += '{';
    for (const Member& member : members) {
      if (&member != &members.front()) text_ += ',';
      begin_line(depth + 1);
      append_string(member.key);
      text_ += indent_ < 0 ? ":" : ": ";
      write(member.value, depth + 1);
    }
    if (!members.empty()) begin_line(depth);
    text_ += '}';
  }

  int indent_;
  bool replaces_;
  std::string text_;
};

std::string Json::dump(int indent, Utf8 utf8) const {
  Writer writer(indent, utf8);
  writer.write(*this, 0);
  return writer.take_text();
}

}  // namespace stickslip
