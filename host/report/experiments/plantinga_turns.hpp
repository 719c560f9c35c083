// Tables 1 and 2 of Plantinga, Seales and Dyer (1990) for the six models here: the events of a full turn, the time to
// find them, and the time of frames of a turning model on this computer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/experiments/plantinga_models.hpp"

namespace sightline::report {

struct TurnModel {
  std::string model;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t events = 0;                // changes of edges
  std::size_t groups = 0;                // different directions
  double kb = 0;                         // size of the event file, units of 1024 bytes
  double per_edge = 0;                   // events
  std::size_t most = 0;                  // events of an edge
  std::optional<StudyTimes> times = {};  // empty without Context::host_times
  bool from_cache = false;
};

// Nanoseconds per frame: medians of rotations of 360 frames as in the paper, on one core.
struct TurnFrames {
  std::string model;
  double image_2_ns = 0;  // image coordinates, frames 2 degrees apart
  double image_6_ns = 0;
  double image_30_ns = 0;
  double space_2_ns = 0;  // coordinates in space
  double space_30_ns = 0;
  double steps_ns = 0;  // events only
  double wire_ns = 0;
  double image_drawn_ns = 0;
  double wire_drawn_ns = 0;
  double event_ns = 0;  // per group of events

  [[nodiscard]] double step_ratio() const { return image_30_ns / image_2_ns; }
  [[nodiscard]] double ratio() const { return image_2_ns / wire_ns; }
  [[nodiscard]] double ratio_drawn() const { return image_drawn_ns / wire_drawn_ns; }
};

struct ToleranceTimes {
  std::string model;
  double degrees = 0;
  double prepare_s = 0;
  double frame_ns = 0;
};

struct StepTimes {
  std::string model;
  double degrees = 0;
  double frame_ns = 0;
};

struct TurnBaseline {
  std::string model;
  double wire_ns = 0;
  double scratch_ns = 0;  // hidden-line removal from scratch
};

// Without Context::host_times there are only models.
struct PlantingaTurns {
  std::vector<TurnModel> models;
  std::vector<TurnFrames> frames;
  std::vector<ToleranceTimes> tolerances;  // one per model and tolerance
  std::vector<StepTimes> steps;            // one per model and angle from frame to frame
  std::vector<TurnBaseline> baselines;     // one per model
};

[[nodiscard]] PlantingaTurns plantinga_turns(const Context& context);

class Page;
void plantinga_timing(Page& page, const PlantingaTurns& turns);

}  // namespace sightline::report
