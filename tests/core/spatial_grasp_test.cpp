// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps in space: what the writer writes, and the forces that follow from a motion.
#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip {
namespace {

const std::string kText = R"({"format": "stickslip-grasp/2",
 "name": "one",
 "units": {"length": "m", "force": "N"},
 "contacts": [
  {"position": [0, "1/2", {"min": 1, "max": 2}], "normal": [0, 0, 2], "friction": "1/2", "preload": 0},
  {"position": [0, 0, 0], "normal": [1, 1, 1], "friction": {"min": 0, "max": 1}, "stiffness": 3, "preload": 4}],
 "wrench": [1, 2, 3, {"min": 0, "max": 1}, 5, 6],
 "cases": [
  {"name": "a", "wrench": [1, 0, 0, 0, 0, 0]},
  {"name": "b", "wrench": [0, 0, 0, 0, 0, "-1/3"]}]}
)";

GraspFile parse(const std::string& text, Intervals intervals = Intervals::kAllowed) {
  return parse_any_grasp(text, "text", intervals);
}

TEST(WriteSpatialGrasp, Bytes) {
  const GraspFile grasp = parse(kText);
  EXPECT_TRUE(grasp.content.in_space());
  EXPECT_EQ(write_grasp_file(grasp), kText);
  EXPECT_EQ(grasp.cases[0].wrench[0], point_interval(2));  // of all loads
  EXPECT_EQ(grasp.assumed_stiffness, std::vector<ContactId>{ContactId(0)});
  const GraspFile empty{GraspBox{{}, WrenchBox(6)}};
  EXPECT_EQ(write_grasp_file(empty),
            "{\"format\": \"stickslip-grasp/2\",\n \"contacts\": [],\n"
            " \"wrench\": [0, 0, 0, 0, 0, 0]}\n");
  EXPECT_TRUE(parse(write_grasp_file(empty)).content.box()->contacts.empty());
}

TEST(ReadSpatialGrasp, IntervalsWhereTheyAreRefused) {
  try {
    parse(kText, Intervals::kRefused);
    FAIL() << "read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[0].position[2]");
    EXPECT_EQ(error.problem(), "the number is uncertain");
  }
}

/// A file with this body.
std::string with_body(const std::string& body) {
  return R"({"format": "stickslip-grasp/2",
 "body": )" +
         body + R"(,
 "contacts": [],
 "wrench": [0, 0, 0, 0, 0, 0]}
)";
}

TEST(BodyInSpace, IsReadAndWrittenExactly) {
  const std::string text = with_body(
      R"({"vertices": [[0, 0, 0], ["1/3", 0, 0], [0, "1/10", 0], [0, 0, -1]],
  "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3, 0]]})");
  const GraspFile grasp = parse(text);
  ASSERT_TRUE(grasp.description().body);
  EXPECT_EQ(grasp.description().body->vertices[2], (Vector3{0, Rational(1, 10), 0}));
  EXPECT_EQ(grasp.description().body->faces[3], (std::vector<std::size_t>{1, 2, 3, 0}));
  EXPECT_EQ(write_grasp_file(grasp), text);
  EXPECT_FALSE(parse(kText).description().body);
}

UncertainContact contact(const Vector3& p, const Vector3& n, const Rational& friction,
                         const Rational& preload) {
  return {{point_interval(p[0]), point_interval(p[1]), point_interval(p[2])},
          {n.begin(), n.end()},
          point_interval(friction),
          point_interval(2),
          point_interval(preload)};
}

TEST(SpatialForces, OfOneMotion) {
  // It moves by (3, 4, -1) there, and -1 along the normal (0, 0, 1) of length 2.
  GraspBox grasp;
  const Vector3 p{0, 0, 0};
  grasp.contacts = {contact(p, {0, 0, 2}, Rational(1, 2), 4), contact(p, {0, 0, -2}, 1, 1),
                    contact({1, 0, 0}, {0, 0, 1}, 0, 0), contact(p, {0, 0, 2}, 0, 4)};
  const RationalRow d{3, 4, -1, 0, 1, 0};
  EXPECT_EQ(displacement({1, 0, 0}, d), (Vector3{3, 4, -2}));
  const std::vector<SpatialForce> forces = forces_of(grasp, d, {});
  EXPECT_EQ(forces[0].normal, 3);  // of (0, 0, 2): 4 of preload and 2 of the spring
  EXPECT_EQ(forces[0].slip, (Vector3{3, 4, 0}));
  EXPECT_EQ(forces[0].friction, (Vector3{Rational(-9, 5), Rational(-12, 5), 0}));  // 1/2 of 6
  EXPECT_EQ(forces[0].force, (Vector3{Rational(-9, 5), Rational(-12, 5), 6}));
  EXPECT_EQ(forces[1].normal, 0);  // open
  EXPECT_EQ(forces[1].force, Vector3{});
  EXPECT_EQ(forces[2].force, (Vector3{0, 0, 4}));
  EXPECT_EQ(forces[3].force, (Vector3{0, 0, 6}));
}

TEST(SpatialForces, SharesOfWhatSticks) {
  GraspBox grasp;
  grasp.contacts = {contact({0, 0, 0}, {1, 0, 0}, Rational(1, 2), 4)};
  const auto forces =
      forces_of(grasp, RationalRow(6), {{ContactId(0), {0, Rational(1, 4), -1}}});
  EXPECT_EQ(forces[0].friction, (Vector3{0, Rational(1, 2), -2}));
  EXPECT_EQ(forces[0].force, (Vector3{4, Rational(1, 2), -2}));
}

TEST(SpatialForces, LengthsThatMatterAreRational) {
  GraspBox grasp;
  grasp.contacts = {contact({0, 0, 0}, {1, 1, 1}, 1, 1)};
  EXPECT_THROW(forces_of(grasp, RationalRow(6), {}), ContractError);  // of the normal
  grasp.contacts = {contact({0, 0, 0}, {0, 0, 1}, 1, 1)};
  EXPECT_THROW(forces_of(grasp, {1, 1, 0, 0, 0, 0}, {}), ContractError);  // of the slip
  EXPECT_EQ(forces_of(grasp, {1, 0, 0, 0, 0, 0}, {})[0].friction, (Vector3{-1, 0, 0}));
}

}  // namespace
}  // namespace stickslip
