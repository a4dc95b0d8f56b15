// SPDX-License-Identifier: MIT
#include "print.hpp"

#include <iostream>

namespace stickslip_check {
namespace {

std::string json_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += (c >= 0 && c < ' ') ? ' ' : c;
  }
  return result + '"';
}

std::string vector(const std::string (&v)[3]) {
  return "(" + v[0] + ", " + v[1] + ", " + v[2] + ")";
}

std::string json_vector(const std::string (&v)[3]) {
  return "[" + json_string(v[0]) + ", " + json_string(v[1]) + ", " + json_string(v[2]) + "]";
}

/// "[0, 1], [3/2, oo)"
std::string in_words(const std::vector<ResistedInterval>& intervals) {
  std::string text;
  for (const auto& [low, high] : intervals) {
    text += (text.empty() ? "[" : ", [") + low + ", " + (high ? *high + "]" : "oo)");
  }
  return text.empty() ? "no multiple" : text;
}

std::string json_intervals(const std::vector<ResistedInterval>& intervals) {
  std::string text;
  for (const auto& [low, high] : intervals) {
    text += (text.empty() ? "[" : ", [") + json_string(low) + ", " +
            (high ? json_string(*high) : "null") + "]";
  }
  return "[" + text + "]";
}

}  // namespace

void print_json(const Answer& answer) {
  const auto* a = std::get_if<Accepted>(&answer);
  const auto* r = std::get_if<Rejected>(&answer);
  const auto* m = std::get_if<Malformed>(&answer);
  const bool in_tree = r != nullptr && r->node.has_value();
  const bool tree = a != nullptr && a->verdict != "stable";
  const bool place = r != nullptr && (in_tree || !r->path.empty());
  const auto text = [](bool present, const std::string& content) {
    return present ? json_string(content) : "null";
  };
  const auto number = [](bool present, std::uint64_t value) {
    return present ? std::to_string(value) : "null";
  };
  std::cout << R"({"result": )"
            << json_string(a != nullptr ? "accepted"
                                        : (r != nullptr ? "rejected" : "malformed"))
            << R"(, "rule": )" << text(r != nullptr, r != nullptr ? r->rule : "")
            << R"(, "node": )" << number(in_tree, in_tree ? *r->node : 0) << R"(, "path": )"
            << text(place || m != nullptr, place ? r->path : (m != nullptr ? m->place : ""))
            << R"(, "found": )"
            << text(a == nullptr, r != nullptr ? r->found : (m != nullptr ? m->problem : ""))
            << R"(, "verdict": )" << text(a != nullptr, a != nullptr ? a->verdict : "")
            << R"(, "nodes": )" << number(tree, tree ? a->nodes : 0) << R"(, "leaves": )"
            << number(tree, tree ? a->leaves : 0) << R"(, "voids": )"
            << number(tree, tree ? a->voids : 0) << R"(, "resisted": )"
            << (a != nullptr && a->margin ? json_intervals(a->margin->intervals) : "null")
            << R"(, "question": )";
  if (a == nullptr) {
    std::cout << "null}\n";
    return;
  }
  std::cout << R"({"contacts": )" << a->contacts << R"(, "wrench": )" << json_vector(a->wrench)
            << R"(, "direction": )" << (a->margin ? json_vector(a->margin->direction) : "null")
            << R"(, "preload": )" << text(a->preload.has_value(), a->preload.value_or(""))
            << R"(, "normal_law": )" << json_string(a->normal_law) << R"(, "snapped_normals": )"
            << a->snapped << R"(, "snapped_by_at_most": )" << json_string(a->snapped_by)
            << "}}\n";
}

void print(const Accepted& a) {
  std::cout << "accepted\n";
  if (a.margin) {
    std::cout << "resisted    " << in_words(a.margin->intervals) << '\n';
  } else {
    std::cout << "verdict     " << a.verdict << '\n';
  }
  std::cout << "contacts    " << a.contacts << '\n'
            << "wrench      " << vector(a.wrench) << '\n';
  if (a.margin) std::cout << "direction   " << vector(a.margin->direction) << '\n';
  std::cout << "preload     "
            << (a.preload ? *a.preload + " at all contacts" : "as in the grasp file") << '\n'
            << "normal law  " << a.normal_law << '\n'
            << "normals     ";
  if (a.snapped == 0) {
    std::cout << "as in the grasp file\n";
  } else {
    std::cout << a.snapped << " replaced, none moved by more than " << a.snapped_by << '\n';
  }
  if (a.verdict == "stable") {
    std::cout << "proof       an equilibrium\n";
  } else if (a.margin) {
    std::cout << "proof       segments: " << a.margin->segments
              << "; trees: " << a.margin->trees << ", of " << a.nodes << " nodes: " << a.leaves
              << " leaves, " << a.voids << " voids\n";
  } else {
    std::cout << "proof       a tree of " << a.nodes << " nodes: " << a.leaves << " leaves, "
              << a.voids << " voids\n";
  }
}

void print(const Rejected& r) {
  std::cout << "rejected\nrule   " << r.rule << '\n';
  if (r.node) std::cout << "node   " << *r.node << '\n';
  if (!r.path.empty()) std::cout << "path   " << r.path << '\n';
  std::cout << "found  " << r.found << '\n';
}

}  // namespace stickslip_check
