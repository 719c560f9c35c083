// Jones's program in various arithmetics, from six eyes per scene, and the errors of its pictures.
//
// On the emulated PDP-7: 0 to 3 fraction bits, rounding or truncating, with and without the EAE, no display on the
// machine. In C++: the same search in words of other lengths and in floating point.
#pragma once

#include <cstddef>
#include <string>
#include <memory>
#include <vector>

#include "host/compare/lines.hpp"
#include "host/compare/jones_precision/precision.hpp"
#include "host/compare/jones_precision/study.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::report {

// Over the views of a scene. Lengths are sums, in pixels of the 1024 raster.
struct PictureError {
  double visible = 0;
  double missing = 0;
  double extra = 0;
  double extra_far = 0;  // farther than a pixel from everything visible
  double hausdorff = 0;  // the greatest of all views; infinite if one shows nothing
  picture::Rate wrong_visibility;
  std::size_t incomplete = 0;  // views that ended with another status

  // L_sym, in per cent of the visible length.
  [[nodiscard]] double symmetric_per_cent() const { return visible > 0 ? 100 * (missing + extra) / visible : 0; }
};

// The six views of a scene, with the visible lines of each.
class SceneViews {
 public:
  // Throws base::Error (bad_input): the scene is beyond the limits of the oracle or of the machine's core.
  explicit SceneViews(const compare::jones_precision::SixViews& views);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const scene::CellScene& scene() const { return scene_; }
  [[nodiscard]] std::size_t size() const { return views_.size(); }
  [[nodiscard]] const geometry::Point& eye(std::size_t view) const { return views_[view].eye; }
  [[nodiscard]] const compare::jones_precision::SceneInCore& in_core(std::size_t view) const { return views_[view].in_core; }

  // `image` in points of the screen.
  [[nodiscard]] picture::DrawnPiece piece(std::size_t view, const compare::jones_precision::SceneLine& line,
                                          const algorithms::oracle::ScreenSegment& image) const;
  void add(PictureError& error, std::size_t view, programs::jones::Status status,
           const std::vector<picture::DrawnPiece>& drawn) const;

 private:
  struct View {
    geometry::Point eye{};
    compare::jones_precision::SceneInCore in_core;
    compare::ImageLines reference;
  };

  std::string name_;
  scene::CellScene scene_;
  std::unique_ptr<const compare::MatterScene> matter_;
  std::vector<View> views_;
};

// A build of the program on the machine. Times are means per view.
struct MachineBuild {
  compare::jones_precision::Precision precision;
  PictureError clipped;    // of pieces after clipping, with their fraction of a point
  PictureError displayed;  // of the same pieces between points of the display
  double eae_s = 0;
  double plain_s = 0;  // without the EAE; the pieces are the same
};

// Throws base::Error: differs, if the builds with and without the EAE draw different pieces; program_failed.
[[nodiscard]] MachineBuild measure_build(const SceneViews& views, const compare::jones_precision::Precision& precision);

// In C++.
[[nodiscard]] compare::jones_precision::PreciseView run_twin(const SceneViews& views, std::size_t view,
                                                  const compare::jones_precision::Precision& precision);
[[nodiscard]] PictureError measure_twin(const SceneViews& views, const compare::jones_precision::Precision& precision);

}  // namespace sightline::report
