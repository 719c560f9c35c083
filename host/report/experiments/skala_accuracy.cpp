// Reference: the native program with 16384 columns of masks, 64 per dot of the 8080's raster: for rasters on the same
// grid, for grids on slices of 1024 points, for contours on a grid four times as fine. The column oracle cannot be
// the reference: it has pictures of 256 by 256 rounded points only, with the very errors that are measured.
#include "host/report/experiments/skala_accuracy.hpp"

#include <fmt/core.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/base/value_of.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::skala;
namespace skala = programs::skala;

constexpr std::array functions{"sinc", "peaks", "cosr"};
constexpr std::array<int, 5> raster_sizes{64, 128, 256, 512, 1024};
constexpr std::array<int, 6> grid_points{8, 16, 32, 64, 128, 256};
constexpr std::array<int, 6> level_counts{1, 2, 4, 8, 16, 32};
constexpr std::size_t slices = 33;
// So few points that they are more than two columns apart even on 64 dots. Of nearer points the host makes curves of
// dots, which the program draws in another way.
constexpr scene::GridSize raster_grid{17, slices};
constexpr scene::GridSize board_grid{65, slices};
constexpr std::size_t finest_slice = 1024;  // points
constexpr scene::GridSize contour_grid{33, 33};
constexpr scene::GridSize finest_contour_grid{129, 129};  // all points of contour_grid are in it
constexpr double rotation = 30;

// Converts pixels of a raster of 1024 to dots.
double dots_of_pixels(double pixels, int raster) {
  return pixels * raster / 1024;
}

scene::HeightGrid grid_of(std::string_view function, scene::GridSize size) {
  return scene::sample(*scene::height_function(function), size);
}

// One picture in the terms of both programs.
struct Order {
  skala::Subject picture = skala::Subject::lines;
  int levels = 8;
  int raster = skala::raster_side;  // dots a side; the program on the 8080 has up to 256
  skala::Device device = skala::Device::ef9365;
  skala::Link link = skala::Link::parallel;
};

skala::View view_of(const Order& order) {
  skala::View view;
  view.subject = order.picture;
  view.family = skala::Family::along_x;
  view.rotation = rotation;
  view.levels = order.levels;
  view.silhouette = order.picture == skala::Subject::contours;
  view.zoom = static_cast<double>(order.raster) / skala::raster_side;
  return view;
}

native::View native_view(const Order& order, int columns) {
  native::View view;
  const bool contours = order.picture == skala::Subject::contours;
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

skala::MachinePicture checked_picture(const scene::HeightGrid& grid, const Order& order) {
  return base::value_of(skala::run({.grid = grid, .view = view_of(order), .device = order.device, .link = order.link, .check = true})).picture;
}

// Measures pictures, and schedules the timing that follows when all are measured.
class Study {
 public:
  Study(std::vector<SkalaPoint>& points, bool host_times) : points_(points), host_times_(host_times) {}

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
      const Order order{.picture = skala::Subject::contours, .levels = levels};
      add_both(levels, grid, order, fine_picture(finest, order));
    }
  }

  // Interleaves all of them.
  void take_times(int rounds) {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < times.size(); ++i) points_[timed_[i]].host_us = times[i] / 1000;
  }

 private:
  void begin(std::string_view study, std::string_view function) {
    study_ = study;
    function_ = function;
  }

  // `drawing`: of the program on the 8080; empty: a picture of the native program.
  void add(int setting, int raster, const SurfaceError& error, std::optional<core::TStates> drawing) {
    SkalaPoint point{study_, function_, drawing ? "8080 and its twin" : "native", setting, raster, error, {}, {}, {}};
    if (drawing) {
      point.drawing_t_states = static_cast<std::uint64_t>(drawing->count());
      point.drawing_s = core::in_seconds(*drawing);
    }
    points_.push_back(std::move(point));
  }

  void add_program(int setting, const scene::HeightGrid& grid, const Order& order, const FinePicture& fine) {
    const auto picture = checked_picture(grid, order);
    add(setting, order.raster, fine.error_of(dots_of(picture.raster, order.raster)), picture.drawing);
    later([stream = skala::stream_of(grid, view_of(order))] { (void)twin_of(stream); });
  }

  // Adds the native program's picture as vectors, too.
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

  std::vector<SkalaPoint>& points_;
  bool host_times_;
  std::string study_;
  std::string function_;
  std::vector<std::function<void()>> jobs_;
  std::vector<std::size_t> timed_;  // rows
};

