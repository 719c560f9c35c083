// The pen of the Skala program on a plotter: visible points, fed one by one, become steps and pen movements;
// runs of one point are dropped and the pen is lifted only to travel. Source:
// firmware/i8080/skala/SPECIFICATION.md section 8.
#pragma once

#include <cstdint>
#include <vector>

#include "host/guests/skala/twin/line.hpp"
#include "host/guests/skala/twin/twin.hpp"

namespace sightline::guests::skala {

class PlotterPen {
 public:
  // Movements are appended to `moves` and counted in `counts`; both must outlive the pen.
  PlotterPen(std::vector<PlotterMove>& moves, TwinCounts& counts) : moves_(moves), counts_(counts) {}

  // The next visible point. Within a run it is a neighbour of the one before.
  void visible(Point point);
  // A hidden point, a movement to another place, or the end of the picture.
  void end_run() { run_points_ = 0; }
  void lift();
  // The step before was visible and belongs to the run a visible point would continue.
  [[nodiscard]] bool in_run() const { return run_points_ != 0; }

 private:
  void put_down_at(Point point);
  void step_towards(Point point);

  std::vector<PlotterMove>& moves_;
  TwinCounts& counts_;
  Point at_;  // where the pen really is
  bool down_ = false;
  int run_points_ = 0;  // of the present run, not counted beyond two
  Point remembered_;    // its first point
};

}  // namespace sightline::guests::skala
