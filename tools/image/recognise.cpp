#include <algorithm>
#include <string>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "tools/image/octal.hpp"
#include "tools/image/tape.hpp"
#include "tools/image/tape_words.hpp"

namespace sightline::image {
namespace {

bool printing(std::uint8_t byte) {
  return (byte >= ' ' && byte < 0177) || (byte >= '\t' && byte <= '\r');
}

enum class End { none, proper, early };

// Whether the first word with hole 7 is also the last of its block, and whether the hole is in its third line.
End hole7_ends_a_block(std::span<const std::uint8_t> tape) {
  std::size_t line_of_word = 0;
  bool early = false;
  for (std::size_t i = 0; i < tape.size(); ++i) {
    if ((tape[i] & hole8) == 0) {
      line_of_word = 0;
      continue;
    }
    const bool hole = (tape[i] & hole7) != 0;
    if (line_of_word == 2 && (hole || early)) {
      if (i + 1 < tape.size() && (tape[i + 1] & hole8) != 0) return End::none;
      return hole ? End::proper : End::early;
    }
    early = early || hole;
    line_of_word = (line_of_word + 1) % 3;
  }
  return End::none;
}

}  // namespace

base::Result<Format> recognise(std::span<const std::uint8_t> bytes, std::string_view file) {
  constexpr std::string_view any = "an octal core image, a RIM tape or an HRI tape";
  if (bytes.empty()) return base::Error{std::string(file), "", "an empty file", std::string(any)};
  if (std::all_of(bytes.begin(), bytes.end(), printing)) return Format::octal;
  const End end = hole7_ends_a_block(bytes);
  if (end == End::proper || (end == End::early && !read_rim(bytes, file))) return Format::hri;
  TapeReader reader(bytes, file);
  const auto first = reader.next(any);
  if (!first) return first.error();
  if (!first.value()) return base::Error{std::string(file), "", "no line with hole 8", std::string(any)};
  const TapeWord word = *first.value();
  if (!word.last &&
      ((word.value & opcode_mask) == dac || (word.value & opcode_mask) == jmp || word.value == hlt)) {
    return Format::rim;
  }
  return reader.error(word.byte, "word " + base::octal(word.value, 6) + " and no hole 7 that ends a block",
                      "DAC address (RIM tape) or hole 7 in the last word (HRI tape)");
}

base::Result<CoreImage> read_image(std::span<const std::uint8_t> bytes, std::string_view file,
                                   std::optional<std::uint32_t> address, std::vector<std::string>* warnings) {
  const auto format = recognise(bytes, file);
  if (!format) return format.error();
  switch (format.value()) {
    case Format::octal: return read_octal(std::string(bytes.begin(), bytes.end()), file, address.value_or(0));
    case Format::rim:
      if (address)
        return base::Error{std::string(file), "", "an address for a RIM tape", "none: the tape has its own"};
      return read_rim(bytes, file, warnings);
    case Format::hri: break;
  }
  if (!address)
    return base::Error{std::string(file), "", "an HRI tape without an address",
                       "the address at which to read it in"};
  return read_hri(bytes, file, *address, warnings);
}

}  // namespace sightline::image
