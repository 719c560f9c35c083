// Runs the program of firmware/i8080/flight on the emulated 8080 between a host, which sends a stream and gives the display
// the visible surfaces, and the priority display; measures every frame by observing the ports. Nothing is added to the
// program.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/devices/priority_board.hpp"
#include "host/programs/flight/program.hpp"
#include "host/programs/flight/status.hpp"

namespace sightline::programs::flight {

struct MachineFrame {
  Priorities priorities{};      // in the display when it was told to show them
  core::TStateInstant commanded_at{};   // the time of that command
  core::TStates waiting{};      // until the display had taken over the frame before
  core::Instant shown{};        // the beginning of the display's frame that shows them
  // The distance of the program's order from that of the frame before: pieces moved before another, and pairs exchanged.
  std::uint32_t moved = 0;
  std::uint32_t exchanges = 0;
  std::uint32_t listed = 0;  // pieces of the order
  // With the facing test, against the frame before; 0 for the first frame.
  Turned turned{};
};

struct MachineFlight {
  Status status = Status::running;
  std::vector<MachineFrame> frames;
  core::TStates total{};
  bool ended = false;             // false: the time limit came before the program's halt
  std::uint64_t priorities = 0;   // written
  std::uint64_t writes_lost = 0;  // by the display; 0 unless the program has an error
  std::uint64_t unanswered = 0;   // accesses that no device answered
};

struct MachineOptions {
  bool display = true;
  core::ClockRate clock{};
  // Called before the display is told to show a frame, numbered from 0: the host gives the board its surfaces.
  std::function<void(std::uint32_t frame, devices::PriorityBoard& board)> give = {};
  // Called when a frame has been scanned, with the display's picture (512 lines of 512 colours, top line first).
  std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> scanned = {};
};

// A flight that is run in parts while somebody watches.
class FlightMachine {
 public:
  // The program's memory is copied; the stream must outlive this.
  FlightMachine(const Program& program, std::span<const std::uint8_t> stream, MachineOptions options = {});
  ~FlightMachine();
  FlightMachine(const FlightMachine&) = delete;
  FlightMachine& operator=(const FlightMachine&) = delete;

  // Runs to that time or to the program's end, which `flight().ended` tells. Then the last frame is shown too.
  void run(core::TStateInstant until);
  // The flight so far; the display's state is as of the last run.
  [[nodiscard]] const MachineFlight& flight() const { return flight_; }
  [[nodiscard]] core::TStateInstant now() const;
  // The current picture of the display, in the form of `scanned`.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  class DisplayFront;
  struct Parts;
  MachineOptions options_;
  MachineFlight flight_;
  std::unique_ptr<Parts> parts_;
};

// An upper bound on the time of any program for that stream.
[[nodiscard]] core::TStateInstant latest_end(std::span<const std::uint8_t> stream);
// Runs the whole flight at once.
[[nodiscard]] MachineFlight run_machine(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options = {});

}  // namespace sightline::programs::flight
