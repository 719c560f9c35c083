// The slow link to the host computer, as in period systems: an 8251 on a line at 9600 baud, on ports EC-EF (Intel's SBC
// 80/10): data even, control odd.
//
// The host sends its bytes one after the other. It samples RTS before each character and waits while the program has it
// off. Set to send blindly, it starts at a given instant and ignores RTS, so that a slow program loses characters (overrun)
// as it would in reality. The chip collects what the program transmits.
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
#include "i8251.hpp"

namespace sightline::devices {

struct SerialHost {
  std::int64_t chip_clock_hertz = 153'600;  // 9600 baud at x16
  std::int64_t baud = 9600;                 // of the host
  SerialFormat format{};                    // of the host: 8 bits, no parity, 1 stop bit
  bool watches_rts = true;
  core::TStateInstant starts{};  // first start bit not before
  core::Duration gap{0};         // between the stop bit and the next start bit
};

class SerialLink final : public core::PortDevice, public core::LinkHost {
 public:
  static constexpr std::uint8_t first_port = 0xEC;
  static constexpr std::array ports{core::PortRange{first_port, 0xEF}};
  static constexpr std::array<std::string_view, 2> lines{"serial-receive", "serial-transmit"};  // on RxRDY, on TxRDY
  static constexpr std::array options{
      core::DeviceOption{"baud", "of the host", SerialHost{}.baud, 50, 1'000'000},
      core::DeviceOption{"chip-clock", "of the 8251, in Hz", SerialHost{}.chip_clock_hertz, 1, 1'000'000'000},
      core::DeviceOption{"watches-rts", "0: the host sends blindly", SerialHost{}.watches_rts ? 1 : 0, 0, 1},
      core::DeviceOption{"starts", "T-state before which the host sends nothing", 0, 0, std::int64_t{1} << 62},
      core::DeviceOption{"gap", "between two characters of the host, in nanoseconds", 0, 0, 1'000'000'000}};
  static constexpr core::PortDeviceInfo info{.name = "serial",
                                             .help = "serial link to a host computer, an 8251",
                                             .choice = "8251",
                                             .kind = core::PortDeviceKind::link,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options,
                                             .received = "What the 8251 sent to the host"};

  explicit SerialLink(const core::PortDeviceSetup& setup) : SerialLink(setup.clock, {}, host_of(setup)) {}
  // The bytes that the host will send must outlive the link.
  SerialLink(core::ClockRate rate, std::span<const std::uint8_t> bytes, SerialHost host = {})
      : rate_(rate),
        chip_(rate, host.chip_clock_hertz),
        host_(host),
        gap_(rate.t_states_in(host.gap)),
        bytes_(bytes),
        line_free_(host.starts) {
    if (!host.watches_rts) plan(line_free_);
  }

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return read(port & 1U, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { write(port & 1U, value, at); }
  [[nodiscard]] unsigned requests() const override {
    return (chip_.receive_ready() ? 1U : 0U) | (chip_.transmit_ready() ? 2U : 0U);
  }
  [[nodiscard]] core::LinkHost* link_host() override { return this; }

  // The host.
  void send(std::span<const std::uint8_t> bytes) override {
    bytes_ = bytes;
    if (!host_.watches_rts) plan(line_free_);
  }
  [[nodiscard]] std::vector<std::uint8_t> received() const override { return chip_.sent().bytes(); }
  [[nodiscard]] std::uint64_t left_out() const override { return chip_.sent().left_out(); }

  // Odd addresses are control and status, even ones data.
  [[nodiscard]] std::uint8_t read(std::uint8_t address, core::TStateInstant at) {
    advance(at);
    return (address & 1U) != 0 ? chip_.read_status() : chip_.read_data();
  }
  void write(std::uint8_t address, std::uint8_t value, core::TStateInstant at) {
    advance(at);
    if ((address & 1U) == 0) {
      chip_.write_data(value, at);
      return;
    }
    chip_.write_control(value, at);
    if (start_ == core::never_t && allowed()) {
      plan(std::max(line_free_, at));
      advance(at);
    }
  }

  void advance(core::TStateInstant now) override {
    chip_.advance(now);
    while (next_event() <= now) {
      if (sampled_ <= start_)
        deliver();
      else
        begin();
    }
  }
  [[nodiscard]] core::TStateInstant deadline() const override { return std::min(next_event(), chip_.deadline()); }

  [[nodiscard]] const I8251& chip() const { return chip_; }
  // Characters the host has begun to send.
  [[nodiscard]] std::size_t sent() const { return sent_; }
  // Those of them that began while a receiver set to a slower line was still sampling the last one.
  [[nodiscard]] std::uint64_t unseen() const { return unseen_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    const I8251Counts& n = chip_.counts();
    return {{"sent_by_host", sent_},
            {"unseen", unseen_},
            {"received", n.received},
            {"received_lost", n.received_lost},
            {"overruns", n.overruns},
            {"parity_errors", n.parity_errors},
            {"framing_errors", n.framing_errors},
            {"transmitted", n.transmitted},
            {"transmit_overwritten", n.transmit_overwritten},
            {"not_kept", left_out()},
            {"unanswered", n.unanswered}};
  }

  // The bytes that the host sends are configuration.
  void visit_state(core::StateVisitor& visit) override {
    visit.part("chip", chip_);
    visit.input("bytes", bytes_);
    visit.count("sent", sent_, bytes_.size());
    visit.part("frame", frame_);
    visit("unseen", unseen_);
    visit("line_free", line_free_);
    visit("start", start_);
    visit("sampled", sampled_);
    visit.require(start_ == core::never_t || sent_ < bytes_.size(), "start", "none after the last byte");
  }

 private:
  static SerialHost host_of(const core::PortDeviceSetup& setup) {
    SerialHost host;
    host.baud = setup.value(info, "baud");
    host.chip_clock_hertz = setup.value(info, "chip-clock");
    host.watches_rts = setup.value(info, "watches-rts") != 0;
    host.starts = core::at_t_state(setup.value(info, "starts"));
    host.gap = core::Duration(setup.value(info, "gap"));
    return host;
  }

  [[nodiscard]] core::TStateInstant next_event() const { return std::min(start_, sampled_); }
  [[nodiscard]] bool allowed() const { return !host_.watches_rts || chip_.request_to_send(); }

  // The next start bit is at `when`, if any bytes are left.
  void plan(core::TStateInstant when) { start_ = sent_ < bytes_.size() ? when : core::never_t; }

  void deliver() {
    sampled_ = core::never_t;
    chip_.receive(frame_);
  }

  // Begins a start bit. If RTS is off, the host waits until it is asserted again.
  void begin() {
    const core::TStateInstant now = start_;
    start_ = core::never_t;
    if (!allowed()) return;
    const std::uint8_t value = bytes_[sent_++];
    const core::TStates lasts = host_half_bits(host_.format.half_bits());
    line_free_ = now + lasts + gap_;
    plan(line_free_);
    if (sampled_ != core::never_t) {
      ++unseen_;
      return;
    }
    frame_ = host_.format.frame(value, host_.baud);
    sampled_ = now + (chip_.programmed() ? chip_.sampling_time() : lasts);
  }

  [[nodiscard]] core::TStates host_half_bits(std::int64_t n) const {
    return core::TStates((n * rate_.hertz + 2 * host_.baud - 1) / (2 * host_.baud));
  }

  core::ClockRate rate_;
  I8251 chip_;
  SerialHost host_;
  core::TStates gap_;
  std::span<const std::uint8_t> bytes_;
  std::size_t sent_ = 0;
  SerialFrame frame_;
  std::uint64_t unseen_ = 0;
  core::TStateInstant line_free_;
  core::TStateInstant start_ = core::never_t;    // of the next start bit
  core::TStateInstant sampled_ = core::never_t;  // when the receiver has the character on the line
};

}  // namespace sightline::devices
