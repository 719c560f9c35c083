// Runs Jones's program on the emulated PDP-7 with its Type 340 and reports each view: its lines, how
// long the machine took, and which cells it entered.
//
// A view's time runs from the fetch at `search` to the store into `file` (jones.md section 7); where lines
// are added at once, to the count of complete views. An observer measures it: nothing is added to
// the program.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/console.hpp"
#include "host/programs/jones/program.hpp"
#include "host/programs/jones/twin/twin.hpp"

namespace sightline::programs::jones {

struct GuestOptions {
  bool eae = true;
  std::optional<std::int32_t> scale;  // 64..4096
  bool stereo = false;                // AC switch 17
  bool immediate = false;             // AC switch 16
  bool clock = true;
  std::vector<pdp7::SwitchSetting> switches;  // a person at the console; instead of the two above
  int views = 2;
  bool display = true;  // false: views are computed with no display on the machine
  core::Duration photograph =
      core::Duration(0);  // keep strokes of this long after the last view's first pass
  core::Duration time_limit = core::seconds(600);  // emulated
};

struct GuestView {
  Status status = Status::complete;
  core::Duration time{};  // the paper's computing time
  std::uint64_t instructions = 0;
  std::uint64_t stolen_cycles = 0;
  std::uint64_t visits = 0;
  std::uint64_t distinct_cells = 0;  // whose words the processor read
  std::uint64_t openings_tested = 0;
  std::uint64_t lines_clipped = 0;
  std::uint64_t pieces = 0;
  std::vector<core::Word18> display_file;  // from its first word to the stop word
};

struct GuestRun {
  std::vector<GuestView> views;  // fewer than asked for if the time limit came first
  bool timed_out = false;
  std::uint64_t instructions = 0;
  core::Duration emulated{};
  // The display: the last view's file, run once from IDLA to its stop, and the time from one IDLA to the
  // next.
  std::vector<core::Stroke> pass;
  core::Duration refresh_period{};       // 0: not seen, as of a picture of nothing
  std::vector<core::Stroke> photograph;  // strokes up to shutter_close
  core::Instant shutter_close{};
};

[[nodiscard]] GuestRun run_guest(const Program& program, const GuestOptions& options);
// With other words in core than the program's own, as after a change of the eye.
[[nodiscard]] GuestRun run_guest(const Program& program, std::span<const core::Word18> core,
                                 const GuestOptions& options);

}  // namespace sightline::programs::jones
