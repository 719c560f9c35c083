// Laws of boxes for all small ones, and of the tree over them, compared with a test of each box.
#include "host/geometry/box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "host/geometry/box_tree.hpp"

namespace sightline::geometry {
namespace {

TEST(Span, SatisfiesTheLawsForAllSmallSpans) {
  for (std::int32_t a = -2; a <= 2; ++a) {
    for (std::int32_t b = -2; b <= 2; ++b) {
      const Span s{a, b};
      for (std::int32_t c = -2; c <= 2; ++c) {
        for (std::int32_t d = -2; d <= 2; ++d) {
          const Span t{c, d};
          const Span common{std::max(a, c), std::min(b, d)};
          EXPECT_EQ(s.overlaps(t), !common.empty());
          EXPECT_EQ(s.overlaps(t), t.overlaps(s));
          if (!t.empty()) {
            EXPECT_EQ(s.contains(t), s.contains(c) && s.contains(d));
          }
        }
      }
      EXPECT_EQ(s.empty(), s.length() <= 0);
      EXPECT_EQ(s.overlaps(s), !s.empty());
    }
  }
}

class RandomBoxes {
 public:
  explicit RandomBoxes(std::int32_t reach) : reach_(reach) {}
  // Perhaps flat, never inverted.
  Box next() {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t a = coordinate();
      const std::int32_t b = coordinate();
      box.low[axis] = std::min(a, b);
      box.high[axis] = std::max(a, b);
    }
    return box;
  }

 private:
  std::int32_t coordinate() {
    return static_cast<std::int32_t>(random_() % static_cast<unsigned>(2 * reach_ + 1)) - reach_;
  }
  std::mt19937 random_{1971};
  std::int32_t reach_;
};

TEST(Box, SatisfiesTheLawsForRandomBoxes) {
  for (const std::int32_t reach : {2, 30, coordinate_limit - 1}) {
    RandomBoxes boxes(reach);
    for (int i = 0; i < 1000; ++i) {
      const Box a = boxes.next();
      const Box b = boxes.next();
      Box common;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        common.low[axis] = std::max(a.low[axis], b.low[axis]);
        common.high[axis] = std::min(a.high[axis], b.high[axis]);
      }
      EXPECT_EQ(a.overlaps(b), common.volume() > 0);
      EXPECT_EQ(a.overlaps(b), b.overlaps(a));
      EXPECT_EQ(a.contains(b), a.contains(b.low) && a.contains(b.high));
      EXPECT_EQ(a.contains(b), common == b);
      EXPECT_EQ(a.empty(), a.volume() == 0);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
          const Rectangle face = face_of(a, axis, high);
          EXPECT_TRUE(a.contains(face.bounds()));
          EXPECT_FALSE(a.contains_inside(face.bounds().low));
          EXPECT_EQ(face.bounds().volume(), 0);
          EXPECT_EQ(face.overlaps(face), !face.empty());
        }
      }
    }
  }
}

TEST(BoxTree, VisitsTheBoxesThatATestOfEachFinds) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 50U}) {
    RandomBoxes random(10);
    for (int round = 0; round < 20; ++round) {
      std::vector<Box> boxes;
      for (std::size_t i = 0; i < count; ++i) boxes.push_back(random.next());
      if (count > 2) boxes[2] = boxes[0];
      const BoxTree tree(boxes);
      const Box query = random.next();
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        bool touches = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          touches =
              touches && boxes[i].low[axis] <= query.high[axis] && query.low[axis] <= boxes[i].high[axis];
        }
        if (touches) expected.push_back(i);
      }
      std::vector<std::uint32_t> found;
      tree.for_each_touching(query, [&](std::uint32_t i) { found.push_back(i); });
      std::vector<std::uint32_t> again;
      tree.for_each_touching(query, [&](std::uint32_t i) { again.push_back(i); });
      EXPECT_EQ(found, again);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace sightline::geometry
