// Measures the error of frames of a turn that are computed from a list of events (Plantinga, Seales and Dyer 1990):
// compares them, edge by edge, with hidden-line removal from scratch at the same angle.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::compare {

// Visible parts of an edge, from 0 at its start to 1.
using EdgeParts = std::vector<std::pair<double, double>>;
[[nodiscard]] double length_of(const EdgeParts& parts);

// The result of hidden-line removal from scratch at one angle, by edge.
struct ExactFrame {
  double angle = 0;  // radians
  std::vector<algorithms::plantinga::EdgeStructure> structures;
  std::vector<EdgeParts> parts;
  std::vector<double> lengths;  // in the image, in units of the model
};
// At the angles nearest to `wanted` whose sine and cosine are ratios of 21-bit integers.
[[nodiscard]] std::vector<ExactFrame> exact_frames(const algorithms::plantinga::RotationModel& model, const std::vector<double>& wanted);

struct TurnError {
  std::size_t wrong_frames = 0;  // frames in which some edge has another structure
  double wrong_length = 0;       // missing and extra, in all frames
  double seen_length = 0;
  double all_length = 0;         // of all edges, hidden or not
};
// `shown` gives the angle of the frame that is shown at an angle.
[[nodiscard]] TurnError turn_error(
    const algorithms::plantinga::RotationModel& model, const algorithms::plantinga::EventList& list, const std::vector<ExactFrame>& frames,
    const std::function<double(double)>& shown = [](double angle) { return angle; });

}  // namespace sightline::compare
