// The options that select the edges to be drawn, the same in every command that draws lines.
#pragma once

#include <optional>
#include <string>

#include "host/app/command_line.hpp"
#include "host/hidden_lines/hidden_lines.hpp"

namespace sightline::app {

struct EdgeArguments {
  std::string kinds;  // empty: not given
  std::optional<double> crease;
  bool all = false;  // --all-edges

  [[nodiscard]] hidden_lines::EdgeOptions options() const { return {all ? "all" : kinds, crease}; }
};

// --edges, --crease, --all-edges.
void add_edge_options(const Command& command, EdgeArguments& arguments);

// Error usage: an unknown kind, or no angle.
void check_edges(const EdgeArguments& arguments);

}  // namespace sightline::app
