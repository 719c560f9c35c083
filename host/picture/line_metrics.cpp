#include "host/picture/line_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/picture/line_metrics_near.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::picture {
namespace {

constexpr double sample_distance = 0.25;
constexpr double tau = 1;  // pixels: smaller distances are not distinguished
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t steps_of(double length) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / sample_distance)));
}

// From every sample of a, ends included, to the nearest point of b.
std::vector<double> distances(const std::vector<PixelSegment>& a, const NearestSegment& b) {
  std::vector<double> result;
  std::uint32_t near = 0;
  for (const PixelSegment& segment : a) {
    const std::size_t steps = steps_of(length_of(segment));
    for (std::size_t n = 0; n <= steps; ++n)
      result.push_back(b.distance(point_at(segment, static_cast<double>(n) / static_cast<double>(steps)), near));
  }
  return result;
}

std::vector<PixelSegment> segments_of(const std::vector<MeasuredLine>& lines,
                                      LineParts MeasuredLine::*parts) {
  std::vector<PixelSegment> segments;
  for (const MeasuredLine& line : lines)
    for (const LinePart& part : line.*parts) segments.push_back(part_of(line.image, part));
  return segments;
}

// Length of the parts, measured at the middles of equal steps, that are farther than tau from `others`.
double far_length(const MeasuredLine& line, const LineParts& parts, const NearestSegment& others) {
  double far = 0;
  for (const LinePart& part : parts) {
    const PixelSegment segment = part_of(line.image, part);
    const double length = length_of(segment);
    const std::size_t steps = steps_of(length);
    std::size_t alone = 0;
    for (std::size_t n = 0; n < steps; ++n) {
      const double place = (static_cast<double>(n) + 0.5) / static_cast<double>(steps);
      alone += others.distance(point_at(segment, place)) > tau ? 1U : 0U;
    }
    far += length * static_cast<double>(alone) / static_cast<double>(steps);
  }
  return far;
}

// Both lists ascend. A piece without a match is counted on the side that ends first.
std::size_t pieces_without_counterpart(const MeasuredLine& line) {
  const LineParts& a = line.visible;
  const LineParts& b = line.drawn;
  std::size_t count = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const bool same = std::abs(a[i].low - b[j].low) * line.length <= tau &&
                      std::abs(a[i].high - b[j].high) * line.length <= tau;
    const bool a_ends = a[i].high <= b[j].high;
    const bool b_ends = b[j].high <= a[i].high;
    if (!same) count += (a_ends ? 1U : 0U) + (b_ends ? 1U : 0U);
    if (same || a_ends) ++i;
    if (same || b_ends) ++j;
  }
  return count + (a.size() - i) + (b.size() - j);
}

// SplitMix64: the same numbers on every platform.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  // A number in [0, 1).
  double operator()() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -53);
  }

 private:
  std::uint64_t state_;
};

bool near_an_end(const MeasuredLine& line, double place) {
  return std::any_of(line.visible.begin(), line.visible.end(), [&](const LinePart& part) {
    return std::abs(part.low - place) * line.length < tau || std::abs(part.high - place) * line.length < tau;
  });
}

Rate wrong_visibility(const std::vector<MeasuredLine>& lines, const MetricOptions& options) {
  struct Edge {
    const MeasuredLine* line;
    LinePart part;
    double until;  // total length of all edges up to the end of this one
  };
  std::vector<Edge> edges;
  double length = 0;
  for (const MeasuredLine& line : lines) {
    for (const LinePart& part : line.edges) {
      length += (part.high - part.low) * line.length;
      edges.push_back({&line, part, length});
    }
  }
  if (!(length > 0)) return rate_of(0, 0);
  Dice dice(options.seed);
  std::uint64_t wrong = 0;
  std::uint64_t points = 0;
  for (std::uint64_t n = 0; n < options.points; ++n) {
    const double at = dice() * length;
    const auto edge = std::upper_bound(edges.begin(), edges.end() - 1, at,
                                       [](double value, const Edge& e) { return value < e.until; });
    const double place = edge->part.low + dice() * (edge->part.high - edge->part.low);
    if (near_an_end(*edge->line, place)) continue;
    ++points;
    wrong += contains(edge->line->visible, place) != contains(edge->line->drawn, place) ? 1U : 0U;
  }
  return rate_of(wrong, points);
}

}  // namespace

