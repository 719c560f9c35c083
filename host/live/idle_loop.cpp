#include "host/live/idle_loop.hpp"

#include <algorithm>
#include <cstring>
#include <span>

namespace sightline::live {

using machines::Limits;
using machines::Machine;
using machines::Stop;

namespace {

// A slow loop polls ten times a second; a program that has not polled for so long takes keys by interrupt.
constexpr std::int64_t looks_without_poll_a_second = 2;
constexpr std::int64_t shortest_gaps_a_second = 50;
constexpr std::int64_t longest_gap = 60;  // seconds
constexpr int most_states = 1024;

class ReturnsAtPolls {
 public:
  explicit ReturnsAtPolls(Machine& machine) : machine_(machine) {
    static_cast<void>(machine_.take_poll());
    machine_.return_at_polls(true);
  }
  ReturnsAtPolls(const ReturnsAtPolls&) = delete;
  ReturnsAtPolls& operator=(const ReturnsAtPolls&) = delete;
  ~ReturnsAtPolls() { machine_.return_at_polls(false); }

 private:
  Machine& machine_;
};

}  // namespace

std::optional<Stop> IdleLoop::look(const Limits& limits) {
  if (!machine_.wants_key() || machine_.waits_for_key() || machine_.ticks() < look_.next) return std::nullopt;
  const std::int64_t second = machine_.ticks_per_second();
  if (!look_.under_way) {
    look_.under_way = true;
    look_.begun = machine_.ticks();
    look_.polled = false;
    look_.unchanged = false;
    look_.remember_at = result_.found ? 2 * (look_.compared + 1) : 1;
    look_.most = std::max(look_.most, 2 * look_.remember_at);
    look_.compared = 0;
  }
  if (machine_.halted()) {
    look_.unchanged = is_as_at_last_look();
    end_look(true);  // the halt ends at a deadline
    return std::nullopt;
  }
  if (!look_.polled && machine_.ticks() - look_.begun >= second / looks_without_poll_a_second) return step(limits);
  const ReturnsAtPolls returns(machine_);
  while (machine_.wants_key() && !machine_.waits_for_key()) {
    auto stop = machine_.run(limits, false);
    if (machine_.take_poll()) {
      look_.polled = true;
      const bool back = is_back();
      if (back || look_.compared >= look_.most) {
        end_look(back);
        return stop;
      }
    }
    if (stop) return stop;
  }
  return std::nullopt;
}

// Compares the states between instructions.
std::optional<Stop> IdleLoop::step(const Limits& limits) {
  Limits one = limits;
  bool back = false;
  for (int n = 0; n < most_states && !back; ++n) {
    one.instructions = std::min(limits.instructions, machine_.instructions() + 1);
    auto stop = machine_.run(one, false);
    const bool only_step_over = stop && stop->name == "instruction_limit" && machine_.instructions() < limits.instructions;
    if (stop && !only_step_over) return stop;
    if (machine_.halted() || machine_.waits_for_key()) return std::nullopt;
    back = is_back();
  }
  end_look(back);
  return std::nullopt;
}

bool IdleLoop::waits_in_vain(std::int64_t seconds) const {
  if (waits_for_ever()) return true;
  return result_.found && machine_.wants_key() && machine_.ticks() - result_.since >= seconds * machine_.ticks_per_second();
}

bool IdleLoop::is_back() {
  look_.unchanged = look_.unchanged || is_as_at_last_look();
  const bool back = remembered_.valid && machine_.register_image() == remembered_.registers && has_same_memory() &&
                    machine_.traffic() == remembered_.traffic;
  if (!back && ++look_.compared == look_.remember_at) {
    remember();
    look_.remember_at *= 2;
  }
  return back;
}

bool IdleLoop::has_same_memory() {
  const std::span<const std::byte> now = machine_.memory_image();
  const std::span<const std::byte> then = remembered_.memory;
  if (now.size() != then.size()) return false;
  constexpr std::size_t block = 1024;
  const auto same = [&](std::size_t at) {
    return std::memcmp(now.data() + at, then.data() + at, std::min(block, now.size() - at)) == 0;
  };
  if (different_at_ < now.size() && !same(different_at_)) return false;
  for (std::size_t at = 0; at < now.size(); at += block) {
    if (same(at)) continue;
    different_at_ = at;
    return false;
  }
  return true;
}

// The word in which a clock counts by itself is left out.
bool IdleLoop::is_as_at_last_look() const {
  const std::span<const std::byte> now = machine_.memory_image();
  const std::vector<std::byte>& then = last_look_.memory;
  if (now.size() != then.size() || machine_.register_image() != last_look_.registers) return false;
  if (now.empty()) return true;  // this machine shows none
  const machines::ClockWord clock = machine_.clock_word();
  const std::size_t rest = clock.first + clock.size;
  return std::memcmp(now.data(), then.data(), clock.first) == 0 && std::memcmp(now.data() + rest, then.data() + rest, now.size() - rest) == 0;
}

void IdleLoop::remember() {
  const std::span<const std::byte> memory = machine_.memory_image();
  remembered_.registers = machine_.register_image();
  remembered_.memory.assign(memory.begin(), memory.end());
  remembered_.traffic = machine_.traffic();
  remembered_.time = machine_.ticks();
  remembered_.deadline = machine_.has_deadline();
  remembered_.valid = true;
}

void IdleLoop::end_look(bool found) {
  const std::int64_t now = machine_.ticks();
  const std::int64_t second = machine_.ticks_per_second();
  look_.under_way = false;
  if (!found) {
    look_.gap = std::clamp(4 * look_.gap, second / shortest_gaps_a_second, longest_gap * second);
    look_.most = std::min(2 * look_.most, most_states);
    look_.next = now + look_.gap;
    result_ = {};
    return;
  }
  if (!result_.found) result_ = {true, false, now};
  if (!look_.unchanged) result_.since = now;
  const std::span<const std::byte> memory = machine_.memory_image();
  last_look_.registers = machine_.register_image();
  last_look_.memory.assign(memory.begin(), memory.end());
  const bool closed = !machine_.has_deadline() && !machine_.halted();
  result_.for_ever = closed && !remembered_.deadline && now - remembered_.time >= second;
  // What a deadline that is over has changed is not in the state that is remembered.
  if (closed && remembered_.deadline) remember();
  look_.most = Look::shortest;
  look_.gap = 0;
  look_.next = now + second;
}

}  // namespace sightline::live
