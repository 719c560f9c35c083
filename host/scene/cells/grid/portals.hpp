// The portals between two boxes of a grid: their common rectangle without the sheets on it, as rectangles.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/scene/cells/grid/cells.hpp"
#include "host/scene/cells/grid/space.hpp"
#include "host/scene/cells/free_rectangles.hpp"

namespace sightline::scene {

class GridOpenings {
 public:
  // `most_parts` limits the parts into which the outlines of sheets may cut one rectangle.
  GridOpenings(const GridSpace& space, std::size_t most_parts) : space_(space), most_parts_(most_parts) {}

  // The openings where `above` meets `below` on the high face of `below` on `axis`: disjoint, covering all of
  // the free part. Valid until the next call. Empty if there are too many parts.
  [[nodiscard]] std::optional<std::span<const geometry::Rectangle>> between(const GridCell& below,
                                                                            const GridCell& above,
                                                                            std::size_t axis);

 private:
  // Units low..end - 1 on both axes of a plane; they are the units below the plane.
  struct Meeting {
    std::size_t axis = 0;
    std::array<std::size_t, 2> across{};
    GridUnit low{};
    GridUnit end{};
  };

  template <class Visit>
  void for_each_unit(const Meeting& meeting, Visit visit) const;
  [[nodiscard]] geometry::Rectangle meeting_rectangle(const Meeting& meeting) const;
  void gather_covers(const Meeting& meeting);

  const GridSpace& space_;
  std::size_t most_parts_;
  std::vector<geometry::Rectangle> covers_;
  FreeRectangles free_;
  std::vector<geometry::Rectangle> openings_;
};

}  // namespace sightline::scene
