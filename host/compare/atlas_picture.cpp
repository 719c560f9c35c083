// See atlas_picture.hpp.
#include "host/compare/atlas_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "host/picture/height_colours.hpp"
#include "host/picture/lettering.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::compare {
namespace {

using picture::Colour;
using picture::VectorDrawing;

// Pixels.
constexpr double border = 28;
constexpr double text_height = 13;
constexpr double small_text = 10;
constexpr double line_height = 24;
constexpr double gap = 64;  // at the right of a panel
constexpr double most_across = 600;
constexpr double most_along = 800;
constexpr double least_side = 120;    // of a plan, which is stretched if necessary
constexpr double least_across = 520;  // of a panel with its legend
constexpr std::size_t most_listed = 16;
constexpr double mark = 3;  // half a mark of a wrong view, which stays visible however small its place is

constexpr Colour grey{205, 205, 205};  // invalid eye
constexpr Colour right{190, 216, 236};
constexpr Colour paper{255, 255, 255};
// For wrong lengths up to so many points. The colours of Okabe and Ito (2008), and black where the machine stopped.
struct WrongClass {
  double up_to;
  const char* label;
  Colour colour;
};
constexpr std::array<WrongClass, 4> wrong_classes{{{3, "up to 3 points wrong", {240, 200, 40}},
                                                   {10, "3 to 10 points", {230, 145, 0}},
                                                   {30, "10 to 30 points", {213, 80, 0}},
                                                   {1e9, "more than 30 points", {150, 0, 60}}}};
constexpr Colour stopped{0, 0, 0};

enum Layer : std::uint32_t { ink, faint, wall, ring };

const WrongClass& class_of(double length) {
  return *std::find_if(wrong_classes.begin(), wrong_classes.end(),
                       [&](const WrongClass& c) { return length <= c.up_to; });
}

Colour colour_of(const AtlasView& view) {
  if (!view.is_wrong()) return right;
  if (view.cause->status != programs::jones::Status::complete) return stopped;
  return class_of(view.wrong.length()).colour;
}

class Sheet {
 public:
  Sheet(double width, double height) {
    drawing_.width = width;
    drawing_.height = height;
    drawing_.layers = {
        {"text", {0, 0, 0}}, {"edges", {150, 150, 150}}, {"walls", {40, 40, 40}}, {"marks", {0, 0, 0}}};
  }

  // From the top left of the sheet, y downwards.
  void box(double x0, double y0, double x1, double y1, Colour colour) {
    const auto first = static_cast<std::uint32_t>(drawing_.points.size());
    for (const auto& [x, y] : {std::pair{x0, y0}, std::pair{x1, y0}, std::pair{x1, y1}, std::pair{x0, y1}})
      drawing_.points.push_back({static_cast<float>(x), static_cast<float>(drawing_.height - y)});
    drawing_.facets.push_back({first, 4, colour});
  }
  void line(Layer layer, double x0, double y0, double x1, double y1) {
    picture::append_line(drawing_, layer, x0, drawing_.height - y0, x1, drawing_.height - y1);
  }
  void frame(Layer layer, double x0, double y0, double x1, double y1) {
    line(layer, x0, y0, x1, y0);
    line(layer, x1, y0, x1, y1);
    line(layer, x1, y1, x0, y1);
    line(layer, x0, y1, x0, y0);
  }
  // On its baseline; shrunk to fit `room`.
  void text(double x, double y, const std::string& words, double height = text_height, double room = 1e9) {
    const double width = picture::text_width(height, words);
    picture::append_text(drawing_, ink, x, drawing_.height - y, width > room ? height * room / width : height,
                         words);
  }
  [[nodiscard]] picture::Image image() const {
    picture::ImageSize size;
    size.width = static_cast<int>(std::lround(drawing_.width));
    size.height = static_cast<int>(std::lround(drawing_.height));
    size.unit = 1;
    size.pen = 1.3;
    return picture::image_of(drawing_, size);
  }

