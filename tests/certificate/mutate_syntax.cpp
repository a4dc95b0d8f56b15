// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

class SyntaxMutations {
 public:
  SyntaxMutations(RandomSource& random, const Certified& original, Mutants& mutants)
      : random_(random),
        original_(original),
        mutants_(mutants),
        json_(Json::parse(original.text)) {}

  void run() {
    text();
    members();
    numbers();
    nesting();
  }

 private:
  void add(const std::string& kind, const std::string& certificate,
           Expectation expected = Expectation::malformed()) {
    CheckerInput input = original_.input();
    input.certificate = certificate;
    mutants_.push_back({kind, original_.name(), std::move(input), std::move(expected)});
  }
  void add(const std::string& kind, const Json& edited,
           Expectation expected = Expectation::malformed()) {
    mutants_.push_back(mutant(kind, original_, edited, std::move(expected)));
  }

  /// The text with a value in it spelled in a way that Json cannot hold.
  std::string spelled(Json edited, const Json::json_pointer& at, const std::string& spelling) {
    edited[at] = "THE VALUE";
    std::string result = edited.dump();
    const std::string marked = "\"THE VALUE\"";
    return result.replace(result.find(marked), marked.size(), spelling);
  }

  /// Some NUMBER of the evidence or the question.
  Json::json_pointer any_number() {
    std::vector<std::string> places{"/question/wrench/" +
                                    std::to_string(random_.between(0, 2))};
    if (json_.contains("twist")) {
      places.push_back("/twist/" + std::to_string(random_.between(0, 2)));
      if (!json_["shares"].empty()) places.emplace_back("/shares/0/1");
    } else {
      for (std::size_t i = 0; i < json_["tree"].size(); ++i) {
        if (json_["tree"][i][0] != "leaf") continue;
        places.push_back("/tree/" + std::to_string(i) + "/" +
                         std::to_string(random_.between(1, 3)));
        break;
      }
    }
    return Json::json_pointer(random_.pick(places));
  }

  void text() {
    const std::string& whole = original_.text;
    const auto last = static_cast<int>(whole.find_last_of('}'));
    for (int round = 0; round < 4; ++round) {
      add("truncate", whole.substr(0, static_cast<std::size_t>(random_.between(0, last))));
    }
    add("anything after the end",
        whole + random_.pick<std::string>({"x", "{}", "]", "0", "//"}));
    add("NUL after the end", whole + std::string(1, '\0'));
    add("byte order mark", "\xEF\xBB\xBF" + whole);
    add("blanks around", " \t\r\n" + whole + "\n \r\t", Expectation::accepted());
    add("not UTF-8", replaced_once(whole, "\"tests\"", "\"te\xFFsts\""));
    add("control character in a string", replaced_once(whole, "\"tests\"", "\"te\nsts\""));
    add("half of a surrogate pair", replaced_once(whole, "\"tests\"", R"("\ud800")"));
    add("other producer", replaced_once(whole, "\"tests\"", R"("\u00e9\ud83e\udd16\\\"")"),
        Expectation::accepted());
    add("comment", "/* */" + whole);
    add("trailing comma", whole.substr(0, static_cast<std::size_t>(last)) + ",}");
  }

  static std::string replaced_once(std::string text, const std::string& from,
                                   const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }

  void members() {
    for (const char* version :
         {"stickslip-certificate/1", "stickslip-certificate/2.0", "stickslip-grasp/1", ""}) {
      Json edited = json_;
      edited["format"] = version;
      add("wrong version", edited);
    }
    const std::string body = json_.dump().substr(1);
    for (const char* key : {"format", "question", "verdict"}) {
      // The same member again, at the front or at the end.
      const std::string member = Json(key).dump() + ":" + json_[key].dump();
      add("duplicate key", "{" + member + "," + body);
      add("duplicate key", "{" + body.substr(0, body.size() - 1) + "," + member + "}");
      Json missing = json_;
      missing.erase(key);
      add("missing member", missing);
      if (key == std::string("question")) continue;
      Json mistyped = json_;
      mistyped[key] = random_.pick<Json>({Json(1), Json(nullptr), Json(true), Json::array()});
      add("member of another type", mistyped);
    }
    add("duplicate key in the question",
        spelled(json_, Json::json_pointer("/question/contacts"),
                json_["question"]["contacts"].dump() +
                    ",\"contacts\":" + json_["question"]["contacts"].dump()));
    Json unknown = json_;
    unknown["remark"] = "more";
    add("unknown member", unknown);
    unknown = json_;
    unknown["question"]["remark"] = 1;
    add("unknown member in the question", unknown);
    Json reordered;
    reordered["question"] = json_["question"];
    for (const auto& [key, value] : json_.items()) reordered[key] = value;
    add("members out of order", reordered);
    Json question;
    question["wrench"] = json_["question"]["wrench"];
    for (const auto& [key, value] : json_["question"].items()) question[key] = value;
    reordered = json_;
    reordered["question"] = question;
    add("members of the question out of order", reordered);
    Json other = json_;
    other["verdict"] = json_["verdict"] == "stable" ? "unstable" : "stable";
    add("other verdict", other);
    other["verdict"] = "undecided";
    add("no such verdict", other);
    Json anonymous = json_;
    anonymous.erase("producer");
    add("no producer", anonymous, Expectation::accepted());
  }

