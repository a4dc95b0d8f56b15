// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

const Rational kTiny = parse_rational("1e-12");

bool is_ray(const Json& segment) {
  return segment[1][0].is_null();
}

class MarginMutations {
 public:
  MarginMutations(RandomSource& random, const CommittedCertificate& original, Mutants& mutants)
      : random_(random),
        original_(original),
        json_(Json::parse(original.input.certificate)),
        mutants_(mutants) {}

  void run() {
    add("margin as it is", json_, Expectation::accepted());
    segments();
    trees();
    for (int k = 0; k < 60; ++k) numbers();
  }

 private:
  void add(const std::string& kind, const Json& edited, Expectation expected = {}) {
    CheckerInput input = original_.input;
    input.certificate = edited.dump();
    mutants_.push_back({kind, original_.name, std::move(input), std::move(expected)});
  }

  static Expectation rule(const char* name) { return Expectation::of_rule(name); }

  void segments() {
    const Json& list = json_["segments"];
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto edit = [&](const char* kind, Expectation expected,
                            const std::function<void(Json&)>& change) {
        Json edited = json_;
        change(edited["segments"][k]);
        add(kind, edited, std::move(expected));
      };
      // In an interval without end no load is too large for the chain.
      const Json& last = json_["resisted"].back();
      const bool endless = last[1].is_null() && number_of(list[k][0][0]) >= number_of(last[0]);
      const char* too_far = endless ? "witness-balance" : "segment-chain";
      Json edited = json_;
      edited["segments"].erase(k);
      add("a segment less", edited, rule("segment-chain"));
      edited["segments"].insert(edited["segments"].begin() + static_cast<std::ptrdiff_t>(k),
                                {list[k], list[k]});
      add("a segment twice", edited, rule("segment-chain"));
      for (const std::size_t end : {0u, 1u}) {
        edit("null in a point",
             is_ray(list[k]) && end == 1 ? Expectation::accepted()
             : end == 0                  ? Expectation::malformed()
                                         : rule(too_far),
             [&](Json& segment) { segment[end][0] = nullptr; });
        edit("a share beyond", rule("witness-share"), [&](Json& segment) {
          segment[end][2].push_back({json_["question"]["contacts"], 0});
        });
        for (std::size_t i = 0; i < list[k][end][2].size(); ++i) {
          const bool full = abs(number_of(list[k][end][2][i][1])) == 1;
          edit("another share of a point",
               full ? rule("witness-share") : rule("witness-balance"), [&](Json& segment) {
                 Json& share = segment[end][2][i][1];
                 share = json_of(number_of(share) * (1 + kTiny));
               });
          edit("a share less", rule("witness-balance"),
               [&](Json& segment) { segment[end][2].erase(i); });
        }
        for (std::size_t j = 0; j < 3; ++j) {
          edit("another motion of a point", {}, [&](Json& segment) {
            Json& c = segment[end][1][j];
            c = json_of(number_of(c) + random_.between(-1, 1) * kTiny);
          });
        }
      }
      edit("a later begin", rule("segment-chain"),
           [](Json& segment) { segment[0][0] = json_of(number_of(segment[0][0]) + kTiny); });
      if (!is_ray(list[k])) {
        edit("a later end", rule(too_far), [](Json& segment) {
          segment[1][0] = json_of(number_of(segment[1][0]) + 1000000);
        });
        edit("a segment that goes down", rule("segment-chain"),
             [](Json& segment) { segment[1][0] = json_of(number_of(segment[0][0]) - kTiny); });
      } else {
        edit("a ray of twice the speed", {}, [](Json& segment) {
          for (Json& c : segment[1][1]) c = json_of(2 * number_of(c));
        });
      }
    }
  }

  void trees() {
    const Json& nodes = json_["tree"];
    Json edited = json_;
    edited["tree"].push_back({"leaf", 0, 0, 0});
    add("a node after the trees", edited, Expectation::of_rule("tree-long", nodes.size()));
    if (nodes.empty()) return;
    edited = json_;
    edited["tree"].erase(nodes.size() - 1);
    add("a node less at the end", edited, Expectation::of_rule("tree-short", nodes.size() - 1));
    edited["tree"] = Json::array();
    add("no trees", edited, Expectation::of_rule("tree-short", 0));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      edited = json_;
      edited["tree"].erase(k);
      add("a node less", edited, Expectation::rejected());
      if (nodes[k][0] != "leaf") continue;
      for (std::size_t j = 1; j < 4; ++j) {
        for (const Rational& by : {kTiny, Rational(-kTiny)}) {
          edited = json_;
          edited["tree"][k][j] = json_of(number_of(nodes[k][j]) + by);
          add("a leaf of a margin shifted", edited);
        }
      }
      edited = json_;
      for (std::size_t j = 1; j < 4; ++j) {
        edited["tree"][k][j] = json_of(-number_of(nodes[k][j]));
      }
      add("a leaf of a margin turned", edited, Expectation::of_rule("leaf-bound", k));
      edited["tree"][k] = {"leaf", 0, 0, 0};
      add("a leaf of nothing in a margin", edited, Expectation::of_rule("leaf-bound", k));
    }
  }

  /// Some numbers anywhere replaced: it may be another proof.
  void numbers() {
    Json edited = json_;
    std::vector<Json*> found;
    const std::function<void(Json&)> collect = [&](Json& value) {
      if (value.is_number() || value.is_null()) found.push_back(&value);
      if (!value.is_array()) return;
      for (Json& item : value) collect(item);
    };
    for (const char* member : {"resisted", "segments", "tree"}) collect(edited[member]);
    if (found.empty()) return;
    for (int k = random_.between(1, 3); k > 0; --k) {
      Json& one = *random_.pick(found);
      one = random_.between(0, 9) == 0 ? Json(nullptr) : Json(random_.between(-2, 3));
    }
    add("numbers of a margin", edited);
  }

  RandomSource& random_;
  const CommittedCertificate& original_;
  const Json json_;
  Mutants& mutants_;
};

}  // namespace

void mutate_margins(RandomSource& random, Mutants& mutants) {
  const std::vector<CommittedCertificate> margins = all_margins();
  for (const CommittedCertificate& margin : margins) {
    MarginMutations(random, margin, mutants).run();
  }
}

}  // namespace stickslip::test
