// Ports of an 8080 machine that follow a script of INT and READY, T-state by T-state, and note what was asked of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "emulators/i8080/pin_bus.hpp"
#include "emulators/machines/i8080_machine.hpp"

namespace sightline::tests {

struct PortAccess {
  std::int64_t t;
  std::uint8_t port;
  std::uint8_t data;
  friend bool operator==(const PortAccess&, const PortAccess&) = default;
};

template <bool may_wait>
class BasicScriptPorts {
 public:
  static constexpr bool waits = may_wait;

  std::vector<i8080::PinInputs> levels;  // after the last: no INT, ready
  std::uint8_t input = 0;
  std::vector<std::uint8_t> supplied{0xFF};  // given in turn to acknowledge cycles; the last one stays
  std::vector<PortAccess> reads;
  std::vector<PortAccess> writes;
  std::size_t stop_after_writes = ~std::size_t{0};

  std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    advance(at);
    reads.push_back({core::t_states_of(at), port, input});
    return input;
  }
  void out(std::uint8_t port, std::uint8_t data, core::TStateInstant at) {
    advance(at);
    writes.push_back({core::t_states_of(at), port, data});
  }
  std::uint8_t acknowledge(core::TStateInstant at) {
    advance(at);
    return supplied[next_ + 1 < supplied.size() ? next_++ : next_];
  }
  void advance(core::TStateInstant at) { now_ = core::t_states_of(at); }
  [[nodiscard]] bool interrupt() const { return level(now_).interrupt; }
  [[nodiscard]] bool stopped() const { return writes.size() >= stop_after_writes; }
  [[nodiscard]] core::TStateInstant deadline() const {
    for (std::int64_t t = now_ + 1; t <= static_cast<std::int64_t>(levels.size()); ++t) {
      if (level(t).interrupt != interrupt()) return core::at_t_state(t);
    }
    return core::never_t;
  }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant at) const {
    for (std::int64_t t = core::t_states_of(at); t < static_cast<std::int64_t>(levels.size()); ++t) {
      if (level(t).hold) return core::at_t_state(t);
    }
    return core::never_t;
  }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant at) const {
    std::int64_t t = core::t_states_of(at);
    while (level(t).hold) ++t;
    return core::at_t_state(t);
  }
  [[nodiscard]] int wait_states(i8080::CycleKind, i8080::Address, core::TStateInstant second) const {
    int count = 0;
    while (!level(core::t_states_of(second) + count).ready) ++count;
    return count;
  }

 private:
  [[nodiscard]] i8080::PinInputs level(std::int64_t t) const {
    return t >= 0 && t < static_cast<std::int64_t>(levels.size()) ? levels[static_cast<std::size_t>(t)]
                                                                  : i8080::PinInputs{};
  }

  std::int64_t now_ = 0;
  std::size_t next_ = 0;
};

using ScriptPorts = BasicScriptPorts<true>;

// Keeps everything a machine reports; without instructions it goes the fast way.
template <bool tells_instructions>
struct BasicI8080Recorder {
  static constexpr bool instructions = tells_instructions;
  static constexpr bool cycles = true;
  static constexpr bool stops = false;

  struct Instruction {
    std::int64_t begun;
    std::int64_t end;
    i8080::Address pc;
    std::uint8_t opcode;
    bool acknowledged;
    i8080::State after;
    friend bool operator==(const Instruction&, const Instruction&) = default;
  };
  std::vector<machines::I8080Cycle> seen;
  std::vector<Instruction> executed;
  std::vector<machines::I8080HoldPins> holds;

  void hold(const machines::I8080HoldPins& pins) { holds.push_back(pins); }
  void cycle(const machines::I8080Cycle& cycle) { seen.push_back(cycle); }
  void instruction(const machines::I8080InstructionRecord& record) {
    executed.push_back({core::t_states_of(record.time), core::t_states_of(record.end), record.pc, record.bytes[0],
                        record.acknowledged, record.after});
  }
};

using I8080Recorder = BasicI8080Recorder<true>;
using ScriptMachine = machines::I8080Machine<ScriptPorts, I8080Recorder>;

}  // namespace sightline::tests
