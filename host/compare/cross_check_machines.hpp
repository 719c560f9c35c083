// Two programs of the cross-check draw on the points of a device: Jones's on the PDP-7, for scenes of cells, and
// Skala's on the 8080, for functions of two variables. Each is compared within bounds that follow from its words.
//
// All builds of Jones's program take part: with 0 to 3 fraction bits, on the machine with and without the EAE
// (jones_bound.hpp). Its twin has the same display words; its lines have more fraction bits and longer words and are
// not rounded to points. Skala's program draws three pictures on four devices (skala_8080.hpp). A program must equal
// its twin, word for word or dot for dot; otherwise it has no picture here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/base/result.hpp"
#include "host/compare/cross_check_compare.hpp"
#include "host/compare/cross_check_scenes.hpp"
#include "host/compare/jones_bound.hpp"
#include "host/compare/scenes.hpp"
#include "host/compare/skala_8080.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::compare {

inline constexpr std::string_view jones_no_eae_name = "jones-pdp7-no-eae";

// The picture that one build of Jones's program shows of a view, in points of the Type 340.
struct JonesPicture {
  JonesWords words;
  std::vector<core::Word18> display_file;      // empty for word lengths that the machine does not have
  std::vector<picture::PixelSegment> lines;    // between points; those of longer words not rounded; empty: the machine's
  double bound = 0;                            // of the distance between these lines and the exact ones, both ways
  std::vector<picture::PixelSegment> flashes;  // of one pass on the machine, each a segment of length 0
  double flash_bound = 0;
};

// By fraction bits. The scene has cells (precondition). Errors: the program differs from its twin, or does not
// complete the view.
[[nodiscard]] base::Result<std::vector<JonesPicture>> jones_on_pdp7(const CommonScene& scene, const CrossCheckView& view,
                                                                    bool eae);
[[nodiscard]] base::Result<std::vector<JonesPicture>> jones_twins(const CommonScene& scene, const CrossCheckView& view);

struct NamedJones {
  std::string_view name;
  const std::vector<JonesPicture>* builds = nullptr;
};
struct NamedInk {
  std::string_view name;
  const std::vector<SkalaInk>* pictures = nullptr;
};

// No line of any build is farther from the other picture's visible lines on the screen than its words explain.
// Flashes are compared with the first line algorithm of the registry only.
[[nodiscard]] ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedJones& a,
                                           const NamedLines& b);
// Builds with the same fraction bits must have the same display file.
[[nodiscard]] ViewVerdict compare_pictures(const NamedJones& a, const NamedJones& b);

// The boards' dots must equal the column oracle's. The ink of lines must be near the visible parts of the unrounded
// lines, and vice versa; the ink of contours near contours, margins and outline; the border of a shaded surface near
// lines, and all lines in the surface.
[[nodiscard]] ViewVerdict compare_with_oracle(const CommonScene& scene, const NamedInk& a);
// The ink of lines and the border of a surface must be near the lines that the native algorithm draws, and vice
// versa.
[[nodiscard]] ViewVerdict compare_with_native(const CommonScene& scene, const NamedInk& a);

// The view of a height scene in the form of the program on the 8080.
[[nodiscard]] algorithms::skala::View program_view(const CommonScene& scene);

}  // namespace sightline::compare
