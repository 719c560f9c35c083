// What Montani and Re leave to a future paper or to the reader: antialiasing by the sides of stripes, overwriting against
// differences, and faces without relations at the end of the priority list. On the 8080, and natively.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A picture of 255 by 255 dots in the eight levels of the board. An error is the difference from the level that the exact regions
// of the faces give the dot, as a share of white; the means are over the dots that show more than one level in exact mixture.
struct GreyScene {
  std::string scene;
  std::size_t faces = 0;       // turned to the eye
  std::size_t mixed_dots = 0;  // that show more than one level
  double plain_error = 0;      // of the 8080, without antialiasing
  double greys_error = 0;      // with it
  double native_error = 0;     // draw montani-re --antialias in the same levels, stripes of a dot
  double thin_error = 0;       // the same, stripes of a quarter of a dot
  double least_error = 0;      // of the exact mixture in eight levels
  double plain_greatest = 0;
  double greys_greatest = 0;
  std::int64_t plain_t = 0;  // T-states of drawing
  std::int64_t greys_t = 0;
  Picture greys;
};

struct OverwritingScene {
  std::string scene;
  std::size_t faces = 0;
  std::uint64_t dots = 0;                // shown
  std::uint64_t overwriting_dots = 0;    // written
  std::uint64_t difference_commands = 0;
  std::uint64_t overwriting_commands = 0;
  double difference_s = 0;  // drawing
  double overwriting_s = 0;
};

struct IsolatedScene {
  std::string scene;
  std::size_t faces = 0;
  std::size_t isolated = 0;  // faces that neither hide nor are hidden when they enter the list
  double back_s = 0;         // drawing on the board, these faces in the back list
  double front_s = 0;
  double back_plotter_s = 0;   // computing for the plotter, without its movements
  double front_plotter_s = 0;
};

struct MontaniReGreys {
  std::vector<GreyScene> greys;
  std::vector<OverwritingScene> overwriting;
  std::vector<IsolatedScene> isolated;
  std::size_t program_bytes = 0;  // with antialiasing
};

[[nodiscard]] MontaniReGreys montani_re_greys(const Context& context);

class Page;
void montani_re_greys_chapter(Page& page, const MontaniReGreys& measured);

}  // namespace sightline::report
