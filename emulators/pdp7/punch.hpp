// The paper-tape punch: PSA punches AC 10-17 as they are, PSB AC 12-17 with hole 8.
//
// The line is on the tape, and the flag up, one line time after the request; a request made before that
// replaces it, as the punch buffer does. Codes as another simulator has them.
#pragma once

#include <cstdint>
#include <vector>

#include "emulators/core/time.hpp"

namespace sightline::pdp7 {

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
  std::uint8_t holes_ = 0;
  bool flag_ = false;
};

}  // namespace sightline::pdp7
