// A town of houses turned by all angles. See scene.hpp.
//
// Source: the town with which Willis measured splitting: 35 rectangles in a square of 100 by 100, sides 3 to
// 14, at least .25 apart, here in units of 1/200. The angles are those of Pythagorean triples and 45 degrees,
// so that corners are integers and rectangles exact.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/scene/generate/random.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"

namespace sightline::scene {
namespace {

using geometry::Int128;
using PlanPoint = std::array<std::int64_t, 2>;   // x, z
using PlanRectangle = std::array<PlanPoint, 4>;  // counterclockwise in (x, z)

constexpr std::int32_t unit = 200;

std::int64_t turn_at(const PlanPoint& a, const PlanPoint& b, const PlanPoint& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

std::int64_t along(const PlanPoint& a, const PlanPoint& b, const PlanPoint& p) {
  return (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1]);
}

// Whether p is at most `gap` away from the segment.
bool within(const PlanPoint& a, const PlanPoint& b, const PlanPoint& p, std::int64_t gap) {
  const auto near = [&](const PlanPoint& end) { return along(p, end, end) <= gap * gap; };
  const std::int64_t length_squared = along(a, b, b);
  const std::int64_t foot = along(a, b, p);
  if (foot <= 0) return near(a);
  if (foot >= length_squared) return near(b);
  const std::int64_t turn = turn_at(a, b, p);
  return Int128{turn} * turn <= Int128{gap * gap} * length_squared;
}

bool cross(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
  const auto apart = [](std::int64_t s, std::int64_t t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  return apart(turn_at(a, b, c), turn_at(a, b, d)) && apart(turn_at(c, d, a), turn_at(c, d, b));
}

bool contains(const PlanRectangle& r, const PlanPoint& p) {
  for (std::size_t i = 0; i < 4; ++i)
    if (turn_at(r[i], r[(i + 1) % 4], p) < 0) return false;
  return true;
}

bool boxes_near(const PlanRectangle& r, const PlanRectangle& s, std::int64_t gap) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto less = [axis](const PlanPoint& a, const PlanPoint& b) { return a[axis] < b[axis]; };
    const auto [r_low, r_high] = std::minmax_element(r.begin(), r.end(), less);
    const auto [s_low, s_high] = std::minmax_element(s.begin(), s.end(), less);
    if ((*r_low)[axis] > (*s_high)[axis] + gap || (*s_low)[axis] > (*r_high)[axis] + gap) return false;
  }
  return true;
}

bool too_near(const PlanRectangle& r, const PlanRectangle& s, std::int64_t gap) {
  if (!boxes_near(r, s, gap)) return false;
  if (contains(r, s[0]) || contains(s, r[0])) return true;
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanPoint& a = r[i];
    const PlanPoint& b = r[(i + 1) % 4];
    for (std::size_t j = 0; j < 4; ++j) {
      const PlanPoint& c = s[j];
      const PlanPoint& d = s[(j + 1) % 4];
      if (cross(a, b, c, d) || within(a, b, c, gap) || within(c, d, a, gap)) return true;
    }
  }
  return false;
}

PlanRectangle some_rectangle(SceneRandom& random, std::int32_t side) {
  constexpr std::array<std::array<std::int32_t, 2>, 8> turns{
      {{4, 3}, {3, 4}, {12, 5}, {5, 12}, {1, 0}, {15, 8}, {24, 7}, {1, 1}}};
  const auto& [c, s] = turns[static_cast<std::size_t>(random.mod(turns.size()))];
  const std::int32_t scale = c + s;
  const std::int64_t w = (3 + random.mod(11)) * unit / scale;
  const std::int64_t h = (3 + random.mod(11)) * unit / scale;
  const std::int64_t x = random.mod(static_cast<std::uint64_t>(side));
  const std::int64_t z = random.mod(static_cast<std::uint64_t>(side));
  return {{{x, z}, {x + w * c, z + w * s}, {x + w * c - h * s, z + w * s + h * c}, {x - h * s, z + h * c}}};
}

void add_prism(PolyBuilder& builder, std::string name, const PlanRectangle& ring, std::int32_t height) {
  const auto vertex = [&](std::size_t i, std::int32_t y) {
    const PlanPoint& p = ring[i % ring.size()];
    return builder.vertex({static_cast<std::int32_t>(p[0]), y, static_cast<std::int32_t>(p[1])});
  };
  PolyBody body{std::move(name), false, {}};
  PolyFace floor;
  PolyFace roof;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    floor.outline.push_back(vertex(i, 0));
    roof.outline.push_back(vertex(ring.size() - 1 - i, height));
    // x, y, z is right-handed, so counterclockwise in (x, z) is clockwise seen from above.
    body.faces.push_back({{vertex(i, 0), vertex(i, height), vertex(i + 1, height), vertex(i + 1, 0)}, {}});
  }
  body.faces.push_back(std::move(floor));
  body.faces.push_back(std::move(roof));
  builder.scene().bodies.push_back(std::move(body));
}

}  // namespace

PolyScene generate_prisms(std::size_t n, std::uint64_t seed, std::int32_t gap) {
  SceneRandom random(seed);
  std::int32_t blocks = 1;
  while (static_cast<std::size_t>(blocks) * static_cast<std::size_t>(blocks) * prisms_in_block < n) ++blocks;
  const std::int32_t side = prism_block * blocks;
  PolyBuilder builder;
  std::vector<PlanRectangle> placed;
  while (placed.size() < n) {
    const PlanRectangle r = some_rectangle(random, side);
    if (std::any_of(placed.begin(), placed.end(),
                    [&](const PlanRectangle& s) { return too_near(r, s, gap); }))
      continue;
    add_prism(builder, "prism " + std::to_string(placed.size()), r, 10 * unit);
    placed.push_back(r);
  }
  builder.scene().name = "prisms " + std::to_string(n) + " seed " + std::to_string(seed);
  builder.scene().camera = {true, {side / 2 - 27, 701, -4001}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return builder.take();
}

}  // namespace sightline::scene
