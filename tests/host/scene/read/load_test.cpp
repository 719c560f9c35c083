// A scene as a user names it: the meaning of a name, the kind of a text, and the errors.
#include "host/scene/read/load.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/poly_file.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::scene {
namespace {

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

SceneFile named(const std::string& name) {
  return std::move(**named_scene(name));
}

std::string error_of(SceneFile file) {
  const auto loaded = load_scene(std::move(file));
  return loaded ? "none" : loaded.error().message();
}

TEST(LoadScene, FindsBuiltInScenes) {
  const SceneFile file = named("house");
  EXPECT_TRUE(file.builtin);
  EXPECT_EQ(read_scene(file).loaded.kind, SceneKind::cells);
  EXPECT_FALSE(can_be_mended(file));
  const auto loaded = load_scene(file);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(*loaded->cells, builtin_scene("house"));
  EXPECT_EQ(loaded->scene, poly_scene_of(*loaded->cells));
}

TEST(LoadScene, AGridOfHeightsIsSentToItsCommand) {
  const std::string remedy = "a grid of heights is drawn by: sightline draw skala heights";
  for (const std::string text : {"1 2 3\n4 5 6\n", "ncols 2\nnrows 2\n", "DSAA\n2 2\n", "DSBB"})
    EXPECT_NE(error_of({.name = "heights", .text = text}).find(remedy), std::string::npos) << text;
}

TEST(LoadScene, MakesGeneratedScenes) {
  for (const auto& [name, expected] :
       {std::pair("boxes-20", generate_boxes(20)), std::pair("town-7-5", generate_town(7, 5)),
        std::pair("big_rooms-2", generate_big_rooms(2))}) {
    SceneFile file = named(name);
    EXPECT_EQ(read_scene(file).loaded.kind, SceneKind::polyhedra);
    EXPECT_FALSE(can_be_mended(file));
    EXPECT_TRUE(read_scene(file).errors.empty());
    EXPECT_EQ(load_scene(std::move(file))->scene, expected) << name;
  }
  for (const char* name : {"boxes", "boxes-", "boxes-x", "boxes-3-x", "crates-3", "no-such-scene"})
    EXPECT_FALSE(named_scene(name)) << name;
  const auto impossible = named_scene("boxes-0");
  ASSERT_TRUE(impossible);
  EXPECT_FALSE(*impossible);
}

TEST(LoadScene, AFileHasPrecedenceOverAGeneratedScene) {
  const auto before = std::filesystem::current_path();
  const auto folder = std::filesystem::temp_directory_path() / "sightline_load_test";
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  std::ofstream("boxes-3") << tetrahedron;
  EXPECT_FALSE(named_scene("boxes-3"));
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);
}

// Generated scenes, which are not checked when they are loaded, equal their files.
TEST(LoadScene, AGeneratedSceneIsTheSceneOfItsFile) {
  for (const std::string_view family : generator_names()) {
    SCOPED_TRACE(family);
    const auto scene = generate_scene(family, 3, 2);
    ASSERT_TRUE(scene);
    const auto read = load_scene({.name = "written.json", .text = *write_poly(*scene, PolyFormat::json)});
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->scene, *scene);
  }
}

TEST(LoadScene, RecognisesTheKindOfAText) {
  std::string complex;
  const PolyScene scene = generate_boxes(2);
  write_cell_complex(scene, *decomposition_of(scene), [&](std::string_view piece) { complex += piece; });
  const auto kind = [](const char* name, const std::string& text) {
    return read_scene({.name = name, .text = text}).loaded.kind;
  };
  EXPECT_EQ(kind("a.json", std::string(*builtin_scene_text("house"))), SceneKind::cells);
  EXPECT_EQ(kind("a.json", R"({"bodies": []})"), SceneKind::polyhedra);
  EXPECT_EQ(kind("a.json", complex), SceneKind::cell_complex);
  EXPECT_EQ(kind("a.off", "anything"), SceneKind::polyhedra);
  EXPECT_EQ(kind("standard input", tetrahedron), SceneKind::polyhedra);
  EXPECT_EQ(kind("standard input", "{ no JSON"), SceneKind::cells);
  const auto loaded = load_scene({.name = "c.json", .text = complex});
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->scene, scene);
  EXPECT_TRUE(loaded->decomposition);
}

TEST(LoadScene, AByteOrderMarkIsSkipped) {
  const std::string mark = "\xef\xbb\xbf";
  std::string complex;
  const PolyScene boxes = generate_boxes(2);
  write_cell_complex(boxes, *decomposition_of(boxes), [&](std::string_view piece) { complex += piece; });
  const auto tetra = load_scene({.name = "a.off", .text = tetrahedron});
  ASSERT_TRUE(tetra);
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const SceneFile files[] = {
      {.name = "a.off", .text = tetrahedron},
      {.name = "-", .text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {.name = "a", .text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
      {.name = "a.obj", .text = ply},
      {.name = "a.json", .text = *write_poly(tetra->scene, PolyFormat::json)},
      {.name = "b.json", .text = complex},
      {.name = "c.json", .text = std::string(*builtin_scene_text("house"))},
  };
  for (const SceneFile& file : files) {
    const auto expected = load_scene(file);
    ASSERT_TRUE(expected) << expected.error().message();
    SceneFile marked = file;
    marked.text = mark + file.text;
    EXPECT_EQ(can_be_mended(marked), can_be_mended(file)) << file.name;
    const auto loaded = load_scene(marked);
    ASSERT_TRUE(loaded) << loaded.error().message();
    EXPECT_EQ(loaded->kind, expected->kind) << file.name;
    EXPECT_EQ(loaded->scene, expected->scene) << file.name;
  }
  EXPECT_EQ(error_of({.name = "a.obj", .text = std::string("\xff\xfev\0 \0", 6)}),
            "a.obj: found a text in UTF-16, expected UTF-8 or ASCII; save it as UTF-8");
  EXPECT_EQ(error_of({.name = "a.json", .text = std::string("\xfe\xff\0{", 4)}),
            "a.json: found a text in UTF-16, expected UTF-8 or ASCII; save it as UTF-8");
}

TEST(LoadScene, AnErrorGivesTheNumberOfErrors) {
  EXPECT_EQ(error_of({.name = "s.json", .text = "{\n \"name\": 3,,}"}).substr(0, 27),
            "s.json: line 2, column 12: ");
  const std::string bent = "OFF\n4 1 0\n0 0 0\n4 0 0\n4 4 1\n0 4 0\n4 0 1 2 3\n";
  EXPECT_EQ(error_of({.name = "bent.off", .text = bent}).find("bent.off: body 0, face 0"), 0U);
  const std::string twice = "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n3 3 4 5\n";
  const SceneReading reading = read_scene({.name = "twice.off", .text = twice});
  ASSERT_GT(reading.errors.size(), 1U);
  EXPECT_EQ(reading.errors.back().file, "twice.off");
  EXPECT_TRUE(error_of({.name = "twice.off", .text = twice})
                  .ends_with(" (the first of " + std::to_string(reading.errors.size()) + " errors)"));
}

TEST(LoadScene, MendsOnRequest) {
  const std::string inside_out =
      "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n";
  const SceneFile file{.name = "scan.off", .text = inside_out};
  ASSERT_TRUE(can_be_mended(file));
  EXPECT_FALSE(load_scene(file));
  const auto mended = load_scene(file, {.mend = true});
  ASSERT_TRUE(mended) << mended.error().message();
  EXPECT_EQ(mended->report.faces.turned_faces, 4U);
}

}  // namespace
}  // namespace sightline::scene
