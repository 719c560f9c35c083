// The DEC Type 340 precision display: takes its words by data break and flashes the beam, pulse by pulse in time.
//
// All eight modes. Without its option a mode hangs the display, no request and no flag, until IDLA: 3 without the Type
// 342, 7 without the Type 347, and always 2 (the Type 343 is not built; its words decode in words.hpp). An IDLA while a
// word runs abandons the word cleanly; the real outcome is not defined. Left out: the tube, which the sink models.
//
// Two shortcuts, both invisible. A word that nothing can disturb is done whole when time passes its end
// (display_word.hpp). Pulses without an effect outside are made at once (quiet_pulses.hpp). So a vector costs a
// handful of operations whatever its length, and a touch in mid-word still finds every register exact.
//
// Source: logic drawings as modelled pulse by pulse, confirmed by 501 display files; IOT actions from the PDP-7 Users
// Handbook and two Cambridge and DEC programs. Inferred, not confirmed: what IDCF and START leave standing, IDRD.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "../core/inline.hpp"
#include "../core/state_visitor.hpp"
#include "../core/stroke.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "characters.hpp"
#include "delays.hpp"
#include "quiet_pulses.hpp"
#include "registers.hpp"
#include "vector_flashes.hpp"

namespace sightline::type340 {

struct Options {
  bool subroutines_347 = false;
  bool characters_342 = false;
  // Pulses of a vector that do not move the beam flash the same spot again, once the word has moved it. As drawn; false:
  // only pulses that move flash.
  bool flash_again = true;
};

// The light pen of the Type 340 (Type 370): where it points, and how late it answers.
//
// The field of view is a rectangle in display points, which a test can state exactly; a real pen sees a disc of some
// forty points. A flash inside it gives one light pulse.
struct LightPen {
  std::uint16_t left = 0;  // points, all borders included
  std::uint16_t bottom = 0;
  std::uint16_t right = 0;
  std::uint16_t top = 0;
  // Beam on -> light pulse. Flashes come no closer than 1.5 us, and one pulse is under way at a time: a longer delay
  // is taken as 1.499 us, a negative one as 0.
  core::Duration delay{100};

  [[nodiscard]] constexpr bool sees(std::uint16_t x, std::uint16_t y) const {
    return left <= x && x <= right && bottom <= y && y <= top;
  }

  void visit_state(core::StateVisitor& visit) {
    visit("left", left);
    visit("bottom", bottom);
    visit("right", right);
    visit("top", top);
    visit("delay", delay);
    visit.require(delay < timing::pulse, "delay", "less than 1500");
  }
};

// What a Type 340 counts for reports: words, passes, and when the last passes began.
struct Counters {
  std::uint64_t words = 0;           // display words taken
  std::uint64_t passes_started = 0;  // IDLA and IDRD
  std::uint64_t passes_stopped = 0;  // by a stop word, or by an edge in vector or increment mode
  std::uint64_t stop_codes = 0;      // words with STOP that ended a pass
  std::uint64_t edges = 0;           // that ended a pass, in vector or increment mode
  std::uint64_t characters_met = 0;  // words of mode 3 without the Type 342: the display waits for ever
  std::uint64_t subroutines_met = 0;  // words of mode 7 without the Type 347, likewise
  core::Instant last_start = core::never;      // never: none yet
  core::Instant previous_start = core::never;  // the one before
};

struct BreakRequest {
  core::Instant since;
  std::uint16_t address;  // 13 bits
  bool write;             // only for DDS of the Type 347
  core::Word18 word;      // to be written
};

template <class Sink = core::NoStrokes>
class Display {
 public:
  Display(Options options, Sink& sink) : options_(options), sink_(&sink) {}

  // What the PDP-7's IOTs do; each first brings the display up to `now`.
  void load_address_and_start(core::Instant now, core::Word18 ac) { start(now, ac.value()); }  // IDLA
  void restart(core::Instant now) { start(now, registers_.address); }                          // IDRD, at DAC
  void clear_flags(core::Instant now);  // IDCF and CAF: flags and a waiting request; a running word runs on
  void resume(core::Instant now);       // IDRS: clears pen flag, find and enable; the word goes on after 1 us
  void power_clear(core::Instant now);  // START key: everything stops; position, scale and intensity stay

  bool stop_interrupt(core::Instant now) { return flags_at(now).stop_interrupt(); }
  bool vertical_edge(core::Instant now) { return flags_at(now).vertical_edge; }
  bool horizontal_edge(core::Instant now) { return flags_at(now).horizontal_edge; }
  bool light_pen_flag(core::Instant now) { return flags_at(now).pen_flag; }
  core::Word18 address_counter(core::Instant now) { return core::Word18(flags_at(now).address); }
  core::Word18 return_address(core::Instant now) { return core::Word18(flags_at(now).return_address); }
  // X/2 in bits 0-8, Y/2 in bits 9-17, as IDRC reads them.
  core::Word18 coordinates(core::Instant now) {
    const Registers& r = at(now);
    return core::Word18((unsigned{r.x} >> 1U) << 9U | unsigned{r.y} >> 1U);
  }

