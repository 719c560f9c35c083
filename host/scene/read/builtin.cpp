#include "host/scene/read/builtin.hpp"

#include <span>
#include <utility>

namespace sightline::scene {

// Defined in the source that cmake/embed.cmake generates from builtin/*.json.
std::span<const std::pair<std::string_view, std::string_view>> builtin_scene_files();

namespace {

std::string_view without_extension(std::string_view file) {
  return file.substr(0, file.rfind('.'));
}

}  // namespace

std::vector<std::string_view> builtin_scene_names() {
  std::vector<std::string_view> names;
  for (const auto& [file, text] : builtin_scene_files()) names.push_back(without_extension(file));
  return names;
}

std::optional<std::string_view> builtin_scene_text(std::string_view name) {
  for (const auto& [file, text] : builtin_scene_files()) {
    if (without_extension(file) == name) return text;
  }
  return std::nullopt;
}

}  // namespace sightline::scene
