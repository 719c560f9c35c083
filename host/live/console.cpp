#include "host/live/console.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <memory>
#include <thread>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/terminal.hpp"
#include "host/live/idle_loop.hpp"

namespace sightline::live {

namespace {

using machines::Arguments;
using machines::Limits;
using machines::Machine;
using base::Result;
using machines::Stop;

// The program and its console exchange characters at the ends of slices of emulated time. A slice is a fifth of the time of a
// teletype's character: too short for a program to notice, and long enough to take no measurable time.
constexpr std::int64_t slices_a_second = 50;
// How long the host waits for a pipe when the program polls but does not wait.
constexpr int longest_silence = 1000;  // ms
// The longest delay of a busy host that the machine catches up with.
constexpr std::chrono::milliseconds most_behind{500};

constexpr char ctrl_e = 5, ctrl_s = 19;
constexpr std::string_view mode_names = "ascii, parity, unix or upper";

std::optional<KeyCodes> codes_named(std::string_view name) {
  if (name == "ascii") return KeyCodes::ascii;
  if (name == "parity") return KeyCodes::parity;
  if (name == "unix") return KeyCodes::unix;
  if (name == "upper") return KeyCodes::upper;
  return std::nullopt;
}

// Converts a text to keys: the end of a line is the RETURN key.
std::string keys_of(std::string_view text, bool& after_return) {
  std::string keys;
  for (const char c : text) {
    const bool second_half = c == '\n' && after_return;
    after_return = c == '\r';
    if (!second_half) keys.push_back(c == '\n' ? '\r' : c);
  }
  return keys;
}

std::string quote(std::string_view text) {
  std::string shown = "\"";
  for (const char c : text) {
    if (c == '\r') {
      shown += "\\r";
    } else if (c == '\n') {
      shown += "\\n";
    } else if (c == '\t') {
      shown += "\\t";
    } else if (c == '\\' || c == '"') {
      shown += std::string("\\") + c;
    } else if (c < ' ') {
      shown += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    } else {
      shown.push_back(c);
    }
  }
  return shown + '"';
}

// --- One session ---

// Types keys, passes on what is printed, and executes the script.
class Session {
 public:
  Session(Machine& machine, const ConsoleOptions& options, Operator& person)
      : machine_(machine), options_(options), person_(person) {
    scripted_ = !options.script.empty();
    steps_.assign(options.script.begin(), options.script.end());
    search_output({});
  }

  // Passes on what the program has printed; false: nobody reads it.
  [[nodiscard]] bool pass_on_printed() {
    const std::string text = shown_text(machine_.take_printed());
    if (text.empty()) return true;
    idle_loop_.forget();
    if (scripted_) search_output(text);
    return person_.print(text);
  }

  // Waits up to `milliseconds` for keys from the person.
  [[nodiscard]] std::optional<Stop> listen(int milliseconds) {
    if (scripted_ || ended_) {
      // Nobody types, but the machine must not run ahead of its speed.
      if (milliseconds > 0) std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      return std::nullopt;
    }
    const auto text = person_.keys(milliseconds);
    ended_ = !text;
    if (!person_.at_terminal()) {
      for (const char key : keys_of(text.value_or(""), after_return_)) keys_.push_back(key);
      silence_ = keys_.empty() ? silence_ + milliseconds : 0;
      return std::nullopt;
    }
    if (!text) return Stop{end_of_input, {}};
    const std::size_t end = text->find(ctrl_e);
    if (!text->empty()) idle_loop_.forget();
    for (const char key : text->substr(0, end)) machine_.type(code_of_key(options_.codes, key));
    return end == std::string::npos ? std::nullopt : std::optional(Stop{stopped_by_ctrl_e, {}});
  }

  // Types the next key if the program asks for one.
  void type() {
    if (keys_.empty()) return;
    // A program that prints does not ask for ^S.
    const bool pauses = keys_.front() == ctrl_s && machine_.pauses_at_key();
    if (!pauses && !machine_.wants_key()) return;
    machine_.type(code_of_key(options_.codes, keys_.front()));
    keys_.pop_front();
    idle_loop_.forget();
    silence_ = 0;
    if (!keys_.empty()) return;
    expected_since_ = machine_.ticks();
    send_next();
    if (scripted_) search_output({});
  }

  // Runs on while it is examined whether the program only waits. For a pipe this comes before its next key is typed, so that
  // the time does not depend on when the pipe has the key.
  [[nodiscard]] std::optional<Stop> look(const Limits& limits) {
    const bool of_interest = scripted_ ? keys_.empty() : ended_ || !options_.speed;
    return of_interest ? idle_loop_.look(limits) : std::nullopt;
  }

