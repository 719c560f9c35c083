// The raster's orientation, and a distinct shape for every printable character.
#include "emulators/core/raster.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <set>

#include "emulators/core/glyphs.hpp"

using sightline::core::ascii_glyph;
using sightline::core::Glyph;
using sightline::core::Raster;

TEST(Raster, BottomRowComesFirstAndRowsGoFromLeftToRight) {
  const auto raster = std::make_unique<Raster>();
  raster->set(3, 2, 5);
  raster->set(0, 255, 1);
  EXPECT_EQ(raster->points()[2 * 256 + 3], 5);
  EXPECT_EQ(raster->row(2)[3], 5);
  EXPECT_EQ(raster->points()[255 * 256], 1);
  EXPECT_EQ(raster->at(2, 3), 0);
}

TEST(Raster, FillReachesEveryPoint) {
  const auto raster = std::make_unique<Raster>();
  raster->fill(6);
  for (const std::uint8_t point : raster->points()) ASSERT_EQ(point, 6);
}

TEST(Glyphs, EveryAsciiCodeHasADistinctShape) {
  std::set<Glyph> shapes;
  for (int code = 0x21; code <= 0x7F; ++code) shapes.insert(ascii_glyph(static_cast<std::uint8_t>(code)));
  EXPECT_EQ(shapes.size(), 0x7FU - 0x21U + 1);
  EXPECT_FALSE(shapes.contains(Glyph{}));
  EXPECT_EQ(ascii_glyph(' '), Glyph{});
  EXPECT_EQ(ascii_glyph(0x80), Glyph{});
}

TEST(Glyphs, CodesFindTheirLetters) {
  EXPECT_EQ(ascii_glyph('L'), (Glyph{020, 020, 020, 020, 020, 020, 037}));
  EXPECT_EQ(ascii_glyph('l'), (Glyph{014, 004, 004, 004, 004, 004, 016}));
  EXPECT_EQ(ascii_glyph('-'), (Glyph{000, 000, 000, 037, 000, 000, 000}));
  EXPECT_EQ(ascii_glyph('_'), (Glyph{000, 000, 000, 000, 000, 000, 037}));
  EXPECT_EQ(ascii_glyph('|'), (Glyph{004, 004, 004, 004, 004, 004, 004}));
}
