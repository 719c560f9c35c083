// See ray_check.hpp.
#include "tests/support/ray_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>
#include <sstream>

namespace sightline::tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;
constexpr double crease_angle = pi / 6;
constexpr double paper_tolerance = 0.01;  // mm: the precision of written strokes
constexpr std::size_t faults_described = 12;

Point3 operator-(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3 operator+(const Point3& a, const Point3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point3 operator*(double s, const Point3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point3& a) {
  return std::sqrt(dot(a, a));
}
Point3 unit(const Point3& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : Point3{};
}
Point2 operator-(const Point2& a, const Point2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
double dot(const Point2& a, const Point2& b) {
  return a[0] * b[0] + a[1] * b[1];
}
double length(const Point2& a) {
  return std::hypot(a[0], a[1]);
}

double distance(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return length(p - (a + t * along));
}

double distance(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return length(Point2{p[0] - a[0] - t * along[0], p[1] - a[1] - t * along[1]});
}

// The bounding box of points.
struct Box {
  Point2 low{infinity, infinity};
  Point2 high{-infinity, -infinity};

  void add(const Point2& p) {
    for (std::size_t a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  [[nodiscard]] double longer() const { return std::max(high[0] - low[0], high[1] - low[1]); }
  [[nodiscard]] double shorter() const { return std::min(high[0] - low[0], high[1] - low[1]); }
};

class Projection {
 public:
  explicit Projection(const PlainView& view)
      : view_(view), forward_(unit(view.forward)), right_(unit(view.right)), up_(unit(view.up)) {}

  [[nodiscard]] double depth(const Point3& p) const { return view_.perspective ? dot(p - view_.eye, forward_) : 1; }
  [[nodiscard]] Point2 image(const Point3& p) const {
    const Point3 d = p - view_.eye;
    const double z = depth(p);
    return {dot(d, right_) / z, dot(d, up_) / z};
  }
  // The unit vector from a point to the eye.
  [[nodiscard]] Point3 to_eye(const Point3& p) const { return view_.perspective ? unit(view_.eye - p) : -1.0 * forward_; }
  [[nodiscard]] const PlainView& view() const { return view_; }

 private:
  PlainView view_;
  Point3 forward_;
  Point3 right_;
  Point3 up_;
};

// A face with precomputed values.
struct Face {
  Point3 normal{};
  Point3 middle{};
  double deviation = 0;  // of the vertices from the face's plane
  double height = 0;     // twice the area divided by the longest side: the distance of a vertex from the opposite side
  double depth = 1;      // of the vertex nearest to the eye
  std::vector<Point2> image;
  Box box;  // of the image
};

enum class Cover { no, unclear, yes };
enum class Sight { visible, unclear, hidden };

// Finds the faces near a point of the image by a grid of cells.
class Caster {
 public:
  Caster(const PlainMesh& mesh, const Projection& projection, double rounding)
      : mesh_(mesh), projection_(projection), rounding_(rounding) {
    for (const auto& corners : mesh.faces) faces_.push_back(face_of(mesh, corners));
    make_grid();
  }

  [[nodiscard]] const Face& face(std::size_t number) const { return faces_[number]; }
  // Whether the coordinates of the file do not define a plane of the face.
  [[nodiscard]] bool is_rough(const Face& face) const { return face.deviation > 4 * rounding_; }

  // Visibility of a point on edges of the faces `own` (ascending), which do not hide it. `blur`: how far the point may be from
  // its true position in addition to rounding, in units of the file.
  [[nodiscard]] Sight sight(const Point3& p, double blur, const std::vector<std::uint32_t>& own) const {
    const Point2 at = projection_.image(p);
    const Point3 to_eye = projection_.to_eye(p);
    const double depth = projection_.depth(p);
    Sight result = Sight::visible;
    for (const std::uint32_t number : cell_at(at)) {
      const Face& face = faces_[number];
      const bool is_own = std::binary_search(own.begin(), own.end(), number);
      const double moved = rounding_ + blur;
      const double margin = 3 * moved / std::min(depth, face.depth);
      const Cover cover = cover_of(face.image, face.box, at, margin);
      if (cover == Cover::no) {
        // A part of a non-planar face may be outside its outline.
        if (is_rough(face) && may_fold_over(number, is_own, p, to_eye, at, margin)) result = Sight::unclear;
        continue;
      }
      const double facing = dot(face.normal, to_eye);
      const double beyond = dot(face.normal, p - face.middle);
      if (std::abs(beyond) <= 4 * moved + face.deviation || is_own) {
        bool clear = !is_own && flat_with_one_of(own, number);
        // A non-planar face may hide its own edge.
        if (is_own) clear = face.deviation <= rounding_ || std::abs(facing) * face.height >= 4 * face.deviation;
        if (is_rough(face)) clear = !may_fold_over(number, is_own, p, to_eye, at, margin);
        if (!clear) result = Sight::unclear;
        continue;
      }
      const bool towards = beyond * facing < 0;
      const bool before_eye =
          !projection_.view().perspective || dot(face.normal, projection_.view().eye - face.middle) * beyond < 0;
      if (!towards || !before_eye) continue;
      if (cover == Cover::yes) return Sight::hidden;
      result = Sight::unclear;
    }
    return result;
  }

 private:
  // Whether a face lies in the plane of one of `own`, within the precision of the file: then it does not hide their edges
  // either. If the plane is seen edge-on, the edge nearest to the eye is at the same place of the paper.
  [[nodiscard]] bool flat_with_one_of(const std::vector<std::uint32_t>& own, std::uint32_t number) const {
    return std::any_of(own.begin(), own.end(), [&](std::uint32_t one) {
      const auto& corners = mesh_.faces[number];
      return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        const double off = dot(faces_[one].normal, mesh_.vertices[corner] - faces_[one].middle);
        return std::abs(off) <= std::min(2 * mesh_.precision, rounding_);
      });
    });
  }

  [[nodiscard]] Face face_of(const PlainMesh& mesh, const std::vector<std::uint32_t>& corners) const {
    Face face;
    double longest = 0;
    face.depth = infinity;
    Point3 area{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point3& p = mesh.vertices[corners[i]];
      const Point3& q = mesh.vertices[corners[(i + 1) % corners.size()]];
      const Point3& first = mesh.vertices[corners[0]];
      area = area + cross(p - first, q - first);
      longest = std::max(longest, length(q - p));
      face.middle = face.middle + (1.0 / static_cast<double>(corners.size())) * p;
      face.depth = std::min(face.depth, projection_.depth(p));
      face.image.push_back(projection_.image(p));
      face.box.add(face.image.back());
    }
    face.normal = unit(area);
    face.height = longest > 0 ? length(area) / longest : 0;
    for (const std::uint32_t corner : corners)
      face.deviation = std::max(face.deviation, std::abs(dot(face.normal, mesh.vertices[corner] - face.middle)));
    return face;
  }

  // Whether a point is on a side of a triangle but at none of its vertices.
  [[nodiscard]] bool inside_side(const Point3& p, const std::array<std::size_t, 3>& triangle,
                                 const std::vector<std::uint32_t>& corners) const {
    bool on_side = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& a = mesh_.vertices[corners[triangle[i]]];
      const Point3& b = mesh_.vertices[corners[triangle[(i + 1) % 3]]];
      if (length(p - a) < 16 * rounding_) return false;
      on_side = on_side || distance(p, a, b) <= 4 * rounding_;
    }
    return on_side;
  }

  // Whether a triangle of a non-planar face may be in front of the point, for some division of the face into triangles.
  // `is_own`: the point is on a side of the face, and the triangle at that side does not hide it.
  [[nodiscard]] bool may_fold_over(std::uint32_t number, bool is_own, const Point3& p, const Point3& to_eye,
                                   const Point2& at, double margin) const {
    const auto& corners = mesh_.faces[number];
    const std::vector<Point2>& image = faces_[number].image;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        for (std::size_t k = j + 1; k < corners.size(); ++k) {
          const std::vector<Point2> triangle{image[i], image[j], image[k]};
          if (cover_of(triangle, faces_[number].box, at, margin) == Cover::no) continue;
          const Point3& first = mesh_.vertices[corners[i]];
          const Point3 normal = unit(cross(mesh_.vertices[corners[j]] - first, mesh_.vertices[corners[k]] - first));
          const double beyond = dot(normal, p - first);
          const double facing = dot(normal, to_eye);
          const bool in_plane = std::abs(beyond) <= 4 * rounding_;
          if (in_plane && is_own && std::abs(facing) > 1e-2 && inside_side(p, {i, j, k}, corners)) continue;
          if (in_plane || beyond * facing < 0) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] static Cover cover_of(const std::vector<Point2>& image, const Box& box, const Point2& p, double margin) {
    for (std::size_t a = 0; a < 2; ++a)
      if (p[a] < box.low[a] - margin || p[a] > box.high[a] + margin) return Cover::no;
    bool inside = false;
    for (std::size_t i = 0; i < image.size(); ++i) {
      const Point2& a = image[i];
      const Point2& b = image[(i + 1) % image.size()];
      if (distance(p, a, b) <= margin) return Cover::unclear;
      if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside ? Cover::yes : Cover::no;
  }

  void make_grid() {
    for (const Face& face : faces_) {
      box_.add(face.box.low);
      box_.add(face.box.high);
    }
    cells_ = std::clamp<std::size_t>(static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(faces_.size()))), 1, 256);
    grid_.resize(cells_ * cells_);
    for (std::uint32_t number = 0; number < faces_.size(); ++number) {
      const Face& face = faces_[number];
      // Larger than any margin: a thousandth of the image.
      const double wide = 1e-3 * box_.longer();
      for (std::size_t y = cell(face.box.low[1] - wide, 1); y <= cell(face.box.high[1] + wide, 1); ++y)
        for (std::size_t x = cell(face.box.low[0] - wide, 0); x <= cell(face.box.high[0] + wide, 0); ++x)
          grid_[y * cells_ + x].push_back(number);
    }
  }
  [[nodiscard]] std::size_t cell(double place, std::size_t axis) const {
    const double size = box_.high[axis] - box_.low[axis];
    const double share = size > 0 ? (place - box_.low[axis]) / size : 0;
    return static_cast<std::size_t>(std::clamp(share * static_cast<double>(cells_), 0.0, static_cast<double>(cells_ - 1)));
  }
  [[nodiscard]] const std::vector<std::uint32_t>& cell_at(const Point2& p) const {
    return grid_[cell(p[1], 1) * cells_ + cell(p[0], 0)];
  }

  const PlainMesh& mesh_;
  const Projection& projection_;
  double rounding_;
  std::vector<Face> faces_;
  Box box_;  // of the image
  std::size_t cells_ = 1;
  std::vector<std::vector<std::uint32_t>> grid_;
};

struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<std::uint32_t> faces;  // ascending, each once per occurrence of the edge
  std::vector<Point3> inwards;       // for each face: perpendicular to the edge, from it into the face
  bool is_line = false;              // a line of the file, with or without faces
};

std::vector<Edge> edges_of(const PlainMesh& mesh, const Caster& caster) {
  std::map<std::array<std::uint32_t, 2>, Edge> edges;
  for (std::uint32_t number = 0; number < mesh.faces.size(); ++number) {
    const auto& corners = mesh.faces[number];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % corners.size()];
      Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
      edge.from = std::min(a, b);
      edge.to = std::max(a, b);
      edge.faces.push_back(number);
      edge.inwards.push_back(unit(cross(caster.face(number).normal, mesh.vertices[b] - mesh.vertices[a])));
    }
  }
  for (const auto& line : mesh.lines) {
    Edge& edge = edges[{std::min(line[0], line[1]), std::max(line[0], line[1])}];
    edge.from = std::min(line[0], line[1]);
    edge.to = std::max(line[0], line[1]);
    edge.is_line = true;
  }
  std::vector<Edge> result;
  for (auto& [key, edge] : edges) result.push_back(std::move(edge));
  return result;
}

