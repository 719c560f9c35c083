#include "host/programs/jones/jones.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"
#include "host/base/text.hpp"
#include "host/machines/pdp7_watch.hpp"
#include "host/machines/stroke_keeper.hpp"
#include "host/programs/jones/twin/walk.hpp"

namespace sightline::programs::jones {

namespace {

// Records the line pieces of a view as the program draws them. Source of the labels: firmware/pdp7/jones/NOTES.md.
class PieceRecorder {
 public:
  explicit PieceRecorder(const Program& program) : drawn_(program.labels.piece), clipped_at_(program.symbols.at("piece") + 1) {
    constexpr std::array names{"lax", "lay", "lbx", "lby", "pax", "pay", "pbx", "pby"};
    for (std::size_t i = 0; i < names.size(); ++i) words_[i].address = program.symbols.at(names[i]);
    words_[vectors].address = vector_pointer;
  }

  // The words whose stores it must observe; it must also observe the fetch at `fetched_label`.
  template <class Mark>
  void for_each_word(Mark&& mark) const {
    for (const Word& word : words_) mark(word.address);
  }
  [[nodiscard]] pdp7::Address fetched_label() const { return clipped_at_; }

  void begin() {
    clipped_.clear();
    on_display_.clear();
  }
  void fetched_at(pdp7::Address pc) {
    if (pc == drawn_) clipped_.back().drawn = true;
    if (pc != clipped_at_) return;
    Piece& piece = clipped_.emplace_back();
    piece.vector_address = static_cast<std::uint16_t>(words_[vectors].word.value() & pdp7::in_bank_mask);
    piece.line = {{at(0), at(1)}, {at(2), at(3)}};
    piece.drawn = false;  // until it has been added to the file
  }
  void stored(pdp7::Address address, core::Word18 stored, bool in_view) {
    for (Word& word : words_)
      if (word.address == address) word.word = stored;
    // The ends on the screen are stored in this order, after the piece was recorded.
    if (in_view && address == words_[last_end].address && !clipped_.empty()) on_display_.push_back({{at(4), at(5)}, {at(6), at(7)}});
  }
  void give(View& view) {
    view.clipped = std::move(clipped_);
    view.on_display = std::move(on_display_);
  }

 private:
  static constexpr pdp7::Address vector_pointer = 010;  // auto-index register that reads the vectors of a chain
  static constexpr std::size_t last_end = 7, vectors = 8;

  // A word into which the program repeatedly stores.
  struct Word {
    pdp7::Address address = 0;
    core::Word18 word;
  };
  [[nodiscard]] std::int32_t at(std::size_t word) const { return words_[word].word.twos_complement(); }

  pdp7::Address drawn_;
  pdp7::Address clipped_at_;
  std::array<Word, 9> words_;
  std::vector<Piece> clipped_;
  std::vector<ScreenSegment> on_display_;
};

// Counts fetches at the program's labels, records the cells whose words the processor reads, and stops the run when a view
// is published; while views are measured, also when one begins, after its first instruction.
class Watch final : public machines::ProgramWatch {
 public:
  Watch(const Program& program, const Order& order);

  void cycle(const pdp7::Cycle& cycle) override;

  struct Watched {
    core::Instant begun;
    core::Instant ended;
    std::uint64_t visits = 0;
    std::uint64_t openings = 0;
    std::uint64_t lines = 0;
    std::uint64_t pieces = 0;
    std::uint64_t distinct_cells = 0;
  };
  // Whether the run stopped because a view has begun; resets the answer.
  [[nodiscard]] bool has_begun() { return std::exchange(begins_, false); }
  // The view that ended last.
  [[nodiscard]] const Watched& view() const { return view_; }
  // Moves the line pieces into the view, if the order asks for them.
  void give_pieces(View& view) {
    if (pieces_) pieces_->give(view);
  }
  // From now on the run stops only where views end.
  void end_measuring() { measures_ = false; }

 private:
  void fetched_at(pdp7::Address pc, core::Instant time);
  void begin(core::Instant time);
  void end(core::Instant time);

