// SPDX-License-Identifier: MIT
// Hand-written and searched certificates of the paper's grasps (Tables I and III) and of small
// random ones: accepted as they are, and not accepted after any of many mutations.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "support.hpp"

namespace stickslip_check {
namespace {

struct Case {
  std::string name;
  std::string grasp;
  std::string certificate;
  Options options;
};

/// The numbers of a member, if the text has it.
std::optional<Vector> vector_in(const std::string& text, const std::string& name) {
  const std::string member = '"' + name + "\": [";
  const std::size_t at = text.find(member);
  if (at == std::string::npos) return std::nullopt;
  std::istringstream in(text.substr(at + member.size()));
  Vector vector;
  for (char separator = ','; separator == ',';) {
    int number = 0;
    in >> number >> separator;
    vector.emplace_back(number);
  }
  return vector;
}

std::string intervals(const Accepted& accepted) {
  std::string text;
  for (const auto& [low, high] : accepted.resisted) {
    text += low.get_str() + " " + (high ? high->get_str() : "oo") + ";";
  }
  return text;
}

std::vector<Case> corpus_of(const char* folder) {
  std::vector<Case> cases;
  const std::string ending = ".grasp.json";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string path = entry.path();
    if (path.size() < ending.size() || path.substr(path.size() - ending.size()) != ending)
      continue;
    const std::string stem = path.substr(0, path.size() - ending.size());
    Case c{std::filesystem::path(stem).filename(),
           read_file(path),
           read_file(stem + ".certificate.json"),
           {}};
    c.options.bilateral = c.name.rfind("bilateral_", 0) == 0;
    const std::string question = c.certificate.substr(0, c.certificate.find("\"verdict\""));
    c.options.direction = vector_in(question, "direction");
    if (const auto growth = vector_in(question, "preload_direction")) {
      c.options.preload_direction = PreloadDirection{false, *growth};
    } else if (question.find("\"scale\"") != std::string::npos) {
      c.options.preload_direction = PreloadDirection{true, {}};
    }
    if (c.options.direction) c.options.wrench = vector_in(c.grasp, "wrench");
    cases.push_back(std::move(c));
  }
  std::sort(cases.begin(), cases.end(), [](auto& a, auto& b) { return a.name < b.name; });
  return cases;
}

std::vector<Case> corpus() {
  std::vector<Case> cases = corpus_of(CERTIFICATE_CORPUS);
  for (Case& c : corpus_of(SPACE_CORPUS)) cases.push_back(std::move(c));
  return cases;
}

TEST(Corpus, EverythingIsAccepted) {
  const std::vector<Case> cases = corpus();
  EXPECT_GE(cases.size(), 40U);
  for (const Case& c : cases) {
    const Answer answer = ask(c.grasp, c.certificate, c.options);
    ASSERT_EQ(outcome(answer), "accepted") << c.name << ": " << explain(answer);
    const auto& accepted = std::get<Accepted>(answer);
    const bool margin = c.options.margin();
    const bool unstable = c.name.find("unstable") != std::string::npos;
    EXPECT_EQ(accepted.verdict, margin ? "margin" : (unstable ? "unstable" : "stable"))
        << c.name;
    const bool has_tree = margin ? accepted.trees > 0 : unstable || accepted.parts > 0;
    EXPECT_EQ(accepted.nodes > 0, has_tree) << c.name;
  }
}

TEST(Corpus, CutAnywhereIsMalformed) {
  for (const Case& c : corpus()) {
    const std::size_t end = c.certificate.find_last_not_of(" \n");
    const std::size_t step = std::max<std::size_t>(1, end / 60);
    for (std::size_t length = 0; length <= end; length += step) {
      const Answer answer = ask(c.grasp, c.certificate.substr(0, length), c.options);
      EXPECT_EQ(outcome(answer), "malformed") << c.name << " cut at " << length;
    }
    EXPECT_EQ(outcome(ask(c.grasp, c.certificate + "x", c.options)), "malformed");
    EXPECT_EQ(outcome(ask(c.grasp, c.certificate + std::string("\0x", 2), c.options)),
              "malformed");
    EXPECT_EQ(outcome(ask(c.grasp, c.certificate + " \t\r\n", c.options)), "accepted");
    EXPECT_EQ(outcome(ask(c.grasp.substr(0, c.grasp.size() / 2), c.certificate, c.options)),
              "malformed");
  }
}

TEST(Corpus, SwappedGraspsAreRejected) {
  const std::vector<Case> cases = corpus();
  for (const Case& a : cases) {
    for (const Case& b : cases) {
      if (a.grasp == b.grasp) continue;
      const Answer answer = ask(a.grasp, b.certificate, a.options);
      // Another grasp can share the proof's question member and even its proof; then the
      // verdict is as good as its own. Never a contradiction:
      if (outcome(answer) != "accepted") continue;
      const auto& accepted = std::get<Accepted>(answer);
      const Accepted own = std::get<Accepted>(ask(a.grasp, a.certificate, a.options));
      EXPECT_EQ(accepted.verdict, own.verdict) << a.name << " with the proof of " << b.name;
      EXPECT_EQ(intervals(accepted), intervals(own)) << a.name << ", proof of " << b.name;
    }
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(Corpus, DroppedOrDoubledNodesAreRejected) {
  for (const Case& c : corpus()) {
    const std::vector<std::string> lines = lines_of(c.certificate);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      if (lines[i].rfind("  [\"", 0) != 0) continue;
      std::vector<std::string> shorter = lines;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
      const Answer without = ask(c.grasp, joined(shorter), c.options);
      EXPECT_TRUE(std::holds_alternative<Rejected>(without)) << c.name << " line " << i;
      std::vector<std::string> longer = lines;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
      const Answer twice = ask(c.grasp, joined(longer), c.options);
      EXPECT_TRUE(std::holds_alternative<Rejected>(twice)) << c.name << " line " << i;
    }
  }
}

// Whatever a mutation does to a proof of instability, it must not be accepted for a stable
// grasp.
TEST(Corpus, MutatedProofsNeverRefuteStableGrasps) {
  Random random(31337);
  for (const Case& c : corpus()) {
    if (c.name.find("unstable") == std::string::npos) continue;
    const std::vector<std::string> lines = lines_of(c.certificate);
    if (lines.size() < 7) continue;
    const bool fig1 = c.grasp.find("\"fig1\"") != std::string::npos;
    const bool fig4 = c.grasp.find("\"fig4\"") != std::string::npos;
    if (!fig1 && !fig4) continue;
    // The nearest stable questions about the same contacts: thresholds are 1 (Fig. 1, P = 1),
    // 2 (Fig. 4, P = 1).
    const std::string wrench = fig1 ? "0, 1, 0" : "0, 2, 0";
    const std::string grasp =
        fig1 ? stickslip_check::fig1("1", wrench) : stickslip_check::fig4("1", wrench);
    for (int trial = 0; trial < 60; ++trial) {
      std::vector<std::string> mutated = lines;
      mutated[1] = " \"question\": {\"contacts\": " + std::string(fig1 ? "3" : "4") +
                   ", \"wrench\": [" + wrench + "], \"normal_law\": \"unilateral\"},";
      for (int k = between(random, 0, 3); k > 0; --k) {
        std::string& line = mutated[static_cast<std::size_t>(
            between(random, 4, static_cast<int>(lines.size()) - 1))];
        for (char& ch : line) {
          if (ch >= '0' && ch <= '3' && between(random, 0, 2) == 0) {
            ch = static_cast<char>('0' + between(random, 0, 3));
          }
        }
      }
      EXPECT_NE(outcome(ask(grasp, joined(mutated))), "accepted") << c.name << "\n"
                                                                  << joined(mutated);
    }
  }
}

}  // namespace
}  // namespace stickslip_check
