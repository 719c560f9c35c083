// The T-state engine, on ../i8080/pin_bus.hpp, whose statements about the pins also hold here.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "../i8080/cpu.hpp"
#include "../i8080/pin_bus.hpp"
#include "i8080_parts.hpp"

namespace sightline::i8080 {

namespace {

// The machine's memory and ports as the board of a PinBus.
class Board {
 public:
  static constexpr bool answers_in_t3 = true;

  // machine.now is the next T-state; the devices are in the state of the last one.
  Board(MachineParts& machine, Watch& watch)
      : machine_(machine),
        ports_(machine.ports),
        watch_(watch),
        changes_(machine.now),
        shown_{machine.now, was_held(), machine.pins.hold_acknowledge, false} {}

  // Whether the next bytes read follow an opcode.
  void set_operand(bool operand) { operand_ = operand; }
  void count_undefined(Byte opcode, Address address) { machine_.count_undefined(opcode, address); }
  // The bytes that a device has supplied since its interrupt was accepted.
  [[nodiscard]] const std::array<Byte, 3>& supplied() const { return supplied_; }

  PinInputs inputs() {
    if (machine_.now >= changes_) {
      ports_.advance(machine_.now);
      changes_ = ports_.deadline();
    }
    PinInputs levels;
    levels.interrupt = ports_.interrupt();
    levels.ready = waits_ == 0;
    if (waits_ != 0) --waits_;
    levels.hold = is_held(machine_.now);
    return levels;
  }

  Byte read(Status status, Address address) {
    const Byte byte = answer(status, address);
    report(byte);
    return byte;
  }
  void write(Status status, Address address, Byte byte) {
    report(byte);
    if ((status & status::output) == 0) {
      machine_.store(address, byte);
      return;
    }
    ports_.out(low(address), byte, machine_.now);
    changes_ = ports_.deadline();
  }

  void t_state(const PinState& row) {
    if (row.sync) begin(row.status, row.address);
    const bool waits = row.state == TState::held;
    if (waits) ++machine_.held;
    if (row.inputs.hold != shown_.hold || row.hold_acknowledge != shown_.acknowledge || waits != shown_.waits) {
      shown_ = {machine_.now, row.inputs.hold, row.hold_acknowledge, waits};
      if (watch_.is_observed()) watch_.report(shown_);
    }
    machine_.now += core::TStates(1);
  }

  // Skips to the T-state in which HOLD falls, or to `until`.
  void pass_held() { pass_held(core::never_t); }
  void pass_held(core::TStateInstant until) {
    const core::TStateInstant then = std::min(ports_.hold_ends(machine_.now), until);
    if (then <= machine_.now) return;
    machine_.held += static_cast<std::uint64_t>((then - machine_.now).count());
    machine_.now = then;
  }

 private:
  [[nodiscard]] bool is_held(core::TStateInstant t) const { return ports_.next_hold(t) == t; }
  [[nodiscard]] bool was_held() const {
    return machine_.now > core::at_t_state(0) && is_held(machine_.now - core::TStates(1));
  }

  void begin(Status status, Address address) {
    cycle_ = {machine_.now, status, address, 0, operand_};
    const bool halt = (status & status::halt) != 0 && (status & status::first) == 0;
    if (halt) return report(0);
    waits_ = ports_.wait_states(status, address, machine_.now + core::TStates(1));
  }

  // Without MEMR the byte comes from the device whose interrupt is acknowledged.
  Byte answer(Status status, Address address) {
    if ((status & status::memory_read) != 0) return machine_.memory[address];
    Byte byte = 0;
    if ((status & status::input) != 0) {
      byte = ports_.in(low(address), machine_.now);
    } else {
      byte = ports_.acknowledge(machine_.now);
      if (supplied_count_ < supplied_.size()) supplied_[supplied_count_++] = byte;
    }
    changes_ = ports_.deadline();
    return byte;
  }

  void report(Byte data) {
    cycle_.data = data;
    if (wanted()) watch_.report(cycle_);
  }
  [[nodiscard]] bool wanted() const {
    const Status status = cycle_.status;
    if (watch_.wants_all_cycles()) return true;
    if (cycle_.operand) return false;
    if ((status & status::first) != 0) return watch_.is_observed() && (status & status::acknowledge) != 0;
    if ((status & status::halt) != 0) return false;
    const std::uint8_t marks = (status & status::read) != 0 ? mark::read : mark::written;
    if ((status & (status::input | status::output)) != 0) return watch_.wants_port(low(cycle_.address), marks);
    return watch_.wants(cycle_.address, marks);
  }

