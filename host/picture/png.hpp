// PNG files, 8-bit grey and 8-bit RGB: the pictures the program writes, and the approved ones the tests read
// back.
//
// No time stamp, no host name: equal pictures give equal bytes. Text entries are tEXt chunks (Latin-1). Left
// out: everything the program never writes (palettes, alpha, 16 bits, interlacing); the reader says so.
// Source: PNG specification, second edition (ISO/IEC 15948), sections 5, 11.2.2, 11.3.4 and 11.3.5.3.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/picture/image.hpp"

namespace sightline::picture {

using TextEntries = std::vector<std::pair<std::string, std::string>>;  // keyword (1 to 79 bytes), text

// Largest width and height that is written or read.
inline constexpr int png_size_limit = 8192;

struct PngFile {
  Image image;
  TextEntries text;
};

// With `pixels_a_millimetre` the file says how large the image is on paper (chunk pHYs), rounded to pixels a metre.
[[nodiscard]] base::Result<base::Bytes> encode_png(const Image& image, const TextEntries& text = {}, double pixels_a_millimetre = 0);
[[nodiscard]] base::Result<base::Done> write_png(const std::string& path, const Image& image,
                                                 const TextEntries& text = {});

// `name` names the file in error messages.
[[nodiscard]] base::Result<PngFile> decode_png(const base::Bytes& bytes, const std::string& name);
[[nodiscard]] base::Result<PngFile> read_png(const std::string& path);

}  // namespace sightline::picture
