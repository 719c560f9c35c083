#include "tools/verify/verify.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <type_traits>
#include <vector>

namespace sightline::verifier {
namespace {

// Edges between vertices are checked in 128 bits: points relative to the eye are below 2^19, and no product reaches 2^124
// (README.md, "Sizes"). Intersections, whose ends are fractions, are checked by the same code in integers of any size.
__extension__ typedef __int128 Int128;
using Integer = mpz_class;
using Index = std::uint32_t;

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
// m a - n b
template <class N>
Vector<N> combination(const N& m, const Vector<N>& a, const N& n, const Vector<N>& b) {
  return {N(m * a[0] - n * b[0]), N(m * a[1] - n * b[1]), N(m * a[2] - n * b[2])};
}
Point difference(const Point& a, const Point& b) { return combination<std::int64_t>(1, a, 1, b); }
template <class N>
Vector<N> as(const Point& p) {
  return {N(p[0]), N(p[1]), N(p[2])};
}

template <class N>
struct Fraction {
  N over;
  N under;  // positive

  friend bool operator<(const Fraction& a, const Fraction& b) { return a.over * b.under < b.over * a.under; }
};

// An open part of an edge, whose points are (1 - s) from + s to.
template <class N>
struct Interval {
  Fraction<N> low{0, 1};
  Fraction<N> high{1, 1};

  [[nodiscard]] bool empty() const { return !(low < high); }
  // Keeps the part where a quantity is positive that is linear along the edge.
  void keep_positive(const N& at_from, const N& at_to) {
    if (at_from <= 0 && at_to <= 0) high = low;
    if (at_from < 0 && at_to > 0) low = std::max(low, Fraction<N>{N(-at_from), N(at_to - at_from)});
    if (at_from > 0 && at_to < 0) high = std::min(high, Fraction<N>{at_from, N(at_from - at_to)});
  }
};

struct Face {
  std::vector<std::array<Index, 2>> sides;  // of all rings: vertex and next vertex
  Point on{};
  Point normal{};
  Index surface = 0;
  bool sheet = false;
  bool occludes = false;     // of a sheet not seen edge-on, or of a solid and turned to the eye
  std::int64_t nearest = 0;  // in the direction of sight
};

struct Scene {
  bool perspective = false;
  Point eye{};
  Point forward{};
  std::array<Point, 2> axes{};  // right, up
  std::vector<Point> points;    // relative to the eye
  std::vector<Face> faces;
};

// The plane through the eye and an edge from a/w to b/w.
template <class N>
struct SightPlane {
  bool perspective;
  Vector<N> forward, a, b;
  N w;
  Vector<N> normal;      // to the left
  std::size_t axis = 0;  // along which the normal is not 0; 3: the edge is seen as a point

  SightPlane(bool in_perspective, const Vector<N>& direction, const Vector<N>& from, const Vector<N>& to, const N& weight)
      : perspective(in_perspective), forward(direction), a(from), b(to), w(weight) {
    normal = perspective ? cross(a, b) : cross(forward, combination<N>(1, b, 1, a));
    while (axis < 3 && normal[axis] == 0) ++axis;
  }
  [[nodiscard]] N left(const Vector<N>& p) const {
    return perspective ? N(dot(normal, p)) : N(w * dot(normal, p) - dot(normal, a));
  }
  // A point x/v of the plane is seen in the direction of (1 - s) a + s b for 1 - s : s as the two numbers returned.
  [[nodiscard]] std::array<N, 2> direction(const Vector<N>& x, const N& v) const {
    if (perspective) return {N(cross(x, b)[axis] / normal[axis]), N(cross(a, x)[axis] / normal[axis])};
    const N s = cross(combination<N>(v, a, w, x), forward)[axis] / normal[axis];
    return {N(v - s), s};
  }
};

// The intervals of an edge that a face hides from one side. The plane of sight, moved a little to that side, cuts the face
// in segments. A segment hides what is seen between its ends and is beyond the plane of the face.
template <class N>
std::vector<Interval<N>> hidden_by(const Face& face, const SightPlane<N>& sight, const Scene& scene, bool from_left) {
  std::vector<std::array<N, 2>> cuts;
  for (const auto& [i, next] : face.sides) {
    Vector<N> p = as<N>(scene.points[i]), q = as<N>(scene.points[next]);
    N at_p = sight.left(p), at_q = sight.left(q);
    if (from_left ? (at_p > 0) == (at_q > 0) : (at_p >= 0) == (at_q >= 0)) continue;
    if (at_p > at_q) std::swap(p, q), std::swap(at_p, at_q);
    cuts.push_back(sight.direction(combination(at_q, p, at_p, q), N(at_q - at_p)));
  }
  std::sort(cuts.begin(), cuts.end(), [](const auto& c, const auto& d) { return c[0] * d[1] > c[1] * d[0]; });
  const Vector<N> normal = as<N>(face.normal);
  const N offset = dot(normal, as<N>(face.on));
  const N away = sight.perspective ? offset : dot(normal, sight.forward);
  const N turn = away > 0 ? 1 : -1;
  const N from = turn * (dot(normal, sight.a) - sight.w * offset), to = turn * (dot(normal, sight.b) - sight.w * offset);
  std::vector<Interval<N>> hidden;
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
    Interval<N> interval;
    interval.keep_positive(N(-cuts[i][1]), cuts[i][0]);
    interval.keep_positive(cuts[i + 1][1], N(-cuts[i + 1][0]));
    interval.keep_positive(from, to);
    if (!interval.empty()) hidden.push_back(interval);
  }
  return hidden;
}

// A rectangle of the image in fixed point: where a face or an edge is seen. What is partly behind the eye is everywhere.
struct Bounds {
  std::array<std::int64_t, 2> low{INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN};

