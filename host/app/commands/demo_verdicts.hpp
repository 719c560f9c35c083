// What `sightline demo` says in about ten lines: of each machine and method what was run, how fast and how wrong it is, and what
// the paper says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/app/commands/demo_answer.hpp"
#include "host/app/commands/demo_runs.hpp"
#include "host/app/commands/skala_demo.hpp"
#include "host/app/commands/stripes_demo.hpp"

namespace sightline::app {

struct DemoResults {
  std::vector<JonesRow> jones;
  std::vector<TurnRow> turns;
  std::vector<FlightRow> flights;
  SkalaDemo skala;
  std::vector<StripesDemoRow> stripes;
  DemoAnswer answer;
};

struct Verdict {
  std::string subject;  // "Jones 1971 on the PDP-7"
  std::string text;     // what was measured, without a full stop at the end
  std::string verdict;  // "right in 5 of 5"; empty: none
  // No program differs from its twin, and no picture is farther from the truth than a point, or than the dots and steps of its device
  // explain; absent where no picture is judged.
  std::optional<bool> right{};
};
[[nodiscard]] std::vector<Verdict> verdicts_of(const DemoResults& results);

// One sentence each: how fast, how wrong, against what.
struct ThreeAnswers {
  std::string fast;
  std::string wrong;
  std::string against;
};
[[nodiscard]] ThreeAnswers answers_of(const DemoResults& results);

// Why visibility does not cost the paper's 15 %: what the test adds to a point, and how many points it hides. Empty: unknown.
[[nodiscard]] std::string visibility_line(const SkalaDemo& demo);

}  // namespace sightline::app
