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

#include "emulators/core/inline.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/absent_devices.hpp"
#include "emulators/pdp7/cpu.hpp"
#include "emulators/pdp7/bus.hpp"
#include "tests/emulators/reference/pdp7/eae.hpp"
#include "emulators/pdp7/isa.hpp"
#include "tests/emulators/reference/pdp7/operate.hpp"
#include "tests/emulators/reference/pdp7/registers.hpp"
#include "emulators/pdp7/state.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline::reference {
using namespace pdp7;


// The processor is a value that holds its bus by value, a light handle on the machine behind it. That lets
// the loop that owns it keep registers and time in host registers: the common instructions are inlined there,
// and the others are executed on a copy out of line, because a call that took the address of the registers
// would keep them in memory, at half the speed.
template <Bus B>
class Cpu {
 public:
  constexpr Cpu(const B& bus, const Model& model, const Timing& timing, const State& state)
      : bus_(bus), model_(&model), timing_(&timing), registers_(state) {}

  [[nodiscard]] constexpr State state() const { return registers_.state(); }
  [[nodiscard]] constexpr Address pc() const { return registers_.pc(); }
  [[nodiscard]] constexpr const B& bus() const { return bus_; }
  [[nodiscard]] constexpr B& bus() { return bus_; }

  // One instruction; a chain of XCTs and what it ends in is one.
  SIGHTLINE_INLINE constexpr Outcome step() {
    const std::uint32_t word = bus_.fetch(registers_.pc()).value();
    registers_.skip();
    if (execute_common(word, registers_.bank())) [[likely]]
      return Outcome::completed;
    Cpu copy = *this;
    const Outcome outcome = copy.execute_rare(word, registers_.before());
    bus_ = copy.bus_;
    registers_ = copy.registers_;
    return outcome;
  }

  // An interrupt may be taken at this boundary, if one is requested. This test ends the delay of
  // ION.
  [[nodiscard]] constexpr bool interrupts_open() const {
    return registers_.is(mode::interrupts_on) && !registers_.is(mode::interrupts_deferred);
  }
  [[nodiscard]] constexpr bool interrupts_deferred() const {
    return registers_.is(mode::interrupts_deferred);
  }
  constexpr void end_interrupt_delay() { registers_.clear(mode::interrupts_deferred); }

  // The program interrupt: the Break cycle that stores the saved word at 0; the next fetch is at 1.
  constexpr void interrupt() {
    bus_.interrupt(registers_.saved_word());
    enter_bank_zero(1);
    registers_.clear(mode::extend);
    if (timing_->interrupt_cycles > 1) bus_.idle(machine_cycle * (timing_->interrupt_cycles - 1));
  }

  // The START key: PC from the ADDRESS switches, interrupt system and modes off. AC, L, MQ and SC stay.
  constexpr void start(Address address) {
    registers_.set_pc(address);
    registers_.clear(~0U);
  }

 private:
  // The memory references but CAL and XCT, LAW, and OPR without OAS and HLT; false: not one of these, nothing
  // done. `bank` is that of the word itself (after an XCT, of its target): direct addresses lie in it. The
  // indirect bit is tested first, so that a direct reference goes straight to its operand; among the
  // operate words it is the bit of LAW.
  SIGHTLINE_INLINE constexpr bool execute_common(std::uint32_t word, Address bank) {
    if ((word & indirect_bit) != 0) return execute_common_as<true>(word, bank);
    return execute_common_as<false>(word, bank);
  }

  template <bool indirect>
  SIGHTLINE_INLINE constexpr bool execute_common_as(std::uint32_t word, Address bank) {
    constexpr std::uint32_t rare_opr = operate_bits::oas | operate_bits::hlt;
    static_assert(pdp7::detail::row_of(Operation::law).value ==
                  (pdp7::detail::row_of(Operation::opr).value | indirect_bit));
    const auto address = [&]() __attribute__((always_inline)) { return effective<indirect>(word, bank); };
    switch ((word >> 14) & 017U) {
      case pdp7::detail::code(Operation::dac): bus_.write(address(), registers_.ac); return true;
      case pdp7::detail::code(Operation::jms): jump_to_subroutine(address()); return true;
      case pdp7::detail::code(Operation::dzm): bus_.write(address(), core::Word18(0)); return true;
      case pdp7::detail::code(Operation::lac): registers_.ac = bus_.read(address()); return true;
      case pdp7::detail::code(Operation::xor_): registers_.ac = registers_.ac ^ bus_.read(address()); return true;
      case pdp7::detail::code(Operation::add): ones_complement_add(bus_.read(address())); return true;
      case pdp7::detail::code(Operation::tad): twos_complement_add(bus_.read(address())); return true;
      case pdp7::detail::code(Operation::and_): registers_.ac = registers_.ac & bus_.read(address()); return true;
      case pdp7::detail::code(Operation::isz):
        if (bus_.modify(address()).value() == 0) registers_.skip();
        return true;
      case pdp7::detail::code(Operation::sad):
        if (bus_.read(address()) != registers_.ac) registers_.skip();
        return true;
      case pdp7::detail::code(Operation::jmp): jump<indirect>(word, bank); return true;
      case pdp7::detail::code(Operation::opr):
        if constexpr (indirect) {
          registers_.ac = core::Word18(word);
          return true;
        }
        if ((word & rare_opr) != 0) return false;
        operate_on_registers(word, core::Word18(0));
        return true;
      case pdp7::detail::code(Operation::cal):
      case pdp7::detail::code(Operation::xct):
      case pdp7::detail::code(Operation::iot):
      case pdp7::detail::code(Operation::eae_setup): return false;
    }
    return false;
  }

