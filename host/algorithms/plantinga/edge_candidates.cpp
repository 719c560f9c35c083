#include "host/algorithms/plantinga/edge_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/algorithms/plantinga/near_forms.hpp"
#include "host/algorithms/plantinga/trace.hpp"

namespace sightline::algorithms::plantinga {
namespace {

template <class Listener>
class Gatherer {
 public:
  Gatherer(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge,
           const std::vector<Occluder>& occluders, Listener listener)
      : model_(model),
        occluders_(occluders),
        filter_(model, parts, edge, occluders),
        listener_(listener),
        edge_(edge),
        ends_(model.edges()[edge]),
        segment_(model.segment(edge)),
        level_(segment_.from[1] == segment_.to[1]) {
    for (const Occluder& occluder : occluders) {
      if (faces_.empty() || faces_.back() != occluder.face) faces_.push_back(occluder.face);
    }
  }

  std::vector<Direction> gather() {
    gather_lines();
    own_faces();
    for (const FaceIndex face : faces_) face_edge_on(face);
    for (const scene::VertexIndex vertex : vertices_) vertex_on_edge(vertex);
    for (const Line& line : lines_) {
      end_behind(ends_.from, 0, line);
      end_behind(ends_.to, 1, line);
      // A line in one plane with the edge: when the plane is edge-on, the two are collinear, and more than the ends may
      // be seen.
      if (line.order == 0) add(EventKind::in_line, line.edge, 0, roots_of(line.d_size != 0 ? line.exact.d : line.exact.n));
    }
    for (const Occluder& occluder : occluders_) {
      if (passes_through(occluder)) passage_behind(occluder);
    }
    pairs_of_lines();
    sort_and_group(found_);
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool touches(const picture::LineEdge& other) const {
    return other.from == ends_.from || other.from == ends_.to || other.to == ends_.from ||
           other.to == ends_.to;
  }

  void add(EventKind kind, std::uint32_t first, std::uint32_t second, const std::vector<Direction>& directions) {
    for (const Direction& direction : directions) listener_.potential(kind, edge_, first, second, direction);
    found_.insert(found_.end(), directions.begin(), directions.end());
  }
  void add(EventKind kind, std::uint32_t first, std::uint32_t second, const Direction& direction) {
    listener_.potential(kind, edge_, first, second, direction);
    found_.push_back(direction);
  }

  void gather_lines() {
    FaceBorders borders = model_.borders_of(occluders_);
    vertices_ = std::move(borders.vertices);
    const auto [low, high] = std::minmax(segment_.from[1], segment_.to[1]);
    for (const EdgeIndex other : borders.edges) {
      const Segment line = model_.segment(other);
      const auto [other_low, other_high] = std::minmax(line.from[1], line.to[1]);
      if (other == edge_ || other_low > high || other_high < low || touches(model_.edges()[other])) continue;
      lines_.push_back(line_of(other, line));
    }
    std::sort(lines_.begin(), lines_.end(),
              [](const Line& a, const Line& b) { return a.low != b.low ? a.low < b.low : a.edge < b.edge; });
  }

  [[nodiscard]] Line line_of(EdgeIndex other, const Segment& segment) const {
    Line line;
    line.edge = other;
    line.exact = crossing_of(segment_, segment);
    line.n = near(line.exact.n);
    line.d = near(line.exact.d);
    line.m = near(line.exact.m);
    line.n_size = size_of(line.n);
    line.d_size = size_of(line.d);
    line.m_size = size_of(line.m);
    line.order = geometry::sign(geometry::dot(geometry::cross(segment_.along(), segment.along()),
                                              minus(segment_.from, segment.from)));
    line.low = std::min(segment.from[1], segment.to[1]);
    line.high = std::max(segment.from[1], segment.to[1]);
    return line;
  }

  // The edge appears, disappears, or coincides in the image with an edge that meets it.
  void own_faces() {
    for (const Incidence& incidence : model_.faces_at(edge_)) {
      add(EventKind::own_face, incidence.face, 0, face_edge_on_events(model_.faces()[incidence.face].normal));
    }
    for (const scene::VertexIndex end : {ends_.from, ends_.to}) {
      for (const EdgeIndex other : model_.edges_at(end)) {
        if (other == edge_) continue;
        add(EventKind::own_plane, other, 0,
            roots_of(form_of(geometry::cross(segment_.along(), model_.segment(other).along()))));
      }
    }
  }

  void face_edge_on(FaceIndex face) {
    // The image of the face is then a line from its lowest to its highest corner.
    Segment image;
    bool first = true;
    for (const Corner& corner : model_.corners(face)) {
      const Vector3& p = model_.vertices()[corner.vertex];
      if (first || p[1] < image.from[1]) image.from = p;
      if (first || p[1] > image.to[1]) image.to = p;
      first = false;
    }
    Line line = line_of(edge_, image);
    for (const Direction& direction : face_edge_on_events(model_.faces()[face].normal)) {
      const NearDirection v = near(direction);
      const Meeting meeting = meeting_of(line, v);
      if (!meeting.within) continue;
      if (filter_.hidden(meeting.s, meeting.error, v)) {
        listener_.dropped(EventKind::face_edge_on, edge_);
        continue;
      }
      add(EventKind::face_edge_on, face, 0, direction);
    }
  }

  // EV: the vertex is nearer.
  void vertex_on_edge(scene::VertexIndex vertex) {
    const Vector3& p = model_.vertices()[vertex];
    const std::int64_t rise = segment_.to[1] - segment_.from[1];
    const std::int64_t above = p[1] - segment_.from[1];
    if (level_ || vertex == ends_.from || vertex == ends_.to) return;
    if (rise > 0 ? above < 0 || above > rise : above > 0 || above < rise) return;
    const Vector3 m = geometry::cross(minus(p, segment_.from), segment_.along());
    if (m[0] == 0 && m[2] == 0) return;
    const int sign = rise > 0 ? 1 : -1;
    consider(EventKind::vertex_in_front, vertex, 0, static_cast<double>(above) / static_cast<double>(rise),
             sign * m[2], -sign * m[0]);
  }

  // EV: an end of the edge is behind a line.
  void end_behind(scene::VertexIndex end, double s, const Line& line) {
    const Segment other = model_.segment(line.edge);
    const Vector3& p = model_.vertices()[end];
    if (line.low == line.high || p[1] < line.low || p[1] > line.high) return;
    const Vector3 m = geometry::cross(minus(p, other.from), other.along());
    if (m[0] == 0 && m[2] == 0) return;
    const int sign = other.to[1] > other.from[1] ? 1 : -1;
    const NearDirection v = near_direction(static_cast<double>(-sign * m[2]), static_cast<double>(sign * m[0]));
    if (filter_.no_contour(line.edge, v)) {
      listener_.dropped(EventKind::vertex_behind, edge_);
      return;
    }
    consider(EventKind::vertex_behind, end, line.edge, s, -sign * m[2], sign * m[0]);
  }

  // Whether the edge passes through the face, or nearly: a test of boxes.
  [[nodiscard]] bool passes_through(const Occluder& occluder) const {
    if (occluder.from == 0 || occluder.to == 0 || (occluder.from < 0) == (occluder.to < 0)) return false;
    const double s = static_cast<double>(occluder.from) /
                     (static_cast<double>(occluder.from) - static_cast<double>(occluder.to));
    bool within = true;
    for (std::size_t axis = 0; axis < 3 && within; ++axis) {
      const double at = static_cast<double>(segment_.from[axis]) +
                        s * static_cast<double>(segment_.to[axis] - segment_.from[axis]);
      bool above = false;
      bool below = false;
      for (const Corner& corner : model_.corners(occluder.face)) {
        const auto c = static_cast<double>(model_.vertices()[corner.vertex][axis]);
        above = above || c > at - 1e-3;
        below = below || c < at + 1e-3;
      }
      within = above && below;
    }
    return within;
  }

  // The point where the edge passes through the plane of a face is seen on a line. A visible piece begins or ends there
  // only if solids touch.
  void passage_behind(const Occluder& occluder) {
    const Int128 whole = Int128{occluder.from} - occluder.to;
    const Vector3 a = segment_.along();
    for (const Line& line : lines_) {
      const Segment other = model_.segment(line.edge);
      const Vector3 b = other.along();
      std::array<Int128, 3> q{};  // the point relative to the line's start, times `whole`
      for (std::size_t axis = 0; axis < 3; ++axis) {
        q[axis] = Int128{segment_.from[axis] - other.from[axis]} * whole + Int128{a[axis]} * occluder.from;
      }
      const Int128 x = q[1] * b[2] - q[2] * b[1];
      const Int128 z = q[0] * b[1] - q[1] * b[0];
      if (x == 0 && z == 0) continue;
      const Direction direction = rational_direction(z, -x);
      add(EventKind::passage, occluder.face, line.edge, direction);
      add(EventKind::passage, occluder.face, line.edge, opposite(direction));
    }
  }

  void consider(EventKind kind, std::uint32_t first, std::uint32_t second, double s, std::int64_t x, std::int64_t z) {
    const NearDirection v = near_direction(static_cast<double>(x), static_cast<double>(z));
    if (filter_.hidden(s, rounding, v)) {
      listener_.dropped(kind, edge_);
    } else {
      add(kind, first, second, rational_direction(x, z));
    }
  }

  // Of the many pairs, few are before the edge in the same direction, unpredictably. They are collected first, without
  // branches, from compact arrays.
  void pairs_of_lines() {
    std::vector<std::size_t> placed;
    std::vector<std::int64_t> lows;
    std::vector<Sector> sectors;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Sector sector = sector_of(lines_[i]);
      if (sector.width < 0) continue;
      placed.push_back(i);
      lows.push_back(lines_[i].low);
      sectors.push_back(sector);
    }
    const auto [low, high] = std::minmax(segment_.from[1], segment_.to[1]);
    std::vector<std::uint32_t> meeting(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Line& a = lines_[placed[i]];
      const Sector own = sectors[i];
      const std::size_t end = static_cast<std::size_t>(
          std::upper_bound(lows.begin() + static_cast<std::ptrdiff_t>(i), lows.end(), a.high) - lows.begin());
      std::size_t count = 0;
      for (std::size_t j = i + 1; j < end; ++j) {
        meeting[count] = static_cast<std::uint32_t>(j);
        count += static_cast<std::size_t>(own.meets(sectors[j]));
      }
      for (std::size_t k = 0; k < count; ++k) {
        const Line& b = lines_[placed[meeting[k]]];
        const std::int64_t bottom = std::max({low, a.low, b.low});
        const std::int64_t top = std::min({high, a.high, b.high});
        if (bottom > top) continue;
        // They share one height only: then an end of one of them is on it, unless one is level.
        if (bottom == top && low != high && a.low != a.high && b.low != b.high) continue;
        pair(a, b);
      }
    }
  }

