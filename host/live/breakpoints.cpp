#include "host/live/breakpoints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::live {

using machines::Probe;

bool HitCount::holds(std::uint64_t passed) const {
  switch (test) {
    case Test::every: return passed % number == 0;
    case Test::equal: return passed == number;
    case Test::more: return passed > number;
    case Test::at_least: return passed >= number;
    case Test::less: return passed < number;
    case Test::at_most: return passed <= number;
  }
  return true;
}

base::Result<HitCount> read_hit_count(std::string_view text) {
  using Test = HitCount::Test;
  // Longer signs first.
  constexpr std::array<std::pair<std::string_view, Test>, 7> signs{{{">=", Test::at_least}, {"<=", Test::at_most}, {"==", Test::equal},
                                                                    {">", Test::more}, {"<", Test::less}, {"=", Test::equal}, {"%", Test::every}}};
  HitCount count;
  std::string_view rest = base::without_blanks(text);
  for (const auto& [sign, test] : signs) {
    if (!rest.starts_with(sign)) continue;
    count.test = test;
    rest = base::without_blanks(rest.substr(sign.size()));
    break;
  }
  const auto number = base::count_number(rest);
  if (!number) {
    return base::Error{.found = fmt::format("found \"{}\"", text),
                       .expected = "a decimal count: 3 or %3 (every third time), =3, >3, >=3, <3 or <=3"};
  }
  count.number = *number;
  const std::uint64_t least = count.test == Test::less ? 2 : count.test == Test::more || count.test == Test::at_least ? 0 : 1;
  if (count.number < least) {
    return base::Error{.found = fmt::format("found count {}", base::without_blanks(text)),
                       .expected = fmt::format("{} or more: the first time has number 1", least)};
  }
  return count;
}

int Breakpoints::add(Breakpoint breakpoint) {
  breakpoint.number = ++last_number_;
  all_.push_back(std::move(breakpoint));
  return last_number_;
}

bool Breakpoints::remove(int number) {
  return std::erase_if(all_, [number](const Breakpoint& each) { return each.number == number; }) != 0;
}

bool Breakpoints::move(int number, std::uint32_t to) {
  const auto found = std::find_if(all_.begin(), all_.end(), [number](const Breakpoint& each) { return each.number == number; });
  if (found == all_.end()) return false;
  found->first = found->last = to;
  return true;
}

void Breakpoints::reset_counts() {
  for (Breakpoint& each : all_) {
    each.passed = 0;
    each.was_true = false;
  }
}

bool Breakpoints::has_conditions() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Breakpoint& each) { return each.kind == Breakpoint::Kind::condition; });
}

void Breakpoints::mark(Probe& probe, bool stops_only) const {
  probe.clear_marks();
  for (const Breakpoint& each : all_) {
    if (stops_only && !each.log.empty()) continue;
    switch (each.kind) {
      case Breakpoint::Kind::execution:
      case Breakpoint::Kind::memory:
        for (std::uint32_t at = each.first; at <= each.last; ++at) probe.mark(at, each.access);
        break;
      case Breakpoint::Kind::port: probe.mark_port(each.first, each.access); break;
      case Breakpoint::Kind::interrupt: probe.mark_interrupts(); break;
      case Breakpoint::Kind::condition: break;
    }
  }
}

// Counts a breakpoint that was reached. False: its condition or count does not hold, or it only prints.
bool Breakpoints::stops(Breakpoint& breakpoint, const Condition& holds, const Log& log) {
  if (breakpoint.kind != Breakpoint::Kind::condition && !breakpoint.condition.empty() && !holds(breakpoint.condition))
    return false;
  if (!breakpoint.count.holds(++breakpoint.passed)) return false;
  if (breakpoint.log.empty()) return true;
  log(breakpoint.log);
  return false;
}

namespace {

// Whether an event matches a breakpoint of any kind except conditions.
bool matches(const Breakpoint& breakpoint, const Probe::Event& event) {
  const auto [kind, access] = [&event]() -> std::pair<Breakpoint::Kind, std::uint8_t> {
    switch (event.kind) {
      case Probe::Kind::execution: return {Breakpoint::Kind::execution, Probe::executed};
      case Probe::Kind::read: return {Breakpoint::Kind::memory, Probe::is_read};
      case Probe::Kind::write:
      case Probe::Kind::break_write:
      case Probe::Kind::interrupt_write: return {Breakpoint::Kind::memory, Probe::is_written};
      case Probe::Kind::port_read: return {Breakpoint::Kind::port, Probe::is_read};
      case Probe::Kind::port_write: return {Breakpoint::Kind::port, Probe::is_written | Probe::executed};
      case Probe::Kind::condition:
      case Probe::Kind::interrupt: break;
    }
    return {Breakpoint::Kind::interrupt, Probe::executed};
  }();
  if (breakpoint.kind != kind || (breakpoint.access & access) == 0) return false;
  if (kind != Breakpoint::Kind::interrupt && (event.address < breakpoint.first || event.address > breakpoint.last)) return false;
  return !breakpoint.value || *breakpoint.value == event.value;
}

}  // namespace

bool Breakpoints::wants(const Probe::Event& event) const {
  return event.kind == Probe::Kind::condition ||
         std::any_of(all_.begin(), all_.end(), [&event](const Breakpoint& each) { return matches(each, event); });
}

std::optional<Breakpoints::Hit> Breakpoints::find_hit(const std::vector<Probe::Event>& events, const Condition& holds,
                                                   const Log& log) {
  std::optional<Hit> hit;
  for (const Probe::Event& event : events) {
    if (event.kind == Probe::Kind::condition) continue;
    for (Breakpoint& each : all_)
      if (matches(each, event) && stops(each, holds, log) && !hit) hit = {each, event};
  }
  return hit;
}

std::optional<Breakpoints::Hit> Breakpoints::find_true_condition(const Condition& holds, const Log& log) {
  std::optional<Hit> hit;
  for (Breakpoint& each : all_) {
    if (each.kind != Breakpoint::Kind::condition) continue;
    const bool is_true = holds(each.condition);
    const bool became = is_true && !each.was_true;
    each.was_true = is_true;
    if (became && stops(each, holds, log) && !hit) hit = {each, std::nullopt};
  }
  return hit;
}

}  // namespace sightline::live
