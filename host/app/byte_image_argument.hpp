// The FILE[@ADDRESS] argument of the 8080: a .com, raw or Intel HEX file, and where it goes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tools/image/binary.hpp"

namespace sightline::app {

enum class ByteFormat { com, bin, hex };

// "com", "bin" or "hex".
[[nodiscard]] ByteFormat byte_format_named(std::string_view name);
// By the ending of a file's name, in either case: .com .bin .hex; nothing for another ending.
[[nodiscard]] std::optional<ByteFormat> byte_format_of_name(std::string_view path);

// Without 0x before or H behind, in either case.
[[nodiscard]] std::string_view without_hexadecimal_mark(std::string_view text);

struct ByteImageArgument {
  std::string path;
  std::optional<std::uint16_t> address;
};

// Splits at the last @ if only hexadecimal digits follow it, with or without an H behind or 0x before them.
// Failure usage if these are no address.
[[nodiscard]] ByteImageArgument byte_image_argument(const std::string& option, const std::string& text);

// Without a format the ending decides, and for another ending the content: a text that begins as a record of
// Intel HEX does, `:` and the ten digits of the shortest one, is HEX, all else raw. `raw` says what raw bytes
// are then taken for: .com instead of .bin. The file is read once, so it may be a pipe. Raw bytes go to the
// address, 0 if none was given; a .com file to 0100 and a HEX file where it says: these two refuse an
// address. Failure io or bad_input.
[[nodiscard]] image::ByteImage load_byte_image(const ByteImageArgument& argument,
                                               std::optional<ByteFormat> format = std::nullopt,
                                               ByteFormat raw = ByteFormat::bin);

}  // namespace sightline::app
