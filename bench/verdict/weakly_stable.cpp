// SPDX-License-Identifier: GPL-3.0-or-later
#include "weakly_stable.hpp"

#include <glpk.h>

#include <stdexcept>
#include <vector>

#include "stickslip/core/contact_row.hpp"

namespace stickslip::bench {

bool is_weakly_stable(const Question& question) {
  const std::vector<ContactRow> rows = contact_rows(question.loaded().grasp);
  const Vector3 load = coordinates(question.loaded().wrench);
  glp_prob* program = glp_create_prob();
  glp_add_rows(program, 3);
  for (int r = 0; r < 3; ++r) {
    const double value = -to_double(load[static_cast<std::size_t>(r)]);
    glp_set_row_bnds(program, r + 1, GLP_FX, value, value);
  }
  if (!rows.empty()) glp_add_cols(program, static_cast<int>(2 * rows.size()));
  int column = 0;
  for (const ContactRow& row : rows) {
    for (const int side : {1, -1}) {
      const Vector3 edge =
          coordinates(row.normal + Rational(side) * row.friction * row.tangent);
      const int index[] = {0, 1, 2, 3};
      const double value[] = {0, to_double(edge[0]), to_double(edge[1]), to_double(edge[2])};
      ++column;
      glp_set_col_bnds(program, column, GLP_LO, 0, 0);
      glp_set_mat_col(program, column, 3, index, value);
    }
  }
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  const int failed = glp_simplex(program, &options);
  const int status = glp_get_status(program);
  glp_delete_prob(program);
  if (failed != 0) throw std::runtime_error("GLPK gave up");
  return status == GLP_OPT || status == GLP_FEAS;
}

}  // namespace stickslip::bench
