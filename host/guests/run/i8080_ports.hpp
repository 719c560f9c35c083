// What lies behind the ports of an 8080 that is run: the devices, and before them CP/M and the watch of --strict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/state_visitor.hpp"
#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/machines/i8080_hold.hpp"
#include "emulators/machines/skala_ports.hpp"
#include "host/guests/run/cpm.hpp"
#include "host/guests/run/i8080_processor.hpp"
#include "host/guests/run/machine.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/stroke_log.hpp"

namespace sightline::guests::run {

// A sink that writes what a plotter's pen does and keeps the lines it draws, as far as the run asks for them.
// Strokes tell nothing of a lifted pen: marks one step apart are joined.
class PlotterTaker {
 public:
  static constexpr bool consumes = true;
  // Corners kept of a program that draws for ever.
  static constexpr std::size_t most_corners = std::size_t{1} << 22;

  explicit PlotterTaker(bool drawing) : drawing_(drawing) {}

  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    if (log_.wanted()) log(stroke);
    if (drawing_) draw({stroke.x, stroke.y});
    if (live_) fresh_.push_back(stroke);
  }
  void keep_strokes(bool keep) { live_ = keep; }
  [[nodiscard]] std::span<const core::Stroke> take_strokes() {
    taken_.swap(fresh_);
    fresh_.clear();
    return taken_;
  }
  void end_pass(core::Instant) {}

  void take(TextTaker taker) { log_.take(std::move(taker)); }
  void finish() { log_.finish(); }
  [[nodiscard]] const std::vector<picture::PenPath>& paths() const { return paths_; }
  // Marks beyond what is kept.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

  // The drawing is an output: where it ends is enough to go back to, as corners are only added or moved at the end. A
  // machine that has not drawn so much begins a new drawing.
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
    if (visit.restores()) {
      if (visit.cuts_outputs()) go_back_to(end);
    }
  }

 private:
  void log(const core::Stroke& stroke) {
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

using RunDevices = machines::SkalaPorts<PlotterTaker>;

// What the devices do by themselves, and a board that takes the bus.
class RunLines final : public I8080Lines {
 public:
  RunLines(RunDevices& devices, const machines::HoldTimes& hold)
      : I8080Lines(hold.length != 0), devices_(devices), hold_(hold) {}

  [[nodiscard]] core::TStateInstant deadline() const override { return devices_.deadline(); }
  void advance(core::TStateInstant now) override { devices_.advance(now); }
  [[nodiscard]] bool interrupt() const override { return devices_.interrupt(); }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) override { return devices_.acknowledge(now); }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const override { return hold_.next_hold(t); }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const override { return hold_.hold_ends(t); }

 private:
  RunDevices& devices_;
  machines::HoldTimes hold_;
};

struct PortCall {
  std::uint8_t port;
  std::uint8_t value;
  core::TStateInstant at;
};

// The machine's devices, and before them the ports of CP/M's entries and the watch of --strict.
//
// Ports see no registers, so a call of CP/M only ends the run at the next instruction boundary; the
// caller then reads the registers there and continues the run. An OUT to those ports that turns out to be none of an
// entry's is handed back to the devices.
class RunPorts final : public I8080Ports {
 public:
  RunPorts(RunDevices& devices, I8080Lines& lines, bool cpm, bool strict)
      : I8080Ports(&lines), devices_(devices), cpm_(cpm), strict_(strict) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    const std::uint64_t before = devices_.unanswered()[port].reads;
    const std::uint8_t value = devices_.in(port, at);
    if (strict_ && devices_.unanswered()[port].reads != before) stop_unanswered();
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    if (cpm_ && port <= Cpm::last_port) {
      call_ = {port, value, at};
      stopped_ = true;
      return;
    }
    pass_on({port, value, at});
  }

  // The OUT to a port of an entry that ended the run, once.
  [[nodiscard]] std::optional<PortCall> take_call() {
    stopped_ = unanswered_;
    return std::exchange(call_, std::nullopt);
  }
  // An OUT as if there were no CP/M.
  void pass_on(const PortCall& call) {
    const std::uint64_t before = devices_.unanswered()[call.port].writes;
    devices_.out(call.port, call.value, call.at);
    if (strict_ && devices_.unanswered()[call.port].writes != before) stop_unanswered();
  }
  // A port did not answer and the run is strict.
  [[nodiscard]] bool unanswered() const { return unanswered_; }

  // Between two runs no call waits; that a run has stopped is not kept.
  void visit_state(core::StateVisitor& visit) {
    devices_.visit_state(visit);
    if (visit.restores()) {
      call_.reset();
      stopped_ = unanswered_ = false;
    }
  }

 private:
  void stop_unanswered() { stopped_ = unanswered_ = true; }

  RunDevices& devices_;
  std::optional<PortCall> call_;
  bool cpm_;
  bool strict_;
  bool unanswered_ = false;
};

}  // namespace sightline::guests::run
