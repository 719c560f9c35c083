// See cell_complex_places.hpp.
//
// A place is a point of fractions with one denominator, so that hardly any lies on a plane of the scene. From
// a free place rays are sent in random directions. Where one leaves its cell is known as a homogeneous point;
// with normals of 40 bits, places of 30 and directions of 8 its side of a plane is a number of 123 bits.
// Whatever cannot be decided because something is met exactly at its border is left out.
#include "host/scene/check/cell_complex_places.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/generate/random.hpp"

namespace sightline::scene {
namespace {

using geometry::Int128;
using geometry::Plane;

constexpr std::int64_t denominator = 1009;  // prime, 10 bits
constexpr int rays_a_place = 4;

// The point numerator / weight, weight positive.
struct HomogeneousPoint {
  std::array<Int128, 3> numerator{};
  Int128 weight = 1;
};

Int128 at(const Plane& plane, const HomogeneousPoint& p) {
  return plane.normal[0] * p.numerator[0] + plane.normal[1] * p.numerator[1] +
         plane.normal[2] * p.numerator[2] - plane.offset * p.weight;
}

// Negative inside the half-space.
Int128 at(const CellComplex& complex, const HalfSpace& half, const HomogeneousPoint& p) {
  const Int128 value = at(complex.planes[half.plane], p);
  return half.turned ? -value : value;
}

enum class Where { inside, border, beyond };

Where where(const CellComplex& complex, std::span<const HalfSpace> halves, const HomogeneousPoint& p) {
  Where result = Where::inside;
  for (const HalfSpace& half : halves) {
    const Int128 value = at(complex, half, p);
    if (value > 0) return Where::beyond;
    if (value == 0) result = Where::border;
  }
  return result;
}

// As seen along `axis`: whether the face covers the point.
Where where(const PolyScene& scene, const PolyFace& face, std::size_t axis, const HomogeneousPoint& p) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  bool inside = false;
  bool border = false;
  const auto cross_ring = [&](std::span<const VertexIndex> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PolyPoint& a = scene.vertices[ring[i]];
      const PolyPoint& b = scene.vertices[ring[i + 1 == ring.size() ? 0 : i + 1]];
      const bool a_above = a[v] * p.weight > p.numerator[v];
      if (a_above == (b[v] * p.weight > p.numerator[v])) continue;
      const Int128 turn = (std::int64_t{b[u]} - a[u]) * (p.numerator[v] - a[v] * p.weight) -
                          (std::int64_t{b[v]} - a[v]) * (p.numerator[u] - a[u] * p.weight);
      border = border || turn == 0;
      if ((turn > 0) == !a_above) inside = !inside;
    }
  };
  cross_ring(face.outline);
  for (const auto& hole : face.holes) cross_ring(hole);
  return border ? Where::border : inside ? Where::inside : Where::beyond;
}

struct ScenePart {
  const PolyFace* face = nullptr;
  Plane plane;
  bool sheet = false;
};

class PlaceChecker {
 public:
  PlaceChecker(const CellComplex& complex, const PolyScene& scene, std::uint64_t seed, Problems& problems);
  void run();

 private:
  HomogeneousPoint random_place();
  geometry::Vector3 random_direction();
  [[nodiscard]] std::optional<bool> in_solid(const HomogeneousPoint& place) const;
  [[nodiscard]] std::optional<std::vector<CellNumber>> cells_of(const HomogeneousPoint& place) const;
  void check_place();
  void check_ray(CellNumber cell, const HomogeneousPoint& place);
  void check_face_point(CellNumber cell, std::uint32_t plane, const HomogeneousPoint& point);
  [[nodiscard]] std::size_t places() const;

  const CellComplex& complex_;
  const PolyScene& scene_;
  SceneRandom random_;
  Problems& problems_;
  std::vector<ScenePart> parts_;
};

std::string place_text(const HomogeneousPoint& p) {
  std::string text = "(";
  for (std::size_t a = 0; a < 3; ++a) {
    text += (a > 0 ? ", " : "") +
            std::to_string(static_cast<double>(p.numerator[a]) / static_cast<double>(p.weight));
  }
  return text + ")";
}

// By the first corner at which the outline turns.
std::optional<Plane> plane_of(const PolyScene& scene, const PolyFace& face) {
  const auto& ring = face.outline;
  geometry::Vector3 normal{};
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const auto part =
        geometry::normal_of(scene.vertices[ring[0]], scene.vertices[ring[i - 1]], scene.vertices[ring[i]]);
    for (std::size_t a = 0; a < 3; ++a) normal[a] += part[a];
  }
  if (geometry::is_zero(normal)) return std::nullopt;
  std::int64_t divisor = 0;
  for (const std::int64_t component : normal) divisor = std::gcd(divisor, component);
  for (std::int64_t& component : normal) component /= divisor;
  return Plane{normal, geometry::dot(normal, geometry::vector_of(scene.vertices[ring[0]]))};
}

bool same_plane(const Plane& a, const Plane& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (Int128{a.normal[i]} * b.offset != Int128{b.normal[i]} * a.offset) return false;
    if (Int128{a.normal[i]} * b.normal[(i + 1) % 3] != Int128{a.normal[(i + 1) % 3]} * b.normal[i])
      return false;
  }
  return true;
}

PlaceChecker::PlaceChecker(const CellComplex& complex, const PolyScene& scene, std::uint64_t seed,
                           Problems& problems)
    : complex_(complex), scene_(scene), random_(seed), problems_(problems) {
  for (const PolyBody& body : scene.bodies)
    for (const PolyFace& face : body.faces)
      if (const auto plane = plane_of(scene, face)) parts_.push_back({&face, *plane, body.sheet});
}

