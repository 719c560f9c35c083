#include "host/algorithms/plantinga/table_1.hpp"

#include <algorithm>
#include <vector>

#include "host/algorithms/plantinga/event_file.hpp"

namespace sightline::algorithms::plantinga {

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
