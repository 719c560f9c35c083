// Each kind of damage that is mended, on meshes whose correct form is known by hand.
#include "host/scene/read/poly_mend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {
namespace {

using Faces = std::vector<std::vector<VertexIndex>>;

PolyMesh mesh_of(const std::vector<std::array<double, 3>>& vertices, const Faces& faces) {
  PolyMesh mesh;
  mesh.source = "m";
  mesh.vertices = vertices;
  mesh.bodies.emplace_back();
  for (const auto& face : faces) mesh.bodies[0].faces.push_back({face, {}});
  return mesh;
}

const std::vector<std::array<double, 3>> cube_corners{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0},
                                                      {0, 0, 8}, {8, 0, 8}, {8, 8, 8}, {0, 8, 8}};
// Counterclockwise from outside.
const Faces cube_faces{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

PolyImport mend_mesh(PolyMesh mesh, double weld = 0) {
  auto result = import_poly(std::move(mesh), {.mend = true, .weld = weld});
  EXPECT_TRUE(result) << result.error().message();
  if (!result) return {};
  EXPECT_EQ(check_poly_scene(result->scene).size(), 0U);
  return std::move(*result);
}

std::vector<std::array<double, 3>> translate(std::vector<std::array<double, 3>> points, double scale, double shift) {
  for (auto& point : points)
    for (double& c : point) c = scale * c + shift;
  return points;
}

// Two corners that nearly meet are merged: a wire between them becomes a point, and two wires to them become equal.
TEST(PolyMend, WiresFollowTheirVertices) {
  PolyMesh mesh = mesh_of({{9, 9, 9}, {0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 1, 0}, {20, 20, 20}}, {{1, 2, 3}});
  mesh.wires = {{5, 1}, {4, 5}, {4, 1}, {2, 1}};
  const PolyImport import = mend_mesh(mesh, 1);
  EXPECT_EQ(import.scene.vertices, (std::vector<PolyPoint>{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {20, 20, 20}}));
  EXPECT_EQ(import.scene.wires, (std::vector<PolyWire>{{0, 1}, {0, 3}}));
  EXPECT_EQ(import.report.faces.merged_vertices, 1U);
  EXPECT_EQ(import.report.faces.dropped_vertices, 1U);
  EXPECT_EQ(import.report.faces.dropped_wires, 1U);
}

TEST(PolyMend, WiresRemainEvenWithoutFaces) {
  PolyMesh mesh = mesh_of({{0, 0, 0}, {8, 0, 0}, {16, 0, 0}, {0, 0, 5}}, {{0, 1, 2}});
  mesh.wires = {{0, 3}};
  const PolyImport import = mend_mesh(mesh);
  EXPECT_TRUE(import.scene.bodies.empty());
  EXPECT_EQ(import.scene.vertices, (std::vector<PolyPoint>{{0, 0, 0}, {0, 0, 5}}));
  EXPECT_EQ(import.scene.wires, (std::vector<PolyWire>{{0, 1}}));
  EXPECT_EQ(import.report.faces.dropped_faces, 1U);
}

std::vector<std::string> faults_of(PolyMesh mesh) {
  const auto import = import_poly(std::move(mesh));
  EXPECT_TRUE(import) << import.error().message();
  std::vector<std::string> texts;
  if (import)
    for (const base::Error& fault : import->faults) texts.push_back(fault.message());
  return texts;
}

// Each kind of change that is not made without mending, by its place in the file.
TEST(PolyMend, FaultsOfTheFileAreNamed) {
  const auto cube_with = [](const Faces& more) {
    Faces faces = cube_faces;
    faces.insert(faces.end(), more.begin(), more.end());
    return mesh_of(cube_corners, faces);
  };
  EXPECT_EQ(faults_of(mesh_of(cube_corners, cube_faces)), std::vector<std::string>{});
  Faces turned = cube_faces;
  std::reverse(turned[1].begin(), turned[1].end());
  EXPECT_EQ(faults_of(mesh_of(cube_corners, turned))[0],
            "m: body 0, face 1: edge 4-5 is passed in the same direction by face 2, expected opposite directions");
  for (auto& face : turned) std::reverse(face.begin(), face.end());
  std::reverse(turned[1].begin(), turned[1].end());
  EXPECT_EQ(faults_of(mesh_of(cube_corners, turned)),
            (std::vector<std::string>{
                "m: body 0, face 0: is part of a surface turned inside out, expected outlines counterclockwise from outside"}));
  EXPECT_EQ(faults_of(cube_with({{4, 5, 6, 7}})), (std::vector<std::string>{"m: body 0, face 6: has the same vertices as face 1"}));
  EXPECT_EQ(faults_of(cube_with({{0, 1, 1, 2}})),
            (std::vector<std::string>{"m: body 0, face 6: the outline has vertex 1 (8, 0, 0) twice in succession"}));
  // Two solids, one in the other, both facing outwards.
  auto points = cube_corners;
  Faces nested = cube_faces;
  for (const auto& p : cube_corners) points.push_back({p[0] / 2 + 2, p[1] / 2 + 2, p[2] / 2 + 2});
  for (auto face : cube_faces) {
    for (VertexIndex& v : face) v += 8;
    nested.push_back(face);
  }
  EXPECT_EQ(faults_of(mesh_of(points, nested)),
            (std::vector<std::string>{
                "m: body 0, face 6: is part of a surface inside a solid, expected outlines clockwise from outside: a cavity"}));
  // Triangles without an area and that are one pillow, and a square whose corner is a unit too high.
  EXPECT_EQ(faults_of(mesh_of({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {0, 8, 0}, {9, 9, 0}, {9, 9, 4}, {8, 0, 4}, {0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 2}},
                              {{0, 1, 2}, {2, 4, 5}, {5, 4, 2}, {7, 8, 9, 10}, {0, 6, 3}})),
            (std::vector<std::string>{"m: body 0, face 0: all vertices are on one line, expected an area",
                                      "m: body 0, face 3: vertex 10 (0, 4, 2) is not in the plane of vertices 7, 8 and 9",
                                      "m: body 0, face 2: has the same vertices as face 1"}));
}

// A triangle beside two others whose common corner is on its side.
TEST(PolyMend, AVertexOnAnEdgeIsAFault) {
  EXPECT_EQ(faults_of(mesh_of({{0, 0, 0}, {2000, 0, 0}, {1000, 900, 0}, {1000, 0, 0}, {0, -900, 0}}, {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}})),
            (std::vector<std::string>{"m: body 0, face 0: edge 0-1 passes vertex 3, expected a corner of the face there"}));
}

