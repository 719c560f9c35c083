// An 8080 with up to 64K of RAM and the devices attached to its ports.
//
//   i8080::Machine machine;
//   machine.load(0x100, program);
//   std::string error = machine.attach("ef9365");      // a device of i8080_devices.hpp, or your own
//   machine.start(0x100);
//   i8080::StopReason why = machine.run({.until = core::at_t_state(3'000'000)});
//   const core::Raster* raster = machine.device("ef9365")->raster();
//
// Between two runs everything can be read and changed. Time is counted in T-states (core/tstates.hpp). A port without a
// device reads as FFh, the level of the undriven bus, and ignores writes; such accesses are counted. So do addresses above
// the RAM, uncounted.
//
// Left out: ROM, and memory banks. Source: see ../i8080/cpu.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/state_visitor.hpp"
#include "../core/stroke.hpp"
#include "../core/tstates.hpp"
#include "../i8080/bus.hpp"
#include "../i8080/state.hpp"

namespace sightline::i8080 {

struct Options {
  core::ClockRate clock{};
  // A run ends at an access to a port without a device, and after an opcode that Intel left undefined.
  bool strict = false;
  std::uint32_t memory = 0x10000;  // bytes of RAM, from address 0 on
};

enum class StopReason : std::uint8_t {
  halt,               // HLT, and no interrupt can end it
  instruction_limit,  // Limits::instructions have been executed
  time_limit,         // the first boundary at or after Limits::until
  observer,           // Observer::stop()
  device,             // Machine::request_stop()
  unanswered,         // Options::strict, at a port
  undefined,          // Options::strict, after an undefined opcode
};

struct Limits {
  std::uint64_t instructions = ~std::uint64_t{0};  // of this run
  core::TStateInstant until = core::never_t;
};

struct InstructionRecord {
  core::TStateInstant time;  // T1 of its fetch
  core::TStateInstant end;
  Address pc;                 // its address; PC, if a device supplied the instruction
  std::array<Byte, 3> bytes;  // the bytes there; those beyond the instruction's length do not count
  bool acknowledged;          // a device supplied it
  const State& before;
  const State& after;
};

// A machine cycle with a SYNC; the internal cycles of DAD have none and are not reported.
struct BusCycle {
  core::TStateInstant time;  // its T1
  Status status;
  Address address;  // for IN and OUT: the port, in both halves
  Byte data;        // 0 in the halt cycle, where nothing is on the bus
  bool operand = false;  // a byte of the instruction after its opcode

  friend constexpr bool operator==(const BusCycle&, const BusCycle&) = default;
};

struct HoldPins {
  core::TStateInstant time;
  bool hold;
  bool acknowledge;  // HLDA
  bool waits;        // the processor waits for the end of HOLD

  friend constexpr bool operator==(const HoldPins&, const HoldPins&) = default;
};

// Marks of an address or a port, one byte each.
namespace mark {
inline constexpr std::uint8_t stop = 1;  // of an address: stop() is called at the boundary before an instruction there
inline constexpr std::uint8_t read = 4;  // cycle() is called after such an access
inline constexpr std::uint8_t written = 8;
}  // namespace mark

// Observes a run; it must not write to the machine. The members are read when a run begins.
class Observer {
 public:
  virtual ~Observer() = default;

  const std::uint8_t* marks = nullptr;       // 65536; null: every cycle is reported, and stop() is called at every boundary
  const std::uint8_t* port_marks = nullptr;  // 256, used only with marks; null: no port is marked
  bool every_boundary = false;               // with marks: stop() is called at every boundary nevertheless
  bool instructions = false;                 // instruction() is called after each

  virtual void instruction(const InstructionRecord& record) { static_cast<void>(record); }
  // Called when the byte is known. With marks: for accesses that are marked, except bytes of the instruction itself, and
  // for each acknowledge cycle that fetches.
  virtual void cycle(const BusCycle& cycle) { static_cast<void>(cycle); }
  // One of the pins has changed.
  virtual void hold(const HoldPins& pins) { static_cast<void>(pins); }
  // Called before the instruction at `next`, not during a halt, also at the boundary where Limits::instructions are done.
  // With marks: before an instruction with mark::stop, at the boundary after a reported cycle, and where the run begins.
  // The machine's registers, time and counts are those of the boundary. True: the run ends there.
  [[nodiscard]] virtual bool stop(core::TStateInstant now, Address next) {
    return static_cast<void>(now), static_cast<void>(next), false;
  }
};

// The accesses of a port that no device answered.
struct UnansweredPort {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

// The executions of an opcode that Intel left undefined.
struct UndefinedOpcode {
  Byte opcode = 0;
  Address first = 0;  // address of the first one
  std::uint64_t count = 0;
};
struct UndefinedOpcodes {
  std::vector<UndefinedOpcode> all;  // in the order of their first execution
  Byte last_opcode = 0;
  Address last_address = 0;
};

struct AttachedDevice {
  const core::PortDeviceInfo* info;
  std::unique_ptr<core::PortDevice> device;
};

struct MachineParts;  // i8080_parts.hpp

class Machine {
 public:
  explicit Machine(const Options& options = {});
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  // --- Devices, between runs. Each call returns an empty text, or the text of an error and then changes nothing.

