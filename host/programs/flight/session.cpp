#include "host/programs/flight/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"

namespace sightline::programs::flight {

namespace {

namespace willis = algorithms::willis;

constexpr double field = 60;  // degrees across the picture

// Of the frames that both have.
std::string first_wrong_frame(const GuestFlight& guest, const TwinFlight& twin) {
  for (std::size_t frame = 0; frame < std::min(guest.frames.size(), twin.frames.size()); ++frame) {
    const Priorities& here = guest.frames[frame].priorities;
    const Priorities& there = twin.frames[frame].priorities;
    const auto [at, other] = std::mismatch(here.begin(), here.end(), there.begin());
    if (at != here.end())
      return fmt::format("frame {}: piece {} has the priority {}, the twin's {}", frame, at - here.begin(), *at, *other);
  }
  return "";
}

FlightSummary summary_of(const FlightRun& run, std::size_t pieces, core::ClockRate clock) {
  FlightSummary sum;
  sum.frames = static_cast<std::uint32_t>(run.frames.size());
  sum.pieces = static_cast<std::uint32_t>(pieces);
  double shown = 0;
  double longest = 0;
  double computing = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FlightFrame& frame = run.frames[i];
    sum.wrong_orders += frame.wrong_orders;
    sum.pairs += std::uint64_t{frame.facing} * (frame.facing - (frame.facing > 0 ? 1 : 0)) / 2;
    sum.wrong_points += frame.wrong_points;
    sum.frames_wrong += frame.wrong_points > 0 ? 1 : 0;
    if (i == 0) continue;  // it has no beginning
    const double gap = core::in_seconds(frame.shown - run.frames[i - 1].shown);
    shown += gap;
    longest = std::max(longest, gap);
    computing += static_cast<double>(frame.computing.count());
    sum.t_states_worst = std::max(sum.t_states_worst, frame.computing.count());
    sum.exchanges_mean += frame.exchanges;
    sum.exchanges_most = std::max(sum.exchanges_most, frame.exchanges);
  }
  if (run.frames.size() < 2) return sum;
  const double count = static_cast<double>(run.frames.size() - 1);
  const auto hertz = static_cast<double>(clock.hertz);
  sum.frames_per_second_mean = count / shown;
  sum.frames_per_second_worst = 1 / longest;
  sum.t_states_mean = computing / count;
  sum.computed_per_second_mean = hertz / sum.t_states_mean;
  sum.computed_per_second_worst = hertz / static_cast<double>(sum.t_states_worst);
  sum.exchanges_mean /= count;
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
      // Cells have no order by distance that could be the same.
      if (model.pieces[exact[far]].cell != model.pieces[exact[near]].cell || distance(exact[far]) != distance(exact[near])) ++shown.wrong;
    }
  }
  shown.pieces.assign(exact.begin(), exact.end());
  std::sort(shown.pieces.begin(), shown.pieces.end(),
            [&](std::uint32_t a, std::uint32_t b) { return priorities[a + 1] < priorities[b + 1]; });
  return shown;
}

std::string difference_of(const GuestFlight& guest, const TwinFlight& twin) {
  if (std::string wrong = first_wrong_frame(guest, twin); !wrong.empty()) return wrong;
  if (guest.frames.size() != twin.frames.size())
    return fmt::format("{} frames, the twin's {}", guest.frames.size(), twin.frames.size());
  if (guest.status != twin.status) return fmt::format("status \"{}\", the twin's \"{}\"", text_of(guest.status), text_of(twin.status));
  if (!guest.ended) return "the program did not end";
  if (guest.writes_lost + guest.unanswered > 0)
    return fmt::format("{} writes to the display lost, {} accesses unanswered", guest.writes_lost, guest.unanswered);
  return "";
}

