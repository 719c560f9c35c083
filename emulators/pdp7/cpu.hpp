// The PDP-7 processor. It decodes by the table of isa.hpp and does everything else through bus verbs, so that the time of
// an instruction is the consequence of its bus cycles (a test compares their sum with the table).
//
// Left out: the ADDRESS switches and single-step keys of the console, and memory protection. Sources: PDP-4 manual pages
// 16-23 and 57-58, with which the PDP-7 is program compatible; where that is silent, a comment states the choice.
#pragma once

#include <cstddef>
#include <cstdint>

#include "../core/branch.hpp"
#include "../core/dispatch.hpp"
#include "../core/inline.hpp"
#include "../core/word.hpp"
#include "absent_devices.hpp"
#include "bus.hpp"
#include "eae.hpp"
#include "isa.hpp"
#include "model.hpp"
#include "operate.hpp"
#include "registers.hpp"
#include "state.hpp"
#include "timing.hpp"

namespace sightline::pdp7 {

// How an instruction ends.
enum class Outcome : std::uint8_t { completed, halted, xct_chain, unanswered };

// The longest chain of XCTs that is followed; the machine itself would follow a closed chain for ever.
inline constexpr int longest_xct_chain = 16;

// SKP7 is 703341: the pulse, and bit 12. Timing::skip_703361 decides about 703361, which has bit 13 too.
inline constexpr std::uint32_t skp7_bits = 041, skp7_undecided_bit = 020;

namespace detail {

[[nodiscard]] consteval const Instruction& row_of(Operation operation) {
  std::size_t i = 0;
  while (instructions[i].operation != operation) ++i;  // a missing row does not compile
  return instructions[i];
}

// Bits 0-3 of an instruction, from the table, so that they are defined once. All EAE commands have the same, and so do OPR
// and LAW, which bit 4 distinguishes.
[[nodiscard]] consteval std::uint32_t code(Operation operation) {
  return row_of(operation).value >> 14;
}

}  // namespace detail

// The installed options, the registers that few instructions use, and between runs all registers.
struct Processor {
  Processor(const Model& installed, const Timing& times, const State& state)
      : model(&installed), timing(&times), registers(state) {}

  const Model* model;
  const Timing* timing;
  Registers registers;
  Outcome outcome = Outcome::completed;  // of the last instruction, unless it completed
};

// An address in the bank of the running program, where nearly all references go: a bus may access it faster.
struct Here {
  Address bank;
  Address place;
  // NOLINTNEXTLINE(google-explicit-constructor): it is an address like any other
  constexpr operator Address() const { return bank | place; }
};

// A running processor: a value that holds its bus, L, AC and PC, so that a compiler keeps them in host registers. The rest
// is in a Processor, where save() stores these too.
template <Bus B>
class Execution {
 public:
  template <unsigned code>
  static constexpr bool is_always_rare = code >> 1 == detail::code(Operation::cal) ||
                                         code >> 1 == detail::code(Operation::xct) ||
                                         code >> 1 == detail::code(Operation::iot);
  // Bits 0-4 of an instruction, operation and indirect bit, select the code that executes it.
  static constexpr unsigned codes = 32;
  [[nodiscard]] static constexpr unsigned code_of(std::uint32_t word) { return word >> 13; }

  SIGHTLINE_INLINE constexpr Execution(const B& bus, Processor& processor)
      : Execution(bus, processor, processor.registers.accumulator, processor.registers.place) {}
  SIGHTLINE_INLINE constexpr Execution(const B& bus, Processor& processor, Accumulator accumulator, Address place)
      : bus_(bus), processor_(&processor), accumulator_(accumulator), place_(place) {}

  SIGHTLINE_INLINE constexpr void save() {
    processor_->registers.accumulator = accumulator_;
    processor_->registers.place = place_;
    if constexpr (requires { bus_.save(); }) bus_.save();
  }

  [[nodiscard]] constexpr const B& bus() const { return bus_; }
  [[nodiscard]] constexpr B& bus() { return bus_; }
  [[nodiscard]] constexpr Accumulator accumulator() const { return accumulator_; }
  // The address of the next instruction.
  [[nodiscard]] constexpr Here next() const { return {processor_->registers.bank, place_}; }

  // One instruction; a chain of XCTs with its final instruction counts as one.
  constexpr Outcome step() {
    const std::uint32_t word = bus_.fetch(next()).value();
    ++place_;
    const Outcome outcome = execute(word);
    place_ &= in_bank_mask;
    return outcome;
  }

