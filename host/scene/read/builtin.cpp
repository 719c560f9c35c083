#include "host/scene/read/builtin.hpp"

#include <span>
#include <utility>

namespace sightline::scene {

// Defined in the source that cmake/embed.cmake generates from builtin/.
std::span<const std::pair<std::string_view, std::string_view>> builtin_scene_files();

namespace {

std::string_view without_extension(std::string_view file) {
  return file.substr(0, file.rfind('.'));
}

std::vector<std::string_view> names_of_files(std::string_view ending) {
  std::vector<std::string_view> names;
  for (const auto& [file, text] : builtin_scene_files()) {
    if (file.ends_with(ending)) names.push_back(without_extension(file));
  }
  return names;
}

}  // namespace

std::vector<std::string_view> builtin_scene_names() {
  return names_of_files(".json");
}

std::vector<std::string_view> builtin_model_names() {
  return names_of_files(".off");
}

std::optional<std::string_view> builtin_scene_text(std::string_view name) {
  for (const auto& [file, text] : builtin_scene_files()) {
    if (without_extension(file) == name) return text;
  }
  return std::nullopt;
}

}  // namespace sightline::scene
