// SPDX-License-Identifier: MIT
#include "states.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "work.hpp"

namespace stickslip_check {
namespace {

/// Planes of the arrangement by their numbers, ascending.
using Planes = std::vector<std::uint32_t>;

/// A plane of a flat, by its row there, and all planes of the arrangement that cut the flat in
/// it.
struct Trace {
  Form row;
  Planes planes;
};

/// The first coordinate that is not 0, or the size.
std::size_t first_entry(const Form& row) {
  return static_cast<std::size_t>(
      std::find_if(row.begin(), row.end(), [](const Integer& x) { return x != 0; }) -
      row.begin());
}

/// The row of the same plane whose first entry is above 0. Returns whether it is one: not 0.
bool make_row_of_plane(Form& row) {
  make_primitive(row);
  const std::size_t first = first_entry(row);
  if (first == row.size()) return false;
  if (row[first] < 0) row = negative(std::move(row));
  return true;
}

/// A row as a function of the points of `plane`, whose coordinate p follows from the others.
Form on_plane(const Form& row, const Form& plane, std::size_t p) {
  Form result;
  result.reserve(row.size() - 1);
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (j != p) result.push_back(row[j] * plane[p] - row[p] * plane[j]);
  }
  const std::uint64_t length = std::max(words(row), words(plane));
  spend(2 * row.size(), length, length);
  return result;
}

bool operator<(const Trace& a, const Trace& b) {
  return a.row < b.row;
}

/// The traces in a plane of the flat, but for those that contain all of it.
std::vector<Trace> restricted(const std::vector<Trace>& traces, const Form& plane) {
  const std::size_t p = first_entry(plane);
  std::vector<Trace> all;
  for (const Trace& trace : traces) {
    Trace here{on_plane(trace.row, plane, p), trace.planes};
    if (make_row_of_plane(here.row)) all.push_back(std::move(here));
  }
  std::sort(all.begin(), all.end());
  std::vector<Trace> result;
  for (Trace& trace : all) {
    if (result.empty() || result.back().row != trace.row) {
      result.push_back(std::move(trace));
      continue;
    }
    Planes& planes = result.back().planes;
    planes.insert(planes.end(), trace.planes.begin(), trace.planes.end());
  }
  for (Trace& trace : result) std::sort(trace.planes.begin(), trace.planes.end());
  return result;
}

/// The rows with those coordinates that determine the others of a sum of rows, as few as there
/// can be. So these have as many as the rank.
std::vector<Form> essential(const std::vector<Form>& rows) {
  std::vector<std::size_t> names(rows.empty() ? 0 : rows[0].size());
  std::iota(names.begin(), names.end(), std::size_t{0});
  std::vector<std::size_t> columns;
  std::vector<Form> left = rows;
  while (!left.empty()) {
    const Form plane = left.back();
    const std::size_t p = first_entry(plane);
    columns.push_back(names[p]);
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(p));
    std::vector<Form> next;
    for (const Form& row : left) {
      Form here = on_plane(row, plane, p);
      if (make_row_of_plane(here)) next.push_back(std::move(here));
    }
    left = std::move(next);
  }
  std::vector<Form> result;
  for (const Form& row : rows) {
    Form& one = result.emplace_back();
    for (const std::size_t j : columns) one.push_back(row[j]);
    make_row_of_plane(one);
  }
  return result;
}

/// The flats of an arrangement, and the numbers of its faces (FORMAT.md §17, *Computing*).
class Flats {
 public:
  /// The rows are those of planes that differ.
  Flats(std::vector<Form> rows, const Integer& most) : rows_(std::move(rows)), most_(most) {}

