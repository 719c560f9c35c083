// Edges on the screen in floating point, cut to a frame: for measuring and drawing only, never for deciding
// what is visible.
#pragma once

#include <array>
#include <optional>

#include "host/compare/lines.hpp"

namespace sightline::compare {

// A point as the camera has it: right, up and forward in units of the scene; an orthographic image has 1 for
// a depth.
using SeenPoint = std::array<double, 3>;

class SeenEdge {
 public:
  SeenEdge(const SeenPoint& from, const SeenPoint& to) : from_(from), to_(to) {}
  SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera);

  // The part in the frame, in the parameter along the edge in space; nothing if it has no length.
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

}  // namespace sightline::compare
