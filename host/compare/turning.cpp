// See turning.hpp.
#include "host/compare/turning.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/guests/turn/guest.hpp"
#include "host/guests/turn/screen_view.hpp"
#include "host/guests/turn/program.hpp"
#include "host/guests/turn/session.hpp"
#include "host/guests/turn/tape.hpp"
#include "host/guests/turn/twin/twin.hpp"
#include "host/picture/line_metrics.hpp"

namespace sightline::compare {
namespace {

namespace turn = guests::turn;
namespace plantinga = algorithms::plantinga;

constexpr std::uint32_t angles_a_turn = 1U << 18;
constexpr std::uint32_t largest_step = 077777;
constexpr std::size_t most_edges = 512;  // as many slots as a tape has

base::Result<std::vector<picture::PixelSegment>> exact_lines(const scene::PolyScene& standing, std::uint32_t angle) {
  const registry::LineAlgorithm& exact = registry::line_algorithms().front();
  if (const auto reason = exact.why_not(standing)) return base::Error{.found = *reason};
  const auto prepared = exact.prepare(standing);
  if (!prepared) return prepared.error();
  const auto view = prepared->view(turn::ScreenView::camera(angle));
  if (!view) return view.error();
  const turn::ScreenView screen(standing);
  std::vector<picture::PixelSegment> lines;
  for (const auto& piece : view->picture.pieces) {
    picture::PixelSegment& line = lines.emplace_back();
    for (std::size_t end = 0; end < 2; ++end) {
      const double t = (end == 0 ? piece.low : piece.high).to_double();
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) {
        const double from = standing.vertices[piece.edge.from][a];
        point[a] = from + (standing.vertices[piece.edge.to][a] - from) * t;
      }
      const auto [x, y] = screen.place(point, angle);
      (end == 0 ? line.a : line.b) = {x, y};
    }
  }
  return lines;
}

}  // namespace

std::optional<std::uint32_t> turn_angle_of(const scene::PolyCamera& camera) {
  const auto sight = plantinga::sight_of(camera);
  if (!sight) return std::nullopt;
  const double turns = std::atan2(static_cast<double>(sight->x), static_cast<double>(sight->z)) / (2 * std::numbers::pi);
  return static_cast<std::uint32_t>(std::lround((turns + 1) * angles_a_turn)) % angles_a_turn;
}

base::Result<TurnCheck> check_turn(const scene::PolyScene& scene, std::uint32_t angle) {
  const auto standing = turn::stand_on_axis(scene, false);
  if (!standing) return standing.error();
  const plantinga::RotationModel model(*standing);
  // Known before the events are, which take long.
  if (model.edges().size() > most_edges)
    return base::fail(fmt::format("found {} edges, expected at most {}, as many as the machine can hold", model.edges().size(), most_edges));
  const auto events = plantinga::build_event_list(model);
  if (!events) return events.error();
  auto tape = turn::encode(model, *events, turn::Memory::words_8k);
  if (!tape) tape = turn::encode(model, *events, turn::Memory::words_32k);
  if (!tape) return tape.error();
  const turn::Program program = turn::assemble_program(true, tape->memory);
  turn::Guest guest(program, *tape, turn::Guest::Strokes::kept);
  turn::Twin twin(tape->words, turn::model_base(tape->memory));

  TurnCheck check;
  check.angle = angle;
  const base::Error none{"", "", "the program made no picture at that angle", "one"};
  turn::GuestPicture picture;
  turn::Picture twins;
  // The first picture is at angle 0; then it turns there, and one word on until the picture has been shown.
  std::uint32_t number = 0;
  std::uint32_t step = 0;
  for (std::uint32_t at = 0;; at += step, ++number) {
    if (!guest.next(step, picture) || !twin.next(step, twins)) return none;
    if (check.difference.empty()) check.difference = turn::difference_of(picture, twins);
    if (at == angle) break;
    step = std::min(largest_step, angle - at);
  }
  check.words = picture.display_file.size();
  check.time = picture.time;
  std::vector<core::Stroke> strokes;
  constexpr int most = 10;
  for (int n = 0; n < most && strokes.empty(); ++n) {
    if (!guest.next(1, picture)) return none;
    for (turn::ShownPass& pass : picture.shown)
      if (pass.picture == number) strokes = std::move(pass.strokes);
  }
  const auto lines = exact_lines(*standing, angle);
  if (!lines) return lines.error();
  std::vector<picture::PixelSegment> flashes;
  for (const core::Stroke& stroke : strokes) {
    const picture::PixelPoint point{static_cast<double>(stroke.x), static_cast<double>(stroke.y)};
    flashes.push_back({point, point});
  }
  check.flashes = flashes.size();
  check.distance = picture::hausdorff_distance(*lines, flashes);
  return check;
}

}  // namespace sightline::compare
