// The error of the pictures of Jones's program: the twin's drawing in 18-bit arithmetic compared with the exact visibility of the
// scene,
// over many views. The bound is one per cent of the true length, counting missing and extra parts that are more than a point
// away. It
// holds for the sum over a thousand views, not for a few: a single line slightly more than a point off is already two per cent of
// a street.
//
// Half of the views are from the scene's own initial cell, half from any cell of the scene.
#include <gtest/gtest.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "tests/host/programs/jones/core.hpp"
#include "tests/host/programs/jones/drawing.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/dice.hpp"

namespace sightline::programs::jones {
namespace {

namespace oracle = algorithms::oracle;

constexpr int views = 1000;
constexpr double a_point = 1.0;
constexpr double allowed_share = 0.01;

// The scene in core with that eye; empty if the position is invalid.
std::optional<std::vector<core::Word18>> core_of(const scene::CellScene& scene, const geometry::Point& eye) {
  const auto encoded = programs::jones::encode(scene, {eye}, TestCore::header);
  if (!encoded) return std::nullopt;
  std::vector<core::Word18> words(core_words);
  for (std::size_t i = 0; i < encoded->words.size(); ++i) {
    words.at(encoded->base + i) = core::Word18(encoded->words[i].value);
  }
  return words;
}

geometry::Point point_in(const geometry::Box& box, Dice& dice) {
  geometry::Point point;
  for (std::size_t a = 0; a < 3; ++a) point[a] = dice(box.low[a], box.high[a]);
  return point;
}

oracle::DrawnError error_of(const std::vector<ScreenSegment>& drawn, double unit, double centre,
                            const std::vector<oracle::ScreenSegment>& truth) {
  std::vector<oracle::ScreenSegment> on_screen;
  for (const ScreenSegment& s : drawn) {
    on_screen.push_back(
        {s.a.x * unit + centre, s.a.y * unit + centre, s.b.x * unit + centre, s.b.y * unit + centre});
  }
  return oracle::drawn_error(truth, on_screen, a_point);
}

struct Sum {
  double truth = 0, missing = 0, extra = 0;
  void operator+=(const oracle::DrawnError& error) {
    truth += error.true_length;
    missing += error.missing;
    extra += error.extra;
  }
  [[nodiscard]] double share() const { return (missing + extra) / truth; }
  void print(const std::string& scene, const char* what) const {
    std::printf("%-10s %-18s true %9.0f points, missing %.3f %%, extra %.3f %%\n", scene.c_str(), what, truth,
                100 * missing / truth, 100 * extra / truth);
  }
};

class JonesQuality : public testing::TestWithParam<const char*> {};

TEST_P(JonesQuality, AtMostOnePerCentIsWrongByMoreThanAPoint) {
  const scene::CellScene scene = scene::builtin_scene(GetParam());
  const auto matter = oracle::Matter::of(scene);
  ASSERT_TRUE(matter);
  const auto lines = matter->real_lines();
  const auto home = programs::jones::encode(scene, {}, TestCore::header);
  ASSERT_TRUE(home);
  const geometry::Box& home_box = home->view.limits;
  oracle::Window window;
  window.near = 1;
  Dice dice(1971);
  Sum pieces, vectors;
  for (int done = 0; done < views;) {
    const geometry::Point eye = done == 0  ? scene.default_view
                                : done % 2 ? point_in(scene.outer, dice)
                                           : point_in(home_box, dice);
    const auto core = core_of(scene, eye);
    if (!core) continue;
    ++done;
    const TwinView view = run_twin(*core, TestCore::header, default_parameters(*core, TestCore::header));
    ASSERT_EQ(view.status, Status::complete) << eye[0] << ' ' << eye[1] << ' ' << eye[2];
    const auto truth = oracle::on_screen(oracle::visible_lines(*matter, lines, eye, window), eye, window);
    std::vector<ScreenSegment> drawn;
    for (const Piece& piece : view.pieces) drawn.push_back(piece.line);
    pieces += error_of(drawn, 1.0 / (1 << machine_fraction_bits), 512, truth);
    vectors += error_of(decode(view).vectors, 1, 0, truth);
  }
  pieces.print(GetParam(), "pieces");
  vectors.print(GetParam(), "display vectors");
  ASSERT_GT(pieces.truth, 1000 * views) << "views must have something in them";
  EXPECT_LE(pieces.share(), allowed_share);
  EXPECT_LE(vectors.share(), allowed_share);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesQuality,
                         testing::Values("house", "roberts", "street4", "corridor8", "corridor32"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace sightline::programs::jones
