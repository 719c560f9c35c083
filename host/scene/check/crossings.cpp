// See crossings.hpp.
#include "host/scene/check/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/apart_bodies.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::scene {
namespace {

struct CrossingFace {
  const PolyFace* face = nullptr;
  geometry::Plane plane;

  [[nodiscard]] const Ring& ring() const { return face->outline; }
  [[nodiscard]] bool is_triangle() const { return ring().size() == 3 && face->holes.empty(); }
};

// Around a face: each end is three numbers of 19 bits with a guard above each, so that one subtraction compares all three.
struct FaceBox {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  static constexpr unsigned step = 20;
  static constexpr std::uint64_t guards = std::uint64_t{1} << 19 | std::uint64_t{1} << 39 | std::uint64_t{1} << 59;

  FaceBox(const std::vector<PolyPoint>& vertices, const Ring& ring) {
    PolyPoint least = vertices[ring[0]];
    PolyPoint most = least;
    for (const VertexIndex v : ring) {
      for (std::size_t k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], vertices[v][k]);
        most[k] = std::max(most[k], vertices[v][k]);
      }
    }
    low = packed(least);
    high = packed(most);
  }

  [[nodiscard]] bool meets(const FaceBox& other) const {
    return (((high | guards) - other.low) & ((other.high | guards) - low) & guards) == guards;
  }
  [[nodiscard]] static std::int32_t coordinate(std::uint64_t end, std::size_t axis) {
    return static_cast<std::int32_t>(end >> (step * axis) & ((1U << 19) - 1)) - poly_coordinate_limit;
  }

 private:
  [[nodiscard]] static std::uint64_t packed(const PolyPoint& p) {
    std::uint64_t number = 0;
    for (std::size_t k = 3; k-- > 0;) number = number << step | static_cast<std::uint64_t>(p[k] + poly_coordinate_limit);
    return number;
  }
};

using Triangle = std::array<VertexIndex, 3>;
constexpr Triangle no_triangle{~VertexIndex{0}, ~VertexIndex{0}, ~VertexIndex{0}};  // a face with other corners

bool is_triangle(const Triangle& corners) { return corners[0] != no_triangle[0]; }

class CrossingSearch {
 public:
  explicit CrossingSearch(const PolyScene& scene) : scene_(scene) {
    const std::size_t count = face_count(scene);
    faces_.reserve(count);
    boxes_.reserve(count);
    corners_.reserve(count);
    for (const PolyBody& body : scene.bodies) {
      for (const PolyFace& face : body.faces) {
        faces_.push_back({&face, plane_of(scene.vertices, face)});
        boxes_.emplace_back(scene.vertices, face.outline);
        corners_.push_back(no_triangle);
        if (faces_.back().is_triangle()) std::copy(face.outline.begin(), face.outline.end(), corners_.back().begin());
      }
    }
  }

  std::vector<Crossing> run(std::size_t most) {
    most_ = most;
    for_near_pairs([&](std::uint32_t a, std::uint32_t b) { try_pair(std::min(a, b), std::max(a, b)); });
    // Those of one pair are found in their order.
    std::stable_sort(found_.begin(), found_.end(), [](const Crossing& x, const Crossing& y) {
      return std::tie(x.face_a, x.face_b) < std::tie(y.face_a, y.face_b);
    });
    return std::move(found_);
  }

 private:
  // --- faces whose boxes meet: looked up in cells of about the size of a usual face

  struct CellGrid {
    PolyPoint low{};
    std::array<std::int64_t, 3> size{1, 1, 1};
    std::array<std::int64_t, 3> count{1, 1, 1};

    [[nodiscard]] std::int64_t place(std::int32_t c, std::size_t axis) const { return (std::int64_t{c} - low[axis]) / size[axis]; }
  };

