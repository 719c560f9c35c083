// What `sightline scene check` finds: of scenes of cells, of polyhedra, and of files of cells cut by program.
#pragma once

#include <vector>

#include "host/app/commands/scene_poly.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::app {

struct SceneFindings {
  std::vector<base::Error> errors;  // all that a check names; empty: a possible scene
  scene::PolyImportReport changes;  // while it was read
};

[[nodiscard]] SceneFindings check_scene_text(const SceneText& file);

}  // namespace sightline::app
