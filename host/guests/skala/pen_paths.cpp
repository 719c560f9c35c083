#include "host/guests/skala/pen_paths.hpp"

namespace sightline::harness {

std::vector<picture::PenPath> pen_paths(std::span<const SkalaPlotterMove> moves) {
  std::vector<picture::PenPath> paths;
  for (const SkalaPlotterMove& move : moves) {
    if (move.action == SkalaPlotterAction::pen_down) paths.push_back({{{move.x, move.y}}});
    if (move.action == SkalaPlotterAction::step && move.pen_down && !paths.empty())
      picture::extend(paths.back(), {move.x, move.y});
  }
  return paths;
}

}  // namespace sightline::harness