  // Attaches a device of the list in i8080_devices.hpp, each at most once. Errors: no such name, no such option, a value
  // beyond its bounds, a port that another device has.
  [[nodiscard]] std::string attach(std::string_view name, std::span<const core::Setting> settings = {});
  // Attaches any other device; `info` must outlive the machine. Errors: a port that another device has, a name that is
  // taken.
  [[nodiscard]] std::string attach(const core::PortDeviceInfo& info, std::unique_ptr<core::PortDevice> device);
  // Connects an interrupt line of an attached device to RST 0..7. Of several requests the highest restart wins, as with an
  // 8214; RST 7 is what the bus gives when no request is left. Errors: no such line, no such restart.
  [[nodiscard]] std::string wire(std::string_view line, std::uint8_t restart);

  // Null: not attached.
  [[nodiscard]] core::PortDevice* device(std::string_view name) const;
  template <class Device>
  [[nodiscard]] Device* find() const {
    return static_cast<Device*>(device(Device::info.name));
  }
  // In the order of the list; other devices come last.
  [[nodiscard]] std::span<const AttachedDevice> devices() const;
  // An interrupt line of the device is connected, or it drives INT or HOLD.
  [[nodiscard]] bool is_connected(const core::PortDevice& device) const;
  // Before it nothing outside the processor changes by itself.
  [[nodiscard]] core::TStateInstant deadline() const;
  // Where plotters draw.
  [[nodiscard]] core::StrokeBuffer& strokes();

  // `front` gets the IN and OUT of these ports instead of the device there, and passes accesses on by forward_in() and
  // forward_out(). It must outlive all later runs. A port has one front: the last. i8080_front.hpp has a base class.
  void put_before(core::PortRange ports, core::PortDevice& front);
  [[nodiscard]] std::uint8_t forward_in(std::uint8_t port, core::TStateInstant at);
  void forward_out(std::uint8_t port, std::uint8_t value, core::TStateInstant at);
  // Indexed by port.
  [[nodiscard]] std::span<const UnansweredPort, 256> unanswered() const;
  [[nodiscard]] const UndefinedOpcodes& undefined() const;

  // --- Registers and memory, between runs

  [[nodiscard]] State& registers();
  [[nodiscard]] const State& registers() const;
  [[nodiscard]] Byte peek(Address address) const;
  void deposit(Address address, Byte byte);  // above the RAM: without effect
  // Addresses wrap from FFFFh to 0.
  void load(Address address, std::span<const Byte> bytes);
  // All 64K; bytes above the RAM must stay FFh.
  [[nodiscard]] std::span<Byte> memory();
  [[nodiscard]] std::span<const Byte> memory() const;
  // Sets PC, and ends a halt.
  void start(Address address);
  // The RESET pin: only PC and INTE change, and a halt ends; memory and the other registers stay.
  void reset();

  // --- Runs

  // Runs from the current state until something stops it. Work that is due at the boundary where it stops is left to the
  // next run, so that a run in pieces equals a run in one piece.
  StopReason run(const Limits& limits = {});
  StopReason run(const Limits& limits, Observer& observer);
  // Without an observer, but by the engine for observed runs: for tests.
  StopReason run_plainly(const Limits& limits);
  // For devices, fronts and stroke takers: ends the current or the next run at the next boundary, with StopReason::device.
  void request_stop();

  [[nodiscard]] const Options& options() const;
  [[nodiscard]] core::TStateInstant now() const;
  // Since the machine was made, including those that a device supplied.
  [[nodiscard]] std::uint64_t instructions() const;
  // T-states in which the processor waited because of HOLD, since the machine was made.
  [[nodiscard]] std::uint64_t held() const;
  // The level of INT, as of the last T-state at which the devices have been polled.
  [[nodiscard]] bool interrupt() const;

  // Everything that determines a further run, as it is between two runs.
  void visit_state(core::StateVisitor& visit);

 private:
  std::unique_ptr<MachineParts> parts_;
};

}  // namespace sightline::i8080
