// The fast link to the host computer: an 8255, on ports E4-E7, whose port A receives the host's bytes by strobed input,
// mode 1.
//
// The host watches IBF. While it is low the host puts the next byte on the lines and pulses STB# low for 500 ns; when the
// processor reads port A, IBF falls and the host answers after its response time (2 us unless set). Until the program has
// set port A to mode 1 input (or mode 2) the line floats high and the host waits; setting the mode counts as IBF falling.
// In the other direction, when the program writes to a port that is a strobed output, the host takes the byte after its
// response time by pulsing ACK# low for 500 ns: port B, and port A if its mode has an output.
//
// Times are rounded up to T-states. At each access the host's pulses since the last access are processed in order. The
// ports are those of Intel's SBC 80/10.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "i8255.hpp"
#include "kept_bytes.hpp"

namespace sightline::devices {

struct ParallelHost {
  core::Duration response{2'000};  // from the fall of IBF or OBF# until the host's pulse begins
  core::Duration pulse{500};       // STB# or ACK# low
};

class ParallelLink final : public core::PortDevice, public core::LinkHost {
 public:
  static constexpr std::uint8_t first_port = 0xE4;
  static constexpr std::array ports{core::PortRange{first_port, 0xE7}};
  static constexpr std::array<std::string_view, 1> lines{"parallel"};  // on INTR of port A or B
  static constexpr std::array options{
      core::DeviceOption{"response", "response time of the host, in nanoseconds", ParallelHost{}.response.count(), 0, 1'000'000'000},
      core::DeviceOption{"pulse", "length of the host's pulses, in nanoseconds", ParallelHost{}.pulse.count(), 0, 1'000'000'000}};
  static constexpr core::PortDeviceInfo info{.name = "parallel",
                                             .help = "parallel link to a host computer, an 8255",
                                             .choice = "8255",
                                             .kind = core::PortDeviceKind::link,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options,
                                             .received = "What the host took from the 8255"};

  explicit ParallelLink(const core::PortDeviceSetup& setup)
      : ParallelLink(setup.clock, {}, {core::Duration(setup.value(info, "response")), core::Duration(setup.value(info, "pulse"))}) {}
  // The bytes that the host will send must outlive the link.
  ParallelLink(core::ClockRate rate, std::span<const std::uint8_t> bytes, ParallelHost host = {})
      : response_(rate.t_states_in(host.response)), pulse_(rate.t_states_in(host.pulse)), bytes_(bytes) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return read(port & 3U, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { write(port & 3U, value, at); }
  [[nodiscard]] unsigned requests() const override { return interrupt() ? 1 : 0; }
  [[nodiscard]] core::LinkHost* link_host() override { return this; }

  // The host.
  void send(std::span<const std::uint8_t> bytes) override { bytes_ = bytes; }
  // From port B, then from port A.
  [[nodiscard]] std::vector<std::uint8_t> received() const override {
    std::vector<std::uint8_t> bytes = takers_[1].bytes.bytes();
    bytes.insert(bytes.end(), takers_[0].bytes.bytes().begin(), takers_[0].bytes.bytes().end());
    return bytes;
  }
  [[nodiscard]] std::uint64_t left_out() const override { return takers_[0].bytes.left_out() + takers_[1].bytes.left_out(); }

  // Address 0..3 of the chip.
  [[nodiscard]] std::uint8_t read(std::uint8_t address, core::TStateInstant at) {
    advance(at);
    const std::uint8_t value = chip_.read(address);
    sample_lines(at);
    return value;
  }
  void write(std::uint8_t address, std::uint8_t value, core::TStateInstant at) {
    advance(at);
    if ((address & 3U) == 3 && (value & 0x80U) != 0) drop_pulses();
    chip_.write(address, value);
    sample_lines(at);
  }

  void advance(core::TStateInstant now) override {
    while (strobe_.due <= now) strobe();
    for (Taker& taker : takers_)
      while (taker.pulse.due <= now) take_byte(taker);
  }
  // When one of the lines, and with it an interrupt request, may change without an access.
  [[nodiscard]] core::TStateInstant deadline() const override {
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
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"sent_by_host", sent_}, {"received_by_host", takers_[0].bytes.total() + takers_[1].bytes.total()}, {"not_kept", left_out()}};
  }

  // The bytes that the host sends are configuration.
  void visit_state(core::StateVisitor& visit) override {
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
  // A pulse from the host: its next edge, and whether the line is low until then.
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
    sample_lines(edge);
  }

  void take_byte(Taker& taker) {
    const core::TStateInstant edge = taker.pulse.due;
    if (!taker.pulse.low) {
      taker.bytes.push_back(chip_.acknowledge_falls(taker.port));
      taker.pulse = {edge + pulse_, true};
      return;
    }
    chip_.acknowledge_rises(taker.port);
    taker.pulse = {};
    sample_lines(edge);
  }

  // The host samples IBF and OBF#, which may have fallen at `at`.
  void sample_lines(core::TStateInstant at) {
    if (strobe_.due == core::never_t && sent_ < bytes_.size() && !chip_.input_buffer_full(I8255::Port::a))
      strobe_.due = at + response_;
    for (Taker& taker : takers_)
      if (taker.pulse.due == core::never_t && chip_.output_buffer_full(taker.port))
        taker.pulse.due = at + response_;
  }

  // A new mode clears the handshakes: the host's pending pulses are cancelled, and it samples the lines again.
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
