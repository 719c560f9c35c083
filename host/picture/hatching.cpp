#include "host/picture/hatching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::picture {
namespace {

using geometry::RealVector;

// Parallel lines: line k is where `across` . p = start + k * step in the image.
struct HatchFamily {
  std::array<double, 2> across{};
  double start = 0;
  double step = 0;
  std::int64_t first = 0;  // of those that meet the window
  std::int64_t last = -1;
};

class Hatcher {
 public:
  Hatcher(const scene::PolyScene& scene, const scene::PolyCamera& camera, const ImageWindow& window,
          double units, const HatchOptions& options)
      : camera_(camera), view_(camera), shade_(options.shade), cut_material_(options.cut_material), axes_{view_.axis(0), view_.axis(1), view_.axis(2)}, light_(geometry::unit(options.light)) {
    result_.scene = scene;
    families_ = {family(options.angle, options.spacing / units, window), family(options.angle + 90, options.spacing / units, window),
                 family(45, options.cut_spacing / units, window), family(135, options.cut_spacing / units, window)};
    image_.reserve(scene.vertices.size());
    for (const scene::PolyPoint& v : scene.vertices) image_.push_back(view_.at(v));
  }

  base::Result<Hatching> run() {
    std::uint32_t number = 0;
    const std::vector<scene::PolyBody>& bodies = result_.scene.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const scene::PolyFace& face : bodies[b].faces) {
        add(face, b, number++);
        if (result_.lines.edges.size() > most_hatch_lines) {
          return base::Error{"", "", "hatching of more than " + std::to_string(most_hatch_lines) + " lines", "fewer",
                             "a wider spacing"};
        }
      }
    }
    return std::move(result_);
  }

 private:
  static HatchFamily family(double degrees, double step, const ImageWindow& window) {
    const double angle = degrees * std::numbers::pi / 180;
    HatchFamily family;
    family.across = {-std::sin(angle), std::cos(angle)};
    family.start = family.across[0] * window.low[0] + family.across[1] * window.low[1];
    family.step = step;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double x : {window.low[0], window.high[0]}) {
      for (const double y : {window.low[1], window.high[1]}) {
        const double at = (family.across[0] * x + family.across[1] * y - family.start) / step;
        low = std::min(low, at);
        high = std::max(high, at);
      }
    }
    constexpr double farthest = 1e7;
    family.first = static_cast<std::int64_t>(std::ceil(std::max(low, -farthest)));
    family.last = static_cast<std::int64_t>(std::floor(std::min(high, farthest)));
    return family;
  }

  [[nodiscard]] bool is_cut(std::uint32_t face) const {
    const std::vector<std::uint32_t>& materials = result_.scene.material_of;
    return cut_material_ && !materials.empty() && materials[face] >= *cut_material_;
  }

  void add(const scene::PolyFace& face, std::size_t body, std::uint32_t number) {
    const bool sheet = result_.scene.bodies[body].sheet;
    const bool cut = is_cut(number);
    if (!cut && !shade_) return;
    const geometry::Vector3 normal = scene::plane_of(result_.scene.vertices, face).normal;
    const geometry::Vector3 sight = camera_.perspective ? geometry::difference(at(face.outline[0]), camera_.eye)
                                                        : geometry::vector_of(camera_.forward);
    const int facing = -geometry::sign(geometry::wide_dot(normal, sight));
    if (facing == 0 || (facing < 0 && !sheet)) return;
    if (cut) {
      const bool second = (result_.scene.material_of[number] - *cut_material_) % 2 != 0;
      return lines(face, normal, second ? HatchDirection::cut_across : HatchDirection::cut, 1, number);
    }
    RealVector shaded = geometry::unit(geometry::real_vector(normal));
    if (!result_.scene.surfaces.empty() && !sheet) shaded = result_.scene.surfaces[result_.scene.surface_of[number]].normal;
    double light = geometry::dot(shaded, light_);
    if (facing < 0) light = -light;
    const Tone tone = tone_of(light);
    if (tone == Tone::light) return;
    lines(face, normal, HatchDirection::along, tone == Tone::fourth ? 4 : tone == Tone::half ? 2 : 1, number);
    if (tone == Tone::crossed) lines(face, normal, HatchDirection::across, 2, number);
  }

  [[nodiscard]] const scene::PolyPoint& at(scene::VertexIndex v) const { return result_.scene.vertices[v]; }

  // The range of lines that meet the face's image; all lines of the window if a part of the face is behind the eye.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> range(const scene::PolyFace& face, const HatchFamily& family) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const scene::VertexIndex v : face.outline) {
      const RealVector& p = image_[v];
      if (p[2] <= 0) return {family.first, family.last};
      const double place = ((family.across[0] * p[0] + family.across[1] * p[1]) / p[2] - family.start) / family.step;
      low = std::min(low, place);
      high = std::max(high, place);
    }
    if (low > static_cast<double>(family.last) || high < static_cast<double>(family.first)) return {1, 0};
    return {std::max(family.first, static_cast<std::int64_t>(std::floor(std::max(low, static_cast<double>(family.first))))),
            std::min(family.last, static_cast<std::int64_t>(std::ceil(std::min(high, static_cast<double>(family.last)))))};
  }

  void lines(const scene::PolyFace& face, const geometry::Vector3& normal, HatchDirection direction, std::int64_t every,
             std::uint32_t number) {
    const auto which = static_cast<std::size_t>(direction);
    auto [first, last] = range(face, families_[which]);
    const std::int64_t over = ((first % every) + every) % every;
    if (over != 0) first += every - over;
    for (std::int64_t k = first; k <= last; k += every) {
      const std::uint32_t plane = plane_of_line(which, k);
      const geometry::Plane& cut = result_.scene.cut_planes[plane];
      const scene::CutAxis along = scene::cut_axis(normal, cut.normal);
      if (along.sign == 0) continue;
      bool zero = false;
      for (const auto& [low, high] : scene::cuts_of(result_.scene.vertices, face, cut, along.axis, true, zero)) {
        if (along.sign > 0) add_line({low.point, high.point}, number, plane, direction);
        else add_line({high.point, low.point}, number, plane, direction);
      }
      if (result_.lines.edges.size() > most_hatch_lines) return;
    }
  }

  // The plane of the points that appear on the line: through the eye in perspective, otherwise parallel to the view.
  std::uint32_t plane_of_line(std::size_t which, std::int64_t k) {
    const HatchFamily& family = families_[which];
    const auto [known, added] = planes_.try_emplace({which, k}, static_cast<std::uint32_t>(result_.scene.cut_planes.size()));
    if (!added) return known->second;
    const double offset = family.start + static_cast<double>(k) * family.step;
    RealVector normal{};
    double most = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      normal[a] = family.across[0] * axes_[0][a] + family.across[1] * axes_[1][a];
      if (camera_.perspective) normal[a] -= offset * axes_[2][a];
      most = std::max(most, std::abs(normal[a]));
    }
    const double scale = 0x1p38 / most;
    geometry::Plane plane;
    for (std::size_t a = 0; a < 3; ++a) plane.normal[a] = std::llround(normal[a] * scale);
    plane.offset = geometry::dot(plane.normal, geometry::vector_of(camera_.eye));
    if (!camera_.perspective) plane.offset += std::llround(offset * scale);
    result_.scene.cut_planes.push_back(plane);
    return known->second;
  }

  void add_line(const std::array<scene::CutPoint, 2>& ends, std::uint32_t face, std::uint32_t plane, HatchDirection direction) {
    scene::add_crossing(result_.scene, face, face, plane, ends);
    const scene::PolyCrossing& line = result_.scene.crossings.back();
    ChosenEdges& lines = result_.lines;
    lines.edges.push_back({line.from, line.to});
    lines.kinds.push_back(EdgeKind::flat);
    lines.turned_away.push_back(0);
    if (!result_.scene.surface_of.empty()) lines.surfaces.push_back(result_.scene.surface_of[face]);
    lines.first_surface.push_back(static_cast<std::uint32_t>(lines.surfaces.size()));
    result_.directions.push_back(direction);
  }

  const scene::PolyCamera& camera_;
  CameraView view_;
  bool shade_;
  std::optional<std::uint32_t> cut_material_;
  std::array<RealVector, 3> axes_;  // normalized
  RealVector light_;
  std::array<HatchFamily, 4> families_;  // by direction
  std::vector<SeenPoint> image_;  // by vertex
  std::map<std::pair<std::size_t, std::int64_t>, std::uint32_t> planes_;  // of lines in use
  Hatching result_;
};

