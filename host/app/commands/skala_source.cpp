#include "host/app/commands/skala_source.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <system_error>
#include <string>
#include <utility>
#include <vector>

#include "host/app/command.hpp"
#include "host/app/commands/jones_session.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/expression.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/heights/read_grid.hpp"

namespace sightline::app {

namespace {

template <class Value>
Value checked(base::Result<Value> result, ExitCode code) {
  if (!result) throw Failure(code, result.error().message(base::MessageStyle::position));
  return std::move(*result);
}

scene::GridSize size_of(const SkalaSource& source, scene::GridSize usual) {
  return {source.points.value_or(usual.points), source.slices.value_or(usual.slices)};
}

SkalaFunction from_expression(const SkalaSource& source, scene::GridSize size) {
  const scene::Interval domain = source.domain.empty()
                                     ? scene::expression_domain
                                     : checked(scene::read_domain(source.domain), ExitCode::usage);
  return {source.expression, "function",
          checked(scene::sample_expression(source.expression, domain, size), ExitCode::usage)};
}

SkalaFunction from_file(const SkalaSource& source) {
  const std::string& file = source.name_or_file;
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) {
    std::vector<std::string> names;
    for (const auto& function : scene::height_functions()) names.emplace_back(function.name);
    throw Failure(ExitCode::io, base::Error{.file = file,
                                            .found = "no such file, and no function of that name",
                                            .expected = "a grid file or one of " + scene::height_function_names(),
                                            .remedy = base::did_you_mean(file, names)}
                                    .message());
  }
  if (source.points || source.slices)
    throw Failure(ExitCode::usage,
                  fmt::format("{}: a grid file has its own size; found --points or --slices", file));
  return {file, file_stem(std::filesystem::path(file).stem().string()),
          checked(scene::load_height_grid(file), ExitCode::bad_input)};
}

}  // namespace

SkalaFunction load_skala_function(const SkalaSource& source, scene::GridSize usual) {
  if (source.name_or_file.empty() == source.expression.empty()) {
    throw Failure(ExitCode::usage,
                  fmt::format("found {}, expected one: a name ({}), a grid file, or --function EXPRESSION",
                              source.expression.empty() ? "no function to draw" : "two functions to draw",
                              scene::height_function_names()));
  }
  const scene::GridSize size = size_of(source, usual);
  if (!source.expression.empty()) return from_expression(source, size);
  if (!source.domain.empty())
    throw Failure(ExitCode::usage, "--domain: found without --function; names and grid files have their own");
  if (const auto function = scene::height_function(source.name_or_file))
    return {source.name_or_file, file_stem(source.name_or_file), scene::sample(*function, size)};
  return from_file(source);
}

}  // namespace sightline::app
