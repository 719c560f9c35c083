#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "host/base/number.hpp"
#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/program.hpp"
#include "host/guests/skala/projection.hpp"
#include "host/guests/skala/twin/twin.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/hard_cases/skala.hpp"

namespace sightline::harness::report {

namespace {

namespace oracle = algorithms::oracle;
using picture::PixelGrid;

constexpr const char* no_native = "not applicable: draws grids, and lines instead of dots";

std::string_view next_word(std::string_view& text) {
  const std::size_t from = std::min(text.find_first_not_of(" \r\n"), text.size());
  text.remove_prefix(from);
  const std::string_view word = text.substr(0, text.find_first_of(" \r\n"));
  text.remove_prefix(word.size());
  return word;
}

// Commands by name and their arguments in decimal, as bytes. Nothing for a word that is neither.
std::optional<std::vector<std::uint8_t>> bytes_of(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    const auto row = std::find_if(guests::skala::commands.begin(), guests::skala::commands.end(),
                                  [word](const guests::skala::CommandRow& r) { return r.name == word; });
    if (row != guests::skala::commands.end()) {
      bytes.push_back(static_cast<std::uint8_t>(row->command));
      continue;
    }
    const auto value = base::whole_number<std::uint8_t>(word);
    if (!value) return std::nullopt;
    bytes.push_back(*value);
  }
  return bytes;
}

PixelGrid grid_of(const core::Raster& raster) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = raster.points()[i] != 0 ? 1 : 0;
  return grid;
}

PixelGrid truth_of(const std::vector<oracle::Chain>& chains) {
  PixelGrid grid(guests::skala::raster_side, guests::skala::raster_side);
  const auto picture = oracle::column_picture(chains, 0);
  for (int x = 0; x < guests::skala::raster_side; ++x) {
    for (int y = 0; y < guests::skala::raster_side; ++y)
      grid.set(x, y, picture.lit[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] ? 1 : 0);
  }
  return grid;
}

Cell compared(const PixelGrid& truth, const PixelGrid& drawn) {
  std::size_t missing = 0;
  std::size_t extra = 0;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    missing += truth.values[i] > drawn.values[i] ? 1 : 0;
    extra += truth.values[i] < drawn.values[i] ? 1 : 0;
  }
  if (missing + extra == 0) return Verdict{true, "right"};
  return Verdict{false, fmt::format("differs: {} dots missing, {} too many", missing, extra)};
}

struct Runs {
  guests::skala::GuestPicture guest;
  guests::skala::TwinPicture twin;
};

Runs run(const guests::skala::Program& program, const std::vector<std::uint8_t>& stream) {
  return {guests::skala::run_guest(program, stream), guests::skala::run_twin(stream)};
}

Cell guest_cell(const Runs& runs, const PixelGrid& truth) {
  if (!runs.guest.ended || runs.guest.status != guests::skala::Status::complete)
    return Verdict{false, fmt::format("differs: stops: {}", text_of(runs.guest.status))};
  const std::string difference =
      guests::skala::difference_from_twin(runs.guest, runs.twin, guests::skala::Device::ef9365);
  if (!difference.empty()) return Verdict{false, "differs: not its twin's picture: " + difference};
  return compared(truth, grid_of(runs.guest.raster));
}

Cell counted(const PixelGrid& truth, const std::optional<std::size_t>& expected) {
  const auto lit = static_cast<std::size_t>(std::count(truth.values.begin(), truth.values.end(), 1U));
  if (!expected || lit == *expected) return Verdict{true, "right"};
  return Verdict{false, fmt::format("differs: {} dots, not {}", lit, *expected)};
}

// Lines from one place on the screen, one by one, without the visibility test.
class Fan {
 public:
  void add(int x, int y, int u, int v) {
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    for (const bool forwards : {true, false}) {
      const auto from = forwards ? std::pair{x, y} : std::pair{x + u, y + v};
      const auto to = forwards ? std::pair{x + u, y + v} : std::pair{x, y};
      const auto move = {
          static_cast<std::uint8_t>(guests::skala::Command::move), byte(from.first), byte(from.second),
          static_cast<std::uint8_t>(guests::skala::Command::draw), byte(to.first),   byte(to.second)};
      stream_.insert(stream_.end(), move);
    }
    for (const oracle::RasterDot& dot : oracle::segment_dots(x, y, x + u, y + v)) truth_.set(dot.x, dot.y, 1);
  }
  [[nodiscard]] const PixelGrid& truth() const { return truth_; }
  [[nodiscard]] std::vector<std::uint8_t> stream() const {
    std::vector<std::uint8_t> whole{static_cast<std::uint8_t>(guests::skala::Command::device),
                                    guests::skala::no_visibility,
                                    static_cast<std::uint8_t>(guests::skala::Command::reset)};
    whole.insert(whole.end(), stream_.begin(), stream_.end());
    whole.push_back(static_cast<std::uint8_t>(guests::skala::Command::end));
    return whole;
  }

 private:
  std::vector<std::uint8_t> stream_;
  PixelGrid truth_{guests::skala::raster_side, guests::skala::raster_side};
};

// 49 lines a screen, none near another.
std::vector<Fan> fans() {
  constexpr int reach = 16;
  constexpr int pitch = 36;
  constexpr int across = 7;
  std::vector<Fan> all;
  int number = 0;
  for (int u = -reach; u <= reach; ++u) {
    for (int v = -reach; v <= reach; ++v, ++number) {
      const int place = number % (across * across);
      if (place == 0) all.emplace_back();
      all.back().add(18 + pitch * (place % across), 18 + pitch * (place / across), u, v);
    }
  }
  return all;
}

bool is_right(const Cell& cell) {
  const auto* const verdict = std::get_if<Verdict>(&cell);
  return verdict == nullptr || verdict->good;
}

}  // namespace

SkalaHardResult run_commands(const SkalaHardCase& hard) {
  const auto stream = bytes_of(hard_case_text(hard.file));
  if (!stream) return {Verdict{false, "no commands"}, Verdict{false, "no commands"}, no_native, Cell()};
  const PixelGrid truth = truth_of(hard.chains);
  const Runs runs = run(guests::skala::assemble_program(), *stream);
  return {guest_cell(runs, truth), compared(truth, grid_of(runs.twin.raster(guests::skala::Device::ef9365))),
          std::string(no_native), counted(truth, hard.lit)};
}

SkalaHardResult run_all_octants() {
  SkalaHardResult result{Verdict{true, "right"}, Verdict{true, "right"}, std::string(no_native),
                         Verdict{true, "right"}};
  const guests::skala::Program program = guests::skala::assemble_program();
  for (const Fan& fan : fans()) {
    const Runs runs = run(program, fan.stream());
    const Cell guest = guest_cell(runs, fan.truth());
    const Cell twin = compared(fan.truth(), grid_of(runs.twin.raster(guests::skala::Device::ef9365)));
    if (is_right(result.guest)) result.guest = guest;
    if (is_right(result.twin)) result.twin = twin;
  }
  return result;
}

}  // namespace sightline::harness::report
