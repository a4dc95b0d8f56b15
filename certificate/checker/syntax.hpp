// SPDX-License-Identifier: MIT
/// \file
/// The pieces that certificates are written in (FORMAT.md §2, §4). All throw Malformed, with
/// the file's name, the line and the place.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "json.hpp"
#include "number.hpp"

namespace stickslip_check {

bool is_text(const Value& value, const char* text);

enum class NodeKind : std::int8_t { kSlip, kSeparation, kPlane, kLeaf, kVoid };

/// A node as the certificate states it; only its shape has been checked.
struct Node {
  NodeKind kind = NodeKind::kVoid;
  Integer contact;                                   ///< of slip and separation
  std::vector<Rational> numbers;                     ///< a of a plane, y of a leaf
  std::vector<std::pair<Integer, Rational>> thetas;  ///< of a leaf
};

class Syntax {
 public:
  explicit Syntax(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  [[noreturn]] void fail(std::size_t line, const std::string& place,
                         const std::string& problem) const;
  void expect(bool good, const Value& value, const std::string& place,
              const std::string& what) const;

  /// NUMBER.
  Rational number(const Value& value, const std::string& place) const;
  /// CONTACT.
  Integer index(const Value& value, const std::string& place) const;
  /// The kSize numbers of an array behind the first `skipped` values.
  template <std::size_t kSize>
  std::array<Rational, kSize> numbers(const Value& value, std::size_t skipped,
                                      const std::string& place) const {
    expect(value.is_array(kSize + skipped), value, place,
           "an array of " + std::to_string(kSize + skipped));
    std::array<Rational, kSize> result;
    for (std::size_t i = 0; i < kSize; ++i) result[i] = number(value.items[skipped + i], place);
    return result;
  }
  /// NODE.
  Node node(const Value& value, const std::string& place) const;

 private:
  std::string file_;
};

}  // namespace stickslip_check