  template <class N>
  void add(const Scene& scene, const Vector<N>& x, const N& w) {
    const N depth = scene.perspective ? dot(as<N>(scene.forward), x) : w;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const N over = dot(as<N>(scene.axes[axis]), x) * (std::int64_t{1} << 24);
      N step = depth > 0 ? N(over / depth) : N(0);
      if (step * depth > over) step -= 1;  // rounded down, which keeps the order
      const N limit = INT64_MAX;
      low[axis] = std::min(low[axis], depth <= 0 || step < -limit ? INT64_MIN : to_int64(N(std::min(step, limit))));
      high[axis] = std::max(high[axis], depth <= 0 || step > limit ? INT64_MAX : to_int64(N(std::max(step, N(-limit)))));
    }
  }
  static std::int64_t to_int64(const Integer& n) { return n.get_si(); }
  static std::int64_t to_int64(Int128 n) { return static_cast<std::int64_t>(n); }
};

struct SeenFace {
  Bounds bounds;
  Index face;
  std::int64_t reach;  // the highest end, on axis 0, of this face and those before it
};

constexpr Index behind_eye = ~0U;

struct Claim {
  std::size_t line;
  Fraction<Int128> low, high;
  Index face;  // or behind_eye
};

struct Edge {
  std::size_t line = 0;
  std::optional<std::array<std::array<Integer, 4>, 2>> points;  // of an intersection: x, y, z over a weight
  std::array<Index, 2> ends{};                                  // vertices; of an intersection, faces
  std::vector<Index> faces;                                     // of which it is a side, or in which it lies
  std::set<Index> surfaces;                                     // their faces do not hide it
  bool turned = false, point = false;
  std::array<std::vector<Claim>, 2> claims;  // left, right
};

class Checker {
 public:
  explicit Checker(std::string_view text) : rest_(text) {}

  Verdict check() {
    try {
      read_scene();
      prepare();
      for (; word_ == "edge" || word_ == "wire" || word_ == "intersection"; ++verdict_.edges) check(read_edge());
      require(word_ == "end" && rest_ == "\n", "expected an edge, a wire, an intersection or the end");
    } catch (const Verdict& fault) {
      return fault;
    }
    return verdict_;
  }

 private:
  static void prove(bool is_true, std::size_t line, const std::string& reason) {
    if (!is_true) throw Verdict{.kind = Verdict::Kind::refuted, .line = line, .reason = reason};
  }
  void require(bool is_so, const std::string& reason) const {
    if (!is_so) throw Verdict{.kind = Verdict::Kind::malformed, .line = line_, .reason = reason};
  }

  // --- Format. `word_` is the first word of the line that is read next.

