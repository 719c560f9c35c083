// The picture of an error atlas: two plans of the scene side by side, x to the right and z, the program's direction
// of view, upwards. Every eye is a mark. Its colour shows the wrong length of its view on the left plan, and the
// PDP-7's time on the right one. Below are the colour scales and the clusters of wrong views.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/compare/atlas.hpp"
#include "host/picture/image.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

// "parallel to y at x = 800, z = 3000".
[[nodiscard]] std::string text_of(const AxisLine& line);

struct AtlasCaption {
  std::string title;  // what was run
  std::string eyes;   // which eyes, and their direction of view
};

// `lattice`: the arrangement of the eyes, if they are those of lattice_eyes. At least one view is free
// (precondition).
[[nodiscard]] picture::Image atlas_picture(const scene::CellScene& scene, const std::vector<AtlasView>& views,
                                           const AtlasSummary& summary,
                                           const std::optional<AtlasLattice>& lattice,
                                           const AtlasCaption& caption);

}  // namespace sightline::compare