  /// The numbers of faces by codimension, from 0 to the rank.
  std::vector<Integer> faces() {
    Planes all(rows_.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<Integer> result = sums(all, true);
    for (Integer& x : result) x *= 2;
    result.emplace_back(1);
    return result;
  }

 private:
  /// The sum of the weights of all flats of these planes but the least; minus where the
  /// codimensions differ by an even number. With `counted` those are left out, and each flat,
  /// as it has a face, is counted.
  std::vector<Integer> sums(const Planes& planes, bool counted) {
    std::vector<Form> chosen;
    for (const std::uint32_t i : planes) chosen.push_back(rows_[i]);
    chosen = essential(chosen);
    const std::size_t rank = chosen.empty() ? 0 : chosen[0].size();
    std::vector<Integer> total(rank);
    std::vector<Integer> simple(rank);  // flats of as many planes as their codimension
    const auto take = [&](const Planes& flat, std::size_t codimension) {
      if (counted && ++found_ > most_) {
        reject("state-complete", "",
                      "there are more states than " + show(Rational(most_)));
      }
      const bool odd = (rank - codimension) % 2 == 1;
      if (counted && !odd) return;
      if (flat.size() == codimension) {
        ++simple[codimension];
        return;
      }
      const std::vector<Integer> all = weights(flat);
      for (std::size_t c = 0; c <= codimension; ++c) {
        if (odd) {
          total[c] += all[c];
        } else {
          total[c] -= all[c];
        }
      }
    };
    // A flat is come to once: by the plane of least number that contains it, then by the one
    // of least number whose trace in that does, and so on.
    const std::function<void(const Planes&, std::size_t, std::uint32_t,
                             const std::vector<Trace>&)>
        descend = [&](const Planes& flat, std::size_t codimension, std::uint32_t from,
                      const std::vector<Trace>& traces) {
          take(flat, codimension);
          if (codimension + 1 >= rank) return;
          for (const Trace& trace : traces) {
            spend(1);
            const std::uint32_t least = trace.planes[0];
            if (least < from) continue;
            Planes next = flat;
            next.insert(next.end(), trace.planes.begin(), trace.planes.end());
            if (codimension + 2 < rank) {
              descend(next, codimension + 1, least + 1, restricted(traces, trace.row));
            } else {
              take(next, codimension + 1);
            }
          }
        };
    if (rank > 0) {
      std::vector<Trace> traces;
      for (std::size_t k = 0; k < planes.size(); ++k) {
        traces.push_back({std::move(chosen[k]), {planes[k]}});
      }
      descend({}, 0, 0, traces);
    }
    for (std::size_t codimension = 0; codimension < rank; ++codimension) {
      for (std::size_t c = 0; c <= codimension && simple[codimension] != 0; ++c) {
        Integer chosen_of;
        mpz_bin_uiui(chosen_of.get_mpz_t(), codimension, c);
        chosen_of *= simple[codimension];
        if ((rank - codimension) % 2 == 1) {
          total[c] += chosen_of;
        } else {
          total[c] -= chosen_of;
        }
      }
    }
    return total;
  }

  /// w_c(Y) for all c up to the codimension of the flat Y of all these planes.
  std::vector<Integer> weights(Planes flat) {
    std::sort(flat.begin(), flat.end());
    const std::vector<bool> free = which_are_free(flat);
    Planes bound;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      if (!free[k]) bound.push_back(flat[k]);
    }
    auto known = known_.find(bound);
    if (known == known_.end()) {
      std::vector<Integer> all = sums(bound, false);
      all.emplace_back(1);
      known = known_.emplace(bound, std::move(all)).first;
    }
    std::vector<Integer> result = known->second;
    for (std::size_t k = bound.size(); k < flat.size(); ++k) {
      result.emplace_back(0);
      for (std::size_t c = result.size() - 1; c > 0; --c) result[c] += result[c - 1];
    }
    return result;
  }

  /// Tells which planes have rows that are not in the span of those of the others.
  std::vector<bool> which_are_free(const Planes& planes) const {
    std::vector<Form> matrix(rows_[0].size());
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      for (const std::uint32_t i : planes) matrix[j].push_back(rows_[i][j]);
    }
    std::vector<std::size_t> pivots;
    for (std::size_t c = 0; c < planes.size() && pivots.size() < matrix.size(); ++c) {
      const auto top = matrix.begin() + static_cast<std::ptrdiff_t>(pivots.size());
      const auto found =
          std::find_if(top, matrix.end(), [c](const Form& row) { return row[c] != 0; });
      if (found == matrix.end()) continue;
      std::iter_swap(top, found);
      for (auto row = matrix.begin(); row != matrix.end(); ++row) {
        if (row == top || (*row)[c] == 0) continue;
        const Integer factor = (*row)[c];
        const std::uint64_t length = std::max(words(*row), words(*top));
        spend(2 * row->size(), length, length);
        for (std::size_t k = 0; k < row->size(); ++k) {
          (*row)[k] = (*row)[k] * (*top)[c] - factor * (*top)[k];
        }
        make_primitive(*row);
      }
      pivots.push_back(c);
    }
    std::vector<bool> free(planes.size());
    for (std::size_t r = 0; r < pivots.size(); ++r) {
      const Form& row = matrix[r];
      free[pivots[r]] =
          std::count_if(row.begin(), row.end(), [](const Integer& x) { return x != 0; }) == 1;
    }
    return free;
  }

  std::vector<Form> rows_;
  Integer most_;
  Integer found_ = 0;
  std::map<Planes, std::vector<Integer>> known_;
};

