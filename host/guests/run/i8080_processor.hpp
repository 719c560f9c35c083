// The 8080 that every program here runs on, those of `sightline run` and those of the guests. A machine is compiled for its ports and for each
// of its observers, which takes longer than all else of a guest: it is compiled once, and its ports are virtual functions.
#pragma once

#include <cstdint>

#include "emulators/core/tstates.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_machine.hpp"

namespace sightline::guests::run {

class I8080Watcher;
class I8080Reporter;

// Devices that raise INT or HOLD, or change with time. The functions are those of ports in emulators/machines/i8080_run.hpp.
class I8080Lines {
 public:
  // False: none of them ever raises HOLD.
  explicit I8080Lines(bool holds) : holds_(holds) {}
  [[nodiscard]] bool holds() const { return holds_; }

  virtual void advance(core::TStateInstant now) = 0;
  [[nodiscard]] virtual core::TStateInstant deadline() const = 0;
  [[nodiscard]] virtual bool interrupt() const = 0;
  [[nodiscard]] virtual std::uint8_t acknowledge(core::TStateInstant now) = 0;
  [[nodiscard]] virtual core::TStateInstant next_hold(core::TStateInstant t) const = 0;
  [[nodiscard]] virtual core::TStateInstant hold_ends(core::TStateInstant t) const = 0;

 protected:
  ~I8080Lines() = default;

 private:
  bool holds_;
};

// What is on the ports.
class I8080Ports {
 public:
  static constexpr bool waits = false;

  // Null: nothing is wired.
  explicit I8080Ports(I8080Lines* lines = nullptr) : lines_(lines) {}

  [[nodiscard]] virtual std::uint8_t in(std::uint8_t port, core::TStateInstant at) = 0;
  virtual void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) = 0;
  // Ends a run after the instruction that touched the ports.
  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] bool wants_look() const {
    return stopped_ || (lines_ != nullptr && (lines_->deadline() != seen_deadline_ || lines_->interrupt() != seen_interrupt_));
  }

  void advance(core::TStateInstant now) {
    if (lines_ != nullptr) lines_->advance(now);
  }
  // Each look of the processor at its lines ends with this.
  [[nodiscard]] core::TStateInstant deadline() {
    if (lines_ == nullptr) return core::never_t;
    seen_interrupt_ = lines_->interrupt();
    return seen_deadline_ = lines_->deadline();
  }
  [[nodiscard]] bool interrupt() const { return lines_ != nullptr && lines_->interrupt(); }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) { return lines_ != nullptr ? lines_->acknowledge(now) : 0xFF; }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const {
    return lines_ != nullptr && lines_->holds() ? lines_->next_hold(t) : core::never_t;
  }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const { return lines_ != nullptr ? lines_->hold_ends(t) : t; }

 protected:
  ~I8080Ports() = default;
  bool stopped_ = false;

 private:
  I8080Lines* lines_;
  core::TStateInstant seen_deadline_{};
  bool seen_interrupt_ = false;
};

class I8080Processor : public machines::I8080Machine<I8080Ports> {
 public:
  // The ports must outlive the machine.
  explicit I8080Processor(I8080Ports& ports) : I8080Machine(ports, nobody_) {}

  machines::I8080StopReason run(const machines::I8080Limits& limits);
  machines::I8080StopReason run(const machines::I8080Limits& limits, I8080Watcher& watcher);
  machines::I8080StopReason run(const machines::I8080Limits& limits, I8080Reporter& reporter);
  // Runs until the next instruction is at `place`, and ends with `observer`. If the run begins there, that instruction is executed first.
  machines::I8080StopReason run_to(i8080::Address place, const machines::I8080Limits& limits);

 private:
  machines::NoI8080Observer nobody_;
};

}  // namespace sightline::guests::run
