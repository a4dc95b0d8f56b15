// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

/// Changes one certificate by hand.
class Attacks {
 public:
  Attacks(std::vector<CommittedCertificate> margins, Mutants& mutants)
      : margins_(std::move(margins)), mutants_(mutants) {}

  void attack(const std::string& kind, const std::string& name, Expectation expected,
              const std::function<void(Json&)>& change) {
    const auto original = std::find_if(margins_.begin(), margins_.end(),
                                       [&](const auto& m) { return m.name == name; });
    CheckerInput input = original->input;
    Json edited = Json::parse(input.certificate);
    change(edited);
    input.certificate = edited.dump();
    mutants_.push_back({kind, name, std::move(input), std::move(expected)});
  }

 private:
  std::vector<CommittedCertificate> margins_;
  Mutants& mutants_;
};

Json parse(const char* text) {
  return Json::parse(text);
}

}  // namespace

void attack_margins(Mutants& mutants) {
  const auto rule = [](const char* name) { return Expectation::of_rule(name); };
  Attacks attacks(all_margins(), mutants);
  // The equilibria at 0 and 2 are of different contacts.
  attacks.attack("opposite gaps", "margin_jaw_two_points", rule("segment-mode"), [](Json& c) {
    c["resisted"] = parse("[[0, 2]]");
    const Json from = c["segments"][0][0];
    const Json to = c["segments"][1][0];
    c["segments"] = {{from, to}};
    c["tree"] = parse("[[\"leaf\", 0, 1, -1]]");
  });
  // At rest, friction up and friction down; then moving against the latter's edge.
  attacks.attack("another edge", "margin_fig1_down", rule("segment-mode"), [](Json& c) {
    c["segments"] = {{c["segments"][0][0], c["segments"][1][1]}};
  });
  // Both equilibria are right; between them friction is off the edge that slip asks for.
  attacks.attack("opposite slip", "margin_fig4_up", rule("segment-mode"), [](Json& c) {
    c["segments"][0][0][1] = {0, -1, 0};
    c["segments"][0][1][1] = {0, 1, 0};
    for (Json& point : c["segments"][0]) point[2] = Json::array();
  });
  // Without the preload nothing presses.
  attacks.attack("a ray that needs the preload", "margin_fig1_down", rule("witness-balance"),
                 [](Json& c) {
                   c["segments"][1][1][1] = {0, 0, 0};
                 });
  attacks.attack(
      "a ray for another direction", "margin_fig1_up", rule("witness-balance"), [](Json& c) {
        c["resisted"][0][1] = nullptr;
        c["segments"].push_back({c["segments"][0][1], parse("[null, [0, -1, 0], []]")});
        c["tree"] = Json::array();
      });
  attacks.attack("a wider interval", "margin_fig1_up", rule("witness-balance"), [](Json& c) {
    c["resisted"][0][1] = c["segments"][0][1][0] = json_of(1 + parse_rational("1e-30"));
  });
  // The trees of the gaps below and above 1, in the other order.
  for (const char* name : {"margin_no_contact_1", "margin_jaw_two_points"}) {
    attacks.attack("trees in another order", name, rule("leaf-bound"), [](Json& c) {
      const auto half = static_cast<std::ptrdiff_t>(c["tree"].size() / 2);
      std::rotate(c["tree"].begin(), c["tree"].begin() + half, c["tree"].end());
    });
  }
  // The load 0 is resisted, and the tree is about what is above it only.
  attacks.attack("0 left out", "margin_no_contact_0", rule("leaf-bound"), [](Json& c) {
    c["resisted"] = Json::array();
    c["segments"] = Json::array();
  });
  attacks.attack("0 refuted with the rest", "margin_no_contact_never", Expectation::accepted(),
                 [](Json& c) { c["tree"] = parse("[[\"leaf\", -1, 0, -1]]"); });
  attacks.attack("a bound that rises without end", "margin_no_contact_never",
                 rule("leaf-bound"),
                 [](Json& c) { c["tree"] = parse("[[\"leaf\", 1, 0, -1]]"); });
  attacks.attack(
      "a bound that rises without end, elsewhere", "margin_no_contact_never",
      Expectation::accepted(), [](Json& c) {
        c["tree"] =
            parse(R"([["plane", 0, 0, 0, -1, 0], ["leaf", 1, 0, -1], ["leaf", 0, 0, -1]])");
      });
}

}  // namespace stickslip::test
