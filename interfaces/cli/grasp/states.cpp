// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "interruption.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/states_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct StatesArguments : StateSetArguments {
  std::string file;
  std::string engine = "auto";
  std::string directions;
  std::string closed;
  std::string dimension;
  unsigned threads = 0;
  std::string certificate;
  std::string time_limit;
  bool list = false;
  bool graph = false;
  bool json = false;

  /// Returns whether something is asked that the enumerators of the sphere do not know.
  bool beyond_sphere() const {
    return modes != "slip" || lines > 0 || snap || !directions.empty() || !closed.empty() ||
           !dimension.empty() || limit > 0 || !certificate.empty() || graph;
  }
};

Enumerator enumerator(const std::string& engine) {
  return engine == "cgal"    ? Enumerator::kCgal
         : engine == "sweep" ? Enumerator::kSweep
         : engine == "paper" ? Enumerator::kPaper
                             : Enumerator::kAuto;
}

void print_text(const StatesArguments& arguments, const std::string& name,
                const Enumeration& report) {
  const ArrangementCounts& c = report.found.counts;
  if (!name.empty()) std::cout << name << '\n';
  std::cout << format_table(
      {{"contacts", "circles", "rank", "vertices", "edges", "faces", "cells",
        "distinct states"},
       {std::to_string(c.planes), std::to_string(c.circles), std::to_string(c.rank),
        std::to_string(c.vertices), std::to_string(c.edges), std::to_string(c.faces),
        std::to_string(c.cells()), std::to_string(c.distinct_states)}});
  if (arguments.list) {
    for (const SlipState& state : report.found.states) std::cout << to_string(state) << '\n';
    std::cout << "A sign a contact: + and - slip along and against the tangent, 0 sticks.\n";
  }
  std::cout
      << "Engine: " << report.engine
      << (enumerator(report.engine) == Enumerator::kPaper
              ? ". What the paper's three steps find; all-stick is not one of their cells.\n"
              : ". Cells are on the sphere of motions; distinct states include all-stick.\n");
}

int states_on_sphere(const StatesArguments& arguments, const Grasp& grasp) {
  LongWork work("states", time_limit_option(arguments.time_limit));
  Enumeration report;
  if (!work.finishes([&] {
        report = enumerate_slip_states(stick_planes(grasp), enumerator(arguments.engine),
                                       arguments.list, arguments.threads);
      })) {
    std::cerr << "stickslip: the states are not known: " << in_words(out_of_time(work.limit()))
              << '\n';
    return kUndecidedWithinLimit;
  }
  if (arguments.json) {
    std::cout << states_json(report, arguments.list).dump(1) << '\n';
  } else {
    print_text(arguments, grasp.name(), report);
  }
  return kDone;
}

/// Returns the error with the options of this command.
InputError of_options(const InputError& error) {
  const std::string& place = error.place();
  if (place == "lines") {
    return {error.file(), "--lines", error.problem(),
            error.remedy() + " (--snap, --directions FILE)"};
  }
  if (place == "graph") {
    return {error.file(), "--graph", error.problem(), "add --modes slip, full or closed"};
  }
  if (place == "certificate") {
    return {error.file(), "--certificate", error.problem(), error.remedy()};
  }
  if (place == "dimension")
    return {error.file(), "--dimension", error.problem(), error.remedy()};
  if (place == "at_least_closed") {
    return {error.file(), "--at-least-closed", error.problem(),
            error.remedy() == "ask for the modes cs or ss" ? "add --modes cs or --modes ss"
                                                           : error.remedy()};
  }
  return error;
}

StatesQuestion question_of(const StatesArguments& arguments, const AnyGrasp& grasp) {
  if (arguments.engine != "auto") {
    throw InputError("", "--engine", "an engine for slip states of one body in the plane",
                     "leave it out");
  }
  StatesAsked asked = arguments.asked();
  if (!arguments.directions.empty()) asked.lines.given = read_directions(arguments.directions);
  try {
    StatesQuestion question =
        states_question(grasp.as_box(), std::move(asked.lines), asked.set);
    if (!arguments.closed.empty()) question.require_closed(std::stoul(arguments.closed));
    if (!arguments.dimension.empty())
      question.require_dimension(std::stoul(arguments.dimension));
    return question;
  } catch (const InputError& error) {
    constexpr std::string_view kDirections = "directions";
    if (error.place().substr(0, kDirections.size()) != kDirections) throw of_options(error);
    throw InputError(arguments.directions, error.place().substr(kDirections.size()),
                     error.problem(), error.remedy());
  }
}

