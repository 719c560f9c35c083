// Reads whole files, and writes files atomically: completely or not at all.
//
// An AtomicFile writes beside its target and renames to the target only in commit(). If it is destroyed before, what it
// wrote is removed and an existing target stays unchanged. A file that is replaced keeps its permissions; a read-only file
// is not replaced. A target that exists and is no regular file (a pipe, /dev/null) is written directly.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::base {

using Bytes = std::vector<std::uint8_t>;

class AtomicFile {
 public:
  [[nodiscard]] static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  // The first failure is kept and reported by commit().
  void write(std::string_view text);
  void write(std::span<const std::uint8_t> bytes);
  // Closes the file and renames it to the target. Called once.
  [[nodiscard]] Result<Done> commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
  };
  AtomicFile(std::string path, std::string target, std::string partial, std::FILE* file);

  std::string path_;     // as the user named it
  std::string target_;   // path_ with symbolic links followed
  std::string partial_;  // empty: the target is written directly
  std::unique_ptr<std::FILE, Close> file_;
  int failure_ = 0;  // errno of the first failure
};

[[nodiscard]] Result<Done> write_file_atomically(const std::string& path,
                                                 std::span<const std::uint8_t> bytes);
[[nodiscard]] Result<Done> write_file_atomically(const std::string& path, std::string_view text);

// What exists at a path.
struct FileStatus {
  enum class Kind : std::uint8_t { none, file, other };  // other: a directory, a device
  Kind kind = Kind::none;
  std::uint64_t size = 0;  // bytes, of a file
  std::string error = {};  // why the status cannot be read; empty: it was read
};
[[nodiscard]] FileStatus file_status(const std::string& path);

// The whole file; an error for a directory, and for more than `limit` bytes.
[[nodiscard]] Result<Bytes> read_file(const std::string& path, std::size_t limit = std::size_t{1} << 30);
[[nodiscard]] Result<std::string> read_text(const std::string& path, std::size_t limit = std::size_t{1} << 30);

}  // namespace sightline::base
