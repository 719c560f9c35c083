// The options that say which edges of a scene are drawn, the same in every command that draws lines.
#pragma once

#include <optional>
#include <string>

#include "host/app/command_line.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

struct EdgeArguments {
  std::string kinds;  // empty: not given
  std::optional<double> crease;
  bool all = false;  // --all-edges

  [[nodiscard]] bool are_given() const { return !kinds.empty() || crease || all; }
};

// --edges, --crease, --all-edges.
void add_edge_options(const Command& command, EdgeArguments& arguments);

// Error usage: no such kind, or no angle.
void check_edges(const EdgeArguments& arguments);

// Of arguments that were checked; empty: all edges, and there are no crossings. Creases of a mesh begin at 30
// degrees, those of all other scenes at 0, unless --crease says otherwise.
[[nodiscard]] std::optional<picture::EdgeChoice> edge_choice_of(const EdgeArguments& arguments,
                                                               const scene::PolyScene& scene);

}  // namespace sightline::app
