// The processor's side of the PDP-7's bus while a program runs: core memory, time, and the way to the
// devices.
//
// It lives in the locals of one run and touches the machine only on the slow paths, by value, so that a
// compiler can keep time and the deadline in registers; every verb is inlined into the run for the same
// reason.
#pragma once

#include <cstdint>

#include "emulators/core/inline.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/bus.hpp"
#include "emulators/pdp7/timing.hpp"
#include "tests/emulators/reference/reporter.hpp"

namespace sightline::reference {

template <class Machine, class Observer>
class Pdp7Bus {
 public:
  // The first boundary of a run is always looked at.
  Pdp7Bus(Machine& machine, Observer& observer)
      : machine_(&machine),
        report_(observer),
        core_(machine.core_.data()),
        words_(machine.core_.size()),
        now_(machine.now_) {}
  Pdp7Bus(const Pdp7Bus&) = default;
  // From a bus of the same machine: takes over the time only, so that a compiler sees that the rest never
  // changes in a run and does not fetch it again for every instruction.
  SIGHTLINE_INLINE Pdp7Bus& operator=(const Pdp7Bus& other) {
    now_ = other.now_;
    deadline_ = other.deadline_;
    return *this;
  }

  SIGHTLINE_INLINE core::Word18 fetch(pdp7::Address address) {
    const core::Word18 word = core_[address];
    pass(pdp7::Verb::fetch, address, word);
    return word;
  }
  SIGHTLINE_INLINE core::Word18 read(pdp7::Address address) {
    const core::Word18 word = core_[address];
    pass(pdp7::Verb::read, address, word);
    return word;
  }
  SIGHTLINE_INLINE void write(pdp7::Address address, core::Word18 word) {
    if (address < words_) core_[address] = word;
    pass(pdp7::Verb::write, address, word);
  }
  SIGHTLINE_INLINE core::Word18 modify(pdp7::Address address) {
    const core::Word18 word = core_[address] + core::Word18(1);
    if (address < words_) core_[address] = word;
    pass(pdp7::Verb::modify, address, word);
    return word;
  }
  void interrupt(core::Word18 word) {
    core_[0] = word;
    pass(pdp7::Verb::interrupt, 0, word);
  }
  SIGHTLINE_INLINE pdp7::IotReply iot(std::uint32_t word, core::Word18 ac) {
    const auto effect = machine_->input_output(now_, word, ac);
    report({now_, effect.stretch, pdp7::Verb::iot, word & 07777U, effect.reply.ac});
    now_ += effect.stretch;
    machine_->asynchronous_ += effect.stretch;
    if (effect.look) attention();
    return effect.reply;
  }
  SIGHTLINE_INLINE void idle(core::Duration duration) {
    report({now_, duration, pdp7::Verb::idle, 0, core::Word18(0)});
    now_ += duration;
    machine_->asynchronous_ += duration;
  }
  SIGHTLINE_INLINE core::Word18 switches() { return machine_->switches(now_); }
  SIGHTLINE_INLINE void unanswered(std::uint32_t word, pdp7::Address at) {
    machine_->count_unanswered(word, at);
  }
  void attention() { deadline_ = core::Instant::min(); }

  [[nodiscard]] bool due() const { return now_ >= deadline_; }
  [[nodiscard]] core::Instant now() const { return now_; }
  void set_now(core::Instant now) { now_ = now; }
  void set_deadline(core::Instant deadline) { deadline_ = deadline; }
  [[nodiscard]] Reporter<Observer> reporter() const { return report_; }

 private:
  SIGHTLINE_INLINE void pass(pdp7::Verb verb, pdp7::Address address, core::Word18 word) {
    report({now_, pdp7::machine_cycle, verb, address, word});
    now_ += pdp7::machine_cycle;
  }
  SIGHTLINE_INLINE void report(const pdp7::Cycle& cycle) {
    if (report_(cycle)) attention();
  }

  Machine* machine_;
  [[no_unique_address]] Reporter<Observer> report_;
  core::Word18* core_;
  std::uint32_t words_;
  core::Instant now_;
  core::Instant deadline_ = core::Instant::min();
};

}  // namespace sightline::reference
