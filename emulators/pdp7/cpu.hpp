// The PDP-7 processor: decodes by the table of isa.hpp and does everything else through bus verbs, so that
// the time of an instruction is a consequence of the cycles it asks for (a test compares their sum with the
// table).
//
// Left out: the ADDRESS switches and single-step keys of the console, and memory protection. Sources: PDP-4
// manual pages 16-23 and 57-58, with which the PDP-7 is program compatible; where that is silent, the choice
// is stated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/bus.hpp"
#include "emulators/pdp7/eae.hpp"
#include "emulators/pdp7/isa.hpp"
#include "emulators/pdp7/model.hpp"
#include "emulators/pdp7/operate.hpp"
#include "emulators/pdp7/state.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline::pdp7 {

namespace detail {

[[nodiscard]] consteval const Instruction& row_of(Operation operation) {
  std::size_t i = 0;
  while (instructions[i].operation != operation) ++i;  // a missing row does not compile
  return instructions[i];
}

// Bits 0-3, by which the processor branches; from the table, so that they are written down once. The EAE
// commands share theirs, and so do OPR and LAW, which bit 4 tells apart.
[[nodiscard]] consteval std::uint32_t code(Operation operation) {
  return row_of(operation).value >> 14;
}

}  // namespace detail

// The processor is a value that holds its bus by value, a light handle on the machine behind it. That lets
// the loop that owns it keep registers and time in host registers: the common instructions are inlined there,
// and the others are executed on a copy out of line, because a call that took the address of the registers
// would keep them in memory, at half the speed.
template <Bus B>
class Cpu {
 public:
  constexpr Cpu(const B& bus, const Model& model, const Timing& timing, const State& state)
      : bus_(bus), model_(&model), timing_(&timing), state_(state) {
    state_.pc &= address_mask;
  }

  [[nodiscard]] constexpr const State& state() const { return state_; }
  [[nodiscard]] constexpr State& state() { return state_; }
  [[nodiscard]] constexpr const B& bus() const { return bus_; }
  [[nodiscard]] constexpr B& bus() { return bus_; }

  // One instruction; a chain of XCTs and what it ends in is one.
  [[gnu::always_inline]] constexpr Outcome step() {
    const Address at = state_.pc;
    const std::uint32_t word = bus_.read(at).value();
    state_.pc = next_in_bank(at);
    if (execute_common(word, at & bank_mask)) [[likely]]
      return Outcome::completed;
    Cpu copy = *this;
    const Outcome outcome = copy.execute_rare(word, at);
    bus_ = copy.bus_;
    state_ = copy.state_;
    return outcome;
  }

  // The program interrupt: the Break cycle that stores the saved word at 0; the next fetch is at 1.
  constexpr void interrupt() {
    enter_bank_zero(1);
    state_.extend = false;
    if (timing_->interrupt_cycles > 1) bus_.idle(machine_cycle * (timing_->interrupt_cycles - 1));
  }

  // The START key: PC from the ADDRESS switches, interrupt system and modes off. AC, L, MQ and SC stay.
  constexpr void start(Address address) {
    state_.pc = address & address_mask;
    state_.interrupts_on = state_.interrupts_deferred = false;
    state_.extend = state_.extend_restore = state_.trap_mode = false;
  }

 private:
  // The memory references but CAL and XCT, LAW, and OPR without OAS and HLT; false: not one of these, nothing
  // done. `bank` is that of the word itself (after an XCT, of its target): direct addresses lie in it.
  [[gnu::always_inline]] constexpr bool execute_common(std::uint32_t word, Address bank) {
    constexpr std::uint32_t rare_opr = operate_bits::oas | operate_bits::hlt;
    constexpr Instruction law = detail::row_of(Operation::law);
    switch ((word >> 14) & 017U) {
      case detail::code(Operation::dac): bus_.write(effective(word, bank), state_.ac); return true;
      case detail::code(Operation::jms): jump_to_subroutine(effective(word, bank)); return true;
      case detail::code(Operation::dzm): bus_.write(effective(word, bank), core::Word18(0)); return true;
      case detail::code(Operation::lac): state_.ac = bus_.read(effective(word, bank)); return true;
      case detail::code(Operation::xor_):
        state_.ac = state_.ac ^ bus_.read(effective(word, bank));
        return true;
      case detail::code(Operation::add): ones_complement_add(bus_.read(effective(word, bank))); return true;
      case detail::code(Operation::tad): twos_complement_add(bus_.read(effective(word, bank))); return true;
      case detail::code(Operation::and_):
        state_.ac = state_.ac & bus_.read(effective(word, bank));
        return true;
      case detail::code(Operation::isz):
        if (bus_.modify(effective(word, bank)).value() == 0) skip();
        return true;
      case detail::code(Operation::sad):
        if (bus_.read(effective(word, bank)) != state_.ac) skip();
        return true;
      case detail::code(Operation::jmp): jump(word, bank); return true;
      case detail::code(Operation::opr):
        if ((word & law.mask) == law.value) {
          state_.ac = core::Word18(word);
          return true;
        }
        if ((word & rare_opr) != 0) return false;
        operate_on_registers(word, core::Word18(0));
        return true;
      default: return false;
    }
  }