  // The same, for an instruction that a bus with fetch_peeked() has shown.
  constexpr Outcome step(std::uint32_t word) {
    bus_.fetch_peeked(next(), core::Word18(word));
    ++place_;
    const Outcome outcome = execute(word);
    place_ &= in_bank_mask;
    return outcome;
  }

  // The same, compiled for one code: in PC's bank, without a call, so that everything stays in host registers. Not for a
  // word with is_rare<code>().
  template <unsigned code>
  SIGHTLINE_INLINE constexpr void step_as(std::uint32_t word) {
    bus_.fetch_peeked(next(), core::Word18(word));
    ++place_;
    if constexpr (code >> 1 == detail::code(Operation::eae_setup)) {
      calculate(word);
    } else if constexpr (!is_always_rare<code>) {
      execute_common<code>(word, InPlace{this});
    }
    place_ &= in_bank_mask;
  }

  // A word that accesses more than PC's bank and the processor, or may not end as usual.
  template <unsigned code>
  [[nodiscard]] SIGHTLINE_INLINE constexpr bool is_rare(std::uint32_t word) const {
    constexpr unsigned operation = code >> 1;
    constexpr std::uint32_t rare_opr = operate_bits::oas | operate_bits::hlt;
    if constexpr (is_always_rare<code>) return true;
    else if constexpr (operation == detail::code(Operation::eae_setup)) return !processor_->model->eae;
    else if constexpr (code == code_of(detail::row_of(Operation::opr).value)) return (word & rare_opr) != 0;
    else if constexpr (operation == detail::code(Operation::opr)) return false;
    else if constexpr ((code & 1U) != 0) return processor_->registers.is(mode::extend | mode::extend_restore);
    else return false;
  }

  // The program interrupt: the Break cycle that stores the saved word at 0; the next fetch is at 1.
  constexpr void interrupt() {
    bus_.interrupt(saved_word());
    enter_bank_zero(1);
    clear(mode::extend);
    if (processor_->timing->interrupt_cycles > 1)
      bus_.idle(machine_cycle * (processor_->timing->interrupt_cycles - 1));
  }

  // The START key: PC from the ADDRESS switches, interrupt system and modes off. AC, L, MQ and SC keep their values.
  constexpr void start(Address address) {
    go_to(address);
    clear(~0U);
  }

 private:
  // The direct addresses of an instruction in the bank of PC, where nearly all instructions are.
  struct InPlace {
    const Execution* execution;
    SIGHTLINE_INLINE constexpr Here operator()(std::uint32_t word) const {
      return {execution->processor_->registers.bank, word & in_bank_mask};
    }
  };
  // The same for a word in another bank, which an XCT can reach.
  struct InBank {
    Address bank;
    SIGHTLINE_INLINE constexpr Address operator()(std::uint32_t word) const { return bank | (word & in_bank_mask); }
  };

  // The memory references except CAL and XCT, LAW, and OPR without HLT and OAS.
  template <unsigned code, class Direct>
  SIGHTLINE_INLINE constexpr void execute_common(std::uint32_t word, Direct direct) {
    constexpr unsigned operation = code >> 1;
    constexpr bool indirect = (code & 1U) != 0;
    static_assert(code_of(detail::row_of(Operation::law).value) == (code_of(detail::row_of(Operation::opr).value) | 1U));
    if constexpr (operation == detail::code(Operation::opr)) {
      if constexpr (indirect) {
        accumulator_.set_ac(core::Word18(word));
      } else {
        operate_on_registers(word, core::Word18(0));
      }
    } else if constexpr (operation == detail::code(Operation::jmp)) {
      if constexpr (indirect) {
        jump_indirect(direct(word));
      } else {
        go_to(direct(word));
      }
    } else if constexpr (indirect) {
      const auto lies_at = direct(word);
      refer<operation>(address_in(defer(lies_at), lies_at));
    } else {
      refer<operation>(direct(word));
    }
  }