  // No later than the instant at which the display, left alone, raises a request or changes its interrupt request;
  // never when it will not.
  [[nodiscard]] core::Instant deadline() const {
    if (whole_) return whole_until_;
    if (planned_) return quiet_until_;
    return deadline_of_delays();
  }
  // Everything up to and including `now` has happened. `now` must not go back.
  void advance(core::Instant now) {
    if (whole_ && now >= whole_until_) {
      whole_ = false;
      do_whole_word();
    }
    if (!delays_.none()) catch_up(now);
  }
  // As of the last advance; nullptr: none.
  [[nodiscard]] const BreakRequest* break_request() const {
    return registers_.request || writing_ ? &request_ : nullptr;
  }
  // The word is at the inputs; ignored when no read request is up.
  void deliver(core::Instant at, core::Word18 word);
  // The write is done; ignored when no write request is up.
  void deposited(core::Instant at);
  // As of the last advance.
  [[nodiscard]] bool interrupt_request() const {
    if (whole_) return false;  // such a word begins without flags
    return registers_.pen_flag || registers_.edge() || registers_.stop_interrupt();
  }

  // From the last advance on; nullopt takes the pen away.
  void point_light_pen(std::optional<LightPen> pen);

  [[nodiscard]] const Counters& counters() const { return counters_; }
  // Where the last pass began; 0 before the first.
  [[nodiscard]] std::uint16_t start_address() const { return start_address_; }
  // Indicator lights, as of the last advance.
  [[nodiscard]] const Registers& registers() const { return registers_; }
  // The next pulse inside, as of the last advance; never: none is under way.
  [[nodiscard]] core::Instant next_pulse() const { return delays_.next().at; }

  // The shortcuts are not visited: without them the same pulses are made one by one.
  void visit_state(core::StateVisitor& visit);

 private:
  const Registers& at(core::Instant now) {
    advance(now);
    return registers_;
  }
  // Flags and addresses do not change while a word runs that is to be done whole.
  const Registers& flags_at(core::Instant now) { return whole_ && now < whole_until_ ? registers_ : at(now); }
  void touch(core::Instant now) {
    advance(now);
    planned_ = false;
  }
  [[nodiscard]] core::Instant deadline_of_delays() const;
  // `advance` when something runs; a word to be done whole has its strobe running.
  void catch_up(core::Instant now);
  void start(core::Instant now, std::uint32_t address);
  void fire(Delay delay, core::Instant t);
  void plan_word(core::Instant at);
  static constexpr core::Duration not_whole{-1};
  [[nodiscard]] SIGHTLINE_INLINE core::Duration time_of_whole_word();
  void do_whole_word();
  void do_pulses(int count);
  void draw_vector(VectorWord w);
  void last_pulse();
  // MOVE, after a count pulse.
  void note_motion(bool moved) { registers_.move = moved || (registers_.move && options_.flash_again); }
  void plan();
  void skip(core::Instant now);
  void operate(core::Instant t);
  void operate_parameter(core::Instant t);
  void operate_point(core::Instant t);
  void operate_subroutine(core::Instant t);
  void operate_character(core::Instant t);
  void count(core::Instant t);
  void end_word(core::Instant t);
  void settled(core::Instant t);
  void next_stroke(core::Instant t);
  void start_intensify(core::Instant t);
  void flash(core::Instant t, bool lit);
  void raise_request(core::Instant t);
  void end_pass(core::Instant t);
  [[nodiscard]] bool counts_pulses() const {
    return registers_.mode == Mode::vector || registers_.mode == Mode::vector_continue ||
           registers_.mode == Mode::increment;
  }
  // A vector of (0, 0) flashes nothing: MOVE stays 0. Vector continue of it never ends, and must not cost a step a pulse.
  [[nodiscard]] bool word_may_flash() const {
    constexpr core::Word18 magnitudes(0077577);
    const bool may_move = registers_.mode == Mode::increment || (registers_.br & magnitudes) != core::Word18{};
    return registers_.br.bit(1) && (registers_.move || may_move);
  }

  Options options_;
  Sink* sink_;
  Registers registers_;
  Delays delays_;
  core::Word18 input_;              // the word at the inputs
  std::uint16_t word_address_ = 0;  // where it came from
  std::uint16_t start_address_ = 0;
  BreakRequest request_{};
  bool writing_ = false;
  bool pass_open_ = false;
  CharacterPath path_;
  std::size_t stroke_ = 0;
  std::optional<LightPen> pen_;
  bool whole_ = false;           // the word at the inputs will run undisturbed until whole_until_
  core::Instant whole_until_{};  // its request, or its stop
  Registers::End end_{};         // where it leads, if it is a vector
  bool planned_ = false;         // no pulse before quiet_until_ matters to anyone outside
  core::Instant quiet_until_{};  // the pulse that does
  Counters counters_;
};

}  // namespace sightline::type340

#include "display_control.hpp"
#include "display_sequence.hpp"
#include "display_word.hpp"
