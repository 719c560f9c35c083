// See table_1.hpp.
#include "host/algorithms/plantinga/table_1.hpp"

#include <algorithm>
#include <vector>

#include "host/algorithms/plantinga/event_file.hpp"

namespace sightline::algorithms::plantinga {

std::array<Table1Row, 6> printed_table_1() {
  return {{{"Squares", 192, 192, 48, 2365, 28, 12.3, 25, 7, 0},
           {"Grid", 82, 105, 41, 1383, 36, 16.3, 60, 7, 0},
           {"Objects", 388, 800, 416, 5269, 120, 6.6, 30, 299, 0},
           {"Bars", 451, 880, 449, 9140, 204, 10.4, 112, 927, 0},
           {"Tori", 512, 1024, 512, 5134, 120, 5.0, 18, 440, 0},
           {"Spring", 909, 2709, 1800, 39953, 868, 14.7, 52, 3551, 0}}};
}

Table1Row table_1_row(std::string_view name, const RotationModel& model, const EventList& list,
                      double seconds) {
  std::vector<std::size_t> of_edge(model.edges().size());
  for (const Change& change : list.changes) ++of_edge[change.edge];
  Table1Row row;
  row.model = name;
  row.vertices = model.vertices().size();
  row.edges = model.edges().size();
  row.faces = model.faces().size();
  row.events = list.changes.size();
  row.kilobytes = static_cast<double>(encode_events(list).size()) / 1024;
  row.events_per_edge =
      static_cast<double>(row.events) / static_cast<double>(std::max<std::size_t>(row.edges, 1));
  for (const std::size_t count : of_edge)
    row.most_events_per_edge = std::max(row.most_events_per_edge, count);
  row.seconds = seconds;
  row.directions = list.events.size();
  return row;
}

}  // namespace sightline::algorithms::plantinga