 private:
  VectorDrawing drawing_;
};

// The plan of the scene on the sheet.
class Plan {
 public:
  Plan(const scene::CellScene& scene, const std::optional<AtlasLattice>& lattice)
      : scene_(&scene), lattice_(lattice) {
    const auto across = static_cast<double>(scene.outer.span(0).length());
    const auto along = static_cast<double>(scene.outer.span(2).length());
    const double scale = std::min(most_across / across, most_along / along);
    width_ = std::max(across * scale, least_side);
    height_ = std::max(along * scale, least_side);
    scale_x_ = width_ / across;
    scale_z_ = height_ / along;
  }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  // large_marks: of wrong views.
  void draw(Sheet& sheet, double left, double top, const std::vector<AtlasView>& views, bool large_marks,
            const std::function<Colour(const AtlasView&)>& colour) const {
    const auto x = [&](double at) { return left + (at - scene_->outer.low[0]) * scale_x_; };
    const auto y = [&](double at) { return top + (scene_->outer.high[2] - at) * scale_z_; };
    const auto fill_solids = [&](Colour shade) {
      for (const geometry::Box& solid : scene_->solids)
        if (at_height(solid.span(1)))
          sheet.box(x(solid.low[0]), y(solid.high[2]), x(solid.high[0]), y(solid.low[2]), shade);
    };
    sheet.box(left, top, left + width_, top + height_, lattice_ ? grey : paper);
    if (!lattice_) fill_solids({235, 235, 235});
    // Wrong views last, so that no other view covers them.
    for (const bool wrong : {false, true}) {
      if (wrong && lattice_) fill_solids(grey);
      for (const AtlasView& view : views) {
        if (view.is_wrong() != wrong || !view.free) continue;
        // Eyes are at integers: one more unit leaves no gap between their places.
        double half_x = lattice_ ? (width_ / lattice_->columns + scale_x_) / 2 : 2.2;
        double half_y = lattice_ ? (height_ / lattice_->rows + scale_z_) / 2 : 2.2;
        if (wrong && large_marks) {
          half_x = std::max(half_x, lattice_ ? mark : 1.8 * mark);
          half_y = std::max(half_y, lattice_ ? mark : 1.8 * mark);
        }
        sheet.box(x(view.eye[0]) - half_x, y(view.eye[2]) - half_y, x(view.eye[0]) + half_x,
                  y(view.eye[2]) + half_y, colour(view));
      }
    }
    for (const geometry::Box& solid : scene_->solids)
      sheet.frame(at_height(solid.span(1)) ? wall : faint, x(solid.low[0]), y(solid.high[2]),
                  x(solid.high[0]), y(solid.low[2]));
    for (const geometry::Rectangle& rectangle : scene_->walls) {
      if (rectangle.axis == 1) continue;
      const geometry::Box box = rectangle.bounds();
      sheet.line(at_height(box.span(1)) ? wall : faint, x(box.low[0]), y(box.low[2]), x(box.high[0]),
                 y(box.high[2]));
    }
    sheet.frame(wall, left, top, left + width_, top + height_);
    const auto corner = [](char axis, std::int32_t at) { return fmt::format("{} = {}", axis, at); };
    std::string across = fmt::format("x = {} to {}", scene_->outer.low[0], scene_->outer.high[0]);
    if (std::abs(scale_x_ / scale_z_ - 1) > 0.01)
      across += fmt::format(", {} stretched {:.1f} times", scale_x_ > scale_z_ ? "x" : "z",
                            std::max(scale_x_ / scale_z_, scale_z_ / scale_x_));
    sheet.text(left, top + height_ + small_text + 6, across, small_text);
    sheet.text(left + width_ + 4, top + small_text, corner('z', scene_->outer.high[2]), small_text, gap - 8);
    sheet.text(left + width_ + 4, top + height_, corner('z', scene_->outer.low[2]), small_text, gap - 8);
  }

  // The number of each cluster at its worst eye.
  void draw_numbers(Sheet& sheet, double left, double top, const std::vector<AtlasView>& views,
                    const std::vector<AtlasCluster>& clusters) const {
    for (std::size_t n = 0; n < std::min(clusters.size(), most_listed); ++n) {
      const geometry::Point& eye = views[clusters[n].worst].eye;
      const double x = left + (eye[0] - scene_->outer.low[0]) * scale_x_;
      const double y = top + (scene_->outer.high[2] - eye[2]) * scale_z_;
      const std::string number = std::to_string(n + 1);
      const bool at_right = x + 26 < left + width_;
      sheet.text(at_right ? x + 9 : x - 9 - picture::text_width(text_height, number), y + text_height / 2,
                 number);
    }
  }

