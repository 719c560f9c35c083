//   stripes    a thickness each, thick to thin, and the exact build, of which the thickness is missing
//   exponents  a scene each, over the thickness: of what is 0 at fewer than three thicknesses there is none
//   measures   the raster
//
// Rasters are compared with the faces met by exact sight lines, lines with those of `exact`. Stripes are
// drawn as the boundaries of what is seen of every face: their sides do not say whose edge they are, so that
// lines are compared as sets of points, and what is within a pixel of the other set counts as found.
#include "host/report/experiments/montani_re_stripes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <list>
#include <optional>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;
using picture::PixelGrid;
using picture::PixelSegment;
using compare::PixelPlane;
using compare::PixelView;
using scene::PolyScene;

// In 1/(16 * 65536) pixel, the ends of what a band covers at an ordinate.
std::vector<std::int64_t> ends_at(const native::StripeBand& band, std::int32_t sixteenths) {
  std::vector<std::int64_t> ends;
  for (const native::StripeSide& side : band.sides) ends.push_back(side.at(sixteenths));
  return ends;
}

// Front to back, each face less the silhouette.
std::vector<PixelSegment> drawn_in_stripes(const native::FaceSet& set, const native::ListedFaces& listed,
                                           const native::StripeFrame& frame, std::int32_t units) {
  std::vector<PixelSegment> segments;
  native::StripePcs silhouette;
  for (const native::PriorityClass& members : listed.list.classes()) {
    for (const std::uint32_t face : members) {
      const auto seen = native::combine(native::stripe_pcs(set.image, listed.faces[face], frame, units),
                                        silhouette, native::Operation::subtract);
      const auto boundary = boundary_of(seen, units);
      segments.insert(segments.end(), boundary.begin(), boundary.end());
      silhouette = native::combine(silhouette, seen, native::Operation::unite);
    }
  }
  return segments;
}

std::vector<PixelSegment> segments_of(const picture::LinePicture& lines, const PolyScene& scene,
                                      const PixelPlane& plane) {
  std::vector<PixelSegment> segments;
  for (const picture::LinePiece& piece : lines.pieces) {
    segments.push_back(plane.segment(scene.vertices[piece.edge.from], scene.vertices[piece.edge.to],
                                     piece.low.to_double(), piece.high.to_double()));
  }
  return segments;
}

// Exact regions at the middles of pixels.
PixelGrid grid_of_regions(const PolyScene& scene, const native::FaceSet& set,
                          const std::vector<native::TrapezoidPcs>& regions,
                          const native::StripeFrame& frame) {
  native::StripeRaster raster{frame.width, frame.height, {}, 0, 0};
  raster.faces.assign(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height),
                      native::none);
  for (std::uint32_t f = 0; f < regions.size(); ++f) {
    for (const native::Band& band : regions[f].bands) {
      for (std::int32_t row = 0; row < frame.height; ++row) {
        const double y = (row + 0.5 - frame.centre[1]) / frame.scale[1];
        if (y < band.low.middle() || y >= band.high.middle()) continue;
        const auto sides = regions[f].sides_of(band);
        for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
          const auto column = [&](const native::Side& side) {
            const double x = frame.centre[0] + frame.scale[0] * set.image.abscissa(side.line, y);
            return static_cast<std::int32_t>(
                std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(frame.width)));
          };
          for (std::int32_t at = column(sides[k]); at < column(sides[k + 1]); ++at)
            raster.faces[static_cast<std::size_t>(row * frame.width + at)] = f;
        }
      }
    }
  }
  return compare::grid_of(scene, set, raster);
}

// What is true of a view.
struct Truth {
  PixelView pixels;
  std::vector<picture::ReferenceLine> lines;
};

// Below this, distances are those of floating point in the measure itself.
double told(double distance) {
  return distance < 1e-9 ? 0 : distance;
}

Truth truth_of(const PolyScene& scene, const native::FaceSet& set, std::int32_t raster) {
  Truth truth{compare::pixels_in_perspective(scene, set, raster), {}};
  const PixelPlane plane(scene.camera, truth.pixels.frame);
  for (const PixelSegment& image :
       segments_of(algorithms::exact::visible_edges(scene, scene.camera), scene, plane))
    truth.lines.push_back({static_cast<picture::LineId>(truth.lines.size()), image, {{0, 1}}, {{0, 1}}});
  return truth;
}

// Scenes and their rows.
class Stripes {
 public:
  Stripes(const MontaniReStripes& order, Records& records) : order_(order), rows_(records["stripes"]) {}

  void add(const std::string& family) {
    const PolyScene& scene = scenes_.emplace_back(*scene::generate_scene(family, order_.scene_size));
    const auto set = native::faces_of(scene, scene.camera);
    const auto listed = native::listed_faces(*set);
    const Truth truth = truth_of(scene, *set, order_.raster);
    frames_.push_back(truth.pixels.frame);
    for (const std::int32_t units : stripe_units) {
      const auto raster =
          native::raster_by_difference(set->image, listed.list, listed.faces, frames_.back(), units);
      add_row(family, *set, truth, 16.0 / units, compare::grid_of(scene, *set, raster),
              drawn_in_stripes(*set, listed, frames_.back(), units), raster.sides);
    }
    const native::VisibleRegions seen = native::visible_regions(*set);
    const auto lines = native::visible_edges(scene, scene.camera);
    add_row(family, *set, truth, {}, grid_of_regions(scene, *set, seen.regions, frames_.back()),
            segments_of(lines->picture, scene, PixelPlane(scene.camera, frames_.back())), seen.counts.sides);
  }

