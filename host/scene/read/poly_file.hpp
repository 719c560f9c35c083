// Scenes of polyhedra as files: which format a file has, reading it, writing one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

enum class PolyFormat { off, obj, stl, ply, json, gltf, glb, threemf };

// For texts that name what can be written.
inline constexpr std::string_view poly_endings = ".json, .off, .obj, .stl or .ply";

// Of glTF and 3MF there are no writers.
[[nodiscard]] constexpr bool can_be_written(PolyFormat format) {
  return format != PolyFormat::gltf && format != PolyFormat::glb && format != PolyFormat::threemf;
}

// By the end of the file's name, such as .off, in small or capital letters.
[[nodiscard]] std::optional<PolyFormat> poly_format_of(std::string_view file);
// By what the text begins with; if that says nothing, as above; else JSON.
[[nodiscard]] PolyFormat poly_format_of(std::string_view file, std::string_view text);

// A fault of a mesh is an error unless it is mended. JSON is not quantised, repaired or checked.
[[nodiscard]] base::Result<PolyImport> read_poly(std::string_view text, std::string_view source,
                                                 PolyFormat format, const PolyImportOptions& options = {});

// What the file of a mesh says, before anything is done to it; `folder` and `jobs` as PolyImportOptions has them. Not of JSON.
[[nodiscard]] base::Result<PolyMesh> read_mesh(std::string_view text, std::string_view source, PolyFormat format,
                                               const std::string& folder, unsigned jobs = 1);

// What reading says of a scene that was not quantised: JSON, or generated.
[[nodiscard]] PolyImport import_unchanged(PolyScene scene);

// The text of a file, of a format that can be written and a checked scene, in the coordinates of the file the
// scene came from (times step); JSON has the integers themselves. OFF and OBJ have no holes: a face with
// holes is written as triangles, which hide the same; the diagonals are seams. STL (binary, float32) has
// triangles only, PLY (binary) no holes either. An error names a face for which that cannot be done, or says that there
// are wires, which only OBJ and JSON keep. None
// keeps the camera. OFF, STL and PLY have no names, nor which faces make a body: read again, connected parts
// are the bodies. In OBJ names that are ambiguous or could not be read again are changed.
[[nodiscard]] base::Result<std::string> write_poly(const PolyScene& scene, PolyFormat format);

}  // namespace sightline::scene
