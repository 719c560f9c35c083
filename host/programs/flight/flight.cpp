#include "host/programs/flight/flight.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/programs/flight/check.hpp"
#include "host/programs/flight/path.hpp"
#include "host/programs/flight/twin/twin.hpp"

namespace sightline::programs::flight {

namespace {

namespace willis = algorithms::willis;

constexpr double field = 60;  // degrees across the picture

Summary summary_of(const std::vector<Frame>& frames, std::size_t pieces, core::ClockRate clock) {
  Summary sum;
  sum.frames = static_cast<std::uint32_t>(frames.size());
  sum.pieces = static_cast<std::uint32_t>(pieces);
  double shown = 0;
  double longest = 0;
  double computing = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& frame = frames[i];
    sum.wrong_orders += frame.wrong_orders;
    sum.pairs += std::uint64_t{frame.facing} * (frame.facing - (frame.facing > 0 ? 1 : 0)) / 2;
    sum.wrong_points += frame.wrong_points;
    sum.frames_wrong += frame.wrong_points > 0 ? 1 : 0;
    sum.hidden += frame.hidden;
    if (i == 0) continue;  // its computing time has no beginning
    const double gap = core::in_seconds(frame.shown - frames[i - 1].shown);
    shown += gap;
    longest = std::max(longest, gap);
    computing += static_cast<double>(frame.computing.count());
    sum.t_states_worst = std::max(sum.t_states_worst, frame.computing.count());
    sum.exchanges_mean += frame.exchanges;
    sum.exchanges_most = std::max(sum.exchanges_most, frame.exchanges);
    sum.listed_mean += frame.listed;
    sum.listed_most = std::max(sum.listed_most, frame.listed);
    const std::uint32_t turned = frame.turned.appeared + frame.turned.vanished;
    sum.turned_mean += turned;
    sum.turned_most = std::max(sum.turned_most, turned);
  }
  if (frames.size() < 2) return sum;
  const double count = static_cast<double>(frames.size() - 1);
  const auto hertz = static_cast<double>(clock.hertz);
  sum.frames_per_second_mean = count / shown;
  sum.frames_per_second_worst = 1 / longest;
  sum.t_states_mean = computing / count;
  sum.computed_per_second_mean = hertz / sum.t_states_mean;
  sum.computed_per_second_worst = hertz / static_cast<double>(sum.t_states_worst);
  sum.exchanges_mean /= count;
  sum.listed_mean /= count;
  sum.turned_mean /= count;
  return sum;
}

}  // namespace

ShownOrder shown_order(const willis::Model& model, const scene::PolyCamera& camera, std::span<const std::uint32_t> exact,
                       const Priorities& priorities) {
  ShownOrder shown;
  willis::Point eye = willis::on_lattice(camera.eye);
  if (model.plan) eye[model.vertical] = 0;
  const geometry::Vector3 forward = geometry::vector_of(camera.forward);
  const auto distance = [&](std::uint32_t piece) {
    const willis::Point& point = model.pieces[piece].points[0];
    return camera.perspective ? willis::squared_distance(eye, point) : static_cast<std::uint64_t>(geometry::dot(forward, geometry::vector_of(point)));
  };
  for (std::size_t near = 0; near < exact.size(); ++near) {
    for (std::size_t far = 0; far < near; ++far) {
      if (priorities[exact[far] + 1] < priorities[exact[near] + 1]) continue;
      // Pieces of different cells are ordered even at equal distances.
      if (model.pieces[exact[far]].cell != model.pieces[exact[near]].cell || distance(exact[far]) != distance(exact[near])) ++shown.wrong;
    }
  }
  shown.pieces.assign(exact.begin(), exact.end());
  std::sort(shown.pieces.begin(), shown.pieces.end(),
            [&](std::uint32_t a, std::uint32_t b) { return priorities[a + 1] < priorities[b + 1]; });
  return shown;
}

// The host's data for each frame: the exact order, and the screen spans of its pieces.
class FlightInProgress::Host {
 public:
  Host(const willis::Model& model, std::span<const scene::PolyCamera> cameras) : model_(model), cameras_(cameras), frames_(model) {}

  [[nodiscard]] std::span<const std::uint32_t> order(std::size_t frame) { return frames_.order(cameras_[frame]); }

