#include <string>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/draw_faces.hpp"
#include "host/app/commands/draw_lines.hpp"
#include "host/app/commands/draw_skala.hpp"

namespace sightline::app {

namespace {

constexpr const char* draw_examples =
    "Examples:\n"
    "  sightline draw exact part.off -o part.svg\n"
    "      a solid with its hidden lines removed, for a drawing program\n"
    "  sightline draw exact town-100 --hidden -o town.plt\n"
    "      a generated scene for a plotter, what is hidden dashed with the second pen\n"
    "  sightline draw skala sinc -o sinc.svg\n"
    "      a function of two variables, hidden lines removed, for a drawing program\n"
    "  sightline draw skala heights.csv --picture contours -o map.png\n"
    "      contours on a grid of heights\n";

}  // namespace

void add_draw_command(const Command& program) {
  std::string names;
  for (const harness::LineAlgorithm& algorithm : harness::line_algorithms())
    names += std::string(algorithm.name) + ", ";
  for (const harness::FaceAlgorithm& algorithm : harness::face_algorithms())
    if (harness::find_line_algorithm(algorithm.name) == nullptr) names += std::string(algorithm.name) + ", ";
  const Command command = program.add_command(
      "draw", "Draw without what is hidden, as SVG, PNG or HP-GL, by a native method: " + names + "skala");
  // One more line algorithm is a line in the table, none here.
  for (const harness::LineAlgorithm& algorithm : harness::line_algorithms()) {
    add_draw_lines(command.add_command(std::string(algorithm.name), std::string(algorithm.description)),
                   algorithm);
  }
  for (const harness::FaceAlgorithm& algorithm : harness::face_algorithms()) {
    if (harness::find_line_algorithm(algorithm.name) != nullptr) continue;
    add_draw_faces(command.add_command(std::string(algorithm.name), std::string(algorithm.description)),
                   algorithm);
  }
  add_draw_skala(
      command.add_command("skala", "A surface over a grid: lines, shaded or contours, after Skala (1985)"));
  command.footer(draw_examples);
}

}  // namespace sightline::app
