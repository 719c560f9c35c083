// The library as its users see it: only <sightline/hidden_lines.hpp> is included. That visibility is right is shown by the tests of
// the algorithm; here it is counted by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sightline/hidden_lines.hpp>
#include <string>
#include <thread>

namespace {

using sightline::Camera;
using sightline::Drawing;
using sightline::DrawOptions;
using sightline::Edge;
using sightline::Error;
using sightline::Kind;
using sightline::Mesh;
using sightline::Part;
using sightline::Scene;

// Adds a box, its faces counterclockwise from outside.
void add_box(Mesh& mesh, const sightline::Point& low, const sightline::Point& size) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      mesh.vertices.push_back({low[0] + x * size[0], low[1] + y * size[1], low[2] + z * size[2]});
  for (const auto& ring : {std::array<std::uint32_t, 4>{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = first + ring[i];
    mesh.add_face(corners);
  }
}

Mesh cube() {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {10, 10, 10});
  return mesh;
}

Mesh many_boxes(int side) {
  Mesh mesh;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) add_box(mesh, {3.0 * x, 0, 3.0 * y}, {2, 1.0 + (x * 7 + y * 5) % 4, 2});
  return mesh;
}

std::string error_of(const std::function<void()>& call, Error::Kind kind) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

TEST(Library, OfACubeNineEdgesAreVisibleAndThreeAreHidden) {
  const Scene scene(cube());
  EXPECT_EQ(scene.face_count(), 6U);
  EXPECT_EQ(scene.vertex_count(), 8U);
  EXPECT_EQ(scene.bounds()[1], (sightline::Point{10, 10, 10}));
  EXPECT_EQ(scene.step(), 1);
  const Drawing drawing = scene.draw({.view = "iso"}, {.hidden = true});
  EXPECT_EQ(drawing.edges.size(), 12U);
  EXPECT_EQ(drawing.lines.size(), 12U);
  std::map<Kind, int> kinds;
  int hidden = 0;
  for (const Part& part : drawing.parts) {
    EXPECT_EQ(part.low, (sightline::Fraction{0, 1}));
    EXPECT_EQ(part.high, (sightline::Fraction{1, 1}));
    hidden += part.hidden ? 1 : 0;
    // The three faces that are seen hide the back.
    EXPECT_EQ(part.hidden, part.hidden_by == 1 || part.hidden_by == 3 || part.hidden_by == 4) << part.hidden_by;
    ++kinds[drawing.edges[part.edge].kind];
  }
  EXPECT_EQ(hidden, 3);
  EXPECT_EQ(kinds, (std::map<Kind, int>{{Kind::silhouette, 6}, {Kind::crease, 6}}));
  for (const Edge& edge : drawing.edges) EXPECT_EQ(edge.face_count, 2U);
}

// The documented formula puts the ends of each visible edge where its line is drawn.
TEST(Library, AxesScaleAndLowTellWhereAPointIsDrawn) {
  const Scene scene(cube());
  for (const Camera& camera : {Camera{.view = "iso"}, Camera{.eye = sightline::Point{30, 25, 40}}}) {
    const Drawing drawing = scene.draw(camera, {.width = 150, .height = 100});
    EXPECT_EQ(drawing.perspective, camera.eye.has_value());
    ASSERT_EQ(drawing.lines.size(), 9U);
    for (const sightline::Line& line : drawing.lines) {
      ASSERT_EQ(line.edge_count, 1U);
      std::set<std::array<long, 2>> expected;
      for (const sightline::Point& end : drawing.edges[drawing.line_edges[line.first_edge]].ends) {
        const auto along = [&](std::size_t axis) {
          double sum = 0;
          for (std::size_t a = 0; a < 3; ++a) sum += drawing.axes[axis][a] * (end[a] - drawing.eye[a]);
          return sum;
        };
        const double depth = drawing.perspective ? along(2) : 1;
        expected.insert({std::lround(1e6 * drawing.scale * (along(0) / depth - drawing.low[0])),
                         std::lround(1e6 * drawing.scale * (along(1) / depth - drawing.low[1]))});
      }
      const std::set<std::array<long, 2>> found{{std::lround(1e6 * line.from[0]), std::lround(1e6 * line.from[1])},
                                                {std::lround(1e6 * line.to[0]), std::lround(1e6 * line.to[1])}};
      EXPECT_EQ(found, expected);
    }
  }
}

