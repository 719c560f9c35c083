// A ring compared with a std::vector that the same is done to, and equal points with those that a search of all finds.
#include "host/scene/model/ring.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "host/scene/model/index_set.hpp"

namespace sightline::scene {
namespace {

TEST(Ring, DoesWhatAVectorDoes) {
  std::mt19937 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  Ring ring;
  std::vector<VertexIndex> vector;
  for (int step = 0; step < 20'000; ++step) {
    const auto vertex = static_cast<VertexIndex>(random());
    const std::size_t at = below(vector.size() + 1);
    const auto in_ring = ring.begin() + at;
    const auto in_vector = vector.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(9)) {
      case 0:
      case 1:
        ring.push_back(vertex);
        vector.push_back(vertex);
        break;
      case 2:
        ring.insert(in_ring, vertex);
        vector.insert(in_vector, vertex);
        break;
      case 3: {
        const std::vector<VertexIndex> more(below(4), vertex);
        ring.insert(in_ring, more.begin(), more.end());
        vector.insert(in_vector, more.begin(), more.end());
        break;
      }
      case 4:
        ring.erase(in_ring, ring.end());
        vector.erase(in_vector, vector.end());
        break;
      case 5:
        if (at == vector.size()) break;
        ring.erase(in_ring);
        vector.erase(in_vector);
        break;
      case 6: {
        const std::size_t size = below(9);
        ring.resize(size);
        vector.resize(size);
        break;
      }
      case 7: {
        Ring other = ring;  // and back by a move
        ring.clear();
        ring = std::move(other);
        break;
      }
      default: {
        Ring other = std::move(ring);
        EXPECT_TRUE(ring.empty());  // NOLINT(bugprone-use-after-move): a ring that was moved from is empty
        ring = other;
        break;
      }
    }
    ASSERT_EQ(ring, vector) << step;
    ASSERT_EQ(ring.size(), vector.size());
    if (vector.empty()) continue;
    ASSERT_EQ(ring.back(), vector.back());
  }
}

TEST(EqualPoints, AreTheFirstOfEach) {
  std::mt19937 random(11);
  for (const std::size_t count : {0U, 1U, 2U, 50U, 700U}) {
    std::vector<PolyPoint> points(count);
    for (PolyPoint& p : points)
      for (std::int32_t& c : p) c = static_cast<std::int32_t>(random() % 7) - 3 - (random() % 40 == 0 ? poly_coordinate_limit / 2 : 0);
    const std::vector<VertexIndex> first = equal_points(points);
    ASSERT_EQ(first.size(), count);
    for (std::size_t v = 0; v < count; ++v) {
      std::size_t expected = 0;
      while (points[expected] != points[v]) ++expected;
      EXPECT_EQ(first[v], expected);
    }
  }
}

}  // namespace
}  // namespace sightline::scene
