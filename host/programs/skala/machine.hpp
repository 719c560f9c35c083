// Runs Skala's program on the emulated 8080 with one output device and one link to its host computer, and
// reports the picture and its costs.
//
// Drawing time is counted from the first instruction at DRAWIT, when a block of commands is in memory, to
// the end of the last dot on the EF9365 board or of the last movement of the CalComp; on the other two
// devices, which do not say when they are done, to the halt. The receipt of commands is not in it: the paper
// measures the programs, not the line. A picture of several blocks has several such stretches, each up to the
// next look at the link. Nothing is added to the program; without a plotter the only observer of the run is the
// link's port.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/stroke.hpp"
#include "emulators/core/tstates.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/picture.hpp"
#include "host/programs/skala/program.hpp"

namespace sightline::programs::skala {

enum class Link { parallel, serial };

struct MachineOptions {
  Device device = Device::ef9365;  // the only one on the machine, whatever the stream asks for
  Link link = Link::parallel;
  core::ClockRate clock{};
  std::int64_t t_state_limit = 0;  // 0: more than any picture of so many bytes can take
  bool keep_strokes = false;       // the marks of a plotter's pen, of which there may be millions
};

// An access no device answered.
struct Unanswered {
  std::uint8_t port = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

// Something a device counts as the program's error, or would have done wrong.
struct DeviceFault {
  std::string_view what;
  std::uint64_t count = 0;
};

struct MachinePicture {
  bool ended = false;  // false: the limit came before the program's halt
  Status status = Status::running;
  core::Raster raster{};              // of the board; empty on a plotter
  std::vector<PlotterMove> moves;     // what the plotter did, in order
  std::vector<core::Stroke> strokes;  // the marks of its pen, with their times; only if asked for
  Columns columns;                    // the program's masks; fold state is left out
  core::TStates total{};              // from reset to halt
  core::TStates drawing{};
  int blocks = 0;  // how often the buffer was drawn
  std::uint64_t instructions = 0;
  std::vector<DeviceFault> faults;  // of the device, counts above 0 only
  std::vector<Unanswered> unanswered;
  std::uint64_t dots_not_shown = 0;  // ALT-256: in the rows its frame leaves out
};

// `stream` as stream_of makes it; any bytes are taken.
[[nodiscard]] MachinePicture run_machine(const Program& program, std::span<const std::uint8_t> stream,
                                     const MachineOptions& options = {});

// Distinct places lit on the board, or marked by the pen.
[[nodiscard]] std::uint64_t points_lit(const MachinePicture& picture);

}  // namespace sightline::programs::skala
