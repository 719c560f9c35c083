// Two programs of the cross-check whose pictures are on the points of a device, each compared at bounds that follow from its
// words: Jones's on the PDP-7 on scenes of cells, and Skala's on the 8080 on functions of two variables.
//
// Jones's in every build there is: with 0 to 3 fraction bits, on the machine with the EAE and without (jones_bound.hpp).
// Its twin has the same display words; its lines are those with more fraction bits, of longer words, before the pieces are
// put on points. Skala's three pictures on its four devices (skala_8080.hpp). A program on its machine is its twin word for
// word and dot for dot, or has no picture here.
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

// What one build of Jones's program shows of a view. Points of the Type 340.
struct JonesPicture {
  JonesWords words;
  std::vector<core::Word18> display_file;      // empty of words the machine has not
  std::vector<picture::PixelSegment> lines;    // between points; those of longer words not rounded; empty: the machine's
  double bound = 0;                            // of the lines from the exact ones, and of those from the lines
  std::vector<picture::PixelSegment> flashes;  // of one pass, each a segment of no length; of the machine
  double flash_bound = 0;
};

// By fraction bits. The scene has cells (precondition). Errors: the program is not its twin, or does not complete the view.
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

// No line of any build is farther from the other picture's, as far as the screen shows them, than its words explain; nor a flash
// from those of the first of the registry.
[[nodiscard]] ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedJones& a,
                                           const NamedLines& b);
// Builds with the same fraction bits have the same display file.
[[nodiscard]] ViewVerdict compare_pictures(const NamedJones& a, const NamedJones& b);

// The boards' dots are the column oracle's; the ink of lines is near what is seen of the unrounded lines, and these near ink;
// that of contours is near contours, margins and outline; the border of a shaded surface is near lines, and all lines are in the
// surface.
[[nodiscard]] ViewVerdict compare_with_oracle(const CommonScene& scene, const NamedInk& a);
// The ink of lines, and the border of a surface, are near the lines that the native algorithm draws, and these near ink.
[[nodiscard]] ViewVerdict compare_with_native(const CommonScene& scene, const NamedInk& a);

// The view of a height scene as the program on the 8080 has it.
[[nodiscard]] algorithms::skala::View program_view(const CommonScene& scene);

}  // namespace sightline::compare
