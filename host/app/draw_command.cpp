#include "host/app/draw_command.hpp"

#include <CLI/CLI.hpp>
#include <array>

#include "host/app/draw_skala.hpp"

namespace sightline::app {

namespace {

constexpr const char* draw_examples =
    "Examples:\n"
    "  sightline draw skala sinc -o sinc.svg\n"
    "      a function of two variables, hidden lines removed, for a drawing program\n"
    "  sightline draw skala heights.csv --picture contours -o map.png\n"
    "      contours on a grid of heights\n";

struct DrawAlgorithm {
  const char* name;
  const char* description;
  void (*add)(CLI::App& command, ExitCode& exit_code);
};

// An algorithm is a line here and the function it names.
constexpr std::array algorithms{
    DrawAlgorithm{"skala", "A surface over a grid: lines, shaded or contours, after Skala (1985)",
                  add_draw_skala},
};

}  // namespace

void add_draw_command(CLI::App& app, ExitCode& exit_code) {
  CLI::App* const command =
      app.add_subcommand("draw", "Draw without what is hidden, as SVG, PNG or HP-GL, by a native algorithm");
  command->require_subcommand(1);
  for (const DrawAlgorithm& algorithm : algorithms)
    algorithm.add(*command->add_subcommand(algorithm.name, algorithm.description), exit_code);
  command->footer(draw_examples);
}

}  // namespace sightline::app
