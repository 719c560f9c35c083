// The bus interface of the 8080. Each verb is one machine cycle and advances the time.
//
//   fetch(status, address)          M1, T1 to T4; returns the opcode
//   operand(status, address)        a byte of the instruction after its opcode: 3 T-states; returns the byte read in T3
//   read(status, address)           the same for any other byte
//   write(status, address, byte)    3 T-states; memory has the byte from T3 on
//   in(status, port)                3 T-states; the device is read in T3
//   out(status, port, byte)         3 T-states; the device gets the byte in T3
//   internal(first, then)           3 T-states without SYNC (DAD); the bytes that the data pins show in T1 and afterwards
//   extend(n)                       n T-states more of the cycle before: T5 of a fetch, T4 and T5 of XTHL's last write
//   halt(status, address)           T1, T2 and one TW of the halt acknowledge; the address is still that of the fetch
// The fetch that ends a halt carries HLTA as well, because the instruction register still holds HLT: the bus, which knows
// its last cycle, adds it. These take no time:
//   interrupt_enable(bool)          INTE changes, in T1 of the next cycle
//   acknowledging()                 INT has stayed high since the acknowledge cycle began
//   end_acknowledge()               RST, EI and DI end it regardless of INT
//   attention()                     the machine must serve the next instruction boundary (EI, HLT)
//   undefined(opcode, address)      an opcode that Intel left undefined was executed; a bus may lack this verb
//
// The bus handles READY and HOLD: one with these lines stretches its verbs and waits before it begins one (pin_bus.hpp
// does, T-state by T-state); one without them spends no time on them. The processor's caller samples INT at the end of each
// instruction, as the level in the last T-state.
#pragma once

#include <concepts>
#include <cstdint>

#include "state.hpp"

namespace sightline::i8080 {

// The status byte on D7-D0 while SYNC is high (MCS-80 User's Manual, chapter 2).
using Status = std::uint8_t;
namespace status {
inline constexpr Status acknowledge = 0x01;   // INTA
inline constexpr Status read = 0x02;          // WO#: not a write
inline constexpr Status stack = 0x04;
inline constexpr Status halt = 0x08;          // HLTA
inline constexpr Status output = 0x10;
inline constexpr Status first = 0x20;         // M1
inline constexpr Status input = 0x40;
inline constexpr Status memory_read = 0x80;

inline constexpr Status fetch_cycle = memory_read | first | read;           // A2
inline constexpr Status read_cycle = memory_read | read;                    // 82
inline constexpr Status write_cycle = 0x00;
inline constexpr Status stack_read_cycle = memory_read | stack | read;      // 86
inline constexpr Status stack_write_cycle = stack;                          // 04
inline constexpr Status input_cycle = input | read;                         // 42
inline constexpr Status output_cycle = output;                              // 10
inline constexpr Status acknowledge_cycle = first | read | acknowledge;     // 23
inline constexpr Status halt_cycle = memory_read | halt | read;             // 8A
}  // namespace status

template <class B>
concept Bus = requires(B bus, Status cycle, Address address, Byte byte, int t_states, bool on) {
  { bus.fetch(cycle, address) } -> std::same_as<Byte>;
  { bus.operand(cycle, address) } -> std::same_as<Byte>;
  { bus.read(cycle, address) } -> std::same_as<Byte>;
  bus.write(cycle, address, byte);
  { bus.in(cycle, byte) } -> std::same_as<Byte>;
  bus.out(cycle, byte, byte);
  bus.internal(byte, byte);
  bus.extend(t_states);
  bus.halt(cycle, address);
  bus.interrupt_enable(on);
  { bus.acknowledging() } -> std::same_as<bool>;
  bus.end_acknowledge();
  bus.attention();
};

}  // namespace sightline::i8080
