// What the devices of an 8080 run leave behind for its report, and who takes the plotter's marks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/guests/run/i8080.hpp"

namespace sightline::harness {

// A sink that writes what a plotter's pen does and keeps the lines it draws, as far as the job asks for them;
// the job outlives it. Strokes tell nothing of a lifted pen: marks one step apart are joined.
class PlotterTaker {
 public:
  static constexpr bool consumes = true;
  // Corners kept of a program that draws for ever.
  static constexpr std::size_t most_corners = std::size_t{1} << 22;

  explicit PlotterTaker(const I8080Job& job) : job_(job) {}

  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    if (job_.strokes) log(stroke);
    if (job_.drawing) draw({stroke.x, stroke.y});
  }
  void end_pass(core::Instant) {}
  // Hands out what is left, once.
  void finish(I8080Report& report);

 private:
  void log(const core::Stroke& stroke);
  void draw(picture::PenPoint point);

  const I8080Job& job_;
  std::string text_;
  std::vector<picture::PenPath> paths_;
  picture::PenPoint last_;
  std::size_t corners_ = 0;  // of all paths but the last, which is counted when the next begins
  std::uint64_t left_out_ = 0;
};

using I8080Devices = machines::SkalaPorts<PlotterTaker>;

// Counts, raster and received bytes; the devices stand at the end of the run.
void collect_devices(I8080Devices& devices, I8080Report& report);

}  // namespace sightline::harness