  [[nodiscard]] CellGrid grid() const {
    CellGrid grid;
    PolyPoint high{};
    std::array<double, 3> sum{};
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t least = FaceBox::coordinate(boxes_[f].low, k);
        const std::int32_t most = FaceBox::coordinate(boxes_[f].high, k);
        grid.low[k] = f == 0 ? least : std::min(grid.low[k], least);
        high[k] = f == 0 ? most : std::max(high[k], most);
        sum[k] += most - least + 1;
      }
    }
    constexpr std::int64_t most_a_side = 512;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t extent = std::int64_t{high[k]} - grid.low[k] + 1;
      const auto usual = static_cast<std::int64_t>(1.5 * sum[k] / static_cast<double>(std::max<std::size_t>(faces_.size(), 1))) + 1;
      grid.size[k] = std::max(usual, extent / most_a_side + 1);
      grid.count[k] = extent / grid.size[k] + 1;
    }
    return grid;
  }

  template <class Visit>
  void for_near_pairs(Visit visit) {
    const CellGrid cells = grid();
    // Cell and face in one number: there are at most 2^27 cells. Above them, whether the face begins in the cell along each axis.
    std::vector<std::uint64_t> entries;
    entries.reserve(4 * faces_.size());
    const auto cell_of = [](std::uint64_t entry) { return (entry >> 32) & ((1U << 27) - 1); };
    const auto begins = [](bool it_does, unsigned axis) { return static_cast<std::uint64_t>(it_does) << (59 + axis); };
    constexpr std::uint64_t on_all_axes = std::uint64_t{7} << 59;
    const auto face_of = [](std::uint64_t entry) { return static_cast<std::uint32_t>(entry); };
    std::vector<std::uint32_t> large;
    constexpr std::int64_t most_cells = 512;  // of one face
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      std::array<std::int64_t, 6> span{};
      std::int64_t covered = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        span[k] = cells.place(FaceBox::coordinate(boxes_[f].low, k), k);
        span[k + 3] = cells.place(FaceBox::coordinate(boxes_[f].high, k), k);
        covered *= span[k + 3] - span[k] + 1;
      }
      if (covered > most_cells) {
        large.push_back(f);
        continue;
      }
      for (std::int64_t x = span[0]; x <= span[3]; ++x)
        for (std::int64_t y = span[1]; y <= span[4]; ++y)
          for (std::int64_t z = span[2]; z <= span[5]; ++z)
            entries.push_back(static_cast<std::uint64_t>((x * cells.count[1] + y) * cells.count[2] + z) << 32 | f |
                              begins(x == span[0], 0) | begins(y == span[1], 1) | begins(z == span[2], 2));
    }
    sort_by_cell(entries);
    std::vector<FaceBox> here;
    for (std::size_t first = 0; first < entries.size() && found_.size() < most_;) {
      std::size_t last = first;
      while (last < entries.size() && cell_of(entries[last]) == cell_of(entries[first])) ++last;
      here.clear();
      for (std::size_t i = first; i < last; ++i) here.push_back(boxes_[face_of(entries[i])]);
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = i + 1; j < here.size(); ++j) {
          // Once, in the first cell that both are in.
          const std::uint64_t both = entries[first + i] | entries[first + j];
          if ((both & on_all_axes) == on_all_axes && here[i].meets(here[j]))
            visit(face_of(entries[first + i]), face_of(entries[first + j]));
        }
      }
      first = last;
    }
    for (std::size_t l = 0; l < large.size(); ++l) {
      for (std::uint32_t f = 0; f < faces_.size() && found_.size() < most_; ++f) {
        const bool later = std::binary_search(large.begin(), large.end(), f);
        if ((later ? f > large[l] : true) && boxes_[large[l]].meets(boxes_[f])) visit(large[l], f);
      }
    }
  }

  // Of fewer than 2^27 cells, nine bits after nine; within one the faces ascend as they did.
  static void sort_by_cell(std::vector<std::uint64_t>& entries) {
    constexpr unsigned digit = 9;
    std::vector<std::uint64_t> sorted(entries.size());
    for (unsigned shift = 32; shift < 32 + 3 * digit; shift += digit) {
      std::array<std::size_t, (1U << digit) + 1> starts{};
      const auto digit_of = [shift](std::uint64_t entry) { return static_cast<std::size_t>(entry >> shift & ((1U << digit) - 1)); };
      for (const std::uint64_t entry : entries) ++starts[digit_of(entry) + 1];
      for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
      for (const std::uint64_t entry : entries) sorted[starts[digit_of(entry)]++] = entry;
      entries.swap(sorted);
    }
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

  void try_pair(std::uint32_t a, std::uint32_t b) {
    if (found_.size() >= most_) return;
    const CrossingFace& face_a = faces_[a];
    const CrossingFace& face_b = faces_[b];
    const SharedCorners shared = shared_corners(corners_[a], corners_[b]);
    if (shared.count > 1) return;  // two corners of each are in the plane of the other
    if (!scene_.surface_of.empty() && scene_.surface_of[a] == scene_.surface_of[b]) return;
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
      Crossing& crossing = found_.emplace_back(Crossing{a, b, {low.point, high.point}});
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
  std::vector<CrossingFace> faces_;
  std::vector<FaceBox> boxes_;  // of each
  std::vector<Triangle> corners_;  // of each
  std::vector<Crossing> found_;
  std::size_t most_ = 0;
};

}  // namespace

PolyScene with_crossings(PolyScene scene) {
  const std::vector<Crossing> crossings = crossings_of(scene);
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

std::vector<Crossing> crossings_of(const PolyScene& scene, std::size_t most) {
  if (are_plainly_apart(scene)) return {};
  return CrossingSearch(scene).run(most);
}

}  // namespace sightline::scene
