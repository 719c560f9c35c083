// Files with fractions are rounded once, with a message; defective scenes are mended on request.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "host/scene/read/poly_file.hpp"
#include "tests/host/scene/poly_support.hpp"

namespace sightline::scene {
namespace {

TEST(Quantise, DecimalFractionsLoseNothing) {
  const PolyImport import =
      read("OFF\n4 1 0\n0.25 0 0\n1 0.001 0\n1 1 0\n-0.3 1 0\n4 0 1 2 3\n", PolyFormat::off);
  EXPECT_TRUE(import.report.quantised);
  EXPECT_EQ(import.report.step, 0.001);
  EXPECT_EQ(import.report.largest_shift, 0.0);
  EXPECT_EQ(import.report.faces.split_faces, 0U);
  EXPECT_EQ(import.scene.vertices[0], (PolyPoint{250, 0, 0}));
  EXPECT_EQ(import.scene.vertices[3], (PolyPoint{-300, 1000, 0}));
  EXPECT_EQ(scene_text(import.scene, PolyFormat::off),
            "OFF\n4 1 0\n0.25 0 0\n1 0.001 0\n1 1 0\n-0.3 1 0\n4 0 1 2 3\n");
}

// Only for some steps below 1 an integer multiple is 1.
TEST(Quantise, AStepOfAnySizeIsMultiplied) {
  const std::string end = ",\"vertices\":[[0,0,0],[10,0,0],[0,-3,0]],\"bodies\":[{\"faces\":[[0,1,2]]}]}";
  const auto after_origin = [&](const std::string& step) {
    const std::string text =
        scene_text(read("{\"step\":" + step + end, PolyFormat::json).scene, PolyFormat::off);
    return text.substr(16, text.find("3 0 1 2") - 16);
  };
  EXPECT_EQ(after_origin("0.75"), "7.5 0 0\n0 -2.25 0\n");
  EXPECT_EQ(after_origin("0.7"), "7 0 0\n0 -2.0999999999999996 0\n");
  EXPECT_EQ(after_origin("0.1"), "1 0 0\n0 -0.3 0\n");
}

TEST(Quantise, OtherFilesAreRoundedToAPowerOfTwo) {
  const PolyImport import = read("OFF\n3 1 0\n0 0 0\n3.14159265 0 0\n0 1e-9 2\n3 0 1 2\n", PolyFormat::off);
  // Half of 3.14.. is below 65536 steps of 2^-15, and the middle of the scene, rounded down, is 51472, 0, 32768 of them.
  EXPECT_EQ(import.report.step, std::ldexp(1.0, -15));
  EXPECT_EQ(import.scene.origin, (PolyOrigin{51472, 0, 32768}));
  EXPECT_EQ(import.scene.vertices[1], (PolyPoint{51472, 0, -32768}));  // 3.14159265 * 32768 = 102943.7
  EXPECT_LE(import.report.largest_shift, std::ldexp(1.0, -16));
  EXPECT_GT(import.report.largest_shift, 0.0);
  const PolyImport large = read("OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1e300 0\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(problems(large.scene), "");
  const PolyImport integers = read("OFF\n3 1 0\n0 0 0\n262144 0 0\n0 262144 0\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(integers.report.step, 2.0);
  EXPECT_EQ(integers.report.largest_shift, 0.0);
}

TEST(Quantise, ASceneFarAwayIsMovedFirst) {
  const PolyImport import =
      read("OFF\n3 1 0\n1000000.125 5000000 0\n1000001.125 5000000 0\n1000000.125 5000001.5 0.1\n3 0 1 2\n",
           PolyFormat::off);
  EXPECT_EQ(problems(import.scene), "");
  EXPECT_LT(import.report.step, 0.01);
  EXPECT_LE(import.report.largest_shift, import.report.step / 2);
  EXPECT_NE(import.scene.origin, (PolyOrigin{0, 0, 0}));
}

// At 5.4e9 a double has units of 2^-20: thousandths are distinct, and 120 units of a part are 120,000 of them.
TEST(Quantise, DecimalFractionsFarAwayLoseNothing) {
  const std::string text =
      "OFF\n4 1 0\n500123496 5412345678.123 310250.5\n500123376 5412345678.123 310250.5\n500123376 5412345700 310250.5\n"
      "500123400.001 5412345700 310250.5\n4 0 1 2 3\n";
  const PolyImport import = read(text, PolyFormat::off);
  EXPECT_EQ(import.report.step, 0.001);
  EXPECT_EQ(import.report.largest_shift, 0.0);
  EXPECT_EQ(import.scene.origin, (PolyOrigin{500123436000, 5412345689061, 310250500}));  // the middle, rounded down
  EXPECT_EQ(import.scene.vertices[0], (PolyPoint{60000, -10938, 0}));
  EXPECT_EQ(scene_text(import.scene, PolyFormat::off), text);
  const PolyImport again = read(scene_text(import.scene, PolyFormat::json), PolyFormat::json);
  PolyScene expected = import.scene;
  expected.face_in_file = expected.vertex_in_file = {};  // of the other file
  EXPECT_EQ(again.scene, expected);
}

TEST(Quantise, IntegersFarAwayAreExact) {
  const PolyImport import =
      read("OFF\n3 1 0\n-9000000000 7 0\n-8999800000 7 0\n-9000000000 100007 1\n3 0 1 2\n", PolyFormat::off);
  EXPECT_FALSE(import.report.quantised);
  EXPECT_EQ(import.report.step, 1.0);
  EXPECT_EQ(import.scene.vertices[2], (PolyPoint{-100000, 50000, 1}));  // the middle is -8999900000, 50007, 0
}

// The largest step that distinguishes adjacent doubles.
TEST(Quantise, TheStepIsNoFinerThanTheNumbers) {
  const PolyImport import =
      read("OFF\n3 1 0\n1e300 0 0\n1.0000000000000002e300 0 0\n1e300 1e284 0\n3 0 1 2\n", PolyFormat::off);
  EXPECT_EQ(import.report.step, std::ldexp(1.0, 944));  // 1e300 is between 2^996 and 2^997
  EXPECT_EQ(import.scene.vertices[1][0] - import.scene.vertices[0][0], 1);
}

// A translated mesh gives the same scene as long as its numbers are equal.
TEST(Quantise, ATranslatedMeshIsTheSameScene) {
  std::mt19937 random(3);
  const auto below = [&random](unsigned most) { return static_cast<double>(random() % most); };
  for (int round = 0; round < 200; ++round) {
    const double unit = round % 2 == 0 ? 1.0 / 1024 : 1.0 / 7 * 0x1p-2;  // 7ths are rounded to a power of two
    PolyMesh mesh;
    mesh.bodies.emplace_back();
    for (VertexIndex v = 0; v < 9; ++v) {
      std::array<double, 3>& vertex = mesh.vertices.emplace_back();
      // 30 bits before and 20 after the point: sums of them are exact.
      for (double& c : vertex) c = std::floor(below(80'000) * unit * 0x1p20) * 0x1p-20;
      if (v % 3 == 2) mesh.bodies[0].faces.push_back({{v - 2, v - 1, v}, {}});
    }
    PolyMesh moved = mesh;
    const std::array<double, 3> way{1e6 + below(1'000'000), -1e9, below(1'000) * 1e6};
    for (auto& vertex : moved.vertices)
      for (std::size_t a = 0; a < 3; ++a) vertex[a] += way[a];
    const auto here = import_poly(mesh);
    const auto there = import_poly(moved);
    ASSERT_TRUE(here && there);
    EXPECT_EQ(here->scene.step, there->scene.step) << round;
    for (std::size_t v = 0; v < 9; ++v)
      for (std::size_t a = 0; a < 3; ++a)
        EXPECT_EQ(here->scene.vertices[v][a] - here->scene.vertices[0][a], there->scene.vertices[v][a] - there->scene.vertices[0][a]);
    EXPECT_EQ(here->report.largest_shift, there->report.largest_shift);
  }
}

TEST(Quantise, FacesThatAreNoLongerPlanarBecomeTriangles) {
  const PolyImport import =
      read("OFF\n4 1 0\n0 0 0\n1.23456789 0 0\n1.23456789 1 0.1\n0 1 0\n4 0 1 2 3\n", PolyFormat::off);
  EXPECT_EQ(import.report.faces.split_faces, 1U);
  EXPECT_GT(import.report.faces.largest_deviation, 0.01);
  EXPECT_LT(import.report.faces.largest_deviation, 0.1);
  EXPECT_EQ(import.scene.bodies[0].faces.size(), 2U);
  EXPECT_EQ(problems(import.scene), "");
}

TEST(Quantise, CoincidentPointsAreMerged) {
  const std::string text = "OFF\n4 2 0\n0 0 0\n100000.7 0 0\n0 100000.7 0\n0 0 0.000001\n3 0 1 2\n3 0 1 3\n";
  const PolyImport import = read(text, PolyFormat::off);
  EXPECT_EQ(import.report.faces.merged_vertices, 1U);
  EXPECT_EQ(import.report.faces.dropped_faces, 1U);
  // Errors of the file itself are not hidden.
  EXPECT_EQ(faults("OFF\n5 2 0\n0 0 0\n100000.7 0 0\n0 100000.7 0\n7 7 7\n0 0 0.000001\n3 0 1 2\n3 0 1 4\n", PolyFormat::off),
            "test: vertex 3: is not used by any face\n");
}

TEST(Mend, MergesEqualVerticesDropsUnusedOnesAndTurnsBodies) {
  const std::string text =
      "OFF\n6 4 0\n0 0 0\n10 0 0\n0 10 0\n0 0 10\n10 0 0\n99 99 99\n"
      "3 1 2 0\n3 3 4 0\n3 3 2 1\n3 3 0 2\n";  // all four inside out
  EXPECT_EQ(faults(text, PolyFormat::off),
            "test: vertex 5: is not used by any face\ntest: vertex 4: is the same point (10, 0, 0) as vertex 1\n"
            "test: body 0, face 0: is part of a surface turned inside out, expected outlines counterclockwise from outside\n");
  const PolyImport mended = read(text, PolyFormat::off, true);
  EXPECT_EQ(problems(mended.scene), "");
  EXPECT_EQ(mended.report.faces.merged_vertices, 1U);
  EXPECT_EQ(mended.report.faces.dropped_vertices, 1U);
  EXPECT_EQ(mended.report.faces.turned_faces, 4U);
  EXPECT_FALSE(mended.scene.bodies[0].sheet);
}

}  // namespace
}  // namespace sightline::scene
