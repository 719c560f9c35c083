// Tests of the check by rays: it accepts a correct drawing and finds each kind of fault. The drawings are made by hand.
#include "tests/support/ray_check.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/plain_mesh.hpp"

namespace sightline::tests {
namespace {

// A square in front of a longer bar, seen along -z: the square hides the middle of the bar.
PlainMesh square_before_bar() {
  PlainMesh mesh;
  mesh.vertices = {{-1, -1, 0},    {1, -1, 0},    {1, 1, 0},    {-1, 1, 0},
                   {-2, -0.5, -1}, {2, -0.5, -1}, {2, 0.5, -1}, {-2, 0.5, -1}};
  mesh.faces = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  mesh.precision = 1e-9;
  return mesh;
}

// 10 mm per unit, the origin at 50,50.
Point2 paper(double x, double y) {
  return {50 + 10 * x, 50 + 10 * y};
}

class RayCheck : public ::testing::Test {
 protected:
  PlainMesh mesh = square_before_bar();
  PlainView view{false, {0, 0, 5}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  std::vector<PlainStroke> strokes;

  void SetUp() override {
    for (std::uint32_t side = 0; side < 4; ++side) add(side, (side + 1) % 4, 0, 1, false);
    for (const std::array<std::uint32_t, 2> along : {std::array<std::uint32_t, 2>{4, 5}, {6, 7}}) {
      add(along[0], along[1], 0, 0.25, false);
      add(along[0], along[1], 0.25, 0.75, true);
      add(along[0], along[1], 0.75, 1, false);
    }
    add(5, 6, 0, 1, false);
    add(7, 4, 0, 1, false);
  }
  // Adds a stroke for a part of an edge.
  void add(std::uint32_t from, std::uint32_t to, double low, double high, bool hidden) {
    const Point3& a = mesh.vertices[from];
    const Point3& b = mesh.vertices[to];
    const auto place = [&](double s) { return paper(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])); };
    strokes.push_back({place(low), place(high), hidden, "boundary", {{a, b}}});
  }
  [[nodiscard]] RayReport report() const { return check_by_rays(mesh, view, strokes, 1); }
};

TEST_F(RayCheck, ARightDrawingIsGood) {
  const RayReport found = report();
  EXPECT_TRUE(found.good()) << (found.faults.empty() ? "" : found.faults.front());
  EXPECT_EQ(found.feature_edges, 8U);
  EXPECT_EQ(found.unclear_edges, 0U);
  EXPECT_GT(found.visible, 20U);
  EXPECT_LT(found.visible, found.samples);
  EXPECT_GT(found.stroke_samples, 15U);
  EXPECT_GT(found.dash_samples, 3U);
  EXPECT_NEAR(found.scale, 10, 1e-9);
  EXPECT_LT(found.residual, 1e-9);
}

TEST_F(RayCheck, EachStrokeThatIsMissingIsFound) {
  const std::vector<PlainStroke> all = strokes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    strokes = all;
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(report().undrawn > 0, !all[i].hidden) << i;
    EXPECT_EQ(report().good(), all[i].hidden) << i;
  }
}

TEST_F(RayCheck, AHiddenStrokeThatIsDrawnIsFound) {
  for (PlainStroke& stroke : strokes) stroke.hidden = false;
  const RayReport found = report();
  EXPECT_GT(found.hidden_drawn, 3U);
  EXPECT_EQ(found.undrawn, 0U);
  ASSERT_FALSE(found.faults.empty());
  EXPECT_NE(found.faults.front().find("hidden and drawn: at "), std::string::npos) << found.faults.front();
}

TEST_F(RayCheck, AVisibleStrokeThatIsDashedIsFound) {
  add(0, 1, 0, 1, true);
  EXPECT_GT(report().visible_dashed, 1U);
}

// The square hides the line of the file behind it.
TEST_F(RayCheck, ALineIsAnEdge) {
  mesh.vertices.insert(mesh.vertices.end(), {{-3, 0, -2}, {3, 0, -2}});
  mesh.lines.push_back({8, 9});
  EXPECT_GT(report().undrawn, 0U);
  add(8, 9, 0, 1.0 / 6, false);
  add(8, 9, 5.0 / 6, 1, false);
  EXPECT_TRUE(report().good());
  strokes.pop_back();
  add(8, 9, 4.0 / 6, 1, false);  // begins behind the bar
  EXPECT_GT(report().hidden_drawn, 0U);
}