  void take_times(int rounds) {
    std::vector<std::function<void()>> jobs;
    for (auto frame = frames_.begin(); const PolyScene& scene : scenes_) {
      for (const std::int32_t units : stripe_units) {
        jobs.emplace_back([&scene, frame, units] {
          const auto set = native::faces_of(scene, scene.camera);
          const auto listed = native::listed_faces(*set);
          (void)native::raster_by_difference(set->image, listed.list, listed.faces, *frame, units);
        });
      }
      jobs.emplace_back([&scene] { (void)native::visible_edges(scene, scene.camera); });
      ++frame;
    }
    const auto times = median_nanoseconds(jobs, rounds);
    for (std::size_t row = 0; row < times.size(); ++row) rows_.set(row, "view_ms", times[row] / 1e6);
  }

  void add_exponents(RowSet& exponents) const {
    for (std::size_t first = 0; first < rows_.size(); first += stripe_units.size() + 1) {
      NamedValues row{{"scene", rows_.at(first, "scene")}, {"faces", rows_.at(first, "faces")}};
      for (const std::string_view key : {"l_sym_percent", "pmr_percent", "h_usual_px", "sides", "view_ms"})
        row.emplace_back(key,
                         growth_exponent(rows_, first, first + stripe_units.size(), key, "thickness_px"));
      exponents.add(row);
    }
  }

 private:
  void add_row(const std::string& family, const native::FaceSet& set, const Truth& truth,
               std::optional<double> thickness, const PixelGrid& grid, const std::vector<PixelSegment>& drawn,
               std::uint64_t sides) {
    const auto pixels = picture::pixel_metrics(truth.pixels.truth, grid, truth.pixels.edges);
    // Of no line of the truth: all is missing and extra, and what is far of both is what is asked for.
    std::vector<picture::DrawnPiece> pieces;
    for (const PixelSegment& segment : drawn)
      pieces.push_back({static_cast<picture::LineId>(truth.lines.size()), segment});
    const auto lines = picture::line_metrics(truth.lines, pieces, {.points = 1, .seed = 1});
    const auto share = [&pixels](std::uint64_t count) {
      return 100 * static_cast<double>(count) / static_cast<double>(pixels.pixels);
    };
    const double usual = told(lines.hausdorff.usual);
    rows_.add({{"family", family},
               {"scene", fmt::format("{} {}", family, order_.scene_size)},
               {"faces", set.faces.size()},
               {"build", thickness ? "stripes" : "exact"},
               {"thickness_px", thickness},
               {"true_length_px", lines.true_length},
               {"missing_percent", 100 * lines.share(lines.missing_far)},
               {"extra_percent", 100 * lines.share(lines.extra_far)},
               {"l_sym_percent", 100 * lines.share(lines.missing_far + lines.extra_far)},
               {"pmr_edges_percent", share(pixels.different_on_boundary)},
               {"pmr_inside_percent", share(pixels.different_inside)},
               {"pmr_percent", share(pixels.different_on_boundary + pixels.different_inside)},
               {"h_px", told(lines.hausdorff.greatest)},
               {"h_usual_px", usual},
               {"h_usual_stripes", thickness ? Value(usual / *thickness) : Value()},
               {"sides", sides},
               {"view_ms", {}}});
  }

  const MontaniReStripes& order_;
  RowSet& rows_;
  std::list<PolyScene> scenes_;
  std::list<native::StripeFrame> frames_;
};

}  // namespace

std::vector<PixelSegment> boundary_of(const native::StripePcs& pcs, std::int32_t units) {
  std::vector<PixelSegment> segments;
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t to_x, std::int64_t to_y) {
    const auto point = [units](std::int64_t at, std::int64_t sixteenths) {
      return picture::PixelPoint{static_cast<double>(at) / (16 * 65536) - 0.5,
                                 static_cast<double>(sixteenths) / units - 0.5};
    };
    segments.push_back({point(x, y), point(to_x, to_y)});
  };
  std::int64_t top = 0;  // of the last band, in sixteenths of a stripe
  std::vector<std::int64_t> top_ends;
  const auto add_level = [&](const std::vector<std::int64_t>& above) {
    std::vector<std::int64_t> ends;  // even-odd
    std::merge(top_ends.begin(), top_ends.end(), above.begin(), above.end(), std::back_inserter(ends));
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
      if (ends[k] != ends[k + 1]) add(ends[k], top, ends[k + 1], top);
    top_ends.clear();
  };
  for (std::size_t k = 0; k < pcs.stripes.size(); ++k) {
    for (const native::StripeBand& band : pcs.stripes[k]) {
      const std::int64_t stripe = 16 * (std::int64_t{pcs.first} + static_cast<std::int64_t>(k));
      if (stripe + band.low != top) add_level({});
      top = stripe + band.low;
      add_level(ends_at(band, band.low));
      for (const native::StripeSide& side : band.sides)
        add(side.at(band.low), top, side.at(band.high), stripe + band.high);
      top = stripe + band.high;
      top_ends = ends_at(band, band.high);
    }
  }
  add_level({});
  return segments;
}

Records measure_stripes(const MontaniReStripes& order, const Context& context) {
  Records records;
  records["measures"].add({{"raster", order.raster}});
  Stripes stripes(order, records);
  for (const std::string& family : order.scenes) {
    context.progress(fmt::format("{} {} in stripes of every thickness", family, order.scene_size));
    stripes.add(family);
  }
  if (order.rounds > 0) stripes.take_times(order.rounds);
  stripes.add_exponents(records["exponents"]);
  return records;
}

Records montani_re_stripes(const Context& context) {
  MontaniReStripes order;
  if (context.full) {
    order.scene_size = 50;
    order.raster = 512;
    order.rounds = 9;
  }
  if (!context.host_times) order.rounds = 0;
  return measure_stripes(order, context);
}

}  // namespace sightline::report
