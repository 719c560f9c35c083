// From the faces of a file, on a grid, to faces that every algorithm takes: mended where it can be done without
// a guess that shows.
//
// In this order. Vertices on one grid point become one, and with a distance those that a chain of steps of at
// most that distance joins: the one with the lowest coordinates stays, whatever the order of the file. Rings
// lose vertices that follow themselves and spikes. Faces whose vertices are in no plane, or whose outline
// touches itself, become triangles between their own vertices. Of faces with the same vertices in one body the
// first stays. A triangle that lost its area gives its middle vertex to the face beyond its longest side, so
// that no crack opens; other faces without area are left out. Faces that a chain of edges with two faces joins
// are a part; its faces are turned to agree with its first one. A closed part is a solid: outside out, in
// another one inside out, in that outside out again; a part that is open, or has but one side, is a sheet.
// Without bodies in the file each part is a body, and a cavity belongs to the solid around it; the bodies of a
// file are divided into what is solid and what is sheet. Wires that became a point, and all but one of those that
// are equal, are left out, and so are vertices that no face or wire has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct MendOptions {
  double weld = 0;       // in grid steps
  bool grouped = false;  // the bodies are the file's
};

struct MendReport {
  std::size_t merged_vertices = 0;
  std::size_t dropped_vertices = 0;   // unused
  std::size_t dropped_faces = 0;      // without area
  std::size_t duplicate_faces = 0;
  std::size_t split_faces = 0;        // no longer planar, or touching themselves
  double largest_deviation = 0;       // of a vertex of those from their plane, in steps
  std::size_t turned_faces = 0;
  std::size_t sheets = 0;             // parts that are not closed, or have but one side
  std::size_t one_sided = 0;          // of these
  std::size_t crowded_edges = 0;      // of three or more faces
  std::size_t crossing_faces = 0;     // left out, because their outlines cross themselves
  std::size_t first_crossing = 0;     // in the file, counted over all bodies from 0
  std::size_t dropped_wires = 0;      // without length
};

// What became of a face of the file.
struct MendedFace {
  std::uint32_t source = 0;  // counted over all bodies of the file from 0
  bool turned = false;
};

// Of a scene of vertices and bodies without holes, indices in range and coordinates within the limit, nothing
// else checked. Result: for each face of the scene, counted over all bodies, where it came from. What is left
// passes check_poly_scene but for the camera, unless no face and no wire is left.
std::vector<MendedFace> mend(PolyScene& scene, const MendOptions& options, MendReport& report);

// Wires from their lower vertex, ascending, each once; those from a vertex to itself are left out and counted.
void tidy_wires(std::vector<PolyWire>& wires, MendReport& report);

}  // namespace sightline::scene
