// The routines of Jones's program that clip lines and make masks, called one by one on the emulated PDP-7 and
// compared with the twin's functions, with the EAE and without. Source: SPECIFICATION.md section 3.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/programs/jones/twin/mask.hpp"
#include "tests/firmware/jones_routine.hpp"
#include "tests/support/dice.hpp"

namespace sightline::programs::jones {
namespace {

using End = RoutineMachine::End;
using Ring = std::vector<ScreenPoint>;

constexpr int rounds = 2000;

std::int64_t turn(ScreenPoint a, ScreenPoint b, ScreenPoint c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

// Convex hull, counter-clockwise, no three in a line (Andrew's monotone chain).
Ring hull(Ring points) {
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  Ring ring;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = ring.size();
    for (const ScreenPoint p : points) {
      while (ring.size() >= start + 2 && turn(ring[ring.size() - 2], ring.back(), p) <= 0) ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return ring;
}

class JonesClipRoutines : public testing::TestWithParam<bool> {
 protected:
  RoutineMachine machine{GetParam()};
  Dice dice{71};

  // A convex polygon of at most `corners` corners between the limits; some of its sides are axis-parallel.
  Ring polygon(std::size_t corners, std::int32_t low, std::int32_t high) {
    for (;;) {
      const std::int32_t xlo = dice(low, high - 1), xhi = dice(xlo + 1, high);
      const std::int32_t ylo = dice(low, high - 1), yhi = dice(ylo + 1, high);
      Ring points;
      if (dice(0, 3) == 0) {
        points = {{xlo, ylo}, {xhi, ylo}, {xhi, yhi}, {xlo, yhi}};
      } else {
        const int count = dice(3, static_cast<int>(3 * corners));
        for (int i = 0; i < count; ++i) {
          points.push_back({dice(0, 3) == 0 ? (dice(0, 1) ? xlo : xhi) : dice(xlo, xhi),
                            dice(0, 3) == 0 ? (dice(0, 1) ? ylo : yhi) : dice(ylo, yhi)});
        }
      }
      const Ring ring = points.size() < 3 ? points : hull(points);
      if (ring.size() >= 3 && ring.size() <= corners) return ring;
    }
  }

  static Mask mask_of_ring(const Ring& ring) {
    Mask mask;
    mask.count = static_cast<int>(ring.size());
    std::copy(ring.begin(), ring.end(), mask.vertices.begin());
    mask.xlo = mask.xhi = ring[0].x;
    mask.ylo = mask.yhi = ring[0].y;
    for (const ScreenPoint p : ring) {
      mask.xlo = std::min(mask.xlo, p.x);
      mask.xhi = std::max(mask.xhi, p.x);
      mask.ylo = std::min(mask.ylo, p.y);
      mask.yhi = std::max(mask.yhi, p.y);
    }
    return mask;
  }

  // Deposits the current polygon and its box.
  void put_polygon(const Ring& ring) {
    machine.set("pcur", static_cast<std::int32_t>(machine.at("poly")) - 1);
    machine.set("palt", static_cast<std::int32_t>(machine.at("polq")) - 1);
    machine.set("pn", static_cast<std::int32_t>(ring.size()));
    pdp7::Address at = machine.at("poly");
    for (const ScreenPoint p : ring) {
      machine.set(at++, p.x);
      machine.set(at++, p.y);
    }
    const Mask box = mask_of_ring(ring);
    machine.set("bxlo", box.xlo);
    machine.set("bxhi", box.xhi);
    machine.set("bylo", box.ylo);
    machine.set("byhi", box.yhi);
  }
  Mask put_mask(const Ring& ring) {
    put_polygon(ring);
    EXPECT_EQ(machine.call("newmsk"), End::returned);
    const Mask mask = mask_of_ring(ring);
    EXPECT_EQ(machine.cell("nslope"), -sloped_edges(mask));
    return mask;
  }
  void put_line(const ScreenSegment& line) {
    machine.set("lax", line.a.x);
    machine.set("lay", line.a.y);
    machine.set("lbx", line.b.x);
    machine.set("lby", line.b.y);
  }
  // Deposits the current sloped edge.
  void put_edge(ScreenPoint a, ScreenPoint b) {
    machine.set("neax", -a.x);
    machine.set("neay", -a.y);
    machine.set("edx", b.x - a.x);
    machine.set("edy", b.y - a.y);
    machine.set("nedy", a.y - b.y);
  }
  ScreenPoint any_point(std::int32_t far) { return {dice(-far, far), dice(-far, far)}; }

  void expect_clip(const Mask& mask, const ScreenSegment& line) {
    put_line(line);
    const End end = machine.call("clip2");
    Operations operations;
    const auto expected = clip2(mask, line, operations);
    ASSERT_EQ(end, expected ? End::piece : End::returned)
        << line.a.x << ',' << line.a.y << ' ' << line.b.x << ',' << line.b.y;
    if (!expected) return;
    const ScreenSegment left{{machine.cell("lax"), machine.cell("lay")},
                             {machine.cell("lbx"), machine.cell("lby")}};
    ASSERT_EQ(left, *expected) << line.a.x << ',' << line.a.y << ' ' << line.b.x << ',' << line.b.y;
  }

  // Does with a ring what tape 2 does: intersects, makes the result the mask, and rejects one without area.
  Intersection intersect_on_machine(Ring ring, bool clockwise) {
    if (clockwise) std::reverse(ring.begin(), ring.end());
    put_polygon(ring);
    machine.set("revers", clockwise ? 1 : 0);
    machine.set("rectf", 0);
    End end = machine.call("isect");
    if (end == End::fault) {
      EXPECT_EQ(machine.ac(), static_cast<std::int32_t>(Status::too_many_mask_vertices));
      return {MaskOutcome::too_many_vertices, {}};
    }
    EXPECT_EQ(end, End::returned);
    if (machine.ac() == 0) return {};
    EXPECT_EQ(machine.call("newmsk"), End::returned);
    if (machine.cell("nslope") != 0) {
      EXPECT_EQ(machine.call("area2"), End::returned);
      if (machine.ac() == 0) return {};
    }
    Intersection made{MaskOutcome::visible, {}};
    made.mask.count = machine.cell("pn");
    auto at = static_cast<pdp7::Address>(machine.cell("pcur")) + 1;
    for (int i = 0; i < made.mask.count; ++i, at += 2) {
      made.mask.vertices.at(static_cast<std::size_t>(i)) = {machine.word(at).twos_complement(),
                                                            machine.word(at + 1).twos_complement()};
    }
    made.mask.xlo = -machine.cell("nxlo");
    made.mask.xhi = machine.cell("xhi1") - 1;
    made.mask.ylo = -machine.cell("nylo");
    made.mask.yhi = machine.cell("yhi1") - 1;
    return made;
  }

  // Skips boxes that do not overlap: the search rejects them earlier.
  MaskOutcome expect_intersection(const Ring& around, const Ring& ring, bool clockwise) {
    Operations operations;
    const Mask mask = put_mask(around), whole = mask_of_ring(ring);
    const Intersection expected = intersect(mask, ring, operations);
    if (whole.xhi <= mask.xlo || whole.xlo >= mask.xhi || whole.yhi <= mask.ylo || whole.ylo >= mask.yhi)
      return expected.outcome;
    const Intersection made = intersect_on_machine(ring, clockwise);
    EXPECT_EQ(static_cast<int>(made.outcome), static_cast<int>(expected.outcome));
    expect_same(made.mask, expected.mask);
    return expected.outcome;
  }
  static void expect_same(const Mask& made, const Mask& expected) {
    ASSERT_EQ(made.count, expected.count);
    ASSERT_TRUE(std::equal(made.ring().begin(), made.ring().end(), expected.ring().begin()));
    ASSERT_EQ(made.xlo, expected.xlo);
    ASSERT_EQ(made.xhi, expected.xhi);
    ASSERT_EQ(made.ylo, expected.ylo);
    ASSERT_EQ(made.yhi, expected.yhi);
  }
};

TEST_P(JonesClipRoutines, LinesAreClippedToMasks) {
  machine.halt_at_piece();
  for (int i = 0; i < rounds / 20; ++i) {
    const Ring ring = i == 0 ? Ring{{-1024, -1024}, {1022, -1024}, {1022, 1022}, {-1024, 1022}}
                             : polygon(i % 2 == 0 ? 5 : 16, -1024, 1022);
    const Mask mask = put_mask(ring);
    for (int k = 0; k < 20; ++k) {
      const std::int32_t far = k % 3 == 0 ? 65535 : k % 3 == 1 ? 2000 : 600;
      ScreenSegment line{any_point(far), any_point(far)};
      if (k % 5 == 1) line.b.x = line.a.x;
      if (k % 5 == 2) line.b.y = line.a.y;
      if (k % 10 == 3) line.a = ring[0];
      if (k % 10 == 8) line = {ring[0], ring[1]};
      expect_clip(mask, line);
    }
    // Along the sides of the box, just inside and just outside.
    for (const std::int32_t off : {-1, 0, 1}) {
      expect_clip(mask, {{mask.xlo + off, -3000}, {mask.xlo + off, 3000}});
      expect_clip(mask, {{mask.xhi + off, 3000}, {mask.xhi + off, -3000}});
      expect_clip(mask, {{-3000, mask.ylo + off}, {3000, mask.ylo + off}});
      expect_clip(mask, {{3000, mask.yhi + off}, {-3000, mask.yhi + off}});
    }
  }
}

TEST_P(JonesClipRoutines, CrossingAtARatio) {
  for (int i = 0; i < rounds; ++i) {
    const ScreenSegment line{any_point(65535), any_point(i % 2 == 0 ? 65535 : 1000)};
    const std::int32_t den = i % 3 == 0 ? dice(1, 9) : dice(1, 131071);
    const std::int32_t num = i % 5 == 0 ? 0 : i % 5 == 1 ? den : dice(0, den);
    put_line(line);
    machine.set("mdm", num);
    machine.set("mdd", den);
    ASSERT_EQ(machine.call("cross"), End::returned);
    const auto between = [&](std::int32_t from, std::int32_t to) {
      const std::int64_t step = (std::int64_t{std::abs(to - from)} * num + den / 2) / den;
      return from + (to < from ? -step : step);
    };
    ASSERT_EQ(machine.cell("crx"), between(line.a.x, line.b.x));
    ASSERT_EQ(machine.cell("cry"), between(line.a.y, line.b.y));
  }
}

TEST_P(JonesClipRoutines, SideOfASlopedEdge) {
  int on_edge = 0;
  for (int i = 0; i < 2 * rounds; ++i) {
    const std::int32_t far = i % 3 == 0 ? 1000 : 8;
    const ScreenPoint a = any_point(far), b = any_point(far), p = any_point(far);
    if (!is_sloped(a, b)) continue;
    put_edge(a, b);
    machine.set("spx", p.x);
    machine.set("spy", p.y);
    const std::int64_t distance = turn(a, b, p);
    on_edge += distance == 0;
    ASSERT_EQ(machine.call("side2"), End::returned);
    ASSERT_EQ(machine.ac() < 0, distance < 0) << distance;
  }
  EXPECT_GT(on_edge, 10);
}

// The ratio of the distances of A and B, with as many bits as fit; without the EAE products have seven bits more.
TEST_P(JonesClipRoutines, RatioOfDistancesFromASlopedEdge) {
  for (int i = 0; i < rounds; ++i) {
    const std::int32_t far = i % 3 == 0 ? 1000 : i % 3 == 1 ? 100 : 8;
    const ScreenPoint a = any_point(far), b = any_point(far);
    const ScreenSegment line{any_point(far), any_point(far)};
    std::int64_t num = std::abs(turn(a, b, line.a)) * machine.product_unit();
    std::int64_t den = num + std::abs(turn(a, b, line.b)) * machine.product_unit();
    if (!is_sloped(a, b) || den == 0) continue;
    for (; den >= 1 << 17; den >>= 1) num >>= 1;
    put_edge(a, b);
    put_line(line);
    ASSERT_EQ(machine.call("both2"), End::returned);
    ASSERT_EQ(machine.cell("mdm"), num);
    ASSERT_EQ(machine.cell("mdd"), den);
  }
}

TEST_P(JonesClipRoutines, OpeningsIntersectMasks) {
  int visible = 0, empty = 0;
  for (int i = 0; i < rounds; ++i) {
    const Ring around = polygon(i % 4 == 0 ? 14 : 6, i % 3 == 0 ? -60 : -1024, i % 3 == 0 ? 60 : 1022);
    const Ring ring = polygon(i % 5 == 0 ? 16 : 5, i % 2 == 0 ? -32768 : -900, i % 2 == 0 ? 32767 : 900);
    SCOPED_TRACE(i);
    const MaskOutcome outcome = expect_intersection(around, ring, i % 7 == 3);
    visible += outcome == MaskOutcome::visible;
    empty += outcome == MaskOutcome::empty;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(visible, 100);
  EXPECT_GT(empty, 100);
}

// A sixteen-sided opening with corners cut off by the mask.
TEST_P(JonesClipRoutines, TooManyVertices) {
  int too_many = 0, enough = 0;
  for (int i = 0; i < 200; ++i) {
    constexpr int corners = 16;
    const double radius = dice(300, 1000), start = 0.001 * dice(0, 400);
    Ring ring;
    for (int k = 0; k < corners; ++k) {
      const double angle = start + 2 * 3.14159265358979 * k / corners;
      ring.push_back({static_cast<std::int32_t>(radius * std::cos(angle)),
                      static_cast<std::int32_t>(radius * std::sin(angle))});
    }
    const auto side = [&] { return static_cast<std::int32_t>(radius * 0.001 * dice(950, 1010)); };
    const std::int32_t left = -side(), right = side(), low = -side(), high = side();
    SCOPED_TRACE(i);
    const auto outcome =
        expect_intersection({{left, low}, {right, low}, {right, high}, {left, high}}, ring, i % 2 == 1);
    too_many += outcome == MaskOutcome::too_many_vertices;
    enough += outcome == MaskOutcome::visible;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(too_many, 20);
  EXPECT_GT(enough, 20);
}

INSTANTIATE_TEST_SUITE_P(Eae, JonesClipRoutines, testing::Bool(),
                         [](const auto& eae) { return std::string(eae.param ? "WithEae" : "WithoutEae"); });

}  // namespace
}  // namespace sightline::programs::jones
