// A mask: the convex cone of directions in which a cell is seen, as the cyclic list of its sides.
//
// Each side is the number of a plane of sight; each corner is the ray in which two consecutive planes cross. A corner
// made by clipping is again the crossing of two planes of sight, so numbers never grow longer than in the first mask. The
// sides are ordered so that the cross product of one plane's image and the next is the ray of their corner, not its
// opposite.
//
// A mask has an area: clipping it to a polygon that only touches a side or a corner leaves an empty mask. A plane along
// one of its sides changes nothing, so collinear sides do not accumulate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sightline::algorithms::jones {

template <class Arithmetic>
struct MaskSide {
  std::uint32_t plane = 0;          // number of the plane of sight
  typename Arithmetic::Ray corner;  // with the next side
};

// Like clip_mask, for a mask with corners on both sides of `line`; their signs are given.
template <class Arithmetic, class Image>
std::span<const MaskSide<Arithmetic>> cut_mask(std::span<const MaskSide<Arithmetic>> mask,
                                               std::uint32_t plane, const typename Arithmetic::Line& line,
                                               const Image& image, std::span<const std::int8_t> signs,
                                               std::vector<MaskSide<Arithmetic>>& left) {
  const std::size_t count = mask.size();
  // A side is replaced by two at most. (By only one if the mask is convex; but complexes come from files.)
  if (left.size() < 2 * count) left.resize(2 * count);
  std::size_t kept = 0;
  std::int8_t before = signs[count - 1];
  for (std::size_t i = 0; i < count; ++i) {
    const std::int8_t here = signs[i];
    if (before > 0 && here <= 0) {
      left[kept++] = {mask[i].plane, Arithmetic::meet(image(mask[i].plane), line)};
      left[kept++].plane = plane;
    } else if (before > 0 || here > 0) {
      left[kept++] = mask[i];
    }
    before = here;
  }
  for (std::size_t i = 0; i < kept; ++i) {
    if (left[i].plane != plane) continue;
    const MaskSide<Arithmetic>& next = left[i + 1 == kept ? 0 : i + 1];
    left[i].corner = Arithmetic::meet(line, image(next.plane));
  }
  return {left.data(), kept};
}

// The part of a mask on the nonnegative side of `line`, perhaps empty. Returns the mask itself if nothing is cut off;
// otherwise the result is in `left`, which only grows, so that a clip costs no more than it writes. `image(n)` returns
// the image of plane n; `line` is the image of `plane`.
template <class Arithmetic, class Image>
inline std::span<const MaskSide<Arithmetic>> clip_mask(std::span<const MaskSide<Arithmetic>> mask,
                                                       std::uint32_t plane,
                                                       const typename Arithmetic::Line& line,
                                                       const Image& image, std::vector<std::int8_t>& signs,
                                                       std::vector<MaskSide<Arithmetic>>& left) {
  const std::size_t count = mask.size();
  if (signs.size() < count) signs.resize(count);
  unsigned inside = 0;
  unsigned outside = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int sign = Arithmetic::side(line, mask[i].corner);
    signs[i] = static_cast<std::int8_t>(sign);
    inside |= static_cast<unsigned>(sign > 0);
    outside |= static_cast<unsigned>(sign < 0);
  }
  if (inside == 0) return {};
  if (outside == 0) return mask;
  return cut_mask<Arithmetic>(mask, plane, line, image, signs, left);
}

}  // namespace sightline::algorithms::jones
