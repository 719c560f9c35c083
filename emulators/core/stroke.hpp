// The output of calligraphic display hardware, and the interface of its consumers.
//
// One Stroke is one flash of the beam: everything the Type 340 draws consists of them. A plotter emits one for each step
// made with the pen down. A device puts them into a StrokeBuffer, which passes them to the taker in blocks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "time.hpp"

namespace sightline::core {

struct Stroke {
  Instant time;               // beam on
  std::uint16_t x = 0;        // 0..1023, 0 = left
  std::uint16_t y = 0;        // 0..1023, 0 = bottom
  std::uint8_t intensity = 0; // 0..7, 7 brightest
  std::uint16_t address = 0;  // core address of the display word that drew it

  friend constexpr bool operator==(const Stroke&, const Stroke&) = default;
};

// A consumer of strokes: raster, phosphor, logs, statistics. It uses no other output of a display.
class StrokeTaker {
 public:
  // In order of time within one device.
  virtual void strokes(std::span<const Stroke> strokes) = 0;
  virtual void begin_pass(Instant) {}  // the program started the display (IDLA)
  virtual void end_pass(Instant) {}    // the display stopped (stop word or edge)

 protected:
  ~StrokeTaker() = default;
};

class StrokeBuffer {
 public:
  // Null: there is no consumer, and a device may skip computing single strokes. The taker must outlive the buffer.
  void hand_to(StrokeTaker* taker) {
    flush();
    taker_ = taker;
  }
  [[nodiscard]] bool wanted() const { return taker_ != nullptr; }

  void put(const Stroke& stroke) {
    if (count_ == strokes_.size()) flush();
    strokes_[count_++] = stroke;
  }
  void begin_pass(Instant t) {
    flush();
    if (taker_ != nullptr) taker_->begin_pass(t);
  }
  void end_pass(Instant t) {
    flush();
    if (taker_ != nullptr) taker_->end_pass(t);
  }
  // Passes the waiting strokes to the taker; a machine calls it at the end of each run.
  void flush() {
    const std::size_t count = count_;
    count_ = 0;
    if (taker_ != nullptr && count != 0) taker_->strokes({strokes_.data(), count});
  }

 private:
  std::array<Stroke, 1024> strokes_;
  std::size_t count_ = 0;
  StrokeTaker* taker_ = nullptr;
};

}  // namespace sightline::core
