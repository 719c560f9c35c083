#include "host/guests/jones/guest.hpp"

#include <algorithm>
#include <utility>

#include "emulators/core/inline.hpp"
#include "emulators/machines/observer.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/bus.hpp"

namespace sightline::guests::jones {

namespace {

// A machine observer that counts fetches at the program's labels, marks the cells whose words the processor
// reads, and stops the run when a view is published.
class Watch {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  // `immediate`: a view ends when it is counted, not when its file is first shown.
  Watch(const Program& program, bool immediate);

  void instruction(const machines::InstructionRecord& record);
  void cycle(const pdp7::Cycle& cycle);
  // The part of instruction() that looks for labels; true at the beginning of a view.
  bool fetched(core::Instant time, pdp7::Address pc);
  [[nodiscard]] bool is_of_cell(pdp7::Address address) const { return cell_of_[address & pdp7::in_bank_mask] >= 0; }
  // True once after each published view, and whenever `until` says so.
  bool stop(core::Instant now, pdp7::Address next);

  struct View {
    core::Instant begun;
    core::Instant ended;
    std::uint64_t instructions = 0;
    std::uint64_t stolen_cycles = 0;
    std::uint64_t visits = 0;
    std::uint64_t openings = 0;
    std::uint64_t lines = 0;
    std::uint64_t pieces = 0;
    std::uint64_t distinct_cells = 0;
  };
  // The view that ended last.
  [[nodiscard]] const View& view() const { return view_; }
  // Ends the run at the next boundary.
  void request_stop() { stop_ = true; }

 private:
  void begin(core::Instant time);
  void end(core::Instant time);

  Labels labels_;
  bool immediate_;
  bool in_view_ = false;
  bool stop_ = false;
  View current_;
  View view_;
  std::vector<std::int32_t> cell_of_;  // by core address: the cell whose element is there, or -1
  std::vector<bool> seen_;             // by cell
};

// The same of a run without display, which nothing else stops: only the labels' fetches, the words of cells and the ends of
// views are told, so that the machine runs nearly as fast as alone. It stops at the beginning of a view, too, where the
// instructions are counted from.
class ViewWatch {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  struct Filter {
    const std::uint8_t* marks;

    SIGHTLINE_INLINE bool arrives(pdp7::Address) const { return false; }
    SIGHTLINE_INLINE bool wants(const pdp7::Cycle& cycle) const {
      switch (cycle.verb) {
        case pdp7::Verb::fetch: return (marks[cycle.address] & (is_label | is_of_cell)) != 0;
        case pdp7::Verb::read: return (marks[cycle.address] & is_of_cell) != 0;
        case pdp7::Verb::write: return (marks[cycle.address] & ends_when_written) != 0;
        case pdp7::Verb::modify: return (marks[cycle.address] & ends_when_modified) != 0;
        case pdp7::Verb::break_read:
        case pdp7::Verb::break_write:
        case pdp7::Verb::break_modify: return true;
        case pdp7::Verb::interrupt:
        case pdp7::Verb::iot:
        case pdp7::Verb::idle: return false;
      }
      return true;
    }
  };

  ViewWatch(const Program& program, bool immediate) : watch_(program, immediate), labels_(program.labels) {
    for (const pdp7::Address label : {labels_.search, labels_.visit, labels_.opening, labels_.line, labels_.piece})
      marks_[label] |= is_label;
    for (std::size_t address = 0; address < marks_.size(); ++address)
      if (watch_.is_of_cell(static_cast<pdp7::Address>(address))) marks_[address] |= is_of_cell;
    marks_[immediate ? labels_.views : labels_.file] |= immediate ? ends_when_modified : ends_when_written;
  }

  [[nodiscard]] Filter filter() const { return {marks_.data()}; }
  void cycle(const pdp7::Cycle& cycle) {
    if (cycle.verb == pdp7::Verb::fetch) begins_ = watch_.fetched(cycle.time, cycle.address) || begins_;
    watch_.cycle(cycle);
  }
  bool stop(core::Instant now, pdp7::Address next) { return watch_.stop(now, next) || begins_; }

  // A view has begun, and the run stopped after its first instruction; asked once.
  [[nodiscard]] bool has_begun() { return std::exchange(begins_, false); }
  // Without `instructions`.
  [[nodiscard]] const Watch::View& view() const { return watch_.view(); }

 private:
  static constexpr std::uint8_t is_label = 1;
  static constexpr std::uint8_t is_of_cell = 2;
  static constexpr std::uint8_t ends_when_written = 4;
  static constexpr std::uint8_t ends_when_modified = 8;

  Watch watch_;
  Labels labels_;
  std::vector<std::uint8_t> marks_ = std::vector<std::uint8_t>(pdp7::address_mask + 1);
  bool begins_ = false;
};

// A sink that keeps the passes of one display file and asks for a stop when it has what it waits for.
class PassWatch {
 public:
  static constexpr bool consumes = true;

