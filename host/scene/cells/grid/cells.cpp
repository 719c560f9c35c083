// See cells.hpp.
#include "host/scene/cells/grid/cells.hpp"

#include <array>

namespace sightline::scene {
namespace {

// Calls visit(unit) for every unit of a cell; returns false at once if visit does.
template <class Visit>
bool all_units(const GridCell& cell, Visit visit) {
  GridUnit unit{};
  for (unit[2] = cell.low[2]; unit[2] < cell.end[2]; ++unit[2])
    for (unit[1] = cell.low[1]; unit[1] < cell.end[1]; ++unit[1])
      for (unit[0] = cell.low[0]; unit[0] < cell.end[0]; ++unit[0])
        if (!visit(unit)) return false;
  return true;
}

}  // namespace

GridCells::GridCells(const GridSpace& space) : space_(space) {
  const GridPlanes& planes = space.planes();
  const GridCell whole{{}, {planes.units(0), planes.units(1), planes.units(2)}};
  owner_.resize(std::size_t{planes.units(0)} * planes.units(1) * planes.units(2));
  for (std::size_t i = 0; i < owner_.size(); ++i) owner_[i] = space.solid(i) ? solid : free;
  all_units(whole, [&](const GridUnit& seed) {
    if (of(seed) != free) return true;
    GridCell cell{seed, {seed[0] + 1, seed[1] + 1, seed[2] + 1}};
    for (const std::size_t axis : {0U, 2U, 1U})
      while (cell.end[axis] < planes.units(axis) && slab_is_free(cell, axis)) ++cell.end[axis];
    all_units(cell, [&](const GridUnit& unit) {
      owner_[space_.index(unit)] = static_cast<CellNumber>(cells_.size());
      return true;
    });
    cells_.push_back(cell);
    return true;
  });
}

// Whether the units just above the cell on `axis` are free, with no sheet between the cell and them or among
// them.
bool GridCells::slab_is_free(const GridCell& cell, std::size_t axis) const {
  GridCell slab = cell;
  slab.low[axis] = cell.end[axis];
  slab.end[axis] = cell.end[axis] + 1;
  const auto across = geometry::other_axes(axis);
  return all_units(slab, [&](const GridUnit& unit) {
    const std::size_t here = space_.index(unit);
    GridUnit before = unit;
    --before[axis];
    if (owner_[here] != free || space_.obstructed(space_.index(before), axis)) return false;
    for (const std::size_t a : across)
      if (unit[a] + 1 < cell.end[a] && space_.obstructed(here, a)) return false;
    return true;
  });
}

}  // namespace sightline::scene
