#include "host/app/commands/skala_options.hpp"

#include <fmt/core.h>

#include <array>

#include "host/app/command_line.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::app {

namespace {

constexpr const char* levels_help = "Number of contour levels";

}  // namespace

void add_function_options(const Command& command, SkalaSource& source, const std::string& slices,
                          const std::string& points) {
  command.option("--function", source.expression, "A function of x and y (or x and z), such as \"x*x - y*y\"")
      .value("EXPR");
  command.option("--domain", source.domain, "Range of both variables in --function").default_value("-10:10").value("A:B");
  command.option("--x-range", source.x_range, "Range of x in a function").default_value("--domain").value("A:B");
  command.option("--y-range", source.y_range, "Range of the second variable").default_value("--domain").value("A:B");
  command.option("--xyz", source.columns, "Three columns of a file of points, by name or number: x, y and height")
      .default_value("by its heading or content")
      .separated_by(',')
      .value("X,Y,Z");
  command.option("--layout", source.layout, "Layout of a file: a matrix of heights, a table with coordinates in its first line and column, or points x y z")
      .one_of({"matrix", "table", "points"})
      .default_value("by its content");
  command.option("--nodata", source.nodata, "A height of a file that means no height: a hole").value("HEIGHT");
  command.option("--thin", source.thin, "Take every N-th point and slice of a file, which may then be larger than 1024 x 1024").range(1, 32767).value("N");
  command.flag("--triangulate", source.triangulate, "Triangulate the points of a file (Delaunay) and sample the surface at --points by --slices");
  constexpr int fewest = static_cast<int>(scene::smallest_grid.points);
  constexpr int most = static_cast<int>(scene::largest_grid.points);
  command.option("--slices", source.slices, "Samples of a function or of triangulated points along the second variable: slices, unless those along it are drawn")
      .range(fewest, most)
      .default_value(slices)
      .value("N");
  command.option("--subdivide", source.subdivide, "Cut each cell into N by N cells on smooth curves through the heights: smooth contours. Slices along one axis are only made smooth: there are not more of them")
      .range(2, 64)
      .value("N");
  command.option("--points", source.points, "Samples of a function or of triangulated points along x")
      .range(fewest, most)
      .default_value(points)
      .value("N");
}

void add_angle_options(const Command& command, double& rotation, double& elevation) {
  command.option("--rotate", rotation, "Rotation about the vertical axis in degrees").default_value().value("A");
  command.option("--elevate", elevation, "Elevation of the camera above the horizon in degrees; negative from below")
      .default_value()
      .range(-90.0, 90.0)
      .value("E");
}

void require_angles(double rotation, double elevation) {
  require_finite("--rotate", rotation);
  require_finite("--elevate", elevation);
}

void add_slices_options(const Command& command, SkalaSlices& slices) {
  const Option both = command.flag("--both", slices.both, "Slices along x and along z (lines only)");
  command.option("--along", slices.along, "Slices along x or along z")
      .default_value("the family seen less end-on")
      .one_of({"x", "z"})
      .excludes(both);
}

std::string_view picture_name(algorithms::skala::Subject picture) {
  constexpr std::array<std::string_view, 3> names{"lines", "surface", "contours"};
  return names[static_cast<std::size_t>(picture)];
}

void add_picture_option(const Command& command, std::string& picture, const std::string& help) {
  command.option("--picture", picture, help).one_of({"lines", "surface", "contours"}).default_value("lines");
}

algorithms::skala::Family family_of(const SkalaSlices& slices) {
  if (slices.both) return algorithms::skala::Family::both;
  if (slices.along.empty()) return algorithms::skala::Family::automatic;
  return slices.along == "x" ? algorithms::skala::Family::along_x : algorithms::skala::Family::along_z;
}

void add_levels_option(const Command& command, int& levels) {
  command.option("--levels", levels, levels_help).default_value().range(1, 255);
}

void add_levels_option(const Command& command, std::optional<int>& levels) {
  command.option("--levels", levels, levels_help)
      .range(1, 255)
      .default_value(std::to_string(algorithms::skala::View{}.levels));
}

}  // namespace sightline::app
