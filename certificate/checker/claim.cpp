// SPDX-License-Identifier: MIT
#include "claim.hpp"

#include <algorithm>

#include "answer.hpp"

namespace stickslip_check {
namespace {

void check_members(const Syntax& syntax, const Value& value, const std::string& place) {
  syntax.expect(value.kind == Value::Kind::kObject, value, place, "an object {...}");
  const std::vector<std::string> order{"contacts", "wrench", "preload", "normal_law",
                                       "normals"};
  std::size_t next = 0;
  for (const std::string& key : value.keys) {
    const auto at =
        std::find(order.begin() + static_cast<std::ptrdiff_t>(next), order.end(), key);
    if (at == order.end()) {
      syntax.fail(value.line, place,
                  "the member " + quote(key) + " is unknown or out of order");
    }
    next = static_cast<std::size_t>(at - order.begin()) + 1;
  }
  for (const char* key : {"contacts", "wrench", "normal_law"}) {
    if (value.find(key) == nullptr) {
      syntax.fail(value.line, place, std::string("the member \"") + key + "\" is missing");
    }
  }
}

/// `question-normals` for one entry: why it may not stand, or nothing.
std::optional<std::string> refusal_of(const NewNormal& entry, const Integer& above,
                                      const Question& question) {
  if (entry.contact <= above || entry.contact >= question.contacts.size()) {
    return "no contact of the grasp above the one before";
  }
  return snap_refusal(question.contacts[entry.contact.get_ui()], entry.u,
                      *question.snap_tolerance);
}

}  // namespace

Claim read_claim(const Syntax& syntax, const Value& value) {
  check_members(syntax, value, "question");
  Claim claim;
  claim.contacts = syntax.index(*value.find("contacts"), "question.contacts");
  claim.wrench = syntax.numbers<3>(*value.find("wrench"), 0, "question.wrench");
  if (const Value* preload = value.find("preload")) {
    claim.preload = syntax.number(*preload, "question.preload");
  }
  const Value& law = *value.find("normal_law");
  claim.bilateral = is_text(law, "bilateral");
  syntax.expect(claim.bilateral || is_text(law, "unilateral"), law, "question.normal_law",
                R"("unilateral" or "bilateral")");
  if (const Value* list = value.find("normals")) {
    syntax.expect(list->kind == Value::Kind::kArray, *list, "question.normals", "an array");
    claim.normals.emplace();
    for (const Value& entry : list->items) {
      const Vector2 u = syntax.numbers<2>(entry, 1, "question.normals");
      claim.normals->push_back({syntax.index(entry.items[0], "question.normals"), u});
    }
  }
  return claim;
}

void reject_question(const char* rule, const std::string& stated, const std::string& asked) {
  throw Rejected{rule, std::nullopt, "",
                 "the certificate is about " + stated + ", the question about " + asked};
}

Rational check_claim(const Claim& claim, Question& question) {
  const std::size_t m = question.contacts.size();
  const auto preloads = [](const std::optional<Rational>& preload) {
    return preload ? "the preload " + show(*preload) : "the file's own preloads";
  };
  if (claim.contacts != m) {
    reject_question("question-contacts", show(Rational(claim.contacts)),
                    std::to_string(m) + " contacts");
  }
  if (claim.wrench != question.wrench) {
    reject_question("question-wrench", show(claim.wrench), show(question.wrench));
  }
  if (claim.preload != question.preload) {
    reject_question("question-preload", preloads(claim.preload), preloads(question.preload));
  }
  if (claim.bilateral != question.bilateral) {
    reject_question("question-law", law_name(claim.bilateral), law_name(question.bilateral));
  }
  Rational furthest = 0;
  if (!claim.normals) return furthest;
  if (!question.snap_tolerance) {
    throw Rejected{"question-normals", std::nullopt, "", "nobody asked for snapped normals"};
  }
  Integer above = -1;
  for (const NewNormal& entry : *claim.normals) {
    if (const auto refusal = refusal_of(entry, above, question)) {
      throw Rejected{"question-normals", std::nullopt, "",
                     "contact " + show(Rational(entry.contact)) + ": " + *refusal};
    }
    GraspContact& contact = question.contacts[entry.contact.get_ui()];
    furthest = std::max(furthest, snap_distance_squared(contact, entry.u));
    contact.normal = entry.u;
    above = entry.contact;
  }
  return furthest;
}

std::string law_name(bool bilateral) {
  return bilateral ? "bilateral" : "unilateral";
}

}  // namespace stickslip_check
