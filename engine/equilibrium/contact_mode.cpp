// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/contact_mode.hpp"

namespace stickslip {

ContactMode mode_of(const Problem& problem, ContactId contact, const Twist& d) {
  const ContactRow& row = problem.row(contact);
  return {problem.law() == NormalLaw::kBilateral || row.normal_coefficient(d).sign() >= 0,
          sign_of(power(row.tangent, d))};
}

std::vector<ContactMode> modes_of(const Problem& problem, const Twist& d) {
  std::vector<ContactMode> modes;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    modes.push_back(mode_of(problem, ContactId(i), d));
  }
  return modes;
}

std::string slips_text(const std::vector<ContactMode>& modes) {
  std::string text;
  for (const ContactMode mode : modes) text += to_char(mode.slip);
  return text;
}

}  // namespace stickslip
