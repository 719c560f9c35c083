#include "host/programs/jones/guest.hpp"

#include <algorithm>
#include <utility>

#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"
#include "host/base/result.hpp"
#include "host/machines/stroke_keeper.hpp"
#include "host/machines/pdp7_watch.hpp"

namespace sightline::programs::jones {

namespace {

// Counts fetches at the program's labels, notes the cells whose words the processor reads, and stops the run when a view is
// published; while views are measured also when one begins, behind its first instruction.
class Watch final : public machines::ProgramWatch {
 public:
  // `immediate`: a view ends when it is counted, not when its file is first shown.
  Watch(const Program& program, bool immediate);

  void cycle(const pdp7::Cycle& cycle) override;

  struct View {
    core::Instant begun;
    core::Instant ended;
    std::uint64_t visits = 0;
    std::uint64_t openings = 0;
    std::uint64_t lines = 0;
    std::uint64_t pieces = 0;
    std::uint64_t distinct_cells = 0;
  };
  // A view has begun, and the run stopped there; asked once.
  [[nodiscard]] bool has_begun() { return std::exchange(begins_, false); }
  // The view that ended last.
  [[nodiscard]] const View& view() const { return view_; }
  // From now on the run stops only where views end.
  void end_measuring() { measures_ = false; }

 private:
  void fetched_at(pdp7::Address pc, core::Instant time);
  void begin(core::Instant time);
  void end(core::Instant time);

  Labels labels_;
  pdp7::Address last_written_;  // by the instruction that ends a view
  pdp7::Verb ends_;             // how
  bool measures_ = true;
  bool begins_ = false;
  bool in_view_ = false;
  View current_;
  View view_;
  std::vector<std::int32_t> cell_of_;  // by core address: the cell whose element is there, or -1
  std::vector<bool> seen_;             // by cell
};

// Keeps one pass of one display file and stops the run when it has what it waits for.
class PassWatch final : public machines::StrokeKeeper {
 public:
  explicit PassWatch(pdp7::Machine& machine) : machine_(machine) {}

  // Wait for a pass that begins at or after `from`: the run stops when it is complete, and again when the next pass begins.
  void wait_from(core::Instant from) { from_ = from; }
  // Or the strokes so far of one that has not ended. Nothing is waited for any longer.
  [[nodiscard]] std::vector<core::Stroke> take_pass();
  // Keep every stroke from now on, for a photograph.
  void photograph() { keep_strokes(true); }
  [[nodiscard]] std::vector<core::Stroke> take_photograph() { return take_strokes(); }

  void begin_pass(core::Instant t) override;
  void end_pass(core::Instant t) override;

  [[nodiscard]] bool complete() const { return ended_; }
  [[nodiscard]] bool repeated() const { return next_begun_.has_value(); }
  // From its beginning to that of the next pass; 0 while that has not begun.
  [[nodiscard]] core::Duration period() const;