// Bodies are given in another order than their faces.
TEST(Library, FacesHaveTheNumbersOfTheMesh) {
  for (const bool mend : {true, false}) {
    Mesh mesh = many_boxes(2);
    for (std::uint32_t face = 0; face < 24; ++face) mesh.bodies.push_back(std::array{3U, 0U, 2U, 1U}[face / 6]);
    const Drawing drawing = Scene(mesh, {.mend = mend}).draw({.view = "iso"}, {.hidden = true});
    EXPECT_EQ(drawing.edges.size(), 48U);
    for (const Edge& edge : drawing.edges) {
      ASSERT_EQ(edge.face_count, 2U);
      for (std::uint32_t f = 0; f < 2; ++f)
        for (const std::uint32_t vertex : edge.vertices) EXPECT_EQ(drawing.faces[edge.first_face + f] / 6, vertex / 8);
    }
  }
}

TEST(Library, AHiddenPartNamesTheFaceThatHidesIt) {
  // A plate from -5 to 5 in front of a line from -10 to 10.
  Mesh mesh;
  mesh.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, {-10, 1, -4}, {10, 1, -4}};
  mesh.add_face(std::array{0U, 1U, 2U, 3U});
  mesh.add_polyline(std::array{4U, 5U});
  const Drawing drawing = Scene(mesh).draw({.direction = sightline::Point{0, 0, -1}}, {.hidden = true});
  std::vector<Part> parts;
  for (const Part& part : drawing.parts)
    if (drawing.edges[part.edge].kind == Kind::polyline) parts.push_back(part);
  ASSERT_EQ(parts.size(), 3U);
  const std::array places{sightline::Fraction{0, 1}, sightline::Fraction{1, 4}, sightline::Fraction{3, 4}, sightline::Fraction{1, 1}};
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(parts[p].low, places[p]);
    EXPECT_EQ(parts[p].high, places[p + 1]);
    EXPECT_EQ(parts[p].hidden, p == 1);
    EXPECT_EQ(parts[p].hidden_by, p == 1 ? 0U : sightline::none);
  }
  const Edge& line = drawing.edges[parts[0].edge];
  EXPECT_EQ(line.vertices, (std::array{4U, 5U}));
  EXPECT_EQ(line.body, sightline::none);
  EXPECT_EQ(line.face_count, 0U);
}

TEST(Library, FacesAreNumberedAsInTheMeshThoughBodiesAlternate) {
  // Triangles one behind the other: the first and the third are body 1.
  Mesh mesh;
  for (const double z : {0.0, 5.0, 10.0, 15.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}}) mesh.vertices.push_back({x, y, z});
    mesh.add_face(std::array{first, first + 1, first + 2});
  }
  mesh.bodies = {1, 0, 1, 0};
  for (const bool mend : {true, false}) {
    const Drawing drawing = Scene(mesh, {.mend = mend}).draw({.view = "iso"});
    EXPECT_EQ(drawing.edges.size(), 12U);
    for (const Edge& edge : drawing.edges) {
      ASSERT_EQ(edge.face_count, 1U);
      const std::uint32_t face = drawing.faces[edge.first_face];
      EXPECT_EQ(face, edge.vertices[0] / 3);
      EXPECT_EQ(edge.body, mesh.bodies[face]);
    }
  }
}

TEST(Library, PartsOfEveryEdgeAreItsWholeLengthAndLinesAreOfTheirEdges) {
  const Scene scene(many_boxes(6));
  const Drawing drawing = scene.draw({.eye = sightline::Point{40, 30, 45}}, {.hidden = true});
  std::vector<double> length(drawing.edges.size());
  for (const Part& part : drawing.parts) {
    length[part.edge] += part.high.value() - part.low.value();
    EXPECT_TRUE(part.hidden_by == sightline::none || part.hidden_by < 6U * 36U);
  }
  for (const double sum : length) EXPECT_NEAR(sum, 1, 1e-12);
  std::set<std::uint32_t> in_lines(drawing.line_edges.begin(), drawing.line_edges.end());
  EXPECT_EQ(in_lines.size(), drawing.edges.size());
}

