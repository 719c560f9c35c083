// The 8080 processor: each opcode is compiled from its row of isa.hpp and does everything else through bus verbs, so
// that the time of an instruction is the consequence of the cycles it asks for (a test compares their sum with the
// table).
//
// Left out: ALU results appear when the instruction ends, not in T2 of the next fetch, which no program can tell; an
// XTHL or HLT given by an interrupting device while INT stays high, which the chip garbles.
// Sources: Intel MCS-80 User's Manual, chapters 2 and 4; the gate-level model of the KR580VM80A where that is silent.
#pragma once

#include <cstdint>

#include "emulators/core/inline.hpp"
#include "emulators/i8080/alu.hpp"
#include "emulators/i8080/cpu.hpp"
#include "emulators/i8080/bus.hpp"
#include "tests/emulators/reference/i8080/dispatch.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"

namespace sightline::reference_8080 {
using namespace i8080;



// The processor is a value that holds its registers and its bus by value, a light handle on the machine behind it.
// That lets the loop that owns it keep registers and time in host registers; what is rare runs on a copy out of line,
// because a call that took the address of the registers would keep them in memory. Control, which hardly any
// instruction touches, stays with the owner for the same reason.
template <Bus B>
class Cpu {
 public:
  // `control` must outlive the processor.
  constexpr Cpu(const B& bus, const Registers& registers, Control& control)
      : bus_(bus), control_(&control), registers_(registers) {
    registers_.f = as_flags(registers.f);
  }

  [[nodiscard]] constexpr const Registers& registers() const { return registers_; }
  [[nodiscard]] constexpr State state() const { return {registers_, *control_}; }
  [[nodiscard]] constexpr Address pc() const { return registers_.pc; }
  [[nodiscard]] constexpr const B& bus() const { return bus_; }
  [[nodiscard]] constexpr B& bus() { return bus_; }

  // One instruction from memory.
  SIGHTLINE_INLINE constexpr Outcome step() {
    const Byte opcode = bus_.fetch(status::fetch_cycle, registers_.pc);
    ++registers_.pc;
    return dispatch(opcode, Executor<false>{this});
  }

  // The interrupt: one instruction from the device that answers the acknowledge. PC does not change while it is read, so
  // a CALL or RST pushes the address of the instruction that was to come next.
  constexpr Outcome acknowledge() {
    Cpu copy = *this;
    const Outcome outcome = copy.acknowledge_out_of_line();
    *this = copy;
    return outcome;
  }

  // The RESET pin: A, F, B to L and SP stay. The next fetch is at 0000.
  constexpr void reset() {
    registers_.pc = 0;
    *control_ = {};
    bus_.end_acknowledge();
    bus_.interrupt_enable(false);
  }

 private:
  // Jammed: the instruction came from an acknowledge cycle.
  template <bool Jammed>
  struct Executor {
    Cpu* cpu;
    template <Byte Opcode>
    SIGHTLINE_INLINE constexpr Outcome execute() const {
      return cpu->template execute<Opcode, Jammed>();
    }
  };

  [[gnu::noinline]] constexpr Outcome acknowledge_out_of_line() {
    control_->interrupts_on = control_->halted = false;
    bus_.interrupt_enable(false);
    const Byte opcode = bus_.fetch(status::acknowledge_cycle, registers_.pc);
    return dispatch(opcode, Executor<true>{this});
  }

  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr Outcome execute() {
    constexpr const Instruction& row = lookup(Opcode);
    if constexpr (Jammed && (row.operation == Operation::rst || row.operation == Operation::ei ||
                             row.operation == Operation::di)) {
      bus_.end_acknowledge();
    }
    if constexpr (row.cycles[0].t_states == 5) bus_.extend(1);
    if constexpr (row.operation == Operation::hlt) {
      bus_.halt(cycle<Jammed>(status::halt_cycle), static_cast<Address>(registers_.pc - (Jammed ? 0 : 1)));
      control_->halted = true;
      bus_.attention();
      return Outcome::halted;
    } else {
      if constexpr (row.operation <= Operation::lda) {
        move<Opcode, Jammed>();
      } else if constexpr (row.operation <= Operation::cmp) {
        calculate<Opcode, Jammed>();
      } else if constexpr (row.operation <= Operation::rst) {
        branch<Opcode, Jammed>();
      } else {
        stack_and_control<Opcode, Jammed>();
      }
      return Outcome::completed;
    }
  }

