// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions for certificate/python/check.py, as tests/support/batch.py reads them.
#pragma once

#include <string>
#include <vector>

namespace stickslip::test {

/// A question as a line of JSON: the bytes of both files, the words of the command line, and
/// the result ("accepted", "rejected", "malformed") that it must give, empty if that is not
/// known.
std::string spool_line(const std::string& grasp, const std::string& certificate,
                       const std::vector<std::string>& options, const std::string& expected);

/// Leaves a line in the folder named by the environment variable STICKSLIP_SPOOL, if it is set.
/// False if it cannot be written.
bool append_to_spool(const std::string& line);

}  // namespace stickslip::test
