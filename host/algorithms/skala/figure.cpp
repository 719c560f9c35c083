#include "host/algorithms/skala/figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "host/algorithms/skala/contour_labels.hpp"
#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/algorithms/skala/figure_box.hpp"
#include "host/algorithms/skala/floor_contours.hpp"
#include "host/algorithms/skala/walk.hpp"
#include "host/picture/height_colours.hpp"
#include "host/picture/lettering.hpp"
#include "host/scene/heights/round_values.hpp"

namespace sightline::algorithms::skala {
namespace {

using picture::DrawingPoint;
using picture::VectorDrawing;

constexpr picture::Colour ink{0, 0, 0};
constexpr picture::Colour box_ink{96, 96, 96};
constexpr std::uint32_t legend_steps = 64;

struct Rectangle {
  double left = 0;
  double bottom = 0;
  double right = 0;
  double top = 0;

  void take(const Rectangle& other) {
    left = std::min(left, other.left);
    bottom = std::min(bottom, other.bottom);
    right = std::max(right, other.right);
    top = std::max(top, other.top);
  }
  [[nodiscard]] bool meets(const Rectangle& other, double clearance) const {
    return left < other.right + clearance && other.left < right + clearance && bottom < other.top + clearance && other.bottom < top + clearance;
  }
};

// Text that begins on the baseline.
struct Label {
  std::string text;
  DrawingPoint at;
  picture::TextDirection direction;
};

struct Tick {
  DrawingPoint from;
  DrawingPoint to;
};

// Ticks and labels of all axes for one placement of the box on the page.
struct Annotations {
  std::vector<Tick> ticks;
  std::vector<Label> labels;
  std::vector<Rectangle> taken;
};

// Converts units of the box to millimetres of the page.
struct PagePlace {
  std::array<double, 2> scale{1, 1};
  std::array<double, 2> shift{};

  [[nodiscard]] DrawingPoint at(const std::array<double, 2>& point) const {
    return {static_cast<float>(point[0] * scale[0] + shift[0]), static_cast<float>(point[1] * scale[1] + shift[1])};
  }
};

// Before anything is placed: what the page shows of the surface.
class FigureMaker {
 public:
  FigureMaker(std::span<const scene::HeightGrid> grids, const View& view, const FigureOptions& options)
      : grids_(grids), grid_(grids.front()), view_(view), options_(options), text_(options.text) {
    view_.family = resolved_family(view_);
    rows_ = view_.subject == Subject::lines ? view_.family : Family::along_x;
  }

  Figure make() {
    Figure result;
    result.sides = view_.sides;
    VectorDrawing& drawing = result.drawing;
    drawing = draw(grids_, view_);
    const Surface surface(grid_, view_, rows_, grids_);
    surface_ = &surface;
    measure_box();
    const int columns = std::clamp(view_.columns, fewest_columns, most_columns);
    // A surface without extent covers no columns and hides nothing.
    const bool hides = view_.visibility && surface.extents()[0] > 0 && surface.extents()[1] > 0;
    std::optional<Coverage> coverage;
    if (hides && (options_.axes || options_.floor)) {
      coverage.emplace(columns);
      const bool triangles = view_.subject != Subject::lines || view_.silhouette;
      for (const scene::HeightGrid& grid : grids_) coverage->add(Surface(grid, view_, rows_, grids_), triangles);
    }
    std::vector<LabelledLayer> labelled;
    const auto levels = level_layers(drawing, labelled);
    if (options_.floor) add_floor(drawing, labelled, levels, coverage ? &*coverage : nullptr, columns);
    const PagePlace place = page_place();
    to_page(drawing, place);
    drawing.width = options_.width;
    drawing.height = options_.height;
    result.scale = place.scale;
    const auto box_layer = static_cast<std::uint32_t>(drawing.layers.size());
    const std::uint32_t text_layer = box_layer + 1;
    if (options_.axes || options_.legend || options_.contour_labels || !options_.title.empty()) {
      drawing.layers.push_back({"axes", box_ink});
      drawing.layers.push_back({"text", ink});
    }
    if (options_.contour_labels) add_contour_labels(drawing, labelled, text_layer, 0.8 * text_);
    if (options_.axes) add_axes(drawing, place, box_layer, text_layer, coverage ? &*coverage : nullptr);
    if (!options_.title.empty()) add_title(drawing, text_layer);
    if (options_.legend) add_legend(drawing, box_layer, text_layer);
    return result;
  }

