// Breakpoints: where and when a run is to stop.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/machines/probe.hpp"

namespace sightline::live {

struct Breakpoint {
  enum class Kind : std::uint8_t { execution, memory, port, interrupt, condition };
  int number = 0;
  Kind kind = Kind::execution;
  std::uint32_t first = 0;  // addresses, or a port
  std::uint32_t last = 0;
  std::uint8_t access = machines::Probe::executed;
  std::optional<std::uint32_t> value;  // read or written
  std::string condition;               // an expression; empty: always
  std::uint64_t count = 1;             // stops each time when so many have passed
  std::uint64_t passed = 0;
  bool was_true = false;  // of a condition: stops when it becomes true
  std::string text;       // as typed
};

class Breakpoints {
 public:
  // Whether an expression is true; one that has no value is.
  using Condition = std::function<bool(const std::string&)>;

  // The number it was given.
  int add(Breakpoint breakpoint);
  bool remove(int number);
  void clear() { all_.clear(); }
  [[nodiscard]] const std::vector<Breakpoint>& all() const { return all_; }
  // Where an execution breakpoint stands now; false: there is none of that number.
  bool move(int number, std::uint32_t to);
  // None has been passed yet.
  void forget_passes();
  // Some become true by themselves: conditions must be looked at after each instruction.
  [[nodiscard]] bool has_conditions() const;

  // What a run is to be watched for.
  void mark(machines::Probe& probe) const;
  // Whether one of them is met by the event, but for its condition.
  [[nodiscard]] bool wants(const machines::Probe::Event& event) const;

  // A reason to stop: the breakpoint, and the event it was met by; of a condition there is none.
  struct Hit {
    Breakpoint breakpoint;
    std::optional<machines::Probe::Event> event;
  };
  // Counts all that are met and gives the first.
  [[nodiscard]] std::optional<Hit> meet(const std::vector<machines::Probe::Event>& events, const Condition& holds);
  // The first condition that has become true since the last look.
  [[nodiscard]] std::optional<Hit> condition_met(const Condition& holds);

 private:
  static bool counts(Breakpoint& breakpoint, const Condition& holds);

  std::vector<Breakpoint> all_;
  int last_number_ = 0;
};

}  // namespace sightline::live
