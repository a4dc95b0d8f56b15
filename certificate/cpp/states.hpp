// SPDX-License-Identifier: MIT
/// \file
/// Lists of all slip states of contacts (FORMAT.md §17): their motions, and how many there are.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "answer.hpp"

namespace stickslip_check {

/// An element of `states`.
struct State {
  std::string signs;  ///< of all rows in their order, as characters
  std::vector<Integer> motion;
};

/// Whether contacts have signs of N as well.
bool has_normal_signs(const std::string& set);

/// A set of words of signs, each as long as the first, five signs a byte.
class SignSet {
 public:
  /// Whether it was not there.
  bool insert(const std::string& signs);

 private:
  static constexpr std::size_t kPage = 4096;  ///< words that are stored together

  const char* word(std::size_t i) const { return &pages_[i / kPage][i % kPage * bytes_]; }
  std::size_t place_of(const std::string& word) const;
  void grow();

  std::size_t bytes_ = 0;  ///< of a word
  std::size_t size_ = 0;
  std::vector<std::string> pages_;
  std::vector<std::uint32_t> places_;  ///< a hash table of words by their numbers, from 1
};

/// The rules of states. The question must ask for them. All throw Rejected.
class StatesProof {
 public:
  /// `state-line`: the lines of slip of each contact of the file.
  StatesProof(const Question& question, const std::vector<std::vector<Vector>>& lines);

  /// `state-sign`, `state-half`, `state-new`
  void visit(const State& state);
  /// `state-complete`, `state-dimension`
  void finish(const std::vector<Integer>& by_dimension) const;

  std::uint64_t listed() const { return listed_; }

 private:
  bool agrees(const State& state) const;
  void add(const Contact& contact, const Vector& direction, std::vector<Form>& to) const;

  std::size_t dimension_;
  std::vector<Form> rows_;                ///< those whose signs are stated
  std::vector<Form> closed_;              ///< those that have to be 0
  std::vector<std::int64_t> short_rows_;  ///< the same, if all of their entries are short;
  std::int64_t longest_motion_ = -1;      ///< then products with motions up to this are words
  SignSet seen_;
  std::uint64_t listed_ = 0;
  Integer number_ = 0;  ///< of states, with opposites
};

/// The number of faces of each dimension, from 0 to D, into which the planes of `rows` divide
/// what the planes of `closed` have in common in Q^D. Throws Rejected by `state-complete` if
/// there are more than `most` in all.
std::vector<Integer> count_faces(const std::vector<Form>& rows, const std::vector<Form>& closed,
                                 std::size_t dimension, const Integer& most);

}  // namespace stickslip_check
