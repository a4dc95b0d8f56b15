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
#include <functional>
#include <future>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "interruption.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/line.hpp"
#include "stickslip/interfaces/results.hpp"
#include "stickslip/interfaces/shard.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct BatchArguments {
  QuestionArguments question;
  std::string file;
  std::string output = "-";
  std::string certificates;
  std::string shard;
  std::vector<std::string> shards_to_merge;
  bool resume = false;
  bool asks_class = false;
  std::string inertia;
  bool asks_quality = false;
  QualityText quality;
  bool asks_states = false;
  StateSetArguments states;
  bool asks_measures = false;
  ComparisonText measures;  ///< but for what other questions have as well
  std::size_t node_limit = 0;
  std::string time_limit;
  int threads = 0;
};

struct Item {
  BatchLine line;
  LineResult result;
};

BatchOptions batch_options(const BatchArguments& arguments) {
  std::optional<RationalRow> inertia;
  if (arguments.asks_class) inertia = inertia_numbers("--inertia", arguments.inertia);
  std::optional<QualityAsked> quality;
  if (arguments.asks_quality) quality = quality_asked(arguments.quality);
  std::optional<StatesAsked> states;
  if (arguments.asks_states) states = arguments.states.asked();
  std::optional<ComparisonAsked> measures;
  if (arguments.asks_measures) {
    ComparisonText text = arguments.measures;
    text.length = arguments.quality.length;
    text.inertia = arguments.inertia;
    text.accuracy = arguments.quality.accuracy;
    measures = comparison_asked(text);
  }
  return {
      arguments.question.options(), arguments.node_limit,  inertia, quality, states, measures,
      arguments.certificates,       arguments.certificates};
}

/// Throws InputError if an option is given, and none of the questions that depend on it.
void require_asked(const CommandOption& option, const std::vector<CommandOption*>& questions) {
  std::string names;
  for (const CommandOption* question : questions) {
    if (question->is_given()) return;
    names += (names.empty() ? "--" : " or --") + question->long_names().front();
  }
  if (!option.is_given()) return;
  throw InputError("", "--" + option.long_names().front(), "no answer depends on it",
                   "ask for " + names);
}

/// Reports on standard error whether lines were unreadable. Returns the exit code: some were
/// unreadable, some undecided, or all is well.
int finish(const BatchTally& tally, const std::string& file) {
  const std::string complaint = tally.complaint(file);
  if (!complaint.empty()) std::cerr << "stickslip: " << complaint << '\n';
  if (tally.unreadable > 0) return kBadInput;
  return tally.undecided > 0 ? kUndecidedWithinLimit : kDone;
}

/// Returns the error about an output file that has something in it.
InputError file_exists(const std::string& path, const std::string& remedy) {
  return {path, "--output", "the file exists", remedy};
}

bool has_content(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) &&
         std::filesystem::file_size(path, ignored) > 0;
}

class Batch {
 public:
  explicit Batch(const BatchArguments& arguments)
      : arguments_(arguments), decider_(batch_options(arguments)) {
    const auto size = std::filesystem::file_size(arguments_.file, ignored_);
    if (!ignored_) bytes_ = size;
    if (!arguments_.shard.empty()) take_shard();
    if (arguments_.output != "-") open_output();
    if (!arguments_.certificates.empty()) {
      open_certificate_folder(arguments_.certificates, arguments_.resume);
    }
  }

