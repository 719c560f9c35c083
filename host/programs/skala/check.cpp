#include "host/programs/skala/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace sightline::programs::skala {

namespace {

constexpr int raster_width = core::Raster::width;

// Calls action(x, y) for every position until it returns true.
template <class Action>
void for_each_position(Action action) {
  for (int y = 0; y < raster_width; ++y)
    for (int x = 0; x < raster_width; ++x)
      if (action(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y))) return;
}

std::string difference(const core::Raster& machine, const core::Raster& twin) {
  std::string text;
  if (machine == twin) return text;
  for_each_position([&](std::uint8_t x, std::uint8_t y) {
    if (machine.at(x, y) == twin.at(x, y)) return false;
    text = fmt::format("dot ({}, {}): the program {}, its twin {}", x, y, machine.at(x, y), twin.at(x, y));
    return true;
  });
  return text;
}

std::string describe(std::span<const PlotterMove> moves, std::size_t number) {
  if (number >= moves.size()) return "nothing more";
  constexpr std::array<std::string_view, 3> names{"a step to", "pen up at", "pen down at"};
  const PlotterMove& move = moves[number];
  return fmt::format("{} ({}, {})", names[static_cast<std::size_t>(move.action)], move.x, move.y);
}

std::string difference(std::span<const PlotterMove> machine, std::span<const PlotterMove> twin) {
  const auto [in_machine, in_twin] = std::mismatch(machine.begin(), machine.end(), twin.begin(), twin.end());
  if (in_machine == machine.end() && in_twin == twin.end()) return {};
  const auto number = static_cast<std::size_t>(in_machine - machine.begin());
  return fmt::format("movement {} of the plotter: the program {}, its twin {}", number + 1,
                     describe(machine, number), describe(twin, number));
}

// With a plotter the program does not record the slices of a surface.
std::string difference(const Columns& machine, const Columns& twin, bool slices) {
  for (std::size_t x = 0; x < machine.mask_top.size(); ++x) {
    const auto difference_text = [x](std::string_view mask, int in_machine, int in_twin) {
      return fmt::format("{} of column {}: the program {}, its twin {}", mask, x, in_machine, in_twin);
    };
    if (machine.mask_top[x] != twin.mask_top[x]) return difference_text("mask top", machine.mask_top[x], twin.mask_top[x]);
    if (machine.mask_bottom[x] != twin.mask_bottom[x])
      return difference_text("mask bottom", machine.mask_bottom[x], twin.mask_bottom[x]);
    if (!slices) continue;
    if (machine.previous_level[x] != twin.previous_level[x])
      return difference_text("level of the previous slice", machine.previous_level[x], twin.previous_level[x]);
    if (machine.previous_level[x] != 0 && machine.previous_y[x] != twin.previous_y[x])
      return difference_text("row of the previous slice", machine.previous_y[x], twin.previous_y[x]);
  }
  return {};
}

}  // namespace

std::string difference_from_twin(const MachinePicture& machine, const TwinPicture& twin, Device device) {
  if (machine.status != twin.status)
    return fmt::format("status: the program \"{}\", its twin \"{}\"", text_of(machine.status),
                       text_of(twin.status));
  std::string text;
  if (is_raster(device)) text = difference(machine.raster, twin.raster(device));
  if (text.empty()) text = difference(machine.moves, twin.moves);
  if (text.empty()) text = difference(machine.columns, twin.columns, is_raster(device));
  return text;
}

}  // namespace sightline::programs::skala
