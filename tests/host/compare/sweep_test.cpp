// The table of algorithms, and sweeps: lines that depend only on their inputs, shards that together equal the whole, and the
// table of
// all lines.
#include "host/compare/sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/compare/piece_difference.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

scene::PolyScene generate_scene(std::string_view family, std::size_t size) {
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

// The summary of lines.
SweepTable table_of(const std::vector<std::string>& lines) {
  SweepTable table;
  for (const std::string& line : lines) EXPECT_TRUE(table.add(line)) << line;
  return table;
}

bool differs(const std::string& line) {
  return table_of({line}).differing() != 0;
}

AnswerRow row_of(const SweepTable& table, std::string_view method) {
  for (const AnswerRow& row : table.rows())
    if (row.method == method) return row;
  throw std::runtime_error(std::string(method) + ": no row");
}

// Every entry of the table gives the same picture of everything to which it applies.
TEST(Algorithms, AgreeOnEveryFamily) {
  for (const std::string_view family : {"boxes", "town", "triangles", "bricks"}) {
    const scene::PolyScene scene = generate_scene(family, 5);
    SweepOptions options;
    options.all_lines = true;
    options.oracle = true;
    const Sweep sweep = sweep_of(scene, options);
    SweepTable table;
    for (std::uint64_t view = 0; view < 6; ++view) {
      const std::string line = sweep.line(view);
      EXPECT_TRUE(table.add(line));
      EXPECT_FALSE(differs(line)) << family << ": " << line;
    }
    // All but the oracle, which is the reference, and Plantinga's method, which draws few of these views.
    for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) {
      if (algorithm.name == "oracle" || algorithm.name == "plantinga") continue;
      EXPECT_EQ(row_of(table, algorithm.name).right, 6U) << algorithm.name;
    }
  }
}

// Plantinga's method and the solid turning on the PDP-7 draw every parallel view along level directions.
TEST(Sweep, MethodsOfTurnsDrawLevelViews) {
  const scene::PolyScene scene = generate_scene("boxes", 3);
  SweepOptions options;
  options.methods = {"exact", "plantinga", "turn-pdp7"};
  options.directions = Directions::level;
  const Sweep sweep = sweep_of(scene, options);
  SweepTable table;
  for (std::uint64_t view = 0; view < 4; ++view) EXPECT_TRUE(table.add(sweep.line(view)));
  EXPECT_TRUE(table.left_out().empty());
  EXPECT_EQ(table.differing(), 0U);
  for (const char* const method : {"exact", "plantinga", "turn-pdp7"}) EXPECT_EQ(row_of(table, method).views, 4U) << method;
  EXPECT_TRUE(row_of(table, "turn-pdp7").emulated_seconds.has_value());
  // Every usual view is omitted, with the reason.
  options.directions = Directions::usual;
  const SweepTable usual = table_of({sweep_of(scene, options).line(0)});
  ASSERT_EQ(usual.left_out().size(), 2U);
  EXPECT_EQ(usual.left_out()[0].method, "plantinga");
  EXPECT_NE(usual.left_out()[1].reason.find("parallel projection"), std::string::npos) << usual.left_out()[1].reason;
}

TEST(SweepViews, AreInFreeSpaceAndOftenInThePlaneOfAFace) {
  const scene::PolyScene scene = generate_scene("boxes", 8);
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

// In perspective along +z, x to the right and y up: the only viewing direction of the program of 1971.
bool looks_along_z(const scene::PolyCamera& camera) {
  const auto along = [](const scene::PolyPoint& axis, std::size_t which) {
    scene::PolyPoint other = axis;
    other[which] = 0;
    return axis[which] > 0 && other == scene::PolyPoint{};
  };
  return camera.perspective && along(camera.forward, 2) && along(camera.right, 0) && along(camera.up, 1);
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
    EXPECT_EQ(turned.eye, straight.eye) << "the same positions";
    EXPECT_EQ(turned, sweep_camera(scene, &cells, true, 3, k));
    along_z += looks_along_z(turned) ? 1 : 0;
    orthographic += turned.perspective ? 0 : 1;
    octants.insert({turned.forward[0] > 0, turned.forward[1] > 0, turned.forward[2] > 0});
  }
  EXPECT_TRUE(3 < along_z && along_z < 60) << along_z;
  EXPECT_TRUE(20 < orthographic && orthographic < 100) << orthographic;
  EXPECT_EQ(octants.size(), 8U);
}

