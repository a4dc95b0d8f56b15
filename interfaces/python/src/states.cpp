// SPDX-License-Identifier: GPL-3.0-or-later
// Slip states and contact modes in space, as arrays of NumPy.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/interfaces/question_text.hpp"
#include "stickslip/interfaces/states_answer.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

/// The digit of a plane that does not count: a slip of a contact that opens.
constexpr std::int8_t kNoSign = 2;

/// States that were found and not yet handed over.
class Chunk {
 public:
  Chunk(std::size_t planes, std::size_t coordinates)
      : planes_(planes), coordinates_(coordinates) {}

  std::size_t size() const { return dimensions_.size(); }

  void add(const Face& face) {
    for (std::size_t i = 0; i < planes_; ++i) {
      const auto sign = face.sign(i);
      signs_.push_back(sign ? static_cast<std::int8_t>(*sign) : kNoSign);
    }
    std::array<LongWord, kMostFaceCoordinates> motion{};
    const auto end = motion.begin() + static_cast<std::ptrdiff_t>(coordinates_);
    const bool fits = face.motion_in_words(motion.data()) &&
                      std::all_of(motion.begin(), end,
                                  [](LongWord x) { return x == static_cast<std::int64_t>(x); });
    if (!fits) {
      motion.fill(0);
      long_.emplace_back(size(), face.motion());
    }
    std::transform(motion.begin(), end, std::back_inserter(motions_),
                   [](LongWord x) { return static_cast<std::int64_t>(x); });
    dimensions_.push_back(static_cast<std::int8_t>(face.dimension()));
  }

  /// Returns the arrays of signs, dimensions and motions, and forgets the states. A motion that
  /// is no word makes the array of motions one of objects.
  py::tuple arrays() {
    const std::size_t n = size();
    py::array_t<std::int8_t> signs({n, planes_});
    std::copy(signs_.begin(), signs_.end(), signs.mutable_data());
    py::array_t<std::int8_t> dimensions(n);
    std::copy(dimensions_.begin(), dimensions_.end(), dimensions.mutable_data());
    py::array_t<std::int64_t> words({n, coordinates_});
    std::copy(motions_.begin(), motions_.end(), words.mutable_data());
    py::object motions = words;
    if (!long_.empty()) {
      motions = words.attr("astype")("O");
      for (const auto& [row, motion] : long_) {
        for (std::size_t j = 0; j < coordinates_; ++j) {
          motions[py::make_tuple(row, j)] = py::int_(py::str(motion[j].str()));
        }
      }
    }
    signs_.clear();
    motions_.clear();
    dimensions_.clear();
    long_.clear();
    return py::make_tuple(signs, dimensions, motions);
  }

 private:
  std::size_t planes_;
  std::size_t coordinates_;
  std::vector<std::int8_t> signs_;
  std::vector<std::int8_t> dimensions_;
  std::vector<std::int64_t> motions_;
  std::vector<std::pair<std::size_t, Row>> long_;  ///< by number of the state
};

/// Finds the states, and hands each `chunk` of them to `take`, which returns whether to go on;
/// between chunks it is now and then given None.
void find_states(const GraspFile& grasp, const py::dict& options, std::size_t chunk,
                 const py::function& take) {
  const StatesQuestion question = states_question_of(grasp, options);
  const StatePlanes& planes = question.planes;
  Chunk found(planes.planes.size(), planes.coordinates);
  const auto hand_over = [&] {
    const py::gil_scoped_acquire acquired;
    return take(found.arrays()).cast<bool>();
  };
  FaceOptions faces = question.faces;
  auto next = std::chrono::steady_clock::now();
  faces.go_on = [&](std::uint64_t) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next) return true;
    next = now + std::chrono::milliseconds(50);
    const py::gil_scoped_acquire acquired;
    return take(py::none()).cast<bool>();
  };
  without_gil([&] {
    const FaceCounts counts = visit_faces(
        planes.coordinates, planes.planes,
        [&](const Face& face) {
          found.add(face);
          return found.size() < chunk || hand_over();
        },
        faces);
    if (counts.complete && found.size() > 0) hand_over();
  });
}

/// States as a certificate has them.
struct Proved : FaceBatch {
  explicit Proved(const StatesQuestion& about) : question(about) {}
  void add(const Face& face) override { append_proved_state(text, ",\n  ", question, face); }
  std::size_t bytes() const override { return text.size(); }
  const StatesQuestion& question;
  std::string text;
};

/// Writes the certificate that a list of all states is complete.
void prove_states(const GraspFile& grasp, const py::dict& options, const std::string& path,
                  unsigned threads) {
  const StatesQuestion question = states_question_of(grasp, options);
  const std::string head = states_certificate_head(question);
  without_gil([&] {
    write_whole_file(path, [&](const FilePiece& piece) {
      piece(head);
      bool first = true;
      const FaceCounts counts = visit_faces_in_batches(
          question.planes.coordinates, question.planes.planes,
          [&] { return std::make_unique<Proved>(question); },
          [&](FaceBatch& batch) {
            std::string_view text = static_cast<Proved&>(batch).text;
            if (first && !text.empty()) {
              text.remove_prefix(1);  // the comma that parts it from others
              first = false;
            }
            piece(text);
            return true;
          },
          question.faces, threads);
      piece(states_certificate_end(counts));
      return counts.complete;
    });
  });
}

}  // namespace

StatesQuestion states_question_of(const GraspFile& file, const py::dict& options) {
  SlipLines lines{options["lines"].cast<std::size_t>(), options["snap"].cast<bool>(), {}};
  if (!options["directions"].is_none()) {
    auto& lists = lines.given.emplace();
    for (const py::handle list : options["directions"]) {
      std::vector<RationalRow>& of_contact = lists.emplace_back();
      for (const py::handle vector : list) {
        RationalRow& row = of_contact.emplace_back();
        for (const py::handle entry : vector) row.push_back(exact(entry, "directions"));
      }
    }
  }
  StatesQuestion question =
      states_question(contacts_alone(file).grasp.as_box(), std::move(lines),
                      state_set_named(options["modes"].cast<std::string>()));
  if (!options["at_least_closed"].is_none()) {
    question.require_closed(options["at_least_closed"].cast<std::size_t>());
  }
  if (!options["dimension"].is_none()) {
    question.require_dimension(options["dimension"].cast<std::size_t>());
  }
  return question;
}

void bind_states(py::module_& module) {
  module.def("find_states", &find_states);
  module.def("prove_states", &prove_states);
  module.def("state_rows", [](const GraspFile& grasp, const py::dict& options) {
    return python_of(states_head_json(states_question_of(grasp, options)));
  });
  module.def("state_counts", [](const GraspFile& grasp, const py::dict& options) {
    const StatesQuestion question = states_question_of(grasp, options);
    return python_of(without_gil([&] {
      return states_counts_json(question, count_faces(question.planes.coordinates,
                                                      question.planes.planes, question.faces));
    }));
  });
}

}  // namespace stickslip::python
