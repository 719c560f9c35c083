// Willis's method as it was meant to run: a model is made once, its frames go to the priority display. Times of this
// computer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

struct WillisModel;
struct WillisOrder;

struct WillisDisplay {
  double frames_per_s = 0;
  std::int64_t scan_lines = 0;
  double line_us = 0;
  std::int64_t shown_lines = 0;
  double frame_ms = 0;
};

// The model of a scene, and a frame of 512 by 512 points from the scene's own camera.
struct WillisFrame {
  std::string scene;
  std::size_t surfaces = 0;
  std::size_t tests = 0;
  std::size_t clusters = 0;
  std::size_t pieces = 0;
  std::size_t order_cells = 0;
  std::size_t left_over = 0;
  std::size_t distances = 0;
  std::size_t spans = 0;
  std::uint64_t points_covered = 0;
  // What the paper calls time-consuming: a plane's place on the line of sight of every point that a piece covers, and a scan of a
  // tree of planes (face_tree.hpp).
  std::uint64_t points_different = 0;  // from the picture by priorities
  std::size_t tree_nodes = 0;
  std::size_t tree_polygons = 0;
  struct Times {
    double prepare_ms = 0;
    double order_us = 0;
    double frame_ms = 0;
    double spans_us = 0;
    double lines_us = 0;  // of sight, with the spans
    double tree_us = 0;
  };
  std::optional<Times> times = {};  // empty without Context::host_times
};

// The times of a model of WillisOrder, and of ordering its surfaces.
struct WillisModelTime {
  double prepare_us = 0;
  double order_us = 0;
};

struct WillisTimes {
  WillisDisplay display;
  std::vector<WillisFrame> frames;
  std::vector<WillisModelTime> models;  // of WillisOrder::models, in their order; empty without Context::host_times

  // `model` is one of `order.models`. Throws std::out_of_range if times were not measured.
  [[nodiscard]] const WillisModelTime& of(const WillisModel& model, const WillisOrder& order) const;
};

[[nodiscard]] WillisTimes willis_times(const Context& context);

class Page;
void willis_timing(Page& page, const WillisTimes& times, const WillisOrder& order);

}  // namespace sightline::report