/// Writes states while they are found, and counts when all are.
class StatesWriter {
 public:
  StatesWriter(const StatesArguments& arguments, const StatesQuestion& question)
      : arguments_(arguments), question_(question) {}

  /// Finds and writes. Returns whether nothing ended it before the last state.
  bool write() {
    if (arguments_.certificate.empty()) return find();
    const std::string head = head_of_proof();
    bool complete = false;
    write_whole_file(arguments_.certificate, [&](const FilePiece& piece) {
      piece_ = &piece;
      proof_ = head;
      complete = find();
      piece(proof_);
      return complete;
    });
    return complete;
  }

 private:
  static constexpr std::size_t kBatch = std::size_t{1} << 16;

  std::string head_of_proof() const {
    try {
      return states_certificate_head(question_);
    } catch (const InputError& error) {
      throw of_options(error);
    }
  }

  /// States as they are written.
  struct Batch : FaceBatch {
    explicit Batch(const StatesWriter& of) : writer(of) {}

    void add(const Face& face) override {
      const StatesArguments& arguments = writer.arguments_;
      if (arguments.list && arguments.json) {
        list += kSeparator;
        append_state_json(list, writer.question_, face);
      } else if (arguments.list) {
        append_state_line(list, writer.question_, face);
      }
      if (writer.piece_ != nullptr) {
        append_proved_state(proof, kSeparator, writer.question_, face);
      }
    }
    std::size_t bytes() const override { return list.size() + proof.size(); }

    static constexpr const char* kSeparator = ",\n  ";
    const StatesWriter& writer;
    std::string list;
    std::string proof;
  };

  bool find() {
    write_head();
    FaceOptions options = question_.faces;
    options.go_on = [&](std::uint64_t found) {
      progress_.show(std::to_string(found) + " states so far");
      return !interrupted_ && !limit_.is_over();
    };
    const StatePlanes& planes = question_.planes;
    const InterruptionStop stop([&] { interrupted_ = true; });
    const FaceCounts counts =
        arguments_.limit > 0 ? find_first(options)
        : arguments_.list || piece_ != nullptr
            ? visit_faces_in_batches(
                  planes.coordinates, planes.planes,
                  [&] { return std::make_unique<Batch>(*this); },
                  [&](FaceBatch& batch) { return write_batch(static_cast<Batch&>(batch)); },
                  options, arguments_.threads)
            : count_faces(planes.coordinates, planes.planes, options, arguments_.threads);
    progress_.clear();
    if (piece_ != nullptr) proof_ += states_certificate_end(counts);
    write_counts(counts);
    return counts.complete;
  }

  void write_head() {
    const std::string& name = question_.grasp.description.name;
    if (!arguments_.json) {
      if (!name.empty()) std::cout << name << '\n';
      return;
    }
    const std::string head = finished(states_head_json(question_), false).dump(1);
    std::cout << head.substr(0, head.size() - 2);  // without the brace that closes it
    if (arguments_.list) std::cout << ",\n \"states\": [";
  }

  /// Finds as many as --limit allows.
  FaceCounts find_first(const FaceOptions& options) {
    Batch batch(*this);
    std::size_t found = 0;
    const FaceCounts counts = visit_faces(
        question_.planes.coordinates, question_.planes.planes,
        [&](const Face& face) {
          if (found++ == arguments_.limit) return false;
          batch.add(face);
          return batch.bytes() < kBatch || write_batch(batch);
        },
        options);
    write_batch(batch);
    return counts;
  }

  /// Writes a batch, whose states begin with commas in JSON, and empties it.
  bool write_batch(Batch& batch) {
    const auto rest = [](const std::string& text, bool after_others) {
      return std::string_view(text).substr(after_others || text.empty() ? 0 : 1);
    };
    std::cout << rest(batch.list, listed_ || !arguments_.json);
    listed_ = listed_ || !batch.list.empty();
    batch.list.clear();
    if (piece_ != nullptr) {
      proof_ += rest(batch.proof, proved_);
      proved_ = proved_ || !batch.proof.empty();
      batch.proof.clear();
      (*piece_)(proof_);
      proof_.clear();
    }
    return true;
  }

