// Scenes for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::scene {

inline CellScene builtin_scene(std::string_view name) {
  auto result = read_cell_scene(builtin_scene_text(name).value(), name);
  if (!result) {
    ADD_FAILURE() << result.error().message();
    return {};
  }
  return *result;
}

}  // namespace sightline::scene
