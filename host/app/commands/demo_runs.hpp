// Runs of `sightline demo` on the emulated machines: Jones's program on its scenes, solids turning, and flights with the priority
// display, each with its table and its JSON. (skala_demo.hpp and stripes_demo.hpp have the others.)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/programs/flight/flight.hpp"
#include "host/base/json.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/programs/turn/turn.hpp"

namespace sightline::app {

// A built-in scene of cells, with or without the EAE.
struct JonesRow {
  std::string scene;
  bool eae = false;
  std::size_t cells = 0;
  std::uint32_t words = 0;
  programs::jones::View view;
  double refreshes = 0;
};
// Writes SCENE.png, -phosphor.png and .svg into `directory`. Errors as of jones::run, or io.
[[nodiscard]] std::vector<JonesRow> run_jones_demo(const std::string& directory);
[[nodiscard]] std::string jones_table(const std::vector<JonesRow>& rows);
// Adds "views".
void add_jones_rows(base::Json& document, const std::vector<JonesRow>& rows);

// A walk from cell to cell, with the EAE or without.
struct WalkRow {
  std::string scene;
  bool rotation = false;
  bool eae = false;
  std::size_t views = 0;
  std::size_t entered = 0;  // cells
  std::size_t cells = 0;
  double mean_s = 0;
  double worst_s = 0;
  std::uint32_t words = 0;
};
// Writes SCENE-walk.png, -walk-phosphor.png and -walk.svg, the last view with the EAE, into `directory`; -turned-walk for walks on
// which the view turns. Errors as above.
[[nodiscard]] std::string walk_stem(const std::string& scene, bool rotation);
[[nodiscard]] std::vector<WalkRow> run_walks(const std::string& directory);
[[nodiscard]] std::string walk_table(const std::vector<WalkRow>& rows);
// Adds "walks".
void add_walks(base::Json& document, const std::vector<WalkRow>& rows);

// A turning solid, with or without the EAE.
struct TurnRow {
  std::string model;
  bool eae = false;
  std::uint32_t edges = 0;
  programs::turn::Outcome outcome;
};
[[nodiscard]] std::vector<TurnRow> run_turns();
[[nodiscard]] std::string turn_table(const std::vector<TurnRow>& rows);
// Adds "turns".
void add_turns(base::Json& document, const std::vector<TurnRow>& rows);

// A solid turning on this computer, about another axis than the vertical one or in perspective, as `sightline spin` does.
struct CircleRow {
  std::string model;
  std::string view;  // "about 1,3,0, from 20 degrees above, in perspective"
  std::string file;
  std::size_t edges = 0;
  std::uint64_t events = 0;
  int frames = 0;
  int right = 0;  // frames whose lines are as long as those of the exact method, which draws each from scratch
};
// Writes MODEL-axis.apng and MODEL-perspective.apng into `directory`. Errors as above.
[[nodiscard]] std::vector<CircleRow> run_circles(const std::string& directory);
[[nodiscard]] std::string circle_table(const std::vector<CircleRow>& rows);
// Adds "circles".
void add_circles(base::Json& document, const std::vector<CircleRow>& rows);

// A flight with the priority display.
struct FlightRow {
  std::string scene;
  int bits = 8;
  programs::flight::Summary summary;
};
[[nodiscard]] std::vector<FlightRow> run_flights();
[[nodiscard]] std::string demo_flight_table(const std::vector<FlightRow>& rows);
// Adds "flights".
void add_flights(base::Json& document, const std::vector<FlightRow>& rows);

}  // namespace sightline::app
