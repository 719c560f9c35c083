// The Aritma Minigraf 0507 plotter, whose stepping motors are driven directly from one output port, F0.
//
// Bits 2-0 are the phase of the X motor, 5-3 that of the Y motor: one more (modulo 8) is a step of 1/8 mm forward, one less
// a step back, both in one byte a diagonal. Bit 7 lowers the pen, bit 6 is not connected. There is no status. A motor
// misses a step that comes too soon after its last, and any change of phase by 2 to 6: it stays where it is, the program's
// position is wrong from then on, and only the count shows it. After power-on both phases are 0 and the pen is up.
//
// The field is 1500 by 2100 steps. Nothing stops the pen at its edge, as the maker warns: steps beyond are made and
// counted. The speed of the motors and of the pen is unknown (machines of 1985 were 40 per cent slower than later ones):
// both are parameters. A step made before the pen has touched draws nothing and is counted. Strokes: one where the pen is
// lowered (with the time it touches) and one for each port write that moved a lowered pen, at the instant of the write; a
// pen lowered in the same write as a step touches where the step ends. Intensity 7, address 0. A position left of or below
// the field cannot be a Stroke and is only counted. Sources: the maker's description for the PMD-85 (sapi.cz 0507_pmd85),
// MAME's iq151 minigraf for the bits.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "plotter.hpp"

