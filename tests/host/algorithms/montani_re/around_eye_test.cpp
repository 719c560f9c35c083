// Perspective from among the faces: faces that extend from in front of the eye to behind it, compared with `exact`.
#include <gtest/gtest.h>

#include <string_view>

#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "tests/host/algorithms/montani_re/agreement.hpp"

namespace sightline::algorithms::montani_re {
namespace {

struct Inside {
  Agreement agreement;
  int past_eye = 0;
};

Inside compare_inside(const scene::PolyScene& scene, int views) {
  Inside result;
  RandomCameras cameras(scene, 77);
  while (result.agreement.views < views) {
    const scene::PolyCamera camera = cameras.inside(1 << 20);
    if (scene::eye_error(scene, camera)) continue;
    if (face_past_eye(scene, camera)) ++result.past_eye;
    compare_view(scene, camera, result.agreement);
  }
  return result;
}

TEST(MontaniReAroundEye, GeneratedScenes) {
  for (const auto& [family, size] : std::initializer_list<std::pair<std::string_view, std::size_t>>{
           {"boxes", 60}, {"town", 16}, {"triangles", 60}, {"bricks", 20}, {"rooms", 6}, {"corridors", 6}}) {
    const auto scene = *scene::generate_scene(family, size, 3);
    const Inside result = compare_inside(scene, 12);
    EXPECT_EQ(result.agreement.first_wrong, "") << family;
    EXPECT_GT(result.past_eye, 5) << family;
  }
}

// The eye is in a room whose walls end on each other.
TEST(MontaniReAroundEye, CellScenes) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const auto cells = scene::load_cell_scene(std::string(name));
    const scene::PolyScene scene = scene::poly_scene_of(*cells);
    Agreement agreement;
    compare_view(scene, scene.camera, agreement);
    EXPECT_EQ(agreement.first_wrong, "") << name;
    EXPECT_EQ(compare_inside(scene, 12).agreement.first_wrong, "") << name;
  }
}

// A room of one box turned inside out, its walls parallel to the camera's axes: edges pass the eye on borders of the pyramids and
// inside them.
TEST(MontaniReAroundEye, WallsInLineWithThePyramids) {
  scene::PolyScene scene;
  scene.name = "room";
  constexpr std::int32_t r = 10;
  add_sheet(scene, {{-r, -r, -r}, {r, -r, -r}, {r, -r, r}, {-r, -r, r}});
  add_sheet(scene, {{-r, -r, r}, {r, -r, r}, {r, r, r}, {-r, r, r}},
            {{-5, -5, r}, {-5, 5, r}, {5, 5, r}, {5, -5, r}});
  add_sheet(scene, {{-r, -r, -r}, {-r, -r, r}, {-r, r, r}, {-r, r, -r}});
  add_sheet(scene, {{r, -r, -r}, {r, r, -r}, {r, r, r}, {r, -r, r}},
            {{r, -2, -2}, {r, -2, 2}, {r, 2, 2}, {r, 2, -2}});
  add_sheet(scene, {{-30, -30, 20}, {30, -30, 20}, {30, 30, 40}, {-30, 30, 40}});
  add_sheet(scene, {{4, 4, 0}, {6, 4, 0}, {6, 6, 0}, {4, 6, 0}});
  for (const scene::PolyPoint& eye :
       {scene::PolyPoint{0, 0, 1}, {1, 2, 4}, {-3, 4, 6}, {5, 5, 8}, {4, 0, 1}}) {
    for (const scene::PolyPoint& forward :
         {scene::PolyPoint{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 0, -1}, {1, 0, 1}}) {
      const scene::PolyCamera camera{true, eye, forward, {forward[2], 0, -forward[0]}, {0, 1, 0}};
      Agreement agreement;
      compare_view(scene, camera, agreement);
      EXPECT_EQ(agreement.first_wrong, "") << eye[0] << ' ' << forward[0] << ' ' << forward[2];
    }
  }
}

TEST(MontaniReAroundEye, ErrorsNameTheFaces) {
  scene::PolyScene scene = scene::generate_rooms(2);
  scene.camera = {true, {500, 500, 300}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto set = faces_of(scene, scene.camera);
  ASSERT_FALSE(set);
  EXPECT_NE(set.error().found.find("of body 0 is partly in front of and partly behind the eye"), std::string::npos);
  Agreement agreement;
  compare_view(scene, scene.camera, agreement);
  EXPECT_EQ(agreement.first_wrong, "");
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
