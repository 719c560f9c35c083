// The bus interface of the PDP-7 processor. Each verb is one machine cycle and advances the time.
//
//   fetch(address)    the cycle that fetches an instruction to execute
//   read(address)     any other core cycle that leaves the word unchanged (Defer, Execute, the target of an XCT)
//   write(address, w) a core cycle that replaces it
//   modify(address)   a core cycle that reads, adds one (18 bits, wraps) and rewrites; returns the new word
//   interrupt(w)      the Break cycle of the program interrupt, which writes w at 0
//   iot(word, ac)     the end of an IOT's Fetch cycle: the pulses reach the devices; adds only the stretch of a slow cycle
//   idle(duration)    asynchronous time of the EAE
// The others take no time: switches() reads the AC switches, unanswered() reports an instruction that nothing in this
// machine obeyed, attention() asks the machine to serve the next instruction boundary (an interrupt may be due).
#pragma once

#include <concepts>
#include <cstdint>

#include "../core/iot_device.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "state.hpp"

namespace sightline::pdp7 {

// break_* are the cycles stolen from the processor: a data break in either direction, or a clock tick.
enum class Verb : std::uint8_t { fetch, read, write, modify, interrupt, iot, idle, break_read, break_write, break_modify };

// One bus event as reported to an observer.
struct Cycle {
  core::Instant time;  // its beginning
  core::Duration length;
  Verb verb;
  Address address;    // iot: bits 6-17 of the instruction; idle, interrupt: 0
  core::Word18 data;  // fetch, read, write, interrupt: the word; modify: the word rewritten; iot: AC afterwards; idle: 0

  friend constexpr bool operator==(const Cycle&, const Cycle&) = default;
};

using core::IotReply;

// IORS: the processor and all devices put their flags on the bus.
[[nodiscard]] constexpr bool reads_status(std::uint32_t word) {
  return (word & 07704U) == 00304U;
}

template <class B>
concept Bus = requires(B bus, Address address, core::Word18 word, core::Duration time,
                       std::uint32_t instruction) {
  { bus.fetch(address) } -> std::same_as<core::Word18>;
  { bus.read(address) } -> std::same_as<core::Word18>;
  bus.write(address, word);
  { bus.modify(address) } -> std::same_as<core::Word18>;
  { bus.iot(instruction, word) } -> std::same_as<IotReply>;
  bus.interrupt(word);
  bus.idle(time);
  { bus.switches() } -> std::same_as<core::Word18>;
  bus.unanswered(instruction, address);
  bus.attention();
};

}  // namespace sightline::pdp7
