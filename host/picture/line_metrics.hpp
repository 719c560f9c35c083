// Measures the error of a line drawing against exact visibility: missing and extra lengths, distance, wrong visibility at
// random points, and differing pieces.
//
// Every straight line of a scene has a number. The reference is a list of lines with their visible parts; a drawing is a
// list of pieces, each with the number of its line. The ends of a piece are projected orthogonally onto its reference
// line, so a piece half a pixel beside its line has no error of length, and one that ends half a pixel too late has an
// error of half a pixel. Pieces of one line are united first, so drawing twice is no error. A piece of a line that the
// reference lacks counts wholly as extra.
//
// Laws, all tested: a drawing of exactly the visible parts gives 0 everywhere; exchanging reference and drawing (if both
// are on the same lines) exchanges missing and extra and does not change distance and pieces; nothing depends on the
// order of pieces and lines, and no length on the position of the picture on the screen or on which end of a line is
// first; extra_far <= extra, missing_far <= missing.
//
// Sizes are pixels. Source: the suite's cross-check of algorithms, section 4 (L_miss, L_extra, H, WVR, TOPO).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline::picture {

struct PixelPoint {
  double x = 0;
  double y = 0;
};

struct PixelSegment {
  PixelPoint a;
  PixelPoint b;
};

// Part of a line: 0 at the image's a, 1 at its b.
struct LinePart {
  double low = 0;
  double high = 1;

  friend bool operator==(const LinePart&, const LinePart&) = default;
};

using LineId = std::uint32_t;

// A straight line of the scene. Several edges may lie on it: `edges` is disjoint and ascending, and so is `visible`,
// which is inside them.
struct ReferenceLine {
  LineId id = 0;  // unique
  PixelSegment image;
  std::vector<LinePart> edges{{0, 1}};
  std::vector<LinePart> visible;
};

struct DrawnPiece {
  LineId line = 0;
  PixelSegment image;
};

// A rate with its 95 per cent interval after Wilson.
struct Rate {
  std::uint64_t points = 0;
  std::uint64_t wrong = 0;
  double rate = 0;  // wrong / points, 0 for no points
  double low = 0;
  double high = 0;  // 1 for no points
};
[[nodiscard]] Rate rate_of(std::uint64_t wrong, std::uint64_t points);

// The Hausdorff distance of two sets of points in the plane: the greatest distance of a point of one set from the other.
// `usual` is exceeded by one sample in a thousand, in the worse of the two directions. Infinite if exactly one set is
// empty.
struct HausdorffDistance {
  double greatest = 0;
  double usual = 0;
};
// Samples both sets every 0.25 pixels and compares the samples with the other set's segments. A segment of length 0 is a
// point.
[[nodiscard]] HausdorffDistance hausdorff_distance(const std::vector<PixelSegment>& a,
                                                   const std::vector<PixelSegment>& b);

struct LineMetrics {
  double true_length = 0;  // of the visible parts
  double drawn_length = 0;
  double missing = 0;      // L_miss
  double extra = 0;        // L_extra
  double missing_far = 0;  // part of missing, farther than 1 pixel from everything drawn
  double extra_far = 0;    // part of extra, farther than 1 pixel from everything visible: noticeable
  HausdorffDistance hausdorff;
  Rate wrong_visibility;
  // TOPO: pieces without a counterpart, on both sides. Drawings do not record what ends a piece, so its counterpart is a
  // piece of the same line with both ends within 1 pixel.
  std::size_t pieces_different = 0;

  [[nodiscard]] double symmetric() const { return missing + extra; }
  // A length relative to the true length: 0 if both are 0, infinite if only the true length is 0.
  [[nodiscard]] double share(double length) const;
};

struct MetricOptions {
  std::uint64_t points = 20'000;  // random points for the wrong-visibility rate, distributed by image length over all edges
  std::uint64_t seed = 1971;
  bool distances = true;  // false: hausdorff, missing_far and extra_far stay 0, which takes a tenth of the time
};

[[nodiscard]] LineMetrics line_metrics(const std::vector<ReferenceLine>& reference,
                                       const std::vector<DrawnPiece>& drawn,
                                       const MetricOptions& options = {});

// Where reference and drawing agree and differ, on the reference lines; pieces of unknown lines at their own place.
struct LineDifference {
  std::vector<PixelSegment> agreed;
  std::vector<PixelSegment> missing;
  std::vector<PixelSegment> extra;
};
// Omits parts of missing and extra that are at most `least` pixels long.
[[nodiscard]] LineDifference line_difference(const std::vector<ReferenceLine>& reference,
                                             const std::vector<DrawnPiece>& drawn, double least = 0);

}  // namespace sightline::picture
