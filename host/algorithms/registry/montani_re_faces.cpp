#include "host/algorithms/registry/montani_re_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "host/algorithms/montani_re/coverage.hpp"
#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/algorithms/montani_re/region_boundary.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

namespace {

namespace montani_re = algorithms::montani_re;

montani_re::StripeFrame frame_of(const scene::PolyCamera& camera, const FaceWindow& window) {
  return {montani_re::pixels_per_unit(camera, window.scale),
          {window.left, window.height - window.top},
          window.width,
          window.height};
}

// The part of the image that the frame shows, enlarged on every side by `beyond` times its size, rounded outwards.
montani_re::WindowBounds bounds_of(const montani_re::StripeFrame& frame, bool perspective, double beyond) {
  constexpr double limit = 0x1p36;
  const std::array<std::int32_t, 2> size{frame.width, frame.height};
  std::array<std::array<double, 2>, 2> places{};
  double most = 1;
  for (std::size_t a = 0; a < 2; ++a) {
    places[a] = {(-beyond * size[a] - frame.centre[a]) / frame.scale[a],
                 ((1 + beyond) * size[a] - frame.centre[a]) / frame.scale[a]};
    most = std::max({most, std::abs(places[a][0]), std::abs(places[a][1])});
  }
  montani_re::WindowBounds bounds;
  bounds.unit = 1;
  while (perspective && bounds.unit < (std::int64_t{1} << 30) &&
         most * 2 * static_cast<double>(bounds.unit) < limit)
    bounds.unit *= 2;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto scaled = [&](double place) {
      return std::clamp(place * static_cast<double>(bounds.unit), -limit, limit);
    };
    bounds.low[a] = static_cast<std::int64_t>(std::floor(scaled(places[a][0])));
    bounds.high[a] = static_cast<std::int64_t>(std::ceil(scaled(places[a][1])));
  }
  return bounds;
}

base::Error passing_through(const montani_re::FaceSet& set, std::uint32_t first, std::uint32_t second) {
  const auto name = [&set](std::uint32_t f) {
    return "face " + std::to_string(set.faces[f].index) + " of body " + std::to_string(set.faces[f].body);
  };
  return {"", "montani-re", name(first) + " and " + name(second) + " pass through each other"};
}

class MontaniReScene {
 public:
  MontaniReScene(const scene::PolyScene& scene, std::int32_t units, montani_re::Silhouette silhouette)
      : scene_(scene),
        units_(units),
        silhouette_(silhouette),
        first_faces_(scene::first_face_numbers(scene)) {}

  [[nodiscard]] base::Result<FaceView> view(const scene::PolyCamera& camera, const FaceWindow& window) const {
    const montani_re::StripeFrame frame = frame_of(camera, window);
    const montani_re::FaceSet set = faces_in(camera, frame);
    const montani_re::ListedFaces listed = montani_re::listed_faces(set);
    if (listed.interpenetrating)
      return passing_through(set, listed.interpenetrating->first, listed.interpenetrating->second);
    const montani_re::StripeRaster raster =
        montani_re::raster_by_difference(set.image, listed.list, listed.faces, frame, units_);
    FaceView view;
    view.faces = picture::PixelGrid(window.width, window.height);
    for (std::size_t i = 0; i < raster.faces.size(); ++i)
      if (raster.faces[i] != montani_re::none) view.faces.values[i] = number(set.faces[raster.faces[i]]);
    view.counts = counts_of(set, listed, raster.sides);
    return view;
  }

  [[nodiscard]] base::Result<std::vector<FaceCount>> coverage(const scene::PolyCamera& camera, const FaceWindow& window,
                                                              const std::function<void(const FacePart&)>& take) const {
    const montani_re::StripeFrame frame = frame_of(camera, window);
    const montani_re::FaceSet set = faces_in(camera, frame);
    const montani_re::ListedFaces listed = montani_re::listed_faces(set);
    if (listed.interpenetrating)
      return passing_through(set, listed.interpenetrating->first, listed.interpenetrating->second);
    const std::uint64_t sides = montani_re::coverage_by_difference(
        set.image, listed.list, listed.faces, frame, units_,
        [&](std::uint32_t face, std::int32_t column, std::int32_t row, std::int64_t part) {
          take({number(set.faces[face]), column, row, part, montani_re::whole_pixel(units_)});
        });
    return counts_of(set, listed, sides);
  }