  [[nodiscard]] bool share_face(const Line& a, const Line& b) const {
    for (const Incidence& p : model_.faces_at(a.edge)) {
      for (const Incidence& q : model_.faces_at(b.edge)) {
        if (p.face == q.face) return true;
      }
    }
    return false;
  }

  void pair(const Line& a, const Line& b) {
    const picture::LineEdge& p = model_.edges()[a.edge];
    const picture::LineEdge& q = model_.edges()[b.edge];
    if (p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to) {
      if (share_face(a, b)) return;  // covered by face_edge_on (FE)
      const Vector3 n = geometry::cross(model_.segment(a.edge).along(), model_.segment(b.edge).along());
      for (const Direction& direction : roots_of(form_of(n))) {
        if (possible(EventKind::edge_pair, a, b, near(direction)))
          add(EventKind::edge_pair, a.edge, b.edge, direction);
      }
      return;
    }
    if (a.d_size == 0 || b.d_size == 0) return;  // parallel, or both level: they never cross
    three_edges(a, b);
  }

  [[nodiscard]] bool possible(EventKind kind, const Line& a, const Line& b, const NearDirection& v) {
    if (surely_farther(a, v) || surely_farther(b, v)) return false;
    const Meeting first = meeting_of(a, v);
    if (!first.within) return false;
    const Meeting second = meeting_of(b, v);
    if (!second.within) return false;
    const Meeting& best = first.error < second.error ? first : second;
    const bool drop =
        filter_.no_contour(a.edge, v) || filter_.no_contour(b.edge, v) || filter_.hidden(best.s, best.error, v);
    if (drop) listener_.dropped(kind, edge_);
    return !drop;
  }

