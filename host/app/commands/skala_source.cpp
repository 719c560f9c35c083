#include "host/app/commands/skala_source.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "host/algorithms/skala/surface.hpp"
#include "host/app/command.hpp"
#include "host/app/outputs.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/expression.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/heights/read_grid.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

template <class Value>
Value value_or_throw(base::Result<Value> result, base::ErrorKind kind) {
  if (!result) throw base::error_of(kind, result.error().message(base::MessageStyle::position));
  return std::move(*result);
}

scene::GridSize size_of(const SkalaSource& source, scene::GridSize usual) {
  return {source.points.value_or(usual.points), source.slices.value_or(usual.slices)};
}

// The domain of the options; parts that are not given are those of `usual`.
scene::HeightDomain domain_of(const SkalaSource& source, scene::HeightDomain usual) {
  const auto read = [](const std::string& text, const char* option, scene::Interval otherwise) {
    return text.empty() ? otherwise : value_or_throw(scene::read_domain(text, option), base::ErrorKind::usage);
  };
  const scene::Interval x = read(source.domain, "--domain", usual.x);
  const scene::Interval z = read(source.domain, "--domain", usual.z);
  return {read(source.x_range, "--x-range", x), read(source.y_range, "--y-range", z)};
}

SkalaFunction from_expression(const SkalaSource& source, scene::GridSize size) {
  const scene::HeightDomain domain = domain_of(source, {scene::expression_domain, scene::expression_domain});
  const auto sampled = [expression = source.expression, domain](scene::GridSize at) {
    return value_or_throw(scene::sample_expression(expression, domain, at), base::ErrorKind::usage);
  };
  return {source.expression, "function", sampled(size), sampled};
}

SkalaFunction from_name(const SkalaSource& source, const scene::HeightFunction& function, scene::GridSize size) {
  const std::string& name = source.name_or_file;
  const bool own_domain = source.x_range.empty() && source.y_range.empty();
  if (function.value == nullptr && own_domain) return {name, file_stem(name), scene::sample(function, size)};
  if (function.value == nullptr)
    throw base::usage_error(fmt::format("{}: found with {}, which has no values between its points", source.x_range.empty() ? "--y-range" : "--x-range", name));
  const auto sampled = [function, domain = domain_of(source, {function.domain, function.domain})](scene::GridSize at) {
    return scene::sample(function, domain, at);
  };
  return {name, file_stem(name), sampled(size), sampled};
}

scene::GridLayout layout_named(const std::string& name) {
  if (name == "matrix") return scene::GridLayout::matrix;
  if (name == "table") return scene::GridLayout::table;
  return name == "points" ? scene::GridLayout::points : scene::GridLayout::by_content;
}

bool named_as_mesh(std::string_view name) {
  constexpr std::array<std::string_view, 7> endings{".off", ".obj", ".stl", ".ply", ".gltf", ".glb", ".3mf"};
  return std::any_of(endings.begin(), endings.end(), [name](std::string_view ending) { return name.ends_with(ending); });
}

// What a net has in common with a grid.
scene::HeightGrid grid_of(const scene::SurfaceNet& net) {
  const auto ranges = net.ranges();
  return {scene::even_positions(net.points), scene::even_positions(net.curves), {}, ranges[0], ranges[1], ranges[2], net.names, net.note};
}

void take_surface(base::Result<scene::HeightSurface> read, bool nets, SkalaFunction& function) {
  scene::HeightSurface surface = value_or_throw(std::move(read), base::ErrorKind::bad_input);
  if (auto* const grid = std::get_if<scene::HeightGrid>(&surface)) {
    function.grid = std::move(*grid);
    return;
  }
  function.net = std::get<scene::SurfaceNet>(std::move(surface));
  if (!nets) {
    throw base::Error{.file = function.name,
                      .found = "found a net of curves that is no grid, a parametric surface",
                      .expected = "heights over a grid",
                      .remedy = "draw it by: sightline draw skala " + function.name};
  }
  function.grid = grid_of(*function.net);
}

