#include "host/picture/plotter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/base/text.hpp"
#include "host/picture/pen_path.hpp"
#include "host/picture/step_file.hpp"

namespace sightline::picture {
namespace {

constexpr double units_a_millimetre = 1000.0 / static_cast<double>(hpgl_unit_micrometres);

// A4 and A3 for a metric machine, ANSI A and B for the other.
constexpr std::array<PlotterPaperLimits, 4> desktop_papers{
    PlotterPaperLimits{"A4", 297, 210, 11040, 7721}, PlotterPaperLimits{"A3", 420, 297, 16158, 11040},
    PlotterPaperLimits{"Letter", 279.4, 215.9, 10365, 7962}, PlotterPaperLimits{"Tabloid", 431.8, 279.4, 16640, 10365}};
constexpr std::array plotter_rows{
    Plotter{"hp7475a",
            "Hewlett-Packard 7475A, six pens, A4 to A3",
            6,
            {381, 508, 19'600, 0.1, 5},
            desktop_papers,
            0,
            0},
    Plotter{"hp7550a",
            "Hewlett-Packard 7550A, eight pens, A4 to A3",
            8,
            {800, 800, 58'800, 0.03, 3},
            desktop_papers,
            0,
            0},
    // 300 steps per second, without acceleration.
    Plotter{"calcomp",
            "CalComp 565, one pen, a drum of 11 inches",
            1,
            {76.2, 76.2, 1e9, 0.1, 0},
            {PlotterPaperLimits{"279.4x279.4", 1100 * calcomp_step, 1100 * calcomp_step, 0, 0}},
            1100 * calcomp_step,
            65'535 * calcomp_step},
};

const PlotterPaperLimits* limits_for(const Plotter& plotter, const Paper& paper) {
  const double longer = std::max(paper.width, paper.height);
  const double shorter = std::min(paper.width, paper.height);
  for (const PlotterPaperLimits& row : plotter.papers)
    if (std::abs(row.width - longer) < 1 && std::abs(row.height - shorter) < 1) return &row;
  return nullptr;
}

// Converts from the drawing to plotter units. The x axis of a named plotter is along the longer side of its paper.
class OnPlotter {
 public:
  OnPlotter(const VectorDrawing& drawing, const Paper& paper, const Plotter* plotter)
      : across_((paper.width - 2 * paper.margin) / drawing.width),
        up_((paper.height - 2 * paper.margin) / drawing.height),
        margin_(paper.margin),
        height_(paper.height) {
    if (plotter == nullptr) return;
    upright_ = paper.height > paper.width;
    const PlotterPaperLimits* limits = limits_for(*plotter, paper);
    if (limits == nullptr) return;
    shift_ = {(limits->x / units_a_millimetre - std::max(paper.width, paper.height)) / 2,
              (limits->y / units_a_millimetre - std::min(paper.width, paper.height)) / 2};
  }

  [[nodiscard]] std::array<std::int64_t, 2> at(DrawingPoint point) const {
    const double x = margin_ + double{point.x} * across_;
    const double y = margin_ + double{point.y} * up_;
    // Upright paper lies on its side, with its top to the left.
    return upright_ ? std::array{units(height_ - y + shift_[0]), units(x + shift_[1])}
                    : std::array{units(x + shift_[0]), units(y + shift_[1])};
  }

 private:
  [[nodiscard]] static std::int64_t units(double millimetres) {
    return static_cast<std::int64_t>(std::floor(millimetres * units_a_millimetre + 0.5));
  }

  double across_;
  double up_;
  double margin_;
  double height_;
  bool upright_ = false;
  std::array<double, 2> shift_{};
};

}  // namespace

std::span<const Plotter> plotters() {
  return plotter_rows;
}

const Plotter* find_plotter(std::string_view name) {
  const auto found = std::find_if(plotter_rows.begin(), plotter_rows.end(),
                                  [name](const Plotter& row) { return row.name == name; });
  return found == plotter_rows.end() ? nullptr : &*found;
}

base::Result<std::array<double, 2>> plotting_area(const Plotter& plotter, const Paper& paper) {
  if (plotter.carriage > 0) {
    if (paper.width > plotter.length)
      return base::Error{.file = "--size",
                         .found = fmt::format("found a width of {:g} mm", paper.width),
                         .expected = fmt::format("at most {:g} for {}", plotter.length, plotter.name)};
    return std::array{paper.width, std::min(paper.height, plotter.carriage)};
  }
  const PlotterPaperLimits* limits = limits_for(plotter, paper);
  if (limits == nullptr) {
    std::string names;
    for (const PlotterPaperLimits& row : plotter.papers) names += (names.empty() ? "" : ", ") + std::string(row.paper);
    return base::Error{.file = "--size",
                       .found = fmt::format("found {:g}x{:g} mm", paper.width, paper.height),
                       .expected = names + " for " + std::string(plotter.name)};
  }
  std::array<double, 2> area{std::min(limits->x / units_a_millimetre, std::max(paper.width, paper.height)),
                             std::min(limits->y / units_a_millimetre, std::min(paper.width, paper.height))};
  if (paper.height > paper.width) std::swap(area[0], area[1]);
  return area;
}

base::Result<double> least_margin(const Plotter& plotter, const Paper& paper) {
  const auto area = plotting_area(plotter, paper);
  if (!area) return area.error();
  return std::max((paper.width - (*area)[0]) / 2, (paper.height - (*area)[1]) / 2);
}

std::size_t pen_count(const HpglOptions& options) {
  if (!options.pens.empty()) return options.pens.size();
  return static_cast<std::size_t>(options.plotter != nullptr ? options.plotter->pens : most_hpgl_pens);
}

int pen_of_layer(std::size_t layer, const HpglOptions& options) {
  const std::size_t pen = std::min(layer, pen_count(options) - 1);
  return options.pens.empty() ? static_cast<int>(pen) + 1 : options.pens[pen];
}

std::optional<double> reachable_speed(const HpglOptions& options) {
  if (!options.speed || options.plotter == nullptr) return options.speed;
  return std::min(*options.speed, options.plotter->speeds.down / 10);
}

std::string hpgl_of(const VectorDrawing& drawing, const Paper& paper, const HpglOptions& options) {
  const OnPlotter place(drawing, paper, options.plotter);
  std::string text = "IN;\n";
  if (options.speed) base::append(text, "VS{:g};\n", *options.speed);
  int held = 0;
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      const auto first = place.at(drawing.points[line.first]);
      const auto differs = [&](const DrawingPoint& p) { return place.at(p) != first; };
      const auto points = drawing.points.begin() + static_cast<std::ptrdiff_t>(line.first);
      // A line shorter than a unit is skipped; a dot is drawn.
      if (line.count > 1 && std::none_of(points, points + static_cast<std::ptrdiff_t>(line.count), differs)) continue;
      const int pen = pen_of_layer(layer, options);
      if (pen != held) base::append(text, "SP{};\n", pen);
      held = pen;
      auto before = first;
      base::append(text, "{}{},{};\nPD", options.relative ? "PU;PA" : "PU", before[0], before[1]);
      std::size_t written = 0;
      for (std::uint32_t i = 1; i < line.count; ++i) {
        const auto at = place.at(drawing.points[line.first + i]);
        if (at == before) continue;
        if (written == 0) {
          text += options.relative ? ";PR" : "";
        } else {
          text += written % hpgl_most_corners == 0 ? options.relative ? ";\nPR" : ";\nPD" : ",";
        }
        ++written;
        if (options.relative) {
          base::append(text, "{},{}", at[0] - before[0], at[1] - before[1]);
        } else {
          base::append(text, "{},{}", at[0], at[1]);
        }
        before = at;
      }
      text += ";\n";
    }
  }
  text += options.relative ? "PU;PA;\nSP0;\n" : "PU;\nSP0;\n";
  return text;
}

}  // namespace sightline::picture
