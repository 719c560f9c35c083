// What `sightline compare` says of a comparison: a table for people, a JSON value for programs, and overlays.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::app {

[[nodiscard]] std::string compare_table(const compare::SceneComparison& comparison);
[[nodiscard]] std::string compare_table(const std::string& name, const compare::HeightComparison& comparison);

[[nodiscard]] base::Json compare_json(const compare::SceneComparison& comparison);
[[nodiscard]] base::Json compare_json(const std::string& name, const compare::HeightComparison& comparison);

// DIRECTORY/NAME-compare-PICTURE.png and .svg for every picture; the directory is made. Returns the paths.
// Failure io.
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::SceneComparison& comparison);
std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const compare::HeightComparison& comparison);

}  // namespace sightline::app