// Vertices that fall together, a face that becomes a line, and a square that no longer has a plane; all on a step of 2^-15.
TEST(PolyMend, WhatRoundingDidIsNoFault) {
  const double least = 1e-7;
  const PolyMesh mesh = mesh_of({{0, 0, 0}, {3.3, 0, 0}, {3.3, 3.3, least}, {0, 3.3, 0.1}, {3.3, least, 0}, {5, 0, 0}, {3.3, 0, 1}},
                                {{0, 1, 2, 3}, {1, 5, 4}, {4, 5, 6}});
  EXPECT_EQ(faults_of(mesh), std::vector<std::string>{});
  const auto strict = import_poly(mesh);
  ASSERT_TRUE(strict) << strict.error().message();
  EXPECT_EQ(strict->scene, mend_mesh(mesh).scene);
  EXPECT_EQ(strict->report.faces.dropped_faces, 1U);
  EXPECT_EQ(strict->report.faces.split_faces, 1U);
}

// Cubes with random faces between their corners and other points, on whole coordinates: a mesh has faults if, and only if, mending
// changes it. No outline comes back to a vertex, which is a fault but not counted.
TEST(PolyMend, WithoutFaultsNothingIsChanged) {
  std::mt19937 random(11);
  std::size_t faulty = 0;
  constexpr std::size_t rounds = 600;
  for (std::size_t round = 0; round < rounds; ++round) {
    auto points = cube_corners;
    Faces faces = cube_faces;
    for (std::size_t more = random() % 3; more > 0; --more) {
      Faces::value_type face;
      while (face.size() < 3 + random() % 3) {
        const VertexIndex v = static_cast<VertexIndex>(random() % (points.size() + 1));
        if (v == points.size()) points.push_back({4, round % 2 == 0 ? 4.0 : 0.0, static_cast<double>(random() % 3) * 8});
        if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
      }
      if (random() % 2 == 0) faces.push_back(face);
      else faces[random() % 6] = face;
    }
    const PolyMesh mesh = mesh_of(points, faces);
    const auto strict = import_poly(mesh);
    if (!strict) continue;  // no face is left
    PolyImport mended = mend_mesh(mesh);
    const MendReport& report = mended.report.faces;
    const bool changed = report.merged_vertices + report.divided_edges + report.dropped_vertices + report.dropped_faces + report.duplicate_faces +
                             report.split_faces + report.turned_faces + report.crossing_faces >
                         0;
    EXPECT_EQ(!strict->faults.empty(), changed) << round << (strict->faults.empty() ? "" : strict->faults[0].message());
    EXPECT_EQ(strict->scene, mended.scene);
    faulty += changed ? 1U : 0U;
  }
  EXPECT_GT(faulty, rounds / 4);
  EXPECT_LT(faulty, rounds);
}

