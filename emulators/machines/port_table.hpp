// The input and output ports of an 8080 as a table of devices: one row says which ports a device has, how it
// is made, which interrupt lines it has and what it counts. skala_ports.hpp is such a table.
//
// A row is an empty struct with
//   struct Configuration                      its settings, members of the machine's configuration
//   template <class Sink> using Device        the device; only a plotter uses the sink of its strokes
//   static constexpr std::string_view name    for reports
//   static constexpr std::array<PortRange, n> reads   ports that answer an IN; writes: that take an OUT
//   static constexpr std::array<InterruptLine<Configuration>, n> lines
//   static void make(std::optional<Device>&, const Configuration&, core::ClockRate, Sink&)    if it is configured
//   static std::uint8_t read(Device&, std::uint8_t port, core::TStateInstant)                 unless `reads` is empty
//   static void write(Device&, std::uint8_t port, std::uint8_t value, core::TStateInstant)    unless `writes` is empty
//   static bool requests(const Device&, std::size_t line)                                     unless `lines` is empty
//   static bool write_may_request(std::uint8_t port)     optional: false if a write there changes no interrupt line
//   static void count(const Device&, take)    take("dots", n) for each count, in the order of reports
// and what the table's user asks of rows: skala_ports.hpp wants `kind`, and by it `choice` and `attached`, or `chip`, `bytes` and
// `received`. A Device has visit_state (../core/state_visitor.hpp), for snapshots. It may have advance(TStateInstant), called to bring
// it up to date, and deadline(), when its lines may change by themselves.
//
// A port without a device reads as FFh, the level of the undriven bus, and swallows what is written; such
// accesses are counted by port and direction. The constructor enters the devices that are there into one
// table of 256 ports for each direction, so an absent device costs nothing. The first row is tested first and
// inlined into OUT: it is for the device that drawing loops write to. Of several interrupt requests the
// highest restart wins, as an 8214 would have it, and RST 7 is what the bus gives when no device requests.
//
// It is a Ports of the 8080 machine (i8080_run.hpp); a program's environment that has further ports (a CP/M
// stub) wraps it and forwards in, out and the rest.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "../core/state_visitor.hpp"
#include "../core/tstates.hpp"

namespace sightline::machines {

// Restart 0..7 a device's request is wired to, or none.
using Restart = std::optional<std::uint8_t>;

struct PortRange {
  std::uint8_t first;
  std::uint8_t last;  // included
};

template <class Configuration>
struct InterruptLine {
  std::string_view name;  // for options
  Restart Configuration::*restart;
};

struct UnansweredPort {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

// The settings of all rows, and the clock they share.
template <class... Rows>
struct PortConfiguration : Rows::Configuration... {
  core::ClockRate clock{};
};

template <class... Rows>
struct PortRows {
  using Configuration = PortConfiguration<Rows...>;

  // visit(Row{}) for every row, in the order of the table.
  template <class Visit>
  static constexpr void each(Visit visit) {
    (visit(Rows{}), ...);
  }
  // No port has two devices for one direction.
  [[nodiscard]] static constexpr bool disjoint() {
    std::array<int, 256> readers{};
    std::array<int, 256> writers{};
    const auto claim = [](std::array<int, 256>& ports, const auto& ranges) {
      for (const PortRange range : ranges)
        for (unsigned port = range.first; port <= range.last; ++port) ++ports[port];
    };
    ((claim(readers, Rows::reads), claim(writers, Rows::writes)), ...);
    const auto at_most_one = [](int devices) { return devices <= 1; };
    return std::all_of(readers.begin(), readers.end(), at_most_one) &&
           std::all_of(writers.begin(), writers.end(), at_most_one);
  }
};

template <class Sink, class Table>
class PortTable;

template <class Sink, class First, class... Rest>
class PortTable<Sink, PortRows<First, Rest...>> {
 public:
  using Rows = PortRows<First, Rest...>;
  using Configuration = typename Rows::Configuration;
  static_assert(Rows::disjoint());

  // The sink takes the strokes of whichever plotter there is (of several in their order) and must outlive the
  // ports.
  PortTable(const Configuration& configuration, Sink& sink) : configuration_(configuration) {
    readers_.fill(nobody);
    writers_.fill(nobody);
    attach<First>(sink);
    (attach<Rest>(sink), ...);
    if (connected_) look();
  }
  PortTable(const PortTable&) = delete;
  PortTable& operator=(const PortTable&) = delete;

  // The 8080 machine's side. `at` never goes back.
  static constexpr bool waits = false;

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    const std::uint8_t value = read(port, at);
    if (connected_) look();
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (writers_[port] == 0) [[likely]] {
      First::write(*slot<First>(), port, value, at);
      if (connected_ && write_may_request<First>(port)) look();
      return;
    }
    write_to_others(port, value, at);
    if (connected_) look();
  }
  // The earliest instant at which the interrupt line may change by itself.
  [[nodiscard]] core::TStateInstant deadline() const { return deadline_; }
  void advance(core::TStateInstant now) {
    each_device([now](auto, auto& device) {
      if constexpr (requires { device.advance(now); }) device.advance(now);
    });
    if (connected_) look();
  }
  [[nodiscard]] bool interrupt() const { return requests_ != 0; }
  // RST n of the highest request.
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) {
    advance(now);
    unsigned restart = 7;
    while (restart != 0 && requests_ != 0 && (requests_ >> restart & 1U) == 0) --restart;
    return static_cast<std::uint8_t>(0xC7U | restart << 3);
  }
  [[nodiscard]] static constexpr bool stopped() { return false; }

