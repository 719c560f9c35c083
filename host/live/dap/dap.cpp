#include "host/live/dap/dap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "host/base/text.hpp"
#include "host/live/console.hpp"
#include "host/live/dap/breakpoints.hpp"
#include "host/live/dap/messages.hpp"
#include "host/live/dap/places.hpp"
#include "host/live/dap/view.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live {

namespace {

using base::Json;
using dap::flag_in;
using dap::member;
using dap::text_in;
using machines::Machine;

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
    } catch (const base::Error& refused) {
      return base::bad_input(refused.message());
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
  template <Json (dap::View::*answer)(const Json&)>
  Json with_view(const Json& arguments) {
    return (*view_.*answer)(arguments);
  }
  template <Json (dap::ClientBreakpoints::*answer)(const Json&)>
  Json with_breakpoints(const Json& arguments) {
    return (breakpoints_.*answer)(arguments);
  }

  // Puts the messages of the client into the queue.
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
  // Polled while the machine runs: whether a message must interrupt the run.
  bool message_waits() {
    if (!over_ && !broken_) {
      if (const auto done = listen(0); !done) broken_ = done.error();
    }
    if (over_ || broken_) return true;
    // An interrupted step over or out of a subroutine cannot be resumed: only messages that end it interrupt it.
    if (action_ == Action::go_on) return !queue_.empty();
    return std::any_of(queue_.begin(), queue_.end(), [](const Json& message) {
      const std::string command = text_in(message, "command");
      return command == "pause" || command == "disconnect" || command == "terminate";
    });
  }

  void send(Json message) {
    Json all{{"seq", ++sent_}};
    all.update(message);
    if (!host_.write(dap::framed(all))) over_ = true;
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
    Json answer{{"type", "response"}, {"request_seq", member(message, "seq").integer().value_or(0)}, {"success", true}, {"command", name}};
    const auto known = std::find_if(commands().begin(), commands().end(), [&name](const Command& each) { return each.name == name; });
    try {
      if (known == commands().end()) throw base::usage_error(fmt::format("found the request \"{}\", which this adapter does not know", name));
      if (known->needs_machine && !debugger_) throw base::usage_error(fmt::format("found {} before launch, expected launch first", name));
      Json body = (this->*known->work)(member(message, "arguments"));
      if (!body.is_null()) answer["body"] = std::move(body);
    } catch (const base::Error& refused) {
      answer["success"] = false;
      answer["message"] = refused.message();
    }
    send(std::move(answer));
    for (auto& each : std::exchange(afterwards_, {})) each();
  }

  // --- Beginning and end ---

  Json initialize(const Json& arguments) {
    if (member(arguments, "linesStartAt1").boolean() == false) numbering_.first_line = 0;
    if (member(arguments, "columnsStartAt1").boolean() == false) numbering_.first_column = 0;
    Json can = Json::object();
    for (const char* const each :
         {"supportsConfigurationDoneRequest", "supportsConditionalBreakpoints", "supportsHitConditionalBreakpoints",
          "supportsFunctionBreakpoints", "supportsInstructionBreakpoints", "supportsDataBreakpoints", "supportsStepBack",
          "supportsEvaluateForHovers", "supportsSetVariable", "supportsReadMemoryRequest", "supportsWriteMemoryRequest",
          "supportsDisassembleRequest", "supportsSteppingGranularity", "supportsTerminateRequest", "supportsSetExpression",
          "supportsCompletionsRequest", "supportsRestartRequest", "supportsLogPoints", "supportsGotoTargetsRequest",
          "supportsBreakpointLocationsRequest", "supportsLoadedSourcesRequest", "supportsDataBreakpointBytes"})
      can[each] = true;
    hears_invalidated_ = flag_in(arguments, "supportsInvalidatedEvent");
    hears_memory_ = flag_in(arguments, "supportsMemoryEvent");
    return can;
  }
  Json launch(const Json& arguments) {
    if (launched_) throw base::usage_error("found a second launch, expected one in a session");
    begin(base::value_of(host_.launch(arguments)), arguments);
    afterwards_.push_back([this] { event("initialized", Json::object()); });
    return {};
  }
  void begin(Launched launched, const Json& arguments) {
    view_.reset();
    monitor_.reset();
    debugger_.reset();
    launched_.emplace(std::move(launched));
    launch_arguments_ = arguments;
    finished_ = false;
    RunHost run;
    run.run = [this](Machine& machine, const machines::Limits& limits, const auto& heard) {
      std::optional<machines::Stop> stop;
      while (!stop) {
        stop = machine.run(limits, true);
        const std::string text = shown_text(machine.take_printed());
        heard(text);
        output("stdout", text);
        if (!stop && message_waits()) stop = machines::Stop{machines::interrupted, {}};
        if (!stop && machine.waits_for_key()) stop = machines::Stop{end_of_input, std::string(no_key)};
      }
      return *stop;
    };
    run.interrupted = [this] { return message_waits(); };
    run.print = [this](std::string_view text) { output("stdout", text); };
    run.log = [this](std::string_view text) { output("console", std::string(text) + "\n"); };
    MonitorHost commands = host_.commands;
    debugger_.emplace(*launched_->description, *launched_->prepared.machine, launched_->prepared.limits,
                      std::move(launched_->symbols), std::move(run));
    if (launched_->radix != 0) debugger_->set_radix(launched_->radix);
    debugger_->set_dialect(launched_->dialect);
    if (launched_->keys) debugger_->set_key_codes(*launched_->keys);
    monitor_.emplace(*debugger_, std::move(commands));
    view_.emplace(*debugger_, numbering_);
    breakpoints_.set_debugger(*debugger_);
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
  // Makes a new machine and assembles its sources again. Breakpoints are kept, because the client does not send them again.
  Json restart(const Json& arguments) {
    const Json& changed = member(arguments, "arguments");
    const Json wanted = changed.is_object() ? changed : launch_arguments_;
    running_ = false;
    finish();
    finished_ = false;  // until a new machine exists
    Launched launched = base::value_of(host_.launch(wanted));
    Breakpoints kept = debugger_->breakpoints();
    begin(std::move(launched), wanted);
    kept.reset_counts();
    debugger_->breakpoints() = std::move(kept);
    for (Json& each : breakpoints_.find_places_again()) event("breakpoint", std::move(each));
    afterwards_.push_back([this] { set_off(); });
    return {};
  }
  Json disconnect(const Json&) {
    over_ = true;
    finish();
    return {};
  }
  // Called once for a machine, also if the client disconnects without a request.
  void finish() {
    if (!launched_ || std::exchange(finished_, true)) return;
    if (monitor_) output("console", monitor_->finish().text);
    if (!host_.finish) return;
    const auto done = host_.finish(*launched_->prepared.machine);
    if (!done) throw base::usage_error(done.error().message());
  }
  Json terminate(const Json&) {
    running_ = false;
    afterwards_.push_back([this] { event("terminated", Json::object()); });
    return {};
  }

  // --- Running ---

  enum class Action : std::uint8_t { go_on, one, over, out };

  // Editors step by lines in a source and by instructions in the disassembly.
  void begin_step(Action action, const Json& arguments) {
    by_lines_ = text_in(arguments, "granularity") != "instruction";
    begin_running(action);
  }
  // A line with a macro has several instructions: steps to the first one of another line, or to the beginning of this line.
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
    base::value_of(debugger_->back(1));
    afterwards_.push_back([this] { stopped("step", {}); });
    return {};
  }
  Json reverse_continue(const Json&) {
    action_ = Action::out;  // what waits meanwhile is for the machine where it will be, but for a pause
    const auto met = base::value_of(debugger_->back_to_breakpoint());
    afterwards_.push_back([this, met] {
      if (!met) return stopped("pause", {});
      stopped(*met ? "breakpoint" : "entry", *met ? std::string() : std::string("the past reaches no further"));
    });
    return {};
  }

  // Sets PC to the address that is the number of a target.
  Json go_to(const Json& arguments) {
    if (running_) throw base::usage_error("found goto while the machine runs, expected it after a stop");
    const std::int64_t at = dap::integer_in(arguments, "targetId", -1);
    if (at < 0 || at >= debugger_->machine().words()) throw base::usage_error("found a targetId that gotoTargets has not returned");
    debugger_->set(debugger_->pc_register(), static_cast<std::uint32_t>(at));
    afterwards_.push_back([this] { stopped("goto", {}); });
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
    // Interrupted by a message: the run continues after it, unless the message stops it.
    if (halted.why == Halted::Why::machine && halted.stop.name == machines::interrupted) {
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
    // The program has ended, but can still be examined and run backwards.
    stopped(halted.stop.complaint.empty() ? "pause" : "exception", halted.reason);
  }

  // --- The console ---

  Json evaluate(const Json& arguments) {
    const std::string text = text_in(arguments, "expression");
    if (text_in(arguments, "context") == "repl") {
      std::string_view line = base::without_blanks(text);
      const bool as_command = line.starts_with(':');
      if (as_command) line.remove_prefix(1);
      if (as_command || (!debugger_->evaluate(line) && Monitor::is_command(line))) return command(line);
    }
    return view_->value_of(text);
  }

  // Executes a line of the monitor, typed at the console.
  Json command(std::string_view line) {
    const std::int64_t time = debugger_->machine().ticks();
    const std::uint64_t instructions = debugger_->machine().instructions();
    action_ = Action::out;  // what waits meanwhile is for the machine where it will be, but for a pause
    const Answer answer = monitor_->execute(line);
    action_ = Action::go_on;
    std::string text = answer.text;
    while (text.ends_with('\n')) text.pop_back();
    afterwards_.push_back([this, time, instructions, text] {
      for (Json& each : breakpoints_.forget_removed()) event("breakpoint", std::move(each));
      if (!debugger_) return;
      const bool moved = debugger_->machine().ticks() != time || debugger_->machine().instructions() != instructions;
      if (moved && !running_) return stopped("step", text.substr(0, text.find('\n')));
      if (hears_invalidated_) event("invalidated", Json{{"areas", Json::array({Json("all")})}});
      if (hears_memory_) event("memory", view_->whole_memory());
    });
    if (answer.kind == Answer::Kind::quit) {
      running_ = false;
      afterwards_.push_back([this] { event("terminated", Json::object()); });
    }
    if (answer.kind == Answer::Kind::wrong || answer.kind == Answer::Kind::failed) throw base::usage_error(text);
    return Json{{"result", text}, {"variablesReference", 0}};
  }

  const DapHost& host_;
  dap::Framing framing_;
  std::deque<Json> queue_;
  std::vector<std::function<void()>> afterwards_;  // called after the response has been sent
  std::int64_t sent_ = 0;
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
  dap::Numbering numbering_;
  dap::ClientBreakpoints breakpoints_{numbering_};
  std::optional<dap::View> view_;
  bool hears_invalidated_ = false;
  bool hears_memory_ = false;
};

std::span<const Adapter::Command> Adapter::commands() {
  static constexpr std::array rows{
      Command{"initialize", false, &Adapter::initialize},
      Command{"launch", false, &Adapter::launch},
      Command{"configurationDone", true, &Adapter::configuration_done},
      Command{"restart", true, &Adapter::restart},
      Command{"disconnect", false, &Adapter::disconnect},
      Command{"terminate", false, &Adapter::terminate},
      Command{"setBreakpoints", true, &Adapter::with_breakpoints<&dap::ClientBreakpoints::set_in_source>},
      Command{"setFunctionBreakpoints", true, &Adapter::with_breakpoints<&dap::ClientBreakpoints::set_at_functions>},
      Command{"setInstructionBreakpoints", true, &Adapter::with_breakpoints<&dap::ClientBreakpoints::set_at_instructions>},
      Command{"dataBreakpointInfo", true, &Adapter::with_breakpoints<&dap::ClientBreakpoints::data_info>},
      Command{"setDataBreakpoints", true, &Adapter::with_breakpoints<&dap::ClientBreakpoints::set_on_data>},
      Command{"continue", true, &Adapter::resume},
      Command{"next", true, &Adapter::next},
      Command{"stepIn", true, &Adapter::step_in},
      Command{"stepOut", true, &Adapter::step_out},
      Command{"stepBack", true, &Adapter::step_back},
      Command{"reverseContinue", true, &Adapter::reverse_continue},
      Command{"pause", true, &Adapter::pause},
      Command{"threads", true, &Adapter::with_view<&dap::View::threads>},
      Command{"stackTrace", true, &Adapter::with_view<&dap::View::stack_trace>},
      Command{"scopes", true, &Adapter::with_view<&dap::View::scopes>},
      Command{"variables", true, &Adapter::with_view<&dap::View::variables>},
      Command{"setVariable", true, &Adapter::with_view<&dap::View::set_variable>},
      Command{"setExpression", true, &Adapter::with_view<&dap::View::set_expression>},
      Command{"completions", true, &Adapter::with_view<&dap::View::completions>},
      Command{"evaluate", true, &Adapter::evaluate},
      Command{"readMemory", true, &Adapter::with_view<&dap::View::read_memory>},
      Command{"writeMemory", true, &Adapter::with_view<&dap::View::write_memory>},
      Command{"disassemble", true, &Adapter::with_view<&dap::View::disassemble>},
      Command{"breakpointLocations", true, &Adapter::with_view<&dap::View::breakpoint_locations>},
      Command{"loadedSources", true, &Adapter::with_view<&dap::View::loaded_sources>},
      Command{"gotoTargets", true, &Adapter::with_view<&dap::View::goto_targets>},
      Command{"goto", true, &Adapter::go_to},
  };
  return rows;
}

}  // namespace

base::Result<base::Done> serve_debug_adapter(const DapHost& host) {
  return Adapter(host).serve();
}

}  // namespace sightline::live
