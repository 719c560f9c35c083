// The 8080 processor. Each opcode is compiled from its row of isa.hpp and does everything else through bus verbs, so that
// the time of an instruction is the consequence of its bus cycles (a test compares their sum with the table).
//
// Left out: ALU results appear when the instruction ends, not in T2 of the next fetch, which no program can observe. The
// chip is said to garble an XTHL or HLT supplied by an interrupting device while INT stays high; no available data shows
// it. Sources: Intel MCS-80 User's Manual, chapters 2 and 4; the gate-level model of the KR580VM80A where that is silent.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "../core/branch.hpp"
#include "../core/dispatch.hpp"
#include "../core/inline.hpp"
#include "alu.hpp"
#include "bus.hpp"
#include "isa.hpp"
#include "state.hpp"

namespace sightline::i8080 {

enum class Outcome : std::uint8_t { completed, halted };

// A running processor: a value that holds its bus, A, HL and PC, so that a compiler keeps them in host registers. The other
// registers are in a Registers object, where save() stores these too; Control, which few instructions use, is separate. `B`
// may be a reference to a bus.
template <class B>
  requires Bus<std::remove_reference_t<B>>
class Execution {
 public:
  static constexpr unsigned codes = 256;

  // The registers and `control` must outlive the execution.
  SIGHTLINE_INLINE constexpr Execution(B bus, Registers& registers, Control& control)
      : Execution(bus, registers, control, registers.a, registers.hl, registers.pc) {}
  SIGHTLINE_INLINE constexpr Execution(B bus, Registers& registers, Control& control, std::uint32_t a,
                                             std::uint32_t hl, std::uint32_t pc)
      : bus_(bus), control_(&control), registers_(&registers), a_(a), hl_(hl), pc_(pc) {
    // Tells the compiler that it need not truncate them.
    if (a > 0xFF || hl > 0xFFFF) __builtin_unreachable();
  }

  SIGHTLINE_INLINE constexpr void save() {
    registers_->a = static_cast<Byte>(a_);
    registers_->hl = static_cast<Address>(hl_);
    registers_->pc = static_cast<Address>(pc_);
    if constexpr (requires { bus_.save(); }) bus_.save();
  }

  [[nodiscard]] constexpr const auto& bus() const { return bus_; }
  [[nodiscard]] constexpr auto& bus() { return bus_; }
  [[nodiscard]] constexpr std::uint32_t a() const { return a_; }
  [[nodiscard]] constexpr std::uint32_t hl() const { return hl_; }
  // Only the low 16 bits count.
  [[nodiscard]] constexpr std::uint32_t pc() const { return pc_; }

  // Executes one instruction from memory.
  constexpr Outcome step() {
    const Byte opcode = bus_.fetch(status::fetch_cycle, static_cast<Address>(pc_));
    step_pc();
    return core::dispatch<codes>(opcode, Executor<false>{this});
  }

  // The same, compiled for one opcode, for an instruction that a bus with fetch_peeked() has shown.
  template <unsigned opcode>
  SIGHTLINE_INLINE constexpr Outcome step_as() {
    bus_.fetch_peeked(status::fetch_cycle, static_cast<Address>(pc_), static_cast<Byte>(opcode));
    step_pc();
    return execute<static_cast<Byte>(opcode), false>();
  }
  // Opcodes that access more than the processor and its memory, and those that Intel left undefined, which are counted.
  template <unsigned opcode>
  static constexpr bool is_rare = lookup(static_cast<Byte>(opcode)).operation == Operation::in ||
                                  lookup(static_cast<Byte>(opcode)).operation == Operation::out ||
                                  lookup(static_cast<Byte>(opcode)).operation == Operation::hlt ||
                                  lookup(static_cast<Byte>(opcode)).duplicate;
  static constexpr Byte opcode_of_in = 0xDB;
  static constexpr Byte opcode_of_out = 0xD3;
  constexpr Outcome step_rare(Byte opcode) {
    static_assert(is_rare<opcode_of_in> && is_rare<opcode_of_out> && is_rare<0x76>);
    if (opcode == opcode_of_in) return step_as<opcode_of_in>();
    if (opcode == opcode_of_out) return step_as<opcode_of_out>();
    if (opcode == 0x76) return step_as<0x76>();
    // A copy, because a compiler would keep in memory an object whose address a call gets.
    Execution copy = *this;
    const Outcome outcome = copy.step_undefined(opcode);
    *this = copy;
    return outcome;
  }

