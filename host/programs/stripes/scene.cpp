#include "host/programs/stripes/scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/algorithms/montani_re/region_boundary.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

namespace {

namespace native = algorithms::montani_re;

constexpr double fraction = 256;               // parts of a dot
constexpr double depth_range = 0xFF00;
constexpr double plane_sum = 16383;            // of |a|, |b| and |c|
constexpr double border = picture_size;

// A point in dots, and its depth: increasing, and linear on every plane in dots.
struct Place {
  double x = 0;
  double y = 0;
  double far = 0;
};
using PlaceRings = std::vector<std::vector<Place>>;

// The plane of a face over the dots: far = at_origin + along_x x + along_y y.
struct Slope {
  double at_origin = 0;
  double along_x = 0;
  double along_y = 0;
  [[nodiscard]] double at(double x, double y) const { return at_origin + along_x * x + along_y * y; }
};

class Projection {
 public:
  Projection(const scene::PolyScene& scene, const View& view)
      : scene_(scene),
        camera_(view.camera),
        frame_{native::pixels_per_unit(view.camera, view.scale), {view.left, view.bottom}, picture_size, picture_size} {}

  [[nodiscard]] std::array<double, 2> placed(const std::array<double, 2>& image) const {
    return {frame_.centre[0] + frame_.scale[0] * image[0], frame_.centre[1] + frame_.scale[1] * image[1]};
  }
  [[nodiscard]] std::array<double, 2> dots(const native::Vertex& p) const {
    const double weight = camera_.perspective ? static_cast<double>(p.z) : 1;
    return placed({static_cast<double>(p.x) / weight, static_cast<double>(p.y) / weight});
  }

  // -1 / z in perspective, otherwise z: both are linear in the image.
  [[nodiscard]] Slope slope(const native::Face& face) const {
    std::array<double, 3> n{};
    for (std::size_t k = 0; k < 3; ++k) n[k] = static_cast<double>(face.normal[k]);
    const auto offset = static_cast<double>(face.offset);
    Slope image{offset / n[2], -n[0] / n[2], -n[1] / n[2]};
    if (camera_.perspective) image = {-n[2] / offset, -n[0] / offset, -n[1] / offset};
    const double x = image.along_x / frame_.scale[0];
    const double y = image.along_y / frame_.scale[1];
    return {image.at_origin - x * frame_.centre[0] - y * frame_.centre[1], x, y};
  }

  [[nodiscard]] std::uint8_t level(const native::Face& face) const {
    // The axes of the frame have the lengths of the camera's vectors.
    const auto length = [](const scene::PolyPoint& v) {
      const std::array<double, 3> p{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
      return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    };
    const std::array<double, 3> axes{length(camera_.right), length(camera_.up), length(camera_.forward)};
    constexpr std::array<double, 3> lamp{-0.4, 0.7, -0.59};  // of length 1
    double size = 0;
    double lit = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double part = -static_cast<double>(face.normal[k]) * axes[k];
      size += part * part;
      lit += part * lamp[k];
    }
    return static_cast<std::uint8_t>(std::clamp(std::lround(2 + 5 * lit / std::sqrt(size)), 1L, 7L));
  }

  // The bounds of the picture, rounded outwards.
  [[nodiscard]] native::WindowBounds bounds() const {
    constexpr double limit = 0x1p36;
    std::array<std::array<double, 2>, 2> places{};
    double most = 1;
    for (std::size_t a = 0; a < 2; ++a) {
      places[a] = {-frame_.centre[a] / frame_.scale[a], (border - frame_.centre[a]) / frame_.scale[a]};
      most = std::max({most, std::abs(places[a][0]), std::abs(places[a][1])});
    }
    native::WindowBounds bounds;
    while (camera_.perspective && bounds.unit < (std::int64_t{1} << 30) &&
           most * 2 * static_cast<double>(bounds.unit) < limit)
      bounds.unit *= 2;
    for (std::size_t a = 0; a < 2; ++a) {
      const auto scaled = [&](double place) { return std::clamp(place * static_cast<double>(bounds.unit), -limit, limit); };
      bounds.low[a] = static_cast<std::int64_t>(std::floor(scaled(places[a][0])));
      bounds.high[a] = static_cast<std::int64_t>(std::ceil(scaled(places[a][1])));
    }
    return bounds;
  }

