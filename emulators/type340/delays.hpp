// The delays of the Type 340: one-shots that run in parallel, each firing one pulse. Two that fire at the same instant fire
// in the order of the list: light reaches FIND before the count pulse tests it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "vector_generator.hpp"

namespace sightline::type340 {

// Times of the Type 340 between one pulse and the next, each with its status.
//
// Source: delay times of the logic drawings as modelled pulse by pulse; the whole-word times that they add up to agree with
// every word of 501 display files. A word takes the sum along its path: parameter 3.3 us, point 38.8 us (a dark Y word
// 3.8), vector 2.8 + 1.5 N + 0.5, increment 9.3, character 0.5 + 1.5 for each of its strokes.
namespace timing {

inline constexpr core::Duration strobe{2800};       // word at the inputs -> word in BR (confirmed)
inline constexpr core::Duration intensify{500};     // beam-on time, spent lit or not -> operate pulse (confirmed)
inline constexpr core::Duration settle{1000};       // step of the beam -> intensify (confirmed)
inline constexpr core::Duration pulse = settle + intensify;
inline constexpr core::Duration load{200};          // coordinate cleared -> coordinate loaded (confirmed)
inline constexpr core::Duration deflection{35000};  // random point -> intensify (confirmed)

// Times of vectors by |dx| OR |dy|, from the first count pulse to the last.
inline constexpr auto times_of_vectors = [] {
  std::array<core::Duration, 128> times{};
  for (std::uint8_t d = 0; d < 128; ++d) times[d] = pulses_of_vector(d, 0) * pulse;
  return times;
}();

}  // namespace timing

enum class Delay : std::uint8_t {
  light,          // beam on -> light pulse of the pen
  load_x,         // X cleared -> X loaded
  load_y,
  strobe,         // word at the inputs -> word in BR
  settle,         // count pulse (or IDRS) -> next intensify
  intensify,      // flash -> the operate pulse of a word, count or character
  deflection,     // random point
  point_flash,    // intensify of a point word -> request
  stroke_settle,  // the same two for a stroke of a character
  stroke_flash,
};

class Delays {
 public:
  struct Next {
    Delay delay;
    core::Instant at;  // never: no delay runs
  };

  // Restarts a running delay.
  void start(Delay d, core::Instant at) {
    at_[index(d)] = at;
    running_ |= bit(d);
  }
  void stop(Delay d) { running_ &= ~bit(d); }
  void stop_all() { running_ = 0; }

  [[nodiscard]] core::Instant at(Delay d) const { return runs(d) ? at_[index(d)] : core::never; }
  [[nodiscard]] bool runs(Delay d) const { return (running_ & bit(d)) != 0; }
  [[nodiscard]] bool only(Delay d) const { return running_ == bit(d); }
  [[nodiscard]] bool none() const { return running_ == 0; }

  [[nodiscard]] Next next() const {
    Next first{Delay::light, core::never};
    for (std::uint32_t left = running_; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      if (at_[i] < first.at) first = {static_cast<Delay>(i), at_[i]};
    }
    return first;
  }

  // Instants of delays that do not run are `never`.
  void visit_state(core::StateVisitor& visit) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto delay = static_cast<Delay>(i);
      core::Instant when = at(delay);
      visit(names[i], when);
      if (visit.restores()) {
        stop(delay);
        if (when != core::never) start(delay, when);
      }
    }
  }

 private:
  static constexpr std::size_t count = 10;
  static constexpr std::array<std::string_view, count> names{
      "light",      "load_x",      "load_y",        "strobe",      "settle", "intensify",
      "deflection", "point_flash", "stroke_settle", "stroke_flash"};
  static constexpr std::size_t index(Delay d) { return static_cast<std::size_t>(d); }
  static constexpr std::uint32_t bit(Delay d) { return 1U << index(d); }

  std::array<core::Instant, count> at_{};
  std::uint32_t running_ = 0;  // bit i: delay i runs
};

}  // namespace sightline::type340
