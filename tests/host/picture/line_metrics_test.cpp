// Metrics of line pictures: cases computed by hand, and the laws of line_metrics.hpp.
#include "host/picture/line_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "host/picture/line_metrics_near.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "tests/support/effort.hpp"

namespace sightline::picture {
namespace {

// 100 pixels to the right; visible from 20 to 60.
ReferenceLine line_of_100_pixels(LineId id, double y = 10) {
  return {id, {{0, y}, {100, y}}, {{0, 1}}, {{0.2, 0.6}}};
}

DrawnPiece drawn(LineId id, double from, double to, double y = 10) {
  return {id, {{from, y}, {to, y}}};
}

TEST(LineMetrics, OfTheVisiblePartsAreZero) {
  const LineMetrics m = line_metrics({line_of_100_pixels(1)}, {drawn(1, 20, 60)});
  EXPECT_NEAR(m.true_length, 40, 1e-9);
  EXPECT_NEAR(m.drawn_length, 40, 1e-9);
  EXPECT_NEAR(m.missing, 0, 1e-9);
  EXPECT_NEAR(m.extra, 0, 1e-9);
  EXPECT_NEAR(m.hausdorff.greatest, 0, 1e-9);
  EXPECT_EQ(m.wrong_visibility.wrong, 0U);
  EXPECT_GT(m.wrong_visibility.points, 10'000U);
  EXPECT_EQ(m.pieces_different, 0U);
}

TEST(LineMetrics, CountsMissingAndExtra) {
  // 15 missing at the left, 10 extra at the right.
  const LineMetrics m = line_metrics({line_of_100_pixels(1)}, {drawn(1, 35, 70)});
  EXPECT_NEAR(m.missing, 15, 1e-9);
  EXPECT_NEAR(m.extra, 10, 1e-9);
  EXPECT_NEAR(m.symmetric(), 25, 1e-9);
  EXPECT_NEAR(m.share(m.missing), 15.0 / 40, 1e-9);
  EXPECT_NEAR(m.missing_far, 14, 0.25);
  EXPECT_NEAR(m.extra_far, 9, 0.25);
  EXPECT_NEAR(m.hausdorff.greatest, 15, 1e-9);
  EXPECT_EQ(m.pieces_different, 2U);
  // 25 of the 100 pixels are wrong. Neither the pixel at the end of the true part of each wrong stretch nor the correct pixel
  // next to it is
  // sampled: 23 of 96.
  EXPECT_NEAR(m.wrong_visibility.rate, 23.0 / 96, 0.01);
  EXPECT_LE(m.wrong_visibility.low, 23.0 / 96);
  EXPECT_GE(m.wrong_visibility.high, 23.0 / 96);
}

TEST(LineMetrics, APieceNextToItsLineIsMeasuredOnTheLine) {
  const LineMetrics m = line_metrics({line_of_100_pixels(1)}, {drawn(1, 20, 60, 10.5)});
  EXPECT_NEAR(m.missing + m.extra, 0, 1e-9);
  EXPECT_NEAR(m.hausdorff.greatest, 0.5, 1e-9);
}

TEST(LineMetrics, DrawingTwiceAndInPartsIsNotAnError) {
  const LineMetrics m = line_metrics({line_of_100_pixels(1)}, {drawn(1, 20, 45), drawn(1, 60, 40), drawn(1, 30, 50)});
  EXPECT_NEAR(m.drawn_length, 40, 1e-9);
  EXPECT_NEAR(m.symmetric(), 0, 1e-9);
  EXPECT_EQ(m.pieces_different, 0U);
}

TEST(LineMetrics, ExtraOnAnotherTrueLineIsNotFar) {
  // Line 2 is half a pixel above line 1, is hidden, and is drawn: extra that is invisible.
  ReferenceLine hidden = line_of_100_pixels(2, 10.5);
  hidden.visible.clear();
  const LineMetrics m = line_metrics({line_of_100_pixels(1), hidden}, {drawn(1, 20, 60), drawn(2, 20, 60, 10.5)});
  EXPECT_NEAR(m.extra, 40, 1e-9);
  EXPECT_NEAR(m.extra_far, 0, 1e-9);
  EXPECT_NEAR(m.hausdorff.greatest, 0.5, 1e-9);
}

TEST(LineMetrics, PiecesOfUnknownLinesAreExtra) {
  const LineMetrics m = line_metrics({line_of_100_pixels(1)}, {drawn(1, 20, 60), drawn(9, 0, 30, 50)});
  EXPECT_NEAR(m.extra, 30, 1e-9);
  EXPECT_NEAR(m.extra_far, 30, 1e-9);
  EXPECT_EQ(m.pieces_different, 1U);
}

TEST(LineMetrics, SampleOnlyOnEdges) {
  ReferenceLine line = line_of_100_pixels(1);
  line.edges = {{0, 0.3}, {0.5, 0.6}};
  line.visible = {{0, 0.3}};
  const LineMetrics m = line_metrics({line}, {drawn(1, 0, 30), drawn(1, 30, 50)});
  EXPECT_NEAR(m.extra, 20, 1e-9);
  EXPECT_EQ(m.wrong_visibility.wrong, 0U) << "the extra is where no edge is";
}

TEST(LineMetrics, OfEmptyPictures) {
  ReferenceLine hidden = line_of_100_pixels(1);
  hidden.visible.clear();
  const LineMetrics nothing = line_metrics({hidden}, {});
  EXPECT_EQ(nothing.hausdorff.greatest, 0);
  EXPECT_EQ(nothing.share(nothing.extra), 0);
  EXPECT_EQ(line_metrics({}, {}).wrong_visibility.points, 0U);
  const LineMetrics lost = line_metrics({line_of_100_pixels(1)}, {});
  EXPECT_NEAR(lost.missing, 40, 1e-9);
  EXPECT_NEAR(lost.missing_far, 40, 1e-9);
  EXPECT_EQ(lost.hausdorff.greatest, std::numeric_limits<double>::infinity());
  EXPECT_EQ(line_metrics({hidden}, {drawn(1, 0, 1)}).share(1), std::numeric_limits<double>::infinity());
}

TEST(Hausdorff, AThousandthMayBeFarther) {
  // 1000 pixels are 4001 samples; a stray piece of half a pixel, 50 away, has three.
  const std::vector<PixelSegment> line{{{0, 0}, {1000, 0}}};
  std::vector<PixelSegment> other = line;
  other.push_back({{500, 50}, {500.5, 50}});
  const HausdorffDistance d = hausdorff_distance(line, other);
  EXPECT_NEAR(d.greatest, 50, 1e-9);
  EXPECT_NEAR(d.usual, 0, 1e-9);
}

TEST(Wilson, KnownIntervals) {
  // 10 of 100: 0.0552 to 0.1744 (Wilson 1927; Newcombe 1998 gives the method's values).
  const Rate rate = rate_of(10, 100);
  EXPECT_NEAR(rate.low, 0.0552, 5e-5);
  EXPECT_NEAR(rate.high, 0.1744, 5e-5);
  // 0 of 10: up to z^2 / (10 + z^2).
  EXPECT_EQ(rate_of(0, 10).low, 0);
  EXPECT_NEAR(rate_of(0, 10).high, 0.2775, 5e-5);
  EXPECT_EQ(rate_of(10, 10).high, 1);
}

// Random pictures: lines all over the screen with random visible and drawn parts.
struct RandomPicture {
  std::vector<ReferenceLine> truth;
  std::vector<DrawnPiece> drawn;
  std::vector<ReferenceLine> other_truth;  // exchanged
  std::vector<DrawnPiece> other_drawn;
};

RandomPicture random_picture(std::uint32_t seed, double shift = 0, bool turned = false) {
  std::mt19937 random(seed);
  const auto number = [&](double most) { return most * (static_cast<double>(random()) / 4294967296.0); };
  RandomPicture picture;
  for (LineId id = 0; id < 30; ++id) {
    PixelSegment image{{number(1023) + shift, number(1023)}, {number(1023) + shift, number(1023)}};
    const auto parts = [&] {
      LineParts some;
      for (int i = 0; i < 3; ++i) some.push_back({number(1), number(1)});
      return united(some);
    };
    LineParts seen = parts();
    LineParts shown = parts();
    if (turned) {
      std::swap(image.a, image.b);
      for (LineParts* list : {&seen, &shown}) {
        for (LinePart& part : *list) part = {1 - part.high, 1 - part.low};
        std::reverse(list->begin(), list->end());
      }
    }
    picture.truth.push_back({id, image, {{0, 1}}, seen});
    picture.other_truth.push_back({id, image, {{0, 1}}, shown});
    for (const LinePart& part : shown) picture.drawn.push_back({id, part_of(image, part)});
    for (const LinePart& part : seen) picture.other_drawn.push_back({id, part_of(image, part)});
  }
  return picture;
}

TEST(LineMetricsLaws, Hold) {
  for (std::uint32_t seed = 1; seed <= tests::effort(5U, 1U); ++seed) {
    SCOPED_TRACE(seed);
    const RandomPicture p = random_picture(seed);
    const LineMetrics m = line_metrics(p.truth, p.drawn, {2000, 1});
    EXPECT_LE(m.extra_far, m.extra + 1e-9);
    EXPECT_LE(m.missing_far, m.missing + 1e-9);
    EXPECT_NEAR(m.true_length - m.missing, m.drawn_length - m.extra, 1e-6) << "the common part";
    EXPECT_NEAR(line_metrics(p.truth, p.other_drawn).symmetric(), 0, 1e-9);

    const LineMetrics exchanged = line_metrics(p.other_truth, p.other_drawn, {2000, 1});
    EXPECT_NEAR(exchanged.missing, m.extra, 1e-6);
    EXPECT_NEAR(exchanged.extra, m.missing, 1e-6);
    EXPECT_NEAR(exchanged.missing_far, m.extra_far, 0.5);
    EXPECT_NEAR(exchanged.hausdorff.greatest, m.hausdorff.greatest, 1e-9);
    EXPECT_EQ(exchanged.pieces_different, m.pieces_different);

    const RandomPicture moved = random_picture(seed, 256);
    EXPECT_NEAR(line_metrics(moved.truth, moved.drawn).symmetric(), m.symmetric(), 1e-6);
    const RandomPicture turned = random_picture(seed, 0, true);
    const LineMetrics t = line_metrics(turned.truth, turned.drawn, {2000, 1});
    EXPECT_NEAR(t.missing, m.missing, 1e-6);
    EXPECT_NEAR(t.hausdorff.greatest, m.hausdorff.greatest, 1e-6);
    EXPECT_EQ(t.pieces_different, m.pieces_different);

    RandomPicture mixed = p;
    std::reverse(mixed.truth.begin(), mixed.truth.end());
    std::reverse(mixed.drawn.begin(), mixed.drawn.end());
    const LineMetrics again = line_metrics(mixed.truth, mixed.drawn, {2000, 1});
    EXPECT_EQ(again.missing, m.missing);
    EXPECT_EQ(again.wrong_visibility.wrong, m.wrong_visibility.wrong);
    // The rate equals the lengths, except near ends.
    EXPECT_NEAR(
        m.wrong_visibility.rate,
        m.symmetric() /
            [&] {
              double all = 0;
              for (const ReferenceLine& line : p.truth) all += length_of(line.image);
              return all;
            }(),
        0.04);
  }
}

TEST(LineDifferenceLaws, StretchesAddUp) {
  const RandomPicture p = random_picture(7);
  const LineMetrics m = line_metrics(p.truth, p.drawn);
  const LineDifference d = line_difference(p.truth, p.drawn);
  const auto length = [](const std::vector<PixelSegment>& segments) {
    double sum = 0;
    for (const PixelSegment& segment : segments) sum += length_of(segment);
    return sum;
  };
  EXPECT_NEAR(length(d.missing), m.missing, 1e-6);
  EXPECT_NEAR(length(d.extra), m.extra, 1e-6);
  EXPECT_NEAR(length(d.agreed), m.true_length - m.missing, 1e-6);
  for (const PixelSegment& segment : line_difference(p.truth, p.drawn, 5).missing)
    EXPECT_GT(length_of(segment), 5);
}

TEST(NearestSegment, EqualsALinearSearch) {
  std::mt19937 random(5);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  for (const int count : {1, 3, 200}) {
    std::vector<PixelSegment> segments;
    for (int i = 0; i < count; ++i)
      segments.push_back({{number(0, 1023), number(0, 1023)}, {number(0, 1023), number(0, 1023)}});
    const NearestSegment nearest(segments);
    for (int i = 0; i < 2000; ++i) {
      const PixelPoint p{number(-300, 1300), number(-300, 1300)};
      double least = std::numeric_limits<double>::infinity();
      for (const PixelSegment& s : segments) {
        const PixelPoint foot = point_at(s, std::clamp(place_on(s, p), 0.0, 1.0));
        least = std::min(least, std::hypot(p.x - foot.x, p.y - foot.y));
      }
      ASSERT_NEAR(nearest.distance(p), least, 1e-9) << count << " segments, point " << p.x << ' ' << p.y;
    }
  }
}

}  // namespace
}  // namespace sightline::picture
