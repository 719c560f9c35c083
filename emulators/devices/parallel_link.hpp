// The fast link to the host computer: an 8255 whose port A takes the host's bytes by strobed input, mode 1.
//
// The host watches IBF. While it is low the host puts the next byte on the lines and pulses STB# low for 500
// ns; when the processor reads port A, IBF falls and the host answers after its response time (2 us unless
// set). Until the program has set port A to mode 1 input (or mode 2) the line floats high and the host waits;
// setting the mode counts as IBF falling. The other way, when the program writes to a port that is a strobed
// output, the host takes the byte after its response time by pulsing ACK# low for 500 ns: port B, and port A
// as far as its mode has an output.
//
// Times are rounded up to T-states. Between two accesses the host's pulses are caught up with, in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../core/state_visitor.hpp"
#include "../core/tstates.hpp"
#include "i8255.hpp"
#include "kept_bytes.hpp"

namespace sightline::devices {

struct ParallelHost {
  core::Duration response{2'000};  // from IBF or OBF# falling until the host's pulse begins
  core::Duration pulse{500};       // STB# or ACK# low
};

class ParallelLink {
 public:
  // The bytes the host will send must stay where they are.
  ParallelLink(core::ClockRate rate, std::span<const std::uint8_t> bytes, ParallelHost host = {})
      : response_(rate.t_states_in(host.response)), pulse_(rate.t_states_in(host.pulse)), bytes_(bytes) {}

  // Address 0..3 of the chip.
  [[nodiscard]] std::uint8_t read(std::uint8_t address, core::TStateInstant at) {
    advance(at);
    const std::uint8_t value = chip_.read(address);
    look(at);
    return value;
  }
  void write(std::uint8_t address, std::uint8_t value, core::TStateInstant at) {
    advance(at);
    if ((address & 3U) == 3 && (value & 0x80U) != 0) drop_pulses();
    chip_.write(address, value);
    look(at);
  }

  void advance(core::TStateInstant now) {
    while (strobe_.due <= now) strobe();
    for (Taker& taker : takers_)
      while (taker.pulse.due <= now) acknowledge(taker);
  }
  // When one of the lines, and with it an interrupt request, may change by itself.
  [[nodiscard]] core::TStateInstant deadline() const {
    return std::min({strobe_.due, takers_[0].pulse.due, takers_[1].pulse.due});
  }
  [[nodiscard]] bool interrupt() const {
    return chip_.interrupt(I8255::Port::a) || chip_.interrupt(I8255::Port::b);
  }

  [[nodiscard]] I8255& chip() { return chip_; }
  // Bytes the host has strobed in so far.
  [[nodiscard]] std::size_t sent() const { return sent_; }
  // Bytes the host has taken from port A or B, in order.
  [[nodiscard]] const KeptBytes& received(I8255::Port port) const {
    return takers_[port == I8255::Port::a ? 0 : 1].bytes;
  }

  // What the host sends is configuration.
  void visit_state(core::StateVisitor& visit) {
    visit.part("chip", chip_);
    visit.input("bytes", bytes_);
    visit.count("sent", sent_, bytes_.size());
    visit.part("strobe", strobe_);
    visit.part("from_a", takers_[0]);
    visit.part("from_b", takers_[1]);
    visit.require(strobe_.due == core::never_t || strobe_.low || sent_ < bytes_.size(), "strobe",
                  "none after the last byte");
  }

 private:
  // A pulse of the host's: its next edge, and whether the line is low until then.
  struct Pulse {
    core::TStateInstant due = core::never_t;
    bool low = false;

    void visit_state(core::StateVisitor& visit) {
      visit("due", due);
      visit("low", low);
    }
  };
  struct Taker {
    I8255::Port port;
    Pulse pulse;
    KeptBytes bytes;

    void visit_state(core::StateVisitor& visit) {
      visit.part("pulse", pulse);
      visit.part("taken", bytes);
    }
  };

  void strobe() {
    const core::TStateInstant edge = strobe_.due;
    if (!strobe_.low) {
      chip_.strobe_falls(I8255::Port::a, bytes_[sent_++]);
      strobe_ = {edge + pulse_, true};
      return;
    }
    chip_.strobe_rises(I8255::Port::a);
    strobe_ = {};
    look(edge);
  }

  void acknowledge(Taker& taker) {
    const core::TStateInstant edge = taker.pulse.due;
    if (!taker.pulse.low) {
      taker.bytes.push_back(chip_.acknowledge_falls(taker.port));
      taker.pulse = {edge + pulse_, true};
      return;
    }
    chip_.acknowledge_rises(taker.port);
    taker.pulse = {};
    look(edge);
  }

  // The host looks at IBF and OBF#, which may have fallen at `at`.
  void look(core::TStateInstant at) {
    if (strobe_.due == core::never_t && sent_ < bytes_.size() && !chip_.input_buffer_full(I8255::Port::a))
      strobe_.due = at + response_;
    for (Taker& taker : takers_)
      if (taker.pulse.due == core::never_t && chip_.output_buffer_full(taker.port))
        taker.pulse.due = at + response_;
  }

  // A new mode clears the handshakes: what the host was about to do is void, and it looks again.
  void drop_pulses() {
    strobe_ = {};
    for (Taker& taker : takers_) taker.pulse = {};
  }

  I8255 chip_;
  core::TStates response_;
  core::TStates pulse_;
  std::span<const std::uint8_t> bytes_;
  std::size_t sent_ = 0;
  Pulse strobe_;
  Taker takers_[2]{{I8255::Port::a, {}, {}}, {I8255::Port::b, {}, {}}};
};

}  // namespace sightline::devices
