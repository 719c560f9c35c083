// Paper tapes in DEC's binary form: three lines per word, each with hole 8 punched and six data bits, high bits
// first. The reader skips lines without hole 8 between words (leader, trailer, feed). Two formats use this form.
//
// RIM (read-in mode): pairs DAC address, data, then JMP start or HLT (P4-65). The loader sits in 17762-17776
// and is started at 17770; it starts the reader again before it executes the last word, so one more word is
// punched after it. Only bank 0 can be addressed, and words 17762-17776 would overwrite the loader while it
// runs.
//
// HRI (hardware read-in, the READ IN key): words for successive addresses from the ADDRESS switches upward;
// hole 7 in the third line of a word marks the last one, which is not stored but executed: JMP start, or HLT.
//
// Hole 7 in an earlier line of the last word is read with a warning: some punches were one line ahead. In any other word
// it is an error. A RIM tape needs no hole 7, and must not have it in a third line.
//
// Not supported: the FF ("funny") format of DEC's one-pass assembler, whose loader resolves symbols.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::image {

using Tape = std::vector<std::uint8_t>;  // one byte per line, hole 1 = bit 0, hole 8 = 0200

// Warnings ("FILE: byte N: ..., expected ...") are appended to `warnings`, unless it is null.
[[nodiscard]] base::Result<CoreImage> read_rim(std::span<const std::uint8_t> tape, std::string_view file,
                                               std::vector<std::string>* warnings = nullptr);
[[nodiscard]] base::Result<CoreImage> read_hri(std::span<const std::uint8_t> tape, std::string_view file,
                                               std::uint32_t address, std::vector<std::string>* warnings = nullptr);

// Fails on words above 17777, on words that would overwrite the RIM loader, and on a start address above
// 17777. An image without a start address ends with HLT.
[[nodiscard]] base::Result<Tape> write_rim(const CoreImage& image, std::string_view file);
// The tape has no addresses: it must be read in at the image's first address. Gaps are punched as zero words.
// Fails on an image without words and on a start address in another bank than the last word.
[[nodiscard]] base::Result<Tape> write_hri(const CoreImage& image, std::string_view file);

enum class Format { octal, rim, hri };

// Determines the format from the content alone: text of printing characters is octal. A tape whose first block ends with
// a word with hole 7 is HRI, unless that hole is early and the tape can be read as RIM. A tape that begins with a DAC is
// RIM.
[[nodiscard]] base::Result<Format> recognise(std::span<const std::uint8_t> bytes, std::string_view file);

// Recognises the format and reads the file. An HRI tape needs the address; a RIM tape contains its own and must not get one.
[[nodiscard]] base::Result<CoreImage> read_image(std::span<const std::uint8_t> bytes, std::string_view file,
                                                 std::optional<std::uint32_t> address,
                                                 std::vector<std::string>* warnings = nullptr);

}  // namespace sightline::image
