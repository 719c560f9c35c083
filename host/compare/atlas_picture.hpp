// The picture of an error atlas: two plans of the scene beside each other, x to the right and z, the way the
// program looks, upwards. Every eye is a mark, coloured on the left by the length of what is wrong in its
// view, on the right by the time the PDP-7 took; below, what the colours mean and the clusters of wrong
// views.
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
  std::string eyes;   // which eyes, and how they look
};

// lattice: how the eyes lie, if they are those of lattice_eyes. At least one view is free.
[[nodiscard]] picture::Image atlas_picture(const scene::CellScene& scene, const std::vector<AtlasView>& views,
                                           const AtlasSummary& summary,
                                           const std::optional<AtlasLattice>& lattice,
                                           const AtlasCaption& caption);

}  // namespace sightline::compare
