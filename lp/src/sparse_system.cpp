// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/sparse_system.hpp"

#include <gmp.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Word = std::uint64_t;

constexpr Word kPrime = (Word{1} << 31U) - 1;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

Word residue(const Integer& value) {
  return mpz_fdiv_ui(value.gmp(), kPrime);
}

Word power(Word base, Word exponent) {
  Word result = 1;
  for (; exponent > 0; exponent /= 2, base = base * base % kPrime) {
    if (exponent % 2 == 1) result = result * base % kPrime;
  }
  return result;
}

Word inverse(Word x) {
  return power(x, kPrime - 2);
}

/// Subtracts factor x from one of several residues.
void take(Word& from, Word factor, Word x) {
  from = (from + (kPrime - factor) * x) % kPrime;
}

/// Returns the fraction n / d = x modulo m with |n| and d of at most `most`, if there is one.
std::optional<std::pair<Integer, Integer>> fraction_of(const Integer& x, const Integer& m,
                                                       const Integer& most) {
  Integer before = m;
  Integer n = x;
  Integer d_before = 0;
  Integer d = 1;
  Integer quotient;
  while (n > most) {
    mpz_fdiv_qr(quotient.mutable_gmp(), before.mutable_gmp(), before.gmp(), n.gmp());
    mpz_submul(d_before.mutable_gmp(), quotient.gmp(), d.gmp());
    mpz_swap(before.mutable_gmp(), n.mutable_gmp());
    mpz_swap(d_before.mutable_gmp(), d.mutable_gmp());
  }
  if (abs(d) > most) return std::nullopt;
  if (d.sign() < 0) {
    d.negate();
    n.negate();
  }
  return std::pair(std::move(n), std::move(d));
}

/// Returns fractions with these residues, of half as many bits as the modulus. Most have one
/// denominator, so that few of them are sought.
std::optional<SharedFractions> fractions_of(const Row& residues, const Integer& modulus) {
  const Integer most = sqrt(Integer(modulus / 2));
  SharedFractions x{{}, 1};
  for (const Integer& value : residues) {
    Integer n = value * x.denominator % modulus;
    if (2 * n > modulus) n -= modulus;
    if (abs(n) > most) {
      if (n.sign() < 0) n += modulus;
      const auto fraction = fraction_of(n, modulus, most);
      if (!fraction) return std::nullopt;
      n = fraction->first;
      x.denominator *= fraction->second;
      for (Integer& before : x.numerators) before *= fraction->second;
    }
    x.numerators.push_back(std::move(n));
  }
  return x;
}

/// Returns the number with these digits in the base powers[0], the lowest first. They are
/// joined two by two, again and again. Their number is a power of two, and powers[j] the 2^j-th
/// power.
Integer joined(std::vector<Integer> digits, const std::vector<Integer>& powers) {
  for (std::size_t j = 0; digits.size() > 1; ++j) {
    for (std::size_t k = 0; 2 * k < digits.size(); ++k) {
      Integer& low = digits[2 * k];
      mpz_addmul(low.mutable_gmp(), digits[2 * k + 1].gmp(), powers[j].gmp());
      if (k > 0) digits[k] = std::move(low);
    }
    digits.resize(digits.size() / 2);
  }
  return std::move(digits.front());
}

}  // namespace

SparseSystem::SparseSystem(std::size_t rows, const std::vector<SparseRow>& columns)
    : size_(columns.size()), scales_(rows, Rational(1)), order_of_row_(rows, kNone) {
  std::vector<Integer> denominators(rows, Integer(1));
  std::vector<std::size_t> counts(rows, 0);
  for (const SparseRow& column : columns) {
    for (const auto& [row, entry] : column) {
      denominators[row] = lcm(denominators[row], denominator(entry));
      ++counts[row];
    }
  }
  for (std::size_t row = 0; row < rows; ++row) scales_[row] = denominators[row];
  for (std::size_t j = 0; j < columns.size(); ++j) {
    IntegerEntries column;
    for (const auto& [row, entry] : columns[j]) {
      column.emplace_back(row, numerator(Rational(entry * scales_[row])));
    }
    if (!eliminate(column, counts)) continue;
    independent_.push_back(j);
    columns_.push_back(std::move(column));
  }
}