  // Ends the run if no more keys will come and the program does nothing but wait for one, or if a text has not been printed in
  // its time.
  [[nodiscard]] std::optional<Stop> end_of_waiting() {
    if (scripted_ && !steps_.empty() && steps_.front().within && keys_.empty()) {
      const double seconds = static_cast<double>(machine_.ticks() - expected_since_) / static_cast<double>(machine_.ticks_per_second());
      if (seconds >= *steps_.front().within) {
        return Stop{end_of_input, missing(fmt::format("--within {:g} is over", *steps_.front().within))};
      }
    }
    if (!(scripted_ || ended_) || !keys_.empty() || !idle_loop_.waits_in_vain()) return std::nullopt;
    return Stop{end_of_input, steps_.empty() ? std::string() : missing("the program waits for a key")};
  }

  // Whether emulated time stops until the input has a key, because the program waits for one, or because a pipe may be about
  // to have the key for which it polls.
  [[nodiscard]] bool must_wait_for_input() const {
    if (scripted_ || ended_ || !keys_.empty() || !machine_.wants_key()) return false;
    if (machine_.waits_for_key()) return true;
    if (options_.speed) return false;
    return idle_loop_.idles() || (!person_.at_terminal() && silence_ < longest_silence);
  }

  [[nodiscard]] bool script_done() const { return done_; }
  // The step of the script that was not reached before the run ended, as a complaint; empty: none.
  [[nodiscard]] std::string missing(std::string_view why) const {
    const std::string left(keys_.begin(), keys_.end());
    if (scripted_ && !left.empty()) return not_typed(left, why);
    if (steps_.empty()) return {};
    if (steps_.front().kind == Step::Kind::send) return not_typed(steps_.front().text, why);
    constexpr std::size_t most_shown = 60;
    const std::string_view last =
        std::string_view(printed_).substr(printed_.size() - std::min(printed_.size(), most_shown));
    return fmt::format("--expect {}: {}, and the text was not printed; printed since the last match: {}{}",
                       quote(steps_.front().text), why, printed_.size() > most_shown ? "..." : "", quote(last));
  }

 private:
  [[nodiscard]] static std::string not_typed(std::string_view text, std::string_view why) {
    return fmt::format("--send {}: {} before it was typed", quote(text), why);
  }

  // Text that is printed while keys are still being typed counts for the text that is expected after them.
  void search_output(std::string_view text) {
    printed_ += text;
    send_next();
    while (keys_.empty() && !steps_.empty()) {
      const std::size_t found = printed_.find(steps_.front().text);
      if (found == std::string::npos) break;
      printed_.erase(0, found + steps_.front().text.size());
      steps_.pop_front();
      done_ = steps_.empty();
      expected_since_ = machine_.ticks();
      send_next();
    }
    constexpr std::size_t most_kept = std::size_t{1} << 20;
    if (printed_.size() > most_kept) printed_.erase(0, printed_.size() - most_kept / 2);
  }
  void send_next() {
    while (!steps_.empty() && steps_.front().kind == Step::Kind::send) {
      for (const char key : steps_.front().text) keys_.push_back(key);
      steps_.pop_front();
    }
  }

  Machine& machine_;
  const ConsoleOptions& options_;
  Operator& person_;
  std::deque<Step> steps_;
  std::string printed_;    // for a script: everything since the last text that was found
  std::deque<char> keys_;  // to be typed when the program asks
  IdleLoop idle_loop_{machine_};
  std::int64_t expected_since_ = machine_.ticks();  // the text of the first step: since the text or the keys before it
  int silence_ = 0;  // for how long the host has waited for a pipe, ms, since its last key
  bool scripted_ = false;
  bool after_return_ = false;
  bool ended_ = false;
  bool done_ = false;
};

// Compares emulated time with host time.
class Pace {
 public:
  Pace(const Machine& machine, std::optional<double> speed) : machine_(machine), speed_(speed) { begin(); }

  // The number of milliseconds by which the machine is ahead.
  [[nodiscard]] int ahead() {
    if (!speed_) return 0;
    const double emulated =
        static_cast<double>(machine_.ticks() - ticks_) / static_cast<double>(machine_.ticks_per_second()) / *speed_;
    const auto due = since_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                  std::chrono::duration<double>(emulated));
    const auto now = std::chrono::steady_clock::now();
    if (now - due > most_behind) begin();
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - now).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, 1000));
  }
  void begin() {
    since_ = std::chrono::steady_clock::now();
    ticks_ = machine_.ticks();
  }

 private:
  const Machine& machine_;
  std::optional<double> speed_;
  std::chrono::steady_clock::time_point since_;
  std::int64_t ticks_ = 0;
};

class StandardOperator final : public Operator {
 public:
  StandardOperator(int output, bool terminal) : output_(output), terminal_(terminal) {}
  std::optional<std::string> keys(int milliseconds) override { return base::read_stdin_within(milliseconds); }
  bool print(std::string_view text) override { return base::write_now(output_, text); }
  bool at_terminal() const override { return terminal_; }

 private:
  int output_;
  bool terminal_;
};

Stop finish(Machine& machine, Stop stop) {
  machine.finish();
  return stop;
}

}  // namespace