void add_boards(std::vector<SkalaBoard>& boards, std::string_view function) {
  const auto grid = grid_of(function, board_grid);
  const FinePicture fine = fine_picture(grid, {});
  for (const skala::Device device : {skala::Device::ef9365, skala::Device::alt256}) {
    for (const skala::Link link : {skala::Link::parallel, skala::Link::serial}) {
      const Order order{.device = device, .link = link};
      const auto picture = checked_picture(grid, order);
      boards.push_back({std::string(function),
                        fmt::format("{}, {} link", device == skala::Device::ef9365 ? "EF9365" : "ALT-256",
                                    link == skala::Link::serial ? "serial" : "parallel"),
                        fine.error_of(dots_of(picture.raster, skala::raster_side)),
                        static_cast<std::uint64_t>(picture.drawing.count()), core::in_seconds(picture.drawing),
                        static_cast<std::uint64_t>(picture.total.count()), core::in_seconds(picture.total), picture.dots_not_shown});
    }
  }
}

// The chapter.

using Point = SkalaPoint;

double pixels_off(const Point& point) {
  return point.error.hausdorff;
}

// An error shown in plots.
struct Measure {
  std::string key;
  std::string title;
  std::string unit;
  double (*of)(const Point&);
};

const std::array<Measure, 2>& measures() {
  static const std::array<Measure, 2> both{
      Measure{"h", "greatest distance", "pixels of 1024", &pixels_off},
      Measure{"pmr", "differing pixels", "% of the raster", [](const Point& point) { return point.error.mismatch; }}};
  return both;
}

Chosen<Point> of_study(const SkalaAccuracy& skala, std::string_view study, bool emulated_only) {
  return where(skala.points, [=](const Point& point) { return point.study == study && !(emulated_only && point.native()); });
}

// The setting labels the points of one function.
CurveParts<Point> labels_at(std::string function) {
  return {[function = std::move(function)](const Point& point) {
    return point.function == function ? fmt::format("{}", point.setting) : std::string();
  }};
}

void plot_emulated(Page& page, const SkalaAccuracy& skala, const Measure& measure, const std::string& study,
                   const std::string& id, const std::string& what, const CheckedText& caption, const std::string& alternative,
                   const std::string& labelled) {
  Plot plot{id,
            fmt::format("Skala on the 8080: {}: {}", what, measure.title),
            caption + " Drawing on the EF9365 board, 8080 at 3 MHz.",
            alternative + ", one curve for each function.",
            {measure.title, measure.unit},
            {"a drawing, time on the emulated machine", "s"}};
  add_curves(plot, of_study(skala, study, true), &Point::function, measure.of, &Point::drawing_s, labels_at(labelled));
  page.plot(std::move(plot));
}

void plot_host(Page& page, const SkalaAccuracy& skala, const Measure& measure, const std::string& study, const std::string& id,
               const std::string& what, const std::string& caption, const std::string& alternative, const std::string& labelled) {
  if (!page.host_times()) return;
  Plot plot{id,
            fmt::format("Skala in C++: {}: {}", what, measure.title),
            caption + " Times are medians of interleaved repetitions, of this computer.",
            alternative,
            {measure.title, measure.unit},
            {"a drawing, time on this computer", "ms"}};
  const auto milliseconds = [](const Point& point) {
    return point.host_us ? std::optional(*point.host_us / 1000) : std::optional<double>();
  };
  add_curves(plot, where(of_study(skala, study, false), [](const Point& point) { return point.host_us.has_value(); }),
             [](const Point& point) { return fmt::format("{}, {}", point.function, point.program); }, measure.of, milliseconds,
             labels_at(labelled));
  page.plot(std::move(plot));
}