// What the host knows of each frame: exact order, and where its pieces are on the screen.
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

  void count(std::size_t frame, const Priorities& priorities, bool points, FlightFrame& result) {
    const auto exact = order(frame);
    result.facing = static_cast<std::uint32_t>(exact.size());
    const ShownOrder shown = shown_order(model_, cameras_[frame], exact, priorities);
    result.wrong_orders = shown.wrong;
    if (!points || shown.wrong == 0) return;
    make(frame, exact, spans_);
    const auto right = willis::resolved(spans_, window(frame));
    make(frame, shown.pieces, spans_);
    const auto made = willis::resolved(spans_, window(frame));
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
  static GuestOptions guest_options(Host& host, const FlightOptions& options) {
    GuestOptions machine;
    machine.clock = options.clock;
    machine.scanned = options.picture;
    if (options.picture || options.shown)
      machine.give = [&host](std::uint32_t frame, devices::PriorityBoard& board) { host.give(frame, board); };
    return machine;
  }
  Parts(const Program& program, const willis::Model& model, std::span<const scene::PolyCamera> cameras, const Packed& packed,
        const FlightOptions& given)
      : options(given), pieces(model.pieces.size()), host(model, cameras), guest(program, packed.stream, guest_options(host, given)),
        twin(run_twin(packed.stream)) {}

  void take_frames() {
    const auto& frames = guest.flight().frames;
    while (run.frames.size() < std::min(frames.size(), twin.frames.size())) {
      const std::size_t i = run.frames.size();
      FlightFrame frame;
      frame.waiting = frames[i].waiting;
      if (i > 0) frame.computing = frames[i].told - frames[i - 1].told - frames[i].waiting;
      frame.shown = frames[i].shown;
      frame.moved = twin.frames[i].moved;
      frame.exchanges = twin.frames[i].exchanges;
      host.count(i, frames[i].priorities, options.count_points, frame);
      run.frames.push_back(frame);
    }
  }

  FlightOptions options;
  std::size_t pieces;
  Host host;
  Guest guest;
  TwinFlight twin;
  FlightRun run;
};

FlightInProgress::FlightInProgress(const Program& program, const willis::Model& model, std::span<const scene::PolyCamera> cameras,
                                   const Packed& packed, const FlightOptions& options)
    : parts_(std::make_unique<Parts>(program, model, cameras, packed, options)) {}
FlightInProgress::~FlightInProgress() = default;

void FlightInProgress::run(core::TStateInstant until) {
  parts_->guest.run(until);
  const std::size_t before = parts_->run.frames.size();
  parts_->take_frames();
  if (parts_->run.frames.size() > before) parts_->run.summary = summary_of(parts_->run, parts_->pieces, parts_->options.clock);
}

core::TStateInstant FlightInProgress::now() const { return parts_->guest.now(); }
bool FlightInProgress::ended() const { return parts_->guest.flight().ended; }

const FlightRun& FlightInProgress::so_far() const {
  FlightRun& run = parts_->run;
  run.guest = parts_->guest.flight();
  run.difference = run.guest.ended ? difference_of(run.guest, parts_->twin) : first_wrong_frame(run.guest, parts_->twin);
  return run;
}

std::span<const std::uint32_t> FlightInProgress::picture() { return parts_->guest.picture(); }

FlightRun Session::run(const willis::Model& model, std::span<const scene::PolyCamera> cameras, const Packed& packed,
                       const FlightOptions& options) const {
  FlightInProgress flight(program_, model, cameras, packed, options);
  flight.run(latest_end(packed.stream));
  FlightRun run = flight.so_far();
  if (!run.guest.ended && run.difference.empty()) run.difference = "the program did not end";
  return run;
}

double predicted_t_states(const Packed& packed, std::size_t pieces, const FlightFrame& frame) {
  const bool space = packed.axes == 3;
  double packet = 0;  // receipt and check of an eye, and what a frame costs besides
  double piece = 0;   // its key, its look at the one before it in the order, its priority
  double key = 0;     // of that
  switch (packed.precision) {
    case Precision::bits_8:
      packet = space ? 1440 : 980;
      piece = space ? 418 : 336;
      key = space ? 277 : 196;
      break;
    case Precision::bits_12:
      packet = space ? 2540 : 1570;
      piece = space ? 519 : 375;
      key = space ? 335 : 233;
      break;
    case Precision::bits_16:
      packet = space ? 2590 : 1690;
      piece = space ? 1231 : 881;
      key = space ? 1090 : 750;
      break;
  }
  // SHIFT of order.asm takes 60 for a piece that is passed where the upper bytes of the keys differ. The rest is INSERT, and keys
  // that begin alike, as those of neighbours do.
  constexpr double moved = 124;
  constexpr double exchange = 60;
  // Both points of a plane have a key; VISIT of cells.asm takes 330, and 86 for each cell. A piece of a cell takes 40 more to be told.
  constexpr double visit = 440;
  constexpr double told = 40;
  const auto planes = static_cast<double>(packed.planes);
  return packet + piece * static_cast<double>(pieces) + moved * frame.moved + exchange * frame.exchanges +
         (packed.planes > 0 ? planes * (2 * key + visit) + told * static_cast<double>(pieces) : 0);
}

}  // namespace sightline::programs::flight
