// Meshes that nobody here made: read, mended and drawn, and held to laws of such drawings; no number is known beforehand.
//
// They are looked for in the folders that SIGHTLINE_MESHES names (with colons between them), in those of Debian's
// assimp-testmodels and where npm installs the package `bunny`. What is not there is skipped, with a message.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/base/file.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::algorithms {
namespace {

std::string find_mesh(const std::string& name) {
  std::vector<std::string> folders;
  if (const char* const given = std::getenv("SIGHTLINE_MESHES")) {
    std::istringstream list(given);
    for (std::string folder; std::getline(list, folder, ':');) folders.push_back(folder);
  }
  for (const char* folder : {"/usr/share/assimp/models", "/usr/share/nodejs", "/usr/lib/node_modules",
                             "/usr/local/lib/node_modules"})
    folders.emplace_back(folder);
  for (const std::string& folder : folders)
    if (std::filesystem::is_regular_file(folder + "/" + name)) return folder + "/" + name;
  return {};
}

// Of the npm package: exports.positions=[[x,y,z],...]; exports.cells=[[a,b,c],...], as OBJ.
std::string obj_of_script(const std::string& script) {
  std::string obj;
  for (const bool cells : {false, true}) {
    std::size_t at = script.find(cells ? "cells" : "positions");
    while (at != std::string::npos && (at = script.find('[', at + 1)) != std::string::npos) {
      const std::size_t first = script.find_first_not_of("[ \n", at);
      const std::size_t end = script.find(']', first);
      if (end == std::string::npos) break;
      std::istringstream numbers(script.substr(first, end - first));
      obj += cells ? 'f' : 'v';
      for (std::string number; std::getline(numbers, number, ',');)
        obj += " " + (cells ? std::to_string(std::stol(number) + 1) : number);
      obj += '\n';
      at = end;
      if (script.find_first_not_of(" \n", end + 1) == script.find(']', end + 1)) break;
    }
  }
  return obj;
}

std::optional<scene::PolyImport> load(const std::string& path) {
  const auto bytes = base::read_file(path);
  if (!bytes) return std::nullopt;
  std::string text(bytes->begin(), bytes->end());
  if (path.ends_with(".js")) text = obj_of_script(text);
  auto read = scene::read_poly(text, path, scene::poly_format_of(path, text),
                               {.mend = true, .folder = std::filesystem::path(path).parent_path().string()});
  if (!read && read.error().found.find("built without") != std::string::npos) return std::nullopt;
  EXPECT_TRUE(read) << read.error().message();
  if (!read) return std::nullopt;
  return std::move(*read);
}

// Every so many-th of the edges chosen.
picture::ChosenEdges sample_of(const picture::ChosenEdges& chosen, std::size_t most) {
  picture::ChosenEdges sample;
  const std::size_t step = chosen.edges.size() / most + 1;
  for (std::size_t e = 0; e < chosen.edges.size(); e += step) {
    sample.edges.push_back(chosen.edges[e]);
    sample.kinds.push_back(chosen.kinds[e]);
    sample.turned_away.push_back(chosen.turned_away[e]);
    for (const std::uint32_t surface : chosen.surfaces_at(e)) sample.surfaces.push_back(surface);
    sample.first_surface.push_back(static_cast<std::uint32_t>(sample.surfaces.size()));
  }
  return sample;
}

// Silhouettes part what faces the eye from what does not: about a vertex whose edges have two faces each there are as many
// changes as changes back.
void expect_even_silhouettes(const scene::PolyScene& scene, const picture::ChosenEdges& chosen) {
  std::vector<int> silhouettes(scene.vertices.size());
  std::vector<bool> whole(scene.vertices.size(), true);
  const scene::EdgeTable edges(scene);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses(e);
    if (uses.size() == 2 && uses[0].upwards != uses[1].upwards) continue;
    whole[edges[e].low] = whole[edges[e].high] = false;
  }
  for (std::size_t e = 0; e < chosen.edges.size(); ++e) {
    if (chosen.kinds[e] != picture::EdgeKind::silhouette) continue;
    ++silhouettes[chosen.edges[e].from];
    ++silhouettes[chosen.edges[e].to];
  }
  for (std::size_t v = 0; v < silhouettes.size(); ++v)
    if (whole[v]) {
      EXPECT_EQ(silhouettes[v] % 2, 0) << "vertex " << v;
    }
}

void expect_laws(const scene::PolyScene& read, std::size_t sampled) {
  EXPECT_TRUE(scene::check_poly_scene(read).empty());
  const scene::PolyScene scene = scene::with_crossings(read);
  const picture::EdgeChooser chooser(scene, {});
  int views = 0;
  for (const std::array<double, 3>& direction : {std::array<double, 3>{-1, -0.6, 0.8}, {0.9, -0.3, -1}, {0.2, 1, 0.5}}) {
    const scene::PolyCamera camera = scene::camera_outside({}, scene, direction, views % 2 == 0);
    if (scene::eye_error(read, camera)) continue;
    ++views;
    const picture::ChosenEdges chosen = chooser.at(camera);
    ASSERT_FALSE(chosen.edges.empty());
    EXPECT_EQ(chosen.counts()[static_cast<std::size_t>(picture::EdgeKind::flat)], 0U);
    expect_even_silhouettes(scene, chosen);
    const picture::LinePicture seen = exact::visible_edges(exact::make_edge_mesh(scene), camera, &chosen);
    EXPECT_FALSE(seen.pieces.empty());
    const picture::ChosenEdges sample = sample_of(chosen, sampled);
    EXPECT_TRUE(picture::only(seen, sample) == oracle::visible_edges(scene, camera, sample));
  }
  EXPECT_GT(views, 0);
}

