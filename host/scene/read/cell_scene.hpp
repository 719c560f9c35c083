// Reading a CellScene from JSON.
//
// Format: {"name", "outer": [low, high], "solids": [[low, high]...], "walls": [[axis, c,
// [[u0,u1],[v0,v1]]]...], "default_view": [x,y,z], "cells": [[low, high]...], "openings": [{"cells": [low
// side, high side], "axis", "c", "rect": [[u0,u1],[v0,v1]], "ring": [4 corners], "vectors": [[F, "i"|"j"|"k",
// magnitude]...]}...], "cell_lines": [[[from, to]...] for each cell]}. All are required, others are ignored.
// Coordinates are integers below 2^15 in magnitude. Reading checks form only; what the numbers mean is
// checked by check_scene.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

// `source` is named in errors. The first error found is returned; a syntax error names line and column.
[[nodiscard]] base::Result<CellScene> read_cell_scene(std::string_view json, std::string_view source);

// Read and checked, so that what is returned is a possible scene. Of several errors of a check the first is
// returned, with their number.
[[nodiscard]] base::Result<CellScene> read_possible_cell_scene(std::string_view json,
                                                               const std::string& source);

// A built-in name, or else a file (at most 64 MiB), read as by read_possible_cell_scene.
[[nodiscard]] base::Result<CellScene> load_cell_scene(const std::string& name_or_file);

}  // namespace sightline::scene
