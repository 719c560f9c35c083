// The 8255 programmable peripheral interface: three ports of eight lines in two groups.
//
// Mode 0 on all ports, the mode 1 handshakes for input and output on ports A and B, mode 2 on port A, and the bit set/reset
// word, which in modes 1 and 2 also sets the interrupt enables. Reading port C gives the levels of its lines; the bit of a
// handshake input (STB#, ACK#) reads as the interrupt enable that shares it. After reset all ports are inputs of mode 0.
// Setting a mode clears all output latches and handshakes.
//
//   line     7     6     5     4     3      2     1     0
//   A in                IBF   STB#  INTR    STB#  IBF   INTR    B in
//   A out    OBF#  ACK#             INTR    ACK#  OBF#  INTR    B out
//   A mode 2 OBF#  ACK#  IBF   STB#  INTR
//
// The outside drives the chip by edges: strobe_falls() and strobe_rises(), acknowledge_falls() and acknowledge_rises(), and
// by the levels on lines that are inputs of mode 0. The chip itself has no delays; the device connected to it has them.
// Reading the control word gives FFh; the data sheet forbids it. Source: Intel's 8255A data sheet.
#pragma once

#include <array>
#include <cstdint>

#include "../core/state_visitor.hpp"

namespace sightline::devices {

class I8255 {
 public:
  enum class Port : std::uint8_t { a, b };

  // Address 0 A, 1 B, 2 C, 3 control.
  [[nodiscard]] std::uint8_t read(std::uint8_t address) {
    switch (address & 3U) {
      case 0: return read_port(a_);
      case 1: return read_port(b_);
      case 2: return read_c();
      default: return 0xFF;
    }
  }

  void write(std::uint8_t address, std::uint8_t value) {
    switch (address & 3U) {
      case 0: write_port(a_, value); break;
      case 1: write_port(b_, value); break;
      case 2: c_latch_ = value; break;
      default: (value & 0x80U) != 0 ? set_mode(value) : set_bit(value); break;
    }
  }

  void reset() { set_mode(0x9B); }

  // The outside, ports A and B.
  // STB#: latches `value` and raises IBF. An edge in a mode without it does nothing.
  void strobe_falls(Port port, std::uint8_t value) {
    Side& side = side_of(port);
    if (!side.strobed_input) return;
    side.in_latch = value;
    side.full = true;
    side.strobe_low = true;
  }
  void strobe_rises(Port port) { side_of(port).strobe_low = false; }
  // ACK#: the outside reads the output latch; OBF# rises.
  std::uint8_t acknowledge_falls(Port port) {
    Side& side = side_of(port);
    side.pending = false;
    side.acknowledge_low = true;
    return side.out_latch;
  }
  void acknowledge_rises(Port port) { side_of(port).acknowledge_low = false; }
  // The levels that the outside puts on lines that are inputs.
  void set_levels(Port port, std::uint8_t levels) { side_of(port).levels = levels; }
  void set_levels_c(std::uint8_t levels) { c_levels_ = levels; }

  // The lines as seen from outside. A line that is not driven is high.
  [[nodiscard]] bool input_buffer_full(Port port) const {
    const Side& side = side_of(port);
    return side.strobed_input ? side.full : true;
  }
  [[nodiscard]] bool output_buffer_full(Port port) const { return side_of(port).pending; }
  [[nodiscard]] bool strobed_input(Port port) const { return side_of(port).strobed_input; }
  [[nodiscard]] std::uint8_t lines(Port port) const {
    const Side& side = side_of(port);
    return side.drives ? side.out_latch : std::uint8_t{0xFF};
  }
  [[nodiscard]] std::uint8_t lines_c() const {
    return static_cast<std::uint8_t>((c_value(false) & driven_c()) | static_cast<std::uint8_t>(~driven_c()));
  }
  [[nodiscard]] bool interrupt(Port port) const {
    const Side& side = side_of(port);
    return (side.strobed_input && side.full && !side.strobe_low && side.input_enable) ||
           (side.strobed_output && !side.pending && !side.acknowledge_low && side.output_enable);
  }

  void visit_state(core::StateVisitor& visit) {
    visit.part("a", a_);
    visit.part("b", b_);
    visit("c_latch", c_latch_);
    visit("c_levels", c_levels_);
    visit("c_inputs", c_inputs_);
  }

 private:
  struct Side {
    // As set by the mode word.
    bool drives = false;          // output of mode 0 or 1
    bool strobed_input = false;   // mode 1 in, mode 2
    bool strobed_output = false;  // mode 1 out, mode 2
    // Latches and handshake.
    std::uint8_t out_latch = 0;
    std::uint8_t in_latch = 0;
    std::uint8_t levels = 0xFF;
    bool full = false;     // IBF
    bool pending = false;  // not OBF#
    bool strobe_low = false;
    bool acknowledge_low = false;
    bool input_enable = false;
    bool output_enable = false;

