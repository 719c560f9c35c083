// A mask: the convex cone of directions in which a cell is seen, as the cyclic list of its sides.
//
// Each side is a plane of sight, kept as its number; each corner the ray in which two such planes, one after
// the other, cross. A corner made by clipping is again where two planes of sight cross, so whatever has been
// clipped before, no number is longer than in the first mask. The sides go round so that the cross product of
// one plane's image and the next is the ray of their corner and not its opposite.
//
// A mask has an area: clipping to a polygon that only touches a side or corner leaves it empty. A plane along one of its
// sides changes nothing, so sides in one line do not pile up.
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

// As clip_mask, of a mask with corners on both sides of `line`, whose signs are given.
template <class Arithmetic, class Image>
std::span<const MaskSide<Arithmetic>> cut_mask(std::span<const MaskSide<Arithmetic>> mask,
                                               std::uint32_t plane, const typename Arithmetic::Line& line,
                                               const Image& image, std::span<const std::int8_t> signs,
                                               std::vector<MaskSide<Arithmetic>>& left) {
  const std::size_t count = mask.size();
  // A side gives way to two at most. (Of a mask that is convex only one does; but complexes come from files.)
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

// What is left of a mask on the not negative side of `line`, perhaps nothing. It is the mask itself if
// nothing is cut off, and else lies in `left`, which only grows, so that no clip costs more than it writes;
// `image` gives the image of the plane with a number, which `line` is for `plane`.
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
