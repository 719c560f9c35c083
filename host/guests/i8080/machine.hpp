// The 8080 that guests run on. A machine is compiled for its ports, which takes longer than all else of a guest: this one is compiled
// once, and what is behind its ports is two virtual functions. Nothing is wired to INT, HOLD or READY.
#pragma once

#include <cstdint>

#include "emulators/core/tstates.hpp"
#include "emulators/machines/i8080_machine.hpp"

namespace sightline::guests {

// As emulators/machines/i8080_run.hpp asks of ports.
class GuestPorts {
 public:
  static constexpr bool waits = false;

  [[nodiscard]] virtual std::uint8_t in(std::uint8_t port, core::TStateInstant at) = 0;
  virtual void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) = 0;
  // Ends a run after the instruction that touched the ports.
  [[nodiscard]] bool stopped() const { return stopped_; }

  static void advance(core::TStateInstant) {}
  [[nodiscard]] static constexpr core::TStateInstant deadline() { return core::never_t; }
  [[nodiscard]] static constexpr bool interrupt() { return false; }
  [[nodiscard]] static constexpr std::uint8_t acknowledge(core::TStateInstant) { return 0xFF; }

 protected:
  ~GuestPorts() = default;
  bool stopped_ = false;
};

class GuestI8080 : public machines::I8080Machine<GuestPorts> {
 public:
  // The ports must outlive the machine.
  explicit GuestI8080(GuestPorts& ports) : I8080Machine(ports, nobody_) {}
  machines::I8080StopReason run(const machines::I8080Limits& limits);

 private:
  machines::NoI8080Observer nobody_;
};

}  // namespace sightline::guests
