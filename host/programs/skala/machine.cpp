#include "host/programs/skala/machine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "emulators/devices/alt256.hpp"
#include "emulators/devices/calcomp565.hpp"
#include "emulators/devices/ef9365.hpp"
#include "emulators/devices/minigraf0507.hpp"
#include "emulators/devices/parallel_link.hpp"
#include "emulators/devices/serial_link.hpp"
#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_front.hpp"
#include "host/base/result.hpp"
#include "host/machines/i8080_run_to.hpp"

namespace sightline::programs::skala {

namespace {

// --- Reports of the devices

void add(MachinePicture& picture, std::string_view what, std::uint64_t count) {
  if (count > 0) picture.faults.push_back({what, count});
}

// Adds those of a device's counts that are errors, and the dots that no monitor shows.
void report_faults(const devices::Ef9365Counts& counts, MachinePicture& picture) {
  add(picture, "commands to the busy EF9365", counts.commands_while_busy);
  add(picture, "registers written while the EF9365 was busy", counts.writes_while_busy);
  add(picture, "operations that the EF9365 does not support", counts.unanswered);
  add(picture, "dots outside the EF9365's planes", counts.dots_outside);
}

void report_faults(const devices::Alt256Counts& counts, MachinePicture& picture) {
  add(picture, "bytes written to the ALT-256 before it was ready", counts.writes_lost);
  picture.dots_not_shown = counts.dots_invisible;
}

void report_faults(const devices::CalComp565Counts& counts, MachinePicture& picture) {
  add(picture, "commands to the busy CalComp", counts.commands_while_busy);
  add(picture, "steps off the CalComp's carriage", counts.off_carriage);
  add(picture, "codes the CalComp does not know", counts.unknown_codes);
  add(picture, "marks beside the CalComp's paper", counts.off_paper);
}

void report_faults(const devices::MinigrafCounts& counts, MachinePicture& picture) {
  add(picture, "steps the Minigraf's motors missed: too soon after the last", counts.missed_fast);
  add(picture, "steps the Minigraf's motors missed: phase changed by more than one", counts.missed_jump);
  add(picture, "steps before the Minigraf's pen had touched", counts.steps_early);
  add(picture, "steps off the Minigraf's field", counts.off_field);
}

// --- In front of the ports

// Ends the run where the links show that a block of commands has arrived, or that the next one is requested.
class LinkFront final : public i8080::Front {
 public:
  explicit LinkFront(i8080::Machine& machine) : Front(machine, both_links) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    const std::uint8_t value = Front::in(port, at);
    if (port == parallel_data || port == serial_data) ++taken_;
    if (at_any_ || taken_ >= stop_at_) machine().request_stop();
    return value;
  }

  // Counted from the first byte of the stream.
  void stop_after_bytes(std::size_t count) {
    stop_at_ = count;
    at_any_ = false;
    if (taken_ >= stop_at_) machine().request_stop();
  }
  // Stops the run when the program next requests input.
  void stop_at_once() {
    never_stop();
    at_any_ = true;
  }
  void never_stop() {
    stop_at_ = std::numeric_limits<std::size_t>::max();
    at_any_ = false;
  }

 private:
  static constexpr std::array both_links{devices::ParallelLink::info.reads[0], devices::SerialLink::info.reads[0]};
  static constexpr std::uint8_t parallel_data = both_links[0].first;
  static constexpr std::uint8_t serial_data = both_links[1].first;

  std::size_t taken_ = 0;
  std::size_t stop_at_ = std::numeric_limits<std::size_t>::max();
  bool at_any_ = false;
};

// Records every movement of a plotter by its position, not by its commands.
class PlotterFront final : public i8080::Front {
 public:
  explicit PlotterFront(i8080::Machine& machine)
      : Front(machine, both_plotters), calcomp_(machine.find<devices::CalComp565>()), minigraf_(machine.find<devices::Minigraf0507>()) {}

  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    Front::out(port, value, at);
    if (calcomp_ != nullptr) note(calcomp_->place(), calcomp_->pen_is_down());
    if (minigraf_ != nullptr) note(minigraf_->place(), minigraf_->pen_is_down());
  }
  [[nodiscard]] std::vector<PlotterMove> take_moves() { return std::move(moves_); }

