// Sections by laws: the parts on both sides of a plane have the volume of the whole, both cut surfaces have the same area, and a solid
// stays closed. The volumes and areas are sums over faces that share nothing with the code under test.
#include "host/scene/read/section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/file_units.hpp"
#include "tests/support/dice.hpp"

namespace sightline::scene {
namespace {

LoadedScene loaded(const std::string& name) {
  auto file = named_scene(name);
  EXPECT_TRUE(file && *file) << name;
  auto scene = load_scene(std::move(**file));
  EXPECT_TRUE(scene) << scene.error().message();
  return std::move(*scene);
}

LoadedScene loaded_off(const std::string& text) {
  PolyImportOptions options;
  options.mend = true;
  auto scene = load_scene({.name = "test.off", .text = text}, options);
  EXPECT_TRUE(scene) << scene.error().message();
  return std::move(*scene);
}

// Six times the volume that a ring and the origin span, or twice the area of the ring along an axis; holes turn the other way and subtract.
template <class Measure>
double sum_over_rings(const PolyScene& scene, const Measure& measure, std::optional<std::uint32_t> material = {}) {
  double sum = 0;
  std::size_t number = 0;
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      const std::size_t n = number++;
      if (material && (scene.material_of.empty() || scene.material_of[n] < *material)) continue;
      std::vector<Ring> rings = face.holes;
      rings.push_back(face.outline);
      for (const auto& ring : rings)
        for (std::size_t i = 2; i < ring.size(); ++i)
          sum += measure(file_point(scene, scene.vertices[ring[0]]), file_point(scene, scene.vertices[ring[i - 1]]),
                         file_point(scene, scene.vertices[ring[i]]));
    }
  }
  return sum;
}

using Point3 = std::array<double, 3>;

double volume(const PolyScene& scene) {
  return sum_over_rings(scene, [](const Point3& a, const Point3& b, const Point3& c) {
           return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
         }) / 6;
}

double cut_area(const Section& section, std::size_t axis) {
  return sum_over_rings(
             section.loaded.scene,
             [axis](const Point3& a, const Point3& b, const Point3& c) {
               const std::size_t u = (axis + 1) % 3;
               const std::size_t v = (axis + 2) % 3;
               return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
             },
             section.cut_material) / 2;
}

void expect_closed(const PolyScene& scene, const std::string& what) {
  EXPECT_TRUE(check_poly_scene(scene).empty()) << what << ": " << check_poly_scene(scene).front().message();
  for (const PolyBody& body : scene.bodies) EXPECT_FALSE(body.sheet) << what;
}

int planes_that_cut = 0;

// Both parts of a scene of solids.
void expect_laws(const LoadedScene& source, std::size_t axis, double at) {
  const std::string what = source.name + " at " + std::string(1, static_cast<char>('x' + axis)) + " = " + std::to_string(at);
  const SectionPlane below{axis, at, false};
  const SectionPlane above{axis, at, true};
  const auto low = section_of(source, {&below, 1});
  const auto high = section_of(source, {&above, 1});
  ASSERT_TRUE(low) << what << low.error().message();
  ASSERT_TRUE(high) << what << high.error().message();
  expect_closed(low->loaded.scene, what);
  expect_closed(high->loaded.scene, what);
  const PolyBounds bounds = bounds_of(source.scene);
  const double size = 2 * static_cast<double>(bounds.half_size()) * source.scene.step;
  const double rounding = 1e-4 * size;  // a vertex is moved by at most 2^-17 of the size
  const double whole = volume(source.scene);
  EXPECT_NEAR(volume(low->loaded.scene) + volume(high->loaded.scene), whole, rounding * size * size) << what;
  const double cut_low = cut_area(*low, axis);
  const double cut_high = cut_area(*high, axis);
  // Seen from above, the lower part's cut turns counterclockwise. A plane between bodies cuts none.
  EXPECT_GE(cut_low, 0) << what;
  EXPECT_LE(cut_high, 0) << what;
  if (cut_low > 0) ++planes_that_cut;
  EXPECT_NEAR(cut_low, -cut_high, rounding * size) << what;
}

