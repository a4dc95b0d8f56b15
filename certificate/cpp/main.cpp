// SPDX-License-Identifier: MIT
// stickslip-check: the command line. See kHelp.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "arguments.hpp"
#include "check.hpp"
#include "json.hpp"
#include "print.hpp"

namespace {

using namespace stickslip_check;

constexpr int kExitAccepted = 0;
constexpr int kExitRejected = 1;
constexpr int kExitMalformed = 2;
constexpr int kExitNotJudged = 3;

int exit_code_of(const Answer& answer) {
  if (std::holds_alternative<Malformed>(answer)) return kExitMalformed;
  if (std::holds_alternative<NotJudged>(answer)) return kExitNotJudged;
  return std::holds_alternative<Rejected>(answer) ? kExitRejected : kExitAccepted;
}

const char* const kHelp =
    R"(stickslip-check GRASP CERTIFICATE [options]

Checks a proof that a frictional grasp, in the plane or in space, of one body or of several that
links and joints hold, is stable, or unstable, under a wrench; or, with a direction, a proof of
which multiples of the direction it resists; or, with a plane, a proof of which wrenches of the
plane it resists.
GRASP is the grasp file (version 1, 2, or of several bodies 3), CERTIFICATE the proof; one of them may be - for standard input.
The grasp file is read afresh and nothing in the certificate is believed: this program
rebuilds every contact row and recomputes every bound; no rounding decides anything.

The question is that of the grasp file unless replaced here. Give the same options as to
the program that produced the certificate:
  --wrench WX,WY,T         wrench applied to the object: force x, force y, torque; in space
                           WX,WY,WZ,TX,TY,TZ: force x, y, z and torque x, y, z; of several
                           bodies these of each that is no link, in their order, then a number
                           for each joint (the answer says of what each is), as is --direction
  --torque T               short for --wrench 0,0,T
  --case NAME              the wrench of this case of the grasp file
  --preload P              one preload for all contacts (not for ratchets and springs)
  --normal-law LAW         unilateral (contacts may open; the default) or bilateral
  --direction WX,WY,T      ask for the margin: all factors f >= 0 for which the grasp is
                           stable under wrench + f direction, where the wrench is 0 unless
                           given by --wrench or --case; in space WX,WY,WZ,TX,TY,TZ
  --preload-direction D    ask for the margin along preloads: D is P0,P1,..., one number for
                           each contact (of several bodies then one for each ratchet and each
                           spring), which f times is added to its preload; or the word scale:
                           f times the preloads, that is, which multiples of them hold
  --plane UX,UY,UT,VX,VY,VT
                           ask for the region: all (s, t) for which the (planar) grasp is stable
                           under wrench + s U + t V, where the wrench is 0 unless given by
                           --wrench or --case
  --inertia X,Y,G2         ask for the class of rigid contacts: whether the object must move, must
                           hold, or neither follows (open); its centre of mass, and the squared
                           radius of gyration about that; in space X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ],
                           the centre and the tensor of inertia about that, of mass 1
  --statics FACTOR         ask whether bodies may stand or must move, with any stiffness and preloads, and
                           all friction multiplied by FACTOR; with --direction which multiples
                           may, with --plane (of as many numbers as two wrenches) which loads
  --states SET             ask which states there are: the signs of slip along lines across the
                           normals (slip), with the signs of N.d (full), or of motions on which all
                           contacts stay closed (closed); without other options but --json
  --robustness MEASURE     ask for bounds of the potential contact robustness (contact) or the
                           potential grasp robustness (grasp), for a load at most
  --length L               the length by which torques are divided there; 1 unless given
  --max-force F,...        the largest normal force there, of all contacts or of each; 1 unless given
  --uncertain LIST         ask about every grasp in a box: how far numbers of each kind may be
                           off, such as friction=10%,stiffness=10%,preload=5%,
                           position=0.001,normal=0.0175,wrench=2%; any of them, absolute or
                           in percent, for normals the slope by which they may be turned;
                           wrench=ball:R[:length=L][:about=X:Y[:Z]][:body=NAME] is every load that
                           differs by a force f and a torque t at (X, Y) with |f|^2 + |t|^2 / L^2
                           at most R^2, where L is 1 and the point 0 unless given; of several
                           bodies it is on the one named last, after body=
  --max-motion LENGTH,ANGLE
                           ask about motions up to these alone, in place of the grasp file's
                           max_motion; or B1,B2,..., a number for each coordinate, which it has
                           to be with joints; or the word none: without a bound

  --json                   answer as one JSON object
  --batch                  instead of GRASP and CERTIFICATE, and without other options: questions from
                           standard input, each a line, a JSON object
                           {"grasp": TEXT, "certificate": TEXT, "options": [WORD, ...]}, of which
                           each character stands for the byte of its number; each is answered by
                           a line, as with --json
  -h, --help               this text, if it comes before GRASP
  --                       no options follow

Numbers are exact: 1, -0.25, 1e-3, 3/5.

