// SPDX-License-Identifier: MIT
#include "syntax.hpp"

#include "answer.hpp"

namespace stickslip_check {
namespace {

constexpr std::size_t kMaxJsonInteger = 4000;

}  // namespace

bool is_text(const Value& value, const char* text) {
  return value.kind == Value::Kind::kString && value.text == text;
}

void Syntax::fail(std::size_t line, const std::string& place,
                  const std::string& problem) const {
  throw Malformed{file_, "line " + std::to_string(line) + ", " + place, problem};
}

void Syntax::expect(bool good, const Value& value, const std::string& place,
                    const std::string& what) const {
  if (!good) fail(value.line, place, "found " + describe(value) + ", expected " + what);
}

Rational Syntax::number(const Value& value, const std::string& place) const {
  std::optional<Rational> read;
  const bool json_integer =
      value.kind == Value::Kind::kNumber && value.text.size() <= kMaxJsonInteger;
  if (json_integer || value.kind == Value::Kind::kString) read = parse_fraction(value.text);
  expect(read.has_value(), value, place, "an integer, or a string such as \"-3/5\"");
  return *read;
}

Integer Syntax::index(const Value& value, const std::string& place) const {
  expect(value.kind == Value::Kind::kNumber, value, place, "a contact, counted from 0");
  const Rational read = number(value, place);
  expect(read >= 0, value, place, "a contact, counted from 0");
  return read.get_num();
}

Node Syntax::node(const Value& value, const std::string& place) const {
  expect(value.kind == Value::Kind::kArray && !value.items.empty() &&
             value.items[0].kind == Value::Kind::kString,
         value, place, "an array that begins with the kind of the node");
  const std::string& kind = value.items[0].text;
  Node node;
  if (kind == "slip" || kind == "separation") {
    node.kind = kind == "slip" ? NodeKind::kSlip : NodeKind::kSeparation;
    expect(value.is_array(2), value, place, "a kind and a contact");
    node.contact = index(value.items[1], place);
  } else if (kind == "plane") {
    node.kind = NodeKind::kPlane;
    const auto a = numbers<4>(value, 1, place);
    node.numbers.assign(a.begin(), a.end());
  } else if (kind == "leaf") {
    node.kind = NodeKind::kLeaf;
    expect(value.is_array(4) || value.is_array(5), value, place, "y1, y2, y3 and maybe thetas");
    for (std::size_t j = 1; j < 4; ++j) node.numbers.push_back(number(value.items[j], place));
    if (value.is_array(5)) {
      const Value& list = value.items[4];
      expect(list.kind == Value::Kind::kArray, list, place, "an array [[i, theta], ...]");
      for (const Value& entry : list.items) {
        const Rational theta = numbers<1>(entry, 1, place)[0];
        node.thetas.emplace_back(index(entry.items[0], place), theta);
      }
    }
  } else {
    expect(kind == "void", value.items[0], place, "slip, separation, plane, leaf or void");
    expect(value.is_array(1), value, place, "[\"void\"]");
  }
  return node;
}

}  // namespace stickslip_check