// Vertices in a grid of cells, to find those near a point.
class NearVertices {
 public:
  NearVertices(const PlainMesh& mesh, double cell) : mesh_(mesh), cell_(cell) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) cells_[key(mesh.vertices[v])].push_back(v);
  }

  // The only vertex within this distance of a point; nothing if there is none or more than one.
  [[nodiscard]] std::optional<std::uint32_t> only_at(const Point3& p, double reach) const {
    std::optional<std::uint32_t> found;
    for (int corner = 0; corner < 8; ++corner) {
      const Point3 offset{(corner & 1) != 0 ? reach : -reach, (corner & 2) != 0 ? reach : -reach,
                          (corner & 4) != 0 ? reach : -reach};
      const auto cell = cells_.find(key(p + offset));
      if (cell == cells_.end()) continue;
      for (const std::uint32_t v : cell->second) {
        if (found == v || length(mesh_.vertices[v] - p) > reach) continue;
        if (found) return std::nullopt;
        found = v;
      }
    }
    return found;
  }

  // Vertices nearer to the edge than `reach`, without its ends.
  [[nodiscard]] std::vector<std::uint32_t> about(const Edge& edge, double reach) const {
    std::vector<std::uint32_t> found;
    const Point3& a = mesh_.vertices[edge.from];
    const Point3& b = mesh_.vertices[edge.to];
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = number(std::min(a[i], b[i]) - reach);
      high[i] = number(std::max(a[i], b[i]) + reach);
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        const auto begin = cells_.lower_bound({x, y, low[2]});
        const auto end = cells_.upper_bound({x, y, high[2]});
        for (auto cell = begin; cell != end; ++cell)
          for (const std::uint32_t v : cell->second)
            if (v != edge.from && v != edge.to && distance(mesh_.vertices[v], a, b) <= reach) found.push_back(v);
      }
    }
    return found;
  }

 private:
  [[nodiscard]] std::int64_t number(double c) const { return static_cast<std::int64_t>(std::floor(c / cell_)); }
  [[nodiscard]] std::array<std::int64_t, 3> key(const Point3& p) const { return {number(p[0]), number(p[1]), number(p[2])}; }

  const PlainMesh& mesh_;
  double cell_;
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells_;
};

