#include "host/programs/flight/machine.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "emulators/devices/parallel_link.hpp"
#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_front.hpp"
#include "host/base/result.hpp"

namespace sightline::programs::flight {

namespace {

namespace display = devices::priority_display;

}  // namespace

// Records every frame, and how long the program waited until the display was free.
class FlightMachine::DisplayFront final : public i8080::Front {
 public:
  DisplayFront(i8080::Machine& machine, const Program& program, const MachineOptions& options, MachineFlight& flight)
      : Front(machine, control), board_(*machine.find<devices::PriorityBoard>()), first_(program.first), list_end_(program.list_end), ranks_(program.facing), options_(options), flight_(flight) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    pass_to_host(options_.clock.to_nanoseconds(at));
    if (!polled_) first_poll_ = at;
    polled_ = true;
    last_asked_ = at;
    return Front::in(port, at);
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    const bool shows = (value & 1U) != 0;
    if (shows && options_.give) options_.give(static_cast<std::uint32_t>(flight_.frames.size()), board_);
    Front::out(port, value, at);
    if (shows) note(at);
  }

  // After the program's end: lets the display show the last frame too.
  void end() {
    if (!flight_.frames.empty()) pass_to_host(flight_.frames.back().shown + display::frame);
  }

 private:
  // The pieces' numbers by distance, and their changes from frame to frame.
  class Ranks {
   public:
    // The first order is compared with that of the numbers; with the facing test nothing is before it.
    explicit Ranks(bool facing) {
      place_.fill(absent);
      if (!facing) std::iota(place_.begin(), place_.end(), 0U);
    }
    // `order`: nearest first.
    void take(std::span<const std::uint8_t> order, MachineFrame& frame) {
      frame.listed = static_cast<std::uint32_t>(order.size());
      std::uint32_t stay = 0;
      for (std::size_t i = 0; i < order.size(); ++i) {
        const unsigned here = place_[order[i]];
        if (here == absent) {
          ++frame.turned.appeared;
          frame.turned.passed = stay;
          continue;
        }
        ++stay;
        const auto passed = std::count_if(order.begin() + static_cast<std::ptrdiff_t>(i) + 1, order.end(),
                                          [&](std::uint8_t other) { return place_[other] < here; });
        frame.exchanges += static_cast<std::uint32_t>(passed);
        frame.moved += passed > 0 ? 1 : 0;
      }
      frame.turned.vanished = listed_before_ - std::min(listed_before_, stay);
      listed_before_ = frame.listed;
      place_.fill(absent);
      for (std::size_t i = 0; i < order.size(); ++i) place_[order[i]] = static_cast<unsigned>(i);
    }

   private:
    static constexpr unsigned absent = 256;
    std::array<unsigned, 256> place_{};  // by number, in the order of the frame before
    std::uint32_t listed_before_ = 0;
  };

  static constexpr std::uint8_t control_port = devices::PriorityBoard::info.writes[0].first + devices::PriorityBoard::Register::control;
  static constexpr core::PortRange control[]{{control_port, control_port}};

  void note(core::TStateInstant at) {
    MachineFrame frame;
    const auto priorities = board_.priorities();
    std::copy(priorities.begin(), priorities.end(), frame.priorities.begin());
    frame.commanded_at = at;
    const std::size_t count = static_cast<std::uint8_t>(-machine().peek(first_));
    ranks_.take(machine().memory().subspan(list_end_ - count, count), frame);
    frame.waiting = last_asked_ - first_poll_;
    // A frame begins with its first line, where the display takes over a new list.
    const std::int64_t length = display::frame.count();
    const std::int64_t now = options_.clock.to_nanoseconds(at).time_since_epoch().count();
    frame.shown = core::at_nanoseconds((now / length + 1) * length);
    flight_.frames.push_back(frame);
    polled_ = false;
  }
  // Passes on frames whose scan is over by `now`.
  void pass_to_host(core::Instant now) {
    if (!options_.scanned) return;
    while (handed_ < flight_.frames.size() && flight_.frames[handed_].shown + display::line * display::lines <= now) {
      const core::Instant over = flight_.frames[handed_].shown + display::line * display::lines;
      const std::int64_t hertz = options_.clock.hertz;
      const std::int64_t t = (over.time_since_epoch().count() / 1000 * (hertz / 1000) + 999) / 1000;
      board_.advance(core::at_t_state(t));
      options_.scanned(static_cast<std::uint32_t>(handed_), board_.display().picture());
      ++handed_;
    }
  }

  devices::PriorityBoard& board_;
  i8080::Address first_;
  i8080::Address list_end_;
  Ranks ranks_;
  const MachineOptions& options_;
  MachineFlight& flight_;
  bool polled_ = false;
  core::TStateInstant first_poll_{};
  core::TStateInstant last_asked_{};
  std::size_t handed_ = 0;
};

struct FlightMachine::Parts {
  Parts(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options, MachineFlight& flight)
      : machine({options.clock}), status(program.status) {
    attach(devices::ParallelLink::info.name);
    machine.find<devices::ParallelLink>()->send(stream);
    if (options.display) {
      attach(devices::PriorityBoard::info.name);
      front.emplace(machine, program, options, flight);
    }
    machine.load(0, program.memory);
    machine.start(program.start);
  }
  // The machine is part of this executable, so an error ends the process.
  void attach(std::string_view device) {
    if (const std::string error = machine.attach(device); !error.empty()) base::give_up(error);
  }

  i8080::Machine machine;
  std::optional<DisplayFront> front;
  i8080::Address status;
};

FlightMachine::FlightMachine(const Program& program, std::span<const std::uint8_t> stream, MachineOptions options)
    : options_(std::move(options)), parts_(std::make_unique<Parts>(program, stream, options_, flight_)) {}
FlightMachine::~FlightMachine() = default;

void FlightMachine::run(core::TStateInstant until) {
  i8080::Machine& machine = parts_->machine;
  if (!flight_.ended) {
    i8080::Limits limits;
    limits.until = until;
    flight_.ended = machine.run(limits) == i8080::StopReason::halt;
    if (flight_.ended && parts_->front) parts_->front->end();
  }
  flight_.total = machine.now().time_since_epoch();
  flight_.status = static_cast<Status>(machine.peek(parts_->status));
  if (const auto* const board = machine.find<devices::PriorityBoard>(); board != nullptr) {
    flight_.priorities = board->totals().priorities;
    flight_.writes_lost = board->totals().writes_lost;
  }
  flight_.unanswered = 0;
  for (const i8080::UnansweredPort& port : machine.unanswered()) flight_.unanswered += port.reads + port.writes;
}

core::TStateInstant FlightMachine::now() const { return parts_->machine.now(); }

std::span<const std::uint32_t> FlightMachine::picture() {
  auto* const board = parts_->machine.find<devices::PriorityBoard>();
  if (board == nullptr) return {};
  if (!flight_.ended) board->advance(now());
  return board->display().picture();
}

core::TStateInstant latest_end(std::span<const std::uint8_t> stream) {
  // The tables and the time-out for a silent host, each byte, and for a frame of that many bytes a complete reversal of the
  // order.
  constexpr std::int64_t once = 20'000'000;
  constexpr std::int64_t per_byte = 2'000'000;
  return core::at_t_state(once + per_byte * static_cast<std::int64_t>(stream.size()));
}

MachineFlight run_machine(const Program& program, std::span<const std::uint8_t> stream, const MachineOptions& options) {
  FlightMachine machine(program, stream, options);
  machine.run(latest_end(stream));
  return machine.flight();
}

}  // namespace sightline::programs::flight
