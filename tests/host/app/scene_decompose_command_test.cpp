// `sightline scene decompose`: counts, the file of cells, methods, and errors.
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class SceneDecomposeCommand : public sightline::test::CommandLine {};

TEST_F(SceneDecomposeCommand, CountsAndFileAgree) {
  const Ran ran = sightline({"scene", "decompose", "roberts", "--json", "-o", "cells.json"});
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
  EXPECT_EQ(sightline({"scene", "decompose", "roberts", "-o", "-"}).out, read("cells.json"));
}

TEST_F(SceneDecomposeCommand, DrawsTheCells) {
  const Ran own = sightline({"scene", "decompose", "house", "-o", "house.svg", "--json"});
  ASSERT_EQ(own.exit_code, 0) << own.err;
  EXPECT_EQ(json::parse(own.out).at("method"), "own");
  EXPECT_EQ(json::parse(own.out).at("cells"), 3);
  for (const char* layer : {"portals", "lines of the scene", "numbers"}) EXPECT_TRUE(has(read("house.svg"), layer)) << layer;
  const Ran decomposed = sightline({"scene", "decompose", "house", "--method", "grid", "-o", "house.pdf", "--json"});
  ASSERT_EQ(decomposed.exit_code, 0) << decomposed.err;
  EXPECT_EQ(json::parse(decomposed.out).at("method"), "grid");
  EXPECT_TRUE(read("house.pdf").starts_with("%PDF"));
  ASSERT_EQ(sightline({"scene", "decompose", "boxes-2", "-o", "boxes.png"}).exit_code, 0);
  EXPECT_TRUE(read("boxes.png").starts_with("\x89PNG"));
  const Ran many = sightline({"scene", "decompose", "boxes-1000", "-o", "many.svg"});
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_TRUE(has(many.err, "expected at most 1000 for diagrams")) << many.err;
  EXPECT_FALSE(exists("many.svg"));
}