TEST(PolyMend, ValidMeshesAreUnchanged) {
  const PolyImport cube = mend_mesh(mesh_of(cube_corners, cube_faces));
  const MendReport& report = cube.report.faces;
  EXPECT_EQ(report.merged_vertices + report.dropped_vertices + report.dropped_faces + report.duplicate_faces +
                report.split_faces + report.turned_faces + report.sheets + report.crowded_edges + report.crossing_faces,
            0U);
  ASSERT_EQ(cube.scene.bodies.size(), 1U);
  EXPECT_FALSE(cube.scene.bodies[0].sheet);
  EXPECT_EQ(cube.scene.surfaces.size(), 6U);
}

TEST(PolyMend, FacesTurnedTheWrongWay) {
  Faces faces = cube_faces;
  std::reverse(faces[1].begin(), faces[1].end());
  std::reverse(faces[4].begin(), faces[4].end());
  EXPECT_EQ(mend_mesh(mesh_of(cube_corners, faces)).report.faces.turned_faces, 2U);
  for (std::size_t f : {0U, 2U, 3U, 5U}) std::reverse(faces[f].begin(), faces[f].end());  // now all are inside out
  EXPECT_EQ(mend_mesh(mesh_of(cube_corners, faces)).report.faces.turned_faces, 6U);
}

TEST(PolyMend, NestedShellsAlternate) {
  // Three nested cubes, all written with the outside out: solid, cavity, solid.
  std::vector<std::array<double, 3>> points;
  Faces faces;
  for (const double scale : {8.0, 4.0, 1.0}) {
    const auto first = static_cast<VertexIndex>(points.size());
    for (const auto& p : translate(cube_corners, scale, -4 * scale)) points.push_back(p);
    for (auto face : cube_faces) {
      for (VertexIndex& v : face) v += first;
      faces.push_back(face);
    }
  }
  const PolyImport nested = mend_mesh(mesh_of(points, faces));
  EXPECT_EQ(nested.report.faces.turned_faces, 6U);
  ASSERT_EQ(nested.scene.bodies.size(), 2U);
  EXPECT_EQ(nested.scene.bodies[0].faces.size(), 12U);  // with its cavity
  EXPECT_EQ(nested.scene.bodies[1].faces.size(), 6U);
}

