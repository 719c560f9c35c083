// Reads a certificate line by line and checks each edge when its lines end. README.md has the mathematics.
#include "tools/verify/verify.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace sightline::verifier {
namespace {

// Edges between vertices are checked in 128 bits: with coordinates below 2^19 relative to the eye, no product is as large
// as 2^124 (README.md, "Sizes"). Lines with fractional ends are checked by the same code in integers of any size.
__extension__ typedef __int128 Int128;
using Integer = mpz_class;

struct Fault {
  std::size_t line = 0;
  std::string reason;
  bool malformed = false;
};

template <class N>
using Vector = std::array<N, 3>;
using Point = Vector<std::int64_t>;

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}

// factor a - other b
template <class N>
Vector<N> combination(const N& factor, const Vector<N>& a, const N& other, const Vector<N>& b) {
  return {N(factor * a[0] - other * b[0]), N(factor * a[1] - other * b[1]), N(factor * a[2] - other * b[2])};
}

template <class N>
Vector<N> as(const Point& p) {
  return {N(p[0]), N(p[1]), N(p[2])};
}

template <class N>
struct Fraction {
  N over = 0;
  N under = 1;  // positive

  friend bool operator<(const Fraction& a, const Fraction& b) { return a.over * b.under < b.over * a.under; }
};

template <class N>
struct Interval {
  Fraction<N> low{0, 1};
  Fraction<N> high{1, 1};

  // Restricts the interval to where a quantity is positive that is linear along the edge, from its values at both ends.
  void keep_positive(const N& from, const N& to) {
    if (from <= 0 && to <= 0) high = low;
    if (from < 0 && to > 0) low = std::max(low, Fraction<N>{N(-from), N(to - from)});
    if (from > 0 && to < 0) high = std::min(high, Fraction<N>{from, N(from - to)});
  }
  [[nodiscard]] bool empty() const { return !(low < high); }
};

struct Face {
  std::size_t first = 0;  // corner
  std::size_t end = 0;
  Point normal{};
  std::uint32_t surface = 0;
  bool sheet = false;
  bool occludes = false;      // of a sheet not seen edge-on, or of a solid and turned to the eye
  std::int64_t nearest = 0;  // along the direction of sight
};

struct Corner {
  std::uint32_t vertex = 0;
  bool last = false;  // of its ring
};

struct Side {  // of a face, low < high
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  bool upwards = false;
  std::uint32_t face = 0;
};

struct Scene {
  bool perspective = false;
  Point eye{};
  std::array<Point, 3> axes{};  // right, up, forward
  std::vector<Point> points;    // relative to the eye
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<Side> sides;           // ascending
  std::vector<std::uint8_t> turned;  // by surface: turned away, or edge-on

  [[nodiscard]] const Point& point(std::size_t corner) const { return points[corners[corner].vertex]; }
  // Calls visit(corner, next corner) for each side of a face.
  template <class Visit>
  void for_sides(const Face& face, Visit visit) const {
    for (std::size_t i = face.first, ring = i; i < face.end; ++i) {
      visit(i, corners[i].last ? ring : i + 1);
      if (corners[i].last) ring = i + 1;
    }
  }
};

// The plane of sight through an edge from a/w to b/w. A point of it is seen in the direction alpha a + beta b.
template <class N>
struct Sight {
  bool perspective = false;
  Vector<N> forward;
  Vector<N> a;
  Vector<N> b;
  N w;
  Vector<N> across{};  // normal of the plane of sight, to the left
  std::size_t axis = 0;  // along which it is not 0

  Sight(bool in_perspective, const Vector<N>& direction, const Vector<N>& from, const Vector<N>& to, const N& weight)
      : perspective(in_perspective), forward(direction), a(from), b(to), w(weight) {
    across = perspective ? cross(a, b) : cross(forward, combination<N>(1, b, 1, a));
    while (axis < 3 && across[axis] == 0) ++axis;
  }
  [[nodiscard]] bool is_point() const { return axis == 3; }
  [[nodiscard]] N left_of(const Vector<N>& p) const {
    if (perspective) return dot(across, p);
    return w * dot(across, p) - dot(across, a);
  }
  struct Direction {
    N alpha;
    N beta;
  };
  // Of the point x/v in the plane.
  [[nodiscard]] Direction direction(const Vector<N>& x, const N& v) const {
    if (perspective) return {N(cross(x, b)[axis] / across[axis]), N(cross(a, x)[axis] / across[axis])};
    const N beta = cross(combination<N>(v, a, w, x), forward)[axis] / across[axis];
    return {N(v - beta), beta};
  }
};