 private:
  // The box contains all heights, also those outside the range that is mapped to -1..1.
  void measure_box() {
    for (const scene::HeightGrid& grid : grids_) {
      const scene::Interval all = scene::finite_range(grid.heights);
      box_.low = std::min(box_.low, surface_->normalised_height(all.low));
      box_.high = std::max(box_.high, surface_->normalised_height(all.high));
    }
    heights_ = box_;
    if (options_.floor) box_.low -= (box_.high - box_.low) / 2;
  }
  [[nodiscard]] double height_of(double normalised) const {
    return (grid_.range.low / 2 + grid_.range.high / 2) + normalised * (grid_.range.high / 2 - grid_.range.low / 2);
  }
  [[nodiscard]] double part_of(double height) const {
    const double extent = grid_.range.high / 2 - grid_.range.low / 2;
    return extent > 0 ? (height / 2 - grid_.range.low / 2) / extent : 0;
  }

  // --- contours

  [[nodiscard]] std::vector<double> level_layers(VectorDrawing& drawing, std::vector<LabelledLayer>& labelled) const {
    std::vector<double> levels = view_.level_heights.empty() ? even_levels() : view_.level_heights;
    if (view_.subject != Subject::contours) return levels;
    for (std::size_t i = 0; i < grids_.size() * levels.size(); ++i) {
      const std::size_t k = i % levels.size();
      const auto layer = static_cast<std::uint32_t>(i / levels.size() * (first_contour + levels.size()) + first_contour + k);
      labelled.push_back({layer, level_text(levels[k])});
      if (view_.colouring == Colouring::heights) drawing.layers[layer].colour = picture::height_line_colour(part_of(levels[k]));
    }
    return levels;
  }
  [[nodiscard]] std::vector<double> even_levels() const {
    std::vector<double> levels;
    if (!(grid_.range.high > grid_.range.low)) return levels;
    const int count = std::clamp(view_.levels, 0, 255);
    for (int k = 1; k <= count; ++k) levels.push_back(height_of(2.0 * k / (count + 1) - 1));
    return levels;
  }
  // Four significant digits distinguish levels.
  [[nodiscard]] static std::string level_text(double level) {
    if (level == 0) return "0";
    const double power = std::pow(10, 3 - std::floor(std::log10(std::abs(level))));
    const double rounded = std::floor(std::abs(level) * power + 0.5) / power;
    if (!std::isfinite(rounded)) return scene::shortest_text(level);
    if (rounded == std::floor(rounded) && rounded < 1e7) return std::to_string(static_cast<std::int64_t>(level < 0 ? -rounded : rounded));
    return scene::shortest_text(level < 0 ? -rounded : rounded);
  }

  void add_floor(VectorDrawing& drawing, std::vector<LabelledLayer>& labelled, const std::vector<double>& levels, const Coverage* coverage, int columns) const {
    if (!(surface_->extents()[0] > 0) || !(surface_->extents()[1] > 0)) return;
    // From below, nothing is before the floor.
    const bool from_below = surface_->to_eye()[2] < 0;
    for (std::size_t i = 0; i < grids_.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(drawing.layers.size());
      const std::string of = i == 0 ? "" : ", surface " + std::to_string(i + 1);
      for (const double level : levels) {
        labelled.push_back({static_cast<std::uint32_t>(drawing.layers.size()), level_text(level)});
        // Overlapping maps have the colours of their surfaces.
        const picture::Colour colour = grids_.size() > 1 ? surface_colour(i) : picture::height_line_colour(part_of(level));
        drawing.layers.push_back({"floor " + level_text(level) + of, colour});
      }
      add_floor_contours(grids_[i], Surface(grids_[i], view_, rows_, grids_), {box_.low, levels, first},
                         from_below ? nullptr : coverage, columns, drawing);
    }
  }

  // --- placement on the page

  [[nodiscard]] Rectangle bounds() const {
    const auto [x, y] = surface_->origin();
    Rectangle all{x, y, x + surface_->extents()[0], y + surface_->extents()[1]};
    if (!options_.axes && !options_.floor) return all;
    for (const double cx : {-1.0, 1.0})
      for (const double cz : {-1.0, 1.0})
        for (const double h : {box_.low, box_.high}) {
          // Without axes only the floor of the box counts.
          if (!options_.axes && h == box_.high) continue;
          const auto p = surface_->project(cx, cz, h);
          all.take({p[0], p[1], p[0], p[1]});
        }
    return all;
  }