  Labels labels_;
  pdp7::Address last_written_;  // by the last instruction of a view
  pdp7::Verb ends_;             // how that instruction accesses it
  bool measures_ = true;
  bool begins_ = false;
  bool in_view_ = false;
  Watched current_;
  Watched view_;
  std::optional<PieceRecorder> pieces_;
  std::vector<std::int32_t> cell_of_;  // by core address: the cell whose element is there, or -1
  std::vector<bool> seen_;             // by cell
};

// Keeps one pass of one display file, and stops the run when the awaited pass is complete.
class PassWatch final : public machines::StrokeKeeper {
 public:
  explicit PassWatch(pdp7::Machine& machine) : machine_(machine) {}

  // Waits for a pass that begins at or after `from`: the run stops when it is complete, and again when the next pass
  // begins.
  void wait_from(core::Instant from) { from_ = from; }
  // The pass, or the strokes so far if it has not ended. Ends the waiting.
  [[nodiscard]] std::vector<core::Stroke> take_pass();
  // Keep every stroke from now on, for a photograph.
  void photograph() { keep_strokes(true); }
  [[nodiscard]] std::vector<core::Stroke> take_photograph() { return take_strokes(); }

  void begin_pass(core::Instant t) override;
  void end_pass(core::Instant t) override;

  [[nodiscard]] bool complete() const { return ended_; }
  [[nodiscard]] bool repeated() const { return next_begun_.has_value(); }
  // From the beginning of the pass to that of the next; 0 while that has not begun.
  [[nodiscard]] core::Duration period() const;

 private:
  pdp7::Machine& machine_;
  core::Instant from_ = core::never;
  std::optional<core::Instant> begun_;  // of the awaited pass
  bool ended_ = false;
  std::optional<core::Instant> next_begun_;
};

// If lines are added at once, a view ends when it is counted, not when its file is first shown.
Watch::Watch(const Program& program, const Order& order)
    : labels_(program.labels),
      last_written_(order.immediate ? labels_.views : labels_.file),
      ends_(order.immediate ? pdp7::Verb::modify : pdp7::Verb::write),
      cell_of_(core_words, -1),
      seen_(program.scene.cell_addresses.size(), false) {
  // Cell-elements are adjacent, those of a walk each with three planes before it.
  const auto& cells = program.scene.cell_addresses;
  const std::uint32_t planes = program.build.walk ? 3 : 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint32_t next = cell + 1 < cells.size()
                                  ? cells[cell + 1]
                                  : cells.front() + static_cast<std::uint32_t>(program.scene.cell_words);
    const std::uint32_t end = next - planes;
    for (std::uint32_t address = cells[cell]; address < end; ++address) {
      cell_of_[address] = static_cast<std::int32_t>(cell);
      mark(address, pdp7::mark::fetched | pdp7::mark::read);
    }
  }
  for (const pdp7::Address label : {labels_.search, labels_.visit, labels_.opening, labels_.line, labels_.piece})
    mark(label, pdp7::mark::fetched);
  mark(last_written_, pdp7::mark::written);
  if (!order.pieces) return;
  pieces_.emplace(program);
  mark(pieces_->fetched_label(), pdp7::mark::fetched);
  pieces_->for_each_word([this](pdp7::Address address) { mark(address, pdp7::mark::written); });
}

void Watch::begin(core::Instant time) {
  in_view_ = true;
  current_ = Watched{};
  current_.begun = time;
  if (pieces_) pieces_->begin();
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
  // What the walk reads of the cells is not counted.
  if (pc == labels_.visit && current_.visits++ == 0) seen_.assign(seen_.size(), false);
  if (pc == labels_.opening) ++current_.openings;
  if (pc == labels_.line) ++current_.lines;
  if (pc == labels_.piece) ++current_.pieces;
  if (pieces_ && in_view_) pieces_->fetched_at(pc);
}

void Watch::cycle(const pdp7::Cycle& cycle) {
  if (cycle.verb == ends_ && cycle.address == last_written_) return end(cycle.time + cycle.length);
  if (pieces_ && (cycle.verb == pdp7::Verb::write || cycle.verb == pdp7::Verb::modify))
    pieces_->stored(cycle.address, cycle.data, in_view_);
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

void load(pdp7::Machine& machine, const Program& program, std::span<const core::Word18> core, const Order& order) {
  machine.load(0, core);
  if (order.scale)
    machine.deposit(program.labels.scale, core::Word18(static_cast<std::uint32_t>(*order.scale)));
  if (program.build.rotation) machine.deposit(program.labels.first_angle, core::Word18(static_cast<std::uint32_t>(order.angle)));
  if (!order.clock) machine.deposit(program.labels.clock, core::Word18(clock_off));
  machine.console().set(core::Word18((order.stereo ? 1U : 0U) | (order.immediate ? 2U : 0U)));
  if (!order.switches.empty()) machine.console().schedule(order.switches);
  machine.start(program.labels.start);
}

// The file under construction, which is the one just published, up to its stop word.
std::vector<core::Word18> display_file(const pdp7::Machine& machine, const Program& program) {
  std::vector<core::Word18> words;
  pdp7::Address address = machine.peek(program.labels.file_begun).value();
  while (words.size() < program.labels.file_words) {
    words.push_back(machine.peek(address++));
    if (words.back().value() == stop_word) break;
  }
  return words;
}

// The number of the cell with this element; the number of cells if none has.
std::size_t cell_at(const Program& program, std::uint32_t address) {
  const auto& cells = program.scene.cell_addresses;
  return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), address) - cells.begin());
}

