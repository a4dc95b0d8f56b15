// SPDX-License-Identifier: GPL-3.0-or-later
#include "float_twin.hpp"

#include <glpk.h>

#include <cmath>
#include <memory>
#include <optional>

namespace stickslip::bench {
namespace {

using State = std::vector<int>;  ///< of slip: -1, 0, 1

/// A linear program in free variables, row by row.
class Program {
 public:
  Program(int variables, double tolerance)
      : program_(glp_create_prob(), glp_delete_prob), variables_(variables) {
    glp_add_cols(program_.get(), variables);
    for (int c = 1; c <= variables; ++c) glp_set_col_bnds(program_.get(), c, GLP_FR, 0, 0);
    glp_init_smcp(&options_);
    options_.msg_lev = GLP_MSG_OFF;
    options_.tol_bnd = tolerance;
    options_.tol_dj = tolerance;
    options_.it_lim = 1000;  // with a tight tolerance it may cycle; then it finds nothing
  }

  void bound(int variable, double low, double high) {
    glp_set_col_bnds(program_.get(), variable + 1, low < high ? GLP_DB : GLP_FX, low, high);
  }

  /// row.x = value, or row.x >= value
  void add(const Eigen::VectorXd& row, bool equality, double value) {
    const int index = glp_add_rows(program_.get(), 1);
    glp_set_row_bnds(program_.get(), index, equality ? GLP_FX : GLP_LO, value, value);
    std::vector<int> columns{0};
    std::vector<double> values{0};
    for (int c = 0; c < variables_; ++c) {
      if (row[c] == 0) continue;
      columns.push_back(c + 1);
      values.push_back(row[c]);
    }
    glp_set_mat_row(program_.get(), index, static_cast<int>(columns.size()) - 1, columns.data(),
                    values.data());
  }

  void maximize(int variable) {
    glp_set_obj_dir(program_.get(), GLP_MAX);
    glp_set_obj_coef(program_.get(), variable + 1, 1);
  }

  std::optional<Eigen::VectorXd> solve() {
    if (glp_simplex(program_.get(), &options_) != 0) return std::nullopt;
    const int status = glp_get_status(program_.get());
    if (status != GLP_OPT && status != GLP_FEAS) return std::nullopt;
    Eigen::VectorXd x(variables_);
    for (int c = 0; c < variables_; ++c) x[c] = glp_get_col_prim(program_.get(), c + 1);
    return x;
  }

