// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "number.hpp"

namespace stickslip_check {
namespace {

Rational parse_number(const std::string& option, const std::string& text) {
  const std::optional<Rational> value = parse_decimal(text);
  if (!value) {
    throw UsageError{option + ": " + quote(text) +
                     " is not a number such as 2, -0.25, 1e-3 or 3/5"};
  }
  return *value;
}

Vector parse_list(const std::string& option, const std::string& text) {
  Vector values;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    values.push_back(parse_number(option, text.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  return values;
}

/// Of the coordinates of a motion.
Vector parse_wrench(const std::string& option, const std::string& text) {
  Vector values = parse_list(option, text);
  if (values.size() > kMostInFile) {
    throw UsageError{
        option + ": " + quote(text) +
        " is not WX,WY,T, such as 0,-11/10,0, or in space WX,WY,WZ,TX,TY,TZ, or of "
        "several bodies at most " +
        std::to_string(kMostInFile) + " numbers"};
  }
  return values;
}

/// An empty list stands for none.
Vector parse_max_motion(const std::string& option, const std::string& text) {
  if (text == "none") return {};
  Vector values = parse_list(option, text);
  if (values.size() > kMostInFile) {
    throw UsageError{
        option + ": " + quote(text) +
        " is not LENGTH,ANGLE, such as 1/10,2, or a number for each coordinate, at most " +
        std::to_string(kMostInFile) + ", or the word none"};
  }
  return values;
}

std::vector<Vector> parse_plane(const std::string& option, const std::string& text) {
  const Vector values = parse_list(option, text);
  if (values.size() < 2 || values.size() % 2 != 0 || values.size() > 2 * kMostInFile) {
    throw UsageError{option + ": " + quote(text) +
                     " is not UX,UY,UT,VX,VY,VT, two wrenches, such as 1,0,0,0,1,0"};
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  return {Vector(values.begin(), middle), Vector(middle, values.end())};
}

Vector parse_inertia(const std::string& option, const std::string& text) {
  Vector values = parse_list(option, text);
  if (values.size() != 3 && values.size() != 6 && values.size() != 9) {
    throw UsageError{option + ": " + quote(text) +
                     " is not X,Y,G2, such as 0,0,1, or in space X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ]"};
  }
  if (values.size() == 6) values.resize(9);
  return values;
}

/// What stands behind "ball:".
Ball parse_ball(const std::string& option, const std::string& text) {
  Ball ball;
  std::string member;  // that is being given
  bool has_length = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t colon = std::min(text.find(':', begin), text.size());
    const std::size_t equals = begin == 0 ? colon : text.find('=', begin);
    const bool named = equals < colon;
    if (named) member = text.substr(begin, equals - begin);
    const std::size_t value = named ? equals + 1 : begin;
    if (begin == 0) {
      ball.radius = parse_number(option, text.substr(0, colon));
    } else if (named && member == "body") {
      ball.body = text.substr(value);
      return ball;
    } else if (named && member == "length" && !has_length) {
      ball.length = parse_number(option, text.substr(value, colon - value));
      has_length = true;
    } else if (member == "about" && named == ball.about.empty()) {
      ball.about.push_back(parse_number(option, text.substr(value, colon - value)));
    } else {
      throw UsageError{option + ": " + quote("ball:" + text) +
                       " is not ball:R[:length=L][:about=X:Y[:Z]][:body=NAME], such as "
                       "ball:1/10:length=2"};
    }
    begin = colon + 1;
  }
  return ball;
}

std::map<std::string, Tolerance> parse_tolerances(const std::string& option,
                                                  const std::string& text) {
  std::map<std::string, Tolerance> result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, comma - begin);
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string kind = part.substr(0, equals);
    const bool known = std::find(kUncertainKinds.begin(), kUncertainKinds.end(), kind) !=
                       kUncertainKinds.end();
    if (!known || equals == part.size() || result.count(kind) != 0) {
      throw UsageError{option + ": " + quote(part) +
                       " is not KIND=TOLERANCE, such as friction=10%, where KIND is friction, "
                       "stiffness, preload, position, normal or wrench, each at most once"};
    }
    std::string number = part.substr(equals + 1);
    constexpr const char* kBall = "ball:";
    const bool ball = number.rfind(kBall, 0) == 0;
    if (ball && kind != "wrench") {
      throw UsageError{option + ": " + quote(part) + ": only the wrench may have a ball"};
    }
    const bool percent = !number.empty() && number.back() == '%';
    if (ball) {
      result[kind] = {0, false, parse_ball(option, number.substr(std::strlen(kBall)))};
    } else {
      if (percent) number.pop_back();
      result[kind] = {parse_number(option, number), percent};
    }
    begin = comma + 1;
  }
  return result;
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  bool options_ended = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    const bool help = (word == "--help" || word == "-h") && arguments.files.empty();
    const bool operand = options_ended || word.size() < 2 || word[0] != '-' ||
                         ((word == "--help" || word == "-h") && !help);
    if (operand) {
      arguments.files.push_back(word);
      continue;
    }
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
    Options& options = arguments.options;
    if (word == "--wrench") {
      options.wrench = parse_wrench(word, value());
    } else if (word == "--torque") {
      options.wrench = Vector{0, 0, parse_number(word, value())};
    } else if (word == "--case") {
      options.case_name = value();
    } else if (word == "--preload") {
      options.preload = parse_number(word, value());
    } else if (word == "--normal-law") {
      const std::string law = value();
      if (law != "unilateral" && law != "bilateral") {
        throw UsageError{"--normal-law: " + quote(law) + " is not unilateral or bilateral"};
      }
      options.bilateral = law == "bilateral";
    } else if (word == "--direction") {
      options.direction = parse_wrench(word, value());
    } else if (word == "--plane") {
      options.plane = parse_plane(word, value());
    } else if (word == "--inertia") {
      options.inertia = parse_inertia(word, value());
    } else if (word == "--statics") {
      options.statics = parse_number(word, value());
    } else if (word == "--states") {
      const std::string set = value();
      if (std::find(kStateSets.begin(), kStateSets.end(), set) == kStateSets.end()) {
        throw UsageError{"--states: " + quote(set) + " is not slip, full or closed"};
      }
      options.states = set;
    } else if (word == "--robustness") {
      const std::string kind = value();
      if (std::find(kRobustnesses.begin(), kRobustnesses.end(), kind) == kRobustnesses.end()) {
        throw UsageError{"--robustness: " + quote(kind) + " is not contact or grasp"};
      }
      options.robustness = kind;
    } else if (word == "--length") {
      options.length = parse_number(word, value());
    } else if (word == "--max-force") {
      options.max_force = parse_list(word, value());
    } else if (word == "--preload-direction") {
      const std::string growth = value();
      options.preload_direction.emplace();
      options.preload_direction->scale = growth == "scale";
      if (growth != "scale") options.preload_direction->values = parse_list(word, growth);
    } else if (word == "--uncertain") {
      options.uncertain = parse_tolerances(word, value());
    } else if (word == "--max-motion") {
      options.max_motion = parse_max_motion(word, value());
    } else if (!attached && word == "--json") {
      arguments.json = true;
    } else if (!attached && word == "--batch") {
      arguments.batch = true;
    } else if (!attached && word == "--") {
      options_ended = true;
    } else if (!attached && help) {
      arguments.help = true;
      return arguments;
    } else {
      throw UsageError{"unknown option " + quote(words[i])};
    }
  }
  if (arguments.batch) {
    if (words.size() > 1) throw UsageError{"--batch takes no other words"};
  } else if (arguments.files.size() != 2) {
    throw UsageError{"expected two files, GRASP and CERTIFICATE, found " +
                     std::to_string(arguments.files.size())};
  }
  if (!arguments.batch && arguments.files[0] == "-" && arguments.files[1] == "-") {
    throw UsageError{"only one of GRASP and CERTIFICATE can be standard input"};
  }
  return arguments;
}

}  // namespace stickslip_check
