// Mesh files read without the product's readers: OFF, STL, PLY and OBJ, as polygons with coordinates in doubles.
//
// For checks that share no code with the product. Left out: colours, normals, materials, texture coordinates and points.
// A file that its own format does not allow is an exception, and so is one without faces and lines.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sightline::tests {

using Point3 = std::array<double, 3>;

struct PlainMesh {
  std::vector<Point3> vertices;                     // no two are equal, each is one of a face or line
  std::vector<std::vector<std::uint32_t>> faces;    // three or more corners, no two neighbours equal; none is there twice
  std::vector<std::array<std::uint32_t, 2>> lines;  // of statements "l" of OBJ, one for each step
  double precision = 0;  // the smallest difference that the numbers of the file express, as far as that is an error
};

// Throws std::runtime_error, which says what was found.
[[nodiscard]] PlainMesh read_plain_mesh(const std::string& path);

}  // namespace sightline::tests
