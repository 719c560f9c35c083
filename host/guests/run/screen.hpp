// What a run keeps of the strokes of its display: a sink (emulators/core/stroke.hpp) that does only what was
// asked for.
//
// A picture shows the last complete pass. A program that never completes one is shown by the newest strokes
// of the run, up to the recorder's limit. A photograph needs the newest strokes too, for the afterglow of
// what was drawn before the shutter opened.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "host/picture/stroke_log.hpp"
#include "host/picture/stroke_sinks.hpp"

namespace sightline::harness {

class Screen {
 public:
  static constexpr bool consumes = true;
  // Three seconds of a display that flashes every 1.5 us.
  static constexpr std::size_t strokes_kept = std::size_t{1} << 21;

  struct Wishes {
    bool picture = false;                       // for picture_strokes()
    bool photograph = false;                    // for newest_strokes()
    std::function<void(std::string_view)> log;  // every stroke, as host/picture/stroke_log writes it
  };

  explicit Screen(Wishes wishes) : wishes_(std::move(wishes)), newest_(strokes_kept) {}

  void begin_pass(core::Instant t) {
    if (wishes_.picture) passes_.begin_pass(t);
  }
  void stroke(const core::Stroke& stroke) {
    if (wishes_.picture) passes_.stroke(stroke);
    if (wishes_.photograph || (wishes_.picture && passes_.passes() == 0)) newest_.stroke(stroke);
    if (wishes_.log) log(stroke);
  }
  void end_pass(core::Instant t) {
    if (wishes_.picture) passes_.end_pass(t);
  }
  // Hands out what is left of the log.
  void finish() {
    if (!log_.empty()) wishes_.log(log_);
    log_.clear();
  }

  [[nodiscard]] bool has_complete_pass() const { return passes_.passes() != 0; }
  // Of the last complete pass; if there is none, the newest of the run.
  [[nodiscard]] std::vector<core::Stroke> picture_strokes() const {
    return has_complete_pass() ? passes_.complete().strokes : newest_.strokes();
  }
  [[nodiscard]] std::vector<core::Stroke> newest_strokes() const { return newest_.strokes(); }

 private:
  static constexpr std::size_t block_size = 65536;

  void log(const core::Stroke& stroke) {
    picture::append_stroke_line(log_, stroke);
    if (log_.size() >= block_size) finish();
  }

  Wishes wishes_;
  picture::PassRecorder passes_;
  picture::StrokeRecorder newest_;
  std::string log_;
};

}  // namespace sightline::harness