  [[nodiscard]] bool at_end_of_line() const { return rest_.starts_with('\n'); }
  std::string_view word() {
    require(rest_.starts_with(' '), "expected another word");
    rest_.remove_prefix(1);
    const std::string_view found = rest_.substr(0, rest_.find_first_of(" \n"));
    rest_.remove_prefix(found.size());
    return found;
  }
  void next_line() {
    require(at_end_of_line(), "expected the end of the line");
    ++line_;
    rest_.remove_prefix(1);
    word_ = rest_.substr(0, rest_.find_first_of(" \n"));
    rest_.remove_prefix(word_.size());
  }
  std::int64_t number(std::string_view digits, std::int64_t least, std::int64_t most) const {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < least || value > most)
      require(false, "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value;
  }
  Index index(std::size_t count) { return static_cast<Index>(number(word(), 0, static_cast<std::int64_t>(count) - 1)); }
  Point point(unsigned bits) {
    const std::int64_t most = (std::int64_t{1} << bits) - 1;
    const std::int64_t x = number(word(), -most, most), y = number(word(), -most, most);
    return {x, y, number(word(), -most, most)};
  }
  Fraction<Int128> fraction() {
    const std::string_view text = word();
    const std::size_t bar = text.find('/');
    require(bar != std::string_view::npos, "expected a fraction");
    const std::int64_t under = number(text.substr(bar + 1), 1, (std::int64_t{1} << 62) - 1);
    return {number(text.substr(0, bar), 0, under), under};
  }

  void read_scene() {
    word_ = "sightline-certificate";
    require(rest_.starts_with("sightline-certificate 1\n"), "expected \"sightline-certificate 1\"");
    rest_.remove_prefix(word_.size() + 2);
    next_line();
    const auto field = [this](std::string_view name) { require(word_ == name, "expected " + std::string(name)); };
    field("view");
    const std::string_view projection = word();
    scene_.perspective = projection == "perspective";
    require(scene_.perspective || projection == "parallel", "expected perspective or parallel");
    using Field = std::tuple<const char*, Point*, unsigned>;
    for (const auto& [name, value, bits] : {Field{"eye", &scene_.eye, 18}, Field{"forward", &scene_.forward, 15},
                                            Field{"rightward", &scene_.axes[0], 15}, Field{"upward", &scene_.axes[1], 15}}) {
      next_line();
      field(name);
      *value = point(bits);
    }
    require(dot(scene_.forward, cross(scene_.axes[0], scene_.axes[1])) != 0, "expected directions that are not in one plane");
    for (next_line(); word_ == "vertex"; next_line()) scene_.points.push_back(difference(point(18), scene_.eye));
    while (word_ == "solid" || word_ == "sheet") read_body();
  }

  // Each side of a solid is passed once in each direction, and the faces enclose a volume.
  void read_body() {
    const bool sheet = word_ == "sheet";
    const std::size_t line = line_;
    std::set<std::array<Index, 2>> passed;
    Int128 volume = 0;
    for (next_line(); word_ == "face"; next_line()) {
      const Face& face = scene_.faces.emplace_back(read_face(sheet));
      volume += dot(face.normal, face.on);
      for (const auto& [i, next] : face.sides) {
        prove(passed.insert({i, next}).second || sheet, line_, "the solid passes a side twice in one direction");
        sides_[{std::min(i, next), std::max(i, next)}].push_back(static_cast<Index>(scene_.faces.size() - 1));
      }
    }
    const auto is_closed = [&](const std::array<Index, 2>& side) { return passed.contains({side[1], side[0]}); };
    const bool is_solid = std::all_of(passed.begin(), passed.end(), is_closed) && volume > 0;
    prove(sheet || is_solid, line, "the solid is not closed, or turned inside out");
  }

  Face read_face(bool sheet) {
    Face face;
    face.sheet = sheet;
    face.surface = index(1U << 31);
    for (bool another_ring = true; another_ring;) {
      const std::size_t first = face.sides.size();
      for (another_ring = false; !at_end_of_line() && !another_ring;) {
        another_ring = rest_.starts_with(" / ");
        if (another_ring) word();
        else face.sides.push_back({index(scene_.points.size()), 0});
      }
      require(face.sides.size() >= first + 3, "expected three corners or more");
      for (std::size_t i = first; i < face.sides.size(); ++i)
        face.sides[i][1] = face.sides[i + 1 < face.sides.size() ? i + 1 : first][0];
    }
    face.on = scene_.points[face.sides[0][0]];
    const auto from_first = [&](Index vertex) { return difference(scene_.points[vertex], face.on); };
    Vector<Int128> area{};
    for (const auto& [i, next] : face.sides) {
      require(i != next, "expected different corners");
      area = combination<Int128>(1, area, -1, as<Int128>(cross(from_first(i), from_first(next))));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      require(-(Int128{1} << 39) < area[axis] && area[axis] < Int128{1} << 39, "expected a simple face");
      face.normal[axis] = static_cast<std::int64_t>(area[axis]);
    }
    require(face.normal != Point{}, "expected a face with an area");
    for (const auto& side : face.sides)
      prove(dot(face.normal, from_first(side[0])) == 0, line_, "the corners are not in one plane");
    return face;
  }

