// Stripes of one thickness: both ways to make a raster agree, and both converge to the exact picture as stripes become thinner.
#include "host/algorithms/montani_re/stripes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/montani_re/plane_faces.hpp"

namespace sightline::algorithms::montani_re {
namespace {

constexpr std::array<std::int32_t, 6> thicknesses{2, 4, 8, 16, 32, 64};  // 8 to 1/4 pixels

FaceSet set_of(const scene::PolyScene& scene) {
  return *faces_of(scene, scene.camera);
}

StripeFrame frame_of(const FaceSet& set, std::int32_t size) {
  std::array<double, 2> low{1e300, 1e300};
  std::array<double, 2> high{-1e300, -1e300};
  for (const Face& face : set.faces) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], face.low[axis].approximate);
      high[axis] = std::max(high[axis], face.high[axis].approximate);
    }
  }
  StripeFrame frame;
  frame.width = frame.height = size;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    frame.scale[axis] = (size - 8) / (high[axis] - low[axis]);
    frame.centre[axis] = 4 - low[axis] * frame.scale[axis] + 0.137;
  }
  return frame;
}

// The nearest face at a point of the image, by its polygons and planes in floating point.
std::uint32_t nearest_at(const FaceSet& set, double x, double y) {
  std::uint32_t nearest = none;
  double best = -std::numeric_limits<double>::infinity();
  for (std::uint32_t f = 0; f < set.faces.size(); ++f) {
    const Face& face = set.faces[f];
    bool inside = false;
    for (const std::uint32_t line : face.lines) {
      const ImageLine& l = set.image.lines()[line];
      const double from = set.image.ordinate_of(l.from).middle();
      const double to = set.image.ordinate_of(l.to).middle();
      if ((from > y) != (to > y) && set.image.abscissa(line, y) <= x) inside = !inside;
    }
    if (!inside) continue;
    const auto part = [&face](std::size_t k) { return static_cast<double>(face.normal[k]); };
    const double offset = static_cast<double>(face.offset);
    const double nearness = set.image.perspective() ? (part(0) * x + part(1) * y + part(2)) / offset
                                                    : (part(0) * x + part(1) * y - offset) / part(2);
    if (nearness > best) {
      best = nearness;
      nearest = f;
    }
  }
  return nearest;
}

double mismatch(const FaceSet& set, const StripeRaster& raster, const StripeFrame& frame) {
  int wrong = 0;
  for (std::int32_t row = 0; row < raster.height; ++row) {
    for (std::int32_t column = 0; column < raster.width; ++column) {
      const std::uint32_t truth = nearest_at(set, (column + 0.5 - frame.centre[0]) / frame.scale[0],
                                             (row + 0.5 - frame.centre[1]) / frame.scale[1]);
      if (raster.faces[static_cast<std::size_t>(row * raster.width + column)] != truth) ++wrong;
    }
  }
  return wrong / double(raster.width * raster.height);
}

// Paints back to front, each face over the earlier ones. A pixel is lit by its centre; on a west side it belongs to the face east
// of it.
std::vector<std::uint32_t> faces_by_overwriting(const FaceSet& set, const ListedFaces& seen, const StripeFrame& frame,
                                                std::int32_t units) {
  constexpr std::int64_t pixel = 16 * 65536;
  std::vector<std::uint32_t> faces(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), none);
  const auto paint = [&](std::uint32_t face) {
    const StripePcs pcs = stripe_pcs(set.image, seen.faces[face], frame, units);
    for (std::int32_t row = 0; row < frame.height; ++row) {
      const std::int32_t height = row * units + units / 2;  // of the centres, in sixteenths of a stripe
      const std::int32_t stripe = height / 16 - pcs.first;
      if (stripe < 0 || stripe >= static_cast<std::int32_t>(pcs.stripes.size())) continue;
      for (const StripeBand& band : pcs.stripes[static_cast<std::size_t>(stripe)]) {
        if (height % 16 < band.low || band.high <= height % 16) continue;
        for (std::int32_t column = 0; column < frame.width; ++column) {
          std::size_t sides = 0;
          for (const StripeSide& side : band.sides) sides += side.at(height % 16) <= column * pixel + pixel / 2 ? 1 : 0;
          if (sides % 2 == 1) faces[static_cast<std::size_t>(row * frame.width + column)] = face;
        }
      }
    }
  };
  const auto classes = seen.list.classes();
  for (auto members = classes.rbegin(); members != classes.rend(); ++members)
    for (auto face = members->rbegin(); face != members->rend(); ++face) paint(*face);
  return faces;
}

