// See i8080.hpp. The processor's engines are listed in i8080_parts.hpp.
#include "i8080.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "../core/device_errors.hpp"
#include "i8080_devices.hpp"
#include "i8080_parts.hpp"

namespace sightline::i8080 {

namespace {

enum class Engine : std::uint8_t { fast, plain };

// One run: what happens at the boundaries between two instructions.
class Run {
 public:
  Run(MachineParts& machine, const Limits& limits, Watch& watch, Engine engine)
      : machine_(machine), limits_(limits), watch_(watch), engine_(engine), begun_(machine.instructions) {
    // Only the plain engine supports memory that makes the processor wait, or that ends below FFFF.
    if (machine.ports.has_wait_states() || machine.ends_early()) engine_ = Engine::plain;
  }

  StopReason run() {
    machine_.state.f = as_flags(machine_.state.f);
    machine_.ports.poll_all();
    machine_.serve_next_boundary();
    while (!reason_) advance();
    // A halted processor samples INT from halt_sampled on: devices must not be ahead of it.
    const bool waits = machine_.state.halted && machine_.state.interrupts_on;
    const core::TStateInstant end = waits ? std::min(machine_.now, machine_.halt_sampled) : machine_.now;
    if (end > core::at_t_state(0)) machine_.ports.advance_all(end - MachineParts::one);
    machine_.strokes.flush();
    return *reason_;
  }

 private:
  enum class Next : std::uint8_t { execute, by_pins, other_boundary, stop };

  void advance() {
    const State& state = machine_.state;
    if (!state.halted && !in_hold_ && watch_.wants_boundary(state.pc) && watch_.stop(machine_.now, state.pc)) {
      reason_ = StopReason::observer;
      return;
    }
    const Next next = machine_.now > machine_.deadline ? serve_boundary() : Next::execute;
    if (next == Next::by_pins) {
      in_hold_ = !state.halted;
      if (step_by_pins(machine_, watch_, limits_.until)) in_hold_ = false;
    } else if (next == Next::execute && engine_ == Engine::fast) {
      run_fast(machine_, most_);
    } else if (next == Next::execute) {
      run_plainly(machine_, watch_);
    }
  }

  // A boundary at which something may be due.
  Next serve_boundary() {
    if (const auto reason = machine_.ports.take_stop()) return stop(*reason);
    const std::uint64_t count = machine_.instructions - begun_;
    if (count >= limits_.instructions) return stop(StopReason::instruction_limit);
    if (machine_.now >= limits_.until) return stop(StopReason::time_limit);
    State& state = machine_.state;
    if (state.halted) return wait_in_halt();
    bring_devices_to(machine_.now);
    if (machine_.pins_under_way() || machine_.hold_is_near(machine_.now)) return Next::by_pins;
    // INT is not sampled after EI, nor before the first instruction, where no T-state has sampled it.
    const bool samples = !state.deferred && machine_.now > core::at_t_state(0);
    if (samples && state.interrupts_on && machine_.ports.interrupt()) return Next::by_pins;
    most_ = static_cast<std::int64_t>(std::min<std::uint64_t>(limits_.instructions - count, core::Allowance<core::TState>::most));
    if (samples && !machine_.ports.stops()) machine_.deadline = next_deadline();
    else machine_.serve_next_boundary();
    state.deferred = false;
    machine_.ports.note_change();
    return Next::execute;
  }

  Next stop(StopReason reason) {
    reason_ = reason;
    return Next::stop;
  }

  // The last instant that must be over before the next boundary is served. An instruction lasts at least 4 T-states, so
  // most_ of them cannot end earlier than 4 * most_ from now: that bounds their number without comparing a count.
  [[nodiscard]] core::TStateInstant next_deadline() const {
    const core::TStateInstant now = machine_.now;
    core::TStateInstant deadline = std::min(machine_.ports.deadline(), now + core::TStates(4) * most_ - MachineParts::one);
    if (machine_.ports.has_holders())
      deadline = std::min(deadline, machine_.ports.next_hold(now) - MachineParts::longest_instruction);
    return limits_.until != core::never_t ? std::min(deadline, limits_.until - MachineParts::one) : deadline;
  }

