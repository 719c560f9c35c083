// A cell complex as a file: to be inspected, kept, or made by another program, and drawn without being cut
// again. It saves the choice of cuts, not time: with all checks a file of 2000 boxes is read in about three
// times what cutting them again takes.
//
// Format, JSON: {"schema": "sightline/cell-complex/2", "method": "grid"|"bsp", "outer": [low, high], "edges",
// "planes", "cells", "openings", "polyhedra"}, the schema first. "polyhedra" is the scene the cells were made
// of (poly_json.hpp); vertices are its. An edge is [from, to]. A plane is [x, y, z, offset] of its
// normal and offset. A half-space is a number: n >= 0 where plane n is not positive, -1 - n where plane n is
// not negative. A cell is {"bounds": half-spaces, "lines": [[edge, a, b, c, d]...], "openings": numbers}: a
// line is from a/b to c/d of its edge. An opening is {"cells": [on the negative side, on the positive],
// "plane", "sides": half-spaces}; the cell outside is null. All of it is as CellComplex
// (host/scene/model/cell_complex.hpp) says.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct CellComplexFile {
  PolyScene scene;  // checked
  Decomposition decomposition;
};

// The complex is of this scene, which is a checked one (precondition). The text comes piece by piece: that of
// a large scene is longer than the scene itself.
void write_cell_complex(const PolyScene& scene, const Decomposition& decomposition,
                        const std::function<void(std::string_view)>& write);

// All errors there are of the first kind found: of the form (the first alone), of the scene
// (check_poly_scene), or of the cells (check_complex, which does not notice a missing part of an edge). A
// syntax error names line and column.
using CheckedCellComplex = base::Result<CellComplexFile, std::vector<base::Error>>;
[[nodiscard]] CheckedCellComplex check_cell_complex(std::string_view json, std::string_view source);

// The first of these errors.
[[nodiscard]] base::Result<CellComplexFile> read_cell_complex(std::string_view json, std::string_view source);

// By the schema at its beginning, of any version.
[[nodiscard]] bool is_cell_complex(std::string_view text);

}  // namespace sightline::scene
