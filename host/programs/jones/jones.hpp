// Runs Jones's program on the emulated PDP-7 with its Type 340: takes a scene and an order, returns views.
//
// run() assembles the program with the scene, loads it, sets the switches, runs it, and reads each view from the machine:
// its display file, its time, and the cells it entered. Prepared assembles once for any number of views.
//
// The time of a view runs from the fetch at `search` to the store into `file`; if lines are added at once, to the count of
// complete views. An observer measures it: nothing is added to the program. The native twin (twin/twin.hpp) runs only if
// the order asks for a check.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/console.hpp"
#include "host/base/result.hpp"
#include "host/programs/jones/program.hpp"
#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "host/programs/jones/walk_path.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::programs::jones {

struct Order {
  std::optional<geometry::Point> eye;  // default: the scene's default view
  std::optional<std::int32_t> scale;   // 64..4096; default: the program's own, 512
  bool stereo = false;                 // AC switch 17
  bool immediate = false;              // AC switch 16: lines are added at once
  bool clock = true;
  std::vector<pdp7::SwitchSetting> switches;  // a script of the console switches, instead of `stereo` and `immediate`
  // Only for a build with the walk: the move before each view after the first, as the switches would have summed it;
  // turns only for a build with rotation. The views are then one more than these.
  std::vector<Move> walk;
  std::int32_t angle = 0;  // only for a build with rotation: direction of the first view, degrees to the right of +z
  int views = 2;
  bool display = true;                        // false: views are computed with no display on the machine
  core::Duration photograph{};                // keep strokes for this long after the last view's first pass
  bool film = false;                          // keep the strokes of the first view while it is computed
  bool pieces = false;                        // read the line pieces of each view from the machine
  core::Duration time_limit = core::seconds(600);  // emulated
  // Compares the last view with the twin's, word for word, and the eye of each view of a walk. The switches must not change
  // during the run: the twin models nothing between views but the order's own walk.
  bool check = false;
};

// One view, read from the machine.
struct View {
  Status status = Status::complete;
  core::Duration time{};  // the paper's computing time
  std::uint64_t instructions = 0;
  std::uint64_t stolen_cycles = 0;
  std::uint64_t visits = 0;
  std::uint64_t distinct_cells = 0;  // cells whose words the processor read
  std::uint64_t openings_tested = 0;
  std::uint64_t lines_clipped = 0;
  std::uint64_t pieces = 0;
  std::vector<core::Word18> display_file;  // from its first word to the stop word
  geometry::Point eye{};
  std::size_t cell = 0;      // of the eye; the number of cells if it is in none
  std::uint32_t stops = 0;   // 1, 2, 4: a wall stopped the eye along x, y, z; 0 without the walk
  std::int32_t angle = 0;    // direction of the view, 0..359 degrees to the right of +z
  // Only for orders with `pieces`, of one eye: the pieces as they left the clip, and the ends of each in points of the
  // screen.
  std::vector<Piece> clipped;
  std::vector<ScreenSegment> on_display;
};

struct Outcome {
  geometry::Point eye{};
  std::uint32_t core_words = 0;  // core needed by the run
  std::vector<View> views;  // as many as the order asks for
  std::uint64_t instructions = 0;
  core::Duration emulated{};
  // The display: one pass through the last view's file, from IDLA to its stop, and the time from one IDLA to the next.
  std::vector<core::Stroke> pass;
  core::Duration refresh_period{};       // 0: not observed, as for an empty picture
  std::vector<core::Stroke> photograph;  // strokes up to shutter_close
  core::Instant shutter_close{};
  std::vector<core::Stroke> film;        // of the first view, from the start of the program
  core::Instant film_end{};

  [[nodiscard]] const View& view() const { return views.back(); }  // the last one
  [[nodiscard]] double refreshes_per_second() const;               // 0: not observed
};

// The scene must have been checked. Errors: bad_input, the program does not accept the eye, or the scene does not fit into
// core; program_failed, the views are not complete within the time limit; differs, the last view is not its twin's.
[[nodiscard]] base::Result<Outcome> run(const scene::CellScene& scene, const Build& build = {}, const Order& order = {});

// The same with core that a caller has changed, as a person at the console would: core_words words of this program. The eye
// of the order is ignored: it is in core.
[[nodiscard]] base::Result<Outcome> run_core(const Program& program, std::span<const core::Word18> core, const Order& order = {});
// The twin for such core.
[[nodiscard]] TwinView run_twin(const Program& program, std::span<const core::Word18> core, const Order& order = {});

// The program assembled for a scene and a build, for views from any eye. Several threads may run it at once.
//
// Another eye changes only the header of the scene in core (SPECIFICATION.md section 7), so the program is not assembled
// again. Another scene needs assembly: constants follow the scene, and their addresses occur throughout the program.
class Prepared {
 public:
  // The scene must have been checked. Errors: bad_input, the program accepts no eye in it, or it does not fit into core.
  [[nodiscard]] static base::Result<Prepared> of(const scene::CellScene& scene, const Build& build = {});

  // Its core has the eye of the scene's default view or, if the program does not accept that, the middle of a cell.
  [[nodiscard]] const Program& program() const { return program_; }
  // Core with this eye, equal to the program assembled with it, word for word. Errors: those of viewpoint().
  [[nodiscard]] base::Result<std::vector<core::Word18>> core_at(const geometry::Point& eye) const;

  // Errors: those of the function run() above.
  [[nodiscard]] base::Result<Outcome> run(const Order& order = {}) const;
  // Runs only the twin. Error: the program does not accept the eye.
  [[nodiscard]] base::Result<TwinView> twin(const Order& order = {}) const;

 private:
  Prepared(const scene::CellScene& scene, Program program);
  [[nodiscard]] geometry::Point eye_of(const Order& order) const { return order.eye.value_or(scene_.default_view); }

  scene::CellScene scene_;
  Program program_;
};

// The difference of a view on the machine from its twin: the status, or the first word of the display file. Empty: equal.
[[nodiscard]] std::string difference_of(const View& view, const TwinView& twin);
// The same for a walk: each eye, and the last view.
[[nodiscard]] std::string difference_of_walk(const Program& program, std::span<const core::Word18> core, const Order& order, const Outcome& outcome);

}  // namespace sightline::programs::jones