  void write_counts(const FaceCounts& counts) {
    if (arguments_.json) {
      if (arguments_.list) std::cout << (listed_ ? "\n ]" : "]");
      const std::string rest = finished(states_counts_json(question_, counts), false).dump(1);
      std::cout << "," << rest.substr(1) << '\n';
      return;
    }
    const StatePlanes& planes = question_.planes;
    std::vector<std::vector<std::string>> rows{{"dimension"}, {"states"}};
    for (std::size_t j = 0; j < counts.by_dimension.size(); ++j) {
      rows[0].push_back(std::to_string(j));
      rows[1].push_back(std::to_string(counts.by_dimension[j]));
    }
    rows[0].push_back("all");
    rows[1].push_back(std::to_string(counts.total()));
    std::cout << format_table(
                     {{"contacts", "coordinates", "planes", "distinct planes", "rank"},
                      {std::to_string(planes.contacts.size()),
                       std::to_string(planes.coordinates), std::to_string(planes.planes.size()),
                       std::to_string(counts.distinct_planes), std::to_string(counts.rank)}})
              << format_table(rows) << meaning();
    if (!counts.complete) {
      std::cout << (interrupted_       ? "Interrupted"
                    : limit_.is_over() ? "Ended by " + limit_.in_words()
                                       : "Ended by --limit")
                << ": there may be more states than these.\n";
    }
    if (const auto warning = near_miss_warning(question_, counts)) {
      std::cout << "Warning: " << *warning << ".\n";
    }
  }

  /// Says what was counted.
  std::string meaning() const {
    std::string text;
    switch (question_.planes.set) {
      case StateSet::kSlip:
        text =
            "Slip states of all motions, as if no contact opened: the signs of slip along the "
            "lines.\n";
        break;
      case StateSet::kFull:
        text =
            "States of all motions: for each contact the sign of N.d (+ apart, - pressed), |, "
            "and\nthe signs of slip along the lines.\n";
        break;
      case StateSet::kClosed:
        text = "Slip states of motions on which all contacts stay closed, N.d = 0.\n";
        break;
      case StateSet::kOpening:
        text = "Modes of motions that press nothing together: o opens, c stays closed.\n";
        break;
      case StateSet::kContact:
        text =
            "Contact modes of motions that press nothing together: o opens; of contacts that "
            "stay\nclosed the signs of slip along the lines.\n";
        break;
    }
    if (arguments_.list) {
      text +=
          "A line a state: contacts, dimension, and a motion that has the state. "
          "+ and - slip along\nand against a line, 0 does neither.\n";
    }
    const bool opens = question_.planes.set == StateSet::kOpening ||
                       question_.planes.set == StateSet::kContact;
    bool preloaded = false;
    for (const UncertainContact& contact : question_.grasp.contacts) {
      preloaded = preloaded || contact.preload.high > 0;
    }
    if (opens && preloaded) {
      text +=
          "Some contacts are preloaded: o says that a contact moves apart. It keeps some "
          "force until\nit has moved by P/k, preload over stiffness.\n";
    }
    return text;
  }

  const StatesArguments& arguments_;
  const StatesQuestion& question_;
  Progress progress_;
  TimeLimit limit_ = time_limit_option(arguments_.time_limit);
  std::atomic<bool> interrupted_{false};
  bool listed_ = false;               ///< whether a state has been listed
  const FilePiece* piece_ = nullptr;  ///< where a certificate goes
  std::string proof_;                 ///< what comes next there
  bool proved_ = false;               ///< whether a state is in it
};

