// The pictures of the demo, drawn by the emulated 8080, against approved ones, point for point.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "host/harness/skala_pen_paths.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"
#include "tests/host/harness/skala_guest_support.hpp"
#include "tests/support/approve_png.hpp"

namespace sightline::harness {
namespace {

SkalaView demo_view(SkalaPicture what, SkalaDevice device) {
  SkalaView view;
  view.picture = what;
  view.device = device;
  view.rotation = 30;
  return view;
}

class SkalaPictures : public testing::TestWithParam<std::tuple<std::string, SkalaPicture>> {};

TEST_P(SkalaPictures, AreTheApprovedOnes) {
  const auto& [function, what] = GetParam();
  const scene::GridSize size =
      what == SkalaPicture::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
  const auto guest =
      run_skala_guest(skala_program(), stream_of(function, size, demo_view(what, SkalaDevice::ef9365)));
  ASSERT_EQ(guest.status, SkalaStatus::complete);
  const auto palette =
      what == SkalaPicture::surface ? picture::RasterPalette::grey : picture::RasterPalette::colour;
  const std::string name =
      "skala/" + function + "-" + std::string(skala_picture_names[static_cast<std::size_t>(what)]) + ".png";
  EXPECT_TRUE(tests::matches_approved_png(picture::raster_image(guest.raster, palette, 1), name));
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::string, SkalaPicture>>& p) {
  return std::get<0>(p.param) + "_" +
         std::string(skala_picture_names[static_cast<std::size_t>(std::get<1>(p.param))]);
}

INSTANTIATE_TEST_SUITE_P(TheEight, SkalaPictures,
                         testing::Combine(testing::Values("sinc", "rogers", "peaks", "franke", "saddle",
                                                          "cosr", "step", "rosen"),
                                          testing::Values(SkalaPicture::lines, SkalaPicture::surface)),
                         name_of);

// Those of rogers, step and rosen are not approved: contours on parts seen edge-on come out dashed.
INSTANTIATE_TEST_SUITE_P(Contours, SkalaPictures,
                         testing::Combine(testing::Values("sinc", "peaks", "franke", "saddle", "cosr"),
                                          testing::Values(SkalaPicture::contours)),
                         name_of);

TEST(SkalaPlot, IsTheApprovedOne) {
  SkalaGuestOptions options;
  options.device = SkalaDevice::calcomp;
  const auto guest = run_skala_guest(
      skala_program(), stream_of("rogers", {33, 60}, demo_view(SkalaPicture::lines, SkalaDevice::calcomp)),
      options);
  ASSERT_EQ(guest.status, SkalaStatus::complete);
  EXPECT_TRUE(tests::matches_approved_png(
      picture::pen_image(pen_paths(guest.moves), picture::calcomp_paper, 1), "skala/rogers-calcomp.png"));
}

}  // namespace
}  // namespace sightline::harness
