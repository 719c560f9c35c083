#include "host/guests/jones/watch.hpp"

namespace sightline::guests::jones {

Watch::Watch(const Program& program, bool immediate)
    : labels_(program.labels),
      immediate_(immediate),
      cell_of_(core_words, -1),
      seen_(program.scene.cell_addresses.size(), false) {
  // Cell-elements stand one after the other; the first opening-element ends the last of them.
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
  const pdp7::Address pc = record.pc;
  if (pc == labels_.search) begin(record.time);
  if (pc == labels_.visit) ++current_.visits;
  if (pc == labels_.opening) ++current_.openings;
  if (pc == labels_.line) ++current_.lines;
  if (pc == labels_.piece) ++current_.pieces;
}

void Watch::cycle(const pdp7::Cycle& cycle) {
  switch (cycle.verb) {
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
    case pdp7::Verb::iot:
    case pdp7::Verb::idle: break;
  }
}

bool Watch::stop() {
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

}  // namespace sightline::guests::jones
