// Comparisons: the metrics receive what the oracles and programs drew.
#include "host/compare/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/base/result.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

namespace oracle = algorithms::oracle;
using picture::LineMetrics;

TEST(SeenEdge, IsClippedToTheFrameAndProjected) {
  const scene::PolyCamera camera;  // at the origin, along z
  ScreenFrame frame;               // 512 pixels at 45 degrees, 0..1023 around 512
  // Half of it is behind the near plane: z runs from -9 to 11, and is 1 at s = 0.5.
  const SeenEdge near({0, 0, -9}, {0, 5, 11}, camera);
  ASSERT_TRUE(near.part_in(frame));
  // y = 5 s, z = 20 s - 9; 512 y = 511 z at s = 4599 / 7660.
  EXPECT_NEAR(near.part_in(frame)->low, 4599.0 / 7660, 1e-12);
  EXPECT_NEAR(near.part_in(frame)->high, 1, 0);
  EXPECT_NEAR(near.pixel_at(1, frame).x, 512, 1e-12);
  EXPECT_NEAR(near.pixel_at(1, frame).y, 512 + 512 * 5.0 / 11, 1e-9);
  EXPECT_FALSE(SeenEdge({0, 0, -9}, {3, 3, -1}, camera).part_in(frame)) << "behind the eye";
  EXPECT_FALSE(SeenEdge({30, 0, 10}, {30, 5, 20}, camera).part_in(frame)) << "to the right of it";
  // A camera along x with vectors of length 2 sees y to the ... left: right = (0, 0, -2).
  const scene::PolyCamera along_x{true, {1, 0, 0}, {2, 0, 0}, {0, 0, -2}, {0, 2, 0}};
  const SeenEdge side({11, 0, 0}, {11, 4, -5}, along_x);
  EXPECT_NEAR(side.pixel_at(1, frame).x, 512 + 512 * 0.5, 1e-9);
  EXPECT_NEAR(side.pixel_at(1, frame).y, 512 + 512 * 0.4, 1e-9);
}

void expect_nothing(const LineMetrics& m) {
  EXPECT_NEAR(m.missing, 0, 1e-6);
  EXPECT_NEAR(m.extra, 0, 1e-6);
  EXPECT_NEAR(m.hausdorff.greatest, 0, 1e-6);
  EXPECT_EQ(m.wrong_visibility.wrong, 0U);
  EXPECT_EQ(m.pieces_different, 0U);
}

TEST(ExactPictures, HaveNoErrorComparedWithThemselves) {
  for (const bool perspective : {true, false}) {
    scene::PolyScene scene = scene::generate_boxes(20, 5);
    scene.camera.perspective = perspective;
    const auto picture = algorithms::exact::visible_edges(scene, scene.camera);
    const ScreenFrame frame = fitted_frame(picture, scene, scene.camera);
    const ImageLines lines(picture, scene, scene.camera, frame);
    const auto& truth = lines.lines();
    const LineMetrics m = line_metrics(truth, lines.pieces(picture));
    expect_nothing(m);
    EXPECT_GT(m.true_length, 2000);
    double low = 1e9;
    double high = -1e9;
    for (const auto& line : truth) {
      for (const auto& part : line.visible) {
        for (const double place : {part.low, part.high}) {
          const auto p = picture::point_at(line.image, place);
          low = std::min({low, p.x, p.y});
          high = std::max({high, p.x, p.y});
        }
      }
    }
    EXPECT_NEAR(low, 24, 1e-6) << "the picture fills its frame in one direction";
    EXPECT_NEAR(high, 999, 1e-6);
    // Without its first piece, that piece is missing.
    picture::LinePicture less = picture;
    less.pieces.erase(less.pieces.begin());
    const LineMetrics lost = line_metrics(truth, lines.pieces(less));
    EXPECT_EQ(lost.pieces_different, 1U);
    EXPECT_GT(lost.missing, 0);
    EXPECT_NEAR(lost.extra, 0, 1e-6);
  }
}

