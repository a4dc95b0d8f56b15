// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Files to read, and files written whole or not at all.
#pragma once

#include <chrono>
#include <fstream>
#include <string>
#include <string_view>

#include "stickslip/core/error.hpp"

namespace stickslip {

/// A file open for reading.
class InputFile {
 public:
  /// "-" is standard input. Throws InputError naming `path` for a directory and for what cannot
  /// be opened; `expected` is what the remedy asks for, "a grasp file".
  InputFile(const std::string& path, const std::string& expected);

  std::istream& stream();                            ///< reads from its beginning
  const std::string& name() const { return name_; }  ///< for errors; "<stdin>" of "-"

 private:
  std::string name_;
  bool standard_;
  std::ifstream file_;
};

/// For a program that answers one command and ends: from now on every InputFile is protected
/// (protect_file), and none may be opened that is standard output or error as well.
void protect_inputs();

/// Lets no write_whole_file replace this file, under any of its names; `role` says in errors
/// what it is, "input". Only regular files need this; of others, and of files that do not
/// exist, nothing is remembered.
void protect_file(const std::string& path, const std::string& role);

/// For what writes by other means than write_whole_file. Throws InputError naming `path` and
/// the protected file that this is.
void require_unprotected(const std::string& path);

/// What is thrown when `path` cannot be written, for the reason that `error`, an errno, gives.
InputError cannot_write(const std::string& path, int error);

/// Makes the folder that an option names, if it is not there. Throws InputError naming both.
void make_folder(const std::string& option, const std::string& folder);

/// Writes a temporary file beside `path` and renames it: at every moment `path` is what it was
/// before or all of `content`. Replaces an existing file, with its permissions; where `path` is
/// a symbolic link, the file that it leads to. "-" is standard output, written directly, as are
/// devices and pipes. Throws InputError naming `path` when the file is protected or cannot be
/// written.
///
/// A signal that ends the program in the meantime leaves the temporary file behind, unless the
/// program waits for the end of the write as the command line does (stop_file_writes).
void write_whole_file(const std::string& path, std::string_view content);

/// Of the name of a temporary file of write_whole_file, that of the file which it was to
/// become; of any other name nothing.
std::string target_of_temporary(const std::string& name);

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
