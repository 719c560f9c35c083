// A whole flight on the emulated 8080 beside its twin: every priority of every frame compared, the orders counted against those of exact
// distances, the frames timed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/programs/flight/guest.hpp"
#include "host/programs/flight/packing.hpp"
#include "host/programs/flight/program.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::flight {

struct FlightFrame {
  core::TStates computing{};  // since the frame before, without waiting for the display; 0 of the first frame
  core::TStates waiting{};
  core::Instant shown{};
  std::uint32_t moved = 0;      // pieces that went before another
  std::uint32_t exchanges = 0;  // pairs whose order changed
  std::uint32_t facing = 0;     // pieces turned to the eye
  // Pairs of pieces turned to the eye, at different distances or in different cells, that are not in the exact order.
  std::uint32_t wrong_orders = 0;
  std::uint64_t wrong_points = 0;  // of the picture: another face than with exact distances; if points are counted
};

struct FlightSummary {
  std::uint32_t frames = 0;
  std::uint32_t pieces = 0;
  double frames_per_second_mean = 0;   // as shown by the display, 25 at most
  double frames_per_second_worst = 0;
  double computed_per_second_mean = 0;  // of a display that never lets the program wait
  double computed_per_second_worst = 0;
  double t_states_mean = 0;  // of a frame, without waiting
  std::int64_t t_states_worst = 0;
  double exchanges_mean = 0;
  std::uint32_t exchanges_most = 0;
  std::uint64_t wrong_orders = 0;
  std::uint64_t pairs = 0;  // that could be wrong
  std::uint64_t wrong_points = 0;
  std::uint32_t frames_wrong = 0;  // with a wrong point
};

struct FlightRun {
  GuestFlight guest;
  std::vector<FlightFrame> frames;
  FlightSummary summary;
  std::string difference;  // where guest and twin are not the same; empty: nowhere
};

struct FlightOptions {
  bool count_points = false;
  bool shown = false;  // the display has something to show, though nobody takes its pictures
  core::ClockRate clock{};
  // The display's pictures, each when it has been scanned: 512 lines of 512 numbers of faces from 1, 0 for none; the top line first.
  std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> picture = {};
};

// The pieces turned to the eye as the display has them, the least priority first; and how many pairs of them, at different distances or in different
// cells, are not in the exact order. `exact` is that order, of willis::Frames.
struct ShownOrder {
  std::vector<std::uint32_t> pieces;
  std::uint32_t wrong = 0;
};
[[nodiscard]] ShownOrder shown_order(const algorithms::willis::Model& model, const scene::PolyCamera& camera,
                                     std::span<const std::uint32_t> exact, const Priorities& priorities);

// A flight that is run from time to time, while somebody looks: all that is known of a frame is known when the display has been told to show it.
class FlightInProgress {
 public:
  // `packed` is made of the model and the cameras; all of them outlive this.
  FlightInProgress(const Program& program, const algorithms::willis::Model& model, std::span<const scene::PolyCamera> cameras,
                   const Packed& packed, const FlightOptions& options);
  ~FlightInProgress();
  FlightInProgress(const FlightInProgress&) = delete;
  FlightInProgress& operator=(const FlightInProgress&) = delete;

  void run(core::TStateInstant until);
  [[nodiscard]] core::TStateInstant now() const;
  [[nodiscard]] bool ended() const;
  // So far; the difference at the end, too, if the flight has ended.
  [[nodiscard]] const FlightRun& so_far() const;
  // What the display shows by now, as FlightOptions::picture has it.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  class Host;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

class Session {
 public:
  Session() : program_(assemble_program()) {}

  [[nodiscard]] const Program& program() const { return program_; }
  // `packed` is made of the model and the cameras.
  [[nodiscard]] FlightRun run(const algorithms::willis::Model& model, std::span<const scene::PolyCamera> cameras, const Packed& packed,
                              const FlightOptions& options = {}) const;

 private:
  Program program_;
};

// The first difference, in words; empty: none.
[[nodiscard]] std::string difference_of(const GuestFlight& guest, const TwinFlight& twin);

// What the cost model of the program's NOTES.md says of a frame, in T-states without waiting.
[[nodiscard]] double predicted_t_states(const Packed& packed, std::size_t pieces, const FlightFrame& frame);

}  // namespace sightline::programs::flight
