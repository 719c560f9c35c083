// See file_io.hpp.
#include "host/picture/file_io.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace sightline::picture {

namespace {

FileError system_error(const std::string& path, const char* doing, int code) {
  return {path, "", std::string(doing) + ": " + std::generic_category().message(code), ""};
}

// Where a symbolic link leads, so that the link itself is kept.
std::string follow_links(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_symlink(path, failed)) return path;
  const auto target = std::filesystem::weakly_canonical(path, failed);
  return failed ? path : target.string();
}

constexpr int most_partial_files = 100;

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
  std::string target = follow_links(path);
  std::error_code failed;
  const auto status = std::filesystem::status(target, failed);
  if (std::filesystem::is_directory(status)) return system_error(path, "cannot write", EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    std::FILE* file = std::fopen(target.c_str(), "wb");
    if (file == nullptr) return system_error(path, "cannot write", errno);
    return AtomicFile(path, std::move(target), std::string(), file);
  }
  for (int attempt = 0; attempt < most_partial_files; ++attempt) {
    std::string partial = target + ".partial" + (attempt == 0 ? std::string() : std::to_string(attempt));
    if (std::FILE* file = std::fopen(partial.c_str(), "wbx"); file != nullptr) {
      return AtomicFile(path, std::move(target), std::move(partial), file);
    }
    if (errno != EEXIST) return system_error(path, "cannot write", errno);
  }
  return FileError{path, "", "cannot write: too many left-over files " + target + ".partial*", "none"};
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

Result<Bytes> read_file(const std::string& path, std::size_t limit) {
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) return system_error(path, "cannot read", EISDIR);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) return system_error(path, "cannot read", errno);
  Bytes bytes;
  std::array<std::uint8_t, 65536> block{};
  while (true) {
    errno = 0;
    const std::size_t n = std::fread(block.data(), 1, block.size(), file.get());
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(n));
    if (bytes.size() > limit) {
      return FileError{path, "", "more than " + std::to_string(limit) + " bytes", "a smaller file"};
    }
    if (n == block.size()) continue;
    if (std::ferror(file.get()) != 0) return system_error(path, "cannot read", errno != 0 ? errno : EIO);
    return bytes;
  }
}

}  // namespace sightline::picture