// A straight line of the image: its position across a direction, and its range along it.
struct Ruled {
  double offset = 0;
  double low = 0;
  double high = 0;
};

using ImageEnds = std::array<std::array<double, 2>, 2>;

ImageEnds ends_of(const UnitedLine& line) {
  return {{{line.from[0] / line.from[2], line.from[1] / line.from[2]}, {line.to[0] / line.to[2], line.to[1] / line.to[2]}}};
}

Ruled ruled(const ImageEnds& ends, const std::array<double, 2>& along) {
  const auto at = [&along](const std::array<double, 2>& p) { return p[0] * along[0] + p[1] * along[1]; };
  const auto across = [&along](const std::array<double, 2>& p) { return p[1] * along[0] - p[0] * along[1]; };
  return {(across(ends[0]) + across(ends[1])) / 2, std::min(at(ends[0]), at(ends[1])), std::max(at(ends[0]), at(ends[1]))};
}

// Lines of the image in one direction.
struct Along {
  std::array<double, 2> direction{};
  double near = 0;  // lines closer together than this count as one line

  [[nodiscard]] bool has(const ImageEnds& ends) const {
    const double off = (ends[1][1] - ends[0][1]) * direction[0] - (ends[1][0] - ends[0][0]) * direction[1];
    return std::abs(off) <= near;
  }
};

