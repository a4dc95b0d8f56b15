// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const Vector3& v) {
  return v == Vector3{0, 0, 0};
}

Rational dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A nonzero vector orthogonal to all of them, if there is one.
std::optional<Vector3> orthogonal_to(const std::vector<Vector3>& vectors) {
  std::optional<Vector3> first;
  for (const Vector3& v : vectors) {
    if (is_zero(v)) continue;
    if (!first) first = v;
    const Vector3 candidate = cross(*first, v);
    if (is_zero(candidate)) continue;
    for (const Vector3& other : vectors) {
      if (!dot(candidate, other).is_zero()) return std::nullopt;
    }
    return candidate;
  }
  if (!first) return Vector3{1, 0, 0};
  const Vector3 candidate = cross(*first, {0, 0, 1});
  return is_zero(candidate) ? cross(*first, {0, 1, 0}) : candidate;
}

/// x with sum of x_i vectors_i = 0, x != 0, if there is one: four vectors always have it.
std::optional<std::vector<Rational>> dependency(const std::vector<Vector3>& vectors) {
  // Each vector with the combination of the originals that it is; eliminated one by one.
  std::vector<std::pair<Vector3, std::vector<Rational>>> basis;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    Vector3 rest = vectors[i];
    std::vector<Rational> x(vectors.size());
    x[i] = 1;
    for (const auto& [pivot, combination] : basis) {
      std::size_t j = 0;
      while (pivot[j].is_zero()) ++j;
      const Rational factor = rest[j] / pivot[j];
      for (std::size_t k = 0; k < 3; ++k) rest[k] -= factor * pivot[k];
      for (std::size_t k = 0; k < x.size(); ++k) x[k] -= factor * combination[k];
    }
    if (is_zero(rest)) return x;
    basis.emplace_back(rest, x);
  }
  return std::nullopt;
}

class WitnessMutations {
 public:
  WitnessMutations(RandomSource& random, const Certified& original, Mutants& mutants)
      : random_(random),
        original_(original),
        mutants_(mutants),
        json_(Json::parse(original.text)) {
    const Question question = original.about.question();
    problem_ = Problem(question.loaded(), question.law);
  }

  void run() {
    lists();
    for (std::size_t i = 0; i < problem_.size(); ++i) share(i);
    twists();
    self_balanced();
    equivalent();
  }

 private:
  void add(const std::string& kind, const Json& edited, Expectation expected = {}) {
    mutants_.push_back(mutant(kind, original_, edited, std::move(expected)));
  }

  using Shares = std::map<std::size_t, Rational>;

  Shares shares() const {
    Shares result;
    for (const Json& entry : json_["shares"]) {
      result[entry[0].get<std::size_t>()] = number_of(entry[1]);
    }
    return result;
  }

  void add_shares(const std::string& kind, const Shares& shares, Expectation expected = {}) {
    Json edited = json_;
    edited["shares"] = Json::array();
    for (const auto& [contact, value] : shares) {
      edited["shares"].push_back({contact, json_of(value)});
    }
    add(kind, edited, std::move(expected));
  }

  Twist twist() const {
    const Json& d = json_["twist"];
    return {number_of(d[0]), number_of(d[1]), number_of(d[2])};
  }

  void lists() {
    const Expectation wrong = Expectation::of_rule("witness-share");
    Json edited = json_;
    edited["shares"].push_back({problem_.size(), 0});
    add("share of a contact beyond", edited, wrong);
    if (json_["shares"].empty()) return;
    edited = json_;
    edited["shares"].push_back(json_["shares"].back());
    add("share twice", edited, wrong);
    edited = json_;
    std::reverse(edited["shares"].begin(), edited["shares"].end());
    if (json_["shares"].size() > 1) add("shares out of order", edited, wrong);
    edited["shares"] = Json::array();
    add("no shares", edited);
  }

