#include "host/programs/skala/skala.hpp"

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>

#include "host/programs/skala/check.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/skala/twin/twin.hpp"

namespace sightline::programs::skala {

namespace {

// A hint that the clock may be why a program failed; empty at the clock for which programs are made.
std::string_view clock_hint(core::ClockRate clock) {
  return clock.hertz == core::ClockRate{}.hertz ? "" : "; its timing is made for a clock of 3 MHz";
}

// Empty: the program has completed its picture.
std::string failure_of(const MachinePicture& picture, core::ClockRate clock) {
  if (!picture.ended)
    return fmt::format("the program did not end within {:.0f} emulated seconds", core::in_seconds(picture.total, clock));
  if (!picture.faults.empty()) {
    std::string text = "the program misused the device";
    for (const DeviceFault& fault : picture.faults)
      text += fmt::format("{}{}: {}", &fault == &picture.faults.front() ? ": " : ", ", fault.what, fault.count);
    return text.append(clock_hint(clock));
  }
  if (picture.status != Status::complete)
    return fmt::format("the program stopped: {}{}", text_of(picture.status),
                       picture.status == Status::link_error ? clock_hint(clock) : "");
  return {};
}

base::Result<Outcome> run(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options, bool check) {
  Outcome outcome;
  outcome.picture = run_machine(program, stream, options);
  const MachinePicture& picture = outcome.picture;
  if (const std::string failure = failure_of(picture, options.clock); !failure.empty()) return base::program_failed(failure);
  if (check) {
    Equipment equipment{{}, program.direct_masks};
    equipment.present[static_cast<std::size_t>(options.device)] = true;
    const TwinPicture twin = run_twin(stream, equipment);
    const std::string difference = difference_from_twin(picture, twin, options.device);
    if (!difference.empty())
      return base::difference("internal error: the 8080's picture is not the one its native twin makes; " + difference);
    outcome.counts = twin.counts;
  }
  outcome.bytes = stream.size();
  outcome.points_walked = points_walked(stream, picture.columns);
  outcome.points_lit = points_lit(picture);
  outcome.plotter = plotter_work(picture.moves);
  return outcome;
}

WrongDots wrong_dots_of(const core::Raster& drawn, const core::Raster& right) {
  WrongDots wrong;
  for (std::size_t i = 0; i < drawn.points().size(); ++i) {
    if (drawn.points()[i] == right.points()[i]) continue;
    ++(drawn.points()[i] == 0 ? wrong.missing : wrong.extra);
  }
  return wrong;
}

}  // namespace

std::optional<double> Outcome::visibility_cost() const {
  if (!plain_drawing || plain_drawing->count() <= 0) return std::nullopt;
  const auto plain = static_cast<double>(plain_drawing->count());
  return 100 * (static_cast<double>(picture.drawing.count()) - plain) / plain;
}

base::Result<Outcome> run(const Order& order) {
  MachineOptions options;
  options.device = order.device;
  options.link = order.link;
  options.clock = order.clock;
  const Program& program = resident_program(order.direct_masks);
  const auto stream = stream_of(order.grid, order.view, {order.device});
  auto outcome = run(program, stream, options, order.check);
  if (!outcome) return outcome;
  if (order.direct_masks && (order.device == Device::ef9365 || order.device == Device::alt256)) {
    const auto right = run(resident_program(), stream, options, order.check);
    if (!right) return right.error();
    outcome->wrong_dots = wrong_dots_of(outcome->picture.raster, right->picture.raster);
  }
  if (!order.view.visibility || !order.time_plain) return outcome;
  View plain_view = order.view;
  plain_view.visibility = false;
  const auto plain = run(program, stream_of(order.grid, plain_view, {order.device}), options, order.check);
  if (!plain) return plain.error();
  outcome->plain_drawing = plain->picture.drawing;
  return outcome;
}

base::Result<Outcome> run(std::span<const std::uint8_t> stream, Device device, bool check, const Program& program) {
  MachineOptions options;
  options.device = device;
  return run(program, stream, options, check);
}

}  // namespace sightline::programs::skala