  Edge read_edge() {
    Edge edge;
    edge.line = line_;
    const bool wire = word_ == "wire", intersection = word_ == "intersection";
    const std::size_t count = intersection ? scene_.faces.size() : scene_.points.size();
    for (Index& end : edge.ends) end = index(count);
    if (intersection) {
      for (auto& p : edge.points.emplace()) {
        for (Integer& part : p) {
          const std::string digits(word());
          require(digits.size() <= 40 && part.set_str(digits, 10) == 0, "expected a whole number of at most 40 digits");
        }
        require(p[3] > 0, "expected a positive denominator");
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= p[3] * scene_.eye[axis];
      }
      edge.faces = {edge.ends[0], edge.ends[1]};
    } else {
      require(edge.ends[0] < edge.ends[1] && last_ < edge.ends, "expected edges in ascending order, the lower vertex first");
      last_ = edge.ends;
      if (const auto found = sides_.find(edge.ends); found != sides_.end()) edge.faces = found->second;
      require(wire || !edge.faces.empty(), "expected a side of a face");
    }
    if (!at_end_of_line()) require(word() == "on", "expected \"on\" and surfaces");
    while (!at_end_of_line()) {
      const Index surface = *edge.surfaces.insert(index(turned_.size())).first;
      const auto is_of = [&](Index face) { return scene_.faces[face].surface == surface; };
      require(wire || std::any_of(edge.faces.begin(), edge.faces.end(), is_of), "expected the surface of a face at the edge");
    }
    for (next_line(); word_ == "left" || word_ == "right" || word_ == "both"; next_line()) {
      const Fraction<Int128> low = fraction(), high = fraction();
      const bool behind = rest_.starts_with(" behind\n");
      const Claim claim{line_, low, high, behind ? behind_eye : index(scene_.faces.size())};
      if (behind) word();
      require(low < high, "expected the lower end of the interval first");
      for (std::size_t side = 0; side < 2; ++side) {
        if (word_ == (side == 0 ? "right" : "left")) continue;
        require(edge.claims[side].empty() || !(low < edge.claims[side].back().low), "expected intervals in ascending order");
        edge.claims[side].push_back(claim);
      }
    }
    edge.turned = word_ == "turned";
    edge.point = word_ == "point";
    if (!edge.turned && !edge.point) return edge;
    require(edge.claims[0].empty() && edge.claims[1].empty(), "expected no claims about an edge that is hidden as a whole");
    next_line();
    return edge;
  }

  // --- Proof

  void prepare() {
    Index surfaces = 0;
    for (const Face& face : scene_.faces) surfaces = std::max(surfaces, face.surface + 1);
    require(surfaces <= scene_.faces.size(), "expected numbers of surfaces below the number of faces");
    // A surface is seen like a plane through its largest face, at right angles to the sum of its normals.
    std::vector<Vector<Int128>> normals(surfaces);
    std::vector<std::pair<Int128, Point>> largest(surfaces);
    for (const Face& face : scene_.faces) {
      const Vector<Int128> normal = as<Int128>(face.normal);
      normals[face.surface] = combination<Int128>(1, normals[face.surface], -1, normal);
      if (dot(normal, normal) > largest[face.surface].first) largest[face.surface] = {dot(normal, normal), face.on};
    }
    for (Index s = 0; s < surfaces; ++s)
      turned_.push_back(dot(normals[s], as<Int128>(scene_.perspective ? largest[s].second : scene_.forward)) >= 0);
    for (Index f = 0; f < scene_.faces.size(); ++f) {
      Face& face = scene_.faces[f];
      const std::int64_t away = dot(face.normal, scene_.perspective ? face.on : scene_.forward);
      Bounds bounds;
      std::int64_t farthest = INT64_MIN;
      face.nearest = INT64_MAX;
      for (const auto& [i, next] : face.sides) {
        const Point& p = scene_.points[i];
        const std::int64_t depth = dot(scene_.forward, p);
        face.nearest = std::min(face.nearest, depth);
        farthest = std::max(farthest, depth);
        bounds.add<Int128>(scene_, as<Int128>(p), 1);
      }
      face.occludes = away < 0 || (away > 0 && face.sheet);
      if (face.occludes && (!scene_.perspective || farthest > 0)) seen_.push_back({bounds, f, INT64_MIN});
    }
    std::sort(seen_.begin(), seen_.end(), [](const SeenFace& a, const SeenFace& b) { return a.bounds.low[0] < b.bounds.low[0]; });
    std::int64_t reach = INT64_MIN;
    for (SeenFace& face : seen_) face.reach = reach = std::max(reach, face.bounds.high[0]);
  }

