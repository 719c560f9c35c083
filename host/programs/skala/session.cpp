#include "host/programs/skala/session.hpp"

#include <utility>

namespace sightline::programs::skala {

CheckedPicture Session::run(std::span<const std::uint8_t> stream, const GuestOptions& options) const {
  Equipment equipment{{}};
  equipment.present[static_cast<std::size_t>(options.device)] = true;
  CheckedPicture picture{run_guest(program_, stream, options), run_twin(stream, equipment), {}};
  picture.difference = difference_from_twin(picture.guest, picture.twin, options.device);
  return picture;
}

std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves) {
  std::vector<picture::PenPath> paths;
  for (const PlotterMove& move : moves) {
    if (move.action == PlotterAction::pen_down) paths.push_back({{{move.x, move.y}}});
    if (move.action == PlotterAction::step && move.pen_down && !paths.empty())
      picture::extend(paths.back(), {move.x, move.y});
  }
  return paths;
}

}  // namespace sightline::programs::skala
