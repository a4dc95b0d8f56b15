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
#include "json.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {

/// The member `question`: what whoever made the certificate was asked.
struct Claim {
  Integer contacts;
  Options asked;  ///< the wrench always, the rest if stated
};

class CertificateReader {
 public:
  CertificateReader(std::istream& in, const std::string& file);

  /// All up to the member `verdict`.
  Claim claim();
  /// "stable", "unstable" or "margin".
  std::string verdict();

  // stable
  Witness witness();

  // unstable, margin
  std::vector<Interval> resisted();
  std::optional<std::pair<Witness, Witness>> next_segment();
  std::optional<Node> next_node();

  /// Nothing follows.
  void finish();

 private:
  void expect_member(const std::string& name);
  bool next_element(const char* list);
  Value take(const std::string& name);
  Rational number(const Value& value, const std::string& place) const;
  std::optional<Rational> number_or_null(const Value& value, const std::string& place) const;
  Integer index(const Value& value, const std::string& place) const;
  Vector numbers(const Value& value, const std::string& place, std::size_t skipped,
                 std::size_t size) const;
  const std::vector<Value>& list(const Value& value, const std::string& place,
                                 const std::string& what) const;
  Options asked(const Value& value) const;
  std::vector<std::pair<Integer, Rational>> shares(const Value& value,
                                                   const std::string& place) const;
  Witness point(const Value& value, bool may_be_ray, const std::string& place) const;
  Node node(const Value& value, const std::string& place) const;

  JsonReader json_;
  bool margin_ = false;    ///< the question has a direction
  std::string open_list_;  ///< whose elements are being taken
  std::size_t elements_ = 0;
  std::optional<Witness> end_;  ///< of the last segment
};

}  // namespace stickslip_check
