// The 8080 of all that runs one here: any program, and the guests' own. A machine is compiled for its ports and for each of its observers,
// which takes longer than all else of a guest: it is compiled once, and what is behind its ports is virtual functions.
#pragma once

#include <cstdint>

#include "emulators/core/tstates.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_machine.hpp"

namespace sightline::guests::run {

class I8080Watcher;
class I8080Reporter;

// What may be wired to INT and HOLD, and change by itself: as emulators/machines/i8080_run.hpp asks of ports.
class I8080Lines {
 public:
  virtual void advance(core::TStateInstant now) = 0;
  [[nodiscard]] virtual core::TStateInstant deadline() const = 0;
  [[nodiscard]] virtual bool interrupt() const = 0;
  [[nodiscard]] virtual std::uint8_t acknowledge(core::TStateInstant now) = 0;
  [[nodiscard]] virtual core::TStateInstant next_hold(core::TStateInstant t) const = 0;
  [[nodiscard]] virtual core::TStateInstant hold_ends(core::TStateInstant t) const = 0;

 protected:
  ~I8080Lines() = default;
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
  [[nodiscard]] bool settled() const { return lines_ == nullptr && !stopped_; }

  void advance(core::TStateInstant now) {
    if (lines_ != nullptr) lines_->advance(now);
  }
  [[nodiscard]] core::TStateInstant deadline() const { return lines_ != nullptr ? lines_->deadline() : core::never_t; }
  [[nodiscard]] bool interrupt() const { return lines_ != nullptr && lines_->interrupt(); }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) { return lines_ != nullptr ? lines_->acknowledge(now) : 0xFF; }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const {
    return lines_ != nullptr ? lines_->next_hold(t) : core::never_t;
  }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const { return lines_ != nullptr ? lines_->hold_ends(t) : t; }

 protected:
  ~I8080Ports() = default;
  bool stopped_ = false;

 private:
  I8080Lines* lines_;
};

class I8080Processor : public machines::I8080Machine<I8080Ports> {
 public:
  // The ports must outlive the machine.
  explicit I8080Processor(I8080Ports& ports) : I8080Machine(ports, nobody_) {}

  machines::I8080StopReason run(const machines::I8080Limits& limits);
  machines::I8080StopReason run(const machines::I8080Limits& limits, I8080Watcher& watcher);
  machines::I8080StopReason run(const machines::I8080Limits& limits, I8080Reporter& reporter);
  // Ends with `observer` where the program comes to a place; an instruction there at which the run begins is passed over.
  machines::I8080StopReason run_to(i8080::Address place, const machines::I8080Limits& limits);

 private:
  machines::NoI8080Observer nobody_;
};

}  // namespace sightline::guests::run