  // A memory reference with its address, a Here or an Address.
  template <unsigned operation, class At>
  SIGHTLINE_INLINE constexpr void refer(At at) {
    if constexpr (operation == detail::code(Operation::dac)) {
      bus_.write(at, accumulator_.ac());
    } else if constexpr (operation == detail::code(Operation::jms)) {
      jump_to_subroutine(at);
    } else if constexpr (operation == detail::code(Operation::dzm)) {
      bus_.write(at, core::Word18(0));
    } else if constexpr (operation == detail::code(Operation::lac)) {
      accumulator_.set_ac(bus_.read(at));
    } else if constexpr (operation == detail::code(Operation::xor_)) {
      accumulator_.exclusive_or(bus_.read(at));
    } else if constexpr (operation == detail::code(Operation::add)) {
      ones_complement_add(bus_.read(at));
    } else if constexpr (operation == detail::code(Operation::tad)) {
      accumulator_.add(bus_.read(at));
    } else if constexpr (operation == detail::code(Operation::and_)) {
      accumulator_.and_(bus_.read(at));
    } else if constexpr (operation == detail::code(Operation::isz)) {
      skip_if(bus_.modify(at).value() == 0);
    } else {
      static_assert(operation == detail::code(Operation::sad));
      skip_if(bus_.read(at) != accumulator_.ac());
    }
  }

  // Any instruction, including the targets of an XCT.
  constexpr Outcome execute(std::uint32_t word) {
    const Address at = instruction_address();
    Address from = at;
    for (int chained = 0; (word >> 14) == detail::code(Operation::xct); ++chained) {
      from = effective(word, from & bank_mask);
      if (chained != 0 && processor_->registers.is(mode::trap)) return trap();
      if (chained == longest_xct_chain) return Outcome::xct_chain;
      word = bus_.read(from).value();
    }
    switch (instruction_of(word).operation) {
      case Operation::cal:
        return call((processor_->registers.is(mode::extend) ? 0 : processor_->registers.bank) | 020, word);
      case Operation::iot: return input_output(word, at);
      case Operation::opr: return operate_with_console(word);
      default: break;
    }
    if ((word >> 14) == detail::code(Operation::eae_setup)) {
      if (!processor_->model->eae) return report_unanswered(word, at);
      calculate(word);
    } else {
      core::dispatch<codes>(code_of(word), Common{this, word, InBank{from & bank_mask}});
    }
    return Outcome::completed;
  }

  struct Common {
    Execution* execution;
    std::uint32_t word;
    InBank direct;
    template <unsigned code>
    SIGHTLINE_INLINE constexpr void execute() const {
      if constexpr (!is_always_rare<code> && code >> 1 != detail::code(Operation::eae_setup))
        execution->template execute_common<code>(word, direct);
    }
  };

  // The address of a memory reference, with the Defer cycle of an indirect one.
  constexpr Address effective(std::uint32_t word, Address bank) {
    const Address direct = bank | (word & in_bank_mask);
    return (word & indirect_bit) != 0 ? address_in(defer(direct), direct) : direct;
  }

  // Locations 10-17 of any bank are incremented, as 18-bit words, before they are used as pointers.
  template <class At>
  SIGHTLINE_INLINE constexpr core::Word18 defer(At pointer) {
    if ((Address{pointer} & in_bank_mask & ~Address{07}) == 010) return bus_.modify(pointer);
    return bus_.read(pointer);
  }

  // The address in a pointer word: 15 bits in extend mode, otherwise 13 in the bank of the pointer. The Here version is
  // never called in extend mode.
  [[nodiscard]] SIGHTLINE_INLINE static constexpr Here address_in(core::Word18 pointer, Here lies_at) {
    return {lies_at.bank, pointer.value() & in_bank_mask};
  }
  [[nodiscard]] constexpr Address address_in(core::Word18 pointer, Address lies_at) const {
    return processor_->registers.is(mode::extend) ? pointer.value() & address_mask
                                                  : (lies_at & bank_mask) | (pointer.value() & in_bank_mask);
  }

  // After EMIR the JMP I that ends an interrupt still takes 15 bits, then restores the mode saved in bit 1. (Another
  // simulator changes the mode first; then an interrupt could not return to a program outside bank 0.)
  SIGHTLINE_INLINE constexpr void jump_indirect(Here lies_at) { go_to(address_in(defer(lies_at), lies_at)); }
  constexpr void jump_indirect(Address lies_at) {
    const core::Word18 pointer = defer(lies_at);
    go_to(address_in(pointer, lies_at));
    if (processor_->registers.is(mode::extend_restore)) {
      clear(mode::extend_restore);
      if (!pointer.bit(1)) clear(mode::extend);
    }
  }

