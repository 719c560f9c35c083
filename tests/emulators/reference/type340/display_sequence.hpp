// Display: the pulses, from a word in BR to the request for the next. Included by display.hpp only.
#pragma once

#include "tests/emulators/reference/type340/display.hpp"

namespace sightline::reference_display {
using namespace type340;


template <class Sink>
void Display<Sink>::fire(Delay delay, core::Instant t) {
  switch (delay) {
    case Delay::light: registers_.pen_find = registers_.pen_find || registers_.pen_enable; break;
    case Delay::load_x: registers_.x = decode_point(registers_.br).coordinate | registers_.x; break;
    case Delay::load_y: registers_.y = decode_point(registers_.br).coordinate | registers_.y; break;
    case Delay::strobe:
      registers_.strobe(input_);
      start_intensify(t);
      break;
    case Delay::settle: settled(t); break;
    case Delay::intensify: operate(t); break;
    case Delay::deflection:
      flash(t, decode_point(registers_.br).intensify);
      delays_.start(Delay::point_flash, t + timing::intensify);
      break;
    case Delay::point_flash: raise_request(t); break;
    case Delay::stroke_settle:
      flash(t, path_[stroke_].lit);
      delays_.start(Delay::stroke_flash, t + timing::intensify);
      break;
    case Delay::stroke_flash:
      ++stroke_;
      next_stroke(t);
      break;
  }
}

template <class Sink>
void Display<Sink>::operate(core::Instant t) {
  switch (registers_.mode) {
    case Mode::parameter: operate_parameter(t); break;
    case Mode::point:
      if (!registers_.pen_flag) operate_point(t);
      break;
    case Mode::slave: break;
    case Mode::character:
      if (options_.characters_342) {
        operate_character(t);
      } else {
        ++counters_.characters_met;
      }
      break;
    case Mode::vector:
    case Mode::vector_continue:
    case Mode::increment: count(t); break;
    case Mode::subroutine:
      if (options_.subroutines_347) {
        operate_subroutine(t);
      } else {
        ++counters_.subroutines_met;
      }
      break;
  }
}

template <class Sink>
void Display<Sink>::operate_parameter(core::Instant t) {
  const ParameterWord w = decode_parameter(registers_.br);
  registers_.mode = w.next;
  registers_.set_pen_enable(w.pen);
  registers_.scale = w.scale.value_or(registers_.scale);
  registers_.intensity = w.intensity.value_or(registers_.intensity);
  if (w.stop) {
    registers_.stop = true;
    ++counters_.stop_codes;
    end_pass(t);
  } else {
    raise_request(t);
  }
}

// Only a dark Y word omits the deflection time.
template <class Sink>
void Display<Sink>::operate_point(core::Instant t) {
  const PointWord w = decode_point(registers_.br);
  registers_.mode = w.next;
  registers_.set_pen_enable(w.pen);
  (w.y ? registers_.y : registers_.x) = 0;
  delays_.start(w.y ? Delay::load_y : Delay::load_x, t + timing::load);
  if (!w.y || w.intensify) {
    delays_.start(Delay::deflection, t + timing::deflection);
  } else {
    delays_.start(Delay::point_flash, t + timing::intensify);
  }
}

// A jump takes the time of a parameter word, a deposit that and its write break (inferred).
template <class Sink>
void Display<Sink>::operate_subroutine(core::Instant t) {
  constexpr std::uint32_t jump = 0400000;
  const SubroutineWord w = decode_subroutine(registers_.br);
  registers_.mode = w.next;
  switch (w.operation) {
    case SubroutineOperation::none: break;
    case SubroutineOperation::deposit:
      registers_.save = false;
      writing_ = true;
      request_ = {t, w.address, true, core::Word18(jump | registers_.return_address)};
      return;
    case SubroutineOperation::jump_and_save:
      registers_.return_address = registers_.address;
      registers_.save = true;
      registers_.address = w.address;
      break;
    case SubroutineOperation::jump: registers_.address = w.address; break;
  }
  raise_request(t);
}

template <class Sink>
void Display<Sink>::count(core::Instant t) {
  const bool last = registers_.halt;
  note_motion(registers_.count());
  if (!last) {
    delays_.start(Delay::settle, t + timing::settle);
    return;
  }
  end_word(t);
}

// Of a vector or increment word.
template <class Sink>
void Display<Sink>::end_word(core::Instant t) {
  if (registers_.br.bit(0)) registers_.escape();
  raise_request(t);
}

// The beam has settled after a count pulse, or IDRS asks to go on.
template <class Sink>
void Display<Sink>::settled(core::Instant t) {
  if (registers_.mode == Mode::vector && registers_.rate.brm == RateMultiplier::full) registers_.halt = true;
  if (registers_.edge()) {
    const bool goes_on = registers_.mode == Mode::vector_continue;
    registers_.escape();
    if (goes_on) {
      raise_request(t);
    } else {
      if (pass_open_) ++counters_.edges;
      end_pass(t);
    }
  } else if (!registers_.pen_flag && !registers_.request) {
    start_intensify(t);
  }
}

template <class Sink>
void Display<Sink>::operate_character(core::Instant t) {
  if (registers_.part < 2) return;
  const std::uint8_t six_bits = decode_characters(registers_.br)[registers_.part - 2U];
  if (six_bits == code::escape) {
    registers_.escape();
    raise_request(t);
    return;
  }
  if (six_bits == code::carriage_return) registers_.x = 0;
  if (six_bits == code::shift_in) registers_.shift_out = false;
  if (six_bits == code::shift_out) registers_.shift_out = true;
  path_ = path_of(six_bits, registers_.shift_out);
  stroke_ = 0;
  next_stroke(t);
}

// An edge raises its flag, but the character is drawn to its end (the behaviour of the real option is unknown).
template <class Sink>
void Display<Sink>::next_stroke(core::Instant t) {
  if (stroke_ < path_.size()) {
    registers_.shift_beam(path_[stroke_].direction);
    registers_.move = false;
    delays_.start(Delay::stroke_settle, t + timing::settle);
    return;
  }
  const bool last = registers_.part == 4;
  registers_.next_part();
  if (last) {
    raise_request(t);
  } else {
    start_intensify(t);
  }
}

template <class Sink>
void Display<Sink>::start_intensify(core::Instant t) {
  flash(t, registers_.move && registers_.br.bit(1));
  delays_.start(Delay::intensify, t + timing::intensify);
}

template <class Sink>
void Display<Sink>::flash(core::Instant t, bool lit) {
  if (!lit) return;
  if constexpr (Sink::consumes) {
    sink_->stroke({.time = t,
                   .x = registers_.x,
                   .y = registers_.y,
                   .intensity = registers_.intensity,
                   .address = word_address_});
  }
  if (pen_ && pen_->sees(registers_.x, registers_.y)) delays_.start(Delay::light, t + pen_->delay);
}

template <class Sink>
void Display<Sink>::raise_request(core::Instant t) {
  writing_ = false;  // else a request of IDRS under that of a deposit would never be met
  registers_.raise_request();
  request_ = {t, registers_.address, false, core::Word18{}};
}

template <class Sink>
void Display<Sink>::end_pass(core::Instant t) {
  if (!pass_open_) return;
  pass_open_ = false;
  ++counters_.passes_stopped;
  sink_->end_pass(t);
}

}  // namespace sightline::reference_display
