// The input of a hard case, generated or read, and checked: a scene, cells, a height grid, or commands of Skala's
// program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/image.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// Commands of Skala's program and the dots that they must produce.
struct CommandScreen {
  std::vector<std::uint8_t> stream;
  picture::PixelGrid truth;
};

// An input in the form that each method takes.
struct CaseInput {
  std::optional<scene::CellScene> cells;
  std::optional<scene::PolyScene> scene;  // of cells, too
  std::optional<scene::HeightGrid> heights;
  std::vector<CommandScreen> screens;
};

// The error is the message of the reader of such files.
[[nodiscard]] base::Result<CaseInput, std::string> load_input(const HardCase& hard);

}  // namespace sightline::compare