TEST(PolyMend, AnOpenPartIsASheetAndAMoebiusBandHasOneSide) {
  Faces open = cube_faces;
  open.pop_back();
  const PolyImport box = mend_mesh(mesh_of(cube_corners, open));
  EXPECT_TRUE(box.scene.bodies.at(0).sheet);
  EXPECT_EQ(box.report.faces.sheets, 1U);
  EXPECT_EQ(box.report.faces.one_sided, 0U);
  // Five triangles in a ring, the smallest one-sided band.
  const std::vector<std::array<double, 3>> points{{90, 0, 5}, {28, 85, -20}, {-73, 53, 30}, {-73, -53, -7}, {28, -86, 11}};
  EXPECT_EQ(mend_mesh(mesh_of(points, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}})).report.faces.one_sided, 1U);
}

// A cube whose faces all have separate corners, as in STL, moved by `apart` along an axis: x, y and z in turn.
void add_loose_cube(double apart, std::vector<std::array<double, 3>>& points, Faces& faces) {
  for (const auto& face : cube_faces) {
    faces.emplace_back();
    for (const VertexIndex v : face) {
      faces.back().push_back(static_cast<VertexIndex>(points.size()));
      points.push_back(cube_corners[v]);
      points.back()[faces.size() % 3] += apart;
    }
  }
}

TEST(PolyMend, CoincidentAndNearbyVertices) {
  std::vector<std::array<double, 3>> points;
  Faces faces;
  add_loose_cube(0, points, faces);
  const PolyImport joined = mend_mesh(mesh_of(points, faces));
  EXPECT_EQ(joined.report.faces.merged_vertices, 16U);
  EXPECT_FALSE(joined.scene.bodies.at(0).sheet);
  // Corners that almost meet: separate by default, merged with a distance.
  for (std::size_t i = 0; i < points.size(); ++i) points[i][i % 3] += 0.01 * static_cast<double>(i / 4 % 3);
  EXPECT_GT(mend_mesh(mesh_of(points, faces)).report.faces.sheets, 0U);
  const PolyImport welded = mend_mesh(mesh_of(points, faces), 0.1);
  EXPECT_EQ(welded.scene.vertices.size(), 8U);
  EXPECT_EQ(welded.report.faces.sheets, 0U);
}

TEST(PolyMend, RepeatedDegenerateAndSelfCrossingFaces) {
  Faces faces = cube_faces;
  faces.push_back({1, 0, 3, 2});     // the first again, starting at another corner
  faces.push_back({0, 1, 0});        // no area
  faces.push_back({0, 6, 3, 5});     // crosses itself, and is not planar
  const PolyImport result = mend_mesh(mesh_of(cube_corners, faces));
  EXPECT_EQ(result.report.faces.duplicate_faces, 1U);
  EXPECT_EQ(result.report.faces.dropped_faces, 1U);
}

// A cube of 6, whose first corner is in the middle of an octahedron; it is within the octahedron's bounds but sticks out of it.
TEST(PolyMend, ASolidThatSticksOutOfAnotherIsNotACavity) {
  std::vector<std::array<double, 3>> points{{10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}, {0, 0, 10}, {0, 0, -10}};
  Faces faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (const auto& face : cube_faces) {
    faces.emplace_back();
    for (const VertexIndex v : face) faces.back().push_back(6 + v);
  }
  for (const double size : {6.0, 2.0}) {  // within the octahedron it is a cavity
    auto all = points;
    for (const auto& corner : cube_corners) {
      std::array<double, 3> p{};
      for (std::size_t a = 0; a < 3; ++a) p[a] = corner[a] > 0 ? size : 0;
      all.push_back(p);
    }
    const PolyImport result = mend_mesh(mesh_of(all, faces));
    EXPECT_EQ(result.scene.bodies.size(), size == 6 ? 2U : 1U);
    EXPECT_EQ(result.report.faces.turned_faces, size == 6 ? 0U : 6U);
  }
}

