// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/double_forces.hpp"

#include <algorithm>
#include <cmath>

#include "earlier/robustness/simplex.hpp"
#include "stickslip/lp/cone_program.hpp"

namespace stickslip::robustness_detail {
namespace {

/// Imbalance costs so much that none is left where forces balance.
constexpr double kImbalance = 1e5;
/// Rounds of cuts and directions for one node.
constexpr int kMostRounds = 24;
/// Cuts that are kept beside those along the axes.
constexpr std::size_t kKeptCuts = 10;
constexpr std::size_t kRoundDirections = 8;
/// Directions of a contact in one program for one combination.
constexpr std::size_t kManyDirections = 64;

Doubles plus(Doubles a, double factor, const Doubles& b) {
  for (std::size_t j = 0; j < 6; ++j) a[j] += factor * b[j];
  return a;
}

void add_square(std::vector<Doubles>& to, double factor, const Doubles& x) {
  for (std::size_t j = 0; j < 6; ++j) to[j] = plus(to[j], factor * x[j], x);
}

/// Returns the squares along u of M of a contact, by state.
std::array<double, 3> squares_along(const ForceContact& contact, const Doubles& u) {
  const double normal = dot(contact.normal_double, u);
  double stick = normal * normal;
  for (std::size_t k = 0; k < contact.tangents.size(); ++k) {
    const double tangent = dot(contact.tangents_double[k], u);
    stick += tangent * tangent;
  }
  return {stick, normal * normal, 0};
}

/// Returns how much a force in the round cone with the normal part 1 can do against a twist.
double most_against(const ForceContact& contact, const Doubles& twist) {
  double square = 0;
  for (std::size_t k = 0; k < contact.tangents.size(); ++k) {
    const double tangent = dot(contact.tangents_double[k], twist);
    square += tangent * tangent;
  }
  return contact.friction_double * std::sqrt(square) - dot(contact.normal_double, twist);
}

/// Diagonalises a symmetric matrix by rotations (Jacobi 1846); the columns of `vectors` become
/// eigenvectors.
void diagonalise(std::vector<Doubles>& a, std::vector<Doubles>& vectors, std::size_t n) {
  vectors.assign(n, Doubles{});
  for (std::size_t j = 0; j < n; ++j) vectors[j][j] = 1;
  for (int sweep = 0; sweep < 40; ++sweep) {
    double off = 0;
    double size = 0;
    for (std::size_t p = 0; p < n; ++p) {
      size += a[p][p] * a[p][p];
      for (std::size_t q = p + 1; q < n; ++q) off += a[p][q] * a[p][q];
    }
    if (off <= 1e-32 * size) return;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1 / std::hypot(t, 1.0);
        const double s = t * c;
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[k][p];
          const double y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[p][k];
          const double y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
          const double v = vectors[k][p];
          const double w = vectors[k][q];
          vectors[k][p] = c * v - s * w;
          vectors[k][q] = s * v + c * w;
        }
      }
    }
  }
}

Doubles column(const std::vector<Doubles>& matrix, std::size_t j) {
  Doubles result{};
  for (std::size_t k = 0; k < matrix.size(); ++k) result[k] = matrix[k][j];
  return result;
}

}  // namespace

Directions::Directions(const ForceModel& model, std::size_t most)
    : model_(model),
      most_(most),
      exact_(model.contacts.size()),
      wrenches_(model.contacts.size()) {
  for (std::size_t i = 0; i < exact_.size(); ++i) {
    if (model.coordinates == 3) {
      add(i, {{1}});
      add(i, {{-1}});
      continue;
    }
    const std::vector<FrictionDirection>& edges = model.contacts[i].edges;
    for (const FrictionDirection& direction :
         edges.empty() ? corners_of_polygon(kRoundDirections) : edges) {
      add(i, direction);
    }
  }
}

void Directions::add(std::size_t contact, const FrictionDirection& direction) {
  const ForceContact& c = model_.contacts[contact];
  Doubles wrench = c.normal_double;
  for (std::size_t k = 0; k < direction.along.size(); ++k) {
    wrench =
        plus(wrench, c.friction_double * to_double(direction.along[k]), c.tangents_double[k]);
  }
  exact_[contact].push_back(direction);
  wrenches_[contact].push_back(wrench);
}

