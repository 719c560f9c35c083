#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "tools/image/tape.hpp"
#include "tools/image/tape_words.hpp"

namespace sightline::image {

base::Result<CoreImage> read_hri(std::span<const std::uint8_t> tape, std::string_view file,
                                 std::uint32_t address, std::vector<std::string>* warnings) {
  constexpr std::string_view word_or_end = "a word, the last with hole 7 in its third line";
  TapeReader reader(tape, file);
  CoreImage image;
  for (std::uint32_t next = address;; ++next) {
    const auto read = reader.next(word_or_end);
    if (!read) return read.error();
    if (!read.value()) return reader.error(tape.size(), "the end of the tape", std::string(word_or_end));
    const TapeWord word = *read.value();
    if (word.early && !reader.at_end_of_block()) return reader.early_error(word, word_or_end);
    if (word.early && warnings != nullptr) warnings->push_back(reader.early_warning(word));
    if (word.last || word.early) {
      if (word.value == hlt) return image;
      if ((word.value & opcode_mask) != jmp) {
        return reader.error(word.byte, "last word " + base::octal(word.value, 6), "JMP start or HLT");
      }
      const std::uint32_t bank = next == address ? address & bank_mask : (next - 1) & bank_mask;
      image.start = bank | (word.value & field_mask);
      return image;
    }
    if (next > last_address)
      return reader.error(word.byte, "a word after address 77777", "the last word, with hole 7");
    image.words.insert_or_assign(next, core::Word18(word.value));
  }
}

base::Result<Tape> write_hri(const CoreImage& image, std::string_view file) {
  if (image.words.empty())
    return base::Error{std::string(file), "", "an image without words", "at least one for an HRI tape"};
  const std::uint32_t first = image.words.begin()->first;
  const std::uint32_t last = image.words.rbegin()->first;
  if (image.start && (*image.start & ~field_mask) != (last & bank_mask)) {
    return base::Error{std::string(file), "", "start address " + base::octal(*image.start, 5),
                       "one in the bank of the last word, " + base::octal(last, 5) + ", on an HRI tape"};
  }
  Tape tape;
  punch_feed(tape);
  std::uint32_t next = first;
  for (const auto& [address, word] : image.words) {
    for (; next < address; ++next) punch_word(tape, 0);
    punch_word(tape, word.value());
    next = address + 1;
  }
  const std::uint32_t end = image.start ? jmp | (*image.start & field_mask) : hlt;
  punch_word(tape, end, true);
  punch_feed(tape);
  return tape;
}

}  // namespace sightline::image