void raster_plots(Page& page, const SkalaAccuracy& skala) {
  const std::string what = "rasters of more and more dots a side";
  const double farthest = greatest(of_study(skala, "raster", true), &Point::dots_off);
  for (const Measure& measure : measures())
    plot_emulated(page, skala, measure, "raster", fmt::format("skala-raster-{}-emulated", measure.key), what,
                  "33 slices of 17 points. The program on the 8080 has 256 dots and is made to use fewer by zooming out. " +
                      page.claim(farthest <= 2.5, fmt::format("The greatest distance is at most {} dots of the raster at hand.",
                                                              text_of(farthest, 1))),
                  "Log-log plot of the time of a drawing against its error on rasters of 64, 128 and 256 dots a side", "sinc");
  plot_host(page, skala, measures()[0], "raster", "skala-raster-h-host", what, "33 slices of 17 points.",
            "Log-log plot of the time of a drawing against its error on rasters of 64 to 1024 dots a side, one curve for each "
            "function and program.",
            "sinc");
}

void grid_plots(Page& page, const SkalaAccuracy& skala) {
  const std::string what = "8 to 256 points in each of 33 slices";
  const std::string alternative = "Log-log plot of the time of a drawing against its error with 8 to 256 points for each slice";
  const auto point = [&](std::string_view function, bool native, int points) -> const Point& {
    return only(skala.points, [=](const Point& row) {
      return row.study == "grid" && row.function == function && row.native() == native && row.setting == points;
    });
  };
  const auto gain = [&](std::string_view function, bool native) {
    return text_of(pixels_off(point(function, native, 8)) / pixels_off(point(function, native, 64)), 0);
  };
  const CheckedText caption = fmt::format(
      "Compared with slices of 1024 points. From 8 to 64 points for each slice, eight times as many, the greatest distance of "
      "the native program falls {} times for sinc and {} times for peaks; on the 8080, whose raster has 256 dots, {} and {} "
      "times. From 128 points on, points are closer than two dots and are sent as curves of dots: for sinc, drawing takes {} "
      "times as long as with 64.",
      gain("sinc", true), gain("peaks", true), gain("sinc", false), gain("peaks", false),
      text_of(*point("sinc", false, 128).drawing_s / *point("sinc", false, 64).drawing_s, 1));
  for (const Measure& measure : measures())
    plot_emulated(page, skala, measure, "grid", fmt::format("skala-grid-{}-emulated", measure.key), what, caption, alternative,
                  "sinc");
  plot_host(page, skala, measures()[0], "grid", "skala-grid-h-host", what, "Compared with slices of 1024 points.",
            alternative + ", one curve for each function and program.", "sinc");
}

void level_plots(Page& page, const SkalaAccuracy& skala) {
  const std::string what = "1 to 32 contour levels";
  const std::string caption =
      "33 x 33 points, compared with 129 x 129. The error is that of the grid; it depends on whether a level is near a peak.";
  const std::string alternative = "Log-log plot of the time of a drawing against its error with 1 to 32 levels of contours";
  plot_emulated(page, skala, measures()[1], "levels", "skala-levels-pmr-emulated", what, caption, alternative, "cosr");
  plot_host(page, skala, measures()[1], "levels", "skala-levels-pmr-host", what, caption,
            alternative + ", one curve for each function.", "cosr");
}

void study_table(Page& page, const SkalaAccuracy& skala, const std::string& study, const std::string& title,
                 const std::string& setting) {
  page.table(
      "skala-speed-error-" + study, "Skala: " + title, where(skala.points, equals(&Point::study, study)),
      {{"function", "Function", &Point::function},
       {"program", "Program", &Point::program},
       {study, setting, &Point::setting},
       {"pmr_per_cent", "Differing pixels", "% of the raster", measures()[1].of},
       {"pmr_far_per_cent", "Differing pixels, no lit dot beside", "%", [](const Point& point) { return point.error.far; }},
       {"h_px", "Greatest distance", "pixels of 1024", &pixels_off},
       {"h_dots", "Greatest distance", "dots of the raster", &Point::dots_off},
       {"h_usual_px", "Distance of all but 1 sample in 1000", "pixels of 1024",
        [](const Point& point) { return point.error.usual; }},
       {"drawing_t_states", "Drawing on the 8080", "T-states", &Point::drawing_t_states},
       {"drawing_s", "at 3 MHz", "s", &Point::drawing_s, 3},
       {"host_us", "Drawing in C++", "us", &Point::host_us, 1, host_time}},
      {.folded = true});
}

