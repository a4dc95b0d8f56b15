// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "batch_results.hpp"
#include "commands.hpp"
#include "interruption.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/equilibrium/search/branch_and_bound.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct BatchArguments {
  QuestionArguments question;
  std::string file;
  std::string output = "-";
  std::string certificates;
  bool resume = false;
  std::size_t node_limit = 0;
  int threads = 0;
};

/// FNV-1a, 64 bits: tells whether a result is that of this line and these options. Nothing is
/// proved by it.
std::string key_of(const std::string& options, const std::string& line) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](const std::string& text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  };
  add(options);
  add(line);
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(hash >> shift) & 15U];
  return text;
}

struct Item {
  std::size_t number = 0;
  std::string text;
  std::string result;  ///< a line of output
  LineOutcome outcome = LineOutcome::kDecided;
};

class Batch {
 public:
  explicit Batch(const BatchArguments& arguments)
      : arguments_(arguments), options_(arguments.question.options()) {
    const auto spell = [&](const std::optional<Rational>& value) {
      options_text_ += (value ? to_string(*value) : "") + ";";
    };
    const std::optional<Wrench>& w = options_.wrench;
    spell(w ? std::optional(w->x) : std::nullopt);
    spell(w ? std::optional(w->y) : std::nullopt);
    spell(w ? std::optional(w->torque) : std::nullopt);
    spell(options_.preload);
    if (options_.case_name) options_text_ += *options_.case_name + ";";
    options_text_ += std::string(to_string(options_.law)) + ";" +
                     std::to_string(arguments.node_limit) + "\n";
    const auto size = std::filesystem::file_size(arguments_.file, ignored_);
    if (!ignored_) bytes_ = size;
    if (arguments_.output != "-") open_output();
    if (!arguments_.certificates.empty()) open_folder();
  }

  int run() {
    to_file_ = writes_to_file();
    using oneapi::tbb::global_control;
    std::optional<global_control> allowed;  // more than there are cores, without a warning
    if (arguments_.threads > 0) {
      allowed.emplace(global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(arguments_.threads));
    }
    oneapi::tbb::task_arena arena(arguments_.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                          : arguments_.threads);
    // So many lines are held at a time, whatever the length of the file.
    const auto lines_held = 4 * static_cast<std::size_t>(arena.max_concurrency());
    using oneapi::tbb::filter_mode;
    using oneapi::tbb::make_filter;
    arena.execute([&] {
      oneapi::tbb::parallel_pipeline(
          lines_held,
          make_filter<void, Item>(filter_mode::serial_in_order,
                                  [&](oneapi::tbb::flow_control& flow) { return read(flow); }) &
              make_filter<Item, Item>(filter_mode::parallel,
                                      [&](Item item) { return decide(std::move(item)); }) &
              make_filter<Item, void>(filter_mode::serial_in_order,
                                      [&](const Item& item) { write(item); }));
    });
    const std::size_t all = written_before_ + written_;
    if (all == 0)
      std::cerr << "stickslip: " << input_.name()
                << ": the file is empty, there is no grasp in it\n";
    if (unreadable_ > 0) {
      progress_.reset();  // its line on the terminal goes
      std::cerr << "stickslip: " << input_.name() << ": " << unreadable_ << " of " << all
                << (all == 1 ? " line" : " lines") << " could not be read, the first is line "
                << first_unreadable_ << "; their results say why\n";
      return kBadInput;
    }
    return undecided_ > 0 ? kUndecidedWithinLimit : kDone;
  }

 private:
  void open_output() {
    const std::string& path = arguments_.output;
    require_unprotected(path);
    if (std::filesystem::is_regular_file(path, ignored_) &&
        std::filesystem::file_size(path, ignored_) > 0) {
      if (!arguments_.resume) {
        throw InputError(path, "--output", "the file exists",
                         "go on with --resume, or name another file");
      }
      keep_finished();
    }
    errno = 0;
    output_file_.open(path, std::ios::binary | std::ios::app);
    if (!output_file_) throw cannot_write(path, errno);
    protect_file(path, "output");
    out_ = &output_file_;
  }

