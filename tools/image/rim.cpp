#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "tools/image/tape.hpp"
#include "tools/image/tape_words.hpp"

namespace sightline::image {
namespace {

constexpr std::uint32_t loader_first = 017762;
constexpr std::uint32_t loader_last = 017776;
constexpr std::string_view pair_or_end = "DAC address, JMP start or HLT";

}  // namespace

base::Result<CoreImage> read_rim(std::span<const std::uint8_t> tape, std::string_view file,
                                 std::vector<std::string>* warnings) {
  TapeReader reader(tape, file);
  CoreImage image;
  for (;;) {
    const auto order = reader.next(pair_or_end);
    if (!order) return order.error();
    if (!order.value()) return reader.error(tape.size(), "the end of the tape", std::string(pair_or_end));
    const TapeWord word = *order.value();
    if (word.last)
      return reader.error(word.byte, "word " + base::octal(word.value, 6) + " with hole 7",
                          "a RIM tape without hole 7");
    const bool ends = (word.value & opcode_mask) == jmp || word.value == hlt;
    if (word.early && !ends) return reader.early_error(word, pair_or_end);
    if (word.early && warnings != nullptr) warnings->push_back(reader.early_warning(word));
    if ((word.value & opcode_mask) == jmp) {
      image.start = word.value & field_mask;
      return image;
    }
    if (word.value == hlt) return image;
    if ((word.value & opcode_mask) != dac) {
      return reader.error(word.byte, "word " + base::octal(word.value, 6), std::string(pair_or_end));
    }
    const std::string expected = "the data word for address " + base::octal(word.value & field_mask, 5);
    const auto data = reader.next(expected);
    if (!data) return data.error();
    if (!data.value()) return reader.error(tape.size(), "the end of the tape", expected);
    if (data.value()->early) return reader.early_error(*data.value(), expected);
    if (data.value()->last)
      return reader.error(data.value()->byte, "a word with hole 7", expected + " without hole 7");
    image.words.insert_or_assign(word.value & field_mask, core::Word18(data.value()->value));
  }
}

base::Result<Tape> write_rim(const CoreImage& image, std::string_view file) {
  const auto refuse = [&](std::string found, std::string expected) {
    return base::Error{std::string(file), "", std::move(found), std::move(expected)};
  };
  if (image.start && *image.start > field_mask) {
    return refuse("start address " + base::octal(*image.start, 5), "at most 17777 on a RIM tape");
  }
  Tape tape;
  punch_feed(tape);
  for (const auto& [address, word] : image.words) {
    if (address > field_mask)
      return refuse("a word at " + base::octal(address, 5), "at most 17777 on a RIM tape");
    if (address >= loader_first && address <= loader_last) {
      return refuse("a word at " + base::octal(address, 5), "none where the RIM loader runs (17762-17776)");
    }
    punch_word(tape, dac | address);
    punch_word(tape, word.value());
  }
  const std::uint32_t end = image.start ? jmp | *image.start : hlt;
  punch_word(tape, end);
  punch_word(tape, 0);  // read by the loader while it executes the last word
  punch_feed(tape);
  return tape;
}

}  // namespace sightline::image
