#include "host/algorithms/exact/view.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <span>

#include "host/base/threads.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::exact {
namespace {

using geometry::dot;
using geometry::Int128;
using geometry::vector_of;

// The bits of a single-precision number, mapped so that they ascend with its value, negative numbers included.
std::uint32_t ascending_key(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits >> 31) != 0 ? ~bits : bits | 0x80000000U;
}

// Rounds image positions to raster steps. They are quotients of integers below 2^37, so every rounding step keeps their
// order.
class Raster {
 public:
  // The raster spans the seen part of the scene except the outermost hundredth on each side, because a vertex beside the
  // eye may appear a thousand widths away. A sample of a few hundred vertices determines it.
  Raster(const View& view, const scene::PolyCamera& camera) {
    constexpr std::size_t samples = 500;
    const std::span<const geometry::Point3> vertices = view.mesh->vertices;
    std::array<std::vector<double>, 2> seen;
    const std::size_t step = vertices.size() / samples + 1;
    for (std::size_t v = 0; v < vertices.size(); v += step) {
      const Vector p = geometry::difference(vertices[v], camera.eye);
      const std::int64_t depth = dot(view.forward, p);
      if (view.perspective && depth <= 0) continue;
      for (std::size_t axis = 0; axis < 2; ++axis) seen[axis].push_back(image_of(view, p, depth, axis));
    }
    for (std::size_t axis = 0; axis < 2 && !seen[0].empty(); ++axis) {
      origin_[axis] = percentile(seen[axis], 0.01);
      const double width = percentile(seen[axis], 0.99) - origin_[axis];
      if (width > 0) steps_a_unit_[axis] = (last_step + 1) / width;
    }
  }

  [[nodiscard]] std::uint16_t step_of(double image, std::size_t axis) const {
    const double step = (image - origin_[axis]) * steps_a_unit_[axis];
    return static_cast<std::uint16_t>(static_cast<std::int32_t>(std::min(std::max(step, 0.0), double{last_step})));
  }
  [[nodiscard]] static double image_of(const View& view, const Vector& p, std::int64_t depth, std::size_t axis) {
    const double over = view.perspective ? static_cast<double>(depth) : 1.0;
    return static_cast<double>(dot(view.axes[axis], p)) / over;
  }

 private:
  static double percentile(std::vector<double>& values, double part) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  }

  std::array<double, 2> origin_{};
  std::array<double, 2> steps_a_unit_{1, 1};
};

// Positions and depths of the ends of crossings. They may be out of order with the exact ones, so depths are one step
// farther.
void place_lines(View& view, const Raster& raster) {
  for (std::size_t l = 0; l < view.mesh->lines.size(); ++l) {
    for (std::size_t e = 0; e < 2; ++e) {
      const LinePoint end = view.line_point(view.mesh->lines[l].ends[e]);
      ViewPoint& point = view.points[view.mesh->first_line_vertex() + 2 * l + e];
      const auto along = [&end](const Vector& direction) { return end.between(dot(direction, end.p), dot(direction, end.q)); };
      const Int128 depth = along(view.forward);
      point.depth = 0;
      if (view.perspective && depth <= 0) continue;
      const auto weight = static_cast<double>(end.weight());
      point.depth = ascending_key(static_cast<float>(static_cast<double>(depth) / weight)) + 1;
      const double over = view.perspective ? static_cast<double>(depth) : weight;
      for (std::size_t axis = 0; axis < 2; ++axis)
        point.seen[axis] = raster.step_of(static_cast<double>(along(view.axes[axis])) / over, axis);
    }
  }
}

void place_points(View& view, const scene::PolyCamera& camera, unsigned jobs) {
  const Raster raster(view, camera);
  const std::span<const geometry::Point3> vertices = view.mesh->vertices;
  view.points.resize(vertices.size());
  base::for_parts(jobs, vertices.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      ViewPoint& point = view.points[v];
      const Vector p = geometry::difference(vertices[v], camera.eye);
      const std::int64_t depth = dot(view.forward, p);
      if (view.perspective && depth <= 0) continue;
      point.depth = ascending_key(static_cast<float>(depth));
      for (std::size_t axis = 0; axis < 2; ++axis)
        point.seen[axis] = raster.step_of(Raster::image_of(view, p, depth, axis), axis);
    }
  });
  place_lines(view, raster);
}

// What one thread finds for its part of the faces.
struct FacePart {
  std::vector<std::uint8_t> drawn;
  std::vector<Occluder> occluders;
  std::vector<ImageBounds> bounds;
  std::vector<std::uint32_t> depths;
};

void add_occluder(const View& view, std::uint32_t number, const Plane& beyond, FacePart& part) {
  const MeshFace& face = view.mesh->faces[number];
  const Corner* const corners = view.mesh->corners_of(face);
  ImageBounds bounds;
  std::uint32_t nearest = ~0U;
  std::uint32_t farthest = 0;
  bool one_ring = true;
  for_sides(corners, face.corner_count, [&](std::uint32_t i, std::uint32_t next) {
    const std::uint32_t depth = view.points[corners[i].vertex].depth;
    view.extend(bounds, corners[i].vertex, corners[next].vertex);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    one_ring = one_ring && next == (i + 1 == face.corner_count ? 0 : i + 1);
  });
  if (view.perspective && farthest == 0) return;
  Occluder occluder;
  const bool few_corners = one_ring && (face.corner_count == 3 || face.corner_count == 4);
  occluder.beyond = PackedNormal(beyond.normal);
  occluder.offset = beyond.offset;
  occluder.face = number & 0x7fffffffU;
  occluder.few_corners = few_corners ? 1 : 0;
  for (std::uint32_t i = 0; few_corners && i < 4; ++i)
    occluder.corners[i] = PackedPoint(view.at(corners[std::min(i, std::uint32_t{face.corner_count} - 1)].vertex));
  part.occluders.push_back(occluder);
  part.bounds.push_back(bounds);
  part.depths.push_back(nearest);
}

