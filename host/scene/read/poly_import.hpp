// From the polyhedra of a file, whose coordinates may have fractions, to a PolyScene: rounded once, or not
// at all.
//
// A file whose coordinates are integers below poly_coordinate_limit is taken as it is: step 1, nothing
// changed. So is one that would be if it were moved to 0. All others are rounded once to a step, which follows the
// size of the scene and not its distance from 0. If every coordinate is a multiple of 0.1, 0.01 .. 0.000001 and
// half the largest side of the scene is at most 2^16 of them, that is the step and nothing is lost; else it is the
// smallest power of two that goes into half the side 2^16 times at most (a quarter of the limit, so that there is room
// for an eye outside), but no less than what the doubles of the file can distinguish. Where coordinates are larger
// than that, they are counted from the middle of the scene (PolyScene::origin). An eye farther away than that room
// makes the step longer, and an eye between the points of a file of integers makes it shorter
// (PolyImportOptions::eye).
//
// Then the faces are mended (poly_mend.hpp), and what lies in one plane is found (poly_planes.hpp); a wire of a rounded file is in
// such a plane if its ends are, within two steps and a ten-thousandth of the scene's size. Without PolyImportOptions::mend, the same
// is done, and what of it was not due to rounding alone is named as a fault of the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/watch.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_mend.hpp"

namespace sightline::scene {

// What a file says, before anything is done to it.
struct PolyMesh {
  std::string source;  // named in errors
  std::string name;
  std::vector<std::array<double, 3>> vertices;  // finite, unless there is a flaw
  std::vector<PolyBody> bodies;                 // sheet is not used; every index is below vertices.size()
  bool grouped = false;  // the bodies are the file's; if not, connected parts become bodies
  // The distance of neighbouring numbers that the file can hold where its coordinates are largest: of float32,
  // or of the last decimal written. 0: not known, and faces are planar or not by their rounded vertices.
  double precision = 0;
  // A number for the material (colour, texture, group within a body) of each face, in the order of the bodies
  // and their faces; empty if all have the same.
  std::vector<std::uint32_t> materials;
  bool materials_are_colours = false;   // of single faces: PolyScene::materials_are_colours
  std::vector<std::uint32_t> face_in_file;  // PolyScene::face_in_file, by faces in the order of the bodies; empty: the same numbers
  std::optional<std::size_t> vertical;  // the axis that the format says is upwards: 0, 1, 2 = x, y, z
  std::string unit;                     // of the coordinates, as the format says: "m", "mm", "inch"; or empty
  std::vector<std::string> notes;       // what was passed over, a phrase each: "3 statements \"s\""
  std::vector<PolyWire> wires;          // every index is below vertices.size()
  // The first coordinate that is no finite number, or face of fewer than three vertices. Mending leaves out all these
  // faces; if no other face is left, this is the error.
  std::optional<base::Error> flaw;
};

struct PolyImportOptions {
  bool mend = false;  // if not, a mesh that has to be mended is an error
  double weld = 0;  // mending, vertices at most so far apart become one; in the unit of the file
  // Mending, how far a vertex may be from the plane of a surface, in the unit of the file; by default four
  // times PolyMesh::precision, or `weld` if that is more.
  std::optional<double> planar_tolerance = {};
  std::optional<std::array<double, 3>> eye = {};  // has to have a place among the scene's coordinates; finite
  std::string folder = {};  // in which the file is, for what it refers to; empty: in none
  std::string unit = {};    // of the coordinates, where the format does not say it
  base::Watch watch = {};   // follows the reading, and may end it: Error cancelled
  unsigned jobs = 1;        // threads; the result is the same for any number
};

struct PolyImportReport {
  bool quantised = false;
  double step = 1;
  double largest_shift = 0;  // how far a coordinate was moved by rounding, in the file's unit
  bool mended = false;  // more than rounding may have changed the faces
  MendReport faces = {};
  std::optional<std::size_t> vertical = {};  // as the format says; 0, 1, 2 = x, y, z
  std::string unit = {};                  // as the format says, or else PolyImportOptions::unit
  std::vector<std::string> notes = {};    // what of the file was passed over, a phrase each
};

struct PolyImport {
  PolyScene scene;  // looked at by default_poly_camera
  PolyImportReport report;
  // Without PolyImportOptions::mend: MendResult::faults, or PolyMesh::flaw. A caller has to reject a mesh with faults; its scene is what
  // mending makes of it, and has no faces if none is left.
  std::vector<base::Error> faults = {};
};

// An error for a file of which no face is left. A scene without faults passes check_poly_scene.
[[nodiscard]] base::Result<PolyImport> import_poly(PolyMesh mesh, const PolyImportOptions& options = {});

// From above, right and in front (y is up), outside of the scene; orthographic if no such point keeps below
// poly_coordinate_limit.
[[nodiscard]] PolyCamera default_poly_camera(const PolyScene& scene);

}  // namespace sightline::scene
