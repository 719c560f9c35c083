// The error of a line drawing, compared with exact visibility: lengths missing and extra, distance, wrong
// visibility at random points, pieces that differ.
//
// Every straight line of a scene has a number. The truth is a list of lines with the parts of them that are
// seen, a drawing a list of pieces that say which line they are of. A piece is measured where it belongs: its
// ends are put on the true line by orthogonal projection, so a piece that lies half a pixel beside its line
// is no error of length, and one that ends half a pixel too late is one of half a pixel. Pieces of one line
// are united first: drawing twice is no error. A piece of a line that is not in the truth counts whole, as extra.
//
// Laws, all tested: a drawing of what is seen gives 0 everywhere; exchanging truth and drawing (where both
// lie on the same lines) exchanges missing and extra and leaves distance and pieces as they are; nothing
// depends on the order of pieces and lines, and no length on where the picture lies on the screen or which
// end of a line comes first; extra_far <= extra, missing_far <= missing.
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

// Parts of a line, 0 at the image's a, 1 at its b.
struct LinePart {
  double low = 0;
  double high = 1;

  friend bool operator==(const LinePart&, const LinePart&) = default;
};

using LineId = std::uint32_t;

// A straight line of the scene. Several edges may lie on it; they are its `edges`, disjoint and ascending,
// as `visible` is, which is inside them.
struct ReferenceLine {
  LineId id = 0;  // each once
  PixelSegment image;
  std::vector<LinePart> edges{{0, 1}};
  std::vector<LinePart> visible;
};

struct DrawnPiece {
  LineId line = 0;
  PixelSegment image;
};

// A rate with its interval of 95 per cent after Wilson.
struct Rate {
  std::uint64_t points = 0;
  std::uint64_t wrong = 0;
  double rate = 0;  // wrong / points, 0 for no points
  double low = 0;
  double high = 0;  // 1 for no points
};
[[nodiscard]] Rate rate_of(std::uint64_t wrong, std::uint64_t points);

// Of two sets of points in the plane: the farthest any point of the one is from the other; `usual` is
// exceeded by one sample in a thousand, in the worse of the two directions. Infinite if one set is empty and
// the other not.
struct HausdorffDistance {
  double greatest = 0;
  double usual = 0;
};
// Samples every 0.25 pixels on both sets, compared with the other set's segments. A segment of no
// length is a point.
[[nodiscard]] HausdorffDistance hausdorff_distance(const std::vector<PixelSegment>& a,
                                                   const std::vector<PixelSegment>& b);

struct LineMetrics {
  double true_length = 0;  // of all that is seen
  double drawn_length = 0;
  double missing = 0;      // L_miss
  double extra = 0;        // L_extra
  double missing_far = 0;  // of missing, farther than 1 pixel from everything drawn
  double extra_far = 0;    // of extra, farther than 1 pixel from everything seen: what a person sees
  HausdorffDistance hausdorff;
  Rate wrong_visibility;
  // TOPO: pieces with no counterpart, on both sides. Drawings say nothing of what ends a piece, so a piece's
  // counterpart is one of the same line with both ends within 1 pixel.
  std::size_t pieces_different = 0;

  [[nodiscard]] double symmetric() const { return missing + extra; }
  // Of a length, in terms of the true length: 0 of nothing, infinite of something where nothing is seen.
  [[nodiscard]] double share(double length) const;
};

struct MetricOptions {
  std::uint64_t points = 20'000;  // tried for the wrong-visibility rate, by image length of all edges
  std::uint64_t seed = 1971;
  bool distances = true;  // false: hausdorff, missing_far and extra_far are left at 0, which takes a tenth of the time
};

[[nodiscard]] LineMetrics line_metrics(const std::vector<ReferenceLine>& truth,
                                       const std::vector<DrawnPiece>& drawn,
                                       const MetricOptions& options = {});

// Where truth and drawing agree and where not, on the true lines; pieces of unknown lines where they lie.
struct LineDifference {
  std::vector<PixelSegment> agreed;
  std::vector<PixelSegment> missing;
  std::vector<PixelSegment> extra;
};
// Stretches of missing and extra that are not longer than `least` pixels are left out.
[[nodiscard]] LineDifference line_difference(const std::vector<ReferenceLine>& truth,
                                             const std::vector<DrawnPiece>& drawn, double least = 0);

}  // namespace sightline::picture
