// The PDP-7 that guests run on, with its Type 340 or without. A machine is compiled for its sink and its observer, which takes longer
// than all else of a guest: this one is compiled once, and finds what a guest looks for by marks at addresses, so that whatever has no
// mark costs one test.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/machines/observer.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/bus.hpp"
#include "emulators/pdp7/state.hpp"

namespace sightline::guests {

// An observer (emulators/machines/observer.hpp) that is told the cycles of the processor at marked addresses. Data breaks and clock
// ticks are not told: the machine counts them.
class GuestWatch {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  struct Filter {
    const std::uint8_t* marks;
    const bool* stop;

    SIGHTLINE_INLINE static bool arrives(pdp7::Address) { return false; }
    SIGHTLINE_INLINE bool wants(const pdp7::Cycle& cycle) const {
      switch (cycle.verb) {
        case pdp7::Verb::fetch: return (marks[cycle.address] & fetched) != 0;
        case pdp7::Verb::read: return (marks[cycle.address] & read) != 0;
        case pdp7::Verb::write: return (marks[cycle.address] & written) != 0;
        case pdp7::Verb::modify: return (marks[cycle.address] & modified) != 0;
        case pdp7::Verb::interrupt:
        case pdp7::Verb::iot:
        case pdp7::Verb::idle:
        case pdp7::Verb::break_read:
        case pdp7::Verb::break_write:
        case pdp7::Verb::break_modify: return false;
      }
      return false;
    }
    // A sink has asked for a stop.
    SIGHTLINE_INLINE bool asks_again() const { return *stop; }
  };

  GuestWatch() = default;
  // A run keeps the address of the marks.
  GuestWatch(const GuestWatch&) = delete;
  GuestWatch& operator=(const GuestWatch&) = delete;

  [[nodiscard]] Filter filter() const { return {marks_.data(), &stop_}; }
  // Kept until the boundary, without a call: one would cost every instruction the registers that it might spoil.
  SIGHTLINE_INLINE void cycle(const pdp7::Cycle& cycle) {
    kept_[kept_count_] = cycle;
    if (kept_count_ + 1 < kept_.size()) ++kept_count_;
  }
  bool stop(core::Instant, pdp7::Address) {
    if (kept_count_ != 0) tell();
    return std::exchange(stop_, false);
  }
  // Hands on what has been kept: a run that ends otherwise than by stop() may leave some.
  void tell();
  // Ends the run: called by told(), at this boundary; by a sink, at the next one. If the run ends otherwise, the next one ends where it begins.
  void request_stop() { stop_ = true; }

 protected:
  ~GuestWatch() = default;

  // A cycle at a marked address, told at the boundary behind its instruction.
  virtual void told(const pdp7::Cycle& cycle) = 0;

  static constexpr std::uint8_t fetched = 1;
  static constexpr std::uint8_t read = 2;  // not as an instruction
  static constexpr std::uint8_t written = 4;
  static constexpr std::uint8_t modified = 8;  // by ISZ or auto-index

  // `marks`: one or several of these.
  void mark(pdp7::Address address, std::uint8_t marks) { marks_[address & pdp7::address_mask] |= marks; }

 private:
  bool stop_ = false;
  std::array<pdp7::Cycle, 64> kept_{};  // more than one instruction has, a chain of sixteen XCTs included
  std::size_t kept_count_ = 0;
  std::vector<std::uint8_t> marks_ = std::vector<std::uint8_t>(std::size_t{pdp7::address_mask} + 1);
};

// A sink (emulators/core/stroke.hpp) that keeps strokes while a guest says so. By itself it keeps none.
class GuestSink {
 public:
  static constexpr bool consumes = true;

  virtual ~GuestSink() = default;

  virtual void begin_pass(core::Instant) {}
  virtual void end_pass(core::Instant) {}
  SIGHTLINE_INLINE void stroke(const core::Stroke& stroke) { *room(1) = stroke; }
  // While nothing is kept, each stroke overwrites the last: that is less work than a test.
  [[nodiscard]] SIGHTLINE_INLINE core::Stroke* room(std::size_t count) {
    if (strokes_.size() - kept_ < count) [[unlikely]]
      grow(count);
    core::Stroke* const first = strokes_.data() + kept_;
    if (keeps_) kept_ += count;
    return first;
  }

 protected:
  void keep_strokes(bool keeps) { keeps_ = keeps; }
  // Those kept since they were last taken or forgotten.
  [[nodiscard]] std::vector<core::Stroke> take_strokes() {
    const std::size_t count = std::exchange(kept_, 0);
    return {strokes_.begin(), strokes_.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  void forget_strokes() { kept_ = 0; }

 private:
  [[gnu::noinline]] void grow(std::size_t count);

  bool keeps_ = false;
  std::size_t kept_ = 0;
  std::vector<core::Stroke> strokes_;  // the first kept_ are kept, the others are room
};

class GuestPdp7 : public machines::Pdp7<GuestSink, GuestWatch> {
 public:
  // Both must outlive the machine.
  GuestPdp7(const machines::Pdp7Options& options, GuestSink& sink, GuestWatch& watch);
  ~GuestPdp7();
  // Out of line: they instantiate the processor and the display.
  void start(pdp7::Address address);
  machines::StopReason run(const machines::Limits& limits);

 private:
  GuestWatch& watch_;
};

}  // namespace sightline::guests
