// The 8080's bus T-state by T-state: READY, HOLD and INT are sampled when the chip samples them, and every pin has its
// level at the end of each T-state.
//
// For boards whose memory makes the processor wait or that take the bus from it, and for the reference data. A board is a
// type with
//   PinInputs inputs()                          the levels during the next T-state
//   Byte read(Status, Address)                  called once per cycle, in T2; also for ports and the acknowledge
//   void write(Status, Address, Byte)           in T3
//   void t_state(const PinState&)               the levels of the pins in the last T-state
// It may have
//   static constexpr bool answers_in_t3         true: read() is called in T3, when the byte is latched; before, the pins
// show 0
//   void pass_held()                            HOLD is granted: the board may skip T-states in which it stays granted
//
// Left out: what the address pins show in T4 and T5 (undefined on the real part; here they keep the cycle's address).
// Sources: MCS-80 User's Manual, chapter 2; the instants at which flip-flops are set are those of the gate-level model
// of the KR580VM80A.
#pragma once

#include <cstdint>

#include "bus.hpp"
#include "cpu.hpp"
#include "state.hpp"

namespace sightline::i8080 {

enum class TState : std::uint8_t { t1, t2, wait, t3, t4, t5, held };
enum class DataPins : std::uint8_t { out, in, floating };

struct PinInputs {
  bool interrupt = false;
  bool ready = true;
  bool hold = false;
};

struct PinState {
  PinInputs inputs;
  TState state;
  Address address;
  DataPins direction;
  Byte data;  // 0 while floating
  bool sync;
  bool data_in;       // DBIN
  bool write_strobe;  // WR# low
  bool waiting;       // WAIT
  bool hold_acknowledge;
  bool interrupts_on;  // INTE
  Status status;       // of the last cycle with a status
};

// What a bus keeps from one instruction to the next.
struct PinLatches {
  bool interrupt = false;         // INT in the last T-state
  bool acknowledged = false;      // the INTA latch
  bool hold = false;              // the HOLD flip-flop
  bool hold_acknowledge = false;  // HLDA
  bool after_write = false;       // the last T-state was T3 of a write or of an internal cycle
  bool passed_over = false;       // HOLD was granted after the last instruction: INT is not sampled before the next
  bool halted = false;            // no other cycle has begun since the halt cycle
  bool waking = false;            // one more TW ends the halt
  bool woken = false;             // the halt has ended

  friend constexpr bool operator==(const PinLatches&, const PinLatches&) = default;
};

template <class Board>
class PinBus {
 public:
  PinBus(Board& board, bool interrupts_on, const PinLatches& latches = {})
      : board_(&board), latches_(latches), interrupts_on_(interrupts_on), next_interrupts_on_(interrupts_on) {}

  [[nodiscard]] const PinLatches& latches() const { return latches_; }

  Byte fetch(Status cycle, Address address) {
    if ((cycle & status::acknowledge) != 0) latches_.acknowledged = true;
    const Byte opcode = read(cycle, address);
    tick(TState::t4);
    return opcode;
  }

  Byte operand(Status cycle, Address address) { return read(cycle, address); }
  Byte read(Status cycle, Address address) {
    begin(cycle, address);
    Byte byte = 0;
    if constexpr (!answers_in_t3) byte = board_->read(status_, address);
    pins_ = {DataPins::in, byte, false, true, false};
    tick(TState::t2);
    while (!ready_) tick(TState::wait);
    if constexpr (answers_in_t3) byte = board_->read(status_, address);
    pins_ = {};
    tick(TState::t3);
    return byte;
  }

  void write(Status cycle, Address address, Byte byte) {
    begin(cycle, address);
    pins_ = {DataPins::out, byte, false, false, false};
    tick(TState::t2);
    pins_.write_strobe = true;
    while (!ready_) tick(TState::wait);
    board_->write(status_, address, byte);
    tick(TState::t3);
    pins_ = {};
  }

  // The port number is on both halves of the address.
  Byte in(Status cycle, Byte port) { return read(cycle, joined(port, port)); }
  void out(Status cycle, Byte port, Byte byte) { write(cycle, joined(port, port), byte); }

  // READY is not sampled, the status and the address stay; HOLD is sampled as in a write.
  void internal(Byte first, Byte then) {
    wait_while_held();
    reading_ = false;
    pins_ = {DataPins::out, first, false, false, false};
    tick(TState::t1);
    pins_.data = then;
    tick(TState::t2);
    tick(TState::t3);
    pins_ = {};
  }

  void extend(int t_states) {
    tick(t_states == 1 ? TState::t5 : TState::t4);
    if (t_states == 2) tick(TState::t5);
  }

  void halt(Status cycle, Address address) {
    begin(cycle, address);
    latches_.halted = true;
    pins_ = {};
    tick(TState::t2);
    wait_in_halt();
  }