  [[nodiscard]] PagePlace fitted(const Rectangle& page) const {
    const Rectangle all = bounds();
    const std::array<double, 2> extent{all.right - all.left, all.top - all.bottom};
    const std::array<double, 2> room{std::max(page.right - page.left, 1.0), std::max(page.top - page.bottom, 1.0)};
    PagePlace place;
    constexpr double no_extent = 1e-12;
    std::array<bool, 2> has{extent[0] > no_extent, extent[1] > no_extent};
    for (std::size_t i = 0; i < 2; ++i) place.scale[i] = has[i] ? room[i] / extent[i] : 0;
    if (!options_.stretch || !has[0] || !has[1]) {
      const double least = has[0] && has[1] ? std::min(place.scale[0], place.scale[1]) : std::max(place.scale[0], place.scale[1]);
      place.scale = {least, least};
    }
    place.shift[0] = (page.left + page.right) / 2 - (all.left + all.right) / 2 * place.scale[0];
    place.shift[1] = (page.bottom + page.top) / 2 - (all.bottom + all.top) / 2 * place.scale[1];
    return place;
  }

  // The largest placement that leaves space for the labels. The labels decide the margins, and the margins decide where
  // labels are; hence the iteration.
  [[nodiscard]] PagePlace page_place() const {
    Rectangle page{0, 0, options_.width - legend_width(), options_.height - (options_.title.empty() ? 0 : 3 * text_)};
    if (!options_.axes) return fitted(page);
    // Labels keep a distance from the edge of the page.
    const double edge = std::min({0.5 * text_, options_.width / 8, options_.height / 8});
    page = {edge, edge, page.right - edge, page.top - edge};
    Rectangle inside = page;
    PagePlace place = fitted(inside);
    constexpr int rounds = 16;
    for (int i = 0; i < rounds; ++i) {
      const Rectangle box = bounds();
      const DrawingPoint low = place.at({box.left, box.bottom});
      const DrawingPoint high = place.at({box.right, box.top});
      Rectangle all{low.x, low.y, high.x, high.y};
      for (const Rectangle& taken : annotations(place).taken) all.take(taken);
      // Margins only grow: labels appear and vanish with the size, and otherwise the iteration would not converge.
      inside.left += std::max(page.left - all.left, 0.0);
      inside.bottom += std::max(page.bottom - all.bottom, 0.0);
      inside.right += std::min(page.right - all.right, 0.0);
      inside.top += std::min(page.top - all.top, 0.0);
      place = fitted(inside);
    }
    return place;
  }

  void to_page(VectorDrawing& drawing, const PagePlace& place) const {
    const auto origin = surface_->origin();
    const auto extents = surface_->extents();
    const bool across = extents[0] > 1e-12;
    const bool up = extents[1] > 1e-12;
    for (DrawingPoint& p : drawing.points)
      p = place.at({origin[0] + (across ? p.x / picture_extent * extents[0] : 0), origin[1] + (up ? p.y / picture_extent * extents[1] : 0)});
  }

  // --- axes

  struct AxisLook {
    scene::Interval values;
    std::array<double, 2> ends;  // the values at the ends of the edge, in units of the box
    std::string name;
  };
  [[nodiscard]] std::array<AxisLook, 3> axes() const {
    return {AxisLook{grid_.domain_x, {-1, 1}, options_.names[0]}, AxisLook{grid_.domain_z, {-1, 1}, options_.names[1]},
            AxisLook{{height_of(heights_.low), height_of(heights_.high)}, {heights_.low, heights_.high}, options_.names[2]}};
  }

  [[nodiscard]] DrawingPoint on_page(const PagePlace& place, const BoxPoint& point) const {
    return place.at(surface_->project(point[0], point[1], point[2]));
  }

  [[nodiscard]] Annotations annotations(const PagePlace& place) const {
    Annotations result;
    const auto edges = tick_edges(*surface_, box_);
    const auto looks = axes();
    for (std::size_t axis = 0; axis < 3; ++axis) add_axis(result, place, edges[axis], looks[axis], axis);
    return result;
  }

