// The delays of the Type 340: one-shots that run side by side, each firing one pulse. Two that fire at the same instant
// fire in the order of the list: light reaches FIND before the count pulse looks at it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "emulators/core/time.hpp"

namespace sightline::type340 {

enum class Delay : std::uint8_t {
  light,          // beam on -> light pulse of the pen
  load_x,         // X cleared -> X loaded
  load_y,
  strobe,         // word at the inputs -> word in BR
  settle,         // count pulse (or IDRS) -> next intensify
  intensify,      // before the operate pulse of a word, count or character
  deflection,     // random point
  point_flash,    // intensify of a point word -> request
  stroke_settle,  // the same two for a stroke of a character
  stroke_flash,
};

class Delays {
 public:
  struct Next {
    Delay delay;
    core::Instant at;  // never: none runs
  };

  Delays() { at_.fill(core::never); }

  // A running delay starts again.
  void start(Delay d, core::Instant at) { at_[index(d)] = at; }
  void stop(Delay d) { at_[index(d)] = core::never; }
  void stop_all() { at_.fill(core::never); }

  [[nodiscard]] core::Instant at(Delay d) const { return at_[index(d)]; }
  [[nodiscard]] bool runs(Delay d) const { return at(d) != core::never; }

  [[nodiscard]] bool only(Delay d) const {
    if (!runs(d)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (i != index(d) && at_[i] != core::never) return false;
    }
    return true;
  }

  [[nodiscard]] Next next() const {
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (at_[i] < at_[first]) first = i;
    }
    return {static_cast<Delay>(first), at_[first]};
  }

 private:
  static constexpr std::size_t count = 10;
  static constexpr std::size_t index(Delay d) { return static_cast<std::size_t>(d); }
  std::array<core::Instant, count> at_;
};

}  // namespace sightline::type340
