// Runs the program of firmware/i8080/flight on the emulated 8080: takes an order of a flight, returns its frames and costs.
// The host computer packs the model and the eyes (packing.hpp); the program orders the pieces for the priority display
// (machine.hpp). Its orders are compared with those of exact distances.
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

// The host's preparation of a flight straight through a scene.
struct Plan {
  algorithms::willis::Model model;
  std::vector<scene::PolyCamera> path;
};
// `level`: a model in plan; otherwise along the scene's vertical. `pieces`: at most that many of the nearest pieces;
// otherwise all. `facing`: for the facing test. Errors: those of path_through and flight_model.
[[nodiscard]] base::Result<Plan> plan_flight(const scene::PolyScene& scene, bool level, std::uint32_t frames,
                                             std::optional<std::size_t> pieces = {}, bool facing = false);

struct Order {
  const algorithms::willis::Model& model;
  std::span<const scene::PolyCamera> path;
  Precision precision = Precision::bits_8;
  bool facing = false;  // the build with the facing test; the model is then one of flight_model with `facing`
  bool count_points = false;
  bool shown = false;  // the display computes its picture even if nobody takes it
  bool check = false;  // compare every priority of every frame with that of the native twin
  core::ClockRate clock{};
  // Receives each picture of the display when it has been scanned: 512 lines of 512 face numbers from 1, 0 for none; top
  // line first.
  std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> picture = {};
};

struct Frame {
  core::TStates computing{};  // since the frame before, without waiting for the display; 0 for the first frame
  core::TStates waiting{};
  core::Instant shown{};
  std::uint32_t moved = 0;      // as in MachineFrame
  std::uint32_t exchanges = 0;
  std::uint32_t listed = 0;
  Turned turned{};
  std::uint32_t facing = 0;     // pieces turned to the eye
  std::uint32_t hidden = 0;     // of these, without a priority: 0 unless the facing test has an error
  // Pairs of pieces turned to the eye, at different distances or in different cells, that are not in the exact order.
  std::uint32_t wrong_orders = 0;
  std::uint64_t wrong_points = 0;  // points of the picture with another face than with exact distances, if points are counted
};

struct Summary {
  std::uint32_t frames = 0;
  std::uint32_t pieces = 0;
  double frames_per_second_mean = 0;   // as the display shows them, at most 25
  double frames_per_second_worst = 0;
  double computed_per_second_mean = 0;  // with a display that never makes the program wait
  double computed_per_second_worst = 0;
  double t_states_mean = 0;  // per frame, without waiting
  std::int64_t t_states_worst = 0;
  double exchanges_mean = 0;
  std::uint32_t exchanges_most = 0;
  double listed_mean = 0;  // pieces that got a key
  std::uint32_t listed_most = 0;
  double turned_mean = 0;  // pieces that have come to face the eye or turned away
  std::uint32_t turned_most = 0;
  std::uint64_t hidden = 0;
  std::uint64_t wrong_orders = 0;
  std::uint64_t pairs = 0;  // pairs that could be wrong
  std::uint64_t wrong_points = 0;
  std::uint32_t frames_wrong = 0;  // frames with a wrong point
};

struct Outcome {
  Packed packed;
  MachineFlight flight;
  std::vector<Frame> frames;
  Summary summary;
};

// Runs the whole flight at once. Error program_failed: the program did not end, or ended wrongly, or the display lost
// writes. Error differs: a priority differs from the twin's, which is a defect of this program.
[[nodiscard]] base::Result<Outcome> run(const Order& order, const Program& program);
[[nodiscard]] base::Result<Outcome> run(const Order& order);

// A flight that is run in parts while somebody watches. The data of a frame is complete when the display has been told to
// show it.
class FlightInProgress {
 public:
  // Model and path must outlive this.
  FlightInProgress(const Order& order, const Program& program);
  explicit FlightInProgress(const Order& order) : FlightInProgress(order, resident_program(order.facing)) {}
  ~FlightInProgress();
  FlightInProgress(const FlightInProgress&) = delete;
  FlightInProgress& operator=(const FlightInProgress&) = delete;

  // Runs to that time, or to the program's end.
  void run(core::TStateInstant until);
  [[nodiscard]] core::TStateInstant now() const;
  [[nodiscard]] bool ended() const;
  // An upper bound on the end, whatever the program does.
  [[nodiscard]] core::TStateInstant latest_end() const;
  [[nodiscard]] const Outcome& outcome() const;
  // The difference of the frames so far from the twin's, in words, and of the end if the flight has ended. Empty: none, or
  // the order is not checked.
  [[nodiscard]] std::string difference() const;
  // The current picture of the display, in the form of Order::picture.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  class Host;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The pieces turned to the eye in the display's order, lowest priority first; and the number of their pairs, at different
// distances or in different cells, that are not in the exact order. `exact` is that order, from willis::Frames.
struct ShownOrder {
  std::vector<std::uint32_t> pieces;
  std::uint32_t wrong = 0;
};
[[nodiscard]] ShownOrder shown_order(const algorithms::willis::Model& model, const scene::PolyCamera& camera,
                                     std::span<const std::uint32_t> exact, const Priorities& priorities);

// The T-states of a frame without waiting, by the cost model of the program's NOTES.md.
[[nodiscard]] double predicted_t_states(const Packed& packed, const Frame& frame);

}  // namespace sightline::programs::flight
