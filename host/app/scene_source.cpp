// See scene_source.hpp.
#include "host/app/scene_source.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "host/app/command.hpp"
#include "host/app/scene_argument.hpp"
#include "host/app/commands/scene_poly.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::app {

namespace {

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

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
      if (!read_number(rest.substr(dash + 1), name.seed)) return std::nullopt;
      rest = rest.substr(0, dash);
    }
    if (read_number(rest, name.size)) return name;
  }
  return std::nullopt;
}

}  // namespace

std::optional<scene::PolyScene> generated_scene(const std::string& name) {
  std::error_code unknown;
  const auto generated = generated_name(name);
  if (!generated || std::filesystem::exists(name, unknown)) return std::nullopt;
  auto scene = scene::generate_scene(generated->family, generated->size, generated->seed);
  if (const auto* error = std::get_if<scene::SceneError>(&scene))
    throw Failure(ExitCode::usage, error->message());
  return std::get<scene::PolyScene>(std::move(scene));
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