  // NOP to LDA in the order of Operation: transfers, and the counting of registers, pairs and M.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void move() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned to = Opcode >> 3 & 7;
    constexpr unsigned pair_code = Opcode >> 4 & 3;
    if constexpr (operation == Operation::lxi) {
      pair<pair_code>() = next_word<Jammed>();
    } else if constexpr (operation == Operation::stax) {
      store<Jammed>(pair<pair_code>(), registers_.a);
    } else if constexpr (operation == Operation::ldax) {
      registers_.a = load<Jammed>(pair<pair_code>());
    } else if constexpr (operation == Operation::inx) {
      ++pair<pair_code>();
    } else if constexpr (operation == Operation::dcx) {
      --pair<pair_code>();
    } else if constexpr (operation == Operation::inr) {
      const Result result = increment(get<to, Jammed>(), registers_.f);
      registers_.f = result.flags;
      set<to, Jammed>(result.value);
    } else if constexpr (operation == Operation::dcr) {
      const Result result = decrement(get<to, Jammed>(), registers_.f);
      registers_.f = result.flags;
      set<to, Jammed>(result.value);
    } else if constexpr (operation == Operation::mvi) {
      set<to, Jammed>(next_byte<Jammed>());
    } else if constexpr (operation == Operation::mov) {
      set<to, Jammed>(get<Opcode & 7, Jammed>());
    } else if constexpr (operation == Operation::dad) {
      add_to_hl(pair<pair_code>());
    } else {
      move_direct<Opcode, Jammed>();
    }
  }

  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void move_direct() {
    constexpr Operation operation = lookup(Opcode).operation;
    if constexpr (operation != Operation::nop) {
      const Address address = next_word<Jammed>();
      if constexpr (operation == Operation::shld) {
        store<Jammed>(address, low(registers_.hl));
        store<Jammed>(static_cast<Address>(address + 1), high(registers_.hl));
      } else if constexpr (operation == Operation::lhld) {
        const Byte low_byte = load<Jammed>(address);
        registers_.hl = joined(load<Jammed>(static_cast<Address>(address + 1)), low_byte);
      } else if constexpr (operation == Operation::sta) {
        store<Jammed>(address, registers_.a);
      } else {
        registers_.a = load<Jammed>(address);
      }
    }
  }

