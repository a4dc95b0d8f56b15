// SPDX-License-Identifier: GPL-3.0-or-later
#include "intervals.hpp"

#include "uncertain_contact.hpp"

namespace stickslip::core_detail {

void IntervalReader::note(const std::string& path) {
  if (first_.empty()) first_ = path;
}

Interval IntervalReader::number(const JsonNode& node, const std::string& path) {
  if (node.kind != JsonNode::Kind::kObject) return point_interval(read_number(node, path));
  note(path);
  expect_object(node, path, {"min", "max"});
  const auto end = [&](const char* key) {
    return read_number(member(node, path, key, R"(an interval is {"min": A, "max": B})"),
                       member_path(path, key));
  };
  Interval interval{end("min"), end("max")};
  check_ends(interval, path);
  return interval;
}

std::vector<Interval> IntervalReader::numbers(const JsonNode& node, const std::string& path,
                                              std::size_t length, const char* form) {
  expect_array(node, path, length, form);
  std::vector<Interval> values;
  for (const JsonNode& child : node.children) {
    values.push_back(number(child, element_path(path, values.size())));
  }
  return values;
}

}  // namespace stickslip::core_detail
