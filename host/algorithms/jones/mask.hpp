// A mask: the convex cone of directions in which a cell is seen, as the cyclic list of its sides.
//
// Each side is a plane of sight, kept as its number; each corner the ray in which two such planes, one after
// the other, cross. A corner made by clipping is again where two planes of sight cross, so whatever has been
// clipped before, no number is longer than in the first mask. The sides go round so that the cross product of
// one plane's image and the next is the ray of their corner and not its opposite.
//
// A mask has an area: what touches it in a side or a corner only leaves nothing. A plane along one of its
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

enum class Cut : std::uint8_t { nothing, part, all };

// What is left of a mask on the not negative side of `line`. In `left` only if a part is cut off; `image`
// gives the image of the plane with a number, which `line` is for `plane`.
template <class Arithmetic, class Image>
Cut clip_mask(std::span<const MaskSide<Arithmetic>> mask, std::uint32_t plane,
              const typename Arithmetic::Line& line, const Image& image, std::vector<std::int8_t>& signs,
              std::vector<MaskSide<Arithmetic>>& left) {
  signs.clear();
  bool inside = false;
  bool outside = false;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const bool on = mask[i].plane == plane || mask[i + 1 == mask.size() ? 0 : i + 1].plane == plane;
    const int sign = on ? 0 : Arithmetic::side(line, mask[i].corner);
    signs.push_back(static_cast<std::int8_t>(sign));
    inside = inside || sign > 0;
    outside = outside || sign < 0;
  }
  if (!inside) return Cut::all;
  if (!outside) return Cut::nothing;
  left.clear();
  std::int8_t before = signs.back();
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const std::int8_t here = signs[i];
    if (before > 0 && here <= 0) {
      left.push_back({mask[i].plane, Arithmetic::meet(image(mask[i].plane), line)});
      left.push_back({plane, {}});
    } else if (before > 0 || here > 0) {
      left.push_back(mask[i]);
    }
    before = here;
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i].plane != plane) continue;
    const MaskSide<Arithmetic>& next = left[i + 1 == left.size() ? 0 : i + 1];
    left[i].corner = Arithmetic::meet(line, image(next.plane));
  }
  return Cut::part;
}

}  // namespace sightline::algorithms::jones