// The intervals of the edge that the face hides from one side: the plane of sight, moved a little to that side, cuts the
// face in segments; the light that they stop falls on the part of the edge that is seen between their ends and lies
// beyond the plane of the face.
template <class N>
std::vector<Interval<N>> shadows(const Sight<N>& sight, const Scene& scene, const Face& face, bool left) {
  using Direction = typename Sight<N>::Direction;
  std::vector<Direction> cuts;
  scene.for_sides(face, [&](std::size_t i, std::size_t next) {
    Vector<N> p = as<N>(scene.point(i));
    Vector<N> q = as<N>(scene.point(next));
    N at_p = sight.left_of(p);
    N at_q = sight.left_of(q);
    const auto is_left = [left](const N& value) { return left ? value > 0 : value >= 0; };
    if (is_left(at_p) == is_left(at_q)) return;
    if (is_left(at_p)) {
      std::swap(p, q);
      std::swap(at_p, at_q);
    }
    cuts.push_back(sight.direction(combination(at_q, p, at_p, q), N(at_q - at_p)));
  });
  std::sort(cuts.begin(), cuts.end(), [](const Direction& c, const Direction& d) { return c.alpha * d.beta > c.beta * d.alpha; });
  const Vector<N> normal = as<N>(face.normal);
  const N offset = dot(normal, as<N>(scene.point(face.first)));
  const N away = sight.perspective ? offset : dot(normal, sight.forward);  // positive: the normal points away from the eye
  N from = dot(normal, sight.a) - sight.w * offset;
  N to = dot(normal, sight.b) - sight.w * offset;
  if (away < 0) {
    from = -from;
    to = -to;
  }
  std::vector<Interval<N>> hidden;
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
    Interval<N> interval;
    interval.keep_positive(from, to);
    interval.keep_positive(N(-cuts[i].beta), cuts[i].alpha);
    interval.keep_positive(cuts[i + 1].beta, N(-cuts[i + 1].alpha));
    if (!interval.empty()) hidden.push_back(interval);
  }
  return hidden;
}

// A rectangle of the image, in fixed point.
struct Bounds {
  std::array<std::int64_t, 2> low{INT64_MAX, INT64_MAX};
  std::array<std::int64_t, 2> high{INT64_MIN, INT64_MIN};

  // Adds the image of x/w. In perspective, what reaches behind the eye is everywhere.
  template <class N>
  void add(const Scene& scene, const Vector<N>& x, const N& w) {
    const N depth = scene.perspective ? dot(as<N>(scene.axes[2]), x) : w;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::int64_t step = 0;
      if (depth > 0) {
        const N over = dot(as<N>(scene.axes[axis]), x) * (std::int64_t{1} << 24);
        N whole = over / depth;
        if (whole * depth > over) whole -= 1;  // rounded down, which keeps the order
        if constexpr (std::is_same_v<N, Integer>) step = whole.fits_slong_p() ? whole.get_si() : whole > 0 ? INT64_MAX : INT64_MIN;
        else step = static_cast<std::int64_t>(whole);
      }
      low[axis] = depth > 0 ? std::min(low[axis], step) : INT64_MIN;
      high[axis] = depth > 0 ? std::max(high[axis], step) : INT64_MAX;
    }
  }
};

