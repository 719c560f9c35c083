// The output of calligraphic display hardware, and the interface of its consumers.
//
// One Stroke is one flash of the beam: everything the Type 340 draws consists of them. A sink is a type with
//   static constexpr bool consumes;             false: the display may skip the work of finding single flashes
//   void begin_pass(Instant);                   the program started the display (IDLA)
//   void stroke(const Stroke&);                 in the order of time within one display
//   void end_pass(Instant);                     the display stopped (stop word or edge)
// and, if it stores them as they are,
//   Stroke* room(std::size_t count);            where the next ones go, all of which are put there at once; null: give them to stroke()
// Consumers (raster, phosphor, logs, statistics) use no other output of a display.
#pragma once

#include <cstdint>

#include "time.hpp"

namespace sightline::core {

struct Stroke {
  Instant time;               // beam on
  std::uint16_t x = 0;        // 0..1023, 0 = left
  std::uint16_t y = 0;        // 0..1023, 0 = bottom
  std::uint8_t intensity = 0; // 0..7, 7 brightest
  std::uint16_t address = 0;  // core address of the display word that lit it

  friend constexpr bool operator==(const Stroke&, const Stroke&) = default;
};

// A sink that discards everything.
struct NoStrokes {
  static constexpr bool consumes = false;
  void begin_pass(Instant) {}
  void stroke(const Stroke&) {}
  void end_pass(Instant) {}
};

}  // namespace sightline::core
