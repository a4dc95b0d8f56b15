// SPDX-License-Identifier: MIT
/// \file
/// The certificate, `stickslip-certificate/2`, in the order of its text (FORMAT.md §2). All
/// throw Malformed, with the file's name, the line and the place.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "degree.hpp"
#include "json.hpp"
#include "margin.hpp"
#include "rigid.hpp"
#include "robustness.hpp"
#include "states.hpp"
#include "statics.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {

/// The member `question`: what whoever made the certificate was asked.
struct Claim {
  Integer contacts;
  Wrench wrench;
  Options asked;  ///< the rest, if stated
};

class CertificateReader {
 public:
  /// How many numbers a twist or a share has is known by the question.
  CertificateReader(std::istream& in, const std::string& file, const Question& question);

  /// All up to the member `question`.
  Claim claim();
  /// "stable", "unstable", "margin" or "region"; or "must move", "must hold", "open" or "may
  /// stand"; or "complete" or "bounds".
  std::string verdict();
  /// Of lengths that are irrational; known with the verdict.
  unsigned bits() const { return bits_; }

  // stable: by parts, or else by a witness
  bool has_parts();
  std::optional<Part> next_part();
  Witness witness();

  // region
  std::optional<std::vector<Witness>> next_piece();

  // a class, in the order of FORMAT.md §13
  Vector twist();
  std::vector<RigidForce> forces(const char* name);
  // of statics, in the order of FORMAT.md §16
  std::optional<StandPoint> next_stand();
  std::optional<Vector> next_move();
  Vector acceleration();
  std::optional<RigidNode> next_rigid_node();

  // states, in the order of FORMAT.md §17
  std::vector<std::vector<Vector>> lines();
  std::optional<State> next_state();
  std::vector<Integer> by_dimension();

  // bounds, in the order of FORMAT.md §18
  Rational bound(const char* name);
  std::optional<RobustCombination> combination();
  std::optional<RobustNode> next_robust_node();

  // unstable, region, and margin that is no claims
  std::vector<Interval> resisted();
  std::optional<Segment> next_segment();
  std::optional<Node> next_node();

  // margin by claims
  std::optional<RangeProof> next_range();

  /// Nothing follows.
  void finish();

 private:
  void expect_member(const std::string& name);
  void expect_name(const std::optional<std::string>& found, const std::string& name) const;
  bool next_element(const char* list);
  Value take(const std::string& name);
  Rational number(const Value& value, const std::string& place) const;
  std::optional<Rational> number_or_null(const Value& value, const std::string& place) const;
  Integer index(const Value& value, const std::string& place) const;
  Vector numbers(const Value& value, const std::string& place, std::size_t skipped,
                 std::size_t size) const;
  void expect_order(const Value& value, const std::string& place,
                    const std::vector<const char*>& names) const;
  const Value& member(const Value& value, const std::string& place,
                      const std::string& name) const;
  const std::vector<Value>& list(const Value& value, const std::string& place,
                                 const std::string& what) const;
  Claim claim_of(const Value& value) const;
  Bounds wrench_component(const Value& value, const std::string& place) const;
  std::map<std::string, Tolerance> tolerances(const Value& value) const;
  Ball ball(const Value& value, const std::string& place) const;
  std::vector<Vector> matrix(const Value& value, const std::string& place, std::size_t least,
                             std::size_t most) const;
  Part part(const Value& value, const std::string& place) const;
  Part shape(const Value& value, const std::string& place, std::size_t least_walls) const;
  RestProof at_rest(const Value& value, const std::string& place) const;
  StickingProof sticking(const Value& value, const std::string& place) const;
  ContactForces single(const Value& value, const std::string& place) const;
  ContactForces answers(const Value& value, const std::string& place) const;
  Segment segment_by_degree(const Value& value, const std::string& place) const;
  std::vector<std::pair<Integer, Vector>> shares(const Value& value,
                                                 const std::string& place) const;
  std::size_t friction_numbers(const Integer& contact) const;
  Witness point(const Value& value, bool may_be_ray, const std::string& place) const;
  Witness point_at(const Rational& multiple, const Value& value,
                   const std::string& place) const;
  Witness load_point(const Value& value, const std::string& place) const;
  Vector friction(const Value& value, const std::string& place, std::size_t size) const;
  std::vector<RigidForce> forces_of(const Value& value, const std::string& place) const;
  Node node(const Value& value, const std::string& place) const;
  MovingTwist moving(const Value& value, const std::string& place) const;
  std::vector<Node> nodes(const Value& value, const std::string& place) const;

  JsonReader json_;
  std::size_t dimension_;
  std::size_t limits_;
  bool in_space_;
  bool claims_;  ///< of a margin, and not segments and a tree
  bool several_;
  Fixed<Contacts> contacts_;
  bool margin_ = false;                ///< the question has a direction
  bool plane_ = false;                 ///< or a plane
  bool rigid_ = false;                 ///< or an inertia
  bool statics_ = false;               ///< or a factor of friction
  std::optional<std::string> states_;  ///< or a set of states
  bool robust_ = false;                ///< or asks for a robustness
  std::vector<std::size_t> signs_;     ///< how many each contact has in one of these
  unsigned bits_ = kDefaultBits;
  std::string open_list_;  ///< whose elements are being taken
  std::size_t elements_ = 0;
  std::optional<Witness> end_;  ///< of the last segment, if that has points
};

}  // namespace stickslip_check
