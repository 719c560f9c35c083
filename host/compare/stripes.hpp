// The 8080's stripes (firmware/i8080/stripes) as a method that gives the visible face at each point.
//
// The machine's picture has 255 columns and lines. The 256 of comparisons are assembled from four pictures, each
// shifted by a dot to the right or up. Left out: scenes of more faces than the machine holds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/base/result.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

inline constexpr std::string_view stripes_name = "stripes-8080";

struct StripesFaces {
  picture::PixelGrid faces;  // face number over all bodies, from 1; 0 for none
  // Pairs of parts of faces that hide each other in different places: the paper, and the program, have no order for
  // them.
  std::size_t not_solved = 0;
  std::string difference;  // how the program differs from its twin; else empty
  std::size_t faces_listed = 0;  // faces turned to the eye, which are sent to the machine
  double seconds = 0;            // on the machine, for the first of the four pictures: its list and its dots
};

// The 8080 makes stripes and priority list. The window has 256 columns and lines (precondition). The error says why
// the machine does not draw the scene.
[[nodiscard]] base::Result<StripesFaces> stripes_faces(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                       const registry::FaceWindow& window);

// The boundaries of the faces as the program draws them on the CalComp 565, in the picture's 255 columns and lines.
struct StripesPen {
  picture::PixelGrid truth;  // 256 by 256 corners of dots: stripes_pen_points() of the nearest faces
  picture::PixelGrid shown;  // where the pen was down
  picture::RasterDifference raster;
  core::TStates time{};    // of priority list and drawing
  std::string difference;  // how the program differs from its twin; else empty
};

// `nearest` has the window's columns and lines (FaceTruth::faces). Preconditions and errors as for stripes_faces.
[[nodiscard]] base::Result<StripesPen> stripes_pen(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                   const registry::FaceWindow& window, const picture::PixelGrid& nearest);

}  // namespace sightline::compare
