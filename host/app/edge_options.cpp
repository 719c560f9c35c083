// See edge_options.hpp.
#include "host/app/edge_options.hpp"

#include <fmt/core.h>

namespace sightline::app {

void add_edge_options(const Command& command, EdgeArguments& arguments) {
  const Option kinds =
      command
          .option("--edges", arguments.kinds,
                  "Which edges are drawn: all, feature (silhouettes, boundaries, creases, borders of "
                  "materials, lines in which bodies pass through each other, and lines without faces), or "
                  "some of these kinds with commas between them; borders of colours of single faces only "
                  "where border is named")
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
  if (!arguments.kinds.empty() && !picture::edge_choice_named(arguments.kinds)) {
    throw base::usage_error(fmt::format("--edges: found \"{}\", expected all, feature, or kinds with commas between them: silhouette, "
                              "boundary, crease, border, intersection, wire",
                              arguments.kinds));
  }
  if (arguments.crease) require_finite("--crease", *arguments.crease);
}

std::optional<picture::EdgeChoice> edge_choice_of(const EdgeArguments& arguments, const scene::PolyScene& scene) {
  const bool all = arguments.all || arguments.kinds == "all";
  if (all && scene.crossings.empty() && scene.wires.empty()) return std::nullopt;
  picture::EdgeChoice choice = *picture::edge_choice_named(all ? "all" : arguments.kinds.empty() ? "feature" : arguments.kinds);
  const bool named = !all && !arguments.kinds.empty() && arguments.kinds != "feature";
  if (scene.materials_are_colours && !named) choice.kinds[static_cast<std::size_t>(picture::EdgeKind::border)] = false;
  choice.crease = arguments.crease.value_or(scene.surfaces.empty() ? 0 : choice.crease);
  return choice;
}

}  // namespace sightline::app
