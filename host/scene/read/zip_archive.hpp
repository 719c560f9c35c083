// The files in a ZIP archive, read by libzip: ZIP64, stored and compressed files.
//
// Left out: archives of several volumes, encrypted files.
// Source: PKWARE, APPNOTE.TXT - .ZIP File Format Specification, version 6.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

struct zip;

namespace sightline::scene {

class ZipArchive {
 public:
  // `bytes` have to live as long as the archive. Errors name a byte, but no file.
  [[nodiscard]] static base::Result<ZipArchive> open(std::string_view bytes);

  // In the order of the archive's directory.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  // The contents of names()[entry]. Errors have the name as their place: a file that is damaged, larger than `most` bytes, or
  // compressed to less than 1/200 although it has more than a megabyte.
  [[nodiscard]] base::Result<std::string> read(std::size_t entry, std::uint64_t most) const;

 private:
  struct Close {
    void operator()(zip* archive) const;
  };
  ZipArchive(zip* archive, std::uint64_t bytes);

  std::unique_ptr<zip, Close> archive_;
  std::uint64_t bytes_;
  std::vector<std::string> names_;
};

}  // namespace sightline::scene
