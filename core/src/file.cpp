// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {
namespace {

namespace fs = std::filesystem;

/// The files that must not be written over, known by device and inode, not by name.
struct ProtectedFiles {
  std::mutex mutex;
  bool inputs = false;  ///< whether every file that is opened is protected
  std::map<std::pair<dev_t, ino_t>, std::string> roles;  ///< "the input g.json"
};

ProtectedFiles& protected_files() {
  static auto* const all = new ProtectedFiles;  // threads may write while the program ends
  return *all;
}

void protect(const struct stat& file, const std::string& role) {
  if (!S_ISREG(file.st_mode)) return;
  ProtectedFiles& all = protected_files();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.roles.emplace(std::pair(file.st_dev, file.st_ino), role);
}

void require_unprotected(const struct stat& file, const std::string& path) {
  ProtectedFiles& all = protected_files();
  const std::lock_guard<std::mutex> lock(all.mutex);
  const auto found = all.roles.find({file.st_dev, file.st_ino});
  if (found == all.roles.end()) return;
  throw InputError(path, "", "this would be written over " + found->second,
                   "name another file for what is written");
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Returns the file that is to be replaced: the one to which `path` leads through any number of
/// links. If that does not exist yet, it is the file that the last link names.
std::string behind_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // the kernel follows so many
  fs::path file = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(file, error); ++links) {
    if (links == kMostLinks) throw cannot_write(path, ELOOP);
    const fs::path target = fs::read_symlink(file, error);
    if (error) throw cannot_write(path, error.value());
    file = file.parent_path() / target;  // the target alone if it is absolute
  }
  return file.string();
}

/// Returns the descriptor of standard output or error if that is this file, as /dev/stdout is.
std::optional<int> standard_stream(const struct stat& file) {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat stream {};
    if (::fstat(descriptor, &stream) == 0 && stream.st_dev == file.st_dev &&
        stream.st_ino == file.st_ino) {
      return descriptor;
    }
  }
  return std::nullopt;
}

/// Writes all pieces, and returns whether they are all. In errors the file is `path`.
bool write_pieces(int descriptor, const std::string& path, const FilePieces& pieces) {
  return pieces([&](std::string_view piece) {
    if (!write_all(descriptor, piece)) throw cannot_write(path, errno);
  });
}

/// Writes to a device or pipe (/dev/null), which cannot be replaced by renaming.
void write_into(const std::string& path, const FilePieces& pieces) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throw cannot_write(path, errno);
  try {
    write_pieces(descriptor, path, pieces);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
}

/// A new file that is open for writing.
struct TemporaryFile {
  std::string name;
  int descriptor;
};

/// Makes a new file beside `file`, with a name that target_of_temporary reads. With
/// `is_private` only its owner may use it, as the file that it is to replace may be private.
TemporaryFile make_temporary(const std::string& file, bool is_private) {
  static std::atomic<unsigned> count{0};
  const mode_t mode = is_private ? 0600 : 0666;
  for (;;) {
    const std::string name =
        file + "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp";
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return {name, descriptor};
  }
}

/// Sets the permissions to those of the file that is replaced.
bool set_permissions(int descriptor, const struct stat& replaced) {
  // Only root may give a file away; otherwise it belongs to who wrote it.
  const bool given = ::fchown(descriptor, replaced.st_uid, replaced.st_gid) == 0;
  const auto mode = static_cast<mode_t>(given ? 07777 : 0777);
  return ::fchmod(descriptor, replaced.st_mode & mode) == 0;
}

/// Removes what a text ends with; returns false if it does not.
bool remove_end(std::string_view& text, std::string_view end) {
  if (text.size() < end.size() || text.substr(text.size() - end.size()) != end) return false;
  text.remove_suffix(end.size());
  return true;
}

/// Removes the decimal digits that a text ends with; returns false if there is none.
bool remove_digits(std::string_view& text) {
  const std::size_t left = text.find_last_not_of("0123456789") + 1;  // 0 if all are digits
  if (left == text.size()) return false;
  text = text.substr(0, left);
  return true;
}

/// The number of threads that are writing, and whether others may begin.
struct Writes {
  std::mutex mutex;
  std::condition_variable changed;
  int under_way = 0;
  bool stopped = false;
};

/// Returns the one object, which is never destroyed: threads may write while the program ends.
Writes& writes() {
  static auto* const all = new Writes;
  return *all;
}

thread_local int writes_of_this_thread = 0;

}  // namespace

