// Reads PNG. The chunks are walked here, so that an error can give its byte; libpng then verifies the checksums and
// unpacks, through its interface that returns errors instead of jumping.
#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/picture/png.hpp"

namespace sightline::picture {

namespace {

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t chunk_overhead = 12;  // length, type, check sum

std::uint32_t big_endian(const base::Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

base::Error at_byte(const std::string& name, std::size_t byte, std::string found, std::string expected) {
  return {name, "byte " + std::to_string(byte), std::move(found), std::move(expected)};
}

// `at` is the position of the chunk's data.
base::Result<base::Done> check_header(const base::Bytes& bytes, std::size_t at, std::uint32_t length,
                                      const std::string& name) {
  if (length != 13) return at_byte(name, at, "a header of " + std::to_string(length) + " bytes", "13");
  const std::uint32_t width = big_endian(bytes, at);
  const std::uint32_t height = big_endian(bytes, at + 4);
  constexpr auto limit = static_cast<std::uint32_t>(png_size_limit);
  if (width < 1 || height < 1 || width > limit || height > limit) {
    return at_byte(name, at, std::to_string(width) + " by " + std::to_string(height) + " pixels",
                   "1 to " + std::to_string(limit) + " each way");
  }
  const int depth = bytes[at + 8];
  const int colour = bytes[at + 9];
  if (depth != 8 || (colour != PNG_COLOR_TYPE_GRAY && colour != PNG_COLOR_TYPE_RGB) || bytes[at + 12] != 0) {
    return at_byte(name, at + 8,
                   std::to_string(depth) + " bits of colour type " + std::to_string(colour) +
                       (bytes[at + 12] != 0 ? ", interlaced" : ""),
                   "8-bit grey or RGB, not interlaced");
  }
  return base::Done{};
}

base::Result<TextEntries> walk_chunks(const base::Bytes& bytes, const std::string& name) {
  TextEntries text;
  std::size_t at = signature.size();
  for (bool first = true;; first = false) {
    if (bytes.size() - at < chunk_overhead) return at_byte(name, at, "the end of the file", "a chunk");
    const std::uint32_t length = big_endian(bytes, at);
    const std::size_t data = at + 8;
    if (length > bytes.size() - at - chunk_overhead) {
      return at_byte(name, at, "a chunk of " + std::to_string(length) + " bytes that extends beyond the end of the file",
                     "at most " + std::to_string(bytes.size() - at - chunk_overhead));
    }
    const std::string type(bytes.begin() + static_cast<std::ptrdiff_t>(at + 4),
                           bytes.begin() + static_cast<std::ptrdiff_t>(data));
    if (first != (type == "IHDR"))
      return at_byte(name, at + 4, first ? "no IHDR" : "a second IHDR", "exactly one, as the first chunk");
    if (first) {
      if (const auto header = check_header(bytes, data, length, name); !header) return header.error();
    }
    if (type == "tEXt") {
      const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(data);
      const auto end = begin + static_cast<std::ptrdiff_t>(length);
      const auto zero = std::find(begin, end, std::uint8_t{0});
      if (zero == end) return at_byte(name, data, "a text entry without a zero byte", "keyword, zero, text");
      text.emplace_back(std::string(begin, zero), std::string(zero + 1, end));
    }
    at = data + length + 4;
    if (type == "IEND") break;
  }
  if (at != bytes.size()) {
    return at_byte(name, at, std::to_string(bytes.size() - at) + " bytes after the last chunk",
                   "the end of the file");
  }
  return text;
}

}  // namespace

base::Result<PngFile> decode_png(const base::Bytes& bytes, const std::string& name) {
  if (bytes.size() < signature.size() || !std::equal(signature.begin(), signature.end(), bytes.begin())) {
    return at_byte(name, 0, "no PNG signature", "a PNG file");
  }
  auto text = walk_chunks(bytes, name);
  if (!text) return text.error();

  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&reader, bytes.data(), bytes.size()) == 0) {
    return base::Error{name, "", reader.message, ""};
  }
  const bool colour = (reader.format & PNG_FORMAT_FLAG_COLOR) != 0;
  reader.format = colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  PngFile file{Image(static_cast<int>(reader.width), static_cast<int>(reader.height), colour ? 3 : 1),
               std::move(*text)};
  const png_color black{0, 0, 0};
  const int read = png_image_finish_read(&reader, &black, file.image.pixels.data(), 0, nullptr);
  const bool complained = PNG_IMAGE_FAILED(reader) || reader.warning_or_error != 0;
  png_image_free(&reader);
  if (read == 0 || complained) return base::Error{name, "", reader.message, ""};
  return file;
}

base::Result<PngFile> read_png(const std::string& path) {
  const auto bytes = base::read_file(path);
  if (!bytes) return bytes.error();
  return decode_png(*bytes, path);
}

}  // namespace sightline::picture
