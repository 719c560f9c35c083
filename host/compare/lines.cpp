// See lines.hpp.
#include "host/compare/lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/picture/line_picture_image.hpp"

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

// Pieces of Jones's program as pieces of the scene's lines: which line a vector word of core is on, and where
// on the screen a piece lies. See lines.hpp.

namespace {

using picture::DrawnPiece;

constexpr double screen_centre = 512;  // of the one window of a mono view

// Two's complement of 18 bits.
std::int32_t number_in(std::uint32_t word) {
  return word & 0400000 ? static_cast<std::int32_t>(word) - (1 << 18) : static_cast<std::int32_t>(word);
}

class VectorWalk {
 public:
  explicit VectorWalk(const guests::jones::EncodedScene& scene) : scene_(scene) {}

  // `at`: the address of X, which Y Z n and the vectors follow.
  void walk(std::uint32_t at) {
    geometry::Point pen{number(at), number(at + 1), number(at + 2)};
    const std::int32_t vectors = number(at + 3);
    for (std::int32_t i = 0; i < vectors; ++i) {
      const std::uint32_t address = at + 4 + static_cast<std::uint32_t>(i);
      const std::uint32_t word = scene_.words[address - scene_.base].value;
      const std::size_t axis = (word >> 15 & 3U) - 1;
      const auto [u, v] = geometry::other_axes(axis);
      lines_[address] = AxisLine{axis, {pen[u], pen[v]}};
      const auto magnitude = static_cast<std::int32_t>(word & 0077777);
      pen[axis] += magnitude >= 1 << 14 ? magnitude - (1 << 15) : magnitude;
    }
  }
  [[nodiscard]] std::map<std::uint32_t, AxisLine> take() && { return std::move(lines_); }

 private:
  [[nodiscard]] std::int32_t number(std::uint32_t address) const {
    return number_in(scene_.words[address - scene_.base].value);
  }

  const guests::jones::EncodedScene& scene_;
  std::map<std::uint32_t, AxisLine> lines_;
};

template <class ToPixel>
std::vector<DrawnPiece> pieces_of(const guests::jones::View& view,
                                  const std::map<std::uint32_t, AxisLine>& vectors,
                                  const CellReference& reference, ToPixel&& pixel) {
  std::vector<DrawnPiece> pieces;
  for (const auto& piece : view.pieces) {
    const picture::PixelSegment image{{pixel(piece.line.a.x), pixel(piece.line.a.y)},
                                      {pixel(piece.line.b.x), pixel(piece.line.b.y)}};
    if (image.a.x == image.b.x && image.a.y == image.b.y) continue;
    pieces.push_back({reference.number_of(vectors.at(piece.vector_address)), image});
  }
  return pieces;
}

}  // namespace

std::map<std::uint32_t, AxisLine> lines_of_vectors(const guests::jones::EncodedScene& scene) {
  VectorWalk walk(scene);
  for (const std::uint32_t cell : scene.cell_addresses) walk.walk(cell);
  for (const std::uint32_t opening : scene.opening_addresses) walk.walk(opening + 2);
  return std::move(walk).take();
}

std::vector<DrawnPiece> twin_pieces(const guests::jones::View& view,
                                    const std::map<std::uint32_t, AxisLine>& vectors,
                                    const CellReference& reference) {
  return pieces_of(view, vectors, reference, [number = guests::jones::ShortWords()](std::int32_t at) {
    return number.points(at) + screen_centre;
  });
}

std::vector<DrawnPiece> display_pieces(const guests::jones::View& view,
                                       const std::map<std::uint32_t, AxisLine>& vectors,
                                       const CellReference& reference) {
  return pieces_of(view, vectors, reference,
                   [number = guests::jones::ShortWords()](std::int32_t at) { return number.point(at) + screen_centre; });
}

namespace {

SeenPoint seen(const scene::PolyPoint& vertex, const scene::PolyCamera& camera) {
  const geometry::Vector3 p = geometry::difference(vertex, camera.eye);
  const auto along = [&](const scene::PolyPoint& axis) {
    const geometry::Vector3 a = geometry::vector_of(axis);
    return static_cast<double>(geometry::dot(a, p)) / std::sqrt(static_cast<double>(geometry::dot(a, a)));
  };
  return {along(camera.right), along(camera.up), camera.perspective ? along(camera.forward) : 1};
}

}  // namespace

SeenEdge::SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera)
    : from_(seen(from, camera)), to_(seen(to, camera)) {}

SeenPoint SeenEdge::at(double s) const {
  SeenPoint point{};
  for (std::size_t a = 0; a < 3; ++a) point[a] = from_[a] * (1 - s) + to_[a] * s;
  return point;
}

std::optional<picture::LinePart> SeenEdge::part_in(const ScreenFrame& frame) const {
  picture::LinePart part{0, 1};
  // Keeps where a quantity that is linear along the edge is not negative.
  const auto keep = [&](double at_from, double at_to) {
    if (at_from < 0 && at_to < 0) {
      part = {1, 0};
    } else if (at_from < 0) {
      part.low = std::max(part.low, at_from / (at_from - at_to));
    } else if (at_to < 0) {
      part.high = std::min(part.high, at_from / (at_from - at_to));
    }
  };
  if (frame.near > 0) keep(from_[2] - frame.near, to_[2] - frame.near);
  for (std::size_t a = 0; a < 2; ++a) {
    const double centre = a == 0 ? frame.centre.x : frame.centre.y;
    const auto above = [&](const SeenPoint& p) { return frame.scale * p[a] - (frame.low - centre) * p[2]; };
    const auto below = [&](const SeenPoint& p) { return (frame.high - centre) * p[2] - frame.scale * p[a]; };
    keep(above(from_), above(to_));
    keep(below(from_), below(to_));
  }
  if (!(part.low < part.high)) return std::nullopt;
  return part;
}

picture::PixelPoint SeenEdge::pixel_at(double s, const ScreenFrame& frame) const {
  const SeenPoint point = at(s);
  return {frame.scale * point[0] / point[2] + frame.centre.x,
          frame.scale * point[1] / point[2] + frame.centre.y};
}

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
