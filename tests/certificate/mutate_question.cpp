// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_edit.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::test {
namespace {

class QuestionMutations {
 public:
  QuestionMutations(RandomSource& random, const Certified& original, Mutants& mutants)
      : random_(random),
        original_(original),
        mutants_(mutants),
        json_(Json::parse(original.text)) {}

  void run() {
    stated();
    asked();
    others();
  }

 private:
  /// The certificate's `question` with one member set.
  void add(const std::string& kind, const char* member, const Json& value,
           const std::string& rule) {
    Json edited = json_;
    Json question;  // members keep their order
    for (const char* key :
         {"contacts", "wrench", "preload", "normal_law", "direction", "preload_direction"}) {
      if (key == std::string(member)) {
        if (!value.is_null()) question[key] = value;
      } else if (json_["question"].contains(key)) {
        question[key] = json_["question"][key];
      }
    }
    edited["question"] = question;
    mutants_.push_back(mutant(kind, original_, edited, Expectation::of_rule(rule)));
  }

  void ask(const std::string& kind, const QuestionOptions& options, const std::string& rule) {
    CheckerInput input = original_.input();
    input.options = options;
    mutants_.push_back({kind, original_.name(), input, Expectation::of_rule(rule)});
  }

  void stated() {
    const Json& question = json_["question"];
    const auto m = question["contacts"].get<std::int64_t>();
    add("one contact more", "contacts", m + 1, "question-contacts");
    if (m > 0) add("one contact fewer", "contacts", m - 1, "question-contacts");
    Json wrench = question["wrench"];
    Json& entry = wrench[any_of(random_, wrench)];
    const Rational value = number_of(entry);
    entry = json_of(value + random_.pick<Rational>({1, Rational(-1, 1000000000)}));
    add("change wrench", "wrench", wrench, "question-wrench");
    if (!value.is_zero()) {
      entry = json_of(-value);
      add("flip sign in wrench", "wrench", wrench, "question-wrench");
    }
    if (question.contains("preload")) {
      add("drop preload", "preload", nullptr, "question-preload");
      add("change preload", "preload", "1/2", "question-preload");
    } else {
      add("add preload", "preload", random_.between(0, 1), "question-preload");
    }
    const bool bilateral = question["normal_law"] == "bilateral";
    add("other law", "normal_law", bilateral ? "unilateral" : "bilateral", "question-law");
  }

  /// Not a margin with a preload at a normal of irrational length; of one verdict that is a
  /// box.
  bool can_be_asked(const QuestionOptions& options) const {
    if (!options.direction && !options.preload_direction) return true;
    try {
      const Question question = stickslip::ask(parse_grasp(original_.about.grasp, ""), options);
      problem_of(question);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  void asked() {
    const QuestionOptions& options = original_.about.options;
    QuestionOptions other = options;
    const Wrench wrench = planar_middle(wrench_of(original_.about.question().grasp));
    other.wrench =
        row_of(wrench + Wrench{0, random_.pick<Rational>({1, Rational(1, 1000000)}), 0});
    ask("ask another wrench", other, "question-wrench");
    other = options;
    other.preload = options.preload.value_or(1) + 1;
    CheckerInput input = original_.input();
    input.options = other;
    mutants_.push_back({"ask another preload", original_.name(), input,
                        can_be_asked(other) ? Expectation::of_rule("question-preload")
                                            : Expectation::malformed()});
    other = options;
    other.law =
        options.law == NormalLaw::kBilateral ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    ask("ask another law", other, "question-law");
    other = options;
    other.uncertain.friction = Tolerance{};
    ask("ask with a tolerance", other, "question-uncertain");
  }

  /// Members of other questions: with a direction there is another kind of verdict.
  void others() {
    for (const auto& [member, value] :
         std::vector<std::pair<const char*, Json>>{{"normals", Json::array()},
                                                   {"direction", {0, 1, 0}},
                                                   {"preload_direction", "scale"}}) {
      Json edited = json_;
      edited["question"][member] = value;
      mutants_.push_back(
          mutant("a member of another question", original_, edited, Expectation::malformed()));
    }
    CheckerInput input = original_.input();
    input.options.direction = RationalRow{0, 1, 0};
    input.options.wrench =
        row_of(planar_middle(wrench_of(original_.about.question().grasp)));
    mutants_.push_back({"ask for a margin", original_.name(), input,
                        Expectation::of_rule("question-direction")});
  }

  RandomSource& random_;
  const Certified& original_;
  Mutants& mutants_;
  const Json json_;
};

/// A positive or nonnegative property, changed.
Json changed(RandomSource& random, const Json& value) {
  return json_of(number_of(value) +
                 random.pick<Rational>({1, Rational(1, 2), Rational(1, 1000000000)}));
}

}  // namespace

void mutate_question(RandomSource& random, const Certified& original, Mutants& mutants) {
  QuestionMutations(random, original, mutants).run();
}

void mutate_grasp(RandomSource& random, const Certified& original, Mutants& mutants) {
  const Json grasp = Json::parse(original.about.grasp);
  const auto add = [&](const std::string& kind, const Json& edited, Expectation expected = {}) {
    CheckerInput input = original.input();
    input.grasp = edited.dump();
    mutants.push_back({kind, original.name(), std::move(input), std::move(expected)});
  };
  Json edited = grasp;
  edited["name"] = "another name";
  add("rename the grasp", edited, Expectation::accepted());
  edited["format"] = "stickslip-grasp/3";
  add("wrong version of the grasp", edited, Expectation::malformed());
  if (!original.about.options.wrench) {
    edited = grasp;
    Json& entry = edited["wrench"][any_of(random, grasp["wrench"])];
    entry = changed(random, entry);
    add("change the grasp's wrench", edited, Expectation::of_rule("question-wrench"));
  }
  if (grasp["contacts"].empty()) return;
  edited = grasp;
  edited["contacts"].erase(any_of(random, grasp["contacts"]));
  add("drop a contact", edited, Expectation::of_rule("question-contacts"));
  edited = grasp;
  edited["contacts"].push_back(grasp["contacts"][0]);
  add("add a contact", edited, Expectation::of_rule("question-contacts"));
  for (const char* key : {"position", "normal", "friction", "stiffness", "preload"}) {
    edited = grasp;
    Json& value = edited["contacts"][any_of(random, grasp["contacts"])][key];
    if (value.is_array()) {
      Json& entry = value[any_of(random, value)];
      entry = changed(random, entry);
    } else {
      value = changed(random, value);
    }
    add(std::string("change the grasp's ") + key, edited);
  }
  edited = grasp;
  std::reverse(edited["contacts"].begin(), edited["contacts"].end());
  add("reverse the contacts", edited);
}

void swap_grasps(const Certified& one, const Certified& other, Mutants& mutants) {
  mutants.push_back({"swap grasps",
                     one.name() + " for " + other.name(),
                     {other.about.grasp, one.text, other.about.options},
                     {}});
}

}  // namespace stickslip::test
