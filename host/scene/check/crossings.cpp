// See crossings.hpp.
#include "host/scene/check/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "host/base/threads.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/apart_bodies.hpp"
#include "host/scene/check/face_cells.hpp"
#include "host/scene/check/layer_finder.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::scene {
namespace {

constexpr Triangle no_triangle{~VertexIndex{0}, ~VertexIndex{0}, ~VertexIndex{0}};  // a face with other corners

bool is_triangle(const Triangle& corners) { return corners[0] != no_triangle[0]; }

// Faces in their order, counted over all bodies.
struct Faces {
  std::vector<const PolyFace*> faces;
  std::vector<std::uint32_t> numbers;
  std::vector<FaceBox> boxes;
  std::vector<Triangle> corners;

  // With `jobs` threads.
  Faces(const PolyScene& scene, unsigned jobs) {
    const std::size_t count = face_count(scene);
    faces.reserve(count);
    for (const PolyBody& body : scene.bodies)
      for (const PolyFace& face : body.faces) faces.push_back(&face);
    numbers.resize(count);
    boxes.resize(count);
    corners.resize(count, no_triangle);
    base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        const Ring& ring = faces[f]->outline;
        numbers[f] = static_cast<std::uint32_t>(f);
        boxes[f] = FaceBox(scene.vertices, ring);
        if (ring.size() == 3 && faces[f]->holes.empty()) std::copy(ring.begin(), ring.end(), corners[f].begin());
      }
    });
  }

  void keep(const std::vector<std::uint8_t>& kept) {
    std::size_t to = 0;
    for (std::size_t f = 0; f < kept.size(); ++f) {
      if (kept[f] == 0) continue;
      faces[to] = faces[f];
      numbers[to] = numbers[f];
      boxes[to] = boxes[f];
      corners[to] = corners[f];
      ++to;
    }
    faces.resize(to);
    numbers.resize(to);
    boxes.resize(to);
    corners.resize(to);
  }
};

// Drops faces that cross no other one because in each cell that they are in all faces are one layer. The cells are `times` as wide as a usual
// face.
void drop_layers(const PolyScene& scene, double times, unsigned jobs, Faces& faces) {
  const FaceCells cells(faces.boxes, times, jobs);
  if (!cells.large().empty()) return;
  const auto make_visit = [&] {
    return [&, finder = LayerFinder(scene.vertices), here = std::vector<Triangle>()](std::span<const FaceCells::Entry> cell,
                                                                                    std::vector<std::uint32_t>& others) mutable {
      here.clear();
      for (const FaceCells::Entry entry : cell) here.push_back(faces.corners[entry.face()]);
      const bool triangles = std::all_of(here.begin(), here.end(), is_triangle);
      if (cell.size() == 1 || (triangles && finder.is_layer(here))) return;
      for (const FaceCells::Entry entry : cell) others.push_back(entry.face());
    };
  };
  std::vector<std::uint8_t> kept(faces.boxes.size());
  for (const std::uint32_t f : cells.visit<std::uint32_t>(std::numeric_limits<std::size_t>::max(), make_visit)) kept[f] = 1;
  faces.keep(kept);
}

struct CrossingFace {
  const PolyFace* face = nullptr;
  std::uint32_t number = 0;
  geometry::Plane plane;

  [[nodiscard]] const Ring& ring() const { return face->outline; }
};

