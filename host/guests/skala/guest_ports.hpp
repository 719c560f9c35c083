// The ports of a Skala run: those of the machine, stopping it where the link says that a block of commands
// has come or the next one is asked for, and on a plotter noting every movement.
//
// A raster board's ports pay one comparison an IN for this and nothing an OUT.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "emulators/machines/skala_ports.hpp"
#include "host/guests/skala/guest.hpp"

namespace sightline::guests::skala {

// What of a device's counts is an error, and the dots no monitor shows.
void report_faults(const devices::Ef9365& board, GuestPicture& picture);
void report_faults(const devices::Alt256& board, GuestPicture& picture);
void report_faults(const devices::CalComp565Counts& counts, GuestPicture& picture);
void report_faults(const devices::MinigrafCounts& counts, GuestPicture& picture);

template <class Sink>
class LinkPorts : public machines::SkalaPorts<Sink> {
 public:
  using Base = machines::SkalaPorts<Sink>;
  using Base::Base;

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    const std::uint8_t value = Base::in(port, at);
    if (port >= first_link_port) note(port);
    return value;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

  // Nothing is wired to INT, so no device need be brought up to date but when the program touches it.
  void advance(core::TStateInstant) {}
  [[nodiscard]] static constexpr core::TStateInstant deadline() { return core::never_t; }
  [[nodiscard]] static constexpr bool interrupt() { return false; }

  // Bytes counted from the first one of all.
  void stop_after_bytes(std::size_t count) {
    stop_at_ = count;
    at_link_ = false;
    stopped_ = taken_ >= stop_at_;
  }
  void stop_at_link() {
    never_stop();
    at_link_ = true;
  }
  void never_stop() {
    stop_at_ = std::numeric_limits<std::size_t>::max();
    at_link_ = false;
    stopped_ = false;
  }

  void report(GuestPicture& picture) {
    if (const auto* board = this->ef9365()) {
      picture.raster = board->raster();
      report_faults(*board, picture);
    }
    if (const auto* board = this->alt256()) {
      picture.raster = board->raster();
      report_faults(*board, picture);
    }
    if (const auto* plotter = this->calcomp565()) report_faults(plotter->counts(), picture);
    if (const auto* plotter = this->minigraf0507()) report_faults(plotter->counts(), picture);
    for (std::size_t port = 0; port < 256; ++port) {
      const machines::UnansweredPort& counts = this->unanswered()[port];
      if (counts.reads + counts.writes > 0)
        picture.unanswered.push_back({static_cast<std::uint8_t>(port), counts.reads, counts.writes});
    }
  }

 private:
  static constexpr std::uint8_t first_link_port = 0xE4;
  static constexpr std::uint8_t parallel_data = 0xE4;
  static constexpr std::uint8_t serial_data = 0xEC;

  void note(std::uint8_t port) {
    if (port == parallel_data || port == serial_data) ++taken_;
    if (at_link_ || taken_ >= stop_at_) stopped_ = true;
  }

  std::size_t taken_ = 0;
  std::size_t stop_at_ = std::numeric_limits<std::size_t>::max();
  bool at_link_ = false;
  bool stopped_ = false;
};

// A Ports owns its sink, which the devices hold by reference from construction on.
class RasterPorts : private core::NoStrokes, public LinkPorts<core::NoStrokes> {
 public:
  explicit RasterPorts(const machines::SkalaConfiguration& configuration)
      : LinkPorts(configuration, static_cast<core::NoStrokes&>(*this)) {}

  static void keep_strokes(bool) {}  // a board makes none
};

struct PortStrokes {
  static constexpr bool consumes = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    if (keep) marks.push_back(stroke);
  }
  void end_pass(core::Instant) {}
  bool keep = false;
  std::vector<core::Stroke> marks;
};

class PlotterPorts : private PortStrokes, public LinkPorts<PortStrokes> {
 public:
  explicit PlotterPorts(const machines::SkalaConfiguration& configuration)
      : LinkPorts(configuration, static_cast<PortStrokes&>(*this)) {}

  void keep_strokes(bool kept) { keep = kept; }

  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    LinkPorts::out(port, value, at);
    if (calcomp565() != nullptr) note_movement(calcomp565()->place(), calcomp565()->pen_is_down());
    if (minigraf0507() != nullptr) note_movement(minigraf0507()->place(), minigraf0507()->pen_is_down());
  }

  void report(GuestPicture& picture) {
    LinkPorts::report(picture);
    picture.moves = std::move(moves_);
    picture.strokes = std::move(marks);
  }

 private:
  // What the output changed: a plotter is asked where it is, not what it was told.
  void note_movement(devices::PlotterPlace place, bool pen_down) {
    if (place != place_) add(PlotterAction::step, place, pen_down_);
    if (pen_down != pen_down_)
      add(pen_down ? PlotterAction::pen_down : PlotterAction::pen_up, place, pen_down);
    place_ = place;
    pen_down_ = pen_down;
  }
  void add(PlotterAction action, devices::PlotterPlace place, bool pen_down) {
    moves_.push_back(
        {action, static_cast<std::uint8_t>(place.x), static_cast<std::uint8_t>(place.y), pen_down});
  }

  devices::PlotterPlace place_{};
  bool pen_down_ = false;
  std::vector<PlotterMove> moves_;
};

}  // namespace sightline::guests::skala
