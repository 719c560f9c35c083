// See apart_bodies.hpp.
#include "host/scene/check/apart_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/base/threads.hpp"
#include "host/geometry/predicates.hpp"

namespace sightline::scene {
namespace {

// Every plane of a face is compared with every corner of the body.
constexpr std::size_t most_corners = 64;

// The bounds of a convex body that has faces; nullopt for every other one.
std::optional<PolyBounds> bounds_of_convex(const PolyScene& scene, const PolyBody& body) {
  std::array<VertexIndex, most_corners> vertices;  // each once: most are corners of three faces
  std::array<geometry::Vector3, most_corners> corners;
  std::size_t different = 0;
  std::size_t count = 0;
  const PolyPoint& first = scene.vertices[body.faces[0].outline[0]];
  PolyBounds bounds{first, first};
  for (const PolyFace& face : body.faces) {
    count += face.outline.size();
    if (count > most_corners) return std::nullopt;
    for (const VertexIndex v : face.outline) {
      const auto end = vertices.begin() + static_cast<std::ptrdiff_t>(different);
      if (std::find(vertices.begin(), end, v) != end) continue;
      const PolyPoint& p = scene.vertices[v];
      for (std::size_t k = 0; k < 3; ++k) {
        bounds.low[k] = std::min(bounds.low[k], p[k]);
        bounds.high[k] = std::max(bounds.high[k], p[k]);
      }
      vertices[different] = v;
      corners[different++] = geometry::vector_of(p);
    }
  }
  for (const PolyFace& face : body.faces) {
    const auto& ring = face.outline;
    const auto at = [&](std::size_t i) -> const PolyPoint& { return scene.vertices[ring[i % ring.size()]]; };
    geometry::Vector3 normal{};
    for (std::size_t i = 0; i < ring.size() && geometry::is_zero(normal); ++i)
      normal = geometry::normal_of(at(i), at(i + 1), at(i + 2));
    if (geometry::is_zero(normal)) return std::nullopt;
    const std::int64_t offset = geometry::dot(normal, geometry::vector_of(at(0)));
    bool before = false;
    bool beyond = false;
    for (std::size_t i = 0; i < different; ++i) {
      const std::int64_t side = geometry::dot(normal, corners[i]) - offset;
      before = before || side < 0;
      beyond = beyond || side > 0;
    }
    if (before && beyond) return std::nullopt;
  }
  return bounds;
}

bool meet(const PolyBounds& a, const PolyBounds& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  return true;
}

// Around each body that has faces; nullopt if not all bodies are convex.
std::optional<std::vector<PolyBounds>> boxes_of_convex(const PolyScene& scene, unsigned jobs) {
  std::vector<std::vector<PolyBounds>> parts(jobs);
  std::vector<std::uint8_t> convex(jobs, 1);
  base::for_parts(jobs, scene.bodies.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end && convex[part] != 0; ++b) {
      if (scene.bodies[b].faces.empty()) continue;
      const auto bounds = bounds_of_convex(scene, scene.bodies[b]);
      convex[part] = bounds ? 1 : 0;
      if (bounds) parts[part].push_back(*bounds);
    }
  });
  if (std::count(convex.begin(), convex.end(), 0) > 0) return std::nullopt;
  std::vector<PolyBounds> boxes;
  for (const std::vector<PolyBounds>& part : parts) boxes.insert(boxes.end(), part.begin(), part.end());
  return boxes;
}

