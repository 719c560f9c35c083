#include "host/report/scene_needs/unseen_building.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/report/guest_runs.hpp"
#include "host/report/scene_needs/unseen_native.hpp"

namespace sightline::harness::report {

namespace {

// The guest: a corridor of rooms in a row, of which the same few are seen.
Outcome<Table> corridors(const Context& context) {
  Table table;
  table.id = "unseen-guest";
  table.title = "Jones on the PDP-7: a corridor that grows behind what is seen";
  table.columns = {{"scene", "Scene", "", false},
                   {"eae", "EAE", "", false},
                   {"cells", "Cells", "in the scene", false},
                   {"cells_read", "Cells", "read", false},
                   {"visits", "Visits", "", false},
                   {"instructions", "Instructions", "", false},
                   {"view_s", "First view", "s", false}};
  for (const bool eae : {true, false}) {
    for (const char* const name : {"corridor8", "corridor32"}) {
      context.progress(fmt::format("{} on the PDP-7", name));
      const auto made = run_jones({name, eae, false, false});
      if (!made) return made.error();
      const auto& run = *made;
      const guests::jones::GuestView& view = run.guest.views.front();
      table.rows.push_back({std::string(name), std::string(eae ? "yes" : "no"),
                            static_cast<std::int64_t>(run.scene.cells.size()),
                            static_cast<std::int64_t>(view.distinct_cells),
                            static_cast<std::int64_t>(view.visits),
                            static_cast<std::int64_t>(view.instructions), Real{seconds(view.time), 6}});
    }
  }
  table.notes = {
      "The first view, while the display takes no cycles. The only thing that grows with the unseen rooms is "
      "the core they stand in."};
  return table;
}

}  // namespace

Outcome<std::vector<Block>> unseen_building(const Context& context) {
  auto guest = corridors(context);
  if (!guest) return std::move(guest.error());
  std::vector<Block> blocks;
  blocks.emplace_back(std::move(*guest));
  auto native = unseen_native(context);
  if (!native) return std::move(native.error());
  for (Block& block : *native) blocks.push_back(std::move(block));
  return blocks;
}

}  // namespace sightline::harness::report