  [[nodiscard]] base::Result<FaceRegions> regions(const scene::PolyCamera& camera,
                                                  const FaceWindow& window) const {
    const montani_re::StripeFrame frame = frame_of(camera, window);
    const montani_re::WindowBounds bounds = bounds_of(frame, camera.perspective, 0);
    const montani_re::FaceSet set = montani_re::faces_seen(scene_, camera, {}, &bounds);
    const montani_re::VisibleRegions seen = montani_re::visible_regions(set, silhouette_);
    if (seen.interpenetrating)
      return passing_through(set, seen.interpenetrating->first, seen.interpenetrating->second);
    FaceRegions regions;
    std::uint64_t corners = 0;
    std::uint64_t holes = 0;
    for (std::size_t f = 0; f < set.faces.size(); ++f) {
      FaceRegion region{number(set.faces[f]), {}};
      for (const montani_re::RegionLoop& loop : montani_re::boundary_of(set.image, seen.regions[f])) {
        if (montani_re::signed_area(set.image, loop) < 0) ++holes;
        corners += loop.size();
        region.loops.push_back(placed(set.image, loop, frame));
      }
      if (!region.loops.empty()) regions.regions.push_back(std::move(region));
    }
    regions.counts = {
        {"faces", set.faces.size()},  {"relations", seen.counts.relations}, {"cycles_cut", seen.counts.cuts},
        {"sides", seen.counts.sides}, {"regions", regions.regions.size()},  {"holes", holes},
        {"corners", corners}};
    return regions;
  }

 private:
  [[nodiscard]] montani_re::FaceSet faces_in(const scene::PolyCamera& camera, const montani_re::StripeFrame& frame) const {
    // Corners are moved by up to four pixels, so the borders are kept far from the shown part.
    const montani_re::WindowBounds bounds = bounds_of(frame, camera.perspective, 1);
    const bool past_eye = montani_re::face_past_eye(scene_, camera).has_value();
    return montani_re::faces_seen(scene_, camera, {}, past_eye ? &bounds : nullptr);
  }

  static std::vector<FaceCount> counts_of(const montani_re::FaceSet& set, const montani_re::ListedFaces& listed,
                                          std::uint64_t sides) {
    return {{"faces", set.faces.size()},
            {"relations", listed.counts.relations},
            {"cycles_cut", listed.counts.cuts},
            {"sides", sides}};
  }

  [[nodiscard]] std::uint32_t number(const montani_re::Face& face) const {
    return first_faces_[face.body] + face.index;
  }

  static std::vector<picture::PixelPoint> placed(const montani_re::Image& image, const montani_re::RegionLoop& loop,
                                                 const montani_re::StripeFrame& frame) {
    std::vector<picture::PixelPoint> points;
    for (const montani_re::RegionCorner& corner : loop) {
      const auto p = montani_re::approximate_point(image, corner);
      points.push_back({frame.centre[0] + frame.scale[0] * p[0], frame.centre[1] + frame.scale[1] * p[1]});
    }
    return points;
  }

  const scene::PolyScene& scene_;
  std::int32_t units_;
  montani_re::Silhouette silhouette_;
  std::vector<std::uint32_t> first_faces_;  // by body
};

}  // namespace

base::Result<PreparedFaces> prepare_montani_re_faces(const scene::PolyScene& scene,
                                                     const FaceOptions& options) {
  const auto found = std::find(stripe_thicknesses.begin(), stripe_thicknesses.end(), options.stripe);
  if (found == stripe_thicknesses.end())
    return base::Error{"", "stripe", "the thickness is not available", "8, 4, 2, 1, 1/2 or 1/4 pixels"};
  const auto made = std::make_shared<const MontaniReScene>(
      scene, static_cast<std::int32_t>(16 / *found),
      options.one_silhouette ? montani_re::Silhouette::whole : montani_re::Silhouette::neighbours);
  PreparedFaces prepared;
  prepared.view = [made](const scene::PolyCamera& camera, const FaceWindow& window) {
    return made->view(camera, window);
  };
  prepared.coverage = [made](const scene::PolyCamera& camera, const FaceWindow& window,
                             const std::function<void(const FacePart&)>& take) { return made->coverage(camera, window, take); };
  prepared.regions = [made](const scene::PolyCamera& camera, const FaceWindow& window) {
    return made->regions(camera, window);
  };
  return prepared;
}

}  // namespace sightline::registry