TEST_F(RayCheck, AStretchOfPaperThatIsDrawnTwiceIsFound) {
  EXPECT_EQ(report().drawn_twice, 0U);
  add(5, 6, 0.25, 0.75, false);
  EXPECT_GT(report().drawn_twice, 1U);
  EXPECT_EQ(report().undrawn, 0U);
  EXPECT_EQ(report().hidden_drawn, 0U);
}

// A stroke is correct if one of its edges is visible.
TEST_F(RayCheck, AStrokeOfSeveralEdgesIsRight) {
  strokes.erase(strokes.begin() + 7, strokes.begin() + 10);
  strokes.erase(strokes.begin() + 4, strokes.begin() + 7);
  add(6, 7, 0, 1, false);
  EXPECT_GT(report().hidden_drawn, 0U);
  strokes.back().edges.push_back({Point3{-1, 0.5, 0.5}, Point3{1, 0.5, 0.5}});
  add(4, 5, 0, 1, false);
  strokes.back().edges.push_back({Point3{-1, -0.5, 0.5}, Point3{1, -0.5, 0.5}});
  EXPECT_TRUE(report().good()) << report().faults.front();
  strokes.back().edges.back() = {Point3{-1, 0.7, 0.5}, Point3{1, 0.7, 0.5}};  // not on the stroke
  EXPECT_FALSE(report().good());
}

TEST_F(RayCheck, AStrokeThatIsElsewhereIsFound) {
  strokes.push_back({paper(-1, 1.5), paper(1, 1.5), false, "boundary", {{mesh.vertices[2], mesh.vertices[3]}}});
  EXPECT_GT(report().off_edge, 0U);
  EXPECT_GT(report().residual, 1);
}

TEST_F(RayCheck, PerspectiveHidesMore) {
  view.perspective = true;
  view.eye = {0, 0, 2};
  strokes.clear();
  // The bar is 3 from the eye, the square 2: the bar's ends at 2 appear at 4/3 on the square's plane.
  const auto add_seen = [&](std::uint32_t from, std::uint32_t to, const Point2& p, const Point2& q) {
    strokes.push_back({p, q, false, "boundary", {{mesh.vertices[from], mesh.vertices[to]}}});
  };
  const double side = 0.5;
  const double near = 2.0 / 3;
  const double high = 0.5 / 3;
  add_seen(0, 1, paper(-side, -side), paper(side, -side));
  add_seen(1, 2, paper(side, -side), paper(side, side));
  add_seen(2, 3, paper(side, side), paper(-side, side));
  add_seen(3, 0, paper(-side, side), paper(-side, -side));
  add_seen(4, 5, paper(-near, -high), paper(-side, -high));
  add_seen(4, 5, paper(side, -high), paper(near, -high));
  add_seen(6, 7, paper(-near, high), paper(-side, high));
  add_seen(6, 7, paper(side, high), paper(near, high));
  add_seen(5, 6, paper(near, -high), paper(near, high));
  add_seen(7, 4, paper(-near, high), paper(-near, -high));
  const RayReport found = report();
  EXPECT_TRUE(found.good()) << (found.faults.empty() ? "" : found.faults.front());
  // Without perspective more of the bar would be visible.
  strokes[4].to = paper(-0.4, -high);
  EXPECT_FALSE(report().good());
}

// A cube seen along (-1,-1,-1): three creases that meet in front, six silhouette edges; the three edges behind are hidden.
TEST_F(RayCheck, ACubeHasNineVisibleEdges) {
  mesh.vertices.clear();
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back({double(corner & 1), double(corner / 2 & 1), double(corner / 4)});
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  view = {false, {0, 0, 0}, {-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}};
  const auto at = [&](std::uint32_t v) {
    const Point3& p = mesh.vertices[v];
    return paper((p[0] - p[2]) / std::sqrt(2), (2 * p[1] - p[0] - p[2]) / std::sqrt(6));
  };
  strokes.clear();
  for (std::uint32_t from = 1; from < 8; ++from)
    for (const std::uint32_t axis : {1U, 2U, 4U})
      if ((from & axis) == 0)
        strokes.push_back({at(from), at(from | axis), false, "crease", {{mesh.vertices[from], mesh.vertices[from | axis]}}});
  ASSERT_EQ(strokes.size(), 9U);
  EXPECT_TRUE(report().good());
  EXPECT_EQ(report().feature_edges, 12U);
  strokes.push_back({at(0), at(1), false, "crease", {{mesh.vertices[0], mesh.vertices[1]}}});
  EXPECT_GT(report().hidden_drawn, 0U);
}

