#include "host/app/commands/random_views.hpp"

#include <fmt/core.h>

#include "host/app/command.hpp"

namespace sightline::app {

void add_random_view_options(const Command& command, RandomViewOptions& options) {
  command.option("--seed", options.seed, "Seed of the random views: another seed gives other views")
      .check(whole_number_error)
      .default_value()
      .value("N");
  const Option turn = command.flag("--turn", options.turn,
                                   "Random views of a scene of cells in all directions, as polyhedra; without it they look along +z, as "
                                   "Jones's program does");
  command.flag("--level", options.level, "Random views in parallel projection along level directions, which plantinga and turn-pdp7 draw")
      .excludes(turn);
}

compare::Directions directions_of(const RandomViewOptions& options, const scene::LoadedScene& source) {
  if (options.turn && !source.cells)
    throw base::usage_error(fmt::format("--turn: found {}, expected a scene of cells; random views of others look in all directions without it",
                              source.name));
  if (options.turn) return compare::Directions::all;
  return options.level ? compare::Directions::level : compare::Directions::usual;
}

}  // namespace sightline::app
