// Turning scenes: the six models and small scenes made by hand.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::algorithms::plantinga {

inline scene::PolyScene model_scene(const std::string& name) {
  auto read = scene::read_poly(*scene::builtin_scene_text(name), name, scene::PolyFormat::off);
  if (read) return std::move(read->scene);
  ADD_FAILURE() << read.error().found;
  return {};
}

// A parallelepiped at o along a, b and c (a right-handed triple), six faces seen from outside.
inline void add_brick(scene::PolyScene& scene, const scene::PolyPoint& o,
                      const std::array<scene::PolyPoint, 3>& along) {
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  for (unsigned corner = 0; corner < 8; ++corner) {
    scene::PolyPoint p = o;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += ((corner >> k) & 1U) != 0 ? along[k][axis] : 0;
    }
    scene.vertices.push_back(p);
  }
  scene::PolyBody body;
  for (const auto& ring : std::array<std::array<unsigned, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}) {
    scene::PolyFace face;
    for (const unsigned corner : ring) face.outline.push_back(first + corner);
    body.faces.push_back(face);
  }
  scene.bodies.push_back(body);
}

// Two tilted boxes, and three: no two corners at one height.
inline scene::PolyScene two_boxes() {
  scene::PolyScene scene;
  add_brick(scene, {-60, -31, -17}, {{{50, 7, 11}, {-6, 61, 9}, {-13, -5, 47}}});
  add_brick(scene, {25, -40, 3}, {{{37, 5, -9}, {4, 83, 7}, {11, -3, 41}}});
  return scene;
}
inline scene::PolyScene three_boxes() {
  scene::PolyScene scene = two_boxes();
  add_brick(scene, {-20, -10, 60}, {{{45, -8, 5}, {7, 39, -6}, {-4, 9, 33}}});
  return scene;
}

// Boxes on the ground, one with a smaller one on top: common heights and planes, permanent contacts.
inline scene::PolyScene boxes_on_the_ground() {
  scene::PolyBuilder builder;
  builder.add_box("left", {-40, 0, -10}, {-10, 30, 20});
  builder.add_box("right", {5, 0, 0}, {35, 30, 40});
  builder.add_box("behind", {-20, 0, -60}, {20, 45, -30});
  builder.add_box("tower", {10, 30, 10}, {30, 60, 30});
  return builder.take();
}

}  // namespace sightline::algorithms::plantinga