  // The interrupt: executes one instruction from the device that answers the acknowledge. PC does not change while it is
  // read, so a CALL or RST pushes the address of the instruction that would have come next.
  constexpr Outcome acknowledge() {
    control_->interrupts_on = control_->halted = false;
    bus_.interrupt_enable(false);
    const Byte opcode = bus_.fetch(status::acknowledge_cycle, static_cast<Address>(pc_));
    return core::dispatch<codes>(opcode, Executor<true>{this});
  }

  // The RESET pin. A, F, B to L and SP keep their values. The next fetch is at 0000.
  constexpr void reset() {
    pc_ = 0;
    *control_ = {};
    bus_.end_acknowledge();
    bus_.interrupt_enable(false);
  }

 private:
  // Jammed: the instruction came from an acknowledge cycle.
  template <bool Jammed>
  struct Executor {
    Execution* execution;
    template <unsigned opcode>
    SIGHTLINE_INLINE constexpr Outcome execute() const {
      return execution->template execute<static_cast<Byte>(opcode), Jammed>();
    }
  };

  [[gnu::noinline]] constexpr Outcome step_undefined(Byte opcode) {
    bus_.fetch_peeked(status::fetch_cycle, static_cast<Address>(pc_), opcode);
    step_pc();
    return core::dispatch<codes>(opcode, UndefinedExecutor{this});
  }
  struct UndefinedExecutor {
    Execution* execution;
    template <unsigned opcode>
    SIGHTLINE_INLINE constexpr Outcome execute() const {
      if constexpr (lookup(static_cast<Byte>(opcode)).duplicate) return execution->template execute<static_cast<Byte>(opcode), false>();
      else __builtin_unreachable();
    }
  };

  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr Outcome execute() {
    constexpr const Instruction& row = lookup(Opcode);
    if constexpr (row.duplicate && requires { bus_.undefined(Opcode, Address{}); })
      bus_.undefined(Opcode, static_cast<Address>(pc_ - (Jammed ? 0 : 1)));
    if constexpr (Jammed && (row.operation == Operation::rst || row.operation == Operation::ei ||
                             row.operation == Operation::di)) {
      bus_.end_acknowledge();
    }
    if constexpr (row.cycles[0].t_states == 5) bus_.extend(1);
    if constexpr (row.operation == Operation::hlt) {
      bus_.halt(cycle<Jammed>(status::halt_cycle), static_cast<Address>(pc_ - (Jammed ? 0 : 1)));
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

  // NOP to LDA in the order of Operation: transfers, and increments and decrements of registers, pairs and M.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void move() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned to = Opcode >> 3 & 7;
    constexpr unsigned pair_code = Opcode >> 4 & 3;
    if constexpr (operation == Operation::lxi) {
      set_pair<pair_code>(next_word<Jammed>());
    } else if constexpr (operation == Operation::stax) {
      store<Jammed>(pair<pair_code>(), static_cast<Byte>(a_));
    } else if constexpr (operation == Operation::ldax) {
      a_ = load<Jammed>(pair<pair_code>());
    } else if constexpr (operation == Operation::inx) {
      set_pair<pair_code>(static_cast<Address>(pair<pair_code>() + 1));
    } else if constexpr (operation == Operation::dcx) {
      set_pair<pair_code>(static_cast<Address>(pair<pair_code>() - 1));
    } else if constexpr (operation == Operation::inr) {
      const Result result = increment(get<to, Jammed>(), registers_->f);
      registers_->f = result.flags;
      set<to, Jammed>(result.value);
    } else if constexpr (operation == Operation::dcr) {
      const Result result = decrement(get<to, Jammed>(), registers_->f);
      registers_->f = result.flags;
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
        store<Jammed>(address, low(pair<2>()));
        store<Jammed>(static_cast<Address>(address + 1), high(pair<2>()));
      } else if constexpr (operation == Operation::lhld) {
        const Byte low_byte = load<Jammed>(address);
        hl_ = joined(load<Jammed>(static_cast<Address>(address + 1)), low_byte);
      } else if constexpr (operation == Operation::sta) {
        store<Jammed>(address, static_cast<Byte>(a_));
      } else {
        a_ = load<Jammed>(address);
      }
    }
  }

  // RLC to CMP: the accumulator alone, or with a register, M or the byte that follows.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void calculate() {
    constexpr const Instruction& row = lookup(Opcode);
    if constexpr (row.operation == Operation::cma) {
      a_ ^= 0xFFU;
    } else if constexpr (row.operation == Operation::stc) {
      registers_->f |= flag::carry;
    } else if constexpr (row.operation == Operation::cmc) {
      registers_->f ^= flag::carry;
    } else {
      Byte operand = 0;
      if constexpr (row.operands[0] == Operand::data8) operand = next_byte<Jammed>();
      else if constexpr (row.operation >= Operation::add) operand = get<Opcode & 7, Jammed>();
      const Result result = operate<row.operation>(static_cast<Byte>(a_), operand, registers_->f);
      registers_->f = result.flags;
      if constexpr (row.operation != Operation::cmp) a_ = result.value;
    }
  }

