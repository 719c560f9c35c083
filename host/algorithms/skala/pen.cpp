#include "host/algorithms/skala/pen.hpp"

#include <algorithm>
#include <limits>

namespace sightline::algorithms::skala {
namespace {

// Ends of pieces are numbered: piece n has the ends 2 n and 2 n + 1.
constexpr std::uint32_t no_end = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void Sheet::line(std::uint32_t layer, const std::vector<Vertex>& corners) {
  std::vector<picture::DrawingPoint>& points = drawing_->points;
  const std::size_t first = points.size();
  for (const Vertex corner : corners) {
    const picture::DrawingPoint point = place(corner);
    if (points.size() == first || points.back() != point) points.push_back(point);
  }
  drawing_->lines.push_back(
      {layer, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(points.size() - first)});
}

// The end that each end is joined to, or none.
std::vector<std::uint32_t> Stitcher::partners() const {
  struct Named {
    std::uint32_t layer;
    std::uint32_t end;
    Joint joint;
  };
  std::vector<Named> named;
  for (std::uint32_t i = 0; i < 2 * pieces_.size(); ++i) {
    const Stitch& stitch = pieces_[i / 2];
    if (stitch.ends[i % 2] != 0) named.push_back({stitch.layer, i, stitch.ends[i % 2]});
  }
  std::sort(named.begin(), named.end(), [](const Named& a, const Named& b) {
    if (a.joint != b.joint) return a.joint < b.joint;
    return a.layer != b.layer ? a.layer < b.layer : a.end < b.end;
  });
  std::vector<std::uint32_t> partner(2 * pieces_.size(), no_end);
  for (std::size_t i = 0; i + 1 < named.size(); ++i) {
    if (named[i].joint != named[i + 1].joint || named[i].layer != named[i + 1].layer) continue;
    partner[named[i].end] = named[i + 1].end;
    partner[named[i + 1].end] = named[i].end;
    ++i;
  }
  return partner;
}

void Stitcher::finish(Sheet& sheet) {
  const std::vector<std::uint32_t> partner = partners();
  std::vector<bool> drawn(pieces_.size());
  std::vector<Vertex> corners;
  for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
    if (drawn[piece]) continue;
    // Goes back to the start of the line, or once around a closed line.
    std::uint32_t start = 2 * piece;
    while (partner[start] != no_end && partner[start] / 2 != piece) start = partner[start] ^ 1U;
    corners.assign(1, end(start));
    for (std::uint32_t at = start; at != no_end && !drawn[at / 2]; at = partner[at ^ 1U]) {
      drawn[at / 2] = true;
      corners.push_back(end(at ^ 1U));
    }
    sheet.line(pieces_[piece].layer, corners);
  }
  pieces_.clear();
}

}  // namespace sightline::algorithms::skala
