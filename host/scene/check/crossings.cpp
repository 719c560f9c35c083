// See crossings.hpp.
#include "host/scene/check/crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/geometry/wide_integer.hpp"
#include "host/scene/check/apart_bodies.hpp"
#include "host/scene/model/finer_grid.hpp"

namespace sightline::scene {
namespace {

using geometry::Int128;
using geometry::Vector3;

struct CrossingFace {
  const PolyFace* face = nullptr;
  Vector3 normal{};
  PolyPoint on{};
  PolyPoint low{};
  PolyPoint high{};

  [[nodiscard]] std::int64_t at(const PolyPoint& p) const { return geometry::dot(normal, geometry::difference(p, on)); }
};

// Where an edge meets a plane: one coordinate of that point, as a fraction with a denominator above 0.
struct LinePlace {
  Int128 numerator = 0;
  std::int64_t denominator = 1;
  double value = 0;
  // The edge, and how far its ends are from the plane.
  VertexIndex p = 0;
  VertexIndex q = 0;
  std::int64_t a = 0;
  std::int64_t b = 0;
};

int compare(const LinePlace& x, const LinePlace& y) {
  // Coordinates are below 2^18, and the quotients wrong by less than 2^-32.
  constexpr double sure = 0x1p-30;
  if (x.value < y.value - sure) return -1;
  if (x.value > y.value + sure) return 1;
  using Wide = geometry::WideInteger<82>;
  using Narrow = geometry::WideInteger<62>;
  return geometry::sign(Wide(x.numerator) * Narrow(Int128{y.denominator}) - Wide(y.numerator) * Narrow(Int128{x.denominator}));
}

using Intervals = std::vector<std::pair<LinePlace, LinePlace>>;

// What two ascending lists have in common.
Intervals common(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const LinePlace& low = compare(a[i].first, b[j].first) < 0 ? b[j].first : a[i].first;
    const bool a_ends = compare(a[i].second, b[j].second) <= 0;
    const LinePlace& high = a_ends ? a[i].second : b[j].second;
    if (compare(low, high) < 0) result.emplace_back(low, high);
    ++(a_ends ? i : j);
  }
  return result;
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const PolyScene& scene) : scene_(scene) {
    for (const PolyBody& body : scene.bodies)
      for (const PolyFace& face : body.faces) faces_.push_back(measured(face));
  }

  std::vector<Crossing> run(std::size_t most) {
    most_ = most;
    for_near_pairs([&](std::uint32_t a, std::uint32_t b) { try_pair(std::min(a, b), std::max(a, b)); });
    std::sort(found_.begin(), found_.end(), [](const Crossing& x, const Crossing& y) {
      return std::tie(x.face_a, x.face_b, x.from, x.to) < std::tie(y.face_a, y.face_b, y.from, y.to);
    });
    return std::move(found_);
  }