  // All faces before the eye; clipped only if necessary.
  [[nodiscard]] native::FaceSet faces() const {
    if (!native::face_past_eye(scene_, camera_)) {
      native::FaceSet set = native::faces_seen(scene_, camera_);
      const auto inside = [&](const native::Face& face) {
        return std::all_of(face.vertices.begin(), face.vertices.end(), [&](std::uint32_t v) {
          const auto p = dots(set.image.vertices()[v]);
          return p[0] >= 0 && p[0] <= border && p[1] >= 0 && p[1] <= border;
        });
      };
      if (std::all_of(set.faces.begin(), set.faces.end(), inside)) return set;
    }
    const native::WindowBounds window = bounds();
    return native::faces_seen(scene_, camera_, {}, &window);
  }

  // The rings of the face as in the scene.
  [[nodiscard]] PlaceRings whole(const native::FaceSet& set, const native::Face& face) const {
    const scene::PolyFace& source = scene_.bodies[face.body].faces[face.index];
    const Slope plane = slope(face);
    PlaceRings rings;
    const auto add = [&](std::span<const scene::VertexIndex> ring) {
      auto& places = rings.emplace_back();
      for (const scene::VertexIndex v : ring) {
        const auto p = dots(set.image.vertices()[v]);
        places.push_back({p[0], p[1], plane.at(p[0], p[1])});
      }
    };
    add(source.outline);
    for (const auto& hole : source.holes) add(hole);
    return rings;
  }

  [[nodiscard]] PlaceRings outline(const native::FaceSet& set, const native::Face& face,
                                   const native::TrapezoidPcs& region) const {
    const Slope plane = slope(face);
    PlaceRings rings;
    for (const native::RegionLoop& loop : native::boundary_of(set.image, region)) {
      auto& places = rings.emplace_back();
      for (const native::RegionCorner& corner : loop) {
        auto p = placed(native::approximate_point(set.image, corner));
        for (double& part : p) part = std::clamp(part, 0.0, border);
        places.push_back({p[0], p[1], plane.at(p[0], p[1])});
      }
    }
    return rings;
  }

 private:
  const scene::PolyScene& scene_;
  const scene::PolyCamera& camera_;
  native::StripeFrame frame_;
};

// The line is the border between stripes nearest to the corner, as in the native algorithm; the fraction must not change
// it.
std::uint16_t height_of(double y) {
  const double line = std::clamp(std::floor(y + 0.5), 0.0, border);
  const double value = std::clamp<double>(std::round(y * fraction), line * fraction - fraction / 2, line * fraction + fraction / 2 - 1);
  return static_cast<std::uint16_t>(std::clamp(value, 0.0, border * fraction));
}

std::uint16_t width_of(double x) {
  return static_cast<std::uint16_t>(std::clamp(std::round(x * fraction), 0.0, border * fraction));
}

// The depths of all corners of a scene as words.
class Depths {
 public:
  void take(const PlaceRings& rings) {
    for (const auto& ring : rings) {
      for (const Place& place : ring) {
        nearest_ = any_ ? std::min(nearest_, place.far) : place.far;
        farthest_ = any_ ? std::max(farthest_, place.far) : place.far;
        any_ = true;
      }
    }
  }
  [[nodiscard]] double unit() const { return farthest_ > nearest_ ? depth_range / (farthest_ - nearest_) : 0; }
  [[nodiscard]] std::uint16_t word(double far) const {
    return static_cast<std::uint16_t>(std::clamp(std::round((far - nearest_) * unit()), 0.0, depth_range));
  }

