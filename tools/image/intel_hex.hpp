// Intel HEX, the text format of 8080 programs (Intel, "Hexadecimal Object File Format",
// 1988).
//
//   :LLAAAATT<data>CC   LL data bytes at address AAAA, type TT, CC the two's complement of the sum of all
//   other bytes
//
// Type 00 is data. Type 01 is the end; its address is the start address (old writers use 0000 for none). Types 02 to 05
// (segments and 32-bit addresses) are accepted within 64K and are errors beyond. CP/M's old end record, a data record of
// length 0, is accepted, too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "tools/image/binary.hpp"

namespace sightline::image {

// Checks every record: colon, hexadecimal digits, length, checksum, type. Only blank lines and Control-Z (CP/M's end of
// text) may follow the end record. A file without an end record is an error, as it is probably truncated. Records are stored
// in their order, as a loader stores them: of two bytes for one address the later counts, and `warnings`, if not null, gets
// a line about the first such address.
[[nodiscard]] base::Result<ByteImage> read_intel_hex(std::string_view text, std::string_view file,
                                                     std::vector<std::string>* warnings = nullptr);

// Records of up to 16 bytes, a new one at the start of each run, then the end record with the start address.
[[nodiscard]] std::string write_intel_hex(const ByteImage& image);

}  // namespace sightline::image
