#include "host/picture/line_metrics_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sightline::picture {

LineParts united(LineParts parts) {
  for (LinePart& part : parts)
    if (part.low > part.high) std::swap(part.low, part.high);
  std::sort(parts.begin(), parts.end(), [](const LinePart& a, const LinePart& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  LineParts result;
  for (const LinePart& part : parts) {
    if (!(part.low < part.high)) continue;
    if (!result.empty() && part.low <= result.back().high)
      result.back().high = std::max(result.back().high, part.high);
    else
      result.push_back(part);
  }
  return result;
}

LineParts common(const LineParts& a, const LineParts& b) {
  LineParts result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const LinePart both{std::max(a[i].low, b[j].low), std::min(a[i].high, b[j].high)};
    if (both.low < both.high) result.push_back(both);
    if (a[i].high < b[j].high)
      ++i;
    else
      ++j;
  }
  return result;
}

LineParts without(const LineParts& a, const LineParts& b) {
  LineParts result;
  std::size_t j = 0;
  for (const LinePart& part : a) {
    double from = part.low;
    while (j < b.size() && b[j].high <= from) ++j;
    for (std::size_t k = j; k < b.size() && b[k].low < part.high; ++k) {
      if (from < b[k].low) result.push_back({from, b[k].low});
      from = std::max(from, b[k].high);
    }
    if (from < part.high) result.push_back({from, part.high});
  }
  return result;
}

double total(const LineParts& parts) {
  double sum = 0;
  for (const LinePart& part : parts) sum += part.high - part.low;
  return sum;
}

bool contains(const LineParts& parts, double place) {
  return std::any_of(parts.begin(), parts.end(),
                     [place](const LinePart& part) { return part.low <= place && place <= part.high; });
}

double length_of(const PixelSegment& segment) {
  return std::hypot(segment.b.x - segment.a.x, segment.b.y - segment.a.y);
}

PixelPoint point_at(const PixelSegment& segment, double place) {
  return {segment.a.x + place * (segment.b.x - segment.a.x),
          segment.a.y + place * (segment.b.y - segment.a.y)};
}

PixelSegment part_of(const PixelSegment& segment, const LinePart& part) {
  return {point_at(segment, part.low), point_at(segment, part.high)};
}

double place_on(const PixelSegment& segment, const PixelPoint& point) {
  const double dx = segment.b.x - segment.a.x;
  const double dy = segment.b.y - segment.a.y;
  const double square = dx * dx + dy * dy;
  return square > 0 ? ((point.x - segment.a.x) * dx + (point.y - segment.a.y) * dy) / square : 0;
}

double distance(const PixelPoint& point, const PixelSegment& segment) {
  const PixelPoint foot = point_at(segment, std::clamp(place_on(segment, point), 0.0, 1.0));
  return std::hypot(point.x - foot.x, point.y - foot.y);
}

std::vector<MeasuredLine> measured_lines(const std::vector<ReferenceLine>& reference,
                                         const std::vector<DrawnPiece>& drawn) {
  std::vector<const ReferenceLine*> order;
  for (const ReferenceLine& line : reference) order.push_back(&line);
  std::sort(order.begin(), order.end(),
            [](const ReferenceLine* a, const ReferenceLine* b) { return a->id < b->id; });
  std::vector<MeasuredLine> lines;
  for (const ReferenceLine* line : order)
    lines.push_back({line->image, length_of(line->image), united(line->edges), united(line->visible), {}});
  const std::size_t known = lines.size();
  for (const DrawnPiece& piece : drawn) {
    const auto place = std::lower_bound(order.begin(), order.end(), piece.line,
                                        [](const ReferenceLine* a, LineId id) { return a->id < id; });
    if (place == order.end() || (*place)->id != piece.line) {
      lines.push_back({piece.image, length_of(piece.image), {}, {}, {{0, 1}}});
      continue;
    }
    MeasuredLine& line = lines[static_cast<std::size_t>(place - order.begin())];
    line.drawn.push_back({place_on(line.image, piece.image.a), place_on(line.image, piece.image.b)});
  }
  for (std::size_t i = 0; i < known; ++i) lines[i].drawn = united(std::move(lines[i].drawn));
  return lines;
}

}  // namespace sightline::picture
