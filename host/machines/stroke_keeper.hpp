// Keeps the strokes of chosen passes of the display, to measure programs.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"

namespace sightline::machines {

// Keeps strokes while the derived class has enabled it. Initially it keeps none.
class StrokeKeeper : public core::StrokeTaker {
 public:
  void strokes(std::span<const core::Stroke> strokes) override {
    if (keeps_) kept_.insert(kept_.end(), strokes.begin(), strokes.end());
  }

 protected:
  ~StrokeKeeper() = default;

  void keep_strokes(bool keeps) { keeps_ = keeps; }
  // The strokes kept since the last call of take_strokes() or forget_strokes().
  [[nodiscard]] std::vector<core::Stroke> take_strokes() { return std::exchange(kept_, {}); }
  void forget_strokes() { kept_.clear(); }

 private:
  bool keeps_ = false;
  std::vector<core::Stroke> kept_;
};

}  // namespace sightline::machines
