// The program of firmware/i8080/flight on the emulated 8080: an order of a flight in, its frames and costs out. The host computer packs
// the model and the eyes (packing.hpp); the program orders the pieces for the priority display (machine.hpp). The orders are counted
// against those of exact distances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/base/result.hpp"
#include "host/programs/flight/machine.hpp"
#include "host/programs/flight/packing.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::flight {

// What the host does once for a flight straight through a scene.
struct Plan {
  algorithms::willis::Model model;
  std::vector<scene::PolyCamera> path;
};
// Along the scene's own vertical. `level`: in plan. Of all pieces, or no more than the so many nearest. Errors: those of path_through
// and flight_model.
[[nodiscard]] base::Result<Plan> plan_flight(const scene::PolyScene& scene, bool level, std::uint32_t frames,
                                             std::optional<std::size_t> pieces = {});

struct Order {
  const algorithms::willis::Model& model;
  std::span<const scene::PolyCamera> path;
  Precision precision = Precision::bits_8;
  bool count_points = false;
  bool shown = false;  // the display has something to show, though nobody takes its pictures
  bool check = false;  // compare every priority of every frame with that of the native twin
  core::ClockRate clock{};
  // The display's pictures, each when it has been scanned: 512 lines of 512 numbers of faces from 1, 0 for none; the top line first.
  std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> picture = {};
};

struct Frame {
  core::TStates computing{};  // since the frame before, without waiting for the display; 0 of the first frame
  core::TStates waiting{};
  core::Instant shown{};
  std::uint32_t moved = 0;      // as of MachineFrame
  std::uint32_t exchanges = 0;
  std::uint32_t facing = 0;     // pieces turned to the eye
  // Pairs of pieces turned to the eye, at different distances or in different cells, that are not in the exact order.
  std::uint32_t wrong_orders = 0;
  std::uint64_t wrong_points = 0;  // of the picture: another face than with exact distances; if points are counted
};

struct Summary {
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

struct Outcome {
  Packed packed;
  MachineFlight flight;
  std::vector<Frame> frames;
  Summary summary;
};

// The whole flight at once. Error program_failed: the program did not end, or not as it should, or the display lost something. Error
// differs: a priority is not the twin's, which is a defect of this program.
[[nodiscard]] base::Result<Outcome> run(const Order& order, const Program& program = resident_program());

// A flight that is run from time to time, while somebody looks: all that is known of a frame is known when the display has been told to show it.
class FlightInProgress {
 public:
  // Model and path outlive this.
  explicit FlightInProgress(const Order& order, const Program& program = resident_program());
  ~FlightInProgress();
  FlightInProgress(const FlightInProgress&) = delete;
  FlightInProgress& operator=(const FlightInProgress&) = delete;

  // To that time, or to the program's end.
  void run(core::TStateInstant until);
  [[nodiscard]] core::TStateInstant now() const;
  [[nodiscard]] bool ended() const;
  // When it is over, whatever the program does.
  [[nodiscard]] core::TStateInstant latest_end() const;
  [[nodiscard]] const Outcome& so_far() const;
  // Of the frames so far from the twin's, in words; of the end, too, if the flight has ended. Empty: none, or the order is not checked.
  [[nodiscard]] std::string difference() const;
  // What the display shows by now, as Order::picture has it.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  class Host;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The pieces turned to the eye as the display has them, the least priority first; and how many pairs of them, at different distances or in different
// cells, are not in the exact order. `exact` is that order, of willis::Frames.
struct ShownOrder {
  std::vector<std::uint32_t> pieces;
  std::uint32_t wrong = 0;
};
[[nodiscard]] ShownOrder shown_order(const algorithms::willis::Model& model, const scene::PolyCamera& camera,
                                     std::span<const std::uint32_t> exact, const Priorities& priorities);

// What the cost model of the program's NOTES.md says of a frame, in T-states without waiting.
[[nodiscard]] double predicted_t_states(const Packed& packed, std::size_t pieces, const Frame& frame);

}  // namespace sightline::programs::flight
