// The steps of a walk as a text: "in 100, right 50 up 20" - one view for each part between commas, a direction with a
// number of units for each axis that moves, and turn-left or turn-right with degrees. They are those of the program's switches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::programs::jones {

using Steps = std::array<std::int32_t, 3>;  // along x, y, z

inline constexpr std::int32_t most_steps = 65535;  // of a view along one axis: sums of 18 bits hold
// Before a view: first the turn, then the steps, which in a program with rotation go where the view then looks.
struct Move {
  Steps steps{};
  std::int32_t turn = 0;  // degrees to the right

  friend bool operator==(const Move&, const Move&) = default;
};

inline constexpr std::int32_t most_degrees = 360;  // of a turn
inline constexpr std::size_t most_walk_views = 1000;

// Error: what was found, and what is expected.
[[nodiscard]] base::Result<std::vector<Move>> read_walk(std::string_view text);

// Whether the walk has a turn, for which the program needs rotation.
[[nodiscard]] bool has_turn(std::span<const Move> walk);

// "x", "y and z", "x, y and z": the axes of View::stops.
[[nodiscard]] std::string axes_of(std::uint32_t stops);

}  // namespace sightline::programs::jones
