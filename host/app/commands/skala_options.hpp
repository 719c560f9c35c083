// The options for a function of two variables and its view, the same in `sightline skala`, `draw skala` and `compare`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/app/command_line.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/algorithms/skala/view.hpp"

namespace sightline::app {

// The default numbers of samples, those of the figures of the paper.
[[nodiscard]] constexpr scene::GridSize usual_grid_size(algorithms::skala::Subject picture) {
  return picture == algorithms::skala::Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
}

// Adds --function, --domain, --x-range, --y-range, --xyz, --layout, --slices and --points. `slices` and `points`: the defaults that
// the help shows.
void add_function_options(const Command& command, SkalaSource& source, const std::string& slices,
                          const std::string& points);

// Adds --rotate and --elevate; the defaults are the values of the variables.
void add_angle_options(const Command& command, double& rotation, double& elevation);
// Error usage: an angle is not finite.
void require_angles(double rotation, double elevation);

// The values of --both and --along, which exclude each other.
struct SkalaSlices {
  bool both = false;
  std::string along;  // "x" or "z"; empty: the family seen less end-on
};
void add_slices_options(const Command& command, SkalaSlices& slices);
[[nodiscard]] algorithms::skala::Family family_of(const SkalaSlices& slices);

// "lines", "surface" or "contours"
[[nodiscard]] std::string_view picture_name(algorithms::skala::Subject picture);

// Adds --picture: "lines", "surface" or "contours"; empty: not given, lines.
void add_picture_option(const Command& command, std::string& picture, const std::string& help);

// Adds --levels; the second function shows no default.
void add_levels_option(const Command& command, int& levels);
void add_levels_option(const Command& command, std::optional<int>& levels);

}  // namespace sightline::app
