// Runs Jones's program for experiments. Each run is compared with its native twin before its results are used.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/programs/jones/jones.hpp"
#include "host/report/experiment.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::report {

struct JonesOrder {
  std::string scene;  // a built-in one, seen from its default view
  bool eae = true;
  bool stereo = false;
  bool photograph = false;
};

struct JonesRun {
  scene::CellScene scene;
  programs::jones::Prepared program;
  programs::jones::Outcome outcome;  // two views; the numbers are those of the second, computed while the display shows the first
  programs::jones::TwinCounts twin;  // of the same view: counts that the machine's program does not make

  [[nodiscard]] const programs::jones::View& view() const { return outcome.view(); }
};

// Throws base::Error: program_failed, if the program stopped with a status or took too long; differs, if its display
// file differs from its twin's.
[[nodiscard]] JonesRun run_jones(const JonesOrder& order);

[[nodiscard]] double seconds(core::Duration time);

// Lines of the display's last complete pass, 1024 x 1024, as PNG.
[[nodiscard]] Picture crisp_png(const JonesRun& run);
// A photograph of the screen, exposed for 0.2 s, 512 x 512. The order asked for one (precondition).
[[nodiscard]] Picture phosphor_png(const JonesRun& run);
[[nodiscard]] Picture phosphor_png(const programs::jones::Outcome& outcome);

inline constexpr core::Duration shutter_time = core::milliseconds(200);

}  // namespace sightline::report
