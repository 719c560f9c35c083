// See scene_check.hpp.
#include "host/app/commands/scene_check.hpp"

#include <optional>
#include <utility>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::app {

namespace {

using base::Error;

std::vector<base::Error> cell_scene_errors(const SceneText& file) {
  auto read = scene::read_cell_scene(file.text, file.name);
  if (!read) return {std::move(read.error())};
  return scene::check_scene(*read);
}

// Where the eye is, is known only among bodies that are in order.
std::vector<base::Error> camera_errors(const scene::PolyScene& scene) {
  auto error = scene::eye_error(scene, scene.camera);
  return error ? std::vector{std::move(*error)} : std::vector<base::Error>();
}

SceneFindings poly_findings(const SceneText& file) {
  const auto read = read_poly_text(file, false);
  if (!read) return {{read.error()}, {}};
  const auto& import = *read;
  auto errors = scene::check_poly_scene(import.scene);
  if (errors.empty()) errors = camera_errors(import.scene);
  return {std::move(errors), import.report};
}

std::vector<base::Error> cell_complex_errors(const SceneText& file) {
  auto read = scene::check_cell_complex(file.text, file.name);
  if (!read) return std::move(read.error());
  return camera_errors(read->scene);
}

}  // namespace

SceneFindings check_scene_text(const SceneText& file) {
  SceneFindings findings;
  switch (file.kind) {
    case SceneKind::cells: findings.errors = cell_scene_errors(file); break;
    case SceneKind::polyhedra: findings = poly_findings(file); break;
    case SceneKind::cell_complex: findings.errors = cell_complex_errors(file); break;
  }
  for (base::Error& error : findings.errors) error.file = file.name;
  return findings;
}

}  // namespace sightline::app
