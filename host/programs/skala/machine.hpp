// Runs Skala's program on the emulated 8080 with one output device and one link to its host computer, and
// reports the picture and its costs.
//
// Drawing time is counted from the first instruction at DRAWIT, when a block of commands is in memory, to the end of the
// last dot on the EF9365 board or of the last movement of the CalComp; for the other two devices, which do not report their
// end, to the halt. It excludes the receipt of commands, because the paper measures the programs, not the line. A picture
// of several blocks has several such intervals, each up to the next poll of the link. Nothing is added to the program;
// without a plotter only the link's port is observed.
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
  Device device = Device::ef9365;  // the only one on the machine, whatever device the stream selects
  Link link = Link::parallel;
  core::ClockRate clock{};
  std::int64_t t_state_limit = 0;  // 0: an upper bound for a stream of this length
  bool keep_strokes = false;       // the marks of a plotter's pen, of which there may be millions
};

// An access that no device answered.
struct Unanswered {
  std::uint8_t port = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

// A count of program errors, or of actions that a real device would have done wrong.
struct DeviceFault {
  std::string_view what;
  std::uint64_t count = 0;
};

struct MachinePicture {
  bool ended = false;  // false: the limit came before the program's halt
  Status status = Status::running;
  core::Raster raster{};              // of the board; empty on a plotter
  std::vector<PlotterMove> moves;     // the plotter's movements, in order
  std::vector<core::Stroke> strokes;  // the marks of its pen, with their times; only if requested
  Columns columns;                    // the program's masks; fold state is left out
  core::TStates total{};              // from reset to halt
  core::TStates drawing{};
  int blocks = 0;  // number of times the buffer was drawn
  std::uint64_t instructions = 0;
  std::vector<DeviceFault> faults;  // of the device, counts above 0 only
  std::vector<Unanswered> unanswered;
  std::uint64_t dots_not_shown = 0;  // ALT-256: in the rows its frame leaves out
};

// `stream` is made by stream_of; arbitrary bytes are allowed.
[[nodiscard]] MachinePicture run_machine(const Program& program, std::span<const std::uint8_t> stream,
                                     const MachineOptions& options = {});

// The number of distinct positions lit on the board, or marked by the pen.
[[nodiscard]] std::uint64_t points_lit(const MachinePicture& picture);

}  // namespace sightline::programs::skala