  void check(const Edge& edge) {
    const auto vertex = [&](std::size_t end) { return as<Int128>(scene_.points[edge.ends[end]]); };
    if (!edge.points) return check<Int128>(edge, vertex(0), vertex(1), 1);
    const auto& [p, q] = *edge.points;
    const Vector<Integer> a{p[0] * q[3], p[1] * q[3], p[2] * q[3]}, b{q[0] * p[3], q[1] * p[3], q[2] * p[3]};
    const Integer w = p[3] * q[3];
    for (const Index f : edge.faces)
      prove(lies_in(scene_.faces[f], a, b, w), edge.line, "the intersection does not lie in both faces");
    check<Integer>(edge, a, b, w);
  }

  // A line lies in a face if it is in its plane and, seen at right angles and moved beyond it, is hidden by it.
  bool lies_in(const Face& face, const Vector<Integer>& a, const Vector<Integer>& b, const Integer& w) const {
    const Vector<Integer> n = as<Integer>(face.normal);
    const Integer offset = w * dot(n, as<Integer>(face.on));
    const SightPlane<Integer> sight(false, n, combination<Integer>(1, a, -w, n), combination<Integer>(1, b, -w, n), w);
    bool within = false;
    for (std::size_t side = 0; side < 2 && sight.axis < 3; ++side) {
      Fraction<Integer> reach{0, 1};
      for (const Interval<Integer>& part : hidden_by(face, sight, scene_, side == 0))
        if (!(reach < part.low)) reach = std::max(reach, part.high);
      within = within || !(reach < Fraction<Integer>{1, 1});
    }
    return within && dot(n, a) == offset && dot(n, b) == offset;
  }

