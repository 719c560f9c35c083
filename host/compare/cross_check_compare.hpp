// Compares two pictures of one view: lines piece by piece or as images, faces pixel by pixel, and lines with faces:
// there is a line where the face changes, and the face changes at an isolated line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/compare/cross_check_scenes.hpp"
#include "host/compare/turning.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::compare {

// The distance of a machine's picture from another one, in points of its device, and the bound that follows from its
// words.
struct MachineDistance {
  std::string what;  // the build, or picture and device; and which lines are measured from which
  double found = 0;
  double bound = 0;
};

// The result in words; of a difference, the first place.
struct ViewVerdict {
  bool agrees = false;
  std::string_view how;  // "pieces", "image", "pixels", "lines on pixels", "points", "words"
  std::string text;
  std::vector<MachineDistance> distances = {};  // of "points" of Jones's and Skala's programs
};

struct NamedLines {
  std::string_view name;
  const picture::LinePicture* lines = nullptr;
  bool same_by_image = false;  // as registry::LineAlgorithm has it
};

struct NamedFaces {
  std::string_view name;
  const picture::PixelGrid* faces = nullptr;  // number + 1, 0 for none
};

// What a machine's display shows of a view.
struct ScreenPicture {
  TurnPicture turn;
  std::vector<picture::PixelSegment> in_view;  // its lines in pixels of the view
  double bound_in_view = 0;                    // of those, in pixels: TurnPicture::view_bound
};

struct NamedScreen {
  std::string_view name;
  const ScreenPicture* screen = nullptr;
};

// Lines drawn at the angle of the machine.
struct NamedScreenLines {
  NamedLines named;
  const std::vector<picture::PixelSegment>* on_screen = nullptr;  // in points of the display
};

[[nodiscard]] ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view,
                                           const NamedLines& a, const NamedLines& b);
// They agree if the structure in the machine's core is that of the pieces, end by end (where pieces are compared), and
// no line is farther from the other picture than the machine's words explain.
[[nodiscard]] ViewVerdict compare_pictures(const NamedScreen& a, const NamedScreenLines& b);
// They agree if they are equal away from all edges.
[[nodiscard]] ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view,
                                           const NamedFaces& a, const NamedFaces& b);
// They agree if lines and changes of face match within one pixel. A line is isolated if no other one is within two
// pixels: between two closer lines there may be no pixel.
[[nodiscard]] ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view,
                                           const NamedLines& a, const NamedFaces& b);
// The same, within one pixel plus the bound of the display's lines.
[[nodiscard]] ViewVerdict compare_pictures(const NamedScreen& a, const NamedFaces& b);

}  // namespace sightline::compare