  // Everything else, and whatever an XCT leads to. `at` is where the instruction stands.
  [[gnu::noinline]] constexpr Outcome execute_rare(std::uint32_t word, Address at) {
    Address from = at;
    for (int chained = 0; (word >> 14) == detail::code(Operation::xct); ++chained) {
      from = effective(word, from & bank_mask);
      if (chained != 0 && state_.trap_mode) return trap();
      if (chained == longest_xct_chain) return Outcome::xct_chain;
      word = bus_.read(from).value();
    }
    if (execute_common(word, from & bank_mask)) return Outcome::completed;
    switch (instruction_of(word).operation) {
      case Operation::cal: return call((state_.extend ? 0 : state_.pc & bank_mask) | 020, word);
      case Operation::iot: return input_output(word, at);
      case Operation::opr: return operate_with_console(word);
      default: return extended_arithmetic(word, at);
    }
  }

  [[gnu::always_inline]] constexpr void skip() { state_.pc = next_in_bank(state_.pc); }

  // The address of a memory reference, with the Defer cycle of an indirect one.
  [[gnu::always_inline]] constexpr Address effective(std::uint32_t word, Address bank) {
    const Address direct = bank | (word & in_bank_mask);
    return (word & indirect_bit) == 0 ? direct : address_in(defer(direct), direct);
  }

  // Locations 10-17 of any bank count up by one, over all 18 bits, before they point.
  [[gnu::always_inline]] constexpr core::Word18 defer(Address pointer) {
    return (pointer & in_bank_mask & ~Address{07}) == 010 ? bus_.modify(pointer) : bus_.read(pointer);
  }

  // The address a pointer word gives: 15 bits in extend mode, else 13 in the bank the pointer lies in.
  [[nodiscard]] constexpr Address address_in(core::Word18 pointer, Address lies_at) const {
    return state_.extend ? pointer.value() & address_mask
                         : (lies_at & bank_mask) | (pointer.value() & in_bank_mask);
  }

  // After EMIR the JMP I that ends an interrupt still takes 15 bits, then returns to the mode saved in bit 1.
  // (Another simulator changes the mode first; a program outside bank 0 could then not be returned to.)
  [[gnu::always_inline]] constexpr void jump(std::uint32_t word, Address bank) {
    const Address direct = bank | (word & in_bank_mask);
    if ((word & indirect_bit) == 0) {
      state_.pc = direct;
      return;
    }
    const core::Word18 pointer = defer(direct);
    state_.pc = address_in(pointer, direct);
    if (state_.extend_restore) {
      state_.extend_restore = false;
      if (!pointer.bit(1)) state_.extend = false;
    }
  }

  [[gnu::always_inline]] constexpr void jump_to_subroutine(Address subroutine) {
    bus_.write(subroutine, saved_word(state_));
    state_.pc = next_in_bank(subroutine);
  }

  constexpr Outcome call(Address location, std::uint32_t word) {
    jump_to_subroutine((word & indirect_bit) == 0 ? location : address_in(defer(location), location));
    return Outcome::completed;
  }

  // End-around carry; L is set by an overflow and never cleared (PDP-4 manual page 17).
  [[gnu::always_inline]] constexpr void ones_complement_add(core::Word18 operand) {
    std::uint32_t sum = state_.ac.value() + operand.value();
    if (sum > core::Word18::mask) ++sum;
    const core::Word18 result(sum);
    if (state_.ac.negative() == operand.negative() && result.negative() != operand.negative())
      state_.link = true;
    state_.ac = result;
  }

  // The carry out of bit 0 complements L; signs are not examined (page 18).
  [[gnu::always_inline]] constexpr void twos_complement_add(core::Word18 operand) {
    const std::uint32_t sum = state_.ac.value() + operand.value();
    state_.link = state_.link != (sum > core::Word18::mask);
    state_.ac = core::Word18(sum);
  }

  [[gnu::always_inline]] constexpr void operate_on_registers(std::uint32_t word, core::Word18 switches) {
    const Operated result = operate(word, state_.ac, state_.link, switches);
    state_.ac = result.ac;
    state_.link = result.link;
    if (result.skip) skip();
  }

