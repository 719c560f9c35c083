#include "host/algorithms/skala/contour_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/picture/lettering.hpp"

namespace sightline::algorithms::skala {
namespace {

using picture::DrawingLine;
using picture::DrawingPoint;
using picture::VectorDrawing;

// Records on a lattice which line is where. A place with several lines belongs to none of them.
class Occupied {
 public:
  explicit Occupied(const VectorDrawing& drawing) {
    constexpr double finest = 0.25;  // mm
    constexpr double most = 2000;    // places per side
    step_ = std::max({finest, drawing.width / most, drawing.height / most});
    columns_ = static_cast<std::size_t>(drawing.width / step_) + 2;
    rows_ = static_cast<std::size_t>(drawing.height / step_) + 2;
    places_.assign(columns_ * rows_, nobody);
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      const DrawingLine& line = drawing.lines[i];
      for (std::uint32_t k = 0; k + 1 < line.count; ++k)
        along(drawing.points[line.first + k], drawing.points[line.first + k + 1], [&](std::uint32_t& place) { mark(place, static_cast<std::uint32_t>(i)); });
    }
  }

  // Whether the rectangle around `middle` contains no line except `own`. Half of its sides are given, the first along
  // `direction`.
  [[nodiscard]] bool is_free(DrawingPoint middle, picture::TextDirection direction, double half_width, double half_height, std::uint32_t own) const {
    const double step = step_ * 0.7;
    for (double u = -half_width; u <= half_width; u += step)
      for (double v = -half_height; v <= half_height; v += step) {
        const double x = middle.x + u * direction.x - v * direction.y;
        const double y = middle.y + u * direction.y + v * direction.x;
        if (!(x >= 0 && y >= 0 && x < static_cast<double>(columns_) * step_ && y < static_cast<double>(rows_) * step_)) return false;
        const std::uint32_t there = places_[index(x, y)];
        if (there != nobody && there != own) return false;
      }
    return true;
  }

  void block(DrawingPoint middle, picture::TextDirection direction, double half_width, double half_height) {
    const double step = step_ * 0.7;
    for (double u = -half_width; u <= half_width; u += step)
      for (double v = -half_height; v <= half_height; v += step) {
        const double x = middle.x + u * direction.x - v * direction.y;
        const double y = middle.y + u * direction.y + v * direction.x;
        if (x >= 0 && y >= 0 && x < static_cast<double>(columns_) * step_ && y < static_cast<double>(rows_) * step_) places_[index(x, y)] = several;
      }
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffff;
  static constexpr std::uint32_t several = 0xfffffffe;

  static void mark(std::uint32_t& place, std::uint32_t line) { place = place == nobody || place == line ? line : several; }
  [[nodiscard]] std::size_t index(double x, double y) const {
    return static_cast<std::size_t>(y / step_) * columns_ + static_cast<std::size_t>(x / step_);
  }
  template <class Visit>
  void along(DrawingPoint a, DrawingPoint b, const Visit& visit) {
    const double dx = double{b.x} - double{a.x};
    const double dy = double{b.y} - double{a.y};
    const int steps = static_cast<int>(std::sqrt(dx * dx + dy * dy) / (step_ * 0.5)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double x = a.x + t * dx;
      const double y = a.y + t * dy;
      if (x >= 0 && y >= 0 && x < static_cast<double>(columns_) * step_ && y < static_cast<double>(rows_) * step_) visit(places_[index(x, y)]);
    }
  }

  double step_ = 1;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> places_;
};

// A line parametrized by its length.
class Measured {
 public:
  Measured(const VectorDrawing& drawing, const DrawingLine& line)
      : points_(drawing.points.data() + line.first, drawing.points.data() + line.first + line.count), lengths_(1, 0.0) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double dx = double{points_[i].x} - double{points_[i - 1].x};
      const double dy = double{points_[i].y} - double{points_[i - 1].y};
      lengths_.push_back(lengths_.back() + std::sqrt(dx * dx + dy * dy));
    }
  }
  [[nodiscard]] double length() const { return lengths_.back(); }
  [[nodiscard]] DrawingPoint at(double s) const {
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), s);
    if (after == lengths_.end()) return points_.back();
    const auto i = static_cast<std::size_t>(after - lengths_.begin());
    if (i == 0) return points_.front();
    const double t = (s - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
    return {static_cast<float>(points_[i - 1].x + t * (double{points_[i].x} - double{points_[i - 1].x})),
            static_cast<float>(points_[i - 1].y + t * (double{points_[i].y} - double{points_[i - 1].y}))};
  }
  // Adds the part of the line from one length to another as a separate line.
  void add_part(VectorDrawing& drawing, std::uint32_t layer, double from, double to) const {
    const auto first = static_cast<std::uint32_t>(drawing.points.size());
    drawing.points.push_back(at(from));
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (lengths_[i] > from && lengths_[i] < to) drawing.points.push_back(points_[i]);
    drawing.points.push_back(at(to));
    drawing.lines.push_back({layer, first, static_cast<std::uint32_t>(drawing.points.size()) - first});
  }

 private:
  std::vector<DrawingPoint> points_;
  std::vector<double> lengths_;
};