namespace sightline::devices {

namespace minigraf0507 {
inline constexpr std::int32_t width = 1500;  // steps of 1/8 mm
inline constexpr std::int32_t height = 2100;
inline constexpr std::uint8_t pen_bit = 0x80;
}  // namespace minigraf0507

struct MinigrafTimes {
  core::Duration shortest_step{3'333'333};  // of one motor; chosen: 300 a second
  core::Duration pen{0};                    // from the command until it touches
};

struct MinigrafCounts {
  std::uint64_t steps = 0;         // port writes that moved the pen, up or down
  std::uint64_t steps_pen_up = 0;  // those of them with the pen up
  std::uint64_t pen_lifts = 0;
  std::uint64_t missed_fast = 0;  // steps of a motor that came too soon after its last
  std::uint64_t missed_jump = 0;  // phases changed by more than one
  std::uint64_t steps_early = 0;  // before the lowered pen had touched; also in steps_pen_up
  std::uint64_t off_field = 0;
};

class Minigraf0507 final : public core::PortDevice {
 public:
  static constexpr std::array writes{core::PortRange{0xF0, 0xF0}};
  static constexpr std::array options{
      core::DeviceOption{"shortest-step", "least time between two steps of a motor, in nanoseconds",
                         MinigrafTimes{}.shortest_step.count(), 0, 1'000'000'000},
      core::DeviceOption{"pen-time", "from the order to lower the pen until it touches, in nanoseconds", MinigrafTimes{}.pen.count(), 0,
                         1'000'000'000}};
  static constexpr core::PortDeviceInfo info{.name = "minigraf0507",
                                             .help = "Aritma Minigraf 0507 plotter, steps of 1/8 mm",
                                             .choice = "minigraf",
                                             .kind = core::PortDeviceKind::plotter,
                                             .writes = writes,
                                             .options = options};

  explicit Minigraf0507(const core::PortDeviceSetup& setup)
      : Minigraf0507(setup.clock, setup.strokes,
                     {core::Duration(setup.value(info, "shortest-step")), core::Duration(setup.value(info, "pen-time"))}) {}
  // The strokes must outlive the plotter.
  Minigraf0507(core::ClockRate rate, core::StrokeBuffer& strokes, MinigrafTimes times = {}, PlotterPlace start = {})
      : rate_(rate),
        shortest_step_(rate.t_states_in(times.shortest_step)),
        pen_time_(rate.t_states_in(times.pen)),
        strokes_(strokes),
        place_(start) {}

  void out(std::uint8_t, std::uint8_t value, core::TStateInstant at) override { write(value, at); }
  [[nodiscard]] std::int64_t micrometres_per_step() const override { return 125; }

  void write(std::uint8_t value, core::TStateInstant at) {
    const std::int32_t dx = x_.follow(value & 7U, at, shortest_step_, counts_);
    const std::int32_t dy = y_.follow((value >> 3) & 7U, at, shortest_step_, counts_);
    const bool was_down = pen_down_;
    set_pen((value & minigraf0507::pen_bit) != 0, at);
    if (dx != 0 || dy != 0) move(dx, dy, was_down, at);
    if (pen_down_ && !was_down) mark(strokes_, place_, rate_.to_nanoseconds(touches_at_));
  }

  [[nodiscard]] PlotterPlace place() const { return place_; }
  [[nodiscard]] bool pen_is_down() const { return pen_down_; }
  [[nodiscard]] const MinigrafCounts& totals() const { return counts_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"steps", counts_.steps},
            {"steps_pen_up", counts_.steps_pen_up},
            {"pen_lifts", counts_.pen_lifts},
            {"missed_fast", counts_.missed_fast},
            {"missed_jump", counts_.missed_jump},
            {"steps_early", counts_.steps_early},
            {"off_field", counts_.off_field}};
  }

  void visit_state(core::StateVisitor& visit) override {
    visit("place_x", place_.x);
    visit("place_y", place_.y);
    visit.part("x", x_);
    visit.part("y", y_);
    visit("pen_down", pen_down_);
    visit("touches_at", touches_at_);
    visit("steps", counts_.steps);
    visit("steps_pen_up", counts_.steps_pen_up);
    visit("pen_lifts", counts_.pen_lifts);
    visit("missed_fast", counts_.missed_fast);
    visit("missed_jump", counts_.missed_jump);
    visit("steps_early", counts_.steps_early);
    visit("off_field", counts_.off_field);
  }

 private:
  struct Motor {
    std::uint8_t phase = 0;
    bool moved = false;
    core::TStateInstant last{};

    void visit_state(core::StateVisitor& visit) {
      visit("phase", phase, std::uint8_t{7});
      visit("moved", moved);
      visit("last", last);
    }

    // The step made: -1, 0 or 1.
    std::int32_t follow(std::uint8_t wanted, core::TStateInstant at, core::TStates shortest,
                        MinigrafCounts& counts) {
      const unsigned change = (wanted - phase) & 7U;
      phase = wanted;
      if (change == 0) return 0;
      if (change != 1 && change != 7) {
        ++counts.missed_jump;
        return 0;
      }
      if (moved && at - last < shortest) {
        ++counts.missed_fast;
        return 0;
      }
      moved = true;
      last = at;
      return change == 1 ? 1 : -1;
    }
  };

  void set_pen(bool down, core::TStateInstant at) {
    if (pen_down_ && !down) ++counts_.pen_lifts;
    if (down && !pen_down_) touches_at_ = at + pen_time_;
    pen_down_ = down;
  }

  void move(std::int32_t dx, std::int32_t dy, bool lowered_before, core::TStateInstant at) {
    place_ = {step_coordinate(place_.x, dx), step_coordinate(place_.y, dy)};
    ++counts_.steps;
    if (place_.x < 0 || place_.x > minigraf0507::width || place_.y < 0 || place_.y > minigraf0507::height)
      ++counts_.off_field;
    const bool drawing = pen_down_ && lowered_before && touches_at_ <= at;
    if (drawing)
      mark(strokes_, place_, rate_.to_nanoseconds(at));
    else
      ++counts_.steps_pen_up;
    if (pen_down_ && lowered_before && !drawing) ++counts_.steps_early;
  }

  core::ClockRate rate_;
  core::TStates shortest_step_;
  core::TStates pen_time_;
  core::StrokeBuffer& strokes_;
  PlotterPlace place_;
  Motor x_;
  Motor y_;
  bool pen_down_ = false;
  core::TStateInstant touches_at_{};
  MinigrafCounts counts_;
};

}  // namespace sightline::devices
