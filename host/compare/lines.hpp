// Line pictures on the screen, as the metrics want them (host/picture/line_metrics.hpp): lines of the image with what is truly seen of
// them, and the pieces that a program or algorithm drew, each on its line.
//
// A line is a line of the image: edges that lie on each other there are one line, and what is seen of it is the union of what is seen of
// them. So pictures are compared as sets of image points, and the length of what is seen does not depend on how a method divides it.
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

// The square part of the image that is looked at, and its size: pixel = scale * image + centre, the image as
// PolyCamera defines it.
struct ScreenFrame {
  double scale = 512;
  picture::PixelPoint centre{512, 512};
  double low = 0;  // of the square, in pixels; its ends are in it
  double high = 1023;
  double near = 1;  // perspective: nothing nearer is shown, in units along the camera's axis
};

// What the Type 340 shows of a scene of cells by Jones's program: for the oracle, and as a frame.
[[nodiscard]] algorithms::oracle::Window type340_window(std::int32_t scale = 512);
[[nodiscard]] ScreenFrame type340_frame(std::int32_t scale = 512);

// All of the picture that is within 60 degrees of the camera's axis, in 1024 pixels.
[[nodiscard]] ScreenFrame fitted_frame(const picture::LinePicture& picture, const scene::PolyScene& scene,
                                       const scene::PolyCamera& camera);

// The lines of a scene's image, and what is seen of them.
class ImageLines {
 public:
  // `truth` is what is seen; the lines are those of the edges `chosen`, or of all. Lines whose image in the frame is a point are left out.
  ImageLines(const picture::LinePicture& truth, const scene::PolyScene& scene, const scene::PolyCamera& camera, const ScreenFrame& frame,
             const picture::ChosenEdges* chosen = nullptr);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // Pieces of edges of the same scene, cut to the frame, on these lines.
  [[nodiscard]] std::vector<picture::DrawnPiece> pieces(const picture::LinePicture& drawn) const;
  // The line that an edge lies on; one that no reference line has for an edge that is none of the scene.
  [[nodiscard]] picture::LineId line_of(const picture::LineEdge& edge) const;

 private:
  const scene::PolyScene* scene_;
  scene::PolyCamera camera_;
  ScreenFrame frame_;
  std::vector<picture::LineEdge> edges_;  // ascending
  std::vector<picture::LineId> line_of_edge_;
  std::vector<picture::ReferenceLine> lines_;
};

// Which line of space each vector word of an encoded scene of cells is on, by address: the layout of encode.hpp.
[[nodiscard]] std::map<std::uint32_t, AxisLine> axis_lines_of_vectors(const programs::jones::EncodedScene& scene);
// And which line of the image; `lines` are of the wires of `matter`.
[[nodiscard]] std::map<std::uint32_t, picture::LineId> lines_of_vectors(const programs::jones::EncodedScene& scene, const MatterScene& matter,
                                                                        const ImageLines& lines);

// Pieces of a mono view, in pixels, before and after the rounding to points of the screen; those that become a single point then are
// not drawn.
[[nodiscard]] std::vector<picture::DrawnPiece> twin_pieces(const programs::jones::TwinView& view,
                                                           const std::map<std::uint32_t, picture::LineId>& lines,
                                                           int fraction_bits = programs::jones::machine_fraction_bits);
[[nodiscard]] std::vector<picture::DrawnPiece> display_pieces(const programs::jones::TwinView& view,
                                                              const std::map<std::uint32_t, picture::LineId>& lines,
                                                              int fraction_bits = programs::jones::machine_fraction_bits);

// Edges on the screen in floating point, cut to a frame: for measuring and drawing only, never for deciding
// what is visible.

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
