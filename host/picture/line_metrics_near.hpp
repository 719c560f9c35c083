// Finds the segment nearest to a point of the screen: segments are sorted into squares, which are searched outwards from
// the point's own square.
#pragma once

#include <cstdint>
#include <vector>

#include "host/picture/line_metrics.hpp"

namespace sightline::picture {

class NearestSegment {
 public:
  // Precondition: the segments are finite.
  explicit NearestSegment(const std::vector<PixelSegment>& segments);

  // The distance to the nearest point of any segment; infinite if there are none.
  [[nodiscard]] double distance(const PixelPoint& point) const {
    std::uint32_t any = 0;
    return distance(point, any);
  }
  // The same. `nearest` is a segment that is probably near, such as that of the previous point, and is set to the
  // nearest.
  [[nodiscard]] double distance(const PixelPoint& point, std::uint32_t& nearest) const;

 private:
  [[nodiscard]] int column_of(double x) const;
  [[nodiscard]] int row_of(double y) const;
  template <class Visit>
  void for_squares(const PixelSegment& segment, Visit&& visit) const;

  struct Found {
    std::uint32_t segment;
    double square_of_distance;
  };
  void look(int column, int row, const PixelPoint& point, Found& found) const;

  std::vector<PixelSegment> segments_;
  PixelPoint low_;
  double side_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;  // by square: start in entries_, and the end of the last
  std::vector<std::uint32_t> entries_;
};

}  // namespace sightline::picture