/// Returns whether the column does not depend on those before it, and if so keeps what is left
/// of it. The pivot is in the row that has the fewest entries.
bool SparseSystem::eliminate(const IntegerEntries& column,
                             const std::vector<std::size_t>& counts) {
  std::vector<Word> left(order_of_row_.size(), 0);
  std::vector<std::size_t> touched;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> pending;
  const auto touch = [&](std::size_t row) {
    touched.push_back(row);
    if (order_of_row_[row] != kNone) pending.push(order_of_row_[row]);
  };
  for (const auto& [row, entry] : column) {
    left[row] = residue(entry);
    if (left[row] != 0) touch(row);
  }
  Entries upper;
  while (!pending.empty()) {
    const std::size_t k = pending.top();
    pending.pop();
    const Word factor = left[pivots_[k]];
    if (factor == 0) continue;
    left[pivots_[k]] = 0;
    upper.emplace_back(k, factor);
    for (const auto& [row, entry] : lower_[k]) {
      if (left[row] == 0) touch(row);
      take(left[row], factor, entry);
    }
  }
  std::size_t pivot = kNone;
  for (const std::size_t row : touched) {
    if (left[row] == 0) continue;
    if (pivot == kNone || std::pair(counts[row], row) < std::pair(counts[pivot], pivot)) {
      pivot = row;
    }
  }
  if (pivot == kNone) return false;
  const Word over = inverse(left[pivot]);
  left[pivot] = 0;
  Entries lower;
  for (const std::size_t row : touched) {
    if (left[row] == 0) continue;
    lower.emplace_back(row, left[row] * over % kPrime);
    left[row] = 0;
  }
  order_of_row_[pivot] = pivots_.size();
  pivots_.push_back(pivot);
  inverses_.push_back(over);
  lower_.push_back(std::move(lower));
  upper_.push_back(std::move(upper));
  return true;
}

/// Returns the multiples of the columns, modulo the prime, that are `left` in the pivots' rows.
std::vector<std::uint64_t> SparseSystem::digits(const Row& left) const {
  std::vector<Word> rows(order_of_row_.size(), 0);
  for (std::size_t k = 0; k < pivots_.size(); ++k) rows[pivots_[k]] = residue(left[k]);
  std::vector<Word> x(pivots_.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = rows[pivots_[k]];
    if (x[k] == 0) continue;
    for (const auto& [row, entry] : lower_[k]) take(rows[row], x[k], entry);
  }
  for (std::size_t k = x.size(); k-- > 0;) {
    if (x[k] == 0) continue;
    x[k] = x[k] * inverses_[k] % kPrime;
    for (const auto& [before, factor] : upper_[k]) take(x[before], factor, x[k]);
  }
  return x;
}

std::optional<SharedFractions> SparseSystem::solve(const RationalRow& b) const {
  require(b.size() == scales_.size(), "a right side of another length");
  Integer common = 1;
  RationalRow scaled;
  for (std::size_t row = 0; row < b.size(); ++row) {
    scaled.push_back(b[row] * scales_[row]);
    common = lcm(common, denominator(scaled.back()));
  }
  Row right;
  for (const Rational& entry : scaled) right.push_back(numerator(Rational(entry * common)));
  Row left;
  for (const std::size_t pivot : pivots_) left.push_back(right[pivot]);
  Row residues(columns_.size(), Integer(0));
  Integer modulus = 1;
  for (std::size_t round = 16;; round *= 2) {
    std::vector<std::vector<Word>> found;
    for (std::size_t digit = 0; digit < round; ++digit) {
      found.push_back(digits(left));
      const std::vector<Word>& x = found.back();
      for (std::size_t k = 0; k < x.size(); ++k) {
        if (x[k] == 0) continue;
        for (const auto& [row, entry] : columns_[k]) {
          const std::size_t place = order_of_row_[row];
          if (place != kNone) mpz_submul_ui(left[place].mutable_gmp(), entry.gmp(), x[k]);
        }
      }
      for (Integer& entry : left) {
        mpz_divexact_ui(entry.mutable_gmp(), entry.gmp(), kPrime);
      }
    }
    std::vector<Integer> powers{Integer(kPrime * kPrime)};  // squared one after another
    while (std::size_t{2} << powers.size() < round) {
      powers.push_back(powers.back() * powers.back());
    }
    for (std::size_t k = 0; k < residues.size(); ++k) {
      std::vector<Integer> pairs;  // of digits, which a word holds
      for (std::size_t j = 0; j < round; j += 2) {
        pairs.emplace_back(found[j][k] + kPrime * found[j + 1][k]);
      }
      mpz_addmul(residues[k].mutable_gmp(), joined(std::move(pairs), powers).gmp(),
                 modulus.gmp());
    }
    modulus *= powers.back() * powers.back();
    std::optional<SharedFractions> kept = fractions_of(residues, modulus);
    if (!kept) continue;
    const Row rest = left_by(*kept, right);
    const bool is_found = std::all_of(pivots_.begin(), pivots_.end(),
                                      [&](std::size_t row) { return rest[row].is_zero(); });
    if (!is_found) continue;
    if (!is_zero(rest)) return std::nullopt;
    SharedFractions x{Row(size_, Integer(0)), kept->denominator * common};
    for (std::size_t k = 0; k < independent_.size(); ++k) {
      x.numerators[independent_[k]] = std::move(kept->numerators[k]);
    }
    return x;
  }
}

/// Returns a positive multiple of b - A x, for x by the columns that are kept.
Row SparseSystem::left_by(const SharedFractions& x, const Row& b) const {
  Row left;
  for (const Integer& entry : b) left.push_back(entry * x.denominator);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    for (const auto& [row, entry] : columns_[k]) {
      mpz_submul(left[row].mutable_gmp(), entry.gmp(), x.numerators[k].gmp());
    }
  }
  return left;
}

RationalRow SharedFractions::row() const {
  RationalRow result;
  for (const Integer& n : numerators) result.emplace_back(n, denominator);
  return result;
}

}  // namespace stickslip