bool Directions::add_against(std::size_t contact, const Doubles& twist) {
  const ForceContact& c = model_.contacts[contact];
  if (!c.is_round()) return false;
  const double most = most_against(c, twist);
  if (most <= 0) return false;
  double known = 0;
  for (const Doubles& wrench : wrenches_[contact]) known = std::max(known, -dot(wrench, twist));
  if (most <= known * (1 + 1e-6) + 1e-9) return false;
  if (exact_[contact].size() >= most_) {
    exact_[contact].erase(exact_[contact].begin() + kRoundDirections);
    wrenches_[contact].erase(wrenches_[contact].begin() + kRoundDirections);
  }
  add(contact, direction_at(std::atan2(-dot(c.tangents_double[1], twist),
                                       -dot(c.tangents_double[0], twist))));
  return true;
}

LeastStiff least_eigenvalue(std::vector<Doubles> matrix, std::size_t size) {
  std::vector<Doubles> vectors;
  diagonalise(matrix, vectors, size);
  std::size_t least = 0;
  for (std::size_t j = 1; j < size; ++j) {
    if (matrix[j][j] < matrix[least][least]) least = j;
  }
  return {matrix[least][least], column(vectors, least)};
}

Doubles least_stretched(const ForceModel& model, const std::vector<SpringState>& states) {
  std::vector<Doubles> sum(6);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    add_square(sum, 1, contact.normal_double);
    if (states[i] == SpringState::kSlip) continue;
    for (std::size_t t = 0; t < contact.tangents.size(); ++t) {
      add_square(sum, 1, contact.tangents_double[t]);
    }
  }
  return least_eigenvalue(std::move(sum), model.coordinates).direction;
}

LeastStiff least_stiff(const ForceModel& model, const std::vector<SpringState>& states) {
  const std::size_t n = model.coordinates;
  std::vector<Doubles> a(6);
  std::vector<Doubles> b(6);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    const double k = model.is_uniform ? 1 : contact.stiffness_double;
    const auto add = [&](const Doubles& x) {
      add_square(a, k, x);
      if (!model.is_uniform) add_square(b, k * k, x);
    };
    add(contact.normal_double);
    if (states[i] == SpringState::kSlip) continue;
    for (std::size_t t = 0; t < contact.tangents.size(); ++t) add(contact.tangents_double[t]);
  }
  std::vector<Doubles> values = a;
  std::vector<Doubles> vectors;
  diagonalise(values, vectors, n);
  std::size_t least = 0;
  double largest = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (values[j][j] < values[least][least]) least = j;
    largest = std::max(largest, values[j][j]);
  }
  if (values[least][least] <= 1e-12 * largest) return {0, column(vectors, least)};
  if (model.is_uniform) return {values[least][least], column(vectors, least)};
  // The largest v of A^-1 B A^-1 is at A z for the z that is sought.
  std::vector<Doubles> inverse(6);
  for (std::size_t j = 0; j < n; ++j) add_square(inverse, 1 / values[j][j], column(vectors, j));
  std::vector<Doubles> product(6);
  for (std::size_t j = 0; j < n; ++j) {
    Doubles row{};
    for (std::size_t k = 0; k < n; ++k) row = plus(row, inverse[j][k], b[k]);
    for (std::size_t k = 0; k < n; ++k) product[j] = plus(product[j], -row[k], inverse[k]);
  }
  const LeastStiff top = least_eigenvalue(std::move(product), n);
  LeastStiff result{-1 / top.inverse_square, {}};
  for (std::size_t j = 0; j < n; ++j) result.direction[j] = dot(inverse[j], top.direction);
  const double size = std::sqrt(dot(result.direction, result.direction));
  for (double& x : result.direction) x /= size;
  return result;
}