  template <class At>
  SIGHTLINE_INLINE constexpr void jump_to_subroutine(At subroutine) {
    bus_.write(subroutine, saved_word());
    go_to(subroutine);
    ++place_;
  }

  constexpr Outcome call(Address location, std::uint32_t word) {
    jump_to_subroutine((word & indirect_bit) == 0 ? location : address_in(defer(location), location));
    return Outcome::completed;
  }

  // End-around carry; L is set by an overflow and never cleared (PDP-4 manual page 17).
  SIGHTLINE_INLINE constexpr void ones_complement_add(core::Word18 operand) {
    const core::Word18 ac = accumulator_.ac();
    std::uint32_t sum = ac.value() + operand.value();
    sum = (sum & core::Word18::mask) + (sum >> 18);
    const std::uint32_t overflow = ~(ac.value() ^ operand.value()) & (sum ^ ac.value()) & core::Word18::sign;
    accumulator_ = Accumulator((accumulator_.bits() & Accumulator::carry) | sum | overflow << 1);
  }

  SIGHTLINE_INLINE constexpr void operate_on_registers(std::uint32_t word, core::Word18 switches) {
    const OperatedBits result = operate_on_bits(word, accumulator_.bits(), switches);
    accumulator_ = Accumulator(result.lac);
    skip_if(result.skip);
  }

  // OPR with OAS or HLT, or after an XCT.
  constexpr Outcome operate_with_console(std::uint32_t word) {
    operate_on_registers(word, (word & operate_bits::oas) != 0 ? bus_.switches() : core::Word18(0));
    if ((word & operate_bits::hlt) == 0) return Outcome::completed;
    return processor_->registers.is(mode::trap) ? trap() : Outcome::halted;
  }

  // Class 64 with the EAE.
  SIGHTLINE_INLINE constexpr void calculate(std::uint32_t word) {
    core::Word18 operand;
    if (eae_takes_operand(word)) {
      operand = bus_.read(here());
      ++place_;
    }
    Registers& r = processor_->registers;
    const EaeResult result = execute_eae(word, {accumulator_.ac(), r.mq, r.sc, accumulator_.link()}, operand);
    accumulator_ = Accumulator(result.registers.ac, result.registers.link);
    r.mq = result.registers.mq;
    r.sc = result.registers.sc;
    const core::Duration stepping = eae_time(word, result.steps);
    if (stepping.count() != 0) bus_.idle(stepping);
  }

  // A setup makes no step, but takes a time.
  [[nodiscard]] SIGHTLINE_INLINE constexpr core::Duration eae_time(std::uint32_t word, int steps) const {
    const Timing& timing = *processor_->timing;
    switch ((word >> 6) & 07U) {
      case 0: return timing.eae_setup;
      case 1: return timing.eae_multiply_step * steps;
      case 3: return timing.eae_divide_step * steps;
      case 4: return timing.eae_normalize_step * steps;
      default: return timing.eae_shift_step * steps;
    }
  }

  // Bit 14 clears AC before the pulses. The processor obeys the pulses of the interrupt system and the memory extension
  // itself; the others go to the bus. If no pulse of an instruction has a device, this machine does not have the
  // instruction.
  constexpr Outcome input_output(std::uint32_t word, Address at) {
    if (processor_->registers.is(mode::trap)) return trap();
    if ((word & 010U) != 0) accumulator_.set_ac(core::Word18(0));
    const std::uint32_t inside = processor_pulses(word);
    const IotReply reply = bus_.iot(word, accumulator_.ac());
    const bool on = reads_status(word) && processor_->registers.is(mode::interrupts_on);
    accumulator_.set_ac(on ? reply.ac | core::Word18(core::Word18::sign) : reply.ac);
    if (reply.skip) skip();
    if ((word & 07U) == 0 || (word & 07U & (inside | reply.answered)) != 0 || belongs_to_absent_device(word))
      return Outcome::completed;
    return report_unanswered(word, at);
  }

  // Obeys the processor's pulses of `word` and returns them.
  constexpr std::uint32_t processor_pulses(std::uint32_t word) {
    switch ((word >> 6) & 077U) {
      case 000: return interrupt_system(word);
      case 033:  // SKP7 (this is a PDP-7); subdevice 0 is the teletype's TTS
        if ((word & skp7_bits) != skp7_bits) return 0;
        if ((word & skp7_undecided_bit) != 0 && !processor_->timing->skip_703361) return 0;
        skip();
        return 01;
      case 077: return processor_->model->extend ? memory_extension(word) : 0;
      default: return 0;
    }
  }

