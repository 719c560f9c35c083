#include "host/live/past.hpp"

#include <algorithm>
#include <utility>

#include "host/live/snapshot.hpp"

namespace sightline::live {

using machines::Probe;

Past::Past(std::string_view name, machines::Machine& machine)
    : name_(name), machine_(machine) {}

std::uint64_t Past::instructions_apart() const { return std::uint64_t{1} << (machine_.display_lines().empty() ? 20 : 18); }

void Past::remember() {
  constexpr std::size_t most_calls = 100'000;  // calls that read or wrote files of the host
  const std::int64_t repeats_from = machine_.trim_journal(most_calls);
  std::erase_if(places_, [repeats_from](const Place& place) { return place.ticks < repeats_from; });
  const std::uint64_t obeyed = machine_.instructions();
  const bool far = places_.empty() || obeyed - std::min(obeyed, places_.back().instructions) >= instructions_apart();
  if (!changed_ && !far) return;
  // The new snapshot replaces those at or after this instruction.
  while (!places_.empty() && places_.back().instructions >= obeyed) {
    changed_ = changed_ || places_.back().changed;
    places_.pop_back();
  }
  places_.push_back({obeyed, machine_.ticks(), machine_.probe()->keys.size(), changed_, save_snapshot(name_, machine_)});
  changed_ = false;
  thin_out();
}

void Past::thin_out() {
  constexpr std::size_t most = 512;
  if (places_.size() <= most) return;
  // Removes every other snapshot of the older half: to go back far takes longer.
  std::vector<Place> kept;
  bool left_out = false;
  for (std::size_t n = 0; n < places_.size(); ++n) {
    left_out = !left_out && n < most / 2 && n != 0 && !places_[n].changed;
    if (!left_out) kept.push_back(std::move(places_[n]));
  }
  // If all follow changes from outside, the oldest ones are removed.
  if (kept.size() > most) kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(most / 4));
  places_ = std::move(kept);
}

void Past::forget() {
  places_.clear();
  machine_.probe()->keys.clear();
  static_cast<void>(machine_.trim_journal(0));
  changed_ = true;
}

std::uint64_t Past::reach() const {
  const std::uint64_t obeyed = machine_.instructions();
  return places_.empty() ? 0 : obeyed - std::min(obeyed, places_.front().instructions);
}

std::size_t Past::segment_of(std::uint64_t instructions) const {
  const auto after = std::upper_bound(places_.begin(), places_.end(), instructions,
                                      [](std::uint64_t n, const Place& place) { return n < place.instructions; });
  return static_cast<std::size_t>(after - places_.begin()) - (after == places_.begin() ? 0 : 1);
}

Past::Boundary Past::end_of(std::size_t segment, Boundary here) const {
  if (segment + 1 == places_.size()) return here;
  return {places_[segment + 1].instructions, places_[segment + 1].ticks};
}

// A machine always accepts its own snapshot; an error would be a defect of this program, and leaves the machine unchanged.
void Past::restore(const Place& place) {
  static_cast<void>(restore_snapshot(name_, machine_, place.snapshot, "snapshot"));
  next_key_ = place.keys;
}

// Repeats a run from a restored place, or from the end of the last repetition, to `end`. Keys are typed at their times.
void Past::run_again(Boundary end, const std::function<void()>& at_event) {
  Probe& probe = *machine_.probe();
  const std::vector<Probe::Key> keys = probe.keys;
  while (machine_.instructions() < end.instructions || machine_.ticks() < end.ticks) {
    while (next_key_ < keys.size() && keys[next_key_].time <= machine_.ticks()) machine_.type(keys[next_key_++].code);
    if (machine_.waits_for_key()) break;
    machines::Limits limits;
    const bool only_time = machine_.instructions() >= end.instructions;
    limits.instructions = end.instructions + (only_time ? 1 : 0);
    if (only_time) limits.until = end.ticks;
    if (next_key_ < keys.size()) limits.until = std::min(limits.until, keys[next_key_].time);
    const auto stop = machine_.run(limits, false);
    if (stop && stop->name == machines::stopped_by_probe) {
      if (at_event) at_event();
      probe.resume();
    } else if (stop && !stop->at_until && stop->name != "instruction_limit") {
      break;
    }
  }
  // CP/M waits for keys at this boundary: the original run ended there only after it had received them.
  while (machine_.waits_for_key() && next_key_ < keys.size() && keys[next_key_].time <= machine_.ticks()) {
    machine_.type(keys[next_key_++].code);
    static_cast<void>(machine_.run({machine_.instructions()}, false));
  }
  // The host may have written memory after the last instruction; no run stops for that event, so it is reported here.
  if (!probe.events().empty() && at_event) at_event();
  probe.resume();
  static_cast<void>(machine_.take_printed());
  probe.keys = keys;
}

