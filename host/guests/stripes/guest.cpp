#include "host/guests/stripes/guest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "emulators/machines/skala_ports.hpp"
#include "host/guests/run/i8080_processor.hpp"

namespace sightline::guests::stripes {

namespace {

// The link, a device, and what the plotter was told.
class Ports final : public run::I8080Ports, public machines::SkalaPorts<> {
 public:
  using Base = machines::SkalaPorts<>;
  Ports(const machines::SkalaConfiguration& configuration, core::NoStrokes& sink) : Base(configuration, sink) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return Base::in(port, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    if (port == plotter_port && calcomp565() != nullptr) commands.push_back(value);
    Base::out(port, value, at);
  }

  std::vector<std::uint8_t> commands;

 private:
  static constexpr std::uint8_t plotter_port = machines::CalComp565Row::writes[0].first;
};

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
  machines::SkalaConfiguration configuration;
  configuration.clock = options.clock;
  configuration.ef9365 = options.device == Device::ef9365;
  configuration.calcomp565 = options.device == Device::calcomp;
  configuration.parallel = stream;
  core::NoStrokes sink;
  const auto ports = std::make_unique<Ports>(configuration, sink);  // large
  run::I8080Processor machine(*ports);
  std::copy(program.memory.begin(), program.memory.end(), machine.memory().begin());
  machine.registers().pc = program.labels.start;
  machines::I8080Limits limits;
  limits.until = core::at_t_state(options.t_state_limit > 0 ? options.t_state_limit : limit_for(options));
  // When the program comes to its labels; at the end, if it does not.
  core::TStateInstant check = core::never_t;
  core::TStateInstant drawing = core::never_t;
  machines::I8080StopReason reason = machine.run_to(program.labels.check, limits);
  if (reason == machines::I8080StopReason::observer) {
    check = machine.now();
    reason = machine.run_to(program.labels.drawing, limits);
  }
  if (reason == machines::I8080StopReason::observer) {
    drawing = machine.now();
    reason = machine.run(limits);
  }
  GuestPicture picture;
  picture.ended = reason == machines::I8080StopReason::halt;
  picture.status = static_cast<Status>(machine.peek(program.labels.status));
  picture.fault = machine.peek(program.labels.fault);
  picture.instructions = machine.instructions();
  core::TStateInstant end = machine.now();
  if (auto* board = ports->ef9365(); board != nullptr) {
    picture.raster = board->raster();
    end = std::max(end, board->busy_until());
    add_faults(board->counts(), picture);
  }
  if (auto* plotter = ports->calcomp565(); plotter != nullptr) {
    end = std::max(end, plotter->busy_until());
    picture.device = plotter->counts().busy;
    add_faults(plotter->counts(), picture);
  }
  picture.commands = std::move(ports->commands);
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

}  // namespace sightline::guests::stripes
