// Drawings checked by rays (tests/support/ray_check.hpp): no visible sample of an edge is undrawn, no hidden one is drawn.
// The public meshes are those of Debian's assimp-testmodels; without them that test is skipped with a message.
#include "tests/support/ray_check.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/host/app/command_line.hpp"
#include "tests/support/plain_mesh.hpp"

namespace {

namespace fs = std::filesystem;
using sightline::tests::PlainMesh;
using sightline::tests::PlainStroke;
using sightline::tests::Point3;
using sightline::tests::RayReport;

constexpr std::size_t most_faces = 20000;
constexpr std::uint32_t seed = 20;

class RayCheckedDrawing : public sightline::test::CommandLine {
 protected:
  // The view of the command's last run.
  sightline::tests::PlainView view;
  std::vector<PlainStroke> strokes;

  [[nodiscard]] sightline::test::Ran draw(const std::string& mesh, const sightline::test::Arguments& options) {
    sightline::test::Arguments arguments{"draw",   "exact",     mesh,      "--hidden", "--size", "1000x1000",
                                         "--json", "--strokes", "s.jsonl", "-o",       "d.svg"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto ran = sightline(arguments);
    if (ran.exit_code != 0) return ran;
    view = sightline::tests::view_of_json(ran.out);
    strokes = sightline::tests::strokes_of_lines(read("s.jsonl"));
    return ran;
  }
};

std::string join_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "\n") + word;
  return text;
}

// Orthographic views, and perspective views from outside.
std::vector<sightline::test::Arguments> views_of(const PlainMesh& mesh) {
  Point3 low = mesh.vertices.front();
  Point3 high = low;
  for (const Point3& p : mesh.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const Point3 away{1.1, 0.7, 1.3};
  std::string eye;
  for (std::size_t a = 0; a < 3; ++a) eye += (a == 0 ? "" : ",") + std::to_string((low[a] + high[a]) / 2 + away[a] * size);
  return {{"--view", "iso"}, {"--view", "front"}, {"--view", "trimetric"}, {"--eye", eye}};
}

TEST_F(RayCheckedDrawing, IsCorrectForPublicMeshes) {
  const fs::path folder = "/usr/share/assimp/models";
  std::error_code missing;
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator entry(folder, missing), end; !missing && entry != end; entry.increment(missing)) {
    std::string ending = entry->path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending == ".off" || ending == ".obj" || ending == ".ply" || ending == ".stl")
      files.push_back(entry->path().string());
  }
  if (files.empty()) GTEST_SKIP() << "found no mesh in " << folder << ": install Debian's assimp-testmodels";
  std::sort(files.begin(), files.end());
  int checked = 0;
  std::size_t visible = 0;
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    std::optional<PlainMesh> mesh;
    std::string damage;
    try {
      mesh = sightline::tests::read_plain_mesh(file);
    } catch (const std::runtime_error& error) {
      damage = error.what();
    }
    if (!mesh) {
      const auto ran = draw(file, {});
      EXPECT_EQ(ran.exit_code, 4) << "the check found: " << damage;
      std::printf("%s\n  not checked: %s", file.c_str(), ran.err.c_str());
      continue;
    }
    if (mesh->faces.size() > most_faces) {
      std::printf("%s\n  not checked: %zu faces, more than %zu\n", file.c_str(), mesh->faces.size(), most_faces);
      continue;
    }
    ++checked;
    std::printf("%s\n  %zu faces, %zu lines\n", file.c_str(), mesh->faces.size(), mesh->lines.size());
    for (const auto& options : views_of(*mesh)) {
      const auto ran = draw(file, options);
      ASSERT_EQ(ran.exit_code, 0) << ran.err;
      const RayReport report = sightline::tests::check_by_rays(*mesh, view, strokes, seed);
      std::printf(
          "  %s %s: %zu feature edges and %zu unclear ones, %zu samples, %zu visible, %zu undrawn; %zu on strokes, %zu "
          "hidden; "
          "%zu on dashes, %zu visible; %zu drawn twice; %zu off their edges, by up to %.4f mm\n",
          options[0].c_str(), options[1].c_str(), report.feature_edges, report.unclear_edges, report.samples, report.visible,
          report.undrawn, report.stroke_samples, report.hidden_drawn, report.dash_samples, report.visible_dashed,
          report.drawn_twice, report.off_edge, report.residual);
      EXPECT_TRUE(report.good()) << options[0] << ' ' << options[1] << ", residual " << report.residual << " of "
                                 << report.allowed_residual << " mm\n"
                                 << join_words(report.faults);
      visible += report.visible;
    }
  }
  // Guards against an empty check.
  EXPECT_GE(checked, 30);
  EXPECT_GE(visible, 60000U);
}

