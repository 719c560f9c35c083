#include "host/guests/skala/pen_paths.hpp"

namespace sightline::guests::skala {

std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves) {
  std::vector<picture::PenPath> paths;
  for (const PlotterMove& move : moves) {
    if (move.action == PlotterAction::pen_down) paths.push_back({{{move.x, move.y}}});
    if (move.action == PlotterAction::step && move.pen_down && !paths.empty())
      picture::extend(paths.back(), {move.x, move.y});
  }
  return paths;
}

}  // namespace sightline::guests::skala