  /// N_i and T_i are independent, so that another force is another wrench.
  void share(std::size_t i) {
    const ContactRow& row = problem_.rows()[i];
    const bool slips = power(row.tangent, twist()) != 0;
    const bool carries = row.friction > 0 && row.normal_coefficient(twist()) > 0;
    Shares edited = shares();
    const Rational own = edited[i];
    const auto with = [&](const std::string& kind, const Rational& value, const char* rule) {
      edited[i] = value;
      add_shares(kind, edited,
                 rule == nullptr ? Expectation::accepted() : Expectation::of_rule(rule));
    };
    if (slips) {
      with("share where a contact slips", 0, "witness-share");
      return;
    }
    with("share above 1", 1 + Rational(1, 1000000000), "witness-share");
    with("share below -1", -2, "witness-share");
    const char* rule = carries ? "witness-balance" : nullptr;
    with("change share",
         own > 0 ? Rational(own - Rational(1, 1000000000)) : Rational(own + 1) / 2,
         own == 1 && carries ? "witness-balance" : rule);
    if (own != 0) with("flip sign of share", -own, rule);
    if (own != 0) with("zero share", 0, rule);
  }

  void add_twist(const std::string& kind, const Vector3& change, Expectation expected = {}) {
    Json edited = json_;
    for (std::size_t j = 0; j < 3; ++j) {
      edited["twist"][j] = json_of(number_of(json_["twist"][j]) + change[j]);
    }
    add(kind, edited, std::move(expected));
  }

  void twists() {
    std::vector<Vector3> all_normals;
    for (const ContactRow& row : problem_.rows())
      all_normals.push_back(coordinates(row.normal));
    add_twist("change twist",
              {Rational(random_.between(-2, 2)), Rational(random_.between(-2, 2)),
               Rational(random_.between(1, 4), 3)});
    const std::size_t j = any_of(random_, json_["twist"]);
    Vector3 flipped{};
    flipped[j] = -2 * number_of(json_["twist"][j]);
    add_twist("flip sign in twist", flipped);
    // A motion on which no contact closes or opens shows at most as slip.
    if (const auto free = orthogonal_to(all_normals)) {
      const Rational size(random_.between(1, 9), random_.pick<int>({1, -1, 5}));
      add_twist("slide", {size * (*free)[0], size * (*free)[1], size * (*free)[2]});
    }
  }

  /// Friction that adds up to nothing where contacts stick: only its bound can tell.
  void self_balanced() {
    std::vector<std::size_t> sticking;
    std::vector<Vector3> tangents;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const ContactRow& row = problem_.rows()[i];
      const Rational edge = row.friction * row.normal_coefficient(twist());
      if (power(row.tangent, twist()) != 0 || edge <= 0) continue;
      sticking.push_back(i);
      Vector3 full = coordinates(row.tangent);
      for (Rational& c : full) c *= edge;
      tangents.push_back(full);
    }
    const auto x = dependency(tangents);
    if (!x) return;
    for (const int size : {1, -1, 100}) {
      Shares edited = shares();
      bool within = true;
      for (std::size_t k = 0; k < sticking.size(); ++k) {
        Rational& share = edited[sticking[k]];
        share += Rational(size, 4) * (*x)[k];
        within = within && share <= 1 && share >= -1;
      }
      add_shares("add friction in balance", edited,
                 within ? Expectation::accepted() : Expectation::of_rule("witness-share"));
    }
  }

  void equivalent() {
    Json edited = json_;
    for (Json& entry : edited["twist"]) {
      const Rational value = number_of(entry);
      entry = to_string(Rational(numerator(value) * 10)) + "/" +
              to_string(Rational(denominator(value) * 10));
    }
    add("fractions not in lowest terms", edited, Expectation::accepted());
  }

  RandomSource& random_;
  const Certified& original_;
  Mutants& mutants_;
  const Json json_;
  Problem problem_;
};

}  // namespace

void mutate_witness(RandomSource& random, const Certified& original, Mutants& mutants) {
  WitnessMutations(random, original, mutants).run();
}

}  // namespace stickslip::test
