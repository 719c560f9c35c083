// The observer, limits and stop reasons of the earlier machine.
#pragma once

#include <array>
#include <cstdint>

#include "emulators/core/inline.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/i8080/state.hpp"

namespace sightline::reference_8080 {

struct I8080InstructionRecord {
  core::TStateInstant time;  // T1 of its fetch
  core::TStateInstant end;
  i8080::Address pc;                  // its address; PC, if a device supplied the instruction
  std::array<i8080::Byte, 3> bytes;   // the bytes there; as many count as the instruction is long
  bool acknowledged;                  // a device supplied it
  const i8080::State& before;
  const i8080::State& after;
};

// DAD's internal cycles have no SYNC and are not reported.
struct I8080Cycle {
  core::TStateInstant time;  // its T1
  i8080::Status status;
  i8080::Address address;
  i8080::Byte data;  // nothing on the bus in the halt cycle: 0
  bool operand = false;  // a byte of the instruction behind its opcode

  friend constexpr bool operator==(const I8080Cycle&, const I8080Cycle&) = default;
};

struct NoI8080Observer {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = false;
};

enum class I8080StopReason : std::uint8_t {
  halt,               // HLT, and no interrupt can ever end it
  instruction_limit,  // I8080Limits::instructions done
  time_limit,         // the first boundary at or after I8080Limits::until
  observer,           // the observer asked for it
  ports,              // the ports asked for it
};

struct I8080Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::TStateInstant until = core::never_t;
};

template <class Observer>
concept Filtered = requires { typename Observer::Filter; };

// An observer that is asked or told after every instruction: a run executes one at a time.
template <class Observer>
inline constexpr bool follows_instructions = Observer::instructions || (Observer::stops && !Filtered<Observer>);

template <class Observer, bool wanted = Observer::cycles>
class Reporter {
 public:
  // The observer outlives the reporter.
  explicit constexpr Reporter(Observer& observer) : observer_(&observer) {}
  // True: stop() is to be asked at the next boundary.
  template <class Cycle>
  SIGHTLINE_INLINE constexpr bool operator()(const Cycle& cycle) const {
    observer_->cycle(cycle);
    return false;
  }

 private:
  Observer* observer_;
};

template <Filtered Observer>
class Reporter<Observer, true> {
 public:
  explicit constexpr Reporter(Observer& observer) : observer_(&observer), filter_(observer.filter()) {}
  template <class Cycle>
  SIGHTLINE_INLINE constexpr bool operator()(const Cycle& cycle) const {
    if (!filter_.wants(cycle)) [[likely]]
      return false;
    observer_->cycle(cycle);
    return true;
  }

 private:
  Observer* observer_;
  typename Observer::Filter filter_;
};

template <class Observer>
class Reporter<Observer, false> {
 public:
  explicit constexpr Reporter(Observer&) {}
  template <class Cycle>
  constexpr bool operator()(const Cycle&) const {
    return false;
  }
};

// Whether the observer is to be asked at a boundary that has nothing else to it.
template <class Observer>
class Arrivals {
 public:
  explicit constexpr Arrivals(const Observer&) {}
  template <class Address>
  constexpr bool operator()(Address) const {
    return Observer::stops;
  }
};

template <Filtered Observer>
class Arrivals<Observer> {
 public:
  explicit constexpr Arrivals(const Observer& observer) : filter_(observer.filter()) {}
  template <class Address>
  SIGHTLINE_INLINE constexpr bool operator()(Address next) const {
    return filter_.arrives(next);
  }

 private:
  typename Observer::Filter filter_;
};

}  // namespace sightline::reference_8080