// The visible part on a screen of 1024 points, of any scene of cells from any eye.
oracle::Window screen() {
  oracle::Window window;
  window.near = programs::jones::near_z;
  return window;
}

ScreenFrame screen_frame() {
  ScreenFrame frame;
  frame.near = programs::jones::near_z;
  return frame;
}

scene::PolyCamera along_z(const geometry::Point& eye) {
  scene::PolyCamera camera;
  camera.eye = eye;
  return camera;
}

// The length that segments cover, counting overlaps on a line once: by brute force, on lines found by slope.
double covered_length(const std::vector<oracle::ScreenSegment>& segments) {
  double length = 0;
  std::vector<bool> taken(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (taken[i]) continue;
    const auto& s = segments[i];
    const double dx = s.x1 - s.x0;
    const double dy = s.y1 - s.y0;
    const double of_s = std::hypot(dx, dy);
    if (of_s < 1e-9) continue;
    const auto along = [&](double x, double y) { return ((x - s.x0) * dx + (y - s.y0) * dy) / of_s; };
    const auto beside = [&](double x, double y) { return std::abs((x - s.x0) * dy - (y - s.y0) * dx) / of_s; };
    std::vector<std::pair<double, double>> parts;
    for (std::size_t j = i; j < segments.size(); ++j) {
      const auto& t = segments[j];
      if (taken[j] || beside(t.x0, t.y0) > 1e-6 || beside(t.x1, t.y1) > 1e-6) continue;
      taken[j] = true;
      parts.push_back(std::minmax(along(t.x0, t.y0), along(t.x1, t.y1)));
    }
    std::sort(parts.begin(), parts.end());
    double end = -1e9;
    for (const auto& [low, high] : parts) {
      if (high > end) length += high - std::max(low, end);
      end = std::max(end, high);
    }
  }
  return length;
}

// The reference of a scene of cells, by the lines of the comparison and by the oracle's own segments.
TEST(ImageLinesOfCells, HaveTheLengthOfTheOracle) {
  for (const char* name : {"house", "roberts", "street4", "corridor8"}) {
    SCOPED_TRACE(name);
    const scene::CellScene scene = scene::builtin_scene(name);
    const MatterScene matter = *MatterScene::of(scene);
    const geometry::Point& eye = scene.default_view;
    const auto chosen = matter.lines_at(eye);
    const ImageLines image(matter.visible(eye, screen()), matter.scene(), along_z(eye), screen_frame(), &chosen);
    double measured = 0;
    std::set<picture::LineId> ids;
    for (const auto& line : image.lines()) {
      measured += picture::total(line.visible) * picture::length_of(line.image);
      EXPECT_TRUE(ids.insert(line.id).second);
      EXPECT_NEAR(picture::total(picture::without(line.visible, line.edges)), 0, 1e-9) << "only edges are visible";
    }
    const double length = covered_length(oracle::on_screen(*oracle::visible_lines(scene, eye, screen()), eye, screen()));
    EXPECT_GT(length, 1000);
    EXPECT_NEAR(measured, length, 1e-6 * length);
  }
}

