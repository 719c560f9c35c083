// Exact sight lines through a model: what is hit, what of it is nearest, and whether that has the highest
// priority. The method's own check of its order, which looks at pieces and not at faces of the scene.
#pragma once

#include <cstdint>
#include <random>
#include <span>

#include "host/algorithms/willis/model.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

struct SightLines {
  std::uint64_t with_two = 0;  // lines that hit two or more pieces turned to the eye
  std::uint64_t wrong = 0;     // of them, those on which not the nearest has the highest priority
};

// So many lines from one eye, each near a corner of some piece, in plan level and in any direction; the pieces
// in ascending priority. Lines through the border of a piece miss it.
void count_lines(const Model& model, const scene::PolyPoint& eye, std::span<const std::uint32_t> order,
                 int lines, std::mt19937& random, SightLines& count);

// At least `wanted` lines with two hits (fewer if 100,000 eyes do not give them), from random places in free
// space within and around the scene, of a model in plan from among the walls; a random corner of each piece
// stands for it.
[[nodiscard]] SightLines count_lines(const Model& model, const scene::PolyScene& scene, std::uint64_t wanted,
                                     std::uint32_t seed);

}  // namespace sightline::algorithms::willis
