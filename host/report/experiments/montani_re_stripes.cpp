// Stripes are drawn as the boundaries of the visible parts of every face. Their sides do not belong to an edge, so
// lines are compared as sets of points, and a point within a pixel of the other set counts as found.
#include "host/report/experiments/montani_re_stripes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <list>
#include <optional>
#include <span>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"
#include "host/report/page.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;
using picture::PixelGrid;
using picture::PixelSegment;
using compare::PixelPlane;
using compare::PixelView;
using scene::PolyScene;

// The ends of the covered parts of a band at an ordinate, in 1/(16 * 65536) pixel.
std::vector<std::int64_t> ends_at(const native::StripeBand& band, std::int32_t sixteenths) {
  std::vector<std::int64_t> ends;
  for (const native::StripeSide& side : band.sides) ends.push_back(side.at(sixteenths));
  return ends;
}

// Front to back, each face without the silhouette.
std::vector<PixelSegment> drawn_in_stripes(const native::FaceSet& set, const native::ListedFaces& listed,
                                           const native::StripeFrame& frame, std::int32_t units) {
  std::vector<PixelSegment> segments;
  native::StripePcs silhouette;
  for (const native::PriorityClass& members : listed.list.classes()) {
    for (const std::uint32_t face : members) {
      const auto seen = native::combine(native::stripe_pcs(set.image, listed.faces[face], frame, units), silhouette,
                                        native::Operation::subtract);
      const auto boundary = boundary_of(seen, units);
      segments.insert(segments.end(), boundary.begin(), boundary.end());
      silhouette = native::combine(silhouette, seen, native::Operation::unite);
    }
  }
  return segments;
}

std::vector<PixelSegment> segments_of(const picture::LinePicture& lines, const PolyScene& scene, const PixelPlane& plane) {
  std::vector<PixelSegment> segments;
  for (const picture::LinePiece& piece : lines.pieces) {
    segments.push_back(plane.segment(scene.vertices[piece.edge.from], scene.vertices[piece.edge.to], piece.low.to_double(),
                                     piece.high.to_double()));
  }
  return segments;
}

// Exact regions at the centres of pixels.
PixelGrid grid_of_regions(const PolyScene& scene, const native::FaceSet& set, const std::vector<native::TrapezoidPcs>& regions,
                          const native::StripeFrame& frame) {
  native::StripeRaster raster{frame.width, frame.height, {}, 0, 0};
  raster.faces.assign(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), native::none);
  for (std::uint32_t f = 0; f < regions.size(); ++f) {
    for (const native::Band& band : regions[f].bands) {
      for (std::int32_t row = 0; row < frame.height; ++row) {
        const double y = (row + 0.5 - frame.centre[1]) / frame.scale[1];
        if (y < band.low.middle() || y >= band.high.middle()) continue;
        const auto sides = regions[f].sides_of(band);
        for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
          const auto column = [&](const native::Side& side) {
            const double x = frame.centre[0] + frame.scale[0] * set.image.abscissa(side.line, y);
            return static_cast<std::int32_t>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(frame.width)));
          };
          for (std::int32_t at = column(sides[k]); at < column(sides[k + 1]); ++at)
            raster.faces[static_cast<std::size_t>(row * frame.width + at)] = f;
        }
      }
    }
  }
  return compare::grid_of(scene, set, raster);
}

// The reference of a view.
struct Truth {
  PixelView pixels;
  std::vector<picture::ReferenceLine> lines;
};

// Smaller distances are floating-point noise of the measure.
double without_noise(double distance) {
  return distance < 1e-9 ? 0 : distance;
}

Truth truth_of(const PolyScene& scene, const native::FaceSet& set, std::int32_t raster) {
  Truth truth{compare::pixels_in_perspective(scene, set, raster), {}};
  const PixelPlane plane(scene.camera, truth.pixels.frame);
  for (const PixelSegment& image : segments_of(algorithms::exact::visible_edges(scene, scene.camera), scene, plane))
    truth.lines.push_back({static_cast<picture::LineId>(truth.lines.size()), image, {{0, 1}}, {{0, 1}}});
  return truth;
}

