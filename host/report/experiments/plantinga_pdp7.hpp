// Solids turning with hidden lines on the PDP-7 (firmware/pdp7/turn): the on-line phase of Plantinga, Seales and Dyer
// on a machine of 1965.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// One turn of a model in 8 emulated seconds, and the same turn as a wire frame.
struct Pdp7Turn {
  std::string model;
  bool eae = false;
  std::uint32_t edges = 0;
  std::uint32_t events = 0;      // different angles
  std::uint32_t used_words = 0;  // of core
  double turn_s = 0;
  double frames_a_second = 0;
  double worst_frames_a_second = 0;
  double wire_frames_a_second = 0;
  double cost = 0;       // time of a frame divided by that of a wire frame
  double junctions = 0;  // T-junctions drawn, mean per frame
  double waiting_percent = 0;
  double refreshes_a_second = 0;
  std::optional<Picture> screen = {};  // after an eighth of a turn; for runs with the EAE
};

[[nodiscard]] std::vector<Pdp7Turn> plantinga_pdp7(const Context& context);

class Page;
void plantinga_pdp7_chapter(Page& page, const std::vector<Pdp7Turn>& turns);

}  // namespace sightline::report
