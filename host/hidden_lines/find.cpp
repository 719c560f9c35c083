// Finds and loads scenes by name; see hidden_lines.hpp.
#include <filesystem>
#include <system_error>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/text.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::hidden_lines {

base::Result<scene::SceneFile> find(const std::string& name) {
  if (auto named = scene::named_scene(name)) {
    if (!*named) named->error().kind = base::ErrorKind::usage;
    return std::move(*named);
  }
  std::error_code unknown;
  if (!std::filesystem::exists(name, unknown)) {
    std::vector<std::string> names;
    for (const std::string_view each : scene::builtin_scene_names()) names.emplace_back(each);
    for (const std::string_view each : scene::builtin_model_names()) names.emplace_back(each);
    return base::Error{.file = name,
                       .found = "no such file, and no built-in scene of that name",
                       .expected = "a file, FAMILY-SIZE or one of " + base::joined(names, ", "),
                       .remedy = base::did_you_mean(name, names),
                       .kind = base::ErrorKind::io};
  }
  auto text = base::read_text(name);
  if (!text) {
    text.error().kind = base::ErrorKind::io;
    return std::move(text.error());
  }
  std::string folder = std::filesystem::path(name).parent_path().string();
  if (folder.empty()) folder = ".";
  return scene::SceneFile{.name = name, .text = std::move(*text), .folder = std::move(folder)};
}

base::Result<Scene> load(scene::SceneFile file, const LoadOptions& options) { return scene::load_scene(std::move(file), options); }

base::Result<Scene> load(const std::string& name, const LoadOptions& options) {
  auto file = find(name);
  if (!file) return std::move(file.error());
  return load(std::move(*file), options);
}

}  // namespace sightline::hidden_lines
