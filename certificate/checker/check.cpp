// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "json.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {
namespace {

constexpr JsonLimits kLimits{std::uint64_t{1} << 30U, 8, false, 65536};
constexpr std::size_t kMaxJsonInteger = 4000;

/// Reads a certificate and checks it as it comes. A rule that fails is remembered, and the rest
/// of the file is still read: what is malformed anywhere is malformed.
class Certificate : public JsonHandler {
 public:
  Certificate(Question question, std::string grasp_file, std::string file, bool exact_only)
      : question_(std::move(question)),
        grasp_file_(std::move(grasp_file)),
        file_(std::move(file)),
        exact_only_(exact_only) {}

  bool begin_member(const std::string& key, std::size_t line) override {
    if (std::find(expected_.begin(), expected_.end(), key) == expected_.end()) {
      fail(line, "top level", "found the member " + quote(key) + ", expected " + expected());
    }
    if (key == "tree" && !rejected_) {
      tree_ = std::make_unique<TreeWalk>(rows_, question_.wrench, question_.bilateral);
      if (exact_only_) tree_->use_exact_bounds_only();
    }
    return key == "tree" || key == "forces";
  }

  void element(const Value& value) override {
    if (expected_.front() == "tree") {
      const Node node = read_node(value);
      ++elements_;
      unless_rejected([&] { tree_->visit(node); });
    } else {
      const Vector2 force = numbers<2>(value, 0, "forces[" + std::to_string(elements_) + "]");
      ++elements_;
      if (forces_.size() < question_.contacts.size()) forces_.push_back(force);
    }
  }

  void end_member(const std::string& key, const Value& value) override {
    if (key == "format") {
      expect(is_text(value, "stickslip-certificate/1"), value, key,
             "\"stickslip-certificate/1\"");
      expected_ = {"producer", "question"};
    } else if (key == "producer") {
      expect(value.kind == Value::Kind::kString, value, key, "a string");
      expected_ = {"question"};
    } else if (key == "question") {
      read_question_member(value);
      expected_ = {"verdict"};
    } else if (key == "verdict") {
      const bool stable = is_text(value, "stable");
      expect(stable || is_text(value, "unstable"), value, key, R"("stable" or "unstable")");
      accepted_.verdict = value.text;
      expected_ = {stable ? "twist" : "tree"};
    } else if (key == "twist") {
      twist_ = numbers<3>(value, 0, key);
      expected_ = {"forces"};
    } else {
      expect(value.kind == Value::Kind::kArray, value, key, "an array");
      expected_.clear();
    }
  }