  /// Whatever a killed run was writing there is to be written again.
  void open_folder() {
    make_folder("--certificates", arguments_.certificates);
    if (!arguments_.resume) return;
    static const std::regex kCertificate("line-[0-9]+\\.json");
    for (const auto& entry : std::filesystem::directory_iterator(arguments_.certificates)) {
      const std::string target = target_of_temporary(entry.path().filename().string());
      if (entry.is_regular_file(ignored_) && std::regex_match(target, kCertificate)) {
        std::filesystem::remove(entry.path(), ignored_);
      }
    }
  }

  /// What has a result need not be decided again, if it was the same question. Cuts off a line
  /// that an interruption left unfinished.
  void keep_finished() {
    std::ifstream before(arguments_.output, std::ios::binary);
    FinishedResults finished(before, arguments_.output);
    while (const std::optional<FinishedResult> result = finished.next()) {
      Item item;
      const bool more = read_line(item);
      if (!more || result->key != key_of(options_text_, item.text)) {
        throw InputError(
            arguments_.output, "result of line " + std::to_string(lines_.number()),
            "it is not that of this line of " + arguments_.file + " under these options",
            "resume with the same grasps and options, or name another file");
      }
      count(item.number, result->outcome);
    }
    before.close();
    std::error_code error;
    std::filesystem::resize_file(arguments_.output, finished.bytes(), error);
    if (error) throw cannot_write(arguments_.output, error.value());
    written_before_ = finished.lines();
    bytes_skipped_ = bytes_read_;
  }

  /// Whether results go to a file, which is to end in a whole line whatever happens. Nobody may
  /// ever read a pipe: an interruption does not wait for it.
  bool writes_to_file() const {
    struct stat out {};
    const int found = out_ == &std::cout ? ::fstat(STDOUT_FILENO, &out)
                                         : ::stat(arguments_.output.c_str(), &out);
    return found == 0 && S_ISREG(out.st_mode);
  }

  /// False at the end. A line that is too long has its error as its result.
  bool read_line(Item& item) {
    try {
      if (!lines_.next(item.text)) return false;
    } catch (const InputError& error) {
      item.text.clear();
      item.number = lines_.number();
      fail(item, error);
      return true;
    }
    item.number = lines_.number();
    bytes_read_ += item.text.size() + 1;
    return true;
  }

  Item read(oneapi::tbb::flow_control& flow) {
    Item item;
    if (!read_line(item)) flow.stop();
    return item;
  }

  Json head(const Item& item) const {
    return {{"line", item.number}, {"key", key_of(options_text_, item.text)}};
  }

  void fail(Item& item, const InputError& error) const {
    Json json = head(item);
    json["error"] = {
        {"place", error.place()}, {"problem", error.problem()}, {"remedy", error.remedy()}};
    item.result = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    item.outcome = LineOutcome::kUnreadable;
  }

  Item decide(Item item) const {
    if (!item.result.empty()) return item;
    std::string certificate;
    Json json = head(item);
    try {
      const Question question = ask_with_options(parse_grasp(item.text, ""), options_, "");
      ConeOptions options;
      options.node_limit = arguments_.node_limit;
      const Problem problem = problem_of(question);
      const Verdict verdict = decide_by_cones(problem, options);
      json["name"] = question.loaded.grasp.name();
      json["verdict"] = name_of(verdict);
      if (const auto* undecided = std::get_if<Undecided>(&verdict)) {
        json["limit"] = undecided->limit;
        item.outcome = LineOutcome::kUndecided;
      } else if (!arguments_.certificates.empty()) {
        certificate =
            certificate_text(question, verdict, "stickslip " STICKSLIP_VERSION ", batch");
      }
    } catch (const InputError& error) {
      fail(item, error);
      return item;
    }
    // A file that cannot be written ends the batch: it is no property of the line.
    if (!certificate.empty()) {
      const std::string path =
          arguments_.certificates + "/line-" + std::to_string(item.number) + ".json";
      write_whole_file(path, certificate);
      json["certificate"] = path;
    }
    item.result = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    item.text.clear();
    return item;
  }

  void write(const Item& item) {
    std::optional<FileWrite> whole_line;
    if (to_file_) whole_line.emplace();
    errno = 0;
    *out_ << item.result << std::flush;
    if (!*out_ && errno == EPIPE && on_broken_pipe_ == SIG_DFL) end_by_signal(SIGPIPE);
    if (!*out_) {
      throw cannot_write(arguments_.output == "-" ? "<stdout>" : arguments_.output, errno);
    }
    ++written_;
    count(item.number, item.outcome);
    progress_->show(progress_text());
  }

