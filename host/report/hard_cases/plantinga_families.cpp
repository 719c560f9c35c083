// Angles and crossings nearer and nearer to each other: what single and double precision get wrong first.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/report/hard_cases/plantinga.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;
using native::Segment;

// Two directions X : Z, the second after the first.
struct TwoDirections {
  std::array<std::int64_t, 2> first;
  std::array<std::int64_t, 2> second;
};

// Neighbouring quotients of Fibonacci numbers: the least angles between fractions of their size.
TwoDirections neighbours(int n) {
  std::array<std::int64_t, 3> f{1, 1, 2};
  for (int i = 0; i < n; ++i) f = {f[1], f[2], f[1] + f[2]};
  TwoDirections two{{f[0], f[1]}, {f[1], f[2]}};
  if (n % 2 == 0) std::swap(two.first, two.second);
  return two;
}
// -log2 of the angle between them.
double separation(const TwoDirections& two) {
  const auto length = [](const std::array<std::int64_t, 2>& d) {
    return std::hypot(static_cast<double>(d[0]), static_cast<double>(d[1]));
  };
  return std::log2(length(two.first)) + std::log2(length(two.second));
}

// The sine of the second less the first, but for positive factors.
template <class Real>
bool by_products(const TwoDirections& two) {
  const Real left = static_cast<Real>(two.second[0]) * static_cast<Real>(two.first[1]);
  const Real right = static_cast<Real>(two.second[1]) * static_cast<Real>(two.first[0]);
  return left - right > 0;
}
template <class Real>
bool by_angles(const TwoDirections& two) {
  const auto angle = [](const std::array<std::int64_t, 2>& d) {
    return std::atan2(static_cast<Real>(d[0]), static_cast<Real>(d[1]));
  };
  return angle(two.first) < angle(two.second);
}
bool exactly(const TwoDirections& two) {
  return native::compare(native::rational_direction(two.first[0], two.first[1]),
                         native::rational_direction(two.second[0], two.second[1])) < 0;
}

// Along Z an upright edge is crossed by two others, at fractions of it 2^-3j apart: the lower of denominator
// (2^j + 1) 2^j, the upper of (2^j - 1) 2^j, numerators such that their difference is as small as can be.
std::array<Segment, 3> triple_point(int j) {
  const std::int64_t two = std::int64_t{1} << j;
  const auto across = [](std::int64_t numerator, std::int64_t width, std::int64_t z) {
    const std::int64_t low = numerator / width;
    const std::int64_t left = numerator % width;
    return Segment{{-left, low, z}, {width - left, low + 1, z}};
  };
  return {Segment{{0, 0, 0}, {0, two, 0}}, across(two * two / 2 + two + 1, two + 1, 3),
          across(two * two / 2, two - 1, 5)};
}

// N / D of equation 5a along Z: of the second edge less than of the third?
template <class Real>
bool crossings_in_order(const std::array<Segment, 3>& edges) {
  const auto crossing = [&](const Segment& g) {
    const auto along = [](std::int64_t from, std::int64_t to) { return static_cast<Real>(to - from); };
    const Segment& e = edges[0];
    const Real gx = along(g.from[0], g.to[0]);
    const Real gy = along(g.from[1], g.to[1]);
    const Real ex = along(e.from[0], e.to[0]);
    const Real ey = along(e.from[1], e.to[1]);
    const Real n = along(e.from[0], g.from[0]) * gy - along(e.from[1], g.from[1]) * gx;
    return std::pair<Real, Real>{n, ex * gy - ey * gx};
  };
  const auto [n2, d2] = crossing(edges[1]);
  const auto [n3, d3] = crossing(edges[2]);
  return n2 * d3 < n3 * d2;
}
bool crossings_exactly(const std::array<Segment, 3>& edges) {
  const auto second = native::crossing_of(edges[0], edges[1]);
  const auto third = native::crossing_of(edges[0], edges[2]);
  return native::meeting_form(second, third).zz < 0;
}

