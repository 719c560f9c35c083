#include "host/scene/check/cell_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "host/base/result.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::scene {

namespace {

using geometry::Rectangle;
using geometry::Span;

enum class Kind : std::uint8_t { opening, wall, solid_above, solid_below, outside };

// Something that covers a part of a plane.
struct Patch {
  Kind kind;
  std::size_t number;
  std::array<Span, 2> sides;
};

using PatchesByPlane = std::map<std::pair<std::size_t, std::int32_t>, std::vector<Patch>>;

PatchesByPlane patches_by_plane(const CellScene& scene) {
  PatchesByPlane planes;
  const auto add = [&](Kind kind, std::size_t number, const Rectangle& r) {
    planes[{r.axis, r.at}].push_back({kind, number, r.sides});
  };
  for (std::size_t i = 0; i < scene.openings.size(); ++i) add(Kind::opening, i, scene.openings[i].place);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) add(Kind::wall, i, scene.walls[i]);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < scene.solids.size(); ++i) {
      add(Kind::solid_above, i, geometry::face_of(scene.solids[i], a, false));
      add(Kind::solid_below, i, geometry::face_of(scene.solids[i], a, true));
    }
    add(Kind::outside, 0, geometry::face_of(scene.outer, a, false));
    add(Kind::outside, 0, geometry::face_of(scene.outer, a, true));
  }
  return planes;
}

std::string name_of(const Patch& patch) {
  switch (patch.kind) {
    case Kind::opening: return "opening " + std::to_string(patch.number);
    case Kind::wall: return "wall " + std::to_string(patch.number);
    case Kind::outside: return "the outer box";
    default: return "solid " + std::to_string(patch.number);
  }
}

// One face of one cell, and the patches on it.
class Face {
 public:
  Face(const CellScene& scene, std::size_t cell, std::size_t axis, bool high, const PatchesByPlane& planes)
      : cell_(cell), high_(high), face_(geometry::face_of(scene.cells[cell].box, axis, high)) {
    const auto plane = planes.find({axis, face_.at});
    if (plane == planes.end()) return;
    for (const Patch& patch : plane->second) {
      const bool here = patch.sides[0].overlaps(face_.sides[0]) && patch.sides[1].overlaps(face_.sides[1]);
      if (here && concerns(scene, patch)) patches_.push_back(patch);
    }
  }

  void check(Problems& problems) const {
    std::vector<std::int32_t> cuts{face_.sides[0].low, face_.sides[0].high};
    for (const Patch& patch : patches_) {
      for (const std::int32_t c : {patch.sides[0].low, patch.sides[0].high}) {
        if (face_.sides[0].low < c && c < face_.sides[0].high) cuts.push_back(c);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size() && !problems.full(); ++i) {
      if (!check_strip({cuts[i], cuts[i + 1]}, problems)) return;
    }
  }

 private:
  [[nodiscard]] bool concerns(const CellScene& scene, const Patch& patch) const {
    switch (patch.kind) {
      case Kind::opening: return scene.openings[patch.number].cells[high_ ? 0 : 1] == cell_;
      case Kind::solid_above: return high_;
      case Kind::solid_below: return !high_;
      default: return true;
    }
  }

  // Sweeps one strip, in which every patch covers the full width. False after the first error.
  [[nodiscard]] bool check_strip(Span strip, Problems& problems) const {
    std::vector<const Patch*> here;
    for (const Patch& patch : patches_) {
      if (patch.sides[0].overlaps(strip)) here.push_back(&patch);
    }
    std::stable_sort(here.begin(), here.end(),
                     [](const Patch* a, const Patch* b) { return a->sides[1].low < b->sides[1].low; });
    std::int32_t covered = face_.sides[1].low;  // everything below is covered
    std::optional<Patch> opening;               // that reaches highest so far
    std::optional<Patch> opaque;
    for (const Patch* patch : here) {
      if (patch->sides[1].low > covered) break;
      const bool is_opening = patch->kind == Kind::opening;
      for (const std::optional<Patch>& earlier : {opening, is_opening ? opaque : std::nullopt}) {
        if (!earlier || !earlier->sides[1].overlaps(patch->sides[1])) continue;
        report_twice(*earlier, *patch, problems);
        return false;
      }
      std::optional<Patch>& own = is_opening ? opening : opaque;
      if (!own || own->sides[1].high < patch->sides[1].high) own = *patch;
      covered = std::max(covered, patch->sides[1].high);
    }
    if (covered >= face_.sides[1].high) return true;
    report_gap(strip, covered, here, problems);
    return false;
  }

  void report_twice(const Patch& a, const Patch& b, Problems& problems) const {
    const Patch& opening = a.kind == Kind::opening ? a : b;
    const Patch& other = a.kind == Kind::opening ? b : a;
    problems.add(name_of(opening), "is partly covered by " + name_of(other));
  }

  void report_gap(Span strip, std::int32_t covered, const std::vector<const Patch*>& here,
                  Problems& problems) const {
    std::int32_t end = face_.sides[1].high;
    for (const Patch* patch : here) {
      if (patch->sides[1].low > covered) end = std::min(end, patch->sides[1].low);
    }
    const auto [u, v] = geometry::other_axes(face_.axis);
    problems.add("cell", cell_,
                 std::string("the ") + (high_ ? "high " : "low ") + axis_name(face_.axis) + " face (" +
                     axis_name(face_.axis) + " = " + std::to_string(face_.at) +
                     ") is neither opaque nor open at " + text_of(u, strip) + ", " +
                     text_of(v, {covered, end}));
  }

  std::size_t cell_;
  bool high_;
  Rectangle face_;
  std::vector<Patch> patches_;
};

// Every point of a cell face is opaque or in exactly one opening. The face is cut into strips at every
// coordinate of what lies on it, and each strip is swept once: exact, and without a grid that a hostile file
// could make huge. Precondition:
// all the rest of check_scene found nothing.
void check_faces(const CellScene& scene, Problems& problems) {
  const PatchesByPlane planes = patches_by_plane(scene);
  for (std::size_t cell = 0; cell < scene.cells.size(); ++cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) {
        if (!problems.full()) Face(scene, cell, axis, high, planes).check(problems);
      }
    }
  }
}

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
