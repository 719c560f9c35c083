#include "host/guests/skala/guest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "emulators/machines/skala_ports.hpp"
#include "host/guests/run/i8080_processor.hpp"

namespace sightline::guests::skala {

namespace {

// --- what the devices say

void add(GuestPicture& picture, std::string_view what, std::uint64_t count) {
  if (count > 0) picture.faults.push_back({what, count});
}

// What of a device's counts is an error, and the dots no monitor shows.
void report_faults(const devices::Ef9365Counts& counts, GuestPicture& picture) {
  add(picture, "commands to the busy EF9365", counts.commands_while_busy);
  add(picture, "registers written while the EF9365 was busy", counts.writes_while_busy);
  add(picture, "things asked of the EF9365 that it cannot do", counts.unanswered);
  add(picture, "dots outside the EF9365's planes", counts.dots_outside);
}

void report_faults(const devices::Alt256Counts& counts, GuestPicture& picture) {
  add(picture, "bytes written to the ALT-256 before it was ready", counts.writes_lost);
  picture.dots_not_shown = counts.dots_invisible;
}

void report_faults(const devices::CalComp565Counts& counts, GuestPicture& picture) {
  add(picture, "commands to the busy CalComp", counts.commands_while_busy);
  add(picture, "steps off the CalComp's carriage", counts.off_carriage);
  add(picture, "codes the CalComp does not know", counts.unknown_codes);
  add(picture, "marks beside the CalComp's paper", counts.off_paper);
}

void report_faults(const devices::MinigrafCounts& counts, GuestPicture& picture) {
  add(picture, "steps the Minigraf's motors missed: too soon after the last", counts.missed_fast);
  add(picture, "steps the Minigraf's motors missed: phase changed by more than one", counts.missed_jump);
  add(picture, "steps before the Minigraf's pen had touched", counts.steps_early);
  add(picture, "steps off the Minigraf's field", counts.off_field);
}

// --- the ports

// Strokes of plotters, kept if they are wanted.
struct PortStrokes {
  static constexpr bool consumes = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    if (keep) marks.push_back(stroke);
  }
  void end_pass(core::Instant) {}
  bool keep = false;
  std::vector<core::Stroke> marks;
};

// The ports of a Skala run: those of the machine, stopping it where the link says that a block of commands
// has come or the next one is asked for, and noting every movement of a plotter. They own their sink, which
// the devices hold by reference from construction on.
class LinkPorts final : private PortStrokes, public run::I8080Ports, public machines::SkalaPorts<PortStrokes> {
 public:
  using Base = machines::SkalaPorts<PortStrokes>;

  explicit LinkPorts(const machines::SkalaConfiguration& configuration)
      : Base(configuration, static_cast<PortStrokes&>(*this)),
        plotter_(calcomp565() != nullptr || minigraf0507() != nullptr) {}

  void keep_strokes(bool kept) { keep = kept; }

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    const std::uint8_t value = Base::in(port, at);
    if (port >= first_link_port) note(port);
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    Base::out(port, value, at);
    if (plotter_) note_movement();
  }

  // Bytes counted from the first one of all.
  void stop_after_bytes(std::size_t count) {
    stop_at_ = count;
    at_link_ = false;
    stopped_ = taken_ >= stop_at_;
  }
  void stop_at_link() {
    never_stop();
    at_link_ = true;
  }
  void never_stop() {
    stop_at_ = std::numeric_limits<std::size_t>::max();
    at_link_ = false;
    stopped_ = false;
  }

  void report(GuestPicture& picture) {
    each_device([&picture](auto row, const auto& device) {
      constexpr machines::DeviceKind kind = decltype(row)::kind;
      if constexpr (kind == machines::DeviceKind::raster_board) picture.raster = device.raster();
      // A device without a report is one that the program never uses.
      if constexpr (requires { report_faults(device.counts(), picture); })
        report_faults(device.counts(), picture);
    });
    for (std::size_t port = 0; port < 256; ++port) {
      const machines::UnansweredPort& counts = unanswered()[port];
      if (counts.reads + counts.writes > 0)
        picture.unanswered.push_back({static_cast<std::uint8_t>(port), counts.reads, counts.writes});
    }
    picture.moves = std::move(moves_);
    picture.strokes = std::move(marks);
  }

 private:
  static constexpr std::uint8_t parallel_data = machines::ParallelRow::reads[0].first;
  static constexpr std::uint8_t serial_data = machines::SerialRow::reads[0].first;
  static constexpr std::uint8_t first_link_port = std::min(parallel_data, serial_data);

  void note(std::uint8_t port) {
    if (port == parallel_data || port == serial_data) ++taken_;
    if (at_link_ || taken_ >= stop_at_) stopped_ = true;
  }

