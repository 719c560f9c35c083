#include "host/algorithms/montani_re/faces.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;

ImageNumber number(std::int64_t numerator, std::int64_t denominator) {
  return {numerator, denominator, static_cast<double>(numerator) / static_cast<double>(denominator)};
}

std::array<Int128, 3> normal_of(const Image& image, const Rings& rings) {
  std::array<Int128, 3> normal{};
  const Vertex& about = image.vertices()[rings[0][0]];
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex& v = image.vertices()[ring[i]];
      const Vertex& w = image.vertices()[ring[i + 1 == ring.size() ? 0 : i + 1]];
      const std::array<Int128, 3> p{v.x - about.x, v.y - about.y, v.z - about.z};
      const std::array<Int128, 3> q{w.x - about.x, w.y - about.y, w.z - about.z};
      for (std::size_t k = 0; k < 3; ++k)
        normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
    }
  }
  return normal;
}

// Some corner of another face, or all of them, or none, on the side of a line where the line's own face is.
class Half {
 public:
  Half(const Image& image, const Face& face, std::size_t k)
      : image_(image), line_(face.lines[k]), east_(face.inner_side[k] > 0) {}

  [[nodiscard]] bool holds_any(const Face& other) const {
    return std::any_of(other.vertices.begin(), other.vertices.end(),
                       [this](std::uint32_t v) { return inward(v) > 0; });
  }
  [[nodiscard]] bool holds_all(const Face& other) const {
    return std::all_of(other.vertices.begin(), other.vertices.end(),
                       [this](std::uint32_t v) { return inward(v) >= 0; });
  }

 private:
  [[nodiscard]] Int128 inward(std::uint32_t vertex) const {
    const Int128 at = image_.value_at(line_, vertex);
    return east_ ? at : -at;
  }

  const Image& image_;
  std::uint32_t line_;
  bool east_;
};

// All of the other face is beyond a line of the face.
bool beside(const Image& image, const Face& face, const Face& other) {
  for (std::size_t k = 0; k < face.lines.size(); ++k) {
    if (face.inner_side[k] != 0 && !Half(image, face, k).holds_any(other)) return true;
  }
  return false;
}

bool covers(const Image& image, const Face& face, const Face& other) {
  for (std::size_t k = 0; k < face.lines.size(); ++k) {
    if (face.inner_side[k] == 0 || !Half(image, face, k).holds_all(other)) return false;
  }
  return true;
}

}  // namespace

int compare(const ImageNumber& a, const ImageNumber& b) {
  if (a.approximate != b.approximate) return a.approximate < b.approximate ? -1 : 1;
  const Int128 left = Int128{a.numerator} * b.denominator;
  const Int128 right = Int128{b.numerator} * a.denominator;
  return (left > right ? 1 : 0) - (left < right ? 1 : 0);
}

Placement placement_of(const Image& image, const Face& first, const Face& second) {
  if (beside(image, second, first) || beside(image, first, second)) return Placement::apart;
  return covers(image, second, first) ? Placement::covered : Placement::mixed;
}

std::uint32_t FaceSetBuilder::line_between(std::uint32_t v, std::uint32_t w) {
  if (!set_.image.distinct_images(v, w)) return none;
  if (set_.image.weight(v) <= 0 && set_.image.weight(w) <= 0) return none;
  const std::uint32_t from = std::min(v, w);
  const std::uint32_t to = std::max(v, w);
  if (last_line_at_.size() <= from) last_line_at_.resize(set_.image.vertices().size(), none);
  for (std::uint32_t known = last_line_at_[from]; known != none; known = line_before_[known]) {
    if (set_.edges[known].to == to) return known;
  }
  const std::uint32_t line = set_.image.add_line(from, to);
  line_before_.resize(line, none);
  line_before_.push_back(last_line_at_[from]);
  last_line_at_[from] = line;
  set_.edges.push_back({from, to});
  return line;
}

void FaceSetBuilder::clip_to(const WindowBounds& bounds) {
  set_.window = add_window(set_.image, bounds);
  for (const std::uint32_t line : {set_.window->west, set_.window->east})
    set_.edges.push_back({set_.image.lines()[line].from, set_.image.lines()[line].to});
}

