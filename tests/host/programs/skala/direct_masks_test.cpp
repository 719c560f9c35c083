// The build without the temporary masks M1T and M1B (SPECIFICATION, section 10): what it loses, by hand; the 8080 compared with its
// twin.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/programs/skala/skala.hpp"
#include "tests/host/programs/skala/machine_support.hpp"
#include "tests/host/programs/skala/twin/support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

TwinPicture direct_twin(std::span<const std::uint8_t> stream, Device device) {
  Equipment equipment{{}, true};
  equipment.present[static_cast<std::size_t>(device)] = true;
  return run_twin(stream, equipment);
}

int dots_in(const core::Raster& raster, int x) {
  int dots = 0;
  for (int y = 0; y < 256; ++y) dots += raster.points()[static_cast<std::size_t>(y * core::Raster::width + x)] != 0 ? 1 : 0;
  return dots;
}

// A slice at height 10, then a line that falls in column 5 from 40 to 20, and one that rises in column 15: with the temporary
// masks all 21 dots of both are visible. Without them the falling line is hidden by its own first dot.
TEST(SkalaDirectMasks, AFallingLineHidesItself) {
  SkalaBytes bytes;
  bytes.reset().move(0, 10).draw(20, 10).commit().move(5, 40).draw(5, 20).commit().move(15, 20).draw(15, 40).commit().end();
  const auto right = run_machine(resident_program(), bytes.bytes());
  const auto direct = run_machine(resident_program(true), bytes.bytes());
  EXPECT_EQ(dots_in(right.raster, 5), 1 + 21);
  EXPECT_EQ(dots_in(right.raster, 15), 1 + 21);
  EXPECT_EQ(dots_in(direct.raster, 5), 1 + 1);
  EXPECT_EQ(dots_in(direct.raster, 15), 1 + 21);
  EXPECT_TRUE(same_as_twin(direct, direct_twin(bytes.bytes(), Device::ef9365), Device::ef9365));
}

class SkalaDirectViews : public testing::TestWithParam<Subject> {};

TEST_P(SkalaDirectViews, MachineEqualsItsTwin) {
  const Subject what = GetParam();
  for (const std::string_view function : {"sinc", "rogers", "peaks", "step", "rosen"}) {
    const auto grid = scene::sample(*scene::height_function(function), tests::effort(scene::GridSize{33, 33}, scene::GridSize{17, 17}));
    for (const Device device : {Device::ef9365, Device::alt256, Device::calcomp}) {
      for (const double rotation : {0.0, 30.0, 130.0, 250.0}) {
        if (device == Device::calcomp && rotation > 30) continue;  // minutes of emulated time
        const View view = view_of(what, rotation);
        const auto bytes = stream_of(grid, view, {device});
        MachineOptions options;
        options.device = device;
        const auto guest = run_machine(resident_program(true), bytes, options);
        ASSERT_TRUE(same_as_twin(guest, direct_twin(bytes, device), device)) << function << " rotated " << rotation;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, SkalaDirectViews, testing::ValuesIn(skala_pictures),
                         [](const auto& p) { return std::string(skala_picture_names[static_cast<std::size_t>(p.param)]); });

// Dots that the right picture lacks cannot appear in lines: the masks only grow earlier.
TEST(SkalaDirectMasks, LinesLoseDotsAndGainNone) {
  std::uint64_t missing = 0;
  for (const std::string_view function : {"sinc", "rogers", "peaks", "saddle"}) {
    for (const double rotation : {0.0, 30.0}) {
      Order order;
      order.grid = scene::sample(*scene::height_function(function), {33, 60});
      order.view = view_of(Subject::lines, rotation);
      order.direct_masks = true;
      order.check = true;
      const auto outcome = run(order);
      ASSERT_TRUE(outcome) << outcome.error().message();
      ASSERT_TRUE(outcome->wrong_dots);
      EXPECT_EQ(outcome->wrong_dots->extra, 0U) << function;
      missing += outcome->wrong_dots->missing;
    }
  }
  EXPECT_GT(missing, 1000U);
}

}  // namespace
}  // namespace sightline::programs::skala
