// A PDP-7 with its core memory, its console and the devices attached to it.
//
//   pdp7::Machine pdp7;                          // 8192 words, clock, reader, punch, keyboard and printer
//   std::string error = pdp7.attach("display");  // by name, from pdp7_devices.hpp; empty: no error
//   pdp7.strokes().hand_to(&screen);             // a core::StrokeTaker
//   pdp7.load(0100, program);
//   pdp7.start(0100);
//   pdp7::StopReason why = pdp7.run({.until = core::at_nanoseconds(1'000'000)});
//
// Everything except instructions happens at an instruction boundary, in this order: data breaks, in the order of the device
// list, then the program interrupt. A data break is granted at the first boundary at or after the request; the device has
// its word at the end of the break. Between boundaries devices do nothing: each publishes its next deadline, and is brought
// up to date then or when the program accesses it.
//
// Left out: the single-step keys, data breaks while the processor is halted, and the devices that no program here uses
// (drum, magnetic tape, line printer). Sources: PDP-4 manual page 16 (breaks "only at the completion of the current
// instruction"), and ../pdp7/timing.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../core/device.hpp"
#include "../core/iot_device.hpp"
#include "../core/state_visitor.hpp"
#include "../core/stroke.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "../pdp7/bus.hpp"
#include "../pdp7/console.hpp"
#include "../pdp7/core_memory.hpp"
#include "../pdp7/model.hpp"
#include "../pdp7/state.hpp"
#include "../pdp7/timing.hpp"

namespace sightline::pdp7 {

// The configuration of the machine.
struct Options {
  std::uint32_t core_words = 8192;  // 4096, 8192, 16384 or 32768
  Model model{};                    // more than 8192 words imply extend
  Timing timing{};
  // Attached when the machine is made. The names must outlive the machine.
  std::vector<std::string_view> devices{"clock", "reader", "punch", "keyboard", "printer"};
};

enum class StopReason : std::uint8_t {
  halt,               // HLT
  instruction_limit,  // Limits::instructions have been executed
  time_limit,         // the first boundary at or after Limits::until
  observer,           // an observer or request_stop()
  xct_chain,          // more than 16 XCTs in a chain
  unanswered,         // Model::strict: nothing in this machine obeyed an instruction
};

struct Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::Instant until = core::never;
};

struct Counts {
  std::uint64_t instructions = 0;
  std::uint64_t machine_cycles = 0;  // includes stolen cycles, excludes asynchronous time
  std::uint64_t stolen_cycles = 0;   // data breaks
};

// An instruction that nothing obeyed: how often, and where first.
struct Unanswered {
  std::uint32_t word;
  std::uint64_t count;
  Address first_pc;
};

// Marks of an address, one byte for each of the 32768.
namespace mark {
inline constexpr std::uint8_t stop = 1,  // Observer::stop() is called before the instruction there
    fetched = 2,                         // Observer::cycle() is called for the fetch of an instruction
    read = 4,                            // for other reads, those of data breaks included
    written = 8;                         // for writes, likewise; ISZ, auto-index and clock ticks read and write
}  // namespace mark

struct InstructionRecord {
  core::Instant time;  // start of its fetch
  core::Instant end;
  Address pc;         // its address
  core::Word18 word;  // the word that was fetched
  const State& before;
  const State& after;
};

// Observes a run. It must not write to the machine. The members are read when a run begins.
class Observer {
 public:
  const std::uint8_t* marks = nullptr;  // 32768 bytes, which may change during the run; null: everything is reported
  bool every_boundary = false;          // with marks: stop() is called at every boundary nevertheless
  bool instructions = false;            // instruction() is called after every instruction

  virtual void instruction(const InstructionRecord& record) { static_cast<void>(record); }
  // With marks: cycles at marked addresses, and all cycles of program interrupts and IOTs. Without: every cycle.
  virtual void cycle(const Cycle& cycle) { static_cast<void>(cycle); }
  // Called at an instruction boundary, before the data breaks and the interrupt that are due there. With marks: where the
  // next instruction has mark::stop, after a reported cycle, and where a run begins. Without: at every boundary. The
  // machine's registers, time and counts are those of the boundary; devices are as of their last access. True: the run ends
  // there. Not called at the boundary where Limits::instructions are done: the next run calls it first.
  [[nodiscard]] virtual bool stop(core::Instant now, Address next) {
    return static_cast<void>(now), static_cast<void>(next), false;
  }

 protected:
  ~Observer() = default;
};

class ObserverCalls;                // pdp7_observer_calls.hpp
struct KnownDevice;                 // pdp7_devices.hpp
struct Registers;                   // ../pdp7/registers.hpp
enum class Outcome : std::uint8_t;  // ../pdp7/cpu.hpp

class Machine {
 public:
  explicit Machine(const Options& options = {});
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  ~Machine();

  // --- Devices ---

  // The first error of attaching Options::devices; empty if none.
  [[nodiscard]] const std::string& error() const { return error_; }

