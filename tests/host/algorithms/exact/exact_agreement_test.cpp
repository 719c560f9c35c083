// `exact` compared with the oracle by ==, on generated scenes from random cameras: perspective and orthographic, from outside and
// from within a building, with much of the scene behind the eye. Bricks, touching cubes and cubes in line have such small
// coordinates that the eye is often exactly in the plane of faces and in line with edges.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

void expect_agreement(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  const picture::LinePicture exact = exact_maker.draw(scene, camera);
  const picture::LinePicture oracle = oracle_maker.draw(scene, camera);
  EXPECT_TRUE(exact == oracle) << scene.name << (camera.perspective ? " perspective" : " orthographic")
                               << " eye " << camera.eye[0] << ' ' << camera.eye[1] << ' ' << camera.eye[2]
                               << " forward " << camera.forward[0] << ' ' << camera.forward[1] << ' '
                               << camera.forward[2] << ": " << exact.pieces.size() << " and "
                               << oracle.pieces.size() << " pieces";
}

void expect_agreement_from_around(const scene::PolyScene& scene, std::uint32_t seed, int views) {
  expect_agreement(scene, scene.camera);
  RandomCameras cameras(scene, seed);
  for (int i = 0; i < views; ++i) {
    expect_agreement(scene, cameras.outside(true));
    expect_agreement(scene, cameras.outside(false));
  }
}

TEST(ExactAgreement, Boxes) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    expect_agreement_from_around(scene::generate_boxes(1 + seed, seed), seed, 3);
  }
  expect_agreement_from_around(scene::generate_boxes(30), 1, 1);
  expect_agreement_from_around(scene::generate_edgeon(20), 1, 1);
}

TEST(ExactAgreement, Bricks) {
  for (std::uint32_t seed = 1; seed <= 15; ++seed) {
    expect_agreement_from_around(scene::generate_bricks(1 + seed % 10, seed), seed, 4);
  }
}

TEST(ExactAgreement, TownsAndTriangles) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    expect_agreement_from_around(scene::generate_town(seed, seed), seed, 2);
    expect_agreement_from_around(scene::generate_triangles(2 * seed, seed), seed, 3);
  }
}

TEST(ExactAgreement, CubesThatTouchAndCubesInLine) {
  for (const std::size_t n : {1U, 2U}) {
    for (scene::PolyScene scene : {scene::generate_touch(n), scene::generate_aligned(n)}) {
      for (auto& vertex : scene.vertices) {
        for (std::int32_t& c : vertex) c /= 250;
      }
      expect_agreement_from_around(scene, 1, 5);
    }
  }
}

TEST(ExactAgreement, RoomsFromWithin) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const scene::PolyScene scene = scene::generate_rooms(1 + seed % 3, seed);
    expect_agreement_from_around(scene, seed, 1);
    RandomCameras cameras(scene, seed);
    for (int i = 0; i < 6; ++i) expect_agreement(scene, cameras.inside(1000));
  }
}

// Sheets that cross each other anywhere: planar quadrilaterals p, p + a, p + a + b, p + b, some with a hole.
TEST(ExactAgreement, SheetsThatCross) {
  std::mt19937 dice(7);
  const auto number = [&dice](std::int32_t range) {
    return static_cast<std::int32_t>(dice() % static_cast<std::uint32_t>(2 * range + 1)) - range;
  };
  for (int round = 0; round < 8; ++round) {
    scene::PolyScene scene;
    scene.name = "crossing sheets " + std::to_string(round);
    for (int sheet = 0; sheet < 12; ++sheet) {
      const scene::PolyPoint p{number(20), number(20), number(20)};
      const scene::PolyPoint a{4 * number(4), 4 * number(4), 4 * number(4)};
      const scene::PolyPoint b{4 * number(4), 4 * number(4), 4 * number(4)};
      const auto at = [&](std::int32_t s, std::int32_t t) {
        scene::PolyPoint point = p;
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += s * a[axis] / 4 + t * b[axis] / 4;
        return point;
      };
      std::vector<scene::PolyPoint> hole;
      if (sheet % 3 == 0) hole = {at(1, 1), at(1, 3), at(3, 2)};
      add_sheet(scene, {at(0, 0), at(4, 0), at(4, 4), at(0, 4)}, hole);
    }
    RandomCameras cameras(scene, static_cast<std::uint32_t>(round));
    for (int i = 0; i < 5; ++i) {
      expect_agreement(scene, cameras.outside(true));
      expect_agreement(scene, cameras.outside(false));
    }
  }
}

// In image order, which a multithreaded run uses for any scene.
TEST(ExactAgreement, AnyNumberOfThreadsDrawsTheSame) {
  for (const scene::PolyScene& scene :
       {scene::generate_boxes(40), scene::generate_town(20), scene::generate_rooms(3), scene::generate_triangles(60),
        scene::generate_bricks(10), scene::PolyScene()}) {
    const exact::EdgeMesh mesh = exact::make_edge_mesh(scene);
    std::vector<scene::PolyCamera> cameras{scene.camera};
    if (!scene.vertices.empty()) {
      RandomCameras random(scene, 5);
      for (int i = 0; i < 10; ++i) cameras.push_back(random.outside(i % 2 == 0));
    }
    for (const scene::PolyCamera& camera : cameras) {
      const picture::LinePicture one = exact::visible_edges(mesh, camera);
      for (const unsigned jobs : {2U, 3U, 16U})
        EXPECT_TRUE(exact::visible_edges(mesh, camera, nullptr, jobs) == one) << scene.name << ", " << jobs;
    }
  }
}

}  // namespace
}  // namespace sightline::algorithms