FacePart faces_of(const View& view, std::size_t begin, std::size_t end, bool all_edges) {
  const EdgeMesh& mesh = *view.mesh;
  FacePart part;
  if (all_edges) part.drawn.assign(mesh.edges.size(), 0);
  const std::size_t likely = (end - begin) / 2 + 1;  // fits solids; the vectors grow for sheets
  part.occluders.reserve(likely);
  part.bounds.reserve(likely);
  part.depths.reserve(likely);
  for (std::size_t number = begin; number < end; ++number) {
    const MeshFace& face = mesh.faces[number];
    const Corner* const corners = mesh.corners_of(face);
    const Vector normal = face.normal.unpacked();
    const std::int64_t offset = dot(normal, vector_of(view.at(corners->vertex)));
    const std::int64_t away = view.perspective ? offset : dot(normal, view.forward);
    if (away > 0 && face.sheet == 0) continue;
    for (std::uint32_t i = 0; all_edges && i < face.corner_count; ++i) part.drawn[mesh.sides[face.first_corner + i]] = 1;
    if (away == 0) continue;
    // Positive beyond the face: opposite to the normal if the face is turned to the eye.
    const Plane beyond = away < 0 ? Plane{geometry::negated(normal), -offset} : Plane{normal, offset};
    add_occluder(view, static_cast<std::uint32_t>(number), beyond, part);
  }
  return part;
}

// `all_edges`: those of the faces are drawn.
void place_faces(View& view, bool all_edges, unsigned jobs) {
  std::vector<FacePart> parts(jobs);
  base::for_parts(jobs, view.mesh->faces.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    parts[part] = faces_of(view, begin, end, all_edges);
  });
  view.drawn = std::move(parts[0].drawn);
  view.occluders = std::move(parts[0].occluders);
  view.occluder_bounds = std::move(parts[0].bounds);
  view.occluder_depths = std::move(parts[0].depths);
  for (std::size_t p = 1; p < parts.size(); ++p) {
    FacePart& part = parts[p];
    for (std::size_t e = 0; e < part.drawn.size(); ++e) view.drawn[e] |= part.drawn[e];
    view.occluders.insert(view.occluders.end(), part.occluders.begin(), part.occluders.end());
    view.occluder_bounds.insert(view.occluder_bounds.end(), part.bounds.begin(), part.bounds.end());
    view.occluder_depths.insert(view.occluder_depths.end(), part.depths.begin(), part.depths.end());
    part = FacePart();
  }
}

}  // namespace

// The segment's image runs to infinity in the direction of the projection of its point behind the eye.
void View::extend_to_infinity(ImageBounds& bounds, std::uint32_t seen, std::uint32_t behind) const {
  const Vector p = vector_of(at(seen));
  const Vector q = vector_of(at(behind));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Int128 direction =
        Int128{dot(axes[axis], q)} * dot(forward, p) - Int128{dot(axes[axis], p)} * dot(forward, q);
    if (direction > 0) bounds.high[axis] = last_step;
    if (direction < 0) bounds.low[axis] = 0;
  }
}

ImageBounds View::bounds_of_line(const picture::LineEdge& line) const {
  ImageBounds bounds{{0, 0}, {last_step, last_step}};
  const ViewPoint& p = points[line.from];
  const ViewPoint& q = points[line.to];
  if (!before_eye(p) || !before_eye(q)) return bounds;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(p.seen[axis], q.seen[axis]);
    bounds.low[axis] = static_cast<std::uint16_t>(low - (low > 0 ? 1 : 0));
    bounds.high[axis] = static_cast<std::uint16_t>(high + (high < last_step ? 1 : 0));
  }
  return bounds;
}

View make_view(const EdgeMesh& mesh, const scene::PolyCamera& camera, const picture::ChosenEdges* chosen,
               unsigned jobs) {
  View view;
  view.mesh = &mesh;
  view.perspective = camera.perspective;
  view.eye = camera.eye;
  view.forward = vector_of(camera.forward);
  view.axes = {vector_of(camera.right), vector_of(camera.up)};
  view.edges = chosen == nullptr ? std::span(mesh.edges) : std::span(chosen->edges);
  const auto is_line = [&mesh](const picture::LineEdge& edge) { return edge.from >= mesh.first_line_vertex(); };
  view.first_line = static_cast<std::uint32_t>(
      std::partition_point(view.edges.begin(), view.edges.end(), std::not_fn(is_line)) - view.edges.begin());
  place_points(view, camera, jobs);
  place_faces(view, chosen == nullptr, jobs);
  if (chosen == nullptr) {
    for (const std::uint32_t wire : mesh.wires) view.drawn[wire] = 1;
  } else {
    view.drawn.resize(view.edges.size());
    std::transform(chosen->turned_away.begin(), chosen->turned_away.end(), view.drawn.begin(), [](std::uint8_t away) { return away == 0 ? 1 : 0; });
  }
  for (std::size_t e = 0; view.perspective && e < view.edges.size(); ++e) {
    const picture::LineEdge& edge = view.edges[e];
    if (view.points[edge.from].depth == 0 && view.points[edge.to].depth == 0) view.drawn[e] = 0;
  }
  return view;
}

}  // namespace sightline::algorithms::exact