base::Result<base::Done> Past::go_back_to(std::uint64_t instructions) {
  const std::size_t from = segment_of(instructions);
  const auto done = restore_snapshot(name_, machine_, places_[from].snapshot, "snapshot");
  if (!done) return done;
  next_key_ = places_[from].keys;
  Probe& probe = *machine_.probe();
  const Probe kept = std::exchange(probe, probe.empty());
  probe.keys = kept.keys;
  run_again({instructions});
  probe = kept;
  probe.keys.resize(next_key_);
  while (places_.size() > from + 1) places_.pop_back();
  return base::Done{};
}

template <class Work>
void Past::look_back(Work work) {
  if (places_.empty()) return;
  Probe& probe = *machine_.probe();
  const machines::Bytes present = save_snapshot(name_, machine_);
  const Probe kept = std::exchange(probe, probe.empty());
  probe.keys = kept.keys;
  work();
  static_cast<void>(restore_snapshot(name_, machine_, present, "snapshot"));
  probe = kept;
}

base::Result<std::optional<bool>> Past::go_back_to_event(const std::function<void(Probe&)>& mark,
                                                         const std::function<bool()>& interrupted) {
  if (places_.empty()) return base::bad_input("there is no past yet");
  const Boundary now = here();
  std::optional<std::uint64_t> found;
  bool given_up = false;
  look_back([&] {
    for (std::size_t segment = places_.size(); segment-- > 0 && !found;) {
      given_up = interrupted();
      if (given_up) return;
      mark(*machine_.probe());
      restore(places_[segment]);
      run_again(end_of(segment, now), [&] {
        if (machine_.instructions() < now.instructions) found = machine_.instructions();
      });
    }
  });
  if (given_up) return std::optional<bool>();
  const auto done = go_back_to(found.value_or(places_.front().instructions));
  if (!done) return done.error();
  return std::optional<bool>(found.has_value());
}

base::Result<std::vector<Past::Cycle>> Past::go_back_into_instruction() {
  const Boundary end = here();
  const std::vector<Probe::Key> typed = machine_.probe()->keys;
  if (const auto done = go_back_to(end.instructions - 1); !done) return done.error();
  Probe& probe = *machine_.probe();
  // Types the keys of the boundary at which the instruction begins, which go_back_to() has not typed.
  for (std::size_t n = probe.keys.size(); n < typed.size() && typed[n].time <= machine_.ticks(); ++n) machine_.type(typed[n].code);
  std::vector<Cycle> cycles;
  const machines::Bytes present = save_snapshot(name_, machine_);
  const Probe kept = std::exchange(probe, probe.empty());
  probe.on_instruction = [](const Entry&) {};
  probe.on_cycle = [&cycles](const Cycle& cycle) { cycles.push_back(cycle); };
  next_key_ = kept.keys.size();
  probe.keys = kept.keys;
  run_again(end);
  static_cast<void>(restore_snapshot(name_, machine_, present, "snapshot"));
  probe = kept;
  return cycles;
}

std::vector<Past::Entry> Past::history(std::size_t n) {
  std::vector<Entry> entries;
  const Boundary now = here();
  n = static_cast<std::size_t>(std::min<std::uint64_t>({n, reach(), most_history}));
  if (n == 0) return entries;
  look_back([&] {
    Probe& probe = *machine_.probe();
    const std::uint64_t first = now.instructions - n;
    for (std::size_t segment = segment_of(first); segment < places_.size(); ++segment) {
      restore(places_[segment]);
      run_again({std::max(first, machine_.instructions())});
      probe.on_instruction = [&entries](const Entry& entry) { entries.push_back(entry); };
      run_again(end_of(segment, now));
      probe.on_instruction = nullptr;
    }
  });
  return entries;
}

std::optional<Past::Writer> Past::last_writer(std::uint32_t address, std::size_t pc_register,
                                              const std::function<bool()>& interrupted) {
  std::optional<Writer> writer;
  const Boundary now = here();
  look_back([&] {
    Probe& probe = *machine_.probe();
    for (std::size_t segment = places_.size(); segment-- > 0 && !writer && !interrupted();) {
      probe.mark(address, Probe::is_written);
      restore(places_[segment]);
      std::uint64_t obeyed = 0;
      run_again(end_of(segment, now), [&] {
        writer = Writer{probe.events().back(), 0};
        obeyed = machine_.instructions();
      });
      if (!writer) continue;
      // The event was seen at the boundary after the instruction; the write of an interrupt is between two instructions.
      probe.clear_marks();
      restore(places_[segment]);
      run_again({writer->event.kind == Probe::Kind::interrupt_write ? obeyed : obeyed - 1});
      writer->pc = machine_.get(pc_register);
    }
  });
  return writer;
}

}  // namespace sightline::live