  // Everything else, and whatever an XCT leads to. `at` is the address of the instruction.
  [[gnu::noinline]] constexpr Outcome execute_rare(std::uint32_t word, Address at) {
    Address from = at;
    for (int chained = 0; (word >> 14) == pdp7::detail::code(Operation::xct); ++chained) {
      from = effective(word, from & bank_mask);
      if (chained != 0 && registers_.is(mode::trap)) return trap();
      if (chained == longest_xct_chain) return Outcome::xct_chain;
      word = bus_.read(from).value();
    }
    if (execute_common(word, from & bank_mask)) return Outcome::completed;
    switch (instruction_of(word).operation) {
      case Operation::cal: return call((registers_.is(mode::extend) ? 0 : registers_.bank()) | 020, word);
      case Operation::iot: return input_output(word, at);
      case Operation::opr: return operate_with_console(word);
      default: return extended_arithmetic(word, at);
    }
  }

  // The address of a memory reference, with the Defer cycle of an indirect one.
  template <bool indirect>
  SIGHTLINE_INLINE constexpr Address effective(std::uint32_t word, Address bank) {
    const Address direct = bank | (word & in_bank_mask);
    if constexpr (!indirect) return direct;
    return address_in(defer(direct), direct);
  }
  constexpr Address effective(std::uint32_t word, Address bank) {
    return (word & indirect_bit) != 0 ? effective<true>(word, bank) : effective<false>(word, bank);
  }

  // Locations 10-17 of any bank count up by one, over all 18 bits, before they point.
  SIGHTLINE_INLINE constexpr core::Word18 defer(Address pointer) {
    return (pointer & in_bank_mask & ~Address{07}) == 010 ? bus_.modify(pointer) : bus_.read(pointer);
  }

  // The address a pointer word gives: 15 bits in extend mode, else 13 in the bank the pointer lies in.
  [[nodiscard]] constexpr Address address_in(core::Word18 pointer, Address lies_at) const {
    return registers_.is(mode::extend) ? pointer.value() & address_mask
                                       : (lies_at & bank_mask) | (pointer.value() & in_bank_mask);
  }

  // After EMIR the JMP I that ends an interrupt still takes 15 bits, then returns to the mode saved in bit 1.
  // (Another simulator changes the mode first; a program outside bank 0 could then not be returned to.)
  template <bool indirect>
  SIGHTLINE_INLINE constexpr void jump(std::uint32_t word, Address bank) {
    const Address direct = bank | (word & in_bank_mask);
    if constexpr (!indirect) {
      registers_.set_pc(bank, word & in_bank_mask);
      return;
    }
    const core::Word18 pointer = defer(direct);
    registers_.set_pc(address_in(pointer, direct));
    if (registers_.is(mode::extend_restore)) {
      registers_.clear(mode::extend_restore);
      if (!pointer.bit(1)) registers_.clear(mode::extend);
    }
  }

  SIGHTLINE_INLINE constexpr void jump_to_subroutine(Address subroutine) {
    bus_.write(subroutine, registers_.saved_word());
    registers_.set_pc(subroutine);
    registers_.skip();
  }

  constexpr Outcome call(Address location, std::uint32_t word) {
    jump_to_subroutine((word & indirect_bit) == 0 ? location : address_in(defer(location), location));
    return Outcome::completed;
  }

  // End-around carry; L is set by an overflow and never cleared (PDP-4 manual page 17).
  SIGHTLINE_INLINE constexpr void ones_complement_add(core::Word18 operand) {
    std::uint32_t sum = registers_.ac.value() + operand.value();
    if (sum > core::Word18::mask) ++sum;
    const core::Word18 result(sum);
    if (registers_.ac.negative() == operand.negative() && result.negative() != operand.negative())
      registers_.set_link(true);
    registers_.ac = result;
  }