  // Wait for a pass that begins at or after `from`: a stop is asked for when it is complete, and again when
  // the next pass begins.
  void wait_from(core::Instant from, Watch& watch);
  // Keep every stroke from now on, for a photograph.
  void keep_strokes() { keeping_ = true; }

  void begin_pass(core::Instant t);
  void stroke(const core::Stroke& stroke);
  void end_pass(core::Instant t);

  [[nodiscard]] bool complete() const { return ended_; }
  [[nodiscard]] bool repeated() const { return next_begun_.has_value(); }
  [[nodiscard]] const std::vector<core::Stroke>& pass() const { return pass_; }
  // From its beginning to that of the next pass; 0 while that has not begun.
  [[nodiscard]] core::Duration period() const;
  [[nodiscard]] const std::vector<core::Stroke>& kept() const { return kept_; }

 private:
  Watch* watch_ = nullptr;
  core::Instant from_ = core::never;
  std::optional<core::Instant> begun_;  // of the pass waited for
  bool ended_ = false;
  std::optional<core::Instant> next_begun_;
  bool keeping_ = false;
  std::vector<core::Stroke> pass_;
  std::vector<core::Stroke> kept_;
};

Watch::Watch(const Program& program, bool immediate)
    : labels_(program.labels),
      immediate_(immediate),
      cell_of_(core_words, -1),
      seen_(program.scene.cell_addresses.size(), false) {
  // Cell-elements follow each other; the first opening-element ends the last of them.
  const auto& cells = program.scene.cell_addresses;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint32_t end = cell + 1 < cells.size()
                                  ? cells[cell + 1]
                                  : cells.front() + static_cast<std::uint32_t>(program.scene.cell_words);
    for (std::uint32_t address = cells[cell]; address < end; ++address)
      cell_of_[address] = static_cast<std::int32_t>(cell);
  }
}

void Watch::begin(core::Instant time) {
  in_view_ = true;
  current_ = View{};
  current_.begun = time;
  seen_.assign(seen_.size(), false);
}

void Watch::end(core::Instant time) {
  if (!in_view_) return;
  in_view_ = false;
  current_.ended = time;
  for (const bool seen : seen_) current_.distinct_cells += seen ? 1 : 0;
  view_ = current_;
  stop_ = true;
}

void Watch::instruction(const machines::InstructionRecord& record) {
  ++current_.instructions;
  fetched(record.time, record.pc);
}

bool Watch::fetched(core::Instant time, pdp7::Address pc) {
  if (pc == labels_.search) begin(time);
  if (pc == labels_.visit) ++current_.visits;
  if (pc == labels_.opening) ++current_.openings;
  if (pc == labels_.line) ++current_.lines;
  if (pc == labels_.piece) ++current_.pieces;
  return pc == labels_.search;
}

void Watch::cycle(const pdp7::Cycle& cycle) {
  switch (cycle.verb) {
    case pdp7::Verb::fetch:
    case pdp7::Verb::read:
      if (const std::int32_t cell = cell_of_[cycle.address & pdp7::in_bank_mask]; cell >= 0)
        seen_[static_cast<std::size_t>(cell)] = true;
      break;
    case pdp7::Verb::write:
      if (!immediate_ && cycle.address == labels_.file) end(cycle.time + cycle.length);
      break;
    case pdp7::Verb::modify:
      if (immediate_ && cycle.address == labels_.views) end(cycle.time + cycle.length);
      break;
    case pdp7::Verb::break_read:
    case pdp7::Verb::break_write:
    case pdp7::Verb::break_modify: ++current_.stolen_cycles; break;
    case pdp7::Verb::interrupt:
    case pdp7::Verb::iot:
    case pdp7::Verb::idle: break;
  }
}

bool Watch::stop(core::Instant, pdp7::Address) {
  const bool stopping = stop_;
  stop_ = false;
  return stopping;
}

void PassWatch::wait_from(core::Instant from, Watch& watch) {
  watch_ = &watch;
  from_ = from;
  begun_.reset();
  ended_ = false;
  next_begun_.reset();
  pass_.clear();
}

void PassWatch::begin_pass(core::Instant t) {
  if (watch_ == nullptr || t < from_) return;
  if (!ended_) {
    begun_ = t;
    pass_.clear();
    return;
  }
  if (next_begun_) return;
  next_begun_ = t;
  watch_->request_stop();
}

void PassWatch::stroke(const core::Stroke& stroke) {
  if (begun_ && !ended_) pass_.push_back(stroke);
  if (keeping_) kept_.push_back(stroke);
}

void PassWatch::end_pass(core::Instant) {
  if (!begun_ || ended_) return;
  ended_ = true;
  watch_->request_stop();
}

core::Duration PassWatch::period() const {
  return next_begun_ && begun_ ? *next_begun_ - *begun_ : core::Duration(0);
}

constexpr std::uint32_t stop_word = 0003000;
// Far longer than the interrupt handler takes to start the display again.
constexpr core::Duration longest_pause = core::milliseconds(10);

template <class Machine>
void load(Machine& machine, const Program& program, std::span<const core::Word18> core,
          const GuestOptions& options) {
  deposit_core(machine, core);
  if (options.scale)
    machine.deposit(program.labels.scale, core::Word18(static_cast<std::uint32_t>(*options.scale)));
  if (!options.clock) machine.deposit(program.labels.clock, core::Word18(clock_off));
  machine.console().set(core::Word18((options.stereo ? 1U : 0U) | (options.immediate ? 2U : 0U)));
  if (!options.switches.empty()) machine.console().schedule(options.switches);
  machine.start(program.labels.start);
}

// The file being made, which is the one just published, up to its stop word.
template <class Machine>
std::vector<core::Word18> display_file(const Machine& machine, const Program& program) {
  std::vector<core::Word18> words;
  pdp7::Address address = machine.peek(program.labels.file_begun).value();
  while (words.size() < program.labels.file_words) {
    words.push_back(machine.peek(address++));
    if (words.back().value() == stop_word) break;
  }
  return words;
}

template <class Machine>
GuestView report(const Machine& machine, const Program& program, const Watch::View& watched) {
  GuestView view;
  view.status = static_cast<Status>(machine.peek(program.labels.status).value());
  view.time = watched.ended - watched.begun;
  view.instructions = watched.instructions;
  view.stolen_cycles = watched.stolen_cycles;
  view.visits = watched.visits;
  view.distinct_cells = watched.distinct_cells;
  view.openings_tested = watched.openings;
  view.lines_clipped = watched.lines;
  view.pieces = watched.pieces;
  view.display_file = display_file(machine, program);
  return view;
}

machines::Pdp7Options machine_for(const GuestOptions& options) {
  machines::Pdp7Options machine;
  machine.configuration.model.eae = options.eae;
  if (options.display) machine.display.emplace();
  return machine;
}

GuestRun run_without_display(const Program& program, std::span<const core::Word18> core, const GuestOptions& options) {
  ViewWatch watch(program, options.immediate);
  PassWatch passes;
  machines::Pdp7<PassWatch, ViewWatch> machine(machine_for(options), passes, watch);
  load(machine, program, core, options);
  machines::Limits limits;
  limits.until = core::Instant(options.time_limit);

  GuestRun run;
  std::uint64_t begun = 0;  // instructions before the view, its first one included
  while (static_cast<int>(run.views.size()) < options.views && !run.timed_out) {
    if (machine.run(limits) != machines::StopReason::observer) {
      run.timed_out = true;
    } else if (watch.has_begun()) {
      begun = machine.counts().instructions;
    } else {
      run.views.push_back(report(machine, program, watch.view()));
      // The one that ended the view is not counted.
      run.views.back().instructions = machine.counts().instructions - begun - 1;
    }
  }
  run.instructions = machine.counts().instructions;
  run.emulated = machine.now().time_since_epoch();
  return run;
}

}  // namespace