 private:
  // Whether the plane of the eyes cuts the span. If the eyes have no common plane: whether it has a height.
  [[nodiscard]] bool at_height(geometry::Span span) const {
    return !lattice_ || span.contains(lattice_->height);
  }

  const scene::CellScene* scene_;
  std::optional<AtlasLattice> lattice_;
  double scale_x_ = 1;  // pixels per unit
  double scale_z_ = 1;
  double width_ = 0;
  double height_ = 0;
};

double legend_row(Sheet& sheet, double x, double y, Colour colour, const std::string& text) {
  sheet.box(x, y - text_height - 1, x + 20, y + 3, colour);
  sheet.frame(faint, x, y - text_height - 1, x + 20, y + 3);
  sheet.text(x + 30, y, text);
  return y + line_height;
}

void wrong_legend(Sheet& sheet, double x, double y, const std::vector<AtlasView>& views,
                  const AtlasSummary& summary) {
  y = legend_row(sheet, x, y, right, fmt::format("right within a point: {}", summary.free - summary.wrong));
  for (const WrongClass& each : wrong_classes) {
    const auto count = std::count_if(views.begin(), views.end(), [&](const AtlasView& view) {
      return view.is_wrong() && colour_of(view) == each.colour && &class_of(view.wrong.length()) == &each;
    });
    y = legend_row(sheet, x, y, each.colour, fmt::format("{}: {}", each.label, count));
  }
  const auto ended = std::count_if(views.begin(), views.end(), [](const AtlasView& view) {
    return view.is_wrong() && view.cause->status != programs::jones::Status::complete;
  });
  y = legend_row(sheet, x, y, stopped, fmt::format("the program stopped: {}", ended));
  y = legend_row(sheet, x, y, grey,
                 fmt::format("no eye: in a solid, or at a wall: {}", views.size() - summary.free));
  if (!summary.clusters.empty()) sheet.text(x, y, "1, 2, ...: the worst view of each cluster below");
}

// 1, 2 or 5 times a power of ten, such that `whole` has four to ten steps.
double tick_of(double whole) {
  double tick = 1;
  while (tick * 5 > whole) tick /= 10;
  while (tick * 50 <= whole) tick *= 10;
  for (const double more : {5.0, 2.0})
    if (tick * more * 4 <= whole) return tick * more;
  return tick;
}

void time_legend(Sheet& sheet, double x, double y, double width, const AtlasSummary& summary) {
  const double greatest = summary.time.greatest > 0 ? summary.time.greatest : 1;
  constexpr int steps = 64;
  for (int i = 0; i < steps; ++i)
    sheet.box(x + width * i / steps, y - text_height, x + width * (i + 1) / steps, y + 6,
              picture::height_colour((i + 0.5) / steps));
  const double tick = tick_of(greatest);
  for (int i = 0; i * tick <= greatest * 1.001; ++i) {
    const double at = x + width * std::min(1.0, i * tick / greatest);
    const std::string label = fmt::format("{:.3g}", i * tick);
    sheet.line(ink, at, y + 6, at, y + 12);
    sheet.text(std::min(at - (i == 0 ? 0 : picture::text_width(text_height, label) / 2),
                        x + width - picture::text_width(text_height, label)),
               y + 18 + text_height, label);
  }
  sheet.text(x, y + 18 + text_height + line_height * 1.2,
             fmt::format("seconds of the PDP-7: median {:.3f}, greatest {:.3f}", summary.time.median,
                         summary.time.greatest),
             text_height, width);
}

// Explains the causes that occur.
std::vector<std::string> notes_on(const std::vector<AtlasCluster>& clusters) {
  const auto any = [&clusters](std::string_view begin) {
    return std::any_of(clusters.begin(), clusters.end(),
                       [&](const AtlasCluster& cluster) { return cluster.cause.starts_with(begin); });
  };
  std::vector<std::string> notes;
  if (any("mask corner"))
    notes.push_back(
        "mask corner: rounding turned the short side between two near corners of a mask, and it cuts off "
        "lines far from it");
  if (any("rounding"))
    notes.push_back(
        "rounding: the line runs along a side of a mask; rounded, it falls on the wrong side: cut off, or drawn "
        "though hidden");
  if (any("not a rounding")) notes.push_back("not a rounding: still wrong with 8 fraction bits");
  if (any("fraction bits"))
    notes.push_back("fraction bits: the view is right with the 3 fraction bits that the program can have");
  return notes;
}

std::string text_of(const geometry::Point& eye) {
  return fmt::format("{},{},{}", eye[0], eye[1], eye[2]);
}

}  // namespace

