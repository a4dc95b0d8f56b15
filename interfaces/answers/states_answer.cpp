// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/states_answer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {
namespace {

/// Appends decimal digits, with a '-' before those of a negative number.
void append_digits(std::string& text, LongWord value) {
  constexpr std::uint64_t kPiece = 10'000'000'000'000'000'000U;  // It has 19 zeros.
  constexpr std::size_t kDigits = 19;
  if (value < 0) {
    text += '-';
    value = -value;
  }
  std::array<char, kDigits + 1> digits{};
  const auto append = [&](std::uint64_t piece, bool with_zeros) {
    const char* const end = std::to_chars(digits.begin(), digits.end(), piece).ptr;
    const auto size = static_cast<std::size_t>(end - digits.begin());
    if (with_zeros) text.append(kDigits - size, '0');
    text.append(digits.begin(), size);
  };
  // Two words have at most three pieces.
  const auto low = static_cast<std::uint64_t>(value % kPiece);
  if (const LongWord rest = value / kPiece; rest > 0) {
    const auto high = static_cast<std::uint64_t>(rest / kPiece);
    if (high > 0) append(high, false);
    append(static_cast<std::uint64_t>(rest % kPiece), high > 0);
    append(low, true);
  } else {
    append(low, false);
  }
}

/// Appends integers of a motion, each between these marks, and `between` them.
void append_motion(std::string& text, const StatesQuestion& question, const Face& face,
                   const char* mark, const char* between = ", ") {
  std::array<LongWord, kMostFaceCoordinates> words{};
  const std::size_t n = question.planes.coordinates;
  const bool fits = face.motion_in_words(words.data());
  const Row motion = fits ? Row() : face.motion();
  for (std::size_t j = 0; j < n; ++j) {
    if (j > 0) text += between;
    text += mark;
    if (fits) {
      append_digits(text, words[j]);
    } else {
      text += motion[j].str();
    }
    text += mark;
  }
}

/// A contact, and one of its lines or its normal.
struct PlaneName {
  std::size_t contact;
  std::optional<std::size_t> line;
};

std::vector<PlaneName> plane_names(const StatePlanes& planes) {
  std::vector<PlaneName> names(planes.planes.size());
  for (std::size_t i = 0; i < planes.contacts.size(); ++i) {
    const StatePlanes::Contact& contact = planes.contacts[i];
    if (contact.normal) names[*contact.normal] = {i, {}};
    for (std::size_t j = 0; j < contact.lines.size(); ++j) {
      names[contact.lines[j]] = {i, j};
    }
  }
  return names;
}

}  // namespace

const char* name_of(StateSet set) {
  for (const auto& [name, each] : kStateSets) {
    if (each == set) return name;
  }
  throw ContractError("a set of states has a name");
}

StateSet state_set_named(const std::string& name) {
  for (const auto& [each, set] : kStateSets) {
    if (each == name) return set;
  }
  throw ContractError("no set of states has that name");
}

void StatesQuestion::require_closed(std::size_t contacts) {
  const std::size_t all = grasp.contacts.size();
  if (planes.set != StateSet::kOpening && planes.set != StateSet::kContact) {
    throw InputError("", "at_least_closed", "no contact is open or closed in these states",
                     "ask for the modes cs or ss");
  }
  if (contacts > all) {
    throw InputError("", "at_least_closed", "more than the contacts of the grasp",
                     "it has " + std::to_string(all));
  }
  faces.most_positive = all - contacts;
}

void StatesQuestion::require_dimension(std::size_t dimension) {
  if (dimension > planes.coordinates) {
    throw InputError("", "dimension", "above that of all motions",
                     "it is at most " + std::to_string(planes.coordinates));
  }
  faces.least_dimension = faces.most_dimension = static_cast<int>(dimension);
}

StatesQuestion states_question(GraspBox grasp, SlipLines lines, StateSet set) {
  std::vector<ContactRows> rows = contact_rows_for_states(grasp, lines);
  StatePlanes planes = state_planes(motion_coordinates(grasp), rows, set);
  return {std::move(grasp), std::move(lines), std::move(rows), std::move(planes), {}};
}

