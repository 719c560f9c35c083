// Certificates of small scenes, and random changes of them.
#pragma once

#include <string>
#include <vector>

#include "host/hidden_lines/hidden_lines.hpp"
#include "tests/support/dice.hpp"

namespace sightline::tests {

using programs::jones::Dice;

struct Drawn {
  std::string certificate;
  std::size_t edges = 0;
  std::size_t pieces = 0;  // visible
};

// Draws a scene as `sightline draw exact --certificate` does. Throws std::runtime_error with the error, if there is one.
[[nodiscard]] Drawn draw_with_proof(const hidden_lines::Scene& scene, const hidden_lines::Camera& camera,
                                    const hidden_lines::EdgeOptions& edges = {});
// A scene that is not from a file.
[[nodiscard]] hidden_lines::Scene loaded(scene::PolyScene scene);

// Certificates to be changed: solids and sheets, in perspective with parts behind the eye and parallel, edges behind common edges,
// edges seen end-on, solids that pass through each other, and a mesh with chosen edges.
[[nodiscard]] std::vector<std::string> certificates_to_change();

// One random change: an interval, a face, a side, a vertex, the eye, a direction, a reason or a whole line.
[[nodiscard]] std::string changed(const std::string& certificate, Dice& dice);

}  // namespace sightline::tests
