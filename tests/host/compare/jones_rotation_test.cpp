// The lines of Jones's program in a view turned about the vertical compared with the exactly visible lines, at a bound that follows
// from the lengths of its words.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/jones_bound.hpp"
#include "host/compare/lines.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/twin/walk.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::compare {
namespace {

namespace jones = programs::jones;
namespace oracle = algorithms::oracle;

const int views = tests::effort(400, 10);
constexpr double most_wrong = 0.001;  // of the visible length: missing or extra by more than a point

class JonesTurned : public testing::TestWithParam<const char*> {};

TEST_P(JonesTurned, LinesAreWhereTheyAreVisible) {
  const scene::CellScene scene = scene::builtin_scene(GetParam());
  const auto matter = oracle::Matter::of(scene);
  ASSERT_TRUE(matter);
  const auto lines = matter->real_lines();
  const auto program = jones::Prepared::of(scene, {.walk = true});
  ASSERT_TRUE(program) << program.error().message();
  const oracle::Window window = type340_window();
  jones::Dice dice(1971);
  double worst = 0, worst_share = 0, wrong = 0, length = 0;
  int beyond = 0;
  for (int n = 0; n < views; ++n) {
    const auto& box = scene.cells[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(scene.cells.size()) - 1))].box;
    geometry::Point eye{};
    for (std::size_t a = 0; a < 3; ++a) eye[a] = dice(box.low[a] + 1, box.high[a] - 1);
    const std::int32_t degrees = dice(0, 359);
    const jones::Direction direction = jones::direction_of(degrees);
    const auto core = program->core_at(eye);
    ASSERT_TRUE(core);
    jones::Walk walk(*core, program->program().labels.scene, program->program().scene.cell_addresses.front());
    ASSERT_EQ(walk.take({}), jones::Status::complete);
    jones::Parameters parameters;
    parameters.eye = {eye[0], eye[1], eye[2]};
    parameters.direction = direction;
    const jones::TwinView view = jones::run_twin(walk.core(), program->program().labels.scene, parameters);
    ASSERT_EQ(view.status, jones::Status::complete);
    std::vector<picture::PixelSegment> drawn;
    for (const jones::Piece& piece : view.pieces) {
      const auto point = [](const jones::ScreenPoint& p) { return picture::PixelPoint{p.x / 8.0 + 512, p.y / 8.0 + 512}; };
      drawn.push_back({point(piece.line.a), point(piece.line.b)});
    }
    const auto truth = oracle::turned_view(*matter, lines, eye, window, direction.cosine, direction.sine);
    std::vector<picture::PixelSegment> exact;
    for (const auto& s : truth) exact.push_back({{s.x0, s.y0}, {s.x1, s.y1}});
    if (!drawn.empty()) {
      ASSERT_FALSE(exact.empty());
      const double farthest = picture::directed_hausdorff_distance(drawn, exact).greatest;
      const double bound = jones_piece_bound(scene, eye, {}, direction);
      EXPECT_LE(farthest, bound) << eye[0] << ',' << eye[1] << ',' << eye[2] << " at " << degrees;
      beyond += farthest > bound ? 1 : 0;
      worst = std::max(worst, farthest);
      worst_share = std::max(worst_share, farthest / bound);
    }
    std::vector<oracle::ScreenSegment> made;
    for (const auto& s : drawn) made.push_back({s.a.x, s.a.y, s.b.x, s.b.y});
    const auto error = oracle::drawn_error(truth, made, 1.0);
    wrong += error.missing + error.extra;
    length += error.true_length;
  }
  std::printf("%-10s farthest %.3f points, at most %.3f of the bound, %d beyond; %.3f per cent wrong\n", GetParam(), worst, worst_share, beyond, 100 * wrong / length);
  EXPECT_GT(length, 500.0 * views);
  EXPECT_LE(wrong, most_wrong * length);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesTurned, testing::Values("house", "roberts", "street4", "corridor8"), [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace sightline::compare
