// Finds the cells that contain a point: a grid of buckets over the outer box, each with the cells that may reach into it.
// It is built once for a complex; a query reads one bucket, whatever the number of cells.
//
// A cell is represented by its enclosing box (enclosing_box.hpp), which is exact for cells parallel to the axes and never
// too small for others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

// Whether a point is in a closed half-space.
[[nodiscard]] inline bool contains(std::span<const geometry::Plane> planes, const scene::HalfSpace& half,
                                   const geometry::Point3& point) {
  const std::int64_t value = planes[half.plane].at(point);
  return half.turned ? value >= 0 : value <= 0;
}

class CellIndex {
 public:
  // Linear time and memory. `planes` are those of the complex; each may be divided by a factor.
  CellIndex(const scene::CellComplex& complex, std::span<const geometry::Plane> planes);

  // The cells whose closure contains the point, ascending.
  [[nodiscard]] std::vector<scene::CellNumber> cells_at(const scene::CellComplex& complex,
                                                        std::span<const geometry::Plane> planes,
                                                        const geometry::Point3& point) const;

 private:
  [[nodiscard]] std::size_t bucket(std::size_t axis, std::int32_t coordinate) const;
  [[nodiscard]] std::size_t number_of(const std::array<std::size_t, 3>& at) const {
    return (at[2] * buckets_[1] + at[1]) * buckets_[0] + at[0];
  }
  template <class Do>
  void for_each_bucket(const geometry::Box& box, const Do& act) const;
  void choose_buckets(const std::vector<geometry::Box>& boxes);

  geometry::Box outer_;
  std::array<std::size_t, 3> buckets_{1, 1, 1};
  std::vector<std::uint32_t> starts_;
  std::vector<scene::CellNumber> entries_;
};

}  // namespace sightline::algorithms::jones
