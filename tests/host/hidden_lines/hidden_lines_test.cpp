// The library interface: results for arrays, names, invalid requests and files. The cube's edges are counted by hand; tests of
// the
// command (tests/host/app) and of the algorithms check that drawings are correct.
#include "host/hidden_lines/hidden_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline::hidden_lines {
namespace {

// From 0 to 10 along each axis, its faces counterclockwise seen from outside.
scene::PolyMesh cube() {
  scene::PolyMesh mesh;
  mesh.source = "cube";
  for (const double z : {0.0, 10.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}}) mesh.vertices.push_back({x, y, z});
  scene::PolyBody body;
  for (const auto& outline : std::vector<std::vector<scene::VertexIndex>>{
           {3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    body.faces.push_back({outline, {}});
  mesh.bodies.push_back(body);
  return mesh;
}

// A camera that sees three sides of the cube.
Camera oblique() { return {false, {}, {-1, -1, -1}, {1, 0, -1}, {-1, 2, -1}}; }

TEST(HiddenLines, OfACubeInMemoryNineEdgesAreVisibleAndThreeHidden) {
  const auto scene = load(cube());
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->name, "cube");
  ViewOptions options;
  options.strokes = true;
  options.hidden = true;
  const auto drawing = view(*scene, oblique(), options);
  ASSERT_TRUE(drawing) << drawing.error().message();
  EXPECT_EQ(drawing->visible.pieces.size(), 9U);
  std::size_t hidden = 0;
  for (const Stroke& stroke : drawing->strokes) {
    hidden += drawing->layers[stroke.layer].hidden ? 1 : 0;
    ASSERT_EQ(stroke.edge_count, 1U);
    const DrawnEdge& edge = drawing->edges_drawn[drawing->stroke_edges[stroke.first_edge]];
    double length = 0;
    for (std::size_t a = 0; a < 3; ++a) length += std::abs(edge.ends[0][a] - edge.ends[1][a]);
    EXPECT_EQ(length, 10) << "in the unit of the arrays";
    EXPECT_EQ(edge.face_count, 2U);
  }
  EXPECT_EQ(drawing->strokes.size(), 12U);
  EXPECT_EQ(hidden, 3U);
  const std::string text = json_lines(*drawing, 5);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 12);
}

// Two tetrahedra whose faces and vertices alternate in the arrays; as bodies, each has its own.
scene::PolyMesh alternating_tetrahedra() {
  scene::PolyMesh mesh;
  mesh.source = "tetrahedra";
  const std::array<std::array<double, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const auto& [x, y, z] : corners)
    for (const double along : {0.0, 5.0}) mesh.vertices.push_back({x + along, y, z});
  scene::PolyBody body;
  for (const auto& [a, b, c] : std::vector<std::array<scene::VertexIndex, 3>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    for (const scene::VertexIndex of : {0U, 1U}) body.faces.push_back({{2 * a + of, 2 * b + of, 2 * c + of}, {}});
  mesh.bodies.push_back(body);
  return mesh;
}

TEST(HiddenLines, FacesAndVerticesOfAnEdgeAreNumberedAsInTheArrays) {
  const scene::PolyMesh mesh = alternating_tetrahedra();
  const auto scene = load(mesh);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->scene.bodies.size(), 2U);
  ViewOptions options;
  options.strokes = true;
  options.hidden = true;
  const auto drawing = view(*scene, oblique(), options);
  ASSERT_TRUE(drawing) << drawing.error().message();
  EXPECT_EQ(drawing->edges_drawn.size(), 12U);
  for (const DrawnEdge& edge : drawing->edges_drawn) {
    for (std::size_t e = 0; e < 2; ++e) {
      ASSERT_LT(edge.vertices[e], mesh.vertices.size());
      EXPECT_EQ(edge.ends[e], mesh.vertices[edge.vertices[e]]);
    }
    std::vector<std::uint32_t> expected;
    for (std::uint32_t f = 0; f < mesh.bodies[0].faces.size(); ++f) {
      const auto& ring = mesh.bodies[0].faces[f].outline;
      const auto has = [&](std::uint32_t vertex) { return std::find(ring.begin(), ring.end(), vertex) != ring.end(); };
      if (has(edge.vertices[0]) && has(edge.vertices[1])) expected.push_back(f);
    }
    const auto faces = std::span(drawing->edge_faces).subspan(edge.first_face, edge.face_count);
    EXPECT_EQ(std::vector<std::uint32_t>(faces.begin(), faces.end()), expected);
  }
  // The parts of each edge are its whole length.
  for (std::uint32_t e = 0; e < drawing->edges_drawn.size(); ++e) {
    geometry::Rational at = 0;
    for (const DrawnPart& part : drawing->parts) {
      if (part.edge != e) continue;
      EXPECT_EQ(part.low, at);
      at = part.high;
    }
    EXPECT_EQ(at, geometry::Rational(1));
  }
}

