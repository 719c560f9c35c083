// The JSON reader: the built-in scenes, and every kind of error with file, position and cause.
#include "host/scene/read/cell_scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::scene {
namespace {

using nlohmann::json;

TEST(Builtin, NamesTheFiveScenesAndNoOther) {
  const std::vector<std::string_view> expected{"house", "roberts", "street4", "corridor8", "corridor32"};
  EXPECT_EQ(builtin_scene_names(), expected);
  EXPECT_FALSE(builtin_scene_text("castle"));
}

TEST(Builtin, EmbeddedTextIsTheFile) {
  for (const std::string_view name : builtin_scene_names()) {
    std::ifstream file(std::string(SIGHTLINE_SOURCE_DIR "/host/scene/read/builtin/") + std::string(name) + ".json",
                       std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(builtin_scene_text(name), text);
  }
}

// Numbers from section "Scenes" of the specification: the house of Fig. 2.
TEST(ReadCellScene, ReadsTheHouse) {
  const CellScene house = builtin_scene("house");
  EXPECT_EQ(house.name, "house");
  EXPECT_EQ(house.outer, (geometry::Box{{0, 0, 0}, {600, 250, 750}}));
  EXPECT_TRUE(house.solids.empty());
  EXPECT_EQ(house.walls.size(), 16U);
  EXPECT_EQ(house.default_view, (geometry::Point{480, 160, 20}));
  ASSERT_EQ(house.cells.size(), 3U);
  EXPECT_EQ(house.cells[2].box, (geometry::Box{{250, 0, 400}, {600, 250, 750}}));
  ASSERT_EQ(house.openings.size(), 3U);
  const Opening& hatch = house.openings[2];
  EXPECT_EQ(hatch.cells, (std::array<std::size_t, 2>{1, 2}));
  EXPECT_EQ(hatch.place, (geometry::Rectangle{0, 250, {geometry::Span{90, 150}, geometry::Span{560, 680}}}));
  ASSERT_EQ(house.openings[0].vectors.size(), 4U);
  EXPECT_EQ(house.openings[0].vectors[0], (RingVector{false, 0, 90}));
  EXPECT_EQ(house.openings[0].vectors[3], (RingVector{true, 1, -205}));
}

struct Damage {
  const char* name;
  const char* pointer;  // JSON pointer to the replaced value
  const char* value;    // by this JSON; empty: erased
  const char* place;
  const char* cause;
};

class DamagedScene : public testing::TestWithParam<Damage> {};

TEST_P(DamagedScene, IsReportedByFilePositionAndCause) {
  json document = json::parse(builtin_scene_text("house").value());
  const json::json_pointer pointer(GetParam().pointer);
  if (*GetParam().value) {
    document[pointer] = json::parse(GetParam().value);
  } else {
    document[pointer.parent_pointer()].erase(pointer.back());
  }
  const auto result = read_cell_scene(document.dump(), "damaged.json");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error(), (base::Error{"damaged.json", GetParam().place, GetParam().cause}));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DamagedScene,
    testing::Values(Damage{"missing", "/outer", "", "", "expected a field \"outer\", found none"},
                    Damage{"missing_in_opening", "/openings/1/ring", "", "openings[1]",
                           "expected a field \"ring\", found none"},
                    Damage{"wrong_type", "/cells", "{}", "cells", "expected an array, found an object"},
                    Damage{"short_point", "/default_view", "[1,2]", "default_view",
                           "expected an array of 3, found an array of 2"},
                    Damage{"fraction", "/outer/1/2", "750.0", "outer[1][2]",
                           "expected an integer -32767..32767, found 750.0"},
                    Damage{"string_for_number", "/walls/3/1", "\"400\"", "walls[3][1]",
                           "expected an integer -32767..32767, found a string"},
                    Damage{"too_large", "/cells/0/1/0", "32768", "cells[0][1][0]",
                           "expected an integer -32767..32767, found 32768"},
                    Damage{"too_small", "/cells/0/0/0", "-32768", "cells[0][0][0]",
                           "expected an integer -32767..32767, found -32768"},
                    Damage{"beyond_64_bits", "/cells/0/1/0", "18446744073709551615", "cells[0][1][0]",
                           "expected an integer -32767..32767, found 18446744073709551615"},
                    Damage{"null", "/openings/0/c", "null", "openings[0].c",
                           "expected an integer -32767..32767, found null"},
                    Damage{"boolean", "/openings/0/axis", "true", "openings[0].axis",
                           "expected an integer 0..2, found true"},
                    Damage{"unknown_axis", "/openings/0/axis", "3", "openings[0].axis",
                           "expected an integer 0..2, found 3"},
                    Damage{"unknown_direction", "/openings/2/vectors/1/1", "\"l\"",
                           "openings[2].vectors[1][1]", "expected \"i\", \"j\" or \"k\", found a string"},
                    Damage{"flag", "/openings/2/vectors/1/0", "2", "openings[2].vectors[1][0]",
                           "expected an integer 0..1, found 2"},
                    Damage{"negative_cell", "/openings/2/cells/1", "-1", "openings[2].cells[1]",
                           "expected an integer 0..2147483647, found -1"},
                    Damage{"name_with_newline", "/name", "\"a\\nb\"", "name",
                           "expected a string of 1 to 40 printable ASCII characters, found a string"},
                    Damage{"lines_missing_for_a_cell", "/cell_lines", "[[],[]]", "cell_lines",
                           "expected an array of 3, found an array of 2"},
                    Damage{"line_of_three_points", "/cell_lines/1/0", "[[0,0,0],[1,0,0],[2,0,0]]",
                           "cell_lines[1][0]", "expected an array of 2, found an array of 3"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ReadCellScene, NamesLineAndColumnOfASyntaxError) {
  const auto result = read_cell_scene("{\"name\": \"x\",\n  \"outer\": [}", "bad.json");
  const auto& error = result.error();
  EXPECT_EQ(error.file, "bad.json");
  EXPECT_EQ(error.place, "line 2, column 13");
  EXPECT_NE(error.found.find("unexpected '}'"), std::string::npos) << error.found;
}

TEST(ReadCellScene, RejectsTextThatIsNotAJsonObject) {
  for (const char* text : {"", " ", "[]", "7", "null", "\xff\xfe", "{\"name\":\"\xc3\"}"}) {
    EXPECT_FALSE(read_cell_scene(text, "x")) << text;
  }
  EXPECT_FALSE(read_cell_scene(std::string(100000, '['), "x"));
}

TEST(LoadCellScene, FindsBuiltinScenesAndNamesMissingFiles) {
  EXPECT_TRUE(load_cell_scene("corridor8"));
  EXPECT_FALSE(load_cell_scene("tori"));
  const auto missing = load_cell_scene("no/such/scene.json");
  EXPECT_EQ(missing.error().message(),
            "no/such/scene.json: no such file, and not a built-in scene (house, roberts, street4, corridor8, "
            "corridor32)");
  const auto folder = load_cell_scene(SIGHTLINE_SOURCE_DIR);
  EXPECT_NE(folder.error().found.find("directory"), std::string::npos);
}

TEST(LoadCellScene, ChecksTheFile) {
  json document = json::parse(builtin_scene_text("house").value());
  document["cells"][1][1][0] = 240;
  const auto file = std::filesystem::path(testing::TempDir()) / "sightline-load-test.json";
  std::ofstream(file) << document.dump();
  const auto result = load_cell_scene(file.string());
  std::filesystem::remove(file);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().file, file.string());
}

// Bytes changed, removed and doubled at random: always an error or a scene that can be checked.
TEST(ReadCellScene, SurvivesRandomDamage) {
  std::mt19937 random(1971);
  for (int round = 0; round < tests::effort(3000, 300); ++round) {
    std::string text(builtin_scene_text(round % 2 ? "house" : "roberts").value());
    for (unsigned edits = random() % 4 + 1; edits > 0; --edits) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0: text[at] = static_cast<char>(random() % 256); break;
        case 1: text.erase(at, random() % 8); break;
        default: text.insert(at, text.substr(at, random() % 8)); break;
      }
    }
    const auto result = read_cell_scene(text, "random");
    if (result) {
      EXPECT_LE(check_scene(*result).size(), most_scene_errors);
    } else {
      EXPECT_FALSE(result.error().found.empty());
    }
  }
}

}  // namespace
}  // namespace sightline::scene