  // What an output changed: a plotter is asked where it is, not what it was told.
  void note_movement() {
    if (calcomp565() != nullptr) note_movement(calcomp565()->place(), calcomp565()->pen_is_down());
    if (minigraf0507() != nullptr) note_movement(minigraf0507()->place(), minigraf0507()->pen_is_down());
  }
  void note_movement(devices::PlotterPlace place, bool pen_down) {
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

  bool plotter_;
  std::size_t taken_ = 0;
  std::size_t stop_at_ = std::numeric_limits<std::size_t>::max();
  bool at_link_ = false;
  devices::PlotterPlace place_{};
  bool pen_down_ = false;
  std::vector<PlotterMove> moves_;
};

// --- the run

// The way from the last byte's IN to DRAWIT is a few dozen instructions.
constexpr int longest_way_to_drawing = 200;

// How many bytes the program has taken at the end of each block, by its rule of receipt (SPECIFICATION,
// section 1). A stream with an unknown command or without END has fewer blocks than bytes.
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

// Generous: a command of three bytes steps through 255 points at most.
std::int64_t limit_for(std::size_t bytes, const GuestOptions& options) {
  const std::int64_t seconds = is_raster(options.device) ? 60 + static_cast<std::int64_t>(bytes) / 20
                                                         : 600 + static_cast<std::int64_t>(bytes);
  return seconds * std::max(options.clock.hertz, core::ClockRate{}.hertz);
}

machines::SkalaConfiguration configuration_for(std::span<const std::uint8_t> stream,
                                               const GuestOptions& options) {
  machines::SkalaConfiguration configuration;
  configuration.clock = options.clock;
  configuration.ef9365 = options.device == Device::ef9365;
  configuration.alt256 = options.device == Device::alt256;
  configuration.calcomp565 = options.device == Device::calcomp;
  configuration.minigraf0507 = options.device == Device::minigraf;
  (options.link == Link::serial ? configuration.serial : configuration.parallel) = stream;
  return configuration;
}

class GuestMachine {
 public:
  GuestMachine(const Program& program, std::span<const std::uint8_t> stream, const GuestOptions& options)
      : program_(program),
        blocks_(block_ends(stream)),
        ports_(std::make_unique<LinkPorts>(configuration_for(stream, options))),
        machine_(*ports_) {
    std::copy(program.memory.begin(), program.memory.end(), machine_.memory().begin());
    machine_.deposit(program.labels.link_switch, options.link == Link::serial ? 1 : 0);
    machine_.registers().pc = program.labels.start;
    ports_->keep_strokes(options.keep_strokes);
    limits_.until = core::at_t_state(options.t_state_limit > 0 ? options.t_state_limit
                                                               : limit_for(stream.size(), options));
  }

  GuestPicture picture() {
    GuestPicture result;
    machines::I8080StopReason reason = machines::I8080StopReason::ports;
    for (std::size_t block = 0; block < blocks_.size() && reason == machines::I8080StopReason::ports;
         ++block) {
      ports_->stop_after_bytes(blocks_[block]);
      reason = machine_.run(limits_);
      if (reason != machines::I8080StopReason::ports || !go_to_drawing()) break;
      ++result.blocks;
      const core::TStateInstant begun = machine_.now();
      ports_->stop_at_link();
      reason = machine_.run(limits_);
      result.drawing += end_of_drawing(begun, reason) - begun;
    }
    ports_->never_stop();
    if (reason == machines::I8080StopReason::ports) reason = machine_.run(limits_);
    result.ended = reason == machines::I8080StopReason::halt;
    report(result);
    return result;
  }

 private:
  // From the byte that completes a block.
  bool go_to_drawing() {
    ports_->never_stop();
    machines::I8080Limits one = limits_;
    one.instructions = 1;
    for (int n = 0; n < longest_way_to_drawing; ++n) {
      if (machine_.registers().pc == program_.labels.drawing) return true;
      if (machine_.run(one) != machines::I8080StopReason::instruction_limit) return false;
    }
    return false;
  }

  // The last block's drawing ends with its last dot, the others' with the next look at the link.
  [[nodiscard]] core::TStateInstant end_of_drawing(core::TStateInstant begun,
                                                   machines::I8080StopReason reason) {
    if (reason != machines::I8080StopReason::halt) return machine_.now();
    core::TStateInstant end = machine_.now();
    if (ports_->ef9365() != nullptr) end = ports_->ef9365()->busy_until();
    if (ports_->calcomp565() != nullptr) end = ports_->calcomp565()->busy_until();
    return end > begun ? end : machine_.now();
  }

