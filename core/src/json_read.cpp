// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/json_read.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/spelling.hpp"

namespace stickslip {

void fail_at(const std::string& path, std::string problem, std::string remedy) {
  throw InputError("", place_name(path), std::move(problem), std::move(remedy));
}

void expect(const JsonNode& node, JsonNode::Kind kind, const std::string& path,
            const char* expected) {
  if (node.kind != kind)
    fail_at(path, "found " + describe(node), std::string("expected ") + expected);
}

void expect_object(const JsonNode& node, const std::string& path, const JsonKeys& allowed) {
  expect(node, JsonNode::Kind::kObject, path, "an object {...}");
  for (const std::string& key : node.keys) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    fail_at(path, "unknown key " + quote(key),
            choice_of(key, allowed, "the keys allowed here are "));
  }
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
  expect(node, JsonNode::Kind::kArray, path, form);
  if (node.children.size() != length) {
    fail_at(path, "found " + describe(node), std::string("expected ") + form);
  }
  std::vector<Rational> values;
  for (const JsonNode& child : node.children) {
    values.push_back(read_number(child, element_path(path, values.size())));
  }
  return values;
}

}  // namespace stickslip
