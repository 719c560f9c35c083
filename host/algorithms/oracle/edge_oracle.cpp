#include "host/algorithms/oracle/edge_oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/rounded_fraction.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::cross;
using geometry::dot;
using geometry::Int128;
using geometry::Rational;
using geometry::sign;
using picture::LineEdge;
using Vector = geometry::Vector3;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::int64_t determinant(const Vector& a, const Vector& b, const Vector& c) {
  return dot(cross(a, b), c);
}

// The values at both ends of the edge of a quantity that is linear along it.
struct Linear {
  std::int64_t from = 0;
  std::int64_t to = 0;

  [[nodiscard]] int sign_at(const Rational& s) const {
    return sign(Int128{from} * (s.denominator() - s.numerator()) + Int128{to} * s.numerator());
  }
  [[nodiscard]] int sign_from() const { return sign(from); }
  [[nodiscard]] int sign_to() const { return sign(to); }
  [[nodiscard]] Rational zero() const { return {from, from - to}; }
};

// The same for a line between two fractional points, with a common denominator, and for a place on it.
using Value = geometry::WideInteger<184>;

struct WidePlace {
  geometry::WideInteger<187> numerator;
  geometry::WideInteger<187> denominator;  // positive

  friend bool operator<(const WidePlace& a, const WidePlace& b) { return a.numerator * b.denominator < b.numerator * a.denominator; }
  friend bool operator==(const WidePlace& a, const WidePlace& b) {
    return sign(a.numerator * b.denominator - b.numerator * a.denominator) == 0;
  }
};

WidePlace mediant(const WidePlace& a, const WidePlace& b) {
  return {(a.numerator + b.numerator).narrow<187>(), (a.denominator + b.denominator).narrow<187>()};
}

struct WideLinear {
  Value from;
  Value to;

  [[nodiscard]] int sign_at(const WidePlace& s) const { return sign(from * (s.denominator - s.numerator) + to * s.numerator); }
  [[nodiscard]] int sign_from() const { return from.sign(); }
  [[nodiscard]] int sign_to() const { return to.sign(); }
  [[nodiscard]] WidePlace zero() const {
    const auto way = from - to;
    return way.negative() ? WidePlace{-from, -way} : WidePlace{from, way};
  }
};

// An end of a line as integers over a positive weight, relative to the eye: 80 over 61 bits.
struct WideEnd {
  std::array<Int128, 3> at{};
  std::int64_t weight = 1;
};

WideEnd wide_end(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CutPoint& cut) {
  const Vector p = geometry::difference(scene.vertices[cut.p], camera.eye);
  const Vector q = geometry::difference(scene.vertices[cut.q], camera.eye);
  const int turn = cut.a > cut.b ? 1 : -1;
  WideEnd end;
  end.weight = turn * (cut.a - cut.b);
  for (std::size_t a = 0; a < 3; ++a) end.at[a] = turn * (Int128{q[a]} * cut.a - Int128{p[a]} * cut.b);
  return end;
}

// Points as the eye sees them. Its three functions are determinants of the eye and three points; in orthographic views
// the eye is the direction towards it.
class Sight {
 public:
  Sight(const scene::PolyScene& scene, const scene::PolyCamera& camera)
      : perspective_(camera.perspective), forward_(geometry::vector_of(camera.forward)) {
    for (const scene::PolyPoint& vertex : scene.vertices)
      vertices_.push_back(geometry::difference(vertex, camera.eye));
  }

  [[nodiscard]] const Vector& vertex(scene::VertexIndex v) const { return vertices_[v]; }
  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] const Vector& forward() const { return forward_; }
  // Positive if x is seen to the left of the line from p to q.
  [[nodiscard]] std::int64_t side(const Vector& p, const Vector& q, const Vector& x) const {
    return perspective_ ? determinant(p, q, x) : determinant(q - p, x - p, forward_);
  }
  // The same for the line from x in direction w.
  [[nodiscard]] std::int64_t side_of_ray(const Vector& x, const Vector& w, const Vector& p) const {
    return perspective_ ? determinant(x, w, p) : determinant(forward_, w, p - x);
  }
  // The rate of change of side(p, q, .) in direction w.
  [[nodiscard]] std::int64_t growth(const Vector& p, const Vector& q, const Vector& w) const {
    return perspective_ ? determinant(p, q, w) : determinant(q - p, w, forward_);
  }
  // On which side of the plane through `on` the eye is.
  [[nodiscard]] std::int64_t eye_side(const Vector& normal, const Vector& on) const {
    return perspective_ ? -dot(normal, on) : -dot(normal, forward_);
  }

 private:
  bool perspective_;
  Vector forward_;
  std::vector<Vector> vertices_;
};

