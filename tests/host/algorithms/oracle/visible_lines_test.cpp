// Visible intervals compared with a point-by-point ray test without grids, and, where sight lines only touch matter, with cases
// computed by hand.
#include "host/algorithms/oracle/visible_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "host/geometry/integer.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::Box;
using geometry::Int128;
using geometry::IntervalSet;
using geometry::Point;
using geometry::Rational;
using geometry::Rectangle;
using geometry::Span;

// A point of a line relative to the eye, its three coordinates with a common denominator.
struct RayEnd {
  std::array<Int128, 3> over{};
  Int128 denominator = 1;
};

RayEnd ray_to(const RealLine& line, const Point& eye, const Rational& t) {
  RayEnd ray;
  ray.denominator = t.denominator();
  for (std::size_t a = 0; a < 3; ++a) {
    ray.over[a] =
        Int128{line.from[a] - eye[a]} * t.denominator() + Int128{line.to[a] - line.from[a]} * t.numerator();
  }
  return ray;
}

// Whether the open segment from the eye (the origin) to the point passes the inside of a box, or the plane of a wall inside the
// wall.
// For s in (0, 1): low < s r < high on all axes with an extent, s r = at on one without.
bool passes(const RayEnd& ray, const Box& box, const Point& eye) {
  struct Fraction {
    Int128 n, d;  // d > 0
  };
  const auto less = [](const Fraction& a, const Fraction& b) { return a.n * b.d < b.n * a.d; };
  Fraction enter{0, 1};
  Fraction leave{1, 1};
  for (std::size_t a = 0; a < 3; ++a) {
    const Int128 low = Int128{box.low[a] - eye[a]} * ray.denominator;
    const Int128 high = Int128{box.high[a] - eye[a]} * ray.denominator;
    const Int128 r = ray.over[a];
    if (r == 0) {
      if (low == high || low >= 0 || high <= 0) return false;
      continue;
    }
    Fraction first = r > 0 ? Fraction{low, r} : Fraction{-high, -r};
    Fraction second = r > 0 ? Fraction{high, r} : Fraction{-low, -r};
    if (less(enter, first)) enter = first;
    if (less(second, leave)) leave = second;
  }
  if (less(enter, leave)) return true;
  // A wall is passed at only one s, which is not at the eye or the point itself.
  const bool flat = box.low[0] == box.high[0] || box.low[1] == box.high[1] || box.low[2] == box.high[2];
  return flat && !less(leave, enter) && enter.n > 0 && enter.n < enter.d;
}

// `passes` also counts a wall passed exactly at its boundary; callers avoid such points.
bool blocked(const scene::CellScene& scene, const RayEnd& ray, const Point& eye) {
  for (const Box& solid : scene.solids) {
    if (passes(ray, solid, eye)) return true;
  }
  for (const Rectangle& wall : scene.walls) {
    if (passes(ray, wall.bounds(), eye)) return true;
  }
  return false;
}

bool in_window(const RayEnd& ray, const Window& w) {
  bool inside = ray.over[2] >= w.near * ray.denominator;
  for (std::size_t b = 0; b < 2; ++b) {
    const Int128 scaled = w.scale * ray.over[b];
    inside = inside && scaled >= (w.points[b].low - w.centre[b]) * ray.over[2] &&
             scaled <= (w.points[b].high - w.centre[b]) * ray.over[2];
  }
  return inside;
}

bool faces_a_feature(const RealLine& line, const Point& eye) {
  const auto [u, v] = geometry::other_axes(line.axis);
  const std::size_t quadrant = (eye[u] > line.from[u] ? 1U : 0U) + (eye[v] > line.from[v] ? 2U : 0U);
  return line.feature[quadrant];
}

// An integer eye that lies in no plane of the scene, so that no sight line lies in one.
Point random_eye(const scene::CellScene& scene, const Matter& matter, std::mt19937& random) {
  for (;;) {
    Point eye;
    bool good = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto length = static_cast<unsigned>(scene.outer.span(a).length());
      // Half of the eyes are in the nearest quarter, from which most is visible.
      const unsigned range = a == 2 && random() % 2 == 0 ? length / 4 : length;
      eye[a] = scene.outer.low[a] + static_cast<std::int32_t>(random() % range);
      for (const std::int32_t g : matter.grid(a)) good = good && g != eye[a];
    }
    for (const Box& solid : scene.solids) good = good && !solid.contains(eye);
    if (good) return eye;
  }
}

const VisibleLine* find(const std::vector<VisibleLine>& visible, const RealLine& line) {
  for (const VisibleLine& v : visible) {
    if (v.p == line.from && v.q == line.to) return &v;
  }
  return nullptr;
}

class OfScene : public testing::TestWithParam<const char*> {};

