// The host's preparation of a flight: the model of Willis, reduced to the machine's capacity, and its points and eyes as
// the bytes of a stream (firmware/i8080/flight/SPECIFICATION.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/base/result.hpp"
#include "host/programs/flight/status.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::flight {

inline constexpr std::size_t most_pieces = 255;  // a piece's number is a byte, and 0 means none

// The model with its pieces in order of distance from the eye: piece i has the number i + 1. With `pieces` given, at most
// that many of the nearest. `facing`: for the facing test, whose directions take space too. Errors: those of
// willis::make_model; more pieces, directions, or planes between solids that touch or are not convex, than the machine holds,
// with the excess and the body that causes most of it; with `facing` a piece without a normal.
[[nodiscard]] base::Result<algorithms::willis::Model> flight_model(const scene::PolyScene& scene, const algorithms::willis::ModelOptions& options,
                                                                   const scene::PolyPoint& eye, std::optional<std::size_t> pieces = {}, bool facing = false);

// The same, with only the pieces turned to one camera: the others need no priority.
[[nodiscard]] base::Result<algorithms::willis::Model> view_model(const scene::PolyScene& scene, const algorithms::willis::ModelOptions& options,
                                                                 const scene::PolyCamera& camera);

struct Packed {
  Precision precision = Precision::bits_8;
  std::size_t axes = 3;
  std::int64_t step = 1;      // per unit of a coordinate, in units of willis's lattice
  double step_in_units = 1;   // in units of the scene
  std::size_t planes = 0;
  // Pieces of a cell whose distances from the eye differ by more than this, in units of the scene, are ordered correctly: a
  // point and the eye are each rounded by half a step along every axis.
  double error_in_units = 0;
  std::size_t directions = 0;  // of the facing test; 0 without it
  // With the facing test a piece that faces the eye is always in the order. So is one that faces away, but is seen from
  // behind by no more than this distance of the eye from its plane, in units of the scene.
  double facing_error_in_units = 0;
  std::vector<std::uint8_t> stream;
};

// The stream of a flight past the cameras' eyes, at least one. The point of a piece is its first corner, as for
// willis::Frames. In parallel projection, with one direction for all cameras (precondition), coordinates are the depth
// along it and 0, and the eye is where the depth begins. `facing`: a stream for the facing test; the model must be one of
// flight_model with `facing`. In parallel projection the pieces that face the eye are then the same in all frames.
[[nodiscard]] Packed pack(const algorithms::willis::Model& model, std::span<const scene::PolyCamera> cameras, Precision precision, bool facing = false);

// Writes the bytes of a stream, for tests and tools: coordinates within the precision, all points, places and cells if there
// are planes, with the facing test each direction and its entries, eyes.
class StreamWriter {
 public:
  // `directions`: 0 for a stream without the facing test.
  StreamWriter(Precision precision, std::size_t axes, std::size_t pieces, std::size_t planes = 0, std::size_t directions = 0);
  void point(std::span<const std::uint32_t> coordinates);
  void place(std::uint8_t place);  // of a plane, or the cell of a piece
  void direction(std::size_t entries);
  void entry(std::uint32_t limit, std::uint8_t piece, bool faces_beyond);
  void check();
  void eye(std::span<const std::uint32_t> coordinates);
  [[nodiscard]] std::vector<std::uint8_t> end();

 private:
  void byte(std::uint32_t value);

  Precision precision_;
  std::vector<std::uint8_t> bytes_;
  std::uint8_t sum_ = 0;
  std::uint8_t sum_of_sums_ = 0;
};

}  // namespace sightline::programs::flight
