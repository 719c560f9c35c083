// See crossings.hpp.
#include "host/scene/check/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "host/base/radix_sort.hpp"
#include "host/base/threads.hpp"
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

  FaceBox() = default;
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
  // With `jobs` threads.
  CrossingSearch(const PolyScene& scene, unsigned jobs) : scene_(scene), jobs_(jobs) {
    const std::size_t count = face_count(scene);
    faces_.reserve(count);
    for (const PolyBody& body : scene.bodies)
      for (const PolyFace& face : body.faces) faces_.push_back({&face, {}});
    boxes_.resize(count);
    corners_.resize(count);
    base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        const PolyFace& face = *faces_[f].face;
        faces_[f].plane = plane_of(scene.vertices, face);
        boxes_[f] = FaceBox(scene.vertices, face.outline);
        corners_[f] = no_triangle;
        if (faces_[f].is_triangle()) std::copy(face.outline.begin(), face.outline.end(), corners_[f].begin());
      }
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

  // A face in a cell as one number: the cell, of which there are at most 2^27, above the face. Above them, whether the face begins in
  // the cell along each axis.
  using Entry = std::uint64_t;
  [[nodiscard]] static std::uint64_t cell_of(Entry entry) { return (entry >> 32) & ((1U << 27) - 1); }
  [[nodiscard]] static std::uint32_t face_of(Entry entry) { return static_cast<std::uint32_t>(entry); }
  [[nodiscard]] static Entry begins(bool it_does, unsigned axis) { return static_cast<Entry>(it_does) << (59 + axis); }
  static constexpr Entry begins_on_all_axes = Entry{7} << 59;

  // Adds the cells of the faces `begin` to `end` - 1. Faces in very many cells are added to `large`.
  void add_entries(const CellGrid& cells, std::size_t begin, std::size_t end, std::vector<Entry>& entries, std::vector<std::uint32_t>& large) const {
    constexpr std::int64_t most_cells = 512;
    entries.reserve(4 * (begin == 0 ? faces_.size() : end - begin));  // the first part gets the entries of all
    for (std::size_t f = begin; f < end; ++f) {
      std::array<std::int64_t, 6> span{};
      std::int64_t covered = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        span[k] = cells.place(FaceBox::coordinate(boxes_[f].low, k), k);
        span[k + 3] = cells.place(FaceBox::coordinate(boxes_[f].high, k), k);
        covered *= span[k + 3] - span[k] + 1;
      }
      if (covered > most_cells) {
        large.push_back(static_cast<std::uint32_t>(f));
        continue;
      }
      for (std::int64_t x = span[0]; x <= span[3]; ++x)
        for (std::int64_t y = span[1]; y <= span[4]; ++y)
          for (std::int64_t z = span[2]; z <= span[5]; ++z)
            entries.push_back(static_cast<Entry>((x * cells.count[1] + y) * cells.count[2] + z) << 32 | f |
                              begins(x == span[0], 0) | begins(y == span[1], 1) | begins(z == span[2], 2));
    }
  }

  // In the order of cells and faces. If there are more than `most`, some behind these may be missing.
  [[nodiscard]] std::vector<Crossing> find(std::size_t most) const {
    const CellGrid cells = grid();
    std::vector<std::vector<Entry>> entries_of(jobs_);  // of each part
    std::vector<std::vector<std::uint32_t>> large_of(jobs_);
    base::for_parts(jobs_, faces_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      add_entries(cells, begin, end, entries_of[part], large_of[part]);
    });
    std::vector<Entry> entries = joined(entries_of);
    base::radix_sort(entries, 32, 32 + 27, [](Entry entry) { return entry; }, jobs_);
    std::vector<std::vector<Crossing>> found_in(jobs_);
    base::for_parts(jobs_, entries.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      try_cells(entries, begin, end, most, found_in[part]);
    });
    std::vector<Crossing> found = joined(found_in);
    const std::vector<std::uint32_t> large = joined(large_of);
    for (std::size_t l = 0; l < large.size(); ++l) {
      for (std::uint32_t f = 0; f < faces_.size() && found.size() < most; ++f) {
        const bool later = std::binary_search(large.begin(), large.end(), f);
        if ((later ? f > large[l] : true) && boxes_[large[l]].meets(boxes_[f])) try_pair(large[l], f, found);
      }
    }
    return found;
  }

  template <class Item>
  static std::vector<Item> joined(std::vector<std::vector<Item>>& parts) {
    std::vector<Item> all = std::move(parts[0]);
    for (std::size_t p = 1; p < parts.size(); ++p) all.insert(all.end(), parts[p].begin(), parts[p].end());
    return all;
  }

  // The cells that begin from `begin` on, before `end`.
  void try_cells(const std::vector<Entry>& entries, std::size_t begin, std::size_t end, std::size_t most, std::vector<Crossing>& found) const {
    std::vector<FaceBox> here;
    std::size_t first = begin;
    while (first > 0 && first < end && cell_of(entries[first]) == cell_of(entries[first - 1])) ++first;
    while (first < end && found.size() < most) {
      std::size_t last = first;
      while (last < entries.size() && cell_of(entries[last]) == cell_of(entries[first])) ++last;
      here.clear();
      for (std::size_t i = first; i < last; ++i) here.push_back(boxes_[face_of(entries[i])]);
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = i + 1; j < here.size() && found.size() < most; ++j) {
          // Once, in the first cell that both are in.
          const Entry both = entries[first + i] | entries[first + j];
          if ((both & begins_on_all_axes) == begins_on_all_axes && here[i].meets(here[j]))
            try_pair(face_of(entries[first + i]), face_of(entries[first + j]), found);
        }
      }
      first = last;
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

  void try_pair(std::uint32_t one, std::uint32_t other, std::vector<Crossing>& found) const {
    const auto [a, b] = std::minmax(one, other);
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
      Crossing& crossing = found.emplace_back(Crossing{a, b, {low.point, high.point}});
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
  return CrossingSearch(scene, jobs).run(most);
}

}  // namespace sightline::scene
