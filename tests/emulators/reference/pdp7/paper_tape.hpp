// Paper tape: the reader and the punch.
//
// Codes of the reader: PDP-4 manual page 65; three-line words and the codes of the punch as another simulator has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"

namespace sightline::reference {
using namespace pdp7;


// The paper-tape reader: RSA reads one line of eight holes, RSB a binary word of three lines with hole 8.
//
// A line takes the same time whether it is used or not; lines without hole 8 pass under RSB unread. A tape
// that ends before the request is met leaves the reader running and its flag down. A new request abandons one
// under way, the tape standing where it had come to.
class Reader {
 public:
  explicit Reader(core::Duration line) : line_(line) {}

  // Puts a tape in, one byte a line, hole 8 = 0200; the reader stops and its flag falls.
  void load(std::vector<std::uint8_t> tape) {
    tape_ = std::move(tape);
    position_ = 0;
    reset();
  }

  void start_line(core::Instant now) {
    halt_motion(now);
    const bool left = position_ < tape_.size();
    begin(now, left ? 1 : 0, left ? tape_[position_] : 0U);
  }

  void start_word(core::Instant now) {
    halt_motion(now);
    std::uint32_t word = 0;
    int taken = 0;
    for (std::size_t i = position_; i < tape_.size(); ++i) {
      if ((tape_[i] & 0200U) == 0) continue;
      word = (word << 6) | (tape_[i] & 077U);
      if (++taken == 3) {
        begin(now, i - position_ + 1, word);
        return;
      }
    }
    begin(now, 0, 0);
  }

  void advance(core::Instant now) {
    if (now < done_) return;
    position_ += lines_;
    done_ = core::never;
    running_ = false;
    buffer_ = coming_;
    flag_ = true;
  }

  // CAF and START: flag down, transfer abandoned; the tape does not move.
  void reset() {
    done_ = core::never;
    running_ = flag_ = false;
    buffer_ = core::Word18(0);
  }
  void reset(core::Instant now) {
    halt_motion(now);
    reset();
  }

  [[nodiscard]] bool flag() const { return flag_; }
  void clear_flag() { flag_ = false; }
  [[nodiscard]] core::Word18 buffer() const { return buffer_; }
  [[nodiscard]] core::Instant deadline() const { return done_; }
  // Of the tape, in lines: in all, and how many have passed, those of a request under way not counted.
  [[nodiscard]] std::size_t length() const { return tape_.size(); }
  [[nodiscard]] std::size_t position() const { return position_; }
  // The tape ran out under a request that is still waiting.
  [[nodiscard]] bool out_of_tape() const { return running_ && done_ == core::never; }


 private:
  void begin(core::Instant now, std::size_t lines, std::uint32_t word) {
    running_ = true;
    flag_ = false;
    buffer_ = core::Word18(0);
    coming_ = core::Word18(word);
    started_ = now;
    lines_ = lines;
    done_ = lines == 0 ? core::never : now + line_ * static_cast<std::int64_t>(lines);
  }

  void halt_motion(core::Instant now) {
    if (!running_) return;
    const std::size_t left = tape_.size() - position_;
    const std::size_t passed = line_.count() > 0 ? static_cast<std::size_t>((now - started_) / line_) : left;
    position_ += passed < left ? passed : left;
    running_ = false;
  }

  core::Duration line_;
  std::vector<std::uint8_t> tape_;
  std::size_t position_ = 0;
  std::size_t lines_ = 0;  // that the request under way takes in all
  core::Instant started_{};
  core::Instant done_ = core::never;
  core::Word18 coming_;
  core::Word18 buffer_;
  bool running_ = false;
  bool flag_ = false;
};

// The paper-tape punch: PSA punches AC 10-17 as they are, PSB AC 12-17 with hole 8.
//
// The line is on the tape, and the flag up, one line time after the request; a request made before that
// replaces it, as the punch buffer does.
class Punch {
 public:
  explicit Punch(core::Duration line) : line_(line) {}

  void start(core::Instant now, std::uint8_t holes) {
    holes_ = holes;
    flag_ = false;
    done_ = now + line_;
  }

  void advance(core::Instant now) {
    if (now < done_) return;
    done_ = core::never;
    tape_.push_back(holes_);
    flag_ = true;
  }

  void reset() {
    done_ = core::never;
    flag_ = false;
  }

  [[nodiscard]] bool flag() const { return flag_; }
  void clear_flag() { flag_ = false; }
  [[nodiscard]] core::Instant deadline() const { return done_; }
  // What has been punched so far, one byte a line.
  [[nodiscard]] const std::vector<std::uint8_t>& tape() const { return tape_; }


 private:
  core::Duration line_;
  core::Instant done_ = core::never;
  std::vector<std::uint8_t> tape_;
  std::uint64_t tape_before_ = 0;  // lines punched before the first of tape_: the machine was restored after them
  std::uint8_t holes_ = 0;
  bool flag_ = false;
};

}  // namespace sightline::reference
