// How long frames of a turning model take on this computer.
#pragma once

#include <array>

#include "host/report/plantinga_models.hpp"

namespace sightline::harness::report {

// Nanoseconds of the processor, one core: medians of rotations of 360 frames, as the paper's.
struct PlantingaFrameTimes {
  std::array<double, 3>
      image{};  // the event structure brought up to date, image coordinates: 2, 6, 30 degrees
  std::array<double, 2> space{};  // the same, coordinates in space: 2, 30 degrees
  double steps = 0;               // the event structure alone, 2 degrees
  double wire = 0;                // every edge whole, image coordinates
  double drawn = 0;               // 2 degrees, and every line as pixels of 1024 by 1024
  double wire_drawn = 0;
  double an_event = 0;  // one event, forwards
};

[[nodiscard]] PlantingaFrameTimes measure_frames(const StudiedModel& studied, int rounds);

// A frame of visible lines, image coordinates, so many degrees after the one before.
[[nodiscard]] double frame_nanoseconds(const algorithms::plantinga::RotationModel& model,
                                       const algorithms::plantinga::EventList& list, double step, int rounds);

}  // namespace sightline::harness::report
