#include "host/algorithms/montani_re/faces.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>
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
      const Vertex p{v.x - about.x, v.y - about.y, v.z - about.z};
      const Vertex q{w.x - about.x, w.y - about.y, w.z - about.z};
      normal[0] += Int128{p.y} * q.z - Int128{p.z} * q.y;
      normal[1] += Int128{p.z} * q.x - Int128{p.x} * q.z;
      normal[2] += Int128{p.x} * q.y - Int128{p.y} * q.x;
    }
  }
  return normal;
}

// Whether any (all) corners of another face are on the same side of a line of a face as that face.
bool holds_any(const Image& image, const Face& face, std::size_t k, const Face& other) {
  return std::any_of(other.vertices.begin(), other.vertices.end(), [&](std::uint32_t v) {
    return face.inner_side[k] * image.side_of(face.lines[k], v) > 0;
  });
}
bool holds_all(const Image& image, const Face& face, std::size_t k, const Face& other) {
  return std::all_of(other.vertices.begin(), other.vertices.end(), [&](std::uint32_t v) {
    return face.inner_side[k] * image.side_of(face.lines[k], v) >= 0;
  });
}

// What the lines of a face show about another face.
struct Seen {
  bool beside = false;    // all of the other face is beyond a line of the face
  bool may_cover = true;  // no corner of the other face is certainly outside
};

Seen seen_from(const FaceSet& set, const Face& face, const Face& other) {
  const std::span corners = set.outline_of(other);
  Seen seen;
  for (std::size_t q = 0; q < face.quads; ++q) {
    const LineSides sides = sides_of_lines(set.outlines[face.first_quad + q], corners);
    if (sides.all_outside != 0) return {true, false};
    seen.may_cover = seen.may_cover && sides.any_outside == 0;
    for (unsigned open = ~sides.any_inside & 0b1111; open != 0; open &= open - 1) {
      const std::size_t k = std::min(4 * q + static_cast<std::size_t>(std::countr_zero(open)), face.lines.size() - 1);
      if (face.inner_side[k] != 0 && !holds_any(set.image, face, k, other)) return {true, false};
    }
  }
  return seen;
}

bool covers(const Image& image, const Face& face, const Face& other) {
  for (std::size_t k = 0; k < face.lines.size(); ++k)
    if (!holds_all(image, face, k, other)) return false;
  return true;
}

}  // namespace

int compare(const ImageNumber& a, const ImageNumber& b) {
  if (a.approximate != b.approximate) return a.approximate < b.approximate ? -1 : 1;
  const Int128 left = Int128{a.numerator} * b.denominator;
  const Int128 right = Int128{b.numerator} * a.denominator;
  return (left > right ? 1 : 0) - (left < right ? 1 : 0);
}

