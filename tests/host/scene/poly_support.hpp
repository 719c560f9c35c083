// Scenes of faces read from text and written to it, and what a check finds in them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <variant>

#include "host/scene/poly_check.hpp"
#include "host/scene/poly_file.hpp"

namespace sightline::scene {

inline PolyImport read(std::string_view text, PolyFormat format, bool mend = false) {
  auto result = read_poly(text, "test", format, {mend});
  if (const auto* error = std::get_if<SceneError>(&result)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<PolyImport>(result);
}

inline std::string written(const PolyScene& scene, PolyFormat format) {
  const auto text = write_poly(scene, format);
  if (const auto* error = std::get_if<SceneError>(&text)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<std::string>(text);
}

inline std::string problems(const PolyScene& scene) {
  std::string text;
  for (const SceneError& error : check_poly_scene(scene)) text += error.message() + "\n";
  return text;
}

}  // namespace sightline::scene
