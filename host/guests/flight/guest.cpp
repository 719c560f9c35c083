#include "host/guests/flight/guest.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "emulators/machines/flight_ports.hpp"
#include "host/guests/run/i8080_processor.hpp"

namespace sightline::guests::flight {

namespace {

namespace display = devices::priority_display;

}  // namespace

// Those of the machine, noting every frame and how long the program looked for the display to be free.
class Guest::Ports final : private core::NoStrokes, public run::I8080Ports, public machines::FlightPorts {
 public:
  Ports(const machines::FlightConfiguration& configuration, const GuestOptions& options, GuestFlight& flight)
      : FlightPorts(configuration, static_cast<core::NoStrokes&>(*this)), options_(options), flight_(flight) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    if (port != control_port || priority() == nullptr) return FlightPorts::in(port, at);
    hand_on_scanned(at);
    if (!looked_) first_look_ = at;
    looked_ = true;
    last_look_ = at;
    return FlightPorts::in(port, at);
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    const bool shows = port == control_port && priority() != nullptr && (value & 1U) != 0;
    if (shows && options_.give) options_.give(static_cast<std::uint32_t>(flight_.frames.size()), *priority());
    FlightPorts::out(port, value, at);
    if (shows) note(at);
  }

  // After the program's end: the last frame is shown, too.
  void end() {
    if (priority() == nullptr || flight_.frames.empty()) return;
    pass_to_host(flight_.frames.back().shown + display::frame);
  }

 private:
  static constexpr std::uint8_t control_port = machines::PriorityRow::first_port + devices::PriorityBoard::Register::control;

  void note(core::TStateInstant at) {
    GuestFrame frame;
    const auto priorities = priority()->priorities();
    std::copy(priorities.begin(), priorities.end(), frame.priorities.begin());
    frame.told = at;
    frame.waiting = last_look_ - first_look_;
    // A frame begins with its first line; the display looks for a new list there.
    const std::int64_t length = display::frame.count();
    const std::int64_t now = options_.clock.to_nanoseconds(at).time_since_epoch().count();
    frame.shown = core::at_nanoseconds((now / length + 1) * length);
    flight_.frames.push_back(frame);
    looked_ = false;
  }
  void hand_on_scanned(core::TStateInstant at) { pass_to_host(options_.clock.to_nanoseconds(at)); }
  // Frames whose scan is over by then.
  void pass_to_host(core::Instant now) {
    if (!options_.scanned) return;
    while (handed_ < flight_.frames.size() && flight_.frames[handed_].shown + display::line * display::lines <= now) {
      const core::Instant over = flight_.frames[handed_].shown + display::line * display::lines;
      const std::int64_t hertz = options_.clock.hertz;
      const std::int64_t t = (over.time_since_epoch().count() / 1000 * (hertz / 1000) + 999) / 1000;
      priority()->advance(core::at_t_state(t));
      options_.scanned(static_cast<std::uint32_t>(handed_), priority()->display().picture());
      ++handed_;
    }
  }

  const GuestOptions& options_;
  GuestFlight& flight_;
  bool looked_ = false;
  core::TStateInstant first_look_{};
  core::TStateInstant last_look_{};
  std::size_t handed_ = 0;
};

struct Guest::Machine {
  static machines::FlightConfiguration configuration_of(std::span<const std::uint8_t> stream, const GuestOptions& options) {
    machines::FlightConfiguration configuration;
    configuration.priority_display = options.display;
    configuration.parallel = stream;
    configuration.clock = options.clock;
    return configuration;
  }
  Machine(const Program& program, std::span<const std::uint8_t> stream, const GuestOptions& options, GuestFlight& flight)
      : ports(configuration_of(stream, options), options, flight), machine(ports), status(program.status) {
    std::copy(program.memory.begin(), program.memory.end(), machine.memory().begin());
    machine.registers().pc = program.start;
  }

  Ports ports;
  run::I8080Processor machine;
  i8080::Address status;
};

Guest::Guest(const Program& program, std::span<const std::uint8_t> stream, GuestOptions options)
    : options_(std::move(options)), machine_(std::make_unique<Machine>(program, stream, options_, flight_)) {}
Guest::~Guest() = default;

void Guest::run(core::TStateInstant until) {
  Machine& it = *machine_;
  if (!flight_.ended) {
    machines::I8080Limits limits;
    limits.until = until;
    flight_.ended = it.machine.run(limits) == machines::I8080StopReason::halt;
    if (flight_.ended) it.ports.end();
  }
  flight_.total = it.machine.now().time_since_epoch();
  flight_.status = static_cast<Status>(it.machine.peek(it.status));
  if (it.ports.priority() != nullptr) {
    flight_.priorities = it.ports.priority()->counts().priorities;
    flight_.writes_lost = it.ports.priority()->counts().writes_lost;
  }
  flight_.unanswered = 0;
  for (const machines::UnansweredPort& port : it.ports.unanswered()) flight_.unanswered += port.reads + port.writes;
}

core::TStateInstant Guest::now() const { return machine_->machine.now(); }

std::span<const std::uint32_t> Guest::picture() {
  devices::PriorityBoard* const board = machine_->ports.priority();
  if (board == nullptr) return {};
  if (!flight_.ended) board->advance(now());
  return board->display().picture();
}

core::TStateInstant latest_end(std::span<const std::uint8_t> stream) {
  // Tables and silence, each byte, and for a frame of so many bytes all pieces in the opposite order.
  constexpr std::int64_t once = 20'000'000;
  constexpr std::int64_t a_byte = 2'000'000;
  return core::at_t_state(once + a_byte * static_cast<std::int64_t>(stream.size()));
}

GuestFlight run_guest(const Program& program, std::span<const std::uint8_t> stream, const GuestOptions& options) {
  Guest guest(program, stream, options);
  guest.run(latest_end(stream));
  return guest.flight();
}

}  // namespace sightline::guests::flight
