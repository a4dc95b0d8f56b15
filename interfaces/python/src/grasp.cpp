// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

Vector2 vector2(const py::list& rows, std::size_t i, const char* name) {
  const auto row = rows[i].cast<py::list>();
  const std::string place = name + ("[" + std::to_string(i) + ", ");
  return {exact(row[0], place + "0]"), exact(row[1], place + "1]")};
}

/// Reads lists of polygons of rings of vertices.
std::vector<Polygon> polygons(const py::list& outline) {
  std::vector<Polygon> result;
  for (const py::handle polygon : outline) {
    const std::string place = "outline[" + std::to_string(result.size()) + "]";
    result.emplace_back();
    for (const py::handle vertices : polygon) {
      const auto rows = vertices.cast<py::list>();
      const std::string name = place + "[" + std::to_string(result.back().size()) + "]";
      result.back().emplace_back();
      for (std::size_t i = 0; i < rows.size(); ++i) {
        result.back().back().push_back(vector2(rows, i, name.c_str()));
      }
    }
  }
  return result;
}

/// Makes a grasp; the package has checked the lengths.
GraspFile make_grasp(const py::list& positions, const py::list& normals,
                     const py::object& friction, const py::object& stiffness,
                     const py::object& preload, const py::list& wrench, const std::string& name,
                     bool assumed_stiffness, const py::list& cases, const py::list& units,
                     const py::list& outline) {
  const std::size_t m = positions.size();
  const std::vector<Rational> frictions = numbers(friction, m, "friction");
  const std::vector<Rational> stiffnesses = numbers(stiffness, m, "stiffness");
  const std::vector<Rational> preloads = numbers(preload, m, "preload");
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < m; ++i) {
    contacts.push_back({vector2(positions, i, "positions"), vector2(normals, i, "normals"),
                        frictions[i], stiffnesses[i], preloads[i]});
  }
  GraspDescription description{name, polygons(outline), units_from(units)};
  GraspFile file{LoadedGrasp{Grasp(std::move(contacts), std::move(description)),
                             exact_wrench(wrench, "wrench")}};
  for (std::size_t i = 0; assumed_stiffness && i < m; ++i) {
    file.assumed_stiffness.emplace_back(i);
  }
  for (const py::handle entry : cases) {
    const auto named = entry.cast<py::tuple>();
    const auto case_name = named[0].cast<std::string>();
    file.cases.push_back({case_name, box_of(exact_wrench(named[1].cast<py::list>(),
                                                         "cases[" + quote(case_name) + "]"))});
  }
  return file;
}

py::dict wrenches_of_cases(const GraspFile& file) {
  py::dict result;
  for (const NamedLoad& load : file.cases) {
    result[text(load.name)] = fractions(wrench_of(middle_of(load.wrench)));
  }
  return result;
}

py::tuple outline_of(const GraspFile& file) {
  const auto vertex = [](const Vector2& v) { return fractions(v.x, v.y); };
  const auto ring = [&](const Ring& vertices) { return tuple_of(vertices, vertex); };
  const auto polygon = [&](const Polygon& rings) { return tuple_of(rings, ring); };
  return tuple_of(file.description().outline, polygon);
}

/// Returns the text with every stiffness written out: equal grasps give equal texts.
std::string text_of(GraspFile file) {
  file.assumed_stiffness.clear();
  return write_grasp_file(file);
}

/// Returns the grasp with rational unit normals, and (contact, normal, moved at most) of each
/// that moved.
py::tuple snapped(const GraspFile& file, const py::object& within) {
  const SnapResult result = snap_normals(file.loaded().grasp, exact(within, "within"));
  GraspFile grasp = file;
  grasp.content = LoadedGrasp{result.grasp, file.loaded().wrench};
  return py::make_tuple(std::move(grasp), moved_normals(result.snapped));
}

/// Returns one value for each contact.
template <class Value>
py::tuple by_contact(const GraspFile& file, Value value) {
  return tuple_of(file.loaded().grasp.contacts(), value);
}

py::tuple scalars(const GraspFile& file, Rational Contact::*member) {
  return by_contact(file, [member](const Contact& c) { return fraction(c.*member); });
}

py::tuple vectors(const GraspFile& file, Vector2 Contact::*member) {
  return by_contact(file, [member](const Contact& c) {
    const Vector2& v = c.*member;
    return fractions(v.x, v.y);
  });
}

}  // namespace

std::vector<Rational> numbers(const py::object& values, std::size_t contacts,
                              const std::string& name) {
  if (!py::isinstance<py::list>(values)) {
    return std::vector<Rational>(contacts, exact(values, name));
  }
  std::vector<Rational> result;
  for (const py::handle value : values) {
    result.push_back(exact(value, name + "[" + std::to_string(result.size()) + "]"));
  }
  return result;
}

std::optional<Units> units_from(const py::list& units) {
  if (units.empty()) return std::nullopt;
  return Units{units[0].cast<std::string>(), units[1].cast<std::string>()};
}

py::dict units_of(const std::optional<Units>& units) {
  py::dict result;
  if (units) {
    result["length"] = text(units->length);
    result["force"] = text(units->force);
  }
  return result;
}

GraspFile with_friction(const GraspFile& file, const std::vector<Rational>& friction) {
  GraspFile result = file;
  if (GraspBox* box = result.content.box()) {
    for (std::size_t i = 0; i < friction.size(); ++i) {
      box->contacts[i].friction = point_interval(friction[i]);
    }
    box->check();
    return result;
  }
  std::vector<Contact> contacts = file.loaded().grasp.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].friction = friction[i];
  result.content =
      LoadedGrasp{Grasp(std::move(contacts), file.description()), file.loaded().wrench};
  return result;
}

py::object in_its_class(GraspFile grasp) {
  if (grasp.content.mechanism() != nullptr) {
    return py::cast(BodiesFile{{std::move(grasp)}});
  }
  if (grasp.content.in_space()) return py::cast(SpatialGraspFile{std::move(grasp)});
  return py::cast(std::move(grasp));
}

void bind_grasp(py::module_& module) {
  py::class_<GraspFile, std::shared_ptr<GraspFile>>(module, "GraspData")
      .def(py::init(&make_grasp))
      .def("text", &text_of)
      .def("with_friction",
           [](const GraspFile& f, const py::object& friction) {
             return with_friction(f, numbers(friction, f.loaded().grasp.size(), "friction"));
           })
      .def("size", [](const GraspFile& f) { return f.loaded().grasp.size(); })
      .def("name", [](const GraspFile& f) { return text(f.description().name); })
      .def("positions", [](const GraspFile& f) { return vectors(f, &Contact::position); })
      .def("normals", [](const GraspFile& f) { return vectors(f, &Contact::normal); })
      .def("friction", [](const GraspFile& f) { return scalars(f, &Contact::friction); })
      .def("stiffness", [](const GraspFile& f) { return scalars(f, &Contact::stiffness); })
      .def("preload", [](const GraspFile& f) { return scalars(f, &Contact::preload); })
      .def("wrench", [](const GraspFile& f) { return fractions(f.loaded().wrench); })
      .def("cases", &wrenches_of_cases)
      .def("outline", &outline_of)
      .def("units", [](const GraspFile& f) { return units_of(f.description().units); })
      .def("snap", &snapped)
      .def(py::pickle(
          [](const GraspFile& f) { return py::make_tuple(py::bytes(write_grasp_file(f))); },
          [](const py::tuple& state) {
            return parse_grasp(state[0].cast<std::string>(), "<pickle>");
          }));
}

}  // namespace stickslip::python