struct LabelPlace {
  double at = 0;  // length along the line to the middle of the label
  DrawingPoint middle;
  picture::TextDirection direction;
};

class Labeller {
 public:
  Labeller(VectorDrawing& drawing, std::uint32_t label_layer, double height)
      : drawing_(drawing), occupied_(drawing), layer_(label_layer), height_(height) {}

  // Returns true if the line is labelled now.
  bool label(std::uint32_t number, const std::string& text) {
    const DrawingLine line = drawing_.lines[number];
    if (line.count < 2) return false;
    const Measured measured(drawing_, line);
    const double width = picture::text_width(height_, text) + height_;  // with a gap of half a capital on both sides
    if (measured.length() < 2.5 * width) return false;
    const int wanted = 1 + static_cast<int>(measured.length() / (60 * height_));
    std::vector<LabelPlace> places;
    for (int i = 0; i < wanted; ++i) {
      const double part = measured.length() / wanted;
      if (const auto found = best_place(measured, number, width, part * i, part * (i + 1)); found.at > 0) {
        places.push_back(found);
        occupied_.block(found.middle, found.direction, width / 2, height_);
      }
    }
    if (places.empty()) return false;
    double from = 0;
    for (const LabelPlace& place : places) {
      measured.add_part(drawing_, line.layer, from, place.at - width / 2);
      from = place.at + width / 2;
      write(place, width - height_, text);
    }
    measured.add_part(drawing_, line.layer, from, measured.length());
    drawing_.lines[number].count = 0;
    return true;
  }

 private:
  // The straightest free place; `at` is 0 if there is none.
  [[nodiscard]] LabelPlace best_place(const Measured& line, std::uint32_t number, double width, double from, double to) const {
    LabelPlace best;
    double best_chord = 0.94 * width;
    const double step = std::max(width / 4, (to - from) / 200);
    for (double at = from + 0.75 * width; at <= to - 0.75 * width; at += step) {
      const DrawingPoint a = line.at(at - width / 2);
      const DrawingPoint b = line.at(at + width / 2);
      const double dx = double{b.x} - double{a.x};
      const double dy = double{b.y} - double{a.y};
      const double chord = std::sqrt(dx * dx + dy * dy);
      if (!(chord > best_chord)) continue;
      const double sign = dx < 0 || (dx == 0 && dy < 0) ? -1 : 1;
      const picture::TextDirection direction{sign * dx / chord, sign * dy / chord};
      const DrawingPoint on_line = line.at(at);
      const DrawingPoint middle{(a.x + b.x + 2 * on_line.x) / 4, (a.y + b.y + 2 * on_line.y) / 4};
      if (!occupied_.is_free(middle, direction, width / 2, 0.6 * height_, number)) continue;
      best_chord = chord;
      best = {at, middle, direction};
    }
    return best;
  }

  void write(const LabelPlace& place, double width, const std::string& text) {
    const double x = place.middle.x - width / 2 * place.direction.x + height_ / 2 * place.direction.y;
    const double y = place.middle.y - width / 2 * place.direction.y - height_ / 2 * place.direction.x;
    picture::append_text(drawing_, layer_, x, y, height_, text, place.direction);
  }

  VectorDrawing& drawing_;
  Occupied occupied_;
  std::uint32_t layer_;
  double height_;
};

}  // namespace

void add_contour_labels(VectorDrawing& drawing, std::span<const LabelledLayer> layers, std::uint32_t label_layer, double text_height) {
  Labeller labeller(drawing, label_layer, text_height);
  std::vector<std::vector<std::pair<double, std::uint32_t>>> lines(layers.size());  // by layer: its lines, by length
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const LabelledLayer& each) { return each.layer == drawing.lines[i].layer; });
    if (found != layers.end() && drawing.lines[i].count > 1)
      lines[static_cast<std::size_t>(found - layers.begin())].push_back({Measured(drawing, drawing.lines[i]).length(), static_cast<std::uint32_t>(i)});
  }
  for (std::size_t k = 0; k < layers.size(); ++k) {
    std::sort(lines[k].begin(), lines[k].end(), [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
    bool has_one = false;
    for (const auto& [length, line] : lines[k])
      if (!has_one || length > 12 * text_height) has_one = labeller.label(line, layers[k].text) || has_one;
  }
  // Removes the lines that were cut: their pieces were appended.
  std::erase_if(drawing.lines, [](const DrawingLine& line) { return line.count == 0; });
}

}  // namespace sightline::algorithms::skala
