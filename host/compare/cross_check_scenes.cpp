// See cross_check_scenes.hpp.
#include "host/compare/cross_check_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::compare {

namespace {

using scene::PolyCamera;
using scene::PolyPoint;
using scene::PolyScene;

// 38 times the rotation of the quaternion (6, 1, 0, 1): 13 degrees about x and y each.
PolyPoint tilt(const PolyPoint& p) {
  return {36 * p[0] - 12 * p[1] + 2 * p[2], 12 * p[0] + 34 * p[1] - 12 * p[2],
          2 * p[0] + 12 * p[1] + 36 * p[2]};
}

void tilt(PolyScene& scene) {
  for (PolyPoint& p : scene.vertices) p = tilt(p);
  PolyCamera& camera = scene.camera;
  camera = {camera.perspective, tilt(camera.eye), tilt(camera.forward), tilt(camera.right),
            tilt(camera.up)};
}

void enlarge(PolyScene& scene, std::int32_t times) {
  for (PolyPoint& p : scene.vertices)
    for (std::int32_t& c : p) c *= times;
}

scene::CellScene built_in(std::string_view name) {
  auto loaded = scene::load_cell_scene(std::string(name));
  return std::move(*loaded);
}

// Walls of thickness 10, towards greater coordinates. The wall across x begins behind the one across z.
PolyScene solid_house() {
  constexpr std::int32_t thickness = 10;
  scene::CellScene house = built_in("house");
  for (const geometry::Rectangle& wall : house.walls) {
    const auto [u, v] = geometry::other_axes(wall.axis);
    geometry::Box box;
    box.low[wall.axis] = wall.at;
    box.high[wall.axis] = wall.at + thickness;
    box.low[u] = wall.sides[0].low;
    box.high[u] = wall.sides[0].high;
    box.low[v] = wall.sides[1].low;
    box.high[v] = wall.sides[1].high;
    constexpr std::int32_t across_z = 400;
    if (wall.axis == 0 && box.low[2] == across_z) box.low[2] += thickness;
    house.solids.push_back(box);
  }
  house.walls.clear();
  return poly_scene_of(house);
}

// A parallelepiped at o along three right-handed edges.
void add_brick(scene::PolyBuilder& builder, const std::string& name, const PolyPoint& o,
               const std::array<PolyPoint, 3>& along) {
  std::array<scene::VertexIndex, 8> corners{};
  for (unsigned corner = 0; corner < 8; ++corner) {
    PolyPoint p = o;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += ((corner >> k) & 1U) != 0 ? along[k][axis] : 0;
    corners[corner] = builder.vertex(p);
  }
  scene::PolyBody body{name, false, {}};
  for (const auto& ring : std::array<std::array<unsigned, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}) {
    scene::PolyFace face;
    for (const unsigned corner : ring) face.outline.push_back(corners[corner]);
    body.faces.push_back(std::move(face));
  }
  builder.scene().bodies.push_back(std::move(body));
}

PolyScene tilted_boxes() {
  scene::PolyBuilder builder;
  add_brick(builder, "left", {-60, -31, -17}, {{{50, 7, 11}, {-6, 61, 9}, {-13, -5, 47}}});
  add_brick(builder, "right", {25, -40, 3}, {{{37, 5, -9}, {4, 83, 7}, {11, -3, 41}}});
  add_brick(builder, "behind", {-20, -10, 60}, {{{45, -8, 5}, {7, 39, -6}, {-4, 9, 33}}});
  return builder.take();
}

// Three bars, each in front of the next, and two interlocked U shapes, each in front of the other in one place (after
// Montani and Re, Figure 10).
PolyScene cycles() {
  scene::PolyBuilder builder;
  add_brick(builder, "bar 0", {-4, -2, 0}, {{{38, 0, 10}, {0, 4, 0}, {0, 0, 2}}});
  add_brick(builder, "bar 1", {31, -4, 0}, {{{-18, 33, 10}, {-4, -2, 0}, {0, 0, 2}}});
  add_brick(builder, "bar 2", {12, 30, 0}, {{{-17, -34, 10}, {4, -2, 0}, {0, 0, 2}}});
  const auto sheet = [&builder](const char* name, std::vector<PolyPoint> outline) {
    for (PolyPoint& p : outline) p[0] += 70;
    builder.add_sheet(name, outline);
  };
  sheet("upright U", {{0, 0, 10},
                      {30, 0, 10},
                      {30, 30, 10},
                      {20, 30, 10},
                      {20, 10, 10},
                      {10, 10, 10},
                      {10, 30, 10},
                      {0, 30, 10}});
  sheet("leaning U", {{-5, 13, -10},
                      {35, 13, 30},
                      {35, 16, 30},
                      {5, 16, 0},
                      {5, 22, 0},
                      {35, 22, 30},
                      {35, 25, 30},
                      {-5, 25, -10}});
  return builder.take();
}