Placement placement_of(const FaceSet& set, const Face& first, const Face& second) {
  if (first.quads == 0 || second.quads == 0) return Placement::mixed;
  const Seen seen = seen_from(set, second, first);
  if (seen.beside || seen_from(set, first, second).beside) return Placement::apart;
  return seen.may_cover && second.convex && covers(set.image, second, first) ? Placement::covered : Placement::mixed;
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

void FaceSetBuilder::reserve(std::size_t vertices, std::size_t faces) {
  set_.image.reserve(vertices, 3 * faces);
  set_.faces.reserve(faces);
  set_.edges.reserve(3 * faces);
  last_line_at_.reserve(vertices);
  line_before_.reserve(3 * faces);
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
      const std::int64_t weight = set_.image.weight(v);
      const std::array<ImageNumber, 2> at{ImageNumber{p.x, weight, set_.image.approximate_x(v)},
                                          ImageNumber{p.y, weight, set_.image.approximate_y(v)}};
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

// A side is positive if the line's value is positive or 0 at all corners.
void FaceSetBuilder::find_inner_sides(Face& face) const {
  for (const std::uint32_t line : face.lines) {
    bool east = false;
    bool west = false;
    const ImageLine& ends = set_.image.lines()[line];
    for (const std::uint32_t v : face.vertices) {
      if (set_.window) break;
      if (v == ends.from || v == ends.to) continue;
      const int side = set_.image.side_of(line, v);
      east = east || side > 0;
      west = west || side < 0;
      if (east && west) break;
    }
    face.inner_side.push_back(static_cast<std::int8_t>(east == west ? 0 : east ? 1 : -1));
    face.convex = face.convex && east != west;
  }
}

// Precondition: all vertices are added, so that the error bounds hold for all of them.
void FaceSetBuilder::add_outline(Face& face) {
  const auto& sides = face.inner_side;
  if (std::all_of(sides.begin(), sides.end(), [](std::int8_t side) { return side == 0; })) return;
  const std::size_t most = std::max(face.vertices.size(), face.lines.size());
  face.first_quad = static_cast<std::uint32_t>(set_.outlines.size());
  face.quads = static_cast<std::uint32_t>((most + 3) / 4);
  for (std::size_t q = 0; q < face.quads; ++q) {
    OutlineQuad& quad = set_.outlines.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      quad.set_corner(k, set_.image, face.vertices[std::min(4 * q + k, face.vertices.size() - 1)]);
      const std::size_t line = std::min(4 * q + k, face.lines.size() - 1);
      // A line with parts of the face on both sides excludes nothing: all corners count as inside.
      if (sides[line] == 0) {
        quad.c[k] = 1;
      } else {
        quad.set_line(k, set_.image, face.lines[line], sides[line]);
      }
    }
  }
}

// The region of a face if there is no window.
TrapezoidPcs FaceSetBuilder::whole_pcs(const Face& face) const {
  const std::span<const std::uint32_t> lines(face.lines.data(), face.lines.size());
  if (!face.convex) return trapezoid_pcs(set_.image, lines);
  return convex_pcs(set_.image, lines, {face.inner_side.data(), face.inner_side.size()});
}

bool FaceSetBuilder::add_face(const Rings& rings, std::uint32_t body, std::uint32_t index) {
  std::array<Int128, 3> normal = normal_of(set_.image, rings);
  const Vertex& p = set_.image.vertices()[rings[0][0]];
  Int128 offset = normal[0] * p.x + normal[1] * p.y + normal[2] * p.z;
  // The eye is at the origin in perspective, otherwise at z = -infinity.
  const Int128 turned = set_.image.perspective() ? offset : normal[2];
  if (turned == 0) {
    ++set_.edge_on;
    return false;
  }
  if (turned < 0) {
    for (Int128& part : normal) part = -part;
    offset = -offset;
  }
  Face& face = set_.faces.emplace_back();
  face.body = body;
  face.index = index;
  face.normal = normal;
  face.offset = offset;
  face.approximate_plane = {static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2]),
                            static_cast<double>(offset)};
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
    // normal . direction is greatest where the plane comes near the eye beside it.
    const int far_side = (face.normal[0] > 0 ? 1 : 0) - (face.normal[0] < 0 ? 1 : 0);
    const std::span<const std::uint32_t> lines(face.lines.data(), face.lines.size());
    face.pcs = clipped_pcs(set_.image, lines, *set_.window, far_side);
    if (face.pcs.empty()) {
      set_.faces.pop_back();
      return false;
    }
    find_inner_sides(face);
  } else {
    find_inner_sides(face);
    face.pcs = whole_pcs(face);
  }
  return true;
}

void FaceSetBuilder::add_isolated_edge(std::uint32_t v, std::uint32_t w) {
  const std::uint32_t line = line_between(v, w);
  if (line != none) set_.isolated.push_back(line);
}

FaceSet FaceSetBuilder::take() {
  set_.outlines.reserve(set_.faces.size());
  for (Face& face : set_.faces) add_outline(face);
  return std::move(set_);
}

base::Result<FaceSet> faces_of(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  if (const auto past = face_past_eye(scene, camera)) {
    return base::Error{"", "montani-re",
                       "face " + std::to_string((*past)[1]) + " of body " + std::to_string((*past)[0]) +
                           " is partly in front of and partly behind the eye, so its image is infinite"};
  }
  return faces_seen(scene, camera);
}

}  // namespace sightline::algorithms::montani_re
