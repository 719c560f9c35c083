// The table of algorithms, and sweeps: lines that depend on nothing but what they should, in order from any
// number of threads, and shards that are the whole.
#include "host/compare/sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <stdexcept>
#include <string>

#include "host/compare/sweep_views.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

scene::PolyScene generated(std::string_view family, std::size_t size) {
  return *scene::generate_scene(family, size);
}

Sweep sweep_of(const scene::PolyScene& scene, const SweepOptions& options,
               const scene::CellScene* cells = nullptr) {
  auto sweep = Sweep::of("test", scene, cells, options);
  if (!sweep) throw std::runtime_error(sweep.error().message());
  return std::move(*sweep);
}

TEST(Algorithms, AreFoundByNameAndExactIsTheFirst) {
  EXPECT_EQ(registry::line_algorithms().front().name, "exact");
  std::set<std::string_view> names;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) {
    EXPECT_TRUE(names.insert(algorithm.name).second);
    EXPECT_EQ(registry::find_line_algorithm(algorithm.name), &algorithm);
    EXPECT_FALSE(algorithm.description.empty());
  }
  EXPECT_TRUE(names.contains("oracle") && names.contains("jones"));
  EXPECT_EQ(registry::find_line_algorithm("Exact"), nullptr);
}

// Every entry of the table gives the same picture of everything it applies to.
TEST(Algorithms, AgreeOnEveryFamily) {
  for (const std::string_view family : {"boxes", "town", "triangles", "bricks"}) {
    const scene::PolyScene scene = generated(family, 5);
    SweepOptions options;
    for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
      if (!algorithm.why_not(scene)) options.algorithms.push_back(&algorithm);
    ASSERT_EQ(options.algorithms.size(), registry::line_algorithms().size());
    const Sweep sweep = sweep_of(scene, options);
    for (std::uint64_t view = 0; view < 6; ++view) {
      const std::string line = sweep.line(view);
      EXPECT_TRUE(Sweep::agrees(line)) << family << ": " << line;
    }
  }
}

TEST(SweepViews, AreInFreeSpaceAndOftenInThePlaneOfAFace) {
  const scene::PolyScene scene = generated("boxes", 8);
  std::set<scene::PolyPoint> eyes;
  int orthographic = 0;
  int level_with_a_vertex = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const scene::PolyCamera camera = sweep_camera(scene, nullptr, false, 3, k);
    EXPECT_FALSE(scene::eye_error(scene, camera));
    EXPECT_EQ(camera, sweep_camera(scene, nullptr, false, 3, k));
    eyes.insert(camera.eye);
    orthographic += camera.perspective ? 0 : 1;
    bool level = false;
    for (const scene::PolyPoint& p : scene.vertices)
      for (std::size_t a = 0; a < 3; ++a) level = level || p[a] == camera.eye[a];
    level_with_a_vertex += level ? 1 : 0;
  }
  EXPECT_EQ(eyes.size(), 400U);
  EXPECT_TRUE(20 < orthographic && orthographic < 100) << orthographic;
  EXPECT_TRUE(60 < level_with_a_vertex && level_with_a_vertex < 300) << level_with_a_vertex;
  EXPECT_NE(sweep_camera(scene, nullptr, false, 3, 0), sweep_camera(scene, nullptr, false, 4, 0));
}

TEST(SweepViews, OfCellsTurnInAllDirections) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  int along_z = 0;
  int orthographic = 0;
  std::set<std::array<bool, 3>> octants;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const scene::PolyCamera straight = sweep_camera(scene, &cells, false, 3, k);
    EXPECT_TRUE(looks_along_z(straight));
    const scene::PolyCamera turned = sweep_camera(scene, &cells, true, 3, k);
    EXPECT_EQ(turned.eye, straight.eye) << "the same places";
    EXPECT_EQ(turned, sweep_camera(scene, &cells, true, 3, k));
    along_z += looks_along_z(turned) ? 1 : 0;
    orthographic += turned.perspective ? 0 : 1;
    octants.insert({turned.forward[0] > 0, turned.forward[1] > 0, turned.forward[2] > 0});
  }
  EXPECT_TRUE(3 < along_z && along_z < 60) << along_z;
  EXPECT_TRUE(20 < orthographic && orthographic < 100) << orthographic;
  EXPECT_EQ(octants.size(), 8U);
}