  void count(std::size_t line, LineOutcome outcome) {
    if (outcome == LineOutcome::kUnreadable && unreadable_ == 0) first_unreadable_ = line;
    unreadable_ += outcome == LineOutcome::kUnreadable ? 1 : 0;
    undecided_ += outcome == LineOutcome::kUndecided ? 1 : 0;
  }

  std::string interruption_text() const {
    if (arguments_.output == "-") {
      return "stickslip: interrupted; had the results gone to --output FILE, --resume would go "
             "on from there";
    }
    return "stickslip: interrupted with " + std::to_string(written_before_ + written_) +
           " results in " + arguments_.output + "; go on with the same command" +
           (arguments_.file == "-" ? ", the same input" : "") + " and --resume";
  }

  std::string progress_text() const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double rate = static_cast<double>(written_) / std::max(seconds, 1e-3);
    std::string text =
        std::to_string(written_) + " grasps, " + std::to_string(std::lround(rate)) + "/s";
    if (unreadable_ > 0) text += ", " + std::to_string(unreadable_) + " unreadable";
    const std::uintmax_t read_now = bytes_read_;
    if (read_now > bytes_skipped_ && read_now <= bytes_) {
      const double share = static_cast<double>(bytes_ - read_now) /
                           static_cast<double>(read_now - bytes_skipped_);
      text += ", about " + std::to_string(std::lround(seconds * share)) + " s left";
    }
    return text;
  }

  const BatchArguments& arguments_;
  QuestionOptions options_;
  std::string options_text_;
  std::error_code ignored_;
  InputFile input_{arguments_.file, "a file of grasps, one a line"};
  std::ofstream output_file_;
  std::ostream* out_ = &std::cout;
  TextLines lines_{input_.stream()};
  std::uintmax_t bytes_ = 0;  ///< of the input, if known
  std::atomic<std::uintmax_t> bytes_read_{0};
  std::uintmax_t bytes_skipped_ = 0;  ///< that had results already
  bool to_file_ = false;
  std::size_t written_before_ = 0;  ///< results that were there
  std::atomic<std::size_t> written_{0};
  std::size_t unreadable_ = 0;
  std::size_t first_unreadable_ = 0;  ///< its number
  std::size_t undecided_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<Progress> progress_{std::in_place};
  /// With the default, the end of whoever reads the results would end a certificate
  /// half-written.
  void (*on_broken_pipe_)(int) = std::signal(SIGPIPE, SIG_IGN);
  InterruptionMessage interruption_{[this] { return interruption_text(); }};
};

}  // namespace

void add_batch_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<BatchArguments>();
  CLI::App* command = app.add_subcommand(
      "batch", "Decide many grasps in parallel, one a line; results in the same order");
  command
      ->add_option("GRASPS", arguments->file,
                   "JSON Lines, a grasp (docs/grasp_file.md) on each line; - is standard input")
      ->type_name("FILE")
      ->required();
  arguments->question.add_options_to(*command);
  CLI::Option* output =
      command
          ->add_option("--output,-o", arguments->output,
                       "File for the results, which is added to as they come; - is standard "
                       "output")
          ->type_name("FILE")
          ->capture_default_str();
  command
      ->add_flag("--resume", arguments->resume,
                 "Go on after an interruption: results in the output file are kept")
      ->needs(output);
  command
      ->add_option("--certificates", arguments->certificates,
                   "Folder for a proof of each verdict, line-N.json")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->node_limit);
  add_threads_option(
      *command, arguments->threads,
      "Grasps decided at a time; 0 is one a core. The results do not depend on it");
  command->footer(footer_text(
      "Each line gives one line of JSON: line, key (of the question), name and verdict, or\n"
      "the error that it has; the rest goes on. Certificates are checked with the line as\n"
      "grasp file. The node limit holds for each grasp. Memory does not grow with the file.\n"
      "An interruption (Ctrl-C, SIGTERM, SIGHUP) ends the program by that signal, between two\n"
      "lines: FILE then ends in a whole line, and the same command with --resume goes on.\n",
      "0 done, 2 some lines were unreadable (or bad usage), 3 some undecided\n"
      "within the limit",
      "stickslip batch grasps.jsonl -o verdicts.jsonl --resume"));
  command->callback([arguments, &exit_code] { exit_code = Batch(*arguments).run(); });
}

}  // namespace stickslip
