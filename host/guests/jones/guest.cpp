#include "host/guests/jones/guest.hpp"

#include <algorithm>

#include "emulators/machines/pdp7.hpp"
#include "host/guests/jones/watch.hpp"

namespace sightline::guests::jones {

namespace {

constexpr std::uint32_t stop_word = 0003000;
// Far longer than the interrupt handler takes to start the display again.
constexpr core::Duration longest_pause = core::milliseconds(10);

template <class Machine>
void load(Machine& machine, const Program& program, const GuestOptions& options) {
  for (const auto& [address, word] : program.core) machine.deposit(address, word);
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

}  // namespace

GuestRun run_guest(const Program& program, const GuestOptions& options) {
  Watch watch(program, options.immediate);
  PassWatch passes;
  machines::Pdp7<PassWatch, Watch> machine(machine_for(options), passes, watch);
  load(machine, program, options);
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
