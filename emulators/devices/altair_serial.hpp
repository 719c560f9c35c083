// The serial boards of the Altair 8800: the 88-SIO (revision 1) and the two channels of the 88-2SIO, each a Motorola 6850. At
// the other end of a line is a terminal, which can have a reader and a punch of paper tape as a Teletype has, or the reader
// and the punch alone.
//
// The 88-SIO is on ports 00-01, the 88-2SIO on 10-11 and 12-13, the addresses of MITS's software.
//
//            read status                        write control        data
//   88-SIO   bit 0: 0 there is a character      bit 0 receive,       one port on, both ways
//            bit 7: 0 one can be sent           bit 1 send interrupt
//   88-2SIO  bit 0: 1 there is a character      bits 1-0 both 1: reset; bit 7 receive interrupt,
//            bit 1: 1 one can be sent           bits 6-5 01: send interrupt; bit 7 of the status: a request
//
// A character takes ten bit times in either direction, eleven at up to 110 baud. One more can be written while one is being
// sent; another write replaces it and is counted. The terminal's next character comes when the last one has been read, but
// no sooner than the line allows: the terminal waits for the program, so that no typed character is lost. A character is on
// the terminal when its transmission begins. The reader sends its tape byte by byte before any key; the punch punches every
// character sent. Both have eight bits, which nothing changes.
// Left out: parity and framing errors, overrun, modem lines, word lengths (the terminal accepts any), and changes of the
// speed jumpers while the board runs. Bits of the 88-SIO that revision 1 does not use (6, 5 and 1: it moved the receiver's
// and transmitter's to 0 and 7) read 0 here; no manual says what an open input of the board reads.
// Sources: MITS 88-SIO manual (1975), "Theory of Operation", table "Bit Definition", with the errata sheet that makes it revision 1; MITS
// 88-2SIO manual (1977), register tables; Motorola MC6850 data sheet (1978).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "kept_bytes.hpp"

namespace sightline::devices {

enum class AltairBoard : std::uint8_t { sio, two_sio };

struct AltairSerialCounts {
  std::uint64_t received = 0;     // characters that the program has read
  std::uint64_t sent = 0;
  std::uint64_t overwritten = 0;  // before they were sent: an error of the driver
};

struct AltairLine {
  std::uint32_t baud = 9600;
  bool has_terminal = true;
  bool has_tape = false;
};

class AltairSerial : public core::PortDevice, public core::Terminal, public core::LinkHost {
 public:
  static constexpr std::array options{core::DeviceOption{"baud", "of the line", 9600, 50, 1'000'000},
                                      core::DeviceOption{"terminal", "1: a terminal is at the other end", 1, 0, 1},
                                      core::DeviceOption{"tape", "1: a reader and a punch of paper tape are there", 0, 0, 1}};

