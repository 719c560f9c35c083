// See i8080.hpp.
#include "host/machines/i8080.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bitset>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "emulators/core/port_device.hpp"
#include "emulators/core/state_visitor.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_front.hpp"
#include "host/base/text.hpp"
#include "host/machines/cpm.hpp"
#include "host/machines/device_option.hpp"
#include "host/machines/i8080_observers.hpp"
#include "host/machines/plotter_taker.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/png.hpp"
#include "host/picture/raster_image.hpp"
#include "tools/disasm/i8080.hpp"
#include "tools/image/binary.hpp"

namespace sightline::machines {

namespace {

// About ten milliseconds of host time: short enough for Ctrl-C, long enough to cost nothing.
constexpr core::TStates time_between_questions{1 << 25};
// Shorter at the beginning of a run, where it may access a missing device, and where every instruction is recorded, which
// takes longer.
constexpr core::TStates time_to_first_question{1 << 19};
constexpr std::size_t most_kept_of_console = std::size_t{1} << 24;
// A program that takes keys only by interrupt never polls: it gets the next key after the line has been quiet for so long.
constexpr core::Duration quiet_before_key{200'000'000};

// --- Texts ---

// Nine digits after the point, rounded down. Computed from T-states, because nanoseconds overflow after 292 years.
std::string seconds_text(core::TStateInstant t, core::ClockRate clock) {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t t_states = core::t_states_of(t);
  return fmt::format("{}.{:09}", t_states / clock.hertz, t_states % clock.hertz * second / clock.hertz);
}

// Bytes as characters of Latin-1, in UTF-8, because JSON has no bytes.
std::string as_utf8(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text.push_back(c);
    } else {
      text.push_back(static_cast<char>(0xC0U | byte >> 6));
      text.push_back(static_cast<char>(0x80U | (byte & 0x3FU)));
    }
  }
  return text;
}

// Registers B to L, numbers 2 to 7: halves of pairs.
template <class State>
auto& pair_of(State& state, std::size_t number) {
  return number < 4 ? state.bc : number < 6 ? state.de : state.hl;
}

// --- CP/M's entries ---

// A device sees no registers, so an OUT to a port of an entry only ends the run at the next instruction boundary; the
// caller then reads the registers and continues the run. An OUT that does not belong to an entry is passed on to the device
// of that port.
class CpmFront final : public i8080::Front {
 public:
  struct Call {
    std::uint8_t port;
    std::uint8_t value;
    core::TStateInstant at;
  };

  explicit CpmFront(i8080::Machine& machine) : Front(machine, Cpm::ports) {}
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    call_ = {port, value, at};
    machine().request_stop();
  }

  // Returns the OUT that ended the run, once.
  [[nodiscard]] std::optional<Call> take_call() { return std::exchange(call_, std::nullopt); }
  void pass_on(const Call& call) { Front::out(call.port, call.value, call.at); }

 private:
  std::optional<Call> call_;
};

// --- The machine ---

class I8080Run final : public Machine, private core::KeyPollListener {
 public:
  explicit I8080Run(I8080Setup setup) : setup_(std::move(setup)), plotter_(setup_.drawing), machine_(std::move(setup_.machine)) {
    machine_->strokes().hand_to(&plotter_);
    if (setup_.monitored) probe_.emplace(std::size_t{0x10000}, std::size_t{0x100});
    if (setup_.observed) recorder_.emplace();
    if (setup_.cpm) {
      setup_.cpm->journal = setup_.monitored;
      cpm_.emplace(*setup_.cpm, [this](std::string_view text) { print(text); }, [this](char c) { list(c); });
      cpm_front_.emplace(*machine_);
      cpm_->prepare(machine_->memory());
    }
    if (setup_.vcd) recorder_->vcd.emplace(std::move(*setup_.vcd), clock(), [this] { return machine_->interrupt(); });
  }

  [[nodiscard]] std::uint32_t words() const override { return machine_->options().memory; }
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const override {
    return machine_->memory()[address];
  }
  void put(std::uint32_t address, std::uint32_t word) override {
    machine_->memory()[address] = static_cast<i8080::Byte>(word);
    loaded_.set(address);
  }