FaceCounts count_states(const StatesQuestion& question, std::size_t limit) {
  const StatePlanes& planes = question.planes;
  if (limit == 0) return count_faces(planes.coordinates, planes.planes, question.faces);
  std::size_t found = 0;
  return visit_faces(
      planes.coordinates, planes.planes, [&](const Face&) { return found++ < limit; },
      question.faces);
}

std::vector<std::vector<RationalRow>> read_directions(const std::string& file) {
  InputFile input(file, "a file of directions");
  try {
    const JsonNode root = parse_json(input.read(kMaxJsonBytes));
    constexpr const char* kForm =
        "an array with a list of directions [x, y, z] for each contact";
    expect(root, JsonNode::Kind::kArray, "", kForm);
    std::vector<std::vector<RationalRow>> result;
    for (std::size_t i = 0; i < root.children.size(); ++i) {
      const std::string path = element_path("", i);
      expect(root.children[i], JsonNode::Kind::kArray, path, "a list of directions [x, y, z]");
      std::vector<RationalRow>& list = result.emplace_back();
      for (std::size_t j = 0; j < root.children[i].children.size(); ++j) {
        const JsonNode& node = root.children[i].children[j];
        const std::string place = element_path(path, j);
        expect(node, JsonNode::Kind::kArray, place, "a direction [x, y, z]");
        list.push_back(read_vector(node, place, node.children.size(), "numbers"));
      }
    }
    return result;
  } catch (const InputError& error) {
    throw error.in_file(input.name());
  }
}

Json states_head_json(const StatesQuestion& question) {
  const StatePlanes& planes = question.planes;
  Json rows = Json::array();
  for (const auto& [contact, line] : plane_names(planes)) {
    const ContactRows& of = question.rows[contact];
    Json row{{"contact", contact}};
    if (line) {
      row["line"] = *line;
    } else {
      row["line"] = nullptr;
    }
    row["row"] = number_json(line ? of.lines[*line] : of.normal);
    rows.push_back(std::move(row));
  }
  return {{"modes", name_of(planes.set)},
          {"contacts", question.grasp.contacts.size()},
          {"coordinates", planes.coordinates},
          {"rows", std::move(rows)}};
}

void append_state_json(std::string& text, const StatesQuestion& question, const Face& face) {
  const StatePlanes& planes = question.planes;
  text += "{\"state\": \"";
  planes.append_text(text, face);
  text += "\", \"dimension\": ";
  append_digits(text, face.dimension());
  text += ", \"motion\": [";
  append_motion(text, question, face, "\"");
  text += ']';
  for (const auto& [name, sign] :
       {std::pair("zero", Sign::kZero), std::pair("positive", Sign::kPositive),
        std::pair("negative", Sign::kNegative)}) {
    text += ", \"";
    text += name;
    text += "\": [";
    bool first = true;
    for (std::size_t i = 0; i < planes.planes.size(); ++i) {
      if (face.sign(i) != sign) continue;
      if (!first) text += ", ";
      first = false;
      append_digits(text, static_cast<LongWord>(i));
    }
    text += ']';
  }
  text += '}';
}

void append_state_line(std::string& text, const StatesQuestion& question, const Face& face) {
  question.planes.append_text(text, face);
  text += "  ";
  append_digits(text, face.dimension());
  text += "  (";
  append_motion(text, question, face, "");
  text += ")\n";
}

Json states_counts_json(const StatesQuestion& question, const FaceCounts& counts) {
  Json json{{"distinct_planes", counts.distinct_planes},
            {"rank", counts.rank},
            {"by_dimension", counts.by_dimension},
            {"distinct_states", counts.total()},
            {"complete", counts.complete}};
  if (const auto warning = near_miss_warning(question, counts)) {
    json["warnings"] = Json::array({*warning});
  }
  return json;
}

