// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzz target without libFuzzer, with any compiler:
//   replay CORPUS ROUNDS [FILE ...]   every seed and file, then ROUNDS mutated seeds, the same
//                                     ones each time
//   replay CORPUS --seeds FOLDER      writes the seeds for libFuzzer
// When the program dies, the input at hand is left beside it, in the file <program>.crash. It
// dies, too, of an input of at most 10 kB that takes more than 10 s of the processor, or 1 GB:
// that is a hang. Sanitizers, which take many times as long and all addresses there are, do not
// measure that, and files named slow_* are not for them.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "fuzz_target.hpp"

namespace {

using stickslip::fuzz::Seed;

std::string crash_file;
const std::string* current_input = nullptr;

extern "C" void keep_input(int signal_number) {
  const int file = open(crash_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0 && current_input != nullptr) {
    if (write(file, current_input->data(), current_input->size()) < 0) _exit(1);
  }
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// SIGVTALRM comes after so many seconds of the processor; 0: not at all.
void set_alarm(int seconds) {
  const itimerval timer{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

void run(const std::string& input) {
  constexpr std::size_t kShort = 10'000;
  constexpr int kMostSeconds = 10;
  set_alarm(!kSanitized && input.size() <= kShort ? kMostSeconds : 0);
  current_input = &input;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

class Mutator {
 public:
  explicit Mutator(std::vector<Seed> seeds) : seeds_(std::move(seeds)) {}

  std::string next() {
    std::string text = any_seed();
    if (below(2) == 0) {
      for (std::size_t edits = 1 + below(2); edits > 0; --edits) edit_within_json(text);
    } else {
      for (std::size_t edits = 1 + below(4); edits > 0; --edits) edit(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }
  const std::string& any_seed() { return seeds_[below(seeds_.size())].bytes; }

  /// A piece of a text: a few bytes, a token, or a longer stretch.
  std::pair<std::size_t, std::size_t> piece(const std::string& text) {
    const std::size_t begin = below(text.size());
    if (below(2) == 0) {
      const std::size_t end = text.find_first_of(",:]}\n", begin);
      return {begin, std::min(end, text.size()) - begin};
    }
    return {begin, std::min(text.size() - begin, 1 + below(below(4) == 0 ? 200 : 4))};
  }

  /// A number somewhere behind a random place, with the quotation marks around it if there are.
  std::pair<std::size_t, std::size_t> number(const std::string& text) {
    std::size_t begin = text.find_first_of("-0123456789", below(text.size()));
    if (begin == std::string::npos) return {text.size(), 0};
    std::size_t end = std::min(text.find_first_not_of("-0123456789./", begin), text.size());
    if (begin > 0 && end < text.size() && text[begin - 1] == '"' && text[end] == '"') {
      --begin;
      ++end;
    }
    return {begin, end - begin};
  }

  /// So that the readers' rules are met behind the syntax: another number, or a line (a
  /// contact, a node, a force) twice or not at all.
  void edit_within_json(std::string& text) {
    const auto [begin, length] = number(text);
    if (below(4) == 0) {
      const std::size_t start = text.rfind('\n', begin) + 1;
      const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
      const std::string line = text.substr(start, end - start);
      text.replace(start, line.size(), below(2) == 0 ? line + line : "");
      return;
    }
    static const std::vector<std::string> kNumbers{"0", "1", "-1", "2",  "-3", "\"1/2\"",
                                                   "7", "3", "4",  "-2", "5",  "\"-5/3\""};
    const std::string& other = below(2) == 0 ? text : any_seed();
    const auto [from, count] = number(other);
    const std::string found = other.substr(from, count);
    text.replace(begin, length, below(2) == 0 ? kNumbers[below(kNumbers.size())] : found);
  }

  void edit(std::string& text) {
    static const std::vector<std::string> kTokens{"0",
                                                  "-1",
                                                  "9",
                                                  "\"1/3\"",
                                                  "\"-7/2\"",
                                                  "1e-3",
                                                  "NaN",
                                                  "\"",
                                                  "[",
                                                  "]",
                                                  "{",
                                                  "}",
                                                  ",",
                                                  ":",
                                                  "null",
                                                  "true",
                                                  "\\u0000",
                                                  "\\ud800",
                                                  "\xFF",
                                                  "\xEF\xBB\xBF",
                                                  "\n",
                                                  " ",
                                                  "1e4096",
                                                  "18446744073709551616",
                                                  "[[0,1]]",
                                                  "\"slip\"",
                                                  "\"separation\"",
                                                  "\"plane\"",
                                                  "\"leaf\"",
                                                  "\"void\"",
                                                  std::string(1, '\0'),
                                                  std::string(20, '9'),
                                                  "\"1/0\"",
                                                  "-0",
                                                  "/"};
    const auto [begin, length] = piece(text);
    switch (below(6)) {
      case 0:
        text.insert(begin, kTokens[below(kTokens.size())]);
        break;
      case 1:
        text.replace(begin, length, kTokens[below(kTokens.size())]);
        break;
      case 2:
        text.erase(begin, length);
        break;
      case 3:
        text.insert(below(text.size()), text.substr(begin, length));
        break;
      case 4: {
        const std::string& other = any_seed();
        const auto [from, count] = piece(other);
        text.replace(begin, length, other.substr(from, count));
        break;
      }
      default:
        if (!text.empty()) text[begin] = static_cast<char>(random_() & 0xFFU);
    }
  }

  std::vector<Seed> seeds_;
  std::mt19937_64 random_{20181};
};

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    std::cerr << "cannot read " << path << "\n";
    std::exit(2);
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2) {
    std::cerr << "usage: replay CORPUS ROUNDS [FILE ...] | replay CORPUS --seeds FOLDER\n";
    return 2;
  }
  const std::vector<Seed> seeds = stickslip::fuzz::seeds(words[0]);
  if (seeds.empty()) {
    std::cerr << "no seeds in " << words[0] << "\n";
    return 2;
  }
  if (words[1] == "--seeds" && words.size() == 3) {
    for (const Seed& seed : seeds) {
      std::string name = seed.name;
      std::replace(name.begin(), name.end(), '/', '_');
      std::ofstream(words[2] + "/" + name, std::ios::binary) << seed.bytes;
    }
    return 0;
  }
  crash_file = std::string(argv[0]) + ".crash";
  for (const int signal_number : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGVTALRM}) {
    std::signal(signal_number, keep_input);
  }
  if (!kSanitized) {
    constexpr rlim_t kMostMemory = 1'000'000'000;
    const rlimit memory{kMostMemory, kMostMemory};
    setrlimit(RLIMIT_AS, &memory);
  }
  for (const Seed& seed : seeds) run(seed.bytes);
  for (std::size_t i = 2; i < words.size(); ++i) {
    const bool is_slow = words[i].find("/slow_") != std::string::npos;
    if (!kSanitized || !is_slow) run(read(words[i]));
  }
  Mutator mutator(seeds);
  const unsigned long rounds = std::stoul(words[1]);
  for (unsigned long round = 0; round < rounds; ++round) run(mutator.next());
  std::cout << seeds.size() << " seeds and " << rounds << " mutants of them: no crash\n";
  return 0;
}
