#include "host/guests/skala/twin/plotter.hpp"

namespace sightline::harness {

void SkalaPlotterPen::visible(SkalaPoint point) {
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

void SkalaPlotterPen::lift() {
  if (!down_) return;
  down_ = false;
  ++counts_.pen_lifts;
  moves_.push_back({SkalaPlotterAction::pen_up, at_.x, at_.y, false});
}

void SkalaPlotterPen::put_down_at(SkalaPoint point) {
  if (down_ && at_ == point) return;
  lift();
  while (at_ != point) step_towards(point);
  down_ = true;
  moves_.push_back({SkalaPlotterAction::pen_down, at_.x, at_.y, true});
}

void SkalaPlotterPen::step_towards(SkalaPoint point) {
  at_.x = static_cast<std::uint8_t>(at_.x + skala_sign(point.x - at_.x));
  at_.y = static_cast<std::uint8_t>(at_.y + skala_sign(point.y - at_.y));
  ++(down_ ? counts_.steps_pen_down : counts_.steps_pen_up);
  moves_.push_back({SkalaPlotterAction::step, at_.x, at_.y, down_});
}

}  // namespace sightline::harness
