// SPDX-License-Identifier: MIT
// stickslip-check: the command line. See kHelp.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <variant>

#include "arguments.hpp"
#include "check.hpp"
#include "print.hpp"

namespace {

using namespace stickslip_check;

constexpr int kExitAccepted = 0;
constexpr int kExitRejected = 1;
constexpr int kExitMalformed = 2;

const char* const kHelp =
    R"(stickslip-check GRASP CERTIFICATE [options]

Checks a proof that a planar frictional grasp is stable, or unstable, under a wrench; or, with
--direction, a proof of which multiples of a direction it resists.
GRASP is the grasp file, CERTIFICATE the proof; one of them may be - for standard input.
The grasp file is read afresh and nothing in the certificate is believed: this program
rebuilds every contact row and recomputes every bound in exact arithmetic.

The question is that of the grasp file unless replaced here. Give the same options as to
the program that produced the certificate:
  --wrench WX,WY,T         wrench applied to the object: force x, force y, torque
  --direction WX,WY,T      ask for the margin: all factors f >= 0 for which the grasp is
                           stable under wrench + f direction, where the wrench is 0 unless
                           given by --wrench; the certificate must be of format
                           stickslip-margin/1
  --preload P              one preload for all contacts
  --normal-law LAW         unilateral (contacts may open; the default) or bilateral
  --snap-normals EPS       let the certificate replace normals of irrational length by
                           rational unit vectors within EPS; the answer says how far

  --json                   answer as one JSON object
  -h, --help               this text

Numbers are exact: 1, -0.25, 1e-3, 3/5.

Answers and exit codes:
  accepted   0   the certificate proves the verdict about the question that is printed;
                 of a margin, that exactly the factors printed as "resisted" are
  rejected   1   it does not; the rule (named as in certificate/FORMAT.md) and the place
  (error)    2   a file or the command line cannot be understood, on standard error

Example:
  stickslip decide grasp.json --certificate proof.json
  stickslip-check grasp.json proof.json
  stickslip-check grasp.json margin.json --direction 0,1,0
)";

/// The stream of a file name; `file` is what it lives in unless it is standard input.
std::istream& open(const std::string& name, std::ifstream& file) {
  if (name == "-") return std::cin;
  errno = 0;
  file.open(name, std::ios::binary);
  if (!file) {
    const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
    throw Malformed{name, "opening", reason + "; name a file, or - for standard input"};
  }
  return file;
}

Answer answer_to(const Arguments& arguments) {
  const auto shown = [](const std::string& name) { return name == "-" ? "<stdin>" : name; };
  std::ifstream grasp_file;
  std::ifstream certificate_file;
  try {
    std::istream& grasp = open(arguments.files[0], grasp_file);
    std::istream& certificate = open(arguments.files[1], certificate_file);
    return check(grasp, certificate, arguments.options, shown(arguments.files[0]),
                 shown(arguments.files[1]));
  } catch (const Malformed& malformed) {
    return malformed;
  }
}

int run(const Arguments& arguments) {
  const Answer answer = answer_to(arguments);
  int exit_code = kExitAccepted;
  if (arguments.json) print_json(answer);
  if (const auto* malformed = std::get_if<Malformed>(&answer)) {
    std::cerr << "stickslip-check: " << malformed->file << ": " << malformed->place << ": "
              << malformed->problem << '\n';
    exit_code = kExitMalformed;
  } else if (const auto* rejected = std::get_if<Rejected>(&answer)) {
    if (!arguments.json) print(*rejected);
    exit_code = kExitRejected;
  } else if (!arguments.json) {
    print(std::get<Accepted>(answer));
  }
  // An answer that nobody can read was not given.
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "stickslip-check: the answer cannot be written to standard output\n";
    return kExitMalformed;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = parse_arguments({argv + 1, argv + argc});
    if (arguments.help) {
      std::cout << kHelp;
      return kExitAccepted;
    }
    return run(arguments);
  } catch (const UsageError& error) {
    std::cerr << "stickslip-check: " << error.problem << "; try stickslip-check --help\n";
  } catch (const std::exception& error) {
    std::cerr << "stickslip-check: " << error.what() << '\n';
  }
  return kExitMalformed;
}
