// The pictures of Jones's program: approved pictures of every scene, and the guest's own display words compared with the
// scene's exact visibility.
//
// The photographs depend on every nanosecond of a run: after a change of the program's timing alone a person must approve
// them again.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "tests/firmware/jones_path_watch.hpp"
#include "tests/host/programs/jones/drawing.hpp"
#include "tests/support/approve_png.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::jones {
namespace {

namespace oracle = algorithms::oracle;

class JonesPictures : public testing::TestWithParam<const char*> {};

TEST_P(JonesPictures, AreTheApprovedOnes) {
  constexpr core::Duration shutter = core::milliseconds(200);
  const std::string scene = GetParam();
  Order order;
  order.photograph = shutter;
  const Outcome run = outcome_of(assemble_jones(scene, true), order);
  EXPECT_TRUE(tests::matches_approved_png(picture::crisp_raster(run.pass), "jones/" + scene + ".png"));
  picture::PhosphorPhotograph photograph(run.shutter_close - shutter, run.shutter_close);
  photograph.expose(run.photograph);
  EXPECT_TRUE(tests::matches_approved_png(photograph.develop(), "jones/" + scene + "-phosphor.png"));
}

TEST_P(JonesPictures, AreTheSameWithoutTheEae) {
  NEEDS_OPTIMISED_CODE();
  const Outcome with = outcome_of(assemble_jones(GetParam(), true));
  const Outcome without = outcome_of(assemble_jones(GetParam(), false));
  EXPECT_TRUE(picture::crisp_raster(with.pass) == picture::crisp_raster(without.pass));
}

// The length drawn wrong by more than a point is at most one per cent of the visible length.
TEST_P(JonesPictures, ShowTheVisibleLines) {
  constexpr int views = 21;
  constexpr double a_point = 1.0;
  const scene::CellScene scene = scene::builtin_scene(GetParam());
  const auto matter = oracle::Matter::of(scene);
  ASSERT_TRUE(matter);
  const auto lines = matter->real_lines();
  oracle::Window window;
  window.near = 1;
  Program program = assemble_jones(scene, true);
  const geometry::Box& limits = program.scene.view.limits;
  Dice dice(340);
  double truth = 0, missing = 0, extra = 0;
  for (int i = 0; i < views; ++i) {
    geometry::Point eye = scene.default_view;
    if (i > 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) eye[axis] = dice(limits.low[axis], limits.high[axis]);
    }
    put_eye(program, {eye[0], eye[1], eye[2]});
    const DarkView view = dark_view(program, true, {});
    ASSERT_EQ(view.status, Status::complete);
    TwinView words;
    words.display_file = view.display_file;
    std::vector<oracle::ScreenSegment> drawn;
    for (const ScreenSegment& s : decode(words).vectors) {
      drawn.push_back({static_cast<double>(s.a.x), static_cast<double>(s.a.y), static_cast<double>(s.b.x),
                       static_cast<double>(s.b.y)});
    }
    const auto seen = oracle::on_screen(oracle::visible_lines(*matter, lines, eye, window), eye, window);
    const auto error = oracle::drawn_error(seen, drawn, a_point);
    truth += error.true_length;
    missing += error.missing;
    extra += error.extra;
    if (i == 0) {
      std::printf("%-10s default view: true %.0f points, missing %.1f, extra %.1f\n", GetParam(),
                  error.true_length, error.missing, error.extra);
    }
  }
  std::printf("%-10s %d views: true %.0f points, missing %.3f %%, extra %.3f %%\n", GetParam(), views, truth,
              100 * missing / truth, 100 * extra / truth);
  ASSERT_GT(truth, 1000.0 * views);
  EXPECT_LE(missing + extra, 0.01 * truth);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesPictures, testing::ValuesIn(scene_names),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace sightline::programs::jones
