// Writes PNG with libpng. libpng reports errors by longjmp. Only run_encoder is between the setjmp and the calls that may
// jump, and it owns nothing that needs a destructor.
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <new>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/picture/png.hpp"

namespace sightline::picture {

namespace {

struct Encoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  base::Bytes bytes;
  bool out_of_memory = false;
  std::string message;

  Encoder() = default;
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void take_error(png_structp png, png_const_charp message) {
  static_cast<Encoder*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void take_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* encoder = static_cast<Encoder*>(png_get_io_ptr(png));
  // An exception must not pass through libpng's frames.
  try {
    encoder->bytes.insert(encoder->bytes.end(), data, data + size);
  } catch (const std::bad_alloc&) {
    encoder->out_of_memory = true;
  }
}

void flush_nothing(png_structp) {}

bool run_encoder(Encoder& encoder, const Image& image, png_textp entries, int entry_count, png_uint_32 pixels_per_metre) {
  if (setjmp(png_jmpbuf(encoder.png)) != 0) return false;
  png_set_write_fn(encoder.png, &encoder, take_bytes, flush_nothing);
  // Fixed, so that the bytes do not depend on libpng's heuristics; line drawings compress best without prediction.
  png_set_compression_level(encoder.png, 9);
  png_set_filter(encoder.png, PNG_FILTER_TYPE_BASE, image.channels == 1 ? PNG_FILTER_NONE : PNG_FILTER_SUB);
  png_set_IHDR(encoder.png, encoder.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8,
               image.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (pixels_per_metre > 0) png_set_pHYs(encoder.png, encoder.info, pixels_per_metre, pixels_per_metre, PNG_RESOLUTION_METER);
  if (entry_count > 0) png_set_text(encoder.png, encoder.info, entries, entry_count);
  png_write_info(encoder.png, encoder.info);
  for (int row = 0; row < image.height; ++row) {
    png_write_row(encoder.png, image.pixels.data() + image.index(0, row));
  }
  png_write_end(encoder.png, encoder.info);
  return !encoder.out_of_memory;
}

bool well_formed(const Image& image) {
  return image.width >= 1 && image.height >= 1 && image.width <= png_size_limit &&
         image.height <= png_size_limit && (image.channels == 1 || image.channels == 3) &&
         image.pixels.size() == image.index(0, image.height);
}

// Keywords are 1 to 79 printable characters; a zero byte would end the text early.
bool well_formed(const TextEntries& text) {
  return std::all_of(text.begin(), text.end(), [](const auto& entry) {
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    return !entry.first.empty() && entry.first.size() <= 79 && entry.first.front() != ' ' &&
           entry.first.back() != ' ' && std::all_of(entry.first.begin(), entry.first.end(), printable) &&
           entry.second.find('\0') == std::string::npos;
  });
}

}  // namespace

base::Result<base::Bytes> encode_png(const Image& image, const TextEntries& text, double pixels_per_millimetre) {
  if (!well_formed(image)) {
    return base::Error{"PNG", "",
                       std::to_string(image.width) + " by " + std::to_string(image.height) + " pixels of " +
                           std::to_string(image.channels) + " bytes in " +
                           std::to_string(image.pixels.size()) + " bytes",
                       "1 to " + std::to_string(png_size_limit) + " each way, 1 or 3 bytes a pixel"};
  }
  if (!well_formed(text)) {
    return base::Error{"PNG", "", "a text entry that cannot be written",
                       "keywords of 1 to 79 printable characters"};
  }
  std::vector<png_text> entries(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    entries[i].compression = PNG_TEXT_COMPRESSION_NONE;
    entries[i].key = const_cast<char*>(text[i].first.c_str());
    entries[i].text = const_cast<char*>(text[i].second.c_str());
    entries[i].text_length = text[i].second.size();
  }
  Encoder encoder;
  encoder.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, take_error, take_warning);
  if (encoder.png != nullptr) encoder.info = png_create_info_struct(encoder.png);
  if (encoder.info == nullptr ||
      !run_encoder(encoder, image, entries.data(), static_cast<int>(entries.size()),
                   static_cast<png_uint_32>(std::lround(1000 * pixels_per_millimetre)))) {
    return base::Error{"PNG", "", encoder.message.empty() ? "out of memory" : encoder.message, ""};
  }
  return std::move(encoder.bytes);
}

base::Result<base::Done> write_png(const std::string& path, const Image& image, const TextEntries& text) {
  const auto bytes = encode_png(image, text);
  if (!bytes) {
    base::Error error = bytes.error();
    error.file = path;
    return error;
  }
  return base::write_file_atomically(path, *bytes);
}

}  // namespace sightline::picture
