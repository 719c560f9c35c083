#include "host/report/experiments/jones_walk.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/text.hpp"
#include "host/base/value_of.hpp"
#include "host/compare/jones_bound.hpp"
#include "host/compare/lines.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/programs/jones/known_walks.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;
namespace oracle = algorithms::oracle;

constexpr double most_time = 1.1;  // of the program without the walk

// The greatest distance of the lines of a view on the display from the exact ones. direction: of a turned view.
double farthest_of(const scene::CellScene& scene, const jones::View& view, const std::optional<jones::Direction>& direction = {}) {
  const auto matter = oracle::Matter::of(scene);
  if (!matter) throw base::bad_input(fmt::format("{}: too large for exact lines", scene.name));
  const oracle::Window window = compare::type340_window();
  std::vector<picture::PixelSegment> exact, drawn;
  const auto lines = direction ? oracle::turned_view(*matter, matter->real_lines(), view.eye, window, direction->cosine, direction->sine)
                               : oracle::on_screen(oracle::visible_lines(*matter, matter->real_lines(), view.eye, window), view.eye, window);
  for (const auto& line : lines)
    exact.push_back({{line.x0, line.y0}, {line.x1, line.y1}});
  for (const auto& line : view.on_display)
    drawn.push_back({{static_cast<double>(line.a.x), static_cast<double>(line.a.y)}, {static_cast<double>(line.b.x), static_cast<double>(line.b.y)}});
  return picture::directed_hausdorff_distance(drawn, exact).greatest;
}

// The second view from this eye, without the walk.
double standing_time(const jones::Prepared& standing, const geometry::Point& eye, const std::string& scene) {
  jones::Order order;
  order.eye = eye;
  return seconds(base::value_of(standing.run(order), scene).view().time);
}

struct BothPrograms {
  jones::Prepared walking;
  jones::Prepared standing;
};

BothPrograms programs_of(const scene::CellScene& scene, bool eae) {
  return {base::value_of(jones::Prepared::of(scene, {.eae = eae, .walk = true}), scene.name),
          base::value_of(jones::Prepared::of(scene, {.eae = eae}), scene.name)};
}

// By which the program grows for any scene, also for one that then has too many words for the machine.
std::size_t words_for_rotation(bool eae) {
  const scene::CellScene house = base::value_of(scene::load_cell_scene("house"), "house");
  const auto words = [&](bool rotation) {
    return base::value_of(jones::Prepared::of(house, {.eae = eae, .walk = true, .rotation = rotation}), house.name).program().program_words;
  };
  return words(true) - words(false);
}

jones::Order order_of(const jones::KnownWalk& known) {
  jones::Order order;
  order.walk = base::value_of(jones::read_walk(known.steps), std::string(known.scene));
  order.check = true;
  order.pieces = true;
  order.photograph = shutter_time;
  return order;
}

void add_walk(JonesWalks& walks, const jones::KnownWalk& known) {
  const std::string name(known.scene);
  const scene::CellScene scene = base::value_of(scene::load_cell_scene(name), name);
  const jones::Order order = order_of(known);
  const compare::JonesWords words;
  const std::size_t first = walks.steps.size();
  for (const bool eae : {true, false}) {
    const BothPrograms programs = programs_of(scene, eae);
    const jones::Outcome outcome = base::value_of(programs.walking.run(order), name);
    for (std::size_t n = 1; n < outcome.views.size(); ++n) {
      const jones::View& view = outcome.views[n];
      const double standing = standing_time(programs.standing, view.eye, name);
      if (eae)
        walks.steps.push_back({name, n + 1, base::joined(view.eye, ","), view.cell, jones::axes_of(view.stops), seconds(view.time), standing, 0, 0, farthest_of(scene, view),
                               compare::jones_line_bound(compare::jones_piece_bound(scene, view.eye, words), words)});
      else
        std::tie(walks.steps[first + n - 1].walking_without_eae_s, walks.steps[first + n - 1].standing_without_eae_s) = std::pair(seconds(view.time), standing);
    }
    const jones::Program& program = programs.walking.program();
    walks.words.push_back({name, eae, scene.cells.size(), 3 * scene.cells.size(), program.program_words, program.words_used, programs.standing.program().words_used, program.words_used + words_for_rotation(eae)});
    if (eae) walks.last.emplace_back(name, phosphor_png(outcome));
  }
}

void add_turned_walk(JonesWalks& walks, const jones::KnownWalk& known) {
  const std::string name(known.scene);
  const scene::CellScene scene = base::value_of(scene::load_cell_scene(name), name);
  const jones::Order order = order_of(known);
  const compare::JonesWords words;
  const std::size_t first = walks.turned.size();
  for (const bool eae : {true, false}) {
    const jones::Outcome outcome = base::value_of(jones::run(scene, {.eae = eae, .walk = true, .rotation = true}, order), name);
    for (std::size_t n = 1; n < outcome.views.size(); ++n) {
      const jones::View& view = outcome.views[n];
      if (!eae) {
        walks.turned[first + n - 1].turned_without_eae_s = seconds(view.time);
        continue;
      }
      const jones::Direction direction = jones::direction_of(view.angle);
      walks.turned.push_back({name, n + 1, base::joined(view.eye, ","), view.angle, seconds(view.time), 0, farthest_of(scene, view, direction),
                              compare::jones_line_bound(compare::jones_piece_bound(scene, view.eye, words, direction), words)});
    }
    if (eae) walks.last.emplace_back(name + "-turned", phosphor_png(outcome));
  }
}

