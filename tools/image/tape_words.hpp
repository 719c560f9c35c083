// The binary layer under RIM and HRI: lines to words and back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "tools/image/tape.hpp"

namespace sightline::image {

inline constexpr std::uint8_t hole8 = 0200;
inline constexpr std::uint8_t hole7 = 0100;
inline constexpr std::uint8_t data_holes = 077;

inline constexpr std::uint32_t opcode_mask = 0760000;  // opcode and indirect bit
inline constexpr std::uint32_t dac = 0040000;
inline constexpr std::uint32_t jmp = 0600000;
inline constexpr std::uint32_t hlt = 0740040;

struct TapeWord {
  std::uint32_t value = 0;
  std::size_t byte = 0;  // position of its first line in the tape
  bool last = false;     // hole 7 in its third line
  std::optional<std::size_t> early = {};  // position of an earlier line with hole 7, which should be in the third
};

class TapeReader {
 public:
  TapeReader(std::span<const std::uint8_t> tape, std::string_view file) : tape_(tape), file_(file) {}

  // The next word, or nothing at the end of the tape. `expected` names what the caller expects, for the error.
  [[nodiscard]] base::Result<std::optional<TapeWord>> next(std::string_view expected);
  [[nodiscard]] base::Error error(std::size_t byte, std::string found, std::string expected) const;
  // About a word with hole 7 before its third line: the error inside the tape; the warning for the last word of the tape.
  [[nodiscard]] base::Error early_error(const TapeWord& word, std::string_view expected) const;
  [[nodiscard]] std::string early_warning(const TapeWord& word) const;
  // True if no line of another word follows directly.
  [[nodiscard]] bool at_end_of_block() const { return at_ == tape_.size() || (tape_[at_] & hole8) == 0; }

 private:
  [[nodiscard]] std::optional<base::Error> skip_feed(std::string_view expected);

  std::span<const std::uint8_t> tape_;
  std::string_view file_;
  std::size_t at_ = 0;
  bool in_data_ = false;
};

void punch_feed(Tape& tape);
void punch_word(Tape& tape, std::uint32_t word, bool last = false);

}  // namespace sightline::image
