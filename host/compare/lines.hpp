// Line pictures on the screen in the form of the metrics (host/picture/line_metrics.hpp): the lines of the image with
// their visible parts, and the pieces that a program or algorithm drew, each on its line.
//
// Edges that coincide in the image are one line; its visible part is the union of theirs. So pictures are compared as
// sets of image points, and the visible length does not depend on how a method divides lines.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "host/algorithms/oracle/matter_scene.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "host/picture/camera_view.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

using algorithms::oracle::AxisLine;
using algorithms::oracle::MatterScene;

// The square part of the image that is shown, and its size: pixel = scale * image + centre, the image as defined by
// PolyCamera.
struct ScreenFrame {
  double scale = 512;
  picture::PixelPoint centre{512, 512};
  double low = 0;  // bounds of the square, in pixels; inclusive
  double high = 1023;
  double near = 1;  // perspective: nearer parts are not shown, in units along the camera's axis
};

// The Type 340's window on a scene of cells in Jones's program: for the oracle, and as a frame.
[[nodiscard]] algorithms::oracle::Window type340_window(std::int32_t scale = 512);
[[nodiscard]] ScreenFrame type340_frame(std::int32_t scale = 512);

// The part of the picture within 60 degrees of the camera's axis, in 1024 pixels.
[[nodiscard]] ScreenFrame fitted_frame(const picture::LinePicture& picture, const scene::PolyScene& scene,
                                       const scene::PolyCamera& camera);

// The lines of a scene's image, and their visible parts.
class ImageLines {
 public:
  // `truth` gives the visible parts; the lines are those of the edges `chosen`, or of all. Lines whose image in the
  // frame is a point are left out.
  ImageLines(const picture::LinePicture& truth, const scene::PolyScene& scene, const scene::PolyCamera& camera, const ScreenFrame& frame,
             const picture::ChosenEdges* chosen = nullptr);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // The pieces of edges of the same scene, clipped to the frame, on these lines.
  [[nodiscard]] std::vector<picture::DrawnPiece> pieces(const picture::LinePicture& drawn) const;
  // The line that an edge lies on. For an edge that is not in the scene, a number that no line has.
  [[nodiscard]] picture::LineId line_of(const picture::LineEdge& edge) const;

 private:
  const scene::PolyScene* scene_;
  scene::PolyCamera camera_;
  ScreenFrame frame_;
  std::vector<picture::LineEdge> edges_;  // ascending
  std::vector<picture::LineId> line_of_edge_;
  std::vector<picture::ReferenceLine> lines_;
};

// The line of space of each vector word of an encoded scene of cells, by address: the layout of encode.hpp.
[[nodiscard]] std::map<std::uint32_t, AxisLine> axis_lines_of_vectors(const programs::jones::EncodedScene& scene);
// The line of the image of each vector word; `lines` are those of the wires of `matter`.
[[nodiscard]] std::map<std::uint32_t, picture::LineId> lines_of_vectors(const programs::jones::EncodedScene& scene, const MatterScene& matter,
                                                                        const ImageLines& lines);

// Pieces of a mono view, in pixels, before and after rounding to points of the screen. Pieces that become a single
// point are not drawn.
[[nodiscard]] std::vector<picture::DrawnPiece> twin_pieces(const programs::jones::TwinView& view,
                                                           const std::map<std::uint32_t, picture::LineId>& lines,
                                                           int fraction_bits = programs::jones::machine_fraction_bits);
[[nodiscard]] std::vector<picture::DrawnPiece> display_pieces(const programs::jones::TwinView& view,
                                                              const std::map<std::uint32_t, picture::LineId>& lines,
                                                              int fraction_bits = programs::jones::machine_fraction_bits);

// Edges on the screen in floating point, clipped to a frame. For measuring and drawing only, never for deciding
// visibility.

class SeenEdge {
 public:
  SeenEdge(const picture::SeenPoint& from, const picture::SeenPoint& to) : from_(from), to_(to) {}
  SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera);

  // The part in the frame, in the parameter along the edge in space; empty if it has no length.
  [[nodiscard]] std::optional<picture::LinePart> part_in(const ScreenFrame& frame) const;
  [[nodiscard]] picture::PixelPoint pixel_at(double s, const ScreenFrame& frame) const;
  [[nodiscard]] picture::PixelSegment pixels_of(const picture::LinePart& part,
                                                const ScreenFrame& frame) const {
    return {pixel_at(part.low, frame), pixel_at(part.high, frame)};
  }

 private:
  [[nodiscard]] picture::SeenPoint at(double s) const;

  picture::SeenPoint from_;
  picture::SeenPoint to_;
};

}  // namespace sightline::compare
