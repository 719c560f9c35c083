// Views of hand-made core images, and the lines of a display file.
#pragma once

#include <vector>

#include "host/programs/jones/twin/twin.hpp"
#include "tests/host/programs/jones/core.hpp"

namespace sightline::programs::jones {

inline TwinView view_of(const TestCore& core, const Parameters& parameters = {}) {
  return run_twin(core.words, TestCore::header, parameters);
}

// The path of the beam, by the word formats of the Type 340 alone.
struct Drawing {
  std::vector<ScreenSegment> pieces;   // one per unbroken chain of vector words, points of the screen
  std::vector<ScreenSegment> vectors;  // one per vector word
  bool well_formed = true;
};
inline Drawing decode(const TwinView& view) {
  Drawing drawing;
  ScreenPoint beam;
  enum class Mode { parameter, point_y, point_x, vector } mode = Mode::parameter;
  bool stopped = false;
  for (std::size_t i = 0; i < view.display_file.size(); ++i) {
    const core::Word18 word = view.display_file[i];
    const auto expect = [&](bool holds) { drawing.well_formed = drawing.well_formed && holds; };
    expect(!stopped);
    if (mode == Mode::parameter) {
      if (word.bit(7)) stopped = true;
      expect(word.field(2, 4) == 0 || word.field(2, 4) == 1);
      if (word.field(2, 4) == 1) mode = Mode::point_y;
    } else if (mode == Mode::point_y) {
      expect(word.bit(1) && word.field(2, 4) == 1 && !word.bit(7));
      beam.y = static_cast<std::int32_t>(word.field(8, 17));
      mode = Mode::point_x;
    } else if (mode == Mode::point_x) {
      expect(!word.bit(1) && word.field(2, 4) == 4 && word.bit(7));
      beam.x = static_cast<std::int32_t>(word.field(8, 17));
      drawing.pieces.push_back({beam, beam});
      mode = Mode::vector;
    } else {
      const auto dy = static_cast<std::int32_t>(word.field(3, 9)),
                 dx = static_cast<std::int32_t>(word.field(11, 17));
      const ScreenPoint from = beam;
      beam.y += word.bit(2) ? -dy : dy;
      beam.x += word.bit(10) ? -dx : dx;
      expect(word.bit(1) && dx + dy > 0);
      expect(0 <= beam.x && beam.x <= 1023 && 0 <= beam.y && beam.y <= 1023);
      drawing.pieces.back().b = beam;
      drawing.vectors.push_back({from, beam});
      if (word.bit(0)) mode = Mode::parameter;
    }
  }
  drawing.well_formed = drawing.well_formed && stopped;
  return drawing;
}

}  // namespace sightline::programs::jones
