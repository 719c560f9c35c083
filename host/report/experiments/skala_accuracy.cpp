// Skala's program and its native version on rasters, grids and numbers of levels of every size: how wrong and how
// long.
//
// Reference: the native program with 16384 columns of masks, 64 to a dot of the 8080's raster: for the raster on
// the same grid, for grids on slices of 1024 points, for contours on a grid four times as fine. The column oracle
// cannot serve: it knows pictures of 256 by 256 rounded points only, and so has the very errors that are measured.
//
//   points  a study (raster, grid, levels), function, program and setting each
//   boards  both boards on both links, 65 points in each of 33 slices
#include <fmt/core.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/guests/skala/projection.hpp"
#include "host/guests/skala/session.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/surface_error.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::skala;
namespace skala = guests::skala;

constexpr std::array functions{"sinc", "peaks", "cosr"};
constexpr std::array<int, 5> raster_sizes{64, 128, 256, 512, 1024};
constexpr std::array<int, 6> grid_points{8, 16, 32, 64, 128, 256};
constexpr std::array<int, 6> level_counts{1, 2, 4, 8, 16, 32};
constexpr std::size_t slices = 33;
// So few points that they are more than two columns apart on 64 dots too: of nearer ones the host makes
// curves of dots, which the program draws in another way.
constexpr scene::GridSize raster_grid{17, slices};
constexpr scene::GridSize board_grid{65, slices};
constexpr std::size_t finest_slice = 1024;  // points
constexpr scene::GridSize contour_grid{33, 33};
constexpr scene::GridSize finest_contour_grid{129, 129};  // all points of contour_grid are in it
constexpr double rotation = 30;
constexpr double pixels = 1024;  // in which distances are told

scene::HeightGrid grid_of(std::string_view function, scene::GridSize size) {
  return scene::sample(*scene::height_function(function), size);
}

// One picture in both programs' words.
struct Order {
  skala::PictureKind picture = skala::PictureKind::lines;
  int levels = 8;
  int raster = skala::raster_side;  // dots a side; the program on the 8080 has up to 256
  skala::Device device = skala::Device::ef9365;
  skala::Link link = skala::Link::parallel;
};

skala::View view_of(const Order& order) {
  skala::View view;
  view.picture = order.picture;
  view.family = skala::Family::along_x;
  view.device = order.device;
  view.rotation = rotation;
  view.levels = order.levels;
  view.zoom = static_cast<double>(order.raster) / skala::raster_side;
  return view;
}

native::View native_view(const Order& order, int columns) {
  native::View view;
  const bool contours = order.picture == skala::PictureKind::contours;
  view.subject = contours ? native::Subject::contours : native::Subject::lines;
  view.silhouette = contours;  // the program draws the outline of the surface with its contours
  view.family = native::Family::along_x;
  view.rotation = rotation;
  view.levels = order.levels;
  view.columns = columns;
  return view;
}

FinePicture fine_picture(const scene::HeightGrid& grid, const Order& order) {
  return FinePicture(native::draw(grid, native_view(order, native::most_columns)));
}

skala::TwinPicture twin_of(std::span<const std::uint8_t> stream) {
  skala::Equipment equipment{{}};
  equipment.present[static_cast<std::size_t>(skala::Device::ef9365)] = true;
  return skala::run_twin(stream, equipment);
}

skala::GuestPicture run_guest(const skala::Session& session, const std::vector<std::uint8_t>& stream,
                              const Order& order) {
  skala::GuestOptions options;
  options.device = order.device;
  options.link = order.link;
  skala::CheckedPicture run = session.run(stream, options);
  if (!run.guest.ended || run.guest.status != skala::Status::complete || !run.guest.faults.empty())
    throw Failure(ErrorKind::guest_failed, "the program on the 8080 failed");
  if (!run.difference.empty())
    throw Failure(ErrorKind::differs,
                  "internal error: the 8080's picture is not the one its native twin makes; " + run.difference);
  return std::move(run.guest);
}

double seconds(core::TStates time) {
  return static_cast<double>(time.count()) / static_cast<double>(core::ClockRate{}.hertz);
}

// raster: dots a side.
void add_error(NamedValues& row, const SurfaceError& error, int raster) {
  row.emplace_back("pmr_per_cent", error.mismatch);
  row.emplace_back("pmr_far_per_cent", error.far);
  row.emplace_back("h_px", error.hausdorff);
  row.emplace_back("h_dots", error.hausdorff * raster / pixels);
  row.emplace_back("h_usual_px", error.usual);
}

// Measures pictures, and keeps what is to be timed when all are measured.
class Study {
 public:
  Study(const skala::Session& session, bool host_times) : session_(session), host_times_(host_times) {}

  void on_rasters(std::string_view function) {
    begin("raster", function);
    const auto grid = grid_of(function, raster_grid);
    const FinePicture fine = fine_picture(grid, {});
    for (const int raster : raster_sizes) {
      const Order order{.raster = raster};
      const native::View view = native_view(order, raster);
      add(raster, raster, fine.error_of(dots_of(native::draw(grid, view), raster)), {});
      later([grid, view] { (void)native::draw(grid, view); });
      if (raster <= skala::raster_side) add_program(raster, grid, order, fine);
    }
  }

