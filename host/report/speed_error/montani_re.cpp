#include "host/report/speed_error/montani_re.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/montani_re_pixels.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;
using picture::PixelGrid;
using picture::PixelSegment;
using scene::PolyScene;

constexpr std::array<std::int32_t, 6> thicknesses{2, 4, 8, 16, 32, 64};  // sixteenths a pixel

// In 1/(16 * 65536) pixel, the ends of what bands cover at an ordinate.
std::vector<std::int64_t> ends_at(const native::StripeBand& band, std::int32_t sixteenths) {
  std::vector<std::int64_t> ends;
  for (const native::StripeSide& side : band.sides) ends.push_back(side.at(sixteenths));
  return ends;
}

// Where one of both covers and not the other.
std::vector<std::int64_t> either(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
  std::vector<std::int64_t> ends;
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(ends));
  return ends;  // even-odd
}

class BoundarySegments {
 public:
  explicit BoundarySegments(std::int32_t units) : stripes_a_pixel_(units / 16.0) {}

  // Bands from below upwards, of stripe after stripe.
  void add(std::int32_t stripe, const native::StripeBand& band) {
    const std::int64_t low = 16 * std::int64_t{stripe} + band.low;
    const auto bottom = ends_at(band, band.low);
    if (low != top_) close();
    horizontal(either(top_ends_, bottom), low);
    for (const native::StripeSide& side : band.sides)
      segments.push_back(
          {point(side.at(band.low), low), point(side.at(band.high), low - band.low + band.high)});
    top_ = low - band.low + band.high;
    top_ends_ = ends_at(band, band.high);
  }
  void close() {
    horizontal(top_ends_, top_);
    top_ends_.clear();
  }

  std::vector<PixelSegment> segments;

 private:
  void horizontal(const std::vector<std::int64_t>& ends, std::int64_t at) {
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      if (ends[k] != ends[k + 1]) segments.push_back({point(ends[k], at), point(ends[k + 1], at)});
    }
  }
  [[nodiscard]] picture::PixelPoint point(std::int64_t x, std::int64_t sixteenths) const {
    return {static_cast<double>(x) / (16 * 65536) - 0.5,
            static_cast<double>(sixteenths) / (16 * stripes_a_pixel_) - 0.5};
  }

  double stripes_a_pixel_;
  std::int64_t top_ = 0;  // of the last band, in sixteenths of a stripe
  std::vector<std::int64_t> top_ends_;
};

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
  return grid_of(scene, set, raster);
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

void compare(MontaniRePoint& point, const Truth& truth, const PixelGrid& grid,
             const std::vector<PixelSegment>& drawn) {
  const auto pixels = picture::pixel_metrics(truth.pixels.truth, grid, truth.pixels.edges);
  const auto share = [&pixels](std::uint64_t count) {
    return 100 * static_cast<double>(count) / static_cast<double>(pixels.pixels);
  };
  point.on_edges = share(pixels.different_on_boundary);
  point.inside = share(pixels.different_inside);
  // Of no line of the truth: all is missing and extra, and what is far of both is what is asked for.
  const auto no_line = static_cast<picture::LineId>(truth.lines.size());
  std::vector<picture::DrawnPiece> pieces;
  for (const PixelSegment& segment : drawn) pieces.push_back({no_line, segment});
  const auto lines = picture::line_metrics(truth.lines, pieces, {.points = 1, .seed = 1});
  point.missing = 100 * lines.share(lines.missing_far);
  point.extra = 100 * lines.share(lines.extra_far);
  point.hausdorff = told(lines.hausdorff.greatest);
  point.usual = told(lines.hausdorff.usual);
}

Truth truth_of(const PolyScene& scene, const native::FaceSet& set, std::int32_t raster) {
  Truth truth{pixels_in_perspective(scene, set, raster), {}};
  const PixelPlane plane(scene.camera, truth.pixels.frame);
  for (const PixelSegment& image :
       segments_of(algorithms::exact::visible_edges(scene, scene.camera), scene, plane))
    truth.lines.push_back({static_cast<picture::LineId>(truth.lines.size()), image, {{0, 1}}, {{0, 1}}});
  return truth;
}

MontaniRePoint exact_point(const PolyScene& scene, const native::FaceSet& set, const Truth& truth) {
  MontaniRePoint point;
  const native::VisibleRegions seen = native::visible_regions(set);
  point.sides = seen.counts.sides;
  const auto view = native::visible_edges(scene, scene.camera);
  compare(point, truth, grid_of_regions(scene, set, seen.regions, truth.pixels.frame),
          segments_of(view->picture, scene, PixelPlane(scene.camera, truth.pixels.frame)));
  return point;
}

MontaniRePoint stripes_point(const PolyScene& scene, const native::FaceSet& set,
                             const native::ListedFaces& listed, const Truth& truth, std::int32_t units) {
  MontaniRePoint point;
  point.thickness = 16.0 / units;
  const auto raster =
      native::raster_by_difference(set.image, listed.list, listed.faces, truth.pixels.frame, units);
  point.sides = raster.sides;
  compare(point, truth, grid_of(scene, set, raster),
          drawn_in_stripes(set, listed, truth.pixels.frame, units));
  return point;
}

void take_times(MontaniReCurve& curve, const PolyScene& scene, const native::StripeFrame& frame, int rounds) {
  std::vector<std::function<void()>> jobs;
  for (const std::int32_t units : thicknesses) {
    jobs.emplace_back([&scene, &frame, units] {
      const auto faces = native::faces_of(scene, scene.camera);
      const auto& set = *faces;
      const auto listed = native::listed_faces(set);
      (void)native::raster_by_difference(set.image, listed.list, listed.faces, frame, units);
    });
  }
  jobs.emplace_back([&scene] { (void)native::visible_edges(scene, scene.camera); });
  const auto times = median_nanoseconds(jobs, rounds);
  for (std::size_t i = 0; i < times.size(); ++i) curve.points[i].host_ns = times[i];
}

}  // namespace

std::vector<PixelSegment> boundary_of(const native::StripePcs& pcs, std::int32_t units) {
  BoundarySegments boundary(units);
  for (std::size_t k = 0; k < pcs.stripes.size(); ++k) {
    for (const native::StripeBand& band : pcs.stripes[k])
      boundary.add(pcs.first + static_cast<std::int32_t>(k), band);
  }
  boundary.close();
  return std::move(boundary.segments);
}

std::vector<MontaniReCurve> measure_montani_re(const MontaniReMeasure& order, const Context& context) {
  std::vector<MontaniReCurve> curves;
  for (const std::string& family : order.scenes) {
    context.progress(fmt::format("{} {} in stripes of every thickness", family, order.scene_size));
    const auto scene = *scene::generate_scene(family, order.scene_size);
    const auto made = native::faces_of(scene, scene.camera);
    const auto& set = *made;
    const auto listed = native::listed_faces(set);
    const Truth truth = truth_of(scene, set, order.raster);
    MontaniReCurve& curve = curves.emplace_back();
    curve.scene = fmt::format("{} {}", family, order.scene_size);
    curve.faces = set.faces.size();
    for (const picture::ReferenceLine& line : truth.lines)
      curve.true_length += std::hypot(line.image.b.x - line.image.a.x, line.image.b.y - line.image.a.y);
    for (const std::int32_t units : thicknesses)
      curve.points.push_back(stripes_point(scene, set, listed, truth, units));
    curve.points.push_back(exact_point(scene, set, truth));
    if (order.rounds > 0) take_times(curve, scene, truth.pixels.frame, order.rounds);
  }
  return curves;
}

}  // namespace sightline::harness::report
