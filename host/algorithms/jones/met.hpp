// What a view has met of a complex, without clearing anything between views, which would cost as much as the
// complex is large: an entry counts if it bears the view's number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

struct Met {
  struct Opening {
    std::uint32_t view = 0;
    std::uint32_t first_plane = 0;  // 0 if its planes of sight are not worked out yet
    int eye_side = 0;               // of its plane
  };

  explicit Met(const scene::CellComplex& complex)
      : openings(complex.openings.size()), cells(complex.cells.size()) {}

  void begin_view() {
    if (view == std::numeric_limits<std::uint32_t>::max()) {
      std::fill(openings.begin(), openings.end(), Opening{});
      std::fill(cells.begin(), cells.end(), 0U);
      view = 0;
    }
    ++view;
  }

  std::uint32_t view = 0;
  std::vector<Opening> openings;
  std::vector<std::uint32_t> cells;
};

}  // namespace sightline::algorithms::jones
