#include "host/base/file.hpp"

#include <algorithm>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace sightline::base {

namespace {

Error system_error(const std::string& path, const char* doing, int code) {
  return {.file = path, .found = std::string(doing) + ": " + std::generic_category().message(code), .kind = ErrorKind::io};
}

// The target of a symbolic link: the target is replaced, the link itself is kept.
std::string follow_links(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_symlink(path, failed)) return path;
  // If /dev/stdout is a pipe, the canonical path does not exist.
  const auto target = std::filesystem::weakly_canonical(path, failed);
  return failed || !std::filesystem::exists(target, failed) ? path : target.string();
}

constexpr int most_partial_files = 100;

std::string partial_name(const std::string& target, int attempt) {
  return target + ".partial" + (attempt == 0 ? std::string() : std::to_string(attempt));
}

// The path by which an open file without a name can be linked.
std::string name_of_open(int file) {
  return "/proc/self/fd/" + std::to_string(file);
}

// A file without a name in the folder of `target`: if the process is killed, nothing remains of it. Null if the file system
// has no such files or they cannot be linked later; the caller then writes target.partial.
std::FILE* open_nameless(const std::string& target) {
  const std::string folder = std::filesystem::path(target).parent_path().string();
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0) return nullptr;
  std::FILE* const stream = ::access(name_of_open(file).c_str(), F_OK) == 0 ? ::fdopen(file, "wb") : nullptr;
  if (stream == nullptr) ::close(file);
  return stream;
}

// Gives `file` the permissions of the file that it will replace and, where the system allows it, its owner.
void keep_permissions(int file, const std::string& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) != 0) return;
  if (::fchown(file, old.st_uid, old.st_gid) != 0) errno = 0;
  if (::fchmod(file, old.st_mode & 07777) != 0) errno = 0;
}

bool is_nameless(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 0;
}

// Links a file without a name beside `target` and returns that name; empty, with errno set, if it cannot be linked.
std::string link_partial(int file, const std::string& target) {
  for (int attempt = 0; attempt < most_partial_files; ++attempt) {
    std::string partial = partial_name(target, attempt);
    if (::linkat(AT_FDCWD, name_of_open(file).c_str(), AT_FDCWD, partial.c_str(), AT_SYMLINK_FOLLOW) == 0)
      return partial;
    if (errno != EEXIST) break;
  }
  return {};
}

// Reads the whole file into a buffer of the size that the file system reports; the buffer grows if the file is longer.
template <class Container>
Result<Container> read_whole(const std::string& path, std::size_t limit) {
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) return system_error(path, "cannot read", EISDIR);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) return system_error(path, "cannot read", errno);
  constexpr std::size_t block = 65536;
  const std::uintmax_t size = std::filesystem::is_regular_file(path, failed) ? std::filesystem::file_size(path, failed) : 0;
  Container bytes;
  std::size_t used = 0;
  while (true) {
    if (bytes.size() - used < block)
      bytes.resize(std::max(used + used / 2, used == 0 && !failed && size <= limit ? static_cast<std::size_t>(size) : 0) + block);
    errno = 0;
    const std::size_t room = bytes.size() - used;
    const std::size_t n = std::fread(bytes.data() + used, 1, room, file.get());
    used += n;
    if (used > limit) {
      return Error{.file = path, .found = "more than " + std::to_string(limit) + " bytes", .expected = "a smaller file", .kind = ErrorKind::io};
    }
    if (n == room) continue;
    if (std::ferror(file.get()) != 0) return system_error(path, "cannot read", errno != 0 ? errno : EIO);
    bytes.resize(used);
    return bytes;
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string path, std::string target, std::string partial, std::FILE* file)
    : path_(std::move(path)), target_(std::move(target)), partial_(std::move(partial)), file_(file) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      partial_(std::exchange(other.partial_, std::string())),
      file_(std::move(other.file_)),
      failure_(other.failure_) {}

