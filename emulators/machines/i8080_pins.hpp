// The 8080 machine T-state by T-state (../i8080/pin_bus.hpp), for what its fast bus has no verbs for: the time about a HOLD,
// and the instruction that an interrupting device supplies. So what is true of the pins there is true here.
//
// It knows no observer: the run is told through two functions, and this is compiled once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/tstates.hpp"
#include "../i8080/bus.hpp"
#include "../i8080/cpu.hpp"
#include "../i8080/pin_bus.hpp"
#include "../i8080/state.hpp"
#include "i8080_observer.hpp"
#include "i8080_run.hpp"

namespace sightline::machines {

// Where cycles and changes of HOLD go; null: nobody wants them.
struct I8080Tell {
  void* to = nullptr;
  void (*cycle)(void* to, const I8080Cycle&) = nullptr;
  void* to_holds = nullptr;
  void (*hold)(void* to, const I8080HoldPins&) = nullptr;
};

// What a device supplied since its interrupt was accepted.
struct SuppliedBytes {
  std::array<i8080::Byte, 3> bytes{};
  std::size_t count = 0;
};

// The machine's memory and ports as the board of such a bus.
template <class Ports>
class I8080Board {
 public:
  static constexpr bool answers_in_t3 = true;

  // `now` is the T-state that is to come; the ports are where the one before it left them.
  I8080Board(Ports& ports, i8080::Byte* memory, SuppliedBytes& supplied, core::TStateInstant now, bool acknowledged, I8080Tell tell)
      : ports_(&ports), memory_(memory), supplied_(&supplied), now_(now), changes_(now), tell_(tell), shown_{now, false, acknowledged, false} {
    if constexpr (HoldingPorts<Ports>) {
      if (now > core::at_t_state(0)) shown_.hold = is_held(now - core::TStates(1));
    }
  }

  [[nodiscard]] core::TStateInstant now() const { return now_; }
  [[nodiscard]] std::int64_t held() const { return held_; }
  // The bytes that are read next are behind an opcode, or not.
  void set_operand(bool operand) { operand_ = operand; }

  i8080::PinInputs inputs() {
    if (now_ >= changes_) {
      ports_->advance(now_);
      changes_ = ports_->deadline();
    }
    i8080::PinInputs levels;
    levels.interrupt = ports_->interrupt();
    levels.ready = waits_ == 0;
    if (waits_ != 0) --waits_;
    if constexpr (HoldingPorts<Ports>) levels.hold = is_held(now_);
    return levels;
  }

  i8080::Byte read(i8080::Status status, i8080::Address address) {
    const i8080::Byte byte = answer(status, address);
    report(byte);
    return byte;
  }
  void write(i8080::Status status, i8080::Address address, i8080::Byte byte) {
    report(byte);
    if ((status & i8080::status::output) == 0) {
      memory_[address] = byte;
      return;
    }
    ports_->out(i8080::low(address), byte, now_);
    changes_ = ports_->deadline();
  }

  void t_state(const i8080::PinState& row) {
    if (row.sync) begin(row.status, row.address);
    if constexpr (HoldingPorts<Ports>) {
      const bool stands = row.state == i8080::TState::held;
      if (stands) ++held_;
      if (tell_.hold != nullptr &&
          (row.inputs.hold != shown_.hold || row.hold_acknowledge != shown_.acknowledge || stands != shown_.stands)) {
        shown_ = {now_, row.inputs.hold, row.hold_acknowledge, stands};
        tell_.hold(tell_.to_holds, shown_);
      }
    }
    now_ += core::TStates(1);
  }

  // To the T-state in which HOLD goes away, or to `until`.
  void pass_held() { pass_held(core::never_t); }
  void pass_held(core::TStateInstant until) {
    if constexpr (HoldingPorts<Ports>) {
      const core::TStateInstant then = std::min(ports_->hold_ends(now_), until);
      if (then <= now_) return;
      held_ += (then - now_).count();
      now_ = then;
    }
  }

 private:
  [[nodiscard]] bool is_held(core::TStateInstant t) const { return ports_->next_hold(t) == t; }

  void begin(i8080::Status status, i8080::Address address) {
    cycle_ = {now_, status, address, 0, operand_};
    const bool halt = (status & i8080::status::halt) != 0 && (status & i8080::status::first) == 0;
    if (halt) return report(0);
    if constexpr (Ports::waits) waits_ = ports_->wait_states(kind_of(status), address, now_ + core::TStates(1));
  }
  static i8080::CycleKind kind_of(i8080::Status status) {
    namespace bits = i8080::status;
    if ((status & bits::first) != 0) return i8080::CycleKind::fetch;
    if ((status & bits::input) != 0) return i8080::CycleKind::input;
    if ((status & bits::output) != 0) return i8080::CycleKind::output;
    const bool stack = (status & bits::stack) != 0;
    if ((status & bits::read) != 0) return stack ? i8080::CycleKind::stack_read : i8080::CycleKind::read;
    return stack ? i8080::CycleKind::stack_write : i8080::CycleKind::write;
  }

  // Without MEMR the byte comes from the device whose interrupt is being acknowledged.
  i8080::Byte answer(i8080::Status status, i8080::Address address) {
    if ((status & i8080::status::memory_read) != 0) return memory_[address];
    i8080::Byte byte = 0;
    if ((status & i8080::status::input) != 0) {
      byte = ports_->in(i8080::low(address), now_);
    } else {
      byte = ports_->acknowledge(now_);
      if (supplied_->count < supplied_->bytes.size()) supplied_->bytes[supplied_->count++] = byte;
    }
    changes_ = ports_->deadline();
    return byte;
  }
  void report(i8080::Byte data) {
    if (tell_.cycle == nullptr) return;
    cycle_.data = data;
    tell_.cycle(tell_.to, cycle_);
  }

  Ports* ports_;
  i8080::Byte* memory_;
  SuppliedBytes* supplied_;
  core::TStateInstant now_;
  core::TStateInstant changes_;  // until then the ports are as they are
  I8080Tell tell_;
  I8080HoldPins shown_;
  I8080Cycle cycle_{};  // under way
  bool operand_ = false;
  int waits_ = 0;  // T-states with READY low that are to come
  std::int64_t held_ = 0;  // T-states in which the processor stood still
};

// The bus on it, which tells it what is behind an opcode.
template <class Ports>
class I8080PinBus : public i8080::PinBus<I8080Board<Ports>> {
 public:
  using Base = i8080::PinBus<I8080Board<Ports>>;
  I8080PinBus(I8080Board<Ports>& board, bool interrupts_on, const i8080::PinLatches& latches)
      : Base(board, interrupts_on, latches), board_(&board) {}

  i8080::Byte operand(i8080::Status cycle, i8080::Address address) {
    board_->set_operand(true);
    const i8080::Byte byte = Base::operand(cycle, address);
    board_->set_operand(false);
    return byte;
  }

 private:
  I8080Board<Ports>* board_;
};

// What a step of the machine on its pins came to.
struct I8080PinStep {
  core::TStateInstant now{};    // the T-state that is to come
  core::TStateInstant begun{};  // T1 of the instruction
  bool executed = false;        // false: it ended in a HOLD or in a halt
  bool acknowledged = false;    // a device supplied the instruction
};

}  // namespace sightline::machines
