// From the faces of a file, on a grid, to faces that every algorithm takes: mended where it can be done without
// a guess that shows.
//
// In this order. Vertices on one grid point become one, and with a distance those that a chain of steps of at
// most that distance joins: the one with the lowest coordinates stays, whatever the order of the file. Rings
// lose vertices that follow themselves and spikes. Faces whose vertices are in no plane, or whose outline
// touches itself, become triangles between their own vertices. Of faces with the same vertices in one body the
// first stays. A triangle that lost its area gives its middle vertex to the face beyond its longest side, so
// that no crack opens; other faces without area are left out.
//
// What is still open is closed as far as the numbers of the file say that it is meant to be. Edges that only one face of a
// body of the file has are open; no others are changed. Ends of open edges that are less than a step apart in the file,
// and that rounding put on neighbouring points, become one, the nearest first; no group of them is wider than a step,
// so that fine detail does not shrink to a point. Nothing is joined if rounding lost nothing. Then an open edge that
// the file says an end of another open edge of the body is on, within `tolerance`, is divided there, if a part of it then is
// a part of another open edge, too. Its face keeps its
// plane: it gets a vertex more, or, if the rounded vertex is not on the rounded plane, becomes triangles of one surface.
//
// Faces that a chain of edges with two faces joins
// are a part; its faces are turned to agree with its first one. A closed part is a solid: outside out, in
// another one inside out, in that outside out again; a part that is open, or has but one side, is a sheet.
// Without bodies in the file each part is a body, and a cavity belongs to the solid around it; the bodies of a
// file are divided into what is solid and what is sheet. Wires that became a point, and all but one of those that
// are equal, are left out, and so are vertices that no face or wire has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The faces of a file, counted over all bodies from 0, with the coordinates before they were rounded.
struct FileFaces {
  std::span<const std::array<double, 3>> vertices;
  std::vector<VertexIndex> corners;
  std::vector<std::uint32_t> starts = {0};  // of each face in corners, and where the last one ends

  void add(std::span<const VertexIndex> outline) {
    corners.insert(corners.end(), outline.begin(), outline.end());
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  [[nodiscard]] std::size_t size() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const VertexIndex> outline(std::size_t face) const {
    return std::span(corners).subspan(starts[face], starts[face + 1] - starts[face]);
  }
};

struct MendOptions {
  double weld = 0;         // in grid steps
  bool grouped = false;    // the bodies are the file's
  double step = 1;         // of the grid, in the unit of the file
  bool rounded = false;    // coordinates of the file are not all on the grid
  double tolerance = 0;    // how far a vertex may be from an edge that it is on, in the unit of the file
  bool name_faults = false;
  unsigned jobs = 1;       // threads; the result is the same for any number
};

struct MendReport {
  std::size_t merged_vertices = 0;
  std::size_t joined_vertices = 0;    // less than a step apart in the file, at a crack
  std::size_t divided_edges = 0;      // at vertices of other faces
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
  bool crowded = false;               // so many vertices are near so many open edges that none was divided
  double helpful_weld = 0;            // the distance with which fewer sheets are left, in the unit of the file; or 0
  std::size_t sheets_with_weld = 0;   // how many are left then
};

// What became of a face of the file.
struct MendedFace {
  std::uint32_t source = 0;  // counted over all bodies of the file from 0
  bool turned = false;
};

struct MendResult {
  std::vector<MendedFace> faces;      // of the scene, counted over all bodies
  std::vector<VertexIndex> vertices;  // of each vertex of the scene, the one of the file that it was
  // Faces of the file that have an edge of the scene in common that no third face has, both in one body; in the order of the edges. A
  // face that was divided may be beside itself.
  std::vector<std::array<std::uint32_t, 2>> neighbours;
  // With name_faults: what is wrong with the file (at most most_scene_errors), named by body, face and vertex of the file from 0.
  // Empty if nothing was changed but by rounding: what became equal, lost its area or is no longer planar, and cracks no
  // wider than a step.
  std::vector<base::Error> faults = {};
};

// Of a scene of vertices and bodies without holes, indices in range and coordinates within the limit, nothing
// else checked; `file` has the same vertices and faces. What is left passes check_poly_scene but for the camera, unless no face and no wire is left.
MendResult mend(PolyScene& scene, const FileFaces& file, const MendOptions& options, MendReport& report);

// Wires from their lower vertex, ascending, each once; those from a vertex to itself are left out and counted.
void tidy_wires(std::vector<PolyWire>& wires, MendReport& report);

}  // namespace sightline::scene