class CrossingSearch {
 public:
  // With `jobs` threads.
  CrossingSearch(const PolyScene& scene, Faces faces, unsigned jobs)
      : scene_(scene), jobs_(jobs), boxes_(std::move(faces.boxes)), corners_(std::move(faces.corners)) {
    faces_.resize(boxes_.size());
    base::for_parts(jobs, faces_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        faces_[f] = {faces.faces[f], faces.numbers[f], plane_of(scene.vertices, *faces.faces[f])};
    });
  }

  std::vector<Crossing> run(std::size_t most) {
    std::vector<Crossing> found = find(most);
    found.resize(std::min(found.size(), most));
    // Those of one pair are found in their order.
    std::stable_sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) {
      return std::tie(x.face_a, x.face_b) < std::tie(y.face_a, y.face_b);
    });
    return found;
  }

 private:
  // In the order of cells and faces. If there are more than `most`, some behind these may be missing.
  [[nodiscard]] std::vector<Crossing> find(std::size_t most) const {
    const FaceCells cells(boxes_, 1.5, jobs_);
    std::vector<Crossing> found = cells.visit<Crossing>(most, [this, most] {
      return [this, most, here = std::vector<FaceBox>()](std::span<const FaceCells::Entry> cell, std::vector<Crossing>& crossings) mutable {
        here.clear();
        for (const FaceCells::Entry entry : cell) here.push_back(boxes_[entry.face()]);
        for (std::size_t i = 0; i < here.size(); ++i)
          for (std::size_t j = i + 1; j < here.size() && crossings.size() < most; ++j)
            if (cell[i].first_of_both(cell[j]) && here[i].meets(here[j])) try_pair(cell[i].face(), cell[j].face(), crossings);
      };
    });
    const std::vector<std::uint32_t>& large = cells.large();
    for (std::size_t l = 0; l < large.size(); ++l) {
      for (std::uint32_t f = 0; f < faces_.size() && found.size() < most; ++f) {
        const bool later = std::binary_search(large.begin(), large.end(), f);
        if ((later ? f > large[l] : true) && boxes_[large[l]].meets(boxes_[f])) try_pair(large[l], f, found);
      }
    }
    return found;
  }

  // --- two faces

  // Whether the outline has corners strictly on both sides.
  [[nodiscard]] bool straddles(std::uint32_t number, const geometry::Plane& plane) const {
    const CrossingFace& face = faces_[number];
    if (is_triangle(corners_[number])) {
      const auto at = [&](std::size_t i) { return plane.at(scene_.vertices[corners_[number][i]]); };
      const std::array<std::int64_t, 3> ends{at(0), at(1), at(2)};
      return std::min({ends[0], ends[1], ends[2]}) < 0 && std::max({ends[0], ends[1], ends[2]}) > 0;
    }
    bool before = false;
    bool beyond = false;
    for (const VertexIndex v : face.ring()) {
      const std::int64_t at = plane.at(scene_.vertices[v]);
      before = before || at < 0;
      beyond = beyond || at > 0;
      if (before && beyond) return true;
    }
    return false;
  }

  [[nodiscard]] FaceCuts inside_on_both_sides(const CrossingFace& face, const geometry::Plane& plane, std::size_t axis) const {
    bool zero = false;
    FaceCuts result = cuts_of(scene_.vertices, *face.face, plane, axis, false, zero);
    if (zero) result = common(result, cuts_of(scene_.vertices, *face.face, plane, axis, true, zero));
    return result;
  }

  void try_pair(std::uint32_t one, std::uint32_t other, std::vector<Crossing>& found) const {
    const auto [a, b] = std::minmax(one, other);
    const CrossingFace& face_a = faces_[a];
    const CrossingFace& face_b = faces_[b];
    const SharedCorners shared = shared_corners(corners_[a], corners_[b]);
    if (shared.count > 1) return;  // two corners of each are in the plane of the other
    if (!scene_.surface_of.empty() && scene_.surface_of[face_a.number] == scene_.surface_of[face_b.number]) return;
    if (!straddles(b, face_a.plane) || !straddles(a, face_b.plane)) return;
    const CutAxis along = cut_axis(face_a.plane.normal, face_b.plane.normal);
    if (along.sign == 0) return;
    if (shared.count == 1 && leaves(face_a, face_b.plane, shared.in_a, along.axis) !=
                                 leaves(face_b, face_a.plane, shared.in_b, along.axis))
      return;
    const FaceCuts cuts = common(inside_on_both_sides(face_a, face_b.plane, along.axis),
                                 inside_on_both_sides(face_b, face_a.plane, along.axis));
    for (const auto& [low, high] : cuts) {
      if (!scene_.surfaces.empty() && is_short(low.point, high.point)) continue;
      Crossing& crossing = found.emplace_back(Crossing{face_a.number, face_b.number, {low.point, high.point}});
      if (along.sign < 0) std::swap(crossing.ends[0], crossing.ends[1]);
    }
  }

  // Most pairs of a mesh are neighbours.
  struct SharedCorners {
    int count = 0;  // of two triangles; otherwise 0
    std::size_t in_a = 0;
    std::size_t in_b = 0;
  };

  [[nodiscard]] static SharedCorners shared_corners(const Triangle& a, const Triangle& b) {
    SharedCorners shared;
    if (!is_triangle(a) || !is_triangle(b)) return shared;
    for (std::size_t i = 0; i < 3; ++i) {
      const int with_first = a[i] == b[0] ? 1 : 0;
      const int with_second = a[i] == b[1] ? 1 : 0;
      const int with_third = a[i] == b[2] ? 1 : 0;
      const int here = with_first + with_second + with_third;
      shared.count += here;
      if (here == 0) continue;
      shared.in_a = i;
      shared.in_b = static_cast<std::size_t>(with_second + 2 * with_third);
    }
    return shared;
  }

  // The line through a corner of a triangle that straddles the plane goes on within it: whether upwards.
  [[nodiscard]] bool leaves(const CrossingFace& face, const geometry::Plane& plane, std::size_t corner, std::size_t axis) const {
    const auto at = [&](std::size_t i) -> const PolyPoint& { return scene_.vertices[face.ring()[(corner + i) % 3]]; };
    const std::int64_t a = plane.at(at(1));
    const std::int64_t b = plane.at(at(2));
    const std::int64_t from = at(0)[axis];
    const geometry::Int128 way = geometry::Int128{at(2)[axis] - from} * a - geometry::Int128{at(1)[axis] - from} * b;
    return (way > 0) == (a > b);
  }

  [[nodiscard]] bool is_short(const CutPoint& from, const CutPoint& to) const {
    const PolyPoint a = rounded(scene_.vertices, from);
    const PolyPoint b = rounded(scene_.vertices, to);
    std::int64_t longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(std::int64_t{a[k]} - b[k]));
    return longest < 2;
  }

  const PolyScene& scene_;
  unsigned jobs_;
  std::vector<CrossingFace> faces_;
  std::vector<FaceBox> boxes_;  // of each
  std::vector<Triangle> corners_;  // of each
};

}  // namespace

PolyScene with_crossings(PolyScene scene, unsigned jobs) {
  const std::vector<Crossing> crossings = crossings_of(scene, std::numeric_limits<std::size_t>::max(), jobs);
  if (crossings.empty()) return scene;
  std::vector<std::uint32_t> body_of;  // of each face
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) body_of.insert(body_of.end(), scene.bodies[b].faces.size(), b);
  for (const Crossing& crossing : crossings) {
    add_crossing(scene, crossing.face_a, crossing.face_b, 0, crossing.ends);
    const std::uint32_t body = body_of[crossing.face_a];
    if (body == body_of[crossing.face_b]) scene.bodies[body].sheet = true;
  }
  return scene;
}

std::vector<Crossing> crossings_of(const PolyScene& scene, std::size_t most, unsigned jobs) {
  if (are_plainly_apart(scene, jobs)) return {};
  Faces faces(scene, jobs);
  // What is left of the wide cells of a smooth surface may be found to be layers in narrow ones.
  for (const double times : {8.0, 3.0}) drop_layers(scene, times, jobs, faces);
  return CrossingSearch(scene, std::move(faces), jobs).run(most);
}

}  // namespace sightline::scene
