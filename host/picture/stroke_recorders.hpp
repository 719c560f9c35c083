// Record the strokes of a display (emulators/core/stroke.hpp).
//
// All recorders are bounded, because a display file that never stops must not exhaust the host's memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"

namespace sightline::picture {

// The display counts in 10 bits, and its words have 3 bits of intensity. A Type 340 cannot produce other values.
inline constexpr int screen_points = 1024;
inline constexpr int intensity_levels = 8;

[[nodiscard]] constexpr bool on_screen(const core::Stroke& stroke) {
  return stroke.x < screen_points && stroke.y < screen_points && stroke.intensity < intensity_levels;
}

// One run of the display from IDLA to the stop.
struct Pass {
  core::Instant begin;
  core::Instant end;  // of the running pass: its begin
  std::vector<core::Stroke> strokes;
  std::uint64_t left_out = 0;  // number of strokes beyond the recorder's limit
};

// Keeps the last complete pass and the running one. IDLA during a pass discards the unfinished pass, which was never
// wholly shown. Strokes before the first begin_pass belong to a pass that began at time 0. If a machine is restored
// during a pass (forget_after), the rest of that pass never counts as complete.
class PassRecorder {
 public:
  static constexpr std::size_t default_limit = std::size_t{1} << 20;  // a pass of more than 1.5 s

  explicit PassRecorder(std::size_t limit_a_pass = default_limit) : limit_(limit_a_pass) {}

  void begin_pass(core::Instant t) {
    begun_ = true;
    partial_ = false;
    running_.begin = t;
    running_.end = t;
    running_.strokes.clear();
    running_.left_out = 0;
  }
  void add(std::span<const core::Stroke> strokes) {
    const std::size_t kept = std::min(strokes.size(), limit_ - running_.strokes.size());
    running_.strokes.insert(running_.strokes.end(), strokes.begin(), strokes.begin() + static_cast<std::ptrdiff_t>(kept));
    running_.left_out += strokes.size() - kept;
  }
  void end_pass(core::Instant t) {
    if (partial_) {
      begin_pass(t);
      return;
    }
    running_.end = t;
    std::swap(complete_, running_);
    ++passes_;
    begin_pass(t);
  }

  // The machine goes back to `t`, or starts there.
  void forget_after(core::Instant t) {
    if (passes_ != 0 && complete_.begin <= t && t < complete_.end) {
      running_ = std::move(complete_);
      complete_ = {};
      passes_ = 0;
    } else if (!begun_ || running_.begin > t) {
      begin_pass(t);
      partial_ = true;
    }
    if (complete_.end > t) {
      complete_ = {};
      passes_ = 0;
    }
    while (!running_.strokes.empty() && running_.strokes.back().time > t) running_.strokes.pop_back();
  }

  // Without strokes and with passes() == 0 if no pass is complete yet.
  [[nodiscard]] const Pass& complete() const { return complete_; }
  [[nodiscard]] const Pass& running() const { return running_; }
  [[nodiscard]] std::uint64_t passes() const { return passes_; }

 private:
  std::size_t limit_;
  Pass complete_;
  Pass running_;
  std::uint64_t passes_ = 0;
  bool begun_ = false;
  bool partial_ = false;  // the start of the running pass is missing
};

// Keeps the newest strokes, up to a limit, for a photograph of the end of a run.
class StrokeRecorder {
 public:
  explicit StrokeRecorder(std::size_t limit) : limit_(limit) {}

  void add(std::span<const core::Stroke> strokes) {
    for (const core::Stroke& stroke : strokes) add(stroke);
  }

  // The machine goes back to `t`.
  void forget_after(core::Instant t) {
    kept_ = strokes();
    oldest_ = 0;
    while (!kept_.empty() && kept_.back().time > t) kept_.pop_back();
  }

  // In the order of arrival.
  [[nodiscard]] std::vector<core::Stroke> strokes() const {
    const auto split = kept_.begin() + static_cast<std::ptrdiff_t>(oldest_);
    std::vector<core::Stroke> ordered(split, kept_.end());
    ordered.insert(ordered.end(), kept_.begin(), split);
    return ordered;
  }
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

 private:
  void add(const core::Stroke& stroke) {
    if (kept_.size() < limit_) {
      kept_.push_back(stroke);
      return;
    }
    ++left_out_;
    if (limit_ == 0) return;
    kept_[oldest_] = stroke;
    oldest_ = oldest_ + 1 == limit_ ? 0 : oldest_ + 1;
  }

  std::size_t limit_;
  std::vector<core::Stroke> kept_;
  std::size_t oldest_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace sightline::picture