  // Coordinates are far from overflow, and a square root is faster than std::hypot.
  [[nodiscard]] static NearDirection near_direction(double x, double z) {
    const double length = std::sqrt(x * x + z * z);
    return {x / length, z / length, rounding};
  }

  // EEE: the roots are computed in doubles first, and exactly only if doubles do not decide.
  void three_edges(const Line& a, const Line& b) {
    const double scale = a.n_size * b.d_size + b.n_size * a.d_size;
    const double xx = a.n.x * b.d.x - b.n.x * a.d.x;
    const double zz = a.n.z * b.d.z - b.n.z * a.d.z;
    const double xz = a.n.x * b.d.z + a.n.z * b.d.x - b.n.x * a.d.z - b.n.z * a.d.x;
    const double disc = xz * xz - 4 * xx * zz;
    const double off = rounding * scale;
    if (disc < -20 * off * scale) return;
    const double root = disc > 0 ? std::sqrt(disc) : 0;
    if (root * root < 1e-9 * scale * scale) return exactly(a, b);
    const double q = -(xz + (xz < 0 ? -root : root)) / 2;
    const double q_off = off + 10 * off * scale / root;
    for (const auto& [x, z] : {std::array{q, xx}, std::array{zz, q}}) {
      const double length = std::sqrt(x * x + z * z);
      if (!(q_off < 1e-9 * length)) return exactly(a, b);
      const NearDirection v{x / length, z / length, 2 * q_off / length};
      const bool here = possible(EventKind::three_edges, a, b, v);
      const bool there = possible(EventKind::three_edges, a, b, turned_round(v));
      if (!here && !there) continue;
      for (const Direction& direction : roots_of(meeting_form(a.exact, b.exact))) {
        const double along = std::sin(direction.angle) * v.x + std::cos(direction.angle) * v.z;
        const double across = std::sin(direction.angle) * v.z - std::cos(direction.angle) * v.x;
        if (std::abs(across) < 1e-7 && (along > 0 ? here : there))
          add(EventKind::three_edges, a.edge, b.edge, direction);
      }
    }
  }

  void exactly(const Line& a, const Line& b) {
    for (const Direction& direction : roots_of(meeting_form(a.exact, b.exact))) {
      if (possible(EventKind::three_edges, a, b, near(direction)))
        add(EventKind::three_edges, a.edge, b.edge, direction);
    }
  }

  const RotationModel& model_;
  const std::vector<Occluder>& occluders_;
  CandidateFilter filter_;
  [[no_unique_address]] Listener listener_;
  EdgeIndex edge_;
  picture::LineEdge ends_;
  Segment segment_;
  bool level_;
  std::vector<FaceIndex> faces_;
  std::vector<scene::VertexIndex> vertices_;
  std::vector<Line> lines_;
  std::vector<Direction> found_;
};

}  // namespace

std::vector<Direction> candidates_of(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge,
                                     const std::vector<Occluder>& occluders, Trace* trace) {
  if (trace != nullptr) return Gatherer<TraceListener>(model, parts, edge, occluders, TraceListener(*trace)).gather();
  return Gatherer<NoListener>(model, parts, edge, occluders, {}).gather();
}

}  // namespace sightline::algorithms::plantinga
