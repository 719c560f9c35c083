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
using picture::LineEdge;
using picture::LineId;
using picture::LinePart;
using picture::LinePicture;
using picture::LinePiece;
using picture::PixelPoint;
using picture::PixelSegment;
using picture::ReferenceLine;
using picture::SeenPoint;

constexpr double shortest_image = 1e-6;  // pixels; shorter images are no lines
constexpr LineId no_line = std::numeric_limits<LineId>::max();

SeenEdge seen_edge(const LineEdge& edge, const scene::PolyScene& scene, const scene::PolyCamera& camera) {
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

constexpr double mono_window_centre = 512;  // the centre of the single window of a mono view

// Two's complement of 18 bits.
std::int32_t number_in(std::uint32_t word) {
  return word & 0400000 ? static_cast<std::int32_t>(word) - (1 << 18) : static_cast<std::int32_t>(word);
}

class VectorWalk {
 public:
  explicit VectorWalk(const programs::jones::EncodedScene& scene) : scene_(scene) {}

  // `at`: the address of X, followed by Y Z n and the vectors.
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

  const programs::jones::EncodedScene& scene_;
  std::map<std::uint32_t, AxisLine> lines_;
};

programs::jones::ShortWords words_of(int fraction_bits) {
  return programs::jones::ShortWords(programs::jones::machine_word_bits, fraction_bits);
}

template <class ToPixel>
std::vector<DrawnPiece> pieces_of(const programs::jones::TwinView& view, const std::map<std::uint32_t, LineId>& lines, ToPixel&& pixel) {
  std::vector<DrawnPiece> pieces;
  for (const auto& piece : view.pieces) {
    const PixelSegment image{{pixel(piece.line.a.x), pixel(piece.line.a.y)}, {pixel(piece.line.b.x), pixel(piece.line.b.y)}};
    if (image.a.x == image.b.x && image.a.y == image.b.y) continue;
    pieces.push_back({lines.at(piece.vector_address), image});
  }
  return pieces;
}

}  // namespace

algorithms::oracle::Window type340_window(std::int32_t scale) {
  algorithms::oracle::Window window;
  window.scale = scale;
  window.near = programs::jones::near_z;
  return window;
}

ScreenFrame type340_frame(std::int32_t scale) {
  ScreenFrame frame;
  frame.scale = scale;
  frame.near = programs::jones::near_z;
  return frame;
}

ScreenFrame fitted_frame(const LinePicture& picture, const scene::PolyScene& scene,
                         const scene::PolyCamera& camera) {
  constexpr double widest = 1.7320508075688772;  // tangent of 60 degrees: the image at unit focal length
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
  if (!(low.x <= high.x)) return frame;  // nothing is visible
  frame.scale = (last_place - 2 * margin) / std::max({high.x - low.x, high.y - low.y, 1e-9});
  frame.centre = {last_place / 2 - frame.scale * (low.x + high.x) / 2,
                  last_place / 2 - frame.scale * (low.y + high.y) / 2};
  return frame;
}

