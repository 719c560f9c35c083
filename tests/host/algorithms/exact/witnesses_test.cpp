// The faces that hide each part of an edge, from each side.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host/algorithms/exact/witnesses.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

using exact::EdgeProof;
using exact::Witness;
using Reason = EdgeProof::Reason;

// An edge is visible where it is not hidden from both sides.
std::vector<geometry::Interval> seen_by(const EdgeProof& proof) {
  if (proof.reason != Reason::witnesses) return {};
  std::array<geometry::IntervalSet, 2> from{geometry::IntervalSet(0, 1), geometry::IntervalSet(0, 1)};
  for (const Witness& w : proof.left) from[0].subtract(w.low, w.high);
  for (const Witness& w : proof.right) from[1].subtract(w.low, w.high);
  for (const geometry::Interval& interval : from[1].intervals()) from[0].unite(interval.low, interval.high);
  return from[0].intervals();
}

// A witness that touches the one after next could replace the one between.
bool is_minimal(const std::vector<Witness>& witnesses) {
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    if (!(witnesses[i].low < witnesses[i].high)) return false;
    if (i > 0 && !(witnesses[i - 1].low < witnesses[i].low && witnesses[i - 1].high < witnesses[i].high)) return false;
    if (i > 1 && !(witnesses[i - 2].high < witnesses[i].low)) return false;
  }
  return true;
}

void check(const scene::PolyScene& scene, const scene::PolyCamera& camera, const picture::ChosenEdges* chosen = nullptr) {
  const exact::EdgeMesh mesh = exact::make_edge_mesh(scene);
  std::vector<EdgeProof> proofs;
  const picture::LinePicture picture = exact::visible_edges(mesh, camera, chosen, proofs);
  ASSERT_TRUE(picture == exact::visible_edges(mesh, camera, chosen)) << scene.name;
  ASSERT_EQ(proofs.size(), chosen != nullptr ? chosen->edges.size() : mesh.edges.size());
  picture::LinePicture proven;
  for (std::size_t p = 0; p < proofs.size(); ++p) {
    EXPECT_EQ(proofs[p].edge, chosen != nullptr ? chosen->edges[p] : mesh.edges[p]);
    EXPECT_TRUE(is_minimal(proofs[p].left) && is_minimal(proofs[p].right)) << scene.name << ": edge " << p;
    for (const geometry::Interval& interval : seen_by(proofs[p])) proven.pieces.push_back({proofs[p].edge, interval.low, interval.high});
  }
  EXPECT_TRUE(proven == picture) << scene.name;
}

TEST(Witnesses, TwoFacesHideTheirOwnSideOfALineBehindTheirCommonEdge) {
  scene::PolyScene scene;
  scene::PolyCamera camera;
  add_sheet(scene, {{0, -10, 100}, {0, 10, 100}, {-20, 10, 120}, {-20, -10, 120}});
  add_sheet(scene, {{0, -10, 100}, {0, 10, 100}, {20, 10, 120}, {20, -10, 120}});
  const auto line = add_sheet(scene, {{0, -5, 200}, {0, 5, 200}, {1, 0, 300}});
  std::vector<EdgeProof> proofs;
  const auto picture = exact::visible_edges(exact::make_edge_mesh(scene), camera, nullptr, proofs);
  const auto found = std::find_if(proofs.begin(), proofs.end(), [line](const EdgeProof& p) { return p.edge == picture::LineEdge{line, line + 1}; });
  ASSERT_NE(found, proofs.end());
  // From (0, -5, 200) to (0, 5, 200), as cross((0, -5, 200), (0, 5, 200)) points to -x, where face 0 is.
  EXPECT_EQ(found->left, (std::vector<Witness>{{0, 1, 0}}));
  EXPECT_EQ(found->right, (std::vector<Witness>{{0, 1, 1}}));
}

TEST(Witnesses, OfTwoFacesThatOverlapBothAreNeededAndAThirdWithinThemIsNot) {
  scene::PolyScene scene;
  scene::PolyCamera camera;
  add_sheet(scene, {{-10, -5, 90}, {10, -5, 90}, {10, 5, 90}, {-10, 5, 90}});
  add_sheet(scene, {{-20, -9, 100}, {4, -9, 100}, {4, 9, 100}, {-20, 9, 100}});
  add_sheet(scene, {{-4, -9, 110}, {22, -9, 110}, {22, 9, 110}, {-4, 9, 110}});
  const auto line = add_sheet(scene, {{-100, 0, 200}, {100, 0, 200}, {0, 300, 200}});
  std::vector<EdgeProof> proofs;
  const auto picture = exact::visible_edges(exact::make_edge_mesh(scene), camera, nullptr, proofs);
  const auto found = std::find_if(proofs.begin(), proofs.end(), [line](const EdgeProof& p) { return p.edge == picture::LineEdge{line, line + 1}; });
  ASSERT_NE(found, proofs.end());
  // x from -40 to 8 is behind face 1, and from -80/11 to 40 behind face 2.
  const std::vector<Witness> expected{{{3, 10}, {27, 50}, 1}, {{51, 110}, {7, 10}, 2}};
  EXPECT_EQ(found->left, expected);
  EXPECT_EQ(found->right, expected);
}

TEST(Witnesses, WhatTheyLeaveIsThePicture) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    for (const scene::PolyScene& scene :
         {scene::generate_boxes(20, seed), scene::generate_bricks(6, seed), scene::generate_triangles(12, seed), scene::generate_rooms(2, seed)}) {
      RandomCameras cameras(scene, seed);
      for (int i = 0; i < 3; ++i) {
        check(scene, cameras.outside(true));
        check(scene, cameras.outside(false));
      }
      const picture::EdgeChooser chooser(scene, *picture::edge_choice_named("feature"));
      const scene::PolyCamera camera = cameras.outside(true);
      const picture::ChosenEdges chosen = chooser.at(camera);
      check(scene, camera, &chosen);
    }
  }
}

TEST(Witnesses, OfLinesInWhichSolidsCrossTooWithRoundedEnds) {
  scene::PolyScene scene = scene::generate_boxes(2, 1);
  for (std::size_t v = 8; v < 16; ++v)
    for (std::size_t a = 0; a < 3; ++a) scene.vertices[v][a] = scene.vertices[v - 8][a] + static_cast<std::int32_t>(a + 1) * 31;
  scene = scene::with_crossings(scene);
  ASSERT_FALSE(scene.crossings.empty());
  RandomCameras cameras(scene, 1);
  for (int i = 0; i < 20; ++i) check(scene, cameras.outside(i % 2 == 0));
}

}  // namespace
}  // namespace sightline::algorithms