ForceProposal propose_forces(const ForceModel& model, const std::vector<SpringState>& states) {
  struct Column {
    std::size_t contact;
    std::size_t index;
    FrictionDirection direction;
  };
  ForceProposal result;
  result.used.resize(states.size());
  Directions directions(model, kManyDirections);
  std::vector<Column> columns;
  const std::size_t n = model.coordinates;
  std::vector<std::size_t> held;
  std::size_t count = 1;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    held.push_back(i);
    count += states[i] == SpringState::kStick ? directions.of(i).size() : 1;
  }
  Simplex program(n + held.size(), count);
  std::array<double, 6> sign{};
  for (std::size_t j = 0; j < n; ++j) {
    sign[j] = model.load_double[j] > 0 ? -1 : 1;
    program.set_right(j, -sign[j] * model.load_double[j]);
    program.set_cost(program.identity(j), -kImbalance);
  }
  program.set_cost(0, 1);
  Doubles lift{};
  std::size_t next = 1;
  for (std::size_t h = 0; h < held.size(); ++h) {
    const ForceContact& contact = model.contacts[held[h]];
    const bool sticks = states[held[h]] == SpringState::kStick;
    const double offset = sticks ? contact.root_double / contact.friction_double : 1;
    lift = plus(lift, offset, contact.normal_double);
    program.set(n + h, 0, 1 + offset);
    program.set_right(n + h, contact.most_force_double);
    const auto add = [&](const Doubles& wrench) {
      for (std::size_t j = 0; j < n; ++j) program.set(j, next, sign[j] * wrench[j]);
      program.set(n + h, next++, 1);
    };
    if (!sticks) {
      add(contact.normal_double);
    } else {
      for (std::size_t k = 0; k < directions.of(held[h]).size(); ++k) {
        columns.push_back({held[h], next, directions.of(held[h])[k]});
        add(directions.wrenches(held[h])[k]);
      }
    }
  }
  for (std::size_t j = 0; j < n; ++j) program.set(j, 0, sign[j] * lift[j]);
  for (int round = 0; round < kMostRounds; ++round) {
    if (!program.maximise()) break;
    Doubles& twist = result.twist;
    for (std::size_t j = 0; j < n; ++j) twist[j] = sign[j] * program.dual(j);
    bool is_new = false;
    for (std::size_t h = 0; h < held.size(); ++h) {
      if (states[held[h]] != SpringState::kStick) continue;
      if (!directions.add_against(held[h], twist)) continue;
      is_new = true;
      const Doubles& wrench = directions.wrenches(held[h]).back();
      std::vector<double> entries(program.rows());
      for (std::size_t j = 0; j < n; ++j) entries[j] = sign[j] * wrench[j];
      entries[n + h] = 1;
      columns.push_back(
          {held[h], program.add_column(entries, 0), directions.of(held[h]).back()});
    }
    if (!is_new) break;
  }
  const std::vector<double> values = program.values();
  for (const Column& column : columns) {
    if (values[column.index] > 0) result.used[column.contact].push_back(column.direction);
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (values[program.identity(j)] > 1e-8 * model.most_force_double) return result;
  }
  result.distance = values[0];
  return result;
}

std::optional<Doubles> propose_opening(const ForceModel& model,
                                       const std::vector<SpringState>& states) {
  ConePair pair{std::vector<double>(model.coordinates), {}};
  const auto column_of = [&](const Doubles& wrench, double factor) {
    DoubleColumn column;
    for (std::size_t j = 0; j < model.coordinates; ++j) {
      if (wrench[j] != 0) column.emplace_back(j, factor * wrench[j]);
    }
    return column;
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    for (std::size_t j = 0; j < model.coordinates; ++j) {
      pair.load[j] += contact.normal_double[j];
    }
    std::vector<DoubleColumn> cone{column_of(contact.normal_double, 1)};
    if (states[i] == SpringState::kStick) {
      for (std::size_t k = 0; k < contact.tangents.size(); ++k) {
        cone.push_back(column_of(contact.tangents_double[k], contact.friction_double));
      }
    }
    pair.cones.push_back(std::move(cone));
  }
  const ConeSearch search(pair);
  if (search.proposal().rests || search.proposal().motion.empty()) return std::nullopt;
  Doubles twist{};
  std::copy(search.proposal().motion.begin(), search.proposal().motion.end(), twist.begin());
  return twist;
}

/// A state of a contact with a force in it, and how much of it there is.
struct NodePrograms::Point {
  std::size_t contact;
  SpringState state;
  Doubles wrench;
};

