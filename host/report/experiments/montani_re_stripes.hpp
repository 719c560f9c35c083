// Montani and Re's algorithm in stripes of every thickness, and exact: the errors of its pictures, the time of a
// view, the number of sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/stripes.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// Thicknesses are 16 / units pixels.
inline constexpr std::array<std::int32_t, 6> stripe_units{2, 4, 8, 16, 32, 64};

struct StripesOptions {
  std::vector<std::string> scenes{"boxes", "town", "triangles"};  // generated
  std::size_t scene_size = 30;
  std::int32_t raster = 384;
  int rounds = 3;  // of time measurements; 0: none
};

// The picture of a scene in stripes, or by the exact build. Rasters are compared with the faces that exact sight
// lines meet first, lines with those of `exact`.
struct StripesPicture {
  std::string family;
  std::string scene;
  std::size_t faces = 0;
  std::optional<double> thickness_px = {};  // empty: the exact build
  double true_length_px = 0;
  double missing_percent = 0;  // farther than a pixel from the other picture
  double extra_percent = 0;
  double l_sym_percent = 0;  // both
  double pmr_edges_percent = 0;
  double pmr_inside_percent = 0;
  double pmr_percent = 0;
  double h_px = 0;
  double h_usual_px = 0;  // of all but one sample in a thousand
  std::uint64_t sides = 0;
  std::optional<double> view_ms = {};  // empty without times

  [[nodiscard]] bool in_stripes() const { return thickness_px.has_value(); }
  [[nodiscard]] std::optional<double> h_usual_stripes() const {
    return in_stripes() ? std::optional(h_usual_px / *thickness_px) : std::nullopt;
  }
};

// Growth exponents of a scene over the thickness. Empty for a quantity that is 0 at all but fewer than three
// thicknesses.
struct StripesExponents {
  std::string scene;
  std::size_t faces = 0;
  std::optional<double> l_sym_percent = {};
  std::optional<double> pmr_percent = {};
  std::optional<double> h_usual_px = {};
  std::optional<double> sides = {};
  std::optional<double> view_ms = {};
};

struct MontaniReStripes {
  std::int32_t raster = 0;               // pixels a side
  std::vector<StripesPicture> pictures;  // of each scene: thick to thin, then the exact build
  std::vector<StripesExponents> exponents;
};

[[nodiscard]] MontaniReStripes measure_stripes(const StripesOptions& options, const Context& context);
[[nodiscard]] MontaniReStripes montani_re_stripes(const Context& context);

// The boundary of stripes of `units` sixteenths of a pixel, with centres of pixels at integers: sides, and horizontal
// pieces where exactly one of above and below is covered.
[[nodiscard]] std::vector<picture::PixelSegment> boundary_of(const algorithms::montani_re::StripePcs& pcs, std::int32_t units);

class Page;
void montani_re_accuracy(Page& page, const MontaniReStripes& measured);

}  // namespace sightline::report