 private:
  void note(devices::PlotterPlace place, bool pen_down) {
    if (place != place_) add(PlotterAction::step, place, pen_down_);
    if (pen_down != pen_down_)
      add(pen_down ? PlotterAction::pen_down : PlotterAction::pen_up, place, pen_down);
    place_ = place;
    pen_down_ = pen_down;
  }
  void add(PlotterAction action, devices::PlotterPlace place, bool pen_down) {
    moves_.push_back(
        {action, static_cast<std::uint8_t>(place.x), static_cast<std::uint8_t>(place.y), pen_down});
  }

  static constexpr std::array both_plotters{devices::CalComp565::info.writes[0], devices::Minigraf0507::info.writes[0]};

  const devices::CalComp565* calcomp_;  // null: not attached
  const devices::Minigraf0507* minigraf_;
  devices::PlotterPlace place_{};
  bool pen_down_ = false;
  std::vector<PlotterMove> moves_;
};

struct KeptStrokes final : core::StrokeTaker {
  void strokes(std::span<const core::Stroke> strokes) override { marks.insert(marks.end(), strokes.begin(), strokes.end()); }
  std::vector<core::Stroke> marks;
};

// --- The run

// From the last byte's IN to DRAWIT the program executes a few dozen instructions.
constexpr std::uint64_t longest_way_to_drawing = 200;

// The number of bytes that the program has received at the end of each block, by its rules (SPECIFICATION, section 1). A
// stream with an unknown command or without END has bytes after its last block.
std::vector<std::size_t> block_ends(std::span<const std::uint8_t> stream) {
  std::vector<std::size_t> ends;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < stream.size();) {
    const auto row = find_command(stream[at]);
    if (!row) break;
    std::size_t length = 1 + static_cast<std::size_t>(row->leading_arguments);
    if (row->bytes_per_item != 0) {
      if (at + length > stream.size()) break;
      length += static_cast<std::size_t>(count_of(stream[at + length - 1]) * row->bytes_per_item);
    }
    at += length;
    if (at > stream.size()) break;
    const bool last = row->command == Command::end;
    if (last || at - begin + buffer_reserve > buffer_bytes) {
      ends.push_back(at);
      begin = at;
    }
    if (last) break;
  }
  return ends;
}

// An upper bound: a command of three bytes steps through at most 255 points.
std::int64_t limit_for(std::size_t bytes, const MachineOptions& options) {
  const std::int64_t seconds = is_raster(options.device) ? 60 + static_cast<std::int64_t>(bytes) / 20
                                                         : 600 + static_cast<std::int64_t>(bytes);
  return seconds * std::max(options.clock.hertz, core::ClockRate{}.hertz);
}

std::string_view name_of(Device device) {
  switch (device) {
    case Device::ef9365: return devices::Ef9365::info.name;
    case Device::alt256: return devices::Alt256::info.name;
    case Device::calcomp: return devices::CalComp565::info.name;
    case Device::minigraf: return devices::Minigraf0507::info.name;
  }
  return {};
}

// A machine with the devices of a run. It is part of this executable, so an error ends the process.
class SkalaMachine : public i8080::Machine {
 public:
  SkalaMachine(std::span<const std::uint8_t> stream, const MachineOptions& options) : i8080::Machine({options.clock}) {
    const std::string_view link = options.link == Link::serial ? devices::SerialLink::info.name : devices::ParallelLink::info.name;
    for (const std::string_view name : {name_of(options.device), link})
      if (const std::string error = attach(name); !error.empty()) base::give_up(error);
    device(link)->link_host()->send(stream);
  }
};

class MeasuredRun {
 public:
  MeasuredRun(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options)
      : program_(program), blocks_(block_ends(stream)), machine_(stream, options) {
    machine_.load(0, program.memory);
    machine_.deposit(program.labels.link_switch, options.link == Link::serial ? 1 : 0);
    machine_.start(program.labels.start);
    if (options.keep_strokes) machine_.strokes().hand_to(&strokes_);
    limits_.until = core::at_t_state(options.t_state_limit > 0 ? options.t_state_limit
                                                               : limit_for(stream.size(), options));
  }

