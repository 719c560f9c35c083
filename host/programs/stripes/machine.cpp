#include "host/programs/stripes/machine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/devices/calcomp565.hpp"
#include "emulators/devices/ef9365.hpp"
#include "emulators/devices/parallel_link.hpp"
#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_front.hpp"
#include "host/base/result.hpp"

namespace sightline::programs::stripes {

namespace {

// Records the commands to the plotter. Ends a run where the program begins to wait for the plotter and where it can stop
// waiting: between them nothing has to be observed, and a run without an observer is faster.
class PlotterFront final : public i8080::Front {
 public:
  explicit PlotterFront(i8080::Machine& machine)
      : Front(machine, devices::CalComp565::info.writes), plotter_(*machine.find<devices::CalComp565>()) {}
  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    // A busy plotter does not change, and none of its lines has to be polled.
    if (waiting_ && at < plotter_.busy_until()) return plotter_.read_status(at);
    const std::uint8_t status = Front::in(port, at);
    const bool busy = (status & devices::CalComp565::Status::busy) != 0;
    if (busy != waiting_) machine().request_stop();
    waiting_ = busy;
    return status;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    commands.push_back(value);
    Front::out(port, value, at);
  }

  [[nodiscard]] bool waiting() const { return waiting_; }

  std::vector<std::uint8_t> commands;

 private:
  devices::CalComp565& plotter_;
  bool waiting_ = false;
};

// The number of toggles in the list at `at`.
std::uint32_t toggles_at(const i8080::Machine& machine, i8080::Address at) {
  const auto list = machine.memory().subspan(at);
  return static_cast<std::uint32_t>(std::find(list.begin(), list.end(), std::uint8_t{picture_size}) - list.begin());
}

// Counts faces on the raster board, where the program writes a face's colour before it draws the face: then the face's
// stripes are complete, and the silhouette is that of all faces before it.
class ColourFront final : public i8080::Front {
 public:
  ColourFront(i8080::Machine& machine, const Labels& labels) : Front(machine, colour), labels_(labels) {}
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    Front::out(port, value, at);
    count_silhouette();
    low_ = machine().peek(labels_.lines);
    high_ = machine().peek(static_cast<i8080::Address>(labels_.lines + 1));
    for (int line = low_; line < high_; ++line)
      face_most_ = std::max(face_most_, toggles_at(machine(), static_cast<i8080::Address>(labels_.face_slots + 16 * line)));
  }

  // Called at the end of the run.
  void add_to(Counts& counts) {
    count_silhouette();
    counts.face_most = face_most_;
    counts.silhouette_most = silhouette_most_;
  }

 private:
  static constexpr core::PortRange colour[]{{0x50, 0x50}};

  // Counts the lines that the last face has changed.
  void count_silhouette() {
    for (int line = low_; line < high_; ++line)
      silhouette_most_ = std::max(silhouette_most_, toggles_at(machine(), static_cast<i8080::Address>(labels_.silhouette_slots + 32 * line)));
  }

  const Labels& labels_;
  int low_ = 0;
  int high_ = 0;
  std::uint32_t face_most_ = 0;
  std::uint32_t silhouette_most_ = 0;
};

// The machine is part of this executable, so an error ends the process.
void attach(i8080::Machine& machine, std::string_view device) {
  if (const std::string error = machine.attach(device); !error.empty()) base::give_up(error);
}

void add_faults(const devices::Ef9365Counts& counts, MachinePicture& picture) {
  const auto add = [&picture](std::string_view what, std::uint64_t count) {
    if (count > 0) picture.faults.push_back({what, count});
  };
  add("commands to the busy EF9365", counts.commands_while_busy);
  add("registers written while the EF9365 was busy", counts.writes_while_busy);
  add("operations that the EF9365 does not support", counts.unanswered);
  add("dots outside the EF9365's planes", counts.dots_outside);
}

