// Whether a certificate is true, decided without the verifier: by the oracle of exact visible edges.
#pragma once

#include <string>
#include <string_view>

namespace sightline::tests {

// Empty if all that the certificate says about edges between vertices is true; otherwise what is false. What it says about
// intersections is not judged.
//
// - The intervals that the claims of an edge leave are those that the oracle sees.
// - A claim: the oracle sees nothing of its interval in a scene of its face and of a triangle that covers the other side of the edge.
// - "turned": each face at the edge, of which there is one, belongs to a closed solid and is not turned to the eye.
// - "point": the eye and the edge are in line.
// Precondition: the certificate has the right format. Scenes without wires that lie on surfaces, coordinates below 2^16.
[[nodiscard]] std::string falsehood_in(std::string_view certificate);

}  // namespace sightline::tests