// Finds the occluding faces whose bounds meet a rectangle: a grid whose lines are at quantiles of the faces' bounds.
class NearFaces {
 public:
  void build(const std::vector<Bounds>& bounds, const std::vector<std::uint32_t>& faces) {
    bounds_ = bounds;
    faces_ = faces;
    seen_.assign(faces.size(), 0);
    for (std::size_t count = static_cast<std::size_t>(std::sqrt(static_cast<double>(faces.size()) / 2)) + 1;; count /= 2) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        std::vector<std::int64_t> ends;
        for (const Bounds& b : bounds) ends.push_back(b.low[axis]);
        std::sort(ends.begin(), ends.end());
        lines_[axis].clear();
        for (std::size_t i = 1; i < count; ++i) lines_[axis].push_back(ends[i * ends.size() / count]);
      }
      cells_.assign(count * count, {});
      std::size_t entries = 0;
      for (std::size_t f = 0; f < bounds.size() && (entries <= 16 * faces.size() || count <= 1); ++f)
        for_cells(bounds[f], [&](std::vector<std::uint32_t>& cell) { cell.push_back(static_cast<std::uint32_t>(f)), ++entries; });
      if (entries <= 16 * faces.size() || count <= 1) return;
    }
  }
  template <class Visit>
  void visit(const Bounds& around, Visit visit_face) {
    ++query_;
    for_cells(around, [&](const std::vector<std::uint32_t>& cell) {
      for (const std::uint32_t f : cell) {
        if (seen_[f] == query_) continue;
        seen_[f] = query_;
        const Bounds& b = bounds_[f];
        if (b.low[0] <= around.high[0] && b.low[1] <= around.high[1] && around.low[0] <= b.high[0] && around.low[1] <= b.high[1])
          visit_face(faces_[f]);
      }
    });
  }

 private:
  template <class Visit>
  void for_cells(const Bounds& b, Visit visit_cell) {
    const auto cell = [this](std::size_t axis, std::int64_t at) {
      return static_cast<std::size_t>(std::upper_bound(lines_[axis].begin(), lines_[axis].end(), at) - lines_[axis].begin());
    };
    for (std::size_t row = cell(1, b.low[1]); row <= cell(1, b.high[1]); ++row)
      for (std::size_t column = cell(0, b.low[0]); column <= cell(0, b.high[0]); ++column) visit_cell(cells_[row * (lines_[0].size() + 1) + column]);
  }

  std::vector<Bounds> bounds_;
  std::vector<std::uint32_t> faces_;
  std::array<std::vector<std::int64_t>, 2> lines_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<std::uint64_t> seen_;  // by face: the last query that found it
  std::uint64_t query_ = 0;
};

struct Place {
  std::int64_t over = 0;
  std::int64_t under = 1;
};

struct Claim {
  static constexpr std::uint32_t behind = ~0U;

  std::size_t line = 0;
  Place low;
  Place high;
  std::uint32_t face = 0;
};

enum class Reason { claims, turned, point };

struct Edge {
  std::size_t line = 0;  // 0: none
  bool fractional = false;
  std::array<std::uint32_t, 2> ends{};              // vertices; of an intersection, faces
  std::array<std::array<Integer, 4>, 2> points{};   // of an intersection: x, y, z over a weight
  std::vector<std::uint32_t> surfaces;              // whose faces do not hide it
  std::vector<std::uint32_t> faces;                 // that have it as a side, or lie on it
  Reason reason = Reason::claims;
  std::array<std::vector<Claim>, 2> claims;  // left, right
};

class Checker {
 public:
  explicit Checker(std::string_view text) : rest_(text) {}

  Verdict check() {
    try {
      read();
    } catch (const Fault& fault) {
      verdict_.kind = fault.malformed ? Verdict::Kind::malformed : Verdict::Kind::refuted;
      verdict_.line = fault.line;
      verdict_.reason = fault.reason;
    }
    return verdict_;
  }

 private:
  // --- Format

  [[noreturn]] void malformed(const std::string& reason) const { throw Fault{line_, reason, true}; }
  [[noreturn]] static void refute(std::size_t line, const std::string& reason) { throw Fault{line, reason, false}; }

