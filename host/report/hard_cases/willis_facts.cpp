// See willis_facts.hpp.
#include "host/report/hard_cases/willis_facts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "host/algorithms/willis/cut.hpp"
#include "host/algorithms/willis/distance.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/surfaces.hpp"
#include "host/report/willis_views.hpp"

namespace sightline::harness::report::willis_facts {

namespace {

namespace willis = algorithms::willis;
using willis::BoundaryShape;
using willis::Point;
using willis::Surface;

constexpr std::array shapes{BoundaryShape::oval, BoundaryShape::ball};

Verdict verdict(bool good, std::string found = {}) {
  std::string text = good ? "right" : "differs";
  if (!found.empty()) text += ": " + found;
  return {good, std::move(text)};
}

// The sides of a scene's walls: 2 i and 2 i + 1 are those of wall i.
std::vector<Surface> sides_of(const PolyScene& scene) {
  auto walls = willis::walls_of(scene, 1);
  return std::move(*walls);
}

std::vector<std::uint32_t> faces_shown(const Model& model, const scene::PolyCamera& camera) {
  willis::Frames frames(model);
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t piece : frames.order(camera)) faces.push_back(model.pieces[piece].face);
  return faces;
}

Verdict at_length(const PolyScene& scene, bool inside) {
  const auto sides = sides_of(scene);
  bool good = true;
  for (const BoundaryShape shape : shapes) {
    good = good && willis::reaches(sides[2], sides[0], shape) == inside &&
           willis::clustered(sides[0], sides[2], {shape, false}) == inside;
  }
  return verdict(good);
}

// Share of a square of three lengths that the boundaries of the walls cover, by counting.
double covered(const std::vector<Surface>& walls, const Surface& whole, BoundaryShape shape) {
  constexpr int steps = 600;
  const std::int32_t from = whole.points[0][0] < whole.points[1][0] ? whole.points[0][0] : whole.points[1][0];
  const std::int32_t length = std::abs(whole.points[1][0] - whole.points[0][0]);
  int inside = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const auto at = [&](int step) {
        return static_cast<std::int32_t>(std::int64_t{3} * length * (2 * step + 1) / (2 * steps));
      };
      const Point p{from - length + at(i), 0, whole.points[0][2] - 3 * (length / 2) + at(j)};
      inside += std::any_of(walls.begin(), walls.end(),
                            [&](const Surface& wall) { return willis::in_boundary(wall, p, shape); });
    }
  }
  return 9.0 * inside / (steps * steps);  // in squares of the length
}

bool near(double a, double b) {
  return std::abs(a - b) <= 0.002 * b;
}

// s hides the end b of another wall from the eye: it lies beyond s, on a line through the inside of s.
bool hides_end(const Surface& s, const Point& b, const Point& eye) {
  if (s.plane.side(b) >= 0) return false;
  const auto side = [&](const Point& p) {
    const auto u = willis::between(b, eye);
    const auto v = willis::between(p, eye);
    return geometry::sign(geometry::Int128{u[0]} * v[2] - geometry::Int128{u[2]} * v[0]);
  };
  return side(s.points[0]) * side(s.points[1]) < 0;
}

struct Compared {
  std::int64_t pairs = 0;
  std::int64_t wrong = 0;
};

// All choices of corners of every two pieces of which one hides an end of the other.
void compare_from(const Model& model, const Point& eye, Compared& compared) {
  for (const Surface& s : model.pieces) {
    if (s.plane.side(eye) <= 0) continue;
    for (const Surface& t : model.pieces) {
      if (t.body == s.body || t.plane.side(eye) <= 0) continue;
      const bool hidden =
          std::any_of(t.points.begin(), t.points.end(), [&](const Point& b) { return hides_end(s, b, eye); });
      if (!hidden) continue;
      for (const Point& p : s.points) {
        for (const Point& q : t.points) {
          ++compared.pairs;
          compared.wrong += willis::squared_distance(eye, p) >= willis::squared_distance(eye, q);
        }
      }
    }
  }
}

