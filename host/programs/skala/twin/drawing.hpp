// The execution of each drawing command in the twin of the Skala program. Source:
// firmware/i8080/skala/SPECIFICATION.md sections 2 to 8.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/programs/skala/twin/masks.hpp"
#include "host/programs/skala/twin/twin.hpp"

namespace sightline::programs::skala {

// The pen of the Skala program on a plotter: converts visible points, given one by one, to steps and pen movements; runs of
// one point are dropped, and the pen is lifted only to travel. Source: firmware/i8080/skala/SPECIFICATION.md section 8.
class PlotterPen {
 public:
  // Movements are appended to `moves` and counted in `counts`; both must outlive the pen.
  PlotterPen(std::vector<PlotterMove>& moves, Counts& counts) : moves_(moves), counts_(counts) {}

  // The next visible point. Within a run it is a neighbour of the one before.
  void visible(Point point);
  // Ends a run: at a hidden point, a movement elsewhere, or the end of the picture.
  void end_run() { run_points_ = 0; }
  void lift();
  // The last step was visible and belongs to the run that a visible point would continue.
  [[nodiscard]] bool in_run() const { return run_points_ != 0; }

 private:
  void put_down_at(Point point);
  void step_towards(Point point);

  std::vector<PlotterMove>& moves_;
  Counts& counts_;
  Point at_;  // the pen's actual position
  bool down_ = false;
  int run_points_ = 0;  // length of the current run, not counted beyond two
  Point remembered_;    // its first point
};

struct ReceivedCommand {
  Command command;
  std::size_t last_byte;  // index in the stream
  std::span<const std::uint8_t> arguments;
};

class TwinDrawing {
 public:
  // Draws into `picture`, which must outlive it, like a program that has just been started.
  TwinDrawing(TwinPicture& picture, const Equipment& equipment);

  // False if the device of a DEVICE command does not answer; then nothing has changed.
  [[nodiscard]] bool obey(const ReceivedCommand& received);

 private:
  // The treatment of a line's points.
  enum class Mode : std::uint8_t {
    draw,     // tested and masked
    test,     // tested with slack
    mask,     // masked without ink
    plain,    // every point plotted
    travel,   // moves the pen without points
    surface,  // shaded and filled
    rim,      // shaded
  };

  [[nodiscard]] bool select_device(std::uint8_t argument);
  void reset();
  void move_to(Point point);
  // A MOVE that is executed wherever the pen is.
  void set_down(Point point);
  // `mode` is that of the command; effective() adapts it to the device and visibility.
  void line_to(Point point, Mode mode) { line_to(point, mode, level_); }
  void line_to(Point point, Mode mode, std::uint8_t level);
  void curve(std::span<const std::uint8_t> arguments);
  void surface(std::span<const std::uint8_t> arguments);
  void rim(Point point, std::uint8_t level);
  void gap(std::span<const std::uint8_t> arguments);
  void commit();
  void outline();
  void outline_run(int first, int last);

  [[nodiscard]] Mode effective(Mode mode) const;
  void step(Point point, Mode mode);
  [[nodiscard]] bool visible_to_draw(Point point) const;
  void ink(bool visible, Point point);
  void plot(Point point, std::uint8_t colour);
  void plot_folds(const FoldLines& lines);
  void plot_fold(const FoldLine& line);
  void shade(Point point, bool may_fill);
  void fill(Point from, std::uint8_t to_y, std::uint8_t to_level);

  [[nodiscard]] bool on_raster() const { return is_raster(device_); }

  TwinPicture& picture_;
  Equipment equipment_;
  Masks masks_;
  PlotterPen pen_;
  Device device_ = Device::ef9365;
  bool visibility_ = true;
  std::uint8_t colour_ = 7;
  std::uint8_t silhouette_ = 0;
  Point at_;           // the pen position (xp, yp) of the specification
  bool fresh_ = true;  // at_ has not been stepped
  std::uint8_t level_ = 0;
  std::optional<std::uint8_t> shaded_column_;  // of the last shaded point of this slice
};

}  // namespace sightline::programs::skala
