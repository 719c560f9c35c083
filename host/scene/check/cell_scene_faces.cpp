// Every point of a cell face is opaque or in exactly one opening. The face is cut into strips at every
// coordinate of what lies on it, and each strip is swept once: exact, and without a grid that a hostile file
// could make huge.
#include "host/scene/check/cell_scene_faces.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

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

}  // namespace

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

}  // namespace sightline::scene
