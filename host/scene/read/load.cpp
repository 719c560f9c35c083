#include "host/scene/read/load.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/grid_formats.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/json_documents.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/stl.hpp"

namespace sightline::scene {
namespace {

struct GeneratedSceneName {
  std::string_view family;
  std::size_t size = 0;
  std::uint64_t seed = 0;
};

// "boxes-100" or "boxes-100-7", of a known family.
std::optional<GeneratedSceneName> generated_name(std::string_view text) {
  for (const std::string_view family : generator_names()) {
    if (!text.starts_with(family) || !text.substr(family.size()).starts_with("-")) continue;
    std::string_view rest = text.substr(family.size() + 1);
    GeneratedSceneName name{family, 0, 1};
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

void take_cells(base::Result<CellScene> cells, SceneReading& reading) {
  reading.loaded.kind = SceneKind::cells;
  if (!cells) {
    reading.errors.push_back(std::move(cells.error()));
    return;
  }
  reading.errors = check_scene(*cells);
  if (reading.errors.empty()) reading.loaded.scene = poly_scene_of(*cells);
  reading.loaded.cells = std::move(*cells);
}

void take_polyhedra(base::Result<PolyImport> import, SceneReading& reading) {
  reading.loaded.kind = SceneKind::polyhedra;
  if (!import) {
    reading.errors.push_back(std::move(import.error()));
    return;
  }
  reading.loaded.scene = std::move(import->scene);
  reading.loaded.report = std::move(import->report);
  reading.errors = std::move(import->faults);
}

// A scene that no mesh was imported for.
void take_unchanged(PolyScene scene, SceneReading& reading) {
  take_polyhedra(import_unchanged(std::move(scene)), reading);
  reading.errors = check_poly_scene(reading.loaded.scene);
}

void take_complex(CheckedCellComplex complex, SceneReading& reading) {
  reading.loaded.kind = SceneKind::cell_complex;
  if (!complex) {
    reading.errors = std::move(complex.error());
    return;
  }
  reading.loaded.scene = std::move(complex->scene);
  reading.loaded.decomposition = std::move(complex->decomposition);
}

// Of a file that is no JSON by its name and by how it begins.
base::Error unknown_format(const SceneFile& file) {
  const std::string_view rest = std::string_view(file.text).substr(std::min(file.text.find_first_not_of(" \t\r\n"), file.text.size()));
  const bool numbers = !rest.empty() && std::string_view("0123456789+-.#").find(rest.front()) != std::string_view::npos;
  return {file.name, "", "found no known format", "STL, PLY, OFF, OBJ, glTF, 3MF or a scene as JSON",
          numbers || grid_format_of(file.text, file.name) != nullptr ? "a grid of heights is drawn by: sightline draw skala " + file.name : "save it in one of these"};
}

bool begins_as_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

// The kind of a document is determined before its contents are read.
void read_json(const SceneFile& file, SceneReading& reading) {
  const bool names_its_schema = is_cell_complex(file.text);
  auto document = base::parse_json(file.text, file.name);
  if (!document) {
    reading.loaded.kind = names_its_schema ? SceneKind::cell_complex : SceneKind::cells;
    const bool is_json = file.builtin || file.name.ends_with(".json") || begins_as_json(file.text);
    reading.errors.push_back(is_json ? std::move(document.error()) : unknown_format(file));
  } else if (names_its_schema) {
    take_complex(cell_complex_of(*document, file.name), reading);
  } else if (is_poly_document(*document)) {
    auto scene = poly_scene_of(*document, file.name);
    if (scene) {
      take_unchanged(std::move(*scene), reading);
    } else {
      take_polyhedra(std::move(scene.error()), reading);
    }
  } else {
    take_cells(cell_scene_of(*document, file.name), reading);
  }
}

}  // namespace

std::optional<base::Result<SceneFile>> named_scene(const std::string& name) {
  if (const auto generated = generated_name(name);
      generated && base::file_status(name).kind == base::FileStatus::Kind::none) {
    auto scene = generate_scene(generated->family, generated->size, generated->seed);
    if (!scene) return std::move(scene.error());
    return SceneFile{.name = name, .generated = std::move(*scene)};
  }
  const auto models = builtin_model_names();
  const bool is_model = std::find(models.begin(), models.end(), name) != models.end();
  // A file of that name is meant, as for generated scenes.
  if (is_model && base::file_status(name).kind != base::FileStatus::Kind::none) return std::nullopt;
  if (const auto text = builtin_scene_text(name))
    return SceneFile{.name = name, .text = std::string(*text), .builtin = true};
  return std::nullopt;
}

std::optional<CellComplex> own_cells(const LoadedScene& loaded) {
  if (loaded.decomposition) return loaded.decomposition->complex;
  if (loaded.cells) return complex_of(*loaded.cells, loaded.scene);
  return std::nullopt;
}

bool can_be_mended(const SceneFile& file) {
  return !file.builtin && !file.generated &&
         poly_format_of(file.name, base::without_byte_order_mark(file.text)) != PolyFormat::json;
}

SceneReading read_scene(SceneFile file, const PolyImportOptions& options) {
  SceneReading reading;
  reading.loaded.name = file.name;
  file.text.erase(0, file.text.size() - base::without_byte_order_mark(file.text).size());
  const PolyFormat format = poly_format_of(file.name, file.text);
  if (file.generated) {
    take_unchanged(std::move(*file.generated), reading);
  } else if (base::begins_as_utf_16(file.text) && !begins_as_binary_stl(file.text)) {
    if (format == PolyFormat::json) reading.loaded.kind = SceneKind::cells;
    reading.errors.push_back({file.name, "", "found a text in UTF-16", "UTF-8 or ASCII", "save it as UTF-8"});
  } else if (format == PolyFormat::json || is_cell_complex(file.text)) {
    read_json(file, reading);
  } else {
    auto mesh = read_mesh(file.text, file.name, format, file.folder, options.jobs);
    std::string().swap(file.text);  // its memory is needed for mending
    if (mesh) {
      take_polyhedra(import_poly(std::move(*mesh), options), reading);
    } else {
      take_polyhedra(std::move(mesh.error()), reading);
    }
  }
  for (base::Error& error : reading.errors) error.file = file.name;
  return reading;
}

base::Result<LoadedScene> scene_or_error(SceneReading reading) {
  if (reading.errors.empty()) return std::move(reading.loaded);
  // The errors of a cell decomposition follow from each other more often than not.
  return reading.loaded.kind == SceneKind::cell_complex ? std::move(reading.errors.front()) : first_of(reading.errors);
}

base::Result<LoadedScene> load_scene(SceneFile file, const PolyImportOptions& options) {
  // What a generator makes is in order: tests check every family.
  if (file.generated) return LoadedScene{.name = file.name, .scene = std::move(*file.generated)};
  return scene_or_error(read_scene(std::move(file), options));
}

}  // namespace sightline::scene
