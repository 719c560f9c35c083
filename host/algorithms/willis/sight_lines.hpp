// Exact sight lines through a model: which pieces a line hits, which is nearest, and whether that piece has the highest
// priority. This checks the method's order on pieces, not on faces of the scene.
#pragma once

#include <cstdint>
#include <random>
#include <span>

#include "host/algorithms/willis/model.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

struct SightLines {
  std::uint64_t with_two = 0;  // lines that hit two or more pieces turned to the eye
  std::uint64_t wrong = 0;     // of these, lines on which the nearest piece does not have the highest priority
};

// Counts `count` lines from one eye, each near a corner of some piece, level in plan and otherwise in any direction.
// `order` is ascending by priority. A line through the border of a piece misses it.
void count_lines(const Model& model, const scene::PolyPoint& eye, std::span<const std::uint32_t> order,
                 int lines, std::mt19937& random, SightLines& count);

// Counts at least `wanted` lines with two hits (fewer if 100,000 eyes do not suffice), from random places in free space
// within and around the scene; in plan, from among the walls. Each piece is represented by a random corner.
[[nodiscard]] SightLines count_lines(const Model& model, const scene::PolyScene& scene, std::uint64_t wanted,
                                     std::uint32_t seed);

}  // namespace sightline::algorithms::willis