  // HLT waits from T2 of its halt cycle on. The T-state t that samples INT high is followed by two more; T1 of the next
  // instruction is t + 3, an ordinary boundary: the level of INT there decides what is fetched. HOLD is sampled from t + 1
  // on, and is low before t + 2.
  Next wait_in_halt() {
    State& state = machine_.state;
    core::TStateInstant& now = machine_.now;
    core::TStateInstant t = machine_.halt_sampled;
    if (machine_.pins_under_way() || (t + MachineParts::one == now && machine_.hold_is_near(now)))
      return machine_.halt_may_end(machine_.pins) ? Next::by_pins : stop(StopReason::halt);
    const core::TStateInstant hold = machine_.ports.next_hold(now);
    while (state.interrupts_on) {
      machine_.ports.advance(t);
      if (hold != core::never_t && t + core::TStates(2) >= hold) {
        machine_.pins.acknowledged = machine_.pins.waking = machine_.ports.interrupt();
        bring_devices_to(hold);
        now = hold;
        return Next::by_pins;
      }
      if (machine_.ports.interrupt()) {
        state.halted = false;
        now = machine_.halt_ended = std::max(now, t + core::TStates(3));
        machine_.serve_next_boundary();
        return Next::other_boundary;
      }
      machine_.halt_sampled = t + MachineParts::one;
      if (machine_.ports.stops()) {
        now = std::max(now, machine_.halt_sampled);
        return stop(*machine_.ports.take_stop());
      }
      const core::TStateInstant next = machine_.ports.deadline();
      if (next == core::never_t) break;
      t = std::max(hold != core::never_t ? std::min(next, hold - core::TStates(2)) : next, machine_.halt_sampled);
      if (t >= limits_.until) {
        machine_.halt_sampled = limits_.until;
        now = std::max(now, limits_.until);
        return stop(StopReason::time_limit);
      }
    }
    return stop(StopReason::halt);
  }

  // Performs everything before `now`.
  void bring_devices_to(core::TStateInstant now) {
    if (now > core::at_t_state(0)) machine_.ports.advance(now - MachineParts::one);
  }

  MachineParts& machine_;
  Limits limits_;
  Watch& watch_;
  Engine engine_;
  std::uint64_t begun_;
  std::int64_t most_ = 1;  // number of instructions that the deadline allows
  bool in_hold_ = false;   // the run has to end in a HOLD, not at a boundary
  std::optional<StopReason> reason_;
};

}  // namespace

void MachineParts::count_undefined(Byte opcode, Address address) {
  auto known = std::find_if(undefined.all.begin(), undefined.all.end(), [opcode](const UndefinedOpcode& each) { return each.opcode == opcode; });
  if (known == undefined.all.end()) known = undefined.all.insert(known, {opcode, address, 0});
  ++known->count;
  undefined.last_opcode = opcode;
  undefined.last_address = address;
  if (options.strict) ports.request_stop(StopReason::undefined);
}

Machine::Machine(const Options& options) : parts_(std::make_unique<MachineParts>(options)) {}
Machine::~Machine() = default;

std::string Machine::attach(std::string_view name, std::span<const core::Setting> settings) {
  std::vector<std::string_view> names;
  for (const KnownDevice& known : known_devices) {
    names.push_back(known.info->name);
    if (known.info->name != name) continue;
    std::string error = core::wrong_setting(name, known.info->options, settings);
    if (error.empty()) error = attach(*known.info, known.make({parts_->options.clock, parts_->strokes, settings}));
    return error;
  }
  return core::unknown_name("device", name, names);
}
std::string Machine::attach(const core::PortDeviceInfo& info, std::unique_ptr<core::PortDevice> device) {
  return parts_->ports.attach(info, std::move(device));
}
std::string Machine::wire(std::string_view line, std::uint8_t restart) { return parts_->ports.wire(line, restart); }
core::PortDevice* Machine::device(std::string_view name) const { return parts_->ports.device(name); }
std::span<const AttachedDevice> Machine::devices() const { return parts_->ports.devices(); }
bool Machine::is_connected(const core::PortDevice& device) const { return parts_->ports.is_connected(device); }
core::TStateInstant Machine::deadline() const {
  core::TStateInstant next = core::never_t;
  for (const AttachedDevice& each : devices()) next = std::min(next, each.device->deadline());
  return next;
}
core::StrokeBuffer& Machine::strokes() { return parts_->strokes; }

void Machine::put_before(core::PortRange ports, core::PortDevice& front) { parts_->ports.put_before(ports, front); }
std::uint8_t Machine::forward_in(std::uint8_t port, core::TStateInstant at) { return parts_->ports.forward_in(port, at); }
void Machine::forward_out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) { parts_->ports.forward_out(port, value, at); }
std::span<const UnansweredPort, 256> Machine::unanswered() const { return parts_->ports.unanswered(); }
const UndefinedOpcodes& Machine::undefined() const { return parts_->undefined; }