TEST_P(OfScene, AgreesWithARayTestAtRandomPoints) {
  const scene::CellScene scene = scene::builtin_scene(GetParam());
  const Matter matter = Matter::of(scene).value();
  const auto lines = matter.real_lines();
  std::mt19937 random(1971);
  int seen_points = 0;
  for (int view = 0; view < 40; ++view) {
    const Point eye = view == 0 ? scene.default_view : random_eye(scene, matter, random);
    Window window;
    window.scale = view % 3 == 2 ? static_cast<std::int32_t>(64 + random() % 4000) : 512;
    if (view % 4 == 3) {
      window.centre = {256, 512};
      window.points[0] = {0, 511};
    }
    const auto visible = visible_lines(matter, lines, eye, window);
    for (const RealLine& line : lines) {
      const VisibleLine* found = find(visible, line);
      for (int sample = 0; sample < 12; ++sample) {
        // A prime denominator keeps samples off the ends of intervals, where a ray only touches matter.
        const Rational t(static_cast<std::int64_t>(random() % 9972 + 1), 9973);
        const RayEnd ray = ray_to(line, eye, t);
        const bool expected =
            faces_a_feature(line, eye) && in_window(ray, window) && !blocked(scene, ray, eye);
        seen_points += expected ? 1 : 0;
        ASSERT_EQ(found != nullptr && found->intervals.contains(t), expected)
            << "eye " << eye[0] << ' ' << eye[1] << ' ' << eye[2] << ", axis " << line.axis << " from "
            << line.from[0] << ' ' << line.from[1] << ' ' << line.from[2] << " at " << t.to_double();
      }
    }
  }
  EXPECT_GT(seen_points, 500);
}

// Something must begin to hide the line where an interval ends: a ray just inside is free, a ray just outside is not.
TEST_P(OfScene, IntervalsEndExactlyWhereSightDoes) {
  const scene::CellScene scene = scene::builtin_scene(GetParam());
  const Matter matter = Matter::of(scene).value();
  const auto lines = matter.real_lines();
  std::mt19937 random(340);
  constexpr std::int64_t fine = 1 << 20;
  int ends = 0;
  for (int view = 0; view < 40; ++view) {
    const Point eye = view == 0 ? scene.default_view : random_eye(scene, matter, random);
    const auto visible = visible_lines(matter, lines, eye, Window{});
    for (const RealLine& line : lines) {
      const VisibleLine* found = find(visible, line);
      if (!found) continue;
      for (const auto& [low, high] : found->intervals.intervals()) {
        for (const bool upper : {false, true}) {
          const Rational& end = upper ? high : low;
          if (end.numerator() == 0 || end == Rational(1)) continue;
          const auto shifted = [&](std::int64_t by) {
            return ray_to(line, eye, Rational(end.numerator() * fine + by, end.denominator() * fine));
          };
          const auto sees = [&](const RayEnd& r) {
            return in_window(r, Window{}) && !blocked(scene, r, eye);
          };
          ASSERT_TRUE(sees(shifted(upper ? -1 : 1)));
          ASSERT_FALSE(sees(shifted(upper ? 1 : -1)));
          ++ends;
        }
      }
    }
  }
  EXPECT_GT(ends, 50);
}

INSTANTIATE_TEST_SUITE_P(Builtin, OfScene,
                         testing::Values("house", "roberts", "street4", "corridor8", "corridor32"),
                         [](const auto& test) { return std::string(test.param); });

// ---- sight lines that only touch matter ----

scene::CellScene room(std::vector<Box> solids, std::vector<Rectangle> walls) {
  scene::CellScene scene;
  scene.outer = {{-100, -100, 0}, {100, 100, 400}};
  scene.solids = std::move(solids);
  scene.walls = std::move(walls);
  return scene;
}

IntervalSet seen_of(const scene::CellScene& scene, const Point& eye, const Point& p, const Point& q) {
  const auto visible = visible_lines(scene, eye, Window{}).value();
  for (const VisibleLine& line : visible) {
    if (line.p == p && line.q == q) return line.intervals;
  }
  return {};
}

TEST(Touching, AnEmptyRoomShowsItsFarEdgesWhole) {
  EXPECT_EQ(seen_of(room({}, {}), {0, 0, 1}, {-100, 100, 400}, {100, 100, 400}), IntervalSet(0, 1));
}

TEST(Touching, TheJointOfTwoWallsHidesWhatIsBehindIt) {
  // Walls at z = 100 above and below y = 20, x -50..50; the eye and the far sheet's rim are at y = 20 too.
  const Rectangle above{2, 100, {Span{-50, 50}, Span{20, 60}}};
  const Rectangle below{2, 100, {Span{-50, 50}, Span{-60, 20}}};
  const Rectangle far{2, 200, {Span{-80, 80}, Span{20, 90}}};
  const Point eye{0, 20, 0};
  const Point p{-80, 20, 200};
  const Point q{80, 20, 200};
  // Both walls: hidden from -100 to 100, which is everything.
  EXPECT_TRUE(seen_of(room({}, {above, below, far}), eye, p, q).empty());
  // One wall: the sight line passes along its boundary.
  EXPECT_EQ(seen_of(room({}, {above, far}), eye, p, q), IntervalSet(0, 1));
  EXPECT_EQ(seen_of(room({}, {below, far}), eye, p, q), IntervalSet(0, 1));
}