/// One linear program: the share x_p of each point, the balance of wrenches, shares of each
/// contact that add up to 1, and a bound t <= sum x_p u.M_p u for each cut u.
class NodePrograms::Program {
 public:
  Program(const ForceModel& model, std::vector<Point> points,
          const std::vector<std::size_t>& first, std::vector<Doubles> cuts)
      : model_(model),
        points_(std::move(points)),
        first_(first),
        cuts_(std::move(cuts)),
        simplex_(model.coordinates + first.size() + cuts_.size(), points_.size() + 1) {
    const std::size_t n = model_.coordinates;
    Doubles rest = plus({}, -1, model_.load_double);
    for (const std::size_t p : first_) rest = plus(rest, -1, points_[p].wrench);
    for (std::size_t j = 0; j < n; ++j) {
      sign_[j] = rest[j] < 0 ? -1 : 1;
      simplex_.set_right(j, sign_[j] * rest[j]);
      simplex_.set_cost(simplex_.identity(j), -kImbalance);
    }
    for (std::size_t i = 0; i < first_.size(); ++i) simplex_.set_right(n + i, 1);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const std::vector<double> entries = column_of(points_[p]);
      for (std::size_t r = 0; r < entries.size(); ++r) simplex_.set(r, p, entries[r]);
      columns_.push_back(p);
    }
    const std::size_t bound = points_.size();
    simplex_.set_cost(bound, 1);
    bound_column_ = bound;
    for (std::size_t k = 0; k < cuts_.size(); ++k) {
      const std::size_t row = n + first_.size() + k;
      simplex_.set(row, bound, 1);
      simplex_.set_right(row, along_first(cuts_[k]));
    }
  }

  bool solve() { return simplex_.maximise(); }

  /// Adds a point. The program is to be solved again.
  void add(Point point) {
    columns_.push_back(simplex_.add_column(column_of(point), 0));
    points_.push_back(std::move(point));
  }

  /// Adds a cut and solves the program.
  bool cut(const Doubles& u) {
    std::vector<double> entries(simplex_.columns());
    for (std::size_t p = 0; p < points_.size(); ++p) {
      entries[columns_[p]] = along_first_of(points_[p].contact, u) - along(points_[p], u);
    }
    entries[bound_column_] = 1;
    cuts_.push_back(u);
    return simplex_.add_row(entries, along_first(u));
  }

  double value() const { return simplex_.objective(); }
  const std::vector<Point>& points() const { return points_; }

  Doubles twist() const {
    Doubles y{};
    for (std::size_t j = 0; j < model_.coordinates; ++j) y[j] = sign_[j] * simplex_.dual(j);
    return y;
  }

  std::vector<MatrixTerm> terms() const {
    std::vector<MatrixTerm> result;
    for (std::size_t k = 0; k < cuts_.size(); ++k) {
      const double weight = simplex_.dual(model_.coordinates + first_.size() + k);
      if (weight > 1e-9) result.push_back({weight, cuts_[k]});
    }
    return result;
  }

  /// Returns the shares of the points. The first point of a contact stands in the program as
  /// the slack of the contact's sum.
  std::vector<double> shares() const {
    const std::vector<double> values = simplex_.values();
    std::vector<double> result(points_.size());
    for (std::size_t p = 0; p < points_.size(); ++p) result[p] = values[columns_[p]];
    for (std::size_t i = 0; i < first_.size(); ++i) {
      result[first_[i]] += values[simplex_.identity(model_.coordinates + i)];
    }
    return result;
  }

 private:
  /// Returns the entries of a point that takes the place of the first one of its contact.
  std::vector<double> column_of(const Point& point) const {
    const std::size_t n = model_.coordinates;
    std::vector<double> entries(simplex_.rows());
    const Doubles change = plus(point.wrench, -1, points_[first_[point.contact]].wrench);
    for (std::size_t j = 0; j < n; ++j) entries[j] = sign_[j] * change[j];
    entries[n + point.contact] = 1;
    for (std::size_t k = 0; k < cuts_.size(); ++k) {
      entries[n + first_.size() + k] =
          along_first_of(point.contact, cuts_[k]) - along(point, cuts_[k]);
    }
    return entries;
  }

  double along(const Point& point, const Doubles& u) const {
    return squares_along(model_.contacts[point.contact],
                         u)[static_cast<std::size_t>(point.state)];
  }
  double along_first_of(std::size_t contact, const Doubles& u) const {
    return along(points_[first_[contact]], u);
  }
  double along_first(const Doubles& u) const {
    double sum = 0;
    for (const std::size_t p : first_) sum += along(points_[p], u);
    return sum;
  }

  const ForceModel& model_;
  std::vector<Point> points_;
  const std::vector<std::size_t>& first_;
  std::vector<Doubles> cuts_;
  Simplex simplex_;
  std::array<double, 6> sign_{};
  std::vector<std::size_t> columns_;  ///< by point
  std::size_t bound_column_ = 0;
};

NodePrograms::NodePrograms(const ForceModel& model, Directions& directions)
    : model_(model), directions_(directions) {
  for (std::size_t j = 0; j < model.coordinates; ++j) {
    Doubles axis{};
    axis[j] = 1;
    cuts_.push_back(axis);
  }
}

