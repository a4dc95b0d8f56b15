// SPDX-License-Identifier: MIT
/// \file
/// Texts of grasps and certificates, and the answers to them, for the checker's tests.
#pragma once

#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "check.hpp"
#include "grasp.hpp"

namespace stickslip_check {

/// As many rounds of a random test as that; with sanitizers, which look for errors of another
/// kind and make each take twenty times as long, a quarter.
template <class Count>
constexpr Count rounds(Count count) {
#if defined(__SANITIZE_ADDRESS__)
  return (count + 3) / 4;
#else
  return count;
#endif
}

inline Answer ask(const std::string& grasp, const std::string& certificate,
                  const Options& options = {}) {
  std::istringstream grasp_in(grasp);
  std::istringstream certificate_in(certificate);
  return check(grasp_in, certificate_in, options);
}

/// "accepted", the rule, "malformed" or "not judged".
inline std::string outcome(const Answer& answer) {
  if (std::holds_alternative<Accepted>(answer)) return "accepted";
  if (std::holds_alternative<NotJudged>(answer)) return "not judged";
  const auto* rejected = std::get_if<Rejected>(&answer);
  return rejected != nullptr ? rejected->rule : "malformed";
}

/// The outcome with its reason, for messages.
inline std::string explain(const Answer& answer) {
  if (const auto* r = std::get_if<Rejected>(&answer)) {
    return r->rule + " at " + (r->node ? std::to_string(*r->node) : "-") + " (" + r->path +
           "): " + r->found;
  }
  if (const auto* m = std::get_if<Malformed>(&answer)) {
    return m->file + ": " + m->place + ": " + m->problem;
  }
  if (const auto* n = std::get_if<NotJudged>(&answer)) return "not judged: " + n->why;
  return "accepted";
}

/// The first occurrence of `from` replaced; `from` must occur.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("not found: " + from);
  return text.replace(at, from.size(), to);
}

/// The grasp of Fig. 1 of the paper: contacts at (-1,0), (0,-1), (1,0), mu = 1/2, k = 1.
inline std::string fig1(const std::string& preload, const std::string& wrench) {
  return R"({"format": "stickslip-grasp/1", "name": "fig1",
 "defaults": {"friction": "1/2", "preload": )" +
         preload + R"(},
 "contacts": [
  {"position": [-1, 0], "normal": [1, 0]},
  {"position": [0, -1], "normal": [0, 1]},
  {"position": [1, 0], "normal": [-1, 0]}],
 "wrench": [)" +
         wrench + "]}\n";
}

inline std::string header(std::size_t contacts, const std::string& wrench,
                          const std::string& law = "unilateral") {
  return R"({"format": "stickslip-certificate/2",
 "question": {"contacts": )" +
         std::to_string(contacts) + ", \"wrench\": [" + wrench + "], \"normal_law\": \"" + law +
         "\"},\n";
}

inline std::string refutation(const std::string& head, const std::vector<std::string>& nodes) {
  std::string text = head + " \"verdict\": \"unstable\",\n \"tree\": [";
  for (std::size_t i = 0; i < nodes.size(); ++i) text += (i == 0 ? "\n  " : ",\n  ") + nodes[i];
  return text + "]}\n";
}

using Random = std::mt19937;
inline int between(Random& random, int low, int high) {
  // Not a standard distribution: those differ between libraries.
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

inline Grasp read(const std::string& text) {
  std::istringstream in(text);
  return read_grasp(in, "grasp");
}

}  // namespace stickslip_check