  // IOF 700002, ION 700042, ITON 700062.
  constexpr std::uint32_t interrupt_system(std::uint32_t word) {
    if ((word & 02U) == 0) return 0;
    clear(mode::interrupts_on | mode::interrupts_deferred);
    if ((word & 040U) != 0) set(mode::interrupts_on | mode::interrupts_deferred);
    if ((word & 060U) == 060U && processor_->model->trap_mode) set(mode::trap);
    bus_.attention();
    return 02;
  }

  // SEM 707701, EEM 707702, EMIR 707742, LEM 707704.
  constexpr std::uint32_t memory_extension(std::uint32_t word) {
    if ((word & 01U) != 0 && processor_->registers.is(mode::extend)) skip();
    if ((word & 02U) != 0) {
      set(mode::extend);
      if ((word & 040U) != 0) set(mode::extend_restore);
    }
    if ((word & 04U) != 0) clear(mode::extend);
    return 07;
  }

  constexpr Outcome report_unanswered(std::uint32_t word, Address at) {
    bus_.unanswered(word, at);
    return processor_->model->strict ? Outcome::unanswered : Outcome::completed;
  }

  // A privileged instruction in trap mode: as an interrupt, but extend mode comes on and the next fetch is at 2. Its Break
  // cycle is assumed to follow the instruction directly (unknown).
  constexpr Outcome trap() {
    bus_.write(Address{0}, saved_word());
    enter_bank_zero(2);
    set(mode::extend);
    return Outcome::completed;
  }

  constexpr void enter_bank_zero(Address next) {
    go_to(next);
    clear(~mode::extend);
  }

  SIGHTLINE_INLINE constexpr void go_to(Here next) { place_ = next.place; }
  SIGHTLINE_INLINE constexpr void go_to(Address next) {
    place_ = next & in_bank_mask;
    processor_->registers.bank = next & bank_mask;
    if constexpr (requires { bus_.enter(Address{}); }) bus_.enter(next & bank_mask);
  }
  // PC within an instruction: 17777 is followed by 00000.
  [[nodiscard]] SIGHTLINE_INLINE constexpr Here here() const {
    return {processor_->registers.bank, place_ & in_bank_mask};
  }
  SIGHTLINE_INLINE constexpr void skip() { ++place_; }
  SIGHTLINE_INLINE constexpr void skip_if(bool condition) { core::set_by_branch(condition, place_, place_ + 1); }
  // The address of the instruction that has just been fetched.
  [[nodiscard]] constexpr Address instruction_address() const {
    return processor_->registers.bank | ((place_ - 1) & in_bank_mask);
  }
  constexpr void set(std::uint32_t modes) { processor_->registers.modes |= modes; }
  constexpr void clear(std::uint32_t modes) { processor_->registers.modes &= ~modes; }
  // The word that JMS, CAL, an interrupt and a trap store: bit 0 L, bit 1 extend mode, bit 2 trap mode, bits 3-17 PC.
  [[nodiscard]] SIGHTLINE_INLINE constexpr core::Word18 saved_word() const {
    const std::uint32_t modes = processor_->registers.modes;
    return core::Word18((accumulator_.bits() & Accumulator::carry) >> 1 | (modes & (mode::extend | mode::trap)) |
                        Address{here()});
  }

  B bus_;
  Processor* processor_;
  Accumulator accumulator_;
  Address place_;  // of PC, in its bank; within an instruction it may be one past the end
};

// A processor that owns its bus and executes one instruction per call.
template <Bus B>
class Cpu {
 public:
  // `model` and `timing` must outlive the processor.
  constexpr Cpu(const B& bus, const Model& model, const Timing& timing, const State& state)
      : bus_(bus), processor_(model, timing, state) {}

  [[nodiscard]] constexpr State state() const { return processor_.registers.state(); }
  [[nodiscard]] constexpr Address pc() const { return processor_.registers.pc(); }

  constexpr Outcome step() {
    Execution<B> execution(bus_, processor_);
    const Outcome outcome = execution.step();
    execution.save();
    bus_ = execution.bus();
    return outcome;
  }

 private:
  B bus_;
  Processor processor_;
};

}  // namespace sightline::pdp7
