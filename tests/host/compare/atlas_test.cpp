// The error atlas of small scenes and of known views, compared with an independent loop over the same eyes.
#include "host/compare/atlas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/atlas_picture.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

namespace jones = programs::jones;
namespace oracle = algorithms::oracle;

std::vector<AtlasView> views_of(const scene::CellScene& scene, const std::vector<geometry::Point>& eyes,
                                const AtlasOptions& options = {}) {
  const auto atlas = ErrorAtlas::of(scene, eyes, options);
  if (!atlas) throw std::runtime_error(atlas.error().message());
  std::vector<AtlasView> views;
  for (std::size_t number = 0; number < eyes.size(); ++number) views.push_back(atlas->view(number));
  return views;
}

// Assembles the program for every eye, makes the visible lines from the scene, and samples lengths.
void expect_as_by_brute_force(const scene::CellScene& scene, const std::vector<geometry::Point>& eyes,
                              const AtlasOptions& options) {
  const std::vector<AtlasView> views = views_of(scene, eyes, options);
  ASSERT_EQ(views.size(), eyes.size());
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    SCOPED_TRACE(std::to_string(eyes[i][0]) + "," + std::to_string(eyes[i][1]) + "," +
                 std::to_string(eyes[i][2]));
    EXPECT_EQ(views[i].eye, eyes[i]);
    jones::Order order;
    order.views = 1;
    order.display = false;
    const auto program = jones::assemble_program(scene, {options.eae, static_cast<std::uint32_t>(options.fraction_bits), false}, eyes[i]);
    ASSERT_EQ(views[i].free, program.has_value());
    if (!program) continue;
    const auto outcome = jones::run_core(*program, program->core, order);
    ASSERT_TRUE(outcome);
    const jones::TwinView twin = jones::run_twin(*program, program->core, order);
    EXPECT_EQ(views[i].difference, "");
    EXPECT_EQ(views[i].emulated_ns, outcome->view().time.count());
    oracle::Window window;
    window.near = 1;
    std::vector<oracle::ScreenSegment> drawn;
    const double unit = 1 << options.fraction_bits;
    for (const jones::Piece& piece : twin.pieces)
      drawn.push_back({512 + piece.line.a.x / unit, 512 + piece.line.a.y / unit, 512 + piece.line.b.x / unit,
                       512 + piece.line.b.y / unit});
    const oracle::DrawnError error = oracle::drawn_error(
        oracle::on_screen(*oracle::visible_lines(scene, eyes[i], window), eyes[i], window), drawn, 1);
    EXPECT_EQ(views[i].is_wrong(), error.missing + error.extra > 0);
    // Differences come from the sampling step, and from overlapping lines.
    EXPECT_LE(views[i].wrong.true_length, error.true_length + 1e-6);
    EXPECT_NEAR(views[i].wrong.missing, error.missing, 1 + 0.1 * error.missing);
    EXPECT_NEAR(views[i].wrong.extra, error.extra, 1 + 0.1 * error.extra);
  }
}

TEST(Atlas, EqualsALoopOverItsEyes) {
  const scene::CellScene house = scene::builtin_scene("house");
  AtlasLattice lattice = default_lattice(house);
  lattice.columns = 5;
  lattice.rows = 6;
  expect_as_by_brute_force(house, lattice_eyes(house, lattice), {});
  // With eyes in solids; and known wrong views, with and without the EAE.
  const scene::CellScene street = scene::builtin_scene("street4");
  AtlasOptions options;
  options.eae = false;
  expect_as_by_brute_force(street, {{73, 582, 814}, {-400, 160, 600}, {298, 677, 1812}, {37, 160, 20}},
                           options);
  options.fraction_bits = 0;
  expect_as_by_brute_force(street, {{-534, 49, 2348}, {73, 582, 814}, {37, 160, 20}}, options);
}

std::string cause_in_street(const geometry::Point& eye, int fraction_bits = 3) {
  AtlasOptions options;
  options.fraction_bits = fraction_bits;
  const AtlasView view = views_of(scene::builtin_scene("street4"), {eye}, options).at(0);
  return view.cause ? view.cause->name() : "none";
}

TEST(Atlas, NamesTheCauseOfAWrongView) {
  // A mask of this view has the consecutive corners (855.750, 236.625), (1013.375, 110.375) and (1023, 102.625): the turn at the
  // second,
  // 157.625 x -7.75 + 126.25 x 9.625, is below 0, to the right. Unrounded it turns to the left.
  EXPECT_EQ(cause_in_street({73, 582, 814}), "mask corner");
  // The line x = -800, y = 0 ends at (0, 196.312) of the screen; the side of the mask along it goes to (0, 196.367) unrounded,
  // and to
  // (0, 196.25) between the rounded corners of its portal.
  EXPECT_EQ(cause_in_street({298, 677, 1812}), "rounding of a portal");
  EXPECT_EQ(cause_in_street({37, 160, 20}), "none");
  // Correct with the largest number of fraction bits of the program.
  EXPECT_EQ(cause_in_street({-534, 49, 2348}), "none");
  EXPECT_EQ(cause_in_street({-534, 49, 2348}, 0), "fraction bits");
}

