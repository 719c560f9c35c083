// See dap.hpp.
#include "host/live/dap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <span>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live {

namespace {

using base::Json;
using guests::run::Machine;
using guests::run::Probe;

// --- Messages on the wire ---

// Content-Length: N, an empty line, N bytes of JSON.
class Framing {
 public:
  void take(std::string_view bytes) { buffer_ += bytes; }
  // The next whole message; nullopt: more is needed.
  [[nodiscard]] base::Result<std::optional<Json>> next() {
    constexpr std::string_view blank_line = "\r\n\r\n";
    constexpr std::size_t longest_header = 4096;
    const std::size_t end = buffer_.find(blank_line);
    if (end == std::string::npos) {
      if (buffer_.size() <= longest_header) return std::optional<Json>();
      return base::fail(fmt::format("found {} bytes without an empty line, expected headers of at most {}", buffer_.size(),
                                    longest_header));
    }
    std::optional<std::uint64_t> length;
    std::string_view headers = std::string_view(buffer_).substr(0, end);
    while (!headers.empty()) {
      const std::string_view line = base::take_line(headers);
      const std::size_t colon = line.find(':');
      if (base::lower_case(line.substr(0, colon)) == "content-length" && colon != std::string_view::npos)
        length = base::count_number(base::without_blanks(line.substr(colon + 1)));
    }
    constexpr std::uint64_t longest = 16U << 20;
    if (!length || *length > longest)
      return base::fail(fmt::format("found no Content-Length, or one that is no number of at most {}, expected one in the headers of "
                                    "a message", longest));
    const std::size_t begin = end + blank_line.size();
    if (buffer_.size() - begin < *length) return std::optional<Json>();
    auto json = base::parse_json(std::string_view(buffer_).substr(begin, *length), "message");
    buffer_.erase(0, begin + *length);
    if (!json) return json.error();
    if (!json->is_object()) return base::fail("found " + describe(*json) + ", expected an object as a message");
    return std::optional<Json>(std::move(*json));
  }

 private:
  std::string buffer_;
};

// --- What is in a message ---

const Json& member(const Json& object, std::string_view name) {
  static const Json nothing;
  const Json* const found = object.is_object() ? object.find(name) : nullptr;
  return found == nullptr ? nothing : *found;
}
std::string text_in(const Json& object, std::string_view name) {
  const std::string* const text = member(object, name).text();
  return text == nullptr ? std::string() : *text;
}
std::int64_t integer_in(const Json& object, std::string_view name, std::int64_t otherwise) {
  return member(object, name).integer().value_or(otherwise);
}
bool flag_in(const Json& object, std::string_view name) {
  return member(object, name).boolean().value_or(false);
}

constexpr std::string_view digits64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t n = 0; n < 3; ++n) group = group << 8 | (n < count ? bytes[at + n] : 0U);
    for (std::size_t n = 0; n < 4; ++n) text += n <= count ? digits64[group >> (18 - 6 * n) & 63U] : '=';
  }
  return text;
}
// nullopt: not base64.
std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  if (text.size() % 4 != 0) return std::nullopt;
  while (text.ends_with('=')) text.remove_suffix(1);
  std::uint32_t group = 0;
  unsigned bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits64.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(group >> bits));
  }
  return bytes;
}

// A request that cannot be done; the text is for the person at the editor.
struct Refused {
  std::string text;
};

template <class T>
T accepted(base::Result<T> result) {
  if (!result) throw Refused{result.error().message()};
  return std::move(*result);
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return a == b || std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
}

// --- The adapter ---

class Adapter {
 public:
  explicit Adapter(const DapHost& host) : host_(host) {}

  base::Result<base::Done> serve() {
    while (!over_) {
      if (const auto done = listen(queue_.empty() && !running_ ? -1 : 0); !done) return done.error();
      while (!queue_.empty() && !over_) {
        const Json message = std::move(queue_.front());
        queue_.pop_front();
        obey(message);
      }
      if (running_ && !over_) run();
    }
    try {
      finish();
    } catch (const Refused& refused) {
      return base::fail(refused.text);
    }
    if (broken_) return *broken_;
    return base::Done{};
  }

 private:
  struct Command {
    std::string_view name;
    bool needs_machine;
    Json (Adapter::*work)(const Json& arguments);
  };
  static std::span<const Command> commands();

  // What the client has sent goes to the queue.
  base::Result<base::Done> listen(int milliseconds) {
    const auto bytes = host_.read(milliseconds);
    if (!bytes) over_ = queue_.empty();
    framing_.take(bytes.value_or(""));
    while (true) {
      auto message = framing_.next();
      if (!message) return message.error();
      if (!*message) return base::Done{};
      queue_.push_back(std::move(**message));
    }
  }
  // Asked while the machine runs.
  bool message_waits() {
    if (!over_ && !broken_) {
      if (const auto done = listen(0); !done) broken_ = done.error();
    }
    if (over_ || broken_) return true;
    // A step over or out of a subroutine would not find back to its end: only what ends it comes before that.
    if (action_ == Action::go_on) return !queue_.empty();
    return std::any_of(queue_.begin(), queue_.end(), [](const Json& message) {
      const std::string command = text_in(message, "command");
      return command == "pause" || command == "disconnect" || command == "terminate";
    });
  }

