// See scene_argument.hpp.
#include "host/app/scene_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <variant>

#include "host/app/command.hpp"
#include "host/scene/builtin.hpp"
#include "host/scene/read.hpp"

namespace sightline::app {

void require_scene_exists(const std::string& name_or_file) {
  std::error_code unknown;
  if (scene::builtin_scene_text(name_or_file) || std::filesystem::exists(name_or_file, unknown)) return;
  std::string names;
  for (const std::string_view name : scene::builtin_scene_names()) names += fmt::format(" {}", name);
  throw Failure(ExitCode::io, fmt::format("{}: no such file, and no built-in scene of that name; there are{}",
                                          name_or_file, names));
}

scene::CellScene load_scene(const std::string& name_or_file) {
  require_scene_exists(name_or_file);
  if (const auto builtin = scene::builtin_scene_text(name_or_file)) return load_scene(*builtin, name_or_file);
  return load_scene(read_input_text(name_or_file), name_or_file);
}

scene::CellScene load_scene(std::string_view text, const std::string& name_or_file) {
  auto read = scene::read_possible_cell_scene(text, name_or_file);
  if (const auto* error = std::get_if<scene::SceneError>(&read))
    throw Failure(ExitCode::bad_input, error->message());
  return std::get<scene::CellScene>(std::move(read));
}

geometry::Point point_argument(std::string_view option, std::string_view text) {
  constexpr std::int32_t too_large = 1 << 15;
  geometry::Point point{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (std::size_t axis = 0; axis < point.size() && good; ++axis) {
    std::int32_t value = 0;
    const auto [after, error] = std::from_chars(at, end, value);
    const bool last = axis + 1 == point.size();
    good = error == std::errc{} && value > -too_large && value < too_large &&
           (last ? after == end : after != end && *after == ',');
    point[axis] = value;
    at = last ? after : after + 1;
  }
  if (!good) {
    throw Failure(ExitCode::usage,
                  fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from -32767 to 32767",
                              option, text));
  }
  return point;
}

}  // namespace sightline::app
