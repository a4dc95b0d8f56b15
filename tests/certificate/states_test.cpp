// SPDX-License-Identifier: GPL-3.0-or-later
// Counts of faces by stickslip-check, which uses flats, beside the enumerator, which splits
// cones, and a naive count by deletion and restriction. None of them shares code with another.
#include "states.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "answer.hpp"
#include "faces_by_programs.hpp"
#include "families.hpp"
#include "rounds.hpp"
#include "stickslip/arrangement/contact_states.hpp"
#include "stickslip/arrangement/faces.hpp"

namespace stickslip {
namespace {

using stickslip_check::Form;
using test::Random;
using Numbers = std::vector<std::uint64_t>;

std::vector<Row> random_rows(Random& random, std::size_t count, std::size_t coordinates,
                             int most) {
  std::vector<Row> rows(count, Row(coordinates));
  for (Row& row : rows) {
    for (std::size_t j = 0; j < coordinates; ++j) row[j] = random.between(-most, most);
  }
  return rows;
}

std::vector<Form> forms_of(const std::vector<Row>& rows) {
  std::vector<Form> forms;
  for (const Row& row : rows) {
    Form& form = forms.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j) form.emplace_back(row[j].str());
  }
  return forms;
}

Numbers by_flats(std::size_t coordinates, const std::vector<Row>& rows,
                 const std::vector<Row>& closed = {}, std::uint64_t most = 10'000'000) {
  Numbers result;
  for (const auto& x :
       stickslip_check::count_faces(forms_of(rows), forms_of(closed), coordinates, most)) {
    result.push_back(x.get_ui());
  }
  return result;
}

Numbers by_cones(std::size_t coordinates, const std::vector<Row>& rows,
                 const std::vector<Row>& closed = {}) {
  std::vector<FacePlane> planes;
  for (const Row& row : rows) planes.push_back({row});
  for (const Row& row : closed) planes.push_back({row, AllowedSigns::kZero});
  return count_faces(coordinates, planes).by_dimension;
}

TEST(StatesOfCertificates, DegenerateArrangementsHaveAsManyFacesAsAreFound) {
  Random random(1);
  for (int round = 0; round < test::rounds(150); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(2, 6));
    const auto count = static_cast<std::size_t>(random.between(0, 9));
    const auto rows = random_rows(random, count, coordinates, 1);
    const Numbers found = by_flats(coordinates, rows);
    EXPECT_EQ(found, test::faces_by_restriction(coordinates, rows)) << "round " << round;
    EXPECT_EQ(found, by_cones(coordinates, rows)) << "round " << round;
  }
}

TEST(StatesOfCertificates, LargerOnesToo) {
  Random random(2);
  for (int round = 0; round < test::rounds(10); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(4, 7));
    const auto rows = random_rows(random, 14, coordinates, 1);
    EXPECT_EQ(by_flats(coordinates, rows), by_cones(coordinates, rows)) << "round " << round;
  }
}

TEST(StatesOfCertificates, ThoseWhereOtherPlanesMeetToo) {
  Random random(3);
  for (int round = 0; round < test::rounds(100); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(2, 6));
    const auto closed =
        random_rows(random, static_cast<std::size_t>(random.between(1, 4)), coordinates, 1);
    const auto rows = random_rows(random, 7, coordinates, 1);
    EXPECT_EQ(by_flats(coordinates, rows, closed), by_cones(coordinates, rows, closed))
        << "round " << round;
  }
}

std::vector<Row> rows_of_contacts(Random& random, std::size_t contacts, bool across_x) {
  GraspBox grasp;
  grasp.wrench.resize(6);
  for (std::size_t i = 0; i < contacts; ++i) {
    const Vector3 p = random.vector(1000);
    Vector3 n = random.vector(1000);
    for (Rational& x : n) x += x.sign() < 0 ? -1000 : 1000;
    if (across_x) n[i < 7 ? 0 : i < 9 ? 1 : 2] = random.between(1, 999);
    UncertainContact contact;
    for (const Rational& x : p) contact.position.push_back(point_interval(x));
    contact.normal = {n[0], n[1], n[2]};
    grasp.contacts.push_back(std::move(contact));
  }
  std::vector<Row> rows;
  for (const ContactRows& contact : contact_rows_for_states(grasp, {})) {
    rows.insert(rows.end(), contact.lines.begin(), contact.lines.end());
  }
  return rows;
}

std::uint64_t sum(const Numbers& numbers) {
  std::uint64_t total = 0;
  for (const std::uint64_t x : numbers) total += x;
  return total;
}

TEST(StatesOfCertificates, CountsOfTheContract) {
  Random random(4);
  EXPECT_EQ(sum(by_flats(6, rows_of_contacts(random, 4, false))), 4513u);
  EXPECT_EQ(sum(by_flats(6, random_rows(random, 12, 6, 1000))), 54257u);
}

TEST(StatesOfCertificates, SixDependentRowsOfTwenty) {
  Random random(6);
  const std::vector<Row> rows = rows_of_contacts(random, 10, true);
  EXPECT_EQ(sum(by_flats(6, rows)), 1009937u);
}

TEST(StatesOfCertificates, MoreFlatsThanAreListedEndTheCount) {
  Random random(5);
  const auto rows = random_rows(random, 200, 6, 1000);
  try {
    by_flats(6, rows, {}, 1000);
    FAIL() << "there are more";
  } catch (const stickslip_check::Rejected& rejected) {
    EXPECT_EQ(rejected.rule, "state-complete");
  }
}

}  // namespace
}  // namespace stickslip