GuestRun run_guest(const Program& program, const GuestOptions& options) {
  return run_guest(program, program.core, options);
}

GuestRun run_guest(const Program& program, std::span<const core::Word18> core, const GuestOptions& options) {
  if (!options.display) return run_without_display(program, core, options);
  Watch watch(program, options.immediate);
  PassWatch passes;
  machines::Pdp7<PassWatch, Watch> machine(machine_for(options), passes, watch);
  load(machine, program, core, options);
  machines::Limits limits;
  limits.until = core::Instant(options.time_limit);

  GuestRun run;
  for (int n = 0; n < options.views && !run.timed_out; ++n) {
    if (machine.run(limits) != machines::StopReason::observer) {
      run.timed_out = true;
    } else {
      run.views.push_back(report(machine, program, watch.view()));
    }
  }
  if (options.display && !run.timed_out) {
    // The file just published is taken up at the next stop: the pass that begins from now on is its first.
    passes.wait_from(machine.now(), watch);
    while (!passes.complete() && !run.timed_out)
      run.timed_out = machine.run(limits) != machines::StopReason::observer;
    // A picture of nothing is not refreshed.
    machines::Limits soon = limits;
    soon.until = std::min(limits.until, machine.now() + longest_pause);
    while (!run.timed_out && !passes.repeated() && machine.run(soon) == machines::StopReason::observer) {
    }
    run.pass = passes.pass();
    run.refresh_period = passes.period();
    if (options.photograph.count() > 0) {
      passes.keep_strokes();
      run.shutter_close = machine.now() + options.photograph;
      limits.until = run.shutter_close;
      while (machine.run(limits) == machines::StopReason::observer) {
      }
      run.photograph = passes.kept();
    }
  }
  run.instructions = machine.counts().instructions;
  run.emulated = machine.now().time_since_epoch();
  return run;
}

}  // namespace sightline::guests::jones
