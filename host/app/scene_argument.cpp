// See scene_argument.hpp.
#include "host/app/scene_argument.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>

#include "host/app/command.hpp"
#include "host/base/number.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::app {

namespace {

constexpr const char* cells_expected =
    "expected a scene of cells, which Jones's program can be given; `sightline draw jones` takes all scenes";

bool is_generated_name(std::string_view name) {
  for (const std::string_view family : scene::generator_names())
    if (name.starts_with(family) && name.substr(family.size()).starts_with("-")) return true;
  return false;
}

// By the file's name, or JSON of another kind.
bool is_no_cell_scene(const std::string& text, const std::string& file) {
  return scene::poly_format_of(file).value_or(scene::PolyFormat::json) != scene::PolyFormat::json ||
         scene::is_poly_json(text) || scene::is_cell_complex(text);
}

}  // namespace

void require_scene_exists(const std::string& name_or_file) {
  std::error_code unknown;
  if (scene::builtin_scene_text(name_or_file) || std::filesystem::exists(name_or_file, unknown)) return;
  std::string names;
  for (const std::string_view name : scene::builtin_scene_names()) names += fmt::format(" {}", name);
  throw Failure(ExitCode::io, fmt::format("{}: no such file, and no built-in scene of that name; there are{}",
                                          name_or_file, names));
}

scene::CellScene load_scene(const std::string& name_or_file) {
  std::error_code unknown;
  if (is_generated_name(name_or_file) && !std::filesystem::exists(name_or_file, unknown)) {
    throw Failure(ExitCode::usage,
                  fmt::format("{}: found the name of a generated scene, {}", name_or_file, cells_expected));
  }
  require_scene_exists(name_or_file);
  if (const auto builtin = scene::builtin_scene_text(name_or_file)) return load_scene(*builtin, name_or_file);
  const std::string text = read_input_text(name_or_file);
  if (is_no_cell_scene(text, name_or_file))
    throw Failure(ExitCode::bad_input, fmt::format("{}: found polyhedra, {}", name_or_file, cells_expected));
  return load_scene(text, name_or_file);
}

scene::CellScene load_scene(std::string_view text, const std::string& name_or_file) {
  auto read = scene::read_possible_cell_scene(text, name_or_file);
  if (!read) throw Failure(ExitCode::bad_input, read.error().message());
  return std::move(*read);
}

geometry::Point point_argument(std::string_view option, std::string_view text) {
  constexpr std::int32_t most = 32767;
  if (const auto point = base::whole_numbers<std::int32_t, 3>(text, ',', -most, most)) return *point;
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from -32767 to 32767",
                            option, text));
}

}  // namespace sightline::app
