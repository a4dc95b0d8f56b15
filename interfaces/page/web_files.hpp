// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The files in page/web, by name; made by interfaces/page/CMakeLists.txt.
#pragma once

#include <map>
#include <string>

namespace stickslip::page_detail {

const std::map<std::string, std::string>& web_files();

}  // namespace stickslip::page_detail