// The scenes and their pictures.
class Stripes {
 public:
  Stripes(const StripesOptions& options, std::vector<StripesPicture>& pictures) : options_(options), pictures_(pictures) {}

  void add(const std::string& family) {
    const PolyScene& scene = scenes_.emplace_back(*scene::generate_scene(family, options_.scene_size));
    const auto set = native::faces_of(scene, scene.camera);
    const auto listed = native::listed_faces(*set);
    const Truth truth = truth_of(scene, *set, options_.raster);
    frames_.push_back(truth.pixels.frame);
    for (const std::int32_t units : stripe_units) {
      const auto raster = native::raster_by_difference(set->image, listed.list, listed.faces, frames_.back(), units);
      add_picture(family, *set, truth, 16.0 / units, compare::grid_of(scene, *set, raster),
                  drawn_in_stripes(*set, listed, frames_.back(), units), raster.sides);
    }
    const native::VisibleRegions seen = native::visible_regions(*set);
    const auto lines = native::visible_edges(scene, scene.camera);
    add_picture(family, *set, truth, {}, grid_of_regions(scene, *set, seen.regions, frames_.back()),
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
    for (std::size_t row = 0; row < times.size(); ++row) pictures_[row].view_ms = times[row] / 1e6;
  }

  [[nodiscard]] std::vector<StripesExponents> exponents() const {
    std::vector<StripesExponents> all;
    for (std::size_t first = 0; first < pictures_.size(); first += stripe_units.size() + 1) {
      const std::span of_scene(pictures_.data() + first, stripe_units.size());
      const auto exponent = [of_scene](const auto& value) {
        std::vector<std::pair<double, double>> points;
        for (const StripesPicture& picture : of_scene)
          if (const std::optional<double> y = value(picture)) points.emplace_back(*picture.thickness_px, *y);
        return growth_exponent(points, 3);
      };
      all.push_back({of_scene.front().scene, of_scene.front().faces,
                     exponent([](const StripesPicture& p) { return p.l_sym_percent; }),
                     exponent([](const StripesPicture& p) { return p.pmr_percent; }),
                     exponent([](const StripesPicture& p) { return p.h_usual_px; }),
                     exponent([](const StripesPicture& p) { return static_cast<double>(p.sides); }),
                     exponent([](const StripesPicture& p) { return p.view_ms; })});
    }
    return all;
  }

 private:
  void add_picture(const std::string& family, const native::FaceSet& set, const Truth& truth, std::optional<double> thickness,
                   const PixelGrid& grid, const std::vector<PixelSegment>& drawn, std::uint64_t sides) {
    const auto pixels = picture::pixel_metrics(truth.pixels.truth, grid, truth.pixels.edges);
    // The pieces belong to no line of the reference, so all of both is missing or extra, and only the far part is
    // used.
    std::vector<picture::DrawnPiece> pieces;
    for (const PixelSegment& segment : drawn) pieces.push_back({static_cast<picture::LineId>(truth.lines.size()), segment});
    const auto lines = picture::line_metrics(truth.lines, pieces, {.points = 1, .seed = 1});
    const auto share = [&pixels](std::uint64_t count) {
      return 100 * static_cast<double>(count) / static_cast<double>(pixels.pixels);
    };
    pictures_.push_back({.family = family,
                         .scene = fmt::format("{} {}", family, options_.scene_size),
                         .faces = set.faces.size(),
                         .thickness_px = thickness,
                         .true_length_px = lines.true_length,
                         .missing_percent = 100 * lines.share(lines.missing_far),
                         .extra_percent = 100 * lines.share(lines.extra_far),
                         .l_sym_percent = 100 * lines.share(lines.missing_far + lines.extra_far),
                         .pmr_edges_percent = share(pixels.different_on_boundary),
                         .pmr_inside_percent = share(pixels.different_inside),
                         .pmr_percent = share(pixels.different_on_boundary + pixels.different_inside),
                         .h_px = without_noise(lines.hausdorff.greatest),
                         .h_usual_px = without_noise(lines.hausdorff.usual),
                         .sides = sides});
  }

  const StripesOptions& options_;
  std::vector<StripesPicture>& pictures_;
  std::list<PolyScene> scenes_;
  std::list<native::StripeFrame> frames_;
};

// The x axis of a plot.
struct ErrorMeasure {
  std::string key;
  double StripesPicture::*value;
  std::string title;
  std::string unit;
};

// A curve for each scene, and points of the exact build. The thickness labels the points of the first curve.
template <class Y>
void add_error_curves(Plot& plot, const std::vector<StripesPicture>& pictures, const ErrorMeasure& error, Y y) {
  const std::string first = pictures.front().scene;
  add_curves(
      plot, where(pictures, &StripesPicture::in_stripes), &StripesPicture::scene, error.value, y,
      {.label = [first](const StripesPicture& p) { return p.scene == first ? "h " + text_of(p.thickness_px) : std::string(); }});
  add_curves(plot, where(pictures, equals(&StripesPicture::in_stripes, false)), "exact build", error.value, y,
             {.label = &StripesPicture::scene, .line = false});
}

void add_sides_plot(Page& page, const std::vector<StripesPicture>& pictures, const ErrorMeasure& error) {
  const double exact = greatest(where(pictures, equals(&StripesPicture::in_stripes, false)), error.value);
  Plot plot{.id = fmt::format("montani-re-{}-sides", error.key),
            .title = "Montani and Re, stripes and exact: sides against " + error.title,
            .caption =
                "Sides of all visible parts, on which the differences operate. The exact build's are those of its own "
                "trapezoids, which do not depend on pixels. " +
                Page::claim(exact == 0, "The exact build has no error.", "it has " + text_of(exact)),
            .alternative = fmt::format("Log-log plot of sides against {}, one curve for each scene.", error.title),
            .x = {error.title, error.unit},
            .y = {"sides"}};
  add_error_curves(plot, pictures, error, [](const StripesPicture& p) { return static_cast<double>(p.sides); });
  page.plot(std::move(plot));
}

void add_time_plot(Page& page, const std::vector<StripesPicture>& pictures, const ErrorMeasure& error) {
  Plot plot{
      .id = fmt::format("montani-re-{}-host", error.key),
      .title = "Montani and Re, stripes and exact: time against " + error.title,
      .caption =
          "A view: relations, list and raster (exact: pieces of edges). Medians of interleaved repetitions, of this computer.",
      .alternative = fmt::format("Log-log plot of time against {}, one curve for each scene.", error.title),
      .x = {error.title, error.unit},
      .y = {"a view, time on this computer", "ms"}};
  add_error_curves(plot, pictures, error, &StripesPicture::view_ms);
  page.plot(std::move(plot));
}

void add_pictures_table(Page& page, const MontaniReStripes& measured) {
  const auto town = where(measured.pictures, equals(&StripesPicture::family, "town"));
  const double of_a_pixel = only(town, equals(&StripesPicture::thickness_px, 1.0)).pmr_percent;
  const double of_half_a_pixel = only(town, equals(&StripesPicture::thickness_px, 0.5)).pmr_percent;
  const std::string rise = fmt::format("from {} to {} %", text_of(of_a_pixel, 3), text_of(of_half_a_pixel, 3));
  page.table(
      "montani-re-speed-error", "Montani and Re: stripes of every thickness", measured.pictures,
      {{"scene", "Scene", &StripesPicture::scene},
       {"faces", "Faces", &StripesPicture::faces},
       {"true_length_px", "Visible length", "pixels", &StripesPicture::true_length_px, 0},
       {"build", "Build", [](const StripesPicture& p) { return p.in_stripes() ? "stripes" : "exact"; }},
       {"thickness_px", "Thickness h", "pixels", &StripesPicture::thickness_px},
       {"missing_percent", "Missing length farther than 1 pixel", "% of the visible", &StripesPicture::missing_percent, 3},
       {"extra_percent", "Extra length farther than 1 pixel", "% of the visible", &StripesPicture::extra_percent, 3},
       {"pmr_edges_percent", "Differing pixels on edges", "% of the raster", &StripesPicture::pmr_edges_percent, 4},
       {"pmr_inside_percent", "Differing pixels inside", "% of the raster", &StripesPicture::pmr_inside_percent, 4},
       {"h_px", "Greatest distance", "pixels", &StripesPicture::h_px, 3},
       {"h_usual_px", "Distance of all but 1 sample in 1000", "pixels", &StripesPicture::h_usual_px, 3},
       {"h_usual_stripes", "Distance of all but 1 sample in 1000", "stripes", &StripesPicture::h_usual_stripes, 3},
       {"sides", "Sides seen", &StripesPicture::sides},
       {"view_ms", "A view", "ms", &StripesPicture::view_ms, Real::as_needed, host_time}},
      {.notes = {fmt::format("Generated scenes in perspective, all of their faces on {0} x {0} pixels. Lines are compared as "
                             "sets of points with those of exact: stripes are drawn as boundaries of visible parts, whose "
                             "sides do not belong to an edge. Differing pixels on edges are within 0.75 pixels of any edge, "
                             "visible or hidden. The greatest distance is large if a face lower than half a stripe is lost, or "
                             "if a corner that moved past another shows or hides the wrong part.",
                             measured.raster),
                 "Lines between stripes of a pixel are lines between pixels, so that a level edge lights the right rows. Lines "
                 "between thinner stripes also run through the centres of pixels, where an edge that is moved onto them lights "
                 "a wrong row. " +
                     page.claim(of_half_a_pixel > of_a_pixel,
                                fmt::format("That is why the share of differing pixels of the town rises {} from stripes of a "
                                            "pixel to stripes of half a pixel.",
                                            rise),
                                "it is " + rise)}});
}

void add_exponents_table(Page& page, const MontaniReStripes& measured) {
  const auto distance = range_of(measured.exponents, &StripesExponents::h_usual_px);
  const auto sides = range_of(measured.exponents, &StripesExponents::sides);
  const auto thickness = range_of(measured.pictures, &StripesPicture::thickness_px);
  const double wrong =
      greatest(where(measured.pictures, [](const StripesPicture& p) { return p.in_stripes() && *p.thickness_px <= 2; }),
               &StripesPicture::l_sym_percent);
  std::vector<CheckedText> notes{
      "Expected: error as h (exponent 1), sides and time as 1/h (exponent -1). " +
      page.claim(distance.least >= 0.9 && distance.greatest <= 1.1 && sides.least >= -1.1 && sides.greatest <= -0.9,
                 "Distance and sides are within a tenth of it.",
                 fmt::format("they are {} to {} and {} to {}", text_of(distance.least), text_of(distance.greatest),
                             text_of(sides.least), text_of(sides.greatest))) +
      fmt::format(" Least squares of logarithms from {} to {} pixels; errors of 0 are left out, and no exponent is given for "
                  "fewer than three other values. ",
                  text_of(thickness.greatest), text_of(thickness.least)) +
      page.claim(wrong == 0,
                 "The wrong length farther than a pixel is 0 for stripes of two pixels or less.",
                 "it is " + text_of(wrong) + " %")};
  if (page.host_times()) notes.emplace_back("A part of the time, that of relations and list, does not depend on h.");
  page.table("montani-re-thickness-exponents", "Montani and Re: exponents over the thickness h of stripes", measured.exponents,
             {{"scene", "Scene", &StripesExponents::scene},
              {"faces", "Faces", &StripesExponents::faces},
              {"l_sym_percent", "Wrong length farther than 1 pixel", &StripesExponents::l_sym_percent, 2},
              {"pmr_percent", "Differing pixels", &StripesExponents::pmr_percent, 2},
              {"h_usual_px", "Distance of all but 1 sample in 1000", &StripesExponents::h_usual_px, 2},
              {"sides", "Sides seen", &StripesExponents::sides, 2},
              {"view_ms", "Time of a view", &StripesExponents::view_ms, 2, host_time}},
             {.notes = std::move(notes)});
}

}  // namespace