TEST_F(SceneDecomposeCommand, CellsAreDrawnWithoutTheScene) {
  ASSERT_EQ(sightline({"scene", "decompose", "boxes-2", "-o", "b.cells.json"}).exit_code, 0);
  for (const char* algorithm : {"jones", "exact"}) {
    const Ran from_cells = sightline({"draw", algorithm, "b.cells.json", "-o", "cells.plt"});
    ASSERT_EQ(from_cells.exit_code, 0) << from_cells.err;
    ASSERT_EQ(sightline({"draw", algorithm, "boxes-2", "-o", "scene.plt"}).exit_code, 0);
    EXPECT_EQ(read("cells.plt"), read("scene.plt")) << algorithm;
  }
  json cells = json::parse(read("b.cells.json"));
  cells["openings"][0]["plane"] = 1'000'000;
  // The schema comes first: the format is recognised by it.
  std::string text = cells.dump();
  write("bad.cells.json", "{\"schema\":\"sightline/cell-complex/2\"," + text.substr(1));
  const Ran bad = sightline({"draw", "jones", "bad.cells.json", "-o", "x.svg"});
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_TRUE(has(bad.err, "bad.cells.json: openings[0].plane: expected an integer 0..")) << bad.err;
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(SceneDecomposeCommand, InfoKnowsTheFile) {
  const json counts =
      json::parse(sightline({"scene", "decompose", "boxes-5", "--json", "-o", "b.cells.json"}).out);
  const Ran ran = sightline({"scene", "info", "--json", "b.cells.json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json info = json::parse(ran.out);
  EXPECT_EQ(info.at("schema"), "sightline/scene-info/1");
  for (const char* same : {"method", "cells", "openings", "openings_outside", "planes"})
    EXPECT_EQ(info.at(same), counts.at(same)) << same;
  EXPECT_EQ(info.at("cell_lines"), counts.at("lines"));
  EXPECT_EQ(info.at("outer"), json::parse(read("b.cells.json")).at("outer"));
  // Everything reported about the scene itself.
  const json scene = json::parse(sightline({"scene", "info", "--json", "boxes-5"}).out);
  for (const char* same :
       {"name", "vertices", "edges", "faces", "holes", "bodies", "sheets", "bounds", "step"})
    EXPECT_EQ(info.at(same), scene.at(same)) << same;
  const std::string text = sightline({"scene", "info", "b.cells.json"}).out;
  for (const std::string& part : {"faces          " + info.at("faces").dump() + ", with 0 holes",
                                  "cells          " + info.at("cells").dump() + ", with " +
                                      info.at("cell_lines").dump() + " lines; by grid",
                                  "openings       " + info.at("openings").dump() + ", " +
                                      info.at("openings_outside").dump() + " of them",
                                  std::string("outer box      x ")})
    EXPECT_TRUE(has(text, part)) << part << '\n' << text;
  // It is also a scene for all other commands.
  EXPECT_EQ(sightline({"scene", "convert", "b.cells.json"}).out,
            sightline({"scene", "convert", "boxes-5"}).out);
}

TEST_F(SceneDecomposeCommand, CheckNamesEveryError) {
  ASSERT_EQ(sightline({"scene", "decompose", "boxes-5", "-o", "b.cells.json"}).exit_code, 0);
  const Ran good = sightline({"scene", "check", "b.cells.json"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_EQ(good.out, "b.cells.json: a possible scene\n");
  const auto written = json::parse(read("b.cells.json"));
  const auto check = [this](json changed) {
    // The schema comes first: the format is recognised by it.
    changed.erase("schema");
    write("bad.cells.json", "{\"schema\":\"sightline/cell-complex/2\"," + changed.dump().substr(1));
    const Ran ran = sightline({"scene", "check", "--json", "bad.cells.json"});
    EXPECT_EQ(ran.exit_code, 4);
    const Ran lines = sightline({"scene", "check", "bad.cells.json"});
    EXPECT_EQ(lines.exit_code, 4);
    EXPECT_EQ(lines.out, "");
    const json report = json::parse(ran.out);
    EXPECT_FALSE(report.at("possible"));
    for (const json& error : report.at("errors"))
      EXPECT_TRUE(has(lines.err, "bad.cells.json: " + error.at("place").get<std::string>() + ": " +
                                     error.at("cause").get<std::string>()))
          << error << lines.err;
    return report.at("errors");
  };
  json form = written;
  form["openings"][0]["plane"] = 1'000'000;
  EXPECT_EQ(check(form).size(), 1U);
  EXPECT_EQ(check(form)[0].at("place"), "openings[0].plane");
  EXPECT_EQ(sightline({"scene", "info", "bad.cells.json"}).exit_code, 4);
  json turned = written;
  for (const std::size_t opening : {0U, 1U})
    std::swap(turned["openings"][opening]["cells"][0], turned["openings"][opening]["cells"][1]);
  EXPECT_EQ(check(turned).size(), 4U);  // one for each cell
  EXPECT_EQ(check(turned)[3].at("place"), "opening 1");
  json scene = written;
  for (const std::size_t vertex : {0U, 9U}) {
    json& x = scene["polyhedra"]["vertices"][vertex][0];
    x = x.get<int>() + 1;
  }
  EXPECT_EQ(check(scene).size(), 2U);  // faces that are no longer planar
  EXPECT_EQ(check(scene)[1].at("place"), "polyhedra: body 1 \"box 1\", face 0");
  json eye = written;
  eye["polyhedra"]["camera"]["eye"] = written["polyhedra"]["vertices"][0];
  EXPECT_EQ(check(eye).size(), 1U);
  EXPECT_TRUE(has(check(eye)[0].at("cause").get<std::string>(), "eye")) << check(eye);
}

TEST_F(SceneDecomposeCommand, Methods) {
  write("wedge.off",
        "OFF\n6 5 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n4 0 4\n0 4 4\n3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 "
        "3 5\n");
  const Ran by_grid = sightline({"scene", "decompose", "wedge.off", "--method", "grid", "-o", "w.json"});
  EXPECT_EQ(by_grid.exit_code, 4);
  EXPECT_TRUE(has(by_grid.err, "wedge.off: body 0, face 0: has a side")) << by_grid.err;
  EXPECT_FALSE(exists("w.json"));
  EXPECT_EQ(json::parse(sightline({"scene", "decompose", "wedge.off", "--json"}).out).at("method"), "bsp");
  EXPECT_TRUE(has(sightline({"scene", "decompose", "house", "--method", "bsp"}).out, "method    bsp"));
  EXPECT_EQ(sightline({"scene", "decompose", "house", "--method", "best"}).exit_code, 2);
  EXPECT_EQ(sightline({"scene", "decompose", "missing.off"}).exit_code, 5);
  EXPECT_EQ(sightline({"scene", "decompose", "house", "-o", "no/x.json"}).exit_code, 5);
}

}  // namespace
