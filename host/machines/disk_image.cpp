// See disk_image.hpp.
#include "host/machines/disk_image.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>

namespace sightline::machines {

namespace {

constexpr std::size_t bytes_per_word = 4;
constexpr std::size_t bytes_of_disk = bytes_per_word * pdp7::rb09::words_of_disk;

}  // namespace

Result<std::vector<core::Word18>> read_disk_image(const Input& input) {
  if (input.bytes.size() != bytes_of_disk) {
    return base::bad_input(fmt::format("{}: found {} bytes, expected {}: an RB09 image is {} words of four bytes; `truncate -s {} FILE` "
                                 "makes an empty one",
                                 input.name, input.bytes.size(), bytes_of_disk, pdp7::rb09::words_of_disk, bytes_of_disk));
  }
  std::vector<core::Word18> words;
  words.reserve(pdp7::rb09::words_of_disk);
  for (std::size_t at = 0; at < bytes_of_disk; at += bytes_per_word) {
    std::uint32_t word = 0;
    for (std::size_t n = bytes_per_word; n-- > 0;) word = word << 8 | input.bytes[at + n];
    if (word > core::Word18::mask) {
      return base::bad_input(fmt::format("{}: byte {}: found {:o}, expected a word of 18 bits in four bytes, the lowest first",
                                   input.name, at, word));
    }
    words.emplace_back(word);
  }
  return words;
}

Bytes disk_image(const pdp7::Rb09& disk) {
  Bytes bytes;
  if (!disk.attached()) return bytes;
  bytes.reserve(bytes_of_disk);
  for (std::uint32_t address = 0; address < pdp7::rb09::words_of_disk; ++address) {
    const std::uint32_t word = disk.word(address).value();
    for (std::size_t n = 0; n < bytes_per_word; ++n) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * n)));
  }
  return bytes;
}

}  // namespace sightline::machines