  // OPR with OAS or HLT.
  constexpr Outcome operate_with_console(std::uint32_t word) {
    operate_on_registers(word, (word & operate_bits::oas) != 0 ? bus_.switches() : core::Word18(0));
    if ((word & operate_bits::hlt) == 0) return Outcome::completed;
    return state_.trap_mode ? trap() : Outcome::halted;
  }

  constexpr Outcome extended_arithmetic(std::uint32_t word, Address at) {
    if (!model_->eae) return not_answered(word, at);
    core::Word18 operand;
    if (eae_takes_operand(word)) {
      operand = bus_.read(state_.pc);
      state_.pc = next_in_bank(state_.pc);
    }
    const EaeResult result = execute_eae(word, {state_.ac, state_.mq, state_.sc, state_.link}, operand);
    state_.ac = result.registers.ac;
    state_.mq = result.registers.mq;
    state_.sc = result.registers.sc;
    state_.link = result.registers.link;
    const core::Duration stepping =
        eae_step(word) * result.steps + (is_setup(word) ? timing_->eae_setup : core::Duration{});
    if (stepping.count() != 0) bus_.idle(stepping);
    return Outcome::completed;
  }

  [[nodiscard]] static constexpr bool is_setup(std::uint32_t word) { return (word & 0700U) == 0; }

  [[nodiscard]] constexpr core::Duration eae_step(std::uint32_t word) const {
    switch (instruction_of(word).operation) {
      case Operation::eae_multiply: return timing_->eae_multiply_step;
      case Operation::eae_divide: return timing_->eae_divide_step;
      case Operation::eae_normalize: return timing_->eae_normalize_step;
      default: return timing_->eae_shift_step;
    }
  }

  // Bit 14 clears AC before the pulses; those of the interrupt system and the memory extension stay in the
  // processor, the rest goes out. A pulse that nothing answers makes the instruction one that this machine
  // does not have.
  constexpr Outcome input_output(std::uint32_t word, Address at) {
    if (state_.trap_mode) return trap();
    if ((word & 010U) != 0) state_.ac = core::Word18(0);
    const std::uint32_t inside = processor_pulses(word);
    const IotReply reply = bus_.iot(word, state_.ac);
    state_.ac = reply.ac;
    if (reads_status(word) && state_.interrupts_on) state_.ac = state_.ac | core::Word18(core::Word18::sign);
    if (reply.skip) skip();
    if ((word & 07U & ~(inside | reply.answered)) == 0) return Outcome::completed;
    return not_answered(word, at);
  }

  // The pulses of `word` that are the processor's own, obeyed.
  constexpr std::uint32_t processor_pulses(std::uint32_t word) {
    switch ((word >> 6) & 077U) {
      case 000: return interrupt_system(word);
      case 033:  // SKP7 (this is a PDP-7); subdevice 0 is the teletype's TTS
        if ((word & 041U) != 041U) return 0;
        skip();
        return 01;
      case 077: return model_->extend ? memory_extension(word) : 0;
      default: return 0;
    }
  }

  // IOF 700002, ION 700042, ITON 700062.
  constexpr std::uint32_t interrupt_system(std::uint32_t word) {
    if ((word & 02U) == 0) return 0;
    state_.interrupts_on = state_.interrupts_deferred = (word & 040U) != 0;
    if ((word & 060U) == 060U && model_->trap_mode) state_.trap_mode = true;
    bus_.attention();
    return 02;
  }

  // SEM 707701, EEM 707702, EMIR 707742, LEM 707704.
  constexpr std::uint32_t memory_extension(std::uint32_t word) {
    if ((word & 01U) != 0 && state_.extend) skip();
    if ((word & 02U) != 0) {
      state_.extend = true;
      if ((word & 040U) != 0) state_.extend_restore = true;
    }
    if ((word & 04U) != 0) state_.extend = false;
    return 07;
  }

  constexpr Outcome not_answered(std::uint32_t word, Address at) {
    bus_.unanswered(word, at);
    return model_->strict ? Outcome::unanswered : Outcome::completed;
  }

  // A privileged instruction in trap mode: as an interrupt, but extend mode comes on and the next fetch is
  // at 2. Its Break cycle is taken to follow the instruction directly (unknown).
  constexpr Outcome trap() {
    enter_bank_zero(2);
    state_.extend = true;
    return Outcome::completed;
  }

  constexpr void enter_bank_zero(Address next) {
    bus_.write(0, saved_word(state_));
    state_.pc = next;
    state_.interrupts_on = state_.interrupts_deferred = false;
    state_.extend_restore = state_.trap_mode = false;
  }

  B bus_;
  const Model* model_;
  const Timing* timing_;
  State state_;
};

}  // namespace sightline::pdp7
