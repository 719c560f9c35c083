// Chooses the plane that splits a part of space.
#pragma once

#include <cstdint>
#include <span>

#include "host/scene/cells/bsp/faces.hpp"

namespace sightline::scene {

// Of the planes of up to a fixed number of evenly spaced faces, the one that splits the fewest faces and
// leaves about as many on either side. There is at least one face (precondition).
[[nodiscard]] std::uint32_t splitting_plane(const Planes& planes, std::span<const FacePiece> faces);

}  // namespace sightline::scene