std::string states_certificate_head(const StatesQuestion& question) {
  const StateSet set = question.planes.set;
  if (set == StateSet::kOpening || set == StateSet::kContact) {
    throw InputError("", "certificate", "modes have no certificate of their own",
                     "take that of --modes full, which has them all: they are its states in "
                     "which no contact is pressed, with o for a contact that moves apart");
  }
  if (question.faces.least_dimension > 0 ||
      question.faces.most_dimension < static_cast<int>(question.planes.coordinates)) {
    throw InputError("", "certificate", "it proves that a list of all states is complete",
                     "take states of all dimensions");
  }
  std::string text =
      "{\"format\": \"stickslip-certificate/2\",\n \"producer\": \"stickslip " STICKSLIP_VERSION
      "\",\n \"question\": {\"contacts\": " +
      std::to_string(question.grasp.elements()) + ", \"states\": \"" + name_of(set) +
      "\"},\n \"verdict\": \"complete\",\n \"lines\": [";
  bool first = true;
  for (const std::vector<RationalRow>& lines :
       slip_directions(question.grasp, question.lines)) {
    text += first ? "\n  [" : ",\n  [";
    first = false;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      text += j == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < lines[j].size(); ++k) {
        text += (k == 0 ? "\"" : ", \"") + to_string(lines[j][k]) + '"';
      }
      text += ']';
    }
    text += ']';
  }
  return text + "],\n \"states\": [";
}

void append_proved_state(std::string& text, const char* separator,
                         const StatesQuestion& question, const Face& face) {
  const StatePlanes& planes = question.planes;
  const std::size_t begin = text.size();
  text += separator;
  text += '"';
  planes.append_text(text, face);
  const std::size_t first = text.find_first_of("+-", begin);
  if (first != std::string::npos && text[first] == '-') {
    text.resize(begin);
    return;
  }
  text += planes.contacts.empty() ? ": " : " : ";
  append_motion(text, question, face, "", " ");
  text += '"';
}

std::string states_certificate_end(const FaceCounts& counts) {
  std::string text = "],\n \"by_dimension\": [";
  for (std::size_t j = 0; j < counts.by_dimension.size(); ++j) {
    text += (j == 0 ? "" : ", ") + std::to_string(counts.by_dimension[j]);
  }
  return text + "]}\n";
}

Json state_graph_json(const StatesQuestion& question, const StateGraph& graph) {
  Json facets = Json::array();
  for (const StateGraph::Facet& facet : graph.facets) {
    facets.push_back(
        {{"state", facet.state}, {"cells", std::array{facet.first, facet.second}}});
  }
  return {{"modes", name_of(question.planes.set)},
          {"contacts", question.grasp.contacts.size()},
          {"coordinates", question.planes.coordinates},
          {"dimension", graph.dimension},
          {"cells", graph.cells},
          {"facets", std::move(facets)}};
}

std::string state_graph_dot(const StatesQuestion& question, const StateGraph& graph) {
  std::string text = std::string("graph ") + name_of(question.planes.set) + " {\n";
  for (const std::string& cell : graph.cells) text += "  \"" + cell + "\";\n";
  for (const StateGraph::Facet& facet : graph.facets) {
    text += "  \"" + graph.cells[facet.first] + "\" -- \"" + graph.cells[facet.second] +
            "\" [label=\"" + facet.state + "\"];\n";
  }
  return text + "}\n";
}

std::optional<std::string> near_miss_warning(const StatesQuestion& question,
                                             const FaceCounts& counts) {
  // The least of so many distances between 0 and 1 is so small by chance once in a thousand
  // times.
  constexpr double kChance = 1e-3;
  constexpr double kNear = 1e-4;
  const double distance = counts.near.distance;
  // Signs of lines are about as many as states, and states do not depend on threads.
  if (distance > kNear || distance * static_cast<double>(counts.total()) > kChance) {
    return std::nullopt;
  }
  const PlaneName name = plane_names(question.planes)[counts.near.plane];
  const int exponent = static_cast<int>(std::floor(std::log10(distance)));
  return "planes nearly coincide: " +
         (name.line ? "line " + std::to_string(*name.line) + " of contact "
                    : "the normal of contact ") +
         std::to_string(name.contact) + " misses a motion on which others are 0 by 1e" +
         std::to_string(exponent) +
         " of its size. If that is rounding, there are fewer states: round positions and "
         "normals "
         "less, or snap them to where they belong";
}

}  // namespace stickslip
