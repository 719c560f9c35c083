// The options of random views, the same in `compare` and `sweep`: a number means the same view in both.
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

// Adds --seed, --turn and --level; the last two exclude each other.
void add_random_view_options(const Command& command, RandomViewOptions& options);

// Error usage: --turn for a scene that has no cells.
[[nodiscard]] compare::Directions directions_of(const RandomViewOptions& options, const scene::LoadedScene& source);

}  // namespace sightline::app
