// The files in a ZIP archive, as far as looking at a 3MF file needs: their names and sizes, and how one begins.
//
// Left out: archives beyond 4 GB (ZIP64) or of several parts, encrypted files, methods other than stored and deflated.
// Source: PKWARE, APPNOTE.TXT - .ZIP File Format Specification, version 6.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {

struct ZipEntry {
  std::string name;
  bool deflated = false;  // or stored
  std::uint32_t packed = 0;    // bytes
  std::uint32_t unpacked = 0;  // as the directory says
  std::size_t begins = 0;      // byte in the archive
};

// What the directory at the end lists, in its order. Errors name a byte, but no file.
[[nodiscard]] base::Result<std::vector<ZipEntry>> zip_entries(std::string_view archive);

// The first `most` bytes of a file, fewer if it is shorter or damaged. The entry is one of this archive (precondition).
[[nodiscard]] std::string zip_beginning(std::string_view archive, const ZipEntry& entry, std::size_t most);

}  // namespace sightline::scene