  // RLC to CMP: the accumulator with itself, a register, M or the byte that follows.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void calculate() {
    constexpr const Instruction& row = lookup(Opcode);
    if constexpr (row.operation == Operation::cma) {
      registers_.a = static_cast<Byte>(~registers_.a);
    } else if constexpr (row.operation == Operation::stc) {
      registers_.f |= flag::carry;
    } else if constexpr (row.operation == Operation::cmc) {
      registers_.f ^= flag::carry;
    } else {
      Byte operand = 0;
      if constexpr (row.operands[0] == Operand::data8) operand = next_byte<Jammed>();
      else if constexpr (row.operation >= Operation::add) operand = get<Opcode & 7, Jammed>();
      const Result result = operate<row.operation>(registers_.a, operand, registers_.f);
      registers_.f = result.flags;
      if constexpr (row.operation != Operation::cmp) registers_.a = result.value;
    }
  }

  // RET to RST. A conditional call reads its address whether it is taken or not.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void branch() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned field = Opcode >> 3 & 7;  // condition, or the number of a restart
    if constexpr (operation == Operation::ret) {
      registers_.pc = pop<Jammed>();
    } else if constexpr (operation == Operation::jmp) {
      registers_.pc = next_word<Jammed>();
    } else if constexpr (operation == Operation::rst) {
      push<Jammed>(registers_.pc);
      registers_.pc = static_cast<Address>(field * 8);
    } else if constexpr (operation == Operation::conditional_return) {
      if (holds(field, registers_.f)) registers_.pc = pop<Jammed>();
    } else {
      const Address target = next_word<Jammed>();
      if constexpr (operation != Operation::call) {
        if (!holds(field, registers_.f)) return;
      }
      if constexpr (operation != Operation::conditional_jump) push<Jammed>(registers_.pc);
      registers_.pc = target;
    }
  }

  // PUSH to DI.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void stack_and_control() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned pair_code = Opcode >> 4 & 3;
    if constexpr (operation == Operation::push) {
      if constexpr (pair_code == 3) push<Jammed>(joined(registers_.a, registers_.f));
      else push<Jammed>(pair<pair_code>());
    } else if constexpr (operation == Operation::pop) {
      const Address word = pop<Jammed>();
      if constexpr (pair_code == 3) {
        registers_.a = high(word);
        registers_.f = as_flags(low(word));
      } else {
        pair<pair_code>() = word;
      }
    } else if constexpr (operation == Operation::xthl) {
      exchange_with_stack<Jammed>();
    } else if constexpr (operation == Operation::sphl) {
      registers_.sp = registers_.hl;
    } else if constexpr (operation == Operation::pchl) {
      registers_.pc = registers_.hl;
    } else if constexpr (operation == Operation::xchg) {
      const Address hl = registers_.hl;
      registers_.hl = registers_.de;
      registers_.de = hl;
    } else if constexpr (operation == Operation::in) {
      const Byte port = next_byte<Jammed>();
      registers_.a = bus_.in(cycle<Jammed>(status::input_cycle), port);
    } else if constexpr (operation == Operation::out) {
      const Byte port = next_byte<Jammed>();
      bus_.out(cycle<Jammed>(status::output_cycle), port, registers_.a);
    } else {
      enable_interrupts(operation == Operation::ei);
    }
  }

  // INT is not looked at at the end of EI, so that EI; RET returns before the next interrupt.
  SIGHTLINE_INLINE constexpr void enable_interrupts(bool on) {
    control_->interrupts_on = control_->deferred = on;
    bus_.interrupt_enable(on);
    if (on) bus_.attention();
  }

  // The data pins show the pair's byte and then that of HL: low in the first cycle, high in the second (measured).
  SIGHTLINE_INLINE constexpr void add_to_hl(Address addend) {
    bus_.internal(low(addend), low(registers_.hl));
    bus_.internal(high(addend), high(registers_.hl));
    const unsigned sum = static_cast<unsigned>(addend) + registers_.hl;
    registers_.hl = static_cast<Address>(sum);
    registers_.f = with_carry(registers_.f, sum >> 16);
  }

  template <bool Jammed>
  SIGHTLINE_INLINE constexpr void exchange_with_stack() {
    const Address above = static_cast<Address>(registers_.sp + 1);
    const Byte low_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), registers_.sp);
    const Byte high_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), above);
    bus_.write(cycle<Jammed>(status::stack_write_cycle), above, high(registers_.hl));
    bus_.write(cycle<Jammed>(status::stack_write_cycle), registers_.sp, low(registers_.hl));
    bus_.extend(2);
    registers_.hl = joined(high_byte, low_byte);
  }

  template <bool Jammed>
  SIGHTLINE_INLINE constexpr void push(Address word) {
    bus_.write(cycle<Jammed>(status::stack_write_cycle), --registers_.sp, high(word));
    bus_.write(cycle<Jammed>(status::stack_write_cycle), --registers_.sp, low(word));
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Address pop() {
    const Byte low_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), registers_.sp++);
    return joined(bus_.read(cycle<Jammed>(status::stack_read_cycle), registers_.sp++), low_byte);
  }

  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Byte load(Address address) {
    return bus_.read(cycle<Jammed>(status::read_cycle), address);
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr void store(Address address, Byte byte) {
    bus_.write(cycle<Jammed>(status::write_cycle), address, byte);
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Byte next_byte() {
    const Byte byte = bus_.operand(cycle<Jammed>(status::read_cycle), registers_.pc);
    if constexpr (!Jammed) ++registers_.pc;
    return byte;
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Address next_word() {
    const Byte low_byte = next_byte<Jammed>();
    return joined(next_byte<Jammed>(), low_byte);
  }

  // While the instruction of an acknowledge runs, no cycle says MEMR, and INTA stays as long as INT does (measured).
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Status cycle(Status plain) {
    if constexpr (!Jammed) return plain;
    else return static_cast<Status>((plain & ~status::memory_read) |
                                    (bus_.acknowledging() ? status::acknowledge : 0));
  }

  template <unsigned Code>
  SIGHTLINE_INLINE constexpr Address& pair() {
    if constexpr (Code == 0) return registers_.bc;
    else if constexpr (Code == 1) return registers_.de;
    else if constexpr (Code == 2) return registers_.hl;
    else return registers_.sp;
  }

  // Register codes: B C D E H L M A.
  template <unsigned Code, bool Jammed>
  SIGHTLINE_INLINE constexpr Byte get() {
    if constexpr (Code == 7) return registers_.a;
    else if constexpr (Code == 6) return load<Jammed>(registers_.hl);
    else if constexpr (Code % 2 == 0) return high(pair<Code / 2>());
    else return low(pair<Code / 2>());
  }
  template <unsigned Code, bool Jammed>
  SIGHTLINE_INLINE constexpr void set(Byte byte) {
    if constexpr (Code == 7) registers_.a = byte;
    else if constexpr (Code == 6) store<Jammed>(registers_.hl, byte);
    else if constexpr (Code % 2 == 0) pair<Code / 2>() = joined(byte, low(pair<Code / 2>()));
    else pair<Code / 2>() = joined(high(pair<Code / 2>()), byte);
  }

  B bus_;
  Control* control_;
  Registers registers_;
};

}  // namespace sightline::reference_8080
