// Certificates: a view's proof as text. tools/verify/README.md describes the format.
#pragma once

#include <string>

#include "host/hidden_lines/hidden_lines.hpp"

namespace sightline::hidden_lines {

// `scene` is what was drawn, with its intersections and wires.
[[nodiscard]] std::string certificate_of(const scene::PolyScene& scene, const Camera& camera, const Proof& proof);

}  // namespace sightline::hidden_lines
