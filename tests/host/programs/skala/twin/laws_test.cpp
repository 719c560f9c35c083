// Laws of the Skala program for every picture, tested on the twin: the line's tie rule over all deltas, the pending column
// compared with
// the paper's second pair of masks, and what masks and visible dots may depend on.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "host/programs/skala/twin/masks.hpp"
#include "tests/host/programs/skala/chain_stream.hpp"
#include "tests/host/programs/skala/family.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

using algorithms::oracle::RasterDot;
using algorithms::oracle::segment_dots;

constexpr std::uint32_t seeds = 12;

SkalaBytes start(bool visibility = true) {
  return SkalaBytes().device(Device::ef9365, visibility).reset();
}

SkalaBytes sent(const std::vector<Chain>& chains, bool visibility = true) {
  auto bytes = start(visibility);
  ChainSender sender(bytes);
  for (const Chain& chain : chains) sender.send(chain);
  return bytes;
}

core::Raster raster_of(SkalaBytes bytes) {
  return bytes.end().run().raster(Device::ef9365);
}

std::vector<RasterDot> walk_dots(Point from, Point to) {
  std::vector<RasterDot> dots{{from.x, from.y}};
  walk_line(from, to, [&](Point point) { dots.push_back({point.x, point.y}); });
  return dots;
}

Point corner(int dx, int dy) {
  return {static_cast<std::uint8_t>(dx < 0 ? -dx : 0), static_cast<std::uint8_t>(dy < 0 ? -dy : 0)};
}

// Bresenham's own form for a line to the right: Skala 1985, algorithm 3.1, with its a and b read as v + v and a - u - u.
std::vector<RasterDot> as_printed(int x, int y, int dx, int dy) {
  const int towards_y = dy < 0 ? -1 : 1;
  const int u = dx;
  const int v = dy * towards_y;
  const bool flat = u >= v;
  const int a = 2 * (flat ? v : u);
  const int b = a - 2 * (flat ? u : v);
  int d = a - (flat ? u : v);
  std::vector<RasterDot> dots{{x, y}};
  for (int i = 0; i < (flat ? u : v); ++i) {
    const bool both = d >= 0;
    d += both ? b : a;
    if (flat || both) ++x;
    if (!flat || both) y += towards_y;
    dots.push_back({x, y});
  }
  return dots;
}

TEST(SkalaTwinLaws, EveryLineHasItsClosedFormInBothDirections) {
  const int step = tests::effort(1, 5);
  for (int dx = -255; dx <= 255; dx += step) {
    for (int dy = -255; dy <= 255; dy += step) {
      const Point from = corner(dx, dy);
      const Point to{static_cast<std::uint8_t>(from.x + dx), static_cast<std::uint8_t>(from.y + dy)};
      const auto forward = walk_dots(from, to);
      auto backward = walk_dots(to, from);
      std::reverse(backward.begin(), backward.end());
      ASSERT_EQ(forward, backward) << dx << ", " << dy;
      ASSERT_EQ(forward, segment_dots(from.x, from.y, to.x, to.y)) << dx << ", " << dy;
      if (dx >= 0) {
        ASSERT_EQ(forward, as_printed(from.x, from.y, dx, dy)) << dx << ", " << dy;
      }
    }
  }
}

// The paper's masks as corrected: the tests of a slice see only earlier slices; the new masks are separate and are copied when
// the
// slice ends.
class CopiedMasks {
 public:
  CopiedMasks() {
    old_top_.fill(std::numeric_limits<int>::min());
    old_bottom_.fill(std::numeric_limits<int>::max());
    new_top_ = old_top_;
    new_bottom_ = old_bottom_;
  }

  void draw(const Chain& chain) {
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
      const auto& from = chain.vertices[i - 1];
      const auto& to = chain.vertices[i];
      for (const RasterDot& dot : segment_dots(from.x, from.y, to.x, to.y)) step(dot);
    }
    old_top_ = new_top_;
    old_bottom_ = new_bottom_;
  }

  std::array<std::bitset<256>, 256> lit;

 private:
  void step(const RasterDot& dot) {
    const auto x = static_cast<std::size_t>(dot.x);
    if (dot.y > old_top_[x] || dot.y < old_bottom_[x]) lit[x].set(static_cast<std::size_t>(dot.y));
    new_top_[x] = std::max(new_top_[x], dot.y);
    new_bottom_[x] = std::min(new_bottom_[x], dot.y);
  }

  std::array<int, 256> old_top_{};
  std::array<int, 256> old_bottom_{};
  std::array<int, 256> new_top_{};
  std::array<int, 256> new_bottom_{};
};

class SkalaTwinFamilyLaws : public testing::TestWithParam<int> {
 protected:
  // Calls test(chains) for some families of the kind.
  template <class Test>
  void for_families(Test&& test) {
    for (std::uint32_t seed = 101; seed < 101 + seeds; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      test(SliceFamily(seed, GetParam()).chains(SegmentRole::draw, SegmentRole::draw));
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }
};

TEST_P(SkalaTwinFamilyLaws, APendingColumnEqualsCopiedMasks) {
  for_families([](const std::vector<Chain>& chains) {
    CopiedMasks masks;
    for (const Chain& chain : chains) masks.draw(chain);
    EXPECT_EQ(lit_differences(raster_of(sent(chains)), masks.lit), "");
  });
}

TEST_P(SkalaTwinFamilyLaws, DotsDoNotDependOnTheDirectionOfSlices) {
  for_families([](const std::vector<Chain>& chains) {
    auto turned = chains;
    for (std::size_t i = 0; i < turned.size(); i += 2) {
      auto& vertices = turned[i].vertices;
      std::reverse(vertices.begin(), vertices.end());
      for (auto& vertex : vertices) vertex.role = SegmentRole::draw;
      vertices.front().role = SegmentRole::none;
    }
    EXPECT_TRUE(raster_of(sent(chains)) == raster_of(sent(turned)));
  });
}

TEST_P(SkalaTwinFamilyLaws, WithoutVisibilityEverythingIsDrawn) {
  for_families([](const std::vector<Chain>& chains) {
    const auto hidden_removed = raster_of(sent(chains));
    const auto everything = raster_of(sent(chains, false));
    for (std::size_t i = 0; i < core::Raster::size; ++i)
      ASSERT_TRUE(hidden_removed.points()[i] == 0 || everything.points()[i] != 0) << "dot " << i;
  });
}

TEST_P(SkalaTwinFamilyLaws, MasksNeverShrink) {
  for_families([](const std::vector<Chain>& chains) {
    Columns before = start().end().run().columns;
    for (std::size_t count = 1; count <= chains.size(); ++count) {
      const std::vector<Chain> drawn(chains.begin(), chains.begin() + static_cast<std::ptrdiff_t>(count));
      const Columns after = sent(drawn).end().run().columns;
      for (std::size_t x = 0; x < 256; ++x) {
        const bool visited = before.mask_top[x] != 0 || before.mask_bottom[x] != 255;
        if (!visited) continue;
        ASSERT_GE(after.mask_top[x], before.mask_top[x]);
        ASSERT_LE(after.mask_bottom[x], before.mask_bottom[x]);
      }
      before = after;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Kinds, SkalaTwinFamilyLaws, testing::Range(0, SliceFamily::kinds));

}  // namespace
}  // namespace sightline::programs::skala
