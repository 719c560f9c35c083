// The fast engine: functions that each end with a jump to the next instruction's (../core/threads.hpp). The remaining time
// and number of instructions of the run are one word in a host register; only the slow paths access the machine.
#include <cstdint>

#include "../core/allowance.hpp"
#include "../core/inline.hpp"
#include "../core/threads.hpp"
#include "../i8080/cpu.hpp"
#include "i8080_parts.hpp"

namespace sightline::i8080 {

#if SIGHTLINE_THREADS

namespace {

using Allowance = core::Allowance<core::TState>;

// 64K of RAM without wait states.
class FastBus {
 public:
  SIGHTLINE_INLINE explicit FastBus(MachineParts& machine) : FastBus(machine, machine.memory.data(), machine.allowance) {}
  SIGHTLINE_INLINE FastBus(MachineParts& machine, Byte* memory, Allowance allowance)
      : machine_(&machine), memory_(memory), allowance_(allowance) {}

  [[nodiscard]] Byte* memory() const { return memory_; }
  [[nodiscard]] Allowance allowance() const { return allowance_; }
  void count_instruction() { allowance_.count_instruction(); }
  void save() { machine_->allowance = allowance_; }

  // The opcode of the next instruction before its cycle, and the cycle that fetches it.
  [[nodiscard]] SIGHTLINE_INLINE Byte peek(Address address) const { return memory_[address]; }
  SIGHTLINE_INLINE void fetch_peeked(Status, Address, Byte) { allowance_.pass(core::TStates(4)); }

  SIGHTLINE_INLINE Byte fetch(Status, Address address) { return take(address, core::TStates(4)); }
  SIGHTLINE_INLINE Byte operand(Status, Address address) { return take(address, core::TStates(3)); }
  SIGHTLINE_INLINE Byte read(Status, Address address) { return take(address, core::TStates(3)); }
  SIGHTLINE_INLINE void write(Status, Address address, Byte byte) {
    memory_[address] = byte;
    allowance_.pass(core::TStates(3));
  }
  Byte in(Status, Byte port) {
    const Byte byte = machine_->ports.in(port, now() + third_t_state);
    allowance_.pass(core::TStates(3));
    if (machine_->ports.changed()) attention();
    return byte;
  }
  void out(Status, Byte port, Byte byte) {
    machine_->ports.out(port, byte, now() + third_t_state);
    allowance_.pass(core::TStates(3));
    if (machine_->ports.changed()) attention();
  }
  SIGHTLINE_INLINE void internal(Byte, Byte) { allowance_.pass(core::TStates(3)); }
  SIGHTLINE_INLINE void extend(int t_states) { allowance_.pass(core::TStates(t_states)); }
  void halt(Status, Address) {
    machine_->halt_sampled = now() + core::TStates(1);
    allowance_.pass(core::TStates(3));
  }

  void undefined(Byte opcode, Address address) {
    machine_->count_undefined(opcode, address);
    if (machine_->ports.changed()) attention();
  }
  void interrupt_enable(bool) {}
  void end_acknowledge() {}
  bool acknowledging() { return false; }
  SIGHTLINE_INLINE void attention() {
    machine_->deadline = now() - core::TStates(1);
    allowance_.end();
  }

  [[nodiscard]] SIGHTLINE_INLINE bool due() const { return allowance_.over(); }
  [[nodiscard]] SIGHTLINE_INLINE core::TStateInstant now() const { return machine_->deadline - allowance_.left(); }

 private:
  static constexpr core::TStates third_t_state{2};

  SIGHTLINE_INLINE Byte take(Address address, core::TStates length) {
    allowance_.pass(length);
    return memory_[address];
  }

  MachineParts* machine_;
  Byte* memory_;
  Allowance allowance_;
};

// The processor on that bus, in the form that threads.hpp runs.
class FastProcessor {
 public:
  using Frame = MachineParts;
  using Processor = Execution<FastBus>;
  static constexpr unsigned codes = Processor::codes;
  static constexpr bool has_spare_word = false;

  SIGHTLINE_INLINE explicit FastProcessor(MachineParts& machine)
      : execution_(FastBus(machine), machine.state, machine.state) {}

  SIGHTLINE_INLINE static FastProcessor resume(MachineParts& machine, const core::HostWords& words) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): it was made by host_words()
    auto* const memory = reinterpret_cast<Byte*>(static_cast<std::uintptr_t>(words.a));
    const FastBus bus(machine, memory, Allowance(words.b));
    return FastProcessor(Processor(bus, machine.state, machine.state, words.c, static_cast<std::uint32_t>(words.d), words.e));
  }
  [[nodiscard]] SIGHTLINE_INLINE core::HostWords host_words() const {
    return {reinterpret_cast<std::uintptr_t>(execution_.bus().memory()), execution_.bus().allowance().host_word(),
            execution_.a(), execution_.hl(), execution_.pc()};
  }

  [[nodiscard]] SIGHTLINE_INLINE unsigned code() const { return execution_.bus().peek(static_cast<Address>(execution_.pc())); }
  // IN, OUT and HLT access more than the processor and its memory; undefined opcodes are counted.
  template <unsigned code>
  [[nodiscard]] SIGHTLINE_INLINE bool is_rare() const {
    return Processor::is_rare<code>;
  }
  template <unsigned code>
  SIGHTLINE_INLINE void execute() {
    execution_.bus().count_instruction();
    if constexpr (!Processor::is_rare<code>) execution_.step_as<code>();
  }
  void execute_any() {
    execution_.bus().count_instruction();
    execution_.step_rare(static_cast<Byte>(code()));
  }
  [[nodiscard]] SIGHTLINE_INLINE bool leaves() const { return execution_.bus().due(); }
  SIGHTLINE_INLINE void leave() { execution_.save(); }

 private:
  SIGHTLINE_INLINE explicit FastProcessor(const Processor& execution) : execution_(execution) {}

  Processor execution_;
};

}  // namespace

void run_fast(MachineParts& machine, std::int64_t most) {
  machine.allowance = Allowance(machine.deadline - machine.now, most);
  core::Threads<FastProcessor>::run(machine);
  machine.now = machine.deadline - machine.allowance.left();
  machine.instructions += static_cast<std::uint64_t>(most - machine.allowance.instructions());
}

#else

void run_fast(MachineParts& machine, std::int64_t) {
  Watch nobody;
  run_plainly(machine, nobody);
}

#endif

}  // namespace sightline::i8080
