// Compares the drawing of a generated scene with `exact`.
#pragma once

#include <map>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"
#include "tests/host/scene/generate/generated_set.hpp"

namespace sightline::algorithms::montani_re {

struct Agreement {
  int views = 0;
  int equal = 0;       // by ==
  int same_image = 0;  // the same points, but on other edges
  std::string first_wrong;
};

inline void compare_view(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                         Agreement& agreement) {
  ++agreement.views;
  const auto drawn = visible_edges(scene, camera);
  if (!drawn) {
    if (agreement.first_wrong.empty()) agreement.first_wrong = scene.name + ": " + drawn.error().message();
    return;
  }
  const picture::LinePicture& ours = drawn->picture;
  const picture::LinePicture truth = exact::visible_edges(scene, camera);
  if (ours == truth) {
    ++agreement.equal;
  } else if (image_set(ours, scene, camera) == image_set(truth, scene, camera)) {
    ++agreement.same_image;
  } else if (agreement.first_wrong.empty()) {
    agreement.first_wrong = scene.name + ": " + std::to_string(ours.pieces.size()) + " pieces, exact has " +
                            std::to_string(truth.pieces.size()) + ", forward " +
                            std::to_string(camera.forward[0]) + ' ' + std::to_string(camera.forward[1]) +
                            ' ' + std::to_string(camera.forward[2]);
  }
}

// Compares every `step`-th scene of the generated set from its own camera and from random ones.
inline std::map<std::string, Agreement> compare_generated_set(std::size_t step, int views) {
  std::map<std::string, Agreement> families;
  const auto names = scene::generated_set();
  for (std::size_t i = 0; i < names.size(); i += step) {
    const auto scene = *scene::generate_scene(names[i].family, names[i].size, names[i].seed);
    RandomCameras cameras(scene, static_cast<std::uint32_t>(i + 1));
    Agreement& agreement = families[std::string(names[i].family)];
    for (int view = 0; view < views; ++view) {
      compare_view(scene, view == 0 ? scene.camera : cameras.outside(view % 2 == 1), agreement);
    }
  }
  return families;
}

}  // namespace sightline::algorithms::montani_re
