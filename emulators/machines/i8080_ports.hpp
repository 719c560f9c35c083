// The devices on the ports of an 8080, the connections of their interrupt lines, and the next instant at which one of them
// needs the processor.
//
// A device brings itself up to date when the processor accesses it; the machine advances it when its deadline has passed,
// and at the end of a run. Only devices connected to INT or HOLD are polled for a deadline: the others affect the processor
// only by IN.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "i8080.hpp"

namespace sightline::i8080 {

class Ports {
 public:
  explicit Ports(bool strict) : strict_(strict) {}

  // --- Between runs: see Machine.
  [[nodiscard]] std::string attach(const core::PortDeviceInfo& info, std::unique_ptr<core::PortDevice> device);
  [[nodiscard]] std::string wire(std::string_view line, std::uint8_t restart);
  [[nodiscard]] core::PortDevice* device(std::string_view name) const;
  [[nodiscard]] std::span<const AttachedDevice> devices() const { return devices_; }
  [[nodiscard]] bool is_connected(const core::PortDevice& device) const;
  void put_before(core::PortRange ports, core::PortDevice& front);
  [[nodiscard]] std::span<const UnansweredPort, 256> unanswered() const { return unanswered_; }
  void visit_state(core::StateVisitor& visit);

  // --- The processor's accesses, at times that never go back.
  [[nodiscard]] Byte in(std::uint8_t port, core::TStateInstant at) {
    if (fronts_[port] != nullptr) return fronts_[port]->in(port, at);
    return forward_in(port, at);
  }
  void out(std::uint8_t port, Byte byte, core::TStateInstant at) {
    if (fronts_[port] != nullptr) return fronts_[port]->out(port, byte, at);
    forward_out(port, byte, at);
  }
  [[nodiscard]] Byte forward_in(std::uint8_t port, core::TStateInstant at) {
    const Port& there = readers_[port];
    if (there.device == nullptr) {
      count_unanswered(unanswered_[port].reads);
      return 0xFF;
    }
    const Byte byte = there.device->in(port, at);
    if (there.connection != nullptr) poll(*there.connection);
    return byte;
  }
  void forward_out(std::uint8_t port, Byte byte, core::TStateInstant at) {
    const Port& there = writers_[port];
    if (there.device == nullptr) return count_unanswered(unanswered_[port].writes);
    there.device->out(port, byte, at);
    if (there.connection != nullptr) poll(*there.connection);
  }
  // The byte that a device puts on the bus in an acknowledge cycle.
  [[nodiscard]] Byte acknowledge(core::TStateInstant at);

  // --- The passage of time.
  // Performs everything that the processor can notice up to and including `now`.
  void advance(core::TStateInstant now) {
    reached_ = std::max(reached_, now);
    if (deadline_ <= now) advance_connected(now);
  }
  // Performs everything up to `now`, and up to the latest instant for which advance() has been called.
  void advance_all(core::TStateInstant now);
  // Polls all connected devices: a host's access between two runs may have caused a request.
  void poll_all();
  // Before it nothing that the processor can notice changes without an access.
  [[nodiscard]] core::TStateInstant deadline() const { return deadline_; }
  // INT, as of the last call of one of the functions above.
  [[nodiscard]] bool interrupt() const { return requests_ != 0; }
  // The first T-state at or after t in which HOLD is high, or never_t; and the first in which it is low.
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const {
    return holders_.empty() ? core::never_t : next_of_holders(t);
  }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const;
  [[nodiscard]] bool has_holders() const { return !holders_.empty(); }
  [[nodiscard]] bool has_wait_states() const { return !waiters_.empty(); }
  [[nodiscard]] int wait_states(Status status, Address address, core::TStateInstant at) const;

  // --- Requests to end a run at the next boundary.
  void request_stop(StopReason reason) {
    stop_ = reason;
    changed_ = true;
  }
  [[nodiscard]] bool stops() const { return stop_.has_value(); }
  [[nodiscard]] std::optional<StopReason> take_stop() { return std::exchange(stop_, std::nullopt); }

  // Whether requests, deadline, HOLD or a stop have changed since the last note_change().
  [[nodiscard]] bool changed() const { return changed_; }
  void note_change() { changed_ = false; }

 private:
  // A device that can affect the processor without an access.
  struct Connection {
    core::PortDevice* device;
    std::vector<unsigned> wires;  // for each line: the bits of `requests` that it raises
    unsigned requests = 0;
    core::TStateInstant deadline = core::never_t;
  };
  struct Port {
    core::PortDevice* device = nullptr;
    Connection* connection = nullptr;  // null: nothing is connected
  };
  using Table = std::array<Port, 256>;

  // Bits of `requests`: RST 0 to RST 7, and the device that drives INT directly.
  static constexpr unsigned every_restart = 0xFF;
  static constexpr unsigned own_instruction = 0x100;

  // An error text if another device has one of these ports in the table.
  [[nodiscard]] std::string find_conflict(const Table& table, std::span<const core::PortRange> ranges, std::string_view name,
                                       std::string_view direction) const;
  Connection& connect(std::size_t device);
  void poll(Connection& connection);
  void advance_connected(core::TStateInstant now);
  [[nodiscard]] core::TStateInstant next_of_holders(core::TStateInstant t) const;
  void count_unanswered(std::uint64_t& count) {
    ++count;
    if (strict_) request_stop(StopReason::unanswered);
  }

  bool strict_;
  std::vector<AttachedDevice> devices_;
  std::vector<std::unique_ptr<Connection>> connections_;  // indexed as devices_; null: not connected
  Table readers_{};
  Table writers_{};
  std::array<core::PortDevice*, 256> fronts_{};
  std::vector<const core::PortDevice*> holders_;  // drive HOLD
  std::vector<const core::PortDevice*> waiters_;  // drive READY
  core::PortDevice* interrupter_ = nullptr;       // drives INT
  unsigned requests_ = 0;
  core::TStateInstant deadline_ = core::never_t;
  core::TStateInstant reached_{};  // by advance()
  bool changed_ = false;
  std::optional<StopReason> stop_;
  std::array<UnansweredPort, 256> unanswered_{};
};

}  // namespace sightline::i8080
