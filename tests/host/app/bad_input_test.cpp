// Every error in a scene or an output path, for every command that takes one: the exit code, a message that names the file, the
// position and what was found, and no partial files.
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

constexpr std::string_view cube =
    R"({"vertices": [[0,0,0],[9,0,0],[9,9,0],[0,9,0],[0,0,9],[9,0,9],[9,9,9],[0,9,9]],
        "bodies": [{"faces": [[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}])";

std::string sheet(std::string_view vertices, std::string_view face) {
  return R"({"vertices": [)" + std::string(vertices) + R"(], "bodies": [{"sheet": true, "faces": [)" +
         std::string(face) + "]}]}";
}

struct Damage {
  std::string name;
  std::string file;
  std::string text;
  std::string found;  // in the message, after the name of the file
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all{
      {"not_planar", "s.json", sheet("[0,0,0],[9,0,0],[9,9,1],[0,9,0]", "[0,1,2,3]"),
       "body 0, face 0: vertex 3 (0, 9, 0) is not in the plane of vertices 0, 1 and 2"},
      {"crosses_itself", "s.json", sheet("[0,0,0],[9,0,0],[0,9,0],[9,7,0]", "[0,1,2,3]"),
       "body 0, face 0: the outline crosses or touches itself (edges 1-2 and 3-0)"},
      {"hole_outside", "s.json",
       sheet("[0,0,0],[9,0,0],[0,9,0],[20,20,0],[20,22,0],[22,20,0]",
             R"({"outline": [0,1,2], "holes": [[3,4,5]]})"),
       "body 0, face 0: hole 0 is outside the outline"},
      {"vertex_twice", "s.json", sheet("[0,0,0],[9,0,0],[0,9,0],[0,0,0]", "[0,1,2],[3,1,2]"),
       "vertex 3: is the same point (0, 0, 0) as vertex 0"},
      {"vertex_for_nothing", "s.json", sheet("[0,0,0],[9,0,0],[0,9,0],[7,7,7]", "[0,1,2]"),
       "vertex 3: is not used by any face"},
      {"no_such_vertex", "s.json", sheet("[0,0,0],[9,0,0],[0,9,0]", "[0,1,3]"),
       "bodies[0].faces[0][2]: expected an integer 0..2, found 3"},
      {"beyond_the_limit", "s.json", sheet("[0,0,0],[262144,0,0],[0,9,0]", "[0,1,2]"),
       "vertices[1][0]: expected an integer -262143..262143, found 262144"},
      {"not_closed", "s.json",
       R"({"vertices": [[0,0,0],[9,0,0],[0,9,0]], "bodies": [{"sheet": false, "faces": [[0,1,2]]}]})",
       "body 0, face 0: edge 0-1 belongs to 1 face of the solid, expected 2"},
      {"empty_json", "s.json", "", "line 1, column 1: syntax error while parsing value - unexpected end"},
      {"empty_off", "s.off", "", "end of file: found no text, expected OFF"},
      {"empty_obj", "s.obj", "", "end of file: found no vertices, expected lines"},
      {"cut_off", "s.json", R"({"vertices": [[0,0,0)", "line 1, column 21: syntax error"},
      {"noise", "s.off", std::string("\x7f\0\xff\x03 OFF\n\n\x80", 11),
       "line 1: found \"????\", expected OFF in the first line"}};
  return all;
}

// Errors that are mended unless --strict is given; `scene check` still reports them.
const std::vector<Damage>& mendable() {
  static const std::vector<Damage> all{
      {"not_planar_off", "s.off", "OFF\n4 1 0\n0 0 0\n9 0 0\n9 9 1\n0 9 0\n4 0 1 2 3\n",
       "body 0, face 0: vertex 3 (0, 9, 0) is not in the plane of vertices 0, 1 and 2"},
      {"vertex_for_nothing_obj", "s.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 1 1 1\nf 1 2 3\n",
       "vertex 3: is not used by any face"}};
  return all;
}

// Each with an output path in an empty folder.
std::vector<Arguments> commands(const std::string& scene) {
  return {{"scene", "check", scene},
          {"scene", "check", "--json", scene},
          {"scene", "info", scene},
          {"scene", "convert", scene, "-o", "to/out.off"},
          {"scene", "decompose", scene, "-o", "to/cells.json"},
          {"draw", "exact", scene, "-o", "to/out.svg"},
          {"draw", "jones", scene, "-o", "to/out.png"},
          {"draw", "oracle", scene, "-o", "to/out.plt"},
          {"sweep", scene, "--views", "2", "-o", "to/out.jsonl"},
          {"compare", scene, "-o", "to/compare"},
          {"jones", scene, "-o", "to/jones"}};
}

std::string text_of(const Arguments& arguments) {
  std::string text;
  for (const std::string& word : arguments) text += word + " ";
  return text;
}

class BadInput : public sightline::test::CommandLine {
 protected:
  BadInput() { std::filesystem::create_directory(path("to")); }

  std::vector<std::string> made() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("to")))
      names.push_back(entry.path().filename().string());
    return names;
  }

  void expect_refused(const Arguments& arguments, int exit_code, const std::string& message) {
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << text_of(arguments) << ran.err;
    const bool in_json = arguments[1] == "check" && arguments[2] == "--json" && exit_code == 4;
    const std::string all = in_json ? ran.out : ran.err;
    EXPECT_TRUE(in_json || has(all, message)) << text_of(arguments) << "\n" << all;
    EXPECT_TRUE(made().empty()) << text_of(arguments) << testing::PrintToString(made());
  }
};

