// A view that the host sends and the twin draws, compared with the column oracle.
#pragma once

#include <gtest/gtest.h>

#include <bitset>
#include <vector>

#include "host/compare/view_chains.hpp"
#include "host/programs/skala/stream.hpp"
#include "tests/host/programs/skala/chain_stream.hpp"

namespace sightline::programs::skala {

// Without silhouettes, whose extent depends on more than depth.
inline core::Raster twin_raster(const scene::HeightGrid& grid, const View& view) {
  const auto drawn = run_twin(stream_of(grid, view));
  EXPECT_EQ(drawn.status, Status::complete);
  return drawn.raster(Device::ef9365);
}

// Chains and depths from the projected points alone.
inline std::vector<Chain> view_chains(const scene::HeightGrid& grid, const View& view,
                                      const compare::ViewChains& chains) {
  if (view.subject == Subject::contours) return chains.contours(grid, view.levels);
  if (view.subject == Subject::surface) return chains.slices(SegmentRole::shade, SegmentRole::rim);
  if (view.family == Family::both) return chains.cells();
  return chains.slices(SegmentRole::draw, SegmentRole::draw);
}

inline ColumnPicture oracle_picture(const scene::HeightGrid& grid, const View& view) {
  const Projection projection(grid, view);
  const compare::ViewChains chains(projection);
  const bool by_cells = view.subject == Subject::contours || view.family == Family::both;
  auto picture = algorithms::oracle::column_picture(
      view_chains(grid, view, chains), by_cells ? chains.cell_tolerance() : chains.slice_tolerance());
  if (view.subject == Subject::contours) {
    for (std::size_t x = 0; x < picture.lit.size(); ++x) picture.lit[x] |= picture.outline[x];
  }
  return picture;
}

inline void expect_as_oracle(const scene::HeightGrid& grid, const View& view) {
  EXPECT_EQ(lit_differences(twin_raster(grid, view), oracle_picture(grid, view).lit), "");
}

}  // namespace sightline::programs::skala