TEST(PolyMend, AFlatTriangleLeavesNoCrack) {
  // A tetrahedron with a vertex in the middle of one edge on one side only, and a triangle that fills the gap.
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {4, 4, 0}};
  const Faces faces{{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {1, 4, 2}};
  const PolyImport result = mend_mesh(mesh_of(points, faces));
  ASSERT_EQ(result.scene.bodies.size(), 1U);
  EXPECT_FALSE(result.scene.bodies[0].sheet);
  EXPECT_EQ(result.report.faces.dropped_faces, 1U);
  EXPECT_EQ(result.scene.bodies[0].faces.size(), 5U);
}

TEST(PolyMend, FacesThatAreNotPlanarBecomeTriangles) {
  std::vector<std::array<double, 3>> points = cube_corners;
  points[6] = {8, 8, 10};
  const PolyImport result = mend_mesh(mesh_of(points, cube_faces));
  EXPECT_EQ(result.report.faces.split_faces, 1U);  // the top; the sides keep their planes
  EXPECT_EQ(result.scene.bodies.at(0).faces.size(), 7U);
  EXPECT_GT(result.report.faces.largest_deviation, 0.4);
  EXPECT_LT(result.report.faces.largest_deviation, 2.0);
}

// A cube whose side x = 8 is two faces, which meet in a line from one edge to the other; the adjacent faces have neither end.
TEST(PolyMend, VerticesOnEdgesOfOtherFaces) {
  std::vector<std::array<double, 3>> points = cube_corners;
  points.push_back({8, 3, 0});
  points.push_back({8, 5, 8});
  Faces faces = cube_faces;
  faces[3] = {1, 8, 9, 5};
  faces.push_back({8, 2, 6, 9});
  const PolyImport result = mend_mesh(mesh_of(points, faces));
  EXPECT_EQ(result.report.faces.divided_edges, 2U);
  EXPECT_EQ(result.report.faces.sheets, 0U);
  EXPECT_EQ(result.scene.bodies.at(0).faces.size(), 7U);
  EXPECT_EQ(result.scene.bodies[0].faces[0].outline.size(), 5U);
  EXPECT_EQ(result.scene.surfaces.size(), 6U);
  // A body of the file does not divide edges of another.
  PolyMesh apart = mesh_of(points, faces);
  apart.grouped = true;
  apart.bodies.emplace_back().faces = {apart.bodies[0].faces[3], apart.bodies[0].faces[6]};
  apart.bodies[0].faces = {apart.bodies[0].faces.begin(), apart.bodies[0].faces.begin() + 3};
  EXPECT_EQ(mend_mesh(std::move(apart)).report.faces.divided_edges, 0U);
}

// Near an edge is not on it: the precision of the file decides.
TEST(PolyMend, VerticesNearEdgesDivideNothing) {
  for (const double aside : {0.0001, 0.01}) {
    std::vector<std::array<double, 3>> points = cube_corners;
    points.push_back({8 + aside, 3, 0});
    points.push_back({8 + aside, 5, 8});
    Faces faces = cube_faces;
    faces[3] = {1, 8, 9, 5};
    faces.push_back({8, 2, 6, 9});
    PolyMesh mesh = mesh_of(points, faces);
    mesh.precision = 0.0001;
    const PolyImport result = mend_mesh(std::move(mesh));
    EXPECT_EQ(result.report.faces.divided_edges, aside < 0.001 ? 2U : 0U);
    EXPECT_EQ(result.report.faces.sheets, aside < 0.001 ? 0U : 1U);
  }
}

// A triangle whose corner touches the middle of another one's side does not close the gap there. A triangle whose side is a part
// of that
// side does, and so does one that extends beyond its end: then both are divided.
TEST(PolyMend, VerticesThatOnlyTouchAnEdgeDivideNothing) {
  const auto divided = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return mend_mesh(mesh_of({{0, 0, 0}, {8, 0, 0}, {4, 5, 0}, a, b, {5, -6, 3}}, {{0, 1, 2}, {3, 4, 5}})).report.faces.divided_edges;
  };
  EXPECT_EQ(divided({4, 0, 0}, {3, -5, 3}), 0U);
  EXPECT_EQ(divided({2, 0, 0}, {6, 0, 0}), 1U);
  EXPECT_EQ(divided({4, 0, 0}, {12, 0, 0}), 2U);
}

