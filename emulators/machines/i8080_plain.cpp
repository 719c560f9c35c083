// The plain engine: one instruction after the other, each one `switch` of ../i8080/cpu.hpp on a bus that reports to the observer and
// knows wait states.
#include <array>

#include "../i8080/cpu.hpp"
#include "i8080_parts.hpp"

namespace sightline::i8080 {

namespace {

class PlainBus {
 public:
  PlainBus(MachineParts& machine, Watch& watch) : machine_(machine), watch_(watch), waits_(machine.ports.has_wait_states()) {}

  Byte fetch(Status cycle, Address address) {
    const Byte byte = instruction_byte(cycle, address, false);
    machine_.now += core::TStates(4);
    return byte;
  }
  Byte operand(Status cycle, Address address) {
    const Byte byte = instruction_byte(cycle, address, true);
    machine_.now += core::TStates(3);
    return byte;
  }
  Byte read(Status cycle, Address address) {
    const core::TStateInstant begun = begin(cycle, address);
    const Byte byte = machine_.memory[address];
    if (watch_.wants(address, mark::read)) report({begun, cycle, address, byte});
    machine_.now += core::TStates(3);
    return byte;
  }
  void write(Status cycle, Address address, Byte byte) {
    if (watch_.wants(address, mark::written)) report({machine_.now, cycle, address, byte});
    begin(cycle, address);
    machine_.memory[address] = byte;
    machine_.now += core::TStates(3);
  }
  Byte in(Status cycle, Byte port) {
    const core::TStateInstant begun = begin(cycle, joined(port, port));
    const Byte byte = machine_.ports.in(port, machine_.now + third_t_state);
    if (watch_.wants_port(port, mark::read)) report({begun, cycle, joined(port, port), byte});
    machine_.now += core::TStates(3);
    if (machine_.ports.changed()) attention();
    return byte;
  }
  void out(Status cycle, Byte port, Byte byte) {
    if (watch_.wants_port(port, mark::written)) report({machine_.now, cycle, joined(port, port), byte});
    begin(cycle, joined(port, port));
    machine_.ports.out(port, byte, machine_.now + third_t_state);
    machine_.now += core::TStates(3);
    if (machine_.ports.changed()) attention();
  }
  void internal(Byte, Byte) { machine_.now += core::TStates(3); }
  void extend(int t_states) { machine_.now += core::TStates(t_states); }
  void halt(Status cycle, Address address) {
    if (watch_.wants_all_cycles()) report({machine_.now, cycle, address, 0});
    machine_.halt_sampled = machine_.now + core::TStates(1);
    machine_.now += core::TStates(3);
  }

  void interrupt_enable(bool) {}
  void end_acknowledge() {}
  bool acknowledging() { return false; }
  void attention() { machine_.attend_next(); }

 private:
  static constexpr core::TStates third_t_state{2};

  Byte instruction_byte(Status cycle, Address address, bool is_operand) {
    const core::TStateInstant begun = begin(cycle, address);
    const Byte byte = machine_.memory[address];
    if (watch_.wants_all_cycles()) report({begun, cycle, address, byte, is_operand});
    return byte;
  }
  // When the cycle begins; its wait states are over.
  core::TStateInstant begin(Status cycle, Address address) {
    const core::TStateInstant begun = machine_.now;
    if (waits_) machine_.now += core::TStates(machine_.ports.wait_states(cycle, address, begun + core::TStates(1)));
    return begun;
  }
  // The fetch that ends a halt still says HLTA.
  [[gnu::noinline]] void report(BusCycle cycle) {
    if (cycle.time == machine_.halt_ended) cycle.status |= status::halt;
    watch_.report(cycle);
  }

  MachineParts& machine_;
  Watch& watch_;
  bool waits_;
};

}  // namespace

void run_plainly(MachineParts& machine, Watch& watch) {
  PlainBus bus(machine, watch);
  Execution<PlainBus&> processor(bus, machine.state, machine.state);
  do {
    if (watch.wants_instructions()) {
      const core::TStateInstant begun = machine.now;
      const State before = machine.state;
      const std::array<Byte, 3> bytes = machine.bytes_at(before.pc);
      processor.step();
      processor.save();
      ++machine.instructions;
      watch.report({begun, machine.now, before.pc, bytes, false, before, machine.state});
    } else {
      processor.step();
      processor.save();
      ++machine.instructions;
    }
  } while (machine.now <= machine.deadline && !watch.wants_boundary(machine.state.pc));
}

}  // namespace sightline::i8080
