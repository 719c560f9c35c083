// Exact lines on devices, compared by hand and with the emulated devices' output for the same lines; and the guests' difference
// from
// them.
#include "host/compare/device_raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/faces.hpp"
#include "host/compare/height_truth.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/turning.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/twin/number.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/programs/stripes/stripes.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

using picture::PixelGrid;
using picture::PixelSegment;

using Places = std::vector<std::pair<int, int>>;

// By columns, then rows.
Places lit(const PixelGrid& grid) {
  Places places;
  for (int x = 0; x < grid.width; ++x)
    for (int y = 0; y < grid.height; ++y)
      if (grid.at(x, y) != 0) places.emplace_back(x, y);
  return places;
}

PixelGrid unite_grids(PixelGrid a, const PixelGrid& b) {
  for (std::size_t i = 0; i < a.values.size(); ++i) a.values[i] = a.values[i] != 0 || b.values[i] != 0 ? 1 : 0;
  return a;
}

TEST(Type340Points, EqualThoseOfTheRateMultiplier) {
  // 5 = 4 + 1 and 3 = 2 + 1 in seven pulses: the first stage passes the 4s at pulses 1, 3, 5, 7, the second the 2s at
  // 2 and 6, the third the units at 4.
  const Places expected{{10, 20}, {11, 20}, {11, 21}, {12, 21}, {13, 22}, {14, 22}, {14, 23}, {15, 23}};
  EXPECT_EQ(lit(type340_points(std::vector<PixelSegment>{{{10, 20}, {15, 23}}})), expected);
  // Ends are rounded, halves up, and the reversed line is the same.
  EXPECT_EQ(lit(type340_points(std::vector<PixelSegment>{{{15.49, 22.5}, {9.5, 20.4}}})), expected);
  // To the left and down: x at 1 .. 7 as above.
  EXPECT_EQ(lit(type340_points(std::vector<PixelSegment>{{{10, 20}, {5, 17}}})),
            (Places{{5, 17}, {6, 17}, {6, 18}, {7, 18}, {8, 19}, {9, 19}, {9, 20}, {10, 20}}));
}

TEST(Type340Points, AreOnTheScreen) {
  EXPECT_EQ(lit(type340_points(std::vector<PixelSegment>{{{-3, 0}, {1, 0.2}}})), (Places{{0, 0}, {1, 0}}));
  EXPECT_EQ(lit(type340_points(std::vector<PixelSegment>{{{1022.6, 1023.7}, {1022, 1023}}})),
            (Places{{1022, 1023}, {1023, 1023}}));
}

TEST(Type340Points, ALineOfNoLength) {
  const std::vector<PixelSegment> dot{{{4.6, 7.2}, {5.4, 6.8}}};
  EXPECT_EQ(lit(type340_points(dot)), Places{});
  EXPECT_EQ(lit(type340_points(dot, LongLines::turn)), (Places{{5, 7}}));
}

TEST(Type340Points, LongLinesAreDividedAsByTheirPrograms) {
  const auto in_words = [](const std::vector<std::pair<int, int>>& words) {
    std::vector<PixelSegment> lines;
    double x = 50;
    double y = 60;
    for (const auto& [dx, dy] : words) {
      lines.push_back({{x, y}, {x + dx, y + dy}});
      x += dx;
      y += dy;
    }
    return lines;
  };
  const std::vector<PixelSegment> line{{{50, 60}, {350, 160}}};
  // Three words: 100, 200, 300 and 33.3, 66.7, 100.
  EXPECT_EQ(type340_points(line), type340_points(in_words({{100, 33}, {100, 34}, {100, 33}})));
  // 127 * 100 = 42 * 300 + 100; the error runs -150, -50, 50.
  EXPECT_EQ(type340_points(line, LongLines::turn), type340_points(in_words({{127, 42}, {127, 43}, {46, 15}}), LongLines::turn));
}

// The program's pieces before rounding, in points of the screen.
std::vector<PixelSegment> pieces_of(const programs::jones::TwinView& view) {
  std::vector<PixelSegment> pieces;
  const programs::jones::ShortWords number;
  const auto point = [&](std::int32_t at) { return number.points(at) + 512; };
  for (const auto& piece : view.pieces)
    pieces.push_back({{point(piece.line.a.x), point(piece.line.a.y)}, {point(piece.line.b.x), point(piece.line.b.y)}});
  return pieces;
}

TEST(Type340Points, OfJonesPiecesEqualTheFlashesOfHisProgram) {
  for (const char* name : {"house", "roberts", "corridor8"}) {
    const auto program = programs::jones::Prepared::of(scene::builtin_scene(name));
    ASSERT_TRUE(program) << name;
    programs::jones::Order order;
    order.views = 1;
    const auto outcome = program->run(order);
    ASSERT_TRUE(outcome) << name;
    const PixelGrid shown = points_of(outcome->pass);
    EXPECT_EQ(type340_points(pieces_of(*program->twin(order))), shown) << name;
    EXPECT_GT(lit(shown).size(), 1000U) << name;
  }
}

