// Paper tape: the reader, IOT device 01, and the punch, IOT device 02.
//
// Sources: PDP-4 manual page 65 for the codes of the reader; another simulator for three-line words and the codes of the
// punch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../core/iot_device.hpp"
#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "device_setup.hpp"
#include "status.hpp"

namespace sightline::pdp7 {

// The paper-tape reader: RSA reads one line of eight holes, RSB a binary word of three lines with hole 8.
//
// A line takes the same time whether it is used or not; RSB skips lines without hole 8. If the tape ends before the request
// is satisfied, the reader keeps running and its flag stays down. A new request abandons the current one; the tape stays at
// the position it has reached.
class Reader final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> codes{001};
  static constexpr std::array iots{
      core::IotName{"rsf", 0700101, "skip if reader flag"},
      core::IotName{"rcf", 0700102, "OR reader buffer into AC, clear flag"},
      core::IotName{"rrb", 0700112, "AC from reader buffer, clear flag"},
      core::IotName{"rsa", 0700104, "read one line"},
      core::IotName{"rsb", 0700144, "read a binary word (three lines)"},
  };
  static constexpr core::IotDeviceInfo info{.name = "reader", .help = "the paper-tape reader", .codes = codes, .iots = iots};

  // `line`: the time of one line.
  explicit Reader(core::Duration line) : line_(line) {}
  explicit Reader(const DeviceSetup& setup) : Reader(setup.timing.reader_line) {}

  // Inserts a tape, one byte per line, hole 8 = 0200; the reader stops and its flag falls.
  void load(std::vector<std::uint8_t> tape) {
    tape_ = std::move(tape);
    position_ = 0;
    reset();
  }

  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    advance(now);
    reply.test(word, flag_);
    if ((word & 02U) != 0) {
      reply.collect(buffer_);
      flag_ = false;
    }
    if ((word & 04U) != 0) {
      if ((word & 040U) != 0) {
        start_word(now);
      } else {
        start_line(now);
      }
    }
    reply.answered |= word & 06U;
  }
  void advance(core::Instant now) override {
    if (now < done_) return;
    position_ += lines_;
    done_ = core::never;
    running_ = false;
    buffer_ = coming_;
    flag_ = true;
  }

  [[nodiscard]] core::Instant deadline() const override { return done_; }
  [[nodiscard]] bool interrupt_request() const override { return flag_; }
  [[nodiscard]] std::uint32_t status(core::Instant now) override { return advance(now), flag_ ? status::reader : 0U; }
  // CAF and START: flag down, transfer abandoned; the tape stays at the position it has reached.
  void clear_flags(core::Instant now) override {
    advance(now);
    halt_motion(now);
    reset();
  }

  // The tape's length and position in lines. The position excludes lines of a request in progress.
  [[nodiscard]] std::size_t length() const { return tape_.size(); }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] core::Word18 buffer() const { return buffer_; }
  // The tape ran out during a request that is still waiting.
  [[nodiscard]] bool out_of_tape() const { return running_ && done_ == core::never; }

  // The tape itself is configuration.
  void visit_state(core::StateVisitor& visit) override {
    visit.input("tape", tape_);
    visit.count("position", position_, tape_.size());
    visit.count("lines", lines_, tape_.size());
    visit("started", started_);
    visit("done", done_);
    visit("coming", coming_);
    visit("buffer", buffer_);
    visit("running", running_);
    visit("flag", flag_);
    visit.require(done_ == core::never || lines_ <= tape_.size() - position_, "lines", "no more than the tape has left");
  }

 private:
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

  void reset() {
    done_ = core::never;
    running_ = flag_ = false;
    buffer_ = core::Word18(0);
  }

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
  std::size_t lines_ = 0;  // that the current request reads in all
  core::Instant started_{};
  core::Instant done_ = core::never;
  core::Word18 coming_;
  core::Word18 buffer_;
  bool running_ = false;
  bool flag_ = false;
};

// The paper-tape punch: PSA punches AC 10-17 as they are, PSB AC 12-17 with hole 8.
//
// One line time after the request the line is on the tape and the flag rises. A request made before that replaces it, as
// the punch buffer does.
class Punch final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> codes{002};
  static constexpr std::array iots{
      core::IotName{"psf", 0700201, "skip if punch flag"},
      core::IotName{"pcf", 0700202, "clear punch flag"},
      core::IotName{"psa", 0700204, "punch a line"},
      core::IotName{"pls", 0700206, "clear flag, punch a line"},
      core::IotName{"psb", 0700244, "punch a line of a binary word"},
  };
  static constexpr core::IotDeviceInfo info{.name = "punch", .help = "the paper-tape punch", .codes = codes, .iots = iots};

  // `line`: the time of one line.
  explicit Punch(core::Duration line) : line_(line) {}
  explicit Punch(const DeviceSetup& setup) : Punch(setup.timing.punch_line) {}

  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    advance(now);
    reply.test(word, flag_);
    if ((word & 02U) != 0) flag_ = false;
    if ((word & 04U) != 0) {
      const std::uint32_t line = reply.ac.value();
      holes_ = static_cast<std::uint8_t>((word & 040U) != 0 ? (line & 077U) | 0200U : line & 0377U);
      flag_ = false;
      done_ = now + line_;
    }
    reply.answered |= word & 06U;
  }
  void advance(core::Instant now) override {
    if (now < done_) return;
    done_ = core::never;
    tape_.push_back(holes_);
    flag_ = true;
  }
  [[nodiscard]] core::Instant deadline() const override { return done_; }
  [[nodiscard]] bool interrupt_request() const override { return flag_; }
  [[nodiscard]] std::uint32_t status(core::Instant now) override { return advance(now), flag_ ? status::punch : 0U; }
  void clear_flags(core::Instant now) override {
    advance(now);
    done_ = core::never;
    flag_ = false;
  }

  // The lines punched so far, one byte per line.
  [[nodiscard]] const std::vector<std::uint8_t>& tape() const { return tape_; }

  void visit_state(core::StateVisitor& visit) override {
    visit("done", done_);
    visit("holes", holes_);
    visit("flag", flag_);
    visit.output("tape", tape_, tape_before_);
  }

 private:
  core::Duration line_;
  core::Instant done_ = core::never;
  std::vector<std::uint8_t> tape_;
  std::uint64_t tape_before_ = 0;  // lines punched before the machine was restored, which tape_ lacks
  std::uint8_t holes_ = 0;
  bool flag_ = false;
};

}  // namespace sightline::pdp7
