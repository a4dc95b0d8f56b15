// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Files written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace stickslip {

/// Writes a temporary file beside `path` and renames it: at every moment `path` is what it was
/// before or all of `content`. Replaces an existing file. "-" is standard output, written
/// directly. Throws InputError naming `path` when the file cannot be written.
void write_whole_file(const std::string& path, std::string_view content);

}  // namespace stickslip