enum class Need { no, unclear, yes };

Need need_of(const Edge& edge, const PlainMesh& mesh, const Caster& caster, const Projection& projection, double rounding) {
  const Point3& a = mesh.vertices[edge.from];
  const Point3& b = mesh.vertices[edge.to];
  if (length(b - a) < 16 * rounding) return Need::unclear;
  double height = infinity;
  for (const std::uint32_t face : edge.faces) height = std::min(height, caster.face(face).height);
  if (height < 8 * rounding) return Need::unclear;
  if (edge.is_line || edge.faces.size() != 2) return Need::yes;
  if (edge.faces[0] == edge.faces[1]) return Need::no;  // both sides belong to one face: a bridge to a hole
  if (caster.is_rough(caster.face(edge.faces[0])) || caster.is_rough(caster.face(edge.faces[1]))) return Need::unclear;
  const double error =
      4 * (rounding + mesh.precision) / height + 1e-4;  // of a direction, which may be that of a larger flat surface
  const double folded = std::acos(std::clamp(dot(edge.inwards[0], edge.inwards[1]), -1.0, 1.0));
  const double bend = pi - folded;
  if (bend > crease_angle + error) return Need::yes;
  const Point3 side = unit(cross(b - a, projection.to_eye(0.5 * (a + b))));
  const double first = dot(edge.inwards[0], side);
  const double second = dot(edge.inwards[1], side);
  // Within the precision of the file the faces may be one flat surface.
  const bool may_be_flat = bend < error || std::sin(bend) * height < 8 * mesh.precision;
  const bool may_be_crease = bend > crease_angle - error;
  const bool is_clear = std::min(std::abs(first), std::abs(second)) >= error;
  if (is_clear && (first > 0) == (second > 0)) return may_be_flat ? Need::unclear : Need::yes;
  return may_be_crease || (!is_clear && !may_be_flat) ? Need::unclear : Need::no;
}