// Boxes at any angle whose sides are divided into random pieces, with fractions, near and far away: each piece has separate
// corners, as in
// STL, and no side has the vertices of its neighbours. The result must be the box.
TEST(PolyMend, BoxesCutAnywhereStayBoxes) {
  std::mt19937 random(5);
  const auto number = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  using Point = std::array<double, 3>;
  using Polygon = std::vector<Point>;
  std::size_t divided = 0;
  for (int round = 0; round < 60; ++round) {
    const Point size{number(2, 10), number(2, 10), number(2, 10)};
    const double decimals = round % 3 == 0 ? 1e4 : 1e6;
    const double away = round % 4 == 0 ? 1e7 : number(0, 10);
    const std::array<double, 2> angles{number(0, 6), number(0, 6)};
    const auto place = [&](const Point& p) {
      const Point q{std::cos(angles[0]) * p[0] - std::sin(angles[0]) * p[1], std::sin(angles[0]) * p[0] + std::cos(angles[0]) * p[1],
                    p[2]};
      Point r{q[0], std::cos(angles[1]) * q[1] - std::sin(angles[1]) * q[2], std::sin(angles[1]) * q[1] + std::cos(angles[1]) * q[2]};
      for (double& c : r) c = std::round((c + away) * decimals) / decimals;
      return r;
    };
    std::vector<Point> points;
    Faces faces;
    for (const auto& side : cube_faces) {
      std::vector<Polygon> pieces(1);
      for (const VertexIndex v : side)
        pieces[0].push_back({cube_corners[v][0] / 8 * size[0], cube_corners[v][1] / 8 * size[1], cube_corners[v][2] / 8 * size[2]});
      for (auto cuts = random() % 4; cuts > 0; --cuts) {
        const std::size_t chosen = random() % pieces.size();
        const Polygon whole = pieces[chosen];
        const std::size_t i = random() % (whole.size() - 1);
        const std::size_t j = i + 1 + random() % (whole.size() - 1 - i);
        const auto within = [&](std::size_t k) {
          const double t = number(0.3, 0.7);
          Point p{};
          for (std::size_t a = 0; a < 3; ++a) p[a] = whole[k][a] + t * (whole[(k + 1) % whole.size()][a] - whole[k][a]);
          return p;
        };
        const Point u = within(i);
        const Point v = within(j);
        Polygon first(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        first.insert(first.end(), {u, v});
        first.insert(first.end(), whole.begin() + static_cast<std::ptrdiff_t>(j) + 1, whole.end());
        Polygon second{u};
        second.insert(second.end(), whole.begin() + static_cast<std::ptrdiff_t>(i) + 1, whole.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        second.push_back(v);
        pieces[chosen] = first;
        pieces.push_back(second);
      }
      for (const Polygon& piece : pieces) {
        faces.emplace_back();
        for (const Point& p : piece) {
          faces.back().push_back(static_cast<VertexIndex>(points.size()));
          points.push_back(place(p));
        }
      }
    }
    PolyMesh mesh = mesh_of(points, faces);
    mesh.precision = 1 / decimals;
    const PolyImport result = mend_mesh(std::move(mesh));
    EXPECT_EQ(result.report.faces.sheets, 0U) << round;
    EXPECT_EQ(result.scene.bodies.size(), 1U) << round;
    EXPECT_EQ(result.scene.surfaces.size(), 6U) << round;
    divided += result.report.faces.divided_edges;
  }
  EXPECT_GT(divided, 200U);
}

// A box at an angle: each side has additional vertices on its edges, which the adjacent sides do not have. The numbers have four
// decimals,
// so that no side is planar: the triangles that it becomes leave no edge between vertices on one of its sides.
TEST(PolyMend, SidesWithAdditionalVerticesStayTogether) {
  using Point = std::array<double, 3>;
  std::mt19937 random(9);
  for (int round = 0; round < 40; ++round) {
    const double decimals = round % 2 == 0 ? 1e4 : 1;
    const double scale = round % 2 == 0 ? 1 : 1e4;  // integers, of a mesh of many units
    const double angle = 0.3 + round * 0.1;
    const auto place = [&](const Point& p) {
      const Point q{std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]};
      Point r{q[0], std::cos(1.0) * q[1] - std::sin(1.0) * q[2], std::sin(1.0) * q[1] + std::cos(1.0) * q[2]};
      for (double& c : r) c = std::round(c * scale * decimals) / decimals;
      return r;
    };
    std::vector<Point> points;
    Faces faces;
    for (const auto& side : cube_faces) {
      faces.emplace_back();
      for (std::size_t i = 0; i < side.size(); ++i) {
        const Point& from = cube_corners[side[i]];
        const Point& to = cube_corners[side[(i + 1) % side.size()]];
        const auto add = [&](double t) {
          Point p{};
          for (std::size_t a = 0; a < 3; ++a) p[a] = from[a] + t * (to[a] - from[a]);
          faces.back().push_back(static_cast<VertexIndex>(points.size()));
          points.push_back(place(p));
        };
        add(0);
        const bool forwards = side[i] < side[(i + 1) % side.size()];
        if (forwards && random() % 2 == 0) add(1.0 / 3);
        if (forwards && random() % 2 == 0) add(3.0 / 7);
        if (!forwards && random() % 2 == 0) add(0.2);
      }
    }
    PolyMesh mesh = mesh_of(points, faces);
    mesh.precision = decimals > 1 ? 1 / decimals : 0;
    const PolyImport result = mend_mesh(std::move(mesh));
    EXPECT_EQ(result.report.faces.sheets, 0U) << round;
    EXPECT_EQ(result.report.faces.crowded_edges, 0U) << round;
    EXPECT_EQ(result.scene.bodies.size(), 1U) << round;
  }
}

// Corners a third of a step apart in the file round to adjacent points of the grid: the cube is still a solid. Where rounding is
// exact,
// corners one step apart stay separate.
TEST(PolyMend, CracksOfRoundingAreClosed) {
  std::vector<std::array<double, 3>> points = cube_corners;
  for (auto& p : points) p[0] += 0.1 / 7;  // not a decimal fraction
  const double step = mend_mesh(mesh_of(points, cube_faces)).report.step;
  const double edge = (std::floor(points[1][0] / step) - 9.5) * step;  // between two points of the grid
  points[1][0] = points[2][0] = points[5][0] = points[6][0] = edge - step / 6;
  Faces faces = cube_faces;
  points.push_back({edge + step / 6, 0, 0});
  faces[2][1] = 8;
  const PolyImport closed = mend_mesh(mesh_of(points, faces));
  EXPECT_EQ(closed.report.step, step);
  EXPECT_EQ(closed.report.faces.joined_vertices, 1U);
  EXPECT_EQ(closed.report.faces.sheets, 0U);
  points = cube_corners;
  points.push_back({9, 0, 0});
  const PolyImport open = mend_mesh(mesh_of(points, faces));
  EXPECT_EQ(open.report.faces.joined_vertices, 0U);
  EXPECT_EQ(open.report.faces.sheets, 1U);
}

// The suggested distance closes the part, and none is suggested for a hole.
TEST(PolyMend, AHelpfulDistanceIsSuggested) {
  std::vector<std::array<double, 3>> points;
  Faces faces;
  add_loose_cube(0.01, points, faces);
  const PolyImport open = mend_mesh(mesh_of(points, faces));
  EXPECT_GT(open.report.faces.sheets, 0U);
  EXPECT_EQ(open.report.faces.helpful_weld, 0.02);  // corners are 0.01 or 0.0141 apart
  EXPECT_EQ(open.report.faces.sheets_with_weld, 0U);
  EXPECT_EQ(mend_mesh(mesh_of(points, faces), 0.02).report.faces.sheets, 0U);
  Faces hole = cube_faces;
  hole.pop_back();
  EXPECT_EQ(mend_mesh(mesh_of(cube_corners, hole)).report.faces.helpful_weld, 0.0);
}

// A square of a height field, warped so that its outline crosses itself along y, where its area is largest, but not along z.
TEST(PolyMend, AWarpedSquareOfAHeightFieldIsTwoTriangles) {
  const PolyImport result = mend_mesh(mesh_of({{0, 0, 20}, {0, 10, 23}, {10, 10, 2}, {10, 0, 27}}, {{0, 1, 2, 3}}));
  EXPECT_EQ(result.report.faces.crossing_faces, 0U);
  EXPECT_EQ(result.report.faces.split_faces, 1U);
  EXPECT_EQ(result.scene.bodies.at(0).faces.size(), 2U);
  // A planar one crosses itself in every projection; when turned, its corners are rounded.
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {9.7, 9.9, 3.3}, {9.7, 0, 3.3}, {0, 9.9, 0},
                                                  {0, 0, 9}, {9, 0, 9},       {0, 9, 9}};
  const PolyImport bow = mend_mesh(mesh_of(points, {{0, 1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(bow.report.faces.crossing_faces + bow.report.faces.dropped_faces, 1U);
}

// Random meshes: the result is valid. (Counts guard against empty results.)
TEST(PolyMend, RandomMeshesAreValidAfterwards) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const int size = 1 + static_cast<int>(random() % 9);
    std::vector<std::array<double, 3>> points(4 + random() % 12);
    for (auto& point : points)
      for (double& c : point) c = static_cast<double>(random() % static_cast<unsigned>(2 * size + 1));
    Faces faces(1 + random() % 30);
    for (auto& face : faces) {
      face.resize(3 + random() % 3);
      for (VertexIndex& v : face) v = static_cast<VertexIndex>(random() % points.size());
    }
    const auto result = import_poly(mesh_of(points, faces), {.mend = true});
    if (!result) continue;
    const auto errors = check_poly_scene(result->scene);
    EXPECT_TRUE(errors.empty()) << round << ": " << errors[0].message();
  }
}

// The order of vertices and faces in the file does not change the shape.
TEST(PolyMend, WeldingDoesNotDependOnTheOrder) {
  std::mt19937 random(11);
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 60; ++i) {
    std::array<double, 3> point{};
    for (double& c : point) c = static_cast<double>(random() % 1000) / 37.0;
    points.push_back(point);
  }
  Faces faces;
  for (VertexIndex v = 0; v + 2 < points.size(); v += 3) faces.push_back({v, v + 1, v + 2});
  const auto shape = [&](const std::vector<std::size_t>& order) {
    std::vector<std::array<double, 3>> shuffled;
    std::vector<VertexIndex> place(points.size());
    for (const std::size_t v : order) {
      place[v] = static_cast<VertexIndex>(shuffled.size());
      shuffled.push_back(points[v]);
    }
    Faces renamed = faces;
    for (auto& face : renamed)
      for (VertexIndex& v : face) v = place[v];
    std::vector<PolyPoint> all = mend_mesh(mesh_of(shuffled, renamed), 3).scene.vertices;
    std::sort(all.begin(), all.end());
    return all;
  };
  std::vector<std::size_t> order(points.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = v;
  const auto first = shape(order);
  EXPECT_LT(first.size(), points.size());
  for (int round = 0; round < 10; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    EXPECT_EQ(shape(order), first);
  }
}

}  // namespace
}  // namespace sightline::scene