TEST(CompareFlashes, OfHisProgramAndExactLines) {
  for (const char* name : {"house", "roberts"}) {
    SCOPED_TRACE(name);
    const scene::CellScene cells = scene::builtin_scene(name);
    const auto program = programs::jones::Prepared::of(cells);
    ASSERT_TRUE(program);
    programs::jones::Order order;
    order.views = 1;
    auto outcome = program->run(order);
    ASSERT_TRUE(outcome);
    algorithms::oracle::Window window;
    window.near = programs::jones::near_z;
    std::vector<PixelSegment> exact;
    const auto seen = algorithms::oracle::visible_lines(cells, cells.default_view, window);
    ASSERT_TRUE(seen);
    for (const auto& line : algorithms::oracle::on_screen(*seen, cells.default_view, window))
      exact.push_back({{line.x0, line.y0}, {line.x1, line.y1}});
    const auto pieces = pieces_of(*program->twin(order));
    const ComparedFlashes right = compare_flashes(exact, pieces, outcome->pass);
    // With three fraction bits the end of a line moves by one point at most.
    EXPECT_EQ(right.difference.missing.beyond_1, 0U);
    EXPECT_EQ(right.difference.extra.beyond_1, 0U);
    EXPECT_LT(right.difference.missing.all, right.difference.lit_in_truth / 20);
    // One flash elsewhere.
    auto flash = std::find_if(outcome->pass.begin(), outcome->pass.end(), [&](const core::Stroke& stroke) {
      return stroke.x > 100 && stroke.x < 900 && right.shown.at(stroke.x, stroke.y + 7) == 0;
    });
    ASSERT_NE(flash, outcome->pass.end());
    core::Stroke moved = *flash;
    moved.y = static_cast<std::uint16_t>(moved.y + 7);
    outcome->pass.push_back(moved);
    const ComparedFlashes wrong = compare_flashes(exact, pieces, outcome->pass);
    EXPECT_EQ(wrong.difference.extra.all, right.difference.extra.all + 1);
    EXPECT_GT(wrong.difference.hausdorff.greatest, 1);
  }
}

TEST(Type340Points, OfTurningLinesEqualTheFlashesOfTheProgram) {
  const auto turning = Turning::of(*scene::generate_scene("boxes", 3, 1));
  ASSERT_TRUE(turning);
  const auto shown = turning->draw(40000);
  ASSERT_TRUE(shown);
  EXPECT_EQ(type340_points(shown->lines, LongLines::turn), shown->lit);
}

TEST(DividedAs, APieceThatLiesOnALineEndsThere) {
  const std::vector<PixelSegment> line{{{0, 0}, {100, 0}}};
  const std::vector<PixelSegment> pieces{{{0.4, 0.3}, {40, -0.5}},  // begins at the start of the line
                                         {{40.6, 0}, {70, 0.5}},    // continues
                                         {{20, 0}, {20, 30}},       // leaves it
                                         {{10, 1.5}, {90, 1.5}}};   // beside it
  const auto divided = divide_like(line, pieces);
  ASSERT_EQ(divided.size(), 3U);
  EXPECT_NEAR(divided[0].a.x, 0, 0);
  EXPECT_NEAR(divided[0].b.x, 40, 1e-9);
  EXPECT_NEAR(divided[1].a.x, 40, 1e-9);
  EXPECT_NEAR(divided[1].b.x, 70, 1e-9);
  EXPECT_NEAR(divided[2].b.x, 100, 0);
}

std::vector<picture::ReferenceLine> make_fully_visible(std::vector<picture::ReferenceLine> lines) {
  for (auto& line : lines) line.visible = {{0, 1}};
  return lines;
}

TEST(SkalaPoints, OfOneLineByHand) {
  const auto line = [](double ax, double ay, double bx, double by, std::vector<picture::LinePart> seen) {
    return std::vector<picture::ReferenceLine>{{0, {{ax, ay}, {bx, by}}, {{0, 1}}, std::move(seen)}};
  };
  // L = 4, l = 2, e = -2: over 0 at steps 1 and 3.
  EXPECT_EQ(lit(skala_points(line(3, 3, 7, 5, {{0, 1}}))), (Places{{3, 3}, {4, 4}, {5, 4}, {6, 5}, {7, 5}}));
  // The same to the left: e = -3.
  EXPECT_EQ(lit(skala_points(line(7, 5, 3, 3, {{0, 1}}))), (Places{{3, 3}, {4, 4}, {5, 4}, {6, 5}, {7, 5}}));
  // Visible from a quarter on, by columns.
  EXPECT_EQ(lit(skala_points(line(3, 3, 7, 5, {{0.25, 0.6}}))), (Places{{4, 4}, {5, 4}}));
  EXPECT_EQ(lit(skala_points(line(3, 3, 7, 5, {{0.3, 0.6}}))), (Places{{5, 4}}));
  EXPECT_EQ(lit(skala_points(line(3, 3, 7, 5, {{0.3, 0.6}}), SkalaDevice::plotter)), Places{}) << "one dot is dropped";
  EXPECT_EQ(lit(skala_points(line(3, 3, 7, 5, {{0.25, 0.6}}), SkalaDevice::plotter)), (Places{{4, 4}, {5, 4}}));
}