TEST(Sweep, TurnedViewsAgreeAndTheGuestSaysWhereItDoesNotApply) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  SweepOptions options;
  options.turned = true;
  options.guest = true;
  for (const char* name : {"jones", "montani-re", "oracle"})
    options.algorithms.push_back(registry::find_line_algorithm(name));
  const Sweep sweep = sweep_of(scene, options, &cells);
  int guests = 0;
  for (std::uint64_t k = 0; k < 40; ++k) {
    const std::string line = sweep.line(k);
    EXPECT_TRUE(Sweep::agrees(line)) << line;
    EXPECT_TRUE(sweep.is_line(k, line));
    const bool straight = looks_along_z(sweep_camera(scene, &cells, true, options.seed, k));
    EXPECT_EQ(
        line.find("\"guest\":{\"not_applicable\":\"the program looks along +z only\"}") == std::string::npos,
        straight);
    EXPECT_EQ(line.find("\"same_as_twin\":true") != std::string::npos, straight);
    guests += straight ? 1 : 0;
  }
  EXPECT_GT(guests, 0);
  options.turned = false;
  EXPECT_FALSE(sweep_of(scene, options, &cells).is_line(0, sweep.line(0)));
}

TEST(Sweep, ShardsAreTheWhole) {
  for (const std::uint64_t views : {1U, 7U, 100U})
    for (const std::uint64_t count : {1U, 2U, 3U, 7U, 150U}) {
      std::uint64_t next = 0;
      for (std::uint64_t number = 1; number <= count; ++number) {
        const SweepShard shard = sweep_shard(views, number, count);
        EXPECT_EQ(shard.first, next);
        EXPECT_LE(shard.last - shard.first, views / count + 1);
        next = shard.last;
      }
      EXPECT_EQ(next, views);
    }
}

TEST(Sweep, KnowsItsOwnLines) {
  const scene::PolyScene scene = generated("boxes", 3);
  SweepOptions options;
  const Sweep sweep = sweep_of(scene, options);
  const std::string line = sweep.line(4);
  EXPECT_EQ(line, sweep.line(4));
  EXPECT_TRUE(sweep.is_line(4, line));
  EXPECT_FALSE(sweep.is_line(5, line));
  EXPECT_FALSE(sweep.is_line(4, line.substr(0, line.size() - 1)));
  EXPECT_FALSE(sweep.is_line(4, line.substr(0, line.size() / 2) + "\n"));
  options.seed = 2;
  EXPECT_FALSE(sweep_of(scene, options).is_line(4, line));
  options.seed = 1;
  options.algorithms = {registry::find_line_algorithm("oracle")};
  EXPECT_FALSE(sweep_of(scene, options).is_line(4, line));
  scene::PolyScene other = scene;
  other.bodies.back().sheet = true;
  EXPECT_FALSE(sweep_of(other, {}).is_line(4, line));
}

TEST(Sweep, SaysWhatDisagrees) {
  EXPECT_TRUE(Sweep::agrees(R"({"jones":{"pieces":1,"agrees":true}})"));
  EXPECT_FALSE(Sweep::agrees(R"({"jones":{"pieces":1,"agrees":false}})"));
  EXPECT_FALSE(Sweep::agrees(R"({"guest":{"status":"complete","same_as_twin":false}})"));
  EXPECT_FALSE(Sweep::agrees(R"({"jones":{"error":"no"}})"));
  EXPECT_TRUE(Sweep::agrees(R"({"scene":"a\",\"agrees\":false","pieces":1})"));
}

TEST(Sweep, TheGuestAgainstItsTwin) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  SweepOptions options;
  options.guest = true;
  const Sweep sweep = sweep_of(scene, options, &cells);
  for (std::uint64_t view = 0; view < 3; ++view) {
    const std::string line = sweep.line(view);
    EXPECT_NE(line.find("\"status\":\"complete\",\"same_as_twin\":true"), std::string::npos) << line;
    EXPECT_NE(line.find("\"guest\":\"with EAE\""), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace sightline::compare
