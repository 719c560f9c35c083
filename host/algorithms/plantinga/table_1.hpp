// The figures of Table 1 of Plantinga, Seales and Dyer (1990) for our list of events. Theirs are in
// host/compare/papers.json. In five of six rows, "Avg. events per edge" times the number of edges gives their number of
// events, so their events are changes of single edges; in the row Grid 16.3 x 105 = 1711, not 1383 (hard case P22).
#pragma once

#include <cstddef>
#include <string_view>

#include "host/algorithms/plantinga/event_list.hpp"

namespace sightline::algorithms::plantinga {

struct Table1Row {
  std::string_view model;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t events = 0;  // changes of single edges
  double kilobytes = 0;    // of 1024 bytes: size of the event file
  double events_per_edge = 0;
  std::size_t most_events_per_edge = 0;
  double seconds = 0;          // preprocessing time
  std::size_t directions = 0;  // number of distinct directions
};

// `seconds` is the time the caller measured for building the list.
[[nodiscard]] Table1Row table_1_row(std::string_view name, const RotationModel& model, const EventList& list,
                                    double seconds);

}  // namespace sightline::algorithms::plantinga