  void on_grids(std::string_view function) {
    begin("grid", function);
    const FinePicture fine = fine_picture(grid_of(function, {finest_slice, slices}), {});
    for (const int points : grid_points)
      add_both(points, grid_of(function, {static_cast<std::size_t>(points), slices}), {}, fine);
  }

  void with_levels(std::string_view function) {
    begin("levels", function);
    const auto grid = grid_of(function, contour_grid);
    const auto finest = grid_of(function, finest_contour_grid);
    for (const int levels : level_counts) {
      const Order order{.picture = skala::PictureKind::contours, .levels = levels};
      add_both(levels, grid, order, fine_picture(finest, order));
    }
  }

  [[nodiscard]] const RowSet& points() const { return points_; }
  // All at once, interleaved; `points` are these.
  void take_times(RowSet& points, int rounds) const {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < times.size(); ++i) points.set(timed_[i], "host_us", times[i] / 1000);
  }

 private:
  void begin(std::string_view study, std::string_view function) {
    study_ = study;
    function_ = function;
  }

  // drawing: of the program on the 8080; none: a picture of the native program.
  void add(int setting, int raster, const SurfaceError& error, std::optional<core::TStates> drawing) {
    NamedValues row{{"study", study_},
                    {"function", function_},
                    {"program", drawing ? "8080 and its twin" : "native"},
                    {"setting", setting}};
    add_error(row, error, raster);
    row.emplace_back("drawing_t_states", drawing ? Value(drawing->count()) : Value());
    row.emplace_back("drawing_s", drawing ? Value(seconds(*drawing)) : Value());
    row.emplace_back("host_us", Value());
    points_.add(row);
  }

  void add_program(int setting, const scene::HeightGrid& grid, const Order& order, const FinePicture& fine) {
    auto stream = skala::stream_of(grid, view_of(order));
    const auto guest = run_guest(session_, stream, order);
    add(setting, order.raster, fine.error_of(dots_of(guest.raster, order.raster)), guest.drawing);
    later([stream = std::move(stream)] { (void)twin_of(stream); });
  }

  // And the native program's picture as vectors.
  void add_both(int setting, const scene::HeightGrid& grid, const Order& order, const FinePicture& fine) {
    add_program(setting, grid, order, fine);
    const native::View view = native_view(order, native::View{}.columns);
    add(setting, skala::raster_side, fine.error_of(native::draw(grid, view), skala::raster_side), {});
    later([grid, view] { (void)native::draw(grid, view); });
  }

  void later(std::function<void()> job) {
    if (!host_times_) return;
    timed_.push_back(points_.size() - 1);
    jobs_.push_back(std::move(job));
  }

  const skala::Session& session_;  // of measuring, not of what is timed
  bool host_times_;
  std::string study_;
  std::string function_;
  RowSet points_;
  std::vector<std::function<void()>> jobs_;
  std::vector<std::size_t> timed_;  // rows
};

void add_boards(RowSet& boards, const skala::Session& session, std::string_view function) {
  const auto grid = grid_of(function, board_grid);
  const FinePicture fine = fine_picture(grid, {});
  for (const skala::Device device : {skala::Device::ef9365, skala::Device::alt256}) {
    for (const skala::Link link : {skala::Link::parallel, skala::Link::serial}) {
      const Order order{.device = device, .link = link};
      const auto guest = run_guest(session, skala::stream_of(grid, view_of(order)), order);
      NamedValues row{{"function", function},
                      {"board", fmt::format("{}, {} link", device == skala::Device::ef9365 ? "EF9365" : "ALT-256",
                                            link == skala::Link::serial ? "serial" : "parallel")}};
      add_error(row, fine.error_of(dots_of(guest.raster, skala::raster_side)), skala::raster_side);
      row.emplace_back("drawing_t_states", guest.drawing.count());
      row.emplace_back("drawing_s", seconds(guest.drawing));
      row.emplace_back("total_t_states", guest.total.count());
      row.emplace_back("total_s", seconds(guest.total));
      row.emplace_back("dots_not_shown", guest.dots_not_shown);
      boards.add(row);
    }
  }
}

}  // namespace

Records skala_accuracy(const Context& context) {
  const skala::Session session;
  Records records;
  const auto study = std::make_shared<Study>(session, context.host_times);
  for (const auto measure : {&Study::on_rasters, &Study::on_grids, &Study::with_levels}) {
    for (const char* const function : functions) {
      context.progress(fmt::format("{} on the 8080, of every size", function));
      ((*study).*measure)(function);
    }
  }
  for (const char* const function : functions) add_boards(records["boards"], session, function);
  records["points"] = study->points();
  if (context.host_times)
    context.alone([study, progress = context.progress, rounds = context.full ? 31 : 5](Records& made) {
      progress("Skala in C++, timed");
      study->take_times(made["points"], rounds);
    });
  return records;
}

}  // namespace sightline::report
