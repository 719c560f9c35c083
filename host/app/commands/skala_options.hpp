// The options that say which function of two variables is drawn and how it is looked at: the same ones in
// `sightline skala`, `draw skala` and `compare`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/app/command_line.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/algorithms/skala/view.hpp"

namespace sightline::app {

// How finely a function is sampled unless the options say so: as in the figures of the paper.
[[nodiscard]] constexpr scene::GridSize usual_grid_size(algorithms::skala::Subject picture) {
  return picture == algorithms::skala::Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
}

// --function, --domain, --x-range, --y-range, --xyz, --slices and --points. `slices` and `points` are what help says is usual.
void add_function_options(const Command& command, SkalaSource& source, const std::string& slices,
                          const std::string& points);

// --rotate and --elevate. The defaults are those the angles have.
void add_angle_options(const Command& command, double& rotation, double& elevation);
// Error usage: an angle that is no number.
void require_angles(double rotation, double elevation);

// --both and --along, which exclude each other.
struct SkalaSlices {
  bool both = false;
  std::string along;  // "x" or "z"; empty: the less end-on
};
void add_slices_options(const Command& command, SkalaSlices& slices);
[[nodiscard]] algorithms::skala::Family family_of(const SkalaSlices& slices);

// "lines", "surface" or "contours"
[[nodiscard]] std::string_view picture_name(algorithms::skala::Subject picture);

// --picture: "lines", "surface" or "contours"; empty: not given, lines.
void add_picture_option(const Command& command, std::string& picture, const std::string& help);

// --levels; the second without a default of its own.
void add_levels_option(const Command& command, int& levels);
void add_levels_option(const Command& command, std::optional<int>& levels);

}  // namespace sightline::app
