// The scenes of a JSON document that was read before, so that a file of unknown kind is parsed once. `source`
// is named in errors. Functions of the same names in cell_scene.hpp, poly_json.hpp and cell_complex_file.hpp
// read texts.
#pragma once

#include <string_view>

#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/cell_complex_file.hpp"

namespace sightline::scene {

[[nodiscard]] base::Result<CellScene> cell_scene_of(const base::Json& document, std::string_view source);
// An object with a field "bodies", as opposed to a cell scene.
[[nodiscard]] bool is_poly_document(const base::Json& document);
[[nodiscard]] base::Result<PolyScene> poly_scene_of(const base::Json& document, std::string_view source);
[[nodiscard]] CheckedCellComplex cell_complex_of(const base::Json& document, std::string_view source);

}  // namespace sightline::scene
