#include "host/picture/line_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/box_tree.hpp"

namespace sightline::picture {
namespace {

using Place = std::array<double, 2>;

// Limits of x and y.
using Window = ImageWindow;

// Removes the part of t in [0, 1] where from + t (to - from) is negative. Returns false if nothing is left.
bool cut(double from, double to, double& low, double& high) {
  if (from < 0 && to < 0) return false;
  if (from < 0) low = std::max(low, from / (from - to));
  if (to < 0) high = std::min(high, from / (from - to));
  return low < high;
}

// Clips a line to a window, which must be bounded in perspective. Returns false if nothing is left.
bool place_in(const UnitedLine& line, const Window& window, LineStroke& stroke) {
  const std::array<double, 3>& a = line.from;
  const std::array<double, 3>& b = line.to;
  double t0 = 0;
  double t1 = 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // Homogeneous: x >= low w and x <= high w, where w is the depth.
    if (!cut(a[axis] - window.low[axis] * a[2], b[axis] - window.low[axis] * b[2], t0, t1)) return false;
    if (!cut(window.high[axis] * a[2] - a[axis], window.high[axis] * b[2] - b[axis], t0, t1)) return false;
  }
  const auto place = [&](double t) -> Place {
    std::array<double, 3> p = t == 1 ? b : a;
    if (t != 0 && t != 1)
      for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
    return {p[0] / p[2], p[1] / p[2]};
  };
  stroke = {place(t0), place(t1), line.layer, line.first_source, line.source_count};
  if (stroke.to < stroke.from) std::swap(stroke.from, stroke.to);
  return stroke.from != stroke.to && std::isfinite(stroke.from[0]) && std::isfinite(stroke.to[0]) &&
         std::isfinite(stroke.from[1]) && std::isfinite(stroke.to[1]);
}

Window square(double half) {
  return {{-half, -half}, {half, half}};
}

double half_extent(double degrees) {
  constexpr double pi = 3.14159265358979323846;
  return std::tan(degrees * pi / 360);
}

std::vector<LineStroke> strokes_of(const UnitedLines& lines, const Window& window) {
  std::vector<LineStroke> strokes;
  strokes.reserve(lines.lines.size());
  LineStroke stroke;
  for (const UnitedLine& line : lines.lines)
    if (place_in(line, window, stroke)) strokes.push_back(stroke);
  return strokes;
}

// The requested extent or that of the strokes, extended to the proportions of the field.
Window frame(const std::vector<LineStroke>& strokes, const DrawingField& field, bool perspective) {
  const double shorter = std::min(field.width, field.height);
  if (field.extent) {
    const double half = perspective ? half_extent(*field.extent) : *field.extent / 2;
    return {{-half * field.width / shorter, -half * field.height / shorter},
            {half * field.width / shorter, half * field.height / shorter}};
  }
  if (strokes.empty()) return square(1);
  Window bounds{strokes.front().from, strokes.front().from};
  for (const LineStroke& stroke : strokes) {
    for (const Place& p : {stroke.from, stroke.to}) {
      for (std::size_t a = 0; a < 2; ++a) {
        bounds.low[a] = std::min(bounds.low[a], p[a]);
        bounds.high[a] = std::max(bounds.high[a], p[a]);
      }
    }
  }
  const double unit = std::max((bounds.high[0] - bounds.low[0]) / field.width,
                               (bounds.high[1] - bounds.low[1]) / field.height);
  const double scale = unit > 0 ? unit : 1;
  std::array<double, 2> size{scale * field.width / 2, scale * field.height / 2};
  for (std::size_t a = 0; a < 2; ++a) {
    if (field.scale)
      size[a] = std::max((a == 0 ? field.width : field.height) / *field.scale, bounds.high[a] - bounds.low[a]) / 2;
    const double middle = (bounds.low[a] + bounds.high[a]) / 2;
    bounds.low[a] = middle - size[a];
    bounds.high[a] = middle + size[a];
  }
  return bounds;
}

// Whether the image is too wide to be fitted: its middle would be too small to see.
bool beyond(const std::vector<LineStroke>& strokes) {
  const double half = half_extent(widest_fitted_angle);
  return std::any_of(strokes.begin(), strokes.end(), [half](const LineStroke& stroke) {
    return std::max({std::abs(stroke.from[0]), std::abs(stroke.from[1]), std::abs(stroke.to[0]),
                     std::abs(stroke.to[1])}) > half;
  });
}

// The places where strokes meet. The ends of stroke n are 2 n and 2 n + 1; they are sorted by place.
struct Meetings {
  std::vector<std::uint32_t> ends;
  std::vector<std::uint32_t> starts;    // first end at each place
  std::vector<std::uint32_t> place_of;  // by end