double ratio_of(const JonesStep& step) { return step.walking_s / step.standing_s; }

}  // namespace

JonesWalks jones_walks(const Context& context) {
  JonesWalks walks;
  for (const jones::KnownWalk& known : jones::known_walks) {
    context.progress(fmt::format("a walk through {} on the PDP-7", known.scene));
    add_walk(walks, known);
  }
  for (const jones::KnownWalk& known : jones::known_turned_walks) {
    context.progress(fmt::format("a walk through {} on the PDP-7, the view turning", known.scene));
    add_turned_walk(walks, known);
  }
  return walks;
}

void jones_walk_chapter(Page& page, const JonesWalks& walks) {
  using Step = JonesStep;
  using Words = JonesWalkWords;
  const auto all = [&](auto holds) { return std::all_of(walks.steps.begin(), walks.steps.end(), holds); };
  const double walking = sum(walks.steps, &Step::walking_s) / sum(walks.steps, &Step::standing_s);
  const double walking_without_eae = sum(walks.steps, &Step::walking_without_eae_s) / sum(walks.steps, &Step::standing_without_eae_s);
  const bool near = all([](const Step& step) { return step.farthest <= step.bound; });
  page.table("jones-walk", "Jones: a walk from cell to cell", walks.steps,
             {{"scene", "Scene", &Step::scene},
              {"view", "View", &Step::view},
              {"eye", "Eye", &Step::eye},
              {"cell", "Cell", &Step::cell},
              {"stopped", "Wall", "axis", &Step::stopped},
              {"walking_s", "View", "s", &Step::walking_s, 3},
              {"standing_s", "Without the walk", "s", &Step::standing_s, 3},
              {"ratio", "Ratio", [](const Step& step) { return ratio_of(step); }, 3},
              {"walking_without_eae_s", "View without EAE", "s", &Step::walking_without_eae_s, 3},
              {"standing_without_eae_s", "Without the walk", "s", &Step::standing_without_eae_s, 3},
              {"farthest", "Farthest line", "points", &Step::farthest, 2},
              {"bound", "Bound", "points", &Step::bound, 2}},
             {{"Jones left out what he called ideal, \"complete freedom of movement of the viewpoint\", because it needs the planes of the cells. Here the "
               "program has them (`sightline jones house --walk \"in 100\"`): it finds the cell of the eye and follows it through portals as the switches move it. "
               "The eyes, the cells and the last display file must equal the native twin's, or the report ends with an error. " +
               page.claim(walking <= most_time && walking_without_eae <= most_time, "On the way a view takes at most 1.1 times as long as in the program without the walk from the same eye, on average.", fmt::format("{:.3f} and {:.3f} times", walking, walking_without_eae)) + " " +
               page.claim(near, "No line is farther from the exact ones than the lengths of words allow.")}});
  using Turned = JonesTurnedStep;
  const bool turned_near = std::all_of(walks.turned.begin(), walks.turned.end(), [](const Turned& step) { return step.farthest <= step.bound; });
  page.table("jones-turned-walk", "Jones: a walk on which the view turns", walks.turned,
             {{"scene", "Scene", &Turned::scene},
              {"view", "View", &Turned::view},
              {"eye", "Eye", &Turned::eye},
              {"angle", "Direction", "degrees", &Turned::angle},
              {"turned_s", "View", "s", &Turned::turned_s, 3},
              {"turned_without_eae_s", "View without EAE", "s", &Turned::turned_without_eae_s, 3},
              {"farthest", "Farthest line", "points", &Turned::farthest, 2},
              {"bound", "Bound", "points", &Turned::bound, 2}},
             {{"An option of the build turns the view about the vertical by whole degrees, to the right of +z (`sightline jones house --turn -45`). All vectors of a scene are parallel to "
               "the axes; turned, their ends are sums of exact products. " +
               page.claim(turned_near, "In these views too no line is farther from the exact ones than the lengths of words allow.")}});
  page.table("jones-walk-words", "Jones: words for the walk", walks.words,
             {{"scene", "Scene", &Words::scene},
              {"eae", "EAE", &Words::eae},
              {"cells", "Cells", &Words::cells},
              {"plane_words", "Planes", "words", &Words::plane_words},
              {"program_words", "Program", "words", &Words::program_words},
              {"used_words", "In all", "words", &Words::used_words},
              {"used_words_standing", "Without the walk", "words", &Words::used_words_standing},
              {"used_words_turning", "With rotation", "words", &Words::used_words_turning},
              {"core_words", "Capacity", "words", [](const Words&) { return jones::core_words; }}},
             {{"A plane is one word, because all planes are parallel to two axes. Three of a cell's six are in its origin, which Jones's elements have too. The records "
               "of the openings are beside them, not in a table of fixed size. Rotation takes more words than the capacity for street4."}});
  page.gallery("jones-walk-screens", "Jones: where the walks end, photographed", walks.last, [](const std::pair<std::string, Picture>& last) {
    return figure(last.second, "walk-" + last.first, last.first, {"the last view of the walk"}, fmt::format("Hidden-line drawing of the scene {} at the end of a walk, on the Type 340", last.first));
  });
}

}  // namespace sightline::report
