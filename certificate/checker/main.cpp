// SPDX-License-Identifier: MIT
// stickslip-check: the command line. See kHelp.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

struct UsageError {
  std::string problem;
};

struct Arguments {
  std::vector<std::string> files;
  QuestionOptions options;
  bool json = false;
  bool help = false;
};

Rational parse_number(const std::string& option, const std::string& text) {
  const std::optional<Rational> value = parse_decimal(text);
  if (!value) {
    throw UsageError{option + ": " + quote(text) +
                     " is not a number such as 2, -0.25, 1e-3 or 3/5"};
  }
  return *value;
}

Vector3 parse_wrench(const std::string& option, const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 3) {
    throw UsageError{option + ": " + quote(text) + " is not WX,WY,T, such as 0,-11/10,0"};
  }
  return {parse_number(option, parts[0]), parse_number(option, parts[1]),
          parse_number(option, parts[2])};
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    std::optional<std::string> attached;
    const std::size_t equals = word.find('=');
    if (word.rfind("--", 0) == 0 && equals != std::string::npos) {
      attached = word.substr(equals + 1);
      word.resize(equals);
    }
    const auto value = [&]() -> std::string {
      if (attached) return *attached;
      if (i + 1 == words.size()) throw UsageError{word + " needs a value"};
      return words[++i];
    };
    if (word == "--wrench") {
      arguments.options.wrench = parse_wrench(word, value());
    } else if (word == "--direction") {
      arguments.options.direction = parse_wrench(word, value());
      if (arguments.options.direction == Vector3{}) {
        throw UsageError{"--direction must not be 0,0,0"};
      }
    } else if (word == "--preload") {
      arguments.options.preload = parse_number(word, value());
      if (*arguments.options.preload < 0) throw UsageError{"--preload must be 0 or more"};
    } else if (word == "--normal-law") {
      const std::string law = value();
      if (law != "unilateral" && law != "bilateral") {
        throw UsageError{"--normal-law: " + quote(law) + " is not unilateral or bilateral"};
      }
      arguments.options.bilateral = law == "bilateral";
    } else if (word == "--snap-normals") {
      const Rational tolerance = parse_number(word, value());
      if (tolerance <= 0 || tolerance >= 1) {
        throw UsageError{"--snap-normals must lie between 0 and 1, such as 1e-9"};
      }
      arguments.options.snap_tolerance = tolerance;
    } else if (!attached && word == "--json") {
      arguments.json = true;
    } else if (!attached && (word == "--help" || word == "-h")) {
      arguments.help = true;
    } else if (word.size() > 1 && word[0] == '-') {
      throw UsageError{"unknown option " + quote(words[i])};
    } else {
      arguments.files.push_back(word);
    }
  }
  if (arguments.help) return arguments;
  if (arguments.files.size() != 2) {
    throw UsageError{"expected two files, GRASP and CERTIFICATE, found " +
                     std::to_string(arguments.files.size())};
  }
  if (arguments.files[0] == "-" && arguments.files[1] == "-") {
    throw UsageError{"only one of GRASP and CERTIFICATE can be standard input"};
  }
  return arguments;
}

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
