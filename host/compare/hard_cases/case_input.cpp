#include "host/compare/hard_cases/case_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/heights/read_grid.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::compare {

namespace {

namespace oracle = algorithms::oracle;
namespace skala = programs::skala;
using picture::PixelGrid;
using scene::PolyScene;

using InputResult = base::Result<CaseInput, std::string>;

InputResult load_scene(PolyScene scene) {
  if (const auto errors = scene::check_poly_scene(scene); !errors.empty()) return errors.front().message();
  CaseInput input;
  input.scene = std::move(scene);
  return input;
}

InputResult load_cells(std::string_view text, const std::string& file) {
  auto read = scene::read_possible_cell_scene(text, file);
  if (!read) return read.error().message();
  CaseInput input;
  input.cells = std::move(*read);
  input.scene = scene::poly_scene_of(*input.cells);
  return input;
}

InputResult load_heights(std::string_view text, const std::string& file) {
  auto read = scene::read_height_grid(text, file);
  if (!read) return read.error().message();
  CaseInput input;
  input.heights = std::move(*read);
  return input;
}

InputResult load_model(std::string_view text, const std::string& file) {
  auto read = scene::read_poly(text, file, scene::PolyFormat::off);
  if (!read) return read.error().message();
  return load_scene(std::move(read->scene));
}

PixelGrid dots_of(const std::vector<oracle::Chain>& chains) {
  PixelGrid grid(skala::raster_side, skala::raster_side);
  const auto picture = oracle::column_picture(chains, 0);
  for (int x = 0; x < skala::raster_side; ++x) {
    for (int y = 0; y < skala::raster_side; ++y)
      grid.set(x, y, picture.lit[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] ? 1 : 0);
  }
  return grid;
}

// Commands by name, their arguments in decimal.
InputResult load_commands(std::string_view text, const HardCase& hard) {
  CommandScreen screen{{}, dots_of(hard.chains)};
  constexpr std::string_view blanks = " \r\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty()) break;
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    const auto row = std::find_if(skala::commands.begin(), skala::commands.end(),
                                  [word](const skala::CommandRow& r) { return r.name == word; });
    std::uint8_t byte = row != skala::commands.end() ? static_cast<std::uint8_t>(row->command) : 0;
    if (row == skala::commands.end()) {
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), byte);
      if (error != std::errc{} || end != word.data() + word.size())
        return fmt::format("{}: found \"{}\", expected a command or a byte", hard.input, word);
    }
    screen.stream.push_back(byte);
  }
  CaseInput input;
  input.screens.push_back(std::move(screen));
  return input;
}

// All lines of up to 16 steps in both directions, each from either end, without the visibility test: 49 per screen,
// far apart.
CaseInput all_octants() {
  constexpr int reach = 16;
  constexpr int pitch = 36;
  constexpr int across = 7;
  const auto byte = [](auto value) { return static_cast<std::uint8_t>(value); };
  CaseInput input;
  for (int number = 0; number < (2 * reach + 1) * (2 * reach + 1); ++number) {
    const int u = number / (2 * reach + 1) - reach;
    const int v = number % (2 * reach + 1) - reach;
    const int place = number % (across * across);
    if (place == 0)
      input.screens.push_back(
          {{byte(skala::Command::device), skala::no_visibility, byte(skala::Command::reset)},
           PixelGrid(skala::raster_side, skala::raster_side)});
    CommandScreen& screen = input.screens.back();
    const std::array from{byte(18 + pitch * (place % across)), byte(18 + pitch * (place / across))};
    const std::array to{byte(from[0] + u), byte(from[1] + v)};
    for (const auto& [begin, end] : {std::pair{from, to}, std::pair{to, from}})
      screen.stream.insert(screen.stream.end(), {byte(skala::Command::move), begin[0], begin[1],
                                                 byte(skala::Command::draw), end[0], end[1]});
    for (const oracle::RasterDot& dot : oracle::segment_dots(from[0], from[1], to[0], to[1]))
      screen.truth.set(dot.x, dot.y, 1);
  }
  for (CommandScreen& screen : input.screens) screen.stream.push_back(byte(skala::Command::end));
  return input;
}

}  // namespace

base::Result<CaseInput, std::string> load_input(const HardCase& hard) {
  if (hard.input == "octants") return all_octants();
  const std::string_view text = hard_case_text(hard.input);
  if (text.empty()) return "found no file " + hard.input;
  if (hard.input.ends_with(".off")) return load_model(text, hard.input);
  if (hard.input.ends_with(".csv") || hard.input.ends_with(".dat")) return load_heights(text, hard.input);
  if (hard.input.ends_with(".txt")) return load_commands(text, hard);
  if (!scene::is_poly_json(text)) return load_cells(text, hard.input);
  auto read = scene::read_poly_json(text, hard.input);
  if (!read) return read.error().message();
  return load_scene(std::move(*read));
}

}  // namespace sightline::compare