  // The direction of ticks from an edge on the page: that of the box, or perpendicular to the edge if the box's would be
  // along it.
  [[nodiscard]] picture::TextDirection outward(const PagePlace& place, const TickEdge& edge, std::size_t axis) const {
    if (axis == 2) return {-1, 0};
    const auto direction = [&](const BoxPoint& from, const BoxPoint& to) {
      const DrawingPoint a = on_page(place, from);
      const DrawingPoint b = on_page(place, to);
      const double dx = double{b.x} - double{a.x};
      const double dy = double{b.y} - double{a.y};
      const double length = std::sqrt(dx * dx + dy * dy);
      return length > 1e-3 ? picture::TextDirection{dx / length, dy / length} : picture::TextDirection{0, 0};
    };
    const picture::TextDirection along = direction(edge.edge.from, edge.edge.to);
    const picture::TextDirection away = direction({0, 0, 0}, edge.outward);
    const double across = along.x * away.y - along.y * away.x;
    constexpr double flattest = 0.35;
    if (std::abs(across) > flattest) return away;
    // Down, or to the right of an upright edge, unless the direction of the box differs.
    const double side = across != 0 ? (across > 0 ? 1 : -1) : (along.x != 0 ? (along.x > 0 ? -1 : 1) : (along.y > 0 ? -1 : 1));
    return {-side * along.y, side * along.x};
  }

  void add_axis(Annotations& result, const PagePlace& place, const TickEdge& edge, const AxisLook& look, std::size_t axis) const {
    const DrawingPoint a = on_page(place, edge.edge.from);
    const DrawingPoint b = on_page(place, edge.edge.to);
    const double length = std::sqrt((double{b.x} - double{a.x}) * (double{b.x} - double{a.x}) + (double{b.y} - double{a.y}) * (double{b.y} - double{a.y}));
    // An axis that is seen end-on gets no ticks.
    if (length < 4 * text_) return;
    const picture::TextDirection away = outward(place, edge, axis);
    const int most = std::clamp(static_cast<int>(length / (4 * text_)), 2, 8);
    std::vector<scene::RoundValue> values = scene::round_values(look.values, most);
    if (values.empty()) values.push_back({look.values.low, scene::shortest_text(look.values.low)});
    double farthest = 0;
    const double tick = 0.6 * text_;
    const double clearance = 0.5 * text_;
    for (const scene::RoundValue& value : values) {
      const double half = look.values.high / 2 - look.values.low / 2;
      const double part = half > 0 ? (value.value / 2 - look.values.low / 2) / half : 0.5;
      BoxPoint at = edge.edge.from;
      at[axis] = look.ends[0] + part * (look.ends[1] - look.ends[0]);
      const DrawingPoint on_edge = on_page(place, at);
      const DrawingPoint end{static_cast<float>(on_edge.x + away.x * tick), static_cast<float>(on_edge.y + away.y * tick)};
      result.ticks.push_back({on_edge, end});
      result.taken.push_back({std::min(on_edge.x, end.x), std::min(on_edge.y, end.y), std::max(on_edge.x, end.x), std::max(on_edge.y, end.y)});
      const double width = picture::text_width(text_, value.text);
      const double reach = tick + clearance + (std::abs(away.x) * width + std::abs(away.y) * text_);
      if (put(result, value.text, on_edge, away, tick + clearance, width, text_, {1, 0})) farthest = std::max(farthest, reach);
    }
    if (look.name.empty()) return;
    const DrawingPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double width = picture::text_width(text_, look.name);
    const bool upright = axis == 2;
    const double start = std::max(farthest, tick) + clearance;
    // Moves away from existing labels until the place is free.
    for (int i = 0; i < 20; ++i)
      if (put(result, look.name, middle, away, start + i * clearance, upright ? text_ : width, upright ? width : text_, upright ? picture::TextDirection{0, 1} : picture::TextDirection{1, 0}))
        return;
  }

  // Places a label of this size beyond a point, unless it would overlap another.
  bool put(Annotations& result, const std::string& text, DrawingPoint from, picture::TextDirection away, double distance, double width, double height,
           picture::TextDirection direction) const {
    // Half its width or height farther, depending on the main direction.
    const auto beyond = [](double way) { return std::clamp(1.6 * way, -1.0, 1.0); };
    const double x = from.x + away.x * distance + width / 2 * beyond(away.x);
    const double y = from.y + away.y * distance + height / 2 * beyond(away.y);
    const Rectangle box{x - width / 2, y - height / 2, x + width / 2, y + height / 2};
    for (const Label& label : result.labels)
      if (box.meets(label_box(label), 0.4 * text_)) return false;
    const bool upright = direction.y != 0;
    result.labels.push_back({text, {static_cast<float>(upright ? box.right : box.left), static_cast<float>(box.bottom)}, direction});
    result.taken.push_back(label_box(result.labels.back()));
    return true;
  }
  [[nodiscard]] Rectangle label_box(const Label& label) const {
    const double width = picture::text_width(text_, label.text);
    if (label.direction.y != 0) return {label.at.x - text_, label.at.y, label.at.x, label.at.y + width};
    return {label.at.x, label.at.y, label.at.x + width, label.at.y + text_};
  }

