// Runs the program of firmware/i8080/stripes on the emulated 8080: takes an order, returns its picture and costs. The host
// computer projects the scene (scene.hpp) and sends its faces (stream.hpp); the program draws them on one device
// (machine.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/pen_path.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/programs/stripes/machine.hpp"
#include "host/programs/stripes/scene.hpp"
#include "host/programs/stripes/stream.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::stripes {

struct Order {
  const scene::PolyScene& scene;  // as for project_scene
  View view;
  StreamOptions options = {};
  bool check = false;  // compare the picture with that of the native twin
};

struct Outcome {
  ProjectedScene scene;
  Stream stream;
  MachinePicture picture;
  // From the twin, if the order is checked: the face at every dot, numbered over all bodies from 1, 0 for none; rows from
  // the bottom.
  std::optional<picture::PixelGrid> faces;
};

// Errors: those of project_scene and encode; bad_input: the scene does not fit during drawing, with the place and the
// excess (computed by the twin); program_failed: the program did not end, stopped, or misused a device; differs: its
// picture is not its twin's, which is a defect of this program.
[[nodiscard]] base::Result<Outcome> run(const Order& order);
// With a program of the build of the order.
[[nodiscard]] base::Result<Outcome> run(const Order& order, const Program& program);

// The plotter's commands by kind.
struct PenWork {
  std::uint64_t steps_down = 0;
  std::uint64_t steps_up = 0;
  std::uint64_t lifts = 0;
};
[[nodiscard]] PenWork pen_work(std::span<const std::uint8_t> commands);

// One path from each lowering of the pen to its lifting; of a straight run only the ends are kept.
[[nodiscard]] std::vector<picture::PenPath> pen_paths(std::span<const std::uint8_t> commands);

}  // namespace sightline::programs::stripes