// Through the hole of a leaning plate one sees the hole of another plate, and a box through that.
PolyScene holes() {
  scene::PolyBuilder builder;
  const auto plate = [&builder](const char* name, const PolyPoint& o, const PolyPoint& u, const PolyPoint& v,
                                std::int32_t from, std::int32_t to) {
    const auto at = [&](std::int32_t a, std::int32_t b) {
      return builder.vertex(
          {o[0] + a * u[0] + b * v[0], o[1] + a * u[1] + b * v[1], o[2] + a * u[2] + b * v[2]});
    };
    scene::PolyFace face{{at(0, 0), at(10, 0), at(10, 10), at(0, 10)},
                         {{at(from, from), at(from, to), at(to, to), at(to, from)}}};
    builder.scene().bodies.push_back({name, true, {std::move(face)}});
  };
  plate("front", {-52, -47, 0}, {10, 1, 2}, {-1, 10, 1}, 2, 8);
  plate("middle", {-50, -51, 70}, {10, -1, -3}, {1, 10, 2}, 3, 7);
  add_brick(builder, "back", {-30, -23, 150}, {{{61, 7, 9}, {-8, 49, 5}, {3, -4, 27}}});
  return builder.take();
}

// The scene's own camera, with a view of 90 degrees. It is perspective and its vectors have one length.
CrossCheckView own_view(const PolyScene& scene) {
  CrossCheckView view;
  view.camera = scene.camera;
  view.unit = view.size;
  return view;
}

CommonScene tilted_scene(std::string_view name, std::string_view title, PolyScene scene) {
  CommonScene common{name, title, std::move(scene), {}, false, {}, {}, {}, {}};
  tilt(common.scene);
  common.views = {parallel_view(common.scene, 3, 4, 5), parallel_view(common.scene, -5, 12, 13),
                  own_view(common.scene)};
  return common;
}

CommonScene parallel_scene(std::string_view name, std::string_view title, PolyScene scene,
                           std::int32_t times) {
  CommonScene common{name, title, std::move(scene), {}, false, {}, {}, {}, {}};
  enlarge(common.scene, times);
  common.views = {parallel_view(common.scene, 0, 1, 1), parallel_view(common.scene, 3, 4, 5),
                  parallel_view(common.scene, -5, 12, 13)};
  common.scene.camera = common.views[0].camera;
  return common;
}

// Includes a view from between the houses, some of which extend from before the eye to behind it.
CommonScene street() {
  CommonScene common = tilted_scene("C3", "street of 8 houses", poly_scene_of(built_in("street4")));
  common.views.push_back(common.views.back());
  common.views.back().camera.eye = tilt({37, 160, 600});
  return common;
}

// One triangle in each of 16 of 27 cells: along the rows of cells they hide each other.
CommonScene triangles() {
  CommonScene common = parallel_scene("C6", "16 random triangles", scene::generate_triangles(16), 8);
  common.views[2] = parallel_view(common.scene, 1, 0, 1);
  return common;
}

CommonScene corridor() {
  CommonScene common{"C4", "corridor of 8 rooms", scene::generate_corridors(8), {}, false, {}, {}, {}, {}};
  common.views = {own_view(common.scene)};
  return common;
}

CommonScene prism_town() {
  CommonScene common{"C9", "35 turned houses, in plan", scene::generate_prisms(35), {}, true, {}, {}, {}, {}};
  common.views = {parallel_view(common.scene, 3, 4, 5), own_view(common.scene)};
  return common;
}

