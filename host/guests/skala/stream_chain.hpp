// A chain: connected lines on the raster between two COMMITs, cut at its border.
//
// Lines are cut exactly, in real coordinates, and the cuts rounded once. What lies left or right of the
// raster is left out. What lies above or below still hides what is behind it: it runs along the border
// without ink (test-only lines have no effect there and are left out; shading has no inkless mode and is
// clamped).
#pragma once

#include <vector>

#include "host/guests/skala/projection.hpp"

namespace sightline::guests::skala {

enum class ChainStep { draw, test, mask, shade, rim };

struct ChainNode {
  int column = 0;  // 0..255
  int row = 0;
  int level = 0;
  ChainStep step = ChainStep::draw;  // of the line that leads here; of the dot, if this is all of the piece
  bool fresh = true;                 // a piece begins here: nothing leads here

  friend bool operator==(const ChainNode&, const ChainNode&) = default;
};

class RasterChain {
 public:
  struct Levels {
    int from = 0;
    int to = 0;
  };

  // Both ends defined. Continues the piece if `from` is the very object the segment before this ended with.
  void segment(const Vertex& from, const Vertex& to, ChainStep step, Levels levels);
  void segment(const Vertex& from, const Vertex& to, ChainStep step) { segment(from, to, step, Levels{}); }
  // A defined vertex without neighbours.
  void point(const Vertex& vertex, ChainStep step, int level = 0);

  [[nodiscard]] const std::vector<ChainNode>& nodes() const { return nodes_; }
  // The same lines from the other end.
  [[nodiscard]] RasterChain reversed() const;

 private:
  void part(const ChainNode& from, const ChainNode& to);

  std::vector<ChainNode> nodes_;
  const Vertex* end_ = nullptr;  // of the last segment; null if that was cut away
};

}  // namespace sightline::guests::skala