struct Face {
  std::vector<LineEdge> sides;  // unordered: a point is inside if a ray from it crosses an odd number
  Vector normal{};              // of length twice the area: below 2^39 in each component
  Vector on{};
  std::int64_t eye_side = 0;
  std::uint32_t surface = 0;
  bool sheet = false;
};

void add_ring(std::span<const scene::VertexIndex> ring, const Sight& sight, Face& face) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const scene::VertexIndex a = ring[i];
    const scene::VertexIndex b = ring[(i + 1) % ring.size()];
    if (a != b) face.sides.push_back({a, b});
    const Vector part = cross(sight.vertex(a) - face.on, sight.vertex(b) - face.on);
    for (std::size_t axis = 0; axis < 3; ++axis) face.normal[axis] += part[axis];
  }
}

std::vector<Face> faces_of(const scene::PolyScene& scene, const Sight& sight) {
  std::vector<Face> faces;
  std::size_t number = 0;
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& given : body.faces) {
      const std::size_t mine = number++;
      if (given.outline.empty()) continue;
      Face face;
      face.surface = scene.surface_of.empty() ? 0 : scene.surface_of[mine];
      face.sheet = body.sheet;
      face.on = sight.vertex(given.outline.front());
      add_ring(given.outline, sight, face);
      for (const auto& hole : given.holes) add_ring(hole, sight, face);
      face.eye_side = sight.eye_side(face.normal, face.on);
      if (face.eye_side != 0) faces.push_back(face);
    }
  }
  return faces;
}

// The quantities that a test needs of an edge between two vertices.
class Segment {
 public:
  using Quantity = Linear;
  using Place = Rational;

  Segment(const Sight& sight, const Vector& a, const Vector& b) : sight_(sight), a_(a), b_(b) {}

  // Signs: how `side` of the edge changes in a direction, and on which side of the edge a point is seen.
  [[nodiscard]] int growth(const Vector& w) const { return sign(sight_.growth(a_, b_, w)); }
  [[nodiscard]] int place_of(const Vector& p) const { return sign(sight_.side(a_, b_, p)); }
  // The values at the ends of the edge: relative to the line from p to q; of a plane; and of p relative to the line from
  // each end in direction w.
  [[nodiscard]] Linear left_of(const Vector& p, const Vector& q) const { return {sight_.side(p, q, a_), sight_.side(p, q, b_)}; }
  [[nodiscard]] Linear along(const Vector& normal, const Vector& on) const { return {dot(normal, a_ - on), dot(normal, b_ - on)}; }
  [[nodiscard]] Linear turn(const Vector& w, const Vector& p) const {
    return {sight_.side_of_ray(a_, w, p), sight_.side_of_ray(b_, w, p)};
  }
  [[nodiscard]] static Rational place(std::int64_t whole) { return Rational(whole); }
  [[nodiscard]] static Rational drawn(const Rational& s) { return s; }

 private:
  const Sight& sight_;
  Vector a_;
  Vector b_;
};

// The same for a crossing, which has fractional ends; its determinants are expanded in wide integers.
class CrossingLine {
 public:
  using Quantity = WideLinear;
  using Place = WidePlace;

  CrossingLine(const Sight& sight, const WideEnd& a, const WideEnd& b) : sight_(sight), a_(a), b_(b) {}

  [[nodiscard]] int growth(const Vector& w) const { return side(w, 0); }
  [[nodiscard]] int place_of(const Vector& p) const { return side(p, 1); }
  [[nodiscard]] WideLinear left_of(const Vector& p, const Vector& q) const {
    const Vector normal = sight_.perspective() ? cross(p, q) : cross(sight_.forward(), q - p);
    return along(normal, sight_.perspective() ? Vector{} : p);
  }
  [[nodiscard]] WideLinear along(const Vector& normal, const Vector& on) const {
    const auto value = [&](const WideEnd& end) {
      Int128 sum = -Int128{dot(normal, on)} * end.weight;
      for (std::size_t a = 0; a < 3; ++a) sum += end.at[a] * normal[a];
      return sum;
    };
    return one_denominator(value(a_), value(b_));
  }
  [[nodiscard]] WideLinear turn(const Vector& w, const Vector& p) const {
    const auto value = [&](const WideEnd& end) {
      // determinant(x, w, p), or in orthographic views determinant(forward, w, p - x) times the weight
      const Vector across = sight_.perspective() ? cross(w, p) : cross(sight_.forward(), w);
      Int128 sum = sight_.perspective() ? Int128{0} : Int128{dot(across, p)} * end.weight;
      for (std::size_t a = 0; a < 3; ++a) sum += (sight_.perspective() ? end.at[a] : -end.at[a]) * across[a];
      return sum;
    };
    return one_denominator(value(a_), value(b_));
  }
  [[nodiscard]] static WidePlace place(std::int64_t whole) {
    return {geometry::WideInteger<187>(whole), geometry::WideInteger<187>(1)};
  }
  [[nodiscard]] static Rational drawn(const WidePlace& s) { return geometry::rounded_fraction(s.numerator, s.denominator); }

