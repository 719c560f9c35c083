// The table of the methods that turn a scene about an axis. A method first computes what all views of a turn
// share, and then draws the views one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/plantinga/eye_circle.hpp"
#include "host/base/result.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

using algorithms::plantinga::EyeCircle;
using algorithms::plantinga::most_axis_part;

struct TurnOptions {
  double tolerance = 0;  // radians, at least 0: events within it are joined; 0: exact
  std::optional<picture::EdgeChoice> edges = {};  // the edges to draw; nullopt: all
  std::string found = {};  // a file written by PreparedTurn::keep for this scene and tolerance; empty: none
  // The way of the eye, about the middle of the scene; nullopt: about the y axis, in parallel projection, from +z at angle 0.
  // Without a tolerance and a file.
  std::optional<EyeCircle> circle = {};
  std::function<void(std::size_t done, std::size_t of)> progress = nullptr;  // from any thread, one at a time
};

struct TurnCount {
  std::string_view name;  // plural, as it is printed: "changes of edges"
  std::uint64_t value = 0;
};

// In scene units: u = x cos - z sin to the right, v = y up. On a circle of the eye: see plantinga::ImageLine.
struct TurnLine {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

// Angles are in radians. Visibility is resolved to 1/32767^2 radian, because cameras have integer components. `lines` is
// overwritten. Not thread-safe.
struct PreparedTurn {
  std::function<void(double angle, std::vector<TurnLine>& lines)> visible;
  std::function<void(double angle, std::vector<TurnLine>& lines)> whole;  // every edge, hidden or not
  // Writes the events found to a file; null if the method finds none.
  std::function<base::Result<base::Done>(const std::string& file)> keep = nullptr;
  std::vector<TurnCount> counts;
};

struct TurnMethod {
  std::string_view name;
  std::string_view description;  // includes the source
  // Why the method does not apply to the scene; nullopt if it does.
  std::optional<std::string> (*why_not)(const scene::PolyScene& scene);
  // Preconditions: the scene is checked, the method applies to it, and the scene outlives the result. Errors: a limit was
  // reached, or the file is damaged or belongs to another scene or tolerance.
  base::Result<PreparedTurn> (*prepare)(const scene::PolyScene& scene, const TurnOptions& options);
};

[[nodiscard]] std::span<const TurnMethod> turn_methods();
// Null if no method has this name.
[[nodiscard]] const TurnMethod* find_turn_method(std::string_view name);

}  // namespace sightline::registry
