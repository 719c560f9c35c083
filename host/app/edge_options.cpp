#include "host/app/edge_options.hpp"

namespace sightline::app {

void add_edge_options(const Command& command, EdgeArguments& arguments) {
  const Option kinds =
      command
          .option("--edges", arguments.kinds,
                  "Which edges are drawn: all, feature (silhouettes, boundaries, creases, borders of "
                  "materials, lines in which bodies pass through each other, and lines without faces), or "
                  "some of these kinds, separated by commas; borders between colours of single faces only "
                  "if border is named")
          .default_value("feature")
          .value("KINDS")
          .group("Edges");
  command.option("--crease", arguments.crease, "An edge is a crease if its faces bend by more than this")
      .range(0.0, 180.0)
      .default_value("30 of a mesh, 0 of other scenes")
      .value("DEGREES")
      .group("Edges");
  command.flag("--all-edges", arguments.all, "As --edges all: also edges between coplanar faces")
      .excludes(kinds)
      .group("Edges");
}

void check_edges(const EdgeArguments& arguments) {
  if (const auto checked = hidden_lines::check(arguments.options()); !checked) {
    base::Error error = checked.error();
    error.file = "--edges";
    throw error;
  }
  if (arguments.crease) require_finite("--crease", *arguments.crease);
}

}  // namespace sightline::app