// `begun`: the counts after the view's first instruction. Neither that instruction nor the last, just executed, is counted.
View view_of(const pdp7::Machine& machine, const Program& program, Watch& watch, const pdp7::Counts& begun) {
  const Watch::Watched& watched = watch.view();
  const pdp7::Counts ended = machine.counts();
  View view;
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
  for (std::size_t a = 0; a < 3; ++a) view.eye[a] = machine.peek(program.labels.eye + static_cast<pdp7::Address>(a)).twos_complement();
  view.cell = cell_at(program, machine.peek(program.labels.scene).value());
  if (program.build.walk) view.stops = machine.peek(program.labels.stops).value();
  if (program.build.rotation) view.angle = machine.peek(program.labels.angle).twos_complement();
  watch.give_pieces(view);
  return view;
}

pdp7::Options machine_for(const Program& program, const Order& order) {
  pdp7::Options machine;
  machine.model.eae = program.build.eae;
  if (order.display) machine.devices.push_back(type340::Display::info.name);
  return machine;
}

// Takes the first pass through the file that has just been published, and then a photograph. False: the time limit came
// first.
bool take_display(pdp7::Machine& machine, Watch& watch, PassWatch& passes, const Order& order, Outcome& outcome) {
  pdp7::Limits limits;
  limits.until = core::Instant(order.time_limit);
  watch.end_measuring();
  // Lines of the next view are not to be added before the pass is complete: the switch for it goes down.
  if (order.immediate) {
    machine.console().schedule({});
    machine.console().set(core::Word18(order.stereo ? 1U : 0U));
  }
  // The display changes to the file at the next stop: the pass that begins from now on is the file's first.
  passes.wait_from(machine.now());
  while (!passes.complete())
    if (machine.run(limits, watch) != pdp7::StopReason::observer) return false;
  // An empty picture is not refreshed.
  pdp7::Limits soon = limits;
  soon.until = std::min(limits.until, machine.now() + longest_pause);
  while (!passes.repeated() && machine.run(soon, watch) == pdp7::StopReason::observer) {
  }
  outcome.refresh_period = passes.period();
  outcome.pass = passes.take_pass();
  if (order.photograph.count() <= 0) return true;
  passes.photograph();
  outcome.shutter_close = machine.now() + order.photograph;
  limits.until = outcome.shutter_close;
  while (machine.run(limits, watch) == pdp7::StopReason::observer) {
  }
  outcome.photograph = passes.take_photograph();
  return true;
}

std::size_t views_of(const Order& order) {
  return order.walk.empty() ? static_cast<std::size_t>(order.views) : order.walk.size() + 1;
}

