// Runs Skala's program (1985) on the emulated 8080: takes an order, returns its picture and costs. The host computer makes
// the commands (stream.hpp); the program draws them on the one device of its machine (machine.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "host/algorithms/skala/view.hpp"
#include "host/base/result.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/machine.hpp"
#include "host/programs/skala/picture.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::programs::skala {

struct Order {
  scene::HeightGrid grid;
  algorithms::skala::View view;
  Device device = Device::ef9365;
  Link link = Link::parallel;
  core::ClockRate clock{};
  bool time_plain = false;  // also run without the visibility test, if the view has it
  bool check = false;       // compare the picture with that of the native twin
  bool direct_masks = false;  // without the temporary masks M1T and M1B; on a raster board the wrong dots are counted
};

// Dots of a picture without the temporary masks that differ from those of the right one.
struct WrongDots {
  std::uint64_t missing = 0;
  std::uint64_t extra = 0;  // also with a wrong colour
};

struct Outcome {
  MachinePicture picture;
  std::size_t bytes = 0;  // of the commands
  std::uint64_t points_walked = 0;
  std::uint64_t points_lit = 0;
  PlotterWork plotter;                       // empty for a raster board
  std::optional<core::TStates> plain_drawing;  // drawing time without the visibility test
  std::optional<Counts> counts;                // the twin's counts, if the order is checked
  std::optional<WrongDots> wrong_dots;         // of direct masks on a raster board

  // How much the visibility test lengthens drawing, in per cent; negative if it shortens it. nullopt if that was not
  // ordered, or nothing is drawn.
  [[nodiscard]] std::optional<double> visibility_cost() const;
};

// Error program_failed: the program did not end, stopped with an error, or misused its device. Error differs: its picture
// is not its twin's, which is a defect of this program.
[[nodiscard]] base::Result<Outcome> run(const Order& order);

// The same for arbitrary commands, with a parallel link at 3 MHz.
[[nodiscard]] base::Result<Outcome> run(std::span<const std::uint8_t> stream, Device device, bool check,
                                        const Program& program = resident_program());

}  // namespace sightline::programs::skala