/// Writes which states border on each other.
int write_graph(const StatesArguments& arguments, const StatesQuestion& question) {
  if (arguments.list || arguments.limit > 0 || !arguments.certificate.empty() ||
      !arguments.closed.empty() || !arguments.dimension.empty()) {
    throw InputError("", "--graph", "it has all states of two dimensions",
                     "leave out --list, --certificate and filters");
  }
  std::atomic<bool> interrupted{false};
  const InterruptionStop stop([&] { interrupted = true; });
  Progress progress;
  StateGraph graph;
  try {
    graph = state_graph(question.planes, [&](std::uint64_t found) {
      progress.show(std::to_string(found) + " states so far");
      return !interrupted;
    });
  } catch (const InputError& error) {
    throw of_options(error);
  }
  progress.clear();
  if (!graph.complete) return kUndecidedWithinLimit;
  if (arguments.json) {
    std::cout << state_graph_json(question, graph).dump(1) << '\n';
  } else {
    std::cout << state_graph_dot(question, graph);
  }
  return kDone;
}

int states(const StatesArguments& arguments) {
  const Question question = read_contacts(arguments.file);
  if (const LoadedGrasp* one = question.grasp.single();
      one != nullptr && !arguments.beyond_sphere()) {
    return states_on_sphere(arguments, one->grasp);
  }
  if (!arguments.certificate.empty() && arguments.limit > 0) {
    throw InputError("", "--certificate", "it proves that a list of all states is complete",
                     "leave out --limit");
  }
  const StatesQuestion states = question_of(arguments, question.grasp);
  if (arguments.graph) return write_graph(arguments, states);
  return StatesWriter(arguments, states).write() ? kDone : kUndecidedWithinLimit;
}

}  // namespace

void add_states_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<StatesArguments>();
  Command* command = app.add_subcommand(
      "states", "Enumerate the slip states consistent with rigid motion, and count cells");
  add_grasp_argument(*command, arguments->file);
  add_state_set_options(*command, *arguments);
  command
      ->add_option("--directions", arguments->directions,
                   "JSON file with directions of lines in place of --lines: a list for each "
                   "contact, of vectors across its normal")
      ->type_name("FILE");
  command
      ->add_option("--at-least-closed", arguments->closed,
                   "With --modes cs or ss: only modes in which so many contacts stay closed")
      ->type_name("J")
      ->check(whole_number(kMostFacePlanes));
  command
      ->add_option("--dimension", arguments->dimension,
                   "Only states whose motions have this dimension; 6 of 6 leave all freedom")
      ->type_name("D")
      ->check(whole_number(kMostFaceCoordinates));
  add_time_limit_option(
      *command, arguments->time_limit,
      "End after so many seconds with the states that are found by then; 0 is "
      "no limit");
  command
      ->add_option("--engine", arguments->engine,
                   "How to enumerate in the plane. cgal: CGAL's arrangement on the sphere, the "
                   "reference. sweep: ours, for many "
                   "contacts. paper: the paper's own three steps, a baseline. auto: cgal for "
                   "few contacts, else sweep")
      ->type_name("ENGINE")
      ->choices({"auto", "cgal", "sweep", "paper"})
      ->capture_default_str();
  add_threads_option(*command, arguments->threads,
                     "Threads, in the plane those of the sweep; 0 is one a core");
  command
      ->add_option("--certificate", arguments->certificate,
                   "With --modes slip, full or closed: write a proof for stickslip-check "
                   "--states MODES that there are no other states (certificate/FORMAT.md, "
                   "section 17)")
      ->type_name("FILE");
  command->add_flag("--list", arguments->list,
                    "List the states, in the plane one character a contact: + and - slip, 0 "
                    "stick; in space a character a line of slip, and a motion");
  command->add_flag("--graph", arguments->graph,
                    "With --modes slip, full or closed: print which states of the largest "
                    "dimension border on each other, and in which states between them, for "
                    "Graphviz; with --json as JSON");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->footer(footer_text(
      "In the plane motions are points of a sphere, which each contact cuts in a great circle: "
      "on it\nthe contact sticks, and it slips one way or the other on either side. Cells are "
      "the faces,\nedges and vertices that result. In space, and of several bodies, each line "
      "of slip is a plane\nof all motions, and states are counted by the dimension of their "
      "motions. Wrench, friction and\npreload play no part.\n",
      kExitCodes + ", 3 ended by a limit or an interruption",
      "stickslip states fig1.json --list"));
  command->callback([arguments, &exit_code] { exit_code = states(*arguments); });
}

}  // namespace stickslip