  int run() {
    to_file_ = writes_to_file();
    if (!head_.empty()) write(head_, 0);
    using oneapi::tbb::global_control;
    std::optional<global_control> allowed;  // there may be more threads than cores, without a
                                            // warning
    if (arguments_.threads > 0) {
      allowed.emplace(global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(arguments_.threads));
    }
    oneapi::tbb::task_arena arena(arguments_.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                          : arguments_.threads);
    // The number of lines held at a time does not depend on the length of the file.
    const auto lines_held = 4 * static_cast<std::size_t>(arena.max_concurrency());
    using oneapi::tbb::filter_mode;
    using oneapi::tbb::make_filter;
    const auto decide_all = [&] {
      oneapi::tbb::parallel_pipeline(
          lines_held,
          make_filter<void, Item>(filter_mode::serial_in_order,
                                  [&](oneapi::tbb::flow_control& flow) { return read(flow); }) &
              make_filter<Item, Item>(filter_mode::parallel,
                                      [&](Item item) {
                                        const SharedCancellation shared(cancellation_);
                                        throw_if_cancelled();
                                        item.result = decider_.decide(item.line);
                                        item.line.text.clear();
                                        return item;
                                      }) &
              make_filter<Item, void>(filter_mode::serial_in_order,
                                      [&](const Item& item) { write(item.result); }));
    };
    const bool is_done = run_within_limit([&] { arena.execute(decide_all); });
    progress_.reset();  // its line on the terminal goes
    BatchTally all = before_;
    all.add(tally_);
    if (!is_done) {
      std::cerr << "stickslip: ended by " << limit_.in_words() << " " << kept_text() << "\n";
      if (all.results > 0) finish(all, input_.name());
      return kUndecidedWithinLimit;
    }
    if (all.results == 0 && shard_) return kDone;  // the file is short
    return finish(all, input_.name());
  }

 private:
  /// Does the work; returns false if the time limit ended it. Only this thread may ask for the
  /// time. While it decided a line it would not ask, so another does all.
  bool run_within_limit(const std::function<void()>& all) {
    if (!limit_.seconds()) {
      all();
      return true;
    }
    return limit_.finishes([&] {
      cancellation_ = Cancellation::current();
      std::future<void> done = std::async(std::launch::async, all);
      constexpr std::chrono::milliseconds kPause{50};
      try {
        while (done.wait_for(kPause) == std::future_status::timeout) cancellation_->check();
      } catch (const Cancelled&) {
        // The other threads see it too, and throw.
      }
      done.get();
    });
  }

  void open_output() {
    const std::string& path = arguments_.output;
    require_unprotected(path);
    if (has_content(path)) {
      if (!arguments_.resume) {
        throw file_exists(path, "go on with --resume, or name another file");
      }
      keep_finished();
    }
    errno = 0;
    output_file_.open(path, std::ios::binary | std::ios::app);
    if (!output_file_) throw cannot_write(path, errno);
    protect_file(path, "output");
    out_ = &output_file_;
  }

  /// Takes the lines of the shard from now on; its head is to be written first.
  void take_shard() {
    if (bytes_ == 0 && !std::filesystem::is_regular_file(arguments_.file, ignored_)) {
      throw InputError(input_.name(), "--shard", "this is not a file of a known length",
                       "name a file; what comes through a pipe can be written to one first");
    }
    const MeasuredShard measured =
        measure_shard(input_.stream(), bytes_, shard_option(arguments_.shard), decider_);
    shard_ = measured.head.shard;
    head_ = head_text(measured.head);
    bytes_read_ = bytes_skipped_ = measured.part.begin;
    bytes_ = measured.part.end;
    lines_.emplace(input_.stream(), measured.part);
  }

  /// Keeps the results of the same questions, which need not be decided again. Cuts off a line
  /// that an interruption left unfinished.
  void keep_finished() {
    std::ifstream before(arguments_.output, std::ios::binary);
    std::uintmax_t head_bytes = 0;
    if (shard_) {
      const std::optional<ShardHead> head = read_head(before, arguments_.output);
      if (head && head_text(*head) != head_) {
        throw InputError(
            arguments_.output, "line 1",
            "this is not the head of shard " + to_string(*shard_) + " of " + arguments_.file +
                " under these options",
            "resume with the same shard, grasps and options, or name another file");
      }
      if (head) head_bytes = std::exchange(head_, "").size();
    }
    FinishedResults finished(before, arguments_.output, head_bytes > 0 ? 1 : 0, head_bytes);
    before_ = skip_finished(finished, arguments_.output, *lines_, arguments_.file, decider_);
    const std::string note = changed_note(finished, arguments_.output);
    if (!note.empty()) std::cerr << "stickslip: " << note << "\n";
    std::error_code error;
    std::filesystem::resize_file(arguments_.output, finished.bytes(), error);
    if (error) throw cannot_write(arguments_.output, error.value());
    bytes_read_ = bytes_skipped_ = lines_->end();
  }

