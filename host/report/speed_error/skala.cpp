#include "host/report/speed_error/skala.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>

#include "host/algorithms/skala/draw.hpp"
#include "host/guests/skala/projection.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/report/speed_error/clock.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::skala;

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

scene::HeightGrid grid_of(std::string_view function, scene::GridSize size) {
  return scene::sample(*scene::height_function(function), size);
}

// One picture in both programs' words.
struct Order {
  guests::skala::PictureKind picture = guests::skala::PictureKind::lines;
  int levels = 8;
  int raster = guests::skala::raster_side;  // dots a side; the program on the 8080 has up to 256
  guests::skala::Device device = guests::skala::Device::ef9365;
  guests::skala::Link link = guests::skala::Link::parallel;
};

guests::skala::View view_of(const Order& order) {
  guests::skala::View view;
  view.picture = order.picture;
  view.family = guests::skala::Family::along_x;
  view.device = order.device;
  view.rotation = rotation;
  view.levels = order.levels;
  view.zoom = static_cast<double>(order.raster) / guests::skala::raster_side;
  return view;
}

native::View native_view(const Order& order, int columns) {
  native::View view;
  const bool contours = order.picture == guests::skala::PictureKind::contours;
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

guests::skala::TwinPicture twin_of(std::span<const std::uint8_t> stream, guests::skala::Device device) {
  guests::skala::Equipment equipment;
  equipment.present = {};
  equipment.present[static_cast<std::size_t>(device)] = true;
  return guests::skala::run_twin(stream, equipment);
}

Outcome<guests::skala::GuestPicture> run_guest(const guests::skala::Program& program,
                                               const std::vector<std::uint8_t>& stream, const Order& order) {
  guests::skala::GuestOptions options;
  options.device = order.device;
  options.link = order.link;
  guests::skala::GuestPicture guest = guests::skala::run_guest(program, stream, options);
  if (!guest.ended || guest.status != guests::skala::Status::complete || !guest.faults.empty())
    return ReportError{ErrorKind::guest_failed, "the program on the 8080 failed"};
  const std::string difference =
      guests::skala::difference_from_twin(guest, twin_of(stream, order.device), order.device);
  if (!difference.empty())
    return ReportError{
        ErrorKind::differs,
        "internal error: the 8080's picture is not the one its native twin makes; " + difference};
  return guest;
}

// Measures pictures, and keeps what is to be timed when all are measured.
class Bench {
 public:
  Bench(const guests::skala::Program& program, bool host_times)
      : program_(program), host_times_(host_times) {}

  // Adds to the program's points.
  [[nodiscard]] std::optional<ReportError> add_program(std::vector<SkalaPoint>& points, int setting,
                                                       const scene::HeightGrid& grid, const Order& order,
                                                       const FinePicture& fine) {
    auto stream = guests::skala::stream_of(grid, view_of(order));
    const auto run = run_guest(program_, stream, order);
    if (!run) return run.error();
    const auto& guest = *run;
    points.push_back({setting, fine.error_of(dots_of(guest.raster, order.raster)), guest.drawing, {}});
    later(points, [stream = std::move(stream)] { (void)twin_of(stream, guests::skala::Device::ef9365); });
    return std::nullopt;
  }

  // As dots on a raster with masks of so many columns.
  void add_native_dots(std::vector<SkalaPoint>& points, const scene::HeightGrid& grid, const Order& order,
                       const FinePicture& fine) {
    const native::View view = native_view(order, order.raster);
    points.push_back({order.raster, fine.error_of(dots_of(native::draw(grid, view), order.raster)), {}, {}});
    later(points, [grid, view] { (void)native::draw(grid, view); });
  }
  // As vectors.
  void add_native_vectors(std::vector<SkalaPoint>& points, int setting, const scene::HeightGrid& grid,
                          const Order& order, const FinePicture& fine) {
    const native::View view = native_view(order, native::View{}.columns);
    points.push_back({setting, fine.error_of(native::draw(grid, view), guests::skala::raster_side), {}, {}});
    later(points, [grid, view] { (void)native::draw(grid, view); });
  }

  // All at once, interleaved. The vectors given to add_... are where they were.
  void take_times(int rounds) {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < times.size(); ++i)
      (*results_[i].first)[results_[i].second].host_ns = times[i];
  }

 private:
  void later(std::vector<SkalaPoint>& points, std::function<void()> job) {
    if (!host_times_) return;
    results_.emplace_back(&points, points.size() - 1);
    jobs_.push_back(std::move(job));
  }

  const guests::skala::Program& program_;
  bool host_times_;
  std::vector<std::function<void()>> jobs_;
  std::vector<std::pair<std::vector<SkalaPoint>*, std::size_t>> results_;
};

