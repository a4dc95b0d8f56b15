// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Files written whole or not at all.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace stickslip {

/// Writes a temporary file beside `path` and renames it: at every moment `path` is what it was
/// before or all of `content`. Replaces an existing file, with its permissions; where `path` is
/// a symbolic link, the file that it leads to. "-" is standard output, written directly, as are
/// devices and pipes. Throws InputError naming `path` when the file cannot be written.
///
/// A signal that ends the program in the meantime leaves the temporary file behind, unless the
/// program waits for the end of the write as the command line does (stop_file_writes).
void write_whole_file(const std::string& path, std::string_view content);

/// While one lives, a file is being written, or several that belong together. May nest within a
/// thread. Once writes are stopped the constructor does not return.
class FileWrite {
 public:
  FileWrite();
  ~FileWrite();
  FileWrite(const FileWrite&) = delete;
  FileWrite& operator=(const FileWrite&) = delete;
};

/// For a program that is about to end: lets no FileWrite begin, and waits until none lives, but
/// not longer than `at_most`, should a disk not answer. Must not be called by a thread that
/// holds one, nor by a signal handler.
void stop_file_writes(std::chrono::seconds at_most);

}  // namespace stickslip
