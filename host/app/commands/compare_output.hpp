// What `sightline compare` says of one view beside the table (answer_output.hpp): for people, as a JSON value, and as overlays.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::app {

// What was compared, before the table.
[[nodiscard]] std::string compare_heading(const compare::SceneComparison& comparison);
[[nodiscard]] std::string compare_heading(const std::string& name, const compare::HeightComparison& comparison);
// Lines below the table: points that devices lit, checks of the programs. `rows`: those in the table.
[[nodiscard]] std::string compare_notes(const compare::SceneComparison& comparison);
[[nodiscard]] std::string compare_notes(const compare::HeightComparison& comparison, const std::vector<compare::MethodView>& rows);

[[nodiscard]] base::Json compare_json(const compare::SceneComparison& comparison);
[[nodiscard]] base::Json compare_json(const std::string& name, const compare::HeightComparison& comparison);

// DIRECTORY/NAME-compare-PICTURE.png and .svg for every picture that differs from the truth, or `all`, and NAME-compare-MACHINE_points.png, the points that a device lit
// beside those that exact lines light; the directory is made. Returns the paths.
// Error io.
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::SceneComparison& comparison, bool all);
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::HeightComparison& comparison, bool all);

}  // namespace sightline::app
