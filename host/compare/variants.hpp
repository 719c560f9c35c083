// Every adjustable method of a scene with each of its settings, one view each: the input of answer_plot.hpp.
//
// Jones's program on the PDP-7 has 0 to 3 fraction bits, with and without the EAE; its twin has the same bits on this
// computer. Montani and Re's stripes have thicknesses; Plantinga's events have an angle within which they are joined,
// in parallel projection; Skala's program has devices. Methods without a setting are added; exact ones are at error
// 0.
//
// Errors are the wrong shares of the table (answer.hpp). For Plantinga's events they are means over a turn, in per
// cent of the visible length, and the time is that of a frame of the turn.
#pragma once

#include <string_view>
#include <vector>

#include "host/compare/answer_plot.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::compare {

// Extends a comparison of the scene by its variants, for the same view and methods. `options` gives the scale and
// whether times of this computer are measured; without them there are no points of this computer.
[[nodiscard]] std::vector<PlotPoint> variants_of(
    const scene::CellScene& scene, const CompareOptions& options, const SceneComparison& comparison,
    const CompareProgress& progress = [](std::string_view) {});
[[nodiscard]] std::vector<PlotPoint> variants_of(
    const scene::PolyScene& scene, const CompareOptions& options, const SceneComparison& comparison,
    const CompareProgress& progress = [](std::string_view) {});
// For a function, everything is in its comparison, if that has the devices.
[[nodiscard]] std::vector<PlotPoint> variants_of(const HeightComparison& comparison);

}  // namespace sightline::compare
