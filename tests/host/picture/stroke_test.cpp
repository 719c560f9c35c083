// Recorders, crisp raster and stroke log for stroke sets small enough to check by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_log.hpp"
#include "host/picture/stroke_recorders.hpp"
#include "tests/host/picture/synthetic.hpp"
#include "tests/support/approve_png.hpp"

namespace sightline::picture {
namespace {

core::Stroke flash(std::int64_t ns, int x, int y, int intensity = 7, int address = 0) {
  core::Stroke stroke;
  stroke.time = core::at_nanoseconds(ns);
  stroke.x = static_cast<std::uint16_t>(x);
  stroke.y = static_cast<std::uint16_t>(y);
  stroke.intensity = static_cast<std::uint8_t>(intensity);
  stroke.address = static_cast<std::uint16_t>(address);
  return stroke;
}

TEST(CrispRaster, LightsExactlyThePointsGiven) {
  const std::vector<core::Stroke> strokes{flash(0, 0, 0),      flash(1, 1023, 1023, 0), flash(2, 0, 1023),
                                          flash(3, 10, 20),    flash(4, 10, 20),        flash(5, 1024, 3),
                                          flash(6, 3, 1024, 7)};
  const Image image = crisp_raster(strokes);
  ASSERT_EQ(image.width, 1024);
  ASSERT_EQ(image.height, 1024);
  ASSERT_EQ(image.channels, 1);
  EXPECT_EQ(image.pixels[1023 * 1024 + 0], 255) << "(0, 0) is lower left";
  EXPECT_EQ(image.pixels[0 * 1024 + 1023], 255) << "(1023, 1023) is upper right";
  EXPECT_EQ(image.pixels[0], 255);
  EXPECT_EQ(image.pixels[1003 * 1024 + 10], 255);
  EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 255), 4);
  EXPECT_EQ(std::count(image.pixels.begin(), image.pixels.end(), 0), 1024 * 1024 - 4);
}

TEST(CrispRaster, ACube) {
  EXPECT_TRUE(tests::matches_approved_png(crisp_raster(tests::cube_pass(0, 7)), "picture/crisp_cube.png"));
}

TEST(PassRecorder, KeepsTheLastCompletePassAndTheRunningOne) {
  PassRecorder recorder;
  EXPECT_EQ(recorder.passes(), 0U);
  recorder.begin_pass(core::at_nanoseconds(100));
  recorder.add(std::vector{flash(110, 1, 1)});
  EXPECT_TRUE(recorder.complete().strokes.empty());
  EXPECT_EQ(recorder.running().strokes.size(), 1U);
  recorder.end_pass(core::at_nanoseconds(200));
  EXPECT_EQ(recorder.passes(), 1U);
  recorder.begin_pass(core::at_nanoseconds(300));
  recorder.add(std::vector{flash(310, 2, 2)});
  recorder.add(std::vector{flash(320, 3, 3)});
  EXPECT_EQ(recorder.complete().begin, core::at_nanoseconds(100));
  EXPECT_EQ(recorder.complete().end, core::at_nanoseconds(200));
  EXPECT_EQ(recorder.complete().strokes, std::vector{flash(110, 1, 1)});
  EXPECT_EQ(recorder.running().begin, core::at_nanoseconds(300));
  EXPECT_EQ(recorder.running().strokes.size(), 2U);
  // Restarted before the stop: the drawing so far is not a complete pass.
  recorder.begin_pass(core::at_nanoseconds(400));
  EXPECT_TRUE(recorder.running().strokes.empty());
  recorder.end_pass(core::at_nanoseconds(500));
  EXPECT_EQ(recorder.passes(), 2U);
  EXPECT_TRUE(recorder.complete().strokes.empty());
}

TEST(PassRecorder, IsBounded) {
  PassRecorder recorder(3);
  recorder.begin_pass(core::at_nanoseconds(0));
  for (int i = 0; i < 10; ++i) recorder.add(std::vector{flash(i, i, i)});
  EXPECT_EQ(recorder.running().strokes.size(), 3U);
  EXPECT_EQ(recorder.running().left_out, 7U);
  recorder.end_pass(core::at_nanoseconds(20));
  EXPECT_EQ(recorder.complete().left_out, 7U);
  EXPECT_EQ(recorder.running().left_out, 0U);
  recorder.add(std::vector{flash(30, 1, 1), flash(31, 2, 2), flash(32, 3, 3), flash(33, 4, 4), flash(34, 5, 5)});
  EXPECT_EQ(recorder.running().strokes, (std::vector{flash(30, 1, 1), flash(31, 2, 2), flash(32, 3, 3)}));
  EXPECT_EQ(recorder.running().left_out, 2U);
}

TEST(StrokeRecorder, KeepsTheNewestInOrder) {
  StrokeRecorder recorder(4);
  for (int i = 0; i < 4; ++i) recorder.add(std::vector{flash(i, i, 0)});
  EXPECT_EQ(recorder.left_out(), 0U);
  for (int i = 4; i < 10; ++i) recorder.add(std::vector{flash(i, i, 0)});
  EXPECT_EQ(recorder.strokes(),
            (std::vector{flash(6, 6, 0), flash(7, 7, 0), flash(8, 8, 0), flash(9, 9, 0)}));
  EXPECT_EQ(recorder.left_out(), 6U);
  StrokeRecorder nothing(0);
  nothing.add(std::vector{flash(0, 0, 0)});
  EXPECT_TRUE(nothing.strokes().empty());
}

TEST(StrokeLog, WritesTheAgreedLine) {
  std::string text;
  append_stroke_line(text, flash(38800, 512, 8, 7, 01234));
  append_stroke_line(text, flash(0, 0, 1023, 0, 077777));
  append_stroke_line(text, flash(std::numeric_limits<std::int64_t>::max(), 1023, 0, 7, 017777));
  EXPECT_EQ(text, "38800 512 8 7 01234\n0 0 1023 0 77777\n9223372036854775807 1023 0 7 17777\n");
}

}  // namespace
}  // namespace sightline::picture
