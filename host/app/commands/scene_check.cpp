// See scene_check.hpp.
#include "host/app/commands/scene_check.hpp"

#include <optional>
#include <utility>
#include <variant>

#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::app {

namespace {

using scene::SceneError;

std::vector<SceneError> cell_scene_errors(const SceneText& file) {
  auto read = scene::read_cell_scene(file.text, file.name);
  if (auto* error = std::get_if<SceneError>(&read)) return {std::move(*error)};
  return scene::check_scene(std::get<scene::CellScene>(read));
}

// Where the eye is, is known only among bodies that are in order.
std::vector<SceneError> camera_errors(const scene::PolyScene& scene) {
  auto error = scene::eye_error(scene, scene.camera);
  return error ? std::vector{std::move(*error)} : std::vector<SceneError>();
}

SceneFindings poly_findings(const SceneText& file) {
  const auto read = read_poly_text(file, false);
  if (const auto* error = std::get_if<SceneError>(&read)) return {{*error}, {}};
  const auto& import = std::get<scene::PolyImport>(read);
  auto errors = scene::check_poly_scene(import.scene);
  if (errors.empty()) errors = camera_errors(import.scene);
  return {std::move(errors), import.report};
}

std::vector<SceneError> cell_complex_errors(const SceneText& file) {
  auto read = scene::check_cell_complex(file.text, file.name);
  if (auto* errors = std::get_if<std::vector<SceneError>>(&read)) return std::move(*errors);
  return camera_errors(std::get<scene::CellComplexFile>(read).scene);
}

}  // namespace

SceneFindings check_scene_text(const SceneText& file) {
  SceneFindings findings;
  switch (file.kind) {
    case SceneKind::cells: findings.errors = cell_scene_errors(file); break;
    case SceneKind::polyhedra: findings = poly_findings(file); break;
    case SceneKind::cell_complex: findings.errors = cell_complex_errors(file); break;
  }
  for (SceneError& error : findings.errors) error.source = file.name;
  return findings;
}

}  // namespace sightline::app
