// The raster board: a Thomson EF9365 graphic display processor with three bit planes and a colour latch.
//
// The chip's sixteen registers are on ports 40-4F, the latch on 50 (chosen): 0 status (read) and command (write), 1 CTRL1,
// 2 CTRL2, 3 CSIZE, 5 DELTAX, 7 DELTAY, 8/9 X high and low, A/B Y high and low, C/D light pen; 4, 6, E and F do not exist
// (read as FFh). The latch beside the chip holds what the pen writes into each plane, bits 2-0; 0 erases all planes.
//
// A command takes effect in the raster at once and completely; only its busy time passes afterwards. A command given while
// the chip is busy is ignored and counted: what the chip would do is not specified. A register or the latch written while
// the chip is busy is stored at once and counted too: on the chip such a write could affect the drawing in progress, here
// it cannot. Status bits 5 and 6 rise with their event when CTRL1 enables it, and fall when status is read; bit 7 and the
// interrupt line are their OR.
//
// Left out: the light pen (XLP and YLP read as 0, status bits 0 and 4 stay 0, commands 08 and 09 only take time) and
// reading the planes back (command 0F only takes time); both are counted. Also left out: waiting for the next field before
// a clear. Sources: MAME's ef9365 device and Wikipedia's article, which agree; times in ef9365_timing.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "../core/inline.hpp"
#include "../core/port_device.hpp"
#include "../core/raster.hpp"
#include "../core/tstates.hpp"
#include "ef9365_drawing.hpp"
#include "ef9365_timing.hpp"

namespace sightline::devices {

struct Ef9365Counts {
  std::uint64_t commands = 0;             // executed
  std::uint64_t commands_while_busy = 0;  // ignored: an error of the driver
  std::uint64_t writes_while_busy = 0;    // registers and latch: an error of the driver
  std::uint64_t unanswered = 0;    // light pen, memory access, writes to registers that cannot be written
  std::uint64_t dots = 0;          // written into the planes
  std::uint64_t dots_outside = 0;  // beyond 256 by 256
};

class Ef9365 final : public core::PortDevice {
 public:
  static constexpr std::uint8_t first_port = 0x40;
  static constexpr std::uint8_t colour_latch = 0x50;
  static constexpr std::array ports{core::PortRange{first_port, 0x4F}, core::PortRange{colour_latch, colour_latch}};
  static constexpr std::array<std::string_view, 1> lines{"ef9365"};
  static constexpr core::PortDeviceInfo info{.name = "ef9365",
                                             .help = "raster board with an EF9365, 256 by 256 points of eight colours",
                                             .choice = "ef9365",
                                             .kind = core::PortDeviceKind::raster_board,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines};

  explicit Ef9365(const core::PortDeviceSetup& setup) : Ef9365(setup.clock) {}
  explicit Ef9365(core::ClockRate rate) : rate_(rate) {
    for (std::size_t dots = 0; dots < vector_times_.size(); ++dots)
      vector_times_[dots] = rate.t_states_in(drawing_time(static_cast<std::int64_t>(dots)));
  }

  struct Status {
    static constexpr std::uint8_t blanking = 0x02;
    static constexpr std::uint8_t ready = 0x04;
    static constexpr std::uint8_t pen_outside = 0x08;
    static constexpr std::uint8_t blanking_interrupt = 0x20;
    static constexpr std::uint8_t ready_interrupt = 0x40;
    static constexpr std::uint8_t interrupt = 0x80;
  };

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    return port == colour_latch ? colour() : read(port & 0x0FU, at);
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    if (port == colour_latch) [[unlikely]] return set_colour(value, at);
    write(port & 0x0FU, value, at);
  }
  [[nodiscard]] unsigned requests() const override { return interrupt() ? 1 : 0; }

  // Register 0..15. `at` must not be before that of any earlier call.
  [[nodiscard]] std::uint8_t read(std::uint8_t number, core::TStateInstant at) {
    switch (number & 0x0FU) {
      case 0x0: return status(at);
      case 0x1: return static_cast<std::uint8_t>(control_ | drawing_.pen);
      case 0x2: return drawing_.style;
      case 0x3: return drawing_.size;
      case 0x5: return delta_x_;
      case 0x7: return delta_y_;
      case 0x8: return static_cast<std::uint8_t>(drawing_.x >> 8);
      case 0x9: return static_cast<std::uint8_t>(drawing_.x);
      case 0xA: return static_cast<std::uint8_t>(drawing_.y >> 8);
      case 0xB: return static_cast<std::uint8_t>(drawing_.y);
      case 0xC:
      case 0xD: return 0;
      default: return 0xFF;
    }
  }