TEST_F(BadInput, DamagedScenes) {
  for (const Damage& damage : damages()) {
    SCOPED_TRACE(damage.name);
    write(damage.file, damage.text);
    for (const Arguments& arguments : commands(damage.file)) {
      // Jones's program takes only cells, and reports that first.
      const bool cells_only = arguments.front() == "jones";
      expect_refused(arguments, 4, damage.file + ": " + (cells_only ? "" : damage.found));
    }
    std::filesystem::remove(path(damage.file));
  }
}

TEST_F(BadInput, StrictMeshes) {
  for (const Damage& damage : mendable()) {
    SCOPED_TRACE(damage.name);
    write(damage.file, damage.text);
    for (Arguments arguments : commands(damage.file)) {
      if (arguments.front() == "jones") continue;
      const bool check = arguments[1] == "check";
      if (!check) arguments.emplace_back("--strict");
      expect_refused(arguments, 4, damage.file + ": " + damage.found);
      if (check) continue;
      arguments.pop_back();
      const Ran ran = sightline(arguments);
      EXPECT_EQ(ran.exit_code, 0) << text_of(arguments) << ran.err;
      EXPECT_TRUE(has(ran.err, "mended: ")) << text_of(arguments) << ran.err;
      std::filesystem::remove_all(path("to"));
      std::filesystem::create_directory(path("to"));
    }
    std::filesystem::remove(path(damage.file));
  }
}

TEST_F(BadInput, AnEyeInsideASolid) {
  const std::string text =
      std::string(cube) +
      R"(, "camera": {"eye": [4,4,4], "forward": [0,0,-1], "right": [1,0,0], "up": [0,1,0]}})";
  write("s.json", text);
  const std::string message = "s.json: body 0: the eye 4,4,4 is inside this solid, expected it in free space";
  expect_refused({"scene", "check", "s.json"}, 4, message);
  const Ran json = sightline({"scene", "check", "--json", "s.json"});
  EXPECT_EQ(json.exit_code, 4);
  EXPECT_TRUE(has(json.out, "the eye 4,4,4 is inside this solid")) << json.out;
  for (const char* algorithm : {"exact", "jones", "oracle"})
    expect_refused({"draw", algorithm, "s.json", "-o", "to/out.svg"}, 4, message);
  expect_refused({"compare", "s.json", "-o", "to/out"}, 4, message);
  // All other commands do not use that eye.
  EXPECT_EQ(sightline({"scene", "decompose", "s.json"}).exit_code, 0);
  EXPECT_EQ(sightline({"sweep", "s.json", "--views", "2"}).exit_code, 0);
  EXPECT_EQ(sightline({"draw", "jones", "s.json", "--eye", "50,40,30", "-o", "to/out.svg"}).exit_code, 0);
}

TEST_F(BadInput, FilesThatCannotBeRead) {
  std::filesystem::create_directory(path("folder.json"));
  for (const Arguments& arguments : commands("folder.json"))
    expect_refused(arguments, 5, "folder.json: cannot read: Is a directory");
  for (const Arguments& arguments : commands("none.json"))
    expect_refused(arguments, 5, "none.json: no such file");
  if (geteuid() == 0) return;  // root may read everything
  write("secret.json", std::string(cube) + "}");
  std::filesystem::permissions(path("secret.json"), std::filesystem::perms::none);
  for (const Arguments& arguments : commands("secret.json"))
    expect_refused(arguments, 5, "secret.json: cannot read: Permission denied");
}

