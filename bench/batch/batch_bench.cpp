// SPDX-License-Identifier: GPL-3.0-or-later
// Throughput of `stickslip batch`: verdicts a second for one thread and for all, against a loop
// in this process that reads, decides and writes nothing else; and the memory that it takes as
// files grow. Exit code 1 if a run fails or misses a line.
//
//     batch_bench PROGRAM [--lines N] [--most-lines N]
//     batch_bench PROGRAM --write FILE --contacts M --lines N
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "arguments.hpp"
#include "grasps.hpp"
#include "limited.hpp"
#include "loads.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A grasp file on one line.
std::string one_line(const LoadedGrasp& content) {
  std::string text = write_grasp(content);
  text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool is_stable(const Question& question) {
  return std::holds_alternative<Stable>(
      branch_and_bound(Problem(question.loaded(), question.law), {}));
}

/// Instances of all families, stable and unstable by turns.
std::vector<std::string> make_lines(std::size_t contacts, std::size_t count) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t family = k / 2 % std::min(kStableFamilies, kUnstableFamilies);
    const Instance instance = k % 2 == 0 ? make_stable(family, contacts, k)
                                         : make_unstable(family, contacts, k, is_stable);
    lines.push_back(one_line(instance.question.loaded()));
  }
  return lines;
}

void write_lines(const std::string& path, const std::vector<std::string>& lines,
                 std::size_t count) {
  std::ofstream file(path, std::ios::binary);
  for (std::size_t k = 0; k < count; ++k) file << lines[k % lines.size()] << '\n';
  if (!file) throw std::runtime_error("cannot write " + path);
}

std::size_t lines_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>(file), {}, '\n'));
}

class BatchBench {
 public:
  explicit BatchBench(std::string program) : program_(std::move(program)) {
    std::string pattern = (fs::temp_directory_path() / "stickslip-batch-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~BatchBench() { fs::remove_all(folder_, ignored_); }
  BatchBench(const BatchBench&) = delete;
  BatchBench& operator=(const BatchBench&) = delete;

  void throughput(std::size_t contacts, std::size_t count) {
    const std::vector<std::string> lines = make_lines(contacts, count);
    write_lines(input(), lines, count);
    std::size_t stable = 0;
    const auto start = Clock::now();
    for (const std::string& line : lines) {
      stable += is_stable(ask(parse_grasp(line, ""), {})) ? 1 : 0;
    }
    const double loop = seconds_since(start);
    if (stable == 0 || stable == count) throw std::runtime_error("all verdicts are the same");
    const double one = batch(count, "1").seconds;
    const double all = batch(count, "0").seconds;
    const double resumed = resume(count).seconds;
    const double proved = batch(count, "0", true).seconds;
    const auto rate = [&](double seconds) { return static_cast<double>(count) / seconds; };
    std::printf("| %zu | %zu | %.0f | %.0f | %.0f | %.2f | %.0f | %.0f |\n", contacts, count,
                rate(loop), rate(one), rate(all), rate(all) / rate(loop), rate(proved),
                rate(resumed));
    std::fflush(stdout);
  }

  void memory(std::size_t most) {
    const std::vector<std::string> lines = make_lines(4, 1000);
    for (std::size_t count = most >= 10000 ? most / 100 : most; count <= most; count *= 10) {
      write_lines(input(), lines, count);
      const ProgramRun run = batch(count, "0");
      const ProgramRun resumed = resume(count);
      std::printf("| %zu | %.0f | %.1f | %.1f |\n", count,
                  static_cast<double>(count) / run.seconds, megabytes(run), megabytes(resumed));
      std::fflush(stdout);
    }
  }

 private:
  std::string input() const { return folder_ / "grasps.jsonl"; }
  std::string output() const { return folder_ / "verdicts.jsonl"; }

  ProgramRun batch(std::size_t count, const std::string& threads, bool proofs = false) const {
    fs::remove(output());
    std::vector<std::string> words{program_, "batch",     input(), "--output",
                                   output(), "--threads", threads};
    if (proofs) words.insert(words.end(), {"--certificates", folder_ / "proofs"});
    return checked(words, count);
  }

  /// Of a batch that is finished already.
  ProgramRun resume(std::size_t count) const {
    return checked({program_, "batch", input(), "--output", output(), "--resume"}, count);
  }

  ProgramRun checked(const std::vector<std::string>& words, std::size_t count) const {
    constexpr double kLimitSeconds = 3600;
    ProgramRun run = run_program(kLimitSeconds, words);
    if (!run.output || run.status != 0) throw std::runtime_error(program_ + " failed");
    if (lines_in(output()) != count) throw std::runtime_error("a line has no result");
    return run;
  }

  static double megabytes(const ProgramRun& run) {
    return static_cast<double>(run.peak_bytes) / (1 << 20);
  }

  std::string program_;
  fs::path folder_;
  std::error_code ignored_;
};

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Arguments arguments("batch_bench",
                                        "Throughput and memory of stickslip batch");
  stickslip::Command& app = arguments.described();
  std::string program;
  std::size_t lines = 2000;
  std::size_t most_lines = 1000000;
  app.add_option("PROGRAM", program, "stickslip")->required();
  app.add_option("--lines", lines, "Lines a file at m = 4; fewer for more contacts")
      ->capture_default_str();
  app.add_option("--most-lines", most_lines, "Longest file that memory is measured on")
      ->capture_default_str();
  std::string write;
  std::size_t contacts = 4;
  app.add_option("--write", write, "Only write such lines to this file, for cluster_bench.py");
  app.add_option("--contacts", contacts, "Of the lines that are only written")
      ->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  try {
    if (!write.empty()) {
      stickslip::bench::write_lines(write, stickslip::bench::make_lines(contacts, lines),
                                    lines);
      return 0;
    }
    stickslip::bench::BatchBench bench(program);
    std::printf("%u cores\n\n", std::thread::hardware_concurrency());
    std::puts(
        "| m | lines | loop, 1/s | one thread, 1/s | all, 1/s | all / loop | with "
        "certificates, 1/s | resumed, 1/s |");
    std::puts("|--:|--:|--:|--:|--:|--:|--:|--:|");
    bench.throughput(4, lines);
    bench.throughput(10, lines);
    bench.throughput(100, std::max<std::size_t>(lines / 4, 2));
    bench.throughput(1000, std::max<std::size_t>(lines / 50, 2));
    std::puts("\n| lines of 4 contacts | 1/s | MB | resumed, MB |");
    std::puts("|--:|--:|--:|--:|");
    bench.memory(most_lines);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "batch_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
