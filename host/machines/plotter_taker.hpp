// Takes the strokes of a run's plotters: logs them and keeps the lines they draw, as the run requires. Strokes do not show
// a lifted pen: marks one step apart are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "emulators/core/state_visitor.hpp"
#include "emulators/core/stroke.hpp"
#include "host/machines/machine.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/stroke_log.hpp"

namespace sightline::machines {

class PlotterTaker final : public core::StrokeTaker {
 public:
  // The bound for a program that draws for ever.
  static constexpr std::size_t most_corners = std::size_t{1} << 22;

  explicit PlotterTaker(bool drawing) : drawing_(drawing) {}

  void strokes(std::span<const core::Stroke> strokes) override {
    if (log_.wanted()) log(strokes);
    if (drawing_) {
      for (const core::Stroke& stroke : strokes) draw({stroke.x, stroke.y});
    }
    if (live_) fresh_.insert(fresh_.end(), strokes.begin(), strokes.end());
  }
  void keep_strokes(bool keep) { live_ = keep; }
  [[nodiscard]] std::span<const core::Stroke> take_strokes() {
    taken_.swap(fresh_);
    fresh_.clear();
    return taken_;
  }

  void take(TextTaker taker) { log_.take(std::move(taker)); }
  void finish() { log_.finish(); }
  [[nodiscard]] const std::vector<picture::PenPath>& paths() const { return paths_; }
  // The number of marks beyond the bound.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

  // The drawing is an output. Its end point is enough to go back to, because corners are only added or moved at the end. A
  // machine that has drawn less begins a new drawing.
  void visit_state(core::StateVisitor& visit) {
    End end;
    if (!paths_.empty()) {
      end = {paths_.size(), paths_.back().corners.size(), paths_.back().corners.back(), last_, left_out_};
    }
    visit("paths", end.paths);
    visit("corners", end.corners);
    for (picture::PenPoint* const point : {&end.corner, &end.last}) {
      visit("x", point->x);
      visit("y", point->y);
    }
    visit("left_out", end.left_out);
    if (visit.cuts_outputs()) go_back_to(end);
  }

 private:
  void log(std::span<const core::Stroke> strokes) {
    for (const core::Stroke& stroke : strokes)
      log_.write([&stroke](std::string& text) { picture::append_stroke_line(text, stroke); });
  }
  struct End {
    std::uint64_t paths = 0;
    std::uint64_t corners = 0;  // of the last path
    picture::PenPoint corner{};  // its last one
    picture::PenPoint last{};    // mark
    std::uint64_t left_out = 0;
  };

  void go_back_to(const End& end) {
    fresh_.clear();
    if (end.paths > paths_.size() || end.paths == 0 ||
        end.corners > paths_[static_cast<std::size_t>(end.paths) - 1].corners.size() || end.corners == 0) {
      paths_.clear();
    } else {
      paths_.resize(static_cast<std::size_t>(end.paths));
      paths_.back().corners.resize(static_cast<std::size_t>(end.corners));
      paths_.back().corners.back() = end.corner;
    }
    last_ = end.last;
    left_out_ = paths_.empty() ? 0 : end.left_out;
    corners_ = 0;
    for (std::size_t n = 0; n + 1 < paths_.size(); ++n) corners_ += paths_[n].corners.size();
  }

  void draw(picture::PenPoint point) {
    const bool joined =
        !paths_.empty() && std::abs(point.x - last_.x) <= 1 && std::abs(point.y - last_.y) <= 1;
    const std::size_t kept = corners_ + (paths_.empty() ? 0 : paths_.back().corners.size());
    if (kept >= most_corners) {
      ++left_out_;
      return;
    }
    if (!joined) {
      corners_ = kept;
      paths_.push_back({{point}});
    } else if (point != last_) {
      picture::extend(paths_.back(), point);
    }
    last_ = point;
  }

  bool live_ = false;
  std::vector<core::Stroke> fresh_;  // since they were last taken
  std::vector<core::Stroke> taken_;
  bool drawing_;
  TextBlocks log_;
  std::vector<picture::PenPath> paths_;
  picture::PenPoint last_;
  std::size_t corners_ = 0;  // of all paths but the last, which is counted when the next begins
  std::uint64_t left_out_ = 0;
};

}  // namespace sightline::machines
