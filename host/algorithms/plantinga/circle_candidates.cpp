#include "host/algorithms/plantinga/circle_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/algorithms/plantinga/near_vector.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::plantinga {
namespace {

constexpr double form_rounding = 0x1p-48;  // of a form, in units of its size

Near3 near_point(const ConvexParts::Point& p) { return {p.x, p.y, p.z}; }

// c0 + c1 cos t + s1 sin t + c2 cos 2t + s2 sin 2t, within `error`.
struct Wave {
  double c0 = 0, c1 = 0, s1 = 0, c2 = 0, s2 = 0;
  double error = 0;

  struct Value {
    double value;
    double slope;
  };
  [[nodiscard]] Value at(double t) const {
    const double c = std::cos(t);
    const double s = std::sin(t);
    const double cc = c * c - s * s;
    const double ss = 2 * c * s;
    return {c0 + c1 * c + s1 * s + c2 * cc + s2 * ss, -c1 * s + s1 * c - 2 * c2 * ss + 2 * s2 * cc};
  }
  // A bound of the second derivative.
  [[nodiscard]] double bend() const { return std::abs(c1) + std::abs(s1) + 4 * (std::abs(c2) + std::abs(s2)); }
};

Wave meeting_wave(const CircleRatio& first, const CircleRatio& second) {
  const auto add = [](Wave& wave, const CircleForm& f, const CircleForm& g, double sign) {
    wave.c0 += sign * (f.a * g.a + (f.b * g.b + f.c * g.c) / 2);
    wave.c1 += sign * (f.a * g.b + f.b * g.a);
    wave.s1 += sign * (f.a * g.c + f.c * g.a);
    wave.c2 += sign * (f.b * g.b - f.c * g.c) / 2;
    wave.s2 += sign * (f.b * g.c + f.c * g.b) / 2;
    wave.error += form_rounding * f.size() * g.size();
  };
  Wave wave;
  add(wave, first.n, second.d, 1);
  add(wave, second.n, first.d, -1);
  return wave;
}

// Encloses the root of a wave that rises or falls from low to high with at least this slope; nothing, if it surely has none.
void append_root(const Wave& wave, double low, double high, double slope, std::vector<Enclosure>& found) {
  const double off = 2 * wave.error / slope + 4e-15;
  const double at_low = wave.at(low).value;
  const double at_high = wave.at(high).value;
  if (std::abs(at_low) <= wave.error) {
    found.push_back(in_range({low - off, low + off}));
  } else if (std::abs(at_high) <= wave.error) {
    found.push_back(in_range({high - off, high + off}));
  } else if ((at_low < 0) != (at_high < 0)) {
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
      const double middle = (low + high) / 2;
      ((wave.at(middle).value < 0) == (at_low < 0) ? low : high) = middle;
    }
    found.push_back(in_range({low - off, high + off}));
  }
}

void isolate(const Wave& wave, double low, double high, int& left, std::vector<Enclosure>& found) {
  const double half = (high - low) / 2;
  const double middle = low + half;
  const Wave::Value here = wave.at(middle);
  const double bend = wave.bend();
  if (std::abs(here.value) > 2 * wave.error + half * std::abs(here.slope) + bend * half * half) return;
  const double slope = std::abs(here.slope) - bend * half - 16 * wave.error;
  if (slope > 0) {
    append_root(wave, low, high, slope, found);
    return;
  }
  if (half < 1e-10 || --left <= 0) {
    found.push_back(in_range({low, high}));
    return;
  }
  isolate(wave, low, middle, left, found);
  isolate(wave, middle, high, left, found);
}

// Another edge, and its forms relative to the current one.
struct CircleLine {
  EdgeIndex edge = 0;
  Segment segment;
  CircleForm from, to;      // where the plane through it and the eye has the current edge's ends
  CircleForm apart;         // from - to: the current edge crosses the line at from / apart
  CircleForm start, finish;  // on which side of the current edge its ends are
  int order = 0;            // nearer where `apart` has the other sign; 0: in one plane
};

// The angles in which a line crosses the edge and is nearer, and the range of s, which rises or falls.
struct Arc {
  double from = 0;
  double to = 0;
  double low = 0;
  double high = 1;
  std::size_t line = 0;
};

