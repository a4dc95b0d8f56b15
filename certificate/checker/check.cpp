// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "claim.hpp"
#include "json.hpp"
#include "margin.hpp"
#include "syntax.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {
namespace {

constexpr JsonLimits kLimits{std::uint64_t{1} << 30U, 8, false, 65536};
constexpr const char* kVerdictFormat = "stickslip-certificate/1";
constexpr const char* kMarginFormat = "stickslip-margin/1";

/// Reads a certificate and checks it as it comes. A rule that fails is remembered, and the rest
/// of the file is still read: what is malformed anywhere is malformed.
class Certificate : public JsonHandler {
 public:
  Certificate(Question question, std::string grasp_file, std::string file, bool exact_only)
      : question_(std::move(question)),
        grasp_file_(std::move(grasp_file)),
        syntax_(std::move(file)),
        exact_only_(exact_only) {}

  bool begin_member(const std::string& key, std::size_t line) override {
    if (std::find(expected_.begin(), expected_.end(), key) == expected_.end()) {
      syntax_.fail(line, "top level",
                   "found the member " + quote(key) + ", expected " + expected());
    }
    elements_ = 0;
    if (key == "segments" && !rejected_) {
      segments_ = std::make_unique<Segments>(rows_, question_, resisted_);
    }
    if (key == "tree" && !rejected_) {
      Loads loads{question_.wrench};
      if (question_.direction)
        loads = {question_.wrench, *question_.direction, gaps(resisted_)};
      tree_ = std::make_unique<TreeWalk>(rows_, std::move(loads), question_.bilateral);
      if (exact_only_) tree_->use_exact_bounds_only();
    }
    return key == "tree" || key == "forces" || key == "segments";
  }

  void element(const Value& value) override {
    const std::string& list = expected_.front();
    const std::string place = list == "tree" ? "node " + std::to_string(elements_)
                                             : list + "[" + std::to_string(elements_) + "]";
    ++elements_;
    if (list == "tree") {
      const Node node = syntax_.node(value, place);
      unless_rejected([&] { tree_->visit(node); });
    } else if (list == "segments") {
      syntax_.expect(value.is_array(2), value, place, "an array of two points");
      const MarginPoint first = point(value.items[0], false, place);
      const MarginPoint second = point(value.items[1], true, place);
      unless_rejected([&] { segments_->visit(first, second); });
    } else {
      const Vector2 force = syntax_.numbers<2>(value, 0, place);
      if (elements_ <= question_.contacts.size()) witness_.forces.push_back(force);
    }
  }

  void end_member(const std::string& key, const Value& value) override {
    if (key == "format") {
      read_format(value);
      expected_ = {"producer", "question"};
    } else if (key == "producer") {
      syntax_.expect(value.kind == Value::Kind::kString, value, key, "a string");
      expected_ = {"question"};
    } else if (key == "question") {
      const Claim claim = read_claim(syntax_, value);
      unless_rejected([&] { accept_question(claim); });
      expected_ = {question_.direction ? "direction" : "verdict"};
    } else if (key == "verdict") {
      const bool stable = is_text(value, "stable");
      syntax_.expect(stable || is_text(value, "unstable"), value, key,
                     R"("stable" or "unstable")");
      accepted_.verdict = value.text;
      expected_ = {stable ? "twist" : "tree"};
    } else if (key == "direction") {
      const Vector3 stated = syntax_.numbers<3>(value, 0, key);
      unless_rejected([&] {
        if (stated != *question_.direction) {
          reject_question("question-direction", show(stated), show(*question_.direction));
        }
      });
      expected_ = {"resisted"};
    } else if (key == "resisted") {
      read_resisted(value);
      unless_rejected([&] { check_order(resisted_); });
      expected_ = {"segments"};
    } else if (key == "twist") {
      witness_.d = syntax_.numbers<3>(value, 0, key);
      expected_ = {"forces"};
    } else {
      syntax_.expect(value.kind == Value::Kind::kArray, value, key, "an array");
      finish_list(key);
    }
  }

  Answer finish() {
    if (!expected_.empty()) {
      throw Malformed{syntax_.file(), "top level", "the member " + expected() + " is missing"};
    }
    if (rejected_) return *rejected_;
    accepted_.contacts = question_.contacts.size();
    spell(question_.wrench, accepted_.wrench);
    if (question_.preload) accepted_.preload = question_.preload->get_str();
    accepted_.normal_law = law_name(question_.bilateral);
    return accepted_;
  }

 private:
  template <typename Action>
  void unless_rejected(Action action) {
    if (rejected_) return;
    try {
      action();
    } catch (const Rejected& rejected) {
      rejected_ = rejected;
    }
  }

  std::string expected() const {
    if (expected_.empty()) return "no more members";
    std::string result;
    for (const std::string& key : expected_) {
      result += (result.empty() ? "\"" : " or \"") + key + "\"";
    }
    return result;
  }

