// Loads the function that `sightline skala` draws: by name, from a grid file, or from an expression.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/heights/grid.hpp"

namespace sightline::app {

struct SkalaSource {
  std::string name_or_file;           // empty: none
  std::string expression;             // empty: none
  std::string domain;                 // "A:B", for both variables of an expression; empty: the default
  std::string x_range;                // "A:B", for a sampled function; empty: that of `domain` or of the function
  std::string y_range;                // of the second variable, y or z
  std::vector<std::string> columns;   // of a file of points: x, y, height; empty: by its content
  std::string layout;                 // of a file: "matrix", "table", "points"; empty: by its content
  std::optional<std::size_t> points;  // only for functions that are sampled
  std::optional<std::size_t> slices;
};

struct SkalaFunction {
  std::string name;
  std::string stem;  // for file names
  scene::HeightGrid grid;
  // Samples the same function at another size; empty for a grid, which has no values between its points.
  std::function<scene::HeightGrid(scene::GridSize)> sampled{};
};

// Loads the function. It is sampled at the requested size, by default `usual`; a file has its own size. A file "-" is standard input.
// If the layout of a file was guessed, one line on standard error says so. Error usage: no function, two functions, options that do
// not apply, an error in an expression or domain. Error io: neither a function nor a file. Error bad_input: the file is wrong.
[[nodiscard]] SkalaFunction load_skala_function(const SkalaSource& source, scene::GridSize usual);

// Whether a name among scenes and functions is a function: its name, or a file whose extension is not that of a scene.
[[nodiscard]] bool is_height_function(const std::string& name);

}  // namespace sightline::app