class CircleGatherer {
 public:
  CircleGatherer(const RotationModel& model, const ConvexParts& parts, const EyeCircle& circle, EdgeIndex edge,
                 const std::vector<Occluder>& occluders)
      : model_(model), parts_(parts), circle_(circle), edge_(edge), occluders_(occluders), ends_(model.edges()[edge]),
        segment_(model.segment(edge)), from_(near_of(segment_.from)), along_(near_of(segment_.along())),
        reach_(2 * parts.size() + length_of(near_of(circle.eye))) {}

  std::vector<Enclosure> gather() {
    gather_lines();
    own_planes();
    for (const Occluder& occluder : occluders_) face_edge_on(occluder);
    for (const scene::VertexIndex vertex : vertices_) vertex_in_front(vertex);
    for (const CircleLine& line : lines_) {
      end_behind(line, line.from, 0);
      end_behind(line, line.to, 1);
      if (line.order == 0) append(roots_of(line.from.size() != 0 ? line.from : line.to));
    }
    for (const Occluder& occluder : occluders_) {
      if (passes_through(occluder)) passage_behind(occluder);
    }
    pairs_of_lines();
    sort_and_join(found_, nearest_enclosures);
    return std::move(found_);
  }

 private:
  void append(const std::vector<Enclosure>& enclosures) { found_.insert(found_.end(), enclosures.begin(), enclosures.end()); }
  [[nodiscard]] CircleForm form(const Vector3& normal, const Vector3& p) const { return form_of(circle_, normal, p); }

  [[nodiscard]] bool touches(const picture::LineEdge& other) const {
    return other.from == ends_.from || other.from == ends_.to || other.to == ends_.from || other.to == ends_.to;
  }

  void gather_lines() {
    FaceBorders borders = model_.borders_of(occluders_);
    vertices_ = std::move(borders.vertices);
    for (const EdgeIndex other : borders.edges) {
      if (other != edge_ && !touches(model_.edges()[other])) lines_.push_back(line_of(other));
    }
  }

  [[nodiscard]] CircleLine line_of(EdgeIndex other) const {
    CircleLine line;
    line.edge = other;
    line.segment = model_.segment(other);
    const auto& [p, q] = line.segment;
    const Vector3 a = segment_.along();
    const Vector3 b = line.segment.along();
    const auto back = minus(segment_.from, segment_.to);
    line.from = form(geometry::cross(b, minus(segment_.from, p)), p);
    line.to = form(geometry::cross(b, minus(segment_.to, p)), p);
    line.apart = form(geometry::cross(b, back), p);
    line.start = form(geometry::cross(a, minus(p, segment_.from)), segment_.from);
    line.finish = form(geometry::cross(a, minus(q, segment_.from)), segment_.from);
    line.order = geometry::sign(geometry::dot(geometry::cross(a, b), minus(segment_.from, p)));
    return line;
  }

  // One of the edge's own faces is edge-on, or its plane with an edge that meets it in a vertex.
  void own_planes() {
    for (const Incidence& incidence : model_.faces_at(edge_)) {
      append(roots_of(form(model_.faces()[incidence.face].normal, segment_.from)));
    }
    for (const scene::VertexIndex end : {ends_.from, ends_.to}) {
      for (const EdgeIndex other : model_.edges_at(end)) {
        if (other != edge_)
          append(roots_of(form(geometry::cross(segment_.along(), model_.segment(other).along()), segment_.from)));
      }
    }
  }

  // A face that is edge-on is seen on the edge only where the edge crosses its plane, if not in the plane.
  void face_edge_on(const Occluder& occluder) {
    if ((occluder.from < 0) == (occluder.to < 0) && occluder.from != 0 && occluder.to != 0) return;
    const double s = static_cast<double>(occluder.from) / (static_cast<double>(occluder.from) - static_cast<double>(occluder.to));
    const Vector3& corner = model_.vertices()[model_.corners(occluder.face)[0].vertex];
    for (const Enclosure& root : roots_of(form(model_.faces()[occluder.face].normal, corner))) keep_unless_hidden(root, s, 1e-12);
  }

  void keep_unless_hidden(const Enclosure& root, double s, double error) {
    if (!hidden(root, s, error)) found_.push_back(root);
  }

