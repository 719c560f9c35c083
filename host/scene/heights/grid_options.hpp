// How a person says what a file of heights has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

enum class GridLayout : std::uint8_t { by_content, matrix, table, points };

struct GridFileOptions {
  // Three columns of points, by their names in the heading or by number from 1: x, z and height. Empty: by content.
  std::vector<std::string> columns = {};
  // With columns it is points or by_content. Not of files that say themselves what they are: ESRI, Surfer, HGT.
  GridLayout layout = GridLayout::by_content;
  std::optional<double> nodata = {};  // heights that are holes, besides those that the format calls so
  // Every n-th point and slice is taken, from 1. Empty: all, and an error that says how to thin a larger grid than largest_grid.
  std::optional<std::size_t> thin = {};
  // Points are triangulated, and the surface is sampled at this size.
  std::optional<GridSize> triangulate = {};
};

}  // namespace sightline::scene