TEST(Atlas, TheLineThatIsWrongIsNamed) {
  const AtlasView view = views_of(scene::builtin_scene("street4"), {{73, 582, 814}}).at(0);
  ASSERT_EQ(view.wrong.stretches.size(), 1U);
  EXPECT_EQ(view.wrong.stretches[0].line, (AxisLine{2, {800, 0}}));
  EXPECT_FALSE(view.wrong.stretches[0].extra);
  EXPECT_EQ(text_of(view.wrong.stretches[0].line), "parallel to z at x = 800, y = 0");
  EXPECT_EQ(view.cause->right_from_bits, 5);
}

// Cells in a row, each with a doorway to the next: each doorway takes a frame of 9 of the 450 words of the stack.
scene::CellScene doorways(std::int32_t cells) {
  scene::CellScene scene;
  scene.name = "doorways";
  scene.outer = {{0, 0, 0}, {40, 40, 20 * cells}};
  scene.default_view = {20, 20, 10};
  for (std::int32_t i = 0; i < cells; ++i) {
    scene.cells.push_back({{{0, 0, 20 * i}, {40, 40, 20 * i + 20}}, {}});
    if (i == 0) continue;
    const std::int32_t z = 20 * i;
    const geometry::Rectangle doorway{2, z, {geometry::Span{10, 30}, geometry::Span{10, 30}}};
    for (const auto& [x, y] : {std::pair{geometry::Span{0, 10}, geometry::Span{0, 40}},
                               std::pair{geometry::Span{30, 40}, geometry::Span{0, 40}},
                               std::pair{geometry::Span{10, 30}, geometry::Span{0, 10}},
                               std::pair{geometry::Span{10, 30}, geometry::Span{30, 40}}})
      scene.walls.push_back({2, z, {x, y}});
    const auto cell = static_cast<std::size_t>(i);
    scene.openings.push_back({{cell - 1, cell},
                              doorway,
                              {{10, 10, z}, {30, 10, z}, {30, 30, z}, {10, 30, z}},
                              {{true, 0, 20}, {true, 1, 20}, {true, 0, -20}, {true, 1, -20}}});
  }
  return scene;
}

TEST(Atlas, AProgramThatStopsIsASeparateCause) {
  const auto views = views_of(doorways(53), {{20, 20, 10}, {20, 20, 30}, {20, 20, 50}});
  for (const std::size_t through_51 : {0U, 1U}) {
    ASSERT_TRUE(views[through_51].is_wrong());
    EXPECT_EQ(views[through_51].cause->status, jones::Status::stack_overflow);
    EXPECT_EQ(views[through_51].cause->name(), "stack overflow");
  }
  EXPECT_TRUE(!views[2].is_wrong() || views[2].cause->status == jones::Status::complete)
      << "50 doorways take all 450 words";
  EXPECT_EQ(views[2].difference, "");
}

TEST(Atlas, LatticeEyesAreTheMiddlesOfRectangles) {
  scene::CellScene scene;
  scene.outer = {{0, 0, 100}, {40, 50, 130}};
  const std::vector<geometry::Point> expected{{10, 7, 105}, {30, 7, 105}, {10, 7, 115},
                                              {30, 7, 115}, {10, 7, 125}, {30, 7, 125}};
  EXPECT_EQ(lattice_eyes(scene, {2, 3, 7}), expected);
  // More steps than there are integer coordinates.
  EXPECT_EQ(lattice_eyes(scene, {1000, 1, 7}).size(), 40U);
  for (const char* name : {"house", "street4", "corridor32"}) {
    const scene::CellScene builtin = scene::builtin_scene(name);
    const AtlasLattice lattice = default_lattice(builtin);
    EXPECT_NEAR(lattice.columns * lattice.rows, 4000, 200) << name;
    EXPECT_EQ(lattice.height, builtin.default_view[1]) << name;
  }
}

TEST(Atlas, RandomEyesAreThoseOfASweep) {
  const scene::CellScene scene = scene::builtin_scene("street4");
  const auto eyes = random_eyes(scene, 20, 3);
  ASSERT_EQ(eyes.size(), 20U);
  const scene::PolyScene polyhedra = scene::poly_scene_of(scene);
  for (std::size_t k = 0; k < eyes.size(); ++k)
    EXPECT_EQ(eyes[k], sweep_camera(polyhedra, &scene, false, 3, k).eye);
}

TEST(Atlas, NoEyeInFreeSpaceIsAnError) {
  const scene::CellScene scene = scene::builtin_scene("street4");
  const auto atlas = ErrorAtlas::of(scene, {{-400, 160, 600}, {-400, 5000, 600}}, {});
  ASSERT_FALSE(atlas);
  EXPECT_NE(atlas.error().message().find("no eye in free space"), std::string::npos)
      << atlas.error().message();
}

