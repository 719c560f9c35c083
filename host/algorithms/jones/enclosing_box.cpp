#include "host/algorithms/jones/enclosing_box.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::jones {
namespace {

using geometry::Box;
using geometry::Int128;

// The least integer not below a / b; b is positive.
Int128 ceiling_divide(const Int128& a, const Int128& b) {
  return a >= 0 ? (a + b - 1) / b : -(-a / b);
}

// Shrinks the box by the part that is certainly not in the half-space normal . x <= offset. Returns true if the box
// changed.
bool tighten(Box& box, const geometry::Vector3& normal, std::int64_t offset) {
  Int128 least = 0;  // of normal . x in the box
  for (std::size_t a = 0; a < 3; ++a) least += Int128{normal[a]} * (normal[a] > 0 ? box.low[a] : box.high[a]);
  bool changed = false;
  for (std::size_t a = 0; a < 3; ++a) {
    if (normal[a] == 0) continue;
    const std::int32_t near = normal[a] > 0 ? box.low[a] : box.high[a];
    const Int128 room = offset - (least - Int128{normal[a]} * near);  // normal[a] x <= room
    if (normal[a] > 0) {
      const Int128 most = ceiling_divide(room, normal[a]);
      if (most >= box.high[a]) continue;
      box.high[a] = most < box.low[a] ? box.low[a] - 1 : static_cast<std::int32_t>(most);
    } else {
      const Int128 fewest = -ceiling_divide(room, -normal[a]);
      if (fewest <= box.low[a]) continue;
      box.low[a] = fewest > box.high[a] ? box.high[a] + 1 : static_cast<std::int32_t>(fewest);
    }
    if (box.low[a] > box.high[a]) return false;
    changed = true;
  }
  return changed;
}

}  // namespace

Box enclosing_box(Box box, std::span<const geometry::Plane> planes,
                  std::span<const scene::HalfSpace> halves) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    for (const scene::HalfSpace& half : halves) {
      const geometry::Plane& plane = planes[half.plane];
      const geometry::Vector3 normal = half.turned ? geometry::negated(plane.normal) : plane.normal;
      changed = tighten(box, normal, half.turned ? -plane.offset : plane.offset) || changed;
      if (is_empty(box)) return box;
    }
    if (!changed) break;
  }
  return box;
}

}  // namespace sightline::algorithms::jones