// The first object returns after the second.
TEST(HiddenLines, FacesOfAnObjectThatReturnsAreNumberedAsInTheFile) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 0 0\nv 10 0 0\nv 9 1 0\no A\nf 1 2 3\no B\nf 4 5 6\no A\nf 7 8 9\n";
  const auto scene = load(scene::SceneFile{.name = "returns.obj", .text = text});
  ASSERT_TRUE(scene) << scene.error().message();
  ViewOptions options;
  options.strokes = true;
  const auto drawing = view(*scene, Camera{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, options);
  ASSERT_TRUE(drawing) << drawing.error().message();
  ASSERT_EQ(drawing->edges_drawn.size(), 9U);
  for (const DrawnEdge& edge : drawing->edges_drawn) {
    ASSERT_EQ(edge.face_count, 1U);
    const double x = std::min(edge.ends[0][0], edge.ends[1][0]);
    EXPECT_EQ(drawing->edge_faces[edge.first_face], x < 2 ? 0U : x < 8 ? 1U : 2U);
  }
}

TEST(HiddenLines, ACreaseIsMeasuredAlsoWhereAllEdgesAreDrawn) {
  scene::PolyMesh mesh;
  mesh.source = "fold";
  mesh.vertices = {{0, 0, 0}, {0, 10, 0}, {10, 0, 0}, {10, 10, 0}, {-8, 0, 6}, {-8, 10, 6}};
  scene::PolyBody body;
  body.faces = {{{0, 2, 3, 1}, {}}, {{0, 1, 5, 4}, {}}};
  mesh.bodies.push_back(body);
  const auto scene = load(mesh);
  ASSERT_TRUE(scene) << scene.error().message();
  for (const auto& [crease, kind] : {std::pair{30.0, "crease"}, {60.0, "flat"}}) {
    ViewOptions options;
    options.strokes = true;
    options.edges = {.kinds = "all", .crease = crease};
    const auto drawing = view(*scene, Camera{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, options);
    ASSERT_TRUE(drawing) << drawing.error().message();
    for (const DrawnEdge& edge : drawing->edges_drawn) EXPECT_EQ(edge.kind, edge.face_count == 2 ? kind : "boundary") << crease;
  }
}

TEST(HiddenLines, AFaceWithAHoleHidesWhatIsNotBehindTheHole) {
  // A square of 10 with a hole of 4 in its middle, and a line behind it from side to side.
  scene::PolyMesh mesh;
  mesh.source = "frame";
  for (const double half : {5.0, 2.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) mesh.vertices.push_back({x * half, y * half, 0.0});
  mesh.vertices.push_back({-5, 0.5, -1});
  mesh.vertices.push_back({5, 0.5, -1});
  scene::PolyBody body;
  body.faces.push_back({{0, 1, 2, 3}, {{7, 6, 5, 4}}});
  mesh.bodies.push_back(body);
  mesh.wires.push_back({8, 9});
  const auto scene = load(mesh);
  ASSERT_TRUE(scene) << scene.error().message();
  ViewOptions options;
  options.strokes = true;
  const auto drawing = view(*scene, Camera{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, options);
  ASSERT_TRUE(drawing) << drawing.error().message();
  EXPECT_EQ(drawing->edges_drawn.size(), 9U) << "eight sides and the line: no edges between triangles";
  for (const DrawnPart& part : drawing->parts) {
    const DrawnEdge& edge = drawing->edges_drawn[part.edge];
    if (edge.kind != "wire") {
      ASSERT_EQ(edge.face_count, 1U);
      EXPECT_EQ(drawing->edge_faces[edge.first_face], 0U) << "all triangles are face 0";
      continue;
    }
    EXPECT_EQ(part.low, geometry::Rational(3, 10));
    EXPECT_EQ(part.high, geometry::Rational(7, 10));
  }
  mesh.vertices.push_back({20, 0, 0});
  mesh.bodies[0].faces[0].holes[0] = {7, 6, 10, 4};
  EXPECT_FALSE(load(mesh)) << "the hole crosses the outline";
  mesh.vertices.pop_back();
  mesh.bodies[0].faces[0].holes[0] = {7, 6, 5, 4};
  mesh.vertices[2][2] = 5;
  EXPECT_TRUE(load(mesh)) << "triangles";
  const auto strict = load(mesh, {});
  ASSERT_FALSE(strict);
  EXPECT_NE(strict.error().message().find("body 0, face 0"), std::string::npos) << strict.error().message();
}

TEST(HiddenLines, OnlyExactHasProofs) {
  const auto scene = load(cube());
  ASSERT_TRUE(scene);
  ViewOptions options;
  options.proof = true;
  const auto drawing = view(*scene, oblique(), options);
  ASSERT_TRUE(drawing);
  ASSERT_NE(drawing->proof, nullptr);
  EXPECT_EQ(drawing->proof->edges.size(), 12U);
  options.algorithm = "oracle";
  const auto refused = view(*scene, oblique(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "proof: found with oracle, expected exact");
  EXPECT_EQ(refused.error().kind, base::ErrorKind::usage);
}

// A box of 10 x 6 x 4, whose sides differ.
scene::PolyMesh box() {
  scene::PolyMesh mesh = cube();
  mesh.source = "box";
  for (auto& vertex : mesh.vertices) {
    vertex[1] *= 0.6;
    vertex[2] *= 0.4;
  }
  return mesh;
}

// The lowest and the highest place of what is drawn.
std::array<std::array<double, 2>, 2> extent_of(const std::vector<Stroke>& strokes) {
  std::array<std::array<double, 2>, 2> extent{{{1e9, 1e9}, {-1e9, -1e9}}};
  for (const Stroke& stroke : strokes) {
    for (const auto& end : {stroke.from, stroke.to}) {
      for (std::size_t a = 0; a < 2; ++a) {
        extent[0][a] = std::min(extent[0][a], end[a]);
        extent[1][a] = std::max(extent[1][a], end[a]);
      }
    }
  }
  return extent;
}

// x to the right, y upwards, z towards the eye of the view from the front.
TEST(HiddenLines, ASheetHasItsViewsAlignedAtOneScale) {
  const auto scene = load(box());
  ASSERT_TRUE(scene) << scene.error().message();
  const std::array views{SheetView{{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, Side::front},
                         SheetView{{false, {}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}}, Side::top},
                         SheetView{{false, {}, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, Side::right}};
  for (const bool first_angle : {false, true}) {
    ViewOptions options;
    options.strokes = true;
    options.field.width = 300;
    options.field.height = 200;
    const SheetLayout layout(scene->scene, views, options.field, first_angle, 20);
    options.field = layout.field();
    // 10 + 4 units and a gap are as wide as the field, 6 + 4 and a gap would be 240 at the same scale.
    const double scale = std::min(280.0 / 14, 180.0 / 10);
    ASSERT_DOUBLE_EQ(*options.field.scale * 1 / scene->scene.step, scale);
    const auto prepared = Views::of(*scene, options);
    ASSERT_TRUE(prepared) << prepared.error().message();
    std::vector<Drawing> drawings;
    for (const SheetView& view : views) drawings.push_back(*prepared->at(view.camera));
    const picture::VectorDrawing sheet = layout.sheet(drawings);
    EXPECT_EQ(sheet.width, 300);
    EXPECT_EQ(sheet.height, 200);
    EXPECT_EQ(sheet.lines.size(), drawings[0].picture.lines.size() + drawings[1].picture.lines.size() + drawings[2].picture.lines.size());
    const auto front = extent_of(drawings[0].strokes);
    const auto top = extent_of(drawings[1].strokes);
    const auto right = extent_of(drawings[2].strokes);
    EXPECT_NEAR(front[1][0] - front[0][0], 10 * scale, 1e-9);
    EXPECT_NEAR(front[1][1] - front[0][1], 6 * scale, 1e-9);
    EXPECT_NEAR(top[1][1] - top[0][1], 4 * scale, 1e-9);
    EXPECT_NEAR(right[1][0] - right[0][0], 4 * scale, 1e-9);
    for (std::size_t end = 0; end < 2; ++end) {
      EXPECT_NEAR(top[end][0], front[end][0], 1e-9) << "one above the other";
      EXPECT_NEAR(right[end][1], front[end][1], 1e-9) << "side by side";
    }
    if (first_angle) {
      EXPECT_NEAR(front[0][1] - top[1][1], 20, 1e-9);
      EXPECT_NEAR(front[0][0] - right[1][0], 20, 1e-9);
    } else {
      EXPECT_NEAR(top[0][1] - front[1][1], 20, 1e-9);
      EXPECT_NEAR(right[0][0] - front[1][0], 20, 1e-9);
    }
    // Its files have what the strokes say.
    double least = 1e9;
    for (const picture::DrawingPoint& point : sheet.points) least = std::min(least, double{point.x});
    EXPECT_NEAR(least, std::min(front[0][0], right[0][0]), 1e-4);
  }
}

TEST(HiddenLines, ACutIsHatchedAtADistanceOnThePaper) {
  const auto scene = load(box());
  ASSERT_TRUE(scene);
  const scene::SectionPlane plane{2, 2, false};
  const auto section = scene::section_of(*scene, {&plane, 1});
  ASSERT_TRUE(section) << section.error().message();
  ViewOptions options;
  options.strokes = true;
  options.field = {100, 100, {}};
  options.cut_material = section->cut_material;
  const auto drawing = view(section->loaded, Camera{false, {}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, options);
  ASSERT_TRUE(drawing) << drawing.error().message();
  // 10 x 6 units at 10 mm a unit: lines at 45 degrees that are 2 mm apart meet the diagonal across them every 2 mm.
  std::size_t lines = 0;
  for (const Stroke& stroke : drawing->strokes) {
    if (drawing->layers[stroke.layer].name != "section") continue;
    ++lines;
    EXPECT_NEAR(stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1], 1e-6);
  }
  EXPECT_NEAR(static_cast<double>(lines), (100 + 60) / std::sqrt(2.0) / 2, 2);
}

TEST(HiddenLines, ViewsOfOnePreparationAreTheViewsOfEach) {
  const auto scene = load("house");
  ASSERT_TRUE(scene) << scene.error().message();
  const auto views = Views::of(*scene);
  ASSERT_TRUE(views) << views.error().message();
  for (const scene::PolyPoint& forward : {scene::PolyPoint{-1, -1, -1}, {1, -1, 1}}) {
    Camera camera = oblique();
    camera.forward = forward;
    camera.right = {-forward[2], 0, forward[0]};
    camera.up = {forward[0], 2, forward[2]};
    const auto one = views->at(camera);
    const auto alone = view(*scene, camera);
    ASSERT_TRUE(one && alone);
    EXPECT_FALSE(one->visible.pieces.empty());
    EXPECT_EQ(one->visible, alone->visible);
    EXPECT_EQ(one->picture.points, alone->picture.points);
    const auto edges = visible_edges(scene->scene, camera);
    ASSERT_TRUE(edges);
    EXPECT_EQ(edges->picture, one->visible) << "all edges are chosen";
  }
}

TEST(HiddenLines, ArraysThatAreNotAMeshAreErrorsWithTheirPosition) {
  scene::PolyMesh mesh = cube();
  mesh.vertices[5][1] = std::numeric_limits<double>::quiet_NaN();
  auto refused = load(mesh);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "vertex 5");
  mesh = cube();
  mesh.bodies[0].faces[2].outline[1] = 8;
  refused = load(mesh);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "body 0, face 2");
  mesh = cube();
  mesh.wires.push_back({0, 99});
  refused = load(mesh);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "line 0");
  mesh = cube();
  mesh.materials = {0, 1, 0};
  refused = load(mesh);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "materials");
  // Moves a corner, so that a face is not planar: an error, or mended.
  mesh = cube();
  mesh.vertices[6] = {10, 10, 13};
  EXPECT_FALSE(load(mesh, {}));
  const auto mended = load(mesh);
  ASSERT_TRUE(mended);
  EXPECT_FALSE(notes_of(mended->report).empty());
}

TEST(HiddenLines, ErrorsHaveAKindAndNameTheOption) {
  const auto missing = load("no-such-file.off");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, base::ErrorKind::io);
  const auto too_large = load("boxes-999999999999");
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().kind, base::ErrorKind::usage);

  const auto scene = load(cube());
  ASSERT_TRUE(scene);
  const auto wrong = [&](const ViewOptions& options) {
    const auto views = Views::of(*scene, options);
    EXPECT_FALSE(views);
    return views ? base::Error{} : views.error();
  };
  ViewOptions options;
  options.algorithm = "painter";
  EXPECT_EQ(wrong(options).file, "algorithm");
  EXPECT_EQ(wrong(options).kind, base::ErrorKind::usage);
  options = {};
  options.edges.kinds = "creases";
  EXPECT_EQ(wrong(options).file, "edges");
  EXPECT_EQ(wrong(options).kind, base::ErrorKind::usage);
  options = {};
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  options.edges.crease = no_number;
  EXPECT_EQ(wrong(options).file, "crease");
  for (const HatchOptions& hatch : {HatchOptions{45, 0}, HatchOptions{45, -1}, HatchOptions{45, no_number}, HatchOptions{no_number, 1},
                                    HatchOptions{45, 1, std::array{0.0, 0.0, 0.0}}, HatchOptions{45, 1, std::array{1.0, no_number, 0.0}}}) {
    options = {};
    options.hatch = hatch;
    EXPECT_EQ(wrong(options).file, "hatch") << hatch.angle << ", " << hatch.spacing;
  }
  EXPECT_FALSE(visible_edges(scene->scene, oblique(), "painter"));
  // Steeply from above: not a view of a turn about the vertical.
  const auto seen = visible_edges(scene->scene, oblique(), "plantinga");
  ASSERT_FALSE(seen);
  EXPECT_EQ(seen.error().kind, base::ErrorKind::bad_input);
}