 private:
  bool any_ = false;
  double nearest_ = 0;
  double farthest_ = 0;
};

void set_shape(SceneFace& face, const PlaceRings& rings, const Slope& slope, const Depths& depths) {
  for (const auto& ring : rings) {
    auto& corners = face.rings.emplace_back();
    for (const Place& place : ring) corners.push_back({width_of(place.x), height_of(place.y), depths.word(place.far)});
  }
  // Z grows by -a / c and -b / c with X and Y.
  const double along_x = slope.along_x * depths.unit() / fraction;
  const double along_y = slope.along_y * depths.unit() / fraction;
  const double size = (plane_sum - 2) / (std::abs(along_x) + std::abs(along_y) + 1);  // minus what rounding may add
  face.a = static_cast<std::int32_t>(std::lround(-along_x * size));
  face.b = static_cast<std::int32_t>(std::lround(-along_y * size));
  face.c = std::max(1, static_cast<std::int32_t>(std::lround(size)));
  double sum = 0;
  double corners = 0;
  for (const auto& ring : face.rings) {
    for (const Corner& corner : ring) {
      sum += static_cast<double>(face.a) * corner.x + static_cast<double>(face.b) * corner.y +
             static_cast<double>(face.c) * corner.z;
      ++corners;
    }
  }
  face.d = static_cast<std::int32_t>(std::llround(sum / std::max(corners, 1.0)));
}

base::Error passing_through(const native::FaceSet& set, std::uint32_t first, std::uint32_t second) {
  const auto name = [&set](std::uint32_t f) { return fmt::format("face {} of body {}", set.faces[f].index, set.faces[f].body); };
  return {"", "stripes", name(first) + " and " + name(second) + " pass through each other"};
}

}  // namespace

View view_of(const scene::PolyCamera& camera, const registry::FaceWindow& window) {
  return {camera, window.scale, window.left, window.height - window.top};
}

View view_of(const scene::PolyScene& scene, const scene::PolyCamera& camera, std::optional<double> extent) {
  return view_of(camera, registry::face_window(scene, camera, picture_size, picture_size, extent));
}

base::Result<ProjectedScene> project_scene(const scene::PolyScene& scene, const View& view, bool with_priority) {
  const Projection projection(scene, view);
  const native::FaceSet set = projection.faces();
  ProjectedScene result;
  result.clipped = set.window.has_value();
  std::vector<std::uint32_t> order;
  std::optional<native::ListedFaces> listed;
  if (with_priority) {
    listed = native::listed_faces(set);
    if (listed->interpenetrating)
      return passing_through(set, listed->interpenetrating->first, listed->interpenetrating->second);
    result.mutual_parts = listed->counts.mutual_parts;
    result.cuts = listed->counts.cuts + result.mutual_parts;
    for (const native::PriorityClass& members : listed->list.classes()) order.insert(order.end(), members.begin(), members.end());
  } else {
    for (std::uint32_t f = 0; f < set.faces.size(); ++f) order.push_back(f);
  }
  Depths depths;
  std::vector<PlaceRings> rings;
  for (const std::uint32_t f : order) {
    const native::Face& face = set.faces[f];
    const native::TrapezoidPcs& region = listed ? listed->faces[f] : face.pcs;
    const bool cut = set.window || (listed && (region.bands.size() != face.pcs.bands.size() || region.sides != face.pcs.sides));
    rings.push_back(cut ? projection.outline(set, face, region) : projection.whole(set, face));
    depths.take(rings.back());
  }
  const std::vector<std::uint32_t> first = scene::first_face_numbers(scene);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (rings[k].empty()) continue;  // clipped away completely
    const native::Face& source = set.faces[order[k]];
    SceneFace& face = result.faces.emplace_back();
    face.number = first[source.body] + source.index;
    face.body = source.body;
    face.index = source.index;
    face.level = projection.level(source);
    set_shape(face, rings[k], projection.slope(source), depths);
  }
  return result;
}

}  // namespace sightline::programs::stripes