/// The most that each of kMostCoordinates products may be, so that their sum is a word.
constexpr std::int64_t kMostProduct = std::int64_t{1} << 57;

/// Whether its size is at most that, which is a word.
bool is_within(const Integer& x, std::int64_t most) {
  return x <= most && x >= -most;
}

char sign_character(int sign) {
  return sign > 0 ? '+' : sign < 0 ? '-' : '0';
}

}  // namespace

bool SignSet::insert(const std::string& signs) {
  constexpr std::size_t kSigns = 5;  // 3^5 is below 256.
  std::string packed((signs.size() + kSigns - 1) / kSigns, '\0');
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const int digit = signs[i] == '+' ? 1 : signs[i] == '-' ? 2 : 0;
    char& to = packed[i / kSigns];
    to = static_cast<char>(3 * static_cast<unsigned char>(to) + digit);
  }
  bytes_ = packed.size();
  if (3 * (size_ + 1) > 2 * places_.size()) grow();
  const std::size_t place = place_of(packed);
  if (places_[place] != 0) return false;
  if (size_ % kPage == 0) pages_.emplace_back().reserve(kPage * bytes_);
  pages_.back() += packed;
  places_[place] = static_cast<std::uint32_t>(++size_);
  return true;
}

/// The place of a word in the table, or the free one that it would have.
std::size_t SignSet::place_of(const std::string& packed) const {
  const std::size_t last = places_.size() - 1;
  std::size_t i = std::hash<std::string_view>()(packed) & last;
  while (places_[i] != 0 && packed.compare(0, bytes_, word(places_[i] - 1), bytes_) != 0) {
    i = (i + 1) & last;
  }
  return i;
}

void SignSet::grow() {
  if (size_ > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw std::length_error("a certificate lists more than two billion states");
  }
  places_.assign(places_.empty() ? 64 : 2 * places_.size(), 0);
  for (std::size_t i = 0; i < size_; ++i) {
    places_[place_of(std::string(word(i), bytes_))] = static_cast<std::uint32_t>(i + 1);
  }
}

bool has_normal_signs(const std::string& set) {
  return set == "full";
}

StatesProof::StatesProof(const Question& question,
                         const std::vector<std::vector<Vector>>& lines)
    : dimension_(question.dimension()) {
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const Contact contact = question.contacts[i];
    if (is_contact(contact.sight)) contacts.push_back(contact);
  }
  if (lines.size() != contacts.size()) {
    reject("state-line", "",
                  "there are lines of " + std::to_string(lines.size()) +
                      " contacts, expected " + std::to_string(contacts.size()));
  }
  const std::string& set = *question.asked.states;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vector& normal = contacts[i].normal;
    if (has_normal_signs(set)) add(contacts[i], normal, rows_);
    if (set == "closed") add(contacts[i], normal, closed_);
    for (std::size_t j = 0; j < lines[i].size(); ++j) {
      const Vector& v = lines[i][j];
      if (dot(v, normal) != 0 || dot(v, v) == 0) {
        reject("state-line",
                      "contact " + std::to_string(i) + ", line " + std::to_string(j),
                      show(v) + " is 0, or not across the normal " + show(normal));
      }
      add(contacts[i], v, rows_);
    }
  }
  Integer longest = 1;
  for (const std::vector<Form>* rows : {&rows_, &closed_}) {
    for (const Form& row : *rows) {
      for (const Integer& x : row) longest = std::max(longest, Integer(abs(x)));
    }
  }
  if (!is_within(longest, kMostProduct)) return;
  longest_motion_ = kMostProduct / longest.get_si();
  for (const std::vector<Form>* rows : {&rows_, &closed_}) {
    for (const Form& row : *rows) {
      for (const Integer& x : row) short_rows_.push_back(x.get_si());
    }
  }
}

