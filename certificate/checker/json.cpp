// SPDX-License-Identifier: MIT
#include "json.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "answer.hpp"
#include "number.hpp"

namespace stickslip_check {
namespace {

// The parser computes a floating-point value that nobody uses, but refuses what overflows it;
// long double reaches 1e4932 and keeps out of the way of the formats' own limits.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

/// The bytes of a stream, counted. The parser keeps what it has read of a token, blanks
/// included, so long tokens end here and blanks outside of strings are passed on singly.
class Source {
 public:
  Source(std::istream& in, std::string file, const JsonLimits& limits)
      : buffer_(in.rdbuf()), file_(std::move(file)), limits_(limits) {
    next();
  }

  bool done() const { return done_; }
  char current() const { return current_; }
  std::size_t line() const { return line_; }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Malformed{file_,
                    "line " + std::to_string(line_) + ", column " + std::to_string(column_),
                    problem};
  }

  void next() {
    bool blank = true;
    do {
      const int byte = buffer_ == nullptr ? EOF : buffer_->sbumpc();
      if (byte == EOF) {
        done_ = true;
        return;
      }
      const bool was_blank = after_blank_;
      accept(static_cast<char>(byte));
      blank = was_blank && after_blank_;
    } while (blank);
  }

 private:
  void accept(char c) {
    if (++bytes_ > limits_.bytes) fail("more than " + std::to_string(limits_.bytes) + " bytes");
    // nlohmann/json takes NUL for the end of the text, and would not see what follows.
    if (c == '\0') fail("a NUL byte; JSON text has none");
    if (current_ == '\n') {
      ++line_;
      column_ = 0;
    }
    ++column_;
    if (bytes_ == 1 && c == '\xEF' && !limits_.byte_order_mark) {
      fail("a byte order mark; use UTF-8 without one");
    }
    current_ = c;
    after_blank_ = !in_string_ && (c == ' ' || c == '\t' || c == '\n' || c == '\r');
    const bool ends_token = !in_string_ && (after_blank_ || c == ',' || c == ':' || c == '[' ||
                                            c == ']' || c == '{' || c == '}');
    token_ = ends_token ? 0 : token_ + 1;
    if (token_ > limits_.token + 2) {
      fail("a number or string of more than " + std::to_string(limits_.token) + " bytes");
    }
    if (escaped_) {
      escaped_ = false;
    } else if (in_string_ && c == '\\') {
      escaped_ = true;
    } else if (c == '"') {
      in_string_ = !in_string_;
    }
  }

  std::streambuf* buffer_;
  std::string file_;
  JsonLimits limits_;
  std::uint64_t bytes_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 0;
  std::uint64_t token_ = 0;
  char current_ = ' ';
  bool done_ = false;
  bool after_blank_ = false;
  bool in_string_ = false;
  bool escaped_ = false;
};

/// The input iterator over a Source that nlohmann/json wants.
class Bytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  explicit Bytes(Source* source) : source_(source) {}
  char operator*() const { return source_->current(); }
  Bytes& operator++() {
    source_->next();
    return *this;
  }
  Bytes operator++(int) { return ++*this; }
  bool operator==(const Bytes& other) const { return ended() == other.ended(); }
  bool operator!=(const Bytes& other) const { return !(*this == other); }

 private:
  bool ended() const { return source_ == nullptr || source_->done(); }
  Source* source_;
};

/// Builds values. Every array or object still open is an entry of `open_`; open_[0] is the
/// whole text, whose members go to the handler and are not kept.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(Source& source, const JsonLimits& limits, JsonHandler& handler)
      : source_(source), limits_(limits), handler_(handler) {}

  bool null() override { return scalar(Value::Kind::kNull, "null"); }
  bool boolean(bool value) override {
    return scalar(Value::Kind::kBoolean, value ? "true" : "false");
  }
  bool number_integer(number_integer_t value) override {
    return scalar(Value::Kind::kNumber, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(Value::Kind::kNumber, std::to_string(value));
  }
  bool number_float(number_float_t /*rounded*/, const std::string& characters) override {
    std::string text = characters;
    // The parser replaces the decimal point by that of the C locale in force.
    for (char& c : text) {
      if ((c < '0' || c > '9') && c != '-' && c != '+' && c != 'e' && c != 'E') c = '.';
    }
    return scalar(Value::Kind::kNumber, std::move(text));
  }
  bool string(std::string& text) override {
    return scalar(Value::Kind::kString, std::move(text));
  }
  bool binary(binary_t& /*bytes*/) override { return false; }  // never in JSON text

  bool start_object(std::size_t /*unknown*/) override { return open(Value::Kind::kObject); }
  bool start_array(std::size_t /*unknown*/) override { return open(Value::Kind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    std::vector<std::string>& keys = open_.back().keys;
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
      source_.fail("the member " + quote(name) + " appears twice; keep one of them");
    }
    if (keys.size() == kMaxMembers) source_.fail("an object with too many members");
    keys.push_back(name);
    if (open_.size() == 1) streams_ = handler_.begin_member(name, source_.line());
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow)
      source_.fail("a number out of range; write it as a string");
    if (source_.done()) source_.fail("the text ends too early, or is empty; is it complete?");
    source_.fail(
        "not JSON; strings take double quotes, numbers look like -2, and nothing "
        "follows the last brace");
  }

 private:
  bool streamed_array_is_open() const {
    return streams_ && open_.size() == 2 && open_[1].kind == Value::Kind::kArray;
  }

  void count() {
    if (++values_ > kMaxValues) source_.fail("too many values in one place");
  }

  bool scalar(Value::Kind kind, std::string text) {
    count();
    return finish({kind, std::move(text), {}, {}, source_.line()});
  }

  bool open(Value::Kind kind) {
    if (open_.empty() && kind != Value::Kind::kObject) source_.fail("expected an object {...}");
    if (open_.size() == limits_.depth) {
      source_.fail("nested more than " + std::to_string(limits_.depth) + " deep");
    }
    count();
    open_.push_back({kind, {}, {}, {}, source_.line()});
    return true;
  }

  bool close() {
    Value closed = std::move(open_.back());
    open_.pop_back();
    return open_.empty() || finish(std::move(closed));
  }

  bool finish(Value value) {
    if (open_.empty()) source_.fail("expected an object {...}, found " + describe(value));
    if (open_.size() > 1 && !streamed_array_is_open()) {
      open_.back().items.push_back(std::move(value));
      return true;
    }
    if (open_.size() == 1) {
      handler_.end_member(open_[0].keys.back(), value);
    } else {
      handler_.element(value);
    }
    values_ = 0;
    return true;
  }

  Source& source_;
  JsonLimits limits_;
  JsonHandler& handler_;
  std::vector<Value> open_;
  std::size_t values_ = 0;
  bool streams_ = false;
};

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

void read_json(std::istream& in, const std::string& file, const JsonLimits& limits,
               JsonHandler& handler) {
  Source source(in, file, limits);
  Builder builder(source, limits, handler);
  if (!Json::sax_parse(Bytes(&source), Bytes(nullptr), &builder)) source.fail("not JSON");
  if (in.bad()) source.fail("the file cannot be read");
}

}  // namespace stickslip_check