// The second and third edge as the lower sides of sheets before the first: it must end at the second.
bool ends_at_the_lower(const std::array<Segment, 3>& edges) {
  scene::PolyScene scene;
  const auto add = [&scene](const Segment& side, std::int64_t third_y) {
    const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
    const auto point = [](const native::Vector3& p) {
      return scene::PolyPoint{static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]),
                              static_cast<std::int32_t>(p[2])};
    };
    scene.vertices.push_back(point(side.from));
    scene.vertices.push_back(point(side.to));
    scene.vertices.push_back(
        point({side.from[0] == side.to[0] ? side.from[0] + 1 : 0, third_y, side.from[2]}));
    scene::PolyBody body;
    body.sheet = true;
    body.faces.push_back({{first, first + 1, first + 2}, {}});
    scene.bodies.push_back(std::move(body));
  };
  const std::int64_t top = edges[0].to[1];
  for (const Segment& edge : edges) add(edge, &edge == &edges[0] ? 0 : 2 * top);
  const native::RotationModel model(scene);
  const auto edge_of = [&](scene::VertexIndex from, scene::VertexIndex to) {
    const auto found = std::find_if(model.edges().begin(), model.edges().end(), [&](const auto& edge) {
      return std::minmax(edge.from, edge.to) == std::minmax(from, to);
    });
    return static_cast<native::EdgeIndex>(found - model.edges().begin());
  };
  const native::EdgeIndex upright = edge_of(0, 1);
  const auto pieces = native::structure_at(model, upright, model.occluders_of(upright), {0, 1});
  return pieces.size() == 1 && pieces[0].high == native::End::of(native::EndKind::junction, edge_of(3, 4));
}

using Trial = std::function<bool(int)>;

void add_row(Table& table, std::array<std::string, 3> names, int last, const Trial& right,
             const std::function<double(int)>& bits, int first = 2) {
  std::vector<Cell> row{std::move(names[0]), std::move(names[1]), std::move(names[2])};
  for (int k = first; k <= last; ++k) {
    if (right(k)) continue;
    row.insert(row.end(), {Real{bits(k), 0}, Verdict{false, "the wrong order"}});
    table.rows.push_back(std::move(row));
    return;
  }
  row.insert(row.end(), {Cell(), Verdict{true, fmt::format("none up to 2^-{:.0f}", bits(last))}});
  table.rows.push_back(std::move(row));
}

}  // namespace

Table plantinga_families(const Context& context) {
  context.progress("hard cases P2, P6: first failures");
  Table table;
  table.id = "hard-cases-plantinga-first-failures";
  table.title = "Plantinga, Seales and Dyer: nearly equal angles, and what gets them wrong first";
  table.columns = {{"case", "Case", "", false},
                   {"input", "Input", "", false},
                   {"build", "Build", "", false},
                   {"first_failure", "First failure", "k of 2^-k", false},
                   {"what", "What happens", "", false}};
  const std::string angles =
      "order of two events at neighbouring quotients of Fibonacci numbers, 2^-k rad apart";
  const auto apart = [](int n) { return separation(neighbours(n)); };
  const auto two = [](bool (*right)(const TwoDirections&)) {
    return [right](int n) { return right(neighbours(n)); };
  };
  constexpr int most_n = 66;
  add_row(table, {"P6", angles, "angles in single precision"}, most_n, two(by_angles<float>), apart);
  add_row(table, {"P6", angles, "products in single precision"}, most_n, two(by_products<float>), apart);
  add_row(table, {"P6", angles, "angles in doubles"}, most_n, two(by_angles<double>), apart);
  add_row(table, {"P6", angles, "products in doubles"}, most_n, two(by_products<double>), apart);
  add_row(table, {"P6", angles, "exact"}, most_n, two(exactly), apart);
  const std::string crossings =
      "two edges that cross a third 2^-k of its length apart, as whole numbers of k/3 bits";
  const auto third = [](int j) { return 3.0 * j; };
  const auto triple = [](bool (*right)(const std::array<Segment, 3>&)) {
    return [right](int j) { return right(triple_point(j)); };
  };
  add_row(table, {"triple point", crossings, "single precision"}, 21, triple(crossings_in_order<float>),
          third);
  add_row(table, {"triple point", crossings, "doubles"}, 21, triple(crossings_in_order<double>), third);
  add_row(table, {"triple point", crossings, "exact"}, 21, triple(crossings_exactly), third);
  add_row(table, {"triple point", crossings, "exact, structure of a scene of sheets"}, 16,
          triple(ends_at_the_lower), third, 3);
  table.notes = {
      "Coordinates of scenes end at 2^18, those of events at 2^23, directions of events at 2^52; the angles "
      "between events that scenes can have reach 2^-104. Doubles go wrong where a product needs more than 53 "
      "bits. What orders events here takes doubles first, and decides exactly where they are too near."};
  return table;
}

}  // namespace sightline::harness::report