// A vertex in the middle of another face's side: mending decides whether the two halves and the side are one edge.
TEST_F(RayCheck, AVertexOnASideLeavesTheSideOpen) {
  mesh.vertices.insert(mesh.vertices.end(), {{0, -1, 0}, {0, -2, 0.5}});
  mesh.faces.push_back({0, 8, 9});
  mesh.faces.push_back({8, 1, 9});
  add(0, 9, 0, 1, false);
  add(1, 9, 0, 1, false);
  EXPECT_TRUE(report().good()) << report().faults.front();
  EXPECT_EQ(report().feature_edges, 9U);
  EXPECT_EQ(report().unclear_edges, 3U);
  strokes.erase(strokes.begin());  // the whole side
  EXPECT_TRUE(report().good()) << report().faults.front();
}

class PlainMeshFile : public ::testing::Test {
 protected:
  PlainMeshFile() { std::filesystem::create_directories(folder_); }
  ~PlainMeshFile() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] PlainMesh read(const std::string& name, const std::string& text) const {
    std::ofstream((folder_ / name).string(), std::ios::binary) << text;
    return read_plain_mesh((folder_ / name).string());
  }

 private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("plain-mesh-" + std::to_string(getpid()));
};

void expect_square(const PlainMesh& mesh) {
  EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {2, 2.5, 0}, {0, 2.5, 0}}));
  EXPECT_EQ(mesh.faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(PlainMeshFile, IsTheSameInEveryFormat) {
  expect_square(read("a.off", "OFF\n# two triangles\n4 2 5\n0 0 0\n2 0 0\n2 2.5 0\n0 2.5 0\n3 0 1 2\n3 0 2 3 255 0 0\n"));
  expect_square(read("a.obj", "v 0 0 0\nv 2 0 0\nv 2 2.5 0\nv 0 2.5 0\nf 1/1 2//3 3\nf 1 \\\n-2 -1 # a comment\n"));
  expect_square(read("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                     "element face 2\nproperty list uchar int vertex_index\nend_header\n"
                     "0 0 0\n2 0 0\n2 2.5 0\n0 2.5 0\n3 0 1 2\n3 0 2 3\n"));
  std::string text = "solid a\n";
  std::string binary(80, ' ');
  const std::uint32_t count = 2;
  binary.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& facet :
       {std::vector<std::array<float, 3>>{{0, 0, 0}, {2, 0, 0}, {2, 2.5, 0}}, {{0, 0, 0}, {2, 2.5, 0}, {0, 2.5, 0}}}) {
    text += "facet normal 0 0 1\nouter loop\n";
    binary.append(12, '\0');
    for (const auto& p : facet) {
      text += "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
      binary.append(reinterpret_cast<const char*>(p.data()), 12);
    }
    text += "endloop\nendfacet\n";
    binary.append(2, '\0');
  }
  expect_square(read("a.stl", text + "endsolid a\n"));
  expect_square(read("b.STL", binary));
}

TEST_F(PlainMeshFile, HasLinesOfObj) {
  const PlainMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2/5 -1\n");
  EXPECT_EQ(mesh.lines, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(mesh.faces.empty());
}

TEST_F(PlainMeshFile, LeavesOutWhatIsNoFace) {
  const PlainMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\nf 2 4 3\nf 3 4 1\n");
  EXPECT_EQ(mesh.faces.size(), 1U);
  EXPECT_EQ(mesh.vertices.size(), 3U);
}

TEST_F(PlainMeshFile, RefusesWhatIsDamaged) {
  EXPECT_THROW((void)read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), std::runtime_error);
  EXPECT_THROW((void)read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), std::runtime_error);
  EXPECT_THROW((void)read("a.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), std::runtime_error);
  EXPECT_THROW((void)read("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), std::runtime_error);
  EXPECT_THROW((void)read("a.stl", "solid\nvertex 0 0 0\nvertex 1 0 0\nendsolid\n"), std::runtime_error);
  EXPECT_THROW((void)read("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"), std::runtime_error);
}

}  // namespace
}  // namespace sightline::tests