  // The device of a row, null when it is absent.
  template <class Row>
  [[nodiscard]] typename Row::template Device<Sink>* device() {
    auto& device = slot<Row>();
    return device ? &*device : nullptr;
  }
  // visit(Row{}, device) for every device that is there, in the order of the table.
  template <class Visit>
  void each_device(Visit visit) {
    visit_devices(*this, visit);
  }
  template <class Visit>
  void each_device(Visit visit) const {
    visit_devices(*this, visit);
  }

  // A section for each device; requests and the next deadline follow from the devices.
  void visit_state(core::StateVisitor& visit) {
    each_device([&visit](auto row, auto& device) { visit.section(row.name, device); });
    visit.section("ports", [this](auto& fields) {
      for (UnansweredPort& port : unanswered_) {
        fields("reads", port.reads);
        fields("writes", port.writes);
      }
    });
    if (visit.restores()) {
      if (connected_) look();
    }
  }

  // Accesses nothing answered, by port.
  [[nodiscard]] std::span<const UnansweredPort, 256> unanswered() const { return unanswered_; }

 private:
  static constexpr std::uint8_t nobody = 0xFF;

  // The place of a row in the table.
  template <class Row>
  static constexpr std::uint8_t number = [] {
    std::uint8_t n = 0;
    std::uint8_t found = nobody;
    Rows::each([&](auto row) {
      if (std::is_same_v<decltype(row), Row>) found = n;
      ++n;
    });
    return found;
  }();

  template <class Row>
  [[nodiscard]] auto& slot() {
    return std::get<number<Row>>(devices_);
  }
  template <class Self, class Visit>
  static void visit_devices(Self& self, Visit& visit) {
    const auto visit_one = [&](auto row) {
      if (auto& device = std::get<number<decltype(row)>>(self.devices_)) visit(row, *device);
    };
    visit_one(First{});
    (visit_one(Rest{}), ...);
  }

  template <class Row>
  void attach(Sink& sink) {
    Row::make(slot<Row>(), configuration_, configuration_.clock, sink);
    if (!slot<Row>()) return;
    enter(readers_, Row::reads, number<Row>);
    enter(writers_, Row::writes, number<Row>);
    for (const auto& line : Row::lines) connected_ = connected_ || configuration_.*line.restart;
  }
  template <class Ranges>
  static void enter(std::array<std::uint8_t, 256>& ports, const Ranges& ranges, std::uint8_t number) {
    for (const PortRange range : ranges)
      std::fill(ports.begin() + range.first, ports.begin() + range.last + 1, number);
  }

  template <class Row>
  static bool write_may_request(std::uint8_t port) {
    if constexpr (requires { Row::write_may_request(port); }) return Row::write_may_request(port);
    return true;
  }

  std::uint8_t read(std::uint8_t port, core::TStateInstant at) {
    const std::uint8_t row = readers_[port];
    std::uint8_t value = 0xFF;
    if (!(read_from<First>(row, port, at, value) || ... || read_from<Rest>(row, port, at, value)))
      ++unanswered_[port].reads;
    return value;
  }
  template <class Row>
  bool read_from(std::uint8_t row, std::uint8_t port, core::TStateInstant at, std::uint8_t& value) {
    if constexpr (Row::reads.empty()) {
      return false;
    } else {
      if (row != number<Row>) return false;
      value = Row::read(*slot<Row>(), port, at);
      return true;
    }
  }

  // All rows but the first.
  [[gnu::noinline]] void write_to_others(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    const std::uint8_t row = writers_[port];
    if (!(write_to<Rest>(row, port, value, at) || ...)) ++unanswered_[port].writes;
  }
  template <class Row>
  bool write_to(std::uint8_t row, std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (row != number<Row>) return false;
    Row::write(*slot<Row>(), port, value, at);
    return true;
  }

  // Requests and the next deadline of the devices whose interrupt is connected.
  void look() {
    requests_ = 0;
    deadline_ = core::never_t;
    look_at<First>();
    (look_at<Rest>(), ...);
  }
  template <class Row>
  void look_at() {
    if constexpr (!Row::lines.empty()) {
      const auto& device = slot<Row>();
      if (device) look_at_lines<Row>(*device, std::make_index_sequence<Row::lines.size()>{});
    }
  }
  template <class Row, std::size_t... n>
  void look_at_lines(const typename Row::template Device<Sink>& device, std::index_sequence<n...>) {
    (consider(configuration_.*Row::lines[n].restart, device, [&device] { return Row::requests(device, n); }),
     ...);
  }
  template <class Device, class Requests>
  void consider(const Restart& restart, const Device& device, Requests requests) {
    if (!restart) return;
    if (requests()) requests_ |= 1U << (*restart & 7U);
    deadline_ = std::min(deadline_, device.deadline());
  }

  Configuration configuration_;
  std::tuple<std::optional<typename First::template Device<Sink>>,
             std::optional<typename Rest::template Device<Sink>>...>
      devices_;
  std::array<std::uint8_t, 256> readers_;  // number of the row
  std::array<std::uint8_t, 256> writers_;
  bool connected_ = false;
  unsigned requests_ = 0;  // bit n: restart n
  core::TStateInstant deadline_ = core::never_t;
  std::array<UnansweredPort, 256> unanswered_{};
};

}  // namespace sightline::machines
