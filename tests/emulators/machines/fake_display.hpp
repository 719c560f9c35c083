// A display that only does what the PDP-7 can feel of one: it asks for the word at its address counter, steps
// on, asks again a set time after each word, and stops with an interrupt request at a word of all ones. One
// that deposits writes its first word instead, and asks for the next as soon as that is done, as the Type 347
// does.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"

namespace sightline::tests {

struct FakeRequest {
  core::Instant since;
  std::uint16_t address;
  bool write;
  core::Word18 word;
};

class FakeDisplay {
 public:
  struct Delivery {
    core::Instant at;
    core::Instant since;
    core::Word18 word;
  };

  explicit FakeDisplay(core::Duration period, bool deposits = false) : period_(period), deposits_(deposits) {}

  void load_address_and_start(core::Instant now, core::Word18 ac) {
    counter_ = ac.field(5, 17);
    restart(now);
  }
  void restart(core::Instant now) {
    stopped_ = false;
    next_ = now;
    request_.reset();
    advance(now);
  }
  void clear_flags(core::Instant) { stopped_ = false; }
  void resume(core::Instant) { resumed = true; }
  void power_clear(core::Instant) {
    stopped_ = false;
    next_ = core::never;
    request_.reset();
  }
  bool stop_interrupt(core::Instant now) { return advance(now), stopped_; }
  bool vertical_edge(core::Instant) { return edge_flags; }
  bool horizontal_edge(core::Instant) { return edge_flags; }
  bool light_pen_flag(core::Instant) { return pen_flag; }
  core::Word18 address_counter(core::Instant now) { return advance(now), core::Word18(counter_); }
  core::Word18 coordinates(core::Instant) { return core::Word18(0123456); }
  core::Word18 return_address(core::Instant) { return core::Word18(0654321); }

  [[nodiscard]] core::Instant deadline() const { return next_; }
  void advance(core::Instant now) {
    if (request_ || next_ > now) return;
    request_ = FakeRequest{next_, static_cast<std::uint16_t>(counter_), deposits_, core::Word18(0252525)};
    next_ = core::never;
  }
  [[nodiscard]] const FakeRequest* break_request() const { return request_ ? &*request_ : nullptr; }
  void deliver(core::Instant at, core::Word18 word) {
    if (keeps_deliveries) deliveries.push_back({at, request_->since, word});
    request_.reset();
    counter_ = (counter_ + 1) & 017777;
    stopped_ = word.value() == core::Word18::mask;
    next_ = stopped_ ? core::never : at + period_;
  }
  void deposited(core::Instant at) {
    deposited_at = at;
    deposits_ = false;
    counter_ = (counter_ + 1) & 017777;
    request_ = FakeRequest{at, static_cast<std::uint16_t>(counter_), false, core::Word18()};
  }
  [[nodiscard]] bool interrupt_request() const { return stopped_ || edge_flags || pen_flag; }

  std::vector<Delivery> deliveries;
  core::Instant deposited_at{};
  bool keeps_deliveries = true;
  bool edge_flags = false;
  bool pen_flag = false;
  bool resumed = false;

 private:
  core::Duration period_;
  bool deposits_;
  core::Instant next_ = core::never;
  std::optional<FakeRequest> request_;
  std::uint32_t counter_ = 0;
  bool stopped_ = false;
};

}  // namespace sightline::tests