  void write(std::uint8_t number, std::uint8_t value, core::TStateInstant at) {
    const unsigned selected = number & 0x0FU;
    if (selected == 0) {
      command(value, at);
      return;
    }
    if (busy(at)) ++counts_.writes_while_busy;
    switch (selected) {
      case 0x1: set_control(value, at); break;
      case 0x2: drawing_.style = value & 0x0FU; break;
      case 0x3: drawing_.size = value; break;
      case 0x5: delta_x_ = value; break;
      case 0x7: delta_y_ = value; break;
      case 0x8: drawing_.x = static_cast<std::uint16_t>((value & 0x0FU) << 8 | (drawing_.x & 0xFFU)); break;
      case 0x9: drawing_.x = static_cast<std::uint16_t>((drawing_.x & 0xF00U) | value); break;
      case 0xA: drawing_.y = static_cast<std::uint16_t>((value & 0x0FU) << 8 | (drawing_.y & 0xFFU)); break;
      case 0xB: drawing_.y = static_cast<std::uint16_t>((drawing_.y & 0xF00U) | value); break;
      default: ++counts_.unanswered; break;
    }
  }

  [[nodiscard]] std::uint8_t colour() const { return drawing_.colour; }
  void set_colour(std::uint8_t value, core::TStateInstant at) {
    if (busy(at)) ++counts_.writes_while_busy;
    drawing_.colour = value & 0x07U;
  }

  // The interrupt line, as of the last read, write or advance.
  [[nodiscard]] bool interrupt() const { return raised_ != 0; }
  // When the line may rise without an access.
  [[nodiscard]] core::TStateInstant deadline() const override {
    if (control_ == 0 || raised_ != 0) return core::never_t;
    return std::min((control_ & blanking_enable) != 0 ? next_blanking_ : core::never_t,
                    (control_ & ready_enable) != 0 && working_ ? busy_until_ : core::never_t);
  }
  void advance(core::TStateInstant now) override {
    if (control_ == 0) return;
    if (working_ && busy_until_ <= now) {
      working_ = false;
      if ((control_ & ready_enable) != 0) raised_ |= Status::ready_interrupt;
    }
    if ((control_ & blanking_enable) != 0 && next_blanking_ <= now) {
      raised_ |= Status::blanking_interrupt;
      next_blanking_ = blanking_after(now);
    }
  }

  void visit_state(core::StateVisitor& visit) override {
    visit.part("drawing", drawing_);
    visit("delta_x", delta_x_);
    visit("delta_y", delta_y_);
    visit("control", control_, enables);
    visit("raised", raised_, enables);
    visit("working", working_);
    visit("busy_until", busy_until_);
    visit("next_blanking", next_blanking_);
    visit("commands", counts_.commands);
    visit("commands_while_busy", counts_.commands_while_busy);
    visit("writes_while_busy", counts_.writes_while_busy);
    visit("unanswered", counts_.unanswered);
  }