std::vector<PixelSegment> boundary_of(const native::StripePcs& pcs, std::int32_t units) {
  std::vector<PixelSegment> segments;
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t to_x, std::int64_t to_y) {
    const auto point = [units](std::int64_t at, std::int64_t sixteenths) {
      return picture::PixelPoint{static_cast<double>(at) / (16 * 65536) - 0.5, static_cast<double>(sixteenths) / units - 0.5};
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
      for (const native::StripeSide& side : band.sides) add(side.at(band.low), top, side.at(band.high), stripe + band.high);
      top = stripe + band.high;
      top_ends = ends_at(band, band.high);
    }
  }
  add_level({});
  return segments;
}

MontaniReStripes measure_stripes(const StripesOptions& options, const Context& context) {
  MontaniReStripes measured;
  measured.raster = options.raster;
  Stripes stripes(options, measured.pictures);
  for (const std::string& family : options.scenes) {
    context.progress(fmt::format("{} {} in stripes of every thickness", family, options.scene_size));
    stripes.add(family);
  }
  if (options.rounds > 0) stripes.take_times(options.rounds);
  measured.exponents = stripes.exponents();
  return measured;
}

MontaniReStripes montani_re_stripes(const Context& context) {
  StripesOptions options;
  if (context.full) {
    options.scene_size = 50;
    options.raster = 512;
    options.rounds = 9;
  }
  if (!context.host_times) options.rounds = 0;
  return measure_stripes(options, context);
}