  // Where the sight line through p, seen near the root, passes the edge; the error of s is too large to use if it is 1.
  struct Meeting {
    double s = 0;
    double error = 1;
    double before = 0;  // how far p is nearer than the edge
  };
  [[nodiscard]] Meeting meeting_of(const Near3& p, const Enclosure& root) const {
    const Near3 sight = near_eye_at(circle_, root.middle()).from(p);
    const Near3 across = cross(along_, sight);
    const Near3 offset = difference(p, from_);
    Meeting meeting;
    const double square = dot(across, across);
    const double sine = std::sqrt(square) / (length_of(along_) * length_of(sight));
    if (!(sine > 1e-5)) return meeting;
    // A + s (B - A) - p is along the sight, so its cross product with the sight is 0.
    meeting.s = dot(cross(offset, sight), across) / square;
    meeting.error = (root.width() + 1e-13) * 8 * reach_ * reach_ / (length_of(sight) * length_of(along_) * sine);
    const Near3 point{from_[0] + meeting.s * along_[0], from_[1] + meeting.s * along_[1], from_[2] + meeting.s * along_[2]};
    meeting.before = dot(difference(p, point), sight) / length_of(sight);
    return meeting;
  }

  // EV: the vertex is nearer.
  void vertex_in_front(scene::VertexIndex vertex) {
    if (vertex == ends_.from || vertex == ends_.to) return;
    const Vector3& p = model_.vertices()[vertex];
    for (const Enclosure& root : roots_of(form(geometry::cross(segment_.along(), minus(p, segment_.from)), segment_.from))) {
      const Meeting meeting = meeting_of(near_of(p), root);
      if (meeting.error < 1e-2) {
        if (meeting.s < -meeting.error - 1e-9 || meeting.s > 1 + meeting.error + 1e-9) continue;
        if (meeting.before < -meeting.error * reach_ - 1e-9 * reach_) continue;
        keep_unless_hidden(root, meeting.s, meeting.error);
      } else {
        found_.push_back(root);
      }
    }
  }

  // EV: an end of the edge is behind a line. `side`: on which side of the line's plane the end is.
  void end_behind(const CircleLine& line, const CircleForm& side, double s) {
    for (const Enclosure& root : roots_of(side)) {
      if (surely_farther(line, root) || outside(line, root) || no_contour(line.edge, root)) continue;
      keep_unless_hidden(root, s, 1e-12);
    }
  }

  struct Turn {
    double cosine;
    double sine;
    double off;  // bound of what the enclosure's width and form_rounding do to a form, in units of its size
  };
  [[nodiscard]] static Turn turn_of(const Enclosure& root) {
    return {std::cos(root.middle()), std::sin(root.middle()), root.width() + 8 * form_rounding};
  }
  [[nodiscard]] static bool surely(const CircleForm& form, const Turn& turn, int sign) {
    return sign * form.at(turn.cosine, turn.sine) > turn.off * form.size();
  }
  [[nodiscard]] static bool surely_farther(const CircleLine& line, const Enclosure& root) {
    return line.order != 0 && surely(line.apart, turn_of(root), line.order);
  }
  // Both ends of the line are surely on one side of the edge's line in the image.
  [[nodiscard]] static bool outside(const CircleLine& line, const Enclosure& root) {
    const Turn turn = turn_of(root);
    return (surely(line.start, turn, 1) && surely(line.finish, turn, 1)) ||
           (surely(line.start, turn, -1) && surely(line.finish, turn, -1));
  }

  // Whether the other edge is surely not the boundary of anything hidden: the faces on its two sides both hide, or neither.
  [[nodiscard]] bool no_contour(EdgeIndex other, const Enclosure& root) const {
    if (root.width() > 1e-6) return false;
    const NearEye eye = near_eye_at(circle_, root.middle());
    bool left = false;
    bool right = false;
    for (const Incidence& incidence : model_.faces_at(other)) {
      const ConvexParts::Face& face = parts_.face(incidence.face);
      const Near3 sight = eye.from(near_point(face.on));
      const double facing = dot(near_point(face.normal), sight) / length_of(sight);
      if (std::abs(facing) <= 1e-9 + slack(root) / length_of(sight)) return false;
      if (facing < 0 && !model_.faces()[incidence.face].sheet) continue;
      ((facing > 0) == incidence.with_edge ? left : right) = true;
    }
    return left == right;
  }

  // How far the eye may be from where it is taken to be.
  [[nodiscard]] double slack(const Enclosure& root) const { return (root.width() + 1e-12) * reach_; }