std::size_t PlaceChecker::places() const {
  constexpr std::size_t comparisons = 50'000'000;
  const std::size_t each = 1 + complex_.bounds.size() + 4 * rays_a_place * parts_.size();
  return std::clamp<std::size_t>(comparisons / each, 10, 1000);
}

HomogeneousPoint PlaceChecker::random_place() {
  HomogeneousPoint place;
  place.weight = denominator;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t span = complex_.outer.span(a).length() * denominator;
    place.numerator[a] =
        complex_.outer.low[a] * denominator + 1 + random_.mod(static_cast<std::uint64_t>(span - 1));
  }
  return place;
}

geometry::Vector3 PlaceChecker::random_direction() {
  geometry::Vector3 direction{};
  while (geometry::is_zero(direction))
    for (std::int64_t& component : direction) component = random_.mod(255) - 127;
  return direction;
}

// More faces are left than entered along +x.
std::optional<bool> PlaceChecker::in_solid(const HomogeneousPoint& place) const {
  int left = 0;
  for (const ScenePart& part : parts_) {
    const int along = geometry::sign(part.plane.normal[0]);
    if (part.sheet || along == 0) continue;
    const int side = geometry::sign(at(part.plane, place));
    if (side == 0) return std::nullopt;
    if (side == along) continue;
    const Where hit = where(scene_, *part.face, 0, place);
    if (hit == Where::border) return std::nullopt;
    if (hit == Where::inside) left += along;
  }
  return left > 0;
}

std::optional<std::vector<CellNumber>> PlaceChecker::cells_of(const HomogeneousPoint& place) const {
  std::vector<CellNumber> cells;
  for (CellNumber c = 0; c < complex_.cells.size(); ++c) {
    const Where position = where(complex_, complex_.bounds_of(complex_.cells[c]), place);
    if (position == Where::border) return std::nullopt;
    if (position == Where::inside) cells.push_back(c);
  }
  return cells;
}

void PlaceChecker::check_place() {
  const HomogeneousPoint place = random_place();
  const auto cells = cells_of(place);
  const auto solid = in_solid(place);
  if (!cells || !solid) return;
  if (*solid && !cells->empty())
    problems_.add("cell", cells->front(), "has " + place_text(place) + " of a solid in it");
  if (*solid) return;
  if (cells->empty()) problems_.add("cells", "none has the free point " + place_text(place) + " in it");
  if (cells->size() > 1) {
    problems_.add("cell", (*cells)[1],
                  "has " + place_text(place) + " in it, as has cell " + std::to_string(cells->front()));
  }
  if (cells->size() != 1) return;
  for (int ray = 0; ray < rays_a_place; ++ray) check_ray(cells->front(), place);
}

void PlaceChecker::check_ray(CellNumber cell, const HomogeneousPoint& place) {
  const geometry::Vector3 direction = random_direction();
  // Where the ray meets a bound: place + t direction, t = distance / (denominator speed).
  std::optional<std::uint32_t> exit;
  bool tie = false;
  Int128 exit_distance = 0;
  Int128 exit_speed = 1;
  for (const HalfSpace& half : complex_.bounds_of(complex_.cells[cell])) {
    const Plane& plane = complex_.planes[half.plane];
    const Int128 speed = geometry::wide_dot(plane.normal, direction) * (half.turned ? -1 : 1);
    if (speed <= 0) continue;
    const Int128 distance = -at(complex_, half, place);
    const Int128 order = exit ? distance * exit_speed - exit_distance * speed : Int128{-1};
    if (order > 0) continue;
    tie = order == 0 && half.plane != *exit;
    exit = half.plane;
    exit_distance = distance;
    exit_speed = speed;
  }
  if (!exit) {
    problems_.add("cell", cell, "has no end");
    return;
  }
  if (tie) return;
  HomogeneousPoint point;
  point.weight = denominator * exit_speed;
  for (std::size_t a = 0; a < 3; ++a)
    point.numerator[a] = place.numerator[a] * exit_speed + direction[a] * exit_distance;
  check_face_point(cell, *exit, point);
}

void PlaceChecker::check_face_point(CellNumber cell, std::uint32_t plane, const HomogeneousPoint& point) {
  std::vector<std::uint32_t> openings;
  for (const std::uint32_t o : complex_.openings_of(complex_.cells[cell])) {
    const ComplexOpening& opening = complex_.openings[o];
    if (opening.plane != plane) continue;
    const Where position = where(complex_, complex_.sides_of(opening), point);
    if (position == Where::border) return;
    if (position == Where::inside) openings.push_back(o);
  }
  bool opaque = false;
  const std::size_t axis = geometry::dominant_axis(complex_.planes[plane].normal);
  for (const ScenePart& part : parts_) {
    if (!same_plane(part.plane, complex_.planes[plane])) continue;
    const Where position = where(scene_, *part.face, axis, point);
    if (position == Where::border) return;
    opaque = opaque || position == Where::inside;
  }
  if (openings.size() > 1) {
    problems_.add("opening", openings[1],
                  "has " + place_text(point) + " in it, as has opening " + std::to_string(openings[0]));
  } else if (!openings.empty() && opaque) {
    problems_.add("opening", openings[0], "has " + place_text(point) + " of a face of the scene in it");
  } else if (openings.empty() && !opaque) {
    problems_.add(
        "cell", cell,
        "ends at " + place_text(point) + " where there is neither an opening nor a face of the scene");
  }
}

void PlaceChecker::run() {
  const std::size_t count = places();
  for (std::size_t i = 0; i < count && !problems_.full(); ++i) check_place();
}

}  // namespace

void check_complex_places(const CellComplex& complex, const PolyScene& scene, std::uint64_t seed,
                          Problems& problems) {
  if (complex.outer.empty()) return;
  PlaceChecker(complex, scene, seed, problems).run();
}

}  // namespace sightline::scene
