#include "host/algorithms/oracle/edge_oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/geometry/predicates.hpp"

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

// What is known at both ends of the edge of a quantity that is linear along it.
struct Linear {
  std::int64_t from = 0;
  std::int64_t to = 0;

  [[nodiscard]] int sign_at(const Rational& s) const {
    return sign(Int128{from} * (s.denominator() - s.numerator()) + Int128{to} * s.numerator());
  }
};

// Points as the eye sees them. Its three functions are determinants of the eye and three points, the eye
// being a point or, if the view is orthographic, the direction towards it.
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
  [[nodiscard]] std::int64_t depth(const Vector& p) const { return dot(forward_, p); }
  // Positive if x is seen to the left of the line from p to q.
  [[nodiscard]] std::int64_t side(const Vector& p, const Vector& q, const Vector& x) const {
    return perspective_ ? determinant(p, q, x) : determinant(q - p, x - p, forward_);
  }
  // The same for the line from x in the direction of w.
  [[nodiscard]] std::int64_t side_of_ray(const Vector& x, const Vector& w, const Vector& p) const {
    return perspective_ ? determinant(x, w, p) : determinant(forward_, w, p - x);
  }
  // How side(p, q, .) grows in the direction of w.
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
  std::vector<LineEdge> sides;  // in no order: a point is inside if a ray from it crosses an odd number
  Vector normal{};              // of length twice the area: below 2^39 in each component
  Vector on{};
  std::int64_t eye_side = 0;
  std::uint32_t surface = 0;
  bool sheet = false;
};

void add_ring(const std::vector<scene::VertexIndex>& ring, const Sight& sight, Face& face) {
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

// The test of one edge.
class EdgeTest {
 public:
  EdgeTest(const Sight& sight, const LineEdge& edge)
      : sight_(sight), a_(sight.vertex(edge.from)), b_(sight.vertex(edge.to)) {
    for (std::size_t axis = 0; axis < 3 && !has_image_; ++axis) {
      leftward_ = {};
      leftward_[axis] = 1;
      const std::int64_t growth = sight.growth(a_, b_, leftward_);
      if (growth < 0) leftward_[axis] = -1;
      has_image_ = growth != 0;
    }
  }

  [[nodiscard]] bool has_image() const { return has_image_; }

  geometry::IntervalSet visible(const std::vector<Face>& faces, const std::vector<LineEdge>& edges) {
    collect_faces(faces);
    const std::vector<Rational> cuts = cuts_by(edges);
    geometry::IntervalSet visible;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (visible_at(mediant(cuts[i], cuts[i + 1]))) visible.unite(cuts[i], cuts[i + 1]);
    }
    return visible;
  }

 private:
  // A face with what its tests need at both ends of the edge.
  struct Candidate {
    const Face* face;
    Linear beyond;  // of the plane of the face, on the other side than the eye, if positive
    struct Side {
      Linear left;                  // of the side of the face
      std::array<Linear, 2> turns;  // of the ends of the side against the ray to the left
    };
    std::vector<Side> sides;
  };

  [[nodiscard]] Linear left_of(const LineEdge& line) const {
    const Vector& p = sight_.vertex(line.from);
    const Vector& q = sight_.vertex(line.to);
    return {sight_.side(p, q, a_), sight_.side(p, q, b_)};
  }

  // A face wholly to one side of the edge's image line hides nothing of it; neither does one beyond it.
  void collect_faces(const std::vector<Face>& faces) {
    place_.resize(sight_.vertex_count());
    for (std::size_t v = 0; v < place_.size(); ++v) {
      place_[v] = sign(sight_.side(a_, b_, sight_.vertex(static_cast<scene::VertexIndex>(v))));
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
      const std::int64_t outward = face.eye_side > 0 ? -1 : 1;
      const Linear beyond{outward * dot(face.normal, a_ - face.on), outward * dot(face.normal, b_ - face.on)};
      if (beyond.from <= 0 && beyond.to <= 0) continue;
      candidates_.push_back({&face, beyond, {}});
      for (const LineEdge& side : face.sides) {
        const auto turn = [&](scene::VertexIndex v) {
          return Linear{sight_.side_of_ray(a_, leftward_, sight_.vertex(v)),
                        sight_.side_of_ray(b_, leftward_, sight_.vertex(v))};
        };
        candidates_.back().sides.push_back({left_of(side), {turn(side.from), turn(side.to)}});
      }
    }
  }

  static void cut(const Linear& quantity, std::vector<Rational>& cuts) {
    if ((quantity.from < 0 && quantity.to > 0) || (quantity.from > 0 && quantity.to < 0)) {
      cuts.emplace_back(quantity.from, quantity.from - quantity.to);
    }
  }

  [[nodiscard]] std::vector<Rational> cuts_by(const std::vector<LineEdge>& edges) const {
    std::vector<Rational> cuts{Rational(0), Rational(1)};
    for (const LineEdge& line : edges) {
      if (place_[line.from] * place_[line.to] <= 0) cut(left_of(line), cuts);
    }
    for (const Candidate& candidate : candidates_) cut(candidate.beyond, cuts);
    if (sight_.perspective()) cut(depth(), cuts);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  [[nodiscard]] Linear depth() const { return {sight_.depth(a_), sight_.depth(b_)}; }

  [[nodiscard]] bool visible_at(const Rational& s) const {
    if (sight_.perspective() && depth().sign_at(s) <= 0) return false;
    return !hidden_at(s, 1) || !hidden_at(s, -1);
  }

  // Hidden in the limit from the left (1) or the right (-1) of the edge.
  [[nodiscard]] bool hidden_at(const Rational& s, int hand) const {
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
      return candidate.beyond.sign_at(s) > 0 && covers(candidate, s, hand);
    });
  }

  // Counts the sides that a ray from the point to the left or right crosses. A side in line with the edge is
  // not crossed: the ray starts a little beside it. A vertex on the ray counts as off it to one fixed side.
  static bool covers(const Candidate& candidate, const Rational& s, int hand) {
    bool inside = false;
    for (const Candidate::Side& side : candidate.sides) {
      const bool first = hand * side.turns[0].sign_at(s) > 0;
      const bool second = hand * side.turns[1].sign_at(s) > 0;
      if (first != second && side.left.sign_at(s) * (second ? 1 : -1) > 0) inside = !inside;
    }
    return inside;
  }

  const Sight& sight_;
  Vector a_;
  Vector b_;
  Vector leftward_{};  // along an axis, so that tests stay narrow
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
    EdgeTest test(sight, edge);
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
    EdgeTest test(sight, chosen.edges[e]);
    if (!test.has_image()) continue;
    const auto beside = chosen.surfaces_at(e);
    std::vector<Face> hiding;
    for (const Face& face : faces) {
      const bool own = std::find(beside.begin(), beside.end(), face.surface) != beside.end();
      if (!own && (face.sheet || face.eye_side > 0)) hiding.push_back(face);
    }
    const geometry::IntervalSet visible = test.visible(hiding, edges);
    for (const geometry::Interval& seen : visible.intervals())
      picture.pieces.push_back({chosen.edges[e], seen.low, seen.high});
  }
  return picture;
}

}  // namespace sightline::algorithms::oracle