 private:
  using Long = geometry::WideInteger<82>;
  using Short = geometry::WideInteger<62>;

  [[nodiscard]] WideLinear one_denominator(Int128 a, Int128 b) const {
    using Part = geometry::WideInteger<122>;
    return {Part(a) * Short(Int128{b_.weight}), Part(b) * Short(Int128{a_.weight})};
  }

  // determinant(a, b, x), or in orthographic views determinant(b - a, x - a, forward). x is a point (1) or a direction
  // (0).
  [[nodiscard]] int side(const Vector& x, int point) const {
    using Wide = geometry::WideInteger<150>;
    std::array<Wide, 3> u;
    std::array<Wide, 3> v;
    std::array<Wide, 3> w;
    for (std::size_t k = 0; k < 3; ++k) {
      const Long a(a_.at[k]);
      const Long b(b_.at[k]);
      if (sight_.perspective()) {
        u[k] = a;
        v[k] = b;
        w[k] = Wide(x[k]);
      } else {
        const Short a_weight(Int128{a_.weight});
        u[k] = b * a_weight - a * Short(Int128{b_.weight});
        v[k] = geometry::WideInteger<20>(Int128{x[k]}) * a_weight - (point != 0 ? a : Long(0));
        w[k] = Wide(sight_.forward()[k]);
      }
    }
    auto sum = (v[1] * w[2] - v[2] * w[1]) * u[0];
    for (std::size_t k = 1; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      const std::size_t m = (k + 2) % 3;
      sum = (sum + (v[l] * w[m] - v[m] * w[l]) * u[k]).narrow<451>();
    }
    return sum.sign();
  }

  const Sight& sight_;
  WideEnd a_;
  WideEnd b_;
};

// Tests one edge or crossing.
template <class Line>
class EdgeTest {
 public:
  using Quantity = typename Line::Quantity;
  using Place = typename Line::Place;

  EdgeTest(const Sight& sight, const Line& line) : sight_(sight), line_(line) {
    for (std::size_t axis = 0; axis < 3 && !has_image_; ++axis) {
      leftward_ = {};
      leftward_[axis] = 1;
      const int growth = line.growth(leftward_);
      if (growth < 0) leftward_[axis] = -1;
      has_image_ = growth != 0;
    }
  }

  [[nodiscard]] bool has_image() const { return has_image_; }