  explicit Meetings(std::span<const LineStroke> strokes) : place_of(2 * strokes.size()) {
    const auto at = [&strokes](std::uint32_t end) -> const Place& {
      return end % 2 == 0 ? strokes[end / 2].from : strokes[end / 2].to;
    };
    ends.resize(place_of.size());
    std::iota(ends.begin(), ends.end(), std::uint32_t{0});
    std::sort(ends.begin(), ends.end(), [&at](std::uint32_t a, std::uint32_t b) {
      return at(a) != at(b) ? at(a) < at(b) : a < b;
    });
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
      if (i == 0 || at(ends[i]) != at(ends[i - 1])) starts.push_back(i);
      place_of[ends[i]] = static_cast<std::uint32_t>(starts.size() - 1);
    }
    starts.push_back(static_cast<std::uint32_t>(ends.size()));
  }
};

class Pen {
 public:
  Pen(VectorDrawing& drawing, const Window& window, const DrawingField& field)
      : drawing_(drawing), window_(window), field_(field) {}

  // Continues each stroke with the first remaining one that begins or ends at its end.
  void lines(std::span<const LineStroke> strokes, std::uint32_t layer) {
    const Meetings meetings(strokes);
    std::vector<std::uint32_t> next(meetings.starts.begin(), meetings.starts.end() - 1);  // by place
    std::vector<bool> drawn(strokes.size(), false);
    for (std::uint32_t i = 0; i < strokes.size(); ++i) {
      if (drawn[i]) continue;
      drawn[i] = true;
      begin(layer);
      add(strokes[i].from);
      add(strokes[i].to);
      std::uint32_t place = meetings.place_of[2 * i + 1];
      for (bool found = true; found;) {
        found = false;
        // Each drawn stroke is skipped only once.
        while (next[place] < meetings.starts[place + 1] && !found) {
          const std::uint32_t end = meetings.ends[next[place]++];
          if (drawn[end / 2]) continue;
          drawn[end / 2] = found = true;
          add(end % 2 == 0 ? strokes[end / 2].to : strokes[end / 2].from);
          place = meetings.place_of[end ^ 1U];
        }
      }
    }
  }

  // Dashes are measured from end to end of each stroke.
  void dashed(std::span<const LineStroke> strokes, std::uint32_t layer) {
    for (const LineStroke& stroke : strokes) {
      begin(layer);
      add(stroke.from);
      add(stroke.to);
    }
  }

 private:
  void begin(std::uint32_t layer) {
    drawing_.lines.push_back({layer, static_cast<std::uint32_t>(drawing_.points.size()), 0});
  }
  void add(const Place& p) {
    const std::array<double, 2> at = window_.in_field(p, field_);
    drawing_.points.push_back({static_cast<float>(at[0]), static_cast<float>(at[1])});
    ++drawing_.lines.back().count;
  }

  VectorDrawing& drawing_;
  const Window& window_;
  const DrawingField& field_;
};

// The number of the drawing's layer for each layer; see LineLayer.
std::vector<std::uint32_t> drawing_layers(std::span<const LineLayer> layers) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const bool begins = i > 0 && (layers[i].label != layers[i - 1].label || layers[i].colour != layers[i - 1].colour ||
                                  layers[i].hidden != layers[i - 1].hidden);
    numbers.push_back(i == 0 ? 0 : numbers.back() + (begins ? 1 : 0));
  }
  return numbers;
}

// For each stroke, the total length of the strokes that it is connected with.
std::vector<double> connected_lengths(std::span<const double> lengths, const Meetings& meetings) {
  std::vector<std::uint32_t> parents(lengths.size());
  std::iota(parents.begin(), parents.end(), std::uint32_t{0});
  const auto root_of = [&parents](std::uint32_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
  };
  for (std::size_t place = 0; place + 1 < meetings.starts.size(); ++place)
    for (std::uint32_t i = meetings.starts[place] + 1; i < meetings.starts[place + 1]; ++i)
      parents[root_of(meetings.ends[i] / 2)] = root_of(meetings.ends[i - 1] / 2);
  std::vector<double> sums(lengths.size(), 0);
  for (std::uint32_t i = 0; i < lengths.size(); ++i) sums[root_of(i)] += lengths[i];
  for (std::uint32_t i = 0; i < lengths.size(); ++i) sums[i] = sums[root_of(i)];
  return sums;
}

