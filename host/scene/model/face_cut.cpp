// See face_cut.hpp.
#include "host/scene/model/face_cut.hpp"

#include <algorithm>
#include <span>

#include "host/geometry/wide_integer.hpp"

namespace sightline::scene {

using geometry::Int128;
using geometry::Vector3;

CutAxis cut_axis(const Vector3& m, const Vector3& n) {
  CutAxis best;
  Int128 most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Int128 part = Int128{m[(k + 1) % 3]} * n[(k + 2) % 3] - Int128{m[(k + 2) % 3]} * n[(k + 1) % 3];
    const Int128 size = part < 0 ? -part : part;
    if (size <= most) continue;
    most = size;
    best = {k, geometry::sign(part)};
  }
  return best;
}

int compare(const CutPlace& x, const CutPlace& y) {
  // Coordinates are below 2^18, and the quotients' errors below 2^-32.
  constexpr double sure = 0x1p-30;
  if (x.value < y.value - sure) return -1;
  if (x.value > y.value + sure) return 1;
  using Wide = geometry::WideInteger<82>;
  using Narrow = geometry::WideInteger<62>;
  return geometry::sign(Wide(x.numerator) * Narrow(Int128{y.denominator}) - Wide(y.numerator) * Narrow(Int128{x.denominator}));
}

FaceCuts cuts_of(std::span<const PolyPoint> vertices, const PolyFace& face, const geometry::Plane& plane, std::size_t axis,
                 bool zero_is_beyond, bool& zero) {
  std::vector<CutPlace> places;
  const auto beyond = [zero_is_beyond](std::int64_t at) { return zero_is_beyond ? at >= 0 : at > 0; };
  const auto add_ring = [&](std::span<const VertexIndex> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // The lower vertex first, so that both faces at a side compute the same point.
      const auto [p, q] = std::minmax({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
      const std::int64_t a = plane.at(vertices[p]);
      const std::int64_t b = plane.at(vertices[q]);
      zero = zero || a == 0 || b == 0;
      if (beyond(a) == beyond(b)) continue;
      CutPlace place{{p, q, a, b}};
      place.numerator = Int128{vertices[q][axis]} * a - Int128{vertices[p][axis]} * b;
      place.denominator = a - b;
      if (place.denominator < 0) {
        place.numerator = -place.numerator;
        place.denominator = -place.denominator;
      }
      place.value = static_cast<double>(place.numerator) / static_cast<double>(place.denominator);
      places.push_back(place);
    }
  };
  add_ring(face.outline);
  for (const auto& hole : face.holes) add_ring(hole);
  std::sort(places.begin(), places.end(), [](const CutPlace& x, const CutPlace& y) { return compare(x, y) < 0; });
  FaceCuts result;
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    if (compare(places[i], places[i + 1]) < 0) result.emplace_back(places[i], places[i + 1]);
  return result;
}

FaceCuts common(const FaceCuts& a, const FaceCuts& b) {
  FaceCuts result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const CutPlace& low = compare(a[i].first, b[j].first) < 0 ? b[j].first : a[i].first;
    const bool a_ends = compare(a[i].second, b[j].second) <= 0;
    const CutPlace& high = a_ends ? a[i].second : b[j].second;
    if (compare(low, high) < 0) result.emplace_back(low, high);
    ++(a_ends ? i : j);
  }
  return result;
}

PolyPoint rounded(std::span<const PolyPoint> vertices, const CutPoint& cut) {
  PolyPoint point{};
  for (std::size_t k = 0; k < 3; ++k) {
    Int128 numerator = Int128{vertices[cut.q][k]} * cut.a - Int128{vertices[cut.p][k]} * cut.b;
    Int128 denominator = Int128{cut.a} - cut.b;
    if (denominator < 0) {
      numerator = -numerator;
      denominator = -denominator;
    }
    const Int128 doubled = 2 * numerator + denominator;
    Int128 whole = doubled / (2 * denominator);
    if (doubled < 0 && whole * 2 * denominator != doubled) --whole;
    point[k] = static_cast<std::int32_t>(whole);
  }
  return point;
}

std::array<double, 3> real(std::span<const PolyPoint> vertices, const CutPoint& cut) {
  std::array<double, 3> point{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Int128 numerator = Int128{vertices[cut.q][k]} * cut.a - Int128{vertices[cut.p][k]} * cut.b;
    point[k] = static_cast<double>(numerator) / static_cast<double>(cut.a - cut.b);
  }
  return point;
}

void add_crossing(PolyScene& scene, std::uint32_t face_a, std::uint32_t face_b, std::uint32_t plane,
                  const std::array<CutPoint, 2>& ends) {
  const auto first = static_cast<VertexIndex>(scene.vertices.size());
  for (const CutPoint& end : ends) {
    const PolyPoint at = rounded(scene.vertices, end);
    scene.vertices.push_back(at);
  }
  scene.crossings.push_back({first, first + 1, face_a, face_b, plane, ends});
}

std::array<double, 3> place_of(const PolyScene& scene, VertexIndex vertex) {
  if (const PolyCrossing* const crossing = crossing_at(scene, vertex))
    return real(scene.vertices, crossing->ends[vertex - crossing->from]);
  const PolyPoint& p = scene.vertices[vertex];
  return {double(p[0]), double(p[1]), double(p[2])};
}

geometry::Plane plane_of(std::span<const PolyPoint> vertices, const PolyFace& face) {
  const auto& ring = face.outline;
  // Overflow of partial sums is harmless, the total fits.
  std::array<std::uint64_t, 3> sum{};
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vector3 part = geometry::normal_of(vertices[ring[0]], vertices[ring[i - 1]], vertices[ring[i]]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += static_cast<std::uint64_t>(part[k]);
  }
  geometry::Plane plane;
  for (std::size_t k = 0; k < 3; ++k) plane.normal[k] = static_cast<std::int64_t>(sum[k]);
  plane.offset = geometry::dot(plane.normal, geometry::vector_of(vertices[ring[0]]));
  return plane;
}

}  // namespace sightline::scene
