// The lines of `sightline demo`: for each machine and method, what was run, its speed and its error, and what the paper states.
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
  std::vector<WalkRow> walks;
  std::vector<TurnRow> turns;
  std::vector<CircleRow> circles;
  std::vector<FlightRow> flights;
  SkalaDemo skala;
  std::vector<StripesDemoRow> stripes;
  DemoAnswer answer;
};

struct Verdict {
  std::string subject;  // "Jones 1971 on the PDP-7"
  std::string text;     // the measurements, without a full stop at the end
  std::string verdict;  // "right in 5 of 5"; empty: none
  // Every program agrees with its twin, and no picture is farther from the reference than a point, or than the dots and steps of its
  // device explain. Absent if no picture is compared.
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

// Why visibility does not cost the 15 % of the paper: the time that the test adds per point, and the share of points that it hides.
// Empty: unknown.
[[nodiscard]] std::string visibility_line(const SkalaDemo& demo);

}  // namespace sightline::app
