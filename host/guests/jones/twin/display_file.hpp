// The display file of Jones's program: Type 340 words for line pieces.
// Source: firmware/pdp7/jones/SPECIFICATION.md section 5; word formats, Type 340 manual.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/guests/jones/twin/arithmetic.hpp"

namespace sightline::guests::jones {

class DisplayFile {
 public:
  enum class Outcome : std::uint8_t { drawn, no_length, full };

  // capacity in words, the stop included; joining: pieces that continue each other share their set-up words.
  // truncate: a long line is divided into vectors by quotients that are cut off, not rounded.
  DisplayFile(std::size_t capacity, bool joining, bool truncate = false);
  // A line from a to b, points of the screen.
  [[nodiscard]] Outcome add(ScreenPoint a, ScreenPoint b, Operations& operations);
  // Adds the stop; the file takes nothing more.
  [[nodiscard]] std::vector<core::Word18> finish() &&;

 private:
  void add_vectors(std::int32_t dx, std::int32_t dy, std::int32_t count, Operations& operations);

  std::size_t capacity_;
  bool joining_;
  ShortWords number_;
  std::vector<core::Word18> words_;
  std::optional<ScreenPoint> beam_;  // end of the last piece, in points of the screen
};

}  // namespace sightline::guests::jones