  geometry::IntervalSet visible(const std::vector<Face>& faces, const std::vector<LineEdge>& edges) {
    collect_faces(faces);
    const std::vector<Place> cuts = cuts_by(edges);
    geometry::IntervalSet visible;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (visible_at(mediant(cuts[i], cuts[i + 1]))) visible.unite(Line::drawn(cuts[i]), Line::drawn(cuts[i + 1]));
    }
    return visible;
  }

 private:
  // A face with the quantities that its tests need at both ends of the edge.
  struct Candidate {
    const Face* face;
    Quantity beyond;  // relative to the plane of the face: positive on the side away from the eye
    struct Side {
      Quantity left;                  // relative to the side of the face
      std::array<Quantity, 2> turns;  // of the side's ends, relative to the ray to the left
    };
    std::vector<Side> sides;
  };

  [[nodiscard]] Quantity left_of(const LineEdge& line) const {
    return line_.left_of(sight_.vertex(line.from), sight_.vertex(line.to));
  }

  // Collects the candidates. A face wholly on one side of the edge's image line hides nothing of the edge, nor does a
  // face beyond it.
  void collect_faces(const std::vector<Face>& faces) {
    place_.resize(sight_.vertex_count());
    for (std::size_t v = 0; v < place_.size(); ++v) {
      place_[v] = line_.place_of(sight_.vertex(static_cast<scene::VertexIndex>(v)));
    }
    candidates_.clear();
    for (const Face& face : faces) {
      int low = 1;
      int high = -1;
      for (const LineEdge& side : face.sides) {
        low = std::min(low, place_[side.from]);
        high = std::max(high, place_[side.from]);
      }
      if (low > 0 || high < 0) continue;
      const Quantity beyond = line_.along(face.eye_side > 0 ? geometry::negated(face.normal) : face.normal, face.on);
      if (beyond.sign_from() <= 0 && beyond.sign_to() <= 0) continue;
      candidates_.push_back({&face, beyond, {}});
      for (const LineEdge& side : face.sides) {
        const auto turn = [&](scene::VertexIndex v) { return line_.turn(leftward_, sight_.vertex(v)); };
        candidates_.back().sides.push_back({left_of(side), {turn(side.from), turn(side.to)}});
      }
    }
  }

  static void cut(const Quantity& quantity, std::vector<Place>& cuts) {
    if (quantity.sign_from() * quantity.sign_to() < 0) cuts.push_back(quantity.zero());
  }

  [[nodiscard]] std::vector<Place> cuts_by(const std::vector<LineEdge>& edges) const {
    std::vector<Place> cuts{Line::place(0), Line::place(1)};
    for (const LineEdge& line : edges) {
      if (place_[line.from] * place_[line.to] <= 0) cut(left_of(line), cuts);
    }
    for (const Candidate& candidate : candidates_) cut(candidate.beyond, cuts);
    if (sight_.perspective()) cut(depth(), cuts);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  [[nodiscard]] Quantity depth() const { return line_.along(sight_.forward(), {}); }

  [[nodiscard]] bool visible_at(const Place& s) const {
    if (sight_.perspective() && depth().sign_at(s) <= 0) return false;
    return !hidden_at(s, 1) || !hidden_at(s, -1);
  }

  // Whether the point is hidden in the limit from the left (1) or the right (-1) of the edge.
  [[nodiscard]] bool hidden_at(const Place& s, int hand) const {
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
      return candidate.beyond.sign_at(s) > 0 && covers(candidate, s, hand);
    });
  }

  // Counts the sides that a ray from the point to the left or right crosses. The ray starts a little beside the edge, so
  // a side in line with the edge is not crossed. A vertex on the ray counts as being on one fixed side of it.
  static bool covers(const Candidate& candidate, const Place& s, int hand) {
    bool inside = false;
    for (const auto& side : candidate.sides) {
      const bool first = hand * side.turns[0].sign_at(s) > 0;
      const bool second = hand * side.turns[1].sign_at(s) > 0;
      if (first != second && side.left.sign_at(s) * (second ? 1 : -1) > 0) inside = !inside;
    }
    return inside;
  }

  const Sight& sight_;
  Line line_;
  Vector leftward_{};  // along an axis, so that the numbers stay short
  bool has_image_ = false;
  std::vector<int> place_;
  std::vector<Candidate> candidates_;
};

}  // namespace

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  const Sight sight(scene, camera);
  const std::vector<Face> faces = faces_of(scene, sight);
  const std::vector<LineEdge> edges = picture::edges_of(scene);
  picture::LinePicture picture;
  for (const LineEdge& edge : edges) {
    EdgeTest test(sight, Segment(sight, sight.vertex(edge.from), sight.vertex(edge.to)));
    if (!test.has_image()) continue;
    const geometry::IntervalSet visible = test.visible(faces, edges);
    for (const geometry::Interval& seen : visible.intervals()) {
      picture.pieces.push_back({edge, seen.low, seen.high});
    }
  }
  return picture;
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                   const picture::ChosenEdges& chosen) {
  const Sight sight(scene, camera);
  const std::vector<Face> faces = faces_of(scene, sight);
  const std::vector<LineEdge> edges = picture::edges_of(scene);
  picture::LinePicture picture;
  for (std::size_t e = 0; e < chosen.edges.size(); ++e) {
    if (chosen.turned_away[e] != 0) continue;
    const auto beside = chosen.surfaces_at(e);
    std::vector<Face> hiding;
    for (const Face& face : faces) {
      const bool own = std::find(beside.begin(), beside.end(), face.surface) != beside.end();
      if (!own && (face.sheet || face.eye_side > 0)) hiding.push_back(face);
    }
    const auto add_visible = [&](const auto& line) {
      EdgeTest test(sight, line);
      if (!test.has_image()) return;
      const geometry::IntervalSet visible = test.visible(hiding, edges);
      for (const geometry::Interval& seen : visible.intervals())
        picture.pieces.push_back({chosen.edges[e], seen.low, seen.high});
    };
    const LineEdge& edge = chosen.edges[e];
    if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene, edge.from)) {
      add_visible(CrossingLine(sight, wide_end(scene, camera, crossing->ends[0]), wide_end(scene, camera, crossing->ends[1])));
    } else {
      add_visible(Segment(sight, sight.vertex(edge.from), sight.vertex(edge.to)));
    }
  }
  return picture;
}

}  // namespace sightline::algorithms::oracle
