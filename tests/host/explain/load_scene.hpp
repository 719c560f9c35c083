// A scene by its name, for tests of lessons.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "host/scene/read/load.hpp"

namespace sightline::explain {

inline scene::LoadedScene load_scene(const std::string& name) {
  auto found = scene::named_scene(name);
  EXPECT_TRUE(found && *found) << name;
  return *scene::load_scene(std::move(**found));
}

}  // namespace sightline::explain