  [[nodiscard]] bool busy(core::TStateInstant at) const { return at < busy_until_; }
  // The end of the last command's busy time.
  [[nodiscard]] core::TStateInstant busy_until() const { return busy_until_; }
  [[nodiscard]] const core::Raster* raster() const override { return &drawing_.raster(); }
  [[nodiscard]] Ef9365Counts totals() const {
    Ef9365Counts totals = counts_;
    totals.dots = drawing_.dots();
    totals.dots_outside = drawing_.dots_outside();
    return totals;
  }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    const Ef9365Counts n = totals();
    return {{"commands", n.commands},
            {"commands_while_busy", n.commands_while_busy},
            {"writes_while_busy", n.writes_while_busy},
            {"unanswered", n.unanswered},
            {"dots", n.dots},
            {"dots_outside", n.dots_outside}};
  }

 private:
  static constexpr std::uint8_t pen_bits = 0x03;
  static constexpr std::uint8_t enables = 0x70;
  static constexpr std::uint8_t blanking_enable = 0x20;
  static constexpr std::uint8_t ready_enable = 0x40;

  [[nodiscard]] std::uint8_t status(core::TStateInstant at) {
    advance(at);
    unsigned bits = raised_;
    if (raised_ != 0) bits |= Status::interrupt;
    if (!busy(at)) bits |= Status::ready;
    if (drawing_.outside()) bits |= Status::pen_outside;
    if (rate_.to_nanoseconds(at).time_since_epoch() % ef9365::field >= ef9365::displayed)
      bits |= Status::blanking;
    raised_ = 0;
    return static_cast<std::uint8_t>(bits);
  }

  // Events before `at` are decided by the old enable bits.
  void set_control(std::uint8_t value, core::TStateInstant at) {
    advance(at);
    drawing_.pen = value & pen_bits;
    control_ = value & enables;
    working_ = busy(at);
    if ((control_ & blanking_enable) != 0) next_blanking_ = blanking_after(at);
  }

  // The first beginning of vertical blanking after `at`.
  [[nodiscard]] core::TStateInstant blanking_after(core::TStateInstant at) const {
    const core::Instant now = rate_.to_nanoseconds(at);
    if (now == core::never) return core::never_t;  // beyond what nanoseconds can count
    const core::Duration since = now.time_since_epoch() + ef9365::field - ef9365::displayed;
    const core::Duration begins = since / ef9365::field * ef9365::field + ef9365::displayed;
    return core::TStateInstant(rate_.t_states_in(begins));
  }

  void command(std::uint8_t code, core::TStateInstant at) {
    if (busy(at)) {
      ++counts_.commands_while_busy;
      return;
    }
    advance(at);
    ++counts_.commands;
    working_ = true;
    if (code >= 0x80)
      busy_until_ = at + vector_times_[small_vector(code)];
    else
      busy_until_ = at + rate_.t_states_in(obey(code));
  }

  // Returns the number of dots. Single dots, the most frequent case, skip the code for lines.
  SIGHTLINE_INLINE std::size_t small_vector(std::uint8_t code) {
    if ((code & 0x78U) != 0) return directed_vector(code, (code >> 5) & 3, (code >> 3) & 3);
    drawing_.single_dot();
    return 1;
  }

  // All commands except small vectors. Returns the busy time.
  [[gnu::noinline]] core::Duration obey(std::uint8_t code) {
    if (code >= 0x20) return drawing_time(drawing_.symbol(ef9365::character(code)));
    if (code < 0x10) return basic(code);
    // The special vectors run along one of eight directions by the larger of the two deltas.
    const int larger = std::max(delta_x_, delta_y_);
    const std::size_t dots =
        (code & 0x08U) != 0 ? directed_vector(code, larger, larger) : directed_vector(code, delta_x_, delta_y_);
    return drawing_time(static_cast<std::int64_t>(dots));
  }

  static constexpr core::Duration drawing_time(std::int64_t dots) {
    return ef9365::clocks(dots + ef9365::start_up_clocks);
  }

  // A vector whose signs are in bits 2-0 of the command: an odd code moves along both axes, an even one along one.
  std::size_t directed_vector(std::uint8_t code, int dx, int dy) {
    constexpr std::array<std::int8_t, 8> sign_x{1, 1, 0, -1, 0, 1, -1, -1};
    constexpr std::array<std::int8_t, 8> sign_y{0, 1, 1, 1, -1, -1, 0, -1};
    return drawing_.vector(sign_x[code & 7U] * dx, sign_y[code & 7U] * dy);
  }

  core::Duration basic(std::uint8_t code) {
    core::Duration busy = ef9365::clocks(ef9365::register_command_clocks);
    switch (code) {
      case 0x00: drawing_.pen |= ef9365::Pen::writes; break;
      case 0x01: drawing_.pen &= static_cast<std::uint8_t>(~ef9365::Pen::writes); break;
      case 0x02: drawing_.pen |= ef9365::Pen::is_down; break;
      case 0x03: drawing_.pen &= static_cast<std::uint8_t>(~ef9365::Pen::is_down); break;
      case 0x04: busy = sweep_clear(); break;
      case 0x05: drawing_.x = drawing_.y = 0; break;
      case 0x06:
        drawing_.x = drawing_.y = 0;
        busy = sweep_clear();
        break;
      case 0x07:
        reset_registers();
        busy = sweep_clear();
        break;
      case 0x0A: busy = drawing_time(drawing_.symbol(ef9365::block_5x8)); break;
      case 0x0B: busy = drawing_time(drawing_.symbol(ef9365::block_4x4)); break;
      case 0x0C:
        drawing_.fill();
        busy = ef9365::sweep;
        break;
      case 0x0D: drawing_.x = 0; break;
      case 0x0E: drawing_.y = 0; break;
      case 0x0F:
        ++counts_.unanswered;
        busy = ef9365::clocks(ef9365::memory_access_clocks);
        break;
      default: ++counts_.unanswered; break;
    }
    return busy;
  }

  core::Duration sweep_clear() {
    drawing_.clear();
    return ef9365::sweep;
  }

  // Command 07: CSIZE to the smallest size, all other registers of the chip to 0; the latch is outside the chip.
  void reset_registers() {
    drawing_.x = drawing_.y = 0;
    drawing_.pen = drawing_.style = 0;
    drawing_.size = 0x11;
    delta_x_ = delta_y_ = 0;
    control_ = 0;
    raised_ = 0;
  }

  core::ClockRate rate_;
  std::array<core::TStates, 5> vector_times_{};  // of the small vectors, by their dots
  ef9365::Drawing drawing_;
  std::uint8_t delta_x_ = 0;
  std::uint8_t delta_y_ = 0;
  std::uint8_t control_ = 0;  // CTRL1's interrupt enables
  std::uint8_t raised_ = 0;   // status bits 4-6
  bool working_ = false;      // the end of the busy time has not been processed yet
  core::TStateInstant busy_until_{};
  core::TStateInstant next_blanking_{};
  Ef9365Counts counts_;
};

}  // namespace sightline::devices