TEST(Section, OfABoxBetweenGridPointsIsTheBoxUpToThere) {
  const LoadedScene box = loaded_off("OFF\n8 6 0\n0 0 0\n10 0 0\n10 6 0\n0 6 0\n0 0 4\n10 0 4\n10 6 4\n0 6 4\n"
                                     "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const SectionPlane plane{0, 2.5, false};
  const auto section = section_of(box, {&plane, 1});
  ASSERT_TRUE(section) << section.error().message();
  const PolyScene& scene = section->loaded.scene;
  const PolyBounds bounds = bounds_of(scene);
  EXPECT_EQ(file_point(scene, bounds.low), (Point3{0, 0, 0}));
  EXPECT_EQ(file_point(scene, bounds.high), (Point3{2.5, 6, 4}));
  EXPECT_EQ(face_count(scene), 6U);
  EXPECT_DOUBLE_EQ(cut_area(*section, 0), 24);
  expect_laws(box, 0, 2.5);
}

TEST(Section, AFaceInThePlaneIsReplacedByTheCut) {
  const LoadedScene box = loaded("boxes-1");
  const PolyBounds bounds = bounds_of(box.scene);
  const Point3 high = file_point(box.scene, bounds.high);
  const SectionPlane keep{1, high[1], false};
  const auto whole = section_of(box, {&keep, 1});
  ASSERT_TRUE(whole) << whole.error().message();
  EXPECT_DOUBLE_EQ(volume(whole->loaded.scene), volume(box.scene));
  EXPECT_GT(cut_area(*whole, 1), 0);
  const SectionPlane leave{1, high[1], true};
  EXPECT_FALSE(section_of(box, {&leave, 1}));
}

TEST(Section, SolidsKeepTheirVolumeAndStayClosed) {
  programs::jones::Dice dice{7};
  planes_that_cut = 0;
  for (const char* name : {"boxes-30", "prisms-20", "roberts"}) {
    LoadedScene source = loaded(name);
    // Panels of scenes of cells have no inside.
    std::erase_if(source.scene.bodies, [](const PolyBody& body) { return body.sheet; });
    ASSERT_FALSE(source.scene.bodies.empty()) << name;
    const PolyBounds bounds = bounds_of(source.scene);
    const Point3 low = file_point(source.scene, bounds.low);
    const Point3 high = file_point(source.scene, bounds.high);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int part = 0; part < 6; ++part)
        expect_laws(source, axis, low[axis] + (high[axis] - low[axis]) * static_cast<double>(dice(100, 900)) / 1000);
  }
  EXPECT_GT(planes_that_cut, 30);
}

// A tube, whose cut along the axis has two outlines, and across it one with a hole; vertices lie in most of the planes.
TEST(Section, AcrossATubeTheCutHasAHole) {
  std::string text = "OFF\n64 64 0\n";
  constexpr int sides = 16;
  for (const double radius : {10.0, 6.0}) {
    for (const double z : {0.0, 8.0}) {
      for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979 * i / sides;
        text += std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + " " + std::to_string(z) + "\n";
      }
    }
  }
  const auto at = [](int circle, int i) { return std::to_string(circle * sides + i % sides); };
  for (int i = 0; i < sides; ++i) {
    text += "4 " + at(0, i) + " " + at(0, i + 1) + " " + at(1, i + 1) + " " + at(1, i) + "\n";
    text += "4 " + at(2, i + 1) + " " + at(2, i) + " " + at(3, i) + " " + at(3, i + 1) + "\n";
    text += "4 " + at(1, i) + " " + at(1, i + 1) + " " + at(3, i + 1) + " " + at(3, i) + "\n";
    text += "4 " + at(0, i + 1) + " " + at(0, i) + " " + at(2, i) + " " + at(2, i + 1) + "\n";
  }
  const LoadedScene tube = loaded_off(text);
  for (const double z : {0.5, 4.0, 7.9}) expect_laws(tube, 2, z);
  for (const double x : {0.0, 1.0, 8.5, -3.0}) expect_laws(tube, 0, x);
  const SectionPlane across{2, 4, false};
  const auto section = section_of(tube, {&across, 1});
  ASSERT_TRUE(section);
  // A regular polygon of 16 sides has the area 8 r r sin(22.5 degrees).
  EXPECT_NEAR(cut_area(*section, 2), 8 * (100 - 36) * std::sin(3.14159265358979 / 8), 0.01);
}