  template <class N>
  void check(const Edge& edge, const Vector<N>& a, const Vector<N>& b, const N& w) {
    const Vector<N> forward = as<N>(scene_.forward);
    const SightPlane<N> sight(scene_.perspective, forward, a, b, w);
    if (edge.turned || edge.point) {
      // A face that is turned away suffices for an intersection, which lies in it.
      const auto is_away = [this](Index f) { return !scene_.faces[f].sheet && turned_[scene_.faces[f].surface]; };
      const auto away = std::count_if(edge.faces.begin(), edge.faces.end(), is_away);
      prove(edge.point || (away > 0 && (edge.points || away == std::ssize(edge.faces))), edge.line,
            "a face at the edge is turned to the eye, or of a sheet");
      prove(edge.turned || sight.axis == 3, edge.line, "the edge is not seen as a point");
      ++verdict_.hidden;
      return;
    }
    prove(sight.axis < 3, edge.line, "the edge is seen as a point");
    // Distances before the eye: positive where it sees.
    const N from = scene_.perspective ? dot(forward, a) : N(1), to = scene_.perspective ? dot(forward, b) : N(1);
    const auto distance = [&](const Fraction<N>& s) { return N(from * (s.under - s.over) + to * s.over); };
    std::array<std::vector<Interval<N>>, 2> gaps;
    for (std::size_t side = 0; side < 2; ++side) {
      Fraction<Int128> reach{0, 1};
      const auto add_gap = [&](const Fraction<Int128>& low, const Fraction<Int128>& high) {
        if (const Interval<N> gap = interval<N>(low, high); !gap.empty()) gaps[side].push_back(gap);
      };
      for (const Claim& claim : edge.claims[side]) {
        add_gap(reach, claim.low);
        reach = std::max(reach, claim.high);
        const Interval<N> part = interval<N>(claim.low, claim.high);
        if (part.empty()) continue;
        if (claim.face == behind_eye) {
          prove(distance(part.low) <= 0 && distance(part.high) <= 0, claim.line, "the interval is not behind the eye");
          continue;
        }
        const Face& face = scene_.faces[claim.face];
        prove(face.occludes && !edge.surfaces.contains(face.surface), claim.line, "the face does not occlude the edge");
        const auto hidden = hidden_by(face, sight, scene_, side == 0);
        const auto covers = [&part](const Interval<N>& whole) { return !(part.low < whole.low) && !(whole.high < part.high); };
        prove(std::any_of(hidden.begin(), hidden.end(), covers), claim.line, "the face does not hide the interval");
      }
      add_gap(reach, {1, 1});
      for (const Interval<N>& gap : gaps[side])
        prove(distance(gap.low) >= 0 && distance(gap.high) >= 0 && (from > 0 || to > 0), edge.line,
              "a part is behind the eye and claimed to be visible");
    }
    count(gaps);
    if (gaps[0].empty() && gaps[1].empty()) return;
    const N farthest = std::max(dot(forward, a), dot(forward, b));
    Bounds bounds;
    bounds.add<N>(scene_, a, w);
    bounds.add<N>(scene_, b, w);
    // Only the faces whose images meet that of the edge can hide it.
    for (auto seen = std::partition_point(seen_.begin(), seen_.end(), [&](const SeenFace& f) { return f.reach < bounds.low[0]; });
         seen != seen_.end() && seen->bounds.low[0] <= bounds.high[0]; ++seen) {
      const Face& face = scene_.faces[seen->face];
      const Bounds& other = seen->bounds;
      if (other.high[0] < bounds.low[0] || other.high[1] < bounds.low[1] || bounds.high[1] < other.low[1]) continue;
      if (w * N(face.nearest) >= farthest || edge.surfaces.contains(face.surface)) continue;
      for (std::size_t side = 0; side < 2; ++side)
        for (const Interval<N>& gap : gaps[side])
          for (const Interval<N>& part : hidden_by(face, sight, scene_, side == 0))
            prove(!(std::max(part.low, gap.low) < std::min(part.high, gap.high)), edge.line,
                  "face " + std::to_string(seen->face) + " hides a part that is claimed to be visible from the " +
                      (side == 0 ? "left" : "right"));
    }
  }

  // The ends of parts of intersections are rounded: without 2^-60 at each end.
  template <class N>
  static Interval<N> interval(const Fraction<Int128>& low, const Fraction<Int128>& high) {
    if constexpr (std::is_same_v<N, Int128>) {
      return {low, high};
    } else {
      const auto moved = [](const Fraction<Int128>& f, int by) {
        const Integer over(static_cast<std::int64_t>(f.over)), under(static_cast<std::int64_t>(f.under));
        const Integer parts = Integer(1) << 60;
        return Fraction<Integer>{over * parts + by * under, under * parts};
      };
      return {moved(low, 1), moved(high, -1)};
    }
  }

  // A part is visible if it is visible from the left or from the right.
  template <class N>
  void count(const std::array<std::vector<Interval<N>>, 2>& gaps) {
    std::vector<Interval<N>> seen = gaps[0];
    seen.insert(seen.end(), gaps[1].begin(), gaps[1].end());
    std::sort(seen.begin(), seen.end(), [](const Interval<N>& a, const Interval<N>& b) { return a.low < b.low; });
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (i == 0 || seen[0].high < seen[i].low) ++verdict_.visible;
      seen[0].high = std::max(seen[0].high, seen[i].high);
    }
    if (seen.empty()) ++verdict_.hidden;
  }

  std::string_view rest_;
  std::string_view word_;
  std::size_t line_ = 1;
  Scene scene_;
  std::map<std::array<Index, 2>, std::vector<Index>> sides_;  // by vertices, the lower first: the faces there
  std::vector<bool> turned_;                                  // by surface: turned away from the eye, or edge-on
  std::vector<SeenFace> seen_;                                // ascending by the low end of axis 0
  std::array<Index, 2> last_{};                               // edge between vertices
  Verdict verdict_;
};

}  // namespace

Verdict verify(std::string_view certificate) { return Checker(certificate).check(); }

std::string sentence(const Verdict& verdict) {
  if (verdict.kind != Verdict::Kind::proved) return "line " + std::to_string(verdict.line) + ": " + verdict.reason;
  return "proved: " + std::to_string(verdict.edges) + " edges, " + std::to_string(verdict.visible) + " visible intervals, " +
         std::to_string(verdict.hidden) + " edges hidden";
}

}  // namespace sightline::verifier
