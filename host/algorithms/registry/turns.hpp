// The methods that turn a scene about its vertical axis, all behind one door: what is common to all views of
// a turn is found first, and then they are drawn one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

struct TurnOptions {
  double tolerance = 0;  // radians, at least 0: what happens within it is joined; 0: exact
  std::optional<picture::EdgeChoice> edges = {};  // those drawn; empty: all
  std::string found = {};  // a file that PreparedTurn::keep wrote for this scene and tolerance; empty: none
  std::function<void(std::size_t done, std::size_t of)> progress = nullptr;  // from any thread, one at a time
};

struct TurnCount {
  std::string_view name;  // plural, as people read it: "changes of edges"
  std::uint64_t value = 0;
};

// In scene units: u = x cos - z sin to the right, v = y up.
struct TurnLine {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

// Angles are radians; what is seen of an edge is decided to 1/32767^2 of one, as cameras are whole numbers.
// `lines` is overwritten. One view at a time.
struct PreparedTurn {
  std::function<void(double angle, std::vector<TurnLine>& lines)> visible;
  std::function<void(double angle, std::vector<TurnLine>& lines)> whole;  // every edge, hidden or not
  // What was found; null if nothing is found that could be kept.
  std::function<base::Result<base::Done>(const std::string& file)> keep = nullptr;
  std::vector<TurnCount> counts;
};

struct TurnMethod {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the method does not apply to the scene; empty if it does.
  std::optional<std::string> (*why_not)(const scene::PolyScene& scene);
  // Of a checked scene to which it applies (preconditions) and that outlives it. Errors: a limit was reached, or the file is
  // damaged or of another scene or tolerance.
  base::Result<PreparedTurn> (*prepare)(const scene::PolyScene& scene, const TurnOptions& options);
};

[[nodiscard]] std::span<const TurnMethod> turn_methods();
// Null if there is none of that name.
[[nodiscard]] const TurnMethod* find_turn_method(std::string_view name);

}  // namespace sightline::registry