// From random eyes: one true length for all rows, and exact methods draw exactly that.
TEST(CompareCellScene, HasOneTrueLengthForAllRows) {
  for (const char* name : {"house", "roberts", "street4", "corridor8"}) {
    const scene::CellScene scene = scene::builtin_scene(name);
    const scene::PolyScene polyhedra = scene::poly_scene_of(scene);
    CompareOptions options;
    options.faces = false;
    const auto methods = SceneMethods::of(scene, options);
    ASSERT_TRUE(methods) << methods.error().message();
    for (std::uint64_t number = 0; number < 12; ++number) {
      SCOPED_TRACE(std::string(name) + " view " + std::to_string(number));
      const auto camera = sweep_camera(polyhedra, &scene, false, 39, number);
      const auto comparison = methods->view(camera);
      ASSERT_TRUE(comparison) << comparison.error().message();
      const double length = covered_length(oracle::on_screen(*oracle::visible_lines(scene, camera.eye, screen()), camera.eye, screen()));
      std::size_t exact = 0;
      for (const ComparedPicture& row : comparison->pictures) {
        EXPECT_NEAR(row.metrics.true_length, length, 1e-6 * (1 + length)) << row.name;
        if (!row.identical) continue;
        ++exact;
        EXPECT_TRUE(*row.identical) << row.name;
        EXPECT_NEAR(row.metrics.symmetric(), 0, 1e-6) << row.name;
      }
      EXPECT_EQ(exact, 3U) << "exact, jones, montani-re";
    }
  }
}

TEST(LinesOfVectors, EqualTheScenesLines) {
  for (const char* name : {"house", "roberts", "street4", "corridor8"}) {
    SCOPED_TRACE(name);
    const scene::CellScene scene = scene::builtin_scene(name);
    const MatterScene matter = *MatterScene::of(scene);
    const geometry::Point& eye = scene.default_view;
    const ImageLines image({}, matter.scene(), along_z(eye), screen_frame());
    const auto line_on = [&](std::size_t axis, const geometry::Point& p) {
      const auto [u, v] = geometry::other_axes(axis);
      const auto wire = matter.wire_on({axis, {p[u], p[v]}});
      EXPECT_TRUE(wire);
      return image.line_of(*wire);
    };
    const auto encoded = *programs::jones::encode(scene, {}, 04000);
    std::multiset<picture::LineId> found;
    for (const auto& [address, line] : lines_of_vectors(encoded, matter, image)) {
      if (encoded.words.at(address - encoded.base).value & 0400000) found.insert(line);
    }
    std::multiset<picture::LineId> expected;
    for (const scene::Cell& cell : scene.cells) {
      for (const scene::Line& line : cell.lines) {
        const std::size_t axis = line.from[0] != line.to[0] ? 0 : line.from[1] != line.to[1] ? 1 : 2;
        expected.insert(line_on(axis, line.from));
      }
    }
    for (const scene::Opening& opening : scene.openings) {
      geometry::Point pen = opening.ring[0];
      for (const scene::RingVector& v : opening.vectors) {
        if (v.actual) expected.insert(line_on(v.axis, pen));
        pen[v.axis] += v.magnitude;
      }
    }
    EXPECT_EQ(found, expected);
  }
}

SceneComparison compare_named(const char* name, const CompareOptions& options = {}) {
  auto result = compare_cell_scene(scene::builtin_scene(name), options);
  EXPECT_TRUE(result) << (!result ? result.error().message() : "");
  return !result ? SceneComparison{} : std::move(*result);
}

const ComparedPicture& picture_named(const SceneComparison& comparison, std::string_view name) {
  return *std::find_if(comparison.pictures.begin(), comparison.pictures.end(),
                       [name](const ComparedPicture& p) { return p.name == name; });
}

TEST(CompareCellScene, GuestEqualsTwinAndExactIsExact) {
  const SceneComparison comparison = compare_named("roberts");
  EXPECT_TRUE(comparison.agrees());
  ASSERT_TRUE(comparison.guest);
  EXPECT_EQ(comparison.guest->difference, "");
  EXPECT_GT(comparison.guest->words, 20U);
  const ComparedPicture& exact = picture_named(comparison, "exact");
  EXPECT_EQ(exact.identical, true);
  expect_nothing(exact.metrics);
  const ComparedPicture& guest = picture_named(comparison, "jones-pdp7");
  const ComparedPicture& twin = picture_named(comparison, "jones-twin");
  // Half points and points are a quarter and half a point off in each direction.
  EXPECT_LT(guest.metrics.share(guest.metrics.extra_far), 0.01);
  EXPECT_LT(twin.metrics.share(twin.metrics.missing_far), 0.01);
  EXPECT_GT(guest.metrics.hausdorff.greatest, 0);
  EXPECT_GT(guest.metrics.symmetric(), 0) << "18 bits are not exact";
  EXPECT_FALSE(guest.metrics.symmetric() == twin.metrics.symmetric()) << "rounding to points is measured";
}