// Sorts boxes into cells by their low corners. A box in a cell is no longer than a cell, so a box that meets it begins in the same
// cell or a neighbouring one. Boxes far longer than most are in no cell: each is compared with all others.
class BoxCells {
 public:
  explicit BoxCells(const std::vector<PolyBounds>& boxes) : boxes_(boxes) {
    PolyBounds around = boxes[0];
    std::array<double, 3> sum{};
    for (const PolyBounds& box : boxes) {
      for (std::size_t k = 0; k < 3; ++k) {
        around.low[k] = std::min(around.low[k], box.low[k]);
        around.high[k] = std::max(around.high[k], box.high[k]);
        sum[k] += box.high[k] - box.low[k];
      }
    }
    low_ = around.low;
    constexpr double times_the_mean = 4;
    const auto most_a_side = static_cast<std::int64_t>(std::cbrt(2 * static_cast<double>(boxes.size()))) + 1;
    std::size_t cells = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t extent = std::int64_t{around.high[k]} - around.low[k];
      const auto usual = static_cast<std::int64_t>(times_the_mean * sum[k] / static_cast<double>(boxes.size()));
      size_[k] = std::max(usual, extent / most_a_side) + 1;
      count_[k] = extent / size_[k] + 1;
      cells *= static_cast<std::size_t>(count_[k]);
    }
    for (std::uint32_t b = 0; b < boxes.size(); ++b)
      if (!fits_cell(boxes[b])) large_.push_back(b);
    starts_.resize(cells + 1);
    for (const PolyBounds& box : boxes)
      if (fits_cell(box)) ++starts_[cell_of(place_of(box)) + 1];
    for (std::size_t c = 1; c <= cells; ++c) starts_[c] += starts_[c - 1];
    members_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const PolyBounds& box : boxes)
      if (fits_cell(box)) members_[next[cell_of(place_of(box))]++] = box;
  }

  // True: no two meet. False: two do, or more pairs than `most` would have to be compared.
  [[nodiscard]] bool are_apart(std::uint64_t most, unsigned jobs) const {
    std::uint64_t sum = large_.size() * boxes_.size();
    if (sum > most) return false;
    for (const std::uint32_t b : large_)
      for (std::uint32_t other = 0; other < boxes_.size(); ++other)
        if (other != b && meet(boxes_[b], boxes_[other])) return false;
    std::vector<std::optional<std::uint64_t>> compared(jobs);
    base::for_parts(jobs, members_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      compared[part] = pairs_apart(begin, end, most);
    });
    for (const auto& pairs : compared) {
      if (!pairs) return false;
      sum += *pairs;
    }
    return sum <= most;
  }

 private:
  using Place = std::array<std::int64_t, 3>;

  // The number of pairs with one of the members `begin` to `end` - 1 that were compared; nullopt if two meet, or if there are more than
  // `most`.
  [[nodiscard]] std::optional<std::uint64_t> pairs_apart(std::size_t begin, std::size_t end, std::uint64_t most) const {
    std::uint64_t compared = 0;
    for (std::size_t m = begin; m < end; ++m) {
      const Place at = place_of(members_[m]);
      for (std::int64_t x = std::max<std::int64_t>(at[0] - 1, 0); x <= at[0]; ++x) {
        for (std::int64_t y = std::max<std::int64_t>(at[1] - 1, 0); y <= std::min(at[1] + 1, count_[1] - 1); ++y) {
          for (std::int64_t z = std::max<std::int64_t>(at[2] - 1, 0); z <= std::min(at[2] + 1, count_[2] - 1); ++z) {
            const std::size_t cell = cell_of({x, y, z});
            compared += starts_[cell + 1] - starts_[cell];
            if (compared > most) return std::nullopt;
            for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i)
              if (i != m && meet(members_[m], members_[i])) return std::nullopt;
          }
        }
      }
    }
    return compared;
  }

  [[nodiscard]] bool fits_cell(const PolyBounds& box) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::int64_t{box.high[k]} - box.low[k] >= size_[k]) return false;
    return true;
  }
  [[nodiscard]] Place place_of(const PolyBounds& box) const {
    Place place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = (std::int64_t{box.low[k]} - low_[k]) / size_[k];
    return place;
  }
  [[nodiscard]] std::size_t cell_of(const Place& place) const {
    return static_cast<std::size_t>((place[0] * count_[1] + place[1]) * count_[2] + place[2]);
  }

  const std::vector<PolyBounds>& boxes_;
  PolyPoint low_{};
  Place size_{};
  Place count_{};
  std::vector<std::uint32_t> large_;
  std::vector<std::uint32_t> starts_;
  std::vector<PolyBounds> members_;  // cell by cell
};

}  // namespace

bool are_plainly_apart(const PolyScene& scene, unsigned jobs) {
  const auto boxes = boxes_of_convex(scene, jobs);
  if (!boxes) return false;
  constexpr std::uint64_t pairs_a_box = 64;
  return boxes->empty() || BoxCells(*boxes).are_apart(pairs_a_box * boxes->size(), jobs);
}

}  // namespace sightline::scene
