// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps in space, and of several bodies: the classes beside GraspData.
#include <pybind11/stl.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

template <std::size_t N>
std::array<Rational, N> exact_array(const py::list& values, const std::string& name) {
  std::array<Rational, N> result;
  const std::vector<Rational> all = numbers(values, N, name);
  std::copy(all.begin(), all.end(), result.begin());
  return result;
}

WrenchBox certain(const Vector6& wrench) {
  WrenchBox result(6);
  for (std::size_t j = 0; j < 6; ++j) result[j] = point_interval(wrench[j]);
  return result;
}

Vector3 row_of(const py::list& rows, std::size_t i, const char* name) {
  const auto row = rows[i].cast<py::list>();
  Vector3 result;
  for (std::size_t j = 0; j < 3; ++j) {
    result[j] =
        exact(row[j], name + ("[" + std::to_string(i) + ", ") + std::to_string(j) + "]");
  }
  return result;
}

/// Reads a pair of lists, vertices and faces, or None.
std::shared_ptr<const Mesh> body_from(const py::object& body) {
  if (body.is_none()) return nullptr;
  const auto parts = body.cast<py::tuple>();
  const auto rows = parts[0].cast<py::list>();
  auto mesh = std::make_shared<Mesh>();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    mesh->vertices.push_back(row_of(rows, i, "body.vertices"));
  }
  mesh->faces = parts[1].cast<std::vector<std::vector<std::size_t>>>();
  return mesh;
}

/// Makes a grasp; the package has checked the lengths, and the body.
SpatialGraspFile make_spatial_grasp(const py::list& positions, const py::list& normals,
                                    const py::object& friction, const py::object& stiffness,
                                    const py::object& preload, const py::list& wrench,
                                    const std::string& name, bool assumed_stiffness,
                                    const py::list& cases, const py::list& units,
                                    const py::object& body) {
  const std::size_t m = positions.size();
  const std::vector<Rational> frictions = numbers(friction, m, "friction");
  const std::vector<Rational> stiffnesses = numbers(stiffness, m, "stiffness");
  const std::vector<Rational> preloads = numbers(preload, m, "preload");
  SpatialGraspFile grasp;
  grasp.content = GraspBox();
  GraspBox& box = *grasp.content.box();
  for (std::size_t i = 0; i < m; ++i) {
    const Vector3 p = row_of(positions, i, "positions");
    const Vector3 n = row_of(normals, i, "normals");
    box.contacts.push_back({{point_interval(p[0]), point_interval(p[1]), point_interval(p[2])},
                            {n.begin(), n.end()},
                            point_interval(frictions[i]),
                            point_interval(stiffnesses[i]),
                            point_interval(preloads[i])});
    if (assumed_stiffness) grasp.assumed_stiffness.emplace_back(i);
  }
  box.wrench = certain(exact_array<6>(wrench, "wrench"));
  for (const py::handle entry : cases) {
    const auto named = entry.cast<py::tuple>();
    const auto case_name = named[0].cast<std::string>();
    grasp.cases.push_back(
        {case_name, certain(exact_array<6>(named[1].cast<py::list>(),
                                           "cases[" + quote(case_name) + "]"))});
  }
  // Grasp itself has the requirements on units.
  box.description =
      Grasp({}, GraspDescription{name, {}, units_from(units), body_from(body)}).description();
  box.check();
  return grasp;
}

/// Returns the text with every stiffness written out, as that of a GraspFile.
std::string spatial_text(SpatialGraspFile grasp) {
  grasp.assumed_stiffness.clear();
  return write_grasp_file(grasp);
}

const GraspBox& box_in(const GraspFile& grasp) {
  require(grasp.content.box() != nullptr, "a grasp in space or of several bodies is a box");
  return *grasp.content.box();
}

/// Returns the numbers of a grasp without intervals.
template <class Intervals>
py::tuple lows(const Intervals& intervals) {
  return tuple_of(intervals, [](const Interval& interval) { return fraction(interval.low); });
}

template <class Values>
py::tuple fractions_of(const Values& values) {
  return tuple_of(values, fraction);
}

/// Returns vertices and faces, or None.
py::object body_of(const SpatialGraspFile& grasp) {
  const std::shared_ptr<const Mesh>& body = grasp.description().body;
  if (!body) return py::none();
  return py::make_tuple(tuple_of(body->vertices, fractions_of<Vector3>),
                        tuple_of(body->faces, [](const std::vector<std::size_t>& face) {
                          return tuple_of(face, [](std::size_t v) { return py::int_(v); });
                        }));
}

/// Returns one value for each contact.
template <class Value>
auto by_contact(Value value) {
  return [value](const SpatialGraspFile& grasp) {
    return tuple_of(box_in(grasp).contacts, value);
  };
}