TEST(CompareCellScene, TakesEyeAndScale) {
  CompareOptions options;
  options.scale = 256;
  const auto small = compare_named("house", options);
  const auto usual = compare_named("house");
  EXPECT_LT(picture_named(small, "jones-twin").metrics.hausdorff.greatest, 8);
  EXPECT_NE(picture_named(small, "jones-twin").metrics.true_length,
            picture_named(usual, "jones-twin").metrics.true_length);
  EXPECT_TRUE(small.agrees());
  options.eye = geometry::Point{100'000, 0, 0};
  EXPECT_FALSE(compare_cell_scene(scene::builtin_scene("house"), options));
}

TEST(ComparePolyScene, RejectsAnEyeInASolid) {
  const scene::PolyScene scene = scene::generate_boxes(3);
  scene::PolyCamera camera = scene.camera;
  EXPECT_TRUE(compare_poly_scene(scene, camera)->agrees());
  const auto& corner = scene.vertices[scene.bodies[0].faces[0].outline[0]];
  camera.eye = corner;
  EXPECT_FALSE(compare_poly_scene(scene, camera));
}

// Seen horizontally, the tops and bottoms of boxes are lines: of edges behind each other only the nearest is drawn.
TEST(ComparePolyScene, OfEdgesThatCoincideInTheImageOneIsEnough) {
  scene::PolyScene scene = scene::generate_boxes(8);
  scene::PolyCamera camera = scene.camera;
  camera.perspective = false;
  camera.forward = {0, 0, -1};
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  const auto comparison = *compare_poly_scene(scene, camera);
  EXPECT_TRUE(comparison.agrees());
  const ComparedPicture& stripes = picture_named(comparison, "montani-re");
  const ComparedPicture& exact = picture_named(comparison, "exact");
  expect_nothing(stripes.metrics);
  expect_nothing(exact.metrics);
  EXPECT_EQ(stripes.metrics.true_length, exact.metrics.true_length);
  // The sum over the individual edges is longer.
  const auto all = algorithms::exact::visible_edges(scene, camera);
  const double edges = picture::image_length(all, scene, camera) * comparison.frame.scale;
  EXPECT_LT(stripes.metrics.true_length, 0.9 * edges);
  EXPECT_GT(stripes.metrics.true_length, 0.3 * edges);
}

// The eye of a parallel view only gives the origin of the image: from within the scene and from far away the same lines are
// visible,
// and all faces equal the nearest ones, including those seen end-on.
TEST(ComparePolyScene, FacesInParallelProjectionAreTheNearestOnes) {
  const scene::PolyCamera level{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  const scene::PolyCamera oblique{false, {}, {-4, -3, -4}, {4, 0, -4}, {-12, 32, -12}};
  for (scene::PolyCamera camera : {level, oblique}) {
    for (const scene::PolyScene& scene : {scene::generate_boxes(8), scene::generate_triangles(8, 3)}) {
      std::vector<picture::PixelGrid> truths;
      for (const scene::PolyPoint& eye : {scene::PolyPoint{500, 500, 500}, {-200'000, 7, 99'000}}) {
        camera.eye = eye;
        const auto truth = FaceTruth::of(scene, camera);
        truths.push_back(truth->faces());
        for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) {
          const auto compared = truth->compare(algorithm);
          const auto& metrics = compared->metrics;
          EXPECT_EQ(metrics.different_inside, 0U) << scene.name << ' ' << algorithm.name;
          EXPECT_GT(metrics.lit, metrics.pixels / 10) << scene.name;
          EXPECT_LT(metrics.boundary_pixels, metrics.pixels / 2) << scene.name;
        }
      }
      const picture::PixelMetrics apart = picture::pixel_metrics(truths[0], truths[1], {});
      EXPECT_LT(apart.different(), apart.pixels / 500) << scene.name;
    }
  }
}

// At angle 0 the machine shows the view from the positive z axis, after a quarter turn the view from the positive x axis.
TEST(CompareTurn, AnglesOfTheMachineAreThoseOfCameras) {
  const auto along = [](std::int32_t x, std::int32_t y, std::int32_t z) {
    scene::PolyCamera camera{false, {0, 0, 0}, {x, y, z}, {z, 0, -x}, {0, 1, 0}};
    return turn_angle_of(camera);
  };
  EXPECT_EQ(along(0, 0, -7), 0U);
  EXPECT_EQ(along(-5, 0, 0), 1U << 16);
  EXPECT_EQ(along(0, 0, 1), 1U << 17);
  EXPECT_EQ(along(1, 0, 0), 3U << 16);
  EXPECT_EQ(along(2, 0, -2), 7U << 15);
  scene::PolyCamera down{false, {0, 0, 0}, {0, -1, 1}, {1, 0, 0}, {0, 1, 1}};
  EXPECT_FALSE(turn_angle_of(down));
  EXPECT_FALSE(turn_angle_of(scene::PolyCamera{}));  // in perspective
}

// A flash is no farther off than the machine's words and the deviation of its beam explain (host/programs/turn/precision.hpp).
TEST(CompareTurn, EqualsItsTwinAndIsNearTheExactLines) {
  for (const std::uint32_t angle : {0U, 26843U, 40000U, 123456U, 262143U}) {
    const auto check = check_turn(scene::generate_boxes(5, 3), angle);
    ASSERT_TRUE(check) << check.error().message();
    EXPECT_EQ(check->angle, angle);
    EXPECT_EQ(check->difference, "");
    EXPECT_GT(check->flashes, 1000U);
    EXPECT_LE(check->distance.greatest, check->bound) << angle;
    // The largest distance seen so far; it shows that the bound has an effect.
    EXPECT_LT(check->distance.greatest, 3.7) << angle;
    EXPECT_LT(check->distance.usual, 3) << angle;
    EXPECT_LT(check->bound, 6) << angle;
    // By the program's own rule only ends that rounding moved by a point differ.
    EXPECT_GT(check->raster.lit_in_truth, 1000U);
    EXPECT_LT(check->raster.missing.all + check->raster.extra.all, check->raster.lit_in_truth / 100) << angle;
    EXPECT_EQ(check->raster.missing.beyond_2 + check->raster.extra.beyond_2, 0U) << angle;
    EXPECT_TRUE(check->agrees());
  }
  const auto large = check_turn(scene::generate_boxes(60, 3), 0);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().message().find("720 edges"), std::string::npos) << large.error().message();
}

