// What `sightline scene info` says: of scenes of cells, of polyhedra, and of files of cells cut by program.
#pragma once

#include <cstddef>
#include <string_view>

#include "host/app/commands/scene_poly.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::app {

// To standard output, as lines or as one JSON document. Failure bad_input: what is wrong with the scene.
void describe_scene_text(const SceneText& file, bool json);

// Openings through which the cells are entered from outside.
[[nodiscard]] std::size_t openings_outside(const scene::CellComplex& complex);
// "grid" or "bsp"
[[nodiscard]] std::string_view method_name(scene::CompartmentMethod method);

}  // namespace sightline::app
