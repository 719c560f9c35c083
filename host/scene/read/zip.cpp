// See zip.hpp.
#include "host/scene/read/zip.hpp"

#include <zlib.h>

#include <algorithm>

namespace sightline::scene {
namespace {

constexpr std::size_t zip_end_bytes = 22;
constexpr std::size_t zip_listing_bytes = 46;
constexpr std::size_t zip_header_bytes = 30;
constexpr std::string_view zip_end_mark = "PK\5\6";
constexpr std::string_view zip_listing_mark = "PK\1\2";
constexpr std::string_view zip_header_mark = "PK\3\4";

std::uint32_t zip_number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count; ++i) number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return number;
}

base::Error zip_error(std::size_t byte, std::string found, std::string expected) {
  return {"", "byte " + std::to_string(byte), std::move(found), std::move(expected), "the file is damaged: export it again"};
}

}  // namespace

base::Result<std::vector<ZipEntry>> zip_entries(std::string_view archive) {
  constexpr std::size_t longest_comment = 65'535;
  const std::size_t tail = archive.size() - std::min(archive.size(), zip_end_bytes + longest_comment);
  const std::size_t end = archive.rfind(zip_end_mark);
  if (end == std::string_view::npos || end < tail || archive.size() - end < zip_end_bytes)
    return zip_error(archive.size(), "found the end of the file", "the directory of a ZIP archive before it");
  const std::size_t count = zip_number(archive, end + 10, 2);
  std::size_t at = zip_number(archive, end + 16, 4);
  // Values too large for these fields are in a directory of ZIP64 (PKWARE, APPNOTE.TXT 4.4.1.4).
  if (count == 0xffff || at == 0xffffffff)
    return base::Error{"", "byte " + std::to_string(end), "found a ZIP64 archive", "a ZIP archive without its extensions",
                       "save it again, or export it as OBJ, STL or PLY"};
  std::vector<ZipEntry> entries;
  for (std::size_t i = 0; i < count; ++i) {
    if (at > end || end - at < zip_listing_bytes || archive.substr(at, 4) != zip_listing_mark)
      return zip_error(std::min(at, archive.size()), "found no entry of the ZIP directory",
                       "entry " + std::to_string(i + 1) + " of " + std::to_string(count));
    const std::size_t name = zip_number(archive, at + 28, 2);
    const std::size_t length = zip_listing_bytes + name + zip_number(archive, at + 30, 2) + zip_number(archive, at + 32, 2);
    if (length > end - at)
      return zip_error(at, "found an entry that is longer than the ZIP directory",
                       "at most " + std::to_string(end - at) + " bytes");
    ZipEntry entry{std::string(archive.substr(at + zip_listing_bytes, name)), false, zip_number(archive, at + 20, 4),
                   zip_number(archive, at + 24, 4), 0};
    const std::uint32_t method = zip_number(archive, at + 10, 2);
    constexpr std::uint32_t deflate = 8;
    if (method != 0 && method != deflate)
      return zip_error(at + 10, "found compression method " + std::to_string(method), "0 (stored) or 8 (deflated)");
    entry.deflated = method == deflate;
    const std::size_t header = zip_number(archive, at + 42, 4);
    if (header > end || end - header < zip_header_bytes || archive.substr(header, 4) != zip_header_mark)
      return zip_error(std::min(header, archive.size()), "found no file", "the one that the ZIP directory has here");
    entry.begins = header + zip_header_bytes + zip_number(archive, header + 26, 2) + zip_number(archive, header + 28, 2);
    if (entry.begins > end || entry.packed > end - entry.begins)
      return zip_error(header, "found a file of " + std::to_string(entry.packed) + " bytes",
                       "one that ends before the ZIP directory");
    entries.push_back(std::move(entry));
    at += length;
  }
  return entries;
}

std::string zip_beginning(std::string_view archive, const ZipEntry& entry, std::size_t most) {
  const std::string_view packed = archive.substr(entry.begins, entry.packed);
  if (!entry.deflated) return std::string(packed.substr(0, most));
  std::string text(std::min<std::size_t>(most, entry.unpacked), '\0');
  z_stream stream{};
  if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  // zlib does not write there.
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  static_cast<void>(::inflate(&stream, Z_SYNC_FLUSH));
  text.resize(text.size() - stream.avail_out);
  ::inflateEnd(&stream);
  return text;
}

}  // namespace sightline::scene
