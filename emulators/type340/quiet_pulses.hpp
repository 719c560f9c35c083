// Count pulses without an effect outside the display: no edge reached, not the last of the word. They can be made
// all at once in closed form, and the instant of the first that matters is known when the word begins.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "registers.hpp"
#include "vector_generator.hpp"

namespace sightline::type340 {

// A vector continue of (0, 0) never reaches an edge.
inline constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max();

// Coming pulses up to and without the one that runs `coordinate` off its edge; `done` pulses since BRM = 0.
[[nodiscard]] constexpr std::int64_t pulses_before_edge(std::uint16_t coordinate, bool negative, unsigned scale,
                                                        std::uint8_t magnitude, std::uint8_t d, std::int64_t done) {
  if (magnitude == 0) return endless;
  const int room = negative ? coordinate : Registers::screen_mask - coordinate;
  const std::int64_t step = steps_after(magnitude, d, done) + (room >> scale) + 1;
  return pulse_of_step(magnitude, d, step) - done - 1;
}

// In vector, vector continue and increment mode; 0 when the next pulse matters, or may.
[[nodiscard]] constexpr std::int64_t quiet_pulses(const Registers& r) {
  if (r.halt) return 0;
  if (r.mode == Mode::increment) {
    Registers ahead = r;
    std::int64_t quiet = 0;
    while (ahead.part != 0) {
      ahead.count();
      if (ahead.edge()) break;
      ++quiet;
    }
    return quiet;
  }
  const VectorWord w = decode_vector(r.br);
  const auto d = static_cast<std::uint8_t>(w.dx | w.dy);
  const std::int64_t done = pulses_at(d, r.rate.brm);
  if (done < 0) return 0;
  const std::int64_t inside = std::min(pulses_before_edge(r.x, w.left, r.scale, w.dx, d, done),
                                       pulses_before_edge(r.y, w.down, r.scale, w.dy, d, done));
  return r.mode == Mode::vector ? std::min(inside, pulses_per_turn(d) - 1 - done) : inside;
}

// Makes `count` (1 or more) quiet pulses. What it returns is for the MOVE flip-flop.
struct Motion {
  bool any;   // some pulse moved the beam
  bool last;  // the last one did
};

constexpr Motion skip_pulses(Registers& r, std::int64_t count) {
  Motion motion{false, false};
  if (r.mode == Mode::increment) {
    for (std::int64_t i = 0; i < count; ++i) {
      motion.last = r.count();
      motion.any = motion.any || motion.last;
    }
    return motion;
  }
  const VectorWord w = decode_vector(r.br);
  const auto d = static_cast<std::uint8_t>(w.dx | w.dy);
  const std::int64_t done = pulses_at(d, r.rate.brm);
  const auto steps_between = [&](std::uint8_t magnitude, std::int64_t from) {
    return steps_after(magnitude, d, done + count) - steps_after(magnitude, d, from);
  };
  const auto moved = [&](std::uint16_t coordinate, std::int64_t steps, bool negative) {
    const std::int64_t way = steps * r.step();
    return static_cast<std::uint16_t>(coordinate + (negative ? -way : way));
  };
  const std::int64_t steps_x = steps_between(w.dx, done);
  const std::int64_t steps_y = steps_between(w.dy, done);
  r.x = moved(r.x, steps_x, w.left);
  r.y = moved(r.y, steps_y, w.down);
  r.rate.brm = brm_after(d, done + count);
  motion.any = steps_x + steps_y > 0;
  motion.last = steps_between(w.dx, done + count - 1) + steps_between(w.dy, done + count - 1) > 0;
  return motion;
}

}  // namespace sightline::type340
