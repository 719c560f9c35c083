// See skala_options.hpp.
#include "host/app/commands/skala_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "host/app/command.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::app {

namespace {

constexpr const char* levels_help = "How many contour levels";

}  // namespace

void add_function_options(CLI::App& command, SkalaSource& source, const std::string& slices,
                          const std::string& points) {
  command.add_option("--function", source.expression, "A function of x and z, such as \"x*x - z*z\"")
      ->type_name("EXPR");
  command.add_option("--domain", source.domain, "Of x and z in --function")
      ->default_str("-10:10")
      ->type_name("A:B");
  const CLI::Range range(static_cast<int>(scene::smallest_grid.points),
                         static_cast<int>(scene::largest_grid.points));
  command.add_option("--slices", source.slices, "Samples along z: slices, unless those along z are drawn")
      ->check(range)
      ->default_str(slices)
      ->type_name("N");
  command.add_option("--points", source.points, "Samples along x")
      ->check(range)
      ->default_str(points)
      ->type_name("N");
}

void add_angle_options(CLI::App& command, double& rotation, double& elevation) {
  command.add_option("--rotate", rotation, "Degrees about the vertical")
      ->capture_default_str()
      ->type_name("A");
  command.add_option("--elevate", elevation, "Degrees of the eye above the horizon; below 0 from below")
      ->capture_default_str()
      ->check(CLI::Range(-90.0, 90.0))
      ->type_name("E");
}

void require_angles(double rotation, double elevation) {
  require_finite("--rotate", rotation);
  require_finite("--elevate", elevation);
}

void add_slices_options(CLI::App& command, SkalaSlices& slices) {
  CLI::Option* const both =
      command.add_flag("--both", slices.both, "Slices along x and along z; of lines only");
  command.add_option("--along", slices.along, "Slices along x or along z")
      ->default_str("the less end-on")
      ->check(CLI::IsMember({"x", "z"}))
      ->excludes(both);
}

std::string_view picture_name(guests::skala::PictureKind picture) {
  constexpr std::array<std::string_view, 3> names{"lines", "surface", "contours"};
  return names[static_cast<std::size_t>(picture)];
}

void add_picture_option(CLI::App& command, std::string& picture, const std::string& help) {
  command.add_option("--picture", picture, help)
      ->check(CLI::IsMember({"lines", "surface", "contours"}))
      ->default_str("lines");
}

guests::skala::Family family_of(const SkalaSlices& slices) {
  if (slices.both) return guests::skala::Family::both;
  if (slices.along.empty()) return guests::skala::Family::automatic;
  return slices.along == "x" ? guests::skala::Family::along_x : guests::skala::Family::along_z;
}

void add_levels_option(CLI::App& command, int& levels) {
  command.add_option("--levels", levels, levels_help)->capture_default_str()->check(CLI::Range(1, 255));
}

void add_levels_option(CLI::App& command, std::optional<int>& levels) {
  command.add_option("--levels", levels, levels_help)
      ->check(CLI::Range(1, 255))
      ->default_str(std::to_string(guests::skala::View{}.levels));
}

}  // namespace sightline::app
