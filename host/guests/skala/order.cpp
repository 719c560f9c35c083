#include "host/guests/skala/order.hpp"

#include <cmath>

namespace sightline::harness {

SkalaFamily less_end_on(SineCosine rotation) {
  return std::abs(rotation.cosine) >= std::abs(rotation.sine) ? SkalaFamily::along_x : SkalaFamily::along_z;
}

SkalaOrder slice_order(const SkalaProjection& projection, SkalaFamily family) {
  const auto [sine, cosine] = projection.rotation();
  SkalaOrder order;
  if (family == SkalaFamily::along_x) {
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

SkalaOrder cell_order(const SkalaProjection& projection) {
  const auto [sine, cosine] = projection.rotation();
  SkalaOrder order = slice_order(projection, SkalaFamily::along_x);
  order.columns_reversed = sine > 0;
  order.column_shift = sine > 0 ? -cosine : cosine;
  return order;
}

}  // namespace sightline::harness
