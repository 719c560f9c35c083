// What is said of a Skala run: errors its devices counted, where it differs from the twin, what the plotter
// did.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/guest_ports.hpp"

namespace sightline::guests::skala {

namespace {

void add(GuestPicture& picture, std::string_view what, std::uint64_t count) {
  if (count > 0) picture.faults.push_back({what, count});
}

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

void report_faults(const devices::Ef9365& board, GuestPicture& picture) {
  const devices::Ef9365Counts counts = board.counts();
  add(picture, "commands to the busy EF9365", counts.commands_while_busy);
  add(picture, "registers written while the EF9365 was busy", counts.writes_while_busy);
  add(picture, "things asked of the EF9365 that it cannot do", counts.unanswered);
  add(picture, "dots outside the EF9365's planes", counts.dots_outside);
}

void report_faults(const devices::Alt256& board, GuestPicture& picture) {
  add(picture, "bytes written to the ALT-256 before it was ready", board.counts().writes_lost);
  picture.dots_not_shown = board.counts().dots_invisible;
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