  void report(GuestPicture& result) {
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
    ports_->report(result);
  }

  const Program& program_;
  std::vector<std::size_t> blocks_;
  std::unique_ptr<LinkPorts> ports_;  // large
  run::I8080Processor machine_;
  machines::I8080Limits limits_;
};

// --- guest and twin

constexpr int raster_width = core::Raster::width;

// Calls action(x, y) for every place until it returns true.
template <class Action>
void for_places(Action action) {
  for (int y = 0; y < raster_width; ++y)
    for (int x = 0; x < raster_width; ++x)
      if (action(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y))) return;
}

std::string difference(const core::Raster& guest, const core::Raster& twin) {
  std::string text;
  if (guest == twin) return text;
  for_places([&](std::uint8_t x, std::uint8_t y) {
    if (guest.at(x, y) == twin.at(x, y)) return false;
    text = fmt::format("dot ({}, {}): the program {}, its twin {}", x, y, guest.at(x, y), twin.at(x, y));
    return true;
  });
  return text;
}

std::string described(std::span<const PlotterMove> moves, std::size_t number) {
  if (number >= moves.size()) return "nothing more";
  constexpr std::array<std::string_view, 3> names{"a step to", "pen up at", "pen down at"};
  const PlotterMove& move = moves[number];
  return fmt::format("{} ({}, {})", names[static_cast<std::size_t>(move.action)], move.x, move.y);
}

std::string difference(std::span<const PlotterMove> guest, std::span<const PlotterMove> twin) {
  const auto [in_guest, in_twin] = std::mismatch(guest.begin(), guest.end(), twin.begin(), twin.end());
  if (in_guest == guest.end() && in_twin == twin.end()) return {};
  const auto number = static_cast<std::size_t>(in_guest - guest.begin());
  return fmt::format("movement {} of the plotter: the program {}, its twin {}", number + 1,
                     described(guest, number), described(twin, number));
}

// Of a surface's slices a plotter's program keeps nothing.
std::string difference(const Columns& guest, const Columns& twin, bool slices) {
  for (std::size_t x = 0; x < guest.mask_top.size(); ++x) {
    const auto said = [x](std::string_view mask, int in_guest, int in_twin) {
      return fmt::format("{} of column {}: the program {}, its twin {}", mask, x, in_guest, in_twin);
    };
    if (guest.mask_top[x] != twin.mask_top[x]) return said("mask top", guest.mask_top[x], twin.mask_top[x]);
    if (guest.mask_bottom[x] != twin.mask_bottom[x])
      return said("mask bottom", guest.mask_bottom[x], twin.mask_bottom[x]);
    if (!slices) continue;
    if (guest.previous_level[x] != twin.previous_level[x])
      return said("level of the previous slice", guest.previous_level[x], twin.previous_level[x]);
    if (guest.previous_level[x] != 0 && guest.previous_y[x] != twin.previous_y[x])
      return said("row of the previous slice", guest.previous_y[x], twin.previous_y[x]);
  }
  return {};
}

}  // namespace

GuestPicture run_guest(const Program& program, std::span<const std::uint8_t> stream,
                       const GuestOptions& options) {
  return GuestMachine(program, stream, options).picture();
}

std::string difference_from_twin(const GuestPicture& guest, const TwinPicture& twin, Device device) {
  if (guest.status != twin.status)
    return fmt::format("status: the program \"{}\", its twin \"{}\"", text_of(guest.status),
                       text_of(twin.status));
  std::string text;
  if (is_raster(device)) text = difference(guest.raster, twin.raster(device));
  if (text.empty()) text = difference(guest.moves, twin.moves);
  if (text.empty()) text = difference(guest.columns, twin.columns, is_raster(device));
  return text;
}

std::uint64_t points_lit(const GuestPicture& guest) {
  core::Raster marked = guest.raster;
  for (const PlotterMove& move : guest.moves)
    if (move.pen_down) marked.set(move.x, move.y, 1);
  const auto points = marked.points();
  return points.size() -
         static_cast<std::uint64_t>(std::count(points.begin(), points.end(), std::uint8_t{0}));
}

PlotterWork plotter_work(std::span<const PlotterMove> moves) {
  PlotterWork work;
  for (const PlotterMove& move : moves) {
    if (move.action == PlotterAction::step) {
      ++(move.pen_down ? work.steps_pen_down : work.steps_pen_up);
      work.time += devices::calcomp565::step;
    } else {
      work.pen_lifts += move.action == PlotterAction::pen_up ? 1 : 0;
      work.time += devices::calcomp565::pen;
    }
  }
  return work;
}

}  // namespace sightline::guests::skala
