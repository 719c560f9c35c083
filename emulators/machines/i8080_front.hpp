// A device that a host puts before ports of an 8080 to record accesses or to end a run at one: a derived class overrides
// in() or out(), and calls these to pass the access on to the device.
#pragma once

#include <cstdint>
#include <span>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "i8080.hpp"

namespace sightline::i8080 {

class Front : public core::PortDevice {
 public:
  // Both must live as long as the machine runs.
  Front(Machine& machine, std::span<const core::PortRange> ports) : machine_(machine) {
    for (const core::PortRange range : ports) machine.put_before(range, *this);
  }

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return machine_.forward_in(port, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { machine_.forward_out(port, value, at); }

 protected:
  [[nodiscard]] Machine& machine() const { return machine_; }

 private:
  Machine& machine_;
};

}  // namespace sightline::i8080
