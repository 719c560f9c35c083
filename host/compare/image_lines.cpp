// See image_lines.hpp.
#include "host/compare/image_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "host/picture/line_metrics_parts.hpp"
#include "host/picture/line_picture_image.hpp"

namespace sightline::compare {
namespace {

using picture::LineId;
using picture::LinePart;
using picture::LineParts;
using picture::PixelSegment;
using picture::ReferenceLine;

// The line in the image that every edge lies on, counted from 0 in the order of the edges.
std::vector<LineId> image_lines(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  std::vector<LineId> numbers;
  std::map<std::array<std::int64_t, 4>, LineId> known;
  LineId next = 0;
  for (const picture::LineEdge& edge : picture::edges_of(scene)) {
    const picture::LinePicture alone{{{edge, geometry::Rational(0), geometry::Rational(1)}}};
    const auto image = picture::image_set(alone, scene, camera).segments;
    // An edge whose image is a point is a line by itself, and never referred to.
    if (image.empty())
      numbers.push_back(next++);
    else if (const auto [line, is_new] = known.try_emplace(image.front().line, next); is_new)
      numbers.push_back(next++);
    else
      numbers.push_back(line->second);
  }
  return numbers;
}

// From the least to the greatest place of all of them, along the longest.
PixelSegment common_image(const std::vector<const ReferenceLine*>& members) {
  const ReferenceLine& longest =
      **std::max_element(members.begin(), members.end(), [](const auto* a, const auto* b) {
        return picture::length_of(a->image) < picture::length_of(b->image);
      });
  LinePart extent{0, 1};
  for (const ReferenceLine* member : members) {
    for (const picture::PixelPoint& end : {member->image.a, member->image.b}) {
      const double place = picture::place_on(longest.image, end);
      extent = {std::min(extent.low, place), std::max(extent.high, place)};
    }
  }
  return {picture::point_at(longest.image, extent.low), picture::point_at(longest.image, extent.high)};
}

LineParts parts_on(const PixelSegment& image, const std::vector<const ReferenceLine*>& members,
                   std::vector<LinePart> ReferenceLine::*which) {
  LineParts parts;
  for (const ReferenceLine* member : members)
    for (const LinePart& part : member->*which)
      parts.push_back({picture::place_on(image, picture::point_at(member->image, part.low)),
                       picture::place_on(image, picture::point_at(member->image, part.high))});
  return picture::united(std::move(parts));
}

}  // namespace

ImageLines::ImageLines(const std::vector<ReferenceLine>& lines, const scene::PolyScene& scene,
                       const scene::PolyCamera& camera)
    : line_of_edge_(image_lines(scene, camera)) {
  std::map<LineId, std::vector<const ReferenceLine*>> members;
  for (const ReferenceLine& line : lines) members[line_of_edge_.at(line.id)].push_back(&line);
  for (const auto& [number, together] : members) {
    const PixelSegment image = common_image(together);
    lines_.push_back({number, image, parts_on(image, together, &ReferenceLine::edges),
                      parts_on(image, together, &ReferenceLine::visible)});
  }
}

std::vector<picture::DrawnPiece> ImageLines::pieces(std::vector<picture::DrawnPiece> of_edges) const {
  for (picture::DrawnPiece& piece : of_edges)
    if (piece.line < line_of_edge_.size()) piece.line = line_of_edge_[piece.line];
  return of_edges;
}

}  // namespace sightline::compare