TEST(HiddenLines, OmissionsAreNotes) {
  scene::PolyMesh mesh = cube();
  const auto first = static_cast<scene::VertexIndex>(mesh.vertices.size());
  for (std::size_t v = 0; v < first; ++v) mesh.vertices.push_back({mesh.vertices[v][0] + 5, mesh.vertices[v][1] + 5, mesh.vertices[v][2] + 5});
  scene::PolyBody second = mesh.bodies[0];
  for (scene::PolyFace& face : second.faces)
    for (scene::VertexIndex& v : face.outline) v += first;
  mesh.bodies.push_back(second);
  mesh.grouped = true;
  const auto scene = load(mesh);
  ASSERT_TRUE(scene) << scene.error().message();
  ViewOptions options;
  EXPECT_TRUE(Views::of(*scene, options)->notes().empty()) << "exact draws where bodies cross";
  options.algorithm = "montani-re";
  const auto views = Views::of(*scene, options);
  ASSERT_TRUE(views) << views.error().message();
  ASSERT_EQ(views->notes().size(), 1U);
  EXPECT_NE(views->notes()[0].find("bodies pass through each other"), std::string::npos);
}

TEST(HiddenLines, FilesBeginAsTheirFormatsRequire) {
  const auto scene = load(cube());
  const auto drawing = view(*scene, oblique());
  ASSERT_TRUE(drawing);
  for (const auto& [ending, begins] : {std::pair<std::string_view, std::string_view>{"svg", "<?xml"},
                                       {"PNG", "\x89PNG"},
                                       {"plt", "IN;"},
                                       {"hpgl", "IN;"},
                                       {"pdf", "%PDF-1.5"},
                                       {"dxf", "  0\nSECTION"}}) {
    const auto format = format_named(ending);
    ASSERT_TRUE(format) << ending;
    const auto file = write(drawing->picture, {.format = *format});
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE(file->bytes.starts_with(begins)) << ending << ": " << file->bytes.substr(0, 12);
    EXPECT_EQ(file->plot.has_value(), *format != Format::png);
    EXPECT_TRUE(file->notes.empty());
  }
  EXPECT_FALSE(format_named("gif"));
  picture::VectorDrawing nothing;
  nothing.width = nothing.height = 10;
  const auto empty = write(nothing);
  ASSERT_TRUE(empty);
  EXPECT_EQ(empty->notes.size(), 1U);
}

}  // namespace
}  // namespace sightline::hidden_lines