std::optional<ReportError> measure_rasters(SkalaCurve& curve, Bench& bench) {
  const auto grid = grid_of(curve.function, raster_grid);
  const FinePicture fine = fine_picture(grid, {});
  for (const int raster : raster_sizes) {
    Order order;
    order.raster = raster;
    bench.add_native_dots(curve.native, grid, order, fine);
    if (raster > guests::skala::raster_side) continue;
    if (auto error = bench.add_program(curve.program, raster, grid, order, fine)) return error;
  }
  return std::nullopt;
}

std::optional<ReportError> measure_grids(SkalaCurve& curve, Bench& bench) {
  const FinePicture fine = fine_picture(grid_of(curve.function, {finest_slice, slices}), {});
  for (const int points : grid_points) {
    const auto grid = grid_of(curve.function, {static_cast<std::size_t>(points), slices});
    bench.add_native_vectors(curve.native, points, grid, {}, fine);
    if (auto error = bench.add_program(curve.program, points, grid, {}, fine)) return error;
  }
  return std::nullopt;
}

std::optional<ReportError> measure_levels(SkalaCurve& curve, Bench& bench) {
  const auto grid = grid_of(curve.function, contour_grid);
  const auto finest = grid_of(curve.function, finest_contour_grid);
  for (const int levels : level_counts) {
    Order order;
    order.picture = guests::skala::PictureKind::contours;
    order.levels = levels;
    const FinePicture fine = fine_picture(finest, order);
    bench.add_native_vectors(curve.native, levels, grid, order, fine);
    if (auto error = bench.add_program(curve.program, levels, grid, order, fine)) return error;
  }
  return std::nullopt;
}

std::optional<ReportError> measure_boards(const guests::skala::Program& program,
                                          std::vector<SkalaBoard>& boards) {
  for (const char* const function : functions) {
    const auto grid = grid_of(function, board_grid);
    const FinePicture fine = fine_picture(grid, {});
    for (const guests::skala::Device device :
         {guests::skala::Device::ef9365, guests::skala::Device::alt256}) {
      for (const guests::skala::Link link : {guests::skala::Link::parallel, guests::skala::Link::serial}) {
        Order order;
        order.device = device;
        order.link = link;
        const auto run = run_guest(program, guests::skala::stream_of(grid, view_of(order)), order);
        if (!run) return run.error();
        const auto& guest = *run;
        boards.push_back({function, device, link, fine.error_of(dots_of(guest.raster, guests::skala::raster_side)),
                          guest.drawing, guest.total, guest.dots_not_shown});
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Outcome<SkalaMeasured> measure_skala(const Context& context) {
  const guests::skala::Program program = guests::skala::assemble_program();
  SkalaMeasured measured;
  Bench bench(program, context.host_times);
  const std::array knobs{std::pair{&measured.rasters, &measure_rasters},
                         std::pair{&measured.grids, &measure_grids},
                         std::pair{&measured.levels, &measure_levels}};
  for (const auto& [curves, measure] : knobs) {
    for (const char* const function : functions) curves->push_back({function, {}, {}});
    for (SkalaCurve& curve : *curves) {
      context.progress(fmt::format("{} on the 8080, of every size", curve.function));
      if (auto error = measure(curve, bench)) {
        error->message = curve.function + ": " + error->message;
        return std::move(*error);
      }
    }
  }
  if (auto error = measure_boards(program, measured.boards)) return std::move(*error);
  if (context.host_times) {
    context.progress("Skala in C++, timed");
    bench.take_times(context.full ? 31 : 9);
  }
  return measured;
}

}  // namespace sightline::harness::report
