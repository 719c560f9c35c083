// The 8251 serial interface (USART) in its asynchronous modes.
//
// After a reset the first control word is the mode: bits 1-0 the clock factor (01 x1, 10 x16, 11 x64), 3-2 the length (5 to
// 8 bits), 4 parity on, 5 even, 7-6 the stop bits (01 one, 10 one and a half, 11 two). All later ones are commands: bit 0
// transmitter on, 1 DTR, 2 receiver on, 3 send break, 4 clear the errors, 5 RTS, 6 reset, 7 hunt. Status: 0 TxRDY (the
// holding register is empty, whatever the enables say), 1 RxRDY, 2 TxEMPTY, 3 parity error, 4 overrun, 5 framing error, 6
// SYNDET, 7 DSR.
//
// The receiver has a character at the middle of its first stop bit; if the last one has not been read by then it is lost
// and overrun is set. The receiver samples the line in the middle of each of its own bits, so a sender of another speed or
// format causes the real errors; the rest of a longer foreign character is not taken for a new start bit. CTS is always
// granted. Left out, and counted where a program uses them: synchronous operation (control words are interpreted in
// sequence, characters are dropped) and break as a level on the line. Times are rounded up to T-states, character by
// character. Sources: Intel's 8251 data sheet as kept by chipdir; usenet 516293 for the sequence.
#pragma once

#include <cstdint>

#include "../core/state_visitor.hpp"
#include "../core/tstates.hpp"
#include "kept_bytes.hpp"

namespace sightline::devices {

// One character on a line, bit 0 first: start bit, data, parity, then mark indefinitely.
struct SerialFrame {
  std::uint32_t levels = ~0U;  // bit n: the level during the n-th bit time
  std::int64_t baud = 9600;

