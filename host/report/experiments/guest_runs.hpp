// Runs of the guest programs as experiments need them: each is compared with its native twin before anything is
// said of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/programs/jones/session.hpp"
#include "host/programs/skala/session.hpp"
#include "host/programs/skala/view.hpp"
#include "host/report/experiment.hpp"
#include "host/scene/heights/grid.hpp"
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
  programs::jones::Program program;
  programs::jones::GuestRun guest;  // two views; figures are of the second, while the display shows the first
  programs::jones::Counts twin;  // of the same view: what the machine's program does not count itself

  [[nodiscard]] const programs::jones::GuestView& view() const { return guest.views.back(); }
};

// Throws base::Error: guest_failed, if the program stopped with a status or took too long; differs, if its display
// file is not its twin's.
[[nodiscard]] JonesRun run_jones(const JonesOrder& order);

[[nodiscard]] double seconds(core::Duration time);

// Lines of the display's last complete pass, 1024 x 1024, as PNG.
[[nodiscard]] Picture crisp_png(const JonesRun& run);
// The screen photographed, 0.2 s, 512 x 512; the order asked for a photograph.
[[nodiscard]] Picture phosphor_png(const JonesRun& run);

inline constexpr core::Duration shutter_time = core::milliseconds(200);

struct SkalaOrder {
  std::string function;  // one of the eight
  programs::skala::PictureKind picture = programs::skala::PictureKind::lines;
  scene::GridSize size{33, 60};
  double rotation = 30;
  bool compare_plain = false;  // run again without the visibility test
  programs::skala::Device device = programs::skala::Device::ef9365;
};

struct SkalaRun {
  std::size_t stream_bytes = 0;
  programs::skala::GuestPicture guest;  // 8080 at 3 MHz
  programs::skala::TwinCounts twin;
  std::uint64_t points_lit = 0;
  core::TStates dots_busy{};           // of an EF9365 board, drawing dots; clearing comes on top
  std::optional<core::TStates> plain;  // drawing without the visibility test
};

// Throws as run_jones.
[[nodiscard]] SkalaRun run_skala(const programs::skala::Session& session, const SkalaOrder& order);

[[nodiscard]] std::string_view name_of(programs::skala::PictureKind picture);  // "lines", "surface", "contours"

[[nodiscard]] Picture raster_png(const SkalaRun& run, const SkalaOrder& order);

}  // namespace sightline::report