  // The next line, divided at blanks.
  void next_line() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) malformed("expected a line that ends with a line feed");
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    words_.clear();
    for (std::size_t blank = 0; blank != std::string_view::npos; line.remove_prefix(blank + 1)) {
      blank = line.find(' ');
      words_.push_back(line.substr(0, blank));
      if (blank == std::string_view::npos) break;
    }
  }
  [[nodiscard]] bool is(std::string_view keyword) const { return words_[0] == keyword; }
  void expect_words(std::size_t count) const {
    if (words_.size() != count) malformed("expected " + std::to_string(count) + " words");
  }
  [[nodiscard]] std::int64_t number(std::string_view word, std::int64_t least, std::int64_t most) const {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < least || value > most)
      malformed("expected a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", found \"" + std::string(word) + '"');
    return value;
  }
  [[nodiscard]] std::uint32_t index(std::string_view word, std::size_t count) const {
    return static_cast<std::uint32_t>(number(word, 0, static_cast<std::int64_t>(count) - 1));
  }
  [[nodiscard]] Point point(std::int64_t limit) const {
    expect_words(4);
    return {number(words_[1], -limit, limit), number(words_[2], -limit, limit), number(words_[3], -limit, limit)};
  }
  [[nodiscard]] Place place(std::string_view word) const {
    constexpr std::int64_t limit = (std::int64_t{1} << 62) - 1;
    const std::size_t bar = std::min(word.find('/'), word.size());
    const std::int64_t under = number(word.substr(std::min(bar + 1, word.size())), 1, limit);
    return {number(word.substr(0, bar), 0, under), under};
  }

  void read() {
    constexpr std::int64_t most_coordinate = (1 << 18) - 1;
    constexpr std::int64_t most_direction = (1 << 15) - 1;
    const auto expect = [this](std::string_view keyword) {
      next_line();
      if (!is(keyword)) malformed("expected \"" + std::string(keyword) + '"');
    };
    expect("sightline-certificate");
    if (words_.size() != 2 || words_[1] != "1") malformed("expected version 1");
    expect("view");
    scene_.perspective = words_.size() == 2 && words_[1] == "perspective";
    if (words_.size() != 2 || (!scene_.perspective && words_[1] != "parallel")) malformed("expected perspective or parallel");
    expect("eye");
    scene_.eye = point(most_coordinate);
    for (const auto& [keyword, axis] : {std::pair{"forward", 2}, std::pair{"right", 0}, std::pair{"up", 1}}) {
      expect(keyword);
      scene_.axes[static_cast<std::size_t>(axis)] = point(most_direction);
    }
    const auto& [right, up, forward] = scene_.axes;
    if (dot(right, up) != 0 || dot(right, forward) != 0 || dot(up, forward) != 0 || dot(right, right) == 0 || dot(up, up) == 0 || dot(forward, forward) == 0)
      malformed("expected three directions at right angles");
    for (next_line(); is("vertex"); next_line()) {
      const Point p = point(most_coordinate);
      scene_.points.push_back({p[0] - scene_.eye[0], p[1] - scene_.eye[1], p[2] - scene_.eye[2]});
    }
    while (is("solid") || is("sheet")) read_body();
    prepare();
    for (; !is("end"); next_line()) {
      if (is("edge") || is("wire") || is("intersection")) {
        check_edge();
        begin_edge();
      } else if (edge_.line == 0) {
        malformed("expected an edge");
      } else {
        read_reason();
      }
    }
    check_edge();
    if (words_.size() != 1 || !rest_.empty()) malformed("expected nothing after \"end\"");
  }

  void read_body() {
    const bool sheet = is("sheet");
    const std::size_t line = line_;
    expect_words(1);
    const std::size_t first = scene_.faces.size();
    for (next_line(); is("face"); next_line()) read_face(sheet);
    if (scene_.faces.size() == first) malformed("expected a face");
    if (!sheet) check_solid(line, first);
  }

  void read_face(bool sheet) {
    if (words_.size() < 5) malformed("expected a surface and three corners or more");
    Face face;
    face.sheet = sheet;
    face.surface = index(words_[1], INT32_MAX);
    face.first = scene_.corners.size();
    std::size_t ring = face.first;
    for (std::size_t w = 2; w <= words_.size(); ++w) {
      if (w < words_.size() && words_[w] != "/") {
        scene_.corners.push_back({index(words_[w], scene_.points.size())});
        continue;
      }
      if (scene_.corners.size() < ring + 3) malformed("expected three corners or more in each ring");
      scene_.corners.back().last = true;
      ring = scene_.corners.size();
    }
    face.end = ring;
    const Point on = scene_.point(face.first);
    Vector<Int128> area{};
    scene_.for_sides(face, [&](std::size_t i, std::size_t next) {
      const auto [p, q] = std::array{scene_.corners[i].vertex, scene_.corners[next].vertex};
      if (p == q) malformed("a side from a vertex to itself");
      scene_.sides.push_back({std::min(p, q), std::max(p, q), p < q, static_cast<std::uint32_t>(scene_.faces.size())});
      const Point part = cross(combination<std::int64_t>(1, scene_.points[p], 1, on), combination<std::int64_t>(1, scene_.points[q], 1, on));
      for (std::size_t axis = 0; axis < 3; ++axis) area[axis] += part[axis];
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (area[axis] >= Int128{1} << 39 || -area[axis] >= Int128{1} << 39) malformed("a face larger than the limits of coordinates allow");
      face.normal[axis] = static_cast<std::int64_t>(area[axis]);
    }
    if (face.normal == Point{}) malformed("a face without an area");
    for (std::size_t i = face.first; i < face.end; ++i)
      if (dot(face.normal, combination<std::int64_t>(1, scene_.point(i), 1, on)) != 0) refute(line_, "the corners of the face are not in one plane");
    scene_.faces.push_back(face);
  }

  // Every edge of a solid belongs to two faces, which pass it in opposite directions, and its faces enclose a volume.
  void check_solid(std::size_t line, std::size_t first) const {
    const std::uint32_t first_face = static_cast<std::uint32_t>(first);
    std::vector<Side> sides;
    for (std::size_t s = scene_.sides.size(); s-- > 0 && scene_.sides[s].face >= first_face;) sides.push_back(scene_.sides[s]);
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    for (std::size_t s = 0; s < sides.size(); s += 2) {
      const auto same = [&](std::size_t other) { return other < sides.size() && sides[other].low == sides[s].low && sides[other].high == sides[s].high; };
      if (!same(s + 1) || same(s + 2) || sides[s].upwards == sides[s + 1].upwards)
        refute(line, "the solid is not closed at vertices " + std::to_string(sides[s].low) + " and " + std::to_string(sides[s].high));
    }
    Int128 volume = 0;
    for (std::size_t f = first; f < scene_.faces.size(); ++f) volume += dot(scene_.faces[f].normal, scene_.point(scene_.faces[f].first));
    if (volume <= 0) refute(line, "the faces of the solid are turned inwards");
  }

  // What all edges need of the scene: which faces occlude, which surfaces are turned away, and where faces are seen.
  void prepare() {
    std::sort(scene_.sides.begin(), scene_.sides.end(), [](const Side& a, const Side& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    std::uint32_t surfaces = 0;
    for (const Face& face : scene_.faces) surfaces = std::max(surfaces, face.surface + 1);
    if (surfaces > scene_.faces.size()) malformed("expected numbers of surfaces below the number of faces");
    std::vector<Vector<Int128>> normals(surfaces);
    for (const Face& face : scene_.faces)
      for (std::size_t axis = 0; axis < 3; ++axis) normals[face.surface][axis] += face.normal[axis];
    scene_.turned.assign(surfaces, 0);
    const Point& forward = scene_.axes[2];
    std::vector<Bounds> bounds;
    std::vector<std::uint32_t> occluders;
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
      Face& face = scene_.faces[f];
      const std::int64_t away = dot(face.normal, scene_.perspective ? scene_.point(face.first) : forward);
      face.occludes = away < 0 || (away > 0 && face.sheet);
      face.nearest = INT64_MAX;
      std::int64_t farthest = INT64_MIN;
      Bounds around;
      for (std::size_t i = face.first; i < face.end; ++i) {
        const Point& p = scene_.point(i);
        around.add(scene_, as<Int128>(p), Int128{1});
        face.nearest = std::min(face.nearest, dot(forward, p));
        farthest = std::max(farthest, dot(forward, p));
        if (dot(normals[face.surface], as<Int128>(scene_.perspective ? p : forward)) >= 0) scene_.turned[face.surface] = 1;
      }
      if (!face.occludes || (scene_.perspective && farthest <= 0)) continue;
      bounds.push_back(around);
      occluders.push_back(f);
    }
    near_.build(bounds, occluders);
  }

  void begin_edge() {
    edge_ = {};
    edge_.line = line_;
    edge_.fractional = is("intersection");
    const std::size_t ends = edge_.fractional ? 11 : 3;
    if (words_.size() != ends && (words_.size() < ends + 2 || words_[ends] != "on")) malformed("expected " + std::to_string(ends) + " words, or \"on\" and surfaces after them");
    const std::size_t count = edge_.fractional ? scene_.faces.size() : scene_.points.size();
    edge_.ends = {index(words_[1], count), index(words_[2], count)};
    if (edge_.fractional) {
      for (std::size_t i = 0; i < 8; ++i) {
        const std::string word(words_[3 + i]);
        if (word.size() > 40 || edge_.points[i / 4][i % 4].set_str(word, 10) != 0) malformed("expected a whole number of at most 40 digits, found \"" + word + '"');
      }
      for (auto& p : edge_.points) {
        if (p[3] <= 0) malformed("expected a positive denominator");
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= p[3] * scene_.eye[axis];
      }
      edge_.faces = {edge_.ends[0], edge_.ends[1]};
    } else {
      if (edge_.ends[0] >= edge_.ends[1]) malformed("expected the lower vertex first");
      const auto before = [](const Side& side, const std::array<std::uint32_t, 2>& vertices) { return std::tie(side.low, side.high) < std::tie(vertices[0], vertices[1]); };
      for (auto side = std::lower_bound(scene_.sides.begin(), scene_.sides.end(), edge_.ends, before);
           side != scene_.sides.end() && side->low == edge_.ends[0] && side->high == edge_.ends[1]; ++side)
        edge_.faces.push_back(side->face);
      if (is("edge") && edge_.faces.empty()) malformed("expected two vertices that are joined by a side of a face");
    }
    if (edge_.line > 0 && !(last_ < std::pair(edge_.fractional, edge_.ends)) && !edge_.fractional) malformed("expected edges in ascending order, then intersections");
    last_ = {edge_.fractional, edge_.ends};
    for (std::size_t w = ends + 1; w < words_.size(); ++w) {
      edge_.surfaces.push_back(index(words_[w], scene_.turned.size()));
      if (!is("wire") && std::none_of(edge_.faces.begin(), edge_.faces.end(), [&](std::uint32_t f) { return scene_.faces[f].surface == edge_.surfaces.back(); }))
        malformed("expected the surface of a face at the edge, found " + std::string(words_[w]));
    }
  }

  void read_reason() {
    const bool whole = is("turned") || is("point");
    if (edge_.reason != Reason::claims || (whole && !(edge_.claims[0].empty() && edge_.claims[1].empty()))) malformed("an edge that is hidden as a whole has no other reasons");
    if (whole) {
      expect_words(1);
      edge_.reason = is("turned") ? Reason::turned : Reason::point;
      return;
    }
    const bool behind = is("behind");
    if (!behind && !is("left") && !is("right") && !is("both")) malformed("expected left, right, both, behind, turned, point, edge, wire, intersection or end");
    expect_words(behind ? 3 : 4);
    const Claim claim{line_, place(words_[1]), place(words_[2]), behind ? Claim::behind : index(words_[3], scene_.faces.size())};
    const auto compare = [](const Place& a, const Place& b) { return Int128{a.over} * b.under < Int128{b.over} * a.under; };
    if (!compare(claim.low, claim.high)) malformed("expected the lower end of the interval first");
    for (std::size_t side = 0; side < 2; ++side) {
      if ((side == 0 && is("right")) || (side == 1 && is("left"))) continue;
      auto& claims = edge_.claims[side];
      if (!claims.empty() && compare(claim.low, claims.back().low)) malformed("expected intervals in ascending order");
      claims.push_back(claim);
    }
  }

  // --- Proof

  void check_edge() {
    if (edge_.line == 0) return;
    ++verdict_.edges;
    if (!edge_.fractional) {
      check_edge<Int128>(as<Int128>(scene_.points[edge_.ends[0]]), as<Int128>(scene_.points[edge_.ends[1]]), 1);
      return;
    }
    const auto& [p, q] = edge_.points;
    const Vector<Integer> a{p[0] * q[3], p[1] * q[3], p[2] * q[3]};
    const Vector<Integer> b{q[0] * p[3], q[1] * p[3], q[2] * p[3]};
    const Integer w = p[3] * q[3];
    for (const std::uint32_t f : edge_.ends) check_lies_in(scene_.faces[f], a, b, w);
    check_edge<Integer>(a, b, w);
  }

  // The line lies in a face if, seen at right angles and moved beyond the face, it is hidden by it from either side.
  void check_lies_in(const Face& face, const Vector<Integer>& a, const Vector<Integer>& b, const Integer& w) const {
    const Vector<Integer> normal = as<Integer>(face.normal);
    const Integer offset = w * dot(normal, as<Integer>(scene_.point(face.first)));
    const Sight<Integer> sight(false, normal, combination<Integer>(1, a, -w, normal), combination<Integer>(1, b, -w, normal), w);
    bool within = dot(normal, a) == offset && dot(normal, b) == offset && !sight.is_point();
    for (const bool left : {true, false}) {
      Fraction<Integer> reach{0, 1};
      for (const auto& interval : shadows(sight, scene_, face, left))
        if (!(reach < interval.low)) reach = std::max(reach, interval.high);
      if (within && !(reach < Fraction<Integer>{1, 1})) return;
    }
    refute(edge_.line, "the intersection is not a line in both faces");
  }

  template <class N>
  void check_edge(const Vector<N>& a, const Vector<N>& b, const N& w) {
    const Vector<N> forward = as<N>(scene_.axes[2]);
    const Sight<N> sight(scene_.perspective, forward, a, b, w);
    if (edge_.reason == Reason::turned) {
      // A solid hides a line on one of its faces that is turned away; the other face of an intersection may belong to
      // another solid.
      const auto is_away = [this](std::uint32_t f) { return !scene_.faces[f].sheet && scene_.turned[scene_.faces[f].surface] != 0; };
      if (edge_.faces.empty() || (edge_.fractional ? std::none_of(edge_.faces.begin(), edge_.faces.end(), is_away) : !std::all_of(edge_.faces.begin(), edge_.faces.end(), is_away)))
        refute(edge_.line, "the edge has a face that is turned to the eye, or of a sheet");
      ++verdict_.hidden;
      return;
    }
    if (sight.is_point() != (edge_.reason == Reason::point)) refute(edge_.line, sight.is_point() ? "the edge is seen as a point" : "the edge is not seen as a point");
    if (edge_.reason == Reason::point) {
      ++verdict_.hidden;
      return;
    }
    const N from = scene_.perspective ? dot(forward, a) : N(1);
    const N to = scene_.perspective ? dot(forward, b) : N(1);
    std::array<std::vector<Interval<N>>, 2> gaps;
    for (std::size_t side = 0; side < 2; ++side) {
      for (const Claim& claim : edge_.claims[side]) check_claim(sight, claim, side == 0, from, to);
      gaps[side] = gaps_of<N>(edge_.claims[side]);
      for (const Interval<N>& gap : gaps[side])
        for (const Fraction<N>& s : {gap.low, gap.high})
          if (from * (s.under - s.over) + to * s.over < 0) refute(edge_.line, "a part behind the eye is claimed to be visible");
    }
    count<N>(gaps);
    if (gaps[0].empty() && gaps[1].empty()) return;
    if (scene_.perspective && from <= 0 && to <= 0) refute(edge_.line, "an edge behind the eye is claimed to be visible");
    const N farthest = std::max(dot(forward, a), dot(forward, b));
    Bounds bounds;
    bounds.add(scene_, a, w);
    bounds.add(scene_, b, w);
    near_.visit(bounds, [&](std::uint32_t f) {
      const Face& face = scene_.faces[f];
      if (w * N(face.nearest) >= farthest || is_own(face)) return;
      for (std::size_t side = 0; side < 2; ++side) {
        if (gaps[side].empty()) continue;
        for (Interval<N> shadow : shadows(sight, scene_, face, side == 0))
          for (const Interval<N>& gap : gaps[side])
            if (std::max(shadow.low, gap.low) < std::min(shadow.high, gap.high))
              refute(edge_.line, "face " + std::to_string(f) + " hides a part that is claimed to be visible from the " + (side == 0 ? "left" : "right"));
      }
    });
  }

  [[nodiscard]] bool is_own(const Face& face) const {
    return std::find(edge_.surfaces.begin(), edge_.surfaces.end(), face.surface) != edge_.surfaces.end();
  }

  // An interval, without 2^-60 at each end if these are rounded.
  template <class N>
  static Interval<N> interval_of(const Place& low, const Place& high) {
    Interval<N> interval{{N(low.over), N(low.under)}, {N(high.over), N(high.under)}};
    if constexpr (std::is_same_v<N, Integer>) {
      const Integer parts = Integer(1) << 60;
      interval.low = {interval.low.over * parts + interval.low.under, interval.low.under * parts};
      interval.high = {interval.high.over * parts - interval.high.under, interval.high.under * parts};
    }
    return interval;
  }

  template <class N>
  void check_claim(const Sight<N>& sight, const Claim& claim, bool left, const N& from, const N& to) const {
    const Interval<N> interval = interval_of<N>(claim.low, claim.high);
    if (interval.empty()) return;
    if (claim.face == Claim::behind) {
      for (const Fraction<N>& s : {interval.low, interval.high})
        if (from * (s.under - s.over) + to * s.over > 0) refute(claim.line, "the interval is not behind the eye");
      return;
    }
    const Face& face = scene_.faces[claim.face];
    if (!face.occludes) refute(claim.line, "the face is seen edge-on, or belongs to a solid and is turned away");
    if (is_own(face)) refute(claim.line, "the face is of a surface of the edge");
    for (const Interval<N>& shadow : shadows(sight, scene_, face, left))
      if (!(interval.low < shadow.low) && !(shadow.high < interval.high)) return;
    refute(claim.line, "the face does not hide the interval");
  }

  // What no claim covers.
  template <class N>
  static std::vector<Interval<N>> gaps_of(const std::vector<Claim>& claims) {
    std::vector<Interval<N>> gaps;
    Place reach{0, 1};
    const auto end_gap = [&](const Place& at) {
      const Interval<N> gap = interval_of<N>(reach, at);
      if (!gap.empty()) gaps.push_back(gap);
    };
    for (const Claim& claim : claims) {
      end_gap(claim.low);
      if (Int128{reach.over} * claim.high.under < Int128{claim.high.over} * reach.under) reach = claim.high;
    }
    end_gap({1, 1});
    return gaps;
  }

  // Adds the visible and the hidden intervals: visible is what either side leaves.
  template <class N>
  void count(const std::array<std::vector<Interval<N>>, 2>& gaps) {
    std::vector<Interval<N>> seen = gaps[0];
    seen.insert(seen.end(), gaps[1].begin(), gaps[1].end());
    std::sort(seen.begin(), seen.end(), [](const Interval<N>& a, const Interval<N>& b) { return a.low < b.low; });
    Fraction<N> reach{0, 1};
    bool first = true;
    for (const Interval<N>& interval : seen) {
      if (reach < interval.low) ++verdict_.hidden;
      if (first || reach < interval.low) ++verdict_.visible;
      reach = std::max(reach, interval.high);
      first = false;
    }
    if (reach < Fraction<N>{1, 1}) ++verdict_.hidden;
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
  Scene scene_;
  NearFaces near_;
  Edge edge_;
  std::pair<bool, std::array<std::uint32_t, 2>> last_{false, {0, 0}};
  Verdict verdict_;
};

}  // namespace

Verdict verify(std::string_view certificate) { return Checker(certificate).check(); }

std::string sentence(const Verdict& verdict) {
  if (verdict.kind != Verdict::Kind::proved) return "line " + std::to_string(verdict.line) + ": " + verdict.reason;
  return "proved: " + std::to_string(verdict.edges) + " edges, " + std::to_string(verdict.visible) + " visible intervals, " + std::to_string(verdict.hidden) + " hidden";
}

}  // namespace sightline::verifier
