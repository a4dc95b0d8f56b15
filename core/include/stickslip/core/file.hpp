// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads files, and writes files whole or not at all.
#pragma once

#include <chrono>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "stickslip/core/error.hpp"

namespace stickslip {

/// A file open for reading.
class InputFile {
 public:
  /// Opens a file; "-" is standard input. Throws InputError naming `path` for a directory and
  /// for a file that cannot be opened. The remedy asks for `expected`, "a grasp file".
  InputFile(const std::string& path, const std::string& expected);

  std::istream& stream();  ///< the content, from its beginning
  /// Returns the content. Of a file that is longer than `most` bytes it is cut off somewhere
  /// behind them. Throws InputError if reading fails.
  std::string read(std::size_t most);
  const std::string& name() const { return name_; }  ///< the name for errors; "<stdin>" for "-"

 private:
  std::string name_;
  bool standard_;
  std::ifstream file_;
};

/// Protects every InputFile from now on (protect_file), and lets none be opened that is
/// standard output or error as well. It is for a program that answers one command and ends.
void protect_inputs();

/// Lets no write_whole_file replace this file, under any of its names. In errors `role` says
/// what it is, "input". Only regular files need this: nothing is remembered of others, or of
/// files that do not exist.
void protect_file(const std::string& path, const std::string& role);

/// Throws InputError naming `path` and the protected file if `path` is a protected file. It is
/// for code that writes by other means than write_whole_file.
void require_unprotected(const std::string& path);

/// Returns the error to throw when `path` cannot be written, for the reason that `error`, an
/// errno, gives.
InputError cannot_write(const std::string& path, int error);

/// Makes the folder that an option names, if it is not there. Throws InputError naming both.
void make_folder(const std::string& option, const std::string& folder);

/// Writes a temporary file beside `path` and renames it: at every moment `path` is what it was
/// before or all of `content`. An existing file is replaced and keeps its permissions. If
/// `path` is a symbolic link, the file that it leads to is replaced. Standard output ("-"),
/// devices and pipes are written directly. Throws InputError naming `path` when the file is
/// protected or cannot be written.
///
/// A signal that ends the program in the meantime leaves the temporary file behind, unless the
/// program waits for the end of the write as the command line does (stop_file_writes).
void write_whole_file(const std::string& path, std::string_view content);

/// \{ A function that gives content in pieces to its argument, and returns whether that is all.
using FilePiece = std::function<void(std::string_view)>;
using FilePieces = std::function<bool(const FilePiece&)>;
/// \}

/// Writes what `pieces` gives in the same way. If it returns false, or throws, `path` stays as
/// it was, but for what is written directly.
void write_whole_file(const std::string& path, const FilePieces& pieces);

/// Returns the name of the file that a temporary file of write_whole_file was to become, given
/// the temporary name; an empty string for any other name.
std::string target_of_temporary(std::string_view name);

/// Returns whether a name is `before`, which does not end with a digit, decimal digits, at
/// least one, and `after`: "line-3.json" is between "line-" and ".json".
bool is_numbered(std::string_view name, std::string_view before, std::string_view after);

/// A file, or several that belong together, are being written while one of these lives. They
/// may nest within a thread. Once writes are stopped, the constructor does not return.
class FileWrite {
 public:
  FileWrite();
  ~FileWrite();
  FileWrite(const FileWrite&) = delete;
  FileWrite& operator=(const FileWrite&) = delete;
};

/// Lets no FileWrite begin, and waits until none lives, but not longer than `at_most`, in case
/// a disk does not answer. It is for a program that is about to end, and must not be called by
/// a thread that holds a FileWrite, nor by a signal handler.
void stop_file_writes(std::chrono::seconds at_most);

}  // namespace stickslip