Result<std::string> plain_text(std::string_view option, std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      plain.push_back(text[i]);
      continue;
    }
    const std::string_view rest = text.substr(i + 1);
    const auto numbered = [&](std::size_t first, std::size_t digits, int radix) -> bool {
      const auto code = base::unsigned_number(rest.substr(std::min(first, rest.size()), digits), radix);
      if (!code || *code > 0xFF || rest.size() < first + digits) return false;
      plain.push_back(static_cast<char>(*code));
      i += first + digits;
      return true;
    };
    constexpr std::string_view letters = "rnte\\";
    constexpr std::string_view meanings = "\r\n\t\033\\";
    const std::size_t letter = rest.empty() ? std::string_view::npos : letters.find(rest.front());
    if (letter != std::string_view::npos) {
      plain.push_back(meanings[letter]);
      ++i;
    } else if (!(rest.starts_with('x') ? numbered(1, 2, 16) : numbered(0, 3, 8))) {
      return base::usage_error(fmt::format("{}: found \"\\{}\", expected \\r \\n \\t \\e \\\\, \\NNN in octal or \\xHH", option,
                               rest.substr(0, 3)));
    }
  }
  return plain;
}

Result<ConsoleOptions> console_options(const Arguments& arguments, bool terminal) {
  ConsoleOptions options;
  const std::string& mode = arguments.text("--console");
  const auto codes = codes_named(mode);
  if (!codes) {
    return base::usage_error(fmt::format("--console: found \"{}\", expected {}; a file for what is printed is named by "
                             "--console-out on the 8080, by --teletype on the PDP-7",
                             mode, mode_names));
  }
  options.codes = *codes;
  for (const Arguments::Step& step : arguments.steps()) {
    if (step.option == "--within") {
      if (options.script.empty() || options.script.back().kind != Step::Kind::expect || options.script.back().within)
        return base::usage_error("--within " + step.text + ": found no --expect before it, expected the one that it limits");
      const auto seconds = base::fixed_number(step.text, 0, 1e9);
      if (!seconds) return base::usage_error(fmt::format("--within: found \"{}\", expected seconds of emulated time, such as 90 or 0.5", step.text));
      options.script.back().within = *seconds;
      continue;
    }
    const auto plain = plain_text(step.option, step.text);
    if (!plain) return plain.error();
    options.script.push_back({step.option == "--expect" ? Step::Kind::expect : Step::Kind::send, *plain});
  }
  const std::string& speed = arguments.text("--speed");
  if (speed.empty()) {
    if (terminal && options.script.empty()) options.speed = 1.0;
  } else if (speed == "real") {
    options.speed = 1.0;
  } else if (speed != "max") {
    char* end = nullptr;
    const double times = std::strtod(speed.c_str(), &end);
    if (end != speed.c_str() + speed.size() || !std::isfinite(times) || times < 0.001 || times > 1000)
      return base::usage_error(fmt::format("--speed: found \"{}\", expected real, max or a number from 0.001 to 1000", speed));
    options.speed = times;
  }
  return options;
}

std::unique_ptr<Operator> standard_operator(int output_descriptor, bool terminal) {
  return std::make_unique<StandardOperator>(output_descriptor, terminal);
}

Stop run_console(Machine& machine, const Limits& limits, const ConsoleOptions& options, Operator& person) {
  Session session(machine, options, person);
  Pace pace(machine, options.speed);
  const std::int64_t slice = std::max<std::int64_t>(1, machine.ticks_per_second() / slices_a_second);
  std::optional<Stop> stop;
  const auto next_slice = [&] {
    Limits part = limits;
    if (limits.until - machine.ticks() > slice) part.until = machine.ticks() + slice;
    return part;
  };
  const auto only_slice_over = [&limits](const std::optional<Stop>& why, const Limits& part) {
    return why && why->at_until && part.until < limits.until;
  };
  while (!stop) {
    const Limits part = next_slice();
    // At the limit of the run the machine itself says so.
    const auto runs_on = [&] {
      return !stop && !machine.waits_for_key() && (machine.ticks() < part.until || part.until == limits.until);
    };
    while (runs_on()) {
      stop = session.look(part);
      if (runs_on()) stop = machine.run(part, false);
    }
    if (only_slice_over(stop, part)) stop.reset();
    if (!stop) {
      const Limits next = next_slice();
      stop = session.look(next);
      if (only_slice_over(stop, next)) stop.reset();
    }
    if (!session.pass_on_printed() && !stop) stop = Stop{machines::interrupted, {}};
    if (stop) break;
    if (session.script_done()) return finish(machine, {end_of_input, {}});
    // Waits in short intervals, because a signal that arrives just before a wait does not end it.
    constexpr int turn = 200;
    const bool waits = session.must_wait_for_input();
    do {
      stop = session.listen(waits ? turn : pace.ahead());
      if (base::EndSignals::received() != 0) return finish(machine, {stopped_by_signal, {}});
    } while (!stop && session.must_wait_for_input());
    if (waits) pace.begin();
    session.type();
    if (!stop) stop = session.end_of_waiting();
  }
  if (stop->name == stopped_by_ctrl_e) return finish(machine, *stop);
  if (stop->complaint.empty()) stop->complaint = session.missing("the run ended");
  return finish(machine, *stop);
}

}  // namespace sightline::live