  /// Returns true if results go to a file, which is to end in a whole line whatever happens. A
  /// pipe may never be read, so an interruption does not wait for it.
  bool writes_to_file() const {
    struct stat out {};
    const int found = out_ == &std::cout ? ::fstat(STDOUT_FILENO, &out)
                                         : ::stat(arguments_.output.c_str(), &out);
    return found == 0 && S_ISREG(out.st_mode);
  }

  Item read(oneapi::tbb::flow_control& flow) {
    std::optional<BatchLine> line = lines_->next();
    bytes_read_ = lines_->end();
    if (line) return {std::move(*line), {}};
    flow.stop();
    return {};
  }

  void write(const LineResult& result) {
    write(result.text, 1);
    tally_.count(result.number, result.outcome);
    progress_->show(progress_text());
  }

  /// Writes results. An interruption finds the results in the file and their number, or
  /// neither.
  void write(const std::string& text, std::size_t results) {
    std::optional<FileWrite> whole_line;
    if (to_file_) whole_line.emplace();
    errno = 0;
    *out_ << text << std::flush;
    if (!*out_ && errno == EPIPE && on_broken_pipe_ == SIG_DFL) end_by_signal(SIGPIPE);
    if (!*out_) {
      throw cannot_write(arguments_.output == "-" ? "<stdout>" : arguments_.output, errno);
    }
    written_ += results;
  }

  std::string interruption_text() const { return "stickslip: interrupted " + kept_text(); }

  /// Says what is kept of work that was ended before the last line.
  std::string kept_text() const {
    if (arguments_.output == "-") {
      return "with " + std::to_string(written_) +
             " results; had they gone to --output FILE, --resume would go on from there";
    }
    return "with " + std::to_string(before_.results + written_) + " results in " +
           arguments_.output + "; go on with the same command" +
           (arguments_.file == "-" ? ", the same input" : "") + " and --resume";
  }

  std::string progress_text() const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double rate = static_cast<double>(written_) / std::max(seconds, 1e-3);
    std::string text =
        std::to_string(written_) + " grasps, " + std::to_string(std::lround(rate)) + "/s";
    if (tally_.unreadable > 0) text += ", " + std::to_string(tally_.unreadable) + " unreadable";
    const std::uintmax_t read_now = bytes_read_;
    if (read_now > bytes_skipped_ && read_now <= bytes_) {
      const double share = static_cast<double>(bytes_ - read_now) /
                           static_cast<double>(read_now - bytes_skipped_);
      text += ", about " + std::to_string(std::lround(seconds * share)) + " s left";
    }
    return text;
  }

  const BatchArguments& arguments_;
  LineDecider decider_;
  TimeLimit limit_ = time_limit_option(arguments_.time_limit);
  Cancellation* cancellation_ = nullptr;  ///< ends the work at the limit
  std::error_code ignored_;
  InputFile input_{arguments_.file, "a file of grasps, one a line"};
  std::ofstream output_file_;
  std::ostream* out_ = &std::cout;
  std::optional<BatchLines> lines_{std::in_place, input_.stream()};
  std::optional<Shard> shard_;
  std::string head_;          ///< the head of the shard, if it is still to be written
  std::uintmax_t bytes_ = 0;  ///< the bytes of the input, if known; up to the end of the shard
  std::atomic<std::uintmax_t> bytes_read_{0};
  std::uintmax_t bytes_skipped_ = 0;  ///< the bytes that had results already
  bool to_file_ = false;
  BatchTally before_;  ///< the results that were there
  BatchTally tally_;   ///< the results written
  std::atomic<std::size_t> written_{0};
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<Progress> progress_{std::in_place};
  /// SIGPIPE by default would end the program, and leave a certificate half-written, as soon as
  // the reader of the results ends.
  void (*on_broken_pipe_)(int) = std::signal(SIGPIPE, SIG_IGN);
  InterruptionMessage interruption_{[this] { return interruption_text(); }};
};