// Finds strokes that pass through a place, as they do where a line ends behind another one.
class PassingStrokes {
 public:
  PassingStrokes(std::span<const LineStroke> strokes, const Window& window) : strokes_(strokes), window_(window) {
    std::vector<geometry::Box> boxes;
    boxes.reserve(strokes.size());
    for (const LineStroke& stroke : strokes) {
      geometry::Box box;
      for (std::size_t a = 0; a < 2; ++a) {
        box.low[a] = cell(std::min(stroke.from[a], stroke.to[a]), a) - 1;
        box.high[a] = cell(std::max(stroke.from[a], stroke.to[a]), a) + 1;
      }
      boxes.push_back(box);
    }
    tree_.emplace(boxes);
  }

  // Whether a stroke that does not end there passes through the place, up to rounding.
  [[nodiscard]] bool any_at(const Place& place) const {
    geometry::Box at;
    for (std::size_t a = 0; a < 2; ++a) at.low[a] = at.high[a] = cell(place[a], a);
    bool found = false;
    tree_->for_each_touching(at, [&](std::uint32_t i) {
      const LineStroke& stroke = strokes_[i];
      const Place d{stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]};
      const Place p{place[0] - stroke.from[0], place[1] - stroke.from[1]};
      const double size = std::hypot(d[0], d[1]);
      const double near = 1e-8 * (window_.high[0] - window_.low[0]);
      const double along = (p[0] * d[0] + p[1] * d[1]) / size;
      found = found || (std::abs(p[1] * d[0] - p[0] * d[1]) <= near * size && along > near && along < size - near);
    });
    return found;
  }

 private:
  [[nodiscard]] std::int32_t cell(double place, std::size_t axis) const {
    constexpr double cells = 1 << 20;
    return static_cast<std::int32_t>((place - window_.low[axis]) / (window_.high[axis] - window_.low[axis]) * cells);
  }

  std::span<const LineStroke> strokes_;
  const Window& window_;
  std::optional<geometry::BoxTree> tree_;
};

// See DrawingField::min_length. A line continues through a place where exactly two strokes meet, if both belong to one
// layer of the drawing.
void leave_out_short(std::vector<LineStroke>& strokes, std::span<const LineLayer> layers, const Window& window,
                     const DrawingField& field) {
  const std::vector<std::uint32_t> numbers = drawing_layers(layers);
  const Meetings meetings(strokes);
  const auto ends_at = [&](std::uint32_t place) { return meetings.starts[place + 1] - meetings.starts[place]; };
  std::vector<double> lengths;
  for (const LineStroke& stroke : strokes)
    lengths.push_back(std::hypot(stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]) * window.units(field));
  const std::vector<double> connected = connected_lengths(lengths, meetings);
  std::vector<bool> known(strokes.size(), false);
  std::vector<bool> left_out(strokes.size(), false);
  std::vector<std::uint32_t> line;
  std::optional<PassingStrokes> passing;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (known[i]) continue;
    known[i] = true;
    line = {i};
    std::vector<std::uint32_t> free_ends;
    for (const std::uint32_t side : {0U, 1U}) {
      std::uint32_t end = 2 * i + side;  // where the line continues
      while (true) {
        const std::uint32_t place = meetings.place_of[end];
        if (ends_at(place) == 1) free_ends.push_back(end);
        if (ends_at(place) != 2) break;
        const std::uint32_t first = meetings.ends[meetings.starts[place]];
        const std::uint32_t other = first == end ? meetings.ends[meetings.starts[place] + 1] : first;
        if (known[other / 2] || numbers[strokes[other / 2].layer] != numbers[strokes[i].layer]) break;
        known[other / 2] = true;
        line.push_back(other / 2);
        end = other ^ 1U;
      }
    }
    double length = 0;
    for (const std::uint32_t s : line) length += lengths[s];
    if (length >= field.min_length) continue;
    bool closes_gap = connected[i] >= field.min_length;
    if (!free_ends.empty()) {
      if (!passing) passing.emplace(strokes, window);
      closes_gap = std::all_of(free_ends.begin(), free_ends.end(), [&](std::uint32_t end) {
        return passing->any_at(end % 2 == 0 ? strokes[end / 2].from : strokes[end / 2].to);
      });
    }
    if (!closes_gap)
      for (const std::uint32_t s : line) left_out[s] = true;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (!left_out[i]) strokes[kept++] = strokes[i];
  strokes.resize(kept);
}

}  // namespace

