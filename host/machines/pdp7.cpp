// See pdp7.hpp.
#include "host/machines/pdp7.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

#include "emulators/core/state_visitor.hpp"
#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/cpu.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/text.hpp"
#include "host/machines/disk_image.hpp"
#include "host/machines/display_file.hpp"
#include "host/machines/pdp7_observers.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/png.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_drawing.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::machines {

namespace {

// About ten milliseconds of host time: short enough for Ctrl-C, long enough to cost nothing.
constexpr std::uint64_t cycles_between_questions = std::uint64_t{1} << 22;
// Shorter at the beginning of a run, where it may access a missing device, and where every instruction is recorded, which
// takes longer.
constexpr std::uint64_t cycles_to_first_question = std::uint64_t{1} << 16;
// A program that executes its data can contain thousands of codes.
constexpr std::size_t most_warnings = 100;
// The exposure for which the photograph's parameters are set.
constexpr core::Duration shutter_time{200'000'000};
// A person would no longer have seen a pass that ended longer ago.
constexpr core::Duration oldest_picture{200'000'000};

std::string seconds_text(core::Instant t) {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t ns = core::nanoseconds_of(t);
  return fmt::format("{}.{:09}", ns / second, ns % second);
}

std::string why_unanswered(std::uint32_t word) {
  constexpr std::uint32_t iot = 0700000;
  if ((word & iot) != iot) return "there is no EAE in this machine";
  return fmt::format("no device {:02o} in this machine obeys it", (word >> 6) & 077U);
}

// The address before `pc` in its bank: PC has already advanced.
pdp7::Address before(pdp7::Address pc) {
  return (pc & pdp7::bank_mask) | ((pc - 1) & pdp7::in_bank_mask);
}

Stop stop_of(pdp7::StopReason reason, pdp7::Address pc) {
  switch (reason) {
    case pdp7::StopReason::halt: return {"halt", {}};
    case pdp7::StopReason::instruction_limit: return {"instruction_limit", {}};
    case pdp7::StopReason::time_limit: return {"time_limit", {}, true};
    case pdp7::StopReason::xct_chain:
      return {"xct_chain", fmt::format("PC {:05o}: stopped: a chain of more than {} XCT instructions",
                                       before(pc), pdp7::longest_xct_chain)};
    case pdp7::StopReason::unanswered:
      return {"strict",
              fmt::format("PC {:05o}: stopped by --strict: nothing obeys the instruction", before(pc))};
    case pdp7::StopReason::observer: break;
  }
  return {"interrupted", {}};
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

constexpr std::string_view display_name = type340::Display::info.name;

std::vector<core::Setting> settings_of(const type340::Options& display) {
  return {{"347", display.subroutines_347 ? 1 : 0}, {"342", display.characters_342 ? 1 : 0}, {"flash-again", display.flash_again ? 1 : 0}};
}

class Pdp7Machine final : public Machine, private core::KeyPollListener {
 public:
  explicit Pdp7Machine(Pdp7Setup setup)
      : setup_(std::move(setup)),
        screen_(setup_.screen.value_or(Screen::Outputs{})),
        machine_(setup_.machine),
        switches_(setup_.switches) {}

  // Call once, before anything else.
  [[nodiscard]] Result<Done> build_machine() {
    std::string error = machine_.error();
    const auto attach = [&](std::string_view name, std::span<const core::Setting> settings = {}) {
      if (error.empty()) error = machine_.attach(name, settings);
    };
    if (setup_.disk) attach(pdp7::Rb09::info.name);
    if (setup_.display) {
      if (error.empty()) error = machine_.attach_when_used(display_name, settings_of(*setup_.display));
      machine_.plug_in(display_name, !setup_.display_when_used);
    }
    for (const DeviceChoice& device : setup_.devices) attach(device.name, device.settings);
    if (!error.empty()) return base::usage_error("--device: " + error);
    if (setup_.disk) {
      disk_ = machine_.find<pdp7::Rb09>();
      disk_->attach(std::move(setup_.disk->image), setup_.disk->locks);
      disk_path_ = setup_.disk->path;
    }
    if (!setup_.reader_tape.empty()) reader_.load(setup_.reader_tape);
    for (const KeyPress& key : setup_.keys) keyboard_.press(key.time, key.code);
    machine_.console().schedule(setup_.switch_script);
    machine_.console().set(setup_.switches);
    if (display() != nullptr) pen_script_ = std::move(setup_.pen_script);
    if (setup_.screen) machine_.strokes().hand_to(&screen_);
    if (setup_.trace) recorder_.tracer.emplace();
    if (setup_.vcd) {
      recorder_.vcd.emplace(std::move(*setup_.vcd), [this] {
        const auto* const display = this->display();
        return display != nullptr ? &display->registers() : nullptr;
      });
    }
    if (setup_.monitored) probe_.emplace(std::size_t{pdp7::address_mask} + 1, std::size_t{0100});
    return Done{};
  }

  [[nodiscard]] std::uint32_t words() const override { return setup_.machine.core_words; }
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const override {
    return machine_.peek(address).value();
  }
  void put(std::uint32_t address, std::uint32_t word) override {
    machine_.deposit(address, core::Word18(word));
    display_words_.reset();
  }

  [[nodiscard]] std::uint32_t get(std::size_t number) const override {
    const pdp7::State& r = machine_.registers();
    switch (number) {
      case 0: return r.pc;
      case 1: return r.ac.value();
      case 2: return r.link ? 1 : 0;
      case 3: return r.mq.value();
      case 4: return r.sc.value();
      case 5: return switches_.value();
      default: return r.interrupts_on ? 1 : 0;
    }
  }
  void set(std::size_t number, std::uint32_t value) override {
    pdp7::State& r = machine_.registers();
    switch (number) {
      case 0: r.pc = value; break;
      case 1: r.ac = core::Word18(value); break;
      case 2: r.link = value != 0; break;
      case 3: r.mq = core::Word18(value); break;
      case 4: r.sc = core::Word<6>(value); break;
      case 5:
        switches_ = core::Word18(value);
        machine_.console().set(switches_);
        break;
      default: r.interrupts_on = value != 0; break;
    }
  }
  void start(std::uint32_t address) override { machine_.start(address); }
  void reset() override { machine_.start(machine_.registers().pc); }

  void take(std::string_view option, TextTaker taker) override {
    if (option == "--trace") {
      if (recorder_.tracer) recorder_.tracer->take(std::move(taker));
    } else if (option == "--vcd") {
      if (recorder_.vcd) recorder_.vcd->take(std::move(taker));
    } else {
      screen_.take_log(std::move(taker));
    }
  }

  // A slice ends where the engine must be asked or the light pen moves.
  [[nodiscard]] std::optional<Stop> run(const Limits& limits, bool asked) override {
    display_words_.reset();
    const std::uint64_t done = machine_.counts().instructions;
    const std::uint64_t left = limits.instructions - std::min(done, limits.instructions);
    const core::Instant limit = core::at_nanoseconds(limits.until);
    const auto reason = run_observed(
        {asked ? std::min(left, slice_after(done)) : left, std::min({limit, move_pen(), next_frame()})});
    film();
    switches_ = machine_.console().switches(machine_.now());
    listen_to_printer();
    if (probe_ && !probe_->events().empty() && reason != pdp7::StopReason::halt) return Stop{stopped_by_probe, {}};
    const bool slice_done = reason == pdp7::StopReason::instruction_limit &&
                            machine_.counts().instructions < limits.instructions;
    const bool pen_due = reason == pdp7::StopReason::time_limit && machine_.now() < limit;
    // Asked for by key_polled(), perhaps at the boundary where the run before ended.
    const bool poll_met = reason == pdp7::StopReason::observer;
    if (slice_done || pen_due || poll_met) return std::nullopt;
    return stop_of(reason, machine_.registers().pc);
  }
  void finish() override {
    recorder_.finish(now());
    if (setup_.movie_rate != 0 && movie_.frames() == 0) take_frame(now());
    screen_.finish();
  }

  [[nodiscard]] Probe* probe() override {
    return probe_ ? &*probe_ : nullptr;
  }
  [[nodiscard]] Instruction instruction_at(std::uint32_t address) const override {
    const core::Word18 word = machine_.peek(address);
    const auto& display_words = words_of_display();
    if (const auto found = display_words.find(address); found != display_words.end())
      return {disassembler::disassemble_display_word(word, found->second), 1};
    return {disassembler::disassemble_word(word, address), 1};
  }
  [[nodiscard]] Flow flow_of(std::uint32_t word) const override {
    const pdp7::Operation operation = pdp7::instruction_of(word).operation;
    if (operation == pdp7::Operation::jms || operation == pdp7::Operation::cal) return Flow::call;
    const bool indirect = (word & pdp7::indirect_bit) != 0;
    return operation == pdp7::Operation::jmp && indirect ? Flow::leave : Flow::plain;
  }
  [[nodiscard]] std::string history_line(const Probe::Entry& entry) const override {
    std::string used = entry.has_address ? fmt::format("{:05o}={:06o}", entry.address, entry.value) : std::string();
    return fmt::format("{:>12} {:05o} {:06o}  {:<18} {:<12} {:06o} {:o}", entry.time, entry.pc, entry.word,
                       disassembler::disassemble_word(core::Word18(entry.word), entry.pc), used, entry.accumulator,
                       entry.link);
  }
  [[nodiscard]] Result<Done> attach(std::string_view device, const Input& input) override {
    if (device == "disk") return attach_disk(input);
    if (device == "pen") return attach_pen(input);
    if (device != "reader")
      return base::usage_error(fmt::format("found device \"{}\", expected reader, disk or pen", device));
    reader_.load(input.bytes);
    setup_.reader_name = input.name;
    return Done{};
  }
  [[nodiscard]] std::vector<Medium> changed_media() const override {
    if (disk_ == nullptr || !disk_->changed() || disk_path_.empty()) return {};
    return {{disk_path_, disk_image(*disk_)}};
  }
  [[nodiscard]] std::vector<std::pair<std::string_view, bool>> conditions() override {
    std::vector<std::pair<std::string_view, bool>> flags{{"clock", clock_.interrupt_request()},
                                                         {"reader", reader_.interrupt_request()},
                                                         {"punch", punch_.interrupt_request()},
                                                         {"keyboard", keyboard_.interrupt_request()},
                                                         {"printer", printer_.interrupt_request()}};
    if (disk_ != nullptr) {
      constexpr std::uint32_t over = pdp7::rb09::status::done | pdp7::rb09::status::error;
      flags.emplace_back("disk", (disk_->status_word() & over) != 0);
    }
    if (setup_.display) {
      // Access brings the display to the machine's time, which the run does anyway. A display that is not plugged in yet
      // has no flag up.
      auto* const display = this->display();
      flags.emplace_back("edge", display != nullptr && (display->vertical_edge(now()) || display->horizontal_edge(now())));
      flags.emplace_back("pen", display != nullptr && display->light_pen_flag(now()));
      flags.emplace_back("stop", display != nullptr && display->stop_interrupt(now()));
    }
    return flags;
  }
  // In the order of conditions().
  [[nodiscard]] bool condition(std::size_t number) override {
    switch (number) {
      case 0: return clock_.interrupt_request();
      case 1: return reader_.interrupt_request();
      case 2: return punch_.interrupt_request();
      case 3: return keyboard_.interrupt_request();
      case 4: return printer_.interrupt_request();
      default: break;
    }
    auto* const display = this->display();
    const std::size_t of_display = number - (disk_ != nullptr ? 6 : 5);
    if (display == nullptr || of_display > 2) return conditions().at(number).second;
    if (of_display == 0) return display->vertical_edge(now()) || display->horizontal_edge(now());
    return of_display == 1 ? display->light_pen_flag(now()) : display->stop_interrupt(now());
  }
  [[nodiscard]] std::vector<ReportLine> device_lines() const override {
    const auto flag = [](bool up) { return up ? "flag up" : "flag down"; };
    std::vector<ReportLine> lines{
        {"clock", fmt::format("{}, {}", clock_.on() ? "on" : "off", flag(clock_.interrupt_request()))},
        {"reader", fmt::format("{}, {}, buffer {:06o}{}", tape_in_reader(), flag(reader_.interrupt_request()), reader_.buffer().value(),
                               reader_.out_of_tape() ? ", waits for tape" : "")},
        {"punch", fmt::format("{}, {} lines punched", flag(punch_.interrupt_request()), punch_.tape().size())},
        {"keyboard", fmt::format("{}, buffer {:03o}", flag(keyboard_.interrupt_request()), keyboard_.buffer())},
        {"printer", fmt::format("{}, {} characters typed", flag(printer_.interrupt_request()), printer_.printed().size())}};
    if (disk_ != nullptr) {
      const std::uint32_t track = disk_->address() / pdp7::rb09::words_per_track;
      const std::uint32_t sector = disk_->address() / pdp7::rb09::words % pdp7::rb09::sectors;
      lines.push_back({"disk", fmt::format("{}, status {:06o}, track {} sector {} word {} (decimal), core {:05o}, count {:06o}",
                                           disk_->attached() ? disk_path_.empty() ? "read only" : disk_path_ : "none in the drive",
                                           disk_->status_word(), track, sector, disk_->address() % pdp7::rb09::words,
                                           disk_->core_address(), disk_->word_count())});
    }
    if (const auto* const display = this->display()) {
      const type340::Counters& done = display->counters();
      lines.push_back({"display", fmt::format("{} words, {} passes complete of {} started; `show display` has its registers",
                                              done.words, done.passes_stopped, done.passes_started)});
    } else if (setup_.display) {
      lines.push_back({"display", "not used yet"});
    }
    add_further_devices(lines);
    return lines;
  }
  [[nodiscard]] std::vector<ReportLine> display_lines() const override {
    const auto* const display = this->display();
    if (display == nullptr) return {};
    constexpr std::array modes{"parameter", "point", "slave", "character", "vector", "vector continue", "increment", "subroutine"};
    const type340::Registers& r = display->registers();
    std::string flags;
    const auto flag = [&flags](bool up, std::string_view name) {
      if (up) flags += fmt::format("{}{}", flags.empty() ? "" : ", ", name);
    };
    flag(r.request, "request for data");
    flag(r.stop, "stopped by its file");
    flag(r.vertical_edge, "vertical edge");
    flag(r.horizontal_edge, "horizontal edge");
    flag(r.pen_flag, "light pen");
    return {{"address", fmt::format("{:05o}, the word {:06o}", r.address, r.br.value())},
            {"mode", modes[static_cast<std::size_t>(r.mode)]},
            {"beam", fmt::format("x {}, y {} of 1023 (decimal)", r.x, r.y)},
            {"scale", fmt::format("{} (x{})", r.scale, r.step())},
            {"intensity", fmt::format("{} of 7", r.intensity)},
            {"light pen", r.pen_enable ? "enabled" : "off"},
            {"flags", flags.empty() ? "none" : flags},
            {"words", fmt::format("{}", display->counters().words)},
            {"passes", fmt::format("{} complete of {} started", display->counters().passes_stopped,
                                   display->counters().passes_started)}};
  }

  void keep_strokes(bool keep) override {
    screen_.keep_strokes(keep);
    machine_.strokes().hand_to(&screen_);
  }
  std::span<const core::Stroke> take_strokes() override { return screen_.take_strokes(); }

  void type(std::uint8_t code) override {
    keyboard_.send(machine_.now(), code);
    if (probe_) probe_->keys.push_back({ticks(), code});
    quiet_since_ = machine_.now() + setup_.machine.timing.teletype_character;
  }
  // A program that takes keys only by interrupt never polls: it gets the next key when the console has been quiet for
  // longer.
  [[nodiscard]] bool wants_key() const override {
    if (!keyboard_.all_read()) return false;
    const core::Duration quiet = machine_.now() - quiet_since_;
    const core::Duration character = setup_.machine.timing.teletype_character;
    return (keyboard_.polled() && quiet >= character) ||
           (machine_.registers().interrupts_on && quiet >= 2 * character);
  }
  void return_at_polls(bool returns) override { keyboard_.tell_polls(returns ? this : nullptr); }
  [[nodiscard]] bool take_poll() override { return std::exchange(polled_, false); }
  [[nodiscard]] std::array<std::uint64_t, 2> register_image() const override {
    const pdp7::State& r = machine_.registers();
    std::uint64_t flags = 0;
    for (const bool flag : {r.link, r.interrupts_on, r.interrupts_deferred, r.extend, r.extend_restore, r.trap_mode})
      flags = flags << 1U | (flag ? 1U : 0U);
    return {std::uint64_t{r.ac.value()} << 18U | r.mq.value(), std::uint64_t{r.sc.value()} << 32U | flags << 16U | r.pc};
  }
  [[nodiscard]] std::span<const std::byte> memory_image() const override { return std::as_bytes(machine_.core()); }
  [[nodiscard]] ClockWord clock_word() const override {
    constexpr std::size_t size = sizeof(core::Word18);
    return {pdp7::Clock::count_address * size, size};
  }
  [[nodiscard]] bool has_deadline() const override {
    return machine_.deadline() != core::never || next_move_ < pen_script_.size();
  }
  // Not the display: a program may draw again and again while it waits.
  [[nodiscard]] std::uint64_t traffic() const override {
    std::uint64_t traffic = printer_.printed().size() + punch_.tape().size() + reader_.position();
    if (disk_ != nullptr) traffic += disk_->counters().transfers;
    further_devices([&traffic](std::string_view, const std::vector<core::Count>& counts) {
      for (const core::Count& count : counts) traffic += count.value;
    });
    return traffic;
  }
  [[nodiscard]] std::string take_printed() override {
    const auto& printed = printer_.printed();
    std::string text(printed.begin() + static_cast<std::ptrdiff_t>(taken_of_printed_), printed.end());
    taken_of_printed_ = printed.size();
    return text;
  }

  [[nodiscard]] std::uint64_t instructions() const override { return machine_.counts().instructions; }
  [[nodiscard]] core::Instant now() const override { return machine_.now(); }
  [[nodiscard]] std::int64_t ticks() const override { return core::nanoseconds_of(machine_.now()); }
  [[nodiscard]] std::int64_t ticks_per_second() const override { return 1'000'000'000; }

  [[nodiscard]] std::vector<std::string> configuration() const override { return configuration_with(display() != nullptr); }
  [[nodiscard]] std::vector<std::string> configuration_in(const MachineState& state) const override {
    return configuration_with(has_display(state));
  }
  [[nodiscard]] MachineState save() override {
    StateWriter writer;
    visit_state(writer);
    return writer.take();
  }
  [[nodiscard]] base::Result<Done> restore(const MachineState& state) override {
    display_words_.reset();
    const bool had_display = display() != nullptr;
    const bool changes = setup_.display && had_display != has_display(state);
    const MachineState before = changes ? save() : MachineState{};
    if (changes) plug_in_display(!had_display);
    const auto restored = [this](const MachineState& from) {
      return restore_state(from, [this](core::StateVisitor& visit) { visit_state(visit); });
    };
    const auto done = restored(state);
    if (!done) {
      if (changes) {
        plug_in_display(had_display);
        static_cast<void>(restored(before));
      }
      return done;
    }
    // An output, or --display, requires one whatever the snapshot has.
    if (setup_.display && !setup_.display_when_used && display() == nullptr) plug_in_display(true);
    switches_ = machine_.console().switches(machine_.now());
    printed_seen_ = taken_of_printed_ = printer_.printed().size();
    screen_.forget_after(machine_.now());
    return done;
  }

  [[nodiscard]] std::vector<ReportLine> lines() const override {
    const pdp7::Counts counts = machine_.counts();
    std::vector<ReportLine> lines{
        {"emulated time", seconds_text(now()) + " s"},
        {"instructions", fmt::format("{}", counts.instructions)},
        {"machine cycles",
         fmt::format("{}, {} of them stolen", counts.machine_cycles, counts.stolen_cycles)}};
    if (disk_ != nullptr) {
      const pdp7::rb09::Counters& done = disk_->counters();
      lines.push_back({"disk", fmt::format("{} words read and {} written in {} transfers, {} timing errors", done.words_read,
                                           done.words_written, done.transfers, done.timing_errors)});
    }
    if (const auto* const display = this->display()) {
      const type340::Counters& counters = display->counters();
      lines.push_back({"display", fmt::format("{} words, {} passes complete of {} started", counters.words,
                                              counters.passes_stopped, counters.passes_started)});
      std::string ends;
      if (counters.stop_codes != 0) ends += fmt::format("{} stop codes", counters.stop_codes);
      if (counters.edges != 0) ends += fmt::format("{}{} passes ended by an edge", ends.empty() ? "" : ", ", counters.edges);
      if (display->registers().stop) ends += fmt::format("{}stopped now by its own file", ends.empty() ? "" : ", ");
      if (!ends.empty()) lines.push_back({"", ends});
    }
    add_further_devices(lines);
    return lines;
  }
  void add_times(base::Json& report) const override {
    const pdp7::Counts counts = machine_.counts();
    const auto* const display = this->display();
    report["machine_cycles"] = counts.machine_cycles;
    report["emulated_ns"] = core::nanoseconds_of(now());
    report["emulated_seconds"] = static_cast<double>(core::nanoseconds_of(now())) / 1e9;
    report["stolen_cycles"] = counts.stolen_cycles;
    report["display_words"] = display != nullptr ? display->counters().words : 0;
    report["passes"] = display != nullptr ? display->counters().passes_stopped : 0;
    report["passes_started"] = display != nullptr ? display->counters().passes_started : 0;
    report["stop_codes"] = display != nullptr ? display->counters().stop_codes : 0;
    report["edges"] = display != nullptr ? display->counters().edges : 0;
  }
  void add_details(base::Json& report) const override {
    const pdp7::Options& machine = setup_.machine;
    report["machine"] = base::Json{{"core_words", machine.core_words},
                                   {"eae", machine.model.eae},
                                   {"extend_mode", machine.core_words > 8192},
                                   {"display", display() != nullptr}};
    base::Json& timing = report["timing"] = base::Json::object();
    for (const auto& [name, value] : setup_.timing) timing[name] = value;
    if (disk_ != nullptr) {
      const pdp7::rb09::Counters& done = disk_->counters();
      report["disk"] = base::Json{{"transfers", done.transfers},
                                  {"words_read", done.words_read},
                                  {"words_written", done.words_written},
                                  {"timing_errors", done.timing_errors}};
    }
    further_devices([&report](std::string_view name, const std::vector<core::Count>& counts) {
      report["devices"][std::string(name)] = counts_json(counts);
    });
    report["reader_out_of_tape"] = reader_.out_of_tape();
    base::Json& unanswered = report["unanswered"] = base::Json::array();
    for (const pdp7::Unanswered& entry : machine_.unanswered()) {
      unanswered.push_back(base::Json{{"word", fmt::format("{:06o}", entry.word)},
                                      {"count", entry.count},
                                      {"first_pc", fmt::format("{:05o}", entry.first_pc)}});
    }
  }

  [[nodiscard]] std::vector<std::string> warnings() const override {
    std::vector<std::string> warnings;
    if (movie_.frames() == most_frames && frame_at_ <= now()) {
      warnings.push_back(fmt::format("the movie ends at {} s, after {} photographs; a smaller --movie-rate makes it longer",
                                     seconds_text(frame_at_ - frame_time()), most_frames));
    }
    for (std::string& warning : early_warnings_left()) warnings.push_back(std::move(warning));
    if (const std::size_t codes = machine_.unanswered().size(); codes > most_warnings)
      warnings.push_back(fmt::format("and {} more such codes", codes - most_warnings));
    if (disk_ != nullptr && disk_->counters().timing_errors != 0) {
      warnings.push_back(fmt::format("the disk waited too long for core in {} transfers, which ended with a timing error",
                                     disk_->counters().timing_errors));
    }
    if (setup_.picture_wanted) add_picture_warnings(warnings);
    return warnings;
  }

  [[nodiscard]] Bytes output(std::string_view option) const override {
    if (option == "--punch") return punch_.tape();
    if (option == "--teletype") {
      Bytes codes = printer_.printed();
      for (std::uint8_t& code : codes) code &= 0177U;
      return codes;
    }
    if (display() == nullptr) return {};
    if (option == "--phosphor") return photograph();
    if (option == "--movie") return *movie_.finish();
    const auto strokes = screen_.picture_strokes(now());
    if (option == "--svg") return bytes_of(picture::svg_drawing(strokes, "Type 340: " + describe_picture(strokes.size())));
    const std::string made_at = fmt::format("{} ns of emulated time", core::nanoseconds_of(now()));
    return *picture::encode_png(picture::crisp_raster(strokes), {{"Software", "sightline " SIGHTLINE_VERSION},
                                                                 {"Shown", describe_picture(strokes.size())},
                                                                 {"End of run", made_at}});
  }

 protected:
  [[nodiscard]] std::vector<EarlyWarning> early_warnings() const override {
    std::vector<EarlyWarning> warnings;
    for (const pdp7::Unanswered& entry : machine_.unanswered()) {
      if (warnings.size() == most_warnings) break;
      warnings.push_back({fmt::format("PC {:05o}: {:06o} does nothing, {}", entry.first_pc, entry.word, why_unanswered(entry.word)),
                          entry.count == 1 ? "once" : fmt::format("{} times", entry.count)});
    }
    if (const auto* const display = this->display()) {
      const auto attach = [&warnings](std::uint64_t times, std::string_view what, std::string_view option) {
        if (times == 0) return;
        warnings.push_back({fmt::format("the display met a word for {} and waits there; --display-option {} attaches it", what, option), {}});
      };
      attach(display->counters().characters_met, "the Type 342 character generator", "342");
      attach(display->counters().subroutines_met, "the Type 347 subroutine option", "347");
      const auto times = [](std::uint64_t count) { return count == 1 ? std::string("once") : fmt::format("{} times", count); };
      // A program may ask in passing; one that asks so often waits.
      constexpr std::uint64_t waits = 1000;
      if (const std::uint64_t asked = display->counters().asked_in_vain; asked >= waits) {
        warnings.push_back({"the program waits with IDSI (700601) for a stop interrupt that cannot come: the word that stopped the "
                            "display asks for none; 3000 stops and interrupts, 2000 only stops",
                            times(asked)});
      }
      if (const std::uint64_t ored = display->counters().starts_ored; ored != 0) {
        warnings.push_back({"700604 has started the display at another address than that in AC: it ORs AC into the address counter, "
                            "which was not 0; IDLA (700606) clears the counter first",
                            times(ored)});
      }
    }
    if (reader_.out_of_tape())
      warnings.push_back({"the program waits for the paper-tape reader, which has no more tape", {}});
    return warnings;
  }

 private:
  [[nodiscard]] std::string tape_in_reader() const {
    if (setup_.reader_name.empty()) return "no tape";
    return fmt::format("{}, {} of {} lines read", setup_.reader_name, reader_.position(), reader_.length());
  }

  void key_polled() override {
    polled_ = true;
    machine_.request_stop();
  }

  // --- Devices by --device ---

  // Calls tell(name, counts) for each attached one.
  template <class Tell>
  void further_devices(Tell tell) const {
    for (const DeviceChoice& choice : setup_.devices)
      if (const core::IotDevice* const device = machine_.device(choice.name)) tell(choice.name, device->counts());
  }
  void add_further_devices(std::vector<ReportLine>& lines) const {
    further_devices([&lines](std::string_view name, const std::vector<core::Count>& counts) {
      lines.push_back({std::string(name), counts_text(counts)});
    });
  }

  // --- The display ---

  // Null: there is no display, or it is not plugged in.
  [[nodiscard]] type340::Display* display() const {
    if (display_ == nullptr) display_ = machine_.find<type340::Display>();
    return display_;
  }
  const std::map<std::uint32_t, type340::Mode>& words_of_display() const {
    if (!display_words_) {
      display_words_.emplace();
      const auto* const display = this->display();
      if (display != nullptr && display->counters().passes_started != 0)
        display_words_ = display_file(*setup_.display, display->registers(), display->start_address(),
                                      [this](std::uint32_t address) { return machine_.peek(address); });
    }
    return *display_words_;
  }
  [[nodiscard]] static bool has_display(const MachineState& state) {
    return std::any_of(state.begin(), state.end(), [](const StateSection& section) { return section.name == display_name; });
  }
  [[nodiscard]] std::vector<std::string> configuration_with(bool display) const {
    std::vector<std::string> words = setup_.configuration;
    if (display) words.emplace_back("--display");
    return words;
  }
  void plug_in_display(bool in) {
    machine_.plug_in(display_name, in);
    display_ = nullptr;
    if (in) return;
    pen_script_.clear();
    next_move_ = 0;
  }

  [[nodiscard]] std::uint64_t slice_after(std::uint64_t done) const {
    return recorder_.records() ? cycles_to_first_question : std::clamp(done, cycles_to_first_question, cycles_between_questions);
  }
  pdp7::StopReason run_observed(const pdp7::Limits& limits) {
    if (recorder_.records()) return machine_.run(limits, recorder_);
    if (!probe_ || !(probe_->watches_instructions() || probe_->watches_boundaries())) return machine_.run(limits);
    Pdp7Watcher watcher(*probe_, machine_.now());
    const auto reason = machine_.run(limits, watcher);
    // No boundary follows the last instruction of a run limited by number.
    if (reason == pdp7::StopReason::instruction_limit)
      static_cast<void>(watcher.stop(machine_.now(), machine_.registers().pc));
    return reason;
  }

  // An input without a name removes the pen.
  Result<Done> attach_pen(const Input& input) {
    if (!setup_.display) return base::usage_error("found no display on this machine, expected one; begin without --no-display");
    std::vector<PenMove> script;
    if (!input.name.empty()) {
      if (auto done = read_light_pen(input, script); !done) return done;
    }
    if (display() == nullptr) {
      if (input.name.empty()) return Done{};  // there is no pen to remove
      plug_in_display(true);
    }
    pen_script_ = std::move(script);
    next_move_ = 0;
    display()->point_light_pen(std::nullopt);
    return Done{};
  }

  // An input without a name empties the drive.
  Result<Done> attach_disk(const Input& input) {
    if (disk_ == nullptr) return base::usage_error("found no disk drive on this machine, expected one; begin with --disk FILE");
    if (input.name.empty()) {
      disk_->detach();
      disk_path_.clear();
      return Done{};
    }
    auto image = read_disk_image(input);
    if (!image) return image.error();
    disk_->attach(std::move(*image), 0);
    disk_path_ = input.name;
    return Done{};
  }

  void listen_to_printer() {
    if (printer_.deadline() != core::never || printer_.printed().size() != printed_seen_)
      quiet_since_ = std::max(quiet_since_, machine_.now());
    printed_seen_ = printer_.printed().size();
  }

  void visit_state(core::StateVisitor& visit) {
    machine_.visit_state(visit);
    pen_script_.erase(pen_script_.begin(), pen_script_.begin() + static_cast<std::ptrdiff_t>(next_move_));
    next_move_ = 0;
    visit.section("console line", [this](core::StateVisitor& fields) { fields("quiet_since", quiet_since_); });
    if (display() == nullptr) return;
    visit.section("light pen script", [this](core::StateVisitor& fields) {
      fields.list("moves", pen_script_, [&fields](PenMove& move) {
        fields("time", move.time);
        fields.present("pen", move.pen, [&fields](type340::LightPen& pen) { pen.visit_state(fields); });
      });
    });
  }

  // Moves the pen as far as the script has come, and returns the time of the next move. Between runs the display is at the
  // machine's time, as its pen requires.
  core::Instant move_pen() {
    while (next_move_ < pen_script_.size() && pen_script_[next_move_].time <= machine_.now())
      display()->point_light_pen(pen_script_[next_move_++].pen);
    return next_move_ < pen_script_.size() ? pen_script_[next_move_].time : core::never;
  }

  void add_picture_warnings(std::vector<std::string>& warnings) const {
    if (!setup_.screen) return;
    const core::Duration window = setup_.screen->window;
    if (window.count() == 0) {
      if (!screen_.has_complete_pass()) {
        warnings.push_back("the picture shows " + describe_picture(screen_.picture_strokes(now()).size()));
      } else if (now() - screen_.end_of_pass() > oldest_picture) {
        warnings.push_back(fmt::format("the picture shows a pass that ended {} s before the run did; --png-window 0.2 shows what was "
                                       "drawn last, --phosphor what the screen showed",
                                       seconds_text(core::Instant(now() - screen_.end_of_pass()))));
      }
      return;
    }
    if (screen_.picture_strokes(now()).empty())
      warnings.emplace_back("the picture shows nothing, no point was lit in the time of --png-window; a longer one reaches further back");
    const auto newest = screen_.newest_strokes();
    if (newest.size() == Screen::strokes_kept && newest.front().time + window > now()) {
      warnings.push_back(fmt::format("the picture shows the newest {} points; --png-window reaches further back", Screen::strokes_kept));
    }
  }
  // Describes what a picture of that many strokes shows.
  [[nodiscard]] std::string describe_picture(std::size_t strokes) const {
    if (setup_.screen && setup_.screen->window.count() != 0)
      return fmt::format("{} points of the last {} s", strokes, seconds_text(core::Instant(setup_.screen->window)));
    if (screen_.has_complete_pass()) return "the last complete pass";
    return strokes == 0 ? "nothing, no point was lit"
                        : fmt::format("no complete pass; the {} newest points", strokes);
  }
  [[nodiscard]] picture::Image developed(core::Instant at) const {
    picture::PhosphorPhotograph photograph(std::max(core::Instant{}, at - shutter_time), at);
    photograph.expose(screen_.newest_strokes());  // later strokes add nothing
    return photograph.develop();
  }
  // The movie: takes a photograph at each frame's time, so that a movie does not change the run.
  [[nodiscard]] core::Instant next_frame() {
    if (setup_.movie_rate == 0 || movie_.frames() == most_frames) return core::never;
    if (frame_at_ == core::Instant{}) frame_at_ = now() + frame_time();
    return frame_at_;
  }
  void film() {
    while (next_frame() <= now()) {
      take_frame(frame_at_);
      frame_at_ += frame_time();
    }
  }
  [[nodiscard]] core::Duration frame_time() const { return core::seconds(1) / setup_.movie_rate; }
  void take_frame(core::Instant at) {
    static_cast<void>(movie_.add(developed(at)));
  }

  [[nodiscard]] Bytes photograph() const {
    const core::Instant open = std::max(core::Instant{}, now() - shutter_time);
    return *picture::encode_png(
        developed(now()),
        {{"Software", "sightline " SIGHTLINE_VERSION},
         {"Shutter", fmt::format("{} to {} ns of emulated time", core::nanoseconds_of(open),
                                 core::nanoseconds_of(now()))}});
  }

  Pdp7Setup setup_;
  Screen screen_;
  Pdp7Recorder recorder_;
  std::optional<Probe> probe_;
  pdp7::Machine machine_;
  // Every machine here has these.
  pdp7::Clock& clock_ = *machine_.find<pdp7::Clock>();
  pdp7::Reader& reader_ = *machine_.find<pdp7::Reader>();
  pdp7::Punch& punch_ = *machine_.find<pdp7::Punch>();
  pdp7::Keyboard& keyboard_ = *machine_.find<pdp7::Keyboard>();
  pdp7::Printer& printer_ = *machine_.find<pdp7::Printer>();
  pdp7::Rb09* disk_ = nullptr;  // null: no drive on the machine
  mutable type340::Display* display_ = nullptr;  // null: display() looks it up
  static constexpr std::uint32_t most_frames = 750;
  picture::ApngWriter movie_{{1, static_cast<std::uint16_t>(std::max(1U, setup_.movie_rate))}, 0,
                             {{"Software", "sightline " SIGHTLINE_VERSION}}};
  core::Instant frame_at_{};  // the next frame of the movie; 0: none yet
  core::Word18 switches_;  // their current setting
  mutable std::optional<std::map<std::uint32_t, type340::Mode>> display_words_;  // for the current core; nullopt: not computed
  std::string disk_path_;  // of the disk in the drive; empty: no disk, or it is not written back
  std::vector<PenMove> pen_script_;
  std::size_t next_move_ = 0;  // of pen_script_
  // For the console: how many characters have been printed, how many of them were handed out, and since when the printer
  // and the keyboard have been quiet.
  std::size_t printed_seen_ = 0;
  std::size_t taken_of_printed_ = 0;
  core::Instant quiet_since_{};
  bool polled_ = false;  // the keyboard, in vain, since take_poll()
};

}  // namespace

Result<std::unique_ptr<Machine>> make_pdp7(Pdp7Setup setup) {
  auto machine = std::make_unique<Pdp7Machine>(std::move(setup));
  if (auto done = machine->build_machine(); !done) return done.error();
  return std::unique_ptr<Machine>(std::move(machine));
}

}  // namespace sightline::machines
