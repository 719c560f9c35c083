// Scenes for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::scene {

inline CellScene builtin_scene(std::string_view name) {
  auto result = read_cell_scene(builtin_scene_text(name).value(), name);
  if (const auto* error = std::get_if<SceneError>(&result)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<CellScene>(result);
}

}  // namespace sightline::scene
