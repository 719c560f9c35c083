// Jones's program in every arithmetic, from six eyes a scene: how wrong and how long.
//
// On the emulated PDP-7: 0 to 3 fraction bits, rounding or cutting off, with the EAE and without, no display
// on the machine. In C++, the same search in words of other lengths, in floating point, and exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/guests/jones/precision/precision.hpp"
#include "host/report/report.hpp"
#include "host/report/speed_error/views.hpp"

namespace sightline::harness::report {

// A build of the program on the machine. Times are means of a view.
struct MachineBuild {
  guests::jones::Precision precision;
  PictureError clipped;    // pieces as they left the clip, with their fraction of a point
  PictureError displayed;  // the same between the whole points of the display
  double eae_s = 0;
  double plain_s = 0;  // without the EAE; the pieces are the same
};

struct Twin {
  guests::jones::Precision precision;
  PictureError error;
  std::optional<double> view_ns;  // a view, mean of six
};

// An algorithm whose picture is that of the edge oracle, piece for piece: its error is 0.
struct ExactProgram {
  std::string name;
  std::optional<double> view_ns;
};

struct JonesMeasured {
  std::string scene;
  std::vector<MachineBuild> machine;  // round f = 0..3, cut off f = 0..3
  std::vector<Twin> fractions;        // words of 36 bits, f = 0..8, rounding, then cutting off
  std::vector<Twin> words;            // 12..36 bits, each with the most fraction bits with which every view
                                      // is complete, or with none
  std::vector<Twin> floating;         // float, double
  std::vector<ExactProgram> exact;
};

// In the order of guests::jones::six_views. Errors: differs, if a build without the EAE does not draw what
// that with it draws, or an exact algorithm not what the oracle finds; guest_failed.
[[nodiscard]] Outcome<std::vector<JonesMeasured>> measure_jones(const Context& context);

// One scene on the machine.
[[nodiscard]] Outcome<MachineBuild> measure_build(const SceneViews& views,
                                                  const guests::jones::Precision& build);
// In C++, without its time.
[[nodiscard]] Twin measure_twin(const SceneViews& views, const guests::jones::Precision& precision);

}  // namespace sightline::harness::report
