// The pictures of the demo, drawn by the emulated 8080, compared with approved ones, point by point.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>

#include "host/programs/skala/contours.hpp"
#include "host/programs/skala/picture.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"
#include "tests/host/programs/skala/machine_support.hpp"
#include "tests/support/approve_png.hpp"

namespace sightline::programs::skala {
namespace {

class SkalaPictures : public testing::TestWithParam<std::tuple<std::string, Subject>> {};

TEST_P(SkalaPictures, AreTheApprovedOnes) {
  const auto& [function, what] = GetParam();
  const scene::GridSize size =
      what == Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
  const auto guest = run_machine(resident_program(), stream_of(function, size, view_of(what, 30)));
  ASSERT_EQ(guest.status, Status::complete);
  const auto palette =
      what == Subject::surface ? picture::RasterPalette::grey : picture::RasterPalette::colour;
  const std::string name =
      "skala/" + function + "-" + std::string(skala_picture_names[static_cast<std::size_t>(what)]) + ".png";
  EXPECT_TRUE(tests::matches_approved_png(picture::raster_image(guest.raster, palette, 1), name));
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::string, Subject>>& p) {
  return std::get<0>(p.param) + "_" +
         std::string(skala_picture_names[static_cast<std::size_t>(std::get<1>(p.param))]);
}

INSTANTIATE_TEST_SUITE_P(TheEight, SkalaPictures,
                         testing::Combine(testing::Values("sinc", "rogers", "peaks", "franke", "saddle",
                                                          "cosr", "step", "rosen"),
                                          testing::ValuesIn(skala_pictures)),
                         name_of);

// Gaps between three dots of one contour in a row with nothing else lit nearby: they would make a dashed line of it.
int gaps_in_contours(const core::Raster& raster) {
  const auto dot = [&](int x, int y) -> int {
    if (x < 0 || x > 255 || y < 0 || y > 255) return 0;
    return raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y));
  };
  const auto lit_around = [&](int x, int y) {
    int lit = 0;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) lit += dot(x + dx, y + dy) != 0 ? 1 : 0;
    return lit;
  };
  int gaps = 0;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      if (dot(x, y) != 0 || lit_around(x, y) != 2) continue;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
        const int colour = dot(x + dx, y + dy);
        if (colour == 0 || colour == margin_colour || dot(x - dx, y - dy) != colour) continue;
        if (dot(x + 2 * dx, y + 2 * dy) == colour || dot(x - 2 * dx, y - 2 * dy) == colour) ++gaps;
      }
    }
  }
  return gaps;
}

class SkalaContourDashes : public testing::TestWithParam<std::string> {};

TEST_P(SkalaContourDashes, ThereAreNone) {
  const auto view = view_of(Subject::contours, 30);
  const auto guest = run_machine(resident_program(), stream_of(GetParam(), {33, 33}, view));
  EXPECT_EQ(gaps_in_contours(guest.raster), 0);
}

INSTANTIATE_TEST_SUITE_P(TheEight, SkalaContourDashes,
                         testing::Values("sinc", "rogers", "peaks", "franke", "saddle", "cosr", "step",
                                         "rosen"),
                         [](const auto& parameter) { return parameter.param; });

TEST(SkalaPlot, IsTheApprovedOne) {
  MachineOptions options;
  options.device = Device::calcomp;
  const auto guest =
      run_machine(resident_program(),
                stream_of("rogers", {33, 60}, view_of(Subject::lines, 30), {Device::calcomp}), options);
  ASSERT_EQ(guest.status, Status::complete);
  EXPECT_TRUE(tests::matches_approved_png(
      picture::pen_image(pen_paths(guest.moves), picture::calcomp_paper, 1), "skala/rogers-calcomp.png"));
}

}  // namespace
}  // namespace sightline::programs::skala
