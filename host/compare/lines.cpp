// See lines.hpp.
#include "host/compare/lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "host/compare/projection.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::compare {
namespace {

using picture::DrawnPiece;
using picture::LineId;
using picture::LinePart;
using picture::LinePicture;
using picture::LinePiece;
using picture::PixelPoint;
using picture::PixelSegment;
using picture::ReferenceLine;

constexpr double shortest_image = 1e-6;  // pixels: of what counts as a line
constexpr LineId no_line = std::numeric_limits<LineId>::max();

SeenEdge seen_edge(const picture::LineEdge& edge, const scene::PolyScene& scene,
                   const scene::PolyCamera& camera) {
  return {scene.vertices[edge.from], scene.vertices[edge.to], camera};
}

std::optional<LinePart> common_part(const LinePart& a, const LinePart& b) {
  const LinePart part{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (!(part.low < part.high)) return std::nullopt;
  return part;
}

LinePart part_of(const LinePiece& piece) {
  return {piece.low.to_double(), piece.high.to_double()};
}

LinePart part_on(const PixelSegment& image, const PixelSegment& pixels) {
  return {picture::place_on(image, pixels.a), picture::place_on(image, pixels.b)};
}

ScreenFrame frame_of(const algorithms::oracle::Window& window) {
  const auto& [across, up] = window.points;
  return {static_cast<double>(window.scale),
          {static_cast<double>(window.centre[0]), static_cast<double>(window.centre[1])},
          static_cast<double>(std::min(across.low, up.low)),
          static_cast<double>(std::max(across.high, up.high)),
          static_cast<double>(window.near)};
}

AxisLine line_through(const geometry::Point& p, const geometry::Point& q) {
  const std::size_t axis = p[0] != q[0] ? 0 : p[1] != q[1] ? 1 : 2;
  const auto [u, v] = geometry::other_axes(axis);
  return {axis, {p[u], p[v]}};
}

// By an eye that looks along z.
SeenEdge seen_from(const geometry::Point& eye, const geometry::Point& p, const geometry::Point& q) {
  const auto relative = [&](const geometry::Point& r) {
    return SeenPoint{static_cast<double>(r[0] - eye[0]), static_cast<double>(r[1] - eye[1]),
                     static_cast<double>(r[2] - eye[2])};
  };
  return {relative(p), relative(q)};
}

}  // namespace

ScreenFrame fitted_frame(const LinePicture& picture, const scene::PolyScene& scene,
                         const scene::PolyCamera& camera) {
  constexpr double widest = 1.7320508075688772;  // of the image at unit focal length: 60 degrees
  ScreenFrame wide;
  wide.scale = 1;
  wide.centre = {0, 0};
  wide.high = camera.perspective ? widest : 1e9;
  wide.low = -wide.high;
  wide.near = camera.perspective ? 1e-6 : 0;
  PixelPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  PixelPoint high{-low.x, -low.y};
  for (const LinePiece& piece : picture.pieces) {
    const SeenEdge edge = seen_edge(piece.edge, scene, camera);
    const auto inside = edge.part_in(wide);
    const auto part = inside ? common_part(*inside, part_of(piece)) : std::nullopt;
    if (!part) continue;
    for (const double s : {part->low, part->high}) {
      const PixelPoint p = edge.pixel_at(s, wide);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  constexpr double last_place = 1023;
  constexpr double margin = 24;
  ScreenFrame frame;
  frame.near = wide.near;
  if (!(low.x <= high.x)) return frame;  // nothing is seen
  frame.scale = (last_place - 2 * margin) / std::max({high.x - low.x, high.y - low.y, 1e-9});
  frame.centre = {last_place / 2 - frame.scale * (low.x + high.x) / 2,
                  last_place / 2 - frame.scale * (low.y + high.y) / 2};
  return frame;
}

std::vector<ReferenceLine> reference_lines(const LinePicture& truth, const scene::PolyScene& scene,
                                           const scene::PolyCamera& camera, const ScreenFrame& frame) {
  std::vector<ReferenceLine> lines;
  const auto edges = picture::edges_of(scene);
  auto piece = truth.pieces.begin();
  for (LineId id = 0; id < edges.size(); ++id) {
    const auto first =
        std::find_if(piece, truth.pieces.end(), [&](const LinePiece& p) { return !(p.edge < edges[id]); });
    piece = std::find_if(first, truth.pieces.end(), [&](const LinePiece& p) { return p.edge != edges[id]; });
    const SeenEdge edge = seen_edge(edges[id], scene, camera);
    const auto inside = edge.part_in(frame);
    if (!inside) continue;
    ReferenceLine line{id, edge.pixels_of(*inside, frame), {{0, 1}}, {}};
    if (picture::length_of(line.image) < shortest_image) continue;
    for (auto p = first; p != piece; ++p) {
      const auto part = common_part(*inside, part_of(*p));
      if (!part) continue;
      line.visible.push_back({picture::place_on(line.image, edge.pixel_at(part->low, frame)),
                              picture::place_on(line.image, edge.pixel_at(part->high, frame))});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<DrawnPiece> drawn_pieces(const LinePicture& drawn, const scene::PolyScene& scene,
                                     const scene::PolyCamera& camera, const ScreenFrame& frame) {
  std::vector<DrawnPiece> pieces;
  const auto edges = picture::edges_of(scene);
  for (const LinePiece& piece : drawn.pieces) {
    const SeenEdge edge = seen_edge(piece.edge, scene, camera);
    const auto inside = edge.part_in(frame);
    const auto part = inside ? common_part(*inside, part_of(piece)) : std::nullopt;
    if (!part) continue;
    const auto id = std::lower_bound(edges.begin(), edges.end(), piece.edge) - edges.begin();
    pieces.push_back({static_cast<LineId>(id), edge.pixels_of(*part, frame)});
  }
  return pieces;
}

CellReference::CellReference(const std::vector<algorithms::oracle::RealLine>& lines,
                             const std::vector<algorithms::oracle::VisibleLine>& visible,
                             const geometry::Point& eye, const algorithms::oracle::Window& window) {
  const ScreenFrame frame = frame_of(window);
  struct OnScreen {
    AxisLine line;
    PixelSegment pixels;
  };
  std::vector<OnScreen> edges;
  for (const auto& line : lines) {
    const SeenEdge edge = seen_from(eye, line.from, line.to);
    const auto inside = edge.part_in(frame);
    if (!inside) continue;
    const PixelSegment pixels = edge.pixels_of(*inside, frame);
    if (picture::length_of(pixels) >= shortest_image)
      edges.push_back({line_through(line.from, line.to), pixels});
  }
  for (const OnScreen& edge : edges) reach(edge.line, edge.pixels);
  for (const OnScreen& edge : edges) {
    ReferenceLine& line = lines_[numbers_.at(edge.line)];
    line.edges.push_back(part_on(line.image, edge.pixels));
  }
  for (const auto& piece : visible) {
    const auto known = numbers_.find(line_through(piece.p, piece.q));
    if (known == numbers_.end()) continue;
    ReferenceLine& line = lines_[known->second];
    const SeenEdge edge = seen_from(eye, piece.p, piece.q);
    for (const auto& [low, high] : piece.intervals.intervals()) {
      const PixelSegment pixels = edge.pixels_of({low.to_double(), high.to_double()}, frame);
      line.visible.push_back(part_on(line.image, pixels));
    }
  }
  for (ReferenceLine& line : lines_) {
    line.edges = picture::united(std::move(line.edges));
    line.visible = picture::united(std::move(line.visible));
  }
}

void CellReference::reach(const AxisLine& line, const PixelSegment& pixels) {
  const auto [known, fresh] = numbers_.try_emplace(line, static_cast<LineId>(lines_.size()));
  if (fresh) {
    lines_.push_back({known->second, pixels, {}, {}});
    return;
  }
  PixelSegment& image = lines_[known->second].image;
  for (const PixelPoint& end : {pixels.a, pixels.b}) {
    const double place = picture::place_on(image, end);
    if (place < 0) image.a = end;
    if (place > 1) image.b = end;
  }
}

LineId CellReference::number_of(const AxisLine& line) const {
  const auto known = numbers_.find(line);
  return known == numbers_.end() ? no_line : known->second;
}

}  // namespace sightline::compare