  // All three return the text of an error, or an empty text. Errors: a name that is not in the list or already attached, an
  // unknown option, a value out of its range, a device code that another device has.
  [[nodiscard]] std::string attach(std::string_view name, std::span<const core::Setting> settings = {});
  // Attaches any other device. Everything that `info` refers to must outlive the machine.
  [[nodiscard]] std::string attach(const core::IotDeviceInfo& info, std::unique_ptr<core::IotDevice> device);
  // Attaches the device at its first use: at its first IOT, except one listed in ../pdp7/absent_devices.hpp. A program that
  // uses it cannot tell it from a device that was always attached.
  [[nodiscard]] std::string attach_when_used(std::string_view name, std::span<const core::Setting> settings = {});
  // Removes a device of attach_when_used() between runs, or attaches it again as new.
  void plug_in(std::string_view name, bool in);

  // Null: no such device is attached. The host may change a device between runs; the next run sees the change.
  [[nodiscard]] core::IotDevice* device(std::string_view name) const;
  // find<pdp7::Reader>(): the same, for a class with an `info` that names it.
  template <class D>
  [[nodiscard]] D* find() const {
    return static_cast<D*>(device(D::info.name));
  }
  // Where displays draw.
  [[nodiscard]] core::StrokeBuffer& strokes() { return *strokes_; }

  // --- Between runs ---

  [[nodiscard]] State& registers() { return state_; }
  [[nodiscard]] const State& registers() const { return state_; }
  // Core, accessed without time. An address outside reads 0 and ignores writes.
  [[nodiscard]] core::Word18 peek(Address address) const { return core_.read(address); }
  void deposit(Address address, core::Word18 word) { core_.write(address, word); }
  void load(Address address, std::span<const core::Word18> words);
  void load(Address address, std::initializer_list<std::uint32_t> words);
  [[nodiscard]] std::span<const core::Word18> core() const { return {core_.data(), core_.size()}; }
  void randomise_core(std::uint64_t seed) { core_.randomise(seed); }
  [[nodiscard]] Console& console() { return console_; }
  // Before it nothing outside the processor changes by itself: no device, and no switch of a script.
  [[nodiscard]] core::Instant deadline() const;

  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] core::Instant now() const { return now_; }
  [[nodiscard]] Counts counts() const;
  // One entry for every instruction word that nothing obeyed, in the order of first appearance.
  [[nodiscard]] const std::vector<Unanswered>& unanswered() const { return unanswered_; }

  // Everything that determines a further run, as it is between two runs.
  void visit_state(core::StateVisitor& visit);

  // --- Running ---

  // The START key: clears all flags, keeps core, AC, L, MQ and SC, and makes the next fetch at `address`.
  void start(Address address);
  // Each runs from the current state (the CONTINUE key) until something stops it. Data breaks and interrupts that are due
  // at the boundary where it stops are left to the next run; strokes() is flushed.
  StopReason run(const Limits& limits = {});                  // as fast as possible
  StopReason run(const Limits& limits, Observer& observer);   // by the plain loop
  StopReason run_plainly(const Limits& limits);               // by the plain loop, unobserved: for tests
  // For stroke takers and devices: ends the current or the next run at the next boundary, with StopReason::observer.
  void request_stop() { stop_requested_ = true; }

 private:
  struct FastRun;   // pdp7_fast.cpp
  struct PlainRun;  // pdp7_plain.cpp

  struct Attached {
    core::IotDeviceInfo info;
    std::unique_ptr<core::IotDevice> device;
    std::size_t priority;   // its position in the list
    bool requests = false;  // an interrupt
  };
  // A device that the program's first IOT attaches.
  struct Spare {
    const KnownDevice* known;
    std::vector<core::Setting> settings;
  };

  [[nodiscard]] Attached* find_attached(std::string_view name) const;
  [[nodiscard]] std::string find_code_conflict(const core::IotDeviceInfo& info) const;
  void wire();
  void plug_in_used(std::uint32_t word);

  // --- Inside a run
  struct Boundary {
    core::Instant now;  // after the data breaks
    core::Instant due;  // nothing happens before
    bool interrupt;
  };
  struct IotEffect {
    core::IotReply reply;
    core::Duration stretch;
    bool attention;  // something may have become due
  };
  void begin_run();
  void end_run();
  [[nodiscard]] Boundary serve_boundary(core::Instant now, Registers& registers, ObserverCalls* calls);
  [[nodiscard]] inline core::Instant grant(core::IotDevice& device, core::DataBreak request, core::Instant now, ObserverCalls* calls);
  [[nodiscard]] IotEffect input_output(core::Instant now, std::uint32_t word, core::Word18 ac);
  void control_pulses(core::Instant now, std::uint32_t word, core::IotReply& reply);
  void count_unanswered(std::uint32_t word, Address at);
  [[nodiscard]] static StopReason reason_of(Outcome outcome);

  Options options_;
  std::string error_;
  State state_;
  core::Instant now_{};
  core::Duration asynchronous_{};
  CoreMemory core_;
  Console console_;
  std::unique_ptr<core::StrokeBuffer> strokes_ = std::make_unique<core::StrokeBuffer>();
  std::vector<std::unique_ptr<Attached>> devices_;  // in the order in which they were attached
  std::vector<Attached*> by_priority_;
  // For each of by_priority_: the device does nothing before that instant unless it is accessed.
  std::vector<core::Instant> due_;
  std::size_t requesting_ = 0;              // how many devices request an interrupt
  std::array<std::uint8_t, 64> by_code_{};  // the index in by_priority_, or no_device
  std::vector<Spare> spares_;
  Counts counts_;
  std::vector<Unanswered> unanswered_;
  bool stop_requested_ = false;
};

}  // namespace sightline::pdp7