// Points wrong in the worst of the pictures with the first and with the second corner of each piece.
std::uint64_t most_wrong(const Model& model, const TrueFaces& truth) {
  std::uint64_t most = 0;
  for (const std::uint32_t first : {0U, 1U}) {
    for (const std::uint32_t second : {0U, 1U}) {
      std::vector<std::uint32_t> corners;
      for (const Surface& s : model.pieces) corners.push_back(s.face == 0 ? first : second);
      const auto drawn = ordered_faces(model, truth.cameras()[0], truth.size(), corners);
      most = std::max(most, truth.errors_of(drawn, 0).wrong_inside);
    }
  }
  return most;
}

}  // namespace

Verdict at_the_length(const PolyScene& scene, const Model&) {
  return at_length(scene, true);
}

Verdict beyond_the_length(const PolyScene& scene, const Model&) {
  return at_length(scene, false);
}

Verdict one_way(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  bool good = willis::reaches(sides[2], sides[0], BoundaryShape::oval) &&
              !willis::reaches(sides[0], sides[2], BoundaryShape::oval);
  for (const BoundaryShape shape : shapes) {
    good = good && willis::clustered(sides[0], sides[2], {shape, false}) &&
           willis::clustered(sides[2], sides[0], {shape, false});
  }
  return verdict(good);
}

Verdict chain(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  bool good = true;
  for (const BoundaryShape shape : shapes) {
    const auto pair = [&](std::size_t a, std::size_t b) {
      return willis::clustered(sides[2 * a], sides[2 * b], {shape, false});
    };
    good = good && pair(0, 1) && pair(1, 2) && !pair(0, 2);
  }
  return verdict(good);
}

Verdict oval_only(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  const double ratio = willis::two_circles_area() / willis::oval_area();
  return verdict(willis::reach_each_other(sides[0], sides[2], BoundaryShape::oval) &&
                     !willis::reach_each_other(sides[0], sides[2], BoundaryShape::ball) &&
                     std::abs(ratio - 0.98312) < 5e-6,
                 fmt::format("areas {:.5f} to 1", ratio));
}

Verdict areas(const PolyScene& scene, const Model&) {
  const Surface wall = sides_of(scene)[0];
  const auto halves = willis::halved(wall);
  if (!halves) return verdict(false, "not halved");
  const double whole = covered({wall}, wall, BoundaryShape::oval);
  const double circles = covered({wall}, wall, BoundaryShape::ball);
  const double parts = covered({(*halves)[0], (*halves)[1]}, wall, BoundaryShape::oval);
  return verdict(near(whole, willis::oval_area()) && near(circles, willis::two_circles_area()) &&
                     near(parts, willis::halves_ovals_area()),
                 fmt::format("oval {:.3f}, two circles {:.3f}, ovals of the halves {:.3f}, {:.1f} % less",
                             whole, circles, parts, 100 * (1 - parts / whole)));
}

Verdict few_pieces(const PolyScene&, const Model& model) {
  return verdict(model.pieces.size() <= 64, fmt::format("pieces {}", model.pieces.size()));
}

Verdict common_plane(const PolyScene& scene, const Model&) {
  auto made = willis::surfaces_of(scene);
  std::vector<Surface> common;
  for (const Surface& s : *made) {
    if (std::all_of(s.points.begin(), s.points.end(),
                    [](const Point& p) { return p[0] == 100 * willis::lattice_unit; }))
      common.push_back(s);
  }
  return verdict(common.size() == 2 && !willis::can_obscure(common[0], common[1]) &&
                 !willis::can_obscure(common[1], common[0]));
}

Verdict first_not_shown(const PolyScene& scene, const Model& model) {
  const auto shown = faces_shown(model, scene.camera);
  return verdict(std::count(shown.begin(), shown.end(), 0U) == 0 &&
                 std::count(shown.begin(), shown.end(), 1U) > 0);
}

Verdict equal_distances(const PolyScene& scene, const Model& model) {
  std::vector<Surface> sides = sides_of(scene);
  std::reverse(sides.begin(), sides.end());
  const Model backwards = willis::make_model(std::move(sides), {.plan = true});
  const std::uint64_t far = std::uint64_t{500} * willis::lattice_unit;
  const auto drawn = [&](const Model& of) {
    std::vector<std::uint32_t> corners;
    for (const Surface& s : of.pieces)
      corners.push_back(willis::squared_distance(s.points[0], {}) == far * far ? 0U : 1U);
    const bool equal =
        std::all_of(of.pieces.begin(), of.pieces.end(), [&, i = std::size_t{0}](const Surface& s) mutable {
          return willis::squared_distance(s.points[corners[i++]], {}) == far * far;
        });
    return std::pair{equal, ordered_faces(of, scene.camera, 256, corners)};
  };
  const auto forwards = drawn(model);
  return verdict(forwards.first && forwards == drawn(backwards));
}