// A limit on the size of files acts like a full disk, without needing one.
class FullDisk : public BadInput {
 protected:
  Ran sightline(const Arguments& arguments) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit limit = before;
    limit.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &limit);
    const Ran ran = BadInput::sightline(arguments);
    setrlimit(RLIMIT_FSIZE, &before);
    return ran;
  }
  void expect_full(const Arguments& arguments) {
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 5) << text_of(arguments) << ran.err;
    EXPECT_TRUE(has(ran.err, arguments.back() + ": cannot write: File too large")) << ran.err;
    EXPECT_TRUE(made().empty()) << text_of(arguments) << testing::PrintToString(made());
  }
};

TEST_F(FullDisk, LeavesNothing) {
  expect_full({"scene", "generate", "boxes", "100", "-o", "to/out.json"});
  ASSERT_EQ(BadInput::sightline({"scene", "generate", "boxes", "100", "-o", "boxes.json"}).exit_code, 0);
  expect_full({"scene", "convert", "boxes.json", "-o", "to/out.obj"});
  expect_full({"scene", "decompose", "boxes-30", "-o", "to/out.json"});
  for (const char* file : {"to/out.svg", "to/out.png", "to/out.plt"})
    expect_full({"draw", "exact", "boxes-100", "-o", file});
  // The folder for the overlays is made before the overlays.
  const Ran compare = sightline({"compare", "boxes-3", "--all", "-o", "to/compare"});
  EXPECT_EQ(compare.exit_code, 5);
  EXPECT_TRUE(has(compare.err, "to/compare/boxes-3-compare-exact.png: cannot write: File too large"))
      << compare.err;
  EXPECT_TRUE(std::filesystem::is_empty(path("to/compare")));
}

TEST_F(FullDisk, LeavesWholeLinesOfASweep) {
  const Ran sweep = sightline({"sweep", "boxes-3", "--views", "40", "-o", "to/out.jsonl"});
  EXPECT_EQ(sweep.exit_code, 5);
  EXPECT_TRUE(has(sweep.err, "to/out.jsonl: cannot write: File too large")) << sweep.err;
  const std::string lines = read("to/out.jsonl");
  EXPECT_TRUE(lines.ends_with("}}\n")) << lines;
  EXPECT_LE(lines.size(), 4096U);
}

TEST_F(BadInput, AnExistingFileIsKept) {
  write("old.off", "old");
  write("s.json", sheet("[0,0,0],[9,0,0],[0,9,0],[7,7,7]", "[0,1,2]"));
  EXPECT_EQ(sightline({"scene", "convert", "s.json", "-o", "old.off"}).exit_code, 4);
  EXPECT_EQ(read("old.off"), "old");
  EXPECT_EQ(files(), (std::vector<std::string>{"old.off", "s.json", "to"}));
}

TEST_F(BadInput, PathsThatCannotBeWritten) {
  write("file", "");
  std::filesystem::create_directory(path("folder.svg"));
  expect_refused({"draw", "exact", "house", "-o", "folder.svg"}, 5,
                 "folder.svg: cannot write: Is a directory");
  expect_refused({"draw", "exact", "house", "-o", "none/out.svg"}, 5,
                 "none/out.svg: cannot write: No such file or directory");
  expect_refused({"sweep", "boxes-2", "--views", "2", "-o", "folder.svg"}, 5,
                 "folder.svg: cannot write: Is a directory");
  expect_refused({"sweep", "boxes-2", "--views", "2", "-o", "/dev/full"}, 5,
                 "/dev/full: cannot write: No space left on device");
  expect_refused({"compare", "boxes-2", "-o", "file"}, 5, "file: Not a directory");
  send_stdout_to("/dev/full");
  for (const Arguments& arguments : {Arguments{"scene", "check", "house"},
                                     {"scene", "info", "house"},
                                     {"scene", "convert", "house"},
                                     {"scene", "decompose", "house"},
                                     {"sweep", "boxes-2", "--views", "2"}})
    expect_refused(arguments, 5, "standard output: cannot write: No space left on device");
}

TEST_F(BadInput, AnErrorForAnotherKindOfFileListsTheReadableKinds) {
  write("s.fbx", "Kaydara FBX Binary");
  write("s.csv", "1,2\n3,4\n");
  write("s.stl", "solid\nendsolid\n");
  expect_refused({"draw", "exact", "s.fbx", "-o", "to/a.svg"}, 4, "s.fbx: found no known format, expected STL, PLY, OFF, OBJ, glTF, 3MF");
  expect_refused({"draw", "exact", "s.csv", "-o", "to/a.svg"}, 4, "a grid of heights is drawn by: sightline draw skala");
  expect_refused({"draw", "skala", "s.stl", "-o", "to/a.svg"}, 4, "draw it by: sightline draw exact s.stl");
}

}  // namespace