// Replaces what the switches have summed up since the last view: the program has copied the sums, and has not taken the
// steps.
void put_steps(pdp7::Machine& machine, const Program& program, const Move& move) {
  const auto put = [&](pdp7::Address word, std::int32_t number) { machine.deposit(program.labels.steps + word, core::Word18(static_cast<std::uint32_t>(number))); };
  for (std::size_t a = 0; a < 3; ++a) put(static_cast<pdp7::Address>(a), move.steps[a]);
  if (program.build.rotation) put(3, move.turn);
}

// Runs the machine until the views are complete and the display has shown the last one. False: the time limit came first.
bool take_views(pdp7::Machine& machine, PassWatch& passes, const Program& program, const Order& order, Outcome& outcome) {
  Watch watch(program, order);
  pdp7::Limits limits;
  limits.until = core::Instant(order.time_limit);
  pdp7::Counts begun;
  if (order.film) passes.photograph();
  while (outcome.views.size() < views_of(order)) {
    if (machine.run(limits, watch) != pdp7::StopReason::observer) return false;
    if (watch.has_begun()) {
      begun = machine.counts();
      if (const std::size_t n = outcome.views.size(); n > 0 && n <= order.walk.size()) put_steps(machine, program, order.walk[n - 1]);
      continue;
    }
    outcome.views.push_back(view_of(machine, program, watch, begun));
    if (!order.film || outcome.views.size() != 1) continue;
    outcome.film_end = machine.now();
    outcome.film = passes.take_photograph();
  }
  return !order.display || take_display(machine, watch, passes, order, outcome);
}

// Words 2 to 4 of the scene's header.
geometry::Point eye_in(const Program& program, std::span<const core::Word18> core) {
  geometry::Point eye{};
  for (std::size_t a = 0; a < 3; ++a) eye[a] = core[program.labels.scene + 2 + a].twos_complement();
  return eye;
}

// An accepted eye: that of the default view, or otherwise the middle of a cell. Error: that of viewpoint() for the default
// view.
base::Result<geometry::Point> find_accepted_eye(const scene::CellScene& scene) {
  const auto place = viewpoint(scene, scene.default_view);
  if (place) return scene.default_view;
  for (const scene::Cell& cell : scene.cells) {
    geometry::Point middle{};
    for (std::size_t a = 0; a < 3; ++a) middle[a] = cell.box.low[a] + (cell.box.high[a] - cell.box.low[a]) / 2;
    if (viewpoint(scene, middle)) return middle;
  }
  return place.error();
}

}  // namespace

double Outcome::refreshes_per_second() const {
  return refresh_period.count() > 0 ? 1.0 / core::in_seconds(refresh_period) : 0.0;
}

std::string difference_of(const View& view, const TwinView& twin) {
  if (view.status != twin.status) return fmt::format("status {}, the twin's {}", name(view.status), name(twin.status));
  const auto& a = view.display_file;
  const auto& b = twin.display_file;
  const auto [here, there] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (here == a.end() && there == b.end()) return "";
  const auto word = [](auto at, const auto& words) {
    return at == words.end() ? std::string("none") : fmt::format("{:06o}", at->value());
  };
  return fmt::format("word {} of the display file is {}, the twin's {}", here - a.begin(), word(here, a), word(there, b));
}

std::string difference_of_walk(const Program& program, std::span<const core::Word18> core, const Order& order, const Outcome& outcome) {
  Walk walk({core.begin(), core.end()}, program.labels.scene, program.scene.cell_addresses.front());
  TwinView view;
  std::int32_t angle = whole_turn(order.angle);
  TurnedSteps turned;
  for (std::size_t n = 0; n < outcome.views.size(); ++n) {
    const View& machine = outcome.views[n];
    view = TwinView{};
    Move move = n > 0 && n <= order.walk.size() ? order.walk[n - 1] : Move{};
    if (program.build.rotation) {
      angle = whole_turn(angle + move.turn);
      const auto [x, z] = turned.take(direction_of(angle), move.steps[0], move.steps[2]);
      move.steps = {x, move.steps[1], z};
    }
    view.status = walk.take(move.steps);
    if (angle != machine.angle) return fmt::format("view {} is turned by {} degrees, the twin's by {}", n + 1, machine.angle, angle);
    if (walk.eye() != machine.eye || walk.stops() != machine.stops || cell_at(program, walk.cell()) != machine.cell)
      return fmt::format("the eye of view {} is at {} in cell {}, the twin's at {} in cell {}", n + 1, base::joined(machine.eye, ","), machine.cell,
                         base::joined(walk.eye(), ","), cell_at(program, walk.cell()));
  }
  if (view.status != Status::complete) return view.status == outcome.view().status ? "" : difference_of(outcome.view(), view);
  std::vector<core::Word18> there = walk.core();
  for (std::size_t a = 0; a < 3; ++a) there[program.labels.scene + 2 + a] = core::Word18(static_cast<std::uint32_t>(walk.eye()[a]));
  Order last = order;
  last.angle = angle;
  return difference_of(outcome.view(), run_twin(program, there, last));
}