    void visit_state(core::StateVisitor& visit) {
      visit("drives", drives);
      visit("strobed_input", strobed_input);
      visit("strobed_output", strobed_output);
      visit("out_latch", out_latch);
      visit("in_latch", in_latch);
      visit("levels", levels);
      visit("full", full);
      visit("pending", pending);
      visit("strobe_low", strobe_low);
      visit("acknowledge_low", acknowledge_low);
      visit("input_enable", input_enable);
      visit("output_enable", output_enable);
    }
  };

  [[nodiscard]] Side& side_of(Port port) { return port == Port::a ? a_ : b_; }
  [[nodiscard]] const Side& side_of(Port port) const { return port == Port::a ? a_ : b_; }

  static std::uint8_t read_port(Side& side) {
    if (side.strobed_input) {
      side.full = false;
      return side.in_latch;
    }
    return side.drives ? side.out_latch : side.levels;
  }

  static void write_port(Side& side, std::uint8_t value) {
    side.out_latch = value;
    if (side.strobed_output) side.pending = true;
  }

  static Side make_side(const Side& before, unsigned mode, bool input) {
    Side side;
    side.levels = before.levels;
    side.strobed_input = mode == 2 || (mode == 1 && input);
    side.strobed_output = mode == 2 || (mode == 1 && !input);
    side.drives = mode != 2 && !input;
    return side;
  }

  void set_mode(std::uint8_t word) {
    const unsigned mode_a = (word & 0x40U) != 0 ? 2U : (word >> 5 & 1U);
    a_ = make_side(a_, mode_a, (word & 0x10U) != 0);
    b_ = make_side(b_, word >> 2 & 1U, (word & 0x02U) != 0);
    c_latch_ = 0;
    c_inputs_ =
        static_cast<std::uint8_t>(((word & 0x08U) != 0 ? 0xF0U : 0U) | ((word & 0x01U) != 0 ? 0x0FU : 0U));
  }

  void set_bit(std::uint8_t word) {
    const unsigned number = word >> 1 & 7U;
    const bool value = (word & 1U) != 0;
    if (number == 4 && a_.strobed_input) a_.input_enable = value;
    if (number == 6 && a_.strobed_output) a_.output_enable = value;
    if (number == 2 && b_.strobed_input) b_.input_enable = value;
    if (number == 2 && b_.strobed_output) b_.output_enable = value;
    const unsigned bit = 1U << number;
    c_latch_ = static_cast<std::uint8_t>(value ? c_latch_ | bit : c_latch_ & ~bit);
  }

  // Lines of port C that belong to a handshake.
  [[nodiscard]] unsigned handshake_lines() const {
    unsigned lines = 0;
    if (a_.strobed_input) lines |= 0x38U;
    if (a_.strobed_output) lines |= 0xC8U;
    if (b_.strobed_input || b_.strobed_output) lines |= 0x07U;
    return lines;
  }
  // Lines of port C the chip drives.
  [[nodiscard]] unsigned driven_c() const {
    unsigned driven = ~unsigned{c_inputs_} & ~handshake_lines() & 0xFFU;
    if (a_.strobed_input) driven |= 0x28U;
    if (a_.strobed_output) driven |= 0x88U;
    if (b_.strobed_input || b_.strobed_output) driven |= 0x03U;
    return driven;
  }

  // Levels of port C; with `enables`, the places of STB# and ACK# show the interrupt enables.
  [[nodiscard]] unsigned c_value(bool enables) const {
    unsigned value = (c_latch_ & ~unsigned{c_inputs_}) | (c_levels_ & unsigned{c_inputs_});
    value &= ~handshake_lines();
    const auto line = [&value](bool high, unsigned number) { value |= unsigned{high} << number; };
    if (a_.strobed_input) {
      line(a_.full, 5);
      line(enables && a_.input_enable, 4);
    }
    if (a_.strobed_output) {
      line(!a_.pending, 7);
      line(enables && a_.output_enable, 6);
    }
    if (a_.strobed_input || a_.strobed_output) line(interrupt(Port::a), 3);
    if (b_.strobed_input || b_.strobed_output) {
      line(b_.strobed_input ? b_.full : !b_.pending, 1);
      line(enables && (b_.input_enable || b_.output_enable), 2);
      line(interrupt(Port::b), 0);
    }
    return value;
  }
  [[nodiscard]] std::uint8_t read_c() const { return static_cast<std::uint8_t>(c_value(true)); }

  Side a_;
  Side b_;
  std::uint8_t c_latch_ = 0;
  std::uint8_t c_levels_ = 0xFF;
  std::uint8_t c_inputs_ = 0xFF;
};

}  // namespace sightline::devices
