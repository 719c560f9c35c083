// A chain: connected lines on the raster between two COMMITs, cut at its border.
//
// Lines are cut exactly, in real coordinates, and the cuts rounded once. What lies left or right of the
// raster is left out. What lies above or below still hides what is behind it: it runs along the border
// without ink (test-only lines have no effect there and are left out; shading has no inkless mode and is
// clamped).
#pragma once

#include <vector>

#include "host/guests/skala/projection.hpp"

namespace sightline::harness {

enum class SkalaStep { draw, test, mask, shade, rim };

struct SkalaNode {
  int column = 0;  // 0..255
  int row = 0;
  int level = 0;
  SkalaStep step = SkalaStep::draw;  // of the line that leads here; of the dot, if this is all of the piece
  bool fresh = true;                 // a piece begins here: nothing leads here

  friend bool operator==(const SkalaNode&, const SkalaNode&) = default;
};

class SkalaChain {
 public:
  struct Levels {
    int from = 0;
    int to = 0;
  };

  // Both ends defined. Continues the piece if `from` is the very object the segment before this ended with.
  void segment(const SkalaVertex& from, const SkalaVertex& to, SkalaStep step, Levels levels);
  void segment(const SkalaVertex& from, const SkalaVertex& to, SkalaStep step) {
    segment(from, to, step, Levels{});
  }
  // A defined vertex without neighbours.
  void point(const SkalaVertex& vertex, SkalaStep step, int level = 0);

  [[nodiscard]] const std::vector<SkalaNode>& nodes() const { return nodes_; }
  // The same lines from the other end.
  [[nodiscard]] SkalaChain reversed() const;

 private:
  void part(const SkalaNode& from, const SkalaNode& to);

  std::vector<SkalaNode> nodes_;
  const SkalaVertex* end_ = nullptr;  // of the last segment; null if that was cut away
};

}  // namespace sightline::harness
