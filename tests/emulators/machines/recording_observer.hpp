// An observer that records every bus event and every instruction, and can stop the run on request.
#pragma once

#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"

namespace sightline::tests {

struct RecordingObserver final : pdp7::Observer {
  RecordingObserver() { instructions = true; }

  struct Step {
    core::Instant time;
    core::Instant end;
    pdp7::Address pc;
    core::Word18 word;
    pdp7::State after;
  };

  void instruction(const pdp7::InstructionRecord& r) override { steps.push_back({r.time, r.end, r.pc, r.word, r.after}); }
  void cycle(const pdp7::Cycle& c) override {
    events.push_back(c);
    if (c.verb == pdp7::Verb::write && c.address == stop_on_write) asked = true;
  }
  bool stop(core::Instant, pdp7::Address) override { return std::exchange(asked, false); }

  std::vector<Step> steps;
  std::vector<pdp7::Cycle> events;
  pdp7::Address stop_on_write = ~pdp7::Address{0};
  bool asked = false;
};

}  // namespace sightline::tests
