#include "host/programs/jones/specification.hpp"

namespace sightline::programs::jones {

std::string_view name(Status status) {
  switch (status) {
    case Status::complete: return "complete";
    case Status::stack_overflow: return "stack overflow";
    case Status::display_file_overflow: return "display file overflow";
    case Status::arithmetic_overflow: return "arithmetic overflow";
    case Status::too_many_mask_vertices: return "too many mask vertices";
    case Status::deeper_than_cells: return "deeper than the number of cells";
    case Status::bad_data_element: return "bad data element";
    case Status::unfinished: return "unfinished: the search goes on";
  }
  return "unknown status";
}

Window window_of(Pass pass, std::int32_t scale, int fraction_bits, int word_bits) {
  const std::int32_t unit = std::int32_t{1} << fraction_bits;
  Window window;
  window.xlo = window.ylo = -512 * unit;
  window.xhi = window.yhi = 511 * unit;
  window.width_scale = scale * unit;
  if (pass != Pass::mono) {
    window.width_scale = (scale >> 1) * unit;
    window.xlo = -256 * unit;
    window.xhi = 255 * unit;
    window.centre_x = pass == Pass::left ? 256 : 768;
  }
  while (window.bound_factor * window.width_scale < 1024 * unit) window.bound_factor *= 2;
  const std::int64_t farthest = std::int64_t{window.bound_factor} * window.width_scale;
  if (farthest > std::int64_t{1} << (word_bits - 3)) window.bound_factor = 1;
  return window;
}

}  // namespace sightline::programs::jones
