// Skala's program on the 8080: the eight functions as lines, surfaces and contours, as `sightline demo` draws them,
// and as lines in long slices. Measures the time of drawing with and without the visibility test, on both boards, and
// the memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A function and picture.
struct SkalaPicture {
  std::string function;
  std::string picture;  // lines, surface, contours
  double drawing_s = 0;
  std::uint64_t drawing_t_states = 0;
  std::optional<std::uint64_t> plain_t_states;  // without the visibility test
  std::uint64_t walked = 0;
  std::uint64_t dots = 0;
  std::uint64_t lit = 0;
  double receipt_s = 0;
  std::size_t command_bytes = 0;
  std::uint64_t blocks = 0;
  std::uint64_t instructions = 0;
  std::uint64_t dots_busy_t_states = 0;
  std::size_t colours = 0;
  Picture raster;

  // The additional time of the visibility test.
  [[nodiscard]] std::optional<double> cost_percent() const;
  // Of the points that were walked.
  [[nodiscard]] double hidden_percent() const { return 100.0 * static_cast<double>(walked - dots) / static_cast<double>(walked); }
};

// A kind of picture of all functions on a board: the time of drawing, and the additional time of the visibility test.
struct SkalaCost {
  std::string picture;
  std::string board;
  double fastest_s = 0;
  double slowest_s = 0;
  double least_percent = 0;
  double mean_percent = 0;
  double greatest_percent = 0;
};

// The contents of the 64 KB, by kind of picture.
struct SkalaMemory {
  std::string what;
  std::size_t lines_bytes = 0;
  std::size_t surface_bytes = 0;
  std::size_t contours_bytes = 0;
};

struct SkalaPictures {
  std::vector<SkalaPicture> pictures;
  // The same functions in 30 slices of 256 points, not rotated. They are sent as curves of dots, where the test is
  // the larger part of the work per dot.
  std::vector<SkalaPicture> curves;
  std::vector<SkalaCost> costs;
  std::vector<SkalaMemory> memory;

  [[nodiscard]] Chosen<SkalaPicture> of(std::string_view picture) const {
    return where(pictures, equals(&SkalaPicture::picture, picture));
  }
};

[[nodiscard]] SkalaPictures skala_pictures(const Context& context);
void skala_timing(Page& page, const SkalaPictures& skala);
void skala_needs(Page& page, const SkalaPictures& skala);

}  // namespace sightline::report
