// What a monitor observes in a run: where it stops, and which instructions it executes.
//
// A machine made with `--monitor` has a probe and reads it when a run begins: without marks, condition and listener the run
// has no observer. Otherwise the machine's observer compares accesses with the marks and checks conditions at boundaries
// between instructions. An event ends the run at the following boundary. The caller of Machine::run calls resume() first; a
// breakpoint at the address where a run begins is skipped once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace sightline::machines {

class Probe {
 public:
  // Marks of an address or a port, with the values of the machines' (pdp7::mark, i8080::mark).
  static constexpr std::uint8_t executed = 1;  // for a port of the PDP-7: an IOT to it
  static constexpr std::uint8_t is_read = 4;
  static constexpr std::uint8_t is_written = 8;

  enum class Kind : std::uint8_t { execution, read, write, break_write, interrupt_write, port_read, port_write, interrupt, condition };
  struct Event {
    Kind kind;
    std::int64_t time;      // in the machine's unit
    std::uint32_t address;  // of memory, or a port; for an interrupt, the address of the instruction it preceded
    std::uint32_t value;    // read or written; for an IOT of the PDP-7, the instruction
    friend bool operator==(const Event&, const Event&) = default;
  };

  // An instruction that has been executed.
  struct Entry {
    std::int64_t time = 0;  // when it began, in the machine's unit
    std::uint32_t pc = 0;
    std::uint32_t word = 0;     // the instruction; for the 8080 its bytes, the first lowest
    std::uint32_t address = 0;  // the last address it accessed; for an XCT, that of its target
    std::uint32_t value = 0;    // the word at that address
    std::uint32_t accumulator = 0;
    std::uint32_t link = 0;   // or the flags
    bool has_address = false;
    bool supplied = false;  // by a device instead of memory
  };

  // A machine cycle.
  struct Cycle {
    std::int64_t time = 0;    // when it began, in the machine's unit
    std::int64_t length = 0;  // minimum length
    std::string_view name = {};
    bool has_address = false;
    std::uint32_t address = 0;
    std::uint32_t value = 0;  // on the bus; only with an address
  };

  // A key typed on the console: the time of its boundary, in the machine's unit, and its code.
  struct Key {
    std::int64_t time;
    std::uint8_t code;
  };

  Probe(std::size_t addresses, std::size_t ports) : addresses_(addresses), ports_(ports) {}
  // A probe of the same size without marks and listeners.
  [[nodiscard]] Probe empty() const { return {addresses_.size(), ports_.size()}; }

  void mark(std::uint32_t address, std::uint8_t marks) {
    if ((marks & ~addresses_.at(address) & is_written) != 0) written_places_.push_back(address);
    addresses_.at(address) |= marks;
    marked_ = true;
  }
  void mark_port(std::uint32_t port, std::uint8_t marks) {
    ports_.at(port) |= marks;
    marked_ = true;
  }
  void mark_interrupts() { interrupts_ = marked_ = true; }
  void clear_marks() {
    std::fill(addresses_.begin(), addresses_.end(), std::uint8_t{0});
    std::fill(ports_.begin(), ports_.end(), std::uint8_t{0});
    written_places_.clear();
    interrupts_ = marked_ = false;
  }
  [[nodiscard]] std::size_t ports() const { return ports_.size(); }

  std::function<void(const Entry&)> on_instruction;  // empty: no listener
  std::function<void(const Cycle&)> on_cycle;        // called in runs with on_instruction; empty: no listener

  // Called at each boundary, when registers, memory, time and counts are those of the boundary; true ends the run there
  // with an event. Empty: no conditions.
  std::function<bool()> condition_changed;

  // Whether an event is wanted, since not every value is; empty: all are wanted.
  std::function<bool(const Event&)> wants;

  std::vector<Key> keys;  // all keys, in order

  // The events since resume(), in order.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  void resume() { events_.clear(); }

  // For the machine: what it must observe in a run.
  [[nodiscard]] bool watches_instructions() const { return static_cast<bool>(on_instruction); }
  [[nodiscard]] bool has_conditions() const { return static_cast<bool>(condition_changed); }
  [[nodiscard]] bool watches_boundaries() const { return has_conditions() || marked_; }
  [[nodiscard]] bool marks_interrupts() const { return interrupts_; }
  // One byte for each possible address or port of the machine.
  [[nodiscard]] const std::uint8_t* marks() const { return addresses_.data(); }
  [[nodiscard]] const std::uint8_t* port_marks() const { return ports_.data(); }
  // Addresses with the mark is_written, to detect writes by the host itself.
  [[nodiscard]] const std::vector<std::uint32_t>& written_places() const { return written_places_; }
  // One instruction can access a watched address without end; the first accesses are enough.
  void add(const Event& event) {
    constexpr std::size_t most = 64;
    if (events_.size() < most) events_.push_back(event);
  }

 private:
  std::vector<std::uint8_t> addresses_;
  std::vector<std::uint8_t> ports_;
  std::vector<std::uint32_t> written_places_;
  std::vector<Event> events_;
  bool interrupts_ = false;
  bool marked_ = false;  // an address, a port or interrupts
};

// The work of a run for its probe, common to all machines. Times are in the machine's unit.
class Watch {
 public:
  // The probe must outlive the watch; its marks must not change during the run.
  explicit Watch(Probe& probe) : probe_(&probe), places_(probe.marks()), ports_(probe.port_marks()) {}

  // A run begins: a breakpoint at its first instruction is skipped.
  void begin(std::int64_t now) {
    begun_ = now;
    reported_ = !probe_->events().empty();
  }
  // Called at a boundary; true: the run ends there.
  [[nodiscard]] bool stop(std::int64_t now, std::uint32_t next) {
    if (now == begun_) return reported_;
    if (has(next, Probe::executed)) add(Probe::Kind::execution, now, next, 0);
    if (probe_->condition_changed && probe_->condition_changed()) add(Probe::Kind::condition, now, next, 0);
    return reported_;
  }

  [[nodiscard]] bool has(std::uint32_t address, std::uint8_t marks) const { return (places_[address] & marks) != 0; }
  [[nodiscard]] bool port_has(std::uint32_t port, std::uint8_t marks) const { return (ports_[port] & marks) != 0; }
  [[nodiscard]] bool wants_interrupts() const { return probe_->marks_interrupts(); }
  void add(Probe::Kind kind, std::int64_t time, std::uint32_t address, std::uint32_t value) {
    const Probe::Event event{kind, time, address, value};
    if (probe_->wants && !probe_->wants(event)) return;
    probe_->add(event);
    reported_ = true;
  }

 private:
  Probe* probe_;
  const std::uint8_t* places_;
  const std::uint8_t* ports_;
  std::int64_t begun_ = 0;
  bool reported_ = false;
};

}  // namespace sightline::machines