std::array<double, 2> ImageWindow::in_field(const std::array<double, 2>& place, const DrawingField& field) const {
  const double unit = units(field);
  // A drawing with a scale may be larger than its field.
  const auto within = [&](std::size_t axis, double size) {
    return std::clamp((place[axis] - low[axis]) * unit, 0.0, field.scale ? (high[axis] - low[axis]) * unit : size);
  };
  return {within(0, field.width), within(1, field.height)};
}

ImageWindow drawing_window(const UnitedLines& lines, const scene::PolyCamera& camera, const DrawingField& field) {
  DrawingField adjusted = field;
  constexpr double everything = 1e9;  // exceeds any image of coordinates below 2^18 in parallel projection
  std::vector<LineStroke> strokes;
  if (!field.extent) strokes = strokes_of(lines, square(everything));
  if (!field.extent && camera.perspective && beyond(strokes)) adjusted.extent = usual_angle;
  return frame(strokes, adjusted, camera.perspective);
}

std::vector<LineStroke> strokes_in(const UnitedLines& lines, std::span<const LineLayer> layers, const ImageWindow& window,
                                   const DrawingField& field) {
  // The window's own rounding must not clip: what is beyond it by less is placed on its border.
  ImageWindow wider = window;
  for (std::size_t a = 0; a < 2; ++a) {
    const double slack = 1e-9 * (window.high[a] - window.low[a]) + 1e-14 * std::max(-window.low[a], window.high[a]);
    wider.low[a] -= slack;
    wider.high[a] += slack;
  }
  std::vector<LineStroke> strokes = strokes_of(lines, wider);
  // A shorter stroke is a point: it only touches the border, or is finer than the resolution of --strokes.
  constexpr double least = 1.5e-6;
  const auto is_point = [&](const LineStroke& stroke) {
    const std::array<double, 2> from = window.in_field(stroke.from, field);
    const std::array<double, 2> to = window.in_field(stroke.to, field);
    return std::abs(to[0] - from[0]) < least && std::abs(to[1] - from[1]) < least;
  };
  strokes.erase(std::remove_if(strokes.begin(), strokes.end(), is_point), strokes.end());
  std::sort(strokes.begin(), strokes.end(), [](const LineStroke& a, const LineStroke& b) {
    if (a.layer != b.layer) return a.layer < b.layer;
    // Not <=>, which arrays in libc++ 14 do not support.
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  if (field.min_length > 0) leave_out_short(strokes, layers, window, field);
  return strokes;
}

VectorDrawing line_drawing(std::span<const LineStroke> strokes, std::span<const LineLayer> layers, const ImageWindow& window,
                           const DrawingField& field) {
  VectorDrawing drawing;
  drawing.width = field.width;
  drawing.height = field.height;
  if (field.scale) {
    drawing.width = std::max(field.width, (window.high[0] - window.low[0]) * *field.scale);
    drawing.height = std::max(field.height, (window.high[1] - window.low[1]) * *field.scale);
  }
  const std::vector<std::uint32_t> numbers = drawing_layers(layers);
  Pen pen(drawing, window, field);
  auto begin = strokes.begin();
  for (std::size_t i = 0; i < layers.size();) {
    const std::uint32_t number = numbers[i];
    drawing.layers.push_back({layers[i].label, layers[i].colour, layers[i].hidden ? field.dash : 0});
    const bool hidden = layers[i].hidden;
    while (i < layers.size() && numbers[i] == number) ++i;
    const auto end = std::find_if(begin, strokes.end(), [i](const LineStroke& stroke) { return stroke.layer >= i; });
    std::vector<LineStroke> of_layer(begin, end);
    std::sort(of_layer.begin(), of_layer.end(),
              [](const LineStroke& a, const LineStroke& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    hidden ? pen.dashed(of_layer, number) : pen.lines(of_layer, number);
    begin = end;
  }
  return drawing;
}

VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const DrawingField& field) {
  const UnitedLines lines = united_lines(layers, scene, camera);
  const ImageWindow window = drawing_window(lines, camera, field);
  return line_drawing(strokes_in(lines, layers, window, field), layers, window, field);
}

VectorDrawing line_drawing(const LinePicture& picture, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const DrawingField& field) {
  const LineLayer layer{"visible", picture};
  return line_drawing({&layer, 1}, scene, camera, field);
}

LineLayer hidden_layer(LinePicture picture, std::string kind) {
  return {"hidden", std::move(picture), {150, 150, 150}, std::move(kind), true};
}

LinePicture wire_frame(const scene::PolyScene& scene) {
  LinePicture picture;
  for (const LineEdge& edge : edges_of(scene)) picture.pieces.push_back({edge, 0, 1});
  return picture;
}

}  // namespace sightline::picture