auto scalars(Interval UncertainContact::*member) {
  return by_contact([member](const UncertainContact& c) { return fraction((c.*member).low); });
}

py::tuple pickled_grasp(const SpatialGraspFile& grasp) {
  return py::make_tuple(py::bytes(write_grasp_file(grasp)));
}

SpatialGraspFile unpickled_grasp(const py::tuple& state) {
  return {parse_any_grasp(state[0].cast<std::string>(), "<pickle>", Intervals::kRefused)};
}

const Mechanism& mechanism_in(const BodiesFile& file) {
  return *box_in(file).mechanism;
}

/// Returns the names of springs; the place of a spring without a name.
py::tuple spring_names(const BodiesFile& file) {
  return tuple_of(box_in(file).springs, [](const Spring& spring) {
    return text(spring.name.empty() ? spring.place : spring.name);
  });
}

/// Returns the grasp of the only body, if it moves freely and nothing else has forces, in its
/// class; else None.
py::object alone(const BodiesFile& file) {
  const Question question = as_one_body(Question{file.content});
  if (question.mechanism() != nullptr) return py::none();
  GraspFile one = file;
  one.content = question.grasp;
  // The class of one body in the plane keeps it so, whatever the lengths of its normals.
  const GraspBox* box = question.box();
  if (box != nullptr && !box->in_space()) one.content = loaded_of(*box);
  return in_its_class(std::move(one));
}

/// Returns for each contact the body that it is of and the body that it is by.
py::tuple pairs_of(const BodiesFile& file) {
  return tuple_of(box_in(file).contacts, [&file](const UncertainContact& contact) {
    return py::make_tuple(text(mechanism_in(file).name_of(contact.of)),
                          text(mechanism_in(file).name_of(contact.by)));
  });
}

/// Reads a grasp of any class.
py::object parse(const std::string& content, const std::string& name) {
  GraspFile file =
      without_gil([&] { return parse_any_grasp(content, name, Intervals::kRefused); });
  return in_its_class(std::move(file));
}

}  // namespace

void bind_space(py::module_& module) {
  py::class_<SpatialGraspFile, GraspFile, std::shared_ptr<SpatialGraspFile>>(module,
                                                                             "SpatialGraspData")
      .def(py::init(&make_spatial_grasp))
      .def("text", &spatial_text)
      .def("with_friction",
           [](const SpatialGraspFile& g, const py::object& friction) {
             return in_its_class(
                 with_friction(g, numbers(friction, box_in(g).contacts.size(), "friction")));
           })
      .def("size", [](const SpatialGraspFile& g) { return box_in(g).contacts.size(); })
      .def("name", [](const SpatialGraspFile& g) { return text(g.description().name); })
      .def("positions", by_contact([](const UncertainContact& c) { return lows(c.position); }))
      .def("normals",
           by_contact([](const UncertainContact& c) { return fractions_of(c.normal); }))
      .def("friction", scalars(&UncertainContact::friction))
      .def("stiffness", scalars(&UncertainContact::stiffness))
      .def("preload", scalars(&UncertainContact::preload))
      .def("wrench", [](const SpatialGraspFile& g) { return lows(box_in(g).wrench); })
      .def("cases",
           [](const SpatialGraspFile& g) {
             py::dict result;
             for (const NamedLoad& one : g.cases) result[text(one.name)] = lows(one.wrench);
             return result;
           })
      .def("body", &body_of)
      .def("units", [](const SpatialGraspFile& g) { return units_of(g.description().units); })
      .def("snap",
           [](const SpatialGraspFile& g, const py::object& within) {
             BoxSnapResult result = snap_normals(box_in(g), exact(within, "within"));
             SpatialGraspFile grasp = g;
             grasp.content = std::move(result.grasp);
             return py::make_tuple(std::move(grasp), moved_normals(result.snapped));
           })
      .def(py::pickle(&pickled_grasp, &unpickled_grasp));
  py::class_<BodiesFile, SpatialGraspFile, std::shared_ptr<BodiesFile>>(module, "BodiesData")
      .def("in_space", [](const BodiesFile& f) { return mechanism_in(f).in_space; })
      .def("bodies",
           [](const BodiesFile& f) {
             return tuple_of(mechanism_in(f).bodies,
                             [](const Body& body) { return text(body.name); });
           })
      .def(
          "coordinates",
          [](const BodiesFile& f) { return tuple_of(coordinate_names(mechanism_in(f)), text); })
      .def("springs", &spring_names)
      .def("alone", &alone)
      .def("pairs", &pairs_of)
      .def(py::pickle(
          [](const BodiesFile& f) { return pickled_grasp(f); },
          [](const py::tuple& state) { return BodiesFile{unpickled_grasp(state)}; }));
  module.def("parse_grasp", &parse);
}

}  // namespace stickslip::python
