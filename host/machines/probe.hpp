// What a monitor wants to know of a run: where it is to stop, and which instructions it obeys.
//
// A machine made with `--monitor` has one and reads it when a run begins: without marks, condition and listener the run has no
// observer. Else the machine's observer compares accesses with the marks and asks at boundaries between two instructions. An
// event ends the run at the boundary that follows. The caller of Machine::run calls resume() first: a run from a place with a
// breakpoint passes over it once.
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
  // Marks of an address or a port: those of the machines (pdp7::mark, i8080::mark).
  static constexpr std::uint8_t executed = 1;  // of a port of the PDP-7: an IOT to it
  static constexpr std::uint8_t is_read = 4;
  static constexpr std::uint8_t is_written = 8;

  enum class Kind : std::uint8_t { execution, read, write, break_write, interrupt_write, port_read, port_write, interrupt, condition };
  struct Event {
    Kind kind;
    std::int64_t time;      // in the machine's unit
    std::uint32_t address;  // of memory, or a port; of an interrupt the instruction it came before
    std::uint32_t value;    // read or written; of an IOT of the PDP-7 the instruction
    friend bool operator==(const Event&, const Event&) = default;
  };

  // An instruction that has been obeyed.
  struct Entry {
    std::int64_t time = 0;  // when it began, in the machine's unit
    std::uint32_t pc = 0;
    std::uint32_t word = 0;     // the instruction; of the 8080 its bytes, the first lowest
    std::uint32_t address = 0;  // that it last used; of an XCT, that of the instruction it led to
    std::uint32_t value = 0;    // there
    std::uint32_t accumulator = 0;
    std::uint32_t link = 0;   // or the flags
    bool has_address = false;
    bool supplied = false;  // by a device
  };

  // A machine cycle.
  struct Cycle {
    std::int64_t time = 0;    // when it began, in the machine's unit
    std::int64_t length = 0;  // at least
    std::string_view name = {};
    bool has_address = false;
    std::uint32_t address = 0;
    std::uint32_t value = 0;  // on the bus; with an address only
  };

  // What was typed on the console: the boundary it came at, in the machine's unit, and its code.
  struct Key {
    std::int64_t time;
    std::uint8_t code;
  };

  Probe(std::size_t addresses, std::size_t ports) : addresses_(addresses), ports_(ports) {}
  // One of the same size that knows nothing.
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

  std::function<void(const Entry&)> on_instruction;  // empty: nobody listens
  std::function<void(const Cycle&)> on_cycle;        // of a run with on_instruction; empty: nobody listens

  // Asked at each boundary, when registers, memory, time and counts are those of the boundary; true: the run ends there, with an
  // event. Empty: nobody waits for conditions.
  std::function<bool()> condition_changed;

  // Whether an event is one that somebody waits for, as not each value is; empty: all are.
  std::function<bool(const Event&)> wants;

  std::vector<Key> keys;  // all, in order

  // Since resume(), in order.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  void resume() { events_.clear(); }

  // For the machine: what a run is to be watched for.
  [[nodiscard]] bool watches_instructions() const { return static_cast<bool>(on_instruction); }
  [[nodiscard]] bool has_conditions() const { return static_cast<bool>(condition_changed); }
  [[nodiscard]] bool watches_boundaries() const { return has_conditions() || marked_; }
  [[nodiscard]] bool marks_interrupts() const { return interrupts_; }
  // One byte for each address, or port, that the machine can have.
  [[nodiscard]] const std::uint8_t* marks() const { return addresses_.data(); }
  [[nodiscard]] const std::uint8_t* port_marks() const { return ports_.data(); }
  // Addresses with the mark is_written, for what the host itself writes.
  [[nodiscard]] const std::vector<std::uint32_t>& written_places() const { return written_places_; }
  // A watched place can be touched without end in one instruction; the first accesses tell enough.
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
  bool marked_ = false;  // a place, a port or interrupts
};

// What a run does for its probe, whatever the machine. Times are in the machine's unit.
class Watch {
 public:
  // The probe outlives it; it must not get others marks while the run lasts.
  explicit Watch(Probe& probe) : probe_(&probe), places_(probe.marks()), ports_(probe.port_marks()) {}

  // A run begins here: an instruction at this place is passed over.
  void begin(std::int64_t now) {
    begun_ = now;
    told_ = !probe_->events().empty();
  }
  // At a boundary; true: the run ends there.
  [[nodiscard]] bool stop(std::int64_t now, std::uint32_t next) {
    if (now == begun_) return told_;
    if (has(next, Probe::executed)) add(Probe::Kind::execution, now, next, 0);
    if (probe_->condition_changed && probe_->condition_changed()) add(Probe::Kind::condition, now, next, 0);
    return told_;
  }

  [[nodiscard]] bool has(std::uint32_t address, std::uint8_t marks) const { return (places_[address] & marks) != 0; }
  [[nodiscard]] bool port_has(std::uint32_t port, std::uint8_t marks) const { return (ports_[port] & marks) != 0; }
  [[nodiscard]] bool at_interrupts() const { return probe_->marks_interrupts(); }
  void add(Probe::Kind kind, std::int64_t time, std::uint32_t address, std::uint32_t value) {
    const Probe::Event event{kind, time, address, value};
    if (probe_->wants && !probe_->wants(event)) return;
    probe_->add(event);
    told_ = true;
  }

 private:
  Probe* probe_;
  const std::uint8_t* places_;
  const std::uint8_t* ports_;
  std::int64_t begun_ = 0;
  bool told_ = false;
};

}  // namespace sightline::machines