// Solids whose cut touches itself at a vertex: a height field of whole numbers, cut at one of its heights.
TEST(Section, CutsThatTouchThemselvesKeepTheirArea) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    programs::jones::Dice dice{seed};
    constexpr int side = 7;
    std::string text = "OFF\n" + std::to_string(2 * side * side) + " " + std::to_string(4 * (side - 1) * (side - 1) + 8 * (side - 1)) + " 0\n";
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(dice(2, 6)) + "\n";
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) text += std::to_string(x) + " " + std::to_string(y) + " 0\n";
    const auto add = [&](int a, int b, int c) { text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n"; };
    const auto top = [](int x, int y) { return y * side + x; };
    const auto bottom = [](int x, int y) { return side * side + y * side + x; };
    for (int y = 0; y + 1 < side; ++y) {
      for (int x = 0; x + 1 < side; ++x) {
        add(top(x, y), top(x + 1, y), top(x + 1, y + 1));
        add(top(x, y), top(x + 1, y + 1), top(x, y + 1));
        add(bottom(x, y), bottom(x + 1, y + 1), bottom(x + 1, y));
        add(bottom(x, y), bottom(x, y + 1), bottom(x + 1, y + 1));
      }
    }
    const auto wall = [&](int x0, int y0, int x1, int y1) {
      add(bottom(x0, y0), bottom(x1, y1), top(x1, y1));
      add(bottom(x0, y0), top(x1, y1), top(x0, y0));
    };
    for (int i = 0; i + 1 < side; ++i) {
      wall(i, 0, i + 1, 0);
      wall(side - 1, i, side - 1, i + 1);
      wall(side - i - 1, side - 1, side - i - 2, side - 1);
      wall(0, side - i - 1, 0, side - i - 2);
    }
    const LoadedScene field = loaded_off(text);
    for (const double z : {3.0, 4.0, 5.0, 4.5}) {
      const SectionPlane below{2, z, false};
      const SectionPlane above{2, z, true};
      const auto low = section_of(field, {&below, 1});
      const auto high = section_of(field, {&above, 1});
      ASSERT_TRUE(low && high) << seed << ": " << (low ? high : low).error().message();
      EXPECT_TRUE(low->notes.empty() && high->notes.empty()) << seed;
      EXPECT_NEAR(volume(low->loaded.scene) + volume(high->loaded.scene), volume(field.scene), 0.01) << seed << ", " << z;
      // A plateau in the plane belongs to the cut of the lower part alone.
      if (z == 4.5) {
        EXPECT_NEAR(cut_area(*low, 2), -cut_area(*high, 2), 0.01) << seed << ", " << z;
      }
    }
  }
}

TEST(Section, PlanesAreTakenOneAfterTheOther) {
  const LoadedScene source = loaded("boxes-30");
  const Point3 middle = file_point(source.scene, bounds_of(source.scene).middle());
  const std::array planes{SectionPlane{0, middle[0] + 0.25, true}, SectionPlane{2, middle[2] + 0.25, false}};
  const auto both = section_of(source, planes);
  ASSERT_TRUE(both) << both.error().message();
  const auto first = section_of(source, {&planes[0], 1});
  ASSERT_TRUE(first);
  const auto second = section_of(first->loaded, {&planes[1], 1});
  ASSERT_TRUE(second);
  EXPECT_NEAR(volume(both->loaded.scene), volume(second->loaded.scene), 1e-3 * volume(source.scene));
  expect_closed(both->loaded.scene, "both");
}

TEST(Section, NothingBehindThePlaneIsAnError) {
  const LoadedScene source = loaded("boxes-5");
  const SectionPlane plane{0, 1e9, true};
  const auto section = section_of(source, {&plane, 1});
  ASSERT_FALSE(section);
  EXPECT_EQ(section.error().kind, base::ErrorKind::bad_input);
}

}  // namespace
}  // namespace sightline::scene
