// Breakpoints: where and when a run stops.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/machines/probe.hpp"

namespace sightline::live {

// At which matches a breakpoint stops, by their number.
struct HitCount {
  enum class Test : std::uint8_t { every, equal, more, at_least, less, at_most };
  Test test = Test::every;
  std::uint64_t number = 1;

  [[nodiscard]] bool holds(std::uint64_t passed) const;
};
// N or %N (every Nth match), =N, ==N, >N, >=N, <N or <=N, decimal; counts that no match could meet are errors.
[[nodiscard]] base::Result<HitCount> read_hit_count(std::string_view text);

struct Breakpoint {
  enum class Kind : std::uint8_t { execution, memory, port, interrupt, condition };
  int number = 0;
  Kind kind = Kind::execution;
  std::uint32_t first = 0;  // addresses, or a port
  std::uint32_t last = 0;
  std::uint8_t access = machines::Probe::executed;
  std::optional<std::uint32_t> value;  // the value read or written; empty: any
  std::string condition;               // an expression; empty: always
  HitCount count;
  std::uint64_t passed = 0;
  bool was_true = false;  // for a condition: stops when it becomes true
  std::string text;       // as typed
  std::string log;        // not empty: prints this, see Debugger::log_text, and does not stop
};

class Breakpoints {
 public:
  // Whether an expression is true. An expression without a value counts as true.
  using Condition = std::function<bool(const std::string&)>;

  // Returns the number of the new breakpoint.
  int add(Breakpoint breakpoint);
  bool remove(int number);
  void clear() { all_.clear(); }
  [[nodiscard]] const std::vector<Breakpoint>& all() const { return all_; }
  // Moves an execution breakpoint; false: no breakpoint has this number.
  bool move(int number, std::uint32_t to);
  // Resets all counts.
  void reset_counts();
  // Whether a breakpoint is a condition, so that the run must check it after each instruction.
  [[nodiscard]] bool has_conditions() const;

  // Marks in the probe what a run is to be watched for; `stops_only`: not for breakpoints that only print.
  void mark(machines::Probe& probe, bool stops_only = false) const;
  // Whether the event matches one of them, conditions and counts aside.
  [[nodiscard]] bool wants(const machines::Probe::Event& event) const;

  // A reason to stop: the breakpoint and the event that reached it; a condition has no event.
  struct Hit {
    Breakpoint breakpoint;
    std::optional<machines::Probe::Event> event;
  };
  // Receives the text of a breakpoint that prints.
  using Log = std::function<void(const std::string&)>;
  // Counts all breakpoints that the events reach and returns the first one that stops the run.
  [[nodiscard]] std::optional<Hit> find_hit(const std::vector<machines::Probe::Event>& events, const Condition& holds, const Log& log);
  // The first condition that has become true since the last call.
  [[nodiscard]] std::optional<Hit> find_true_condition(const Condition& holds, const Log& log);

 private:
  static bool stops(Breakpoint& breakpoint, const Condition& holds, const Log& log);

  std::vector<Breakpoint> all_;
  int last_number_ = 0;
};

}  // namespace sightline::live
