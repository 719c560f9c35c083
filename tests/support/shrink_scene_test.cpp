// The shrinker, given programs that are wrong on purpose, so that the defect certainly exists.
#include "tests/support/shrink_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/poly_file.hpp"
#include "tests/host/algorithms/agreement/random_scene.hpp"

namespace sightline::tests {
namespace {

using algorithms::exact::visible_edges;
using scene::PolyBody;
using scene::PolyScene;

// Defect: a body does not hide other bodies.
bool misses_other_bodies(const PolyScene& scene) {
  const picture::LinePicture truth = visible_edges(scene, scene.camera);
  PolyScene part = scene;
  std::size_t pieces = 0;
  for (const PolyBody& body : scene.bodies) {
    part.bodies = {body};
    pieces += visible_edges(part, scene.camera).pieces.size();
  }
  return pieces > truth.pieces.size();
}

// Defect: the holes of sheets are ignored, so that nothing is seen through them.
bool fills_holes(const PolyScene& scene) {
  PolyScene filled = scene;
  for (PolyBody& body : filled.bodies) {
    if (!body.sheet) continue;
    for (scene::PolyFace& face : body.faces) face.holes.clear();
  }
  const picture::LinePicture truth = visible_edges(scene, scene.camera);
  const picture::LinePicture wrong = visible_edges(filled, scene.camera);
  // Edges of outlines only, not of the holes themselves.
  const auto has_edge = [&](const picture::LinePiece& piece) {
    for (const PolyBody& body : filled.bodies) {
      for (const scene::PolyFace& face : body.faces) {
        for (std::size_t i = 0; i < face.outline.size(); ++i) {
          const auto [low, high] = std::minmax(face.outline[i], face.outline[(i + 1) % face.outline.size()]);
          if (piece.edge == picture::LineEdge{low, high}) return true;
        }
      }
    }
    return false;
  };
  const auto outlines_seen = std::count_if(truth.pieces.begin(), truth.pieces.end(), has_edge);
  return outlines_seen != std::count_if(wrong.pieces.begin(), wrong.pieces.end(), has_edge);
}

std::size_t faces_of(const PolyScene& scene) {
  std::size_t faces = 0;
  for (const PolyBody& body : scene.bodies) faces += body.faces.size();
  return faces;
}

std::int32_t largest_coordinate(const PolyScene& scene) {
  std::int32_t largest = 0;
  for (const scene::PolyPoint& p : scene.vertices)
    for (const std::int32_t c : p) largest = std::max(largest, std::abs(c));
  return largest;
}

// Runs `wanted` scenes of at least three bodies that show the defect.
template <class Check>
void shrink_random_scenes(const ShowsDefect& shows_defect, int wanted, Check check) {
  int found = 0;
  for (std::uint32_t seed = 1; seed < 2000 && found < wanted; ++seed) {
    algorithms::RandomScene random(seed);
    if (random.scene().bodies.size() < 3 || !random.look() || !shows_defect(random.scene())) continue;
    ++found;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const PolyScene small = shrink_scene(random.scene(), shows_defect);
    EXPECT_TRUE(shows_defect(small));
    EXPECT_TRUE(scene::check_poly_scene(small).empty());
    EXPECT_FALSE(scene::eye_error(small, small.camera));
    EXPECT_EQ(small, shrink_scene(random.scene(), shows_defect));
    EXPECT_EQ(small, shrink_scene(small, shows_defect));
    check(small);
  }
  EXPECT_EQ(found, wanted);
}

TEST(ShrinkScene, OneFaceBeforeAnotherIsLeftOfBodiesThatDoNotHideEachOther) {
  shrink_random_scenes(misses_other_bodies, 12, [](const PolyScene& small) {
    EXPECT_EQ(small.bodies.size(), 2U);
    EXPECT_EQ(faces_of(small), 2U);
    EXPECT_LE(small.vertices.size(), 6U);
    EXPECT_LE(largest_coordinate(small), 4);
  });
}

TEST(ShrinkScene, AHoleAndWhatIsBehindItAreLeftOfFilledHoles) {
  shrink_random_scenes(fills_holes, 6, [](const PolyScene& small) {
    EXPECT_EQ(faces_of(small), 2U);
    std::size_t holes = 0;
    for (const PolyBody& body : small.bodies)
      for (const scene::PolyFace& face : body.faces) holes += face.holes.size();
    EXPECT_EQ(holes, 1U);
    EXPECT_LE(small.vertices.size(), 9U);
    EXPECT_LE(largest_coordinate(small), 8);
  });
}

// 30 boxes of coordinates up to 4000 and a sheet; a defect that needs three bodies, one of them the sheet.
TEST(ShrinkScene, WhatADefectNeedsStays) {
  scene::PolyBuilder builder;
  for (std::int32_t i = 0; i < 30; ++i) builder.add_box("box", {i * 130, 7, 9}, {i * 130 + 100, 900, 4000});
  const scene::PolyPoint sheet[] = {{0, 0, -5}, {3000, 0, -5}, {3000, 2000, -5}, {0, 2000, -5}};
  builder.add_sheet("sheet", sheet);
  PolyScene scene = builder.take();
  scene.camera.eye = {1500, 500, -2000};
  scene.step = 0.5;
  const auto needs = [](const PolyScene& candidate) {
    const auto is_sheet = [](const PolyBody& body) { return body.sheet; };
    const auto sheets = std::count_if(candidate.bodies.begin(), candidate.bodies.end(), is_sheet);
    return candidate.bodies.size() >= 3 && sheets == 1 && candidate.camera.perspective;
  };
  ASSERT_TRUE(scene::check_poly_scene(scene).empty());
  const PolyScene small = shrink_scene(scene, needs);
  EXPECT_EQ(small.bodies.size(), 3U);
  EXPECT_EQ(faces_of(small), 6U + 6U + 1U);
  EXPECT_TRUE(small.camera.perspective);
  EXPECT_EQ(small.step, 1);
  EXPECT_EQ(small.bodies.front().name, "");
  EXPECT_LE(largest_coordinate(small), 1);
}

// A saved scene is read back unchanged, including the camera.
TEST(ShrinkScene, TheResultIsAFile) {
  shrink_random_scenes(misses_other_bodies, 1, [](const PolyScene& small) {
    const auto text = scene::write_poly(small, scene::PolyFormat::json);
    const auto read = scene::read_poly(*text, "small.json", scene::PolyFormat::json);
    EXPECT_EQ(read->scene, small);
  });
}

}  // namespace
}  // namespace sightline::tests