Answers and exit codes:
  accepted   0   the certificate proves the verdict about the question that is printed;
                 of a margin, that exactly the factors printed as "resisted" are; by claims,
                 that those are, that those printed as "refuted" are not, and nothing of others;
                 of a region, that exactly the (s, t) in the certificate's pieces are;
                 of statics with a direction or a plane, that those printed as "may stand" may,
                 that those printed as "must move" must, and nothing of others;
                 of states, that there are no others than those in the certificate and their opposites;
                 of a robustness, that it is not below and not above the bounds printed
  rejected   1   it does not; the rule (named as in certificate/FORMAT.md) and the place
  (error)    2   a file or the command line cannot be understood, on standard error; of a
                 batch, a line, where it ends; else its exit code is 0
  not judged 3   it may, but to see it takes more work than the files' length allows

Example:
  stickslip decide grasp.json --certificate proof.json
  stickslip-check grasp.json proof.json
  stickslip-check grasp.json margin.json --direction 0,1,0
  stickslip-check --batch < questions.jsonl
)";

/// The stream of a file name; `file` is what it lives in unless it is standard input.
std::istream& open(const std::string& name, std::ifstream& file) {
  if (name == "-") return std::cin;
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) {
    throw Malformed{name, "opening", "it is a directory; name a file, or - for standard input"};
  }
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

/// What nobody can read was not answered.
int write(const std::string& text, int exit_code) {
  errno = 0;
  std::cout << text << std::flush;
  if (std::cout) return exit_code;
  std::cerr << "stickslip-check: standard output cannot be written";
  if (errno != 0) std::cerr << ": " << std::strerror(errno);
  std::cerr << '\n';
  return kExitMalformed;
}

int run(const Arguments& arguments) {
  // Never freed: to return all numbers of a large grasp one by one takes time.
  static const Answer& answer = *new Answer(answer_to(arguments));
  const bool malformed = std::holds_alternative<Malformed>(answer);
  if (malformed) std::cerr << "stickslip-check: " << as_text(answer);
  const int exit_code = exit_code_of(answer);
  if (arguments.json) return write(as_json(answer), exit_code);
  return malformed ? exit_code : write(as_text(answer), exit_code);
}

/// The bytes that characters, in UTF-8, stand for.
std::string bytes_of(const Value& value, const JsonReader& reader, const std::string& place) {
  reader.expect(value.kind == Value::Kind::kString, value, place, "a string");
  std::string bytes;
  for (std::size_t k = 0; k < value.text.size(); ++k) {
    const auto lead = static_cast<unsigned char>(value.text[k]);
    reader.expect(lead < 0xC4, value, place, "characters that each stand for a byte");
    bytes += lead < 0x80 ? value.text[k]
                         : static_cast<char>((lead & 3U) << 6U | (value.text[++k] & 0x3FU));
  }
  return bytes;
}

/// Throws Malformed or UsageError if it is no question.
Answer answer_to_line(const std::string& line, const std::string& name) {
  std::istringstream text(line);
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  JsonReader reader(text, name, {kAny, 2, kAny, kAny, false});
  std::vector<std::string> words = {"grasp", "certificate"};
  std::map<std::string, std::string> files;
  while (const std::optional<std::string> member = reader.next_member()) {
    const Value value = reader.value();
    if (*member == "options") {
      reader.expect(value.kind == Value::Kind::kArray, value, *member, "a list of words");
      for (const Value& word : value.items) words.push_back(bytes_of(word, reader, *member));
    } else {
      files[*member] = bytes_of(value, reader, *member);
    }
  }
  if (files.size() != 2 || files.count("grasp") + files.count("certificate") != 2) {
    reader.fail(1, "", "expected the members grasp, certificate and options");
  }
  std::istringstream grasp(files["grasp"]);
  std::istringstream certificate(files["certificate"]);
  return check(grasp, certificate, parse_arguments(words).options);
}

/// Whoever asks may wait for each answer.
int run_batch() {
  std::size_t number = 0;
  for (std::string line; std::getline(std::cin, line);) {
    const std::string name = "question " + std::to_string(++number);
    try {
      const int code = write(as_json(answer_to_line(line, name)), kExitAccepted);
      if (code != kExitAccepted) return code;
    } catch (const Malformed& malformed) {
      std::cerr << "stickslip-check: " << as_text(malformed);
      return kExitMalformed;
    } catch (const UsageError& error) {
      throw UsageError{name + ": " + error.problem};
    }
  }
  return kExitAccepted;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = parse_arguments({argv + 1, argv + argc});
    if (arguments.help) return write(kHelp, kExitAccepted);
    return arguments.batch ? run_batch() : run(arguments);
  } catch (const UsageError& error) {
    std::cerr << "stickslip-check: " << error.problem << "; try stickslip-check --help\n";
  } catch (const std::exception& error) {
    std::cerr << "stickslip-check: " << error.what() << '\n';
  }
  return kExitMalformed;
}
