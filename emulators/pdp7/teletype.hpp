// The KSR 33 teletype: a keyboard, IOT device 03, and a printer, IOT device 04, which share only the cabinet and the
// character time.
//
// The keyboard sends eight bits, channel 8 always marked. A key pressed before the last character has been sent waits for
// the line; one that arrives before the program has read the last overwrites it. The printer's flag rises one character
// time after TLS; a TLS before that replaces the character. Source of the codes: another simulator.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../core/iot_device.hpp"
#include "../core/key_polls.hpp"
#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "device_setup.hpp"
#include "status.hpp"

namespace sightline::pdp7 {

class Keyboard final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> codes{003};
  static constexpr std::array iots{
      core::IotName{"ksf", 0700301, "skip if keyboard flag"},
      core::IotName{"krb", 0700312, "AC from keyboard, clear flag"},
  };
  static constexpr core::IotDeviceInfo info{.name = "keyboard", .help = "the teletype's keyboard", .codes = codes, .iots = iots};

  // `character`: the time of one character.
  explicit Keyboard(core::Duration character) : character_(character) {}
  explicit Keyboard(const DeviceSetup& setup) : Keyboard(setup.timing.teletype_character) {}

  // A key (7-bit code) is pressed at `when`, not before any earlier one; it is in the buffer one character time later.
  void press(core::Instant when, std::uint8_t code) { send(when, static_cast<std::uint8_t>(code | 0200U)); }
  // The same for a terminal other than a KSR 33: sends the eight bits unchanged.
  void send(core::Instant when, std::uint8_t code) {
    const core::Instant line_free = keys_.empty() ? when : keys_.back().arrives;
    keys_.push_back({std::max(when, line_free) + character_, code});
    polls_.forget();
  }

  // Pulse 4 of this code is IORS, which the machine executes.
  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    advance(now);
    reply.test(word, flag_);
    if ((word & 02U) != 0) {
      reply.collect(core::Word18(buffer_));
      reply.answered |= 02U;
      flag_ = false;
      polls_.forget();
    } else if ((word & 01U) != 0 && !flag_) {
      polls_.add();
    }
  }
  void advance(core::Instant now) override {
    while (next_ < keys_.size() && keys_[next_].arrives <= now) {
      buffer_ = keys_[next_++].code;
      flag_ = true;
    }
  }
  [[nodiscard]] core::Instant deadline() const override {
    return next_ < keys_.size() ? keys_[next_].arrives : core::never;
  }
  [[nodiscard]] bool interrupt_request() const override { return flag_; }
  [[nodiscard]] std::uint32_t status(core::Instant now) override { return advance(now), flag_ ? status::keyboard : 0U; }
  void clear_flags(core::Instant now) override {
    advance(now);
    flag_ = false;
    polls_.forget();
  }

  [[nodiscard]] std::uint8_t buffer() const { return buffer_; }
  // A skip test has found the flag down since a key was last pressed or read.
  [[nodiscard]] bool polled() const { return polls_.any(); }
  void tell_polls(core::KeyPollListener* listener) { polls_.tell(listener); }
  // Every key pressed has been sent and read.
  [[nodiscard]] bool all_read() const { return next_ == keys_.size() && !flag_; }

  // The keys not yet read, and the last one before them, which tells when the line is free.
  void visit_state(core::StateVisitor& visit) override {
    if (next_ > 1) keys_.erase(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(next_ - 1));
    next_ = std::min(next_, std::size_t{1});
    visit.list("keys", keys_, [&visit](Key& key) {
      visit("arrives", key.arrives);
      visit("code", key.code);
    });
    visit.count("next", next_, 1);
    visit("buffer", buffer_);
    visit("flag", flag_);
    visit("asked", polls_.state());
    visit.require(next_ <= keys_.size(), "next", "no more than the number of keys");
  }

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
  core::KeyPolls polls_;
};

class Printer final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> codes{004};
  static constexpr std::array iots{
      core::IotName{"tsf", 0700401, "skip if printer flag"},
      core::IotName{"tcf", 0700402, "clear printer flag"},
      core::IotName{"tls", 0700406, "clear flag, print"},
  };
  static constexpr core::IotDeviceInfo info{.name = "printer", .help = "the teletype's printer", .codes = codes, .iots = iots};

  // `character`: the time of one character.
  explicit Printer(core::Duration character) : character_(character) {}
  explicit Printer(const DeviceSetup& setup) : Printer(setup.timing.teletype_character) {}

  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    advance(now);
    reply.test(word, flag_);
    if ((word & 02U) != 0) flag_ = false;
    if ((word & 04U) != 0) {
      code_ = static_cast<std::uint8_t>(reply.ac.value() & 0377U);
      flag_ = false;
      done_ = now + character_;
    }
    reply.answered |= word & 06U;
  }
  void advance(core::Instant now) override {
    if (now < done_) return;
    done_ = core::never;
    printed_.push_back(code_);
    flag_ = true;
  }
  [[nodiscard]] core::Instant deadline() const override { return done_; }
  [[nodiscard]] bool interrupt_request() const override { return flag_; }
  [[nodiscard]] std::uint32_t status(core::Instant now) override { return advance(now), flag_ ? status::printer : 0U; }
  void clear_flags(core::Instant now) override {
    advance(now);
    done_ = core::never;
    flag_ = false;
  }

  // Eight-bit codes in the order printed.
  [[nodiscard]] const std::vector<std::uint8_t>& printed() const { return printed_; }

  void visit_state(core::StateVisitor& visit) override {
    visit("done", done_);
    visit("code", code_);
    visit("flag", flag_);
    visit.output("printed", printed_, printed_before_);
  }

 private:
  core::Duration character_;
  core::Instant done_ = core::never;
  std::vector<std::uint8_t> printed_;
  std::uint64_t printed_before_ = 0;  // codes printed before the machine was restored, which printed_ lacks
  std::uint8_t code_ = 0;
  bool flag_ = false;
};

}  // namespace sightline::pdp7
