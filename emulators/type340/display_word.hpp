// Display: a word executed in one step. Included by display.hpp only.
//
// When a word arrives, nothing else is under way, no flag is about to change and no pen could see it, then its result
// and its end are known at once; if time passes that end before the display is accessed, only the result is
// made. Anything else goes pulse by pulse. Flashes are the same either way.
#pragma once

#include "../core/inline.hpp"
#include "display.hpp"

namespace sightline::type340 {

template <class Sink>
SIGHTLINE_INLINE inline void Display<Sink>::plan_word(core::Instant at) {
  const core::Duration time = time_of_whole_word();
  whole_ = time != not_whole;
  whole_until_ = at + timing::strobe + timing::intensify + time;
}

// Beyond strobe and first intensify; not_whole for a word that may reach an edge, be seen by the pen, or never end.
template <class Sink>
inline core::Duration Display<Sink>::time_of_whole_word() {
  switch (registers_.mode) {
    case Mode::parameter: return core::Duration(0);
    case Mode::point: {
      const PointWord w = decode_point(input_);
      if (w.intensify && pen_) return not_whole;
      return w.y && !w.intensify ? timing::intensify : timing::deflection + timing::intensify;
    }
    case Mode::vector: {
      const VectorWord w = decode_vector(input_);
      end_ = registers_.end_of(w);
      if ((w.intensify && pen_) || !end_.is_on_screen()) return not_whole;
      return timing::times_of_vectors[w.dx | w.dy];
    }
    case Mode::increment: {
      // Four steps of at most eight points.
      constexpr unsigned margin = 32;
      constexpr unsigned room = Registers::screen_mask - 2 * margin;
      if ((input_.bit(1) && pen_) || registers_.x - margin > room || registers_.y - margin > room) return not_whole;
      return 4 * timing::pulse;
    }
    case Mode::slave:
    case Mode::character:
    case Mode::vector_continue:
    case Mode::subroutine: break;
  }
  return not_whole;
}

// The time is whole_until_. As no other pulse has come since the word was planned, the registers that a word begins with are clear,
// and no pen is about to stop it.
template <class Sink>
void Display<Sink>::do_whole_word() {
  delays_.stop_all();
  registers_.br = input_;
  switch (registers_.mode) {
    case Mode::parameter: operate_parameter(whole_until_); return;
    case Mode::point: {
      const PointWord w = decode_point(input_);
      registers_.mode = w.next;
      registers_.set_pen_enable(w.pen);
      (w.y ? registers_.y : registers_.x) = w.coordinate;
      if (w.intensify) flash(whole_until_ - timing::intensify, true);
      raise_request(whole_until_);
      return;
    }
    case Mode::vector: {
      const VectorWord w = decode_vector(input_);
      if (Sink::consumes && w.intensify) return draw_vector(w);
      // The last pulse turns the full BRM over and moves nothing.
      registers_.x = static_cast<std::uint16_t>(end_.x);
      registers_.y = static_cast<std::uint16_t>(end_.y);
      registers_.move = options_.flash_again && (w.dx | w.dy) != 0;
      registers_.halt = true;
      end_word(whole_until_);
      return;
    }
    default:  // increment: nothing else is planned
      registers_.part = 1;
      do_pulses(4);
  }
}

// The pulses that may move the beam, each with its flash, and the one that ends the word.
template <class Sink>
[[gnu::noinline]] void Display<Sink>::do_pulses(int count) {
  const bool lit = registers_.br.bit(1);
  core::Instant t = whole_until_ - count * timing::pulse + timing::settle;
  for (int i = 0; i < count; ++i, t += timing::pulse) {
    note_motion(registers_.count());
    flash(t, lit && registers_.move);
  }
  last_pulse();
}

// The pulses of a vector that stays inside, seen by no pen: each turns on one stage, and that passes its bit of dx and dy
// (vector_generator.hpp).
template <class Sink>
[[gnu::noinline]] void Display<Sink>::draw_vector(VectorWord w) {
  const auto d = static_cast<std::uint8_t>(w.dx | w.dy);
  const int count = pulses_of_vector(w.dx, w.dy);
  const unsigned steps_x = steps_by_stage(w.dx, d);
  const unsigned steps_y = steps_by_stage(w.dy, d);
  const std::int32_t step = registers_.step();
  const std::int32_t right = w.left ? -step : step;
  const std::int32_t up = w.down ? -step : step;
  core::Stroke flash{.time = whole_until_ - count * timing::pulse + timing::settle,
                     .x = registers_.x,
                     .y = registers_.y,
                     .intensity = registers_.intensity,
                     .address = word_address_};
  bool moves = registers_.move;
  // If the first pulse moves the beam, all flash.
  core::Stroke* room = nullptr;
  if constexpr (requires { sink_->room(std::size_t{}); }) {
    if (((steps_x | steps_y) & 1U) != 0 && options_.flash_again) room = sink_->room(static_cast<std::size_t>(count));
  }
  if (room != nullptr) {
    VectorFlashes(flash, steps_x, steps_y, right, up).put(room, count);
    registers_.x = static_cast<std::uint16_t>(end_.x);
    registers_.y = static_cast<std::uint16_t>(end_.y);
    moves = true;
  } else {
    for (unsigned n = 1; n <= static_cast<unsigned>(count); ++n, flash.time += timing::pulse) {
      const auto stage = static_cast<unsigned>(std::countr_zero(n));
      const auto move_x = static_cast<std::int32_t>(steps_x >> stage & 1U);
      const auto move_y = static_cast<std::int32_t>(steps_y >> stage & 1U);
      flash.x = static_cast<std::uint16_t>(flash.x + (right & -move_x));
      flash.y = static_cast<std::uint16_t>(flash.y + (up & -move_y));
      moves = (move_x | move_y) != 0 || (moves && options_.flash_again);
      if (moves) sink_->stroke(flash);
    }
    registers_.x = flash.x;
    registers_.y = flash.y;
  }
  registers_.move = moves;
  registers_.rate.brm = brm_after(d, count);
  last_pulse();
}

// The one that ends the word, which cannot move it.
template <class Sink>
void Display<Sink>::last_pulse() {
  registers_.halt = true;
  count(whole_until_);
}

}  // namespace sightline::type340
