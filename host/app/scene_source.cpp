// See scene_source.hpp.
#include "host/app/scene_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "host/app/command.hpp"
#include "host/app/commands/scene_poly.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/number.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

struct GeneratedName {
  std::string family;
  std::size_t size = 0;
  std::uint64_t seed = 1;
};

// "boxes-100" or "boxes-100-7", of a family there is.
std::optional<GeneratedName> generated_name(std::string_view text) {
  for (const std::string_view family : scene::generator_names()) {
    if (!text.starts_with(family) || !text.substr(family.size()).starts_with("-")) continue;
    std::string_view rest = text.substr(family.size() + 1);
    GeneratedName name{std::string(family)};
    if (const std::size_t dash = rest.find('-'); dash != std::string_view::npos) {
      const auto seed = base::unsigned_number(rest.substr(dash + 1));
      if (!seed) return std::nullopt;
      name.seed = *seed;
      rest = rest.substr(0, dash);
    }
    if (const auto size = base::whole_number<std::size_t>(rest)) {
      name.size = *size;
      return name;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<scene::PolyScene> generated_scene(const std::string& name) {
  std::error_code unknown;
  const auto generated = generated_name(name);
  if (!generated || std::filesystem::exists(name, unknown)) return std::nullopt;
  auto scene = scene::generate_scene(generated->family, generated->size, generated->seed);
  if (!scene) throw Failure(ExitCode::usage, scene.error().message());
  return std::move(*scene);
}

SceneSource load_scene_source(const std::string& name) {
  if (auto generated = generated_scene(name))
    return {name, std::nullopt, std::move(*generated), std::nullopt};
  const SceneText file = read_scene_text(name);
  if (file.kind == SceneKind::cell_complex) {
    auto [scene, compartments] = load_cell_complex(file);
    return {name, std::nullopt, std::move(scene), std::move(compartments.complex)};
  }
  if (file.kind == SceneKind::polyhedra) {
    scene::PolyImport import = load_poly_file(file, false);
    tell(import.report);
    return {name, std::nullopt, std::move(import.scene), std::nullopt};
  }
  scene::CellScene cells = load_scene(file.text, file.name);
  scene::PolyScene scene = scene::poly_scene_of(cells);
  return {name, std::move(cells), std::move(scene), std::nullopt};
}

}  // namespace sightline::app