  // The carry out of bit 0 complements L; signs are not examined (page 18).
  SIGHTLINE_INLINE constexpr void twos_complement_add(core::Word18 operand) {
    const std::uint32_t sum = registers_.ac.value() + operand.value();
    registers_.add_carry(sum);
    registers_.ac = core::Word18(sum);
  }

  SIGHTLINE_INLINE constexpr void operate_on_registers(std::uint32_t word, core::Word18 switches) {
    const Operated result = operate(word, registers_.ac, registers_.link(), switches);
    registers_.ac = result.ac;
    registers_.set_link(result.link);
    if (result.skip) registers_.skip();
  }

  // OPR with OAS or HLT.
  constexpr Outcome operate_with_console(std::uint32_t word) {
    operate_on_registers(word, (word & operate_bits::oas) != 0 ? bus_.switches() : core::Word18(0));
    if ((word & operate_bits::hlt) == 0) return Outcome::completed;
    return registers_.is(mode::trap) ? trap() : Outcome::halted;
  }

  constexpr Outcome extended_arithmetic(std::uint32_t word, Address at) {
    if (!model_->eae) return not_answered(word, at);
    core::Word18 operand;
    if (eae_takes_operand(word)) {
      operand = bus_.read(registers_.pc());
      registers_.skip();
    }
    const EaeResult result =
        execute_eae(word, {registers_.ac, registers_.mq, registers_.sc, registers_.link()}, operand);
    registers_.ac = result.registers.ac;
    registers_.mq = result.registers.mq;
    registers_.sc = result.registers.sc;
    registers_.set_link(result.registers.link);
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
  // processor, the rest goes out. Pulses that all have no device make the instruction one that this machine
  // does not have.
  constexpr Outcome input_output(std::uint32_t word, Address at) {
    if (registers_.is(mode::trap)) return trap();
    if ((word & 010U) != 0) registers_.ac = core::Word18(0);
    const std::uint32_t inside = processor_pulses(word);
    const IotReply reply = bus_.iot(word, registers_.ac);
    registers_.ac = reply.ac;
    if (reads_status(word) && registers_.is(mode::interrupts_on))
      registers_.ac = registers_.ac | core::Word18(core::Word18::sign);
    if (reply.skip) registers_.skip();
    if ((word & 07U) == 0 || (word & 07U & (inside | reply.answered)) != 0 || belongs_to_absent_device(word))
      return Outcome::completed;
    return not_answered(word, at);
  }

  // The pulses of `word` that are the processor's own, obeyed.
  constexpr std::uint32_t processor_pulses(std::uint32_t word) {
    switch ((word >> 6) & 077U) {
      case 000: return interrupt_system(word);
      case 033:  // SKP7 (this is a PDP-7); subdevice 0 is the teletype's TTS
        if ((word & skp7_bits) != skp7_bits) return 0;
        registers_.skip();
        return 01;
      case 077: return model_->extend ? memory_extension(word) : 0;
      default: return 0;
    }
  }

  // IOF 700002, ION 700042, ITON 700062.
  constexpr std::uint32_t interrupt_system(std::uint32_t word) {
    if ((word & 02U) == 0) return 0;
    registers_.clear(mode::interrupts_on | mode::interrupts_deferred);
    if ((word & 040U) != 0) registers_.set(mode::interrupts_on | mode::interrupts_deferred);
    if ((word & 060U) == 060U && model_->trap_mode) registers_.set(mode::trap);
    bus_.attention();
    return 02;
  }

  // SEM 707701, EEM 707702, EMIR 707742, LEM 707704.
  constexpr std::uint32_t memory_extension(std::uint32_t word) {
    if ((word & 01U) != 0 && registers_.is(mode::extend)) registers_.skip();
    if ((word & 02U) != 0) {
      registers_.set(mode::extend);
      if ((word & 040U) != 0) registers_.set(mode::extend_restore);
    }
    if ((word & 04U) != 0) registers_.clear(mode::extend);
    return 07;
  }

  constexpr Outcome not_answered(std::uint32_t word, Address at) {
    bus_.unanswered(word, at);
    return model_->strict ? Outcome::unanswered : Outcome::completed;
  }

  // A privileged instruction in trap mode: as an interrupt, but extend mode comes on and the next fetch is
  // at 2. Its Break cycle is taken to follow the instruction directly (unknown).
  constexpr Outcome trap() {
    bus_.write(0, registers_.saved_word());
    enter_bank_zero(2);
    registers_.set(mode::extend);
    return Outcome::completed;
  }

  constexpr void enter_bank_zero(Address next) {
    registers_.set_pc(next);
    registers_.clear(~mode::extend);
  }

  B bus_;
  const Model* model_;
  const Timing* timing_;
  Registers registers_;
};

}  // namespace sightline::reference
