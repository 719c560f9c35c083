// Whether a certificate is true, decided without the verifier: by the oracle of exact visible edges.
#pragma once

#include <string>
#include <string_view>

namespace sightline::tests {

// Empty if all that the certificate says is true; otherwise what is false.
//
// - The intervals that the claims of an edge leave are those that the oracle sees, for an intersection up to rounding.
// - A claim about an edge between vertices: the oracle sees nothing of its interval in a scene of its face and of a triangle
//   that covers the other side of the edge.
// - "turned", of an edge between vertices: each face at the edge, of which there is one, belongs to a closed solid, and its
//   surface is not turned to the eye.
// - "point": the eye and the edge are in line.
// Precondition: the certificate has the right format. Scenes without wires that lie on surfaces, coordinates below 2^16.
[[nodiscard]] std::string falsehood_in(std::string_view certificate);

}  // namespace sightline::tests
