#include "tools/image/tape_words.hpp"

#include "host/base/number.hpp"
#include "host/base/result.hpp"

namespace sightline::image {
base::Error TapeReader::error(std::size_t byte, std::string found, std::string expected) const {
  return base::Error{std::string(file_), "byte " + std::to_string(byte), std::move(found),
                     std::move(expected)};
}

// Before the first word any line without hole 8 is leader (some tapes have their name punched there in readable shapes).
// After it only blank feed is skipped, so that one lost hole 8 does not shift all words that follow.
std::optional<base::Error> TapeReader::skip_feed(std::string_view expected) {
  for (; at_ < tape_.size() && (tape_[at_] & hole8) == 0; ++at_) {
    if (in_data_ && tape_[at_] != 0) {
      return error(at_, "line " + base::octal(tape_[at_], 3) + " without hole 8",
                   "hole 8 of " + std::string(expected));
    }
  }
  return std::nullopt;
}

base::Result<std::optional<TapeWord>> TapeReader::next(std::string_view expected) {
  if (auto problem = skip_feed(expected)) return *problem;
  if (at_ == tape_.size()) return std::optional<TapeWord>{};
  in_data_ = true;
  TapeWord word{0, at_, false};
  for (int line = 0; line < 3; ++line, ++at_) {
    if (at_ == tape_.size()) {
      return error(at_, "the end of the tape inside a word", "three lines of " + std::string(expected));
    }
    const std::uint8_t holes = tape_[at_];
    if ((holes & hole8) == 0) {
      return error(at_, "line " + base::octal(holes, 3) + " without hole 8 inside a word",
                   "three lines with hole 8 of " + std::string(expected));
    }
    if (line != 2 && (holes & hole7) != 0) word.early = at_;
    word.value = word.value << 6 | (holes & data_holes);
    word.last = (holes & hole7) != 0;
  }
  return std::optional<TapeWord>{word};
}

base::Error TapeReader::early_error(const TapeWord& word, std::string_view expected) const {
  const std::size_t byte = word.early.value_or(word.byte);
  return error(byte, "line " + base::octal(tape_[byte], 3) + " with hole 7 before the third line of a word",
               "three lines with hole 8 of " + std::string(expected));
}

std::string TapeReader::early_warning(const TapeWord& word) const {
  const std::size_t byte = word.early.value_or(word.byte);
  const base::Error warning = error(byte, "hole 7 in line " + std::to_string(byte - word.byte + 1) + " of the last word",
                              "it in line 3; the tape is read up to this word");
  return warning.message();
}

void punch_feed(Tape& tape) {
  constexpr std::size_t feed_lines = 20;  // two inches, enough to thread a reader
  tape.insert(tape.end(), feed_lines, std::uint8_t{0});
}

void punch_word(Tape& tape, std::uint32_t word, bool last) {
  tape.push_back(static_cast<std::uint8_t>(hole8 | ((word >> 12) & data_holes)));
  tape.push_back(static_cast<std::uint8_t>(hole8 | ((word >> 6) & data_holes)));
  tape.push_back(static_cast<std::uint8_t>(hole8 | (last ? hole7 : 0) | (word & data_holes)));
}

}  // namespace sightline::image