// A box seen horizontally: three upright edges, and its top and its bottom as one line each, on which two or more edges coincide.
TEST(CompareTurn, CoincidentLinesCountOnce) {
  scene::PolyScene box;
  box.vertices = {{-10, 0, -5}, {10, 0, -5}, {10, 60, -5}, {-10, 60, -5}, {-10, 0, 5}, {10, 0, 5}, {10, 60, 5}, {-10, 60, 5}};
  box.bodies = {{"", true, {{{3, 2, 1, 0}, {}}, {{4, 5, 6, 7}, {}}, {{0, 1, 5, 4}, {}}, {{1, 2, 6, 5}, {}}, {{2, 3, 7, 6}, {}}, {{3, 0, 4, 7}, {}}}}};
  constexpr std::uint32_t angle = 30'000;
  const auto check = check_turn(box, angle);
  ASSERT_TRUE(check) << check.error().message();
  const double radians = 2 * 3.14159265358979323846 * angle / (1 << 18);
  const double width = 20 * std::abs(std::cos(radians)) + 10 * std::abs(std::sin(radians));
  // The farthest vertex is 505 points from the middle: 30 units above it.
  EXPECT_NEAR(check->metrics.true_length, (3 * 60 + 2 * width) * 505 / 30, 1e-6);
}

