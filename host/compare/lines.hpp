// Converts every kind of line picture for the metrics (host/picture/line_metrics.hpp): lines of the scene on
// the screen with what is seen of them, and the pieces a program or algorithm drew.
//
// Exact pictures of polyhedra: a line is an edge of the scene, in the order of picture::edges_of. Pictures of
// cell scenes by guest and twin: a line is everything on one axis-parallel line of space, because cells, and
// with them vector words, divide lines where the scene does not.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/guests/jones/encode.hpp"
#include "host/guests/jones/twin/twin.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// The square part of the image that is looked at, and its size: pixel = scale * image + centre, the image as
// PolyCamera defines it.
struct ScreenFrame {
  double scale = 512;
  picture::PixelPoint centre{512, 512};
  double low = 0;  // of the square, in pixels; its ends are in it
  double high = 1023;
  double near = 1;  // perspective: nothing nearer is shown, in units along the camera's axis
};

// All of the picture that is within 60 degrees of the camera's axis, in 1024 pixels.
[[nodiscard]] ScreenFrame fitted_frame(const picture::LinePicture& picture, const scene::PolyScene& scene,
                                       const scene::PolyCamera& camera);

// The parts of the scene's edges in the frame; edges whose image is a point are left out.
[[nodiscard]] std::vector<picture::ReferenceLine> reference_lines(const picture::LinePicture& truth,
                                                                  const scene::PolyScene& scene,
                                                                  const scene::PolyCamera& camera,
                                                                  const ScreenFrame& frame);
[[nodiscard]] std::vector<picture::DrawnPiece> drawn_pieces(const picture::LinePicture& drawn,
                                                            const scene::PolyScene& scene,
                                                            const scene::PolyCamera& camera,
                                                            const ScreenFrame& frame);

// A line of space parallel to an axis.
struct AxisLine {
  std::size_t axis = 0;
  std::array<std::int32_t, 2> cross{};  // on other_axes(axis)

  friend auto operator<=>(const AxisLine&, const AxisLine&) = default;
};

// The lines of a cell scene as one eye sees them.
class CellReference {
 public:
  // `visible` is the oracle's answer for these lines, this eye and this window, which is a square.
  CellReference(const std::vector<algorithms::oracle::RealLine>& lines,
                const std::vector<algorithms::oracle::VisibleLine>& visible, const geometry::Point& eye,
                const algorithms::oracle::Window& window);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // Lines that are not in the scene, or not in the window, get a number of their own that no reference line
  // has.
  [[nodiscard]] picture::LineId number_of(const AxisLine& line) const;

 private:
  // The line's image reaches to these pixels.
  void reach(const AxisLine& line, const picture::PixelSegment& pixels);

  std::map<AxisLine, picture::LineId> numbers_;
  std::vector<picture::ReferenceLine> lines_;
};

// Which line of space each vector word of an encoded scene is on, by address: the layout of encode.hpp.
[[nodiscard]] std::map<std::uint32_t, AxisLine> lines_of_vectors(const guests::jones::EncodedScene& scene);

// Pieces of a mono view, in pixels, before and after the rounding to points of the screen; those that become
// a single point then are not drawn.
[[nodiscard]] std::vector<picture::DrawnPiece> twin_pieces(const guests::jones::View& view,
                                                           const std::map<std::uint32_t, AxisLine>& vectors,
                                                           const CellReference& reference);
[[nodiscard]] std::vector<picture::DrawnPiece> display_pieces(
    const guests::jones::View& view, const std::map<std::uint32_t, AxisLine>& vectors,
    const CellReference& reference);

// Edges on the screen in floating point, cut to a frame: for measuring and drawing only, never for deciding
// what is visible.

// A point as the camera has it: right, up and forward in units of the scene; an orthographic image has 1 for
// a depth.
using SeenPoint = std::array<double, 3>;

class SeenEdge {
 public:
  SeenEdge(const SeenPoint& from, const SeenPoint& to) : from_(from), to_(to) {}
  SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera);

  // The part in the frame, in the parameter along the edge in space; empty if it has no length.
  [[nodiscard]] std::optional<picture::LinePart> part_in(const ScreenFrame& frame) const;
  [[nodiscard]] picture::PixelPoint pixel_at(double s, const ScreenFrame& frame) const;
  [[nodiscard]] picture::PixelSegment pixels_of(const picture::LinePart& part,
                                                const ScreenFrame& frame) const {
    return {pixel_at(part.low, frame), pixel_at(part.high, frame)};
  }

 private:
  [[nodiscard]] SeenPoint at(double s) const;

  SeenPoint from_;
  SeenPoint to_;
};

// Lines of a scene that lie on each other in the image taken as one: the reference for algorithms that draw
// the nearest of them only (LineAlgorithm::same_by_image), whose pictures are right as sets of points.
class ImageLines {
 public:
  // `lines` are those of reference_lines (lines.hpp) for this scene and camera.
  ImageLines(const std::vector<picture::ReferenceLine>& lines, const scene::PolyScene& scene,
             const scene::PolyCamera& camera);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // Pieces of edges as pieces of these lines.
  [[nodiscard]] std::vector<picture::DrawnPiece> pieces(std::vector<picture::DrawnPiece> of_edges) const;

 private:
  std::vector<picture::LineId> line_of_edge_;
  std::vector<picture::ReferenceLine> lines_;
};

}  // namespace sightline::compare
