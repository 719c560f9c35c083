// Reading a PolyScene from JSON, the only format that keeps everything: holes, sheets, the camera.
//
// Format: {"name", "step", "origin": [x,y,z], "vertices": [[x,y,z]...], "bodies": [{"name", "sheet":
// true|false, "faces": [face...]}...], "camera": {"perspective": true|false, "eye", "forward", "right", "up":
// [x,y,z]}}. A face is an array of vertices, [0,1,2], or {"outline": [...], "holes": [[...]...]}; vertices
// count from 0. Required are "vertices", "bodies" and a body's "faces"; without "sheet" a body is a sheet
// unless it is closed; without "camera" the camera is above, right and in front; within one,
// "perspective" is true unless said. Everything else is ignored. Coordinates are integers, and "step" says
// what one unit stands for (default 1); "origin" is added before that. Names are up to 200 printable ASCII
// characters. Of a mesh, "surfaces": [[x,y,z]...] are the normals of its surfaces, "surface_of" the surface of
// each face, counted over all bodies, and "material_of" its material; with "materials_are_colours": true the materials
// are colours of single faces, whose borders are drawn only where they are asked for. "wires": [[a,b]...] are lines of no
// face, from vertex to vertex, and "wires_on": [[w,s]...] numbers of a wire and of a surface in whose plane it lies. Reading
// checks form only: check_poly_scene the rest.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The first error found; a syntax error names line and column.
[[nodiscard]] base::Result<PolyScene> read_poly_json(std::string_view json, std::string_view source);

// A JSON object with a field "bodies", as opposed to a cell scene. False for text that is no JSON.
[[nodiscard]] bool is_poly_json(std::string_view text);

}  // namespace sightline::scene