  void give(std::size_t frame, devices::PriorityBoard& board) {
    make(frame, order(frame), spans_);
    surfaces_.clear();
    for (const willis::SurfaceSpans& surface : spans_.surfaces)
      surfaces_.push_back({static_cast<std::uint8_t>(surface.piece + 1), surface.face + 1, surface.first_line, surface.first_span, surface.line_count});
    covered_.clear();
    for (const willis::Span& span : spans_.spans) covered_.push_back({span.from, span.to});
    board.give(surfaces_, covered_);
  }

  void count(std::size_t frame, const Priorities& priorities, bool points, Frame& result) {
    const auto exact = order(frame);
    result.facing = static_cast<std::uint32_t>(exact.size());
    const ShownOrder shown = shown_order(model_, cameras_[frame], exact, priorities);
    result.wrong_orders = shown.wrong;
    for (const std::uint32_t piece : exact) result.hidden += priorities[piece + 1] == 0 ? 1 : 0;
    if (!points || shown.wrong == 0) return;
    make(frame, exact, spans_);
    const auto right = willis::resolve_priorities(spans_, window(frame));
    make(frame, shown.pieces, spans_);
    const auto made = willis::resolve_priorities(spans_, window(frame));
    for (std::size_t i = 0; i < right.values.size(); ++i) result.wrong_points += right.values[i] != made.values[i] ? 1 : 0;
  }

 private:
  [[nodiscard]] willis::ImageWindow window(std::size_t frame) const {
    return willis::window_ahead(cameras_[frame], devices::priority_display::columns, devices::priority_display::lines, field);
  }
  void make(std::size_t frame, std::span<const std::uint32_t> order, willis::FrameSpans& spans) const {
    willis::make_spans(model_, order, cameras_[frame], window(frame), spans);
  }

  const willis::Model& model_;
  std::span<const scene::PolyCamera> cameras_;
  willis::Frames frames_;
  willis::FrameSpans spans_;
  std::vector<devices::PriorityBoard::HostSurface> surfaces_;
  std::vector<devices::PriorityBoard::HostSpan> covered_;
};

struct FlightInProgress::Parts {
  Parts(const Order& given, const Program& program)
      : order(given), outcome{pack(given.model, given.path, given.precision, given.facing), {}, {}, {}}, host(given.model, given.path),
        machine(program, outcome.packed.stream, machine_options(host, given)) {
    if (order.check) twin = run_twin(outcome.packed.stream, order.facing);
  }
  static MachineOptions machine_options(Host& host, const Order& order) {
    MachineOptions options;
    options.clock = order.clock;
    options.scanned = order.picture;
    if (order.picture || order.shown)
      options.give = [&host](std::uint32_t frame, devices::PriorityBoard& board) { host.give(frame, board); };
    return options;
  }

  void take_frames() {
    outcome.flight = machine.flight();
    const auto& frames = outcome.flight.frames;
    const std::size_t before = outcome.frames.size();
    while (outcome.frames.size() < std::min(frames.size(), order.path.size())) {
      const std::size_t i = outcome.frames.size();
      Frame frame;
      frame.waiting = frames[i].waiting;
      if (i > 0) frame.computing = frames[i].commanded_at - frames[i - 1].commanded_at - frames[i].waiting;
      frame.shown = frames[i].shown;
      frame.moved = frames[i].moved;
      frame.exchanges = frames[i].exchanges;
      frame.listed = frames[i].listed;
      frame.turned = frames[i].turned;
      host.count(i, frames[i].priorities, order.count_points, frame);
      outcome.frames.push_back(frame);
    }
    if (outcome.frames.size() > before) outcome.summary = summary_of(outcome.frames, order.model.pieces.size(), order.clock);
  }

  Order order;
  Outcome outcome;
  Host host;
  FlightMachine machine;
  std::optional<TwinFlight> twin;
};

FlightInProgress::FlightInProgress(const Order& order, const Program& program) : parts_(std::make_unique<Parts>(order, program)) {}
FlightInProgress::~FlightInProgress() = default;

void FlightInProgress::run(core::TStateInstant until) {
  parts_->machine.run(until);
  parts_->take_frames();
}

core::TStateInstant FlightInProgress::now() const { return parts_->machine.now(); }
bool FlightInProgress::ended() const { return parts_->machine.flight().ended; }
core::TStateInstant FlightInProgress::latest_end() const { return flight::latest_end(parts_->outcome.packed.stream); }
const Outcome& FlightInProgress::outcome() const { return parts_->outcome; }