std::string text_of(const AxisLine& line) {
  static constexpr std::array<char, 3> names{'x', 'y', 'z'};
  const auto [u, v] = geometry::other_axes(line.axis);
  return fmt::format("parallel to {} at {} = {}, {} = {}", names[line.axis], names[u], line.cross[0],
                     names[v], line.cross[1]);
}

picture::Image atlas_picture(const scene::CellScene& scene, const std::vector<AtlasView>& views,
                             const AtlasSummary& summary, const std::optional<AtlasLattice>& lattice,
                             const AtlasCaption& caption) {
  const Plan plan(scene, lattice);
  const double panel = std::max(plan.width(), least_across);
  const double top = border + 5 * line_height;
  const double legend = top + plan.height() + 2.6 * line_height;
  const double list = legend + 9 * line_height;
  const std::size_t rows =
      std::min(summary.clusters.size(), most_listed) + (summary.clusters.size() > most_listed ? 1 : 0);
  const std::vector<std::string> notes = notes_on(summary.clusters);
  const double width = border + 2 * (panel + gap);
  Sheet sheet(width, list + (rows == 0 ? 0 : static_cast<double>(rows + notes.size() + 2)) * line_height +
                         border / 2);

  const double room = width - 2 * border;
  sheet.text(border, border + text_height, caption.title, 17, room);
  sheet.text(border, border + text_height + line_height * 1.1, caption.eyes, text_height, room);
  sheet.text(border, border + text_height + line_height * 2,
             "Wrong: missing or extra, and farther than one point of the screen from the truth.", text_height,
             room);
  const double left = border;
  const double second = border + panel + gap;
  sheet.text(
      left, top - 10,
      fmt::format("Wrong length by position of the eye: {} of {} views wrong", summary.wrong, summary.free),
      text_height, panel);
  sheet.text(second, top - 10, "Emulated time of the view by position of the eye", text_height, panel);
  plan.draw(sheet, left, top, views, true, colour_of);
  plan.draw_numbers(sheet, left, top, views, summary.clusters);
  const double greatest = summary.time.greatest > 0 ? summary.time.greatest : 1;
  plan.draw(sheet, second, top, views, false, [&](const AtlasView& view) {
    return picture::height_colour(static_cast<double>(view.emulated_ns) / 1e9 / greatest);
  });
  wrong_legend(sheet, left, legend, views, summary);
  time_legend(sheet, second, legend, panel, summary);

  if (rows == 0) return sheet.image();
  const std::array<double, 6> columns{border,       border + 44,  border + 112,
                                      border + 240, border + 530, border + 880};
  const auto row = [&](double y, const std::array<std::string, 6>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      sheet.text(columns[i], y, cells[i], text_height,
                 (i + 1 < cells.size() ? columns[i + 1] - 14 : width - border / 2) - columns[i]);
  };
  row(list, {"no", "views", "points wrong", "cause", "line of the scene", "worst eye x,y,z"});
  for (std::size_t n = 0; n < std::min(summary.clusters.size(), most_listed); ++n) {
    const AtlasCluster& cluster = summary.clusters[n];
    row(list + static_cast<double>(n + 1) * line_height,
        {std::to_string(n + 1), std::to_string(cluster.views.size()),
         fmt::format("{:.1f}", cluster.most_wrong), cluster.cause,
         cluster.line ? text_of(*cluster.line) : std::string("-"), text_of(views[cluster.worst].eye)});
  }
  if (summary.clusters.size() > most_listed)
    sheet.text(
        border, list + static_cast<double>(rows) * line_height,
        fmt::format("and {} more clusters, which --json lists", summary.clusters.size() - most_listed));
  for (std::size_t i = 0; i < notes.size(); ++i)
    sheet.text(border, list + (static_cast<double>(rows + i) + 1.3) * line_height, notes[i], text_height,
               room);
  return sheet.image();
}

}  // namespace sightline::compare
