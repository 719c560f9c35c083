// The six views a scene from which Jones's program is measured: the scene's own view, and five near it.
//
// The five are those of the prototype that first measured the errors of 18-bit arithmetic: x and y up to 30
// units from the scene's own eye, drawn at random once and written down here; z unchanged. The scale is 512.
#pragma once

#include <array>
#include <string_view>

#include "host/geometry/box.hpp"

namespace sightline::guests::jones {

struct SixViews {
  std::string_view scene;  // a built-in scene
  std::array<geometry::Point, 6> eyes;
};

inline constexpr std::array<SixViews, 4> six_views{{
    {"house",
     {{{480, 160, 20}, {470, 190, 20}, {475, 171, 20}, {454, 182, 20}, {456, 153, 20}, {453, 188, 20}}}},
    {"roberts", {{{30, 150, 40}, {13, 122, 40}, {27, 146, 40}, {15, 125, 40}, {27, 123, 40}, {36, 127, 40}}}},
    {"street4", {{{37, 160, 20}, {21, 170, 20}, {44, 190, 20}, {43, 167, 20}, {10, 144, 20}, {42, 184, 20}}}},
    {"corridor8",
     {{{140, 150, 30}, {128, 146, 30}, {144, 127, 30}, {129, 155, 30}, {153, 131, 30}, {147, 156, 30}}}},
}};

}  // namespace sightline::guests::jones
