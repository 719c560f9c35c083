// Scenes and views of the tests of stripes, and all ways to draw one.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "host/algorithms/registry/faces.hpp"
#include "host/compare/cross_check_scenes.hpp"
#include "host/programs/stripes/session.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::programs::stripes {

inline View view_of(const scene::PolyCamera& camera, const registry::FaceWindow& window) {
  return {camera, window.scale, window.left, window.height - window.top};
}

inline registry::FaceWindow window_of(const View& view) {
  return {picture_size, picture_size, view.scale, view.left, picture_size - view.bottom};
}

// All of the scene from its own camera.
inline View whole_view(const scene::PolyScene& scene) {
  return view_of(scene.camera, registry::face_window(scene, scene.camera, picture_size, picture_size, std::nullopt));
}

// A view of a common scene, of 256 points, in the picture's 255.
inline View common_view(const compare::CrossCheckView& view) {
  const registry::FaceWindow window = view.window();
  const double size = double{picture_size} / window.width;
  return {view.camera, window.scale * size, window.left * size, (window.height - window.top) * size};
}

inline scene::PolyScene scene_named(const std::string& name) {
  const auto file = scene::named_scene(name);
  return scene::load_scene(**file)->scene;
}

// Assembled once.
inline const Session& session() {
  static const Session made;
  return made;
}

inline constexpr std::array both{Computer::host, Computer::i8080};
inline constexpr std::array outputs{Output::raster, Output::vector};

}  // namespace sightline::programs::stripes