TEST(Sweep, TurnedViewsAgree) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  SweepOptions options;
  options.directions = Directions::all;
  options.oracle = true;
  options.methods = {"exact", "jones", "montani-re"};
  const Sweep sweep = sweep_of(scene, options, &cells);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const std::string line = sweep.line(k);
    EXPECT_FALSE(differs(line)) << line;
    EXPECT_TRUE(sweep.is_line(k, line));
  }
  const std::string turned = sweep.line(0);
  options.directions = Directions::usual;
  EXPECT_FALSE(sweep_of(scene, options, &cells).is_line(0, turned));
}

TEST(Sweep, ReportsWhyAMethodDoesNotApply) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  const auto reason = [&](const char* method, const scene::CellScene* of_cells, Directions directions) {
    SweepOptions options;
    options.methods = {"exact", method};
    options.directions = directions;
    const auto sweep = Sweep::of("test", scene, of_cells, options);
    return sweep ? std::string() : sweep.error().message();
  };
  EXPECT_EQ(reason("jones-pdp7", &cells, Directions::usual), "");
  EXPECT_EQ(reason("jones-pdp7", nullptr, Directions::usual),
            "test: jones-pdp7 does not apply: Jones's program takes scenes of cells, looking along +z");
  EXPECT_EQ(reason("jones-twin", &cells, Directions::all),
            "test: jones-twin does not apply: Jones's program takes scenes of cells, looking along +z");
  EXPECT_EQ(reason("skala", &cells, Directions::usual), "test: skala does not apply: it draws functions of two variables, such as sinc");
  EXPECT_NE(reason("turn-pdp7", &cells, Directions::usual).find("--level"), std::string::npos);
  EXPECT_EQ(reason("turn-pdp7", nullptr, Directions::usual), "");
}

TEST(Sweep, ShardsEqualTheWhole) {
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

TEST(Sweep, RecognisesItsOwnLines) {
  const scene::PolyScene scene = generate_scene("boxes", 3);
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
  options.methods = {"exact", "jones"};
  EXPECT_FALSE(sweep_of(scene, options).is_line(4, line));
  scene::PolyScene other = scene;
  other.bodies.back().sheet = true;
  EXPECT_FALSE(sweep_of(other, {}).is_line(4, line));
}

// Nearest ranks by hand: of 1 to 10, the fifth and the ninth.
TEST(SweepTable, IsMadeOfLines) {
  const auto line = [](int view, int wrong, const std::string& more) {
    return R"({"schema":"sightline/sweep/2","scene":"a","view":)" + std::to_string(view) + R"(,"results":{"jones-pdp7":{)" +
           R"("method":"jones-pdp7","picture":"lines","rounding":"points","unit":"px","all":200.0,"wrong":)" +
           std::to_string(wrong) + ".0,\"far\":0.0,\"emulated_s\":" + std::to_string(11 - wrong) + ".0" + more + "}}}\n";
  };
  SweepTable table;
  const int wrong[] = {3, 10, 1, 2, 9, 4, 5, 8, 6, 7};
  for (int view = 0; view < 10; ++view) EXPECT_TRUE(table.add(line(view, wrong[view], "")));
  AnswerRow row = row_of(table, "jones-pdp7");
  EXPECT_EQ(row.views, 10U);
  EXPECT_EQ(row.right, 10U);
  EXPECT_EQ(row.wrong.median, 5);
  EXPECT_EQ(row.wrong.ninety, 9);
  EXPECT_EQ(row.wrong.greatest, 10);
  EXPECT_EQ(row.wrong_percent.ninety, 4.5);
  EXPECT_EQ(row.emulated_seconds->ninety, 9);
  EXPECT_EQ(row.worst_view, 1U);
  EXPECT_EQ(table.differing(), 0U);
  // A wrong view ranks worse than any correct one.
  EXPECT_TRUE(table.add(line(10, 1, ",\"defect\":\"word 3\"")));
  row = row_of(table, "jones-pdp7");
  EXPECT_EQ(row.right, 10U);
  EXPECT_EQ(row.worst_view, 10U);
  EXPECT_EQ(row.defect, "word 3");
  EXPECT_EQ(table.differing(), 1U);
  EXPECT_FALSE(table.add("my notes\n"));
  EXPECT_FALSE(table.add("{\"scene\":\"a\"}\n"));
  EXPECT_EQ(row_of(table, "jones-pdp7").views, 11U);
}

TEST(SweepTable, CountsWhatDiffers) {
  const auto line = [](const std::string& result) {
    return R"({"scene":"a","view":0,"results":)" + result + "}\n";
  };
  const std::string measures = R"("method":"jones","picture":"lines","rounding":"none","unit":"px","all":1.0,"wrong":0.0,"far":0.0)";
  EXPECT_FALSE(differs(line(R"({"jones":{)" + measures + R"(,"exact":true}})")));
  EXPECT_TRUE(differs(line(R"({"jones":{)" + measures + R"(,"exact":false}})")));
  EXPECT_TRUE(differs(line(R"({"jones":{)" + measures + R"(,"defect":"word 3"}})")));
  EXPECT_TRUE(differs(line(R"({"error":"no"})")));
  EXPECT_FALSE(differs(line(R"({"jones":{"not_applicable":"no"}})")));
  EXPECT_TRUE(differs(line(R"({"jones-pdp7":{"not_applicable":"no lines","defect":"word 3"}})")));
}

// A view's measures equal those of `compare` with the same camera, whose reference is the slow oracle.
TEST(Sweep, MeasuresAsCompareDoes) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene polyhedra = scene::poly_scene_of(cells);
  const scene::PolyScene boxes = generate_scene("boxes", 4);
  for (const bool of_cells : {true, false}) {
    SweepOptions options;
    options.methods = of_cells ? std::vector<std::string>{"jones-pdp7", "jones-twin", "exact", "montani-re"}
                               : std::vector<std::string>{"exact", "jones", "montani-re", "willis"};
    const Sweep sweep = of_cells ? sweep_of(polyhedra, options, &cells) : sweep_of(boxes, options);
    const std::uint64_t number = 2;
    const SweepTable table = table_of({sweep.line(number)});
    EXPECT_EQ(table.differing(), 0U);
    CompareOptions compared;
    compared.methods = options.methods;
    compared.faces = !of_cells;  // as naming willis implies
    const auto methods = of_cells ? SceneMethods::of(cells, compared) : SceneMethods::of(boxes, compared);
    const auto comparison =
        methods->view(random_camera(of_cells ? polyhedra : boxes, of_cells ? &cells : nullptr, Directions::usual, 1, number));
    Answer answer;
    answer.add("test", number, method_views(*comparison));
    const auto expected = answer.rows();
    const auto rows = table.rows();
    ASSERT_EQ(rows.size(), expected.size());
    ASSERT_GE(rows.size(), 4U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].method, expected[i].method);
      EXPECT_EQ(rows[i].picture, expected[i].picture);
      EXPECT_EQ(rows[i].right, expected[i].right);
      EXPECT_EQ(rows[i].wrong.greatest, expected[i].wrong.greatest) << rows[i].method;
      EXPECT_EQ(rows[i].far.greatest, expected[i].far.greatest) << rows[i].method;
      EXPECT_EQ(rows[i].emulated_seconds.has_value(), rows[i].method == "jones-pdp7");
      if (rows[i].emulated_seconds) {
        EXPECT_EQ(rows[i].emulated_seconds->greatest, expected[i].emulated_seconds->greatest);
      }
    }
  }
}

