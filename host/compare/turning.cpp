// See turning.hpp.
#include "host/compare/turning.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/type340/words.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/compare/device_raster.hpp"
#include "host/programs/turn/precision.hpp"
#include "host/programs/turn/screen_view.hpp"
#include "host/programs/turn/turn.hpp"
#include "host/picture/dots_and_lines.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/picture/line_picture_image.hpp"

namespace sightline::compare {
namespace {

namespace turn = programs::turn;
namespace plantinga = algorithms::plantinga;

constexpr std::uint32_t angles_a_turn = 1U << 18;
constexpr std::uint32_t largest_step = 077777;
constexpr std::size_t most_edges = 512;  // the number of slots of a tape

// The vector words of a display file as straight lines.
std::vector<picture::PixelSegment> lines_of(const std::vector<core::Word18>& file) {
  std::vector<picture::PixelSegment> lines;
  picture::PixelPoint beam;
  auto mode = type340::Mode::parameter;
  for (const core::Word18 word : file) {
    if (mode == type340::Mode::point) {
      const auto point = type340::decode_point(word);
      (point.y ? beam.y : beam.x) = point.coordinate;
    } else if (mode == type340::Mode::vector) {
      const auto vector = type340::decode_vector(word);
      const picture::PixelPoint from = beam;
      beam.x += vector.left ? -vector.dx : vector.dx;
      beam.y += vector.down ? -vector.dy : vector.dy;
      if (vector.intensify) lines.push_back({from, beam});
    }
    const auto next = type340::following(mode, word);
    if (next.stops) break;
    mode = next.mode;
  }
  return lines;
}

double radians_of(const scene::PolyCamera& camera) {
  const auto sight = *plantinga::sight_of(camera);
  return std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
}

// Whether an edge is seen end-on: exact methods draw nothing for it, the machine a piece whose ends are one point.
bool sees_end_on(const plantinga::RotationModel& model, const scene::PolyCamera& camera) {
  const auto sight = *plantinga::sight_of(camera);
  return std::any_of(model.edges().begin(), model.edges().end(), [&](const picture::LineEdge& edge) {
    const auto& from = model.vertices()[edge.from];
    const auto& to = model.vertices()[edge.to];
    return from[1] == to[1] && (to[0] - from[0]) * std::int64_t{sight.z} == (to[2] - from[2]) * std::int64_t{sight.x};
  });
}

// A camera between the events around an angle of the machine, with no edge seen end-on: the first of several at
// increasing distance from it.
std::optional<scene::PolyCamera> camera_between_events(const plantinga::RotationModel& model, const plantinga::EventList& list,
                                                       std::uint32_t angle) {
  if (list.events.empty()) {
    const scene::PolyCamera there = turn::ScreenView::camera(angle);
    return sees_end_on(model, there) ? turn::ScreenView::camera_at(turn::radians(angle) + 0.01) : there;
  }
  const auto as_signed = [](std::uint32_t word) {
    return static_cast<std::int64_t>(word) - (word > angles_a_turn / 2 ? angles_a_turn : 0);
  };
  // An event applies from its word on.
  const auto next = std::find_if(list.events.begin(), list.events.end(), [&](const plantinga::Event& event) {
    return as_signed(turn::event_word(event.direction)) > as_signed(angle);
  });
  const plantinga::Direction& after = (next == list.events.end() ? list.events.front() : *next).direction;
  const plantinga::Direction& before = (next == list.events.begin() ? list.events.back() : *std::prev(next)).direction;
  const auto between = [&](const scene::PolyCamera& camera) {
    const auto sight = *plantinga::sight_of(camera);
    const auto direction = plantinga::rational_direction(sight.x, sight.z);
    const bool behind = plantinga::less(before, direction);
    const bool ahead = plantinga::less(direction, after);
    // Where the turn closes, `after` has the smaller angle.
    return plantinga::less(before, after) ? behind && ahead : behind || ahead;
  };
  const double at = turn::radians(angle);
  const auto way = [at](const plantinga::Direction& to) { return std::remainder(to.angle - at, 2 * std::numbers::pi); };
  // A path of nearly a whole turn must not be taken for half a turn.
  const double forwards = way(after) > 0 ? way(after) : 0.01;
  const double backwards = way(before) < 0 ? way(before) : 0;
  for (const double part : {0.0, 0.02, 0.1, 0.25, 0.5, 0.75, 0.9})
    for (const double to : {forwards, backwards})
      if (const auto camera = turn::ScreenView::camera_at(at + part * to); between(camera) && !sees_end_on(model, camera)) return camera;
  return std::nullopt;
}

// The pieces of the machine's structure and the exact ones. Edges that coincide in the image, such as those of a
// level face, are one line and count once, as in the pictures of all other methods (lines.hpp).
picture::LineMetrics metrics_on_lines(const Turning& turning, const TurnPicture& shown, const picture::LinePicture& exact) {
  struct Line {
    picture::LineId id = 0;
    picture::PixelSegment along;                // the longest edge
    std::vector<picture::PixelSegment> edges;
    std::vector<picture::PixelSegment> visible;
  };
  std::map<std::array<std::int64_t, 4>, Line> lines;
  const auto line_of = [&](const picture::LineEdge& edge) -> Line& {
    const auto plane = picture::in_lowest_terms(picture::image_plane(edge, turning.scene_on_axis(), shown.camera));
    const auto [line, is_new] = lines.try_emplace(plane);
    if (is_new) line->second.id = static_cast<picture::LineId>(lines.size() - 1);
    return line->second;
  };
  const auto whole = [&](const picture::LineEdge& edge) {
    return turning.on_screen({{{edge, geometry::Rational(0), geometry::Rational(1)}}}, shown.angle).front();
  };
  const auto add_edge = [&](const picture::LineEdge& edge) -> Line& {
    Line& line = line_of(edge);
    line.edges.push_back(whole(edge));
    if (picture::length_of(line.along) < picture::length_of(line.edges.back())) line.along = line.edges.back();
    return line;
  };
  for (const picture::LinePiece& piece : exact.pieces)
    add_edge(piece.edge).visible.push_back(picture::part_of(whole(piece.edge), {piece.low.to_double(), piece.high.to_double()}));
  std::vector<picture::DrawnPiece> drawn;
  for (const TurnPicture::Piece& piece : shown.pieces)
    drawn.push_back({add_edge(piece.edge).id, picture::part_of(whole(piece.edge), piece.part)});
  std::vector<picture::ReferenceLine> truth;
  for (const auto& [plane, line] : lines) {
    const auto parts_on = [](const picture::PixelSegment& image, const std::vector<picture::PixelSegment>& segments) {
      picture::LineParts parts;
      for (const picture::PixelSegment& each : segments) parts.push_back({picture::place_on(image, each.a), picture::place_on(image, each.b)});
      return picture::united(std::move(parts));
    };
    const picture::LineParts reach = parts_on(line.along, line.edges);
    const picture::PixelSegment image{picture::point_at(line.along, reach.front().low), picture::point_at(line.along, reach.back().high)};
    truth.push_back({line.id, image, parts_on(image, line.edges), parts_on(image, line.visible)});
  }
  return picture::line_metrics(truth, drawn);
}

}  // namespace

std::optional<std::uint32_t> turn_angle_of(const scene::PolyCamera& camera) {
  const auto sight = plantinga::sight_of(camera);
  if (!sight) return std::nullopt;
  const double turns = std::atan2(static_cast<double>(sight->x), static_cast<double>(sight->z)) / (2 * std::numbers::pi);
  return static_cast<std::uint32_t>(std::lround((turns + 1) * angles_a_turn)) % angles_a_turn;
}

struct Turning::Parts {
  scene::PolyScene standing;
  plantinga::RotationModel model;
  plantinga::EventList events;
  turn::Tape tape;
  turn::Program program;
  turn::ScreenView screen;
};

Turning::Turning(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Turning::Turning(Turning&&) noexcept = default;
Turning& Turning::operator=(Turning&&) noexcept = default;
Turning::~Turning() = default;

base::Result<Turning> Turning::of(const scene::PolyScene& scene) {
  const auto standing = turn::stand_on_axis(scene, false);
  if (!standing) return standing.error();
  const plantinga::RotationModel model(*standing);
  // Checked before the events are computed, which takes long.
  if (model.edges().size() > most_edges)
    return base::bad_input(fmt::format("found {} edges, expected at most {}, as many as the machine can hold", model.edges().size(), most_edges));
  const auto events = plantinga::build_event_list(model);
  if (!events) return events.error();
  auto tape = turn::encode(model, *events, turn::Memory::words_8k);
  if (!tape) tape = turn::encode(model, *events, turn::Memory::words_32k);
  if (!tape) return tape.error();
  const turn::Program program = turn::assemble_program(true, tape->memory);
  return Turning(std::make_unique<Parts>(Parts{*standing, model, *events, *tape, program, turn::ScreenView(*standing)}));
}

const scene::PolyScene& Turning::scene_on_axis() const { return parts_->standing; }

double Turning::scale() const { return turn::points_per_unit(parts_->model); }

std::vector<picture::PixelSegment> Turning::on_screen(const picture::LinePicture& lines, std::uint32_t angle) const {
  std::vector<picture::PixelSegment> segments;
  for (const auto& piece : lines.pieces) {
    picture::PixelSegment& line = segments.emplace_back();
    for (std::size_t end = 0; end < 2; ++end) {
      const double t = (end == 0 ? piece.low : piece.high).to_double();
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) {
        const double from = parts_->standing.vertices[piece.edge.from][a];
        point[a] = from + (parts_->standing.vertices[piece.edge.to][a] - from) * t;
      }
      const auto [x, y] = parts_->screen.place(point, angle);
      (end == 0 ? line.a : line.b) = {x, y};
    }
  }
  return segments;
}

base::Result<TurnPicture> Turning::draw(std::uint32_t angle, const scene::PolyCamera* view) const {
  const turn::Tape& tape = parts_->tape;
  TurnPicture shown;
  shown.angle = angle;
  const auto camera = camera_between_events(parts_->model, parts_->events, angle);
  if (!camera) return base::bad_input(fmt::format("found no camera between the events around angle {} of the machine", angle));
  shown.camera = *camera;

  turn::Machine machine(parts_->program, tape, {.strokes = true});
  turn::Twin twin(tape.words, turn::model_base(tape.memory));
  const base::Error none{"", "", "the program made no picture at that angle", "one"};
  turn::Picture picture;
  turn::TwinPicture twins;
  // The first picture is at angle 0. Then the machine turns to the angle, and on by one word until the picture has
  // been shown.
  std::uint32_t number = 0;
  std::uint32_t step = 0;
  for (std::uint32_t at = 0;; at += step, ++number) {
    if (!machine.next(step, picture) || !twin.next(step, twins)) return none;
    if (shown.difference.empty()) shown.difference = turn::difference_of(picture, twins);
    if (at == angle) break;
    step = std::min(largest_step, angle - at);
  }
  shown.words = picture.display_file.size();
  shown.time = picture.time;
  shown.lines = lines_of(picture.display_file);

  std::vector<std::uint32_t> states;
  for (std::uint32_t slot = 0; slot < tape.slots; ++slot) states.push_back(machine.peek(tape.words[6].value() + 4 * slot).value());
  const turn::Precision precision(tape);
  const auto bounds = precision.pieces(states, angle, radians_of(shown.camera));
  shown.bound = turn::picture_bound(bounds);
  if (view != nullptr) {
    constexpr double half_a_word = std::numbers::pi / angles_a_turn;
    shown.view_bound = turn::picture_bound(precision.pieces(states, angle, radians_of(*view))) + half_a_word * turn::points_to_rim;
  }
  shown.flash_bound = shown.bound + turn::flash_bound();
  for (const turn::PieceBound& bound : bounds) {
    const turn::Tape::Slot& slot = tape.slot_of[bound.slot];
    const auto& edge = parts_->model.edges()[slot.edge];
    const auto [first, second] = bound.ends;
    TurnPicture::Piece piece{{edge.from, edge.to}, {first.at, second.at}, {first.along, second.along}};
    if (slot.reversed) {
      piece.part = {1 - second.at, 1 - first.at};
      piece.tolerance = {second.along, first.along};
    }
    shown.pieces.push_back(piece);
  }
  std::sort(shown.pieces.begin(), shown.pieces.end(), [](const auto& a, const auto& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.part.low < b.part.low;
  });

  std::vector<core::Stroke> strokes;
  constexpr int most = 10;
  for (int n = 0; n < most && strokes.empty(); ++n) {
    if (!machine.next(1, picture)) return none;
    for (turn::ShownPass& pass : picture.shown)
      if (pass.picture == number) strokes = std::move(pass.strokes);
  }
  shown.flashes = strokes.size();
  shown.lit = points_of(strokes);
  return shown;
}

std::string structure_difference(const TurnPicture& turn, const picture::LinePicture& exact) {
  std::size_t i = 0;
  for (const picture::LinePiece& piece : exact.pieces) {
    const auto name = [&piece] { return fmt::format("edge {}-{}", piece.edge.from, piece.edge.to); };
    if (i == turn.pieces.size() || piece.edge < turn.pieces[i].edge) return name() + ": the machine shows fewer pieces";
    const TurnPicture::Piece& shown = turn.pieces[i++];
    if (shown.edge < piece.edge)
      return fmt::format("edge {}-{}: the machine shows more pieces", shown.edge.from, shown.edge.to);
    constexpr double noise = 1e-9;  // of the doubles that are compared
    const double low = piece.low.to_double();
    const double high = piece.high.to_double();
    if (std::abs(low - shown.part.low) > shown.tolerance.low + noise || std::abs(high - shown.part.high) > shown.tolerance.high + noise)
      return name() + fmt::format(": the machine shows {:.6f} to {:.6f}, {:.6f} to {:.6f} is seen", shown.part.low, shown.part.high, low, high);
  }
  if (i == turn.pieces.size()) return "";
  return fmt::format("edge {}-{}: the machine shows more pieces", turn.pieces[i].edge.from, turn.pieces[i].edge.to);
}

base::Result<TurnCheck> check_turn(const scene::PolyScene& scene, std::uint32_t angle) {
  const auto turning = Turning::of(scene);
  if (!turning) return turning.error();
  return check_turn(*turning, angle);
}

base::Result<TurnCheck> check_turn(const Turning& turning, std::uint32_t angle) {
  const auto shown = turning.draw(angle);
  if (!shown) return shown.error();
  const auto view = hidden_lines::visible_edges(turning.scene_on_axis(), shown->camera);
  if (!view) return view.error();
  TurnCheck check{angle, shown->words, shown->time, shown->flashes, {}, shown->flash_bound, {}, shown->difference};
  if (check.difference.empty()) check.difference = structure_difference(*shown, view->picture);
  const auto exact_lines = turning.on_screen(view->picture, angle);
  check.distance = picture::hausdorff_distance(exact_lines, picture::dot_segments(shown->lit));
  check.raster = picture::raster_difference(type340_points(exact_lines, LongLines::turn), shown->lit);
  check.metrics = metrics_on_lines(turning, *shown, view->picture);
  return check;
}

}  // namespace sightline::compare
