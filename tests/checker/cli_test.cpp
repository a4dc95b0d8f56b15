// SPDX-License-Identifier: MIT
// The program stickslip-check itself: arguments, exit codes, streams.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "support.hpp"

namespace stickslip_check {
namespace {

struct Result {
  int code;
  std::string out;
};

/// Runs the program; `arguments` goes through the shell and may redirect.
Result run(const std::string& arguments) {
  const std::string command =
      std::string("cd " CERTIFICATE_CORPUS " && " STICKSLIP_CHECK " ") + arguments;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("popen");
  Result result;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    result.out.append(buffer, n);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

const std::string kPair = "fig1_up_p0_unstable.grasp.json fig1_up_p0_unstable.certificate.json";

TEST(Cli, Accepted) {
  const Result r = run(kPair);
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(
      r.out.rfind("accepted\nverdict     unstable\ncontacts    3\nwrench      (0, 1, 0)\n", 0),
      0U)
      << r.out;
  EXPECT_NE(r.out.find("38 nodes"), std::string::npos) << r.out;
}

TEST(Cli, StandardInput) {
  EXPECT_EQ(run("fig1_up_p0_unstable.grasp.json - < fig1_up_p0_unstable.certificate.json").code,
            0);
  EXPECT_EQ(run("- fig1_up_p0_unstable.certificate.json < fig1_up_p0_unstable.grasp.json").code,
            0);
  EXPECT_EQ(run("- - < fig1_up_p0_unstable.grasp.json 2>&1").code, 2);
}

TEST(Cli, Rejected) {
  const Result r = run(kPair + " --wrench 0,2,0");
  EXPECT_EQ(r.code, 1);
  EXPECT_EQ(r.out.rfind("rejected\nrule   question-wrench\n", 0), 0U) << r.out;
  EXPECT_EQ(run(kPair + " --wrench=0,2/2,-0.0").code, 0);
  EXPECT_EQ(run(kPair + " --preload 1").code, 1);
  EXPECT_EQ(run(kPair + " --normal-law bilateral").code, 1);
  EXPECT_EQ(run(kPair + " --normal-law=unilateral --snap-normals 1e-3").code, 0);
  const Result tree =
      run("fig1_up_p1_stable.grasp.json - < fig1_up_p0_unstable.certificate.json");
  EXPECT_EQ(tree.code, 1);
  EXPECT_NE(tree.out.find("rule   leaf-bound\nnode   "), std::string::npos) << tree.out;
  EXPECT_NE(tree.out.find("\npath   slip 0 +, "), std::string::npos) << tree.out;
}

TEST(Cli, ErrorsGoToStandardError) {
  for (const char* arguments :
       {"", "one", "one two three", "no_such_file.json no_such_file.json", "--what a b",
        "-x a b", "a b --wrench", "a b --wrench 1,2", "a b --wrench 1,2,x",
        "a b --wrench 1,2,3,4", "a b --preload -1", "a b --preload nan",
        "a b --normal-law both", "a b --snap-normals 0", "a b --snap-normals 1",
        "a b --json=yes", ". ."}) {
    const Result silent = run(std::string(arguments) + " 2>/dev/null");
    EXPECT_EQ(silent.code, 2) << arguments;
    EXPECT_EQ(silent.out, "") << arguments;
    const Result loud = run(std::string(arguments) + " 2>&1 >/dev/null");
    EXPECT_EQ(loud.out.rfind("stickslip-check: ", 0), 0U) << loud.out;
  }
}

TEST(Cli, Help) {
  const Result r = run("--help");
  EXPECT_EQ(r.code, 0);
  for (const char* word : {"--wrench", "--preload", "--normal-law", "--snap-normals", "--json",
                           "accepted", "rejected", "Example"}) {
    EXPECT_NE(r.out.find(word), std::string::npos) << word;
  }
}

TEST(Cli, Json) {
  const auto parse = [](const Result& r) { return nlohmann::json::parse(r.out); };
  const nlohmann::json good = parse(run(kPair + " --json"));
  EXPECT_EQ(good["result"], "accepted");
  EXPECT_EQ(good["verdict"], "unstable");
  EXPECT_EQ(good["nodes"], 38);
  EXPECT_EQ(good["question"]["wrench"][1], "1");
  EXPECT_TRUE(good["rule"].is_null());
  const nlohmann::json bad =
      parse(run("fig1_up_p1_stable.grasp.json fig1_up_p0_unstable.certificate.json --json"));
  EXPECT_EQ(bad["result"], "rejected");
  EXPECT_EQ(bad["rule"], "leaf-bound");
  EXPECT_TRUE(bad["node"].is_number());
  EXPECT_TRUE(bad["verdict"].is_null());
  const Result broken = run("fig1_up_p1_stable.grasp.json /dev/null --json 2>/dev/null");
  EXPECT_EQ(broken.code, 2);
  EXPECT_EQ(parse(broken)["result"], "malformed");
}

TEST(Cli, AnAnswerThatCannotBeWrittenIsNone) {
  EXPECT_EQ(run(kPair + " > /dev/full 2>/dev/null").code, 2);
}

}  // namespace
}  // namespace stickslip_check
