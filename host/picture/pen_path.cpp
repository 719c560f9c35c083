#include "host/picture/pen_path.hpp"

namespace sightline::picture {

namespace {

int sign(int value) {
  return (value > 0) - (value < 0);
}

}  // namespace

void extend(PenPath& path, PenPoint next) {
  auto& corners = path.corners;
  if (corners.back() == next) return;
  if (corners.size() >= 2) {
    const PenPoint a = corners[corners.size() - 2];
    const PenPoint b = corners.back();
    if (sign(b.x - a.x) == sign(next.x - b.x) && sign(b.y - a.y) == sign(next.y - b.y)) {
      corners.back() = next;
      return;
    }
  }
  corners.push_back(next);
}

}  // namespace sightline::picture
