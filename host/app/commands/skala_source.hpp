// Loads the function that `sightline skala` draws: by name, from a grid file, or from an expression.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::app {

struct SkalaSource {
  std::string name_or_file;           // empty: none
  std::string expression;             // empty: none
  std::string domain;                 // "A:B", of both variables of an expression; empty: the usual one
  std::string x_range;                // "A:B", of a function that is sampled; empty: as `domain` or the function says
  std::string y_range;                // of the second variable, whatever its name
  std::vector<std::string> columns;   // of a file of points: x, y, height; empty: as its content says
  std::string layout;                 // of a file: "matrix", "table", "points"; empty: as its content says
  std::optional<double> nodata;       // of a file: heights that are holes
  std::optional<std::size_t> thin;    // of a file: every n-th point
  bool triangulate = false;           // of a file of points
  bool nets = false;                  // a file may be a net of curves
  std::optional<std::size_t> points;  // of a function or of triangulated points
  std::optional<std::size_t> slices;
  std::optional<std::size_t> subdivide;  // each cell in so many parts, by smooth curves
};

struct SkalaFunction {
  std::string name;
  std::string stem;  // for file names
  scene::HeightGrid grid;
  // Samples the same function at another size; empty for a grid, which has no values between its points.
  std::function<scene::HeightGrid(scene::GridSize)> sampled{};
  // A file's net of curves, which is no function of x and y: `grid` then has only its size and its ranges.
  std::optional<scene::SurfaceNet> net{};
};

// One line on standard error if the layout of a file was guessed, or if it was thinned or triangulated. A file "-" is standard input.
// Functions and triangulated points are sampled at the size of the source, or at `usual`; other files have their own size.
// Error usage: no function, two of them, options that do not apply, a wrong expression or domain. Error io: neither a name nor a file.
// Error bad_input: the file is wrong.
// `subdivide` cuts cells along the slices of `cut`, or along both axes.
[[nodiscard]] SkalaFunction load_skala_function(const SkalaSource& source, scene::GridSize usual,
                                                algorithms::skala::Family cut = algorithms::skala::Family::both);

// Whether a name is that of a function, or of a file that is no scene by its ending.
[[nodiscard]] bool is_height_function(const std::string& name);

}  // namespace sightline::app
