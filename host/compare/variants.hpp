// Every adjustable method of a scene with each of its settings, one view each: what answer_plot.hpp draws.
//
// Jones's program on the PDP-7 has 0 to 3 fraction bits, with the EAE and without; its twin the same bits on this computer. Montani and
// Re's stripes have thicknesses; Plantinga's events an angle within which they are joined, in parallel projection; Skala's program has
// devices. Beside them stand the methods without a setting, of which the exact ones are at error 0.
//
// Errors are shares of what is truly seen: of the length of lines; of the points of the picture that show another face; of the dots of
// Skala's devices those that exact lines do not light by the program's own rule, and the other way round. Of Plantinga's events they
// are means over a turn, with the time of a frame.
#pragma once

#include <vector>

#include "host/base/result.hpp"
#include "host/compare/answer_plot.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::compare {

// Of the options the eye, the scale, the methods and whether times of this computer are measured: without them there are no points of
// this computer. Errors: those of compare_cell_scene.
[[nodiscard]] base::Result<std::vector<PlotPoint>> variants_of(
    const scene::CellScene& scene, const CompareOptions& options, const CompareProgress& progress = [](std::string_view) {});
// Errors: those of compare_poly_scene.
[[nodiscard]] base::Result<std::vector<PlotPoint>> variants_of(
    const scene::PolyScene& scene, const scene::PolyCamera& camera, const CompareOptions& options,
    const CompareProgress& progress = [](std::string_view) {});
// The grid and the view can be compared (why_not_comparable: precondition).
[[nodiscard]] std::vector<PlotPoint> variants_of(
    const scene::HeightGrid& grid, const guests::skala::View& view, bool host_times,
    const CompareProgress& progress = [](std::string_view) {});

}  // namespace sightline::compare