void boards(Page& page, const SkalaAccuracy& skala) {
  using Board = SkalaBoard;
  const auto mismatch = [](const Board& board) { return board.error.mismatch; };
  const auto of = [&](const char* function) { return where(skala.boards, equals(&Board::function, function)); };
  bool same = true;
  for (const char* const function : functions) same = same && distinct(of(function), mismatch) == 1;
  const auto sinc = range_of(of("sinc"), &Board::total_s);
  Plot plot{"skala-boards-pmr",
            "Skala on the 8080: two boards and two links, receipt included",
            "33 slices of 65 points of three functions, from the first byte of a command to the last dot." +
                page.claim(same, "The board does not change the picture, so the points of a function are on one vertical."),
            fmt::format("Plot of the time of a picture against its error for each board and link; for sinc it takes {} to {} s.",
                        text_of(sinc.least, 1), text_of(sinc.greatest, 1)),
            {"differing pixels", "% of the raster", false},
            {"a picture, time on the emulated machine", "s"}};
  add_curves(plot, skala.boards, &Board::board, mismatch, &Board::total_s,
             {[](const Board& board) { return board.function; }, false});
  page.plot(std::move(plot));
  page.table(
      "skala-boards", "Skala: two boards and two links", skala.boards,
      {{"function", "Function", &Board::function},
       {"board", "Board and link", &Board::board},
       {"pmr_per_cent", "Differing pixels", "% of the raster", mismatch},
       {"pmr_far_per_cent", "Differing pixels, no lit dot beside", "%", [](const Board& board) { return board.error.far; }},
       {"h_px", "Greatest distance", "pixels of 1024", [](const Board& board) { return board.error.hausdorff; }},
       {"h_dots", "Greatest distance", "dots",
        [](const Board& board) { return dots_of_pixels(board.error.hausdorff, skala::raster_side); }, 2},
       {"h_usual_px", "Distance of all but 1 sample in 1000", "pixels of 1024",
        [](const Board& board) { return board.error.usual; }},
       {"drawing_t_states", "Drawing", "T-states", &Board::drawing_t_states},
       {"drawing_s", "Drawing", "s at 3 MHz", &Board::drawing_s, 3},
       {"total_t_states", "With the receipt of commands", "T-states", &Board::total_t_states},
       {"total_s", "With the receipt", "s at 3 MHz", &Board::total_s, 3},
       {"dots_not_shown", "Dots in rows not shown", &Board::dots_not_shown}},
      {{"33 slices of 65 points. Both boards store the same dots; the ALT-256 shows fewer rows than it stores. The link "
        "affects the receipt only."},
       true});
}

}  // namespace

double SkalaPoint::dots_off() const {
  return dots_of_pixels(error.hausdorff, raster);
}

void skala_accuracy(const Context& context, SkalaAccuracy& made) {
  const auto study = std::make_shared<Study>(made.points, context.host_times);
  for (const auto measure : {&Study::on_rasters, &Study::on_grids, &Study::with_levels}) {
    for (const char* const function : functions) {
      context.progress(fmt::format("{} on the 8080, of every size", function));
      ((*study).*measure)(function);
    }
  }
  for (const char* const function : functions) add_boards(made.boards, function);
  if (context.host_times)
    context.when_alone([study, progress = context.progress, rounds = context.full ? 31 : 5] {
      progress("Skala in C++, timed");
      study->take_times(rounds);
    });
}

void skala_accuracy_chapter(Page& page, const SkalaAccuracy& skala) {
  page.paragraph(
      "Pictures of three functions turned by 30 degrees, compared with the native program with 16384 columns of masks, 64 to a "
      "dot of the 8080's raster. The measures are: differing pixels, the share of the raster's dots that differ, and of these "
      "those without a lit dot beside them; and the greatest distance between the dots or lines of the two pictures, also "
      "without the farthest one of a thousand samples. In the plots less error is to the left and less time is below. The "
      "program tests contours with a tolerance of one dot: `sightline compare sinc --picture contours` counts the dots that "
      "are more than a point from any visible contour.");
  raster_plots(page, skala);
  grid_plots(page, skala);
  level_plots(page, skala);
  study_table(page, skala, "raster", "rasters of more and more dots a side", "Dots a side");
  study_table(page, skala, "grid", "8 to 256 points in each of 33 slices", "Points for each slice");
  study_table(page, skala, "levels", "1 to 32 contour levels", "Levels");
  boards(page, skala);
}

}  // namespace sightline::report
