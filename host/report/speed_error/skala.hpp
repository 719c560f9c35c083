// Skala's program and its native version on rasters, grids and numbers of levels of every size: how wrong and
// how long.
//
// What pictures are held against is the native program with 16384 columns of masks, 64 to a dot of the 8080's
// raster: for the raster on the same grid, for grids on slices of 1024 points, for contours on a grid four
// times as fine. The column oracle cannot serve: it knows pictures of 256 by 256 rounded points only, and so
// has the very errors in it that are to be measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/guests/skala/guest.hpp"
#include "host/report/report.hpp"
#include "host/report/speed_error/pictures.hpp"

namespace sightline::harness::report {

struct SkalaPoint {
  int setting = 0;  // dots a side, points a slice, or levels
  SurfaceError error;
  std::optional<core::TStates> drawing;  // of the program on the 8080
  std::optional<double> host_ns;         // of the twin, or of the native program
};

struct SkalaCurve {
  std::string function;
  std::vector<SkalaPoint> program;  // 8080 and twin
  std::vector<SkalaPoint> native;
};

struct SkalaBoard {
  std::string function;
  guests::skala::Device device = guests::skala::Device::ef9365;
  guests::skala::Link link = guests::skala::Link::parallel;
  SurfaceError error;
  core::TStates drawing{};
  core::TStates total{};
  std::uint64_t dots_not_shown = 0;
};

struct SkalaMeasured {
  std::vector<SkalaCurve> rasters;  // 64..256 dots a side, native to 1024; 17 points in each of 33 slices
  std::vector<SkalaCurve> grids;    // 8..256 points in each of 33 slices
  std::vector<SkalaCurve> levels;   // 1..32 of contours
  std::vector<SkalaBoard> boards;   // both boards on both links, 65 points in each of 33 slices
};

// Errors: guest_failed; differs, if the 8080 does not draw what its twin draws.
[[nodiscard]] Outcome<SkalaMeasured> measure_skala(const Context& context);

}  // namespace sightline::harness::report