TEST(Library, PreparedViewsAreTheViewsOfEach) {
  const Scene scene(many_boxes(4));
  const auto prepared = scene.prepare({.hidden = true});
  for (const std::string& view : sightline::view_names()) {
    const Drawing one = scene.draw({.view = view}, {.hidden = true});
    const Drawing other = prepared.draw({.view = view});
    EXPECT_EQ(one.file(), other.file()) << view;
    EXPECT_EQ(one.file(), scene.draw({.view = view}, {.hidden = true, .jobs = 3}).file()) << view;
  }
}

TEST(Library, ADrawingGrowsWithItsScaleAndSoDoesItsFile) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {30, 1, 0}, {0, 1, 0}};
  mesh.corners = {0, 1, 2, 3};
  mesh.ring_sizes = {4};
  const Drawing drawing = Scene(mesh).draw({.view = "front"}, {.scale = 20});
  EXPECT_EQ(drawing.width, 600);
  EXPECT_NE(drawing.file({.margin = 10}).find("width=\"620.000mm\""), std::string::npos) << drawing.file().substr(0, 300);
}

TEST(Library, AnEyeOffTheGridIsNoted) {
  const Mesh mesh = cube();
  const sightline::Point eye{24.4, 21.6, 20.5};
  const Drawing rounded = Scene(mesh).draw({.eye = eye});
  EXPECT_EQ(rounded.eye, (sightline::Point{24, 22, 21}));
  ASSERT_EQ(rounded.notes.size(), 1U);
  EXPECT_EQ(rounded.notes[0].substr(0, 50), "eye: rounded from 24.4,21.6,20.5 to 24,22,21, the ");
  const Drawing nearer = Scene(mesh, {.eye = eye}).draw({.eye = eye});
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(nearer.eye[a], eye[a], 0.01);
}

TEST(Library, HolesMayTurnEitherWay) {
  const auto drawn = [](const std::vector<std::uint32_t>& hole) {
    Mesh mesh;
    mesh.vertices = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, {-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {-9, 1, -2}, {9, 1, -2}};
    mesh.add_face(std::array{0U, 1U, 2U, 3U}, std::array{hole});
    mesh.add_polyline(std::array{8U, 9U});
    return Scene(mesh).draw({.view = "front"}).file();
  };
  EXPECT_EQ(drawn({4, 5, 6, 7}), drawn({7, 6, 5, 4}));
}

