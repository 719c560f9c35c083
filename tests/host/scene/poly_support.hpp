// Scenes of faces read from text and written to it, the errors that a check finds in them, and a scene that several tests use.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::scene {

inline PolyImport read(std::string_view text, PolyFormat format, bool mend = false) {
  auto result = read_poly(text, "test", format, {mend});
  if (!result) {
    ADD_FAILURE() << result.error().message();
    return {};
  }
  return *result;
}

// What is wrong with the file of a mesh.
inline std::string faults(std::string_view text, PolyFormat format) {
  auto mesh = read_mesh(text, "test", format, "");
  if (!mesh) return mesh.error().message();
  const auto import = import_poly(std::move(*mesh));
  if (!import) return import.error().message();
  std::string all;
  for (const base::Error& error : import->faults) all += error.message() + "\n";
  return all;
}

inline std::string scene_text(const PolyScene& scene, PolyFormat format) {
  const auto text = write_poly(scene, format);
  if (!text) {
    ADD_FAILURE() << text.error().message();
    return {};
  }
  return *text;
}

inline std::string problems(const PolyScene& scene) {
  std::string text;
  for (const base::Error& error : check_poly_scene(scene)) text += error.message() + "\n";
  return text;
}

// A box within a box, one body: the inner faces, 6 to 11, face the cavity; their vertices are 8 to 15.
inline PolyScene hollow_box() {
  PolyBuilder builder;
  builder.add_box("outer", {0, 0, 0}, {10, 10, 10});
  builder.add_box("inner", {2, 2, 2}, {8, 8, 8});
  PolyScene scene = builder.take();
  for (PolyFace face : scene.bodies[1].faces) {
    std::reverse(face.outline.begin(), face.outline.end());
    scene.bodies[0].faces.push_back(face);
  }
  scene.bodies.pop_back();
  return scene;
}

}  // namespace sightline::scene
