// Montani and Re's filled faces, by stripes of one thickness and as outlines with holes, compared with the face that the exact
// sight
// line of every pixel meets first.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::registry {
namespace {

constexpr int size = 120;  // pixels per side, a field of view of 90 degrees
constexpr FaceWindow window{size, size, size / 2.0, size / 2.0, size / 2.0};

struct Setting {
  std::string family;
  std::size_t size = 0;
  scene::PolyPoint eye;
  scene::PolyPoint forward{0, 0, 1};
  scene::PolyPoint right{1, 0, 0};
  scene::PolyPoint up{0, 1, 0};
};
// In all but the first setting the eye is among the faces.
const std::vector<Setting> settings{{"boxes", 30, {211, 345, -700}},
                                    {"boxes", 60, {1103, 977, 1011}},
                                    {"rooms", 4, {481, 233, 307}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                    {"corridors", 4, {107, 53, 211}},
                                    {"triangles", 40, {501, 479, 513}}};

scene::PolyScene scene_of(const Setting& setting) {
  auto scene = *scene::generate_scene(setting.family, setting.size, 5);
  scene.camera = {true, setting.eye, setting.forward, setting.right, setting.up};
  return scene;
}

picture::PixelGrid nearest_faces(const scene::PolyScene& scene) {
  return algorithms::oracle::nearest_faces(scene, {scene.camera, size, size});
}

// Edges in front of the eye, in pixels whose middles are at integers.
std::vector<picture::PixelSegment> edges_of(const scene::PolyScene& scene) {
  std::vector<picture::PixelSegment> segments;
  for (const picture::LineEdge& edge : picture::edges_of(scene)) {
    std::array<std::array<double, 3>, 2> ends{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::array axes{scene.camera.right, scene.camera.up, scene.camera.forward};
      for (std::size_t k = 0; k < 3; ++k) {
        ends[0][k] += axes[k][a] * (scene.vertices[edge.from][a] - scene.camera.eye[a]);
        ends[1][k] += axes[k][a] * (scene.vertices[edge.to][a] - scene.camera.eye[a]);
      }
    }
    constexpr double near = 1.0 / 16;
    if (ends[0][2] < near && ends[1][2] < near) continue;
    const double s = (near - ends[0][2]) / (ends[1][2] - ends[0][2]);
    const std::size_t behind = ends[0][2] < near ? 0 : 1;
    if (ends[behind][2] < near)
      for (std::size_t a = 0; a < 3; ++a) ends[behind][a] = ends[0][a] + s * (ends[1][a] - ends[0][a]);
    const auto place = [](const std::array<double, 3>& p) {
      return picture::PixelPoint{size / 2.0 * (p[0] / p[2] + 1) - 0.5, size / 2.0 * (p[1] / p[2] + 1) - 0.5};
    };
    segments.push_back({place(ends[0]), place(ends[1])});
  }
  return segments;
}

PreparedFaces prepare_faces(const scene::PolyScene& scene, double stripe) {
  FaceOptions options;
  options.stripe = stripe;
  return *find_face_algorithm("montani-re")->prepare(scene, options);
}

// Corners move by half a stripe at most, so pixels farther from all edges are correct. At edges, stripes of one pixel are better
// than
// thinner ones: their lines run between the middles of pixels, so that an edge along them moves across none.
TEST(MontaniReFaces, StripesOfAPixelAreRightInsideFaces) {
  for (const Setting& setting : settings) {
    const scene::PolyScene scene = scene_of(setting);
    ASSERT_FALSE(scene::eye_error(scene, scene.camera)) << setting.family;
    const picture::PixelGrid truth = nearest_faces(scene);
    const auto edges = edges_of(scene);
    const auto different = [&](double stripe) {
      const auto seen = prepare_faces(scene, stripe).view(scene.camera, window);
      const auto metrics = picture::pixel_metrics(truth, seen->faces, edges);
      if (stripe <= 1) {
        EXPECT_EQ(metrics.different_inside, 0U) << setting.family << ' ' << stripe;
      }
      return metrics.different();
    };
    const std::uint64_t thick = different(8);
    EXPECT_GT(thick, size * size / 100U) << setting.family;
    for (const double stripe : {1.0, 0.5, 0.25})
      EXPECT_LT(different(stripe), thick / 2) << setting.family << " " << stripe;
  }
}

std::vector<double> crossings(const FaceRegion& region, double y) {
  std::vector<double> at;
  for (const auto& loop : region.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const picture::PixelPoint& p = loop[i];
      const picture::PixelPoint& q = loop[i + 1 == loop.size() ? 0 : i + 1];
      if ((p.y > y) != (q.y > y)) at.push_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

TEST(MontaniReFaces, OutlinesContainThePixelsOfTheirFaces) {
  for (const Setting& setting : settings) {
    const scene::PolyScene scene = scene_of(setting);
    const auto seen = prepare_faces(scene, 1).regions(scene.camera, window);
    picture::PixelGrid filled(size, size);
    for (const FaceRegion& region : seen->regions) {
      for (int row = 0; row < size; ++row) {
        const std::vector<double> at = crossings(region, row + 0.5);
        ASSERT_EQ(at.size() % 2, 0U);
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
          for (int column = std::max(0, static_cast<int>(std::ceil(at[k] - 0.5)));
               column < std::min<double>(size, std::ceil(at[k + 1] - 0.5)); ++column) {
            EXPECT_EQ(filled.at(column, row), 0U);
            filled.set(column, row, region.face);
          }
        }
      }
    }
    const picture::PixelGrid truth = nearest_faces(scene);
    int different = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) different += truth.values[i] != filled.values[i];
    EXPECT_EQ(different, 0) << setting.family;
  }
}

TEST(MontaniReFaces, RejectOtherThicknesses) {
  const scene::PolyScene scene = scene::generate_boxes(2);
  FaceOptions options;
  options.stripe = 3;
  EXPECT_FALSE(find_face_algorithm("montani-re")->prepare(scene, options));
}

// Parts of pixels, compared with the faces at 8 by 8 places in each pixel: the picture of eight times the size with stripes of the
// same height. A row of places is off by at most half the distance of two places for each side that passes: by 1/16, on average by 1/32.
TEST(MontaniReCoverage, PartsAreTheSharesOfManyPlaces) {
  constexpr int factor = 8;
  for (const Setting& setting : settings) {
    const scene::PolyScene scene = scene_of(setting);
    for (const double stripe : {1.0, 0.25}) {
      FaceOptions options;
      options.stripe = stripe;
      const auto prepared = find_face_algorithm("montani-re")->prepare(scene, options);
      ASSERT_TRUE(prepared);
      std::map<std::array<std::uint32_t, 3>, double> parts;  // row, column, face
      std::vector<std::int64_t> sums(static_cast<std::size_t>(size) * size);
      std::int64_t whole = 0;
      const auto counts = prepared->coverage(scene.camera, window, [&](const FacePart& part) {
        whole = part.whole;
        sums[static_cast<std::size_t>(part.row * size + part.column)] += part.part;
        parts[{static_cast<std::uint32_t>(part.row), static_cast<std::uint32_t>(part.column), part.face}] +=
            static_cast<double>(part.part) / static_cast<double>(part.whole);
      });
      ASSERT_TRUE(counts);
      options.stripe = factor * stripe;
      const auto fine = find_face_algorithm("montani-re")->prepare(scene, options);
      constexpr FaceWindow large{factor * size, factor * size, factor * window.scale, factor * window.left, factor * window.top};
      const auto places = fine->view(scene.camera, large);
      ASSERT_TRUE(places);
      double error = 0;
      std::size_t shared = 0;
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          std::map<std::uint32_t, int> shares;
          for (int y = 0; y < factor; ++y)
            for (int x = 0; x < factor; ++x) ++shares[places->faces.at(factor * column + x, factor * row + y)];
          const auto place = std::array{static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)};
          const bool covered = !shares.contains(0);
          const std::int64_t sum = sums[static_cast<std::size_t>(row * size + column)];
          if (covered && shares.size() == 1) {
            // Nothing but a side at the very border of the pixel can take some of it.
            EXPECT_GE(sum, whole - whole / 4) << setting.family << ", pixel " << column << ", " << row;
          }
          EXPECT_LE(sum, whole + whole / 16) << setting.family << ", pixel " << column << ", " << row;
          if (shares.size() == 1) continue;
          for (const auto& [face, count] : shares) {
            if (face == 0) continue;
            const auto found = parts.find({place[0], place[1], face});
            const double part = found == parts.end() ? 0 : found->second;
            const double share = count / static_cast<double>(factor * factor);
            EXPECT_NEAR(part, share, 0.25) << setting.family << ", pixel " << column << ", " << row << ", face " << face;
            error += std::abs(part - share);
            ++shared;
          }
        }
      }
      EXPECT_GT(shared, 200U) << setting.family;
      EXPECT_LT(error, static_cast<double>(shared) / 24) << setting.family;
    }
  }
}

}  // namespace
}  // namespace sightline::registry