State& Machine::registers() { return parts_->state; }
const State& Machine::registers() const { return parts_->state; }
Byte Machine::peek(Address address) const { return parts_->memory[address]; }
void Machine::deposit(Address address, Byte byte) { parts_->store(address, byte); }
void Machine::load(Address address, std::span<const Byte> bytes) {
  for (const Byte byte : bytes) parts_->store(address++, byte);
}
std::span<Byte> Machine::memory() { return parts_->memory; }
std::span<const Byte> Machine::memory() const { return parts_->memory; }
void Machine::start(Address address) {
  State& state = parts_->state;
  state.pc = address;
  if (!std::exchange(state.halted, false)) return;
  parts_->now = std::max(parts_->now, parts_->halt_sampled);  // up to there the devices have advanced
  parts_->pins = {};
  parts_->halt_ended = core::never_t;
}
void Machine::reset() {
  start(0);
  static_cast<Control&>(parts_->state) = {};
  parts_->pins = {};
  parts_->halt_ended = core::never_t;
}

StopReason Machine::run(const Limits& limits) {
  Watch nobody;
  return Run(*parts_, limits, nobody, Engine::fast).run();
}
StopReason Machine::run(const Limits& limits, Observer& observer) {
  Watch watch(observer);
  return Run(*parts_, limits, watch, Engine::plain).run();
}
StopReason Machine::run_plainly(const Limits& limits) {
  Watch nobody;
  return Run(*parts_, limits, nobody, Engine::plain).run();
}
void Machine::request_stop() { parts_->ports.request_stop(StopReason::device); }

const Options& Machine::options() const { return parts_->options; }
core::TStateInstant Machine::now() const { return parts_->now; }
std::uint64_t Machine::instructions() const { return parts_->instructions; }
std::uint64_t Machine::held() const { return parts_->held; }
bool Machine::interrupt() const { return parts_->ports.interrupt(); }

void Machine::visit_state(core::StateVisitor& visit) {
  MachineParts& machine = *parts_;
  visit.section("processor", machine.state);
  visit.section("time", [&machine](core::StateVisitor& fields) {
    fields("now", machine.now);
    fields("instructions", machine.instructions);
    fields("halt_sampled", machine.halt_sampled);
    bool after_halt = machine.halt_ended == machine.now;
    fields("after_halt", after_halt);
    machine.halt_ended = after_halt ? machine.now : core::never_t;
  });
  // The state of T-states in progress when the run stopped: an interrupt's instruction, or a HOLD.
  visit.section("pins", [&machine](core::StateVisitor& fields) {
    fields("acknowledging", machine.pins.acknowledged);
    fields("hold", machine.pins.hold);
    fields("hold_acknowledge", machine.pins.hold_acknowledge);
    fields("after_write", machine.pins.after_write);
    fields("passed_over", machine.pins.passed_over);
    fields("waking", machine.pins.waking);
    fields("held", machine.held);
    fields.require(!machine.pins.waking || machine.state.halted, "waking", "only in a halt");
  });
  visit.section("memory", [&machine](core::StateVisitor& fields) { fields.bytes("bytes", machine.memory); });
  if (visit.restores()) machine.clear_above_memory();
  visit.section("undefined", [&machine](core::StateVisitor& fields) {
    fields.list("opcodes", machine.undefined.all, [&fields](UndefinedOpcode& each) {
      fields("opcode", each.opcode);
      fields("first", each.first);
      fields("count", each.count);
      fields.require(lookup(each.opcode).duplicate, "opcode", "one that Intel left undefined");
    });
    fields("last_opcode", machine.undefined.last_opcode);
    fields("last_address", machine.undefined.last_address);
  });
  machine.ports.visit_state(visit);
}

}  // namespace sightline::i8080