void montani_re_accuracy(Page& page, const MontaniReStripes& measured) {
  const std::vector<StripesPicture>& pictures = measured.pictures;
  const double usual = greatest(pictures, &StripesPicture::h_usual_stripes);
  page.paragraph(
      "Corners are moved to the nearest line between stripes, edges are straight between them, so errors should be at most "
      "half a stripe. " +
      page.claim(usual <= 0.5,
                 fmt::format("Of a thousand samples of the lines, all but one are within {} stripes.", text_of(usual, 2)),
                 "one is at " + text_of(usual)) +
      " The measures are: missing and extra length farther than a pixel from the other picture, in per cent of the visible "
      "length, and wrong length, their sum; differing pixels, the share of pixels that show another face than the exact sight "
      "line through their centre meets; and the greatest distance between the lines of the pictures, also without the farthest "
      "one of a thousand samples. h is the thickness of a stripe.");
  const ErrorMeasure length{"l", &StripesPicture::l_sym_percent, "wrong length farther than 1 pixel", "% of the visible"};
  const ErrorMeasure pixels{"pmr", &StripesPicture::pmr_percent, "differing pixels", "% of the raster"};
  const ErrorMeasure distance{"h", &StripesPicture::h_usual_px, "distance of all but one sample in a thousand", "pixels"};
  for (const ErrorMeasure& error : {pixels, distance}) add_sides_plot(page, pictures, error);
  if (page.host_times())
    for (const ErrorMeasure& error : {length, pixels, distance}) add_time_plot(page, pictures, error);
  add_pictures_table(page, measured);
  add_exponents_table(page, measured);
}

}  // namespace sightline::report
