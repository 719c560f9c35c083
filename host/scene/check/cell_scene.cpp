#include "host/scene/check/cell_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene_faces.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/locate.hpp"

namespace sightline::scene {
namespace {

using geometry::Box;
using geometry::Point;
using geometry::Rectangle;
using geometry::Span;

constexpr std::int32_t lowest_magnitude = -16384;  // 15 bits, two's complement: what a vector word holds
constexpr std::int32_t highest_magnitude = 16383;

bool strictly_inside(std::int32_t c, Span span) {
  return span.low < c && c < span.high;
}

void check_place(const char* kind, std::size_t number, const Box& box, const Box& outer, Problems& problems) {
  if (!outer.contains(box)) problems.add(kind, number, "reaches outside the outer box");
}

void check_extents(const CellScene& scene, Problems& problems) {
  const auto check_box = [&](const char* kind, std::size_t number, const Box& box) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (box.span(a).empty()) {
        problems.add(kind, number, "is empty: " + text_of(a, box.span(a)) + ", expected low < high");
      }
    }
    check_place(kind, number, box, scene.outer, problems);
  };
  for (std::size_t a = 0; a < 3; ++a) {
    if (scene.outer.span(a).empty()) {
      problems.add("outer box", "is empty: " + text_of(a, scene.outer.span(a)) + ", expected low < high");
    }
  }
  if (scene.cells.empty()) problems.add("cells", "expected at least one cell, found none");
  for (std::size_t i = 0; i < scene.solids.size(); ++i) check_box("solid", i, scene.solids[i]);
  for (std::size_t i = 0; i < scene.cells.size(); ++i) check_box("cell", i, scene.cells[i].box);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const Rectangle& wall = scene.walls[i];
    if (wall.empty()) problems.add("wall", i, "is empty, expected low < high on both sides");
    check_place("wall", i, wall.bounds(), scene.outer, problems);
  }
}

// A box, or a wall as a box without depth, in the sweep below.
struct Item {
  const char* kind;
  std::size_t number;
  Box box;
  const Rectangle* wall;  // null for cells and solids
};

bool wall_cuts(const Rectangle& wall, const Box& box) {
  const auto [u, v] = geometry::other_axes(wall.axis);
  return strictly_inside(wall.at, box.span(wall.axis)) && wall.sides[0].overlaps(box.span(u)) &&
         wall.sides[1].overlaps(box.span(v));
}

void check_pair(const Item& a, const Item& b, Problems& problems) {
  if (a.wall && b.wall) return;
  if (a.wall || b.wall) {
    const Item& wall = a.wall ? a : b;
    const Item& box = a.wall ? b : a;
    // A wall inside a solid changes nothing; it may be drawn through one.
    if (std::string_view(box.kind) == "cell" && wall_cuts(*wall.wall, box.box)) {
      problems.add(box.kind, box.number, "is cut by wall " + std::to_string(wall.number));
    }
    return;
  }
  if (a.box.overlaps(b.box)) {
    problems.add(a.kind, a.number, std::string("overlaps ") + b.kind + " " + std::to_string(b.number));
  }
}

// The axis with the most different low ends tells the items apart best.
std::size_t sweep_axis(const std::vector<Item>& items) {
  std::size_t best = 0;
  std::size_t most = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    std::set<std::int32_t> lows;
    for (const Item& item : items) lows.insert(item.box.low[a]);
    if (lows.size() > most) {
      most = lows.size();
      best = a;
    }
  }
  return best;
}

void check_overlaps(const CellScene& scene, Problems& problems) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < scene.cells.size(); ++i)
    items.push_back({"cell", i, scene.cells[i].box, nullptr});
  for (std::size_t i = 0; i < scene.solids.size(); ++i)
    items.push_back({"solid", i, scene.solids[i], nullptr});
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    items.push_back({"wall", i, scene.walls[i].bounds(), &scene.walls[i]});
  }
  const std::size_t axis = sweep_axis(items);
  std::stable_sort(items.begin(), items.end(),
                   [&](const Item& a, const Item& b) { return a.box.low[axis] < b.box.low[axis]; });
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1; j < items.size() && items[j].box.low[axis] <= items[i].box.high[axis]; ++j) {
      if (problems.full()) return;
      check_pair(items[i], items[j], problems);
    }
  }
}

void check_volume(const CellScene& scene, Problems& problems) {
  std::int64_t filled = 0;
  for (const Cell& cell : scene.cells) filled += cell.box.volume();
  for (const Box& solid : scene.solids) filled += solid.volume();
  if (filled != scene.outer.volume()) {
    problems.add("volume", "cells and solids together have " + std::to_string(filled) +
                               ", expected the outer box's " + std::to_string(scene.outer.volume()));
  }
}