// A built-in scene of cells, seen from its own eye and from one where the error of Jones's program is near its bound,
// with any number of fraction bits.
CommonScene cell_scene(std::string_view name, std::string_view built_in_name, std::string_view title, const PolyPoint& far_off) {
  CommonScene common{name, title, {}, {}, false, {}, {}, built_in(built_in_name), {}};
  auto matter = algorithms::oracle::MatterScene::of(*common.cells);
  common.matter.emplace(std::move(*matter));
  common.scene = common.matter->scene();
  common.views = {own_view(common.scene), own_view(common.scene)};
  common.views[1].camera.eye = far_off;
  return common;
}

constexpr std::array<std::string_view, 15> names{"C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8",
                                                 "C9", "H1", "H2", "J1", "J2", "J3", "J4"};

constexpr std::size_t side = 32;
constexpr double highest = 3720;

double degrees(double sine) {
  return std::asin(sine) * 180 / std::numbers::pi;
}

// Scales heights to integers between -highest and highest.
void quantise(scene::HeightGrid& grid) {
  const scene::Interval range = scene::finite_range(grid.heights);
  for (double& h : grid.heights) {
    const double part = (h - range.low) / (range.high - range.low);
    h = std::floor(highest * (2 * part - 1) + 0.5);
  }
  grid.range = {-highest, highest};
}

std::int64_t dot(const PolyPoint& a, const PolyPoint& b) {
  return geometry::dot(geometry::vector_of(a), geometry::vector_of(b));
}

}  // namespace

std::span<const std::string_view> common_scene_names() {
  return names;
}

CommonScene common_scene(std::string_view name) {
  if (name == "C1") return tilted_scene(name, "house of solid walls that touch", solid_house());
  if (name == "C2") return tilted_scene(name, "roberts", poly_scene_of(built_in("roberts")));
  if (name == "C3") return street();
  if (name == "C4") return corridor();
  if (name == "C5") return parallel_scene(name, "three tilted boxes", tilted_boxes(), 64);
  if (name == "C6") return triangles();
  if (name == "C7") return parallel_scene(name, "cycles: three bars, two U", cycles(), 64);
  if (name == "C8") return parallel_scene(name, "a hole seen through a hole", holes(), 64);
  if (name == "C9") return prism_town();
  if (name == "J1") return cell_scene(name, "house", "cells: house", {429, 182, 135});
  if (name == "J2") return cell_scene(name, "roberts", "cells: roberts", {215, 14, 14});
  if (name == "J3") return cell_scene(name, "street4", "cells: street4", {-115, 597, 291});
  if (name == "J4") return cell_scene(name, "corridor8", "cells: corridor8", {273, 3, 824});
  if (name == "H1") return height_scene(name, "sin(r)/r, 32 x 32", "sinc", 3, 4);
  return height_scene(name, "terrain with cliffs, 32 x 32", "terrain", 4, 3);
}

// Functions of two variables among the common scenes.
//
// With X, Z odd from -31 to 31, D = 7 X + 24 Z and an integer height k from -3720 to 3720, a point's place on the
// screen is 40 (24 X - 7 Z) and c k + 8 s D, and its depth 8 c D - s k, where s and c are the sine and cosine of
// the elevation in fifths: 31000 times Skala's projection of x = X / 31, z = Z / 31, h = k / 3720, in integers.

CommonScene height_scene(std::string_view name, std::string_view title, std::string_view function,
                         std::int32_t sine, std::int32_t cosine) {
  scene::HeightGrid grid = sample(*scene::height_function(function), {side, side});
  quantise(grid);
  CommonScene common{name, title, {}, {}, false, {}, {}, {}, {}};
  scene::PolyScene& scene = common.scene;
  scene.name = function;
  const auto odd = [](std::size_t i) { return 2 * static_cast<std::int32_t>(i) - 31; };
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const std::int32_t d = 7 * odd(i) + 24 * odd(j);
      const auto k = static_cast<std::int32_t>(grid.height(i, j));
      scene.vertices.push_back(
          {40 * (24 * odd(i) - 7 * odd(j)), cosine * k + 8 * sine * d, 8 * cosine * d - sine * k});
    }
  }
  scene::PolyBody body{"surface", true, {}};
  for (std::size_t j = 0; j + 1 < side; ++j) {
    for (std::size_t i = 0; i + 1 < side; ++i) {
      // Divided between the corners at the sides, as Skala's cells are: one triangle is in front of the other.
      const auto near = static_cast<scene::VertexIndex>(j * side + i);
      const scene::VertexIndex beside = near + 1;
      const scene::VertexIndex behind = near + side;
      body.faces.push_back({{near, beside, behind}, {}});
      body.faces.push_back({{beside, behind + 1, behind}, {}});
    }
  }
  scene.bodies.push_back(std::move(body));
  common.views = {parallel_view(scene, 0, 1, 1, 512)};
  scene.camera = common.views[0].camera;
  common.heights = std::move(grid);
  common.height_view.subject = algorithms::skala::Subject::surface;
  common.height_view.rotation = -degrees(7.0 / 25);
  common.height_view.elevation = degrees(sine / 5.0);
  return common;
}