// Where a closed part passes through itself, the surface beyond the crossing is inside out: two pyramids on one base, turned
// against
// each other, so that the outside of each is inside the other.
TEST_F(RayCheckedDrawing, IsCorrectForABodyThatPassesThroughItself) {
  write("a.obj", "v 0 0 0\nv 4 0 0\nv 0 0 4\nv 1 4 1\nv 6 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 2 1 5\nf 3 2 5\nf 1 3 5\n");
  const PlainMesh mesh = sightline::tests::read_plain_mesh(path("a.obj").string());
  for (const char* name : {"front", "back", "left", "right", "top", "bottom", "iso"}) {
    ASSERT_EQ(draw("a.obj", {"--view", name}).exit_code, 0);
    const RayReport report = sightline::tests::check_by_rays(mesh, view, strokes, seed);
    EXPECT_GT(report.visible, 40U);
    EXPECT_TRUE(report.good()) << name << '\n' << join_words(report.faults);
  }
}

// Bevels of 0.2 in a file with one decimal are not rounding errors.
TEST_F(RayCheckedDrawing, ShowsBevelsOfFewDecimals) {
  write("a.obj",
        "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 0.8 0\nv 1 0.8 0\nv 1 0.8 1\nv 0 0.8 1\nv 0.2 1 0.2\nv 0.8 1 0.2\nv 0.8 1 "
        "0.8\n"
        "v 0.2 1 0.8\nf 1 2 3 4\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 5 9 10 6\nf 6 10 11 7\nf 7 11 12 8\nf 8 12 9 "
        "5\nf 9 12 11 10\n");
  const PlainMesh mesh = sightline::tests::read_plain_mesh(path("a.obj").string());
  ASSERT_EQ(draw("a.obj", {"--view", "iso"}).exit_code, 0);
  const RayReport report = sightline::tests::check_by_rays(mesh, view, strokes, seed);
  EXPECT_EQ(report.feature_edges, 20U);
  EXPECT_TRUE(report.good()) << join_words(report.faults);
}

// Meshes with few integer coordinates: vertices and edges on faces, touching and coplanar faces, coincident lines.
TEST_F(RayCheckedDrawing, IsCorrectForRandomMeshes) {
  std::mt19937 engine(seed);
  const auto random = [&engine](int low, int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1));
  };
  const auto triple = [&](int low, int high) {
    std::string text = std::to_string(random(low, high));
    for (int i = 0; i < 2; ++i) text += " " + std::to_string(random(low, high));
    return text;
  };
  std::size_t visible = 0;
  for (int number = 0; number < 60; ++number) {
    std::string obj;
    if (number % 2 == 0) {
      const int vertices = random(6, 24);
      for (int v = 0; v < vertices; ++v) obj += "v " + triple(0, 9) + "\n";
      for (int face = random(3, 16); face > 0; --face) obj += "f " + triple(1, vertices) + "\n";
    } else {
      for (int box = random(2, 6); box > 0; --box) {
        std::array<std::array<int, 2>, 3> sides{};
        for (auto& side : sides) {
          side[0] = random(0, 6);
          side[1] = side[0] + random(1, 4);
        }
        for (std::size_t corner = 0; corner < 8; ++corner)
          obj += "v " + std::to_string(sides[0][corner & 1]) + " " + std::to_string(sides[1][corner / 2 & 1]) + " " +
                 std::to_string(sides[2][corner / 4]) + "\n";
        obj += "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
      }
    }
    write("a.obj", obj);
    PlainMesh mesh;
    try {
      mesh = sightline::tests::read_plain_mesh(path("a.obj").string());
    } catch (const std::runtime_error&) {
      continue;  // every face has a vertex twice
    }
    std::string direction = triple(-3, 3);
    if (direction == "0 0 0") direction = "1 2 -3";
    std::replace(direction.begin(), direction.end(), ' ', ',');
    for (const sightline::test::Arguments& options :
         {sightline::test::Arguments{"--orthographic=" + direction}, {"--view", "iso", "--perspective"}}) {
      const auto ran = draw("a.obj", options);
      if (ran.exit_code == 4) continue;  // no face has an area
      ASSERT_EQ(ran.exit_code, 0) << ran.err << obj;
      const RayReport report = sightline::tests::check_by_rays(mesh, view, strokes, seed);
      EXPECT_TRUE(report.good()) << options[0] << '\n' << join_words(report.faults) << '\n' << obj;
      visible += report.visible;
    }
  }
  EXPECT_GE(visible, 10000U);
}

// The command's drawing of a mesh, with one fault inserted by hand.
TEST_F(RayCheckedDrawing, FindsAFaultInADrawingOfTheCommand) {
  const std::string file = std::string(SIGHTLINE_SOURCE_DIR) + "/host/examples/bracket.obj";
  const PlainMesh mesh = sightline::tests::read_plain_mesh(file);
  ASSERT_EQ(draw(file, {"--view", "iso"}).exit_code, 0);
  const std::vector<PlainStroke> right = strokes;
  const auto report = [&] { return sightline::tests::check_by_rays(mesh, view, strokes, seed); };
  ASSERT_TRUE(report().good()) << join_words(report().faults);
  for (std::size_t i = 0; i < right.size(); ++i) {
    strokes = right;
    if (right[i].hidden) {
      strokes[i].hidden = false;
      EXPECT_GT(report().hidden_drawn, 0U) << "dash " << i;
    } else {
      strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_GT(report().undrawn, 0U) << "stroke " << i;
    }
  }
}

}  // namespace