Rate rate_of(std::uint64_t wrong, std::uint64_t points) {
  Rate rate{points, wrong, 0, 0, 1};
  if (points == 0) return rate;
  constexpr double z = 1.959963984540054;  // of the normal distribution: two-sided 95 per cent
  const auto n = static_cast<double>(points);
  const double p = static_cast<double>(wrong) / n;
  const double middle = p + z * z / (2 * n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  rate.rate = p;
  rate.low = wrong == 0 ? 0 : (middle - half) / (1 + z * z / n);
  rate.high = wrong == points ? 1 : (middle + half) / (1 + z * z / n);
  return rate;
}

HausdorffDistance directed_hausdorff_distance(std::vector<double> distances) {
  if (distances.empty()) return {};
  const auto usual = distances.end() - 1 - static_cast<std::ptrdiff_t>(distances.size() / 1000);
  std::nth_element(distances.begin(), usual, distances.end());
  return {*std::max_element(usual, distances.end()), *usual};
}

HausdorffDistance directed_hausdorff_distance(const std::vector<PixelSegment>& a, const std::vector<PixelSegment>& b) {
  return directed_hausdorff_distance(distances(a, NearestSegment(b)));
}

HausdorffDistance hausdorff_distance(const std::vector<PixelSegment>& a, const std::vector<PixelSegment>& b) {
  const HausdorffDistance there = directed_hausdorff_distance(a, b);
  const HausdorffDistance back = directed_hausdorff_distance(b, a);
  return {std::max(there.greatest, back.greatest), std::max(there.usual, back.usual)};
}

double LineMetrics::share(double length) const {
  if (!(length > 0)) return 0;
  return true_length > 0 ? length / true_length : infinity;
}

LineMetrics line_metrics(const std::vector<ReferenceLine>& reference, const std::vector<DrawnPiece>& drawn,
                         const MetricOptions& options) {
  const std::vector<MeasuredLine> lines = measured_lines(reference, drawn);
  std::vector<PixelSegment> seen;
  std::vector<PixelSegment> pieces;
  if (options.distances) {
    seen = segments_of(lines, &MeasuredLine::visible);
    for (const DrawnPiece& piece : drawn) pieces.push_back(piece.image);
  }
  const NearestSegment near_seen(seen);
  const NearestSegment near_drawn(pieces);
  LineMetrics metrics;
  for (const MeasuredLine& line : lines) {
    const LineParts missing = without(line.visible, line.drawn);
    const LineParts extra = without(line.drawn, line.visible);
    metrics.true_length += total(line.visible) * line.length;
    metrics.drawn_length += total(line.drawn) * line.length;
    metrics.missing += total(missing) * line.length;
    metrics.extra += total(extra) * line.length;
    if (options.distances) {
      metrics.missing_far += far_length(line, missing, near_drawn);
      metrics.extra_far += far_length(line, extra, near_seen);
    }
    metrics.pieces_different += pieces_without_counterpart(line);
  }
  if (options.distances) metrics.hausdorff = hausdorff_distance(seen, pieces);
  metrics.wrong_visibility = wrong_visibility(lines, options);
  return metrics;
}

LineDifference line_difference(const std::vector<ReferenceLine>& reference, const std::vector<DrawnPiece>& drawn,
                               double least) {
  LineDifference difference;
  for (const MeasuredLine& line : measured_lines(reference, drawn)) {
    const auto add = [&](std::vector<PixelSegment>& to, const LineParts& parts, double shortest) {
      for (const LinePart& part : parts)
        if ((part.high - part.low) * line.length > shortest) to.push_back(part_of(line.image, part));
    };
    add(difference.agreed, common(line.visible, line.drawn), 0);
    add(difference.missing, without(line.visible, line.drawn), least);
    add(difference.extra, without(line.drawn, line.visible), least);
  }
  return difference;
}

}  // namespace sightline::picture