 private:
  [[nodiscard]] CrossingFace measured(const PolyFace& face) const {
    CrossingFace result{&face, {}, scene_.vertices[face.outline[0]], scene_.vertices[face.outline[0]], scene_.vertices[face.outline[0]]};
    // The normal of three corners that are not on a line, as all are in one plane.
    const auto& ring = face.outline;
    for (std::size_t i = 0; i < ring.size() && geometry::is_zero(result.normal); ++i) {
      result.on = scene_.vertices[ring[i]];
      result.normal = geometry::normal_of(scene_.vertices[ring[i]], scene_.vertices[ring[(i + 1) % ring.size()]],
                                          scene_.vertices[ring[(i + 2) % ring.size()]]);
    }
    for (const VertexIndex v : ring) {
      for (std::size_t k = 0; k < 3; ++k) {
        result.low[k] = std::min(result.low[k], scene_.vertices[v][k]);
        result.high[k] = std::max(result.high[k], scene_.vertices[v][k]);
      }
    }
    return result;
  }

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
        grid.low[k] = f == 0 ? faces_[f].low[k] : std::min(grid.low[k], faces_[f].low[k]);
        high[k] = f == 0 ? faces_[f].high[k] : std::max(high[k], faces_[f].high[k]);
        sum[k] += faces_[f].high[k] - faces_[f].low[k] + 1;
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
    // Cell and face in one number: there are at most 2^27 cells.
    std::vector<std::uint64_t> entries;
    const auto cell_of = [](std::uint64_t entry) { return static_cast<std::int64_t>(entry >> 32); };
    const auto face_of = [](std::uint64_t entry) { return static_cast<std::uint32_t>(entry); };
    std::vector<std::uint32_t> large;
    constexpr std::int64_t most_cells = 512;  // of one face
    std::vector<std::array<std::uint16_t, 6>> spans(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      auto& span = spans[f];
      std::int64_t covered = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        span[k] = static_cast<std::uint16_t>(cells.place(faces_[f].low[k], k));
        span[k + 3] = static_cast<std::uint16_t>(cells.place(faces_[f].high[k], k));
        covered *= span[k + 3] - span[k] + 1;
      }
      if (covered > most_cells) {
        large.push_back(f);
        continue;
      }
      for (std::int64_t x = span[0]; x <= span[3]; ++x)
        for (std::int64_t y = span[1]; y <= span[4]; ++y)
          for (std::int64_t z = span[2]; z <= span[5]; ++z)
            entries.push_back(static_cast<std::uint64_t>((x * cells.count[1] + y) * cells.count[2] + z) << 32 | f);
    }
    std::sort(entries.begin(), entries.end());
    for (std::size_t first = 0; first < entries.size() && found_.size() < most_;) {
      std::size_t last = first;
      while (last < entries.size() && cell_of(entries[last]) == cell_of(entries[first])) ++last;
      for (std::size_t i = first; i < last; ++i) {
        for (std::size_t j = i + 1; j < last; ++j) {
          const std::uint32_t a = face_of(entries[i]);
          const std::uint32_t b = face_of(entries[j]);
          // Once, in the first cell that both are in.
          std::int64_t cell = 0;
          for (std::size_t k = 0; k < 3; ++k) cell = cell * cells.count[k] + std::int64_t{std::max(spans[a][k], spans[b][k])};
          if (cell == cell_of(entries[first]) && boxes_meet(a, b)) visit(a, b);
        }
      }
      first = last;
    }
    for (std::size_t l = 0; l < large.size(); ++l) {
      for (std::uint32_t f = 0; f < faces_.size() && found_.size() < most_; ++f) {
        const bool later = std::binary_search(large.begin(), large.end(), f);
        if ((later ? f > large[l] : true) && boxes_meet(large[l], f)) visit(large[l], f);
      }
    }
  }

  [[nodiscard]] bool boxes_meet(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (faces_[a].low[k] > faces_[b].high[k] || faces_[b].low[k] > faces_[a].high[k]) return false;
    return true;
  }

  // --- two faces

  // Whether the outline has corners strictly on both sides.
  [[nodiscard]] bool straddles(const CrossingFace& face, const CrossingFace& plane) const {
    bool before = false;
    bool beyond = false;
    for (const VertexIndex v : face.face->outline) {
      const std::int64_t at = plane.at(scene_.vertices[v]);
      before = before || at < 0;
      beyond = beyond || at > 0;
      if (before && beyond) return true;
    }
    return false;
  }

  // What of the plane is in the face if corners in the plane count as beyond it, or as before it: pieces of their line.
  [[nodiscard]] Intervals inside(const CrossingFace& face, const CrossingFace& plane, std::size_t axis, bool zero_is_beyond,
                                 bool& zero) const {
    std::vector<LinePlace> places;
    const auto add_ring = [&](const std::vector<VertexIndex>& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const VertexIndex p = ring[i];
        const VertexIndex q = ring[i + 1 == ring.size() ? 0 : i + 1];
        const std::int64_t a = plane.at(scene_.vertices[p]);
        const std::int64_t b = plane.at(scene_.vertices[q]);
        zero = zero || a == 0;
        const auto beyond = [zero_is_beyond](std::int64_t at) { return zero_is_beyond ? at >= 0 : at > 0; };
        if (beyond(a) == beyond(b)) continue;
        LinePlace place;
        place.p = p;
        place.q = q;
        place.a = a;
        place.b = b;
        const std::int64_t from = scene_.vertices[p][axis];
        const std::int64_t to = scene_.vertices[q][axis];
        // p + (q - p) a / (a - b)
        place.numerator = Int128{to} * a - Int128{from} * b;
        place.denominator = a - b;
        if (place.denominator < 0) {
          place.numerator = -place.numerator;
          place.denominator = -place.denominator;
        }
        place.value = static_cast<double>(place.numerator) / static_cast<double>(place.denominator);
        places.push_back(place);
      }
    };
    add_ring(face.face->outline);
    for (const auto& hole : face.face->holes) add_ring(hole);
    std::sort(places.begin(), places.end(), [](const LinePlace& x, const LinePlace& y) { return compare(x, y) < 0; });
    Intervals result;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
      if (compare(places[i], places[i + 1]) < 0) result.emplace_back(places[i], places[i + 1]);
    return result;
  }

  [[nodiscard]] Intervals inside_on_both_sides(const CrossingFace& face, const CrossingFace& plane, std::size_t axis) const {
    bool zero = false;
    Intervals result = inside(face, plane, axis, false, zero);
    if (zero) result = common(result, inside(face, plane, axis, true, zero));
    return result;
  }

  void try_pair(std::uint32_t a, std::uint32_t b) {
    if (found_.size() >= most_) return;
    const CrossingFace& face_a = faces_[a];
    const CrossingFace& face_b = faces_[b];
    if (!scene_.surface_of.empty() && scene_.surface_of[a] == scene_.surface_of[b]) return;
    if (!straddles(face_b, face_a) || !straddles(face_a, face_b)) return;
    const std::size_t axis = axis_along(face_a.normal, face_b.normal);
    if (axis == 3) return;
    for (const auto& [low, high] : common(inside_on_both_sides(face_a, face_b, axis), inside_on_both_sides(face_b, face_a, axis))) {
      const Crossing crossing{a, b, rounded(low), rounded(high)};
      std::int64_t longest = 0;
      for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest, std::abs(std::int64_t{crossing.from[k]} - crossing.to[k]));
      if (longest >= 2) found_.push_back(crossing);
    }
  }

  // The axis along which the line of two planes is longest; 3 if they are parallel.
  [[nodiscard]] static std::size_t axis_along(const Vector3& m, const Vector3& n) {
    std::size_t best = 3;
    Int128 most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Int128 part = Int128{m[(k + 1) % 3]} * n[(k + 2) % 3] - Int128{m[(k + 2) % 3]} * n[(k + 1) % 3];
      const Int128 size = part < 0 ? -part : part;
      if (size <= most) continue;
      most = size;
      best = k;
    }
    return best;
  }

  [[nodiscard]] PolyPoint rounded(const LinePlace& place) const {
    PolyPoint point{};
    for (std::size_t k = 0; k < 3; ++k) {
      Int128 numerator = Int128{scene_.vertices[place.q][k]} * place.a - Int128{scene_.vertices[place.p][k]} * place.b;
      Int128 denominator = Int128{place.a} - place.b;
      if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
      }
      // Halves upwards.
      const Int128 doubled = 2 * numerator + denominator;
      Int128 whole = doubled / (2 * denominator);
      if (doubled < 0 && whole * 2 * denominator != doubled) --whole;
      point[k] = static_cast<std::int32_t>(whole);
    }
    return point;
  }

  const PolyScene& scene_;
  std::vector<CrossingFace> faces_;
  std::vector<Crossing> found_;
  std::size_t most_ = 0;
};

}  // namespace

PolyScene with_crossings(PolyScene scene) {
  const std::vector<Crossing> crossings = crossings_of(scene);
  if (!crossings.empty() && scene.surfaces.empty()) number_planes(scene);
  for (const Crossing& crossing : crossings) {
    const auto first = static_cast<VertexIndex>(scene.vertices.size());
    scene.vertices.push_back(crossing.from);
    scene.vertices.push_back(crossing.to);
    scene.crossings.push_back({first, first + 1, crossing.face_a, crossing.face_b});
  }
  return scene;
}

std::vector<Crossing> crossings_of(const PolyScene& scene, std::size_t most) {
  if (are_plainly_apart(scene)) return {};
  return CrossingSearch(scene).run(most);
}

}  // namespace sightline::scene
