// The cost of the parts of the program, as stated in NOTES.md: differences between runs of scenes that differ in one respect.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/host/programs/stripes/views.hpp"

namespace sightline::programs::stripes {
namespace {

// A rectangle of `lines` lines, parallel to the picture.
SceneFace rectangle(int west, int east, int low, int lines, std::uint16_t z) {
  SceneFace face;
  const auto at = [](int dots) { return static_cast<std::uint16_t>(256 * dots); };
  face.rings = {{{at(west), at(low), z}, {at(east), at(low), z}, {at(east), at(low + lines), z}, {at(west), at(low + lines), z}}};
  face.c = 1000;
  face.d = 1000 * z;
  return face;
}

MachinePicture run(const ProjectedScene& scene, Computer stripes, Computer priority) {
  const CheckedPicture picture = run_both(encode(scene, {Output::raster, stripes, priority})->bytes);
  EXPECT_EQ(picture.difference, "");
  EXPECT_EQ(picture.machine.status, Status::complete);
  return picture.machine;
}

// Compares with NOTES.md: T-states are exact, the notes round them to tens.
void expect_cost(std::int64_t measured, std::int64_t said, const char* what) {
  EXPECT_LE(std::abs(measured - said), 5) << what;
}

TEST(StripesCost, OfALineOfAFace) {
  const auto drawing = [](int lines, Computer stripes) {
    ProjectedScene scene;
    scene.faces = {rectangle(10, 20, 10, lines, 0)};
    return run(scene, stripes, Computer::host).drawing.count();
  };
  const auto line = [&](Computer stripes) { return (drawing(200, stripes) - drawing(100, stripes)) / 100; };
  expect_cost(line(Computer::host), 1030, "two sides, stripes by the host");
  expect_cost(line(Computer::i8080), 1500, "two sides, stripes by the 8080");
}

TEST(StripesCost, OfAHiddenLine) {
  const auto drawing = [](int lines) {
    ProjectedScene scene;
    scene.faces = {rectangle(5, 30, 5, 240, 0), rectangle(10, 20, 10, lines, 9)};
    return run(scene, Computer::i8080, Computer::host).drawing.count();
  };
  expect_cost((drawing(200) - drawing(100)) / 100, 1620, "two sides behind the silhouette");
}

// Two faces of four corners: apart in depth; one behind the plane of the other; crossing each other's planes.
TEST(StripesCost, OfAPair) {
  const auto ranking = [](int second_lines, bool sloped, bool turned) {
    ProjectedScene scene;
    scene.faces = {rectangle(5, 105, 5, 240, 100), rectangle(10, 110, 10, second_lines, sloped ? 3000 : 900)};
    auto& first = scene.faces[0];
    auto& second = scene.faces[1];
    if (sloped) {
      first.rings[0][2].z = first.rings[0][3].z = 5000;
      first.b = -80;
      first.d = -80 * 5 * 256 + 1000 * 100;
    }
    if (turned) {
      second.rings[0][1].z = second.rings[0][2].z = 4000;
      second.a = -39;
      second.d = -39 * 10 * 256 + 1000 * 3000;
    }
    return run(scene, Computer::i8080, Computer::i8080).ranking.count();
  };
  expect_cost(ranking(100, true, false) - ranking(100, false, false), 32490, "test 4 instead of test 3");
  expect_cost((ranking(220, true, true) - ranking(180, true, true)) / 40, 2120, "a common line in test 6");
}

// The table of emulated seconds in NOTES.md.
TEST(StripesCost, OfTheBuilds) {
  std::ifstream file(SIGHTLINE_SOURCE_DIR "/firmware/i8080/stripes/NOTES.md");
  std::size_t rows = 0;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## Builds";
    char name[32] = "";
    unsigned faces = 0;
    std::array<double, 3> said{};
    if (!inside || std::sscanf(line.c_str(), "| %31[^ |] | %u | %lf | %lf | %lf |", name, &faces, &said[0], &said[1], &said[2]) != 5) continue;
    ++rows;
    const scene::PolyScene scene = scene_named(name);
    std::size_t column = 0;
    for (const Build build : {Build::plain, Build::coverage, Build::overwrite}) {
      const auto drawn = stripes::run({.scene = scene, .view = whole_view(scene), .options = {.build = build}});
      ASSERT_TRUE(drawn) << name;
      EXPECT_EQ(drawn->scene.faces.size(), faces) << name;
      EXPECT_NEAR(core::in_seconds(drawn->picture.drawing), said[column++], 0.00501) << name;
    }
  }
  EXPECT_EQ(rows, 5U);
}

}  // namespace
}  // namespace sightline::programs::stripes