void add_faults(const devices::CalComp565Counts& counts, MachinePicture& picture) {
  const auto add = [&picture](std::string_view what, std::uint64_t count) {
    if (count > 0) picture.faults.push_back({what, count});
  };
  add("commands to the busy CalComp", counts.commands_while_busy);
  add("steps off the CalComp's carriage", counts.off_carriage);
  add("codes the CalComp does not know", counts.unknown_codes);
  add("marks beside the CalComp's paper", counts.off_paper);
}

// Records when the program reaches its parts, and counts its work in them.
class WorkObserver final : public i8080::Observer {
 public:
  // `whole`: observes the drawing too; otherwise the run ends where drawing begins.
  WorkObserver(const i8080::Machine& machine, const Labels& labels, std::size_t faces, bool whole)
      : machine_(machine), labels_(labels), faces_(faces), whole_(whole) {
    for (const i8080::Address place : {labels.check, labels.drawing, labels.tests, labels.sides, labels.common, labels.first_hides,
                                       labels.second_hides, labels.hides, labels.classes, labels.deleted, labels.line_done})
      places_[place] = i8080::mark::stop;
    marks = places_.data();
  }

  [[nodiscard]] bool stop(core::TStateInstant now, i8080::Address next) override {
    if (places_[next] == 0) return false;
    if (next == labels_.check) check_ = now;
    if (next == labels_.drawing) drawing_ = now;
    if (next == labels_.drawing && !whole_) return true;
    if (next == labels_.line_done) count_line();
    if (next == labels_.deleted) ++deletions_;
    if (next == labels_.hides) ++counts_.relations;
    if (next == labels_.tests) begin_pair();
    if (next == labels_.classes) end_pairs();
    if (test_ == 0) return false;
    if (next == labels_.sides) test_ = 4;
    if (next == labels_.common) test_ = 6;
    if (next == labels_.first_hides || next == labels_.second_hides) {
      if (test_ == 2) test_ = 3;
      if (test_ == 4 && next == labels_.second_hides) test_ = 5;
    }
    return false;
  }

  // The times at which the program reached its labels; never_t if it did not.
  [[nodiscard]] core::TStateInstant check() const { return check_; }
  [[nodiscard]] core::TStateInstant drawing() const { return drawing_; }
  // Called at the end of the run.
  [[nodiscard]] Counts counts() const {
    Counts counts = counts_;
    counts.cuts = machine_.peek(labels_.cuts);
    counts.deleted = deletions_ - std::min(deletions_, counts.cuts);
    return counts;
  }

 private:
  void begin_pair() {
    end_pair();
    ++pairs_;
    test_ = 2;
  }
  void end_pair() {
    if (test_ != 0) ++counts_.decided_by[test_];
    test_ = 0;
  }
  // Pairs that reach no other test are decided by the first.
  void end_pairs() {
    if (ranked_) return;
    ranked_ = true;
    end_pair();
    counts_.decided_by[1] = static_cast<std::uint32_t>(faces_ * (faces_ - 1) / 2 - pairs_);
  }

  void count_line() {
    const auto word = [this](i8080::Address at) {
      return static_cast<i8080::Address>(machine_.peek(at) | machine_.peek(static_cast<i8080::Address>(at + 1)) << 8U);
    };
    counts_.face_most = std::max(counts_.face_most, toggles_at(machine_, word(labels_.face_line)));
    counts_.silhouette_most = std::max(counts_.silhouette_most, toggles_at(machine_, word(labels_.shadow_line)));
    bool inside = false;
    std::uint32_t from = 0;
    for (auto at = static_cast<i8080::Address>(labels_.difference - 1);; at = static_cast<i8080::Address>(at - 2)) {
      const std::uint32_t toggle = machine_.peek(at);
      if (inside) counts_.dots += toggle - from;
      if (toggle == picture_size) break;
      from = toggle;
      inside = !inside;
    }
  }

  const i8080::Machine& machine_;
  const Labels& labels_;
  std::vector<std::uint8_t> places_ = std::vector<std::uint8_t>(0x10000);
  core::TStateInstant check_ = core::never_t;
  core::TStateInstant drawing_ = core::never_t;
  Counts counts_;
  std::size_t faces_;
  bool whole_;
  std::size_t pairs_ = 0;
  std::uint32_t deletions_ = 0;
  bool ranked_ = false;
  std::size_t test_ = 0;  // the last test of the current pair so far; 0: no pair
};

