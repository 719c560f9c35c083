// Native Jones compared with `exact` by ==, on the 500 generated scenes with automatic cell decomposition: by the grid where
// faces
// are axis-parallel, and by the BSP, in turn. Each from 20 cameras: outside, orthographic, and among the bodies; bricks have such
// small coordinates that most eyes are in planes of faces and in line with edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"
#include "tests/host/scene/generate/generated_set.hpp"

namespace sightline::algorithms {
namespace {

// `exact` requires an eye that is on no face. This test rejects any eye in the plane and within the bounds of a face.
bool on_a_face(const scene::PolyScene& scene, const scene::PolyPoint& eye) {
  const auto has_eye = [&](const scene::PolyFace& face) {
    const auto& ring = face.outline;
    geometry::Box box{scene.vertices[ring[0]], scene.vertices[ring[0]]};
    geometry::Vector3 normal{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const scene::PolyPoint& v = scene.vertices[ring[i]];
      for (std::size_t a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], v[a]);
        box.high[a] = std::max(box.high[a], v[a]);
      }
      if (i < 2) continue;
      const auto part = geometry::normal_of(scene.vertices[ring[0]], scene.vertices[ring[i - 1]], v);
      for (std::size_t a = 0; a < 3; ++a) normal[a] += part[a];
    }
    return box.contains(eye) &&
           geometry::dot(normal, geometry::difference(eye, scene.vertices[ring[0]])) == 0;
  };
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const scene::PolyBody& body) {
    return std::any_of(body.faces.begin(), body.faces.end(), has_eye);
  });
}

class GeneratedSet : public testing::TestWithParam<std::string_view> {
 protected:
  int compared_ = 0;

  // Draws views of the complexes in turn.
  void expect_exact(const scene::PolyScene& scene, const std::vector<scene::CellComplex>& complexes,
                    std::uint32_t seed, const std::string& where) {
    std::vector<jones::PreparedComplex> prepared(complexes.begin(), complexes.end());
    std::vector<jones::Walker> walkers(prepared.begin(), prepared.end());
    std::size_t turn = seed;
    const auto next = [&](const scene::PolyCamera& camera) {
      const std::size_t which = turn++ % walkers.size();
      return compare(walkers[which], scene, camera, where + (which == 0 ? " bsp" : " grid"));
    };
    RandomCameras cameras(scene, seed);
    next(scene.camera);
    for (int i = 0; i < 7; ++i) {
      next(cameras.outside(true));
      next(cameras.outside(false));
    }
    for (int left = 5, tries = 0; left > 0 && tries < 200; ++tries) {
      const scene::PolyCamera camera = cameras.inside(1 << 20);
      if (!on_a_face(scene, camera.eye) && next(camera)) --left;
    }
  }

  // False if the eye is in a solid.
  bool compare(jones::Walker& walker, const scene::PolyScene& scene, const scene::PolyCamera& camera,
               const std::string& where) {
    const auto result = walker.visible_edges(camera);
    const std::string what = where + (camera.perspective ? " perspective eye " : " orthographic eye ") +
                             testing::PrintToString(camera.eye) + " forward " +
                             testing::PrintToString(camera.forward);
    if (!result) {
      EXPECT_EQ(result.error(), base::bad_input(jones::eye_in_solid)) << what;
      return false;
    }
    ++compared_;
    const picture::LinePicture exact = exact::visible_edges(scene, camera);
    const picture::LinePicture& seen = result->picture;
    EXPECT_TRUE(seen == exact) << what << ": " << seen.pieces.size() << " pieces, exact "
                               << exact.pieces.size();
    return true;
  }
};

TEST_P(GeneratedSet, EqualsExactAfterAutomaticDecomposition) {
  for (const scene::GeneratedSceneName& name : scene::generated_set()) {
    if (name.family != GetParam()) continue;
    const auto scene = *scene::generate_scene(name.family, name.size, name.seed);
    const std::string where =
        std::string(name.family) + ' ' + std::to_string(name.size) + " seed " + std::to_string(name.seed);
    const auto seed = static_cast<std::uint32_t>(name.seed);
    std::vector<scene::CellComplex> complexes{*scene::decompose_bsp(scene)};
    if (!scene::why_no_grid(scene)) complexes.push_back(*scene::decompose_grid(scene));
    expect_exact(scene, complexes, seed, where);
    if (HasFailure()) return;
  }
  EXPECT_GE(compared_, 1900);
}

std::string family_name(const testing::TestParamInfo<std::string_view>& info) {
  return std::string(info.param);
}

INSTANTIATE_TEST_SUITE_P(Families, GeneratedSet,
                         testing::Values("boxes", "town", "triangles", "bricks", "rooms"), family_name);

}  // namespace
}  // namespace sightline::algorithms
