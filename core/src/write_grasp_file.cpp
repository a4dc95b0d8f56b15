// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "grasp_format.hpp"
#include "loads.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/spatial_grasp.hpp"

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

template <std::size_t N>
std::string write_intervals(const std::array<Interval, N>& intervals) {
  std::string text;
  for (const Interval& interval : intervals) {
    text += (text.empty() ? "[" : ", ") + write_interval(interval);
  }
  return text + "]";
}

/// Of a case, what its load adds to the common one.
template <std::size_t N>
std::array<Interval, N> own_load(std::array<Interval, N> load,
                                 const std::array<Interval, N>& common) {
  for (std::size_t j = 0; j < N; ++j) {
    load[j].low -= common[j].low;
    load[j].high -= common[j].high;
  }
  return load;
}

std::string write_normal(const UncertainContact& c) {
  const std::string direction = write_numbers({&c.normal.x, &c.normal.y});
  if (c.slope.is_zero()) return direction;
  return "{\"direction\": " + direction + ", \"slope\": " + write_number(c.slope) + "}";
}

/// `place` is its position and its normal. Without a stiffness if that is assumed.
template <class AnyContact>
std::string write_contact(const std::pair<std::string, std::string>& place, const AnyContact& c,
                          std::size_t i, const std::vector<ContactId>& assumed_stiffness) {
  const bool assumed =
      std::binary_search(assumed_stiffness.begin(), assumed_stiffness.end(), ContactId(i));
  return std::string(i == 0 ? "\n" : ",\n") + "  {\"position\": " + place.first +
         ", \"normal\": " + place.second + ", \"friction\": " + write_interval(c.friction) +
         (assumed ? "" : ", \"stiffness\": " + write_interval(c.stiffness)) +
         ", \"preload\": " + write_interval(c.preload) + "}";
}

/// What stands before the contacts.
std::string write_head(const char* format, const std::string& name,
                       const std::optional<Units>& units) {
  std::string text = std::string("{\"format\": \"") + format + "\",\n";
  if (!name.empty()) text += " \"name\": " + json_string(name, "name") + ",\n";
  if (units) {
    text += " \"units\": {\"length\": " + json_string(units->length, "units") +
            ", \"force\": " + json_string(units->force, "units") + "},\n";
  }
  return text;
}

/// What stands behind the contacts; the cases have a name and a load, which load_of() gives.
template <std::size_t N, class Case, class Load>
std::string write_loads(const std::array<Interval, N>& common, const std::vector<Case>& cases,
                        Load load_of) {
  std::string text = "],\n \"wrench\": " + write_intervals(common);
  const char* separator = ",\n \"cases\": [\n";
  for (const Case& one : cases) {
    text += separator;
    text += "  {\"name\": " + json_string(one.name, "name") +
            ", \"wrench\": " + write_intervals(own_load(load_of(one), common)) + "}";
    separator = ",\n";
  }
  return text + (cases.empty() ? "}\n" : "]}\n");
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
  std::string text = write_head(format, grasp.name(), units);
  if (!outline.empty()) {
    text += " \"outline\": " + write_list(outline, ",\n  ", write_polygon) + ",\n";
  }
  text += " \"contacts\": [";
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const UncertainContact c = file.box ? file.box->contacts[i] : box_of(grasp.contacts()[i]);
    text += write_contact({write_intervals(std::array{c.x, c.y}), write_normal(c)}, c, i,
                          file.assumed_stiffness);
  }
  return text + write_loads(file.box ? file.box->wrench : box_of(file.content.wrench),
                            file.cases, [](const NamedLoad& load) {
                              return load.box.value_or(box_of(load.wrench));
                            });
}

std::string write_grasp_file(const SpatialGrasp& grasp) {
  std::string text = write_head(kVersion2, grasp.name, grasp.units) + " \"contacts\": [";
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const SpatialContact& c = grasp.contacts[i];
    text += write_contact({write_intervals(c.position),
                           write_numbers({&c.normal[0], &c.normal[1], &c.normal[2]})},
                          c, i, grasp.assumed_stiffness);
  }
  return text + write_loads(grasp.wrench, grasp.cases,
                            [](const SpatialCase& one) { return one.wrench; });
}

}  // namespace stickslip
