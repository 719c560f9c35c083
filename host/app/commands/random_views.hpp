// The options of random views, the same in `compare` and `sweep`, so that a view's number means the same view in both.
#pragma once

#include <cstdint>

#include "host/app/command_line.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::app {

struct RandomViewOptions {
  std::uint64_t seed = 1;
  bool turn = false;
  bool level = false;
};

// --seed, --turn and --level, of which the last two exclude each other.
void add_random_view_options(const Command& command, RandomViewOptions& options);

// Error usage: --turn of a scene that is not of cells.
[[nodiscard]] compare::Directions directions_of(const RandomViewOptions& options, const scene::LoadedScene& source);

}  // namespace sightline::app
