// What is watched while Jones's program runs: a machine observer that counts fetches at the program's labels,
// marks the cells whose words the processor reads, and stops the run when a view is published; and a stroke
// sink that knows which pass of the display began when.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/observer.hpp"
#include "emulators/pdp7/bus.hpp"
#include "host/guests/jones/program.hpp"

namespace sightline::guests::jones {

class Watch {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  // `immediate`: a view ends when it is counted, not when its file is first shown.
  Watch(const Program& program, bool immediate);

  void instruction(const machines::InstructionRecord& record);
  void cycle(const pdp7::Cycle& cycle);
  // True once after each published view, and whenever `until` says so.
  bool stop();

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
  std::vector<std::int32_t> cell_of_;  // by core address: the cell whose element stands there, or -1
  std::vector<bool> seen_;             // by cell
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

}  // namespace sightline::guests::jones