std::string FlightInProgress::difference() const {
  if (!parts_->twin) return "";
  const MachineFlight& flight = parts_->outcome.flight;
  return flight.ended ? difference_from_twin(flight, *parts_->twin) : first_wrong_frame(flight, *parts_->twin);
}

std::span<const std::uint32_t> FlightInProgress::picture() { return parts_->machine.picture(); }

base::Result<Plan> plan_flight(const scene::PolyScene& scene, bool level, std::uint32_t frames, std::optional<std::size_t> pieces, bool facing) {
  const scene::SceneFrame frame = scene::frame_of(scene.camera);
  auto path = path_through(scene, frame, frames, level);
  if (!path) return path.error();
  willis::ModelOptions options;
  options.plan = level;
  options.vertical = frame.vertical;
  auto model = flight_model(scene, options, path->front().eye, pieces, facing);
  if (!model) return model.error();
  return Plan{std::move(*model), std::move(*path)};
}

base::Result<Outcome> run(const Order& order) { return run(order, resident_program(order.facing)); }

base::Result<Outcome> run(const Order& order, const Program& program) {
  FlightInProgress flight(order, program);
  flight.run(flight.latest_end());
  const MachineFlight& machine = flight.outcome().flight;
  if (const std::string difference = flight.difference(); !difference.empty())
    return base::difference("internal error: a priority on the 8080 is not the one its native twin computes: " + difference);
  if (!machine.ended) return base::program_failed("the program did not end");
  if (machine.status != Status::complete) return base::program_failed(fmt::format("the program stopped: {}", text_of(machine.status)));
  if (machine.writes_lost + machine.unanswered > 0)
    return base::program_failed(
        fmt::format("{} writes to the display lost, {} accesses unanswered", machine.writes_lost, machine.unanswered));
  return flight.outcome();
}

double predicted_t_states(const Packed& packed, const Frame& frame) {
  const bool space = packed.axes == 3;
  double packet = 0;  // receiving and checking an eye, and the fixed cost of a frame
  double piece = 0;   // its key, its comparison with the piece before it in the order, its priority
  double key = 0;     // of the same piece
  double pick = 0;    // with the facing test: to find the next piece of a list and its coordinates
  switch (packed.precision) {
    case Precision::bits_8:
      packet = space ? 1440 : 980;
      piece = space ? 418 : 336;
      key = space ? 277 : 196;
      pick = 33;
      break;
    case Precision::bits_12:
      packet = space ? 2540 : 1570;
      piece = space ? 519 : 375;
      key = space ? 335 : 233;
      pick = 58;
      break;
    case Precision::bits_16:
      packet = space ? 2590 : 1690;
      piece = space ? 1231 : 881;
      key = space ? 1090 : 750;
      pick = 64;
      break;
  }
  // SHIFT of order.asm takes 60 for each piece passed if the upper bytes of the keys differ. The rest is INSERT, and keys
  // with equal upper bytes, as neighbours have.
  constexpr double moved = 124;
  constexpr double exchange = 60;
  // Both points of a plane have a key; VISIT of cells.asm takes 330, and 86 for each cell. A piece of a cell takes 40 more
  // to receive its priority.
  constexpr double visit = 440;
  constexpr double cell_piece = 40;
  const auto planes = static_cast<double>(packed.planes);
  const double pieces = frame.listed;
  if (packed.directions > 0) {
    // SIDES of facing_test.asm takes 430 for a direction. REMOVE goes over the whole order, MERGE1 as far as the last new piece. A piece that turns takes its
    // entry's part of SIDES, and then its priority 0, or its place among the new pieces and in the order.
    key += pick;
    piece += pick;
    constexpr double lists = 450;
    constexpr double direction = 430;
    constexpr double appeared = 820;
    constexpr double passed = 64;
    constexpr double vanished = 440;
    constexpr double removed_from = 45;
    packet += lists + key + (key + direction) * static_cast<double>(packed.directions) + appeared * frame.turned.appeared + passed * frame.turned.passed +
              vanished * frame.turned.vanished + (frame.turned.vanished > 0 ? removed_from * pieces : 0);
  }
  return packet + piece * pieces + moved * frame.moved + exchange * frame.exchanges +
         (packed.planes > 0 ? planes * (2 * key + visit) + cell_piece * pieces : 0);
}

}  // namespace sightline::programs::flight
