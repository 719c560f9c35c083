// See line_drawing.hpp.
#include "host/picture/line_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "host/scene/model/face_cut.hpp"

namespace sightline::picture {
namespace {

using Place = std::array<double, 2>;

struct Stroke {
  Place from{};
  Place to{};

  friend bool operator==(const Stroke&, const Stroke&) = default;
  // Not <=>, which the arrays of libc++ 14 do not have.
  friend bool operator<(const Stroke& a, const Stroke& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; }
};

// x and y within these.
using Window = ImageWindow;

double dot(const std::array<double, 3>& a, const scene::PolyPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const scene::PolyPoint& v) {
  return std::sqrt(dot({double(v[0]), double(v[1]), double(v[2])}, v));
}

// Cuts the part of t in [0, 1] away where from + t (to - from) is negative; false if nothing is left.
bool cut(double from, double to, double& low, double& high) {
  if (from < 0 && to < 0) return false;
  if (from < 0) low = std::max(low, from / (from - to));
  if (to < 0) high = std::min(high, from / (from - to));
  return low < high;
}

class Projection {
 public:
  Projection(const scene::PolyScene& scene, const scene::PolyCamera& camera)
      : scene_(scene),
        camera_(camera),
        lengths_{length(camera.right), length(camera.up), length(camera.forward)} {}

  // The piece in a window, which must be bounded in perspective; false if nothing of it is there.
  bool stroke(const LineEdge& edge, double low, double high, const Window& window, Stroke& result) const {
    const std::array<double, 3> a = point(edge, low);
    const std::array<double, 3> b = point(edge, high);
    double t0 = 0;
    double t1 = 1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      // Homogeneous: x >= low w and x <= high w, w being the depth.
      if (!cut(a[axis] - window.low[axis] * a[2], b[axis] - window.low[axis] * b[2], t0, t1)) return false;
      if (!cut(window.high[axis] * a[2] - a[axis], window.high[axis] * b[2] - b[axis], t0, t1)) return false;
    }
    result = {place(a, b, t0), place(a, b, t1)};
    return std::isfinite(result.from[0]) && std::isfinite(result.to[0]) && std::isfinite(result.from[1]) &&
           std::isfinite(result.to[1]);
  }

 private:
  // Right, up and depth of a place on an edge; the depth is 1 without perspective.
  [[nodiscard]] std::array<double, 3> point(const LineEdge& edge, double s) const {
    const std::array<double, 3> from = scene::place_of(scene_, edge.from);
    const std::array<double, 3> to = scene::place_of(scene_, edge.to);
    std::array<double, 3> d{};
    for (std::size_t a = 0; a < 3; ++a) d[a] = (s == 1 ? to[a] : from[a] + s * (to[a] - from[a])) - camera_.eye[a];
    return {dot(d, camera_.right) / lengths_[0], dot(d, camera_.up) / lengths_[1],
            camera_.perspective ? dot(d, camera_.forward) / lengths_[2] : 1};
  }
  [[nodiscard]] static Place place(const std::array<double, 3>& a, const std::array<double, 3>& b, double t) {
    std::array<double, 3> p = t == 1 ? b : a;
    if (t != 0 && t != 1)
      for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
    return {p[0] / p[2], p[1] / p[2]};
  }

