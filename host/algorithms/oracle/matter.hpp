// The matter of a scene on the grid of its own coordinates: which units of space are solid, which unit faces a wall
// covers, and the scene's real lines derived from these alone. The scene's cells, openings and cell lines are not read,
// so that the oracle cannot inherit their mistakes.
//
// Unit i of an axis extends from the axis's i-th to its (i+1)-th grid coordinate. Everything outside the outer box is
// solid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/scene/model/cell_scene.hpp"

namespace sightline::algorithms::oracle {

// A real line: an edge of the grid, or several in a row, where matter is not flat. Around it are four quadrants: quadrant
// q is on the high side of the first cross axis if q is odd, and of the second if q is 2 or 3. A quadrant's flag says
// whether the line is a feature when seen from that quadrant: the free angle that contains the quadrant is not half a
// turn. (A wall that a partition meets from behind is flat in front.)
struct RealLine {
  std::size_t axis = 0;
  std::array<int, 2> cross{};  // grid line numbers on other_axes(axis)
  geometry::Point from{};      // from < to on the axis
  geometry::Point to{};
  std::array<bool, 4> feature{};

  friend bool operator==(const RealLine&, const RealLine&) = default;
};

class Matter {
 public:
  static constexpr std::size_t most_units = std::size_t{1} << 26;

  // nullopt if the grid would have more than most_units units, or if a box or wall is empty.
  [[nodiscard]] static std::optional<Matter> of(const scene::CellScene& scene);

  [[nodiscard]] const std::vector<std::int32_t>& grid(std::size_t axis) const { return grid_[axis]; }
  [[nodiscard]] int units(std::size_t axis) const { return static_cast<int>(grid_[axis].size()) - 1; }

  [[nodiscard]] bool solid(const std::array<int, 3>& unit) const;
  // Whether the face of `unit` on its low side of `axis` is opaque: it is a wall, or a unit on either side is solid.
  [[nodiscard]] bool opaque_face(std::size_t axis, const std::array<int, 3>& unit) const;

  // All real lines, by axis, then in the order of the grid.
  [[nodiscard]] std::vector<RealLine> real_lines() const;

 private:
  [[nodiscard]] std::size_t index(const std::array<int, 3>& unit) const;
  [[nodiscard]] std::array<int, 2> units_within(std::size_t axis, geometry::Span span) const;
  void fill(const geometry::Box& solid);
  void cover(const geometry::Rectangle& wall);
  [[nodiscard]] std::array<bool, 4> features(std::size_t axis, const std::array<int, 3>& edge) const;

  std::array<std::vector<std::int32_t>, 3> grid_;
  std::vector<bool> solid_;                  // by unit
  std::array<std::vector<bool>, 3> walled_;  // by axis: the low face of each unit
};

}  // namespace sightline::algorithms::oracle