  // RET to RST. A conditional call reads its address whether it is taken or not.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void branch() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned field = Opcode >> 3 & 7;  // condition, or the number of a restart
    if constexpr (operation == Operation::ret) {
      pc_ = pop<Jammed>();
    } else if constexpr (operation == Operation::jmp) {
      pc_ = next_word<Jammed>();
    } else if constexpr (operation == Operation::rst) {
      push<Jammed>(static_cast<Address>(pc_));
      pc_ = field * 8;
    } else if constexpr (operation == Operation::conditional_return) {
      if (holds(field, registers_->f)) pc_ = pop<Jammed>();
    } else {
      const Address target = next_word<Jammed>();
      if constexpr (operation == Operation::conditional_jump) {
        core::set_by_branch(holds(field, registers_->f), pc_, std::uint32_t{target});
        return;
      }
      if constexpr (operation != Operation::call) {
        if (!holds(field, registers_->f)) return;
      }
      push<Jammed>(static_cast<Address>(pc_));
      pc_ = target;
    }
  }

  // PUSH to DI.
  template <Byte Opcode, bool Jammed>
  SIGHTLINE_INLINE constexpr void stack_and_control() {
    constexpr Operation operation = lookup(Opcode).operation;
    constexpr unsigned pair_code = Opcode >> 4 & 3;
    if constexpr (operation == Operation::push) {
      if constexpr (pair_code == 3) push<Jammed>(joined(static_cast<Byte>(a_), registers_->f));
      else push<Jammed>(pair<pair_code>());
    } else if constexpr (operation == Operation::pop) {
      const Address word = pop<Jammed>();
      if constexpr (pair_code == 3) {
        a_ = high(word);
        registers_->f = as_flags(low(word));
      } else {
        set_pair<pair_code>(word);
      }
    } else if constexpr (operation == Operation::xthl) {
      exchange_with_stack<Jammed>();
    } else if constexpr (operation == Operation::sphl) {
      registers_->sp = pair<2>();
    } else if constexpr (operation == Operation::pchl) {
      pc_ = hl_;
    } else if constexpr (operation == Operation::xchg) {
      const Address hl = pair<2>();
      hl_ = registers_->de;
      registers_->de = hl;
    } else if constexpr (operation == Operation::in) {
      const Byte port = next_byte<Jammed>();
      a_ = bus_.in(cycle<Jammed>(status::input_cycle), port);
    } else if constexpr (operation == Operation::out) {
      const Byte port = next_byte<Jammed>();
      bus_.out(cycle<Jammed>(status::output_cycle), port, static_cast<Byte>(a_));
    } else {
      enable_interrupts(operation == Operation::ei);
    }
  }

  // INT is not sampled at the end of EI, so that EI; RET returns before the next interrupt.
  SIGHTLINE_INLINE constexpr void enable_interrupts(bool on) {
    control_->interrupts_on = control_->deferred = on;
    bus_.interrupt_enable(on);
    if (on) bus_.attention();
  }

  // The data pins show the pair's byte and then that of HL: low in the first cycle, high in the second (measured).
  SIGHTLINE_INLINE constexpr void add_to_hl(Address addend) {
    bus_.internal(low(addend), low(pair<2>()));
    bus_.internal(high(addend), high(pair<2>()));
    const unsigned sum = addend + hl_;
    hl_ = sum & 0xFFFFU;
    registers_->f = with_carry(registers_->f, sum >> 16);
  }

  template <bool Jammed>
  SIGHTLINE_INLINE constexpr void exchange_with_stack() {
    const Address above = static_cast<Address>(registers_->sp + 1);
    const Byte low_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), registers_->sp);
    const Byte high_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), above);
    bus_.write(cycle<Jammed>(status::stack_write_cycle), above, high(pair<2>()));
    bus_.write(cycle<Jammed>(status::stack_write_cycle), registers_->sp, low(pair<2>()));
    bus_.extend(2);
    hl_ = joined(high_byte, low_byte);
  }

  template <bool Jammed>
  SIGHTLINE_INLINE constexpr void push(Address word) {
    // A local copy: for all the compiler knows, SP lies in the memory that is written.
    const Address top = registers_->sp;
    bus_.write(cycle<Jammed>(status::stack_write_cycle), static_cast<Address>(top - 1), high(word));
    bus_.write(cycle<Jammed>(status::stack_write_cycle), static_cast<Address>(top - 2), low(word));
    registers_->sp = static_cast<Address>(top - 2);
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Address pop() {
    const Address top = registers_->sp;
    const Byte low_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), top);
    const Byte high_byte = bus_.read(cycle<Jammed>(status::stack_read_cycle), static_cast<Address>(top + 1));
    registers_->sp = static_cast<Address>(top + 2);
    return joined(high_byte, low_byte);
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
    const Byte byte = bus_.operand(cycle<Jammed>(status::read_cycle), static_cast<Address>(pc_));
    if constexpr (!Jammed) step_pc();
    return byte;
  }
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Address next_word() {
    const Byte low_byte = next_byte<Jammed>();
    return joined(next_byte<Jammed>(), low_byte);
  }

  // During an instruction from an acknowledge cycle no cycle says MEMR, and INTA stays as long as INT does (measured).
  template <bool Jammed>
  SIGHTLINE_INLINE constexpr Status cycle(Status plain) {
    if constexpr (!Jammed) return plain;
    else return static_cast<Status>((plain & ~status::memory_read) |
                                    (bus_.acknowledging() ? status::acknowledge : 0));
  }

  SIGHTLINE_INLINE constexpr void step_pc() { ++pc_; }

  // Pair codes: BC DE HL SP.
  template <unsigned Code>
  [[nodiscard]] SIGHTLINE_INLINE constexpr Address pair() const {
    if constexpr (Code == 0) return registers_->bc;
    else if constexpr (Code == 1) return registers_->de;
    else if constexpr (Code == 2) return static_cast<Address>(hl_);
    else return registers_->sp;
  }
  template <unsigned Code>
  SIGHTLINE_INLINE constexpr void set_pair(Address word) {
    if constexpr (Code == 0) registers_->bc = word;
    else if constexpr (Code == 1) registers_->de = word;
    else if constexpr (Code == 2) hl_ = word;
    else registers_->sp = word;
  }

  // Register codes: B C D E H L M A.
  template <unsigned Code, bool Jammed>
  SIGHTLINE_INLINE constexpr Byte get() {
    if constexpr (Code == 7) return static_cast<Byte>(a_);
    else if constexpr (Code == 6) return load<Jammed>(pair<2>());
    else if constexpr (Code / 2 == 2) return Code % 2 == 0 ? high(pair<2>()) : low(pair<2>());
    else return half<Code>();
  }
  template <unsigned Code, bool Jammed>
  SIGHTLINE_INLINE constexpr void set(Byte byte) {
    if constexpr (Code == 7) a_ = byte;
    else if constexpr (Code == 6) store<Jammed>(pair<2>(), byte);
    else if constexpr (Code / 2 == 2) hl_ = Code % 2 == 0 ? joined(byte, low(pair<2>())) : joined(high(pair<2>()), byte);
    else half<Code>() = byte;
  }
  // B, C, D or E in its pair.
  template <unsigned Code>
  SIGHTLINE_INLINE Byte& half() {
    static_assert(std::endian::native == std::endian::little || std::endian::native == std::endian::big);
    constexpr bool first = (Code % 2 == 0) == (std::endian::native == std::endian::big);
    Address& pair = Code / 2 == 0 ? registers_->bc : registers_->de;
    return reinterpret_cast<Byte*>(&pair)[first ? 0 : 1];
  }

  B bus_;
  Control* control_;
  Registers* registers_;  // except A, HL and PC
  std::uint32_t a_;       // 8 bits
  std::uint32_t hl_;      // 16 bits
  std::uint32_t pc_;      // 16 bits; higher bits are undefined, so that no instruction waits for their removal
};

// A processor that owns its bus and executes one instruction per call.
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
  [[nodiscard]] constexpr const B& bus() const { return bus_; }
  [[nodiscard]] constexpr B& bus() { return bus_; }

  constexpr Outcome step() {
    Execution<B&> execution(bus_, registers_, *control_);
    const Outcome outcome = execution.step();
    execution.save();
    return outcome;
  }
  constexpr Outcome acknowledge() {
    Execution<B&> execution(bus_, registers_, *control_);
    const Outcome outcome = execution.acknowledge();
    execution.save();
    return outcome;
  }
  constexpr void reset() {
    Execution<B&> execution(bus_, registers_, *control_);
    execution.reset();
    execution.save();
  }

 private:
  B bus_;
  Control* control_;
  Registers registers_;
};

}  // namespace sightline::i8080