TEST(MontaniReStripes, DifferenceAndOverwritingAreTheSame) {
  for (const scene::PolyScene& scene : {scene::generate_boxes(20), scene::generate_town(9),
                                        scene::generate_triangles(40), scene::generate_bricks(10)}) {
    const FaceSet set = set_of(scene);
    const ListedFaces seen = listed_faces(set);
    const StripeFrame frame = frame_of(set, 150);
    for (const std::int32_t units : thicknesses) {
      const StripeRaster one = raster_by_difference(set.image, seen.list, seen.faces, frame, units);
      EXPECT_TRUE(one.faces == faces_by_overwriting(set, seen, frame, units)) << scene.name << ' ' << units;
    }
  }
}

TEST(MontaniReStripes, ThinnerStripesHaveSmallerErrors) {
  const FaceSet set = set_of(scene::generate_boxes(12));
  const ListedFaces seen = listed_faces(set);
  const StripeFrame frame = frame_of(set, 128);
  double before = 1;
  double first = 0;
  for (const std::int32_t units : thicknesses) {
    const double wrong =
        mismatch(set, raster_by_difference(set.image, seen.list, seen.faces, frame, units), frame);
    EXPECT_LT(wrong, before) << units;
    before = wrong;
    if (units == 2) first = wrong;
    RecordProperty("share_" + std::to_string(units), std::to_string(wrong));
  }
  // h is 32 times smaller; so would the error be if it were not counted in whole pixels.
  EXPECT_LT(before, first / 16);
}

// M10: where all corners lie on lines between stripes, thick stripes are exact.
TEST(MontaniReStripes, CornersOnLinesBetweenStripesAreExact) {
  const FaceSet set = face_set({{{{0, 0, 0}, {24, 16, 0}, {8, 32, 0}}},
                                rectangle(4, 8, 30, 24, 5),
                                {{{2, 0, 9}, {20, 0, 9}, {31, 32, 9}, {0, 32, 9}}}});
  const ListedFaces seen = listed_faces(set);
  const StripeFrame frame{{1, 1}, {0, 0}, 32, 32};
  for (const std::int32_t units : thicknesses) {
    EXPECT_EQ(mismatch(set, raster_by_difference(set.image, seen.list, seen.faces, frame, units), frame), 0)
        << units;
  }
}

// A cycle and faces that hide each other are resolved in stripes, too.
TEST(MontaniReStripes, CyclesAreCutInStripes) {
  const PlaneFace portal{
      {{0, 0, 0}, {8, 0, 0}, {8, 32, 0}, {24, 32, 0}, {24, 0, 0}, {32, 0, 0}, {32, 40, 0}, {0, 40, 0}}};
  const PlaneFace bar{{{-4, 8, -20}, {36, 8, 20}, {36, 24, 20}, {-4, 24, -20}}};
  const FaceSet set = face_set({portal, bar});
  const ListedFaces seen = listed_faces(set);
  const StripeFrame frame{{1, 1}, {8, 0}, 48, 48};
  EXPECT_EQ(mismatch(set, raster_by_difference(set.image, seen.list, seen.faces, frame, 16), frame), 0);
}

TEST(MontaniReStripes, SidesGrowAsStripesBecomeThinner) {
  const FaceSet set = set_of(scene::generate_boxes(20));
  const ListedFaces seen = listed_faces(set);
  const StripeFrame frame = frame_of(set, 256);
  const auto sides = [&](std::int32_t units) {
    return static_cast<double>(raster_by_difference(set.image, seen.list, seen.faces, frame, units).sides);
  };
  EXPECT_NEAR(sides(32) / sides(16), 2, 0.25);
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