  AltairSerial(core::ClockRate rate, AltairBoard board, AltairLine line)
      : board_(board), line_(line), character_(rate.t_states_in(core::Duration(bits_at(line.baud) * 1'000'000'000 / line.baud))) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return read(port & 1U, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { write(port & 1U, value, at); }
  [[nodiscard]] unsigned requests() const override { return interrupt() ? 1 : 0; }
  [[nodiscard]] core::Terminal* terminal() override { return line_.has_terminal ? this : nullptr; }
  [[nodiscard]] core::LinkHost* link_host() override { return line_.has_tape ? this : nullptr; }

  // Port 0: status and control; 1: data.
  [[nodiscard]] std::uint8_t read(std::uint8_t port, core::TStateInstant at) {
    advance(at);
    const bool key = key_is_there();
    if (!key && at_end()) polls_.add();
    if ((port & 1U) == 0) return status(key);
    if (!key) return last_read_;
    if (tape_read_ < tape_.size()) {
      last_read_ = tape_[tape_read_++];
    } else {
      last_read_ = keys_.front();
      keys_.erase(keys_.begin());
    }
    next_key_ = now_ + character_;
    ++counts_.received;
    return last_read_;
  }
  void write(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    advance(at);
    if ((port & 1U) == 0) {
      control_ = value;
      if (board_ == AltairBoard::two_sio && (value & 3U) == 3) holding_ = false;
      return;
    }
    if (!holding_ && line_free_ <= now_) return transmit(value, now_);
    if (holding_) ++counts_.overwritten;
    held_ = value;
    holding_ = true;
  }
  // Performs everything up to and including `now`.
  void advance(core::TStateInstant now) override {
    now_ = std::max(now_, now);
    if (!holding_ || line_free_ > now_) return;
    holding_ = false;
    transmit(held_, line_free_);
  }
  // The next instant at which a flag changes without an access.
  [[nodiscard]] core::TStateInstant deadline() const override {
    core::TStateInstant next = core::never_t;
    if (holding_) next = line_free_;
    if (!at_end() && next_key_ > now_) next = std::min(next, next_key_);
    return next;
  }
  [[nodiscard]] bool interrupt() const { return interrupt(key_is_there()); }

  // The terminal's side. A typed key is sent as soon as the line and the program allow.
  void type(std::uint8_t code) override {
    keys_.push_back(code);
    polls_.forget();
  }
  [[nodiscard]] bool wants_key() const override { return at_end() && polls_.any(); }
  [[nodiscard]] bool interrupts_for_key() const override { return at_end() && receives(); }
  [[nodiscard]] core::TStateInstant quiet_since() const override {
    return std::max(next_key_, holding_ ? line_free_ + character_ : line_free_);
  }
  void tell_polls(core::KeyPollListener* listener) override { polls_.tell(listener); }
  // The characters sent since the last call.
  [[nodiscard]] std::vector<std::uint8_t> take_printed() override { return std::exchange(printed_, {}); }

  // The reader's tape, and what has been punched.
  void send(std::span<const std::uint8_t> bytes) override { tape_ = bytes; }
  [[nodiscard]] std::vector<std::uint8_t> received() const override { return punched_.bytes(); }
  [[nodiscard]] std::uint64_t left_out() const override { return punched_.left_out(); }

  [[nodiscard]] const AltairSerialCounts& totals() const { return counts_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"received", counts_.received}, {"sent", counts_.sent}, {"overwritten", counts_.overwritten}};
  }

  // Between two runs all printed characters have been taken.
  void visit_state(core::StateVisitor& visit) override {
    visit("now", now_);
    visit("control", control_);
    visit("last_read", last_read_);
    visit("held", held_);
    visit("holding", holding_);
    visit("line_free", line_free_);
    visit("next_key", next_key_);
    visit("asked", polls_.state());
    visit.list("keys", keys_, [&visit](std::uint8_t& key) { visit("key", key); });
    visit.input("tape", tape_);
    visit.count("tape_read", tape_read_, tape_.size());
    visit.part("punched", punched_);
    visit("received", counts_.received);
    visit("sent", counts_.sent);
    visit("overwritten", counts_.overwritten);
    if (visit.restores()) printed_.clear();
  }

 private:
  static constexpr std::int64_t bits_at(std::uint32_t baud) { return baud <= 110 ? 11 : 10; }

  void transmit(std::uint8_t character, core::TStateInstant begins) {
    if (line_.has_terminal) printed_.push_back(character);
    if (line_.has_tape) punched_.push_back(character);
    ++counts_.sent;
    line_free_ = begins + character_;
  }
  // The receive interrupt is enabled.
  [[nodiscard]] bool receives() const {
    return board_ == AltairBoard::sio ? (control_ & 1U) != 0 : (control_ & 0x80U) != 0;
  }
  // Nothing is left to be received.
  [[nodiscard]] bool at_end() const { return keys_.empty() && tape_read_ == tape_.size(); }
  [[nodiscard]] bool key_is_there() const { return !at_end() && next_key_ <= now_; }
  // `key`: key_is_there(), which a program that polls should not pay for more than once.
  [[nodiscard]] bool interrupt(bool key) const {
    const bool sends = board_ == AltairBoard::sio ? (control_ & 2U) != 0 : (control_ & 0x60U) == 0x20;
    return (receives() && key) || (sends && !holding_);
  }
  [[nodiscard]] std::uint8_t status(bool key) const {
    const bool out = !holding_;
    if (board_ == AltairBoard::sio) return static_cast<std::uint8_t>((key ? 0U : 1U) | (out ? 0U : 0x80U));
    return static_cast<std::uint8_t>((key ? 1U : 0U) | (out ? 2U : 0U) | (interrupt(key) ? 0x80U : 0U));
  }

  AltairBoard board_;
  AltairLine line_;
  core::TStates character_;
  core::TStateInstant now_{};
  std::uint8_t control_ = 0;
  std::uint8_t last_read_ = 0;
  std::uint8_t held_ = 0;  // written, waits for the line
  bool holding_ = false;
  core::TStateInstant line_free_{};  // when the character before has been sent
  core::TStateInstant next_key_{};   // earliest instant of the next key
  core::KeyPolls polls_;
  std::vector<std::uint8_t> keys_;
  std::vector<std::uint8_t> printed_;
  std::span<const std::uint8_t> tape_;  // in the reader
  std::size_t tape_read_ = 0;
  KeptBytes punched_;
  AltairSerialCounts counts_;
};

[[nodiscard]] inline AltairLine altair_line(const core::PortDeviceSetup& setup, const core::PortDeviceInfo& info) {
  return {static_cast<std::uint32_t>(setup.value(info, "baud")), setup.value(info, "terminal") != 0, setup.value(info, "tape") != 0};
}

class AltairSio final : public AltairSerial {
 public:
  static constexpr std::array ports{core::PortRange{0x00, 0x01}};
  static constexpr std::array<std::string_view, 1> lines{"sio"};
  static constexpr core::PortDeviceInfo info{.name = "sio",
                                             .help = "Altair 88-SIO with a terminal",
                                             .choice = "sio",
                                             .kind = core::PortDeviceKind::terminal,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options};

  explicit AltairSio(const core::PortDeviceSetup& setup)
      : AltairSerial(setup.clock, AltairBoard::sio, altair_line(setup, info)) {}
};

class Altair2Sio final : public AltairSerial {
 public:
  static constexpr std::array ports{core::PortRange{0x10, 0x11}};
  static constexpr std::array<std::string_view, 1> lines{"2sio"};
  static constexpr core::PortDeviceInfo info{.name = "2sio",
                                             .help = "Altair 88-2SIO with a terminal, first channel",
                                             .choice = "2sio",
                                             .kind = core::PortDeviceKind::terminal,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options};

  explicit Altair2Sio(const core::PortDeviceSetup& setup)
      : AltairSerial(setup.clock, AltairBoard::two_sio, altair_line(setup, info)) {}
};

class Altair2SioB final : public AltairSerial {
 public:
  static constexpr std::array ports{core::PortRange{0x12, 0x13}};
  static constexpr std::array<std::string_view, 1> lines{"2sio-b"};
  static constexpr core::PortDeviceInfo info{.name = "2sio-b",
                                             .help = "second channel of the Altair 88-2SIO",
                                             .choice = "2sio-b",
                                             .kind = core::PortDeviceKind::terminal,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options};

  explicit Altair2SioB(const core::PortDeviceSetup& setup)
      : AltairSerial(setup.clock, AltairBoard::two_sio, altair_line(setup, info)) {}
};

}  // namespace sightline::devices