// `size`: the sampling of triangulated points.
SkalaFunction from_file(const SkalaSource& source, scene::GridSize size) {
  const std::string& file = source.name_or_file;
  std::error_code unknown;
  if (file != "-" && !std::filesystem::exists(file, unknown)) {
    std::vector<std::string> names;
    for (const auto& function : scene::height_functions()) names.emplace_back(function.name);
    throw base::Error{.file = file,
                      .found = "no such file, and no function of that name",
                      .expected = "a grid file or one of " + scene::height_function_names(),
                      .remedy = base::did_you_mean(file, names),
                      .kind = base::ErrorKind::io};
  }
  if (named_as_mesh(file)) {
    throw base::Error{.file = file,
                      .found = "found a mesh",
                      .expected = "a grid of heights",
                      .remedy = "draw it by: sightline draw exact " + file};
  }
  if ((source.points || source.slices) && !source.triangulate)
    throw base::usage_error(fmt::format("{}: a grid file has its own size; found --points or --slices without --triangulate", display_name(file)));
  if (!source.x_range.empty() || !source.y_range.empty())
    throw base::usage_error(fmt::format("{}: a grid file has its own ranges; found --x-range or --y-range", display_name(file)));
  if (source.nodata) require_finite("--nodata", *source.nodata);
  scene::GridFileOptions options{source.columns, layout_named(source.layout), source.nodata, source.thin, false, {}};
  if (source.triangulate) options.triangulate = size;
  SkalaFunction function;
  function.name = display_name(file);
  if (file == "-") {
    function.stem = "standard-input";
    take_surface(scene::read_height_surface(read_input_text(file), function.name, options), source.nets, function);
  } else {
    function.stem = file_stem(std::filesystem::path(file).stem().string());
    take_surface(scene::load_height_surface(file, options), source.nets, function);
  }
  if (!function.grid.note.empty()) print_message(fmt::format("{}: {}", function.name, function.grid.note));
  return function;
}

SkalaFunction load_whole(const SkalaSource& source, scene::GridSize usual) {
  if (source.name_or_file.empty() == source.expression.empty()) {
    throw base::usage_error(fmt::format("found {}, expected one: a name ({}), a grid file, or --function EXPRESSION",
                              source.expression.empty() ? "no function to draw" : "two functions to draw",
                              scene::height_function_names()));
  }
  const scene::GridSize size = size_of(source, usual);
  if (!source.columns.empty() && source.columns.size() != 3)
    throw base::usage_error(fmt::format("--xyz: found {} columns, expected three: x, y and height", source.columns.size()));
  if (!source.columns.empty() && !source.layout.empty() && source.layout != "points")
    throw base::usage_error(fmt::format("--xyz: found with --layout {}, expected it with a file of points", source.layout));
  if (source.triangulate && (source.layout == "matrix" || source.layout == "table"))
    throw base::usage_error(fmt::format("--triangulate: found with --layout {}, expected it with a file of points", source.layout));
  const auto function = scene::height_function(source.name_or_file);
  if (!source.expression.empty() || function) {
    if (!source.columns.empty()) throw base::usage_error("--xyz: found without a grid file");
    if (!source.layout.empty()) throw base::usage_error("--layout: found without a grid file");
    if (source.nodata) throw base::usage_error("--nodata: found without a grid file");
    if (source.thin) throw base::usage_error("--thin: found without a grid file");
    if (source.triangulate) throw base::usage_error("--triangulate: found without a file of points");
  }
  if (!source.expression.empty()) return from_expression(source, size);
  if (!source.domain.empty())
    throw base::usage_error("--domain: found without --function; names and grid files have their own");
  return function ? from_name(source, *function, size) : from_file(source, size);
}

}  // namespace

SkalaFunction load_skala_function(const SkalaSource& source, scene::GridSize usual, algorithms::skala::Family cut) {
  SkalaFunction function = load_whole(source, usual);
  if (!source.subdivide) return function;
  if (function.net) throw base::usage_error(fmt::format("--subdivide: expected a surface over a grid; {} is a net of curves", function.name));
  function.grid = value_of(algorithms::skala::finer_mesh(function.grid, *source.subdivide, cut), function.name);
  return function;
}

bool is_height_function(const std::string& name) {
  if (scene::builtin_scene_text(name)) return false;
  if (scene::height_function(name)) return true;
  std::error_code unknown;
  return std::filesystem::exists(name, unknown) && !named_as_mesh(name) && !name.ends_with(".json");
}

}  // namespace sightline::app