// Subtracts, from lines in the direction, the parts that lie on other such lines.
template <class IsTaken, class IsDrawn>
void take_out(UnitedLines& lines, const Along& along, const IsTaken& is_taken, const IsDrawn& is_drawn) {
  std::vector<Ruled> drawn;
  for (const UnitedLine& line : lines.lines)
    if (const ImageEnds ends = ends_of(line); is_drawn(line) && along.has(ends)) drawn.push_back(ruled(ends, along.direction));
  if (drawn.empty()) return;
  std::sort(drawn.begin(), drawn.end(), [](const Ruled& a, const Ruled& b) { return a.offset < b.offset; });
  std::vector<UnitedLine> kept;
  std::vector<std::pair<double, double>> covered;
  for (const UnitedLine& line : lines.lines) {
    covered.clear();
    const ImageEnds ends = ends_of(line);
    const Ruled at = ruled(ends, along.direction);
    if (is_taken(line) && along.has(ends)) {
      for (auto other = std::lower_bound(drawn.begin(), drawn.end(), at.offset - along.near,
                                         [](const Ruled& r, double offset) { return r.offset < offset; });
           other != drawn.end() && other->offset <= at.offset + along.near; ++other)
        if (other->low < at.high - along.near && other->high > at.low + along.near) covered.emplace_back(other->low, other->high);
    }
    if (covered.empty()) {
      kept.push_back(line);
      continue;
    }
    // The rest, as points between the ends, which are in homogeneous coordinates.
    std::sort(covered.begin(), covered.end());
    const bool rises = ruled({{ends[0], ends[0]}}, along.direction).low == at.low;
    const auto point = [&](double place) {
      const std::array<double, 3>& low = rises ? line.from : line.to;
      const std::array<double, 3>& high = rises ? line.to : line.from;
      const double t = (place - at.low) / (at.high - at.low) * low[2];
      const double s = (at.high - place) / (at.high - at.low) * high[2];
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < 3; ++i) p[i] = (low[i] * s + high[i] * t) / (s + t);
      return p;
    };
    double low = at.low;
    covered.emplace_back(at.high, at.high);
    for (const auto& [from, to] : covered) {
      if (from > low + along.near)
        kept.push_back({point(low), point(std::min(from, at.high)), line.layer, line.first_source, line.source_count});
      low = std::max(low, to);
    }
  }
  lines.lines = std::move(kept);
}

}  // namespace

Tone tone_of(double facing) {
  constexpr double no_lines = 0.85;
  constexpr double every_fourth = 0.6;
  constexpr double every_second = 0.35;
  constexpr double all = 0.1;
  if (facing >= no_lines) return Tone::light;
  if (facing >= every_fourth) return Tone::fourth;
  if (facing >= every_second) return Tone::half;
  return facing >= all ? Tone::full : Tone::crossed;
}

base::Result<Hatching> hatch(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                               const ImageWindow& window, double units, const HatchOptions& options) {
  return Hatcher(scene, camera, window, units, options).run();
}

void leave_out_hatching_on_lines(UnitedLines& lines, std::span<const LineLayer> layers, const ImageWindow& window) {
  const auto kind_of = [&](const UnitedLine& line) -> std::string_view { return layers[line.layer].kind; };
  for (const std::string_view kind : hatching_kinds) {
    const auto is_hatching = [&](const UnitedLine& line) { return kind_of(line) == kind; };
    // All lines of a kind are parallel: the longest gives the direction.
    Along along;
    double longest = 0;
    for (const UnitedLine& line : lines.lines) {
      if (!is_hatching(line)) continue;
      const ImageEnds ends = ends_of(line);
      const double length = std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
      if (!std::isfinite(length) || length <= longest) continue;
      longest = length;
      along.direction = {(ends[1][0] - ends[0][0]) / length, (ends[1][1] - ends[0][1]) / length};
    }
    if (longest == 0) continue;
    along.near = 1e-6 * std::max(window.high[0] - window.low[0], window.high[1] - window.low[1]);
    const auto is_hidden = [&](const UnitedLine& line) { return layers[line.layer].hidden; };
    const auto is_visible_edge = [&](const UnitedLine& line) {
      return !is_hidden(line) && std::find(hatching_kinds.begin(), hatching_kinds.end(), kind_of(line)) == hatching_kinds.end();
    };
    take_out(lines, along, is_hatching, is_visible_edge);
    take_out(lines, along, is_hidden, is_hatching);
  }
}

}  // namespace sightline::picture
