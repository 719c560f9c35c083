// The KSR 33 teletype: a keyboard and a printer that share only the cabinet and the character time.
//
// The keyboard sends eight bits, channel 8 always marked. A key pressed before the last character has been
// sent waits for the line; one that arrives before the program has read the last overwrites it. The printer's
// flag rises one character time after TLS; a TLS before that replaces the character. Codes as another
// simulator has them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "emulators/core/time.hpp"

namespace sightline::reference {
using namespace pdp7;


class Keyboard {
 public:
  explicit Keyboard(core::Duration character) : character_(character) {}

  // Someone presses a key (7-bit code) at `when`, not before any key already pressed; it is in the buffer one
  // character time later.
  void press(core::Instant when, std::uint8_t code) { send(when, static_cast<std::uint8_t>(code | 0200U)); }
  // The same for a terminal that is no KSR 33: the eight bits as they are.
  void send(core::Instant when, std::uint8_t code) {
    const core::Instant line_free = keys_.empty() ? when : keys_.back().arrives;
    keys_.push_back({std::max(when, line_free) + character_, code});
    asked_ = false;
  }

  void advance(core::Instant now) {
    while (next_ < keys_.size() && keys_[next_].arrives <= now) {
      buffer_ = keys_[next_++].code;
      flag_ = true;
    }
  }

  [[nodiscard]] core::Instant deadline() const {
    return next_ < keys_.size() ? keys_[next_].arrives : core::never;
  }
  [[nodiscard]] bool flag() const { return flag_; }
  // As the program does that reads the character: it waits no more, until it tests for the next.
  void clear_flag() {
    flag_ = false;
    asked_ = false;
  }
  [[nodiscard]] std::uint8_t buffer() const { return buffer_; }

  // A skip test that found the flag down: the program waits for a key.
  void ask() { asked_ = true; }
  [[nodiscard]] bool asked() const { return asked_; }
  // Every key pressed has been sent and read.
  [[nodiscard]] bool all_read() const { return next_ == keys_.size() && !flag_; }


 private:
  struct Key {
    core::Instant arrives;
    std::uint8_t code = 0;
  };

  core::Duration character_;
  std::vector<Key> keys_;
  std::size_t next_ = 0;
  std::uint8_t buffer_ = 0;
  bool flag_ = false;
  bool asked_ = false;  // since the last key was pressed or read
};

class Printer {
 public:
  explicit Printer(core::Duration character) : character_(character) {}

  void start(core::Instant now, std::uint8_t code) {
    code_ = code;
    flag_ = false;
    done_ = now + character_;
  }

  void advance(core::Instant now) {
    if (now < done_) return;
    done_ = core::never;
    printed_.push_back(code_);
    flag_ = true;
  }

  void reset() {
    done_ = core::never;
    flag_ = false;
  }

  [[nodiscard]] core::Instant deadline() const { return done_; }
  [[nodiscard]] bool flag() const { return flag_; }
  void clear_flag() { flag_ = false; }
  // Eight-bit codes in the order printed.
  [[nodiscard]] const std::vector<std::uint8_t>& printed() const { return printed_; }


 private:
  core::Duration character_;
  core::Instant done_ = core::never;
  std::vector<std::uint8_t> printed_;
  std::uint64_t printed_before_ = 0;  // codes before the first of printed_: the machine was restored after them
  std::uint8_t code_ = 0;
  bool flag_ = false;
};

}  // namespace sightline::reference