  void numbers() {
    for (const char* spelling :
         {"NaN",      "Infinity", "-Infinity", "\"nan\"",    "\"inf\"", "1.0",    "1e5",
          "1E400",    "-0.5",     "\"1.5\"",   "\"1e5\"",    "\"+1\"",  "\" 1\"", "\"1/0\"",
          "\"1/-2\"", "\"\"",     "\"0x10\"",  "01",         "--1",     "+1",     "null",
          "true",     "[]",       "{}",        "\"\\u0661\""}) {
      const bool nan = std::string(spelling) == "NaN";
      if (!nan && !random_.one_in(4)) continue;
      add(nan ? "NaN" : "not a number", spelled(json_, any_number(), spelling));
    }
    const auto huge = [&](const std::string& kind, const std::string& spelling) {
      add(kind, spelled(json_, any_number(), spelling));
    };
    huge("huge JSON integer", "-1" + std::string(4000, '0'));
    huge("huge JSON integer", "1" + std::string(70000, '0'));
    huge("huge string", "\"1" + std::string(65536, '0') + "\"");
    huge("huge fraction", "\"1/1" + std::string(65534, '0') + "\"");
    // Within the limits; the question or a rule refuses it, or it makes no difference.
    const std::size_t digits = random_.one_in(8) ? 65533 : 400;
    for (const std::string& spelling :
         {std::string("1") + std::string(digits < 4000 ? digits : 3999, '0'),
          "\"1" + std::string(digits, '0') + "/1\"",
          "\"1/1" + std::string(digits - 1, '3') + "\""}) {
      add("large number", spelled(json_, any_number(), spelling), Expectation{});
    }
    const Json m = json_["question"]["contacts"];
    const Json::json_pointer contacts("/question/contacts");
    add("contacts as a string", spelled(json_, contacts, "\"" + m.dump() + "\""));
    add("contacts as a fraction", spelled(json_, contacts, m.dump() + ".0"));
    add("negative contacts", spelled(json_, contacts, "-1"));
  }

  void nesting() {
    const Json::json_pointer at = any_number();
    for (const std::size_t depth : {1U, 9U, 100000U}) {
      add("deep nesting",
          spelled(json_, at, std::string(depth, '[') + "1" + std::string(depth, ']')));
    }
    add("unclosed nesting", "{\"format\":" + std::string(200000, '['));
    const char* list = json_.contains("tree") ? "tree" : "shares";
    Json edited = json_;
    edited[list] = Json::object();
    add("an object for a list", edited);
    edited[list] = Json::array({Json::array()});
    add("empty element", edited);
    edited[list] = Json::array({Json::array({"leaf", 1, 2})});
    add("short element", edited);
    edited[list] = Json::array({Json::array({"leaves", 1, 2, 3})});
    add("unknown element", edited);
    // Malformed at the end counts, although a rule fails before.
    edited = json_;
    edited["question"]["contacts"] = 1000;
    add("a rule fails before the end is malformed", edited.dump() + ",");
  }

  RandomSource& random_;
  const Certified& original_;
  Mutants& mutants_;
  const Json json_;
};

std::string damaged(RandomSource& random, std::string text) {
  static const std::string kLikely = "0123456789-+.,:/\"[]{}eE \\\n\xFF";
  for (int edits = random.between(1, 3); edits > 0; --edits) {
    const auto at =
        static_cast<std::size_t>(random.between(0, static_cast<int>(text.size()) - 1));
    const char c = kLikely[static_cast<std::size_t>(
        random.between(0, static_cast<int>(kLikely.size()) - 1))];
    switch (random.between(0, 2)) {
      case 0:
        text[at] = c;
        break;
      case 1:
        text.insert(at, 1, c);
        break;
      default:
        if (text.size() > 1) text.erase(at, 1);
    }
  }
  return text;
}

}  // namespace

void mutate_syntax(RandomSource& random, const Certified& original, Mutants& mutants) {
  SyntaxMutations(random, original, mutants).run();
}

void mutate_bytes(RandomSource& random, const Certified& original, Mutants& mutants) {
  for (int round = 0; round < 4; ++round) {
    CheckerInput input = original.input();
    input.certificate = damaged(random, input.certificate);
    mutants.push_back({"bytes of the certificate", original.name(), input, {}});
    input = original.input();
    input.grasp = damaged(random, input.grasp);
    mutants.push_back({"bytes of the grasp file", original.name(), input, {}});
  }
}

}  // namespace stickslip::test
