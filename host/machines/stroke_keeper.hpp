// The strokes of chosen passes of the display, for programs that are measured.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"

namespace sightline::machines {

// Keeps strokes while the class that derives from it says so. By itself it keeps none.
class StrokeKeeper : public core::StrokeTaker {
 public:
  void strokes(std::span<const core::Stroke> strokes) override {
    if (keeps_) kept_.insert(kept_.end(), strokes.begin(), strokes.end());
  }

 protected:
  ~StrokeKeeper() = default;

  void keep_strokes(bool keeps) { keeps_ = keeps; }
  // Those kept since they were last taken or forgotten.
  [[nodiscard]] std::vector<core::Stroke> take_strokes() { return std::exchange(kept_, {}); }
  void forget_strokes() { kept_.clear(); }

 private:
  bool keeps_ = false;
  std::vector<core::Stroke> kept_;
};

}  // namespace sightline::machines
