// Any bytes as a command stream for the Skala program's twin. The twin must end, report where it stopped, and leave a state
// that its specification allows.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "host/programs/skala/twin/twin.hpp"

namespace {

using namespace sightline;

void require(bool holds) {
  if (!holds) std::abort();
}

void check_path(const programs::skala::TwinPicture& picture) {
  programs::skala::PlotterMove before;
  std::uint64_t steps = 0;
  for (const programs::skala::PlotterMove& move : picture.moves) {
    const int dx = move.x - before.x;
    const int dy = move.y - before.y;
    if (move.action == programs::skala::PlotterAction::step) {
      ++steps;
      require(dx * dx <= 1 && dy * dy <= 1 && (dx != 0 || dy != 0));
      require(move.pen_down == before.pen_down);
    } else {
      require(dx == 0 && dy == 0 && move.pen_down != before.pen_down);
    }
    before = move;
  }
  require(steps == picture.counts.steps_pen_down + picture.counts.steps_pen_up);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> stream(data, size);
  const programs::skala::TwinPicture picture = programs::skala::run_twin(stream);
  require(picture.bytes_taken <= size);
  require(picture.status == programs::skala::Status::running ||
          picture.status == programs::skala::Status::complete ||
          picture.status == programs::skala::Status::unknown_command ||
          picture.status == programs::skala::Status::argument_out_of_range);
  require(picture.status != programs::skala::Status::running || picture.bytes_taken == size);
  unsigned colours = 0;
  for (const auto& raster : picture.rasters)
    for (const std::uint8_t dot : raster.points()) colours |= dot;
  require(colours < 8);
  for (std::size_t x = 0; x < 256; ++x) {
    const int top = picture.columns.mask_top[x];
    const int bottom = picture.columns.mask_bottom[x];
    require(bottom <= top || (bottom == 255 && top == 0));
    require(picture.columns.previous_level[x] < 8 &&
            picture.columns.raised_from[x] <= picture.columns.mask_top[x] &&
            picture.columns.lowered_from[x] >= picture.columns.mask_bottom[x]);
  }
  check_path(picture);
  // Bytes after the one at which it stopped have no effect.
  const programs::skala::TwinPicture again = programs::skala::run_twin(stream.first(picture.bytes_taken));
  require(again.status == picture.status && again.bytes_taken == picture.bytes_taken);
  require(again.moves == picture.moves && again.rasters == picture.rasters);
  return 0;
}
