// The DEC Type 340 precision display: takes its words by data break and flashes the beam, pulse by pulse in time.
//
// All eight modes. Without its option a mode hangs the display, no request and no flag, until IDLA: 3 without the Type
// 342, 7 without the Type 347, and always 2 (the Type 343 is not built; its words decode in words.hpp). An IDLA while a
// word runs abandons the word cleanly; the real outcome is not defined. Left out: the tube, which the sink models.
//
// Pulse by pulse throughout: the shortcuts of the display in emulators/ are compared with this.
//
// Source: logic drawings as modelled pulse by pulse, confirmed by 501 display files; IOT actions from the PDP-7 Users
// Handbook and two Cambridge and DEC programs. Inferred, not confirmed: what IDCF and START leave standing, IDRD.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "emulators/core/state_visitor.hpp"
#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/type340/characters.hpp"
#include "emulators/type340/delays.hpp"
#include "emulators/type340/display.hpp"
#include "emulators/type340/registers.hpp"

namespace sightline::reference_display {
using namespace type340;

struct BreakRequest {
  core::Instant since;
  std::uint16_t address;  // 13 bits
  bool write;             // only for DDS of the Type 347
  core::Word18 word;      // to be written
};

// `Sink`: begin_pass(Instant), stroke(const Stroke&), end_pass(Instant); `consumes` false: single flashes are not wanted.
template <class Sink>
class Display {
 public:
  Display(Options options, Sink& sink) : options_(options), sink_(&sink) {}

  // What the PDP-7's IOTs do; each first brings the display up to `now`.
  void load_address_and_start(core::Instant now, core::Word18 ac) { start(now, ac.value()); }  // IDLA
  void restart(core::Instant now) { start(now, at(now).address); }                            // IDRD, at DAC
  void clear_flags(core::Instant now);  // IDCF and CAF: flags and a waiting request; a running word runs on
  void resume(core::Instant now);       // IDRS: clears pen flag, find and enable; the word goes on after 1 us
  void power_clear(core::Instant now);  // START key: everything stops; position, scale and intensity stay

  bool stop_interrupt(core::Instant now) { return at(now).stop_interrupt(); }
  bool vertical_edge(core::Instant now) { return at(now).vertical_edge; }
  bool horizontal_edge(core::Instant now) { return at(now).horizontal_edge; }
  bool light_pen_flag(core::Instant now) { return at(now).pen_flag; }
  core::Word18 address_counter(core::Instant now) { return core::Word18(at(now).address); }
  core::Word18 return_address(core::Instant now) { return core::Word18(at(now).return_address); }
  // X/2 in bits 0-8, Y/2 in bits 9-17, as IDRC reads them.
  core::Word18 coordinates(core::Instant now) {
    const Registers& r = at(now);
    return core::Word18((unsigned{r.x} >> 1U) << 9U | unsigned{r.y} >> 1U);
  }

  // No later than the instant at which the display, left alone, raises a request or changes its interrupt request;
  // never when it will not.
  [[nodiscard]] core::Instant deadline() const;
  // Everything up to and including `now` has happened. `now` must not go back.
  void advance(core::Instant now) {
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
    return registers_.pen_flag || registers_.edge() || registers_.stop_interrupt();
  }

  // From the last advance on; nullopt takes the pen away.
  void point_light_pen(std::optional<LightPen> pen);

  [[nodiscard]] const Counters& counters() const { return counters_; }
  // Indicator lights, as of the last advance.
  [[nodiscard]] const Registers& registers() const { return registers_; }
  // The next pulse inside, as of the last advance; never: none is under way.
  [[nodiscard]] core::Instant next_pulse() const { return delays_.next().at; }

  void visit_state(core::StateVisitor& visit);

 private:
  const Registers& at(core::Instant now) {
    advance(now);
    return registers_;
  }
  // `advance` when something runs.
  void catch_up(core::Instant now);
  void start(core::Instant now, std::uint32_t address);
  void fire(Delay delay, core::Instant t);
  // MOVE, after a count pulse.
  void note_motion(bool moved) { registers_.move = moved || (registers_.move && options_.flash_again); }
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

  Options options_;
  Sink* sink_;
  Registers registers_;
  Delays delays_;
  core::Word18 input_;              // the word at the inputs
  std::uint16_t word_address_ = 0;  // where it came from
  BreakRequest request_{};
  bool writing_ = false;
  bool pass_open_ = false;
  CharacterPath path_;
  std::size_t stroke_ = 0;
  std::optional<LightPen> pen_;
  Counters counters_;
};

}  // namespace sightline::reference_display

#include "tests/emulators/reference/type340/display_control.hpp"
#include "tests/emulators/reference/type340/display_sequence.hpp"
