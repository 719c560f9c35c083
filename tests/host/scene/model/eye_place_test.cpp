// The position of an eye relative to boxes whose inside is known, and cameras aimed in a direction.
#include "host/scene/model/eye_place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/generate/random.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {
namespace {

using Kind = EyePlace::Kind;

struct Range {
  PolyPoint low;
  PolyPoint high;
};

Kind place_in(const Range& box, const PolyPoint& p) {
  bool strictly = true;
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] < box.low[a] || p[a] > box.high[a]) return Kind::free;
    strictly = strictly && p[a] > box.low[a] && p[a] < box.high[a];
  }
  return strictly ? Kind::inside : Kind::on_face;
}

TEST(EyePlace, OfABoxAtEveryPointAroundIt) {
  const Range box{{0, 0, 0}, {3, 4, 2}};
  PolyBuilder builder;
  builder.add_box("box", box.low, box.high);
  const PolyScene scene = builder.take();
  for (std::int32_t x = -1; x <= 4; ++x)
    for (std::int32_t y = -1; y <= 5; ++y)
      for (std::int32_t z = -1; z <= 3; ++z)
        EXPECT_EQ(eye_place(scene, {x, y, z}).kind, place_in(box, {x, y, z})) << x << "," << y << "," << z;
}

// An octahedron: every ray from a grid point of its middle planes meets an edge or a corner.
TEST(EyePlace, RaysThroughEdgesAndCorners) {
  PolyScene scene;
  scene.vertices = {{6, 0, 0}, {-6, 0, 0}, {0, 6, 0}, {0, -6, 0}, {0, 0, 6}, {0, 0, -6}};
  PolyBody body;
  for (const VertexIndex x : {0U, 1U})
    for (const VertexIndex y : {2U, 3U})
      for (const VertexIndex z : {4U, 5U}) {
        const bool turned = (x + y + z) % 2 != 0;
        body.faces.push_back(
            {turned ? std::vector<VertexIndex>{x, z, y} : std::vector<VertexIndex>{x, y, z}, {}});
      }
  scene.bodies.push_back(body);
  ASSERT_TRUE(check_poly_scene(scene).empty()) << check_poly_scene(scene).front().message();
  for (std::int32_t x = -7; x <= 7; ++x)
    for (std::int32_t y = -7; y <= 7; ++y)
      for (std::int32_t z = -7; z <= 7; ++z) {
        const int sum = std::abs(x) + std::abs(y) + std::abs(z);
        const Kind expected = sum < 6 ? Kind::inside : sum == 6 ? Kind::on_face : Kind::free;
        EXPECT_EQ(eye_place(scene, {x, y, z}).kind, expected) << x << "," << y << "," << z;
      }
}

TEST(EyePlace, ACavityIsFree) {
  PolyBuilder builder;
  builder.add_box("shell", {0, 0, 0}, {10, 10, 10});
  builder.add_box("cavity", {3, 3, 3}, {7, 7, 7});
  PolyScene scene = builder.take();
  for (PolyFace face : scene.bodies[1].faces) {
    std::reverse(face.outline.begin(), face.outline.end());
    scene.bodies[0].faces.push_back(face);
  }
  scene.bodies.pop_back();
  ASSERT_TRUE(check_poly_scene(scene).empty());
  EXPECT_EQ(eye_place(scene, {5, 5, 5}).kind, Kind::free);
  EXPECT_EQ(eye_place(scene, {1, 5, 5}).kind, Kind::inside);
  EXPECT_EQ(eye_place(scene, {3, 5, 5}), (EyePlace{Kind::on_face, 0, eye_place(scene, {3, 5, 5}).face}));
}

TEST(EyePlace, AHoleIsFreeAndItsBorderIsNot) {
  PolyScene scene;
  scene.vertices = {{0, 0, 5}, {9, 0, 5}, {9, 9, 5}, {0, 9, 5}, {3, 3, 5}, {3, 6, 5}, {6, 6, 5}, {6, 3, 5}};
  scene.bodies.push_back({"window", true, {{{0, 1, 2, 3}, {{4, 5, 6, 7}}}}});
  ASSERT_TRUE(check_poly_scene(scene).empty()) << check_poly_scene(scene).front().message();
  EXPECT_EQ(eye_place(scene, {4, 4, 5}).kind, Kind::free);
  EXPECT_EQ(eye_place(scene, {3, 4, 5}).kind, Kind::on_face);
  EXPECT_EQ(eye_place(scene, {1, 4, 5}).kind, Kind::on_face);
  EXPECT_EQ(eye_place(scene, {1, 4, 6}).kind, Kind::free);
  EXPECT_EQ(eye_place(scene, {10, 4, 5}).kind, Kind::free);
}

