// Cells as a file: a written file is read again, and every kind of error is named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::scene {
namespace {

using nlohmann::json;

std::string write_file_text(const PolyScene& scene, const Decomposition& decomposition) {
  std::string text;
  write_cell_complex(scene, decomposition, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string file_of(const PolyScene& scene, DecompositionMethod method = DecompositionMethod::automatic) {
  return write_file_text(scene, *decomposition_of(scene, method));
}

std::string error_of(const std::string& text) {
  const auto read = read_cell_complex(text, "c.json");
  return !read ? read.error().message() : "";
}

TEST(CellComplexFile, AWrittenFileIsReadAgain) {
  std::vector<PolyScene> scenes{poly_scene_of(builtin_scene("roberts")),
                                poly_scene_of(builtin_scene("house")), generate_boxes(6),
                                generate_triangles(4)};
  for (const PolyScene& scene : scenes) {
    SCOPED_TRACE(scene.name);
    const std::string text = file_of(scene);
    EXPECT_TRUE(is_cell_complex(text));
    const auto read = read_cell_complex(text, "c.json");
    ASSERT_TRUE(read) << error_of(text);
    EXPECT_EQ(read->scene, scene);
    EXPECT_EQ(write_file_text(read->scene, read->decomposition), text);
  }
  EXPECT_NE(file_of(scenes[0], DecompositionMethod::bsp), file_of(scenes[0], DecompositionMethod::grid));
}

TEST(CellComplexFile, OtherTextIsNotACellComplex) {
  EXPECT_FALSE(is_cell_complex(""));
  EXPECT_FALSE(is_cell_complex("{\"bodies\": []}"));
  EXPECT_FALSE(is_cell_complex("\"sightline/cell-complex/2\""));
  EXPECT_TRUE(is_cell_complex(" {\n \"schema\": \"sightline/cell-complex/1\"}"));
}

// One change to a valid file each, and the resulting error.
TEST(CellComplexFile, NamesTheErrors) {
  const PolyScene scene = poly_scene_of(builtin_scene("roberts"));
  const json good = json::parse(file_of(scene));
  ASSERT_EQ(error_of(good.dump()), "");
  struct Damage {
    const char* place;  // JSON pointer
    json value;         // null as a whole: the field is removed
    const char* said;
  };
  const std::vector<Damage> damages{
      {"/schema", "sightline/cell-complex/1", "schema: expected \"sightline/cell-complex/2\""},
      {"/method", "guess", "method: expected \"grid\" or \"bsp\""},
      {"/outer/0", json::array({1, 2}), "outer[0]: expected an array of 3"},
      {"/outer/0/1", 1 << 20, "outer[0][1]: expected an integer"},
      {"/outer/1", good["outer"][0], "outer: expected a box with an inside"},
      {"/edges/0/1", 100'000, "edges[0][1]: expected an integer 0.."},
      {"/edges/0", json::array({0, 5}), "edges: are not those of the scene"},
      {"/planes/2/0", std::int64_t{1} << 40, "planes[2][0]: expected an integer"},
      {"/planes/2/0", 0.5, "planes[2][0]: expected an integer"},
      {"/planes/0", json::array({0, 0, 0, 0}), "plane 0: has no normal"},
      {"/cells/1/bounds/0", -10'000, "cells[1].bounds[0]: expected an integer"},
      {"/cells/1/bounds", json::array(), "cell 1"},
      {"/cells/3/openings/0", 9999, "cells[3].openings[0]: expected an integer"},
      {"/cells/3/lines/0/2", 0, "cells[3].lines[0][2]: expected an integer 1.."},
      {"/cells/3/lines/0", json::array({0, 1, 1, 0, 1}), "is no part of the edge"},
      {"/cells/3/lines", "none", "cells[3].lines: expected an array, found a string"},
      {"/openings/0/cells/0", 777, "openings[0].cells[0]: expected an integer"},
      {"/openings/0/cells", json::array({2, 2}), "opening 0: has the same cell on both sides"},
      {"/openings/0/plane", -1, "openings[0].plane: expected an integer"},
      {"/openings/0/sides", json::array({0}), "opening 0"},
      {"/openings/0", json::array(), "openings[0]: expected an object"},
      {"/polyhedra/vertices/0/0", "a", "polyhedra: vertices[0][0]: expected an integer"},
      {"/polyhedra/bodies", json::array(), "polyhedra: bodies: expected at least one body"},
  };
  for (const Damage& damage : damages) {
    json bad = good;
    bad[json::json_pointer(damage.place)] = damage.value;
    const std::string said = error_of(bad.dump());
    EXPECT_NE(said.find(damage.said), std::string::npos) << damage.place << ": " << said;
    EXPECT_TRUE(said.starts_with("c.json: ")) << said;
  }
  for (const auto& [name, value] : good.items()) {
    json bad = good;
    bad.erase(name);
    EXPECT_NE(error_of(bad.dump()).find("expected a field \"" + name + "\", found none"), std::string::npos)
        << error_of(bad.dump());
  }
}

// Deeper than the stack of a recursive reader.
TEST(CellComplexFile, NestingOfAnyDepthIsAnError) {
  std::string text = file_of(generate_boxes(2));
  const std::size_t at = text.find("\"polyhedra\"");
  ASSERT_NE(at, std::string::npos);
  constexpr std::size_t depth = 1'000'000;
  text.erase(at);
  text += "\"polyhedra\": " + std::string(depth, '[') + std::string(depth, ']') + "}";
  EXPECT_EQ(error_of(text), "c.json: polyhedra: expected an object, found an array of 1");
}

TEST(CellComplexFile, ARemovedCellIsAnError) {
  const PolyScene scene = poly_scene_of(builtin_scene("roberts"));
  json file = json::parse(file_of(scene));
  // Without the last cell and all its openings the rest is valid, but does not fill the outer box.
  const std::size_t last = file["cells"].size() - 1;
  std::vector<std::size_t> number(file["openings"].size());
  json openings = json::array();
  for (std::size_t i = 0; i < number.size(); ++i) {
    const json& cells = file["openings"][i]["cells"];
    const bool gone = cells[0] == last || cells[1] == last;
    number[i] = gone ? number.size() : openings.size();
    if (!gone) openings.push_back(file["openings"][i]);
  }
  file["cells"].erase(last);
  for (json& cell : file["cells"]) {
    json left = json::array();
    for (const json& opening : cell["openings"])
      if (number[opening.get<std::size_t>()] < number.size())
        left.push_back(number[opening.get<std::size_t>()]);
    cell["openings"] = left;
  }
  file["openings"] = openings;
  EXPECT_NE(error_of(file.dump()), "");
}

TEST(CellComplexFile, SyntaxErrorsAndEmptyFiles) {
  EXPECT_NE(error_of("").find("c.json: line 1, column 1"), std::string::npos) << error_of("");
  EXPECT_NE(error_of("[]").find("expected an object"), std::string::npos);
  const std::string text = file_of(generate_boxes(2));
  for (const std::size_t length : {std::size_t{1}, text.size() / 3, text.size() - 3})
    EXPECT_NE(error_of(text.substr(0, length)).find("line "), std::string::npos) << length;
}

}  // namespace
}  // namespace sightline::scene