// Windows and places of pixels.

registry::FaceWindow CrossCheckView::window() const {
  const double half = size / 2.0;
  const double length = std::sqrt(static_cast<double>(dot(camera.right, camera.right)));
  return {size, size, camera.perspective ? unit / 2.0 : 1 / (2.0 * unit * length), half, half};
}

// The coordinates of a point along right, up and forward from the eye, in lengths of the vectors.
std::array<double, 3> CrossCheckView::in_camera(const PolyPoint& point) const {
  const auto d = geometry::difference(point, camera.eye);
  const double length = std::sqrt(static_cast<double>(dot(camera.right, camera.right)));
  std::array<double, 3> coordinates{};
  for (std::size_t a = 0; const PolyPoint& axis : {camera.right, camera.up, camera.forward})
    coordinates[a++] = static_cast<double>(geometry::dot(geometry::vector_of(axis), d)) / length;
  return coordinates;
}

picture::PixelPoint CrossCheckView::project(const std::array<double, 3>& p) const {
  const double scale = window().scale / (camera.perspective ? p[2] : 1);
  const double middle = size / 2.0 - 0.5;
  return {middle + scale * p[0], middle + scale * p[1]};
}

bool CrossCheckView::has_place(const PolyPoint& point) const {
  return !camera.perspective || in_camera(point)[2] >= nearest;
}

picture::PixelPoint CrossCheckView::place(const PolyPoint& point) const {
  return project(in_camera(point));
}

std::optional<picture::PixelSegment> CrossCheckView::place(const PolyPoint& from, const PolyPoint& to,
                                                           const picture::LinePart& piece) const {
  const auto a = in_camera(from);
  const auto b = in_camera(to);
  auto [low, high] = piece;
  if (camera.perspective) {
    if (std::max(a[2], b[2]) < nearest) return std::nullopt;
    const double at_nearest = (nearest - a[2]) / (b[2] - a[2]);
    if (a[2] < nearest) low = std::max(low, at_nearest);
    if (b[2] < nearest) high = std::min(high, at_nearest);
    if (low >= high) return std::nullopt;
  }
  const auto at = [&](double s) {
    return project({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])});
  };
  return picture::PixelSegment{at(low), at(high)};
}

CrossCheckView parallel_view(const PolyScene& scene, std::int32_t p, std::int32_t q, std::int32_t h,
                             int size) {
  CrossCheckView view;
  view.size = size;
  view.camera = {false, {}, {p, 0, q}, {q, 0, -p}, {0, h, 0}};
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, 3> low{most, most, most};
  std::array<std::int64_t, 3> high{-most, -most, -most};
  const std::array<PolyPoint, 3> axes{view.camera.right, view.camera.up, view.camera.forward};
  for (const PolyPoint& v : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], dot(axes[a], v));
      high[a] = std::max(high[a], dot(axes[a], v));
    }
  }
  // In front of the whole scene, level with its centre, in lengths of the vectors.
  const std::int64_t square = std::int64_t{h} * h;
  const std::array<std::int64_t, 3> eye{(low[0] + high[0]) / 2 / square, (low[1] + high[1]) / 2 / square,
                                        low[2] / square - 2};
  for (std::size_t a = 0; a < 3; ++a)
    view.camera.eye[a] =
        static_cast<std::int32_t>(eye[0] * axes[0][a] + eye[1] * axes[1][a] + eye[2] * axes[2][a]);
  const std::int64_t extent = std::max(high[0] - low[0], high[1] - low[1]) / square;
  constexpr std::int64_t border = 4;  // pixels, on each side
  view.unit = static_cast<std::int32_t>(extent / (2 * (size - 2 * border)) + 1);
  return view;
}

}  // namespace sightline::compare