NodeProposal NodePrograms::bound(const std::vector<StateSet>& sets, double distance,
                                 double enough,
                                 const std::vector<std::array<double, 3>>& share) {
  std::vector<Point> points;
  std::vector<std::size_t> first;
  std::vector<double> offsets(sets.size());
  std::vector<double> rooms(sets.size(), -1);
  const auto stick_point = [&](std::size_t i, const Doubles& wrench) {
    const Doubles base = plus({}, distance * offsets[i], model_.contacts[i].normal_double);
    return Point{i, SpringState::kStick, plus(base, rooms[i], wrench)};
  };
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const ForceContact& c = model_.contacts[i];
    const std::size_t begin = points.size();
    const double f = c.most_force_double;
    if ((sets[i] & only(SpringState::kDetached)) != 0) {
      points.push_back({i, SpringState::kDetached, {}});
    }
    if ((sets[i] & only(SpringState::kSlip)) != 0 && 2 * distance <= f) {
      points.push_back({i, SpringState::kSlip, plus({}, distance, c.normal_double)});
      points.push_back({i, SpringState::kSlip, plus({}, f - distance, c.normal_double)});
    }
    if ((sets[i] & only(SpringState::kStick)) != 0 && c.can_stick()) {
      offsets[i] = c.root_double / c.friction_double;
      rooms[i] = f - distance * (1 + offsets[i]);
      if (rooms[i] >= 0) {
        points.push_back(stick_point(i, {}));
        for (const Doubles& wrench : directions_.wrenches(i)) {
          points.push_back(stick_point(i, wrench));
        }
      }
    }
    if (points.size() == begin) {
      NodeProposal none;
      none.is_solved = true;
      none.square = -1;
      return none;
    }
    std::size_t start = begin;
    if (!share.empty()) {
      for (std::size_t p = begin; p < points.size(); ++p) {
        if (share[i][static_cast<std::size_t>(points[p].state)] >
            share[i][static_cast<std::size_t>(points[start].state)]) {
          start = p;
        }
      }
    }
    first.push_back(start);
  }
  const std::size_t axes = model_.coordinates;
  if (cuts_.size() > axes + kKeptCuts) {
    cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(axes),
                cuts_.end() - static_cast<std::ptrdiff_t>(kKeptCuts));
  }
  Program program(model_, std::move(points), first, cuts_);
  NodeProposal found;
  if (!program.solve()) return found;
  for (int round = 0; round < kMostRounds; ++round) {
    found.is_solved = true;
    found.twist = program.twist();
    found.terms = program.terms();
    const std::vector<double> shares = program.shares();
    found.share.assign(sets.size(), {});
    std::vector<Doubles> sum(6);
    for (std::size_t p = 0; p < shares.size(); ++p) {
      if (shares[p] <= 0) continue;
      const Point& point = program.points()[p];
      found.share[point.contact][static_cast<std::size_t>(point.state)] += shares[p];
      const ForceContact& c = model_.contacts[point.contact];
      if (point.state == SpringState::kDetached) continue;
      add_square(sum, shares[p], c.normal_double);
      if (point.state == SpringState::kSlip) continue;
      for (std::size_t t = 0; t < c.tangents.size(); ++t) {
        add_square(sum, shares[p], c.tangents_double[t]);
      }
    }
    // In space the twist may bound less than the program, which knows few directions.
    bool has_new = false;
    double excess = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!model_.contacts[i].is_round() || rooms[i] < 0) continue;
      double known = 0;
      for (const Doubles& w : directions_.wrenches(i))
        known = std::max(known, -dot(w, found.twist));
      excess += rooms[i] * std::max(0.0, most_against(model_.contacts[i], found.twist) - known);
      if (!directions_.add_against(i, found.twist)) continue;
      has_new = true;
      program.add(stick_point(i, directions_.wrenches(i).back()));
    }
    found.square = program.value() + excess;
    if (found.square <= enough || found.square < 0) return found;
    const LeastStiff least = least_eigenvalue(std::move(sum), model_.coordinates);
    const bool cuts = least.inverse_square < program.value() * (1 - 1e-4);
    if (!cuts && !has_new) return found;
    if (has_new && !program.solve()) return found;
    if (cuts) {
      cuts_.push_back(least.direction);
      if (!program.cut(least.direction)) return found;
    }
  }
  return found;
}

}  // namespace stickslip::robustness_detail
