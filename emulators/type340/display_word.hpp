// Display: a word executed in one step. Included by display.hpp only.
//
// When a word arrives, nothing else is under way, no flag is about to change and no pen could see it, then its result
// and its end are known at once; if time passes that end before the display is accessed, only the result is
// made. Anything else goes pulse by pulse. Flashes are the same either way.
#pragma once

#include "display.hpp"

namespace sightline::type340 {

template <class Sink>
void Display<Sink>::plan_word(core::Instant at) {
  const Registers& r = registers_;
  if (!delays_.none() || r.stop || r.pen_flag || r.pen_will_stop()) return;
  const std::optional<core::Duration> time = time_of_whole_word();
  whole_ = time.has_value();
  if (whole_) whole_until_ = at + timing::strobe + timing::intensify + *time;
}

// Beyond strobe and first intensify; nothing for a word that may reach an edge, be seen by the pen, or never end.
template <class Sink>
inline std::optional<core::Duration> Display<Sink>::time_of_whole_word() const {
  switch (registers_.mode) {
    case Mode::parameter: return core::Duration(0);
    case Mode::point: {
      const PointWord w = decode_point(input_);
      if (w.intensify && pen_) return std::nullopt;
      return w.y && !w.intensify ? timing::intensify : timing::deflection + timing::intensify;
    }
    case Mode::vector: {
      const VectorWord w = decode_vector(input_);
      if ((w.intensify && pen_) || !vector_stays_inside(w)) return std::nullopt;
      return pulses_of_vector(w.dx, w.dy) * timing::pulse;
    }
    case Mode::increment: {
      // Four steps of at most eight points.
      constexpr unsigned margin = 32;
      constexpr unsigned room = Registers::screen_mask - 2 * margin;
      if ((input_.bit(1) && pen_) || registers_.x - margin > room || registers_.y - margin > room) return std::nullopt;
      return 4 * timing::pulse;
    }
    case Mode::slave:
    case Mode::character:
    case Mode::vector_continue:
    case Mode::subroutine: break;
  }
  return std::nullopt;
}

template <class Sink>
bool Display<Sink>::vector_stays_inside(VectorWord w) const {
  const auto end = [this](unsigned from, bool negative, unsigned steps) {
    const unsigned way = steps << registers_.scale;
    return negative ? from - way : from + way;
  };
  return (end(registers_.x, w.left, w.dx) | end(registers_.y, w.down, w.dy)) <= Registers::screen_mask;
}

// The time is whole_until_.
template <class Sink>
void Display<Sink>::do_whole_word() {
  delays_.stop_all();
  registers_.strobe(input_);
  switch (registers_.mode) {
    case Mode::point: {
      const PointWord w = decode_point(input_);
      operate_point(whole_until_);
      delays_.stop_all();
      (w.y ? registers_.y : registers_.x) = w.coordinate;
      flash(whole_until_ - timing::intensify, w.intensify);
      raise_request(whole_until_);
      break;
    }
    case Mode::vector: {
      const VectorWord w = decode_vector(input_);
      if (Sink::consumes && w.intensify) {
        draw_vector(w);
        last_pulse();
      } else {
        registers_.finish_vector(w);
        note_motion(false);
        end_word(whole_until_);
      }
      break;
    }
    case Mode::increment:
      do_pulses(4);
      last_pulse();
      break;
    default: operate(whole_until_); break;
  }
}

// The pulses that may move the beam, each with its flash.
template <class Sink>
void Display<Sink>::do_pulses(int count) {
  const bool lit = registers_.br.bit(1);
  core::Instant t = whole_until_ - count * timing::pulse + timing::settle;
  for (int i = 0; i < count; ++i, t += timing::pulse) {
    note_motion(registers_.count());
    flash(t, lit && registers_.move);
  }
}

// The pulses of a vector that stays inside, seen by no pen: each turns on one stage, and that passes its bit of dx and dy
// (vector_generator.hpp).
template <class Sink>
void Display<Sink>::draw_vector(VectorWord w) {
  const auto d = static_cast<std::uint8_t>(w.dx | w.dy);
  const int count = pulses_of_vector(w.dx, w.dy);
  const unsigned steps_x = steps_by_stage(w.dx, d);
  const unsigned steps_y = steps_by_stage(w.dy, d);
  const auto step = static_cast<unsigned>(registers_.step());
  const unsigned right = w.left ? 0U - step : step;
  const unsigned up = w.down ? 0U - step : step;
  std::uint16_t x = registers_.x;
  std::uint16_t y = registers_.y;
  bool moves = registers_.move;
  core::Instant t = whole_until_ - count * timing::pulse + timing::settle;
  for (unsigned n = 1; n <= static_cast<unsigned>(count); ++n, t += timing::pulse) {
    const auto stage = static_cast<unsigned>(std::countr_zero(n));
    const unsigned move_x = steps_x >> stage & 1U;
    const unsigned move_y = steps_y >> stage & 1U;
    x = static_cast<std::uint16_t>(x + (right & (0U - move_x)));
    y = static_cast<std::uint16_t>(y + (up & (0U - move_y)));
    moves = (move_x | move_y) != 0 || (moves && options_.flash_again);
    if (moves) sink_->stroke({.time = t, .x = x, .y = y, .intensity = registers_.intensity, .address = word_address_});
  }
  registers_.x = x;
  registers_.y = y;
  registers_.move = moves;
  registers_.rate.brm = brm_after(d, count);
}

// The one that ends the word, which cannot move it.
template <class Sink>
void Display<Sink>::last_pulse() {
  registers_.halt = true;
  count(whole_until_);
}

}  // namespace sightline::type340
