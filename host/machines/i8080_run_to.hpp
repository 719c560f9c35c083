// Runs an 8080 to an address in its program.
#pragma once

#include <cstdint>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "emulators/machines/i8080.hpp"

namespace sightline::machines {

// Runs until the next instruction is at `place`, and ends with StopReason::observer. If the run begins there, that
// instruction is executed first.
inline i8080::StopReason run_to(i8080::Machine& machine, i8080::Address place, const i8080::Limits& limits) {
  class Arrival final : public i8080::Observer {
   public:
    Arrival(i8080::Address place, core::TStateInstant begun) : place_(place), begun_(begun) {
      places_[place] = i8080::mark::stop;
      marks = places_.data();
    }
    [[nodiscard]] bool stop(core::TStateInstant now, i8080::Address next) override { return next == place_ && now != begun_; }

   private:
    i8080::Address place_;
    core::TStateInstant begun_;
    std::vector<std::uint8_t> places_ = std::vector<std::uint8_t>(0x10000);
  };
  Arrival arrival(place, machine.now());
  return machine.run(limits, arrival);
}

}  // namespace sightline::machines