// The four corners of `rectangle` in the order in which `ring` has them, or false.
bool goes_round(const std::vector<Point>& ring, const Rectangle& rectangle) {
  if (ring.size() != 4) return false;
  const Box bounds = rectangle.bounds();
  const std::set<Point> corners(ring.begin(), ring.end());
  for (std::size_t s = 0; s < 4; ++s) {
    int changes = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      if (ring[s][a] != bounds.low[a] && ring[s][a] != bounds.high[a]) return false;
      changes += ring[s][a] != ring[(s + 1) % 4][a] ? 1 : 0;
    }
    if (changes != 1) return false;
  }
  return corners.size() == 4;
}

void check_vectors(std::size_t number, const Opening& opening, Problems& problems) {
  Point at = opening.ring[0];
  std::size_t side = 0;  // the corner last reached
  for (std::size_t n = 0; n < opening.vectors.size(); ++n) {
    const RingVector& v = opening.vectors[n];
    const std::string name = "vector " + std::to_string(n);
    if (v.axis > 2 || v.magnitude < lowest_magnitude || v.magnitude > highest_magnitude || v.magnitude == 0) {
      problems.add(
          "opening", number,
          name + " has magnitude " + std::to_string(v.magnitude) + ", expected -16384..16383 and not 0");
      return;
    }
    const Point& from = opening.ring[side % 4];
    const Point& corner = opening.ring[(side + 1) % 4];
    at[v.axis] += v.magnitude;
    const Span stretch{std::min(from[v.axis], corner[v.axis]), std::max(from[v.axis], corner[v.axis])};
    const bool forward = (v.magnitude > 0) == (corner[v.axis] > from[v.axis]);
    if (side == 4 || stretch.empty() || !forward || !stretch.contains(at[v.axis])) {
      problems.add("opening", number, name + " ends at " + text_of(at) + ", off the outline");
      return;
    }
    if (at == corner) ++side;
  }
  if (side != 4) {
    problems.add(
        "opening", number,
        "the vectors do not close: they end at " + text_of(at) + ", expected " + text_of(opening.ring[0]));
  }
}

void check_opening(const CellScene& scene, std::size_t number, Problems& problems) {
  const Opening& opening = scene.openings[number];
  const Rectangle& place = opening.place;
  for (const std::size_t cell : opening.cells) {
    if (cell >= scene.cells.size()) {
      problems.add("opening", number,
                   "names cell " + std::to_string(cell) + ", of " + std::to_string(scene.cells.size()));
      return;
    }
  }
  if (place.axis > 2 || place.empty() || opening.cells[0] == opening.cells[1]) {
    problems.add("opening", number, "expected a rectangle with an area between two different cells");
    return;
  }
  for (const bool second : {false, true}) {
    const std::size_t cell = opening.cells[second ? 1 : 0];
    const Rectangle face = geometry::face_of(scene.cells[cell].box, place.axis, !second);
    if (face.at != place.at || !face.sides[0].contains(place.sides[0]) ||
        !face.sides[1].contains(place.sides[1])) {
      problems.add("opening", number,
                   std::string("is not on the ") + (second ? "low " : "high ") + axis_name(place.axis) +
                       " face of cell " + std::to_string(cell) + " (" + axis_name(place.axis) + " = " +
                       std::to_string(face.at) + ")");
    }
  }
  if (!goes_round(opening.ring, place)) {
    problems.add("opening", number, "the ring is not the four corners of the rectangle in order");
    return;
  }
  check_vectors(number, opening, problems);
}

void check_line(std::size_t cell, const Box& box, std::size_t number, const Line& line, Problems& problems) {
  int moving = 0;
  bool on_boundary = false;
  for (std::size_t a = 0; a < 3; ++a) {
    const bool moves = line.from[a] != line.to[a];
    moving += moves ? 1 : 0;
    on_boundary = on_boundary || (!moves && (line.from[a] == box.low[a] || line.from[a] == box.high[a]));
  }
  const std::string name =
      "line " + std::to_string(number) + " from " + text_of(line.from) + " to " + text_of(line.to);
  if (moving != 1) {
    problems.add("cell", cell, name + " is not parallel to an axis");
  } else if (!on_boundary || !box.contains(line.from) || !box.contains(line.to)) {
    problems.add("cell", cell, name + " is not on the cell's boundary");
  }
}

}  // namespace

std::vector<base::Error> check_scene(const CellScene& scene) {
  Problems problems;
  check_extents(scene, problems);
  if (!problems.none()) return problems.take();
  check_overlaps(scene, problems);
  check_volume(scene, problems);
  for (std::size_t o = 0; o < scene.openings.size() && !problems.full(); ++o)
    check_opening(scene, o, problems);
  for (std::size_t c = 0; c < scene.cells.size(); ++c) {
    const Cell& cell = scene.cells[c];
    for (std::size_t l = 0; l < cell.lines.size() && !problems.full(); ++l) {
      check_line(c, cell.box, l, cell.lines[l], problems);
    }
  }
  if (problems.none()) check_faces(scene, problems);
  if (problems.none()) {
    const auto location = locate(scene, scene.default_view);
    if (!location) problems.add("default_view", location.error().found);
  }
  return problems.take();
}

}  // namespace sightline::scene