  void visit_state(core::StateVisitor& visit) {
    visit("levels", levels);
    visit("baud", baud, std::int64_t{1'000'000'000});
  }

  [[nodiscard]] bool level(std::int64_t bit_times) const {
    return bit_times > 31 || (levels >> bit_times & 1U) != 0;
  }
};

// The frame format of characters.
struct SerialFormat {
  int data_bits = 8;  // 5..8
  bool parity = false;
  bool even = false;
  int half_stop_bits = 2;  // 2, 3 or 4

  void visit_state(core::StateVisitor& visit) {
    visit("data_bits", data_bits, 8);
    visit("parity", parity);
    visit("even", even);
    visit("half_stop_bits", half_stop_bits, 4);
  }

  [[nodiscard]] int half_bits() const { return 2 * (1 + data_bits + (parity ? 1 : 0)) + half_stop_bits; }
  // The parity bit for `data`.
  [[nodiscard]] bool parity_of(std::uint32_t data) const {
    bool odd = false;
    for (; data != 0; data &= data - 1) odd = !odd;
    return odd == even;
  }
  [[nodiscard]] SerialFrame frame(std::uint8_t value, std::int64_t baud) const {
    const std::uint32_t data = value & ((1U << data_bits) - 1U);
    const std::uint32_t check = parity && !parity_of(data) ? 1U << (1 + data_bits) : 0U;
    return {~(1U | (~data & ((1U << data_bits) - 1U)) << 1 | check), baud};
  }
};

struct I8251Counts {
  std::uint64_t received = 0;
  std::uint64_t received_lost = 0;  // receiver off or not yet programmed
  std::uint64_t overruns = 0;
  std::uint64_t parity_errors = 0;
  std::uint64_t framing_errors = 0;
  std::uint64_t transmitted = 0;
  std::uint64_t transmit_overwritten = 0;  // written before TxRDY: an error of the driver
  std::uint64_t unanswered = 0;            // synchronous operation, breaks
};

class I8251 {
 public:
  // `clock_hertz` drives receiver and transmitter: 153,600 makes 9600 baud at x16.
  I8251(core::ClockRate rate, std::int64_t clock_hertz) : rate_(rate), clock_hertz_(clock_hertz) {}

  struct Status {
    static constexpr std::uint8_t transmit_ready = 0x01;
    static constexpr std::uint8_t receive_ready = 0x02;
    static constexpr std::uint8_t transmit_empty = 0x04;
    static constexpr std::uint8_t parity_error = 0x08;
    static constexpr std::uint8_t overrun = 0x10;
    static constexpr std::uint8_t framing_error = 0x20;
    static constexpr std::uint8_t data_set_ready = 0x80;
  };

  [[nodiscard]] std::uint8_t read_data() {
    ready_ = false;
    return received_;
  }
  [[nodiscard]] std::uint8_t read_status() const {
    unsigned bits = errors_ | Status::data_set_ready;
    if (!holding_) bits |= Status::transmit_ready;
    if (ready_) bits |= Status::receive_ready;
    if (!holding_ && !shifting_) bits |= Status::transmit_empty;
    return static_cast<std::uint8_t>(bits);
  }
  void write_data(std::uint8_t value, core::TStateInstant at) {
    if (expects_ != Expects::command || synchronous_) {
      ++counts_.unanswered;
      return;
    }
    if (holding_) ++counts_.transmit_overwritten;
    holding_ = true;
    released_ = transmits();
    to_send_ = value;
    if (!shifting_) shift(at);
  }
  void write_control(std::uint8_t value, core::TStateInstant at) {
    switch (expects_) {
      case Expects::mode: set_mode(value); break;
      case Expects::two_sync: expects_ = Expects::sync; break;
      case Expects::sync: expects_ = Expects::command; break;
      case Expects::command: command(value, at); break;
    }
  }
  // The reset line; a command with bit 6 does the same.
  void reset() {
    expects_ = Expects::mode;
    command_ = 0;
    synchronous_ = ready_ = holding_ = shifting_ = released_ = false;
    errors_ = 0;
  }

  // Runs the transmitter up to `now`.
  void advance(core::TStateInstant now) {
    while (shifting_ && shift_ends_ <= now) {
      ++counts_.transmitted;
      sent_.push_back(shifter_);
      shifting_ = false;
      shift(shift_ends_);
    }
  }
  // When TxRDY or TxEMPTY changes.
  [[nodiscard]] core::TStateInstant deadline() const { return shifting_ ? shift_ends_ : core::never_t; }

  // Receives a character that began some time ago; call it when its sampling ends.
  void receive(const SerialFrame& frame) {
    if (expects_ != Expects::command || synchronous_ || (command_ & 0x04U) == 0) {
      ++counts_.received_lost;
      return;
    }
    ++counts_.received;
    if (ready_) {
      ++counts_.overruns;
      errors_ |= Status::overrun;
    }
    ready_ = true;
    sample(frame);
  }
  // From the beginning of the start bit until the receiver has the character; the mode must be set.
  [[nodiscard]] core::TStates sampling_time() const {
    return half_bit_times(format_.half_bits() - format_.half_stop_bits + 1);
  }

  [[nodiscard]] bool programmed() const { return expects_ == Expects::command && !synchronous_; }
  [[nodiscard]] const SerialFormat& format() const { return format_; }
  [[nodiscard]] bool request_to_send() const { return (command_ & 0x20U) != 0; }
  [[nodiscard]] bool receive_ready() const { return ready_; }                     // the RxRDY pin
  [[nodiscard]] bool transmit_ready() const { return !holding_ && transmits(); }  // the TxRDY pin
  // Characters whose last stop bit has been sent, in order.
  [[nodiscard]] const KeptBytes& sent() const { return sent_; }
  [[nodiscard]] const I8251Counts& counts() const { return counts_; }

  void visit_state(core::StateVisitor& visit) {
    visit("expects", expects_, Expects::command);
    visit.part("format", format_);
    visit("factor", factor_, 64);
    visit("command", command_);
    visit("synchronous", synchronous_);
    visit("ready", ready_);
    visit("holding", holding_);
    visit("released", released_);
    visit("shifting", shifting_);
    visit("received_character", received_);
    visit("to_send", to_send_);
    visit("shifter", shifter_);
    visit("errors", errors_, 0xFFU);
    visit("shift_ends", shift_ends_);
    visit.part("sent", sent_);
    visit("received", counts_.received);
    visit("received_lost", counts_.received_lost);
    visit("overruns", counts_.overruns);
    visit("parity_errors", counts_.parity_errors);
    visit("framing_errors", counts_.framing_errors);
    visit("transmitted", counts_.transmitted);
    visit("transmit_overwritten", counts_.transmit_overwritten);
    visit("unanswered", counts_.unanswered);
  }

 private:
  enum class Expects : std::uint8_t { mode, two_sync, sync, command };

  [[nodiscard]] bool transmits() const { return (command_ & 0x01U) != 0; }

  void set_mode(std::uint8_t word) {
    synchronous_ = (word & 0x03U) == 0;
    if (synchronous_) {
      ++counts_.unanswered;
      expects_ = (word & 0x80U) != 0 ? Expects::sync : Expects::two_sync;
      return;
    }
    constexpr int factors[]{0, 1, 16, 64};
    factor_ = factors[word & 0x03U];
    format_.data_bits = 5 + static_cast<int>(word >> 2 & 3U);
    format_.parity = (word & 0x10U) != 0;
    format_.even = (word & 0x20U) != 0;
    // 00 is not allowed; it is treated as one stop bit.
    format_.half_stop_bits = (word >> 6) < 2 ? 2 : 1 + static_cast<int>(word >> 6);
    expects_ = Expects::command;
  }

  void command(std::uint8_t word, core::TStateInstant at) {
    if ((word & 0x40U) != 0) {
      reset();
      return;
    }
    command_ = word;
    if ((word & 0x10U) != 0) errors_ = 0;
    if ((word & 0x88U) != 0) ++counts_.unanswered;
    released_ = released_ || transmits();
    if (!shifting_) shift(at);
  }

  // A character written while the transmitter was on is sent even if it is then switched off.
  void shift(core::TStateInstant at) {
    if (!holding_ || !released_) return;
    shifter_ = static_cast<std::uint8_t>(to_send_ & ((1U << format_.data_bits) - 1U));
    holding_ = released_ = false;
    shifting_ = true;
    shift_ends_ = at + half_bit_times(format_.half_bits());
  }

  [[nodiscard]] core::TStates half_bit_times(std::int64_t n) const {
    return core::TStates((n * factor_ * rate_.hertz + 2 * clock_hertz_ - 1) / (2 * clock_hertz_));
  }

  // The level in the middle of the receiver's n-th bit.
  [[nodiscard]] bool sampled_level(const SerialFrame& frame, std::int64_t n) const {
    return frame.level((2 * n + 1) * factor_ * frame.baud / (2 * clock_hertz_));
  }
  void sample(const SerialFrame& frame) {
    std::uint32_t data = 0;
    for (int n = 0; n < format_.data_bits; ++n) data |= std::uint32_t{sampled_level(frame, 1 + n)} << n;
    received_ = static_cast<std::uint8_t>(data);
    int next = 1 + format_.data_bits;
    if (format_.parity && sampled_level(frame, next++) != format_.parity_of(data)) {
      ++counts_.parity_errors;
      errors_ |= Status::parity_error;
    }
    if (!sampled_level(frame, next)) {
      ++counts_.framing_errors;
      errors_ |= Status::framing_error;
    }
  }

  core::ClockRate rate_;
  std::int64_t clock_hertz_;
  Expects expects_ = Expects::mode;
  SerialFormat format_;
  int factor_ = 16;
  std::uint8_t command_ = 0;
  bool synchronous_ = false;
  bool ready_ = false;     // RxRDY
  bool holding_ = false;   // a character waits for the transmitter
  bool released_ = false;  // and may be sent
  bool shifting_ = false;
  std::uint8_t received_ = 0;
  std::uint8_t to_send_ = 0;
  std::uint8_t shifter_ = 0;
  unsigned errors_ = 0;
  core::TStateInstant shift_ends_{};
  KeptBytes sent_;
  I8251Counts counts_;
};

}  // namespace sightline::devices