base::Result<Outcome> run_core(const Program& program, std::span<const core::Word18> core, const Order& order) {
  pdp7::Machine machine(machine_for(program, order));
  if (!machine.error().empty()) base::give_up(machine.error());
  PassWatch passes(machine);
  machine.strokes().hand_to(&passes);
  load(machine, program, core, order);
  Outcome outcome;
  outcome.eye = eye_in(program, core);
  outcome.core_words = program.words_used;
  const bool complete = take_views(machine, passes, program, order, outcome);
  outcome.instructions = machine.counts().instructions;
  outcome.emulated = machine.now().time_since_epoch();
  if (!complete)
    return base::program_failed(
        fmt::format("the program did not complete a view in {:.0f} emulated seconds", core::in_seconds(outcome.emulated)));
  if (!order.check) return outcome;
  const std::string difference = program.build.walk ? difference_of_walk(program, core, order, outcome)
                                                    : difference_of(outcome.view(), run_twin(program, core, order));
  if (!difference.empty())
    return base::difference("internal error: the view on the PDP-7 is not the one its native twin computes: " + difference);
  return outcome;
}

TwinView run_twin(const Program& program, std::span<const core::Word18> core, const Order& order) {
  Parameters parameters = default_parameters(core, program.labels.scene);
  if (order.scale) parameters.scale = *order.scale;
  parameters.stereo = order.stereo;
  parameters.immediate = order.immediate;
  parameters.fraction_bits = static_cast<int>(program.build.fraction_bits);
  parameters.truncate = program.build.truncate;
  if (program.build.rotation) parameters.direction = direction_of(order.angle);
  return run_twin(core, program.labels.scene, parameters);
}

base::Result<Outcome> run(const scene::CellScene& scene, const Build& build, const Order& order) {
  const auto place = viewpoint(scene, order.eye.value_or(scene.default_view));
  if (!place) return place.error();
  const auto prepared = Prepared::of(scene, build);
  if (!prepared) return prepared.error();
  return prepared->run(order);
}

Prepared::Prepared(const scene::CellScene& scene, Program program) : scene_(scene), program_(std::move(program)) {}

base::Result<Prepared> Prepared::of(const scene::CellScene& scene, const Build& build) {
  const auto eye = find_accepted_eye(scene);
  if (!eye) return eye.error();
  auto program = assemble_program(scene, build, *eye);
  if (!program) return program.error();
  return Prepared(scene, std::move(*program));
}

base::Result<std::vector<core::Word18>> Prepared::core_at(const geometry::Point& eye) const {
  const auto view = viewpoint(scene_, eye);
  if (!view) return view.error();
  std::vector<core::Word18> core = program_.core;
  pdp7::Address address = program_.labels.scene;
  for (const std::uint32_t word : header_words(program_.scene, *view)) core[address++] = core::Word18(word);
  return core;
}

base::Result<Outcome> Prepared::run(const Order& order) const {
  const auto core = core_at(eye_of(order));
  if (!core) return core.error();
  return run_core(program_, *core, order);
}

base::Result<TwinView> Prepared::twin(const Order& order) const {
  const auto core = core_at(eye_of(order));
  if (!core) return core.error();
  return run_twin(program_, *core, order);
}

}  // namespace sightline::programs::jones