/// Writes the results of shards, one after the other.
int merge(const std::vector<std::string>& files, const std::string& output) {
  if (output != "-" && has_content(output)) {
    throw file_exists(output, "name another file");
  }
  const CompleteShards all = complete_shards(files);
  std::ofstream file;
  if (output != "-") {
    require_unprotected(output);
    errno = 0;
    file.open(output, std::ios::binary);
    if (!file) throw cannot_write(output, errno);
  }
  std::ostream& out = output == "-" ? std::cout : file;
  for (const CompleteShard& shard : all.shards) {
    InputFile in(shard.file, "a shard's file of results");
    in.stream().seekg(static_cast<std::streamoff>(shard.begin));
    std::vector<char> block(std::size_t{1} << 20);
    for (std::uintmax_t left = shard.end - shard.begin; left > 0 && out;) {
      in.stream().read(block.data(), static_cast<std::streamsize>(
                                         std::min<std::uintmax_t>(left, block.size())));
      const std::streamsize count = in.stream().gcount();
      if (count == 0) {
        throw InputError(shard.file, "", "the file has become shorter", "merge again");
      }
      errno = 0;
      out.write(block.data(), count);
      left -= static_cast<std::uintmax_t>(count);
    }
  }
  out.flush();
  if (!out) throw cannot_write(output == "-" ? "<stdout>" : output, errno);
  return finish(all.tally, output == "-" ? "<stdout>" : output);
}

}  // namespace

