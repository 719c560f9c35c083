// A view as the host sends it and the twin draws it, held against the column oracle.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <vector>

#include "host/harness/skala_stream.hpp"
#include "tests/host/harness/skala_chain_stream.hpp"
#include "tests/host/harness/skala_view_chains.hpp"

namespace sightline::harness {

inline core::Raster twin_raster(const scene::HeightGrid& grid, const SkalaView& view) {
  const auto drawn = run_skala_twin(skala_stream(grid, view));
  EXPECT_EQ(drawn.status, SkalaStatus::complete);
  return drawn.raster(view.device);
}

// Chains and depths from the projected points alone.
inline std::vector<Chain> view_chains(const scene::HeightGrid& grid, const SkalaView& view,
                                      const ViewChains& chains) {
  if (view.picture == SkalaPicture::contours) return chains.contours(grid, view.levels);
  if (view.picture == SkalaPicture::surface) return chains.slices(SegmentRole::shade, SegmentRole::rim);
  if (view.family == SkalaFamily::both) return chains.cells();
  return chains.slices(SegmentRole::draw, SegmentRole::draw);
}

inline ColumnPicture oracle_picture(const scene::HeightGrid& grid, const SkalaView& view) {
  const SkalaProjection projection(grid, view);
  const ViewChains chains(projection);
  const bool by_cells = view.picture == SkalaPicture::contours || view.family == SkalaFamily::both;
  auto picture = algorithms::oracle::column_picture(
      view_chains(grid, view, chains), by_cells ? chains.cell_tolerance() : chains.slice_tolerance());
  if (view.picture == SkalaPicture::contours) {
    for (std::size_t x = 0; x < picture.lit.size(); ++x) picture.lit[x] |= picture.outline[x];
  }
  return picture;
}

inline void expect_as_oracle(const scene::HeightGrid& grid, const SkalaView& view) {
  EXPECT_EQ(lit_differences(twin_raster(grid, view), oracle_picture(grid, view).lit), "");
}

// The same picture sent chain by chain by the test, each with a MOVE of its own; without silhouettes.
inline core::Raster twin_raster_of_chains(const scene::HeightGrid& grid, const SkalaView& view) {
  const SkalaProjection projection(grid, view);
  auto chains = view_chains(grid, view, ViewChains(projection));
  std::stable_sort(chains.begin(), chains.end(),
                   [](const Chain& a, const Chain& b) { return a.rank < b.rank; });
  auto bytes = SkalaBytes().device(view.device).reset();
  const bool contours = view.picture == SkalaPicture::contours;
  ChainSender sender(bytes);
  for (const Chain& chain : chains) sender.send(chain);
  // The pen goes elsewhere, so that the outline's first point is a step.
  if (contours) bytes.move(0, 0).move(255, 255).send(SkalaCommand::outline);
  return bytes.end().run().raster(view.device);
}

}  // namespace sightline::harness