  void read_format(const Value& value) const {
    const char* other = question_.direction ? kVerdictFormat : kMarginFormat;
    if (is_text(value, other)) {
      syntax_.fail(
          value.line, "format",
          question_.direction
              ? std::string("a certificate of one verdict; ask without --direction")
              : std::string("a certificate of a margin; ask with --direction WX,WY,T"));
    }
    const std::string wanted = question_.direction ? kMarginFormat : kVerdictFormat;
    syntax_.expect(is_text(value, wanted.c_str()), value, "format", "\"" + wanted + "\"");
  }

  void accept_question(const Claim& claim) {
    const Rational furthest = check_claim(claim, question_);
    accepted_.snapped = claim.normals ? claim.normals->size() : 0;
    accepted_.snapped_by = decimal_above_sqrt(furthest);
    rows_.reserve(question_.contacts.size());
    for (std::size_t i = 0; i < question_.contacts.size(); ++i) {
      std::optional<Row> row = make_row(question_.contacts[i]);
      if (!row) {
        throw Malformed{
            grasp_file_, "contacts[" + std::to_string(i) + "].normal",
            "its length is irrational and the contact has a preload, so there is no "
            "exact question; snap the normals (--snap-normals EPS, both when "
            "deciding and here)"};
      }
      rows_.push_back(std::move(*row));
    }
  }

  std::optional<Rational> number_or_null(const Value& value, const std::string& place) const {
    if (value.kind == Value::Kind::kNull) return std::nullopt;
    return syntax_.number(value, place);
  }

  void read_resisted(const Value& value) {
    syntax_.expect(value.kind == Value::Kind::kArray, value, "resisted",
                   "an array of intervals");
    for (const Value& entry : value.items) {
      const std::string place = "resisted[" + std::to_string(resisted_.size()) + "]";
      syntax_.expect(entry.is_array(2), entry, place, "[low, high] or [low, null]");
      resisted_.push_back(
          {syntax_.number(entry.items[0], place), number_or_null(entry.items[1], place)});
    }
  }

  /// POINT (FORMAT.md §10).
  MarginPoint point(const Value& value, bool may_be_ray, const std::string& place) const {
    syntax_.expect(value.is_array(3), value, place, "a point [lambda, twist, forces]");
    MarginPoint result;
    if (may_be_ray) {
      result.lambda = number_or_null(value.items[0], place);
    } else {
      result.lambda = syntax_.number(value.items[0], place);
    }
    result.witness.h = result.lambda ? 1 : 0;
    result.witness.d = syntax_.numbers<3>(value.items[1], 0, place);
    const Value& forces = value.items[2];
    syntax_.expect(forces.kind == Value::Kind::kArray, forces, place, "an array of forces");
    for (const Value& force : forces.items) {
      result.witness.forces.push_back(syntax_.numbers<2>(force, 0, place));
    }
    result.witness.stated = forces.items.size();
    return result;
  }

  void finish_list(const std::string& key) {
    if (key == "segments") {
      unless_rejected([&] { segments_->finish(); });
      accept_margin();
      expected_ = {"tree"};
      return;
    }
    expected_.clear();
    unless_rejected([&] {
      if (key == "forces") {
        witness_.stated = elements_;
        check_witness(rows_, question_.wrench, question_.bilateral, witness_);
        return;
      }
      tree_->finish();
      accepted_.nodes = tree_->nodes();
      accepted_.leaves = tree_->leaves();
      accepted_.voids = tree_->voids();
      if (accepted_.margin) accepted_.margin->trees = tree_->trees();
    });
  }

  void accept_margin() {
    accepted_.verdict = "margin";
    ResistedMargin& margin = accepted_.margin.emplace();
    spell(*question_.direction, margin.direction);
    for (const auto& [low, high] : resisted_) {
      margin.intervals.push_back({low.get_str(), std::nullopt});
      if (high) margin.intervals.back().high = high->get_str();
    }
    margin.segments = elements_;
  }

  static void spell(const Vector3& v, std::string (&texts)[3]) {
    for (std::size_t j = 0; j < 3; ++j) texts[j] = v[j].get_str();
  }

  Question question_;
  std::string grasp_file_;
  Syntax syntax_;
  bool exact_only_;
  std::vector<std::string> expected_{"format"};
  std::vector<Row> rows_;
  Witness witness_;                 ///< of "stable"
  std::vector<Interval> resisted_;  ///< of a margin, as is the next
  std::unique_ptr<Segments> segments_;
  std::unique_ptr<TreeWalk> tree_;
  std::uint64_t elements_ = 0;  ///< of forces, segments or tree
  std::optional<Rejected> rejected_;
  Accepted accepted_;
};

}  // namespace

Answer check(std::istream& grasp, std::istream& certificate, const QuestionOptions& options,
             const std::string& grasp_name, const std::string& certificate_name,
             bool exact_only) {
  try {
    Certificate reader(read_question(grasp, grasp_name, options), grasp_name, certificate_name,
                       exact_only);
    read_json(certificate, certificate_name, kLimits, reader);
    return reader.finish();
  } catch (const Malformed& malformed) {
    return malformed;
  }
}

}  // namespace stickslip_check
