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

/// Runs the program; all goes through the shell: `arguments` may redirect, and what comes
/// `before` may pipe.
Result run(const std::string& arguments, const std::string& before = "") {
  const std::string command =
      "cd " CERTIFICATE_CORPUS " && " + before + STICKSLIP_CHECK " " + arguments;
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
        "a b --json=yes", ". .", "a b --direction 0,1", "a b --direction 0,0,0/1"}) {
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
  for (const char* word :
       {"--wrench", "--direction", "stickslip-margin/1", "--preload", "--normal-law",
        "--snap-normals", "--json", "accepted", "rejected", "Example"}) {
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

const std::string kMargin =
    "margin_fig4_two_intervals.grasp.json margin_fig4_two_intervals.certificate.json "
    "--wrench -3,1,0";

TEST(Cli, Margin) {
  const Result r = run(kMargin + " --direction 1,0,0");
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out,
            "accepted\n"
            "resisted    [0, 1], [5, oo)\n"
            "contacts    4\n"
            "wrench      (-3, 1, 0)\n"
            "direction   (1, 0, 0)\n"
            "preload     as in the grasp file\n"
            "normal law  unilateral\n"
            "normals     as in the grasp file\n"
            "proof       segments: 2; trees: 1, of 7 nodes: 4 leaves, 0 voids\n");
  const Result never =
      run("margin_no_contact_never.grasp.json margin_no_contact_never.certificate.json "
          "--wrench 0,0,1 --direction=1,0,0");
  EXPECT_EQ(never.out.rfind("accepted\nresisted    no multiple\n", 0), 0U) << never.out;
  EXPECT_EQ(run(kMargin + " --direction 2,0,0").out.rfind("rejected\nrule   question-dir", 0),
            0U);
  // Without --wrench the margin starts from 0, whatever the wrench in the file.
  EXPECT_NE(run("margin_fig4_two_intervals.grasp.json "
                "margin_fig4_two_intervals.certificate.json --direction 1,0,0")
                .out.find("question-wrench"),
            std::string::npos);
}

TEST(Cli, MarginSaysWhere) {
  // The same forces where the springs are loaded by twice as much.
  const std::string grasp = "sed 's/\"preload\": 1/\"preload\": 2/' margin_fig1_up.grasp.json";
  const Result r =
      run("- margin_fig1_up.certificate.json --direction 0,1,0 --json", grasp + " | ");
  const nlohmann::json answer = nlohmann::json::parse(r.out);
  EXPECT_EQ(answer["rule"], "witness-normal");
  EXPECT_TRUE(answer["node"].is_null());
  EXPECT_EQ(answer["path"], "segment 0, first point");
}

TEST(Cli, MarginOrNot) {
  // Which option is missing, or is too much.
  const Result without = run(kMargin + " 2>&1");
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.out.find("ask with --direction WX,WY,T"), std::string::npos) << without.out;
  const Result with = run(kPair + " --direction 0,1,0 2>&1");
  EXPECT_EQ(with.code, 2);
  EXPECT_NE(with.out.find("ask without --direction"), std::string::npos) << with.out;
}

TEST(Cli, MarginAsJson) {
  const auto parse = [](const Result& r) { return nlohmann::json::parse(r.out); };
  const nlohmann::json good = parse(run(kMargin + " --direction 1,0,0 --json"));
  EXPECT_EQ(good["result"], "accepted");
  EXPECT_EQ(good["verdict"], "margin");
  EXPECT_EQ(good["resisted"], nlohmann::json::parse(R"([["0", "1"], ["5", null]])"));
  EXPECT_EQ(good["question"]["direction"], nlohmann::json::parse(R"(["1", "0", "0"])"));
  EXPECT_EQ(good["question"]["wrench"][0], "-3");
  EXPECT_EQ(good["nodes"], 7);
  const nlohmann::json bad =
      parse(run("margin_fig1_up.grasp.json - --preload 2 --direction 0,1,0 --json < "
                "margin_fig1_up.certificate.json"));
  EXPECT_EQ(bad["rule"], "question-preload");
  EXPECT_TRUE(bad["node"].is_null());
  EXPECT_TRUE(bad["path"].is_null());
  EXPECT_TRUE(bad["resisted"].is_null());
}

TEST(Cli, AnAnswerThatCannotBeWrittenIsNone) {
  EXPECT_EQ(run(kPair + " > /dev/full 2>/dev/null").code, 2);
}

}  // namespace
}  // namespace stickslip_check