TEST(EyePlace, ErrorsNameTheBody) {
  PolyBuilder builder;
  builder.add_box("left", {0, 0, 0}, {4, 4, 4});
  builder.add_box("tower", {10, 0, 0}, {14, 9, 4});
  const PolyScene scene = builder.take();
  PolyCamera camera;
  camera.eye = {12, 2, 2};
  ASSERT_TRUE(eye_error(scene, camera));
  EXPECT_EQ(eye_error(scene, camera)->message(),
            "body 1 \"tower\": the eye 12,2,2 is inside this solid, expected it in free space");
  camera.perspective = false;
  EXPECT_FALSE(eye_error(scene, camera));
  camera.perspective = true;
  camera.eye = {2, 2, 4};
  ASSERT_TRUE(eye_error(scene, camera));
  EXPECT_TRUE(eye_error(scene, camera)->place.starts_with("body 0 \"left\", face "));
  camera.eye = {7, 2, 2};
  EXPECT_FALSE(eye_error(scene, camera));
}

TEST(EyePlace, TheGeneratedViewsAreInFreeSpace) {
  for (const std::string_view family : generator_names()) {
    const PolyScene scene = *generate_scene(family, 4);
    EXPECT_FALSE(eye_error(scene, scene.camera)) << family;
  }
}

// --- Cameras

std::int64_t dot(const PolyPoint& a, const PolyPoint& b) {
  return geometry::dot(geometry::vector_of(a), geometry::vector_of(b));
}

void expect_good(const PolyCamera& camera, const SceneFrame& frame) {
  EXPECT_EQ(dot(camera.forward, camera.right), 0);
  EXPECT_EQ(dot(camera.forward, camera.up), 0);
  EXPECT_EQ(dot(camera.right, camera.up), 0);
  for (const PolyPoint& v : {camera.forward, camera.right, camera.up})
    for (const std::int32_t c : v) EXPECT_LT(std::abs(c), camera_vector_limit);
  EXPECT_EQ(camera.right[frame.vertical], 0);
  EXPECT_GE(camera.up[frame.vertical] * (frame.downwards ? -1 : 1), 0);
  const auto turned = geometry::cross(geometry::vector_of(camera.right), geometry::vector_of(camera.up));
  EXPECT_EQ(geometry::wide_dot(turned, geometry::vector_of(camera.forward)) > 0, frame.forward_is_z);
}

double degrees_between(const PolyPoint& a, const PolyPoint& b) {
  const auto turned = geometry::cross(geometry::vector_of(a), geometry::vector_of(b));
  double square = 0;
  for (const std::int64_t c : turned) square += static_cast<double>(c) * static_cast<double>(c);
  return std::atan2(std::sqrt(square), static_cast<double>(dot(a, b))) * 180 / 3.14159265358979;
}

TEST(AimCamera, NearEveryDirection) {
  SceneRandom random(3);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const SceneFrame frame{static_cast<std::size_t>(random.mod(3)), random.mod(2) == 1, random.mod(2) == 1};
    const std::int32_t size = 1 << (1 + random.mod(18));
    PolyPoint direction{};
    for (std::int32_t& c : direction) c = random.mod(static_cast<std::uint64_t>(2 * size + 1)) - size;
    if (direction == PolyPoint{}) continue;
    const PolyCamera camera = aimed_camera(frame, {1, 2, 3}, direction);
    expect_good(camera, frame);
    worst = std::max(worst, degrees_between(camera.forward, direction));
  }
  EXPECT_LT(worst, 0.3);
}

