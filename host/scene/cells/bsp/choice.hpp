// Chooses the plane that splits a part of space.
#pragma once

#include <cstdint>
#include <span>

#include "host/scene/cells/bsp/faces.hpp"

namespace sightline::scene {

// The plane of one of the faces, of which there is at least one, that splits few of the others and leaves
// about as many on either side. Of many faces an evenly spaced sample is tried.
[[nodiscard]] std::uint32_t splitting_plane(const Planes& planes, std::span<const FacePiece> faces);

}  // namespace sightline::scene