  [[nodiscard]] std::uint32_t get(std::size_t number) const override {
    const i8080::State& s = machine_->registers();
    switch (number) {
      case 0: return s.a;
      case 1: return s.f;
      case 8: return s.sp;
      case 9: return s.pc;
      case 10: return s.interrupts_on ? 1 : 0;
      default: return number % 2 == 0 ? i8080::high(pair_of(s, number)) : i8080::low(pair_of(s, number));
    }
  }
  // Bits of F that the machine does not have are ignored.
  void set(std::size_t number, std::uint32_t value) override {
    i8080::State& s = machine_->registers();
    const auto byte = static_cast<i8080::Byte>(value);
    switch (number) {
      case 0: s.a = byte; break;
      case 1: s.f = i8080::as_flags(byte); break;
      case 8: s.sp = static_cast<i8080::Address>(value); break;
      case 9: machine_->start(static_cast<i8080::Address>(value)); break;
      case 10: s.interrupts_on = value != 0; break;
      default: {
        i8080::Address& pair = pair_of(s, number);
        pair =
            number % 2 == 0 ? i8080::joined(byte, i8080::low(pair)) : i8080::joined(i8080::high(pair), byte);
      }
    }
  }

  [[nodiscard]] std::uint32_t start_address(std::optional<std::uint32_t> loaded) const override {
    return cpm_ ? cpm_->start_address() : loaded.value_or(0);
  }
  void start(std::uint32_t address) override { machine_->start(static_cast<i8080::Address>(address)); }
  void reset() override { machine_->reset(); }
  [[nodiscard]] bool halted() const override { return machine_->registers().halted; }
  [[nodiscard]] std::string_view system_missing(std::uint32_t lowest) const override {
    return !cpm_ && lowest == image::com_origin ? "--cpm gives a CP/M program its system" : "";
  }
  [[nodiscard]] Result<Done> ready() override {
    if (!cpm_) return Done{};
    for (const auto& [address, byte] : cpm_->entries()) {
      if (loaded_[address] && machine_->memory()[address] != byte) {
        return base::bad_input(fmt::format(
            "--load: found a byte for {:04X}, expected none: --cpm has its entry to CP/M there", address));
      }
    }
    cpm_->start(machine_->registers(), machine_->memory());
    return Done{};
  }

  void take(std::string_view option, TextTaker taker) override {
    if (option == "--console-out") {
      console_ = std::move(taker);
    } else if (option == "--list") {
      list_ = std::move(taker);
    } else if (option == "--cpm-log") {
      cpm_->take_log(std::move(taker));
    } else if (option == "--strokes") {
      plotter_.take(std::move(taker));
    } else {
      if (recorder_) recorder_->take(option, std::move(taker));
    }
  }

