// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/json_members.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json_tree.hpp"

namespace stickslip {
namespace {

class Splitter {
 public:
  explicit Splitter(std::string_view text) : text_(text) {}

  std::vector<JsonMember> run() {
    std::vector<JsonMember> members;
    take('{', "an object {...} is expected here");
    skip_blanks();
    if (peek() == '}') {
      ++at_;
    } else {
      do {
        members.push_back(take_member());
        const auto same = [&](const JsonMember& m) { return m.key == members.back().key; };
        if (std::any_of(members.begin(), members.end() - 1, same)) {
          throw InputError("", place_name(""),
                           "the key " + quote(members.back().key) + " appears twice",
                           "keep one of them");
        }
        if (members.size() > kMaxJsonNodes) {
          throw InputError("", place_name(""),
                           "more than " + std::to_string(kMaxJsonNodes) + " keys",
                           "an object here has a few");
        }
      } while (took_comma());
    }
    skip_blanks();
    if (peek() == ',') fail("a comma after the object", "remove it: lines need none between");
    if (at_ != text_.size()) fail("nothing may follow the object", "write one object a line");
    return members;
  }

 private:
  /// NUL where the text ends; a NUL in the text fits nowhere either.
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  std::size_t column(std::size_t offset) const {
    const auto begin = text_.begin();
    return static_cast<std::size_t>(
        std::count_if(begin, begin + static_cast<std::ptrdiff_t>(offset),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw InputError("", "1:" + std::to_string(column(at_) + 1), problem, remedy);
  }

  void take(char expected, const char* problem) {
    skip_blanks();
    if (peek() != expected) fail(problem, "is the line complete, and JSON?");
    ++at_;
  }

  /// From a double quote to behind the one that closes the string.
  void skip_string() {
    const std::size_t start = at_++;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (at_ >= text_.size()) {
      at_ = start;
      fail("this string does not end", "close it with a double quote");
    }
    ++at_;
  }

  JsonMember take_member() {
    const std::size_t start_of_member = at_;
    skip_blanks();
    if (peek() == '}') {  // not that of an empty object: there is a comma before
      at_ = start_of_member - 1;
      fail("a comma before \"}\"", "remove it: no comma follows the last element");
    }
    if (peek() != '"') fail("a key in double quotes is expected here", "write \"key\": value");
    const std::size_t key_start = at_;
    skip_string();
    const std::string key =
        std::string(column(key_start), ' ').append(text_.substr(key_start, at_ - key_start));
    take(':', "a colon is expected between a key and its value");
    skip_blanks();
    const std::size_t start = at_;
    skip_value();
    const std::string_view span = text_.substr(start, at_ - start);
    const std::size_t last = span.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) {
      at_ = start;
      fail("a value is missing", "write \"key\": value");
    }
    return {parse_json(key, "", {}).text, span.substr(0, last + 1), column(start)};
  }

  /// To the comma or brace that ends a member of this object.
  void skip_value() {
    std::size_t depth = 0;
    for (; at_ < text_.size(); ++at_) {
      switch (text_[at_]) {
        case '"':
          skip_string();
          --at_;  // the loop steps over the closing quote
          break;
        case '{':
        case '[':
          ++depth;
          break;
        case '}':
        case ']':
          if (depth == 0) return;
          --depth;
          break;
        case ',':
          if (depth == 0) return;
          break;
        default:
          break;
      }
    }
    fail("the line ends inside the object", "write the whole object on one line");
  }

  bool took_comma() {
    if (peek() == ',') {
      ++at_;
      return true;
    }
    take('}', "a comma or the end of the object is expected here");
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<JsonMember> split_json_object(std::string_view text) {
  return Splitter(text).run();
}

}  // namespace stickslip