// The position of the image on the paper: p = scale * image + shift.
struct Placing {
  double scale = 0;
  Point2 shift{};

  [[nodiscard]] Point2 paper(const Point2& image) const {
    return {scale * image[0] + shift[0], scale * image[1] + shift[1]};
  }
  [[nodiscard]] Point2 image(const Point2& paper) const {
    return {(paper[0] - shift[0]) / scale, (paper[1] - shift[1]) / scale};
  }
};

// For a mesh whose image is a line along an axis: matches both ends.
Placing placing_of_line(const std::vector<PlainStroke>& strokes, const Projection& projection) {
  Box paper;
  Box image;
  for (const PlainStroke& stroke : strokes) {
    paper.add(stroke.from);
    paper.add(stroke.to);
    for (const auto& edge : stroke.edges)
      for (const Point3& end : edge) image.add(projection.image(end));
  }
  const double scale = paper.longer() / image.longer();
  return {scale, {paper.low[0] - scale * image.low[0], paper.low[1] - scale * image.low[1]}};
}

// Least squares over the distances of stroke ends from the lines of their source edges: an end may be anywhere on its edge.
Placing placing_of(const std::vector<PlainStroke>& strokes, const Projection& projection, double smallest) {
  std::array<std::array<double, 4>, 3> sums{};
  for (const PlainStroke& stroke : strokes) {
    for (const auto& edge : stroke.edges) {
      const Point2 a = projection.image(edge[0]);
      const Point2 along = projection.image(edge[1]) - a;
      const double size = length(along);
      if (size < smallest) continue;
      const Point2 normal{-along[1] / size, along[0] / size};
      for (const Point2& end : {stroke.from, stroke.to}) {
        const std::array<double, 4> row{normal[0], normal[1], dot(normal, a), dot(normal, end)};
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t k = 0; k < 4; ++k) sums[i][k] += row[i] * row[k];
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t largest = i;
    for (std::size_t k = i + 1; k < 3; ++k)
      if (std::abs(sums[k][i]) > std::abs(sums[largest][i])) largest = k;
    std::swap(sums[i], sums[largest]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == i) continue;
      const double factor = sums[k][i] / sums[i][i];
      for (std::size_t c = i; c < 4; ++c) sums[k][c] -= factor * sums[i][c];
    }
  }
  return {sums[2][3] / sums[2][2], {sums[0][3] / sums[0][0], sums[1][3] / sums[1][1]}};
}

