// A display reduced to what the PDP-7 can observe: it requests the word at its address counter, increments it, requests again a
// set
// time after each word, and stops with an interrupt request at a word of all ones. A display that deposits writes its first word
// instead, and requests the next as soon as that is done, as the Type 347 does.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "emulators/core/iot_device.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"

namespace sightline::tests {

class FakeDisplay final : public core::IotDevice {
  static constexpr std::array<std::uint8_t, 4> codes{005, 006, 007, 010};

 public:
  static constexpr core::IotDeviceInfo info{"display", "a display for tests", codes};

  struct Delivery {
    core::Instant at;
    core::Instant since;
    core::Word18 word;
  };

  explicit FakeDisplay(core::Duration period, bool deposits = false) : period_(period), deposits_(deposits) {}

  void load_address_and_start(core::Instant now, core::Word18 ac) {
    counter_ = ac.field(5, 17);
    stopped_ = false;
    next_ = now;
    requested_ = false;
    advance(now);
  }
  // Pulses 1 and 2 of devices 05, 07 and 10, IDRS, and IDSI and IDLA of device 06.
  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    advance(now);
    const std::uint32_t device = (word >> 6) & 077U;
    reply.test(word, device == 006 ? stopped_ : device == 007 ? pen_flag : edge_flags);
    if (device == 006) {
      if ((word & 06U) == 06U) load_address_and_start(now, reply.ac);
    } else if ((word & 02U) != 0) {
      reply.collect(core::Word18(device == 005 ? counter_ : device == 007 ? 0123456U : 0654321U));
    }
    if (device == 005 && (word & 04U) != 0) resumed = true;
    reply.answered |= word & 06U;
  }
  void clear_flags(core::Instant) override { stopped_ = false; }
  void power_clear(core::Instant) override {
    stopped_ = false;
    next_ = core::never;
    requested_ = false;
  }
  [[nodiscard]] std::uint32_t status(core::Instant) override { return pen_flag ? 0010000 : 0; }
  [[nodiscard]] bool interrupt_request() const override { return stopped_ || edge_flags || pen_flag; }

  [[nodiscard]] core::Instant deadline() const override { return requested_ ? since_ : next_; }
  void advance(core::Instant now) override {
    if (requested_ || next_ > now) return;
    ask(next_, deposits_ ? core::DataBreak::Direction::to_core : core::DataBreak::Direction::from_core);
    next_ = core::never;
  }
  [[nodiscard]] const core::DataBreak* data_break() const override { return requested_ ? &request_ : nullptr; }
  void end_break(core::Instant end, core::Word18 word) override {
    counter_ = (counter_ + 1) & 017777;
    if (request_.direction == core::DataBreak::Direction::to_core) {
      deposited_at = end;
      deposits_ = false;
      ask(end, core::DataBreak::Direction::from_core);
      return;
    }
    if (keeps_deliveries) deliveries.push_back({end, since_, word});
    requested_ = false;
    stopped_ = word.value() == core::Word18::mask;
    next_ = stopped_ ? core::never : end + period_;
  }

  std::vector<Delivery> deliveries;
  core::Instant deposited_at{};
  bool keeps_deliveries = true;
  bool edge_flags = false;
  bool pen_flag = false;
  bool resumed = false;

 private:
  void ask(core::Instant since, core::DataBreak::Direction direction) {
    request_ = {direction, static_cast<std::uint16_t>(counter_), core::Word18(0252525)};
    since_ = since;
    requested_ = true;
  }

  core::Duration period_;
  bool deposits_;
  core::Instant next_ = core::never;
  core::DataBreak request_;
  core::Instant since_{};
  bool requested_ = false;
  std::uint32_t counter_ = 0;
  bool stopped_ = false;
};

}  // namespace sightline::tests
