// The CalComp 565 drum plotter (IBM 1627 model 1) behind a byte port with a status, port 60.
//
// A command of 0-7 makes one step of 0.01 inch: 0 is +y, then clockwise in eighths of a turn (1 +x+y, 2 +x, ... 7 -x+y);
// 08h lifts the pen, 09h lowers it. The drum moves the paper along x without limit, the carriage moves the pen along y,
// 0..1100 steps (11 inches). The plotter has no position sensor and no end stop to report: the driver board here counts. A
// step takes 3.333 ms, a pen command 100 ms, whether or not the pen moves.
//
// Status: bit 0 BUSY, bit 1 DONE (a command has ended; cleared by the next command), bit 2 PEN down, bit 7 ERROR (a command
// while busy, off the carriage, or an unknown code; cleared by the next accepted command). A step off the carriage moves
// the drum by its x part and takes its time. DONE can drive an interrupt: the line follows the bit.
//
// Strokes: one where the pen comes down and one at the end of every step made with the pen down, with the time at which
// that command ends; they are emitted when the command is given. Intensity 7, address 0. Drum positions that a Stroke
// cannot hold (below 0, above 65535) are only counted: choose the start position accordingly. Sources: ibm1130.net (1627
// functional description), retro-1620's Plotter.js (codes, periods), PDP-X memo 15; the byte port and its status are chosen
// here.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "plotter.hpp"

namespace sightline::devices {

namespace calcomp565 {
inline constexpr core::Duration step{3'333'333};   // 18,000 a minute
inline constexpr core::Duration pen{100'000'000};  // 600 a minute
inline constexpr std::int32_t carriage_steps = 1100;
inline constexpr std::uint8_t pen_up = 0x08;
inline constexpr std::uint8_t pen_down = 0x09;
}  // namespace calcomp565

struct CalComp565Counts {
  std::uint64_t steps = 0;         // executed, pen up or down
  std::uint64_t steps_pen_up = 0;  // those of them with the pen up
  std::uint64_t pen_lifts = 0;     // down to up
  std::uint64_t pen_commands = 0;  // 08h and 09h executed
  std::uint64_t commands_while_busy = 0;
  std::uint64_t off_carriage = 0;
  std::uint64_t unknown_codes = 0;
  std::uint64_t off_paper = 0;  // strokes whose x is out of a Stroke's range
  core::TStates busy{};         // sum of all busy times
};

class CalComp565 final : public core::PortDevice {
 public:
  static constexpr std::array ports{core::PortRange{0x60, 0x60}};
  static constexpr std::array<std::string_view, 1> lines{"calcomp"};  // on DONE
  static constexpr std::array options{
      core::DeviceOption{"start-x", "place of the pen along the paper, in steps", 0, std::numeric_limits<std::int32_t>::min(),
                         std::numeric_limits<std::int32_t>::max()},
      core::DeviceOption{"start-y", "place of the pen across the paper, in steps", 0, 0, calcomp565::carriage_steps}};
  static constexpr core::PortDeviceInfo info{.name = "calcomp565",
                                             .help = "CalComp 565 drum plotter, steps of 0.01 inch",
                                             .choice = "calcomp",
                                             .kind = core::PortDeviceKind::plotter,
                                             .reads = ports,
                                             .writes = ports,
                                             .lines = lines,
                                             .options = options};

  explicit CalComp565(const core::PortDeviceSetup& setup)
      : CalComp565(setup.clock, setup.strokes,
                   {static_cast<std::int32_t>(setup.value(info, "start-x")), static_cast<std::int32_t>(setup.value(info, "start-y"))}) {}
  // The pen starts up, at `start`. The strokes must outlive the plotter.
  CalComp565(core::ClockRate rate, core::StrokeBuffer& strokes, PlotterPlace start = {})
      : rate_(rate),
        step_time_(rate.t_states_in(calcomp565::step)),
        pen_time_(rate.t_states_in(calcomp565::pen)),
        strokes_(strokes),
        place_(start) {}

  struct Status {
    static constexpr std::uint8_t busy = 0x01;
    static constexpr std::uint8_t done = 0x02;
    static constexpr std::uint8_t pen = 0x04;
    static constexpr std::uint8_t error = 0x80;
  };

  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant at) override { return read_status(at); }
  void out(std::uint8_t, std::uint8_t value, core::TStateInstant at) override { write(value, at); }
  [[nodiscard]] unsigned requests() const override { return done_ ? 1 : 0; }
  [[nodiscard]] std::int64_t micrometres_per_step() const override { return 254; }