// The number of links between drawn dots: a diagonal step crosses two.
std::uint32_t links_of(std::span<const std::uint8_t> commands) {
  constexpr std::uint8_t pen_up = 8;
  std::uint32_t links = 0;
  bool down = false;
  for (const std::uint8_t command : commands) {
    if (command >= pen_up) {
      down = command > pen_up;
    } else if (down) {
      links += command % 2 == 0 ? 1U : 2U;
    }
  }
  return links;
}

// Ten minutes for the program's work, and the time of the plotter, which draws no link twice.
std::int64_t limit_for(const MachineOptions& options) {
  const std::int64_t seconds = options.device == Device::calcomp ? 3600 : 600;
  return seconds * std::max(options.clock.hertz, core::ClockRate{}.hertz);
}

}  // namespace

MachinePicture run_machine(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options) {
  i8080::Machine machine({options.clock});
  if (options.device == Device::ef9365) attach(machine, devices::Ef9365::info.name);
  if (options.device == Device::calcomp) attach(machine, devices::CalComp565::info.name);
  attach(machine, devices::ParallelLink::info.name);
  machine.find<devices::ParallelLink>()->send(stream);
  std::optional<PlotterFront> plotter_front;
  if (options.device == Device::calcomp) plotter_front.emplace(machine);
  machine.load(0, program.memory);
  machine.start(program.labels.start);
  i8080::Limits limits;
  limits.until = core::at_t_state(options.t_state_limit > 0 ? options.t_state_limit : limit_for(options));
  std::optional<ColourFront> colour_front;
  if (options.device == Device::ef9365 && program.build == Build::plain) colour_front.emplace(machine, program.labels);
  WorkObserver work(machine, program.labels, stream.size() >= header_bytes ? stream[header_bytes - 1] : 0U,
                    options.device == Device::calcomp);
  i8080::StopReason reason = i8080::StopReason::device;
  while (reason == i8080::StopReason::device)
    reason = plotter_front && plotter_front->waiting() ? machine.run(limits) : machine.run(limits, work);
  if (reason == i8080::StopReason::observer) reason = machine.run(limits);
  MachinePicture picture;
  picture.ended = reason == i8080::StopReason::halt;
  picture.status = static_cast<Status>(machine.peek(program.labels.status));
  picture.fault = machine.peek(program.labels.fault);
  picture.instructions = machine.instructions();
  core::TStateInstant end = machine.now();
  if (const auto* const board = machine.find<devices::Ef9365>(); board != nullptr) {
    picture.raster = *board->raster();
    end = std::max(end, board->busy_until());
    picture.board_commands = board->totals().commands;
    picture.dots_written = board->totals().dots;
    add_faults(board->totals(), picture);
  }
  if (const auto* const plotter = machine.find<devices::CalComp565>(); plotter != nullptr) {
    end = std::max(end, plotter->busy_until());
    picture.device = plotter->totals().busy;
    add_faults(plotter->totals(), picture);
  }
  if (plotter_front) picture.commands = std::move(plotter_front->commands);
  picture.counts = work.counts();
  picture.counts.links = links_of(picture.commands);
  if (colour_front) colour_front->add_to(picture.counts);
  if (options.device == Device::ef9365) {
    const auto dots = picture.raster.points();
    picture.counts.dots = static_cast<std::uint32_t>(std::count_if(dots.begin(), dots.end(), [](std::uint8_t level) { return level != 0; }));
  }
  picture.receiving = std::min(work.check(), end).time_since_epoch();
  picture.ranking = std::min(work.drawing(), end) - std::min(work.check(), end);
  picture.drawing = end - std::min(work.drawing(), end);
  if (work.drawing() != core::never_t) {
    const auto order = machine.memory().subspan(program.labels.order, stream[header_bytes - 1]);
    picture.order.assign(order.begin(), order.end());
  }
  return picture;
}

}  // namespace sightline::programs::stripes
