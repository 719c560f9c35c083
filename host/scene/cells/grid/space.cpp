// See space.hpp.
#include "host/scene/cells/grid/space.hpp"

#include <algorithm>
#include <utility>

#include "host/scene/cells/grid/face.hpp"

namespace sightline::scene {
namespace {

using geometry::Rectangle;
using geometry::Span;

// The units whose faces share an area with a rectangle in the same plane, on both other axes.
struct UnitRange {
  std::array<std::uint32_t, 2> low{};
  std::array<std::uint32_t, 2> end{};
};

UnitRange units_under(const GridPlanes& planes, const Rectangle& rectangle) {
  UnitRange range;
  const auto axes = geometry::other_axes(rectangle.axis);
  for (std::size_t k = 0; k < 2; ++k) {
    range.low[k] = planes.unit_of(axes[k], rectangle.sides[k].low);
    range.end[k] = planes.unit_below(axes[k], rectangle.sides[k].high) + 1;
  }
  return range;
}

Span unit_span(const GridPlanes& planes, std::size_t axis, std::uint32_t n) {
  return {planes.at(axis, n), planes.at(axis, n + 1)};
}

std::int64_t common_length(const Span& a, const Span& b) {
  return std::int64_t{std::min(a.high, b.high)} - std::max(a.low, b.low);
}

// By unit, the area of solids' faces on its low x face: positive where a ray along x enters a solid, negative
// where it leaves one.
class WindingSums {
 public:
  explicit WindingSums(const GridPlanes& planes)
      : planes_(planes), areas_(std::size_t{planes.units(0)} * planes.units(1) * planes.units(2), 0) {}

  void add(const GridFace& face) {
    const std::uint32_t x = planes_.unit_of(0, face.at);
    for (const Rectangle& rectangle : face.rectangles) {
      const UnitRange range = units_under(planes_, rectangle);
      for (std::uint32_t z = range.low[1]; z < range.end[1]; ++z) {
        const std::int64_t height = common_length(rectangle.sides[1], unit_span(planes_, 2, z));
        for (std::uint32_t y = range.low[0]; y < range.end[0]; ++y) {
          const std::int64_t area = height * common_length(rectangle.sides[0], unit_span(planes_, 1, y));
          areas_[(std::size_t{z} * planes_.units(1) + y) * planes_.units(0) + x] +=
              face.faces_up ? -area : area;
        }
      }
    }
  }

  // Calls visit(unit) for every unit inside a solid: where more area was entered than left.
  template <class Visit>
  void for_each_inside(Visit visit) const {
    std::size_t unit = 0;
    for (std::uint32_t row = 0; unit < areas_.size(); ++row) {
      std::int64_t entered = 0;
      for (std::uint32_t x = 0; x < planes_.units(0); ++x, ++unit) {
        entered += areas_[unit];
        if (entered > 0) visit(unit);
      }
    }
  }

 private:
  const GridPlanes& planes_;
  std::vector<std::int64_t> areas_;  // by unit, on its low face
};

}  // namespace

GridPlanes::GridPlanes(const PolyScene& scene, const geometry::Box& outer) : low_(outer.low) {
  for (std::size_t a = 0; a < 3; ++a) {
    unit_of_[a].assign(static_cast<std::size_t>(outer.span(a).length() + 1), 0);
    unit_of_[a].front() = unit_of_[a].back() = 1;
  }
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      const auto axis = grid_axis_of(scene, face);
      if (!axis) continue;
      const std::int32_t at = scene.vertices[face.outline[0]][*axis];
      unit_of_[*axis][static_cast<std::size_t>(at - low_[*axis])] = 1;
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t c = 0; c < unit_of_[a].size(); ++c) {
      if (unit_of_[a][c] == 1) planes_[a].push_back(low_[a] + static_cast<std::int32_t>(c));
      unit_of_[a][c] = static_cast<std::uint32_t>(planes_[a].size() - 1);
    }
  }
}

GridSpace::GridSpace(const PolyScene& scene, GridPlanes planes)
    : planes_(std::move(planes)),
      state_(std::size_t{planes_.units(0)} * planes_.units(1) * planes_.units(2), 0) {
  fill_solids(scene);
  add_sheets(scene);
}

void GridSpace::fill_solids(const PolyScene& scene) {
  const bool any =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const PolyBody& body) { return !body.sheet; });
  if (!any) return;
  WindingSums sums(planes_);
  for (const PolyBody& body : scene.bodies) {
    if (body.sheet) continue;
    for (const PolyFace& face : body.faces)
      if (grid_axis_of(scene, face) == std::size_t{0}) sums.add(grid_face_of(scene, face));
  }
  sums.for_each_inside([&](std::size_t unit) { state_[unit] |= solid_bit; });
}

// Reserves space for a rectangle per two corners, which is enough. Reserved memory that is never touched
// costs nothing; a vector that grows needs its memory twice.
void GridSpace::reserve_parts(const PolyScene& scene) {
  std::size_t corners = 0;
  for (const PolyBody& body : scene.bodies) {
    if (!body.sheet) continue;
    for (const PolyFace& face : body.faces) {
      corners += face.outline.size();
      for (const auto& hole : face.holes) corners += hole.size();
    }
  }
  rectangles_.reserve(corners / 2);
  parts_.reserve(corners / 2);
}

void GridSpace::add_sheets(const PolyScene& scene) {
  reserve_parts(scene);
  for (const PolyBody& body : scene.bodies) {
    if (!body.sheet) continue;
    for (const PolyFace& face : body.faces)
      for (const Rectangle& rectangle : grid_face_of(scene, face).rectangles) add_sheet_rectangle(rectangle);
  }
  std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
    return a.face != b.face ? a.face < b.face : a.rectangle < b.rectangle;
  });
}

void GridSpace::add_sheet_rectangle(const Rectangle& rectangle) {
  const auto [u, v] = geometry::other_axes(rectangle.axis);
  const UnitRange range = units_under(planes_, rectangle);
  GridUnit unit{};
  unit[rectangle.axis] = planes_.unit_below(rectangle.axis, rectangle.at);
  bool in_part = false;
  for (unit[v] = range.low[1]; unit[v] < range.end[1]; ++unit[v]) {
    const bool whole_v = rectangle.sides[1].contains(unit_span(planes_, v, unit[v]));
    for (unit[u] = range.low[0]; unit[u] < range.end[0]; ++unit[u]) {
      const std::size_t here = index(unit);
      state_[here] = static_cast<std::uint8_t>(state_[here] | 1U << (first_part_bit + rectangle.axis));
      if (whole_v && rectangle.sides[0].contains(unit_span(planes_, u, unit[u]))) {
        state_[here] = static_cast<std::uint8_t>(state_[here] | 1U << (first_whole_bit + rectangle.axis));
      } else {
        parts_.push_back({face_of(here, rectangle.axis), static_cast<std::uint32_t>(rectangles_.size())});
        in_part = true;
      }
    }
  }
  if (in_part) rectangles_.push_back(rectangle.sides);
}

std::size_t GridSpace::first_part_of(std::uint32_t face) const {
  const auto place = std::lower_bound(parts_.begin(), parts_.end(), face,
                                      [](const Part& part, std::uint32_t f) { return part.face < f; });
  return static_cast<std::size_t>(place - parts_.begin());
}

}  // namespace sightline::scene
