// Intel HEX, the text format of 8080 programs (Intel, "Hexadecimal Object File Format",
// 1988).
//
//   :LLAAAATT<data>CC   LL data bytes at address AAAA, type TT, CC the two's complement of the sum of all
//   other bytes
//
// Type 00 is data, 01 the end, whose address is the start address (0000: none given, as the old writers had
// it). Types 02 to 05 (segments and 32-bit addresses) are taken as far as they stay within 64K and refused
// beyond. CP/M's old end, a data record of length 0, is taken too.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "tools/image/binary.hpp"

namespace sightline::image {

// Every record is checked: colon, hexadecimal digits, length, checksum, type, one value an address. After the
// end record only blank lines and Control-Z (CP/M's end of text) may follow; without one the file is taken
// for cut off.
[[nodiscard]] base::Result<ByteImage> read_intel_hex(std::string_view text, std::string_view file);

// Records of up to 16 bytes, each run from its own address, then the end record with the start address.
[[nodiscard]] std::string write_intel_hex(const ByteImage& image);

}  // namespace sightline::image