// Views without a machine: the summary reads nothing else.
AtlasView view_with(std::int64_t milliseconds, std::vector<std::pair<AxisLine, double>> wrong,
                    bool hollow = true) {
  AtlasView view;
  view.free = true;
  view.emulated_ns = milliseconds * 1'000'000;
  for (const auto& [line, length] : wrong) {
    view.wrong.missing += length;
    view.wrong.stretches.push_back({line, false, length, {}});
  }
  if (!wrong.empty()) {
    view.cause.emplace();
    view.cause->concave_mask = hollow;
    view.cause->finer = {{false, true, false}};
    view.cause->right_from_bits = static_cast<int>(milliseconds);
  }
  return view;
}

TEST(Atlas, TheSummaryCountsAndClusters) {
  const AxisLine a{0, {1, 2}}, b{1, {3, 4}}, c{2, {5, 6}};
  std::vector<AtlasView> views;
  for (int i = 0; i < 94; ++i) views.push_back(view_with(1, {}));
  views.push_back(AtlasView{});                     // 94: no eye
  views.push_back(view_with(4, {{a, 2}}));          // 95
  views.push_back(view_with(5, {{c, 9}}));          // 96
  views.push_back(view_with(6, {{a, 1}, {b, 4}}));  // 97: connects 95 and 98
  views.push_back(view_with(2, {{b, 3}}));          // 98
  views.push_back(view_with(3, {{b, 30}}, false));  // 99: another cause
  AtlasView stopped = view_with(9, {{a, 1}});
  stopped.cause->status = jones::Status::display_file_overflow;
  views.push_back(stopped);  // 100
  const AtlasSummary summary = summary_of(views);
  EXPECT_EQ(summary.free, 100U);
  EXPECT_EQ(summary.wrong, 6U);
  EXPECT_EQ(summary.worst, 99U);
  EXPECT_EQ(summary.slowest, 100U);
  EXPECT_EQ(summary.time.median, 0.001);
  EXPECT_EQ(summary.time.of_99, 0.006);
  EXPECT_EQ(summary.time.greatest, 0.009);
  EXPECT_EQ(summary.wrong_length.of_90, 0);
  EXPECT_EQ(summary.wrong_length.greatest, 30);
  ASSERT_EQ(summary.clusters.size(), 4U);
  EXPECT_EQ(summary.clusters[0].cause, "rounding of a portal");
  EXPECT_EQ(summary.clusters[0].views, std::vector<std::size_t>{99});
  EXPECT_EQ(summary.clusters[1].line, c);
  EXPECT_EQ(summary.clusters[2].views, (std::vector<std::size_t>{95, 97, 98}));
  EXPECT_EQ(summary.clusters[2].line, b) << "two views each, and b is longer";
  EXPECT_EQ(summary.clusters[2].worst, 97U);
  EXPECT_EQ(summary.clusters[2].most_wrong, 5);
  EXPECT_EQ(summary.clusters[2].right_from_bits, 6);
  EXPECT_EQ(summary.clusters[3].cause, "display file overflow");
  EXPECT_EQ(summary.clusters[3].line, std::nullopt);
  EXPECT_FALSE(summary.differs_from_twin);
}

// The legend contains every colour; a wrong view adds its mark in one of them.
TEST(Atlas, ThePictureShowsAWrongViewWhereItsEyeIs) {
  const scene::CellScene scene = scene::builtin_scene("house");
  const AtlasLattice lattice{4, 4, 160};
  const auto eyes = lattice_eyes(scene, lattice);
  const auto count = [&](const std::vector<AtlasView>& views) {
    const picture::Image image = atlas_picture(scene, views, summary_of(views), lattice, {"title", "eyes"});
    std::array<std::size_t, 3>
        found{};  // of the class of the longest wrong lengths: pixels, greatest column, least row
    found[2] = 100000;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const std::uint8_t* const pixel = &image.pixels[image.index(column, row)];
        if (pixel[0] != 150 || pixel[1] != 0 || pixel[2] != 60) continue;
        ++found[0];
        found[1] = std::max(found[1], static_cast<std::size_t>(column));
        found[2] = std::min(found[2], static_cast<std::size_t>(row));
      }
    return found;
  };
  std::vector<AtlasView> views;
  for (const geometry::Point& eye : eyes) {
    views.push_back(view_with(1, {}));
    views.back().eye = eye;
  }
  const auto none = count(views);
  std::array<std::array<std::size_t, 3>, 2> found{};
  for (const std::size_t wrong : {0U, 15U}) {  // the least x and z, the greatest
    std::vector<AtlasView> with = views;
    with[wrong] = view_with(1, {{AxisLine{0, {1, 2}}, 50}});
    with[wrong].eye = eyes[wrong];
    found[wrong == 0 ? 0 : 1] = count(with);
    EXPECT_GT(found[wrong == 0 ? 0 : 1][0], none[0] + 500);
  }
  EXPECT_LT(found[0][1], found[1][1]) << "x runs to the right";
  EXPECT_GT(found[0][2], found[1][2]) << "z runs upwards";
}

}  // namespace
}  // namespace sightline::compare
