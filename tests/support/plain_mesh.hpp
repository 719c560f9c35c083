// Mesh files read without the product's readers: OFF, STL, PLY and OBJ, as polygons with coordinates in doubles.
//
// For checks that share no code with the product. Ignores colours, normals, materials, texture coordinates and points.
// Throws on a file that violates its format and on one without faces and lines.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sightline::tests {

using Point3 = std::array<double, 3>;

struct PlainMesh {
  std::vector<Point3> vertices;                     // all different; each belongs to a face or line
  std::vector<std::vector<std::uint32_t>> faces;    // three or more corners, adjacent ones different; no face occurs twice
  std::vector<std::array<std::uint32_t, 2>> lines;  // of statements "l" of OBJ, one per step
  double precision = 0;  // the smallest difference that the file's numbers can express, where it limits their accuracy
};

// Throws std::runtime_error with what was found.
[[nodiscard]] PlainMesh read_plain_mesh(const std::string& path);

}  // namespace sightline::tests
