// Runs the program of firmware/i8080/stripes on the emulated 8080 with its parallel link and one device, the EF9365 board
// or the CalComp 565, and measures receipt, priority list and drawing. An observer records when the program reaches its
// labels, and counts together with fronts at the ports; nothing is added to the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/tstates.hpp"
#include "host/programs/stripes/counts.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

enum class Device : std::uint8_t { none, ef9365, calcomp };

struct MachineOptions {
  Device device = Device::ef9365;
  core::ClockRate clock{};
  std::int64_t t_state_limit = 0;  // 0: an upper bound for any scene
};

// A count of errors of the program, found by the device.
struct DeviceFault {
  std::string_view what;
  std::uint64_t count = 0;
};

struct MachinePicture {
  bool ended = false;  // false: the limit came before the program's halt
  Status status = Status::running;
  std::uint8_t fault = 0;
  core::Raster raster;                 // of the board
  std::vector<std::uint8_t> commands;  // to the plotter, in order
  std::vector<std::uint8_t> order;     // the priority list; empty if the program did not reach it
  core::TStates receiving{};           // from the start to the last byte
  core::TStates ranking{};             // check of the records and priority list
  core::TStates drawing{};             // to the halt, or until the device is done
  core::TStates device{};              // of the plotter: its busy times
  std::uint64_t board_commands = 0;    // to the board
  std::uint64_t dots_written = 0;      // by the board, also again
  std::uint64_t instructions = 0;
  Counts counts;
  std::vector<DeviceFault> faults;  // counts above 0 only

  // Without the receipt, because the host determines the link's speed.
  [[nodiscard]] core::TStates working() const { return ranking + drawing; }
};

// Arbitrary bytes are allowed.
[[nodiscard]] MachinePicture run_machine(const Program& program, std::span<const std::uint8_t> stream,
                                     const MachineOptions& options = {});

}  // namespace sightline::programs::stripes