  Answer finish() {
    if (!expected_.empty()) {
      throw Malformed{file_, "top level", "the member " + expected() + " is missing"};
    }
    unless_rejected([&] {
      if (tree_) {
        tree_->finish();
        accepted_.nodes = tree_->nodes();
        accepted_.leaves = tree_->leaves();
        accepted_.voids = tree_->voids();
      } else {
        check_witness(rows_, question_.wrench, question_.bilateral, twist_, forces_, elements_);
      }
    });
    if (rejected_) return *rejected_;
    accepted_.contacts = question_.contacts.size();
    for (std::size_t j = 0; j < 3; ++j) accepted_.wrench[j] = question_.wrench[j].get_str();
    if (question_.preload) accepted_.preload = question_.preload->get_str();
    accepted_.normal_law = law();
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

  [[noreturn]] void fail(std::size_t line, const std::string& place,
                         const std::string& problem) const {
    throw Malformed{file_, "line " + std::to_string(line) + ", " + place, problem};
  }

  void expect(bool good, const Value& value, const std::string& place,
              const std::string& what) const {
    if (!good) fail(value.line, place, "found " + describe(value) + ", expected " + what);
  }

  std::string expected() const {
    if (expected_.empty()) return "no more members";
    std::string result;
    for (const std::string& key : expected_) {
      result += (result.empty() ? "\"" : " or \"") + key + "\"";
    }
    return result;
  }

  static bool is_text(const Value& value, const char* text) {
    return value.kind == Value::Kind::kString && value.text == text;
  }

  /// NUMBER (FORMAT.md §2).
  Rational number(const Value& value, const std::string& place) const {
    std::optional<Rational> read;
    const bool json_integer =
        value.kind == Value::Kind::kNumber && value.text.size() <= kMaxJsonInteger;
    if (json_integer || value.kind == Value::Kind::kString) read = parse_fraction(value.text);
    expect(read.has_value(), value, place, "an integer, or a string such as \"-3/5\"");
    return *read;
  }

  /// CONTACT.
  Integer index(const Value& value, const std::string& place) const {
    expect(value.kind == Value::Kind::kNumber, value, place, "a contact, counted from 0");
    const Rational read = number(value, place);
    expect(read >= 0, value, place, "a contact, counted from 0");
    return read.get_num();
  }

  /// The kSize numbers of an array behind the first `skipped` values.
  template <std::size_t kSize>
  std::array<Rational, kSize> numbers(const Value& value, std::size_t skipped,
                                      const std::string& place) const {
    expect(value.is_array(kSize + skipped), value, place,
           "an array of " + std::to_string(kSize + skipped));
    std::array<Rational, kSize> result;
    for (std::size_t i = 0; i < kSize; ++i) result[i] = number(value.items[skipped + i], place);
    return result;
  }

  std::string law() const { return question_.bilateral ? "bilateral" : "unilateral"; }

  void read_question_member(const Value& value) {
    const std::string place = "question";
    expect(value.kind == Value::Kind::kObject, value, place, "an object {...}");
    const std::vector<std::string> order{"contacts", "wrench", "preload", "normal_law",
                                         "normals"};
    std::size_t next = 0;
    for (const std::string& key : value.keys) {
      const auto at =
          std::find(order.begin() + static_cast<std::ptrdiff_t>(next), order.end(), key);
      if (at == order.end()) {
        fail(value.line, place, "the member " + quote(key) + " is unknown or out of order");
      }
      next = static_cast<std::size_t>(at - order.begin()) + 1;
    }
    for (const char* key : {"contacts", "wrench", "normal_law"}) {
      if (value.find(key) == nullptr) {
        fail(value.line, place, std::string("the member \"") + key + "\" is missing");
      }
    }
    const Integer contacts = index(*value.find("contacts"), "question.contacts");
    const Vector3 wrench = numbers<3>(*value.find("wrench"), 0, "question.wrench");
    std::optional<Rational> preload;
    if (const Value* stated = value.find("preload"))
      preload = number(*stated, "question.preload");
    const Value& stated_law = *value.find("normal_law");
    expect(is_text(stated_law, "unilateral") || is_text(stated_law, "bilateral"), stated_law,
           "question.normal_law", R"("unilateral" or "bilateral")");
    struct NewNormal {
      Integer contact;
      Vector2 u;
    };
    std::vector<NewNormal> normals;
    const Value* list = value.find("normals");
    if (list != nullptr) {
      expect(list->kind == Value::Kind::kArray, *list, "question.normals", "an array");
      for (const Value& entry : list->items) {
        const Vector2 u = numbers<2>(entry, 1, "question.normals");
        normals.push_back({index(entry.items[0], "question.normals"), u});
      }
    }

    unless_rejected([&] {
      const auto reject = [](const char* rule, const std::string& stated,
                             const std::string& asked) {
        throw Rejected{rule, std::nullopt, "",
                       "the certificate is about " + stated + ", the question about " + asked};
      };
      const std::size_t m = question_.contacts.size();
      if (contacts != m) {
        reject("question-contacts", show(Rational(contacts)), std::to_string(m) + " contacts");
      }
      if (wrench != question_.wrench) {
        reject("question-wrench", show(wrench), show(question_.wrench));
      }
      if (preload != question_.preload) {
        reject("question-preload", preload ? show(*preload) : "the file's own preloads",
               question_.preload ? show(*question_.preload) : "the file's own");
      }
      if (stated_law.text != law()) reject("question-law", stated_law.text, law());
      if (list != nullptr && !question_.snap_tolerance) {
        throw Rejected{"question-normals", std::nullopt, "",
                       "nobody asked for snapped normals"};
      }
      Integer above = -1;
      Rational furthest = 0;
      for (const NewNormal& entry : normals) {
        std::optional<std::string> refusal;
        if (entry.contact <= above || entry.contact >= m) {
          refusal = "no contact of the grasp above the one before";
        } else {
          GraspContact& contact = question_.contacts[entry.contact.get_ui()];
          refusal = snap_refusal(contact, entry.u, *question_.snap_tolerance);
          if (!refusal) {
            furthest = std::max(furthest, snap_distance_squared(contact, entry.u));
            contact.normal = entry.u;
          }
        }
        if (refusal) {
          throw Rejected{"question-normals", std::nullopt, "",
                         "contact " + show(Rational(entry.contact)) + ": " + *refusal};
        }
        above = entry.contact;
      }
      accepted_.snapped = normals.size();
      accepted_.snapped_by = decimal_above_sqrt(furthest);
      make_rows();
    });
  }

  static std::string show(const Vector3& v) {
    return "(" + stickslip_check::show(v[0]) + ", " + stickslip_check::show(v[1]) + ", " +
           stickslip_check::show(v[2]) + ")";
  }
  static std::string show(const Rational& x) { return stickslip_check::show(x); }

  void make_rows() {
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

  Node read_node(const Value& value) const {
    const std::string place = "node " + std::to_string(elements_);
    expect(value.kind == Value::Kind::kArray && !value.items.empty() &&
               value.items[0].kind == Value::Kind::kString,
           value, place, "an array that begins with the kind of the node");
    const std::string& kind = value.items[0].text;
    Node node;
    if (kind == "slip" || kind == "separation") {
      node.kind = kind == "slip" ? NodeKind::kSlip : NodeKind::kSeparation;
      expect(value.is_array(2), value, place, "a kind and a contact");
      node.contact = index(value.items[1], place);
    } else if (kind == "plane") {
      node.kind = NodeKind::kPlane;
      const auto a = numbers<4>(value, 1, place);
      node.numbers.assign(a.begin(), a.end());
    } else if (kind == "leaf") {
      node.kind = NodeKind::kLeaf;
      expect(value.is_array(4) || value.is_array(5), value, place,
             "y1, y2, y3 and maybe thetas");
      for (std::size_t j = 1; j < 4; ++j) node.numbers.push_back(number(value.items[j], place));
      if (value.is_array(5)) {
        const Value& list = value.items[4];
        expect(list.kind == Value::Kind::kArray, list, place, "an array [[i, theta], ...]");
        for (const Value& entry : list.items) {
          const Rational theta = numbers<1>(entry, 1, place)[0];
          node.thetas.emplace_back(index(entry.items[0], place), theta);
        }
      }
    } else {
      expect(kind == "void", value.items[0], place, "slip, separation, plane, leaf or void");
      expect(value.is_array(1), value, place, "[\"void\"]");
    }
    return node;
  }

  Question question_;
  std::string grasp_file_;
  std::string file_;
  bool exact_only_;
  std::vector<std::string> expected_{"format"};
  std::vector<Row> rows_;
  std::unique_ptr<TreeWalk> tree_;
  Vector3 twist_;
  std::vector<Vector2> forces_;
  std::uint64_t elements_ = 0;  ///< of forces or tree
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
