// What the languages' libraries have in common: the types of the C++ library from and to those of host/hidden_lines, with
// Results instead of exceptions, so that it also compiles for WebAssembly.
#pragma once

#include <string>

#include "host/base/result.hpp"
#include "host/base/watch.hpp"
#include "host/bindings/cpp/hidden_lines.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline {

struct Drawing::Picture {
  picture::VectorDrawing drawing;
  double width = 0;
  double height = 0;
};

namespace bindings {

// Progress functions in options are not called: the watch is used instead. Error cancelled: it ended the work.

// Error bad_input: sizes that do not add up, or as hidden_lines::load.
[[nodiscard]] base::Result<hidden_lines::Scene> load(const Mesh& mesh, const LoadOptions& options, const base::Watch& watch);
// Of a file by its name.
[[nodiscard]] base::Result<hidden_lines::Scene> load(const std::string& path, const LoadOptions& options, const base::Watch& watch);

// Error usage: an option is wrong; Error::file is its name.
[[nodiscard]] base::Result<hidden_lines::ViewOptions> view_options(const DrawOptions& options, const hidden_lines::Scene& scene);

// Errors as those of Scene::draw. `options` were made for `views`.
[[nodiscard]] base::Result<Drawing> draw(const hidden_lines::Scene& scene, const hidden_lines::Views& views, const Camera& camera,
                                         const DrawOptions& options, const base::Watch& watch);

[[nodiscard]] base::Result<std::string> file_of(const Drawing& drawing, const FileOptions& options);

// Sentences on what was changed.
[[nodiscard]] std::vector<std::string> notes_of(const hidden_lines::Scene& scene);

}  // namespace bindings
}  // namespace sightline