  const scene::PolyScene& scene_;
  const scene::PolyCamera& camera_;
  std::array<double, 3> lengths_;
};

Window square(double half) {
  return {{-half, -half}, {half, half}};
}

double half_extent(double degrees) {
  constexpr double pi = 3.14159265358979323846;
  return std::tan(degrees * pi / 360);
}

std::vector<Stroke> strokes_of(const LinePicture& picture, const Projection& projection,
                               const Window& window) {
  std::vector<Stroke> strokes;
  strokes.reserve(picture.pieces.size());
  for (const LinePiece& piece : picture.pieces) {
    Stroke stroke;
    if (projection.stroke(piece.edge, piece.low.to_double(), piece.high.to_double(), window, stroke))
      strokes.push_back(stroke);
  }
  return strokes;
}

// What of whole edges, ascending as a picture's are, the picture has not.
std::vector<Stroke> hidden_strokes(const LinePicture& edges, const LinePicture& picture,
                                   const Projection& projection, const Window& window) {
  std::vector<Stroke> strokes;
  auto seen = picture.pieces.begin();
  for (const LinePiece& whole : edges.pieces) {
    double low = 0;
    const auto add = [&](double high) {
      Stroke stroke;
      if (low < high && projection.stroke(whole.edge, low, high, window, stroke)) strokes.push_back(stroke);
    };
    while (seen != picture.pieces.end() && seen->edge < whole.edge) ++seen;
    for (; seen != picture.pieces.end() && seen->edge == whole.edge; ++seen) {
      add(seen->low.to_double());
      low = seen->high.to_double();
    }
    add(1);
  }
  return strokes;
}

// The wanted extent, or that of the strokes, made as wide or as high as the field is.
Window framed(const std::vector<Stroke>& strokes, const DrawingField& field, bool perspective) {
  const double shorter = std::min(field.width, field.height);
  if (field.extent) {
    const double half = perspective ? half_extent(*field.extent) : *field.extent / 2;
    return {{-half * field.width / shorter, -half * field.height / shorter},
            {half * field.width / shorter, half * field.height / shorter}};
  }
  if (strokes.empty()) return square(1);
  Window bounds{strokes.front().from, strokes.front().from};
  for (const Stroke& stroke : strokes) {
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

// Whether the image is wider than can be fitted, beyond which all of it would be corners.
bool beyond(const LinePicture& picture, const Projection& projection) {
  const std::vector<Stroke> strokes = strokes_of(picture, projection, square(1e9));
  const double half = half_extent(widest_fitted_angle);
  return std::any_of(strokes.begin(), strokes.end(), [half](const Stroke& stroke) {
    return std::max({std::abs(stroke.from[0]), std::abs(stroke.from[1]), std::abs(stroke.to[0]),
                     std::abs(stroke.to[1])}) > half;
  });
}

// Where strokes meet: their ends, 2 n where stroke n begins and 2 n + 1 where it ends, by place, ascending.
struct Meetings {
  std::vector<std::uint32_t> ends;
  std::vector<std::uint32_t> starts;    // of the ends at each place
  std::vector<std::uint32_t> place_of;  // of each end

  explicit Meetings(const std::vector<Stroke>& strokes) : place_of(2 * strokes.size()) {
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
  Pen(VectorDrawing& drawing, const Window& window) : drawing_(drawing), window_(window) {}

  // Each stroke is continued with the first of those left that begins or ends where it ends.
  void lines(std::vector<Stroke> strokes, std::uint32_t layer) {
    for (Stroke& stroke : strokes)
      if (stroke.to < stroke.from) std::swap(stroke.from, stroke.to);
    std::sort(strokes.begin(), strokes.end());
    strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
    const Meetings meetings(strokes);
    std::vector<std::uint32_t> next(meetings.starts.begin(), meetings.starts.end() - 1);  // of each place
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
        // What is drawn is passed once.
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

  // A dash, a gap of three quarters of it; each stroke begins and ends with a dash.
  void dashes(const std::vector<Stroke>& strokes, std::uint32_t layer, double dash) {
    constexpr double gap = 0.75;
    for (const Stroke& stroke : strokes) {
      const double size = std::hypot(stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]) * scale();
      const double periods = std::min(std::floor((size / dash + gap) / (1 + gap) + 0.5), 1e4);
      const double count = std::max(periods, 1.0);
      const double step = 1 / (count * (1 + gap) - gap);  // one dash, as a share of the stroke
      for (int i = 0; i < static_cast<int>(count); ++i) {
        const double from = i * (1 + gap) * step;
        begin(layer);
        add(between(stroke, from));
        add(between(stroke, std::min(from + step, 1.0)));
      }
    }
  }

 private:
  [[nodiscard]] double scale() const { return drawing_.width / (window_.high[0] - window_.low[0]); }
  static Place between(const Stroke& stroke, double t) {
    return {stroke.from[0] + t * (stroke.to[0] - stroke.from[0]),
            stroke.from[1] + t * (stroke.to[1] - stroke.from[1])};
  }
  void begin(std::uint32_t layer) {
    drawing_.lines.push_back({layer, static_cast<std::uint32_t>(drawing_.points.size()), 0});
  }
  void add(const Place& p) {
    const double x = std::clamp((p[0] - window_.low[0]) * scale(), 0.0, drawing_.width);
    const double y = std::clamp((p[1] - window_.low[1]) * scale(), 0.0, drawing_.height);
    drawing_.points.push_back({static_cast<float>(x), static_cast<float>(y)});
    ++drawing_.lines.back().count;
  }

  VectorDrawing& drawing_;
  const Window& window_;
};

}  // namespace

namespace {

LinePicture together(std::span<const LineLayer> layers) {
  LinePicture all;
  for (const LineLayer& layer : layers)
    all.pieces.insert(all.pieces.end(), layer.picture.pieces.begin(), layer.picture.pieces.end());
  if (layers.size() == 1) return all;
  std::sort(all.pieces.begin(), all.pieces.end(), [](const LinePiece& a, const LinePiece& b) {
    return a.edge == b.edge ? a.low < b.low : a.edge < b.edge;
  });
  return all;
}

}  // namespace

ImageWindow drawing_window(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const DrawingField& field, const LinePicture* edges) {
  const Projection projection(scene, camera);
  DrawingField settled = field;
  const LinePicture seen = together(layers);
  const LinePicture& widest = edges != nullptr ? *edges : seen;
  if (!field.extent && camera.perspective && beyond(widest, projection)) settled.extent = usual_angle;
  constexpr double everything = 1e9;  // more than any image of coordinates below 2^18 without perspective
  const Window window = square(camera.perspective ? half_extent(widest_fitted_angle) : everything);
  return framed(settled.extent ? std::vector<Stroke>() : strokes_of(widest, projection, window), settled,
                camera.perspective);
}

VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const DrawingField& field, const LinePicture* edges) {
  return line_drawing(layers, scene, camera, field, drawing_window(layers, scene, camera, field, edges), edges);
}

VectorDrawing line_drawing(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const DrawingField& field, const ImageWindow& window, const LinePicture* edges) {
  const Projection projection(scene, camera);
  VectorDrawing drawing;
  drawing.width = field.width;
  drawing.height = field.height;
  if (field.scale) {
    drawing.width = std::max(field.width, (window.high[0] - window.low[0]) * *field.scale);
    drawing.height = std::max(field.height, (window.high[1] - window.low[1]) * *field.scale);
  }
  Pen pen(drawing, window);
  for (const LineLayer& layer : layers) {
    pen.lines(strokes_of(layer.picture, projection, window), static_cast<std::uint32_t>(drawing.layers.size()));
    drawing.layers.push_back({layer.label, layer.colour});
  }
  if (edges != nullptr) {
    pen.dashes(hidden_strokes(*edges, together(layers), projection, window), static_cast<std::uint32_t>(drawing.layers.size()),
               field.dash);
    drawing.layers.push_back({std::string(dashed_layer), {150, 150, 150}});
  }
  return drawing;
}

VectorDrawing line_drawing(const LinePicture& picture, const scene::PolyScene& scene,
                           const scene::PolyCamera& camera, const DrawingField& field, const LinePicture* edges) {
  const LineLayer layer{"visible", picture};
  return line_drawing({&layer, 1}, scene, camera, field, edges);
}

LinePicture wire_frame(const scene::PolyScene& scene) {
  LinePicture picture;
  for (const LineEdge& edge : edges_of(scene)) picture.pieces.push_back({edge, 0, 1});
  return picture;
}

}  // namespace sightline::picture
