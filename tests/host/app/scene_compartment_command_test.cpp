// `sightline scene compartment`: counts, the file of cells, methods, and what is refused.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class SceneCompartmentCommand : public sightline::test::CommandLine {};

TEST_F(SceneCompartmentCommand, CountsAndFileAgree) {
  const Ran ran = sightline({"scene", "compartment", "roberts", "--json", "-o", "cells.json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json counts = json::parse(ran.out);
  EXPECT_EQ(counts.at("method"), "grid");
  EXPECT_EQ(counts.at("cells"), 12);
  const json file = json::parse(read("cells.json"));
  EXPECT_EQ(file.at("schema"), "sightline/cell-complex/2");
  for (const char* part : {"cells", "openings", "edges", "planes"})
    EXPECT_EQ(file.at(part).size(), counts.at(part)) << part;
  std::size_t lines = 0;
  for (const json& cell : file.at("cells")) {
    EXPECT_EQ(cell.at("bounds").size(), 6U);
    lines += cell.at("lines").size();
  }
  EXPECT_EQ(counts.at("lines"), lines);
  EXPECT_EQ(sightline({"scene", "compartment", "roberts", "-o", "-"}).out, read("cells.json"));
}

TEST_F(SceneCompartmentCommand, CellsAreDrawnWithoutTheScene) {
  ASSERT_EQ(sightline({"scene", "compartment", "boxes-5", "-o", "b.cells.json"}).exit_code, 0);
  for (const char* algorithm : {"jones", "exact"}) {
    const Ran from_cells = sightline({"draw", algorithm, "b.cells.json", "-o", "cells.plt"});
    ASSERT_EQ(from_cells.exit_code, 0) << from_cells.err;
    ASSERT_EQ(sightline({"draw", algorithm, "boxes-5", "-o", "scene.plt"}).exit_code, 0);
    EXPECT_EQ(read("cells.plt"), read("scene.plt")) << algorithm;
  }
  json cells = json::parse(read("b.cells.json"));
  cells["openings"][0]["plane"] = 1'000'000;
  // The schema first, by which the file is known.
  std::string text = cells.dump();
  write("bad.cells.json", "{\"schema\":\"sightline/cell-complex/2\"," + text.substr(1));
  const Ran bad = sightline({"draw", "jones", "bad.cells.json", "-o", "x.svg"});
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_TRUE(has(bad.err, "bad.cells.json: openings[0].plane: expected an integer 0..")) << bad.err;
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(SceneCompartmentCommand, Methods) {
  write("wedge.off",
        "OFF\n6 5 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n4 0 4\n0 4 4\n3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 "
        "3 5\n");
  const Ran by_grid = sightline({"scene", "compartment", "wedge.off", "--method", "grid", "-o", "w.json"});
  EXPECT_EQ(by_grid.exit_code, 4);
  EXPECT_TRUE(has(by_grid.err, "wedge.off: body 0, face 0: has a side")) << by_grid.err;
  EXPECT_FALSE(exists("w.json"));
  EXPECT_EQ(json::parse(sightline({"scene", "compartment", "wedge.off", "--json"}).out).at("method"), "bsp");
  EXPECT_TRUE(has(sightline({"scene", "compartment", "house", "--method", "bsp"}).out, "method    bsp"));
  EXPECT_EQ(sightline({"scene", "compartment", "house", "--method", "best"}).exit_code, 2);
  EXPECT_EQ(sightline({"scene", "compartment", "missing.off"}).exit_code, 5);
  EXPECT_EQ(sightline({"scene", "compartment", "house", "-o", "no/x.json"}).exit_code, 5);
}

}  // namespace
