#include "host/guests/skala/twin/plotter.hpp"

namespace sightline::guests::skala {

void PlotterPen::visible(Point point) {
  if (run_points_ == 0) {
    remembered_ = point;
    run_points_ = 1;
    return;
  }
  if (run_points_ == 1) {
    put_down_at(remembered_);
    run_points_ = 2;
  }
  step_towards(point);
}

void PlotterPen::lift() {
  if (!down_) return;
  down_ = false;
  ++counts_.pen_lifts;
  moves_.push_back({PlotterAction::pen_up, at_.x, at_.y, false});
}

void PlotterPen::put_down_at(Point point) {
  if (down_ && at_ == point) return;
  lift();
  while (at_ != point) step_towards(point);
  down_ = true;
  moves_.push_back({PlotterAction::pen_down, at_.x, at_.y, true});
}

void PlotterPen::step_towards(Point point) {
  at_.x = static_cast<std::uint8_t>(at_.x + sign_of(point.x - at_.x));
  at_.y = static_cast<std::uint8_t>(at_.y + sign_of(point.y - at_.y));
  ++(down_ ? counts_.steps_pen_down : counts_.steps_pen_up);
  moves_.push_back({PlotterAction::step, at_.x, at_.y, down_});
}

}  // namespace sightline::guests::skala