 private:
  std::unique_ptr<glp_prob, void (*)(glp_prob*)> program_;
  int variables_;
  glp_smcp options_;
};

/// Whether some motion in a box has these signs of slip, by a margin above the tolerance.
bool is_state(const FloatQuestion& question, const State& state, double tolerance) {
  Program program(4, tolerance);  // the motion and the margin
  for (int c = 0; c < 3; ++c) program.bound(c, -1, 1);
  program.bound(3, 0, 1);
  program.maximize(3);
  for (std::size_t i = 0; i < state.size(); ++i) {
    Eigen::VectorXd row(4);
    row << question.contacts[i].tangent_row, 0;
    if (state[i] != 0) row = row * state[i];
    row[3] = state[i] != 0 ? -1 : 0;
    program.add(row, state[i] == 0, 0);
  }
  const auto solution = program.solve();
  return solution && (*solution)[3] > tolerance;
}

std::vector<State> slip_states(const FloatQuestion& question, double tolerance) {
  std::vector<State> states{{}};
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    std::vector<State> next;
    for (State state : states) {
      state.push_back(0);
      for (const int sign : {-1, 0, 1}) {
        state.back() = sign;
        if (is_state(question, state, tolerance)) next.push_back(state);
      }
    }
    states = std::move(next);
  }
  return states;
}

/// Eqs. 1, 4 and 12-14 and the signs of the state. Unknowns: the motion, and friction at each
/// closed contact.
FloatAnswer solve_state(const FloatQuestion& question, const State& state,
                        const std::vector<bool>& closed, double tolerance) {
  const std::size_t m = state.size();
  const int variables = 3 + static_cast<int>(m);
  Program program(variables, tolerance);
  Eigen::MatrixXd balance = Eigen::MatrixXd::Zero(3, variables);
  Eigen::Vector3d constant = question.load;
  for (std::size_t i = 0; i < m; ++i) {
    const FloatContact& c = question.contacts[i];
    const int friction = 3 + static_cast<int>(i);
    Eigen::VectorXd slip = Eigen::VectorXd::Zero(variables);
    slip.head<3>() = c.tangent_row;
    program.add(state[i] < 0 ? Eigen::VectorXd(-slip) : slip, state[i] == 0, 0);
    // v = P - k N.d
    Eigen::VectorXd normal = Eigen::VectorXd::Zero(variables);
    normal.head<3>() = -c.stiffness * c.normal_row;
    if (!closed[i]) {
      program.add(-normal, false, c.preload);
      program.bound(friction, 0, 0);
      continue;
    }
    program.add(normal, false, -c.preload);
    balance += c.normal_row * normal.transpose();
    balance.col(friction) += c.tangent_row;
    constant += c.preload * c.normal_row;
    // mu v - |friction| >= 0, and 0 on the side against slip.
    for (const int side : {-1, 1}) {
      Eigen::VectorXd room = c.friction * normal;
      room[friction] = side;
      program.add(room, state[i] == side, -c.friction * c.preload);
    }
  }
  for (int r = 0; r < 3; ++r) program.add(balance.row(r).transpose(), true, -constant[r]);
  const auto solution = program.solve();
  FloatAnswer answer;
  if (!solution) return answer;
  answer.stable = true;
  answer.twist = solution->head<3>();
  for (std::size_t i = 0; i < m; ++i) {
    const FloatContact& c = question.contacts[i];
    const double v = c.preload - c.stiffness * c.normal_row.dot(answer.twist);
    const double normal = closed[i] ? v : 0;
    const double friction = closed[i] ? (*solution)[3 + static_cast<int>(i)] : 0;
    const Eigen::Vector2d tangent(-c.normal.y(), c.normal.x());
    answer.forces.emplace_back(normal * c.normal + friction * tangent);
  }
  return answer;
}

}  // namespace

FloatQuestion to_float(const Question& question) {
  FloatQuestion result;
  result.law = question.law;
  const Wrench& w = question.loaded().wrench;
  result.load << to_double(w.x), to_double(w.y), to_double(w.torque);
  for (const Contact& contact : question.loaded().grasp.contacts()) {
    FloatContact c;
    const Eigen::Vector2d p(to_double(contact.position.x), to_double(contact.position.y));
    c.normal = Eigen::Vector2d(to_double(contact.normal.x), to_double(contact.normal.y));
    c.normal.normalize();
    const Eigen::Vector2d t(-c.normal.y(), c.normal.x());
    c.normal_row << c.normal, p.x() * c.normal.y() - p.y() * c.normal.x();
    c.tangent_row << t, p.x() * t.y() - p.y() * t.x();
    c.friction = to_double(contact.friction);
    c.stiffness = to_double(contact.stiffness);
    c.preload = to_double(contact.preload);
    result.contacts.push_back(c);
  }
  return result;
}

FloatAnswer decide_in_doubles(const FloatQuestion& question, double tolerance) {
  const std::size_t m = question.contacts.size();
  std::vector<State> states = slip_states(question, tolerance);
  states.emplace_back(m, 0);
  // Under the bilateral law no contact opens.
  const std::size_t all_closed = (std::size_t{1} << m) - 1;
  const std::size_t last = question.law == NormalLaw::kBilateral ? all_closed : 0;
  for (const State& state : states) {
    for (std::size_t set = all_closed + 1; set-- > last;) {
      std::vector<bool> closed;
      for (std::size_t i = 0; i < m; ++i) closed.push_back((set >> i & 1U) != 0);
      FloatAnswer answer = solve_state(question, state, closed, tolerance);
      if (answer.stable) return answer;
    }
  }
  return {};
}

}  // namespace stickslip::bench