  // One more TW. True: it was the last, and the next T-state is T1 of a fetch or an acknowledge. An INT that the chip has
  // sampled ends the halt three T-states later even if it is low by then.
  bool wait_in_halt() {
    const bool last = latches_.waking;
    tick(TState::wait);
    latches_.waking = latches_.acknowledged;
    if (!last) return false;
    latches_.waking = false;
    latches_.woken = true;
    return true;
  }

  // One more T-state of a HOLD that was granted between two instructions. False: HOLD is not granted.
  bool wait_in_hold() {
    if (!is_held()) return false;
    latches_.passed_over = true;
    tick(TState::held);
    return true;
  }

  // RESET ends a halt.
  void reset() { latches_.halted = latches_.waking = latches_.woken = false; }

  void interrupt_enable(bool on) { next_interrupts_on_ = on; }
  void attention() {}
  void end_acknowledge() { latches_.acknowledged = false; }
  bool acknowledging() {
    wait_while_held();
    return latches_.acknowledged && latches_.interrupt;
  }

  // INT in the last T-state of the instruction. If HOLD is granted between two instructions, INT is not sampled there but
  // after the second.
  bool interrupt() {
    const bool held = latches_.hold || latches_.passed_over;
    latches_.passed_over = false;
    wait_while_held();
    return latches_.interrupt && !held;
  }

 private:
  struct Pins {
    DataPins direction = DataPins::floating;
    Byte data = 0;
    bool sync = false;
    bool data_in = false;
    bool write_strobe = false;
  };

  void begin(Status cycle, Address address) {
    wait_while_held();
    status_ = static_cast<Status>(cycle | (latches_.halted ? status::halt : 0));
    latches_.halted = latches_.woken = false;
    reading_ = (cycle & status::read) != 0;
    address_ = address;
    interrupts_on_ = next_interrupts_on_;
    pins_ = {DataPins::out, status_, true, false, false};
    tick(TState::t1);
  }

  // A cycle does not begin while HOLD is granted, except the one that ends a halt.
  [[nodiscard]] bool is_held() const { return latches_.hold && !latches_.woken; }
  void wait_while_held() {
    while (is_held()) {
      tick(TState::held);
      if constexpr (requires { board_->pass_held(); }) {
        if (latches_.hold) board_->pass_held();
      }
    }
  }

  // One T-state: phi1, what the pins show, phi2.
  void tick(TState state) {
    latches_.hold_acknowledge =
        latches_.hold && (latches_.hold_acknowledge || latches_.after_write || latches_.halted || (state == TState::t3 && reading_));
    if (latches_.halted && state == TState::wait && interrupts_on_ && !latches_.hold) latches_.acknowledged = true;
    if (!latches_.interrupt) latches_.acknowledged = false;
    const PinInputs inputs = board_->inputs();
    board_->t_state({inputs, state, address_, pins_.direction, pins_.data, pins_.sync, pins_.data_in,
                     pins_.write_strobe, state == TState::wait, latches_.hold_acknowledge, interrupts_on_, status_});
    latches_.after_write = state == TState::t3 && !reading_;
    if (!inputs.hold) latches_.hold = false;
    else if (!latches_.acknowledged && (state == TState::t2 || state == TState::wait)) latches_.hold = true;
    latches_.interrupt = inputs.interrupt;
    ready_ = inputs.ready;
  }

  static constexpr bool answers_in_t3 = [] {
    if constexpr (requires { Board::answers_in_t3; }) return Board::answers_in_t3;
    return false;
  }();

  Board* board_;
  PinLatches latches_;
  Pins pins_;
  Address address_ = 0;
  Status status_ = 0;
  bool reading_ = true;
  bool interrupts_on_;
  bool next_interrupts_on_;
  bool ready_ = true;  // READY as it was in the last T-state
};

// An 8080 on such a bus.
template <class Board>
class PinMachine {
 public:
  PinMachine(Board& board, const State& state)
      : control_(state), cpu_(PinBus<Board>(board, state.interrupts_on), state, control_) {}
  PinMachine(const PinMachine&) = delete;
  PinMachine& operator=(const PinMachine&) = delete;

  [[nodiscard]] State registers() const { return cpu_.state(); }
  void reset() {
    cpu_.reset();
    cpu_.bus().reset();
  }

  // One instruction from memory or from the interrupting device; in a halt, one TW.
  void step() {
    if (control_.halted) {
      if (!cpu_.bus().wait_in_halt()) return;
      control_.halted = false;
    }
    const bool interrupt = cpu_.bus().interrupt();
    const bool open = control_.interrupts_on && !control_.deferred;
    control_.deferred = false;
    if ((interrupt && open) || cpu_.bus().acknowledging()) cpu_.acknowledge();
    else cpu_.step();
  }

 private:
  Control control_;
  Cpu<PinBus<Board>> cpu_;
};

}  // namespace sightline::i8080