// Strokes in a grid of cells of the paper.
class StrokesOnPaper {
 public:
  explicit StrokesOnPaper(const std::vector<PlainStroke>& strokes) {
    for (const PlainStroke& stroke : strokes) {
      box_.add(stroke.from);
      box_.add(stroke.to);
    }
    grid_.resize(cells * cells);
    for (const PlainStroke& stroke : strokes) {
      const auto [x0, x1] = std::minmax(stroke.from[0], stroke.to[0]);
      const auto [y0, y1] = std::minmax(stroke.from[1], stroke.to[1]);
      for (std::size_t y = cell(y0 - 1, 1); y <= cell(y1 + 1, 1); ++y)
        for (std::size_t x = cell(x0 - 1, 0); x <= cell(x1 + 1, 0); ++x) grid_[y * cells + x].push_back(&stroke);
    }
  }

  // The distance from the nearest visible stroke, up to 1 mm; infinity beyond.
  [[nodiscard]] double distance_of(const Point2& p) const {
    double nearest = infinity;
    for (const PlainStroke* stroke : about(p))
      if (!stroke->hidden) nearest = std::min(nearest, distance(p, stroke->from, stroke->to));
    return nearest;
  }

  // Another stroke that contains both points of a stroke; null if there is none.
  [[nodiscard]] const PlainStroke* other_on(const PlainStroke& one, const Point2& p, const Point2& q) const {
    constexpr double written = 3e-6;  // mm: the precision of --strokes
    for (const PlainStroke* stroke : about(p)) {
      if (stroke != &one && distance(p, stroke->from, stroke->to) <= written &&
          distance(q, stroke->from, stroke->to) <= written)
        return stroke;
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t cells = 64;
  [[nodiscard]] std::size_t cell(double place, std::size_t axis) const {
    const double share = (place - box_.low[axis]) / std::max(box_.longer(), 1e-9);
    return static_cast<std::size_t>(std::clamp(share * cells, 0.0, cells - 1.0));
  }
  [[nodiscard]] const std::vector<const PlainStroke*>& about(const Point2& p) const {
    return grid_[cell(p[1], 1) * cells + cell(p[0], 0)];
  }

  Box box_;
  std::vector<std::vector<const PlainStroke*>> grid_;
};

class Check {
 public:
  Check(const PlainMesh& mesh, const PlainView& view, const std::vector<PlainStroke>& strokes, std::uint32_t seed)
      : mesh_(mesh),
        projection_(view),
        strokes_(strokes),
        rounding_(size_of(mesh) / 65536),
        caster_(mesh, projection_, rounding_),
        edges_(edges_of(mesh, caster_)),
        near_(mesh, size_of(mesh) / 48),
        paper_(strokes),
        engine_(seed) {}

  RayReport run() {
    double nearest = infinity;
    Box image;
    for (const Point3& p : mesh_.vertices) {
      nearest = std::min(nearest, projection_.depth(p));
      image.add(projection_.image(p));
    }
    const bool line = image.shorter() < 1e-6 * image.longer();
    placing_ = line ? placing_of_line(strokes_, projection_) : placing_of(strokes_, projection_, 1e-3 * image.longer());
    report_.scale = placing_.scale;
    report_.allowed_residual = 2 * rounding_ / nearest * placing_.scale + paper_tolerance;
    if (!(placing_.scale > 0) || !std::isfinite(placing_.scale)) {
      report_.residual = infinity;
      note("the strokes have no common scale");
      return report_;
    }
    check_residual();
    check_edges();
    check_strokes();
    return report_;
  }

 private:
  static double size_of(const PlainMesh& mesh) {
    double size = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      double low = infinity;
      double high = -infinity;
      for (const Point3& p : mesh.vertices) {
        low = std::min(low, p[a]);
        high = std::max(high, p[a]);
      }
      size = std::max(size, high - low);
    }
    return size;
  }

  // In [0, 1), the same with every library.
  double random() { return static_cast<double>(engine_()) / 4294967296.0; }

  void note(const std::string& fault) {
    if (report_.faults.size() < faults_described) report_.faults.push_back(fault);
  }
  void note(const std::string& what, const Point3& p, const std::string& more) {
    const Point2 paper = placing_.paper(projection_.image(p));
    std::ostringstream text;
    text.precision(9);
    text << what << " at " << p[0] << ',' << p[1] << ',' << p[2] << ", on the paper " << paper[0] << ',' << paper[1] << ", "
         << more;
    note(text.str());
  }
  static std::string name_of(const Point3& a, const Point3& b) {
    std::ostringstream text;
    text.precision(9);
    text << "edge " << a[0] << ',' << a[1] << ',' << a[2] << " to " << b[0] << ',' << b[1] << ',' << b[2];
    return text.str();
  }

  // The largest expected error of a point's position on the paper.
  [[nodiscard]] double tolerance(const Point3& p) const {
    return 2 * rounding_ / projection_.depth(p) * placing_.scale + paper_tolerance;
  }

  // Each end of a stroke must be on one of its edges, and each of its edges must touch the stroke.
  void check_residual() {
    for (const PlainStroke& stroke : strokes_) {
      double from = infinity;
      double to = infinity;
      for (const auto& edge : stroke.edges) {
        const Point2 a = placing_.paper(projection_.image(edge[0]));
        const Point2 b = placing_.paper(projection_.image(edge[1]));
        const double from_edge = distance(stroke.from, a, b);
        const double to_edge = distance(stroke.to, a, b);
        from = std::min(from, from_edge);
        to = std::min(to, to_edge);
        const double apart =
            std::min({from_edge, to_edge, distance(a, stroke.from, stroke.to), distance(b, stroke.from, stroke.to)});
        report_.residual = std::max(report_.residual, apart);
      }
      report_.residual = std::max({report_.residual, from, to});
    }
  }

  // Numbers, ascending, of edges near vertices that are not their ends, and of edges that are part of such an edge, as where a
  // vertex of one face divides the side of another.
  [[nodiscard]] std::set<std::size_t> edges_near_vertices() const {
    std::set<std::size_t> result;
    std::vector<std::vector<std::size_t>> edges_at(mesh_.vertices.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      edges_at[edges_[e].from].push_back(e);
      edges_at[edges_[e].to].push_back(e);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      std::vector<std::uint32_t> near = near_.about(edges_[e], 3 * rounding_);
      if (near.empty()) continue;
      near.insert(near.end(), {edges_[e].from, edges_[e].to});
      std::sort(near.begin(), near.end());
      for (const std::uint32_t vertex : near) {
        for (const std::size_t other : edges_at[vertex]) {
          if (std::binary_search(near.begin(), near.end(), edges_[other].from) &&
              std::binary_search(near.begin(), near.end(), edges_[other].to))
            result.insert(other);
        }
      }
    }
    return result;
  }

  void check_edges() {
    const std::set<std::size_t> near_vertices = edges_near_vertices();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const Edge& edge = edges_[e];
      Need need = need_of(edge, mesh_, caster_, projection_, rounding_);
      if (need == Need::yes && near_vertices.contains(e)) need = Need::unclear;
      if (need == Need::unclear) ++report_.unclear_edges;
      if (need != Need::yes) continue;
      ++report_.feature_edges;
      const Point3& a = mesh_.vertices[edge.from];
      const Point3& b = mesh_.vertices[edge.to];
      const double size = placing_.scale * length(projection_.image(b) - projection_.image(a));
      if (size <= 2 * paper_tolerance) continue;  // seen end-on: its image is a point
      const int count = static_cast<int>(std::clamp(size / 5, 2.0, 12.0));
      for (int i = 0; i < count; ++i) {
        const double s = (i + random()) / count;
        const Point3 p = a + s * (b - a);
        ++report_.samples;
        if (caster_.sight(p, 0, edge.faces) != Sight::visible) continue;
        ++report_.visible;
        if (paper_.distance_of(placing_.paper(projection_.image(p))) <= tolerance(p)) continue;
        ++report_.undrawn;
        note("visible and not drawn:", p, name_of(a, b) + " of " + std::to_string(edge.faces.size()) + " faces");
      }
    }
  }

