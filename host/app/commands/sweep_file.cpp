// See sweep_file.hpp.
#include "host/app/commands/sweep_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "host/app/command.hpp"

namespace sightline::app {

namespace {

[[noreturn]] void fail_with_errno(const std::string& path, const char* doing = "cannot write") {
  throw Failure(ExitCode::io, path + ": " + doing + ": " + std::strerror(errno));
}

}  // namespace

SweepFile::SweepFile(const std::string& path) : path_(path) {
  if (path == "-") {
    path_ = "standard output";
    file_ = STDOUT_FILENO;
    return;
  }
  // A pipe is opened for writing only: reading and writing it would not fail when nobody reads.
  struct stat about {};
  const bool exists = stat(path.c_str(), &about) == 0;
  regular_ = !exists || S_ISREG(about.st_mode);
  file_ = open(path.c_str(), (regular_ ? O_RDWR | O_CREAT : O_WRONLY) | O_CLOEXEC, 0666);
  if (file_ < 0) fail_with_errno(path);
  if (regular_ && flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int why = errno;
    close(file_);
    file_ = -1;
    errno = why;
    if (why == EWOULDBLOCK) throw Failure(ExitCode::io, path + ": is being written by another sweep");
    fail_with_errno(path);
  }
}

SweepFile::~SweepFile() {
  if (file_ > STDERR_FILENO) close(file_);
}

std::int64_t SweepFile::keep_lines(const std::function<bool(std::string_view)>& keep) {
  if (!regular_) return 0;
  std::string held;
  std::vector<char> block(std::size_t{1} << 16);
  std::int64_t kept = 0;
  off_t length = 0;
  while (true) {
    const ssize_t count = read(file_, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_with_errno(path_, "cannot read");
    if (count == 0) break;
    held.append(block.data(), static_cast<std::size_t>(count));
    std::size_t from = 0;
    for (std::size_t end = held.find('\n'); end != std::string::npos; end = held.find('\n', from)) {
      if (!keep(std::string_view(held).substr(from, end + 1 - from))) return -1 - kept;
      ++kept;
      length += static_cast<off_t>(end + 1 - from);
      from = end + 1;
    }
    held.erase(0, from);
  }
  if (ftruncate(file_, length) != 0 || lseek(file_, length, SEEK_SET) < 0) fail_with_errno(path_);
  return kept;
}

void SweepFile::append(std::string_view line) {
  const off_t start = regular_ ? lseek(file_, 0, SEEK_CUR) : 0;
  while (!line.empty()) {
    const ssize_t count = write(file_, line.data(), line.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int why = errno;
      // A full disk leaves whole lines. What is left of this one if even that fails, the next sweep takes
      // off.
      if (regular_) static_cast<void>(ftruncate(file_, start) == 0);
      errno = why;
      fail_with_errno(path_);
    }
    line.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace sightline::app
