// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/json.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "json_text.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/json_value.hpp"

namespace stickslip {
namespace {

// The floating-point type is only a by-product of the parser, which rejects what overflows
// it. long double on x86 reaches 1e4932, so it does not get in the way of kMaxExponent.
using ParsedJson = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                        std::uint64_t, long double>;

/// Returns "line:column" of a byte, columns counted in characters.
std::string position_of(std::string_view text, std::size_t offset) {
  std::size_t line = 1;
  std::size_t column = 1;
  for (const char c : text.substr(0, offset)) {
    if (c == '\n') {
      ++line;
      column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
      ++column;
    }
  }
  return std::to_string(line) + ":" + std::to_string(column);
}

bool in_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         c == '+' || c == '-' || c == '.' || c == '_';
}

bool is_ascii(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

bool is_not_finite(std::string word) {
  for (char& c : word) c = (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.erase(0, 1);
  return word == "nan" || word == "inf" || word == "infinity";
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// Returns the parser's own words, without its name, its position and the bytes it choked on.
std::string essence(std::string message) {
  const std::size_t start = message.find(" - ");
  if (start != std::string::npos) message.erase(0, start + 3);
  const std::size_t end = message.find("; last read: ");
  if (end != std::string::npos) message.erase(end);
  return message;
}

/// Throws InputError if the bracket at `at` was unexpected because of a comma before it.
void refuse_trailing_comma(std::string_view text, std::size_t at) {
  if (at == 0 || at >= text.size() || (text[at] != ']' && text[at] != '}')) return;
  const std::size_t comma = text.find_last_not_of(" \t\r\n", at - 1);
  if (comma == std::string_view::npos || text[comma] != ',') return;
  throw InputError("", position_of(text, comma), "a comma before " + quote(text.substr(at, 1)),
                   "remove it: no comma follows the last element");
}

/// Throws the InputError of a syntax error. `read` is the number of bytes that the parser had
/// read, the offending one included.
[[noreturn]] void fail_syntax(std::string_view text, std::size_t read, bool out_of_range,
                              const std::string& parser_message) {
  const std::size_t at = std::min(read == 0 ? 0 : read - 1, text.size());
  refuse_trailing_comma(text, at);
  std::size_t begin = at;
  // A number is found wanting only at the character behind it.
  if ((begin == text.size() || !in_word(text[begin])) && begin > 0 &&
      in_word(text[begin - 1])) {
    --begin;
  }
  std::size_t end = begin;
  while (end < text.size() && in_word(text[end])) ++end;
  while (end > begin && begin > 0 && in_word(text[begin - 1])) --begin;
  const std::string word(text.substr(begin, end - begin));

  std::string problem = out_of_range ? "the number is out of range" : essence(parser_message);
  std::string remedy =
      "JSON strings take double quotes, numbers look like 2, -0.25 or 1e-3, and no comma "
      "follows the last element";
  if (out_of_range) {
    remedy = "exponents reach " + std::to_string(kMaxExponent) +
             "; write a number with more digits than that as a string";
  } else if (is_not_finite(word)) {
    problem = "a number must be finite";
    remedy = "write a decimal such as 0.25 or a string such as \"3/5\"";
  } else if (end < text.size() && text[end] == '/' && !word.empty()) {
    remedy = "a fraction is a string: write it in double quotes, as \"3/5\"";
  } else if (at == text.size()) {
    remedy = "the text ends too early; is the file complete?";
  } else if (contains(problem, "UTF-8") || (at == 0 && !is_ascii(text[0]))) {
    remedy = "save the file as UTF-8";
  } else if (contains(problem, "expected end of input")) {
    remedy = text[at] == ',' ? "remove the comma: nothing follows the object"
                             : "one JSON object is expected, and nothing behind it";
  }
  // A token that the parser names as unexpected need not be repeated.
  const bool bare =
      word.empty() && problem == "invalid literal" && at < text.size() && is_ascii(text[at]);
  const std::string_view shown = bare ? text.substr(at, 1) : std::string_view(word);
  if (!shown.empty()) problem += ", at " + quote(shown);
  throw InputError("", position_of(text, word.empty() ? at : begin), problem, remedy);
}

/// Builds the tree. Every container that is still open is an entry of `open_`; the parser
/// itself is iterative, so nesting costs no stack.
class Builder : public nlohmann::json_sax<ParsedJson> {
 public:
  Builder(std::string_view text, const std::vector<JsonStream>& streams)
      : text_(text), streams_(streams) {}

  JsonNode take_root() { return std::move(root_); }

  bool null() override { return leaf(JsonNode::Kind::kNull, "null"); }
  bool boolean(bool value) override {
    return leaf(JsonNode::Kind::kBoolean, value ? "true" : "false");
  }
  bool number_integer(number_integer_t value) override {
    return leaf(JsonNode::Kind::kNumber, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return leaf(JsonNode::Kind::kNumber, std::to_string(value));
  }
  bool number_float(number_float_t /*rounded*/, const std::string& characters) override {
    std::string exact = characters;
    // The parser replaces the decimal point by that of the C locale in force.
    for (char& c : exact) {
      if ((c < '0' || c > '9') && c != '-' && c != '+' && c != 'e' && c != 'E') c = '.';
    }
    return leaf(JsonNode::Kind::kNumber, std::move(exact));
  }
  bool string(std::string& value) override {
    return leaf(JsonNode::Kind::kString, std::move(value));
  }
  bool binary(binary_t& /*value*/) override { return false; }  // never in JSON text

  bool start_object(std::size_t /*unknown*/) override { return open(JsonNode::Kind::kObject); }
  bool start_array(std::size_t /*unknown*/) override { return open(JsonNode::Kind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    std::vector<std::string>& keys = open_.back().node.keys;
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
      throw InputError("", place_name(path(open_.size() - 1)),
                       "the key " + quote(name) + " appears twice", "keep one of them");
    }
    if (keys.size() == kMaxJsonKeys) {
      throw InputError("", place_name(path(open_.size() - 1)),
                       "more than " + std::to_string(kMaxJsonKeys) + " members in one object",
                       "no object here has so many");
    }
    keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;
    fail_syntax(text_, position, error.id == kNumberOverflow, error.what());
  }

 private:
  struct Open {
    JsonNode node;
    std::size_t count;  ///< children so far, streamed ones included
    std::size_t nodes_before;
    const JsonStream* elements;  ///< the stream that takes the elements; null if they are kept
  };

  /// Returns the path of the value at hand when the first `depth` open containers are around
  /// it.
  std::string path(std::size_t depth) const {
    std::string result;
    for (std::size_t i = 0; i < depth; ++i) {
      const Open& o = open_[i];
      result = o.node.kind == JsonNode::Kind::kObject ? member_path(result, o.node.keys.back())
                                                      : element_path(result, o.count);
    }
    return result;
  }

  /// Returns the stream of the array that begins here, or nullptr.
  const JsonStream* stream() const {
    const auto leads_here = [&](const JsonStream& stream) {
      return std::equal(stream.keys.begin(), stream.keys.end(), open_.begin(), open_.end(),
                        [](const std::string& key, const Open& o) {
                          return o.node.kind == JsonNode::Kind::kObject &&
                                 o.node.keys.back() == key;
                        });
    };
    const auto found = std::find_if(streams_.begin(), streams_.end(), leads_here);
    return found == streams_.end() ? nullptr : &*found;
  }

  /// Returns whether the value at hand has the limit for itself: a member of the text's object,
  /// or a streamed element.
  bool begins_place() const {
    return !open_.empty() &&
           (open_.back().elements != nullptr ||
            (open_.size() == 1 && open_.back().node.kind == JsonNode::Kind::kObject));
  }

  void count_node() {
    if (begins_place()) nodes_ = 0;
    if (++nodes_ > kMaxJsonNodes) {
      throw InputError("", place_name(path(open_.size())),
                       "more than " + std::to_string(kMaxJsonNodes) + " values in one place",
                       "only the lists of contacts and forces may be that long");
    }
  }

  bool leaf(JsonNode::Kind kind, std::string text) {
    const std::size_t nodes_before = nodes_;
    count_node();
    return finish({kind, std::move(text), {}, {}}, nodes_before);
  }

  bool open(JsonNode::Kind kind) {
    if (open_.size() == kMaxJsonDepth) {
      throw InputError("", place_name(path(open_.size())),
                       "nested more than " + std::to_string(kMaxJsonDepth) + " levels deep",
                       "grasps and claims need no more than five");
    }
    const std::size_t nodes_before = nodes_;
    count_node();
    const JsonStream* const elements = kind == JsonNode::Kind::kArray ? stream() : nullptr;
    open_.push_back({{kind, {}, {}, {}}, 0, nodes_before, elements});
    // Room for as many as most have is reserved at once: lists that grew one by one took much
    // of the time of reading contacts.
    JsonNode& node = open_.back().node;
    if (kind == JsonNode::Kind::kObject) {
      node.keys.reserve(kUsualMembers);
      node.children.reserve(kUsualMembers);
    } else if (elements == nullptr) {
      node.children.reserve(kUsualElements);
    }
    return true;
  }

  static constexpr std::size_t kUsualMembers = 5;
  static constexpr std::size_t kUsualElements = 3;

  bool close() {
    Open closed = std::move(open_.back());
    open_.pop_back();
    return finish(std::move(closed.node), closed.nodes_before);
  }

  bool finish(JsonNode node, std::size_t nodes_before) {
    if (open_.empty()) {
      root_ = std::move(node);
      return true;
    }
    Open& parent = open_.back();
    if (parent.elements != nullptr) {
      parent.elements->sink(parent.count, node);
    } else {
      parent.node.children.push_back(std::move(node));
    }
    if (begins_place()) nodes_ = nodes_before;
    ++parent.count;
    return true;
  }

  std::string_view text_;
  const std::vector<JsonStream>& streams_;
  std::vector<Open> open_;
  std::size_t nodes_ = 0;  ///< the values so far of the place at hand
  JsonNode root_;
};

/// Builds a Json from a text that a program wrote itself.
class ValueBuilder : public nlohmann::json_sax<ParsedJson> {
 public:
  Json take_root() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t /*rounded*/, const std::string& characters) override {
    double value = 0;
    std::from_chars(characters.data(), characters.data() + characters.size(), value);
    return add(value);
  }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // never in JSON text

  bool start_object(std::size_t /*unknown*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*unknown*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    keys_.back() = std::move(name);
    return true;
  }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

 private:
  bool open(Json container) {
    open_.push_back(std::move(container));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    Json closed = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return add(std::move(closed));
  }

  bool add(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().is_array()) {
      open_.back().push_back(std::move(value));
    } else {
      open_.back()[keys_.back()] = std::move(value);
    }
    return true;
  }

  std::vector<Json> open_;
  std::vector<std::string> keys_;  ///< the last key of each open object
  Json root_;
};

}  // namespace

Json Json::parse(std::string_view text) {
  ValueBuilder builder;
  require(ParsedJson::sax_parse(text.begin(), text.end(), &builder), "a program wrote no JSON");
  return builder.take_root();
}

std::string core_detail::json_double(double value) {
  return nlohmann::json(value).dump();
}

const JsonNode* JsonNode::find(std::string_view key) const {
  const auto it = std::find(keys.begin(), keys.end(), key);
  return it == keys.end() ? nullptr : &children[static_cast<std::size_t>(it - keys.begin())];
}

std::string describe(const JsonNode& node) {
  const auto counted = [](const char* what, std::size_t n) {
    return std::string(what) + " of " + std::to_string(n) + (n == 1 ? " value" : " values");
  };
  switch (node.kind) {
    case JsonNode::Kind::kNull:
    case JsonNode::Kind::kBoolean:
      return node.text;
    case JsonNode::Kind::kNumber: {
      const std::string text = quote(node.text);
      return "the number " + text.substr(1, text.size() - 2);
    }
    case JsonNode::Kind::kString:
      return "the string " + quote(node.text);
    case JsonNode::Kind::kArray:
      return counted("an array", node.children.size());
    case JsonNode::Kind::kObject:
      return counted("an object", node.children.size());
  }
  return "a value";
}

std::string member_path(const std::string& path, const std::string& key) {
  // A key is the user's: it may be long or hold anything.
  const std::string safe = quote(key);
  return (path.empty() ? path : path + ".") + safe.substr(1, safe.size() - 2);
}

std::string element_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

std::string place_name(const std::string& path) {
  return path.empty() ? "top level" : path;
}

JsonNode parse_json(std::string_view text, const std::vector<JsonStream>& streams) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError("", "1:1", "the text is empty", "write a grasp, see docs/grasp_file.md");
  }
  Builder builder(text, streams);
  const bool complete = ParsedJson::sax_parse(text.begin(), text.end(), &builder);
  require(complete, "the JSON parser stopped without a reason");
  // The parser takes a NUL byte for the end of the text and would not see what follows it.
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw InputError("", position_of(text, nul), "a NUL byte",
                     "nothing but blanks may follow the object");
  }
  return builder.take_root();
}

std::string json_string(const std::string& text, const std::string& path) {
  try {
    std::string result;
    core_detail::append_json_string(result, text, false);
    return result;
  } catch (const JsonTextError&) {
    fail_at(path, quote(text) + " is not valid UTF-8", "give the " + path + " in UTF-8");
  }
}

bool TextLines::next(std::string& line) {
  std::streambuf& in = *in_.rdbuf();
  constexpr int kEnd = std::streambuf::traits_type::eof();
  for (int c = in.sbumpc(); c != kEnd;) {
    line.clear();
    ++number_;
    bool blank = true;
    bool too_long = false;
    begin_ = end_;
    for (; c != kEnd && c != '\n'; c = in.sbumpc()) {
      ++end_;
      if (c != ' ' && c != '\t' && c != '\r') blank = false;
      too_long = too_long || line.size() == kMaxJsonBytes;
      if (!too_long) line.push_back(static_cast<char>(c));
    }
    if (c != kEnd) ++end_;
    if (too_long) {
      throw InputError("", "", "more than " + std::to_string(kMaxJsonBytes) + " bytes",
                       "longer lines are not read");
    }
    if (!blank) return true;
    if (c != kEnd) c = in.sbumpc();
  }
  return false;
}

void fail_at(const std::string& path, std::string problem, std::string remedy) {
  throw InputError("", place_name(path), std::move(problem), std::move(remedy));
}

void expect(const JsonNode& node, JsonNode::Kind kind, const std::string& path,
            const char* expected) {
  if (node.kind != kind)
    fail_at(path, "found " + describe(node), std::string("expected ") + expected);
}

void expect_object(const JsonNode& node, const std::string& path,
                   const std::vector<std::string>& allowed) {
  expect(node, JsonNode::Kind::kObject, path, "an object {...}");
  for (const std::string& key : node.keys) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    fail_at(path, "unknown key " + quote(key),
            choice_of(key, allowed, "the keys allowed here are "));
  }
}

void expect_array(const JsonNode& node, const std::string& path, std::size_t length,
                  const char* form) {
  expect(node, JsonNode::Kind::kArray, path, form);
  if (node.children.size() == length) return;
  fail_at(path, "found " + describe(node), std::string("expected ") + form);
}

const JsonNode& member(const JsonNode& object, const std::string& path, const char* key,
                       const char* remedy) {
  const JsonNode* node = object.find(key);
  if (node == nullptr) fail_at(path, std::string("the key \"") + key + "\" is missing", remedy);
  return *node;
}

Rational read_number(const JsonNode& node, const std::string& path) {
  if (node.kind != JsonNode::Kind::kNumber && node.kind != JsonNode::Kind::kString) {
    fail_at(path, "found " + describe(node),
            "expected a number such as 0.25, or a string as \"3/5\"");
  }
  try {
    return parse_rational(node.text);
  } catch (const NumberError& error) {
    fail_at(path, error.what(), "write a decimal such as 0.25, or a string such as \"3/5\"");
  }
}

std::vector<Rational> read_vector(const JsonNode& node, const std::string& path,
                                  std::size_t length, const char* form) {
  expect_array(node, path, length, form);
  std::vector<Rational> values;
  for (const JsonNode& child : node.children) {
    values.push_back(read_number(child, element_path(path, values.size())));
  }
  return values;
}

}  // namespace stickslip