void add_batch_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<BatchArguments>();
  Command* command = app.add_subcommand(
      "batch", "Decide many grasps in parallel, one a line; results in the same order");
  command
      ->add_option("GRASPS", arguments->file,
                   "JSON Lines, a grasp (docs/grasp_file.md) on each line; - is standard input")
      ->type_name("FILE");
  arguments->question.add_options_to(*command);
  CommandOption* output =
      command
          ->add_option("--output,-o", arguments->output,
                       "File for the results, which is added to as they come; - is standard "
                       "output")
          ->type_name("FILE")
          ->capture_default_str();
  CommandOption* resume =
      command
          ->add_flag("--resume", arguments->resume,
                     "Go on after an interruption: results in the output file are kept")
          ->needs(output);
  command
      ->add_option("--certificates", arguments->certificates,
                   "Folder for a proof of each verdict, line-N.json")
      ->type_name("DIR");
  CommandOption* asks_class = command->add_flag(
      "--class", arguments->asks_class,
      "Ask not for the verdict but for the class of rigid contacts, as compare "
      "does: must move, must hold or open");
  CommandOption* inertia =
      command
          ->add_option("--inertia", arguments->inertia,
                       "Of the objects, for --class and --measures: the centre of mass and the "
                       "squared radius of gyration about it; default: 0,0,1, or of --measures "
                       "0,0 and the square of the length. Of grasps in space "
                       "X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ], as of compare; default: 0,0,0,1,1,1, or "
                       "that square thrice")
          ->type_name("INERTIA");
  CommandOption* asks_quality =
      command
          ->add_flag("--quality", arguments->asks_quality,
                     "Ask also for the quality of each grasp that is stable, as quality does: "
                     "how large a ball of loads does it resist? The certificate is then that "
                     "of the ball")
          ->excludes(asks_class);
  add_ball_options(*command, arguments->quality);
  for (const char* option : {"--about", "--body", "--at-most"}) {
    command->get_option(option)->needs(asks_quality);
  }
  CommandOption* length = command->get_option("--length");
  CommandOption* accuracy =
      command->get_option("--accuracy")
          ->description(
              "Stop when what is proved and what is refuted differ by this part of it, or with "
              "--measures the bounds of the two robustnesses");
  CommandOption* asks_states = command->add_flag(
      "--states", arguments->asks_states,
      "Ask not for the verdict but how many slip states or contact modes there are of each "
      "dimension, as states does");
  for (CommandOption* option : add_state_set_options(*command, arguments->states)) {
    option->needs(asks_states);
  }
  for (const char* other : {"--class", "--quality", "--certificates", "--wrench", "--case",
                            "--preload", "--normal-law"}) {
    asks_states->excludes(command->get_option(other));
  }
  CommandOption* asks_measures = command->add_flag(
      "--measures", arguments->asks_measures,
      "Ask not for the verdict but what other methods and measures say, as compare does: its "
      "rows, with its --length, --inertia and --accuracy");
  for (CommandOption* option : add_method_options(*command, arguments->measures)) {
    option->needs(asks_measures);
  }
  for (const char* other : {"--class", "--quality", "--states", "--certificates"}) {
    asks_measures->excludes(command->get_option(other));
  }
  CommandOption* shard =
      command
          ->add_option("--shard", arguments->shard,
                       "Decide only the I-th of N parts of the file, as on one of N machines; "
                       "--merge puts the results together (docs/batch.md)")
          ->type_name("I/N");
  command
      ->add_option("--merge", arguments->shards_to_merge,
                   "The files of all N shards: write the results of the whole, the same as "
                   "without shards")
      ->type_name("FILE")
      ->excludes(resume)
      ->excludes(shard);
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(
      *command, arguments->time_limit,
      "End after so many seconds, between two lines; --resume goes on. 0 is no "
      "limit");
  add_threads_option(
      *command, arguments->threads,
      "Grasps decided at a time; 0 is one a core. The results do not depend on it");
  command->footer(footer_text(
      "Each line gives one line of JSON: line, key (of the question), name and verdict, or\n"
      "the error that it has; the rest goes on. Certificates are checked with the line as\n"
      "grasp file, that of a ball of loads with the result's uncertain as --uncertain. The\n"
      "node limit holds for each grasp, with --measures for each of the two robustnesses.\n"
      "With --states by_dimension stands in place of the verdict, of the first states alone\n"
      "if there is a limit, too; with --measures methods, as compare --json prints it. Memory\n"
      "does not grow with the file. An interruption (Ctrl-C, SIGTERM, SIGHUP) ends the\n"
      "program by that signal, between two lines: FILE then ends in a whole line, and the\n"
      "same command with --resume goes on.\n"
      "On many machines: docs/batch.md.\n",
      "0 done, 2 some lines were unreadable (or bad usage), 3 some undecided\n"
      "within a limit, or ended by --time-limit",
      "stickslip batch grasps.jsonl -o verdicts.jsonl --resume"));
  command->callback([=, &exit_code] {
    require_asked(*inertia, {asks_class, asks_measures});
    require_asked(*length, {asks_quality, asks_measures});
    require_asked(*accuracy, {asks_quality, asks_measures});
    if (!arguments->shards_to_merge.empty()) {
      if (!arguments->file.empty()) {
        throw InputError("", "--merge", "there is " + quote(arguments->file) + " before it",
                         "name the shards' files after --merge, and nothing else");
      }
      exit_code = merge(arguments->shards_to_merge, arguments->output);
      return;
    }
    if (arguments->file.empty()) {
      throw InputError("", "GRASPS", "no file of grasps is named",
                       "name one, or - for standard input; or shards after --merge");
    }
    exit_code = Batch(*arguments).run();
  });
}

}  // namespace stickslip
