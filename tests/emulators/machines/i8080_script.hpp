// A device on all ports of an 8080 that follows a script of INT, READY and HOLD, T-state by T-state, and records all accesses;
// and an observer that records everything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "emulators/core/port_device.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/pin_bus.hpp"
#include "emulators/machines/i8080.hpp"

namespace sightline::tests {

inline constexpr std::array all_ports{core::PortRange{0x00, 0xFF}};

struct PortAccess {
  std::int64_t t;
  std::uint8_t port;
  std::uint8_t data;
  friend bool operator==(const PortAccess&, const PortAccess&) = default;
};

class ScriptDevice final : public core::PortDevice {
 public:
  static constexpr core::PortDeviceInfo info{.name = "script", .help = "", .choice = "", .reads = all_ports, .writes = all_ports};

  // The pins that the script drives besides INT.
  explicit ScriptDevice(bool ready, bool hold) : ready_(ready), hold_(hold) {}

  std::vector<i8080::PinInputs> levels;  // after the last: no INT, ready
  std::uint8_t input = 0;
  std::vector<std::uint8_t> supplied{0xFF};  // given in turn to acknowledge cycles; the last one repeats
  std::vector<PortAccess> reads;
  std::vector<PortAccess> writes;
  i8080::Machine* stopped_by_writes = nullptr;  // not null: each write ends its run

  std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    advance(at);
    reads.push_back({core::t_states_of(at), port, input});
    return input;
  }
  void out(std::uint8_t port, std::uint8_t data, core::TStateInstant at) override {
    advance(at);
    writes.push_back({core::t_states_of(at), port, data});
    if (stopped_by_writes != nullptr) stopped_by_writes->request_stop();
  }
  [[nodiscard]] bool drives_interrupt() const override { return true; }
  std::uint8_t acknowledge(core::TStateInstant at) override {
    advance(at);
    return supplied[next_ + 1 < supplied.size() ? next_++ : next_];
  }
  void advance(core::TStateInstant at) override { now_ = core::t_states_of(at); }
  [[nodiscard]] unsigned requests() const override { return level(now_).interrupt ? 1 : 0; }
  [[nodiscard]] core::TStateInstant deadline() const override {
    for (std::int64_t t = now_ + 1; t <= static_cast<std::int64_t>(levels.size()); ++t) {
      if (level(t).interrupt != level(now_).interrupt) return core::at_t_state(t);
    }
    return core::never_t;
  }
  [[nodiscard]] bool drives_hold() const override { return hold_; }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant at) const override {
    for (std::int64_t t = core::t_states_of(at); t < static_cast<std::int64_t>(levels.size()); ++t) {
      if (level(t).hold) return core::at_t_state(t);
    }
    return core::never_t;
  }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant at) const override {
    std::int64_t t = core::t_states_of(at);
    while (level(t).hold) ++t;
    return core::at_t_state(t);
  }
  [[nodiscard]] bool drives_ready() const override { return ready_; }
  [[nodiscard]] int wait_states(std::uint8_t, std::uint16_t, core::TStateInstant second) const override {
    int count = 0;
    while (!level(core::t_states_of(second) + count).ready) ++count;
    return count;
  }

 private:
  [[nodiscard]] i8080::PinInputs level(std::int64_t t) const {
    return t >= 0 && t < static_cast<std::int64_t>(levels.size()) ? levels[static_cast<std::size_t>(t)]
                                                                  : i8080::PinInputs{};
  }

  bool ready_;
  bool hold_;
  std::int64_t now_ = 0;
  std::size_t next_ = 0;
};

// Attaches a ScriptDevice to the machine.
inline ScriptDevice& attach_script(i8080::Machine& machine, bool ready, bool hold) {
  auto device = std::make_unique<ScriptDevice>(ready, hold);
  ScriptDevice& script = *device;
  static_cast<void>(machine.attach(ScriptDevice::info, std::move(device)));
  return script;
}

// Records everything that a machine reports.
struct I8080Recorder : i8080::Observer {
  explicit I8080Recorder(bool with_instructions) { instructions = with_instructions; }

  struct Instruction {
    std::int64_t begun;
    std::int64_t end;
    i8080::Address pc;
    std::uint8_t opcode;
    bool acknowledged;
    i8080::State after;
    friend bool operator==(const Instruction&, const Instruction&) = default;
  };
  std::vector<i8080::BusCycle> seen;
  std::vector<Instruction> executed;
  std::vector<i8080::HoldPins> holds;

  void hold(const i8080::HoldPins& pins) override { holds.push_back(pins); }
  void cycle(const i8080::BusCycle& cycle) override { seen.push_back(cycle); }
  void instruction(const i8080::InstructionRecord& record) override {
    executed.push_back({core::t_states_of(record.time), core::t_states_of(record.end), record.pc, record.bytes[0],
                        record.acknowledged, record.after});
  }
};

}  // namespace sightline::tests
