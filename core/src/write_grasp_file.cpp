// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "grasp_format.hpp"
#include "loads.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

/// Exact: an integer that every JSON reader keeps, else a string. Throws InputError for a
/// number that parse_rational would not read back.
std::string write_number(const Rational& value) {
  constexpr std::int64_t kExactInDouble = std::int64_t{1} << 53;
  std::string text = to_string(value);
  if (text.size() > kMaxNumberLength) {
    throw InputError("", "", "a number of " + std::to_string(text.size()) + " characters",
                     "grasp files hold numbers of at most " + std::to_string(kMaxNumberLength));
  }
  const bool plain =
      boost::multiprecision::denominator(value) == 1 && abs(value) < kExactInDouble;
  return plain ? text : "\"" + text + "\"";
}

std::string write_numbers(std::initializer_list<const Rational*> values) {
  std::string text;
  for (const Rational* value : values)
    text += (text.empty() ? "[" : ", ") + write_number(*value);
  return text + "]";
}

template <class Entry, class Write>
std::string write_list(const std::vector<Entry>& entries, const char* separator, Write write) {
  std::string text;
  for (const Entry& entry : entries) text += (text.empty() ? "[" : separator) + write(entry);
  return text + "]";
}

std::string write_polygon(const Polygon& polygon) {
  const auto write_vertex = [](const Vector2& v) { return write_numbers({&v.x, &v.y}); };
  return write_list(polygon, ", ",
                    [&](const Ring& ring) { return write_list(ring, ", ", write_vertex); });
}

std::string write_interval(const Interval& interval) {
  if (interval.is_point()) return write_number(interval.low);
  return "{\"min\": " + write_number(interval.low) +
         ", \"max\": " + write_number(interval.high) + "}";
}

std::string write_wrench(const WrenchBox& w) {
  return "[" + write_interval(w[0]) + ", " + write_interval(w[1]) + ", " +
         write_interval(w[2]) + "]";
}

/// Of a case, what its load adds to the common one.
WrenchBox own_load(const NamedLoad& load, const WrenchBox& common) {
  WrenchBox own = load.box.value_or(box_of(load.wrench));
  for (std::size_t j = 0; j < own.size(); ++j) {
    own[j].low -= common[j].low;
    own[j].high -= common[j].high;
  }
  return own;
}

std::string write_normal(const UncertainContact& c) {
  const std::string direction = write_numbers({&c.normal.x, &c.normal.y});
  if (c.slope.is_zero()) return direction;
  return "{\"direction\": " + direction + ", \"slope\": " + write_number(c.slope) + "}";
}

std::string write_contact(const UncertainContact& c, bool has_stiffness) {
  return "{\"position\": [" + write_interval(c.x) + ", " + write_interval(c.y) +
         "], \"normal\": " + write_normal(c) + ", \"friction\": " + write_interval(c.friction) +
         (has_stiffness ? ", \"stiffness\": " + write_interval(c.stiffness) : "") +
         ", \"preload\": " + write_interval(c.preload) + "}";
}

bool has_intervals(const GraspFile& file) {
  return file.box || std::any_of(file.cases.begin(), file.cases.end(),
                                 [](const NamedLoad& load) { return load.box.has_value(); });
}

}  // namespace

std::string write_grasp(const LoadedGrasp& content) {
  return write_grasp_file({content});
}

std::string write_grasp_file(const GraspFile& file) {
  const Grasp& grasp = file.content.grasp;
  const std::vector<Polygon>& outline = grasp.description().outline;
  const std::optional<Units>& units = grasp.description().units;
  const bool version1 = file.cases.empty() && outline.empty() && !units && !has_intervals(file);
  const char* format = version1 ? kVersion1 : kVersion2;
  std::string text = std::string("{\"format\": \"") + format + "\",\n";
  if (!grasp.name().empty()) text += " \"name\": " + json_string(grasp.name(), "name") + ",\n";
  if (units) {
    text += " \"units\": {\"length\": " + json_string(units->length, "units") +
            ", \"force\": " + json_string(units->force, "units") + "},\n";
  }
  if (!outline.empty()) {
    text += " \"outline\": " + write_list(outline, ",\n  ", write_polygon) + ",\n";
  }
  text += " \"contacts\": [";
  const char* separator = "\n";
  const std::vector<ContactId>& assumed = file.assumed_stiffness;
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const bool given = !std::binary_search(assumed.begin(), assumed.end(), ContactId(i));
    text += separator;
    text += "  " + write_contact(file.box ? file.box->contacts[i] : box_of(grasp.contacts()[i]),
                                 given);
    separator = ",\n";
  }
  const WrenchBox common = file.box ? file.box->wrench : box_of(file.content.wrench);
  text += "],\n \"wrench\": " + write_wrench(common);
  separator = ",\n \"cases\": [\n";
  for (const NamedLoad& load : file.cases) {
    text += separator;
    text += "  {\"name\": " + json_string(load.name, "name") +
            ", \"wrench\": " + write_wrench(own_load(load, common)) + "}";
    separator = ",\n";
  }
  return text + (file.cases.empty() ? "}\n" : "]}\n");
}

}  // namespace stickslip