  void send(Json message) {
    Json all{{"seq", ++sent_}};
    all.update(message);
    const std::string text = all.dump();
    if (!host_.write(fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text))) over_ = true;
  }
  void event(std::string_view name, Json body) { send(Json{{"type", "event"}, {"event", name}, {"body", std::move(body)}}); }
  void output(std::string_view category, std::string_view text) {
    if (!text.empty()) event("output", Json{{"category", category}, {"output", text}});
  }
  void stopped(std::string_view reason, const std::string& description, std::optional<int> breakpoint = std::nullopt) {
    Json body{{"reason", reason}, {"threadId", 1}, {"allThreadsStopped", true}};
    if (!description.empty()) body["description"] = body["text"] = description;
    if (breakpoint) body["hitBreakpointIds"] = Json::array({Json(*breakpoint)});
    event("stopped", std::move(body));
  }

  void obey(const Json& message) {
    if (text_in(message, "type") != "request") return;
    const std::string name = text_in(message, "command");
    Json answer{{"type", "response"}, {"request_seq", integer_in(message, "seq", 0)}, {"success", true}, {"command", name}};
    const auto known = std::find_if(commands().begin(), commands().end(), [&name](const Command& each) { return each.name == name; });
    try {
      if (known == commands().end()) throw Refused{fmt::format("found the request \"{}\", which this adapter does not know", name)};
      if (known->needs_machine && !debugger_) throw Refused{fmt::format("found {} before launch, expected launch first", name)};
      Json body = (this->*known->work)(member(message, "arguments"));
      if (!body.is_null()) answer["body"] = std::move(body);
    } catch (const Refused& refused) {
      answer["success"] = false;
      answer["message"] = refused.text;
    }
    send(std::move(answer));
    for (auto& each : std::exchange(afterwards_, {})) each();
  }

  // --- Beginning and end ---

  Json initialize(const Json& arguments) {
    if (member(arguments, "linesStartAt1").boolean() == false) first_line_ = 0;
    if (member(arguments, "columnsStartAt1").boolean() == false) first_column_ = 0;
    Json can = Json::object();
    for (const char* const each :
         {"supportsConfigurationDoneRequest", "supportsConditionalBreakpoints", "supportsHitConditionalBreakpoints",
          "supportsFunctionBreakpoints", "supportsInstructionBreakpoints", "supportsDataBreakpoints", "supportsStepBack",
          "supportsEvaluateForHovers", "supportsSetVariable", "supportsReadMemoryRequest", "supportsWriteMemoryRequest",
          "supportsDisassembleRequest", "supportsSteppingGranularity", "supportsTerminateRequest", "supportsSetExpression",
          "supportsCompletionsRequest", "supportsRestartRequest"})
      can[each] = true;
    hears_invalidated_ = flag_in(arguments, "supportsInvalidatedEvent");
    hears_memory_ = flag_in(arguments, "supportsMemoryEvent");
    return can;
  }
  Json launch(const Json& arguments) {
    if (launched_) throw Refused{"found a second launch, expected one in a session"};
    begin(accepted(host_.launch(arguments)), arguments);
    afterwards_.push_back([this] { event("initialized", Json::object()); });
    return {};
  }
  void begin(Launched launched, const Json& arguments) {
    monitor_.reset();
    debugger_.reset();
    launched_.emplace(std::move(launched));
    launch_arguments_ = arguments;
    finished_ = false;
    RunHost run;
    run.run = [this](Machine& machine, const guests::run::Limits& limits, const auto& heard) {
      std::optional<guests::run::Stop> stop;
      while (!stop) {
        stop = machine.run(limits, true);
        const std::string text = shown_text(machine.take_printed());
        heard(text);
        output("stdout", text);
        if (!stop && message_waits()) stop = guests::run::Stop{guests::run::interrupted, {}};
        if (!stop && machine.waits_for_key()) stop = guests::run::Stop{end_of_input, {}};
      }
      return *stop;
    };
    run.interrupted = [this] { return message_waits(); };
    run.print = [this](std::string_view text) { output("stdout", text); };
    MonitorHost commands = host_.commands;
    debugger_.emplace(*launched_->description, *launched_->prepared.machine, launched_->prepared.limits,
                      std::move(launched_->symbols), std::move(run));
    if (launched_->radix != 0) debugger_->set_radix(launched_->radix);
    debugger_->set_dialect(launched_->dialect);
    if (launched_->keys) debugger_->set_key_codes(*launched_->keys);
    monitor_.emplace(*debugger_, std::move(commands));
    for (const std::string& warning : launched_->warnings) output("console", warning + "\n");
    debugger_->send(text_in(arguments, "input"));
    stop_on_entry_ = flag_in(arguments, "stopOnEntry");
  }
  void set_off() {
    if (stop_on_entry_) {
      stopped("entry", {});
    } else {
      begin_running(Action::go_on);
    }
  }
  Json configuration_done(const Json&) {
    afterwards_.push_back([this] { set_off(); });
    return {};
  }
  // A new machine, its sources read again. Breakpoints stay: the client does not send them again.
  Json restart(const Json& arguments) {
    const Json& changed = member(arguments, "arguments");
    const Json wanted = changed.is_object() ? changed : launch_arguments_;
    running_ = false;
    finish();
    finished_ = false;  // until there is another
    Launched launched = accepted(host_.launch(wanted));
    Breakpoints kept = debugger_->breakpoints();
    begin(std::move(launched), wanted);
    kept.forget_passes();
    debugger_->breakpoints() = std::move(kept);
    find_places_again();
    afterwards_.push_back([this] { set_off(); });
    return {};
  }
  Json disconnect(const Json&) {
    over_ = true;
    finish();
    return {};
  }
  // Once for a machine; also where the client just goes away.
  void finish() {
    if (!launched_ || !host_.finish || std::exchange(finished_, true)) return;
    const auto done = host_.finish(*launched_->prepared.machine);
    if (!done) throw Refused{done.error().message()};
  }
  Json terminate(const Json&) {
    running_ = false;
    afterwards_.push_back([this] { event("terminated", Json::object()); });
    return {};
  }

  // --- Breakpoints ---

  void forget(std::vector<int>& numbers) {
    for (const int number : std::exchange(numbers, {})) {
      static_cast<void>(debugger_->breakpoints().remove(number));
      wanted_.erase(number);
    }
  }
  // With the condition and the count of the request; the answer has its number.
  Json add(Breakpoint breakpoint, const Json& request, std::vector<int>& numbers) {
    const std::string condition = text_in(request, "condition");
    const std::string count = text_in(request, "hitCondition");
    if (!condition.empty()) {
      const auto value = debugger_->evaluate(condition);
      if (!value) return Json{{"verified", false}, {"message", value.error().message()}};
      breakpoint.condition = condition;
    }
    if (!count.empty()) {
      const auto number = base::count_number(count);
      if (!number || *number == 0) return Json{{"verified", false}, {"message", "expected a count, decimal"}};
      breakpoint.count = *number;
    }
    const int number = debugger_->breakpoints().add(std::move(breakpoint));
    numbers.push_back(number);
    return Json{{"id", number}, {"verified", true}};
  }
  // One for each element of `list`: `make` throws Refused where there is none to be.
  template <class Make>
  Json set_all(const Json& list, std::vector<int>& numbers, Make make) {
    forget(numbers);
    Json answers = Json::array();
    for (const Json& each : list.elements()) {
      try {
        answers.push_back(make(each));
      } catch (const Refused& refused) {
        answers.push_back(Json{{"verified", false}, {"message", refused.text}});
      }
    }
    return Json{{"breakpoints", std::move(answers)}};
  }
  // Where a breakpoint of a source or a function was asked for.
  struct Wanted {
    std::string file;
    std::int64_t line = 0;  // from 1
    std::string name;       // of a function; then there is no file
  };
  struct Found {
    std::uint32_t at = 0;
    std::int64_t line = 0;  // from 1
  };
  // The first line from there on that makes a word, or the value of the name.
  [[nodiscard]] Found place_for(const Wanted& wanted) const {
    if (!wanted.name.empty()) return {accepted(debugger_->address_of(wanted.name)), 0};
    const std::map<Symbols::Place, std::uint32_t>& lines = debugger_->symbols().lines();
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& known) {
      return static_cast<std::int64_t>(known.first.line) >= wanted.line && same_file(known.first.file, wanted.file);
    });
    if (found == lines.end()) throw Refused{"no word is made by this line or one that follows"};
    return {found->second, static_cast<std::int64_t>(found->first.line)};
  }
  Json add_at(const Wanted& wanted, const Json& request, std::vector<int>& numbers) {
    const Found found = place_for(wanted);
    Breakpoint breakpoint;
    breakpoint.first = breakpoint.last = found.at;
    Json answer = add(breakpoint, request, numbers);
    if (!flag_in(answer, "verified")) return answer;
    wanted_[numbers.back()] = wanted;
    tell_place(answer, found);
    return answer;
  }
  void tell_place(Json& breakpoint, const Found& found) const {
    if (found.line == 0) return;
    breakpoint["line"] = found.line - 1 + first_line_;
    breakpoint["instructionReference"] = reference(found.at);
  }
  Json set_breakpoints(const Json& arguments) {
    const std::string path = text_in(member(arguments, "source"), "path");
    std::vector<int>& numbers = of_files_[path];
    return set_all(member(arguments, "breakpoints"), numbers, [&](const Json& each) {
      return add_at({path, integer_in(each, "line", 0) + 1 - first_line_, {}}, each, numbers);
    });
  }
  Json set_function_breakpoints(const Json& arguments) {
    return set_all(member(arguments, "breakpoints"), of_functions_, [&](const Json& each) {
      const std::string name = text_in(each, "name");
      if (name.empty()) throw Refused{"found no name, expected a symbol or an expression"};
      return add_at({{}, 0, name}, each, of_functions_);
    });
  }
  // After the sources have been read again: lines and names may be elsewhere.
  void find_places_again() {
    std::erase_if(wanted_, [this](const auto& each) {
      const auto& [number, wanted] = each;
      Json breakpoint{{"id", number}, {"verified", false}};
      try {
        const Found found = place_for(wanted);
        if (!debugger_->breakpoints().move(number, found.at)) return true;
        breakpoint["verified"] = true;
        tell_place(breakpoint, found);
      } catch (const Refused& refused) {
        static_cast<void>(debugger_->breakpoints().remove(number));
        breakpoint["message"] = refused.text;
      }
      const bool lost = !flag_in(breakpoint, "verified");
      event("breakpoint", Json{{"reason", "changed"}, {"breakpoint", std::move(breakpoint)}});
      return lost;
    });
  }
  Json set_instruction_breakpoints(const Json& arguments) {
    return set_all(member(arguments, "breakpoints"), of_instructions_, [&](const Json& each) {
      Breakpoint breakpoint;
      breakpoint.first = breakpoint.last = place_of(text_in(each, "instructionReference"), integer_in(each, "offset", 0));
      return add(breakpoint, each, of_instructions_);
    });
  }
  // Registers are no places; a name or an expression is the word at its value.
  Json data_breakpoint_info(const Json& arguments) {
    const std::string name = text_in(arguments, "name");
    if (debugger_->register_named(name)) return Json{{"dataId", Json()}, {"description", "a register cannot be watched"}};
    if (debugger_->is_state(name)) return Json{{"dataId", Json()}, {"description", name + " is no word of memory"}};
    const auto at = debugger_->address_of(name);
    if (!at) return Json{{"dataId", Json()}, {"description", at.error().message()}};
    return Json{{"dataId", reference(*at)},
                {"description", fmt::format("word at {} {}", debugger_->address(*at), debugger_->symbols().near(*at))},
                {"accessTypes", Json::array({Json("read"), Json("write"), Json("readWrite")})}};
  }
  Json set_data_breakpoints(const Json& arguments) {
    return set_all(member(arguments, "breakpoints"), of_data_, [&](const Json& each) {
      const std::string access = text_in(each, "accessType");
      Breakpoint breakpoint;
      breakpoint.kind = Breakpoint::Kind::memory;
      breakpoint.first = breakpoint.last = place_of(text_in(each, "dataId"), 0);
      breakpoint.access = static_cast<std::uint8_t>(access == "read"        ? Probe::is_read
                                                    : access == "readWrite" ? Probe::is_read | Probe::is_written
                                                                            : Probe::is_written);
      return add(breakpoint, each, of_data_);
    });
  }

  // --- Running ---

  enum class Action : std::uint8_t { go_on, one, over, out };

  // An editor steps by lines in a source and by instructions in the disassembly.
  void begin_step(Action action, const Json& arguments) {
    by_lines_ = text_in(arguments, "granularity") != "instruction";
    begin_running(action);
  }
  // A line of a macro makes several instructions: to the first that is of another, or of this one from its beginning.
  Halted step() {
    const std::uint32_t begun = debugger_->pc();
    const Symbols::Place* const line = debugger_->symbols().place(begun);
    constexpr int most = 65536;
    Halted halted;
    for (int n = 0; n < most; ++n) {
      halted = action_ == Action::over ? debugger_->step_over() : debugger_->run({.instructions = 1});
      if (!by_lines_ || line == nullptr || halted.why != Halted::Why::goal || debugger_->pc() == begun) return halted;
      const Symbols::Place* const now = debugger_->symbols().place(debugger_->pc());
      if (now == nullptr || now->line != line->line || now->file != line->file) return halted;
    }
    return halted;
  }

  void begin_running(Action action) {
    running_ = true;
    action_ = action;
  }
  Json resume(const Json&) {
    begin_running(Action::go_on);
    return Json{{"allThreadsContinued", true}};
  }
  Json next(const Json& arguments) {
    begin_step(Action::over, arguments);
    return {};
  }
  Json step_in(const Json& arguments) {
    begin_step(Action::one, arguments);
    return {};
  }
  Json step_out(const Json&) {
    begin_running(Action::out);
    return {};
  }
  Json pause(const Json&) {
    if (std::exchange(running_, false)) afterwards_.push_back([this] { stopped("pause", {}); });
    return {};
  }
  Json step_back(const Json&) {
    accepted(debugger_->back(1));
    afterwards_.push_back([this] { stopped("step", {}); });
    return {};
  }
  Json reverse_continue(const Json&) {
    action_ = Action::out;  // what waits meanwhile is for the machine where it will be, but for a pause
    const auto met = accepted(debugger_->back_to_breakpoint());
    afterwards_.push_back([this, met] {
      if (!met) return stopped("pause", {});
      stopped(*met ? "breakpoint" : "entry", *met ? std::string() : std::string("the past reaches no further"));
    });
    return {};
  }

  void run() {
    Halted halted;
    switch (action_) {
      case Action::go_on: halted = debugger_->run({}); break;
      case Action::one:
      case Action::over: halted = step(); break;
      case Action::out: {
        auto out = debugger_->step_out();
        running_ = out.has_value();
        if (!out) return stopped("step", out.error().message());
        halted = std::move(*out);
        break;
      }
    }
    if (broken_) {
      over_ = true;
      return;
    }
    // A message waits: the run goes on after it, unless it says otherwise.
    if (halted.why == Halted::Why::machine && halted.stop.name == guests::run::interrupted) {
      action_ = Action::go_on;
      return;
    }
    running_ = false;
    switch (halted.why) {
      case Halted::Why::breakpoint: return stopped("breakpoint", halted.reason, halted.breakpoint);
      case Halted::Why::goal: return stopped("step", halted.reason);
      case Halted::Why::machine: break;
    }
    output("console", halted.reason + "\n");
    // The program has ended, but can still be looked at and taken back.
    stopped(halted.stop.complaint.empty() ? "pause" : "exception", halted.reason);
  }

  // --- Looking ---

  [[nodiscard]] static std::string reference(std::uint32_t at) { return fmt::format("0x{:X}", at); }
  [[nodiscard]] std::uint32_t bytes_a_word() const { return debugger_->description().word_bits > 8 ? 4 : 1; }
  // "0x40" and an offset in bytes.
  [[nodiscard]] std::uint32_t place_of(std::string_view text, std::int64_t offset) const {
    std::optional<std::uint64_t> at;
    if (text.starts_with("0x") || text.starts_with("0X")) at = base::unsigned_number(text.substr(2), 16);
    if (!at) at = base::count_number(text);
    const std::int64_t words = debugger_->machine().words();
    const std::int64_t place = at && *at < (std::uint64_t{1} << 32)
                                   ? static_cast<std::int64_t>(*at) + offset / static_cast<std::int64_t>(bytes_a_word())
                                   : -1;
    if (place < 0 || place >= words) {
      throw Refused{fmt::format("found {} and {} bytes, expected an address in {}, 0x0 to 0x{:X}", text, offset,
                                debugger_->description().memory_name, words - 1)};
    }
    return static_cast<std::uint32_t>(place);
  }

  Json threads(const Json&) {
    return Json{{"threads", Json::array({Json{{"id", 1}, {"name", debugger_->description().name}}})}};
  }
  void add_place(Json& object, std::uint32_t at) const {
    const Symbols::Place* const place = debugger_->symbols().place(at);
    object["line"] = place == nullptr ? 0 : static_cast<std::int64_t>(place->line) - 1 + first_line_;
    object["column"] = place == nullptr ? 0 : first_column_;
    if (place == nullptr) return;
    std::error_code ignored;
    const std::filesystem::path path = std::filesystem::absolute(place->file, ignored);
    object["source"] = Json{{"name", path.filename().string()}, {"path", path.string()}};
  }
  Json stack_trace(const Json& arguments) {
    const std::vector<Frame> frames = debugger_->stack();
    Json list = Json::array();
    const std::int64_t first = std::max<std::int64_t>(0, integer_in(arguments, "startFrame", 0));
    const std::int64_t levels = integer_in(arguments, "levels", 0);
    const auto all = static_cast<std::int64_t>(frames.size()) + 1;
    for (std::int64_t n = first; n < all && (levels <= 0 || n < first + levels); ++n) {
      const std::uint32_t at = n == 0 ? debugger_->pc() : frames[static_cast<std::size_t>(n - 1)].caller;
      const std::string near = debugger_->symbols().near(at);
      Json frame{{"id", n}, {"name", near.empty() ? debugger_->address(at) : near}, {"instructionPointerReference", reference(at)}};
      add_place(frame, at);
      list.push_back(std::move(frame));
    }
    return Json{{"stackFrames", std::move(list)}, {"totalFrames", all}};
  }

  enum : std::int64_t { of_registers = 1, of_conditions, of_devices, of_display };
  Json scopes(const Json&) {
    Json list = Json::array();
    const auto add = [&list](std::string_view name, std::int64_t number) {
      list.push_back(Json{{"name", name}, {"variablesReference", number}, {"expensive", false}});
    };
    add("Registers", of_registers);
    if (!debugger_->machine().conditions().empty()) add("Flags", of_conditions);
    add("Devices", of_devices);
    if (!debugger_->machine().display_lines().empty()) add("Display", of_display);
    return Json{{"scopes", std::move(list)}};
  }
  Json variables(const Json& arguments) {
    Json list = Json::array();
    const auto add = [&list](std::string_view name, std::string_view value) {
      list.push_back(Json{{"name", name}, {"value", value}, {"evaluateName", name}, {"variablesReference", 0}});
    };
    // Texts for a person; no expression gives them.
    const auto add_lines = [&list](const std::vector<guests::run::ReportLine>& lines) {
      for (const auto& line : lines)
        list.push_back(Json{{"name", line.label}, {"value", line.text}, {"variablesReference", 0}});
    };
    switch (integer_in(arguments, "variablesReference", 0)) {
      case of_registers:
        for (std::size_t n = 0; n < debugger_->description().registers.size(); ++n) {
          const std::string_view name = debugger_->description().registers[n].name;
          add(name, debugger_->register_text(n).substr(name.size() + 1));
        }
        add("time", debugger_->time_text(debugger_->machine().ticks()));
        break;
      case of_conditions:
        for (const auto& [name, holds] : debugger_->machine().conditions()) add(name, holds ? "1" : "0");
        break;
      case of_devices: add_lines(debugger_->machine().device_lines()); break;
      case of_display: add_lines(debugger_->machine().display_lines()); break;
      default: throw Refused{"found a variablesReference that no scope has"};
    }
    return Json{{"variables", std::move(list)}};
  }
  Json set_variable(const Json& arguments) {
    const std::string name = text_in(arguments, "name");
    const auto number = debugger_->register_named(name);
    if (integer_in(arguments, "variablesReference", 0) != of_registers || !number)
      throw Refused{fmt::format("found {}, expected a register", name)};
    const std::int64_t value = accepted(debugger_->evaluate(text_in(arguments, "value")));
    const auto& each = debugger_->description().registers[*number];
    if (value < 0 || value >= std::int64_t{1} << each.bits)
      throw Refused{fmt::format("found {}, expected {} of {} bits", text_in(arguments, "value"), each.what, each.bits)};
    debugger_->set(*number, static_cast<std::uint32_t>(value));
    return Json{{"value", debugger_->register_text(*number).substr(name.size() + 1)}};
  }
  // A register by its name, or a word of memory as [address].
  Json set_expression(const Json& arguments) {
    const std::string expression = text_in(arguments, "expression");
    if (debugger_->register_named(expression)) {
      Json request = arguments;
      request["name"] = expression;
      request["variablesReference"] = std::int64_t{of_registers};
      return set_variable(request);
    }
    const std::string_view place = base::without_blanks(expression);
    if (place.size() < 3 || place.front() != '[' || place.back() != ']')
      throw Refused{fmt::format("found {}, expected a register or a word as [ADDRESS]", expression)};
    const std::uint32_t at = accepted(debugger_->address_of(place.substr(1, place.size() - 2)));
    const std::int64_t value = accepted(debugger_->evaluate(text_in(arguments, "value")));
    if (value < 0 || value >= std::int64_t{1} << debugger_->description().word_bits)
      throw Refused{fmt::format("found {}, expected a word of {} bits", text_in(arguments, "value"), debugger_->description().word_bits)};
    debugger_->put(at, static_cast<std::uint32_t>(value));
    return Json{{"value", debugger_->word(static_cast<std::uint32_t>(value))}};
  }
  // Names that begin with what stands before the cursor.
  Json completions(const Json& arguments) {
    const std::string text = text_in(arguments, "text");
    const std::int64_t column = integer_in(arguments, "column", first_column_) - first_column_;
    std::string_view before = std::string_view(text).substr(0, static_cast<std::size_t>(std::clamp<std::int64_t>(
                                                                   column, 0, static_cast<std::int64_t>(text.size()))));
    const std::size_t begun = before.find_last_of(" ()[]+-*/&|!<>=~^%");
    if (begun != std::string_view::npos) before.remove_prefix(begun + 1);
    Json targets = Json::array();
    // Verbs of the monitor at the beginning of a line.
    if (begun == std::string_view::npos) {
      for (const std::string_view verb : Monitor::verbs()) {
        if (verb.starts_with(base::lower_case(before)))
          targets.push_back(Json{{"label", verb}, {"type", "keyword"}, {"length", before.size()}, {"start", column - static_cast<std::int64_t>(before.size())}});
      }
    }
    for (const std::string& name : debugger_->names()) {
      if (base::lower_case(name).starts_with(base::lower_case(before)))
        targets.push_back(Json{{"label", name}, {"length", before.size()}, {"start", column - static_cast<std::int64_t>(before.size())}});
    }
    return Json{{"targets", std::move(targets)}};
  }
  Json evaluate(const Json& arguments) {
    const std::string text = text_in(arguments, "expression");
    if (text_in(arguments, "context") == "repl") {
      std::string_view line = base::without_blanks(text);
      const bool as_command = line.starts_with(':');
      if (as_command) line.remove_prefix(1);
      if (as_command || (!debugger_->evaluate(line) && Monitor::is_command(line))) return command(line);
    }
    const std::int64_t value = accepted(debugger_->evaluate(text));
    const bool word = value >= 0 && value < std::int64_t{1} << debugger_->description().word_bits;
    std::string result = word ? debugger_->word(static_cast<std::uint32_t>(value)) : std::string();
    result += fmt::format("{}{}.", result.empty() ? "" : " = ", value);
    Json body{{"result", result}, {"variablesReference", 0}};
    if (value >= 0 && value < debugger_->machine().words()) body["memoryReference"] = reference(static_cast<std::uint32_t>(value));
    return body;
  }

  // A line of the monitor, typed at the console.
  Json command(std::string_view line) {
    const std::int64_t time = debugger_->machine().ticks();
    const std::uint64_t instructions = debugger_->machine().instructions();
    action_ = Action::out;  // what waits meanwhile is for the machine where it will be, but for a pause
    const Answer answer = monitor_->execute(line);
    action_ = Action::go_on;
    std::string text = answer.text;
    while (text.ends_with('\n')) text.pop_back();
    afterwards_.push_back([this, time, instructions, text] {
      tell_removed();
      if (!debugger_) return;
      const bool moved = debugger_->machine().ticks() != time || debugger_->machine().instructions() != instructions;
      if (moved && !running_) return stopped("step", text.substr(0, text.find('\n')));
      if (hears_invalidated_) event("invalidated", Json{{"areas", Json::array({Json("all")})}});
      if (hears_memory_) {
        const std::int64_t bytes = std::int64_t{debugger_->machine().words()} * bytes_a_word();
        event("memory", Json{{"memoryReference", reference(0)}, {"offset", 0}, {"count", bytes}});
      }
    });
    if (answer.kind == Answer::Kind::quit) {
      running_ = false;
      afterwards_.push_back([this] { event("terminated", Json::object()); });
    }
    if (answer.kind == Answer::Kind::wrong || answer.kind == Answer::Kind::failed) throw Refused{text};
    return Json{{"result", text}, {"variablesReference", 0}};
  }
  // Of the client's breakpoints, those that a command has removed.
  void tell_removed() {
    const auto& all = debugger_->breakpoints().all();
    const auto gone = [&](int number) {
      if (std::any_of(all.begin(), all.end(), [number](const Breakpoint& each) { return each.number == number; })) return false;
      event("breakpoint", Json{{"reason", "removed"}, {"breakpoint", Json{{"id", number}, {"verified", false}}}});
      wanted_.erase(number);
      return true;
    };
    for (auto& [path, numbers] : of_files_) std::erase_if(numbers, gone);
    for (std::vector<int>* const numbers : {&of_functions_, &of_instructions_, &of_data_}) std::erase_if(*numbers, gone);
  }

  // --- Memory ---

  Json read_memory(const Json& arguments) {
    const std::uint32_t first = place_of(text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
    const std::uint32_t words = debugger_->machine().words() - first;
    const std::int64_t most = std::int64_t{words} * bytes_a_word();
    const std::int64_t wanted = std::max<std::int64_t>(0, integer_in(arguments, "count", 0));
    const std::int64_t count = std::min(wanted, most);
    std::vector<std::uint8_t> bytes;
    for (std::int64_t n = 0; n < count; ++n) {
      const std::int64_t a_word = bytes_a_word();
      const std::uint32_t word = debugger_->machine().word(first + static_cast<std::uint32_t>(n / a_word));
      bytes.push_back(static_cast<std::uint8_t>(word >> (8 * (n % a_word))));
    }
    return Json{{"address", reference(first)}, {"unreadableBytes", wanted - count}, {"data", base64(bytes)}};
  }
  Json write_memory(const Json& arguments) {
    const auto bytes = bytes_of_base64(text_in(arguments, "data"));
    if (!bytes || bytes->size() % bytes_a_word() != 0)
      throw Refused{fmt::format("found data that is not base64 of whole words, expected {} bytes a word", bytes_a_word())};
    const std::uint32_t first = place_of(text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
    if (bytes->size() / bytes_a_word() > debugger_->machine().words() - first)
      throw Refused{"found more words than memory has behind that address"};
    const std::uint32_t most = (std::uint32_t{1} << debugger_->description().word_bits) - 1;
    for (std::size_t at = 0; at < bytes->size(); at += bytes_a_word()) {
      std::uint32_t word = 0;
      for (std::size_t n = bytes_a_word(); n-- > 0;) word = word << 8 | (*bytes)[at + n];
      debugger_->put(first + static_cast<std::uint32_t>(at / bytes_a_word()), word & most);
    }
    return Json{{"bytesWritten", bytes->size()}};
  }
  Json disassemble(const Json& arguments) {
    const std::int64_t begin = place_of(text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
    const std::int64_t words = debugger_->machine().words();
    constexpr std::int64_t most = 4096;
    const std::int64_t count = std::clamp<std::int64_t>(integer_in(arguments, "instructionCount", 0), 0, most);
    const std::int64_t offset = std::clamp<std::int64_t>(integer_in(arguments, "instructionOffset", 0), -most, most);
    std::vector<std::uint32_t> before;
    if (offset < 0) before = debugger_->instructions_before(static_cast<std::uint32_t>(begin), static_cast<std::size_t>(-offset));
    std::int64_t at = begin;
    for (std::int64_t n = 0; n < offset && at < words; ++n)
      at += debugger_->machine().instruction_at(static_cast<std::uint32_t>(at)).words;
    // Rows before the beginning of memory have addresses below it.
    const std::int64_t missing = offset < 0 ? -offset - static_cast<std::int64_t>(before.size()) : 0;
    Json list = Json::array();
    for (std::int64_t n = 0; n < count; ++n) {
      Json row = Json::object();
      const std::int64_t row_before = n - missing;
      if (n < missing) {
        at = -1;
      } else if (row_before < static_cast<std::int64_t>(before.size())) {
        at = before[static_cast<std::size_t>(row_before)];
      } else if (row_before == static_cast<std::int64_t>(before.size()) && offset < 0) {
        at = begin;
      }
      if (at < 0 || at >= words) {
        row = Json{{"address", fmt::format("0x{:X}", std::max<std::int64_t>(at, 0))}, {"instruction", "outside memory"}};
        row["presentationHint"] = "invalid";
        ++at;
      } else {
        const auto place = static_cast<std::uint32_t>(at);
        const auto instruction = debugger_->machine().instruction_at(place);
        std::string content;
        for (std::uint32_t m = 0; m < instruction.words && place + m < words; ++m)
          content += (m == 0 ? "" : " ") + debugger_->word(debugger_->machine().word(place + m));
        row = Json{{"address", reference(place)}, {"instructionBytes", content}, {"instruction", instruction.text}};
        const std::string near = debugger_->symbols().near(place);
        if (!near.empty()) row["symbol"] = near;
        if (const Symbols::Place* const line = debugger_->symbols().place(place)) {
          row["line"] = static_cast<std::int64_t>(line->line) - 1 + first_line_;
          std::error_code ignored;
          const std::filesystem::path path = std::filesystem::absolute(line->file, ignored);
          row["location"] = Json{{"name", path.filename().string()}, {"path", path.string()}};
        }
        at += std::max(1U, instruction.words);
      }
      list.push_back(std::move(row));
    }
    return Json{{"instructions", std::move(list)}};
  }

  const DapHost& host_;
  Framing framing_;
  std::deque<Json> queue_;
  std::vector<std::function<void()>> afterwards_;  // what follows the response
  std::int64_t sent_ = 0;
  std::int64_t first_line_ = 1;  // the number of the first line in the client's words
  std::int64_t first_column_ = 1;
  bool over_ = false;
  bool stop_on_entry_ = false;
  bool running_ = false;
  bool finished_ = false;
  Action action_ = Action::go_on;
  bool by_lines_ = false;
  std::optional<base::Error> broken_;
  std::optional<Launched> launched_;
  Json launch_arguments_;
  std::optional<Debugger> debugger_;
  std::optional<Monitor> monitor_;
  bool hears_invalidated_ = false;
  bool hears_memory_ = false;
  std::map<int, Wanted> wanted_;  // by the numbers of breakpoints
  std::map<std::string, std::vector<int>> of_files_;
  std::vector<int> of_functions_;
  std::vector<int> of_instructions_;
  std::vector<int> of_data_;
};

std::span<const Adapter::Command> Adapter::commands() {
  static constexpr std::array rows{
      Command{"initialize", false, &Adapter::initialize},
      Command{"launch", false, &Adapter::launch},
      Command{"configurationDone", true, &Adapter::configuration_done},
      Command{"restart", true, &Adapter::restart},
      Command{"disconnect", false, &Adapter::disconnect},
      Command{"terminate", false, &Adapter::terminate},
      Command{"setBreakpoints", true, &Adapter::set_breakpoints},
      Command{"setFunctionBreakpoints", true, &Adapter::set_function_breakpoints},
      Command{"setInstructionBreakpoints", true, &Adapter::set_instruction_breakpoints},
      Command{"dataBreakpointInfo", true, &Adapter::data_breakpoint_info},
      Command{"setDataBreakpoints", true, &Adapter::set_data_breakpoints},
      Command{"continue", true, &Adapter::resume},
      Command{"next", true, &Adapter::next},
      Command{"stepIn", true, &Adapter::step_in},
      Command{"stepOut", true, &Adapter::step_out},
      Command{"stepBack", true, &Adapter::step_back},
      Command{"reverseContinue", true, &Adapter::reverse_continue},
      Command{"pause", true, &Adapter::pause},
      Command{"threads", true, &Adapter::threads},
      Command{"stackTrace", true, &Adapter::stack_trace},
      Command{"scopes", true, &Adapter::scopes},
      Command{"variables", true, &Adapter::variables},
      Command{"setVariable", true, &Adapter::set_variable},
      Command{"setExpression", true, &Adapter::set_expression},
      Command{"completions", true, &Adapter::completions},
      Command{"evaluate", true, &Adapter::evaluate},
      Command{"readMemory", true, &Adapter::read_memory},
      Command{"writeMemory", true, &Adapter::write_memory},
      Command{"disassemble", true, &Adapter::disassemble},
  };
  return rows;
}

}  // namespace

base::Result<base::Done> serve_debug_adapter(const DapHost& host) {
  return Adapter(host).serve();
}

}  // namespace sightline::live