void StatesProof::add(const Contact& contact, const Vector& direction,
                      std::vector<Form>& to) const {
  Vector point;
  for (const Bounds& p : contact.position) point.push_back(p.low);
  to.push_back(make_form(seen(contact.sight, at_point(point, direction))));
}

/// `state-sign`
bool StatesProof::agrees(const State& state) const {
  const std::size_t n = rows_.size();
  const auto expected = [&](std::size_t i) { return i < n ? state.signs[i] : '0'; };
  if (std::all_of(state.motion.begin(), state.motion.end(),
                  [&](const Integer& x) { return is_within(x, longest_motion_); })) {
    std::vector<std::int64_t> motion;
    for (const Integer& x : state.motion) motion.push_back(x.get_si());
    const std::int64_t* row = short_rows_.data();
    for (std::size_t i = 0; i < n + closed_.size(); ++i, row += dimension_) {
      const std::int64_t product =
          std::inner_product(motion.begin(), motion.end(), row, std::int64_t{0});
      if (sign_character(product > 0 ? 1 : product < 0 ? -1 : 0) != expected(i)) return false;
    }
    return true;
  }
  for (std::size_t i = 0; i < n + closed_.size(); ++i) {
    const Form& row = i < n ? rows_[i] : closed_[i - n];
    const std::uint64_t length = words(row);
    spend(dimension_, length, words(state.motion));
    if (sign_character(sign_of_dot(row, state.motion)) != expected(i)) return false;
  }
  return true;
}

void StatesProof::visit(const State& state) {
  spend(1 + rows_.size() + closed_.size());
  const std::string place = "state " + std::to_string(listed_);
  if (!agrees(state)) reject("state-sign", place, "the motion has other signs");
  const std::size_t first = state.signs.find_first_not_of('0');
  const bool is_zero = first == std::string::npos;
  if (!is_zero && state.signs[first] == '-') {
    reject("state-half", place, "the first sign that is not 0 is -");
  }
  if (!seen_.insert(state.signs)) {
    reject("state-new", place, "a state before it has the same signs");
  }
  ++listed_;
  number_ += is_zero ? 1 : 2;
}

void StatesProof::finish(const std::vector<Integer>& by_dimension) const {
  const std::vector<Integer> found = count_faces(rows_, closed_, dimension_, number_);
  Integer all = 0;
  for (const Integer& f : found) all += f;
  if (all != number_) {
    reject("state-complete", "",
                  "there are " + show(Rational(all)) + " states, and " +
                      show(Rational(number_)) + " are listed");
  }
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (by_dimension[j] == found[j]) continue;
    reject("state-dimension", "",
                  show(Rational(found[j])) + " states have dimension " + std::to_string(j) +
                      ", not " + show(Rational(by_dimension[j])));
  }
}

std::vector<Integer> count_faces(const std::vector<Form>& rows, const std::vector<Form>& closed,
                                 std::size_t dimension, const Integer& most) {
  std::vector<Form> planes;
  for (Form row : rows) planes.push_back(std::move(row));
  std::vector<Form> left = closed;
  std::size_t free = dimension;
  while (!left.empty()) {
    Form plane = std::move(left.back());
    left.pop_back();
    if (!make_row_of_plane(plane)) continue;
    const std::size_t p = first_entry(plane);
    for (std::vector<Form>* some : {&planes, &left}) {
      for (Form& row : *some) row = on_plane(row, plane, p);
    }
    --free;
  }
  planes.erase(std::remove_if(planes.begin(), planes.end(),
                              [](Form& row) { return !make_row_of_plane(row); }),
               planes.end());
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  const std::vector<Integer> found = Flats(std::move(planes), most).faces();
  std::vector<Integer> result(dimension + 1);
  for (std::size_t c = 0; c < found.size(); ++c) result[free - c] = found[c];
  return result;
}

}  // namespace stickslip_check
