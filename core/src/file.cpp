// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

InputError cannot_write(const std::string& path, int error) {
  return {path, "", std::string("the file cannot be written: ") + std::strerror(error),
          "name a file in an existing folder that you may write to"};
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

}  // namespace

void write_whole_file(const std::string& path, std::string_view content) {
  if (path == "-") {
    if (!write_all(STDOUT_FILENO, content)) throw cannot_write("<stdout>", errno);
    return;
  }
  // A device or pipe (/dev/null, /dev/stdout) cannot be replaced by renaming.
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const bool good = descriptor >= 0 && write_all(descriptor, content);
    const int error = errno;
    if (descriptor >= 0) ::close(descriptor);
    if (!good) throw cannot_write(path, error);
    return;
  }
  const std::string pattern = path + ".XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) throw cannot_write(path, errno);
  // mkstemp makes the file private; give it the permissions a new file would have.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  bool good = ::fchmod(descriptor, static_cast<mode_t>(0666) & ~mask) == 0 &&
              write_all(descriptor, content);
  int error = errno;
  if (::close(descriptor) != 0) {
    good = false;
    error = errno;
  }
  if (good && std::rename(name.data(), path.c_str()) != 0) {
    good = false;
    error = errno;
  }
  if (!good) {
    ::unlink(name.data());
    throw cannot_write(path, error);
  }
}

}  // namespace stickslip
