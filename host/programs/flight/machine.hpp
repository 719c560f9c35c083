// Runs the program of firmware/i8080/flight on the emulated 8080 between a host, which sends a stream and gives the display what is to be seen,
// and the priority display; and measures every frame. The ports are watched; nothing is added to the program.
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
  core::TStateInstant told{};   // when
  core::TStates waiting{};      // until the display had taken up the frame before
  core::Instant shown{};        // the beginning of the display's frame that shows it
  // How far the program's order is from that of the frame before: pieces that went before another, and pairs that changed places.
  std::uint32_t moved = 0;
  std::uint32_t exchanges = 0;
};

struct MachineFlight {
  Status status = Status::running;
  std::vector<MachineFrame> frames;
  core::TStates total{};
  bool ended = false;             // false: the limit of time came before the program's halt
  std::uint64_t priorities = 0;   // written
  std::uint64_t writes_lost = 0;  // by the display: none, if all is well
  std::uint64_t unanswered = 0;   // accesses that no device answered
};

struct MachineOptions {
  bool display = true;
  core::ClockRate clock{};
  // Called before the display is told to show a frame, from 0: the host gives the board what is to be seen.
  std::function<void(std::uint32_t frame, devices::PriorityBoard& board)> give = {};
  // Called when a frame has been scanned, with the picture of the display (512 lines of 512 colours, the top line first).
  std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> scanned = {};
};

// A flight that is run from time to time, while somebody looks.
class FlightMachine {
 public:
  // The program's memory is copied; the stream outlives this.
  FlightMachine(const Program& program, std::span<const std::uint8_t> stream, MachineOptions options = {});
  ~FlightMachine();
  FlightMachine(const FlightMachine&) = delete;
  FlightMachine& operator=(const FlightMachine&) = delete;

  // To that time, or to the program's end, which `flight().ended` tells. The last frame is then shown, too.
  void run(core::TStateInstant until);
  // So far; what is in the display is as of the last run.
  [[nodiscard]] const MachineFlight& flight() const { return flight_; }
  [[nodiscard]] core::TStateInstant now() const;
  // What the display shows by now, as `scanned` has it.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  class DisplayFront;
  struct Parts;
  MachineOptions options_;
  MachineFlight flight_;
  std::unique_ptr<Parts> parts_;
};

// More than any program can take for that stream.
[[nodiscard]] core::TStateInstant latest_end(std::span<const std::uint8_t> stream);
// The whole flight at once.
[[nodiscard]] MachineFlight run_machine(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options = {});

}  // namespace sightline::programs::flight