 private:
  pdp7::Machine& machine_;
  core::Instant from_ = core::never;
  std::optional<core::Instant> begun_;  // of the pass waited for
  bool ended_ = false;
  std::optional<core::Instant> next_begun_;
};

Watch::Watch(const Program& program, bool immediate)
    : labels_(program.labels),
      last_written_(immediate ? labels_.views : labels_.file),
      ends_(immediate ? pdp7::Verb::modify : pdp7::Verb::write),
      cell_of_(core_words, -1),
      seen_(program.scene.cell_addresses.size(), false) {
  // Cell-elements follow each other; the first opening-element ends the last of them.
  const auto& cells = program.scene.cell_addresses;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint32_t end = cell + 1 < cells.size()
                                  ? cells[cell + 1]
                                  : cells.front() + static_cast<std::uint32_t>(program.scene.cell_words);
    for (std::uint32_t address = cells[cell]; address < end; ++address) {
      cell_of_[address] = static_cast<std::int32_t>(cell);
      mark(address, pdp7::mark::fetched | pdp7::mark::read);
    }
  }
  for (const pdp7::Address label : {labels_.search, labels_.visit, labels_.opening, labels_.line, labels_.piece})
    mark(label, pdp7::mark::fetched);
  mark(last_written_, pdp7::mark::written);
}

void Watch::begin(core::Instant time) {
  in_view_ = true;
  current_ = View{};
  current_.begun = time;
  seen_.assign(seen_.size(), false);
  if (!measures_) return;
  begins_ = true;
  request_stop();
}

void Watch::end(core::Instant time) {
  if (!in_view_) return;
  in_view_ = false;
  current_.ended = time;
  for (const bool seen : seen_) current_.distinct_cells += seen ? 1 : 0;
  view_ = current_;
  request_stop();
}

void Watch::fetched_at(pdp7::Address pc, core::Instant time) {
  if (pc == labels_.search) begin(time);
  if (pc == labels_.visit) ++current_.visits;
  if (pc == labels_.opening) ++current_.openings;
  if (pc == labels_.line) ++current_.lines;
  if (pc == labels_.piece) ++current_.pieces;
}

void Watch::cycle(const pdp7::Cycle& cycle) {
  if (cycle.verb == ends_ && cycle.address == last_written_) return end(cycle.time + cycle.length);
  if (cycle.verb != pdp7::Verb::fetch && cycle.verb != pdp7::Verb::read) return;
  if (cycle.verb == pdp7::Verb::fetch) fetched_at(cycle.address, cycle.time);
  if (const std::int32_t cell = cell_of_[cycle.address]; cell >= 0) seen_[static_cast<std::size_t>(cell)] = true;
}

void PassWatch::begin_pass(core::Instant t) {
  if (t < from_) return;
  if (!ended_) {
    begun_ = t;
    forget_strokes();
    keep_strokes(true);
    return;
  }
  if (next_begun_) return;
  next_begun_ = t;
  machine_.request_stop();
}

void PassWatch::end_pass(core::Instant) {
  if (!begun_ || ended_) return;
  ended_ = true;
  keep_strokes(false);
  machine_.request_stop();
}

std::vector<core::Stroke> PassWatch::take_pass() {
  from_ = core::never;
  begun_.reset();
  keep_strokes(false);
  return take_strokes();
}

core::Duration PassWatch::period() const {
  return next_begun_ && begun_ ? *next_begun_ - *begun_ : core::Duration(0);
}

constexpr std::uint32_t stop_word = 0003000;
// Far longer than the interrupt handler takes to start the display again.
constexpr core::Duration longest_pause = core::milliseconds(10);

void load(pdp7::Machine& machine, const Program& program, std::span<const core::Word18> core, const GuestOptions& options) {
  machine.load(0, core);
  if (options.scale)
    machine.deposit(program.labels.scale, core::Word18(static_cast<std::uint32_t>(*options.scale)));
  if (!options.clock) machine.deposit(program.labels.clock, core::Word18(clock_off));
  machine.console().set(core::Word18((options.stereo ? 1U : 0U) | (options.immediate ? 2U : 0U)));
  if (!options.switches.empty()) machine.console().schedule(options.switches);
  machine.start(program.labels.start);
}

// The file being made, which is the one just published, up to its stop word.
std::vector<core::Word18> display_file(const pdp7::Machine& machine, const Program& program) {
  std::vector<core::Word18> words;
  pdp7::Address address = machine.peek(program.labels.file_begun).value();
  while (words.size() < program.labels.file_words) {
    words.push_back(machine.peek(address++));
    if (words.back().value() == stop_word) break;
  }
  return words;
}

// `begun`: when the first instruction of the view had been done. Neither that nor the last, which has just been done, is counted.
GuestView report(const pdp7::Machine& machine, const Program& program, const Watch::View& watched, const pdp7::Counts& begun) {
  const pdp7::Counts ended = machine.counts();
  GuestView view;
  view.status = static_cast<Status>(machine.peek(program.labels.status).value());
  view.time = watched.ended - watched.begun;
  view.instructions = ended.instructions - begun.instructions - 1;
  view.stolen_cycles = ended.stolen_cycles - begun.stolen_cycles;
  view.visits = watched.visits;
  view.distinct_cells = watched.distinct_cells;
  view.openings_tested = watched.openings;
  view.lines_clipped = watched.lines;
  view.pieces = watched.pieces;
  view.display_file = display_file(machine, program);
  return view;
}

pdp7::Options machine_for(const GuestOptions& options) {
  pdp7::Options machine;
  machine.model.eae = options.eae;
  if (options.display) machine.devices.push_back(type340::Display::info.name);
  return machine;
}

// The first pass through the file that has just been published, and a photograph behind it.
void watch_display(pdp7::Machine& machine, Watch& watch, PassWatch& passes, const GuestOptions& options, GuestRun& run) {
  pdp7::Limits limits;
  limits.until = core::Instant(options.time_limit);
  watch.end_measuring();
  // The file is taken up at the next stop: the pass that begins from now on is its first.
  passes.wait_from(machine.now());
  while (!passes.complete() && !run.timed_out) run.timed_out = machine.run(limits, watch) != pdp7::StopReason::observer;
  // A picture of nothing is not refreshed.
  pdp7::Limits soon = limits;
  soon.until = std::min(limits.until, machine.now() + longest_pause);
  while (!run.timed_out && !passes.repeated() && machine.run(soon, watch) == pdp7::StopReason::observer) {
  }
  run.refresh_period = passes.period();
  run.pass = passes.take_pass();
  if (options.photograph.count() <= 0) return;
  passes.photograph();
  run.shutter_close = machine.now() + options.photograph;
  limits.until = run.shutter_close;
  while (machine.run(limits, watch) == pdp7::StopReason::observer) {
  }
  run.photograph = passes.take_photograph();
}

}  // namespace

GuestRun run_guest(const Program& program, const GuestOptions& options) {
  return run_guest(program, program.core, options);
}

GuestRun run_guest(const Program& program, std::span<const core::Word18> core, const GuestOptions& options) {
  Watch watch(program, options.immediate);
  pdp7::Machine machine(machine_for(options));
  if (!machine.error().empty()) base::give_up(machine.error());
  PassWatch passes(machine);
  machine.strokes().hand_to(&passes);
  load(machine, program, core, options);
  pdp7::Limits limits;
  limits.until = core::Instant(options.time_limit);

  GuestRun run;
  pdp7::Counts begun;
  while (static_cast<int>(run.views.size()) < options.views && !run.timed_out) {
    if (machine.run(limits, watch) != pdp7::StopReason::observer) {
      run.timed_out = true;
    } else if (watch.has_begun()) {
      begun = machine.counts();
    } else {
      run.views.push_back(report(machine, program, watch.view(), begun));
    }
  }
  if (options.display && !run.timed_out) watch_display(machine, watch, passes, options, run);
  run.instructions = machine.counts().instructions;
  run.emulated = machine.now().time_since_epoch();
  return run;
}

}  // namespace sightline::programs::jones
