// Reads and writes PNG files, 8-bit grey and 8-bit RGB: the pictures that the program writes, and the approved ones that
// the tests read.
//
// There is no time stamp and no host name: equal pictures give equal bytes. Text entries are tEXt chunks (Latin-1). Not
// supported: what the program never writes (palettes, alpha, 16 bits, interlacing); the reader reports it as an error.
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

// Greatest width and height that can be written or read.
inline constexpr int png_size_limit = 8192;

struct PngFile {
  Image image;
  TextEntries text;
};

// `pixels_per_millimetre`, if given, is stored as the image's size on paper (chunk pHYs), rounded to pixels per metre.
[[nodiscard]] base::Result<base::Bytes> encode_png(const Image& image, const TextEntries& text = {}, double pixels_per_millimetre = 0);
[[nodiscard]] base::Result<base::Done> write_png(const std::string& path, const Image& image,
                                                 const TextEntries& text = {});

// `name` is the name of the file in errors.
[[nodiscard]] base::Result<PngFile> decode_png(const base::Bytes& bytes, const std::string& name);
[[nodiscard]] base::Result<PngFile> read_png(const std::string& path);

}  // namespace sightline::picture