TEST(Sweep, DiagnosesWhatAnExactMethodMisses) {
  const scene::PolyScene scene = generate_scene("boxes", 3);
  const auto exact = registry::line_algorithms().front().prepare(scene);
  const picture::LinePicture right = exact->view(random_camera(scene, nullptr, Directions::usual, 1, 0))->picture;
  ASSERT_GT(right.pieces.size(), 2U);
  picture::LinePicture other = right;
  other.pieces.erase(other.pieces.begin() + 1);
  const PieceDifference difference = piece_difference(right, other);
  EXPECT_EQ(difference.missing, 1U);
  EXPECT_EQ(difference.extra, 0U);
  EXPECT_EQ(difference.first, right.pieces[1]);
  EXPECT_TRUE(difference.first_is_missing);
  EXPECT_FALSE(piece_difference(right, right).first.has_value());
}

TEST(Sweep, TheGuestEqualsItsTwin) {
  const scene::CellScene cells = scene::builtin_scene("house");
  const scene::PolyScene scene = scene::poly_scene_of(cells);
  SweepOptions options;
  options.methods = {"jones-pdp7", "jones-twin", "exact"};
  const Sweep sweep = sweep_of(scene, options, &cells);
  options.eae = false;
  const Sweep without = sweep_of(scene, options, &cells);
  for (std::uint64_t view = 0; view < 2; ++view) {
    const SweepTable table = table_of({sweep.line(view)});
    EXPECT_EQ(table.differing(), 0U);
    EXPECT_LT(row_of(table, "jones-pdp7").emulated_seconds->greatest,
              row_of(table_of({without.line(view)}), "jones-pdp7").emulated_seconds->greatest)
        << "the EAE makes it faster";
    EXPECT_FALSE(without.is_line(view, sweep.line(view)));
  }
}

}  // namespace
}  // namespace sightline::compare
