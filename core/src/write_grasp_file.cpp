// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "grasp_format.hpp"
#include "loads.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

/// Returns the exact number: an integer that every JSON reader keeps, else a string. Throws
/// InputError for a number that parse_rational would not read back.
std::string write_number(const Rational& value) {
  constexpr std::int64_t kExactInDouble = std::int64_t{1} << 53;
  std::string text = to_string(value);
  if (text.size() > kMaxNumberLength) {
    throw InputError("", "", "a number of " + std::to_string(text.size()) + " characters",
                     "grasp files hold numbers of at most " + std::to_string(kMaxNumberLength));
  }
  const bool plain = stickslip::denominator(value) == 1 && abs(value) < kExactInDouble;
  return plain ? text : "\"" + text + "\"";
}

template <class Entry, class Write>
std::string write_list(const std::vector<Entry>& entries, const char* separator, Write write) {
  std::string text;
  for (const Entry& entry : entries) text += (text.empty() ? "[" : separator) + write(entry);
  return text + "]";
}

std::string write_polygon(const Polygon& polygon) {
  const auto write_vertex = [](const Vector2& v) {
    return write_list(std::vector{v.x, v.y}, ", ", write_number);
  };
  return write_list(polygon, ", ",
                    [&](const Ring& ring) { return write_list(ring, ", ", write_vertex); });
}

std::string write_body(const Mesh& body) {
  const auto write_vertex = [](const Vector3& v) {
    return write_list(std::vector<Rational>(v.begin(), v.end()), ", ", write_number);
  };
  const auto write_face = [](const std::vector<std::size_t>& face) {
    return write_list(face, ", ", [](std::size_t v) { return std::to_string(v); });
  };
  return "{\"vertices\": " + write_list(body.vertices, ", ", write_vertex) +
         ",\n  \"faces\": " + write_list(body.faces, ", ", write_face) + "}";
}

std::string write_interval(const Interval& interval) {
  if (interval.is_point()) return write_number(interval.low);
  return "{\"min\": " + write_number(interval.low) +
         ", \"max\": " + write_number(interval.high) + "}";
}

std::string write_intervals(const std::vector<Interval>& intervals) {
  return write_list(intervals, ", ", write_interval);
}

/// Returns the load that a case adds to the common one.
WrenchBox own_load(WrenchBox load, const WrenchBox& common) {
  for (std::size_t j = 0; j < load.size(); ++j) {
    load[j].low -= common[j].low;
    load[j].high -= common[j].high;
  }
  return load;
}

std::string write_normal(const UncertainContact& c) {
  const std::string direction = write_list(c.normal, ", ", write_number);
  if (c.slope.is_zero()) return direction;
  return "{\"direction\": " + direction + ", \"slope\": " + write_number(c.slope) + "}";
}

std::string member(const char* key, const std::string& value) {
  return std::string(", \"") + key + "\": " + value;
}

/// \{ Writes the members of several bodies.
std::string write_name(const std::string& name) {
  return json_string(name, "name");
}

std::string write_vector(const RationalRow& row) {
  return write_list(row, ", ", write_number);
}

std::string write_rates(const Mechanism& mechanism, const LinkRates& rates) {
  std::string text;
  for (const auto& [body, rate] : rates) {
    text += (text.empty() ? "{" : ", ") + write_name(mechanism.bodies[body].name) + ": " +
            write_number(rate);
  }
  return text + "}";
}

std::string write_one_body(const Mechanism& mechanism, const Body& body) {
  std::string text = "{\"name\": " + write_name(body.name);
  if (body.link) {
    const Link& link = *body.link;
    if (link.slides) {
      text += member("slide", write_vector(link.axis));
    } else if (mechanism.in_space) {
      text += member("hinge", "{\"at\": " + write_vector(link.at) +
                                  ", \"axis\": " + write_vector(link.axis) + "}");
    } else {
      text += member("hinge", write_vector(link.at));
    }
    if (link.on) text += member("on", write_name(mechanism.bodies[*link.on].name));
  }
  if (!body.outline.empty()) {
    text += member("outline", write_list(body.outline, ",\n  ", write_polygon));
  }
  if (body.mesh) text += member("mesh", write_body(*body.mesh));
  return text + "}";
}

/// Writes the list of springs of this kind. (The spring of a joint stands beside the joint's
/// `turns`.)
std::string write_springs(const GraspBox& box, Spring::Kind kind, const char* list) {
  std::string text;
  for (const Spring& spring : box.springs) {
    if (spring.kind != kind) continue;
    text += text.empty() ? std::string(" \"") + list + "\": [\n  " : std::string(",\n  ");
    text += "{\"over\": " + write_rates(*box.mechanism, spring.over) +
            (spring.name.empty() ? "" : member("name", write_name(spring.name))) +
            member("stiffness", write_interval(spring.stiffness)) +
            member(force_name(spring), write_interval(spring.force)) + "}";
  }
  return text.empty() ? "" : text + "],\n";
}

