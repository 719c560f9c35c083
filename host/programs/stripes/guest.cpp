#include "host/programs/stripes/guest.hpp"

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
#include "host/machines/i8080_run_to.hpp"

namespace sightline::programs::stripes {

namespace {

// Notes the commands to the plotter.
class PlotterFront final : public i8080::Front {
 public:
  explicit PlotterFront(i8080::Machine& machine) : Front(machine, devices::CalComp565::info.writes) {}
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    commands.push_back(value);
    Front::out(port, value, at);
  }

  std::vector<std::uint8_t> commands;
};

// The machine is a part of this program, so that an error ends the process.
void attach(i8080::Machine& machine, std::string_view device) {
  if (const std::string error = machine.attach(device); !error.empty()) base::give_up(error);
}

void add_faults(const devices::Ef9365Counts& counts, GuestPicture& picture) {
  const auto add = [&picture](std::string_view what, std::uint64_t count) {
    if (count > 0) picture.faults.push_back({what, count});
  };
  add("commands to the busy EF9365", counts.commands_while_busy);
  add("registers written while the EF9365 was busy", counts.writes_while_busy);
  add("things asked of the EF9365 that it cannot do", counts.unanswered);
  add("dots outside the EF9365's planes", counts.dots_outside);
}

void add_faults(const devices::CalComp565Counts& counts, GuestPicture& picture) {
  const auto add = [&picture](std::string_view what, std::uint64_t count) {
    if (count > 0) picture.faults.push_back({what, count});
  };
  add("commands to the busy CalComp", counts.commands_while_busy);
  add("steps off the CalComp's carriage", counts.off_carriage);
  add("codes the CalComp does not know", counts.unknown_codes);
  add("marks beside the CalComp's paper", counts.off_paper);
}

// Ten minutes for the work of the program; and the plotter's, of which no link is drawn twice.
std::int64_t limit_for(const GuestOptions& options) {
  const std::int64_t seconds = options.device == Device::calcomp ? 3600 : 600;
  return seconds * std::max(options.clock.hertz, core::ClockRate{}.hertz);
}

}  // namespace

GuestPicture run_guest(const Program& program, std::span<const std::uint8_t> stream, const GuestOptions& options) {
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
  // When the program comes to its labels; at the end, if it does not.
  core::TStateInstant check = core::never_t;
  core::TStateInstant drawing = core::never_t;
  i8080::StopReason reason = machines::run_to(machine, program.labels.check, limits);
  if (reason == i8080::StopReason::observer) {
    check = machine.now();
    reason = machines::run_to(machine, program.labels.drawing, limits);
  }
  if (reason == i8080::StopReason::observer) {
    drawing = machine.now();
    reason = machine.run(limits);
  }
  GuestPicture picture;
  picture.ended = reason == i8080::StopReason::halt;
  picture.status = static_cast<Status>(machine.peek(program.labels.status));
  picture.fault = machine.peek(program.labels.fault);
  picture.instructions = machine.instructions();
  core::TStateInstant end = machine.now();
  if (const auto* const board = machine.find<devices::Ef9365>(); board != nullptr) {
    picture.raster = *board->raster();
    end = std::max(end, board->busy_until());
    add_faults(board->totals(), picture);
  }
  if (const auto* const plotter = machine.find<devices::CalComp565>(); plotter != nullptr) {
    end = std::max(end, plotter->busy_until());
    picture.device = plotter->totals().busy;
    add_faults(plotter->totals(), picture);
  }
  if (plotter_front) picture.commands = std::move(plotter_front->commands);
  picture.receiving = std::min(check, end).time_since_epoch();
  picture.ranking = std::min(drawing, end) - std::min(check, end);
  picture.drawing = end - std::min(drawing, end);
  if (drawing != core::never_t) {
    const auto order = machine.memory().subspan(program.labels.order, stream[header_bytes - 1]);
    picture.order.assign(order.begin(), order.end());
  }
  return picture;
}

std::string difference_from_twin(const GuestPicture& guest, const TwinPicture& twin) {
  if (guest.status != twin.status || guest.fault != twin.fault)
    return fmt::format("status: the program \"{}\" (face {}), its twin \"{}\" (face {})", text_of(guest.status), guest.fault,
                       text_of(twin.status), twin.fault);
  if (!guest.order.empty() && !twin.order.empty() && guest.order != twin.order) {
    const auto [here, there] = std::mismatch(guest.order.begin(), guest.order.end(), twin.order.begin());
    return fmt::format("place {} of the priority list: the program face {}, its twin face {}", here - guest.order.begin(), *here,
                       *there);
  }
  const auto dots = guest.raster.points();
  const auto twins = twin.raster.points();
  if (const auto [here, there] = std::mismatch(dots.begin(), dots.end(), twins.begin()); here != dots.end()) {
    const auto at = here - dots.begin();
    return fmt::format("dot ({}, {}): the program {}, its twin {}", at % core::Raster::width, at / core::Raster::width, *here,
                       *there);
  }
  const auto [here, there] =
      std::mismatch(guest.commands.begin(), guest.commands.end(), twin.commands.begin(), twin.commands.end());
  if (here == guest.commands.end() && there == twin.commands.end()) return {};
  const auto said = [](auto at, auto end) { return at == end ? std::string("none") : fmt::format("{}", *at); };
  return fmt::format("command {} to the plotter: the program {}, its twin {}", here - guest.commands.begin(),
                     said(here, guest.commands.end()), said(there, twin.commands.end()));
}

}  // namespace sightline::programs::stripes