TEST(Touching, TheLintelOfAFartherDoorIsSeenThroughANearerOneOfTheSameHeight) {
  const auto corridor =
      scene::builtin_scene("corridor8");  // doors up to 210; the first at x 130..240, the second 70..180
  const auto visible = visible_lines(corridor, Point{140, 210, 30}, Window{}).value();
  // lintel of the second door (z = 800), x 70..180: rays pass z = 400 at 140 + (x - 140) 370/770
  IntervalSet seen;
  for (const VisibleLine& line : visible) {
    if (line.p[1] == 210 && line.p[2] == 800 && line.q[2] == 800) seen = line.intervals;
  }
  ASSERT_EQ(seen.intervals().size(), 1U);
  // 130 at the first door is x = 140 - 10 * 770/370 on the second: t = (70 - 7700/370) / 110 measured from 70
  EXPECT_EQ(seen.intervals()[0].low, Rational(70 * 370 - 7700, 370 * 110));
  EXPECT_EQ(seen.intervals()[0].high, Rational(1));
}

TEST(Touching, NothingIsSeenThroughTheJointOfTwoSolids) {
  const Box upper{{-50, 20, 100}, {50, 60, 150}};
  const Box lower{{-50, -60, 100}, {50, 20, 150}};
  const Rectangle far{2, 200, {Span{-40, 40}, Span{20, 90}}};
  const Point eye{0, 20, 0};
  EXPECT_TRUE(seen_of(room({upper, lower}, {far}), eye, {-40, 20, 200}, {40, 20, 200}).empty());
  EXPECT_EQ(seen_of(room({upper}, {far}), eye, {-40, 20, 200}, {40, 20, 200}), IntervalSet(0, 1));
}

TEST(Touching, NothingIsSeenThroughAnEdgeWhereTwoSolidsMeet) {
  // Diagonal solids that meet in the edge x = 10, z = 100; the sight line passes across the edge.
  const Box left{{-50, -50, 60}, {10, 50, 100}};
  const Box right{{10, -50, 100}, {70, 50, 140}};
  const Rectangle far{2, 200, {Span{20, 60}, Span{-40, 40}}};
  const Point eye{0, 0, 0};
  // The sheet's left side x = 20, z = 200 is exactly behind the edge.
  EXPECT_TRUE(seen_of(room({left, right}, {far}), eye, {20, -40, 200}, {20, 40, 200}).empty());
  // A solid on only one side is touched and passed.
  EXPECT_EQ(seen_of(room({{{10, -50, 100}, {70, 50, 140}}}, {}), eye, {10, -50, 100}, {10, 50, 100}),
            IntervalSet(0, 1));
}

TEST(Touching, ASightLineAlongAWallIsFree) {
  const Rectangle wall{0, 0, {Span{-100, 100}, Span{50, 150}}};
  const Rectangle far{2, 200, {Span{0, 60}, Span{-40, 40}}};
  EXPECT_EQ(seen_of(room({}, {wall, far}), {0, 0, 0}, {0, -40, 200}, {0, 40, 200}), IntervalSet(0, 1));
}

TEST(Window, CutsExactlyAtTheNearPlaneAndAtTheEdgesOfTheScreen) {
  // the room's edge x = 100, y = 100 along z, from the eye (0, 0, 1): 512 * 100 / z <= 511 from z = 51200/511
  // on
  const auto seen = seen_of(room({}, {}), {0, 0, 1}, {100, 100, 0}, {100, 100, 400});
  ASSERT_EQ(seen.intervals().size(), 1U);
  EXPECT_EQ(seen.intervals()[0].low, Rational(51200 + 511, 511 * 400));
  EXPECT_EQ(seen.intervals()[0].high, Rational(1));
  // a line along z just off the axis: the near plane cuts it at z = 1 + 8
  const Rectangle shelf{1, -1, {Span{-1, 1}, Span{0, 100}}};
  const auto near = seen_of(room({}, {shelf}), {0, 0, 1}, {1, -1, 0}, {1, -1, 100});
  ASSERT_EQ(near.intervals().size(), 1U);
  EXPECT_EQ(near.intervals()[0].low, Rational(9, 100));
}

TEST(OnScreen, ProjectsInPoints) {
  const auto scene = room({}, {});
  const auto visible = visible_lines(scene, {0, 0, 0}, Window{}).value();
  bool found = false;
  for (const ScreenSegment& s : on_screen(visible, {0, 0, 0}, Window{})) {
    EXPECT_GE(std::min(s.x0, s.x1), 0);
    EXPECT_LE(std::max(s.y0, s.y1), 1023);
    found = found || (s.x0 == 384 && s.y0 == 640 && s.x1 == 640 && s.y1 == 640);  // 512 * 100/400 = 128
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace sightline::algorithms::oracle
