// SPDX-License-Identifier: MIT
#include "certificate.hpp"

#include <algorithm>

namespace stickslip_check {
namespace {

constexpr JsonLimits kLimits{std::uint64_t{1} << 30U, 8, 65536, std::uint64_t{1} << 22U, false};
constexpr std::size_t kMaxJsonInteger = 4000;
constexpr const char* kFormat = "stickslip-certificate/2";

}  // namespace

CertificateReader::CertificateReader(std::istream& in, const std::string& file)
    : json_(in, file, kLimits) {}

Claim CertificateReader::claim() {
  const Value format = take("format");
  json_.expect(format.is_text(kFormat), format, "format",
               std::string("\"") + kFormat + "\", the only one that this program knows");
  std::optional<std::string> name = json_.next_member();
  if (name == "producer") {
    const Value producer = json_.value();
    json_.expect(producer.kind == Value::Kind::kString, producer, *name, "a string");
    name = json_.next_member();
  }
  if (name != "question") {
    json_.fail(json_.line(), "top level", "expected the member \"question\"");
  }
  const Value question = json_.value();
  json_.expect(question.kind == Value::Kind::kObject, question, *name, "an object {...}");
  const Options stated = asked(question);
  margin_ = stated.margin();
  return {index(*question.find("contacts"), "question.contacts"), stated};
}

std::string CertificateReader::verdict() {
  const Value verdict = take("verdict");
  if (margin_) {
    json_.expect(verdict.is_text("margin"), verdict, "verdict",
                 "\"margin\", as the question has a direction");
  } else {
    json_.expect(verdict.is_text("stable") || verdict.is_text("unstable"), verdict, "verdict",
                 "\"stable\" or \"unstable\", as the question has no direction");
  }
  return verdict.text;
}

Witness CertificateReader::witness() {
  Witness witness;
  witness.x = numbers(take("twist"), "twist", 0, kDimension);
  witness.x.insert(witness.x.end(), {1, 0});
  witness.shares = shares(take("shares"), "shares");
  return witness;
}

std::vector<Interval> CertificateReader::resisted() {
  std::vector<Interval> result;
  const Value value = take("resisted");
  for (const Value& entry : list(value, "resisted", "an array of intervals")) {
    const std::string place = "resisted[" + std::to_string(result.size()) + "]";
    json_.expect(entry.is_array(2), entry, place, "[low, high] or [low, null]");
    result.push_back({number(entry.items[0], place), number_or_null(entry.items[1], place)});
  }
  return result;
}

std::optional<std::pair<Witness, Witness>> CertificateReader::next_segment() {
  if (!next_element("segments")) return std::nullopt;
  const std::string place = "segments[" + std::to_string(elements_ - 1) + "]";
  const Value value = json_.value();
  const bool goes_on = value.is_array(1) && end_ && end_->x[kDimension] != 0;
  json_.expect(goes_on || value.is_array(2), value, place,
               "two points, or one where the segment before ended with a number");
  Witness begin = goes_on ? std::move(*end_) : point(value.items[0], false, place);
  end_ = point(value.items.back(), true, place);
  return std::pair(std::move(begin), *end_);
}

std::optional<Node> CertificateReader::next_node() {
  if (!next_element("tree")) return std::nullopt;
  return node(json_.value(), "tree[" + std::to_string(elements_ - 1) + "]");
}

void CertificateReader::finish() {
  if (json_.next_member()) json_.fail(json_.line(), "top level", "a member too many");
}

void CertificateReader::expect_member(const std::string& name) {
  const std::optional<std::string> found = json_.next_member();
  if (found != name) {
    json_.fail(json_.line(), "top level",
               (found ? "found the member " + quote(*found) : std::string("the object ends")) +
                   ", expected \"" + name + "\"");
  }
}

bool CertificateReader::next_element(const char* list) {
  if (open_list_ != list) {
    expect_member(list);
    open_list_ = list;
    elements_ = 0;
  }
  ++elements_;
  return json_.next_element();
}

Value CertificateReader::take(const std::string& name) {
  expect_member(name);
  return json_.value();
}

/// NUMBER.
Rational CertificateReader::number(const Value& value, const std::string& place) const {
  std::optional<Rational> read;
  const bool json_integer =
      value.kind == Value::Kind::kNumber && value.text.size() <= kMaxJsonInteger;
  if (json_integer || value.kind == Value::Kind::kString) read = parse_fraction(value.text);
  json_.expect(read.has_value(), value, place, "an integer, or a string such as \"-3/5\"");
  return *read;
}

std::optional<Rational> CertificateReader::number_or_null(const Value& value,
                                                          const std::string& place) const {
  if (value.kind == Value::Kind::kNull) return std::nullopt;
  return number(value, place);
}

/// CONTACT, and m.
Integer CertificateReader::index(const Value& value, const std::string& place) const {
  json_.expect(value.kind == Value::Kind::kNumber, value, place, "a contact, counted from 0");
  const Rational read = number(value, place);
  json_.expect(read >= 0, value, place, "a contact, counted from 0");
  return read.get_num();
}

/// The `size` numbers of an array behind the first `skipped` values.
Vector CertificateReader::numbers(const Value& value, const std::string& place,
                                  std::size_t skipped, std::size_t size) const {
  json_.expect(value.is_array(skipped + size), value, place,
               "an array of " + std::to_string(skipped + size));
  Vector result;
  for (std::size_t j = skipped; j < skipped + size; ++j) {
    result.push_back(number(value.items[j], place));
  }
  return result;
}

const std::vector<Value>& CertificateReader::list(const Value& value, const std::string& place,
                                                  const std::string& what) const {
  json_.expect(value.kind == Value::Kind::kArray, value, place, what);
  return value.items;
}

Options CertificateReader::asked(const Value& value) const {
  const std::vector<std::string> order{"contacts",   "wrench",    "preload",
                                       "normal_law", "direction", "preload_direction"};
  auto next = order.begin();
  for (const std::string& key : value.keys) {
    next = std::find(next, order.end(), key);
    if (next == order.end()) {
      json_.fail(value.line, "question",
                 "the member " + quote(key) + " is unknown or out of order");
    }
    ++next;
  }
  for (const char* key : {"contacts", "wrench", "normal_law"}) {
    if (value.find(key) == nullptr) {
      json_.fail(value.line, "question", std::string("the member \"") + key + "\" is missing");
    }
  }
  Options asked;
  asked.wrench = numbers(*value.find("wrench"), "question.wrench", 0, kDimension);
  if (const Value* preload = value.find("preload")) {
    asked.preload = number(*preload, "question.preload");
  }
  const Value& law = *value.find("normal_law");
  asked.bilateral = law.is_text("bilateral");
  json_.expect(asked.bilateral || law.is_text("unilateral"), law, "question.normal_law",
               R"("unilateral" or "bilateral")");
  if (const Value* direction = value.find("direction")) {
    asked.direction = numbers(*direction, "question.direction", 0, kDimension);
  }
  if (const Value* growth = value.find("preload_direction")) {
    asked.preload_direction.emplace();
    asked.preload_direction->scale = growth->is_text("scale");
    if (!growth->is_text("scale")) {
      const std::string place = "question.preload_direction";
      for (const Value& entry : list(*growth, place, "\"scale\" or an array of numbers")) {
        asked.preload_direction->values.push_back(number(entry, place));
      }
    }
  }
  return asked;
}

std::vector<std::pair<Integer, Rational>> CertificateReader::shares(
    const Value& value, const std::string& place) const {
  std::vector<std::pair<Integer, Rational>> result;
  for (const Value& entry : list(value, place, "an array [[contact, share], ...]")) {
    json_.expect(entry.is_array(2), entry, place, "[contact, share]");
    result.emplace_back(index(entry.items[0], place), number(entry.items[1], place));
  }
  return result;
}

/// POINT.
Witness CertificateReader::point(const Value& value, bool may_be_ray,
                                 const std::string& place) const {
  json_.expect(value.is_array(3), value, place, "a point [lambda, twist, shares]");
  const std::optional<Rational> lambda =
      may_be_ray ? number_or_null(value.items[0], place) : number(value.items[0], place);
  Witness witness;
  witness.x = numbers(value.items[1], place, 0, kDimension);
  witness.x.push_back(lambda ? 1 : 0);
  witness.x.push_back(lambda.value_or(1));
  witness.shares = shares(value.items[2], place);
  return witness;
}

/// NODE.
Node CertificateReader::node(const Value& value, const std::string& place) const {
  json_.expect(value.kind == Value::Kind::kArray && !value.items.empty() &&
                   value.items[0].kind == Value::Kind::kString,
               value, place, "an array that begins with the kind of the node");
  const std::string& kind = value.items[0].text;
  Node node;
  if (kind == "leaf") {
    node.numbers = numbers(value, place, 1, kDimension);
  } else if (kind == "plane") {
    node.kind = NodeKind::kPlane;
    node.numbers = numbers(value, place, 1, kDimension + (margin_ ? 2 : 1));
    node.numbers.resize(kDimension + 2);
  } else {
    json_.expect(kind == "slip" || kind == "separation", value.items[0], place,
                 "slip, separation, plane or leaf");
    node.kind = kind == "slip" ? NodeKind::kSlip : NodeKind::kSeparation;
    json_.expect(value.is_array(2), value, place, "a kind and a contact");
    node.contact = index(value.items[1], place);
  }
  return node;
}

}  // namespace stickslip_check