std::string write_joints(const GraspBox& box) {
  std::string text;
  for (std::size_t q = 0; q < box.mechanism->joints.size(); ++q) {
    const Joint& joint = box.mechanism->joints[q];
    text += std::string(q == 0 ? " \"joints\": [\n  " : ",\n  ") +
            "{\"turns\": " + write_rates(*box.mechanism, joint.turns) +
            (joint.name.empty() ? "" : member("name", write_name(joint.name)));
    for (const Spring& spring : box.springs) {
      if (spring.kind != Spring::Kind::kJoint || spring.joint != q) continue;
      text += member("stiffness", write_interval(spring.stiffness)) +
              member(force_name(spring), write_interval(spring.force)) +
              (spring.max_torque ? member("max_torque", write_number(*spring.max_torque)) : "");
    }
    text += "}";
  }
  return text.empty() ? "" : text + "],\n";
}

std::string write_mechanism(const GraspBox& box) {
  return " \"bodies\": " +
         write_list(box.mechanism->bodies, ",\n  ",
                    [&](const Body& body) { return write_one_body(*box.mechanism, body); }) +
         ",\n" + write_joints(box) + write_springs(box, Spring::Kind::kTendon, "tendons") +
         write_springs(box, Spring::Kind::kRatchet, "ratchets");
}
/// \}

/// Writes a contact, without its stiffness if that is assumed. `bodies` has the members that
/// say which bodies it is between.
std::string write_contact(const UncertainContact& c, std::size_t i,
                          const std::vector<ContactId>& assumed_stiffness,
                          const std::string& bodies = "") {
  const bool assumed =
      std::binary_search(assumed_stiffness.begin(), assumed_stiffness.end(), ContactId(i));
  return std::string(i == 0 ? "\n" : ",\n") + "  {" + bodies +
         "\"position\": " + write_intervals(c.position) + ", \"normal\": " + write_normal(c) +
         ", \"friction\": " + write_interval(c.friction) +
         (assumed ? "" : ", \"stiffness\": " + write_interval(c.stiffness)) +
         ", \"preload\": " + write_interval(c.preload) +
         (c.torsion.is_zero() ? "" : member("torsion", write_number(c.torsion))) +
         (c.max_force ? member("max_force", write_number(*c.max_force)) : "") + "}";
}

bool has_intervals(const GraspFile& file) {
  const GraspBox* box = file.content.box();
  return (box != nullptr && (!box->is_point() || box->is_bounded())) ||
         std::any_of(file.cases.begin(), file.cases.end(),
                     [](const NamedLoad& load) { return is_uncertain(load.wrench); });
}

std::string write_contacts(const GraspFile& file) {
  std::string text;
  const Mechanism* mechanism = file.content.mechanism();
  for (std::size_t i = 0; i < file.content.contacts(); ++i) {
    const UncertainContact c = file.content.contact(ContactId(i));
    std::string bodies;
    if (mechanism != nullptr) {
      bodies = "\"of\": " + write_name(mechanism->name_of(c.of)) +
               (c.by ? member("by", write_name(mechanism->name_of(c.by))) : "") + ", ";
    }
    text += write_contact(c, i, file.assumed_stiffness, bodies);
  }
  return text;
}

/// Writes the end of the file, after the contacts: the load and the cases.
std::string write_loads(const WrenchBox& common, const std::vector<NamedLoad>& cases) {
  std::string text = "],\n \"wrench\": " + write_intervals(common);
  const char* separator = ",\n \"cases\": [\n";
  for (const NamedLoad& one : cases) {
    text += separator;
    text += "  {\"name\": " + json_string(one.name, "name") +
            ", \"wrench\": " + write_intervals(own_load(one.wrench, common)) + "}";
    separator = ",\n";
  }
  return text + (cases.empty() ? "}\n" : "]}\n");
}

}  // namespace

std::string write_grasp(const LoadedGrasp& content) {
  return write_grasp_file({content});
}

std::string write_grasp(const AnyGrasp& content) {
  return write_grasp_file({content});
}

std::string write_grasp_file(const GraspFile& file) {
  const GraspDescription& about = file.description();
  const auto& [name, outline, units, body] =
      std::tie(about.name, about.outline, about.units, about.body);
  const GraspBox* box = file.content.box();
  const Mechanism* mechanism = file.content.mechanism();
  const bool has_bodies = mechanism != nullptr;
  const bool version1 = !has_bodies && !file.content.in_space() && file.cases.empty() &&
                        outline.empty() && !units && !has_intervals(file);
  std::string text = std::string("{\"format\": \"") +
                     (has_bodies ? kVersion3
                      : version1 ? kVersion1
                                 : kVersion2) +
                     "\",\n";
  if (!name.empty()) text += " \"name\": " + json_string(name, "name") + ",\n";
  if (units) {
    text += " \"units\": {\"length\": " + json_string(units->length, "units") +
            ", \"force\": " + json_string(units->force, "units") + "},\n";
  }
  if (!outline.empty()) {
    text += " \"outline\": " + write_list(outline, ",\n  ", write_polygon) + ",\n";
  }
  if (body) text += " \"body\": " + write_body(*body) + ",\n";
  if (has_bodies) text += write_mechanism(*box);
  if (box != nullptr && box->is_bounded()) {
    text += " \"max_motion\": " + write_list(box->max_motion, ", ", write_number) + ",\n";
  }
  return text + " \"contacts\": [" + write_contacts(file) +
         write_loads(file.content.wrench(), file.cases);
}

}  // namespace stickslip