  void add_axes(VectorDrawing& drawing, const PagePlace& place, std::uint32_t box_layer, std::uint32_t text_layer, const Coverage* coverage) const {
    for (const BoxEdge& edge : visible_box(*surface_, box_, coverage)) {
      const DrawingPoint a = on_page(place, edge.from);
      const DrawingPoint b = on_page(place, edge.to);
      // Edges that are seen end-on would be dots.
      if (std::abs(double{a.x} - double{b.x}) + std::abs(double{a.y} - double{b.y}) > 0.01) picture::append_line(drawing, box_layer, a.x, a.y, b.x, b.y);
    }
    const Annotations all = annotations(place);
    for (const Tick& tick : all.ticks) picture::append_line(drawing, box_layer, tick.from.x, tick.from.y, tick.to.x, tick.to.y);
    for (const Label& label : all.labels) picture::append_text(drawing, text_layer, label.at.x, label.at.y, text_, label.text, label.direction);
  }

  // --- title and legend

  void add_title(VectorDrawing& drawing, std::uint32_t layer) const {
    double height = 1.4 * text_;
    const double width = picture::text_width(height, options_.title);
    if (width > options_.width) height *= options_.width / width;
    picture::append_text(drawing, layer, (options_.width - picture::text_width(height, options_.title)) / 2, options_.height - 1.6 * text_, height, options_.title);
  }

  [[nodiscard]] std::vector<scene::RoundValue> legend_values() const { return scene::round_values(grid_.range, 8); }
  [[nodiscard]] double legend_width() const {
    if (!options_.legend) return 0;
    double widest = 0;
    for (const scene::RoundValue& value : legend_values()) widest = std::max(widest, picture::text_width(text_, value.text));
    return widest + 5 * text_;
  }

  void add_legend(VectorDrawing& drawing, std::uint32_t box_layer, std::uint32_t text_layer) const {
    const double bar = 1.6 * text_;
    const double left = options_.width - legend_width() + 2 * text_;
    const double right = left + bar;
    const double bottom = options_.height * 0.2;
    const double top = options_.height * 0.8;
    const auto corner = [&](double x, double y) { drawing.points.push_back({static_cast<float>(x), static_cast<float>(y)}); };
    for (std::uint32_t i = 0; i < legend_steps; ++i) {
      const double from = bottom + (top - bottom) * i / legend_steps;
      const double to = bottom + (top - bottom) * (i + 1) / legend_steps;
      const picture::Colour colour = picture::height_colour((i + 0.5) / legend_steps);
      const auto rectangle = [&](double upper) {
        corner(left, from);
        corner(right, from);
        corner(right, upper);
        corner(left, upper);
      };
      drawing.facets.push_back({static_cast<std::uint32_t>(drawing.points.size()), 4, colour});
      rectangle(to);
      // Later colours are painted over it.
      drawing.areas.push_back({static_cast<std::uint32_t>(drawing.points.size()), 4, colour});
      rectangle(top);
    }
    const auto first = static_cast<std::uint32_t>(drawing.points.size());
    for (const auto& [x, y] : {std::pair{left, bottom}, std::pair{right, bottom}, std::pair{right, top}, std::pair{left, top}, std::pair{left, bottom}}) corner(x, y);
    drawing.lines.push_back({box_layer, first, 5});
    for (const scene::RoundValue& value : legend_values()) {
      const double y = bottom + (top - bottom) * part_of(value.value);
      picture::append_line(drawing, box_layer, right, y, right + 0.5 * text_, y);
      picture::append_text(drawing, text_layer, right + text_, y - text_ / 2, text_, value.text);
    }
  }

  std::span<const scene::HeightGrid> grids_;
  const scene::HeightGrid& grid_;  // the first: all have the same coordinates and range
  View view_;
  const FigureOptions& options_;
  double text_;
  Family rows_ = Family::along_x;
  const Surface* surface_ = nullptr;
  Box box_;
  Box heights_;  // the part of the box that contains heights
};

}  // namespace

Figure figure(std::span<const scene::HeightGrid> grids, const View& view, const FigureOptions& options) {
  return FigureMaker(grids, view, options).make();
}

}  // namespace sightline::algorithms::skala
