// The plain engine: executes one instruction after the other by the `switch` of ../i8080/cpu.hpp.
#include <array>
#include <cstdint>

#include "../core/inline.hpp"
#include "../i8080/cpu.hpp"
#include "i8080_parts.hpp"

namespace sightline::i8080 {

namespace {

// `full`: reports to an observer and supports wait states and less than 64K of RAM. Without these a compiler keeps most of
// the bus in registers.
template <bool full>
class PlainBus {
 public:
  PlainBus(MachineParts& machine, Watch& watch)
      : machine_(&machine), watch_(&watch), now_(machine.now), waits_(full && machine.ports.has_wait_states()) {}

  SIGHTLINE_INLINE Byte fetch(Status cycle, Address address) {
    const Byte byte = instruction_byte(cycle, address, false);
    now_ += core::TStates(4);
    return byte;
  }
  SIGHTLINE_INLINE Byte operand(Status cycle, Address address) {
    const Byte byte = instruction_byte(cycle, address, true);
    now_ += core::TStates(3);
    return byte;
  }
  SIGHTLINE_INLINE Byte read(Status cycle, Address address) {
    const core::TStateInstant begun = begin(cycle, address);
    const Byte byte = machine_->memory[address];
    if (full && watch_->wants(address, mark::read)) report({begun, cycle, address, byte});
    now_ += core::TStates(3);
    return byte;
  }
  SIGHTLINE_INLINE void write(Status cycle, Address address, Byte byte) {
    if (full && watch_->wants(address, mark::written)) report({now_, cycle, address, byte});
    begin(cycle, address);
    if constexpr (full) machine_->store(address, byte);
    else machine_->memory[address] = byte;
    now_ += core::TStates(3);
  }
  SIGHTLINE_INLINE Byte in(Status cycle, Byte port) {
    const core::TStateInstant begun = begin(cycle, joined(port, port));
    const Byte byte = machine_->ports.in(port, now_ + third_t_state);
    if (full && watch_->wants_port(port, mark::read)) report({begun, cycle, joined(port, port), byte});
    now_ += core::TStates(3);
    if (machine_->ports.changed()) attention();
    return byte;
  }
  SIGHTLINE_INLINE void out(Status cycle, Byte port, Byte byte) {
    if (full && watch_->wants_port(port, mark::written)) report({now_, cycle, joined(port, port), byte});
    begin(cycle, joined(port, port));
    machine_->ports.out(port, byte, now_ + third_t_state);
    now_ += core::TStates(3);
    if (machine_->ports.changed()) attention();
  }
  SIGHTLINE_INLINE void internal(Byte, Byte) { now_ += core::TStates(3); }
  SIGHTLINE_INLINE void extend(int t_states) { now_ += core::TStates(t_states); }
  SIGHTLINE_INLINE void halt(Status cycle, Address address) {
    if (full && watch_->wants_all_cycles()) report({now_, cycle, address, 0});
    machine_->halt_sampled = now_ + core::TStates(1);
    now_ += core::TStates(3);
  }

  void undefined(Byte opcode, Address address) {
    machine_->count_undefined(opcode, address);
    if (machine_->ports.changed()) attention();
  }
  void interrupt_enable(bool) {}
  void end_acknowledge() {}
  bool acknowledging() { return false; }
  SIGHTLINE_INLINE void attention() { machine_->deadline = now_ - core::TStates(1); }

  [[nodiscard]] bool due() const { return now_ > machine_->deadline; }
  SIGHTLINE_INLINE void save() { machine_->now = now_; }

 private:
  static constexpr core::TStates third_t_state{2};

  SIGHTLINE_INLINE Byte instruction_byte(Status cycle, Address address, bool is_operand) {
    const core::TStateInstant begun = begin(cycle, address);
    const Byte byte = machine_->memory[address];
    if (full && watch_->wants_all_cycles()) report({begun, cycle, address, byte, is_operand});
    return byte;
  }
  // The beginning of the cycle proper, after its wait states.
  SIGHTLINE_INLINE core::TStateInstant begin(Status cycle, Address address) {
    const core::TStateInstant begun = now_;
    if (full && waits_) now_ += core::TStates(machine_->ports.wait_states(cycle, address, begun + core::TStates(1)));
    return begun;
  }
  SIGHTLINE_INLINE void report(const BusCycle& cycle) { report_to(*machine_, *watch_, cycle); }
  // The fetch that ends a halt still says HLTA.
  [[gnu::noinline]] static void report_to(MachineParts& machine, Watch& watch, BusCycle cycle) {
    if (cycle.time == machine.halt_ended) cycle.status |= status::halt;
    watch.report(cycle);
  }

  MachineParts* machine_;
  Watch* watch_;
  core::TStateInstant now_;
  bool waits_;
};

template <bool full>
void execute(MachineParts& machine, Watch& watch) {
  Execution<PlainBus<full>> processor(PlainBus<full>(machine, watch), machine.state, machine.state);
  bool ends = false;
  while (!ends) {
    processor.step();
    ++machine.instructions;
    ends = processor.bus().due();
    // An observer of instructions gets them one at a time.
    if (full) ends = ends || watch.wants_instructions() || watch.wants_boundary(static_cast<Address>(processor.pc()));
  }
  processor.save();
}

}  // namespace

void run_plainly(MachineParts& machine, Watch& watch) {
  if (!watch.is_observed() && !machine.ports.has_wait_states() && !machine.ends_early()) return execute<false>(machine, watch);
  if (!watch.wants_instructions()) return execute<true>(machine, watch);
  const core::TStateInstant begun = machine.now;
  const State before = machine.state;
  const std::array<Byte, 3> bytes = machine.bytes_at(before.pc);
  execute<true>(machine, watch);
  watch.report({begun, machine.now, before.pc, bytes, false, before, machine.state});
}

}  // namespace sightline::i8080
