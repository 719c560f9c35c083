// The output of `sightline compare` for one view, except the table (answer_output.hpp): text, JSON and overlays.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::app {

// The line above the table: scene, view and visible length.
[[nodiscard]] std::string compare_heading(const compare::SceneComparison& comparison);
[[nodiscard]] std::string compare_heading(const std::string& name, const compare::HeightComparison& comparison);
// The lines below the table: points that devices lit, checks of the programs. `rows`: the rows of the table.
[[nodiscard]] std::string compare_notes(const compare::SceneComparison& comparison);
[[nodiscard]] std::string compare_notes(const compare::HeightComparison& comparison, const std::vector<compare::MethodView>& rows);

[[nodiscard]] base::Json compare_json(const compare::SceneComparison& comparison);
[[nodiscard]] base::Json compare_json(const std::string& name, const compare::HeightComparison& comparison);

// Writes DIRECTORY/NAME-compare-PICTURE.png and .svg for every picture that differs from the reference (with `all`, for every
// picture), and NAME-compare-MACHINE_points.png, which compares the points that a device lit with those of exact lines. Creates
// the directory. Returns the paths. Error io.
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::SceneComparison& comparison, bool all);
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::HeightComparison& comparison, bool all);

}  // namespace sightline::app
