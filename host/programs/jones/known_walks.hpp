// Walks through the scenes of cells that `demo`, the report and tests show: texts for read_walk, from the default view.
#pragma once

#include <array>
#include <string_view>

namespace sightline::programs::jones {

struct KnownWalk {
  std::string_view scene;
  std::string_view steps;
};
inline constexpr std::array<KnownWalk, 2> known_walks{{
    // Through the door of the dining room, the hatch, the kitchen and its door, back to the start, against a wall, and back from it.
    {"house", "left 130 in 300, in 150, in 150 down 40, left 200, in 100, left 30 out 400, right 360 up 40 out 300, in 500, out 300"},
    // Along the street, through the arch, round it and back over the roofs.
    {"street4", "in 400, in 600, in 700, in 500, in 600, left 500, up 450, out 900, right 600 out 800, down 300"},
}};

// With turns of the view, for the program with rotation.
inline constexpr std::array<KnownWalk, 1> known_turned_walks{{
    // Round the living room, through the wide door of the dining room, to its hatch and back to look through the door.
    {"house", "turn-left 30, in 200, turn-right 30 in 100, in 200, turn-left 60, turn-left 30 in 50, turn-left 45, turn-left 45, turn-left 20 right 40"},
}};

}  // namespace sightline::programs::jones