  MachinePicture picture() {
    using i8080::StopReason;
    MachinePicture result;
    StopReason reason = StopReason::device;
    for (std::size_t block = 0; block < blocks_.size() && reason == StopReason::device; ++block) {
      link_.stop_after_bytes(blocks_[block]);
      reason = machine_.run(limits_);
      if (reason != StopReason::device || !go_to_drawing()) break;
      ++result.blocks;
      const core::TStateInstant begun = machine_.now();
      link_.stop_at_once();
      reason = machine_.run(limits_);
      result.drawing += end_of_drawing(begun, reason) - begun;
    }
    link_.never_stop();
    if (reason == StopReason::device) reason = machine_.run(limits_);
    result.ended = reason == StopReason::halt;
    report(result);
    return result;
  }

 private:
  // Runs from the byte that completes a block to the beginning of its drawing.
  bool go_to_drawing() {
    link_.never_stop();
    if (machine_.registers().pc == program_.labels.drawing) return true;
    i8080::Limits limits = limits_;
    limits.instructions = longest_way_to_drawing;
    return machines::run_to(machine_, program_.labels.drawing, limits) == i8080::StopReason::observer;
  }

  // The last block's drawing ends with its last dot, that of the others when the program next polls the link.
  [[nodiscard]] core::TStateInstant end_of_drawing(core::TStateInstant begun, i8080::StopReason reason) const {
    if (reason != i8080::StopReason::halt) return machine_.now();
    core::TStateInstant end = machine_.now();
    if (const auto* const board = machine_.find<devices::Ef9365>(); board != nullptr) end = board->busy_until();
    if (const auto* const plotter = machine_.find<devices::CalComp565>(); plotter != nullptr) end = plotter->busy_until();
    return end > begun ? end : machine_.now();
  }

  void report(MachinePicture& result) {
    const auto page = [&](i8080::Address from, std::array<std::uint8_t, 256>& to) {
      std::copy_n(machine_.memory().begin() + from, to.size(), to.begin());
    };
    result.status = static_cast<Status>(machine_.peek(program_.labels.status));
    page(program_.labels.mask_top, result.columns.mask_top);
    page(program_.labels.mask_bottom, result.columns.mask_bottom);
    page(program_.labels.previous_row, result.columns.previous_y);
    page(program_.labels.previous_level, result.columns.previous_level);
    result.total = machine_.now().time_since_epoch();
    result.instructions = machine_.instructions();
    result.moves = plotter_.take_moves();
    result.strokes = std::move(strokes_.marks);
    for (const i8080::AttachedDevice& each : machine_.devices())
      if (const core::Raster* const raster = each.device->raster(); raster != nullptr) result.raster = *raster;
    report_faults_of<devices::Ef9365>(result);
    report_faults_of<devices::Alt256>(result);
    report_faults_of<devices::CalComp565>(result);
    report_faults_of<devices::Minigraf0507>(result);
    for (std::size_t port = 0; port < 256; ++port) {
      const i8080::UnansweredPort& counts = machine_.unanswered()[port];
      if (counts.reads + counts.writes > 0)
        result.unanswered.push_back({static_cast<std::uint8_t>(port), counts.reads, counts.writes});
    }
  }
  template <class Device>
  void report_faults_of(MachinePicture& picture) const {
    if (const Device* const device = machine_.find<Device>(); device != nullptr) report_faults(device->totals(), picture);
  }

  const Program& program_;
  std::vector<std::size_t> blocks_;
  KeptStrokes strokes_;
  SkalaMachine machine_;
  LinkFront link_{machine_};
  PlotterFront plotter_{machine_};
  i8080::Limits limits_;
};

}  // namespace

MachinePicture run_machine(const Program& program, std::span<const std::uint8_t> stream,
                       const MachineOptions& options) {
  return MeasuredRun(program, stream, options).picture();
}

std::uint64_t points_lit(const MachinePicture& picture) {
  core::Raster marked = picture.raster;
  for (const PlotterMove& move : picture.moves)
    if (move.pen_down) marked.set(move.x, move.y, 1);
  const auto points = marked.points();
  return points.size() -
         static_cast<std::uint64_t>(std::count(points.begin(), points.end(), std::uint8_t{0}));
}

}  // namespace sightline::programs::skala