  MachineParts& machine_;
  Ports& ports_;
  Watch& watch_;
  core::TStateInstant changes_;  // until then the devices do not change
  HoldPins shown_;
  BusCycle cycle_{};  // the current cycle
  bool operand_ = false;
  int waits_ = 0;  // T-states with READY low still to come
  std::array<Byte, 3> supplied_{};
  std::size_t supplied_count_ = 0;
};

// The bus on that board, which marks the bytes after an opcode.
class BoardBus : public PinBus<Board> {
 public:
  BoardBus(Board& board, bool interrupts_on, const PinLatches& latches) : PinBus(board, interrupts_on, latches), board_(board) {}

  void undefined(Byte opcode, Address address) { board_.count_undefined(opcode, address); }
  Byte operand(Status cycle, Address address) {
    board_.set_operand(true);
    const Byte byte = PinBus::operand(cycle, address);
    board_.set_operand(false);
    return byte;
  }

 private:
  Board& board_;
};

void wait_in_halt(MachineParts& machine, BoardBus& bus, core::TStateInstant until) {
  do {
    if (bus.wait_in_halt()) {
      machine.state.halted = false;
      machine.halt_ended = machine.now;
      return;
    }
    if (machine.ports.stops() || machine.now >= until || !machine.halt_may_end(bus.latches())) return;
  } while (bus.latches().waking || bus.latches().hold || bus.latches().hold_acknowledge || machine.hold_is_near(machine.now));
}

// False: HOLD lasts at least until `until`.
bool wait_in_hold(MachineParts& machine, Board& board, BoardBus& bus, core::TStateInstant until) {
  while (bus.wait_in_hold()) {
    if (machine.now >= until) return false;
    if (bus.latches().hold) board.pass_held(until);
    if (machine.now >= until) return false;
  }
  return true;
}

// True: a device supplied the instruction.
bool execute(MachineParts& machine, BoardBus& bus) {
  Execution<BoardBus&> processor(bus, machine.state, machine.state);
  const bool interrupt = bus.interrupt();
  const bool open = machine.state.interrupts_on && !machine.state.deferred;
  machine.state.deferred = false;
  const bool acknowledged = (interrupt && open) || bus.acknowledging();
  if (acknowledged) processor.acknowledge();
  else processor.step();
  processor.save();
  return acknowledged;
}

}  // namespace

bool step_by_pins(MachineParts& machine, Watch& watch, core::TStateInstant until) {
  const State before = machine.state;
  const std::array<Byte, 3> bytes = machine.bytes_at(before.pc);
  PinLatches latches = machine.pins;
  latches.interrupt = machine.now > core::at_t_state(0) && machine.ports.interrupt();
  latches.woken = !machine.state.halted && machine.halt_ended == machine.now;
  latches.halted = machine.state.halted || latches.woken;
  Board board(machine, watch);
  BoardBus bus(board, machine.state.interrupts_on, latches);
  bool executed = false;
  bool acknowledged = false;
  core::TStateInstant begun{};
  if (machine.state.halted) {
    wait_in_halt(machine, bus, until);
  } else if (wait_in_hold(machine, board, bus, until)) {
    begun = machine.now;
    acknowledged = execute(machine, bus);
    executed = true;
    ++machine.instructions;
  }
  if (machine.state.halted) machine.halt_sampled = machine.now - core::TStates(1);
  machine.pins = bus.latches();
  machine.pins.acknowledged = machine.pins.acknowledged && machine.pins.interrupt;
  machine.pins.after_write = machine.pins.after_write && machine.pins.hold;
  machine.pins.interrupt = machine.pins.halted = machine.pins.woken = false;  // these follow from the rest, see above
  machine.serve_next_boundary();
  if (executed && watch.wants_instructions()) {
    watch.report({begun, machine.now, before.pc, acknowledged ? board.supplied() : bytes, acknowledged, before, machine.state});
  }
  return executed;
}

}  // namespace sightline::i8080