void FaceSetBuilder::measure(Face& face) const {
  bool first = true;
  bool past_eye = false;
  for (const std::uint32_t v : face.vertices) {
    const Vertex& p = set_.image.vertices()[v];
    face.nearest = first ? p.z : std::min(face.nearest, p.z);
    face.farthest = first ? p.z : std::max(face.farthest, p.z);
    if (set_.image.weight(v) <= 0) {
      past_eye = true;
    } else {
      const std::array<ImageNumber, 2> at{number(p.x, set_.image.weight(v)),
                                          number(p.y, set_.image.weight(v))};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (first || compare(at[axis], face.low[axis]) < 0) face.low[axis] = at[axis];
        if (first || compare(at[axis], face.high[axis]) > 0) face.high[axis] = at[axis];
      }
    }
    first = false;
  }
  if (!set_.window) return;
  const WindowBounds& window = set_.window->bounds;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const ImageNumber low = number(window.low[axis], window.unit);
    const ImageNumber high = number(window.high[axis], window.unit);
    if (past_eye || compare(face.low[axis], low) < 0) face.low[axis] = low;
    if (past_eye || compare(face.high[axis], high) > 0) face.high[axis] = high;
  }
}

void FaceSetBuilder::find_inner_sides(Face& face) const {
  face.inner_side.resize(face.lines.size());
  if (set_.window) return;
  for (std::size_t k = 0; k < face.lines.size(); ++k) {
    bool east = false;
    bool west = false;
    for (const std::uint32_t v : face.vertices) {
      const Int128 at = set_.image.value_at(face.lines[k], v);
      east = east || at > 0;
      west = west || at < 0;
      if (east && west) break;
    }
    face.inner_side[k] = static_cast<std::int8_t>(east == west ? 0 : east ? 1 : -1);
  }
}

bool FaceSetBuilder::add_face(const Rings& rings, std::uint32_t body, std::uint32_t index) {
  Face face;
  face.body = body;
  face.index = index;
  face.normal = normal_of(set_.image, rings);
  const Vertex& p = set_.image.vertices()[rings[0][0]];
  face.offset = face.normal[0] * p.x + face.normal[1] * p.y + face.normal[2] * p.z;
  // The eye is at the origin in perspective, at z = -infinity else.
  const Int128 turned = set_.image.perspective() ? face.offset : face.normal[2];
  if (turned == 0) {
    ++set_.edge_on;
    return false;
  }
  if (turned < 0) {
    for (Int128& part : face.normal) part = -part;
    face.offset = -face.offset;
  }
  std::size_t corners = 0;
  for (const auto& ring : rings) corners += ring.size();
  face.vertices.reserve(corners);
  face.lines.reserve(corners);
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t next = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (ring[i] == next) continue;
      face.vertices.push_back(ring[i]);
      const std::uint32_t line = line_between(ring[i], next);
      if (line != none) face.lines.push_back(line);
    }
  }
  measure(face);
  if (set_.window) {
    // Where the plane comes near the eye beside it, normal . direction is greatest.
    const int far_side = (face.normal[0] > 0 ? 1 : 0) - (face.normal[0] < 0 ? 1 : 0);
    face.pcs = clipped_pcs(set_.image, face.lines, *set_.window, far_side);
    if (face.pcs.empty()) return false;
  } else {
    face.pcs = trapezoid_pcs(set_.image, face.lines);
  }
  find_inner_sides(face);
  set_.faces.push_back(std::move(face));
  return true;
}

void FaceSetBuilder::add_isolated_edge(std::uint32_t v, std::uint32_t w) {
  const std::uint32_t line = line_between(v, w);
  if (line != none) set_.lone.push_back(line);
}

FaceSet FaceSetBuilder::take() {
  return std::move(set_);
}

base::Result<FaceSet> faces_of(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  if (const auto past = face_past_eye(scene, camera)) {
    return base::Error{"", "montani-re",
                       "face " + std::to_string((*past)[1]) + " of body " + std::to_string((*past)[0]) +
                           " reaches from before the eye to behind it: its image has no end"};
  }
  return faces_seen(scene, camera);
}

}  // namespace sightline::algorithms::montani_re
