// Hatching: faces are shaded by parallel lines on the paper, which are denser where less light falls on the face.
//
// The lines of a direction are at whole multiples of the spacing from one corner of the window, so they continue from
// face to face. As the angle to the light grows, a face takes every fourth line, every second or all; the darkest faces
// take all, and every second line across. Only the plane through the eye and such a line is rounded, once, to a normal of
// 38 bits; where it cuts a face, and which parts are visible, is exact.
// Not modelled: shadows that bodies cast.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_union.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

struct HatchOptions {
  double angle = 45;                // degrees on the paper, counterclockwise from the horizontal
  double spacing = 1;               // distance of the densest lines, in units of the drawing
  std::array<double, 3> light{};    // towards the light, of any length except 0, in the axes of the scene
  bool shade = true;                // hatch faces by their light; otherwise only the cut faces of a section
  // Faces of this material and of higher ones are cut by a section. They have lines at 45 degrees, those of the next material at 135 degrees.
  std::optional<std::uint32_t> cut_material = {};
  double cut_spacing = 2;           // distance of these lines, in units of the drawing
};

// The tone of a face: which lines it takes, according to the light that it loses by its direction.
enum class Tone : std::uint8_t { light, fourth, half, full, crossed };
// `facing`: the cosine of the angle between the normal, turned to the eye, and the direction of the light.
[[nodiscard]] Tone tone_of(double facing);

// Lines of one direction are parallel.
enum class HatchDirection : std::uint8_t { along, across, cut, cut_across };

struct Hatching {
  scene::PolyScene scene;           // the given scene, with the lines appended to its crossings
  ChosenEdges lines;                // all added lines, ascending
  std::vector<HatchDirection> directions;  // by line
};

// The layer kinds of the visible parts of these lines, by direction.
inline constexpr std::array<std::string_view, 4> hatching_kinds{"hatching", "cross-hatching", "section", "section-across"};

inline constexpr std::size_t most_hatch_lines = 2'000'000;

// Hatches faces that are turned to the eye, and sheets. `units` is the number of units of the drawing per unit of the
// image. Error: there would be more than most_hatch_lines lines.
[[nodiscard]] base::Result<Hatching> hatch(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                             const ImageWindow& window, double units,
                                             const HatchOptions& options);

// Removes hatching that lies on a visible line of another layer: an edge in the direction of the hatching may coincide
// with one of its lines up to rounding (a millionth of the window). Then removes the parts of hidden lines that lie on
// the remaining hatching.
void leave_out_hatching_on_lines(UnitedLines& lines, std::span<const LineLayer> layers, const ImageWindow& window);

}  // namespace sightline::picture
