// SPDX-License-Identifier: GPL-3.0-or-later
// What nodes of the branch and bound inherit, against a look at all contacts of their regions.
#include "search/node.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "random_grasps.hpp"

namespace stickslip {
namespace {

using namespace equilibrium_detail;
using test::RandomSource;

/// After RayTable::read: what it says of every contact is so, and nothing is left out.
void compare(const Problem& problem, const Node& node, const RayTable& table,
             std::size_t& decided) {
  const std::vector<Ray> rays = node.region.generators(problem);
  std::set<std::size_t> undecided;
  for (std::size_t q = 0; q < node.undecided->size(); ++q) {
    const UndecidedContact& u = (*node.undecided)[q];
    undecided.insert(u.contact);
    const ContactId contact(u.contact);
    EXPECT_EQ(u.separation == Separation::kClosed,
              node.region.separation(problem, contact) == Separation::kClosed);
    const int slip = to_int(node.region.slip_sign(problem, contact).value_or(Sign::kZero));
    EXPECT_TRUE(u.slip == slip || problem.row(contact).friction.is_zero());
    for (std::size_t r = 0; r < rays.size(); ++r) {
      const int sign = dot(problem.separation_plane(contact), rays[r].x).sign();
      const double v = table.separation(q, r);
      EXPECT_EQ((v > 0) - (v < 0), sign);
    }
  }
  Rational sum[3][5];
  IntegerVector5 push{};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (undecided.count(i) != 0) continue;
    const ContactId contact(i);
    const auto slip = node.region.slip_sign(problem, contact);
    const bool has_edge = slip.has_value() || problem.row(contact).friction.is_zero();
    bool acts = false;
    for (const Ray& ray : rays) {
      acts = acts || dot(problem.separation_plane(contact), ray.x).sign() > 0;
    }
    if (!acts) continue;  // open, or v = 0, where what is added up is 0 on the region
    ASSERT_EQ(node.region.separation(problem, contact), Separation::kClosed);
    ASSERT_TRUE(has_edge);
    ++decided;
    const Vector3 edge = coordinates(problem.edge_wrench(contact, slip ? -to_int(*slip) : 0));
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 5; ++k) sum[j][k] += edge[j] * problem.separation(contact)[k];
    }
  }
  // On the region, as contacts with v = 0 on it may have been added up, too.
  for (const Ray& ray : rays) {
    for (std::size_t j = 0; j < 3; ++j) {
      Rational exact = 0;
      double found = 0;
      for (std::size_t k = 0; k < 5; ++k) {
        exact += sum[j][k] * Rational(ray.x[k]);
        found += node.decided.value[j][k] * to_double(Rational(ray.x[k]));
      }
      EXPECT_NEAR(found, to_double(exact), 1e-9 * (1 + std::fabs(found)));
    }
  }
}

TEST(Node, InheritsWhatALookAtAllContactsGives) {
  RandomSource random(31);
  std::size_t decided = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Grasp grasp =
        test::degenerate_grasp(random, static_cast<std::size_t>(random.between(1, 6)));
    const Problem problem({grasp, test::small_wrench(random)}, random.between(0, 3) == 0
                                                                   ? NormalLaw::kBilateral
                                                                   : NormalLaw::kUnilateral);
    const DoubleModel model(problem);
    RayTable table;
    Node node = Node::root(problem);
    for (int depth = 0; depth < 6 && !node.region.is_void(); ++depth) {
      const std::size_t above = node.undecided->size();
      table.read(problem, model, node);
      EXPECT_LE(node.undecided->size(), above);
      compare(problem, node, table, decided);
      if (node.undecided->empty()) break;
      const auto last = static_cast<int>(node.undecided->size()) - 1;
      const UndecidedContact& u =
          (*node.undecided)[static_cast<std::size_t>(random.between(0, last))];
      const ContactId contact(u.contact);
      if (u.separation == Separation::kMixed) {
        node = node.separation_child(
            problem, contact,
            random.between(0, 1) == 0 ? Separation::kClosed : Separation::kOpen);
      } else if (u.slip == 0 && u.slip_cuts) {
        node = node.slip_child(problem, contact, sign_of_int(random.between(-1, 1)));
      }
    }
  }
  EXPECT_GT(decided, 500U);
}

}  // namespace
}  // namespace stickslip