ImageLines::ImageLines(const LinePicture& truth, const scene::PolyScene& scene, const scene::PolyCamera& camera, const ScreenFrame& frame,
                       const picture::ChosenEdges* chosen)
    : scene_(&scene), camera_(camera), frame_(frame), edges_(picture::edges_of(scene)) {
  std::map<std::array<std::int64_t, 4>, LineId> known;
  LineId next = 0;
  for (const LineEdge& edge : edges_) {
    const auto plane = picture::in_lowest_terms(picture::image_plane(edge, scene, camera));
    // An edge whose image is a point is a separate line, which is never used.
    if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0) {
      line_of_edge_.push_back(next++);
      continue;
    }
    const auto [line, is_new] = known.try_emplace(plane, next);
    if (is_new) ++next;
    line_of_edge_.push_back(line->second);
  }

  struct OnScreen {
    LineId line = 0;
    PixelSegment pixels;
  };
  std::vector<OnScreen> images;
  for (const LineEdge& edge : chosen != nullptr ? chosen->edges : edges_) {
    const SeenEdge seen = seen_edge(edge, scene, camera);
    const auto inside = seen.part_in(frame);
    if (!inside) continue;
    const PixelSegment pixels = seen.pixels_of(*inside, frame);
    if (picture::length_of(pixels) >= shortest_image) images.push_back({line_of(edge), pixels});
  }
  std::vector<DrawnPiece> visible = pieces(truth);

  // The longest image of a line gives the direction, and all of its images the ends.
  std::map<LineId, PixelSegment> longest;
  for (const OnScreen& image : images) {
    const auto [line, is_new] = longest.try_emplace(image.line, image.pixels);
    if (!is_new && picture::length_of(line->second) < picture::length_of(image.pixels)) line->second = image.pixels;
  }
  std::map<LineId, LinePart> extent;
  for (const OnScreen& image : images) {
    LinePart& reach = extent.try_emplace(image.line, LinePart{0, 1}).first->second;
    for (const PixelPoint& end : {image.pixels.a, image.pixels.b}) {
      const double place = picture::place_on(longest.at(image.line), end);
      reach = {std::min(reach.low, place), std::max(reach.high, place)};
    }
  }
  std::map<LineId, std::size_t> place;
  for (const auto& [line, reach] : extent) {
    const PixelSegment& along = longest.at(line);
    place[line] = lines_.size();
    lines_.push_back({line, {picture::point_at(along, reach.low), picture::point_at(along, reach.high)}, {}, {}});
  }
  for (const OnScreen& image : images) {
    ReferenceLine& line = lines_[place.at(image.line)];
    line.edges.push_back(part_on(line.image, image.pixels));
  }
  for (const DrawnPiece& piece : visible) {
    const auto found = place.find(piece.line);
    if (found == place.end()) continue;
    ReferenceLine& line = lines_[found->second];
    line.visible.push_back(part_on(line.image, piece.image));
  }
  for (ReferenceLine& line : lines_) {
    line.edges = picture::united(std::move(line.edges));
    line.visible = picture::united(std::move(line.visible));
  }
}

LineId ImageLines::line_of(const LineEdge& edge) const {
  const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
  return found != edges_.end() && *found == edge ? line_of_edge_[static_cast<std::size_t>(found - edges_.begin())] : no_line;
}

std::vector<DrawnPiece> ImageLines::pieces(const LinePicture& drawn) const {
  std::vector<DrawnPiece> pieces;
  for (const LinePiece& piece : drawn.pieces) {
    const SeenEdge edge = seen_edge(piece.edge, *scene_, camera_);
    const auto inside = edge.part_in(frame_);
    const auto part = inside ? common_part(*inside, part_of(piece)) : std::nullopt;
    if (part) pieces.push_back({line_of(piece.edge), edge.pixels_of(*part, frame_)});
  }
  return pieces;
}

// Assigns pieces of Jones's program to lines of the scene: the line of a vector word in core, and the piece's
// position on the screen. See lines.hpp.

std::map<std::uint32_t, AxisLine> axis_lines_of_vectors(const programs::jones::EncodedScene& scene) {
  VectorWalk walk(scene);
  for (const std::uint32_t cell : scene.cell_addresses) walk.walk(cell);
  for (const std::uint32_t opening : scene.opening_addresses) walk.walk(opening + 2);
  return std::move(walk).take();
}

std::map<std::uint32_t, LineId> lines_of_vectors(const programs::jones::EncodedScene& scene, const MatterScene& matter,
                                                 const ImageLines& lines) {
  std::map<std::uint32_t, LineId> result;
  for (const auto& [address, line] : axis_lines_of_vectors(scene)) {
    const auto wire = matter.wire_on(line);
    result[address] = wire ? lines.line_of(*wire) : no_line;
  }
  return result;
}

std::vector<DrawnPiece> twin_pieces(const programs::jones::TwinView& view, const std::map<std::uint32_t, LineId>& lines, int fraction_bits) {
  return pieces_of(view, lines, [number = words_of(fraction_bits)](std::int32_t at) { return number.points(at) + mono_window_centre; });
}

std::vector<DrawnPiece> display_pieces(const programs::jones::TwinView& view, const std::map<std::uint32_t, LineId>& lines, int fraction_bits) {
  return pieces_of(view, lines, [number = words_of(fraction_bits)](std::int32_t at) { return number.point(at) + mono_window_centre; });
}

SeenEdge::SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera) {
  const picture::CameraView view(camera);
  from_ = view.at(from);
  to_ = view.at(to);
}

SeenPoint SeenEdge::at(double s) const {
  SeenPoint point{};
  for (std::size_t a = 0; a < 3; ++a) point[a] = from_[a] * (1 - s) + to_[a] * s;
  return point;
}

std::optional<picture::LinePart> SeenEdge::part_in(const ScreenFrame& frame) const {
  picture::LinePart part{0, 1};
  // Restricts the part to where a quantity that is linear along the edge is not negative.
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

}  // namespace sightline::compare
