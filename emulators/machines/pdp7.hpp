// A PDP-7 with its core memory, its console and the devices attached to it.
//
//   pdp7::Machine pdp7;                          // 8192 words, clock, reader, punch, keyboard and printer
//   std::string error = pdp7.attach("display");  // by name, from pdp7_devices.hpp; empty: none
//   pdp7.strokes().hand_to(&screen);             // a core::StrokeTaker
//   pdp7.load(0100, program);
//   pdp7.start(0100);
//   pdp7::StopReason why = pdp7.run({.until = core::at_nanoseconds(1'000'000)});
//
// Everything that is not an instruction happens at an instruction boundary, in this order: data breaks, those of the first
// device in the list first, then the program interrupt. A data break is granted at the first boundary at or after the
// request; its word is at the device at the end of the break. Between boundaries devices do nothing: each says when it will
// do something by itself, and is brought up to date then or when the program touches it.
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

// How the machine is put together.
struct Options {
  std::uint32_t core_words = 8192;  // 4096, 8192, 16384 or 32768
  Model model{};                    // extend is implied by more than 8192 words
  Timing timing{};
  // Attached from the beginning. The names must outlive the machine.
  std::vector<std::string_view> devices{"clock", "reader", "punch", "keyboard", "printer"};
};

enum class StopReason : std::uint8_t {
  halt,               // HLT
  instruction_limit,  // Limits::instructions done
  time_limit,         // the first boundary at or after Limits::until
  observer,           // an observer or request_stop()
  xct_chain,          // more than 16 XCTs in a chain
  unanswered,         // Model::strict: an instruction nothing in this machine obeys
};

struct Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::Instant until = core::never;
};

struct Counts {
  std::uint64_t instructions = 0;
  std::uint64_t machine_cycles = 0;  // stolen ones included, asynchronous time not
  std::uint64_t stolen_cycles = 0;   // data breaks
};

// An instruction nothing obeyed: how often, and where first.
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

// Watches a run. It must not write to the machine. The members are read when a run begins.
class Observer {
 public:
  const std::uint8_t* marks = nullptr;  // 32768 bytes, which may change during the run; null: everything is reported
  bool every_boundary = false;          // with marks: stop() is called at every boundary all the same
  bool instructions = false;            // instruction() is called after every instruction

  virtual void instruction(const InstructionRecord& record) { static_cast<void>(record); }
  // With marks: cycles at marked addresses, and all of program interrupts and IOTs. Without: every cycle.
  virtual void cycle(const Cycle& cycle) { static_cast<void>(cycle); }
  // At an instruction boundary, before the data breaks and the interrupt that are due there. With marks: where the next
  // instruction has mark::stop, after a cycle that was reported, and where a run begins. Without: at every boundary. The
  // machine's registers, time and counts are those of the boundary; devices are as they were last touched. True: the run ends
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

  // The first error of attaching Options::devices; empty: none.
  [[nodiscard]] const std::string& error() const { return error_; }

  // All three give the text of an error, or nothing: a name that is not in the list or attached already, an unknown option or
  // a value out of its range, a device code that another device has.
  [[nodiscard]] std::string attach(std::string_view name, std::span<const core::Setting> settings = {});
  // A device of one's own. What `info` refers to must outlive the machine.
  [[nodiscard]] std::string attach(const core::IotDeviceInfo& info, std::unique_ptr<core::IotDevice> device);
  // It is there as soon as the program uses it: from its first IOT on, unless that is one of a device that is absent on
  // purpose (../pdp7/absent_devices.hpp). A program that uses it cannot tell it from one that was there all the time.
  [[nodiscard]] std::string attach_when_used(std::string_view name, std::span<const core::Setting> settings = {});
  // Of a device that attach_when_used() was given, between runs: takes it out, or plugs it in as new.
  void plug_in(std::string_view name, bool in);

  // Null: no such device is attached. What the host does to a device between runs the next run finds.
  [[nodiscard]] core::IotDevice* device(std::string_view name) const;
  // find<pdp7::Reader>(): the same, of a class with an `info` that names it.
  template <class D>
  [[nodiscard]] D* find() const {
    return static_cast<D*>(device(D::info.name));
  }
  // What displays draw.
  [[nodiscard]] core::StrokeBuffer& strokes() { return *strokes_; }

  // --- Between runs ---

  [[nodiscard]] State& registers() { return state_; }
  [[nodiscard]] const State& registers() const { return state_; }
  // Core, without time. An address outside reads 0 and ignores writes.
  [[nodiscard]] core::Word18 peek(Address address) const { return core_.read(address); }
  void deposit(Address address, core::Word18 word) { core_.write(address, word); }
  void load(Address address, std::span<const core::Word18> words);
  void load(Address address, std::initializer_list<std::uint32_t> words);
  [[nodiscard]] std::span<const core::Word18> core() const { return {core_.data(), core_.size()}; }
  void randomise_core(std::uint64_t seed) { core_.randomise(seed); }
  [[nodiscard]] Console& console() { return console_; }

  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] core::Instant now() const { return now_; }
  [[nodiscard]] Counts counts() const;
  // One entry for every instruction word that nothing obeyed, in the order of first appearance.
  [[nodiscard]] const std::vector<Unanswered>& unanswered() const { return unanswered_; }

  // All that a further run depends on, as it is between two runs.
  void visit_state(core::StateVisitor& visit);

  // --- Running ---

  // The START key: clears all flags, leaves core, AC, L, MQ and SC alone, and makes the next fetch at `address`.
  void start(Address address);
  // Each runs from the state as it is (the CONTINUE key) until something stops it; data breaks and interrupts that are due at
  // the boundary where it stops are left to the next run, and strokes() is flushed.
  StopReason run(const Limits& limits = {});                  // as fast as possible
  StopReason run(const Limits& limits, Observer& observer);   // by the plain loop
  StopReason run_plainly(const Limits& limits);               // by the plain loop, unwatched: for tests
  // By a StrokeTaker or a device: the run, or the next one, ends at the next boundary, with StopReason::observer.
  void request_stop() { stop_requested_ = true; }

 private:
  struct FastRun;   // pdp7_fast.cpp
  struct PlainRun;  // pdp7_plain.cpp

  struct Attached {
    core::IotDeviceInfo info;
    std::unique_ptr<core::IotDevice> device;
    std::size_t priority;   // its place in the list
    bool requests = false;  // an interrupt
  };
  // One that the program's first IOT plugs in.
  struct Spare {
    const KnownDevice* known;
    std::vector<core::Setting> settings;
  };

  [[nodiscard]] Attached* find_attached(std::string_view name) const;
  [[nodiscard]] std::string wrong_codes(const core::IotDeviceInfo& info) const;
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
  [[nodiscard]] Boundary attend(core::Instant now, Registers& registers, ObserverCalls* calls);
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
  // What the machine knows of each of by_priority_: it wants nothing by itself before.
  std::vector<core::Instant> due_;
  std::size_t requesting_ = 0;              // how many devices request an interrupt
  std::array<std::uint8_t, 64> by_code_{};  // the place in by_priority_, or no_device
  std::vector<Spare> spares_;
  Counts counts_;
  std::vector<Unanswered> unanswered_;
  bool stop_requested_ = false;
};

}  // namespace sightline::pdp7