AtomicFile::~AtomicFile() {
  file_.reset();
  if (!partial_.empty()) static_cast<void>(std::remove(partial_.c_str()));
}

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  std::error_code failed;
  if (std::filesystem::is_symlink(path, failed) && !std::filesystem::exists(path, failed))
    return Error{.file = path,
                 .found = "cannot write: found a symbolic link to " + std::filesystem::read_symlink(path, failed).string() +
                          ", where there is no file",
                 .expected = "a link to a file",
                 .remedy = "remove the link, or make the file first",
                 .kind = ErrorKind::io};
  std::string target = follow_links(path);
  const auto status = std::filesystem::status(target, failed);
  if (failed == std::errc::filename_too_long) return system_error(path, "cannot write", ENAMETOOLONG);
  if (std::filesystem::is_directory(status)) return system_error(path, "cannot write", EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    std::FILE* file = std::fopen(target.c_str(), "wb");
    if (file == nullptr) return system_error(path, "cannot write", errno);
    return AtomicFile(path, std::move(target), std::string(), file);
  }
  // Renaming would replace a file that its owner has made read-only.
  if (std::filesystem::exists(status) && ::access(target.c_str(), W_OK) != 0) return system_error(path, "cannot write", errno);
  if (std::FILE* const file = open_nameless(target); file != nullptr) {
    keep_permissions(::fileno(file), target);
    return AtomicFile(path, std::move(target), std::string(), file);
  }
  for (int attempt = 0; attempt < most_partial_files; ++attempt) {
    std::string partial = partial_name(target, attempt);
    if (std::FILE* file = std::fopen(partial.c_str(), "wbx"); file != nullptr) {
      keep_permissions(::fileno(file), target);
      return AtomicFile(path, std::move(target), std::move(partial), file);
    }
    if (errno != EEXIST) return system_error(path, "cannot write", errno);
  }
  return Error{.file = path,
               .found = "cannot write: too many left-over files " + target + ".partial*",
               .expected = "none",
               .kind = ErrorKind::io};
}

void AtomicFile::write(std::string_view text) {
  if (file_ == nullptr || failure_ != 0 || text.empty()) return;
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size())
    failure_ = errno != 0 ? errno : EIO;
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
  if (file_ == nullptr || failure_ != 0 || bytes.empty()) return;
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
    failure_ = errno != 0 ? errno : EIO;
}

Result<Done> AtomicFile::commit() {
  if (file_ == nullptr) return system_error(path_, "cannot write", EBADF);
  errno = 0;
  if (std::fflush(file_.get()) != 0 && failure_ == 0) failure_ = errno != 0 ? errno : EIO;
  if (failure_ == 0 && partial_.empty() && is_nameless(::fileno(file_.get()))) {
    partial_ = link_partial(::fileno(file_.get()), target_);
    if (partial_.empty()) failure_ = errno;
  }
  errno = 0;
  if (std::fclose(file_.release()) != 0 && failure_ == 0) failure_ = errno != 0 ? errno : EIO;
  if (failure_ != 0) return system_error(path_, "cannot write", failure_);
  if (partial_.empty()) return Done{};
  if (std::rename(partial_.c_str(), target_.c_str()) != 0) return system_error(path_, "cannot write", errno);
  partial_.clear();
  return Done{};
}

Result<Done> write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  auto file = AtomicFile::create(path);
  if (!file) return file.error();
  file->write(bytes);
  return file->commit();
}

Result<Done> write_file_atomically(const std::string& path, std::string_view text) {
  auto file = AtomicFile::create(path);
  if (!file) return file.error();
  file->write(text);
  return file->commit();
}

FileStatus file_status(const std::string& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (!std::filesystem::exists(status)) return {};
  if (!std::filesystem::is_regular_file(status)) return {FileStatus::Kind::other};
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) return {FileStatus::Kind::file, 0, failed.message()};
  return {FileStatus::Kind::file, size};
}

Result<Bytes> read_file(const std::string& path, std::size_t limit) { return read_whole<Bytes>(path, limit); }

Result<std::string> read_text(const std::string& path, std::size_t limit) { return read_whole<std::string>(path, limit); }

}  // namespace sightline::base
