// Registers and flip-flops of the Type 340, and the effect of one pulse on them. Timing is in display.hpp.
//
// Flip-flops known to programs have the names of the drawings (STOP, HEF, VEF, FIND, LP FLAG, MOVE, HALT, RFD). The Type
// 347 adds ASR and SAVE, the Type 342 the shift of the character set.
//
// Source: logic drawings as modelled pulse by pulse, confirmed by 501 display files; the Type 347 from DEC's listing
// symbols and a Cambridge program of 1972 (DDS clearing SAVE is inferred from that program).
#pragma once

#include <cstdint>
#include <optional>

#include "../core/state_visitor.hpp"
#include "../core/word.hpp"
#include "vector_generator.hpp"
#include "words.hpp"

namespace sightline::type340 {

struct Registers {
  static constexpr std::uint16_t address_mask = 017777;
  static constexpr std::uint16_t screen_mask = 01777;

  core::Word18 br;  // buffer: the current word
  Mode mode = Mode::parameter;
  std::uint16_t x = 0;  // points, 0..1023
  std::uint16_t y = 0;
  std::uint8_t scale = 0;      // 0..3, a step is 1 << scale points
  std::uint8_t intensity = 0;  // 0..7
  // The registers that each word clears are adjacent, so that few stores clear them.
  RateMultiplier rate;
  std::uint8_t part = 0;  // increment: move 1-4; characters: 2-4; 0 none
  bool halt = false;      // the next count pulse ends the word
  bool move = false;      // the word has moved the beam
  bool request = false;   // RFD, request for data
  bool vertical_edge = false;
  bool horizontal_edge = false;
  bool stop = false;
  bool pen_enable = false;
  bool pen_find = false;  // light was seen
  bool pen_flag = false;
  std::uint16_t address = 0;         // DAC, 13 bits
  std::uint16_t return_address = 0;  // ASR, 13 bits
  bool save = false;                 // an escape returns to ASR
  bool shift_out = false;            // second character set

  [[nodiscard]] bool edge() const { return vertical_edge || horizontal_edge; }
  [[nodiscard]] bool stop_interrupt() const { return stop && br.bit(8); }
  [[nodiscard]] bool pen_will_stop() const { return pen_enable && pen_find; }
  // A word that arrives now may not run to its end undisturbed. Branch-free, because there are millions of words.
  [[nodiscard]] bool pen_or_stop() const { return (unsigned{stop} | unsigned{pen_flag} | (unsigned{pen_enable} & unsigned{pen_find})) != 0; }
  [[nodiscard]] std::uint16_t step() const { return static_cast<std::uint16_t>(1U << scale); }

  void clear_edges() { vertical_edge = horizontal_edge = false; }

  // Mode 0; with SAVE set, the one-level return of the Type 347.
  void escape() {
    mode = Mode::parameter;
    pen_find = false;
    if (save) {
      address = return_address;
      save = false;
    }
  }

  void raise_request() {
    request = true;
    clear_edges();
  }

  // IDLA: initialises everything except position, scale, intensity and the buffer.
  void initiate(std::uint16_t start) {
    save = false;
    escape();
    pen_enable = pen_flag = stop = shift_out = false;
    address = start & address_mask;
    raise_request();
  }

  void clear_flags() {
    stop = request = pen_flag = false;
    clear_edges();
  }

  void resume() { pen_flag = pen_find = pen_enable = false; }

  // A word arrives: clears for it and increments DAC.
  void clear_for_word() {
    br = core::Word18{};
    rate.brm = 0;
    part = 0;
    halt = move = request = false;
    clear_edges();
    address = (address + 1U) & address_mask;
  }

  void strobe(core::Word18 word) {
    br = br | word;
    if (mode == Mode::increment) part = 1;
    if (mode == Mode::character) part = 2;
    test_pen();
  }

  // FIND is copied to LP FLAG at a word load or a count of Y.
  void test_pen() { pen_flag = pen_flag || pen_will_stop(); }

  void next_part() { part = part == 0 || part == 4 ? 0 : static_cast<std::uint8_t>(part + 1U); }

  void set_pen_enable(std::optional<bool> enable) { pen_enable = enable.value_or(pen_enable); }

  // Moves the beam one step; running off an edge wraps and raises its flag.
  void shift_beam(Direction d) {
    horizontal_edge = shift(x, d.x) || horizontal_edge;
    vertical_edge = shift(y, d.y) || vertical_edge;
    test_pen();
  }

  // Count pulse of a vector or increment word. Returns whether it made a step.
  bool count() {
    const VectorWord w = decode_vector(br);
    const RateMultiplier::Step step_now = rate.count(w.dx, w.dy);
    Direction d;
    if (mode == Mode::increment) {
      if (part != 0) d = decode_increment(br).moves[part - 1U];
      if (part == 4) halt = true;
      next_part();
    } else {
      if (step_now.x) d.x = w.left ? -1 : 1;
      if (step_now.y) d.y = w.down ? -1 : 1;
    }
    shift_beam(d);
    return d.moves();
  }

  // The end point of a vector, or that it is beyond the screen.
  struct End {
    unsigned x;
    unsigned y;
    [[nodiscard]] constexpr bool is_on_screen() const { return (x | y) <= screen_mask; }
  };
  [[nodiscard]] constexpr End end_of(VectorWord w) const {
    const auto end = [this](unsigned from, bool negative, unsigned steps) {
      const unsigned way = steps << scale;
      return negative ? from - way : from + way;
    };
    return {end(x, w.left, w.dx), end(y, w.down, w.dy)};
  }

  void visit_state(core::StateVisitor& visit) {
    visit("br", br);
    visit("mode", mode, Mode::subroutine);
    visit("x", x, screen_mask);
    visit("y", y, screen_mask);
    visit("scale", scale, std::uint8_t{3});
    visit("intensity", intensity, std::uint8_t{7});
    visit("brm", rate.brm, RateMultiplier::full);
    visit("part", part, std::uint8_t{4});
    visit("halt", halt);
    visit("move", move);
    visit("stop", stop);
    visit("request", request);
    visit("vertical_edge", vertical_edge);
    visit("horizontal_edge", horizontal_edge);
    visit("pen_enable", pen_enable);
    visit("pen_find", pen_find);
    visit("pen_flag", pen_flag);
    visit("address", address, address_mask);
    visit("return_address", return_address, address_mask);
    visit("save", save);
    visit("shift_out", shift_out);
  }

  friend bool operator==(const Registers&, const Registers&) = default;

 private:
  [[nodiscard]] bool shift(std::uint16_t& coordinate, int direction) const {
    const int moved = coordinate + direction * step();
    coordinate = static_cast<std::uint16_t>(moved) & screen_mask;
    return moved != coordinate;
  }
};

}  // namespace sightline::type340