  [[nodiscard]] std::uint8_t read_status(core::TStateInstant at) {
    advance(at);
    unsigned bits = 0;
    if (busy_) bits |= Status::busy;
    if (done_) bits |= Status::done;
    if (pen_down_) bits |= Status::pen;
    if (error_) bits |= Status::error;
    return static_cast<std::uint8_t>(bits);
  }

  void write(std::uint8_t code, core::TStateInstant at) {
    advance(at);
    if (busy_) {
      ++counts_.commands_while_busy;
      error_ = true;
      return;
    }
    if (code > calcomp565::pen_down) {
      ++counts_.unknown_codes;
      error_ = true;
      return;
    }
    error_ = done_ = false;
    if (code >= calcomp565::pen_up)
      move_pen(code == calcomp565::pen_down, at);
    else
      step(code, at);
  }

  void advance(core::TStateInstant now) override {
    if (!busy_ || now < busy_until_) return;
    busy_ = false;
    done_ = true;
  }
  // When DONE rises.
  [[nodiscard]] core::TStateInstant deadline() const override { return busy_ ? busy_until_ : core::never_t; }
  [[nodiscard]] bool done() const { return done_; }

  [[nodiscard]] PlotterPlace place() const { return place_; }
  [[nodiscard]] bool pen_is_down() const { return pen_down_; }
  [[nodiscard]] core::TStateInstant busy_until() const { return busy_until_; }
  [[nodiscard]] const CalComp565Counts& totals() const { return counts_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"steps", counts_.steps},
            {"steps_pen_up", counts_.steps_pen_up},
            {"pen_lifts", counts_.pen_lifts},
            {"pen_commands", counts_.pen_commands},
            {"commands_while_busy", counts_.commands_while_busy},
            {"off_carriage", counts_.off_carriage},
            {"unknown_codes", counts_.unknown_codes},
            {"off_paper", counts_.off_paper},
            {"busy_t_states", static_cast<std::uint64_t>(counts_.busy.count())}};
  }

  void visit_state(core::StateVisitor& visit) override {
    visit("place_x", place_.x);
    visit("place_y", place_.y, calcomp565::carriage_steps);
    visit("pen_down", pen_down_);
    visit("busy", busy_);
    visit("done", done_);
    visit("error", error_);
    visit("busy_until", busy_until_);
    visit("steps", counts_.steps);
    visit("steps_pen_up", counts_.steps_pen_up);
    visit("pen_lifts", counts_.pen_lifts);
    visit("pen_commands", counts_.pen_commands);
    visit("commands_while_busy", counts_.commands_while_busy);
    visit("off_carriage", counts_.off_carriage);
    visit("unknown_codes", counts_.unknown_codes);
    visit("off_paper", counts_.off_paper);
    visit("busy_time", counts_.busy);
  }

 private:
  static constexpr std::array<std::int8_t, 8> along_x{0, 1, 1, 1, 0, -1, -1, -1};
  static constexpr std::array<std::int8_t, 8> along_y{1, 1, 0, -1, -1, -1, 0, 1};

  void work(core::TStates busy, core::TStateInstant at) {
    busy_ = true;
    busy_until_ = at + busy;
    counts_.busy += busy;
  }

  void step(std::uint8_t direction, core::TStateInstant at) {
    work(step_time_, at);
    ++counts_.steps;
    place_.x = step_coordinate(place_.x, along_x[direction]);
    const std::int32_t wanted = step_coordinate(place_.y, along_y[direction]);
    place_.y = std::clamp(wanted, std::int32_t{0}, calcomp565::carriage_steps);
    if (wanted != place_.y) {
      ++counts_.off_carriage;
      error_ = true;
    }
    if (pen_down_)
      emit();
    else
      ++counts_.steps_pen_up;
  }

  void move_pen(bool down, core::TStateInstant at) {
    work(pen_time_, at);
    ++counts_.pen_commands;
    if (pen_down_ && !down) ++counts_.pen_lifts;
    const bool touches = down && !pen_down_;
    pen_down_ = down;
    if (touches) emit();
  }

  void emit() {
    if (!mark(strokes_, place_, rate_.to_nanoseconds(busy_until_))) ++counts_.off_paper;
  }

  core::ClockRate rate_;
  core::TStates step_time_;
  core::TStates pen_time_;
  core::StrokeBuffer& strokes_;
  PlotterPlace place_;
  bool pen_down_ = false;
  bool busy_ = false;
  bool done_ = false;
  bool error_ = false;
  core::TStateInstant busy_until_{};
  CalComp565Counts counts_;
};

}  // namespace sightline::devices