TEST(AimCamera, ExactWhereTheVectorsAreSmall) {
  const SceneFrame frame{};
  EXPECT_EQ(aimed_camera(frame, {}, {-24, -18, -40}).forward, (PolyPoint{-12, -9, -20}));
  EXPECT_EQ(aimed_camera({1, false, true}, {}, {0, 0, 700}),
            (PolyCamera{true, {}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(aimed_camera({2, false, false}, {}, {0, 0, -5}),
            (PolyCamera{true, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(aimed_camera(frame, {}, {0, -5, 0}), (PolyCamera{true, {}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}}));
}

// With a given up: right is forward x up, the upright vector right x forward, each without common divisors.
TEST(AimCamera, UpKeepsDirectionsExact) {
  const SceneFrame frame{};
  const auto vectors = [&frame](const std::array<double, 3>& direction, const std::array<double, 3>& up) {
    const PolyCamera camera = turned_camera(frame, {}, direction, up, false);
    return std::array{camera.forward, camera.right, camera.up};
  };
  using Vectors = std::array<PolyPoint, 3>;
  EXPECT_EQ(vectors({-1, -1, -1}, {0, 1, 0}), (Vectors{PolyPoint{-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}}));
  EXPECT_EQ(vectors({-1, -1, -1}, {0, 0, 1}), (Vectors{PolyPoint{-1, -1, -1}, {-1, 1, 0}, {-1, -1, 2}}));
  // Not perpendicular, and with decimals: (1, 2, 3) x (2, 1, 0) = (-3, 6, -3).
  EXPECT_EQ(vectors({0.1, 0.2, 0.3}, {1, 0.5, 0}), (Vectors{PolyPoint{1, 2, 3}, {-1, 2, -1}, {4, 1, -2}}));
  EXPECT_EQ(vectors({12000, 0, 5000}, {0, 7, 0}), (Vectors{PolyPoint{12, 0, 5}, {-5, 0, 12}, {0, 1, 0}}));
  // A direction without integers, and the vertical: the camera is the one without up.
  const std::array<double, 3> dimetric{-1, -1, -std::sqrt(7.0)};
  EXPECT_EQ(turned_camera(frame, {}, dimetric, {0, 2, 0}, false), aimed_camera(frame, {}, direction_of(dimetric), false));
}

TEST(AimCamera, UpThatNeedsLargeVectorsIsApproximated) {
  SceneRandom random(38);
  for (int i = 0; i < 500; ++i) {
    std::array<double, 3> direction{};
    std::array<double, 3> up{};
    for (double& c : direction) c = static_cast<double>(random.mod(65535)) - 32767;
    for (double& c : up) c = (static_cast<double>(random.mod(65535)) - 32767) / 1000;
    const PolyCamera camera = turned_camera({}, {}, direction, up, false);
    EXPECT_EQ(dot(camera.forward, camera.right), 0);
    EXPECT_EQ(dot(camera.forward, camera.up), 0);
    EXPECT_EQ(dot(camera.right, camera.up), 0);
    for (const PolyPoint& v : {camera.forward, camera.right, camera.up})
      for (const std::int32_t c : v) EXPECT_LT(std::abs(c), camera_vector_limit);
    EXPECT_LT(angle_to(camera, direction), 1) << i;
  }
}

TEST(AimCamera, TheThreeQuarterViewEqualsThatOfAFile) {
  PolyScene scene = *generate_scene("town", 9, 2);
  EXPECT_EQ(three_quarter_camera({}, scene), default_poly_camera(scene));
  for (std::size_t vertical = 0; vertical < 3; ++vertical)
    for (const bool forward_is_z : {false, true}) {
      const SceneFrame frame{vertical, false, forward_is_z};
      const PolyCamera camera = three_quarter_camera(frame, scene);
      expect_good(camera, frame);
      EXPECT_EQ(frame_of(camera), frame);
      for (const PolyPoint& p : scene.vertices)
        EXPECT_GT(geometry::dot(geometry::vector_of(camera.forward), geometry::difference(p, camera.eye)), 0);
    }
}

TEST(AimCamera, FramesOfTheKindsOfScene) {
  EXPECT_EQ(frame_of(generate_scene("boxes", 8)->camera), (SceneFrame{2, false, false}));
  EXPECT_EQ(frame_of(PolyCamera{}), (SceneFrame{1, false, true}));
  EXPECT_EQ(frame_of(default_poly_camera({})), (SceneFrame{1, false, false}));
}

}  // namespace
}  // namespace sightline::scene
