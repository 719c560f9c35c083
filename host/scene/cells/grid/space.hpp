// The grid of decompose_grid: which units are solid, and where sheets lie between units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// A unit by its numbers along x, y and z, from the low end of the outer box.
using GridUnit = std::array<std::uint32_t, 3>;

// The planes perpendicular to each axis, ascending, including those of the outer box.
class GridPlanes {
 public:
  // The scene's faces are parallel to the axes.
  GridPlanes(const PolyScene& scene, const geometry::Box& outer);

  // The number of units along an axis.
  [[nodiscard]] std::uint32_t units(std::size_t axis) const {
    return static_cast<std::uint32_t>(planes_[axis].size() - 1);
  }
  [[nodiscard]] double all_units() const { return static_cast<double>(units(0)) * units(1) * units(2); }
  // The coordinate where unit number n of an axis begins; units(axis) is where the last one ends.
  [[nodiscard]] std::int32_t at(std::size_t axis, std::uint32_t n) const { return planes_[axis][n]; }
  // The unit that contains `coordinate`, which is within the outer box; at a border, the higher unit.
  [[nodiscard]] std::uint32_t unit_of(std::size_t axis, std::int32_t coordinate) const {
    return unit_of_[axis][static_cast<std::size_t>(coordinate - low_[axis])];
  }
  // The unit just below `coordinate`.
  [[nodiscard]] std::uint32_t unit_below(std::size_t axis, std::int32_t coordinate) const {
    const std::uint32_t n = unit_of(axis, coordinate);
    return at(axis, n) == coordinate ? n - 1 : n;
  }

 private:
  geometry::Point low_{};
  std::array<std::vector<std::int32_t>, 3> planes_;
  std::array<std::vector<std::uint32_t>, 3> unit_of_;
};

class GridSpace {
 public:
  static constexpr std::size_t most_units = 0xFFFFFFFF / 3;  // so that their faces are numbered in 32 bits

  // The planes make at most most_units units (precondition).
  GridSpace(const PolyScene& scene, GridPlanes planes);

  [[nodiscard]] const GridPlanes& planes() const { return planes_; }
  // x fastest, then y, then z: the order in which boxes grow.
  [[nodiscard]] std::size_t index(const GridUnit& unit) const {
    return (std::size_t{unit[2]} * planes_.units(1) + unit[1]) * planes_.units(0) + unit[0];
  }
  [[nodiscard]] bool solid(std::size_t unit) const { return (state_[unit] & solid_bit) != 0; }
  // Whether a sheet covers some part of the unit's high face on `axis`.
  [[nodiscard]] bool obstructed(std::size_t unit, std::size_t axis) const {
    return (state_[unit] >> (first_part_bit + axis) & 1U) != 0;
  }
  // Whether a single rectangle of a sheet covers all of that face.
  [[nodiscard]] bool closed(std::size_t unit, std::size_t axis) const {
    return (state_[unit] >> (first_whole_bit + axis) & 1U) != 0;
  }
  // If no rectangle covers all of that face, calls visit(sides) for those that cover part of it, not cut at
  // the unit's borders.
  template <class Visit>
  void for_each_part(std::size_t unit, std::size_t axis, Visit visit) const {
    const std::uint32_t face = face_of(unit, axis);
    for (std::size_t i = first_part_of(face); i < parts_.size() && parts_[i].face == face; ++i)
      visit(rectangles_[parts_[i].rectangle]);
  }

 private:
  static constexpr std::uint8_t solid_bit = 1;
  static constexpr unsigned first_part_bit = 1;
  static constexpr unsigned first_whole_bit = 4;

  using Sides = std::array<geometry::Span, 2>;

  // A unit's high face on an axis and a rectangle that covers part of it. A building of a million rooms has
  // millions of parts, so they do not repeat what is known of their face.
  struct Part {
    std::uint32_t face = 0;
    std::uint32_t rectangle = 0;
  };

  [[nodiscard]] static std::uint32_t face_of(std::size_t unit, std::size_t axis) {
    return static_cast<std::uint32_t>(unit * 3 + axis);
  }
  void fill_solids(const PolyScene& scene);
  void reserve_parts(const PolyScene& scene);
  void add_sheets(const PolyScene& scene);
  void add_sheet_rectangle(const geometry::Rectangle& rectangle);
  [[nodiscard]] std::size_t first_part_of(std::uint32_t face) const;

  GridPlanes planes_;
  std::vector<std::uint8_t> state_;
  std::vector<Sides> rectangles_;  // those that cover a unit's face in part
  std::vector<Part> parts_;        // ascending by face
};

}  // namespace sightline::scene
