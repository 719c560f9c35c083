// The built-in cell scenes as polyhedra: the same matter, the same eye.
#include "host/scene/model/poly_from_cells.hpp"

#include <gtest/gtest.h>

#include "host/base/result.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::scene {
namespace {

TEST(PolyFromCells, ConsistOfExactlyTheSolidsAndWalls) {
  for (const std::string_view name : builtin_scene_names()) {
    const auto loaded = load_cell_scene(std::string(name));
    const CellScene& cells = *loaded;
    const PolyScene scene = poly_scene_of(cells);
    for (const base::Error& error : check_poly_scene(scene)) ADD_FAILURE() << name << ": " << error.message();
    ASSERT_EQ(scene.bodies.size(), cells.solids.size() + (cells.walls.empty() ? 0U : 1U)) << name;
    for (std::size_t s = 0; s < cells.solids.size(); ++s) {
      EXPECT_TRUE(enclosed_volume(scene.vertices, scene.bodies[s]) == 6 * cells.solids[s].volume()) << name;
      EXPECT_FALSE(scene.bodies[s].sheet);
    }
    for (std::size_t w = 0; w < cells.walls.size(); ++w) {
      const geometry::Box bounds = cells.walls[w].bounds();
      const PolyFace& face = scene.bodies.back().faces[w];
      ASSERT_EQ(face.outline.size(), 4U);
      for (const VertexIndex v : face.outline) {
        for (std::size_t a = 0; a < 3; ++a) {
          const std::int32_t c = scene.vertices[v][a];
          EXPECT_TRUE(c == bounds.low[a] || c == bounds.high[a]) << name << " wall " << w;
        }
      }
    }
    EXPECT_EQ(scene.camera.eye, cells.default_view);
    EXPECT_EQ(scene.camera.forward, (PolyPoint{0, 0, 1}));
  }
}

}  // namespace
}  // namespace sightline::scene
