// See cross_check_scenes.hpp.
#include "host/compare/cross_check_scenes.hpp"

#include <array>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::compare {
namespace {

using scene::PolyCamera;
using scene::PolyPoint;
using scene::PolyScene;

// 38 times the rotation of the quaternion (6, 1, 0, 1): 13 degrees about x and y each.
PolyPoint tilted(const PolyPoint& p) {
  return {36 * p[0] - 12 * p[1] + 2 * p[2], 12 * p[0] + 34 * p[1] - 12 * p[2],
          2 * p[0] + 12 * p[1] + 36 * p[2]};
}

void tilt(PolyScene& scene) {
  for (PolyPoint& p : scene.vertices) p = tilted(p);
  PolyCamera& camera = scene.camera;
  camera = {camera.perspective, tilted(camera.eye), tilted(camera.forward), tilted(camera.right),
            tilted(camera.up)};
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

// Three bars, each before the next, and beside them two U that reach into each other: each is before the
// other in one place (after Montani and Re, Figure 10).
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

// Through the hole of a leaning plate the hole of another one, and through that a box.
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

// The scene's own camera, which is in perspective and has vectors of one length, over a right angle.
AgreementView own_view(const PolyScene& scene) {
  AgreementView view;
  view.camera = scene.camera;
  view.unit = view.size;
  return view;
}

CommonScene tilted_scene(std::string_view name, std::string_view title, PolyScene scene) {
  CommonScene common{name, title, std::move(scene), {}, false, {}, {}};
  tilt(common.scene);
  common.views = {parallel_view(common.scene, 3, 4, 5), parallel_view(common.scene, -5, 12, 13),
                  own_view(common.scene)};
  return common;
}

CommonScene parallel_scene(std::string_view name, std::string_view title, PolyScene scene,
                           std::int32_t times) {
  CommonScene common{name, title, std::move(scene), {}, false, {}, {}};
  enlarge(common.scene, times);
  common.views = {parallel_view(common.scene, 0, 1, 1), parallel_view(common.scene, 3, 4, 5),
                  parallel_view(common.scene, -5, 12, 13)};
  common.scene.camera = common.views[0].camera;
  return common;
}

// Also from between the houses, of which some reach from before the eye to behind it.
CommonScene street() {
  CommonScene common = tilted_scene("C3", "street of 8 houses", poly_scene_of(built_in("street4")));
  common.views.push_back(common.views.back());
  common.views.back().camera.eye = tilted({37, 160, 600});
  return common;
}

// One triangle in each of 16 cells of 27: along the rows of cells they hide each other.
CommonScene triangles() {
  CommonScene common = parallel_scene("C6", "16 random triangles", scene::generate_triangles(16), 8);
  common.views[2] = parallel_view(common.scene, 1, 0, 1);
  return common;
}

CommonScene corridor() {
  CommonScene common{"C4", "corridor of 8 rooms", scene::generate_corridors(8), {}, false, {}, {}};
  common.views = {own_view(common.scene)};
  return common;
}

CommonScene prism_town() {
  CommonScene common{"C9", "35 turned houses, in plan", scene::generate_prisms(35), {}, true, {}, {}};
  common.views = {parallel_view(common.scene, 3, 4, 5), own_view(common.scene)};
  return common;
}

constexpr std::array<std::string_view, 11> names{"C1", "C2", "C3", "C4", "C5", "C6",
                                                 "C7", "C8", "C9", "H1", "H2"};

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
  if (name == "H1") return height_scene(name, "sin(r)/r, 32 x 32", "sinc", 3, 4);
  return height_scene(name, "terrain with cliffs, 32 x 32", "terrain", 4, 3);
}

}  // namespace sightline::compare
