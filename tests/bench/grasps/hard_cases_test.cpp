// SPDX-License-Identifier: GPL-3.0-or-later
// The worst grasps that were found, with the nodes that branch and bound needed
// (tests/corpus/hard/nodes.txt). Fewer is progress: lower the table then. Twice as many is a
// loss that somebody should look at.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip::bench {
namespace {

struct HardCase {
  std::string file;
  NormalLaw law = NormalLaw::kUnilateral;
  std::string verdict;
  std::size_t nodes = 0;
};

std::vector<HardCase> read_table() {
  std::ifstream in(std::string(STICKSLIP_HARD_CASES) + "/nodes.txt");
  std::vector<HardCase> cases;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    HardCase c;
    std::string law;
    fields >> c.file >> law >> c.verdict >> c.nodes;
    EXPECT_FALSE(fields.fail()) << line;
    c.law = law == "bilateral" ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    cases.push_back(std::move(c));
  }
  return cases;
}

std::string path_of(const HardCase& c) {
  return std::string(STICKSLIP_HARD_CASES) + '/' + c.file;
}

std::string checkers_answer(const HardCase& c, const std::string& proof) {
  std::ifstream grasp(path_of(c));
  std::istringstream certificate(proof);
  stickslip_check::Options options;
  options.bilateral = c.law == NormalLaw::kBilateral;
  const auto answer = stickslip_check::check(grasp, certificate, options);
  if (const auto* accepted = std::get_if<stickslip_check::Accepted>(&answer)) {
    return accepted->verdict;
  }
  if (const auto* rejected = std::get_if<stickslip_check::Rejected>(&answer)) {
    return "rejected: " + rejected->rule + ", " + rejected->found;
  }
  return "malformed";
}

TEST(HardCases, KeepTheirVerdictsAndNoMoreThanTwiceTheirNodes) {
  for (const HardCase& c : read_table()) {
    QuestionOptions options;
    options.law = c.law;
    const Question question = ask(read_grasp_file(path_of(c)), options);
    BranchWork work;
    SearchOptions limit;
    limit.node_limit = 2 * c.nodes + 1;
    const Verdict verdict =
        branch_and_bound(Problem(question.loaded(), question.law), limit, &work);
    ASSERT_EQ(name_of(verdict), c.verdict) << c.file << ": " << work.nodes << " nodes";
    EXPECT_LE(work.nodes, 2 * c.nodes) << c.file;
    RecordProperty(c.file, static_cast<int>(work.nodes));
    EXPECT_EQ(checkers_answer(c, certificate_text(question, verdict, "test")), c.verdict)
        << c.file;
  }
}

TEST(HardCases, TableAndFolderAgree) {
  std::set<std::string> in_table;
  for (const HardCase& c : read_table()) in_table.insert(c.file);
  std::set<std::string> in_folder;
  for (const auto& entry : std::filesystem::directory_iterator(STICKSLIP_HARD_CASES)) {
    if (entry.path().extension() == ".json") in_folder.insert(entry.path().filename().string());
  }
  EXPECT_EQ(in_table, in_folder);
  EXPECT_GE(in_table.size(), 8u);
}

}  // namespace
}  // namespace stickslip::bench
