// The Type 340: its IOTs and data breaks, words executed as a whole, and the pulses from a word in BR to the request for
// the next.
#include "display.hpp"

#include <algorithm>
#include <bit>

namespace sightline::type340 {

Display::Display(const core::IotDeviceSetup& setup)
    : Display({.subroutines_347 = setup.value(info, "347") != 0,
               .characters_342 = setup.value(info, "342") != 0,
               .flash_again = setup.value(info, "flash-again") != 0},
              setup.strokes) {}

// --- IOTs
//
//   700501 IDVE  700504 IDRS  700512 IDRA  700601 IDSI  700606 IDLA  700614 IDRD
//   700701 IDSP  700704 IDCF  700712 IDRC  701001 IDHE  701012 (347: return address)
// Pulse 1 skips, 2 reads, 4 acts, in this order. On device 06 pulse 2 clears the address counter and 4 ORs AC into it and
// starts, so 606 loads, and 614 (which clears AC first) starts at the current address. Pulse 2 of device 06 alone is no
// instruction of the display and is unanswered. Source: Type 340 programs of the Cambridge CAD Group (1972); inferred:
// IDRD.

void Display::iot(core::Instant now, std::uint32_t word, core::IotReply& reply) {
  const bool reads = (word & 02U) != 0;
  const bool acts = (word & 04U) != 0;
  switch ((word >> 6) & 077U) {
    case 005:
      reply.test(word, vertical_edge(now));
      if (reads) reply.collect(address_counter(now));
      if (acts) resume(now);
      reply.answered |= word & 06U;
      break;
    case 006:
      reply.test(word, stop_interrupt(now));
      if (!acts) {
        if (registers_.stop && !registers_.stop_interrupt()) ++counters_.asked_in_vain;
        break;
      }
      if (!reads && (address_counter(now).value() & ~reply.ac.value() & Registers::address_mask) != 0 && reply.ac.value() != 0)
        ++counters_.starts_ored;
      start(now, (reads ? reply.ac : reply.ac | address_counter(now)).value());
      reply.answered |= word & 06U;
      break;
    case 007:
      reply.test(word, light_pen_flag(now));
      if (reads) reply.collect(coordinates(now));
      if (acts) clear_flags(now);
      reply.answered |= word & 06U;
      break;
    default:
      reply.test(word, horizontal_edge(now));
      if (reads) reply.collect(return_address(now));
      reply.answered |= word & 02U;
      break;
  }
}

core::Word18 Display::coordinates(core::Instant now) {
  advance(now);
  return core::Word18((unsigned{registers_.x} >> 1U) << 9U | unsigned{registers_.y} >> 1U);
}

void Display::start(core::Instant now, std::uint32_t address) {
  advance(now);
  delays_.stop_all();
  registers_.initiate(static_cast<std::uint16_t>(address & Registers::address_mask));
  pass_open_ = true;
  start_address_ = registers_.address;
  ++counters_.passes_started;
  counters_.asked_in_vain = 0;
  counters_.previous_start = counters_.last_start;
  counters_.last_start = now;
  strokes_.begin_pass(now);
  raise_request(now);
}

void Display::clear_flags(core::Instant now) {
  advance(now);
  registers_.clear_flags();
  writing_ = false;
}

void Display::resume(core::Instant now) {
  advance(now);
  registers_.resume();
  if (registers_.mode != Mode::character) delays_.start(Delay::settle, now + timing::settle);
}

void Display::power_clear(core::Instant now) {
  advance(now);
  delays_.stop_all();
  writing_ = false;
  pass_open_ = false;
  Registers clear;
  clear.x = registers_.x;
  clear.y = registers_.y;
  clear.scale = registers_.scale;
  clear.intensity = registers_.intensity;
  clear.address = registers_.address;
  clear.return_address = registers_.return_address;
  registers_ = clear;
}

// --- Data breaks

void Display::end_break(core::Instant end, core::Word18 word) {
  const bool written = writing_;
  advance(end);  // a point that IDRS cut short may raise its request before the word is written
  if (written) {
    if (writing_) raise_request(end);
  } else if (registers_.request) {
    deliver(end, word);
  }
}

// The word is at the inputs.
void Display::deliver(core::Instant at, core::Word18 word) {
  ++counters_.words;
  input_ = word;
  word_address_ = registers_.address;
  const bool alone = delays_.none() && !registers_.pen_or_stop();
  registers_.clear_for_word();
  if (alone) {
    const core::Duration time = time_of_whole_word();
    whole_ = time != not_whole;
    whole_until_ = at + timing::strobe + timing::intensify + time;
  }
  delays_.start(Delay::strobe, at + timing::strobe);
}

// A new request replaces one of DDS.
void Display::raise_request(core::Instant t) {
  writing_ = false;
  registers_.raise_request();
  request_ = {.direction = core::DataBreak::Direction::from_core, .address = registers_.address};
  request_since_ = t;
}

// --- Host

void Display::point_light_pen(std::optional<LightPen> pen) {
  constexpr core::Duration longest = timing::pulse - core::Duration(1);
  if (pen) pen->delay = std::clamp(pen->delay, core::Duration(0), longest);
  pen_ = pen;
  whole_ = false;
}

std::vector<core::Count> Display::counts() const {
  return {{"words", counters_.words},
          {"passes_started", counters_.passes_started},
          {"passes_stopped", counters_.passes_stopped},
          {"stop_codes", counters_.stop_codes},
          {"edges", counters_.edges},
          {"characters_met", counters_.characters_met},
          {"subroutines_met", counters_.subroutines_met}};
}

void Display::visit_state(core::StateVisitor& visit) {
  using enum core::DataBreak::Direction;
  if (visit.restores()) whole_ = false;
  visit.part("registers", registers_);
  visit.part("delays", delays_);
  visit("input", input_);
  visit("word_address", word_address_, Registers::address_mask);
  visit("start_address", start_address_, Registers::address_mask);
  visit("request_since", request_since_);
  visit("request_address", request_.address, Registers::address_mask);
  bool writes = request_.direction == to_core;
  visit("request_write", writes);
  request_.direction = writes ? to_core : from_core;
  visit("request_word", request_.word);
  visit("writing", writing_);
  visit("pass_open", pass_open_);
  visit.part("path", path_);
  visit.count("stroke", stroke_, path_.size());
  visit.present("pen", pen_, [&visit](LightPen& pen) { pen.visit_state(visit); });
  visit("words", counters_.words);
  visit("passes_started", counters_.passes_started);
  visit("passes_stopped", counters_.passes_stopped);
  visit("stop_codes", counters_.stop_codes);
  visit("edges", counters_.edges);
  visit("characters_met", counters_.characters_met);
  visit("subroutines_met", counters_.subroutines_met);
  visit("asked_in_vain", counters_.asked_in_vain);
  visit("starts_ored", counters_.starts_ored);
  visit("last_start", counters_.last_start);
  visit("previous_start", counters_.previous_start);
  const bool draws_stroke = delays_.runs(Delay::stroke_settle) || delays_.runs(Delay::stroke_flash);
  visit.require(!draws_stroke || stroke_ < path_.size(), "stroke", "one of the character");
  visit.require(data_break() == nullptr || writes == writing_, "request_write", "the same as writing");
}

void Display::require_time(core::StateVisitor& visit, core::Instant now) {
  visit.require(next_pulse() > now, info.name, "all pulses after the time");
}

// --- Words executed as a whole
//
// When a word arrives while nothing else is in progress, no flag is about to change and no pen can see it, its result and
// its end are known at once. If time passes that end before the display is accessed, only the result is computed. All other
// words are executed pulse by pulse. Flashes are the same either way.

// The time of the word at the inputs, beyond strobe and first intensify; not_whole if it may reach an edge, be seen by the
// pen, or never end.
core::Duration Display::time_of_whole_word() {
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

// The time is whole_until_. No pulse has come since the word was delivered, so the registers that each word clears are
// clear, and no pen is about to stop it.
void Display::execute_whole_word() {
  whole_ = false;
  delays_.stop_all();
  registers_.br = input_;
  switch (registers_.mode) {
    case Mode::parameter: operate_parameter(whole_until_); break;
    case Mode::point: {
      const PointWord w = decode_point(input_);
      registers_.mode = w.next;
      registers_.set_pen_enable(w.pen);
      (w.y ? registers_.y : registers_.x) = w.coordinate;
      if (w.intensify) flash(whole_until_ - timing::intensify, true);
      raise_request(whole_until_);
      break;
    }
    case Mode::vector: draw_vector(decode_vector(input_)); break;
    default: {  // increment: no other mode is executed as a whole
      registers_.part = 1;
      core::Instant t = whole_until_ - 4 * timing::pulse + timing::settle;
      for (int i = 0; i < 4; ++i, t += timing::pulse) {
        note_motion(registers_.count());
        flash(t, registers_.move && registers_.br.bit(1));
      }
      count(whole_until_);
    }
  }
}

// Each pulse turns on one stage of the rate multiplier, which passes its bit of dx and dy (vector_generator.hpp).
void Display::draw_vector(VectorWord w) {
  if (w.intensify && strokes_.wanted()) {
    const auto d = static_cast<std::uint8_t>(w.dx | w.dy);
    const auto count = static_cast<unsigned>(pulses_of_vector(w.dx, w.dy));
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
    for (unsigned n = 1; n <= count; ++n, flash.time += timing::pulse) {
      const auto stage = static_cast<unsigned>(std::countr_zero(n));
      const auto move_x = static_cast<std::int32_t>(steps_x >> stage & 1U);
      const auto move_y = static_cast<std::int32_t>(steps_y >> stage & 1U);
      flash.x = static_cast<std::uint16_t>(flash.x + (right & -move_x));
      flash.y = static_cast<std::uint16_t>(flash.y + (up & -move_y));
      note_motion((move_x | move_y) != 0);
      if (registers_.move) strokes_.put(flash);
    }
  }
  registers_.x = static_cast<std::uint16_t>(end_.x);
  registers_.y = static_cast<std::uint16_t>(end_.y);
  // The last pulse toggles the full rate multiplier back to 0 and moves nothing.
  registers_.move = options_.flash_again && (w.dx | w.dy) != 0;
  registers_.halt = true;
  end_word(whole_until_);
}

// --- Pulses

// Fixed delays follow between a delay and its visible effect, unless a flag is about to rise or fall with it.
core::Instant Display::deadline_of_delays() const {
  if (counts_for_ever()) return core::never;
  const auto effect = [this](Delay d, bool at_once) {
    const core::Instant t = delays_.at(d);
    return t == core::never || at_once ? t : t + timing::intensify;
  };
  const bool flag_at_strobe = registers_.stop || registers_.pen_will_stop() || delays_.runs(Delay::light);
  return std::min({effect(Delay::strobe, flag_at_strobe), effect(Delay::settle, registers_.edge()),
                   effect(Delay::intensify, true), effect(Delay::deflection, false),
                   effect(Delay::point_flash, true), effect(Delay::stroke_settle, false),
                   effect(Delay::stroke_flash, true)});
}

// Makes all pulses up to `now`, one by one; the strobe of a word that was to be executed as a whole is running.
void Display::make_pulses(core::Instant now) {
  // Keeps sums of delays within the clock's range.
  constexpr core::Instant latest = core::never - core::milliseconds(1);
  now = std::min(now, latest);
  whole_ = false;
  while (!delays_.none()) {
    Delays::Next next = delays_.next();
    if (next.at > now) return;
    if (counts_for_ever()) {
      // Eight pulses take the rate multiplier through one turn and change nothing. They are skipped, so that hours of them
      // cost no more than microseconds.
      constexpr core::Duration turn = 8 * timing::pulse;
      next.at += (now - next.at) / turn * turn;
    }
    delays_.stop(next.delay);
    fire(next.delay, next.at);
  }
}

// During the pulses of a vector continue of (0, 0), which reaches no edge and flashes nothing.
bool Display::counts_for_ever() const {
  constexpr core::Word18 magnitudes(0077577);
  const Registers& r = registers_;
  return r.mode == Mode::vector_continue && (r.br & magnitudes) == core::Word18{} &&
         (delays_.only(Delay::settle) || delays_.only(Delay::intensify)) &&
         !(r.halt || r.move || r.request || r.edge() || r.pen_flag || r.pen_will_stop());
}

void Display::fire(Delay delay, core::Instant t) {
  switch (delay) {
    case Delay::light: registers_.pen_find = registers_.pen_find || registers_.pen_enable; break;
    case Delay::load_x: registers_.x = decode_point(registers_.br).coordinate | registers_.x; break;
    case Delay::load_y: registers_.y = decode_point(registers_.br).coordinate | registers_.y; break;
    case Delay::strobe:
      registers_.strobe(input_);
      start_intensify(t);
      break;
    case Delay::settle: continue_word(t); break;
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

void Display::operate(core::Instant t) {
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

void Display::operate_parameter(core::Instant t) {
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

// Only a dark Y word skips the deflection time.
void Display::operate_point(core::Instant t) {
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

// A jump takes the time of a parameter word; a deposit takes that and its write break (inferred).
void Display::operate_subroutine(core::Instant t) {
  constexpr std::uint32_t jump = 0400000;
  const SubroutineWord w = decode_subroutine(registers_.br);
  registers_.mode = w.next;
  switch (w.operation) {
    case SubroutineOperation::none: break;
    case SubroutineOperation::deposit:
      registers_.save = false;
      writing_ = true;
      request_ = {core::DataBreak::Direction::to_core, w.address, core::Word18(jump | registers_.return_address)};
      request_since_ = t;
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

void Display::count(core::Instant t) {
  const bool last = registers_.halt;
  note_motion(registers_.count());
  if (!last) {
    delays_.start(Delay::settle, t + timing::settle);
    return;
  }
  end_word(t);
}

// Sets MOVE after a count pulse.
void Display::note_motion(bool moved) { registers_.move = moved || (registers_.move && options_.flash_again); }

// Ends a vector or increment word.
void Display::end_word(core::Instant t) {
  if (registers_.br.bit(0)) registers_.escape();
  raise_request(t);
}

// The beam has settled after a count pulse, or IDRS resumes the word.
void Display::continue_word(core::Instant t) {
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

void Display::operate_character(core::Instant t) {
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
void Display::next_stroke(core::Instant t) {
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

void Display::start_intensify(core::Instant t) {
  flash(t, registers_.move && registers_.br.bit(1));
  delays_.start(Delay::intensify, t + timing::intensify);
}

void Display::flash(core::Instant t, bool lit) {
  if (!lit) return;
  if (strokes_.wanted()) {
    strokes_.put({.time = t,
                  .x = registers_.x,
                  .y = registers_.y,
                  .intensity = registers_.intensity,
                  .address = word_address_});
  }
  if (pen_ && pen_->sees(registers_.x, registers_.y)) delays_.start(Delay::light, t + pen_->delay);
}

void Display::end_pass(core::Instant t) {
  if (!pass_open_) return;
  pass_open_ = false;
  ++counters_.passes_stopped;
  strokes_.end_pass(t);
}

}  // namespace sightline::type340
