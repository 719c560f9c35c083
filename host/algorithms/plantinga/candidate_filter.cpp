#include "host/algorithms/plantinga/candidate_filter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using Point = ConvexParts::Point;

Point point_of(const Vector3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// Far above the rounding errors of unit normals and directions.
constexpr double facing_margin = 1e-9;

// Whether the face has one ring that turns in one direction only. Collinear corners are allowed.
bool is_convex(const RotationModel& model, FaceIndex index) {
  const auto corners = model.corners(index);
  const std::size_t axis = geometry::dominant_axis(model.faces()[index].normal);
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].next != (i + 1 == corners.size() ? 0 : i + 1)) return false;  // a second ring
    const Vector3& p = model.vertices()[corners[i].vertex];
    const Vector3& q = model.vertices()[corners[corners[i].next].vertex];
    const Vector3& r = model.vertices()[corners[corners[corners[i].next].next].vertex];
    const std::int64_t turn = (q[u] - p[u]) * (r[v] - q[v]) - (q[v] - p[v]) * (r[u] - q[u]);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

// The rings of a face in the scene's form.
scene::PolyFace rings_of(const RotationModel& model, FaceIndex index) {
  scene::PolyFace face;
  const auto corners = model.corners(index);
  for (std::size_t i = 0; i < corners.size();) {
    scene::Ring ring;
    const std::size_t first = i;
    do {
      ring.push_back(corners[i].vertex);
      i = corners[i].next;
    } while (i != first);
    i = first + ring.size();
    if (first == 0) {
      face.outline = std::move(ring);
    } else {
      face.holes.push_back(std::move(ring));
    }
  }
  return face;
}

}  // namespace

ConvexParts::ConvexParts(const RotationModel& model) {
  std::vector<scene::PolyPoint> vertices;
  vertices.reserve(model.vertices().size());
  for (const Vector3& v : model.vertices()) {
    vertices.push_back(
        {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), static_cast<std::int32_t>(v[2])});
    for (const std::int64_t c : v) size_ = std::max(size_, std::abs(static_cast<double>(c)));
  }
  part_start_.push_back(0);
  for (FaceIndex f = 0; f < model.faces().size(); ++f) {
    const RotatedFace& given = model.faces()[f];
    Face face;
    face.first_part = static_cast<std::uint32_t>(part_start_.size() - 1);
    const Point n = point_of(given.normal);
    const double length = std::hypot(n.x, n.y, n.z);
    face.normal = {n.x / length, n.y / length, n.z / length};
    face.on = point_of(model.vertices()[model.corners(f)[0].vertex]);
    face.low = static_cast<double>(given.low);
    face.high = static_cast<double>(given.high);
    if (is_convex(model, f)) {
      for (const Corner& corner : model.corners(f))
        points_.push_back(point_of(model.vertices()[corner.vertex]));
      part_start_.push_back(static_cast<std::uint32_t>(points_.size()));
    } else if (const auto triangles = scene::triangulate(vertices, rings_of(model, f))) {
      for (const auto& triangle : *triangles) {
        for (const scene::VertexIndex v : triangle) points_.push_back(point_of(model.vertices()[v]));
        part_start_.push_back(static_cast<std::uint32_t>(points_.size()));
      }
    }
    face.last_part = static_cast<std::uint32_t>(part_start_.size() - 1);
    faces_.push_back(face);
  }
}

bool ConvexParts::covers(FaceIndex index, int side, const Point& p, const NearDirection& v,
                         double margin) const {
  const Face& face = faces_[index];
  if (p.y <= face.low + margin || p.y >= face.high - margin) return false;
  const double u = p.x * v.z - p.z * v.x;
  const auto u_of = [&v](const Point& q) { return q.x * v.z - q.z * v.x; };
  for (std::uint32_t part = face.first_part; part < face.last_part; ++part) {
    const std::uint32_t first = part_start_[part];
    const std::uint32_t last = part_start_[part + 1];
    double qu = u_of(points_[last - 1]);
    double qy = points_[last - 1].y;
    bool inside = true;
    for (std::uint32_t i = first; i < last && inside; ++i) {
      const double ru = u_of(points_[i]);
      const double ry = points_[i].y;
      const double turn = side * ((ru - qu) * (p.y - qy) - (ry - qy) * (u - qu));
      inside = turn > margin * (std::abs(ru - qu) + std::abs(ry - qy));
      qu = ru;
      qy = ry;
    }
    if (inside) return true;
  }
  return false;
}

CandidateFilter::CandidateFilter(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge,
                                 const std::vector<Occluder>& occluders)
    : model_(model), parts_(parts), occluders_(occluders) {
  const Segment segment = model.segment(edge);
  from_ = point_of(segment.from);
  along_ = point_of(segment.along());
  length_ = std::hypot(along_.x, along_.y, along_.z);
}

bool CandidateFilter::hidden(double s, double ds, const NearDirection& v) {
  if (!(ds < 1e-2)) return false;
  const double margin = ds * length_ + (v.error + 1e-10) * parts_.size();
  const Point p{from_.x + s * along_.x, from_.y + s * along_.y, from_.z + s * along_.z};
  const auto hides = [&](const Occluder& occluder) {
    const ConvexParts::Face& face = parts_.face(occluder.face);
    const double facing = occluder.side * (face.normal.x * v.x + face.normal.z * v.z);
    if (facing <= facing_margin + v.error) return false;
    const double before =
        occluder.side * (face.normal.x * (p.x - face.on.x) + face.normal.y * (p.y - face.on.y) +
                         face.normal.z * (p.z - face.on.z));
    return before < -margin && parts_.covers(occluder.face, occluder.side, p, v, margin);
  };
  if (last_ < occluders_.size() && hides(occluders_[last_])) return true;
  for (std::size_t i = 0; i < occluders_.size(); ++i) {
    if (hides(occluders_[i])) {
      last_ = i;
      return true;
    }
  }
  return false;
}

bool CandidateFilter::no_contour(EdgeIndex other, const NearDirection& v) const {
  bool left = false;
  bool right = false;
  for (const Incidence& incidence : model_.faces_at(other)) {
    if (model_.faces()[incidence.face].horizontal) continue;
    const ConvexParts::Point& n = parts_.face(incidence.face).normal;
    const double facing = n.x * v.x + n.z * v.z;
    if (std::abs(facing) <= facing_margin + v.error) return false;  // it may be turning at this direction
    if (facing < 0 && !model_.faces()[incidence.face].sheet) continue;
    ((facing > 0) == incidence.with_edge ? left : right) = true;
  }
  return left == right;
}

}  // namespace sightline::algorithms::plantinga
