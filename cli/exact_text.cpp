// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_text.hpp"

#include <cstdio>

namespace stickslip {

std::string tuple(const Vector2& v) {
  return "(" + to_readable_string(v.x) + ", " + to_readable_string(v.y) + ")";
}

std::string tuple(const Vector3& v) {
  return "(" + to_readable_string(v[0]) + ", " + to_readable_string(v[1]) + ", " +
         to_readable_string(v[2]) + ")";
}

std::string tuple(const Twist& d) {
  return tuple(coordinates(d));
}

std::string brief(const Rational& value) {
  constexpr std::size_t kLongest = 12;
  std::string exact = to_string(value);
  if (exact.size() <= kLongest) return exact;
  char rounded[32];
  std::snprintf(rounded, sizeof rounded, "~%.6g", to_double(value));
  return rounded;
}

std::string brief(const Vector2& v) {
  return "(" + brief(v.x) + ", " + brief(v.y) + ")";
}

std::string brief(const Twist& d) {
  return "(" + brief(d.x) + ", " + brief(d.y) + ", " + brief(d.r) + ")";
}

Json strings_json(const Vector2& v) {
  return Json::array({to_string(v.x), to_string(v.y)});
}

Json strings_json(const Vector3& v) {
  return Json::array({to_string(v[0]), to_string(v[1]), to_string(v[2])});
}

Json snapped_json(const Question& question) {
  Json json = Json::array();
  for (const SnappedNormal& normal : question.snapped) {
    json.push_back({{"contact", normal.contact.index()},
                    {"normal", strings_json(normal.after)},
                    {"moved_at_most", normal.moved}});
  }
  return json;
}

std::string snapped_text(const Question& question) {
  std::string text;
  for (const SnappedNormal& normal : question.snapped) {
    text += "  contact " + std::to_string(normal.contact.index()) + ": normal snapped to " +
            tuple(normal.after) + ", moved by at most " + normal.moved + '\n';
  }
  return text;
}

}  // namespace stickslip
