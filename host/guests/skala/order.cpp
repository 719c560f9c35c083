#include "host/guests/skala/order.hpp"

#include <cmath>

namespace sightline::guests::skala {

Family less_end_on(SineCosine rotation) {
  return std::abs(rotation.cosine) >= std::abs(rotation.sine) ? Family::along_x : Family::along_z;
}

DrawingOrder slice_order(const Projection& projection, Family family) {
  const auto [sine, cosine] = projection.rotation();
  DrawingOrder order;
  if (family == Family::along_x) {
    order.rows = projection.slices();
    order.columns = projection.points();
    order.rows_reversed = cosine < 0;
    order.columns_reversed = cosine < 0;
    order.row_shift = cosine < 0 ? -sine : sine;
    order.column_shift = std::abs(cosine);
    return order;
  }
  order.row_is_slice = false;
  order.rows = projection.points();
  order.columns = projection.slices();
  order.rows_reversed = sine > 0;
  order.columns_reversed = sine < 0;
  order.row_shift = sine > 0 ? -cosine : cosine;
  order.column_shift = std::abs(sine);
  return order;
}

DrawingOrder cell_order(const Projection& projection) {
  const auto [sine, cosine] = projection.rotation();
  DrawingOrder order = slice_order(projection, Family::along_x);
  order.columns_reversed = sine > 0;
  order.column_shift = sine > 0 ? -cosine : cosine;
  return order;
}

}  // namespace sightline::guests::skala
