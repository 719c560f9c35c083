// Hatching: faces shaded by parallel lines on the paper, denser where less light falls on them, as one does with a pen.
//
// The lines of a direction lie at whole multiples of the spacing from one corner of the window, so that they go on from
// face to face. A face takes every fourth of them, every second or all, as the angle to the light grows, and where it is
// darkest all of them and every second across. Rounded is only the plane through the eye and such a line, once, to a
// normal of 38 bits; where it cuts a face, and what is seen of that, is exact.
// Left out: shadows that bodies cast.
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
  double angle = 45;                // degrees, counterclockwise from the horizontal of the paper
  double spacing = 1;               // of the densest lines, in units of the drawing
  std::array<double, 3> light{};    // towards the light, of any length but 0, in the axes of the scene
  bool shade = true;                // faces by their light; otherwise only those that a section cut
  // Faces of this material lie in the plane of a section: they take lines at 45 degrees, those of the second, fourth ... body at 135.
  std::optional<std::uint32_t> cut_material = {};
  double cut_spacing = 2;           // of these, in units of the drawing
};

// How dark a face is, by the share of light that its direction loses: which lines it takes.
enum class Tone : std::uint8_t { light, fourth, half, full, crossed };
// `facing`: the cosine of the angle between the normal, turned to the eye, and the direction of the light.
[[nodiscard]] Tone tone_of(double facing);

// Which lines are parallel to each other.
enum class HatchDirection : std::uint8_t { along, across, cut, cut_across };

struct Hatching {
  scene::PolyScene scene;           // with the lines as crossings behind its own
  ChosenEdges lines;                // all that were added, ascending
  std::vector<HatchDirection> directions;  // of each line
};

// Kinds of layers of what is seen of these lines, by direction.
inline constexpr std::array<std::string_view, 4> hatching_kinds{"hatching", "cross-hatching", "section", "section-across"};

inline constexpr std::size_t most_hatch_lines = 2'000'000;

// Of faces that are turned to the eye, and of sheets; for a drawing with this window, of `units` to one of the image.
// An error if there were more than most_hatch_lines.
[[nodiscard]] base::Result<Hatching> hatched(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                             const ImageWindow& window, double units,
                                             const HatchOptions& options);

// Takes from the hatching what lies on a visible line of another layer: an edge along the hatching may be one of its lines but for
// rounding, within a millionth of the window. Then takes from hidden lines what lies on the hatching that is left.
void leave_out_hatching_on_lines(UnitedLines& lines, std::span<const LineLayer> layers, const ImageWindow& window);

}  // namespace sightline::picture