FileWrite::FileWrite() {
  if (writes_of_this_thread++ > 0) return;
  Writes& all = writes();
  std::unique_lock<std::mutex> lock(all.mutex);
  all.changed.wait(lock, [&] { return !all.stopped; });
  ++all.under_way;
}

FileWrite::~FileWrite() {
  if (--writes_of_this_thread > 0) return;
  Writes& all = writes();
  const std::lock_guard<std::mutex> lock(all.mutex);
  --all.under_way;
  all.changed.notify_all();
}

void stop_file_writes(std::chrono::seconds at_most) {
  Writes& all = writes();
  std::unique_lock<std::mutex> lock(all.mutex);
  all.stopped = true;
  all.changed.wait_for(lock, at_most, [&] { return all.under_way == 0; });
}

InputFile::InputFile(const std::string& path, const std::string& expected)
    : name_(path == "-" ? "<stdin>" : path), standard_(path == "-") {
  struct stat file {};
  const bool exists =
      (standard_ ? ::fstat(STDIN_FILENO, &file) : ::stat(path.c_str(), &file)) == 0;
  if (exists && S_ISDIR(file.st_mode)) {
    throw InputError(name_, "", "this is a directory", "name " + expected);
  }
  if (!standard_) {
    errno = 0;
    file_.open(path, std::ios::binary);
    if (!file_) {
      const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
      throw InputError(path, "", "cannot open the file: " + reason,
                       "name " + expected + ", or - for standard input");
    }
  }
  if (!exists || !protected_files().inputs || !S_ISREG(file.st_mode)) return;
  if (standard_stream(file)) {
    throw InputError(name_, "", "the output goes into this very file",
                     "send standard output and error elsewhere");
  }
  protect(file, "the input " + name_);
}

std::istream& InputFile::stream() {
  return standard_ ? std::cin : file_;
}

std::string InputFile::read(std::size_t most) {
  std::istream& in = stream();
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (in && text.size() <= most) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(name_, "", "reading failed", "is it a readable file?");
  return text;
}

void protect_inputs() {
  protected_files().inputs = true;
}

void protect_file(const std::string& path, const std::string& role) {
  struct stat file {};
  if (::stat(path.c_str(), &file) == 0) protect(file, "the " + role + " " + path);
}

void require_unprotected(const std::string& path) {
  struct stat file {};
  if (::stat(path.c_str(), &file) == 0) require_unprotected(file, path);
}

InputError cannot_write(const std::string& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT;
  const std::string reason = error != 0 ? std::strerror(error) : "unknown reason";
  return {path, "", "the file cannot be written: " + reason,
          full ? "make room there, or name a file elsewhere"
               : "name a file in an existing folder that you may write to"};
}

void make_folder(const std::string& option, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw InputError(folder, option, "the folder cannot be made: " + error.message(),
                     "name a folder that you may write to");
  }
}

std::string target_of_temporary(std::string_view name) {
  const bool is_one = remove_end(name, ".tmp") && remove_digits(name) &&
                      remove_end(name, "-") && remove_digits(name) && remove_end(name, ".");
  return is_one ? std::string(name) : std::string();
}

bool is_numbered(std::string_view name, std::string_view before, std::string_view after) {
  return remove_end(name, after) && remove_digits(name) && name == before;
}

void write_whole_file(const std::string& path, std::string_view content) {
  write_whole_file(path, [content](const FilePiece& write) {
    write(content);
    return true;
  });
}

void write_whole_file(const std::string& path, const FilePieces& pieces) {
  if (path == "-") {
    write_pieces(STDOUT_FILENO, "<stdout>", pieces);
    return;
  }
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists) require_unprotected(old, path);
  if (const auto stream = exists ? standard_stream(old) : std::nullopt) {
    write_pieces(*stream, path, pieces);
    return;
  }
  if (exists && !S_ISREG(old.st_mode)) {
    write_into(path, pieces);
    return;
  }

  const std::string file = behind_links(path);
  const FileWrite write;
  const auto [name, descriptor] = make_temporary(file, exists);
  if (descriptor < 0) throw cannot_write(path, errno);
  bool all = false;
  try {
    all = write_pieces(descriptor, path, pieces);
  } catch (...) {
    ::close(descriptor);
    ::unlink(name.c_str());
    throw;
  }
  bool good = !all || !exists || set_permissions(descriptor, old);
  int error = errno;
  if (::close(descriptor) != 0) {
    good = false;
    error = errno;
  }
  if (all && good && std::rename(name.c_str(), file.c_str()) != 0) {
    good = false;
    error = errno;
  }
  if (!all || !good) ::unlink(name.c_str());
  if (!good) throw cannot_write(path, error);
}

}  // namespace stickslip
