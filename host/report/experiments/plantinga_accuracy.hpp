// Plantinga, Seales and Dyer (1990): the errors of frames if events are joined within an angle tolerance, or if a
// frame is shown until the next one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// At random angles, compared with hidden-line removal from scratch.
struct TurnErrors {
  std::string model;
  double degrees = 0;            // the tolerance, or the step from frame to frame
  double topo_per_cent = 0;      // views with a wrong structure
  double expected_per_cent = 0;  // expected value of topo_per_cent if groups of events were evenly distributed
  double wvr_per_cent = 0;       // of the length of edges, wrongly visible or hidden
};

struct ToleranceErrors : TurnErrors {
  std::size_t groups = 0;  // of events
  double file_kb = 0;      // of 1024 bytes
};

struct HiddenShare {
  std::string model;
  std::size_t views = 0;
  double hidden_per_cent = 0;  // of the edges' length, hence wrong in the wire frame
};

struct PlantingaAccuracy {
  std::vector<ToleranceErrors> tolerances;  // one per model and angle tolerance
  std::vector<TurnErrors> steps;            // one per model and angle from frame to frame
  std::vector<HiddenShare> hidden;          // one per model
};

[[nodiscard]] PlantingaAccuracy plantinga_accuracy(const Context& context);

class Page;
struct PlantingaTurns;
void plantinga_accuracy_chapter(Page& page, const PlantingaAccuracy& measured, const PlantingaTurns& times);

}  // namespace sightline::report