#define NEEDS_MESH(path, name)              \
  const std::string path = find_mesh(name); \
  if (path.empty())                         \
  GTEST_SKIP()                              \
      << name                               \
      << " was not found: install Debian's assimp-testmodels or npm's bunny, or set SIGHTLINE_MESHES"

TEST(PublicMeshes, AnAnimalHasAnOutlineAndCreasesAndNoNet) {
  NEEDS_MESH(path, "bunny/index.js");
  const auto bunny = load(path);
  ASSERT_TRUE(bunny);
  EXPECT_GT(scene::face_count(bunny->scene), 1000U);
  expect_laws(bunny->scene, 60);
  const scene::PolyCamera camera = scene::camera_outside({}, bunny->scene, {-1, -0.5, 0.7}, true);
  const picture::ChosenEdges chosen = picture::EdgeChooser(bunny->scene, {}).at(camera);
  EXPECT_LT(3 * chosen.edges.size(), picture::edges_of(bunny->scene).size());
}

TEST(PublicMeshes, AreDrawnByTheLaws) {
  int found = 0;
  for (const auto& [name, sampled] :
       std::map<std::string, std::size_t>{{"OBJ/spider.obj", 40},
                                          {"OBJ/WusonOBJ.obj", 40},
                                          {"OBJ/regr01.obj", 40},
                                          {"OBJ/concave_polygon.obj", 40},
                                          {"OFF/Cube.off", 40},
                                          {"PLY/cube_binary.ply", 40},
                                          {"PLY/Wuson.ply", 40},
                                          {"STL/Spider_ascii.stl", 40},
                                          {"STL/sphereWithHole.stl", 40},
                                          {"STL/3DSMaxExport.STL", 40},
                                          {"3MF/box.3mf", 40},
                                          {"glTF/CesiumMilkTruck/CesiumMilkTruck.gltf", 40},
                                          {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 3}}) {
    const std::string path = find_mesh(name);
    if (path.empty()) continue;
    SCOPED_TRACE(path);
    const auto mesh = load(path);
    if (!mesh) continue;
    ++found;
    expect_laws(mesh->scene, sampled);
  }
  if (found == 0) GTEST_SKIP() << "no mesh of Debian's assimp-testmodels was found: install it, or set SIGHTLINE_MESHES";
}

// One mesh in two forms is one drawing.
TEST(PublicMeshes, TextAndBinaryAreTheSame) {
  NEEDS_MESH(text_path, "STL/Spider_ascii.stl");
  NEEDS_MESH(binary_path, "STL/Spider_binary.stl");
  const auto text = load(text_path);
  const auto binary = load(binary_path);
  ASSERT_TRUE(text && binary);
  EXPECT_EQ(scene::face_count(text->scene), scene::face_count(binary->scene));
  const auto kinds_of = [](const scene::PolyScene& scene) {
    return picture::EdgeChooser(scene, {}).at(scene::camera_outside({}, scene, {-1, -0.5, 0.7}, false)).counts();
  };
  EXPECT_EQ(kinds_of(text->scene), kinds_of(binary->scene));
}

// Cubes in four formats have twelve edges and six surfaces.
TEST(PublicMeshes, ACubeIsACubeInEveryFormat) {
  int found = 0;
  for (const char* name :
       {"OFF/Cube.off", "PLY/cube.ply", "PLY/cube_binary.ply", "OBJ/box.obj", "3MF/box.3mf",
        "glTF2/BoxTextured-glTF/BoxTextured.gltf", "glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf",
        "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"}) {
    const std::string path = find_mesh(name);
    if (path.empty()) continue;
    SCOPED_TRACE(path);
    const auto cube = load(path);
    if (!cube) continue;
    ++found;
    EXPECT_EQ(cube->scene.vertices.size(), 8U);
    EXPECT_EQ(cube->scene.surfaces.size(), 6U);
    const scene::PolyCamera camera = scene::camera_outside({}, cube->scene, {-1, -0.5, 0.7}, false);
    const picture::ChosenEdges chosen = picture::EdgeChooser(cube->scene, {}).at(camera);
    EXPECT_EQ(chosen.edges.size(), 12U);
    EXPECT_EQ(chosen.counts()[static_cast<std::size_t>(picture::EdgeKind::silhouette)], 6U);
    const picture::LinePicture seen = exact::visible_edges(exact::make_edge_mesh(cube->scene), camera, &chosen);
    EXPECT_EQ(seen.pieces.size(), 9U);
  }
  if (found == 0) GTEST_SKIP() << "no cube of Debian's assimp-testmodels was found: install it, or set SIGHTLINE_MESHES";
}

}  // namespace
}  // namespace sightline::algorithms
