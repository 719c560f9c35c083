// The Skala program's twin compared with the column oracle on random families of slices: the stream is in order, the oracle's
// chains are
// shuffled, so that it must find the order by depth alone.
#include <gtest/gtest.h>

#include "tests/host/programs/skala/chain_stream.hpp"
#include "tests/host/programs/skala/family.hpp"

namespace sightline::programs::skala {
namespace {

using algorithms::oracle::column_picture;

constexpr int seeds_per_kind = 25;

std::vector<Chain> shuffle_chains(std::vector<Chain> chains, std::uint32_t seed) {
  programs::jones::Dice dice(seed);
  for (std::size_t i = chains.size(); i-- > 1;)
    std::swap(chains[i], chains[static_cast<std::size_t>(dice(0, static_cast<int>(i)))]);
  return chains;
}

SkalaBytes sent(const std::vector<Chain>& chains, int silhouette) {
  SkalaBytes bytes;
  bytes.device(Device::ef9365).reset().send(Command::silhouette, {silhouette});
  ChainSender sender(bytes);
  for (const Chain& chain : chains) sender.send(chain);
  return bytes;
}

void expect_as_oracle(const std::vector<Chain>& chains, std::uint32_t seed) {
  const auto picture = sent(chains, 0).end().run();
  const auto expected = column_picture(shuffle_chains(chains, seed), 0);
  ASSERT_EQ(picture.status, Status::complete);
  EXPECT_EQ(lit_differences(picture.raster(Device::ef9365), expected.lit), "");
  expect_same_masks(picture.columns, expected);
}

// Every dot where the surface turns away must be lit, and every other lit dot must be connected with one: how far a fold extends
// towards its neighbour depends on what was drawn there before, which depth alone does not determine.
void expect_folds(const core::Raster& raster, const ColumnPicture& expected) {
  for (int x = 0; x < 256; ++x) {
    const auto& folds = expected.silhouette[static_cast<std::size_t>(x)];
    bool run_has_fold = true;
    for (int y = 0; y <= 256; ++y) {
      const bool lit = y < 256 && raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)) != 0;
      const bool fold = y < 256 && folds.test(static_cast<std::size_t>(y));
      ASSERT_TRUE(lit || !fold) << x << ", " << y << " is not lit";
      const bool begins =
          lit && (y == 0 || raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y - 1)) == 0);
      if (begins) run_has_fold = false;
      run_has_fold = run_has_fold || fold;
      ASSERT_TRUE(lit || run_has_fold) << x << ", below " << y << " is lit without a fold";
    }
  }
}

class SkalaTwinColumns : public testing::TestWithParam<int> {};

TEST_P(SkalaTwinColumns, Lines) {
  for (std::uint32_t seed = 1; seed <= seeds_per_kind; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SliceFamily family(seed, GetParam());
    expect_as_oracle(family.chains(SegmentRole::draw, SegmentRole::draw), seed);
    if (HasFailure()) return;
  }
}

TEST_P(SkalaTwinColumns, Surfaces) {
  for (std::uint32_t seed = 1; seed <= seeds_per_kind; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SliceFamily family(seed, GetParam());
    expect_as_oracle(family.chains(SegmentRole::shade, SegmentRole::rim), seed);
    if (HasFailure()) return;
  }
}

// Slices without ink; the pieces between them are only tested.
TEST_P(SkalaTwinColumns, TestedPieces) {
  for (std::uint32_t seed = 1; seed <= seeds_per_kind; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    SliceFamily family(seed, GetParam());
    std::vector<Chain> chains;
    int slice = 0;
    for (const Chain& chain : family.chains(SegmentRole::mask, SegmentRole::mask)) {
      chains.push_back(chain);
      for (int i = 0; i < 8 && slice + 1 < family.slices(); ++i)
        if (const auto piece = family.piece(slice)) chains.push_back(*piece);
      ++slice;
    }
    expect_as_oracle(chains, seed);
    if (HasFailure()) return;
  }
}

TEST_P(SkalaTwinColumns, SilhouettesAndOutline) {
  for (std::uint32_t seed = 1; seed <= seeds_per_kind; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SliceFamily family(seed, GetParam());
    const auto chains = family.chains(SegmentRole::mask, SegmentRole::mask);
    const auto expected = column_picture(shuffle_chains(chains, seed), 0);
    const auto folds = sent(chains, 2).end().run();
    expect_folds(folds.raster(Device::ef9365), expected);
    // The pen moves away, so that the outline's first point is a step.
    auto outlined = sent(chains, 0);
    const auto outline = outlined.move(0, 0).move(255, 255).send(Command::outline).end().run();
    EXPECT_EQ(lit_differences(outline.raster(Device::ef9365), expected.outline), "");
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SkalaTwinColumns, testing::Range(0, SliceFamily::kinds));

}  // namespace
}  // namespace sightline::programs::skala
