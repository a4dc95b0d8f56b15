// SPDX-License-Identifier: GPL-3.0-or-later
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
    problem_ = Problem(question.loaded, question.law);
  }

  void run() {
    counts();
    for (std::size_t i = 0; i < problem_.size(); ++i) forces(i);
    twists();
    self_balanced();
    equivalent();
  }

 private:
  void add(const std::string& kind, const Json& edited, Expectation expected = {}) {
    mutants_.push_back(mutant(kind, original_, edited, std::move(expected)));
  }

  void counts() {
    Json edited = json_;
    edited["forces"].push_back({0, 0});
    add("extra force", edited, Expectation::of_rule("witness-count"));
    if (problem_.size() == 0) return;
    edited = json_;
    edited["forces"].erase(any_of(random_, edited["forces"]));
    add("drop force", edited, Expectation::of_rule("witness-count"));
    if (problem_.size() < 2) return;
    edited = json_;
    std::swap(edited["forces"][0], edited["forces"][problem_.size() - 1]);
    add("exchange forces", edited);
  }

  /// N_i and T_i are independent, so that another force is another wrench.
  void forces(std::size_t i) {
    const Expectation wrong = Expectation::of_rule("witness-balance");
    const Json& force = json_["forces"][i];
    for (const std::size_t j : {0, 1}) {
      Json edited = json_;
      const Rational value = number_of(force[j]);
      edited["forces"][i][j] = json_of(value + random_.pick<Rational>({1, Rational(-1, 9)}));
      add("change force", edited, wrong);
      if (value.is_zero()) continue;
      edited["forces"][i][j] = json_of(-value);
      add("flip sign of force", edited, wrong);
    }
    if (number_of(force[0]).is_zero() && number_of(force[1]).is_zero()) return;
    const Rational factor = random_.pick<Rational>({0, Rational(1, 2), Rational(999, 1000)});
    Json edited = json_;
    for (const std::size_t j : {0, 1}) {
      edited["forces"][i][j] = json_of(factor * number_of(force[j]));
    }
    add("shrink force", edited, wrong);
  }

  void add_twist(const std::string& kind, const Vector3& change, Expectation expected = {}) {
    Json edited = json_;
    for (std::size_t j = 0; j < 3; ++j) {
      edited["twist"][j] = json_of(number_of(json_["twist"][j]) + change[j]);
    }
    add(kind, edited, std::move(expected));
  }

  void twists() {
    // Closed contacts with a force answer to every motion along their normals.
    std::vector<Vector3> normals;
    std::vector<Vector3> all_normals;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      all_normals.push_back(coordinates(problem_.rows()[i].normal));
      if (!number_of(json_["forces"][i][0]).is_zero()) normals.push_back(all_normals.back());
    }
    const Vector3 change{Rational(random_.between(-2, 2)), Rational(random_.between(-2, 2)),
                         Rational(random_.between(1, 4), 3)};
    const std::optional<Vector3> unnoticed = orthogonal_to(normals);
    add_twist("change twist", change,
              unnoticed ? Expectation{} : Expectation::of_rule("witness-normal"));
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

  /// Forces that add up to nothing: only the laws of the contacts can tell.
  void self_balanced() {
    std::vector<Vector3> tangents;
    std::vector<Vector3> all;
    for (const ContactRow& row : problem_.rows()) {
      tangents.push_back(coordinates(row.tangent));
      all.push_back(coordinates(row.normal));
    }
    all.insert(all.end(), tangents.begin(), tangents.end());
    const std::size_t m = problem_.size();
    for (const int size : {1, -1, 100}) {
      if (const auto x = dependency(tangents)) {
        Json edited = json_;
        for (std::size_t i = 0; i < m; ++i) {
          Json& b = edited["forces"][i][1];
          b = json_of(number_of(b) + Rational(size, 4) * (*x)[i]);
        }
        add("add friction in balance", edited);
      }
      if (const auto x = dependency(all)) {
        Json edited = json_;
        for (std::size_t i = 0; i < m; ++i) {
          for (const std::size_t j : {0, 1}) {
            Json& value = edited["forces"][i][j];
            value = json_of(number_of(value) + Rational(size, 4) * (*x)[i + j * m]);
          }
        }
        add("add forces in balance", edited);
      }
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