  // Each BDOS call ends a slice: a program that prints continuously would never reach the end of a long one.
  [[nodiscard]] std::optional<Stop> run(const Limits& limits, bool asked) override {
    if (cpm_) {
      const bool waited = cpm_->waits_for_key();
      if (!watching_host([this] { return cpm_->resume(processor()); })) return std::nullopt;
      if (waited && condition_changed()) return Stop{stopped_by_probe, {}};
      // CP/M has written to a watched address, now or at the end of the last slice.
      if (probe_ && !probe_->events().empty()) return Stop{stopped_by_probe, {}};
    }
    const core::TStateInstant limit = core::at_t_state(limits.until);
    const core::TStateInstant until =
        asked ? std::min(limit, machine_->now() + slice()) : limit;
    const std::uint64_t left = limits.instructions - std::min(machine_->instructions(), limits.instructions);
    const auto reason = run_observed({left, until});
    each_terminal([this](core::Terminal& terminal) {
      const auto bytes = terminal.take_printed();
      if (!bytes.empty()) print({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
    // A CP/M call that ended the run is answered first.
    if (probe_ && !probe_->events().empty() && reason != i8080::StopReason::device) return Stop{stopped_by_probe, {}};
    switch (reason) {
      case i8080::StopReason::halt:
        if (halts_for_key()) return std::nullopt;
        return Stop{"halt", {}};
      case i8080::StopReason::instruction_limit: return Stop{"instruction_limit", {}};
      case i8080::StopReason::time_limit:
        if (machine_->now() < limit) return std::nullopt;
        return Stop{"state_limit", {}, true};
      case i8080::StopReason::unanswered: return unanswered();
      case i8080::StopReason::undefined: return undefined();
      case i8080::StopReason::device: {
        const auto call = cpm_front_ ? cpm_front_->take_call() : std::nullopt;
        const auto stop = call ? answer(*call) : std::nullopt;
        if (stop || !condition_changed()) return stop;
        return Stop{stopped_by_probe, {}};
      }
      case i8080::StopReason::observer: break;
    }
    return Stop{"interrupted", {}};
  }
  void finish() override {
    if (recorder_) recorder_->finish(machine_->now());
    if (cpm_) cpm_->finish();
    plotter_.finish();
  }

  [[nodiscard]] Probe* probe() override { return probe_ ? &*probe_ : nullptr; }
  [[nodiscard]] Instruction instruction_at(std::uint32_t address) const override {
    const auto at = [&](std::uint32_t n) { return machine_->memory()[static_cast<i8080::Address>(address + n)]; };
    const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction({at(0), at(1), at(2)});
    return {(line.duplicate ? "*" : "") + line.text, static_cast<unsigned>(line.bytes)};
  }
  [[nodiscard]] Flow flow_of(std::uint32_t word) const override {
    using i8080::Operation;
    switch (i8080::lookup(static_cast<i8080::Byte>(word)).operation) {
      case Operation::call:
      case Operation::conditional_call:
      case Operation::rst: return Flow::call;
      case Operation::ret:
      case Operation::conditional_return: return Flow::leave;
      default: return Flow::plain;
    }
  }
  [[nodiscard]] std::string history_line(const Probe::Entry& entry) const override {
    const auto byte = [&entry](unsigned n) { return static_cast<std::uint8_t>(entry.word >> (8 * n)); };
    const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction({byte(0), byte(1), byte(2)});
    std::string bytes;
    for (unsigned n = 0; n < static_cast<unsigned>(line.bytes); ++n) bytes += fmt::format("{:02X}", byte(n));
    const std::string used =
        entry.has_address ? fmt::format("{:04X}={:02X}", entry.address, entry.value) : std::string();
    return fmt::format("{:>12} {:04X} {:<6} {:<20} {:<7} {:02X} {:02X}", entry.time, entry.pc, bytes,
                       (entry.supplied ? "INT " : "") + line.text, used, entry.accumulator, entry.link);
  }
  [[nodiscard]] std::vector<ReportLine> device_lines() const override {
    std::vector<ReportLine> rows = lines();
    for (ReportLine& row : rows) {
      const auto sent = setup_.sent_from.find(row.label);
      if (sent != setup_.sent_from.end()) row.text = sent->second + ": " + row.text;
    }
    if (!setup_.cpm) return rows;
    for (const CpmDrive& drive : setup_.cpm->drives)
      rows.push_back({fmt::format("drive {}", static_cast<char>('A' + drive.number)), drive.folder + (drive.read_only ? ", read only" : "")});
    return rows;
  }

  void type(std::uint8_t code) override {
    if (cpm_) cpm_->type(code);
    each_terminal([code](core::Terminal& terminal) { terminal.type(code); });
    if (probe_) probe_->keys.push_back({ticks(), code});
  }
  [[nodiscard]] bool wants_key() const override {
    bool wants = (cpm_ && cpm_->wants_key()) || halts_for_key();
    each_terminal([this, &wants](const core::Terminal& terminal) {
      wants = wants || terminal.wants_key() ||
              (interrupts_for_key(terminal) && machine_->now() >= terminal.quiet_since() + clock().t_states_in(quiet_before_key));
    });
    return wants;
  }
  [[nodiscard]] bool pauses_at_key() const override { return cpm_ && cpm_->pauses_at_key(); }
  [[nodiscard]] bool waits_for_key() const override { return (cpm_ && cpm_->waits_for_key()) || halts_for_key(); }
  [[nodiscard]] std::string take_printed() override { return std::exchange(printed_, {}); }

  void return_at_polls(bool returns) override {
    each_terminal([this, returns](core::Terminal& terminal) { terminal.tell_polls(returns ? this : nullptr); });
  }
  [[nodiscard]] bool take_poll() override {
    const bool of_cpm = cpm_ && cpm_->take_poll();
    return std::exchange(polled_, false) || of_cpm;
  }
  [[nodiscard]] std::array<std::uint64_t, 2> register_image() const override {
    const i8080::State& s = machine_->registers();
    const auto joined = [](std::initializer_list<std::uint16_t> words) {
      std::uint64_t all = 0;
      for (const std::uint16_t word : words) all = all << 16U | word;
      return all;
    };
    const auto control = static_cast<std::uint16_t>((s.interrupts_on ? 1U : 0U) | (s.deferred ? 2U : 0U) | (s.halted ? 4U : 0U));
    return {joined({i8080::joined(s.a, s.f), s.bc, s.de, s.hl}), joined({control, s.sp, s.pc})};
  }
  [[nodiscard]] std::span<const std::byte> memory_image() const override {
    return std::as_bytes(std::as_const(*machine_).memory());
  }
  [[nodiscard]] bool has_deadline() const override { return machine_->deadline() != core::never_t; }
  [[nodiscard]] std::uint64_t traffic() const override {
    std::uint64_t traffic = printed_bytes_;
    for (const i8080::AttachedDevice& each : machine_->devices()) {
      for (const core::Count& count : each.device->counts()) traffic += count.value;
    }
    return traffic;
  }

  [[nodiscard]] std::int64_t trim_journal(std::size_t most) override { return cpm_ ? cpm_->trim_journal(most) : 0; }

  [[nodiscard]] std::uint64_t instructions() const override { return machine_->instructions(); }
  [[nodiscard]] core::Instant now() const override {
    return clock().to_nanoseconds(machine_->now());
  }
  [[nodiscard]] std::int64_t ticks() const override { return core::t_states_of(machine_->now()); }
  [[nodiscard]] std::int64_t ticks_per_second() const override { return clock().hertz; }

  [[nodiscard]] std::vector<std::string> configuration() const override { return setup_.configuration; }
  [[nodiscard]] MachineState save() override {
    StateWriter writer;
    visit_state(writer);
    return writer.take();
  }
  [[nodiscard]] base::Result<Done> restore(const MachineState& state) override {
    const auto done = restore_state(state, [this](core::StateVisitor& visit) { visit_state(visit); });
    if (done) printed_.clear();
    return done;
  }

  [[nodiscard]] std::vector<ReportLine> lines() const override {
    std::vector<ReportLine> lines{
        {"T-states", fmt::format("{}", core::t_states_of(machine_->now()))},
        {"emulated time", fmt::format("{} s at {} Hz", seconds_text(machine_->now(), clock()), clock().hertz)},
        {"instructions", fmt::format("{}", machine_->instructions())}};
    if (has_hold()) lines.push_back({"held", fmt::format("{} T-states", machine_->held())});
    std::string undefined;
    for (const i8080::UndefinedOpcode& each : machine_->undefined().all)
      undefined += fmt::format("{}{:02X} at {:04X} ({})", undefined.empty() ? "" : ", ", each.opcode, each.first, each.count);
    if (!undefined.empty()) lines.push_back({"undefined", "opcodes " + undefined});
    if (cpm_) {
      for (ReportLine& line : cpm_->lines()) lines.push_back(std::move(line));
    }
    each_reported([&lines](const i8080::AttachedDevice& each) {
      lines.push_back({std::string(each.info->name), counts_text(each.device->counts())});
    });
    return lines;
  }
  void add_times(base::Json& report) const override {
    const std::int64_t t_states = core::t_states_of(machine_->now());
    report["t_states"] = t_states;
    if (has_hold()) report["held_t_states"] = machine_->held();
    report["clock_hz"] = clock().hertz;
    // null if 64 bits cannot hold it
    report["emulated_ns"] = now() == core::never ? base::Json() : base::Json(core::nanoseconds_of(now()));
    report["emulated_seconds"] = static_cast<double>(t_states) / static_cast<double>(clock().hertz);
  }
  void add_details(base::Json& report) const override {
    report["cpm"] = cpm_.has_value();
    if (cpm_) cpm_->add_details(report);
    if (setup_.keep_console) report["console"] = as_utf8(kept_console_);
    base::Json& devices = report["devices"] = base::Json::object();
    each_reported([&devices](const i8080::AttachedDevice& each) {
      devices[each.info->name] = counts_json(each.device->counts());
    });
    base::Json& unanswered = report["unanswered"] = base::Json::array();
    each_unanswered([&unanswered](std::size_t port, const i8080::UnansweredPort& counts) {
      unanswered.push_back(base::Json{
          {"port", fmt::format("{:02X}", port)}, {"reads", counts.reads}, {"writes", counts.writes}});
    });
    base::Json& undefined = report["undefined"] = base::Json::array();
    for (const i8080::UndefinedOpcode& each : machine_->undefined().all) {
      undefined.push_back(base::Json{
          {"opcode", fmt::format("{:02X}", each.opcode)}, {"first", fmt::format("{:04X}", each.first)}, {"count", each.count}});
    }
  }

  [[nodiscard]] std::vector<std::string> warnings() const override {
    std::vector<std::string> warnings;
    for (const auto& [info, device] : machine_->devices()) {
      const core::LinkHost* const host = device->link_host();
      if (host != nullptr && host->left_out() != 0)
        warnings.push_back(fmt::format("{}: the last {} bytes from the program were not kept", info->name, host->left_out()));
    }
    for (std::string& warning : early_warnings_left()) warnings.push_back(std::move(warning));
    if (machine_->registers().halted && machine_->registers().interrupts_on) {
      std::string lines;
      for (const auto& [info, device] : machine_->devices()) {
        if (machine_->is_connected(*device)) continue;
        for (const std::string_view line : info->lines) lines += fmt::format("{}{}", lines.empty() ? "" : ", ", line);
      }
      if (!lines.empty())
        warnings.push_back(fmt::format("HLT waits for an interrupt, and a device here is not wired to one: --interrupt LINE=N, with LINE of {} and N of 0 to 7", lines));
    }
    if (console_left_out_ != 0) {
      warnings.push_back(
          fmt::format("the report's \"console\" lacks the last {} bytes printed; --console-out FILE takes all",
                      console_left_out_));
    }
    if (list_dropped_ != 0)
      warnings.push_back(fmt::format("the list device: {} characters were discarded; --list FILE keeps them", list_dropped_));
    if (plotter_.left_out() != 0)
      warnings.push_back(fmt::format("the drawing lacks the last {} marks of the pen", plotter_.left_out()));
    return warnings;
  }

  void keep_strokes(bool keep) override { plotter_.keep_strokes(keep); }
  std::span<const core::Stroke> take_strokes() override { return plotter_.take_strokes(); }
  [[nodiscard]] const core::Raster* raster() const override {
    const core::Raster* shown = nullptr;
    for (const i8080::AttachedDevice& each : machine_->devices()) {
      if (const core::Raster* const raster = each.device->raster(); raster != nullptr) shown = raster;
    }
    return shown;
  }

  // --png of the raster board, --svg of the plotter, --tape-out, --parallel-out and the like of the links.
  [[nodiscard]] Bytes output(std::string_view option) const override {
    for (const auto& [info, device] : machine_->devices()) {
      if (option == "--png" && device->raster() != nullptr) return png(*device->raster());
      if (option == "--svg" && info->kind == core::PortDeviceKind::plotter) return svg(device->micrometres_per_step());
      core::LinkHost* const host = device->link_host();
      const bool tape = option == "--tape-out" && info->kind == core::PortDeviceKind::terminal;
      if (host != nullptr && (tape || option == fmt::format("--{}-out", info->name))) return host->received();
    }
    return {};
  }

 protected:
  [[nodiscard]] std::vector<EarlyWarning> early_warnings() const override {
    std::vector<EarlyWarning> warnings;
    each_unanswered([&warnings](std::size_t port, const i8080::UnansweredPort& counts) {
      const auto warn = [&](std::uint64_t count, std::string_view what) {
        if (count == 0) return;
        warnings.push_back({fmt::format("port {:02X}: no device at this port, {}", port, what),
                            count == 1 ? "once" : fmt::format("{} times", count)});
      };
      warn(counts.reads, "read as FF");
      warn(counts.writes, "written without effect");
    });
    if (cpm_) {
      for (EarlyWarning& warning : cpm_->warnings()) warnings.push_back(std::move(warning));
    }
    const auto& undefined = machine_->undefined().all;
    if (!undefined.empty()) {
      std::uint64_t count = 0;
      for (const i8080::UndefinedOpcode& each : undefined) count += each.count;
      warnings.push_back({undefined_text(undefined.front().opcode, undefined.front().first),
                          count == 1 ? "once" : fmt::format("{} such opcodes", count)});
    }
    return warnings;
  }

 private:
  void key_polled() override {
    polled_ = true;
    machine_->request_stop();
  }
  // A key on that terminal would interrupt the program.
  [[nodiscard]] bool interrupts_for_key(const core::Terminal& terminal) const {
    if ((!setup_.console && !setup_.monitored) || !machine_->registers().interrupts_on || !terminal.interrupts_for_key()) return false;
    const auto devices = machine_->devices();
    return std::any_of(devices.begin(), devices.end(), [&](const i8080::AttachedDevice& each) {
      return each.device->terminal() == &terminal && machine_->is_connected(*each.device);
    });
  }
  // The program is in HLT, and only a key can end that.
  [[nodiscard]] bool halts_for_key() const {
    if (!machine_->registers().halted || has_connected_deadline()) return false;
    bool waits = false;
    each_terminal([this, &waits](const core::Terminal& terminal) { waits = waits || interrupts_for_key(terminal); });
    return waits;
  }
  [[nodiscard]] bool has_connected_deadline() const {
    const auto devices = machine_->devices();
    return std::any_of(devices.begin(), devices.end(), [this](const i8080::AttachedDevice& each) {
      return machine_->is_connected(*each.device) && (each.device->deadline() != core::never_t || each.device->requests() != 0);
    });
  }
  [[nodiscard]] core::TStates slice() const {
    if (setup_.observed) return time_to_first_question;
    return std::clamp(machine_->now().time_since_epoch(), time_to_first_question, time_between_questions);
  }
  i8080::StopReason run_observed(const i8080::Limits& limits) {
    if (recorder_) return machine_->run(limits, *recorder_);
    if (probe_ && probe_->watches_instructions()) {
      I8080Listener listener(*probe_, machine_->now());
      return machine_->run(limits, listener);
    }
    if (probe_ && probe_->watches_boundaries()) {
      I8080Watcher watcher(*probe_, machine_->now());
      return machine_->run(limits, watcher);
    }
    return machine_->run(limits);
  }

  // Between two runs no CP/M call is pending.
  void visit_state(core::StateVisitor& visit) {
    machine_->visit_state(visit);
    if (cpm_front_ && visit.restores()) static_cast<void>(cpm_front_->take_call());
    visit.section("drawing", plotter_);
    visit.section("console", [this](core::StateVisitor& fields) {
      fields.output("printed", kept_console_, console_before_);
      fields("left_out", console_left_out_);
      fields("list_dropped", list_dropped_);
    });
    if (cpm_) visit.section("cpm", *cpm_);
  }

  // A change that CP/M makes at a watched address counts as the program's access; rewriting the same byte does not.
  template <class Work>
  std::invoke_result_t<Work> watching_host(Work work) {
    if (!probe_ || probe_->written_places().empty()) return work();
    std::vector<i8080::Byte> before;
    for (const std::uint32_t at : probe_->written_places()) before.push_back(machine_->memory()[at]);
    const std::invoke_result_t<Work> done = work();
    for (std::size_t n = 0; n < before.size(); ++n) {
      const std::uint32_t at = probe_->written_places()[n];
      const i8080::Byte now = machine_->memory()[at];
      if (now != before[n]) probe_->add({Probe::Kind::write, ticks(), at, now});
    }
    return done;
  }

  // Whether the work of CP/M has changed a condition that is waited for.
  bool condition_changed() {
    if (!probe_ || !probe_->has_conditions() || !probe_->condition_changed()) return false;
    probe_->add({Probe::Kind::condition, ticks(), machine_->registers().pc, 0});
    return true;
  }

  // nullopt: the run continues.
  std::optional<Stop> answer(const CpmFront::Call& call) {
    switch (watching_host([this, &call] { return cpm_->out(call.port, processor()); })) {
      case Cpm::Outcome::answered: return std::nullopt;
      case Cpm::Outcome::stopped: return cpm_->stop();
      case Cpm::Outcome::no: break;
    }
    cpm_front_->pass_on(call);  // with --strict and no device there, the next slice ends where it begins
    return std::nullopt;
  }
  template <class Visit>
  void each_terminal(Visit visit) const {
    for (const i8080::AttachedDevice& each : machine_->devices()) {
      if (core::Terminal* const terminal = each.device->terminal(); terminal != nullptr) visit(*terminal);
    }
  }
  // The devices that were selected by name.
  template <class Visit>
  void each_reported(Visit visit) const {
    for (const i8080::AttachedDevice& each : machine_->devices()) {
      if (each.info->kind != core::PortDeviceKind::special) visit(each);
    }
  }
  [[nodiscard]] bool has_hold() const {
    const auto devices = machine_->devices();
    return std::any_of(devices.begin(), devices.end(), [](const auto& each) { return each.device->drives_hold(); });
  }
  [[nodiscard]] core::ClockRate clock() const { return machine_->options().clock; }
  [[nodiscard]] Cpm::Processor processor() { return {machine_->registers(), machine_->memory(), ticks()}; }
  // What the 8080 makes of an opcode that Intel left undefined. On the Z80 they are instructions.
  static std::string undefined_text(i8080::Byte opcode, i8080::Address address) {
    const std::string instruction = disassembler::disassemble_i8080_instruction({opcode, 0, 0}).text;
    return fmt::format("PC {:04X}: executes opcode {:02X}, which Intel left undefined and an 8080 takes as {}; a program for the Z80?",
                       address, opcode, std::string_view(instruction).substr(0, instruction.find(' ')));
  }
  std::optional<Stop> undefined() const {
    const i8080::UndefinedOpcodes& all = machine_->undefined();
    return Stop{"strict", "stopped by --strict: " + undefined_text(all.last_opcode, all.last_address)};
  }
  // The IN or OUT precedes PC.
  std::optional<Stop> unanswered() const {
    return Stop{"strict", fmt::format("PC {:04X}: stopped by --strict: no device at that port",
                                      static_cast<i8080::Address>(machine_->registers().pc - 2))};
  }

  void print(std::string_view text) {
    printed_bytes_ += text.size();
    if (console_) console_(text);
    if (setup_.console) printed_ += text;
    if (!setup_.keep_console) {
      console_before_ += text.size();
      return;
    }
    const std::string_view kept = text.substr(0, most_kept_of_console - kept_console_.size());
    kept_console_ += kept;
    console_left_out_ += text.size() - kept.size();
  }

  void list(char c) {
    ++printed_bytes_;
    if (list_) list_(std::string_view(&c, 1));
    else ++list_dropped_;
  }

  template <class Visit>
  void each_unanswered(Visit visit) const {
    for (std::size_t port = 0; port < 256; ++port) {
      const i8080::UnansweredPort& counts = machine_->unanswered()[port];
      if (counts.reads + counts.writes != 0) visit(port, counts);
    }
  }

  [[nodiscard]] Bytes png(const core::Raster& raster) const {
    const auto palette = setup_.grey ? picture::RasterPalette::grey : picture::RasterPalette::colour;
    return *picture::encode_png(
        picture::raster_image(raster, palette, 1),
        {{"Software", "sightline " SIGHTLINE_VERSION},
         {"End of run", fmt::format("T-state {}", core::t_states_of(machine_->now()))}});
  }
  // The paper is as large as the drawing needs, starting at step (0, 0).
  [[nodiscard]] Bytes svg(std::int64_t micrometres_per_step) const {
    picture::PlotterPaper paper{.micrometres_per_step = micrometres_per_step};
    for (const picture::PenPath& path : plotter_.paths()) {
      for (const picture::PenPoint corner : path.corners)
        paper.steps = std::max({paper.steps, corner.x + 1, corner.y + 1});
    }
    const std::string drawing =
        picture::pen_svg(plotter_.paths(), paper,
                         fmt::format("8080: plotter at T-state {}", core::t_states_of(machine_->now())));
    return {drawing.begin(), drawing.end()};
  }

  I8080Setup setup_;
  PlotterTaker plotter_;
  std::unique_ptr<i8080::Machine> machine_;
  std::optional<CpmFront> cpm_front_;  // with CP/M
  std::optional<I8080Recorder> recorder_;
  std::optional<Probe> probe_;
  std::bitset<0x10000> loaded_;
  TextTaker console_;
  std::string kept_console_;
  std::uint64_t console_before_ = 0;  // bytes printed before the machine was restored, which kept_console_ lacks
  std::uint64_t console_left_out_ = 0;  // bytes
  std::string printed_;  // printed on the console and not yet handed out
  TextTaker list_;
  std::uint64_t list_dropped_ = 0;  // characters without a taker
  std::optional<Cpm> cpm_;
  bool polled_ = false;  // a terminal, in vain
  std::uint64_t printed_bytes_ = 0;  // on the console and the list device, since the machine was made
};

}  // namespace

std::unique_ptr<Machine> make_i8080(I8080Setup setup) {
  return std::make_unique<I8080Run>(std::move(setup));
}

}  // namespace sightline::machines