  // The point of an edge whose image is nearest to a point of the image; `off`: the distance that remains there.
  [[nodiscard]] Point3 point_at(const std::array<Point3, 2>& edge, const Point2& image, double& off) const {
    const Point2 a = projection_.image(edge[0]);
    const Point2 along = projection_.image(edge[1]) - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(image - a, along) / square, 0.0, 1.0) : 0;
    off = length(image - Point2{a[0] + t * along[0], a[1] + t * along[1]});
    // In perspective, equal steps of the image are unequal steps of the edge.
    const double w0 = (1 - t) / projection_.depth(edge[0]);
    const double w1 = t / projection_.depth(edge[1]);
    return (w0 / (w0 + w1)) * edge[0] + (w1 / (w0 + w1)) * edge[1];
  }

  // The faces at an edge of the mesh; empty if no edge has these ends.
  [[nodiscard]] const std::vector<std::uint32_t>& faces_at(const std::array<Point3, 2>& ends) const {
    static const std::vector<std::uint32_t> none;
    const auto from = near_.only_at(ends[0], 2 * rounding_);
    const auto to = near_.only_at(ends[1], 2 * rounding_);
    if (!from || !to) return none;
    const std::array<std::uint32_t, 2> key{std::min(*from, *to), std::max(*from, *to)};
    const auto edge =
        std::lower_bound(edges_.begin(), edges_.end(), key, [](const Edge& a, const std::array<std::uint32_t, 2>& b) {
          return std::array{a.from, a.to} < b;
        });
    return edge != edges_.end() && edge->from == key[0] && edge->to == key[1] ? edge->faces : none;
  }

  void check_strokes() {
    for (const PlainStroke& stroke : strokes_) {
      const double size = length(stroke.to - stroke.from);
      const auto at = [&](double s) {
        return Point2{stroke.from[0] + s * (stroke.to[0] - stroke.from[0]),
                      stroke.from[1] + s * (stroke.to[1] - stroke.from[1])};
      };
      const int count = static_cast<int>(std::clamp(size / 5, 2.0, 12.0));
      for (int i = 0; i < count; ++i) {
        const double s = (i + random()) / count;
        if (size >= 0.01) check_once(stroke, at(0.98 * s), at(0.98 * s + 0.02));
        if (size >= 4 * report_.allowed_residual) check_stroke_at(stroke, at(s));
      }
    }
  }

  // Whether the strokes have edges on one line of the image. Strokes of edges at an acute angle may overlap within the digits of
  // --strokes although their edges do not.
  [[nodiscard]] bool on_one_line(const PlainStroke& one, const PlainStroke& other) const {
    constexpr double exact = 1e-9;  // mm
    for (const auto& first : one.edges) {
      for (const auto& second : other.edges) {
        const std::array<Point2, 4> ends{
            placing_.paper(projection_.image(first[0])), placing_.paper(projection_.image(first[1])),
            placing_.paper(projection_.image(second[0])), placing_.paper(projection_.image(second[1]))};
        const bool first_is_longer = length(ends[1] - ends[0]) > length(ends[3] - ends[2]);
        const Point2 at = ends[first_is_longer ? 0 : 2];
        const Point2 along = ends[first_is_longer ? 1 : 3] - at;
        const auto off = [&](const Point2& p) {
          return std::abs(along[0] * (p[1] - at[1]) - along[1] * (p[0] - at[0])) / length(along);
        };
        if (std::all_of(ends.begin(), ends.end(), [&](const Point2& p) { return off(p) < exact; })) return true;
      }
    }
    return false;
  }

  void check_once(const PlainStroke& stroke, const Point2& p, const Point2& q) {
    const PlainStroke* const other = paper_.other_on(stroke, p, q);
    if (other == nullptr || !on_one_line(stroke, *other)) return;
    ++report_.drawn_twice;
    std::ostringstream text;
    text.precision(9);
    text << "drawn twice: on the paper " << p[0] << ',' << p[1] << ", by a " << (stroke.hidden ? "dash" : "stroke")
         << " of kind " << stroke.kind << " and a " << (other->hidden ? "dash" : "stroke") << " of kind " << other->kind;
    note(text.str());
  }

  void check_stroke_at(const PlainStroke& stroke, const Point2& on_paper) {
    const Point2 image = placing_.image(on_paper);
    bool all_hidden = true;
    bool some_visible = false;
    bool on_edge = false;
    Point3 first{};
    for (const auto& edge : stroke.edges) {
      double off = 0;
      const Point3 p = point_at(edge, image, off);
      if (off * placing_.scale > tolerance(p)) continue;
      // A small step on the paper is a large one on an edge that points towards the eye.
      const double foreshortened = length(projection_.image(edge[1]) - projection_.image(edge[0])) * projection_.depth(p);
      const double blur = foreshortened > 0 ? paper_tolerance / placing_.scale * projection_.depth(p) *
                                                  length(edge[1] - edge[0]) / foreshortened
                                            : infinity;
      const Sight sight = caster_.sight(p, blur, faces_at(edge));
      if (!on_edge) first = p;
      on_edge = true;
      all_hidden = all_hidden && sight == Sight::hidden;
      some_visible = some_visible || sight == Sight::visible;
    }
    ++(stroke.hidden ? report_.dash_samples : report_.stroke_samples);
    const std::string edges = (stroke.edges.empty() ? "no edge" : name_of(stroke.edges[0][0], stroke.edges[0][1])) + ", " +
                              stroke.kind + ", of " + std::to_string(stroke.edges.size()) + " edges";
    if (!on_edge) {
      ++report_.off_edge;
      note("stroke off its edges: on the paper " + std::to_string(on_paper[0]) + "," + std::to_string(on_paper[1]) + ", " +
           edges);
    } else if (!stroke.hidden && all_hidden) {
      ++report_.hidden_drawn;
      note("hidden and drawn:", first, edges);
    } else if (stroke.hidden && some_visible) {
      ++report_.visible_dashed;
      note("visible and dashed:", first, edges);
    }
  }

  const PlainMesh& mesh_;
  Projection projection_;
  const std::vector<PlainStroke>& strokes_;
  double rounding_;
  Caster caster_;
  std::vector<Edge> edges_;  // ascending by their ends
  NearVertices near_;
  StrokesOnPaper paper_;
  std::mt19937 engine_;
  Placing placing_;
  RayReport report_;
};

Point3 point_of(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace

PlainView view_of_json(const std::string& document) {
  const nlohmann::json camera = nlohmann::json::parse(document).at("camera");
  return {camera.at("perspective").get<bool>(), point_of(camera.at("eye")), point_of(camera.at("forward")),
          point_of(camera.at("right")), point_of(camera.at("up"))};
}

std::vector<PlainStroke> strokes_of_lines(const std::string& lines) {
  std::vector<PlainStroke> strokes;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    const nlohmann::json json = nlohmann::json::parse(line);
    PlainStroke stroke{{json.at("from").at(0).get<double>(), json.at("from").at(1).get<double>()},
                       {json.at("to").at(0).get<double>(), json.at("to").at(1).get<double>()},
                       json.at("hidden").get<bool>(),
                       json.at("kind").get<std::string>(),
                       {}};
    for (const auto& edge : json.at("edges")) stroke.edges.push_back({point_of(edge.at(0)), point_of(edge.at(1))});
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

RayReport check_by_rays(const PlainMesh& mesh, const PlainView& view, const std::vector<PlainStroke>& strokes,
                        std::uint32_t seed) {
  return Check(mesh, view, strokes, seed).run();
}

}  // namespace sightline::tests
