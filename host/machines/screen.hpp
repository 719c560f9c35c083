// The strokes that a run keeps of its display, only as far as requested.
//
// A picture shows the last complete pass. If a program never completes one, it shows the newest strokes of the run, up to
// the recorder's limit. A photograph needs the newest strokes too, for the afterglow of those drawn before the shutter
// opened.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "host/machines/machine.hpp"
#include "host/picture/stroke_log.hpp"
#include "host/picture/stroke_recorders.hpp"

namespace sightline::machines {

class Screen final : public core::StrokeTaker {
 public:
  // Three seconds of a display that flashes every 1.5 us.
  static constexpr std::size_t strokes_kept = std::size_t{1} << 21;

  struct Outputs {
    bool picture = false;     // for picture_strokes()
    bool photograph = false;  // for newest_strokes()
    core::Duration window{};  // a picture shows all strokes of this last period; 0: the last complete pass
  };

  explicit Screen(Outputs outputs) : outputs_(outputs), newest_(strokes_kept) {}
  // Logs every stroke, in the format of host/picture/stroke_log; call it before the first stroke.
  void take_log(TextTaker taker) { log_.take(std::move(taker)); }

  void begin_pass(core::Instant t) override {
    if (outputs_.picture) passes_.begin_pass(t);
  }
  void strokes(std::span<const core::Stroke> strokes) override {
    if (live_) fresh_.insert(fresh_.end(), strokes.begin(), strokes.end());
    if (outputs_.picture) passes_.add(strokes);
    const bool of_picture = outputs_.picture && (outputs_.window.count() != 0 || passes_.passes() == 0);
    if (outputs_.photograph || of_picture) newest_.add(strokes);
    if (!log_.wanted()) return;
    for (const core::Stroke& stroke : strokes)
      log_.write([&stroke](std::string& text) { picture::append_stroke_line(text, stroke); });
  }
  void end_pass(core::Instant t) override {
    if (outputs_.picture) passes_.end_pass(t);
  }
  // The machine goes back to `t`: later strokes will be drawn again. Text that the log has written stays.
  void forget_after(core::Instant t) {
    passes_.forget_after(t);
    newest_.forget_after(t);
    fresh_.clear();
  }
  // From now on strokes are kept for take_strokes, and only for it.
  void keep_strokes(bool keep) {
    live_ = keep;
    if (keep) outputs_ = {};
  }
  // Valid until the display draws again.
  [[nodiscard]] std::span<const core::Stroke> take_strokes() {
    taken_.clear();
    std::swap(taken_, fresh_);
    return taken_;
  }
  // Flushes the log.
  void finish() { log_.finish(); }

  [[nodiscard]] bool has_complete_pass() const { return passes_.passes() != 0; }
  // When the last complete pass ended; there must be one.
  [[nodiscard]] core::Instant end_of_pass() const { return passes_.complete().end; }
  // The strokes of the window that ends at `now`; without a window, of the last complete pass; if there is none, the newest
  // of the run.
  [[nodiscard]] std::vector<core::Stroke> picture_strokes(core::Instant now) const {
    if (outputs_.window.count() == 0) return has_complete_pass() ? passes_.complete().strokes : newest_.strokes();
    std::vector<core::Stroke> strokes = newest_.strokes();
    std::erase_if(strokes, [&](const core::Stroke& stroke) { return stroke.time + outputs_.window < now; });
    return strokes;
  }
  [[nodiscard]] std::vector<core::Stroke> newest_strokes() const { return newest_.strokes(); }

 private:
  Outputs outputs_;
  picture::PassRecorder passes_;
  picture::StrokeRecorder newest_;
  TextBlocks log_;
  bool live_ = false;
  std::vector<core::Stroke> fresh_;  // since they were last taken
  std::vector<core::Stroke> taken_;
};

}  // namespace sightline::machines
