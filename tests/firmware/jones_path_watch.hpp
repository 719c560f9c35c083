// Watches a view of Jones's program by its core cycles alone: when it began and ended, how deep the search went, and which cell
// was current at each depth. Smaller than the watch of host/programs/jones, and independent of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "tests/firmware/jones_core.hpp"

namespace sightline::programs::jones {

class PathWatch final : public pdp7::Observer {
 public:
  PathWatch(const Program& program, bool immediate)
      : labels_(program.labels),
        depth_at_(tag(program, "depth")),
        cell_at_(tag(program, "cell")),
        immediate_(immediate) {}

  void cycle(const pdp7::Cycle& cycle) override {
    const bool writes = cycle.verb == pdp7::Verb::write, counts = cycle.verb == pdp7::Verb::modify;
    if (cycle.verb == pdp7::Verb::fetch && cycle.address == labels_.search) {
      begun_ = cycle.time;
      searching_ = true;
    }
    if (!searching_) return;
    if (writes && cycle.address == cell_at_) cell_ = cycle.data.value();
    if (counts && cycle.address == depth_at_) visit(cycle.data.value());
    if (immediate_ ? counts && cycle.address == labels_.views : writes && cycle.address == labels_.file) {
      ended_ = cycle.time + cycle.length;
      stop_ = true;
    }
  }
  bool stop(core::Instant, pdp7::Address) override { return std::exchange(stop_, false); }

  [[nodiscard]] core::Duration time() const { return ended_ - begun_; }
  [[nodiscard]] std::uint64_t visits() const { return visits_; }
  [[nodiscard]] std::size_t depth() const { return deepest_; }
  // The search entered a cell that was already on the path to it.
  [[nodiscard]] bool reentered() const { return reentered_; }

 private:
  void visit(std::size_t depth) {
    ++visits_;
    deepest_ = std::max(deepest_, depth);
    path_.resize(depth - 1);
    reentered_ = reentered_ || std::find(path_.begin(), path_.end(), cell_) != path_.end();
    path_.push_back(cell_);
  }

  Labels labels_;
  pdp7::Address depth_at_;
  pdp7::Address cell_at_;
  bool immediate_;
  bool searching_ = false;
  bool stop_ = false;
  core::Instant begun_{};
  core::Instant ended_{};
  std::uint32_t cell_ = 0;
  std::uint64_t visits_ = 0;
  std::size_t deepest_ = 0;
  bool reentered_ = false;
  std::vector<std::uint32_t> path_;
};

// The file just published, up to its stop.
inline std::vector<core::Word18> file_words(const pdp7::Machine& machine, const Program& program) {
  std::vector<core::Word18> words;
  pdp7::Address at = machine.peek(program.labels.file_begun).value();
  do words.push_back(machine.peek(at++));
  while (words.back().value() != 03000 && words.size() < program.labels.file_words);
  return words;
}

// One view without display and clock.
struct DarkView {
  Status status = Status::unfinished;  // no view within the time limit
  std::vector<core::Word18> display_file;
  core::Duration time{};
  std::uint64_t visits = 0;
  std::size_t depth = 0;
  bool reentered = false;
};

inline DarkView dark_view(const Program& program, bool eae, const Parameters& parameters) {
  PathWatch watch(program, parameters.immediate);
  pdp7::Options options;
  options.model.eae = eae;
  pdp7::Machine machine(options);
  machine.load(0, program.core);
  machine.deposit(program.labels.scale, word_of(parameters.scale));
  machine.deposit(program.labels.clock, core::Word18(0700004));
  machine.console().set(core::Word18((parameters.stereo ? 1U : 0U) | (parameters.immediate ? 2U : 0U)));
  machine.start(program.labels.start);
  pdp7::Limits limits;
  limits.until = core::Instant(core::seconds(600));
  DarkView view;
  if (machine.run(limits, watch) != pdp7::StopReason::observer) return view;
  view.status = static_cast<Status>(machine.peek(program.labels.status).value());
  view.display_file = file_words(machine, program);
  view.time = watch.time();
  view.visits = watch.visits();
  view.depth = watch.depth();
  view.reentered = watch.reentered();
  return view;
}

}  // namespace sightline::programs::jones