Verdict both_cut(const PolyScene&, const Model& model) {
  std::array<std::size_t, 2> pieces{};
  for (const Surface& s : model.pieces) ++pieces[s.face];
  return verdict(
      pieces[0] >= 24 && pieces[0] <= 80 && pieces[1] >= 4,
      fmt::format("pieces of both sides: {} of the long wall, {} of the short one", pieces[0], pieces[1]));
}

Verdict cut_where_they_cross(const PolyScene&, const Model& model) {
  const auto straddles = [](const Surface& s, const Surface& t) {
    return t.plane.side(s.points[0]) * t.plane.side(s.points[1]) < 0;
  };
  bool good = true;
  for (const Surface& s : model.pieces)
    for (const Surface& t : model.pieces) good = good && !(straddles(s, t) && straddles(t, s));
  return verdict(good, fmt::format("pieces {}", model.pieces.size()));
}

Verdict any_representative(const PolyScene&, const Model& model) {
  Compared compared;
  for (const double radius : {300.0, 1500.0, 40000.0}) {
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * std::numbers::pi / 180;
      compare_from(model,
                   willis::on_lattice({static_cast<std::int32_t>(1700 + radius * std::cos(angle)), 0,
                                       static_cast<std::int32_t>(1700 + radius * std::sin(angle))}),
                   compared);
    }
  }
  return verdict(compared.wrong == 0 && compared.pairs > 1000,
                 fmt::format("{} of {} in the wrong order", compared.wrong, compared.pairs));
}

Verdict right_angle(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  bool good = geometry::dot(sides[0].plane.normal, sides[2].plane.normal) == 0;
  int can = 0;
  for (const std::size_t s : {0U, 1U}) {
    for (const std::size_t t : {2U, 3U}) {
      good = good && willis::can_obscure(sides[s], sides[t], true) == willis::can_obscure(sides[s], sides[t]);
      can += willis::can_obscure(sides[s], sides[t]);
    }
  }
  return verdict(good && can > 0);
}

Verdict beyond_90_degrees(const PolyScene& scene, const Model&) {
  std::vector<Surface> seen;
  for (const Surface& s : sides_of(scene))
    if (s.plane.side(willis::on_lattice(scene.camera.eye)) > 0) seen.push_back(s);
  const TrueFaces truth(scene, {scene.camera}, 128);
  const Model paper = willis::make_model(seen, {.rules = {BoundaryShape::ball, true}, .plan = true});
  const Model model = willis::make_model(seen, {.plan = true});
  const std::uint64_t wrong = most_wrong(paper, truth);
  const std::uint64_t left = most_wrong(model, truth);
  return verdict(
      paper.clusters == 0 && wrong > 0 && model.clusters > 0 && model.residual.empty() && left == 0,
      fmt::format("points wrong: {} with the rule, {} without", wrong, left));
}

Verdict on_the_plane(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  const auto hidden = [&](std::size_t by, std::size_t wall) {
    return willis::can_obscure(sides[by], sides[2 * wall]) ||
           willis::can_obscure(sides[by], sides[2 * wall + 1]);
  };
  // Side 0 of the first wall is seen from before z = 0, where the second one's other end is not.
  return verdict(hidden(0, 1) && !hidden(1, 1) && !hidden(0, 2) && !hidden(1, 2));
}

Verdict not_overflowing(const PolyScene& scene, const Model&) {
  const auto sides = sides_of(scene);
  const std::uint64_t side = std::uint64_t{2} * (scene::poly_coordinate_limit - 1) * willis::lattice_unit;
  const Surface& t = sides[2];
  return verdict(willis::squared_diameter(sides[0].points) == side * side &&
                 willis::within(sides[0].points[0], t.points, t.plane.normal, side * side) &&
                 !willis::within(sides[0].points[0], t.points, t.plane.normal, side * side - 1));
}

}  // namespace sightline::harness::report::willis_facts
