// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/json_read.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// "did you mean" for a near miss: at most half of the key is wrong.
std::string suggestion(const std::string& key, const JsonKeys& allowed) {
  constexpr std::size_t kLongest = 40;
  if (key.size() > kLongest) return {};
  const auto distance = [&](const std::string& other) { return edit_distance(key, other); };
  const std::string nearest = *std::min_element(
      allowed.begin(), allowed.end(),
      [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (2 * distance(nearest) > nearest.size()) return {};
  return "did you mean \"" + nearest + "\"? ";
}

}  // namespace

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
    std::string remedy = suggestion(key, allowed) + "the keys allowed here are";
    for (const std::string& name : allowed) {
      remedy += (name == allowed.front() ? " " : ", ") + name;
    }
    fail_at(path, "unknown key " + quote(key), remedy);
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