TEST(Library, SeveralThreadsMayUseOneScene) {
  const Scene scene(many_boxes(5));
  const auto prepared = scene.prepare();
  const std::string expected = prepared.draw({.view = "iso"}).file();
  std::array<std::string, 4> found;
  std::vector<std::thread> threads;
  for (std::string& file : found) threads.emplace_back([&] { file = prepared.draw({.view = "iso"}).file(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& file : found) EXPECT_EQ(file, expected);
}

TEST(Library, FilesHaveTheBeginningOfTheirFormat) {
  const Drawing drawing = Scene(cube()).draw();
  for (const auto& [format, beginning] : std::map<std::string, std::string>{
           {"svg", "<?xml"}, {"pdf", "%PDF-"}, {"dxf", "  0\nSECTION"}, {"png", "\x89PNG"}, {"hpgl", "IN;"}})
    EXPECT_EQ(drawing.file({.format = format}).substr(0, beginning.size()), beginning) << format;
  EXPECT_EQ(error_of([&] { static_cast<void>(drawing.file({.format = "bmp"})); }, Error::Kind::usage),
            "format: found \"bmp\", expected svg, pdf, dxf, hpgl, png or steps");
}

TEST(Library, DamageOfArraysIsNamedWithItsPlace) {
  const auto damaged = [](const std::function<void(Mesh&)>& damage) {
    Mesh mesh = cube();
    damage(mesh);
    return error_of([&] { Scene scene(mesh); }, Error::Kind::bad_input);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(damaged([](Mesh& m) { m.vertices[2][1] = nan; }), "mesh: vertex 2: found nan, expected a finite number");
  EXPECT_EQ(damaged([](Mesh& m) { m.corners[5] = 8; }), "mesh: corners[5]: found vertex 8, expected a number below 8");
  EXPECT_EQ(damaged([](Mesh& m) { m.ring_sizes[0] = 5; }), "mesh: ring_sizes: found sizes with the sum 25, expected 24, the number of corners");
  EXPECT_EQ(damaged([](Mesh& m) { m.ring_sizes[0] = 2, m.ring_sizes[1] = 6; }), "mesh: ring_sizes[0]: found 2, expected at least 3");
  EXPECT_EQ(damaged([](Mesh& m) { m.face_rings = {1, 1, 1, 1, 1}; }), "mesh: face_rings: found numbers with the sum 5, expected 6, the number of rings");
  EXPECT_EQ(damaged([](Mesh& m) { m.bodies = {0}; }), "mesh: bodies: found 1 numbers, expected 6, one for each face");
  EXPECT_EQ(damaged([](Mesh& m) { m.bodies = {0, 0, 0, 0, 0, 4294967295}; }),
            "mesh: bodies[5]: found 4294967295, expected a number below 6, the number of faces");
  EXPECT_EQ(damaged([](Mesh& m) { m.line_sizes = {2}, m.line_points = {0}; }), "mesh: line_sizes: found sizes with the sum 2, expected 1, the number of line_points");
  EXPECT_EQ(damaged([](Mesh& m) { m = Mesh(); }), "mesh: found no faces, expected a mesh; points alone make no drawing");
  Mesh open = cube();
  open.ring_sizes.pop_back();
  open.corners.resize(20);
  EXPECT_NO_THROW(Scene{open}) << "a sheet";
  EXPECT_NE(error_of([] { static_cast<void>(Scene::load("no/such/file.obj")); }, Error::Kind::io).find("no/such/file.obj"), std::string::npos);
}

TEST(Library, WrongOptionsAndCamerasAreNamed) {
  const Scene scene(cube());
  const auto usage = [&](const Camera& camera, const DrawOptions& options) {
    return error_of([&] { static_cast<void>(scene.draw(camera, options)); }, Error::Kind::usage);
  };
  EXPECT_EQ(usage({.view = "side"}, {}).substr(0, 26), "view: found \"side\", expect");
  EXPECT_EQ(usage({.view = "iso", .eye = sightline::Point{1, 2, 3}}, {}), "eye: found besides view, expected one of them");
  EXPECT_EQ(usage({.direction = sightline::Point{}}, {}), "direction: found 0,0,0, expected a direction");
  EXPECT_EQ(usage({}, {.width = -1}), "width: found -1, expected a number above 0, at most 1e9");
  EXPECT_EQ(usage({}, {.jobs = 0}), "jobs: found 0, expected 1 to 1024");
  EXPECT_EQ(usage({.eye = sightline::Point{30, 30, 30}}, {.scale = 2}), "scale: found in perspective, expected parallel projection");
  EXPECT_EQ(usage({.view = "iso"}, {.field = 60}), "field: found in parallel projection, expected perspective, or scale");
  EXPECT_EQ(usage({}, {.edges = "corners"}).substr(0, 22), "edges: found \"corners\"");
  EXPECT_NE(error_of([&] { static_cast<void>(scene.draw({.eye = sightline::Point{5, 5, 5}})); }, Error::Kind::bad_input).find("inside this solid"),
            std::string::npos);
}

TEST(Library, WorkEndsWhenTheProgressFunctionSaysSo) {
  const Mesh mesh = many_boxes(40);
  const auto calls_of = [](const std::function<void(const sightline::Progress&)>& work) {
    int calls = 0;
    double before = 0;
    work([&](double done) {
      EXPECT_GE(done, before);
      EXPECT_LE(done, 1);
      before = done;
      ++calls;
      return true;
    });
    EXPECT_GE(before, 0.9) << "not followed to its end";
    return calls;
  };
  const auto load = [&](const sightline::Progress& progress) { Scene scene(mesh, {.progress = progress}); };
  const Scene scene(mesh);
  const auto draw = [&](const sightline::Progress& progress) { static_cast<void>(scene.draw({}, {.hidden = true, .progress = progress})); };
  for (const std::function<void(const sightline::Progress&)>& work : {std::function<void(const sightline::Progress&)>(load), {draw}}) {
    const int calls = calls_of(work);
    EXPECT_GT(calls, 3);
    for (int stop = 0; stop < calls; ++stop) {
      int call = 0;
      EXPECT_EQ(error_of([&] { work([&](double) { return call++ < stop; }); }, Error::Kind::cancelled), "cancelled");
      EXPECT_EQ(call, stop + 1) << "no call after the last one";
      call = 0;
      const auto fail = [&](double) -> bool {
        if (call++ == stop) throw std::out_of_range("mine");
        return true;
      };
      EXPECT_THROW(work(fail), std::out_of_range);
    }
  }
}

}  // namespace
