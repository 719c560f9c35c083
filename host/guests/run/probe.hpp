// What a monitor wants to know of a run: where it is to stop, what the last instructions were, who wrote a word.
//
// The observer of a machine made with `--monitor` fills it; a run without one has none and pays nothing. An event ends the
// run at the boundary that follows it. The caller of Machine::run calls resume() first: a run from a place with a breakpoint
// passes over it once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace sightline::guests::run {

class Probe {
 public:
  // Of an address or a port.
  static constexpr std::uint8_t executed = 1;  // of a port of the PDP-7: an IOT to it
  static constexpr std::uint8_t is_read = 2;
  static constexpr std::uint8_t is_written = 4;

  enum class Kind : std::uint8_t { execution, read, write, port_read, port_write, interrupt };
  struct Event {
    Kind kind;
    std::uint32_t address;  // of memory, or a port
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
  static constexpr std::size_t history_length = 4096;

  struct Writer {
    std::int64_t time = -1;  // of the instruction; -1: nothing has written there
    std::uint32_t pc = 0;
    std::uint32_t value = 0;
    bool device = false;  // by data break
  };

  Probe(std::size_t addresses, std::size_t ports)
      : at_address(addresses), at_port(ports), writers(addresses), ring_(history_length) {}

  std::vector<std::uint8_t> at_address;  // which accesses end the run
  std::vector<std::uint8_t> at_port;
  bool at_interrupt = false;
  std::vector<Event> events;  // since resume(), in order
  std::vector<Writer> writers;
  std::function<void(const Entry&)> on_instruction;  // empty: nobody listens

  void resume() { events.clear(); }
  [[nodiscard]] bool stops() const { return !events.empty(); }

  // For the observer.
  void access(Kind kind, std::uint8_t bit, std::uint32_t address, std::uint32_t value) {
    if (address < at_address.size() && (at_address[address] & bit) != 0) [[unlikely]]
      add({kind, address, value});
  }
  void port(Kind kind, std::uint8_t bit, std::uint32_t number, std::uint32_t value) {
    if ((at_port[number] & bit) != 0) [[unlikely]]
      add({kind, number, value});
  }
  void interrupt(std::uint32_t address) {
    if (at_interrupt) add({Kind::interrupt, address, 0});
  }
  void written(std::uint32_t address, const Writer& writer) {
    if (address < writers.size()) writers[address] = writer;
  }
  void remember(const Entry& entry) {
    ring_[obeyed_++ % history_length] = entry;
    latest_ = std::max(latest_, obeyed_);
    if (on_instruction) [[unlikely]]
      on_instruction(entry);
  }

  // The last `n` instructions, the oldest first.
  [[nodiscard]] std::vector<Entry> last(std::size_t n) const {
    // After a step back the newer ones have taken the places of the oldest.
    const std::uint64_t oldest = latest_ - std::min<std::uint64_t>(latest_, history_length);
    const std::uint64_t there = obeyed_ - std::min(obeyed_, oldest);
    const std::uint64_t wanted = std::min<std::uint64_t>(n, there);
    std::vector<Entry> entries;
    for (std::uint64_t i = obeyed_ - wanted; i < obeyed_; ++i) entries.push_back(ring_[i % history_length]);
    return entries;
  }

  // How many have been remembered; a monitor that has gone back says so.
  [[nodiscard]] std::uint64_t remembered() const { return obeyed_; }
  void go_back_to(std::uint64_t remembered) { obeyed_ = remembered; }

 private:
  // A block that is watched can be touched without end in one instruction; the first accesses tell enough.
  void add(const Event& event) {
    constexpr std::size_t most = 64;
    if (events.size() < most) events.push_back(event);
  }

  std::vector<Entry> ring_;
  std::uint64_t obeyed_ = 0;
  std::uint64_t latest_ = 0;  // the largest it has been
};

}  // namespace sightline::guests::run
