// Every adjustable method of a scene with each of its settings, one view each: what answer_plot.hpp draws.
//
// Jones's program on the PDP-7 has 0 to 3 fraction bits, with the EAE and without; its twin the same bits on this computer.
// Montani and Re's stripes have thicknesses; Plantinga's events an angle within which they are joined, in parallel projection;
// Skala's program has devices. Beside them stand the methods without a setting, of which the exact ones are at error 0.
//
// Errors are the wrong shares of the table (answer.hpp). Of Plantinga's events they are means over a turn, of the length that is
// truly seen, and the time is that of a frame of the turn.
#pragma once

#include <string_view>
#include <vector>

#include "host/compare/answer_plot.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::compare {

// Beside a comparison of the scene, of its view and its methods: what was left out there has no points here. Of the options the
// scale and whether times of this computer are measured, without which there are no points of this computer.
[[nodiscard]] std::vector<PlotPoint> variants_of(
    const scene::CellScene& scene, const CompareOptions& options, const SceneComparison& comparison,
    const CompareProgress& progress = [](std::string_view) {});
[[nodiscard]] std::vector<PlotPoint> variants_of(
    const scene::PolyScene& scene, const CompareOptions& options, const SceneComparison& comparison,
    const CompareProgress& progress = [](std::string_view) {});
// Of a function all is in its comparison, if it has the devices.
[[nodiscard]] std::vector<PlotPoint> variants_of(const HeightComparison& comparison);

}  // namespace sightline::compare