  // Whether the point at parameter s of the edge, with error ds, is surely hidden near the root.
  [[nodiscard]] bool hidden(const Enclosure& root, double s, double ds) {
    if (!(ds < 1e-2) || root.width() > 1e-6) return false;
    const NearEye eye = near_eye_at(circle_, root.middle());
    const Near3 p{from_[0] + s * along_[0], from_[1] + s * along_[1], from_[2] + s * along_[2]};
    const double margin = ds * length_of(along_) + 4 * slack(root) + 1e-10 * reach_;
    const auto hides = [&](const Occluder& occluder) {
      const ConvexParts::Face& face = parts_.face(occluder.face);
      const Near3 on = near_point(face.on);
      const Near3 normal = near_point(face.normal);
      if (occluder.side * dot(normal, difference(p, on)) >= -margin) return false;
      const Near3 sight = eye.from(on);
      if (occluder.side * dot(normal, sight) <= 1e-9 * length_of(sight) + slack(root)) return false;
      return covers(occluder, p, eye, margin);
    };
    if (last_ < occluders_.size() && hides(occluders_[last_])) return true;
    for (std::size_t i = 0; i < occluders_.size(); ++i) {
      if (hides(occluders_[i])) {
        last_ = i;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool covers(const Occluder& occluder, const Near3& p, const NearEye& eye, double margin) const {
    const ConvexParts::Face& face = parts_.face(occluder.face);
    for (std::uint32_t index = face.first_part; index < face.last_part; ++index) {
      const auto corners = parts_.part(index);
      Near3 q = near_point(corners.back());
      bool inside = true;
      for (std::size_t i = 0; i < corners.size() && inside; ++i) {
        const Near3 r = near_point(corners[i]);
        const Near3 side = difference(r, q);
        const Near3 sight = eye.from(q);
        const double turn = occluder.side * dot(cross(side, difference(p, q)), sight);
        inside = turn > 2 * margin * length_of(side) * length_of(sight);
        q = r;
      }
      if (inside) return true;
    }
    return false;
  }

  // Whether the edge passes through the face, or nearly: a test of boxes.
  [[nodiscard]] bool passes_through(const Occluder& occluder) const {
    if (occluder.from == 0 || occluder.to == 0 || (occluder.from < 0) == (occluder.to < 0)) return false;
    const double s = static_cast<double>(occluder.from) / (static_cast<double>(occluder.from) - static_cast<double>(occluder.to));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = from_[axis] + s * along_[axis];
      bool above = false;
      bool below = false;
      for (const Corner& corner : model_.corners(occluder.face)) {
        const auto c = static_cast<double>(model_.vertices()[corner.vertex][axis]);
        above = above || c > at - 1e-3;
        below = below || c < at + 1e-3;
      }
      if (!above || !below) return false;
    }
    return true;
  }

  // The point where the edge passes through the plane of a face is seen on a line: the forms of the line at the edge's ends, in
  // this ratio.
  void passage_behind(const Occluder& occluder) {
    const double whole = static_cast<double>(occluder.from) - static_cast<double>(occluder.to);
    const double s = static_cast<double>(occluder.from) / whole;
    for (const CircleLine& line : lines_) {
      const CircleForm at{line.from.a + s * (line.to.a - line.from.a), line.from.b + s * (line.to.b - line.from.b),
                          line.from.c + s * (line.to.c - line.from.c)};
      const double off = form_rounding * (line.from.size() + line.to.size());
      // The root of a form that is certain only within `off` is enclosed by those of forms that much above and below.
      const auto above = roots_of(CircleForm{at.a + off, at.b, at.c});
      const auto below = roots_of(CircleForm{at.a - off, at.b, at.c});
      append(above);
      append(below);
      for (std::size_t i = 0; i < above.size() && i < below.size(); ++i) {
        const double gap = std::remainder(below[i].middle() - above[i].middle(), 2 * half_turn);
        found_.push_back(in_range({above[i].middle() + std::min(gap, 0.0), above[i].middle() + std::max(gap, 0.0)}));
      }
      if (above.size() != below.size()) {  // a double root, or nearly: at the angle where the form is nearest to 0
        const double top = std::atan2(at.c, at.b) + (at.a > 0 ? half_turn : 0.0);
        found_.push_back(in_range({top - 1e-5, top + 1e-5}));
      }
    }
  }

  void append_arcs(std::size_t index, std::vector<Arc>& arcs) const {
    const CircleLine& line = lines_[index];
    if (line.from.size() == 0 && line.to.size() == 0) return;  // always in line: they never cross
    std::vector<Enclosure> cuts;
    const auto cut = [&cuts](const CircleForm& form) {
      for (const Enclosure& root : roots_of(form)) cuts.push_back(root);
    };
    for (const CircleForm* const form : {&line.from, &line.to, &line.start, &line.finish}) cut(*form);
    // Where s neither rises nor falls: from' apart - from apart' = 0, which is again such a form.
    const CircleForm& n = line.from;
    const CircleForm& d = line.apart;
    cut({n.c * d.b - n.b * d.c, n.c * d.a - n.a * d.c, n.a * d.b - n.b * d.a});
    cuts.push_back({-half_turn, -half_turn});
    cuts.push_back({half_turn, half_turn});
    for (std::size_t i = 0, count = cuts.size(); i < count; ++i) {
      if (cuts[i].high <= half_turn) continue;  // otherwise around half_turn: both of its parts
      cuts.push_back({-half_turn, cuts[i].high - 2 * half_turn});
      cuts[i].high = half_turn;
    }
    std::sort(cuts.begin(), cuts.end(), [](const Enclosure& a, const Enclosure& b) { return a.low < b.low; });
    double reached = cuts.front().high;
    double begun = cuts.front().low;
    for (const Enclosure& next : cuts) {
      if (next.low > reached) {
        append_arc(index, begun, reached, next.low, next.high, arcs);
        begun = next.low;
      }
      reached = std::max(reached, next.high);
    }
  }

  // Between cuts from `inner` to `inner_end`, which are certain only within `from` to `to`.
  void append_arc(std::size_t index, double from, double inner, double inner_end, double to, std::vector<Arc>& arcs) const {
    const CircleLine& line = lines_[index];
    const double middle = (inner + inner_end) / 2;
    const Turn turn{std::cos(middle), std::sin(middle), 8 * form_rounding};
    const auto same = [&](const CircleForm& f, const CircleForm& g) {
      return (surely(f, turn, 1) && surely(g, turn, 1)) || (surely(f, turn, -1) && surely(g, turn, -1));
    };
    if (same(line.from, line.to) || same(line.start, line.finish)) return;
    if (line.order != 0 && surely(line.apart, turn, line.order)) return;
    Arc arc{from, to, 0, 1, index};
    const auto s_at = [&](double angle) -> std::pair<double, double> {
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const double whole = line.apart.at(c, s);
      if (std::abs(whole) < 1e-6 * line.apart.size()) return {0, 1};
      const double at = std::clamp(line.from.at(c, s) / whole, 0.0, 1.0);
      return {at - 1e-4, at + 1e-4};
    };
    const auto [first_low, first_high] = s_at(inner);
    const auto [last_low, last_high] = s_at(inner_end);
    arc.low = std::min(first_low, last_low);
    arc.high = std::max(first_high, last_high);
    if (inner - from > 1e-9 || to - inner_end > 1e-9) {
      arc.low = 0;
      arc.high = 1;
    }
    arcs.push_back(arc);
  }

  void pairs_of_lines() {
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i < lines_.size(); ++i) append_arcs(i, arcs);
    std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) { return a.from < b.from; });
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      for (std::size_t j = i + 1; j < arcs.size() && arcs[j].from <= arcs[i].to; ++j) {
        const Arc& a = arcs[i];
        const Arc& b = arcs[j];
        if (a.line == b.line || a.high < b.low || b.high < a.low) continue;
        pair(lines_[a.line], lines_[b.line], b.from, std::min(a.to, b.to));
      }
    }
  }

  [[nodiscard]] bool share_face(const CircleLine& a, const CircleLine& b) const {
    for (const Incidence& p : model_.faces_at(a.edge)) {
      for (const Incidence& q : model_.faces_at(b.edge)) {
        if (p.face == q.face) return true;
      }
    }
    return false;
  }

  // Whether the lines cross the edge at the same point from everywhere: a form of degree 4 in (p : q) that is 0 at five places.
  [[nodiscard]] bool always_meet(const CircleLine& a, const CircleLine& b) const {
    using Value = geometry::WideInteger<110>;
    const auto value = [](const Vector3& normal, const Vector3& p, const EyeCircle& circle, const ExactEye& eye) {
      geometry::Int128 sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += normal[i] * (eye.turned[i] + geometry::Int128{eye.weight} * (circle.about[i] - p[i]));
      return Value(sum);
    };
    const auto forms = [&](const CircleLine& line, const ExactEye& eye) {
      const auto& [p, q] = line.segment;
      const Vector3 along = line.segment.along();
      return std::pair{value(geometry::cross(along, minus(segment_.from, p)), p, circle_, eye),
                       value(geometry::cross(along, minus(segment_.from, segment_.to)), p, circle_, eye)};
    };
    for (const CirclePlace& place : {CirclePlace{0, 1}, CirclePlace{1, 1}, CirclePlace{-1, 1}, CirclePlace{1, 2}, CirclePlace{1, 0}}) {
      const ExactEye eye = eye_at(circle_, place);
      const auto [n, d] = forms(a, eye);
      const auto [m, e] = forms(b, eye);
      if ((n * e - m * d).sign() != 0) return false;
    }
    return true;
  }

  // Two nearer lines cross on the edge, from `low` to `high`.
  void pair(const CircleLine& a, const CircleLine& b, double low, double high) {
    const picture::LineEdge& p = model_.edges()[a.edge];
    const picture::LineEdge& q = model_.edges()[b.edge];
    meetings_.clear();
    if (p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to) {
      if (share_face(a, b)) return;  // the face is edge-on, or their vertex is on the edge
      meetings_ = roots_of(form(geometry::cross(a.segment.along(), b.segment.along()), a.segment.from));
    } else if (!append_meetings({a.from, a.apart}, {b.from, b.apart}, low, high, meetings_)) {
      if (always_meet(a, b)) return;
      meetings_.push_back(in_range({low, high}));
    }
    for (const Enclosure& root : meetings_) {
      if (no_contour(a.edge, root) || no_contour(b.edge, root)) continue;
      if (surely_farther(a, root) || surely_farther(b, root)) continue;
      const Turn turn = turn_of(root);
      const CircleLine& best = std::abs(a.apart.at(turn.cosine, turn.sine)) / (a.apart.size() + 1e-300) >
                                 std::abs(b.apart.at(turn.cosine, turn.sine)) / (b.apart.size() + 1e-300)
                             ? a
                             : b;
      const double whole = std::abs(best.apart.at(turn.cosine, turn.sine));
      const double error = whole > 0 ? turn.off * (best.from.size() + best.apart.size()) * 2 / whole : 1;
      if (error < 1e-2) {
        const double s = best.from.at(turn.cosine, turn.sine) / best.apart.at(turn.cosine, turn.sine);
        if (s < -error - 1e-9 || s > 1 + error + 1e-9 || hidden(root, s, error)) continue;
      }
      found_.push_back(root);
    }
  }

  const RotationModel& model_;
  const ConvexParts& parts_;
  const EyeCircle& circle_;
  EdgeIndex edge_;
  const std::vector<Occluder>& occluders_;
  picture::LineEdge ends_;
  Segment segment_;
  Near3 from_;
  Near3 along_;
  double reach_;  // no vertex and no eye is farther from another
  std::size_t last_ = 0;  // the occluder that hid the last point: likely to hide the next one
  std::vector<scene::VertexIndex> vertices_;
  std::vector<CircleLine> lines_;
  std::vector<Enclosure> meetings_;
  std::vector<Enclosure> found_;
};

}  // namespace

bool append_meetings(const CircleRatio& first, const CircleRatio& second, double low, double high, std::vector<Enclosure>& found) {
  const Wave wave = meeting_wave(first, second);
  const double size = std::abs(wave.c0) + std::abs(wave.c1) + std::abs(wave.s1) + std::abs(wave.c2) + std::abs(wave.s2);
  if (size <= 4 * wave.error) return false;
  int left = 4000;
  isolate(wave, low, high, left, found);
  return true;
}

std::vector<Enclosure> candidates_of(const RotationModel& model, const ConvexParts& parts, const EyeCircle& circle, EdgeIndex edge,
                                     const std::vector<Occluder>& occluders) {
  return CircleGatherer(model, parts, circle, edge, occluders).gather();
}

}  // namespace sightline::algorithms::plantinga
