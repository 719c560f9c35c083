// Every kind of error in a scene of polyhedra is found and named; scenes without errors are accepted.
#include "host/scene/check/poly_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "tests/host/scene/generate/generated_set.hpp"
#include "tests/host/scene/poly_support.hpp"

namespace sightline::scene {
namespace {

// A cube of 10, low corner at the origin, and a square sheet of 20 with a clockwise square hole at z = 50.
PolyScene cube_and_sheet() {
  PolyBuilder builder;
  builder.add_box("cube", {0, 0, 0}, {10, 10, 10});
  const PolyPoint square[] = {{0, 0, 50}, {20, 0, 50}, {20, 20, 50}, {0, 20, 50}};
  builder.add_sheet("", square);
  PolyFace& face = builder.scene().bodies[1].faces[0];
  std::vector<VertexIndex> hole;
  for (const PolyPoint& p : {PolyPoint{5, 5, 50}, {5, 15, 50}, {15, 15, 50}, {15, 5, 50}})
    hole.push_back(builder.vertex(p));
  face.holes.push_back(hole);
  return builder.take();
}

TEST(CheckPolyScene, AcceptsValidScenes) {
  EXPECT_EQ(problems(cube_and_sheet()), "");
  for (const std::string_view family : generator_names()) {
    const auto scene = generate_scene(family, 3, 7);
    EXPECT_EQ(problems(*scene), "") << family;
  }
}

TEST(CheckPolyScene, TheGeneratedSetIsValid) {
  for (const GeneratedSceneName& name : generated_set()) {
    const auto scene = generate_scene(name.family, name.size, name.seed);
    ASSERT_EQ(problems(*scene), "") << scene->name;
  }
}

struct Damage {
  const char* name;
  std::function<void(PolyScene&)> damage;
  std::string found;
};

class DamagedPolyScene : public testing::TestWithParam<Damage> {};

TEST_P(DamagedPolyScene, IsNamed) {
  PolyScene scene = cube_and_sheet();
  GetParam().damage(scene);
  EXPECT_EQ(problems(scene), GetParam().found);
}

// Vertices 8..11 are the sheet's outline, 12..15 its hole.
const Damage kinds[] = {
    {"empty", [](PolyScene& s) { s = PolyScene{}; }, "bodies: expected at least one body, found none\n"},
    {"body_without_faces",
     [](PolyScene& s) {
       s.bodies.push_back({"nothing", true, {}});
     },
     "body 2 \"nothing\": has no faces\n"},
    {"beyond_the_limit", [](PolyScene& s) { s.vertices[9][0] = 1 << 18; },
     "vertex 9: found (262144, 0, 50), expected coordinates -262143..262143\n"},
    {"beyond_the_limit_below", [](PolyScene& s) { s.vertices[9][2] = INT32_MIN; },
     "vertex 9: found (20, 0, -2147483648), expected coordinates -262143..262143\n"},
    {"eye_beyond_the_limit",
     [](PolyScene& s) {
       s.camera.eye = {0, -262144, 0};
     },
     "camera: the eye is (0, -262144, 0), expected coordinates -262143..262143\n"},
    {"camera_not_orthogonal",
     [](PolyScene& s) {
       s.camera.up = {0, 1, 1};
     },
     "camera: up and forward are not orthogonal\n"},
    {"camera_zero", [](PolyScene& s) { s.camera.right = {}; }, "camera: right is zero\n"},
    {"no_such_vertex", [](PolyScene& s) { s.bodies[1].faces[0].holes[0][2] = 16; },
     "body 1, face 0: names vertex 16, of 16\n"},
    {"unused",
     [](PolyScene& s) {
       s.vertices.push_back({1, 2, 3});
     },
     "vertex 16: is not used by any face\n"},
    {"wire_of_no_vertex", [](PolyScene& s) { s.wires = {{0, 5}, {3, 16}}; }, "wire 1: names vertex 16, of 16\n"},
    {"wire_of_a_point", [](PolyScene& s) { s.wires = {{0, 5}, {3, 3}}; }, "wire 1: joins vertex 3 to itself\n"},
    {"unused_beside_wires",
     [](PolyScene& s) {
       s.vertices.push_back({1, 2, 3});
       s.wires = {{0, 5}};
     },
     "vertex 16: is not used by any face or wire\n"},
    {"duplicate",
     [](PolyScene& s) {
       s.vertices.push_back(s.vertices[9]);
       s.bodies[1].faces[0].outline[1] = 16;
       s.bodies.push_back({"", true, {{{9, 8, 11}, {}}}});
     },
     "vertex 16: is the same point (20, 0, 50) as vertex 9\n"},
    {"two_vertices",
     [](PolyScene& s) {
       s.bodies.push_back({"", true, {{{8, 9}, {}}}});
     },
     "body 2, face 0: the outline has 2 vertices, expected 3 or more\n"},
    {"vertex_twice",
     [](PolyScene& s) {
       s.bodies.push_back({"", true, {{{8, 9, 9, 10}, {}}}});
     },
     "body 2, face 0: the outline has vertex 9 (20, 0, 50) twice in succession\n"},
    {"vertex_twice_at_the_seam",
     [](PolyScene& s) {
       s.bodies.push_back({"", true, {{{8, 9, 10, 8}, {}}}});
     },
     "body 2, face 0: the outline has vertex 8 (0, 0, 50) twice in succession\n"},
    {"no_area",
     [](PolyScene& s) {
       s.vertices = {{0, 0, 0}, {5, 5, 5}, {10, 10, 10}};
       s.bodies = {{"", true, {{{0, 1, 2}, {}}}}};
     },
     "body 0, face 0: all vertices are on one line, expected an area\n"},
    {"not_planar", [](PolyScene& s) { s.vertices[11][2] = 51; },
     "body 1, face 0: vertex 11 (0, 20, 51) is not in the plane of vertices 8, 9 and 10\n"},
    {"hole_not_in_the_plane", [](PolyScene& s) { s.vertices[14][2] = 49; },
     "body 1, face 0: vertex 14 (15, 15, 49) is not in the plane of vertices 8, 9 and 10\n"},
    {"bow_tie",
     [](PolyScene& s) {
       s.bodies.push_back({"", true, {{{8, 10, 9, 11}, {}}}});
     },
     "body 2, face 0: the outline crosses or touches itself (edges 8-10 and 9-11)\n"},
    {"spike",
     [](PolyScene& s) {
       s.vertices.push_back({10, 0, 50});
       s.bodies.push_back({"", true, {{{8, 9, 16, 10}, {}}}});
     },
     "body 2, face 0: the outline crosses or touches itself (edges 8-9 and 9-16)\n"
     "body 2, face 0: the outline crosses or touches itself (edges 8-9 and 16-10)\n"},
    {"hole_outside",
     [](PolyScene& s) {
       for (VertexIndex v = 12; v < 16; ++v) s.vertices[v][0] += 100;
     },
     "body 1, face 0: hole 0 is outside the outline\n"},
    {"hole_touches",
     [](PolyScene& s) {
       for (VertexIndex v = 12; v < 16; ++v) s.vertices[v][0] += 5;
     },
     "body 1, face 0: hole 0 meets the outline (edges 13-14 and 9-10)\n"
     "body 1, face 0: hole 0 meets the outline (edges 15-12 and 9-10)\n"
     "body 1, face 0: hole 0 meets the outline (edges 9-10 and 14-15)\n"},
    {"hole_turns_the_wrong_way",
     [](PolyScene& s) {
       auto& hole = s.bodies[1].faces[0].holes[0];
       std::reverse(hole.begin(), hole.end());
     },
     "body 1, face 0: hole 0 turns the same way as the outline, expected the other way\n"},
    {"hole_in_hole",
     [](PolyScene& s) {
       s.vertices.insert(s.vertices.end(), {{7, 7, 50}, {7, 12, 50}, {12, 7, 50}});
       s.bodies[1].faces[0].holes.push_back({16, 17, 18});
     },
     "body 1, face 0: hole 1 is inside hole 0\n"},
    {"open_solid", [](PolyScene& s) { s.bodies[0].faces.pop_back(); },
     "body 0 \"cube\", face 0: edge 0-1 belongs to 1 face of the solid, expected 2\n"
     "body 0 \"cube\", face 2: edge 0-7 belongs to 1 face of the solid, expected 2\n"
     "body 0 \"cube\", face 3: edge 1-6 belongs to 1 face of the solid, expected 2\n"
     "body 0 \"cube\", face 1: edge 6-7 belongs to 1 face of the solid, expected 2\n"},
    {"a_face_turned_over",
     [](PolyScene& s) {
       auto& outline = s.bodies[0].faces[0].outline;
       std::reverse(outline.begin(), outline.end());
     },
     "body 0 \"cube\", face 0: edge 0-1 is passed in the same direction by face 5, expected opposite "
     "directions\n"
     "body 0 \"cube\", face 0: edge 0-3 is passed in the same direction by face 2, expected opposite "
     "directions\n"
     "body 0 \"cube\", face 0: edge 1-2 is passed in the same direction by face 3, expected opposite "
     "directions\n"
     "body 0 \"cube\", face 0: edge 2-3 is passed in the same direction by face 4, expected opposite "
     "directions\n"},
    {"inside_out",
     [](PolyScene& s) {
       for (PolyFace& face : s.bodies[0].faces) std::reverse(face.outline.begin(), face.outline.end());
     },
     "body 0 \"cube\", face 0: is part of a surface turned inside out, expected outlines counterclockwise "
     "from "
     "outside\n"},
    {"flat_solid",
     [](PolyScene& s) {
       s.bodies.push_back({"", false, {{{8, 9, 10}, {}}, {{10, 9, 8}, {}}}});
     },
     "body 2, face 0: is part of a surface that encloses nothing\n"},
    {"several",
     [](PolyScene& s) {
       s.vertices.push_back({1, 2, 3});
       s.vertices[11][2] = 51;
       s.camera.up = {};
     },
     "camera: up is zero\nvertex 16: is not used by any face\n"
     "body 1, face 0: vertex 11 (0, 20, 51) is not in the plane of vertices 8, 9 and 10\n"},
};

INSTANTIATE_TEST_SUITE_P(Kinds, DamagedPolyScene, testing::ValuesIn(kinds),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CheckPolyScene, ACavityFacesInwards) {
  PolyScene scene = hollow_box();
  EXPECT_EQ(problems(scene), "");
  for (VertexIndex v = 8; v < 16; ++v) scene.vertices[v][0] += 100;
  EXPECT_NE(problems(scene).find("face 6: is part of a surface turned inside out"), std::string::npos);
}

// A comb with so many teeth that each edge is next to every other one.
TEST(CheckPolyScene, TooManyAdjacentEdgesAreAnError) {
  const auto comb = [](std::int32_t teeth) {
    PolyScene scene;
    PolyFace face;
    for (std::int32_t i = 0; i < teeth; ++i) {
      scene.vertices.push_back({0, 4 * i, 0});
      scene.vertices.push_back({100000, 4 * i + 2, 0});
    }
    scene.vertices.push_back({-1, 4 * teeth, 0});
    scene.vertices.push_back({-1, 0, 0});
    for (VertexIndex v = 0; v < scene.vertices.size(); ++v) face.outline.push_back(v);
    scene.bodies = {{"", true, {face}}};
    return scene;
  };
  EXPECT_EQ(problems(comb(2000)), "");
  EXPECT_EQ(problems(comb(20000)), "body 0, face 0: has too many edges side by side to be checked\n");
}

TEST(CheckPolyScene, ReportsAtMostAHundredErrors) {
  PolyScene scene = generate_boxes(50);
  for (PolyPoint& p : scene.vertices) p[0] += 1 << 20;
  EXPECT_EQ(check_poly_scene(scene).size(), most_scene_errors);
}

}  // namespace
}  // namespace sightline::scene