TEST(SkalaPoints, EqualTheProgramsIfNothingIsHidden) {
  for (const double rotation : {0.0, 33.0}) {
    algorithms::skala::View view;
    view.rotation = rotation;
    view.visibility = false;
    const scene::HeightGrid grid = scene::sample(*scene::height_function("sinc"), {17, 12});
    const auto lines = make_fully_visible(HeightLines(grid, view).lines());
    const auto on_board = programs::skala::run({.grid = grid, .view = view});
    ASSERT_TRUE(on_board) << on_board.error().message();
    EXPECT_EQ(skala_points(lines), points_of(on_board->picture.raster)) << rotation;
    const auto plotted = programs::skala::run({.grid = grid, .view = view, .device = programs::skala::Device::calcomp});
    ASSERT_TRUE(plotted) << plotted.error().message();
    EXPECT_EQ(skala_points(lines, SkalaDevice::plotter), points_of(programs::skala::pen_paths(plotted->picture.moves))) << rotation;
  }
}

TEST(LinesAsDrawn, TreatsPiecesAsVisibleParts) {
  const std::vector<picture::ReferenceLine> lines{{7, {{0, 0}, {10, 0}}, {{0, 1}}, {{0, 1}}},
                                                  {9, {{0, 0}, {0, 8}}, {{0, 1}}, {{0, 1}}}};
  const std::vector<picture::DrawnPiece> pieces{{7, {{5, 0.1}, {2, 0}}}, {7, {{4, 0}, {6, 0}}}, {8, {{0, 0}, {1, 1}}}};
  const auto drawn = lines_as_drawn(lines, pieces);
  ASSERT_EQ(drawn.size(), 2U);
  ASSERT_EQ(drawn[0].visible.size(), 1U);
  EXPECT_NEAR(drawn[0].visible[0].low, 0.2, 1e-9);
  EXPECT_NEAR(drawn[0].visible[0].high, 0.6, 1e-9);
  EXPECT_TRUE(drawn[1].visible.empty());
  EXPECT_EQ(visible_segments(drawn).size(), 1U);
}

TEST(StripesPenPoints, EqualThoseOfTheProgram) {
  const scene::PolyScene scene = scene::poly_scene_of(scene::builtin_scene("roberts"));
  programs::stripes::View view;
  view.camera = scene.camera;
  constexpr auto host = programs::stripes::Computer::host;
  const auto drawn = programs::stripes::run(
      {.scene = scene, .view = view, .options = {programs::stripes::Output::vector, host, host}, .check = true});
  ASSERT_TRUE(drawn) << drawn.error().message();
  const PixelGrid shown = points_of(programs::stripes::pen_paths(drawn->picture.commands));
  EXPECT_GT(lit(shown).size(), 300U);
  const PixelGrid expected = stripes_pen_points(*drawn->faces);
  // The pen cuts corners: it may omit the corner between two links, but goes nowhere else.
  EXPECT_EQ(unite_grids(expected, shown), expected);
  EXPECT_EQ(picture::raster_difference(expected, shown).missing.beyond_1, 0U);
}

TEST(StripesPen, IsNearTheBoundariesOfTheNearestFaces) {
  const scene::PolyScene scene = scene::poly_scene_of(scene::builtin_scene("roberts"));
  const auto truth = FaceTruth::of(scene, scene.camera);
  ASSERT_TRUE(truth);
  auto pen = stripes_pen(scene, scene.camera, truth->window(), truth->faces());
  ASSERT_TRUE(pen) << pen.error().message();
  EXPECT_EQ(pen->difference, "");
  EXPECT_GT(pen->raster.lit_in_drawn, 300U);
  EXPECT_EQ(pen->raster.missing.beyond_2, 0U);
  EXPECT_EQ(pen->raster.extra.beyond_2, 0U);
  // A boundary a hundred dots long that is not visible.
  picture::PixelGrid other = truth->faces();
  for (int x = 100; x < 200; ++x) other.set(x, 128, 77);
  const auto wrong = stripes_pen(scene, scene.camera, truth->window(), other);
  ASSERT_TRUE(wrong);
  EXPECT_GT(wrong->raster.missing.beyond_2, 50U);
}

}  // namespace
}  // namespace sightline::compare
