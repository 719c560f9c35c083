// Jones's program on the PDP-7: the five built-in scenes from their default views, with and without the EAE; a
// stereoscopic pair; a corridor that grows beyond the visible part. Measures the time and the core of a view.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A scene, with or without the EAE. The second view is measured: during it, the display shows the first and takes
// cycles.
struct JonesView {
  std::string scene;
  bool eae = true;
  double first_view_s = 0;
  double second_view_s = 0;
  std::uint64_t instructions = 0;
  std::uint64_t lines_clipped = 0;
  std::uint64_t pieces = 0;
  double refresh_s = 0;
  std::uint64_t stolen_cycles = 0;
  std::size_t cells = 0;
  std::size_t cells_read = 0;
  std::uint64_t visits = 0;
  std::uint64_t depth = 0;
  std::size_t openings = 0;
  std::uint64_t openings_tested = 0;
  std::uint64_t masks = 0;
  std::string devices;
  std::size_t program_words = 0;
  std::size_t scene_words = 0;
  std::size_t used_words = 0;
  std::size_t stack_words = 0;
  std::size_t file_words = 0;
  std::size_t file_room_words = 0;
  // Of the run with the EAE.
  std::optional<Picture> screen;
  std::optional<Picture> phosphor;
};

// The words of a scene's elements, as assembled, and those of openings as counted in Fig. 6.
struct JonesElements {
  std::string scene;
  std::size_t opening_words = 0;
  std::size_t opening_words_counted = 0;
  std::size_t cell_words = 0;
};

// corridor8 and corridor32: the same few rooms are visible. The first view, while the display takes no cycles.
struct JonesCorridor {
  std::string scene;
  bool eae = true;
  std::size_t cells = 0;
  std::size_t cells_read = 0;
  std::uint64_t visits = 0;
  std::uint64_t instructions = 0;
  double view_s = 0;
};

struct JonesViews {
  std::vector<JonesView> views;
  std::vector<JonesElements> elements;
  std::vector<JonesCorridor> corridors;
  double pair_s = 0;  // a view of roberts as a stereoscopic pair

  [[nodiscard]] const JonesView& view(std::string_view scene, bool eae) const;
  [[nodiscard]] Chosen<JonesView> of(bool eae) const { return where(views, equals(&JonesView::eae, eae)); }
  // Rooms that are not visible cost neither instructions nor time.
  [[nodiscard]] bool unseen_rooms_cost_nothing() const;
};

// The PDP-7's memory cycle, in microseconds.
[[nodiscard]] double jones_cycle_us();

[[nodiscard]] JonesViews jones_views(const Context& context);

void jones_timing(Page& page, const JonesViews& jones);
void jones_needs(Page& page, const JonesViews& jones);

}  // namespace sightline::report