TEST(ComparePolyScene, HasNoFacesOfAnImageTooSmallForItsDepth) {
  scene::PolyScene scene;
  scene.vertices = {{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 100'000}, {0, 2, 100'000}, {2, 0, 100'000}};
  scene.bodies = {{"", true, {{{0, 1, 2}, {}}, {{3, 4, 5}, {}}}}};
  scene::PolyCamera camera;
  camera.perspective = false;
  EXPECT_FALSE(FaceTruth::of(scene, camera));
  for (scene::PolyPoint& v : scene.vertices) v[2] /= 1000;
  EXPECT_TRUE(FaceTruth::of(scene, camera));
}

TEST(SceneComparison, DoesNotAgreeIfAnyoneIsWrong) {
  SceneComparison comparison;
  EXPECT_TRUE(comparison.agrees());
  comparison.pictures.push_back({"exact", "", true, {}, {}, {}, {}, {}});
  comparison.pictures.push_back({"jones-twin", "", std::nullopt, {}, {}, {}, {}, {}});
  EXPECT_TRUE(comparison.agrees());
  comparison.guest.emplace().difference = "word 7";
  EXPECT_FALSE(comparison.agrees());
  comparison.guest->difference.clear();
  comparison.pictures.push_back({"jones", "", false, {}, {}, {}, {}, {}});
  EXPECT_FALSE(comparison.agrees());
}

TEST(CompareHeights, TwinAndGuestEqualTheOracleAndNativeIsNear) {
  const auto grid = scene::sample(*scene::height_function("sinc"), {33, 60});
  algorithms::skala::View view;
  view.rotation = 30;
  const HeightComparison comparison = compare_heights(grid, view);
  EXPECT_TRUE(comparison.agrees()) << comparison.guest_difference;
  ASSERT_EQ(comparison.rasters.size(), 3U);
  EXPECT_EQ(comparison.rasters[0].grid, comparison.rasters[1].grid);
  EXPECT_EQ(comparison.rasters[1].metrics.different(), 0U) << "the twin, at this view";
  const picture::PixelMetrics& native = comparison.rasters[2].metrics;
  EXPECT_GT(native.lit, 5'000U);
  // The native algorithm does not round vertices to points: dots move by one, few by more.
  EXPECT_LT(native.missing_far + native.extra_far, native.lit / 100);
  EXPECT_LT(native.interior_mismatch(), 0.01);
}

TEST(CompareHeights, ReportsWhatItCannotCompare) {
  auto grid = scene::sample(*scene::height_function("sinc"), {9, 9});
  algorithms::skala::View view;
  EXPECT_FALSE(why_not_comparable(grid, view));
  view.zoom = 2;
  EXPECT_TRUE(why_not_comparable(grid, view));
  view.zoom = 1;
  view.family = algorithms::skala::Family::along_z;
  EXPECT_TRUE(why_not_comparable(grid, view)) << "seen end-on";
  view.rotation = 80;
  EXPECT_FALSE(why_not_comparable(grid, view));
  view.family = algorithms::skala::Family::along_x;
  EXPECT_TRUE(why_not_comparable(grid, view));
  view.subject = algorithms::skala::Subject::contours;
  EXPECT_FALSE(why_not_comparable(grid, view)) << "contours go by cells";
  grid.heights[5] = std::nan("");
  EXPECT_TRUE(why_not_comparable(grid, view));
}

}  // namespace
}  // namespace sightline::compare
