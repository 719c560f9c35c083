// The stripes program on the emulated 8080 compared with its native twin, dot for dot and step for step; its memory and time; and
// the
// laws of its pictures.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "host/scene/generate/scene.hpp"
#include "tests/host/programs/stripes/views.hpp"
#include "tests/host/scene/generate/generated_set.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::stripes {
namespace {

using jones::Dice;

constexpr double clock = 3e6;
double seconds(core::TStates time) { return static_cast<double>(time.count()) / clock; }

// All eight ways to draw a view; with the same priority list, the machine's picture is the same with stripes by the host and by
// the 8080.
void expect_twins(const scene::PolyScene& scene, const View& view, const std::string& name, bool with_plotter) {
  for (const Output output : outputs) {
    if (output == Output::vector && !with_plotter) continue;  // minutes of emulated time
    for (const Computer priority : both) {
      std::array<MachinePicture, 2> ways;
      for (std::size_t k = 0; k < both.size(); ++k) {
        const auto drawn = run({.scene = scene, .view = view, .options = {output, both[k], priority}, .check = true});
        ASSERT_TRUE(drawn) << name << ": " << drawn.error().message();
        ways[k] = drawn->picture;
        EXPECT_EQ(ways[k].status, Status::complete) << name;
        EXPECT_TRUE(ways[k].faults.empty()) << name;
        EXPECT_EQ(ways[k].counts, run_twin(drawn->stream.bytes).counts) << name;
      }
      EXPECT_EQ(ways[0].raster, ways[1].raster) << name;
      EXPECT_EQ(ways[0].commands, ways[1].commands) << name;
    }
  }
}

TEST(StripesGuest, EqualsItsTwinOnCommonScenes) {
  const auto names = compare::common_scene_names();
  for (std::size_t n = 0; n < names.size(); n += tests::effort(std::size_t{1}, std::size_t{2})) {
    const std::string_view name = names[n];
    const compare::CommonScene scene = compare::common_scene(name);
    if (scene.heights) continue;  // thousands of triangles
    const std::size_t views = tests::effort(scene.views.size(), std::size_t{1});
    for (std::size_t v = 0; v < views; ++v) {
      const std::string title = std::string(name) + ", view " + std::to_string(v);
      if (title == "C9, view 1") {
        const auto drawn = run({.scene = scene.scene, .view = common_view(scene.views[v])});
        ASSERT_FALSE(drawn);
        EXPECT_EQ(drawn.error().found, "65 faces are turned to the eye, 1 too many");
        continue;
      }
      expect_twins(scene.scene, common_view(scene.views[v]), title, v == 0);
    }
  }
}

TEST(StripesGuest, EqualsItsTwinOnBuiltInScenes) {
  for (const char* name : {"house", "roberts", "street4", "corridor8"}) {
    const scene::PolyScene scene = scene_named(name);
    expect_twins(scene, whole_view(scene), name, true);
  }
}

TEST(StripesGuest, EqualsItsTwinOnGeneratedScenes) {
  const auto names = scene::generated_set();
  const std::size_t stride = tests::effort(std::size_t{5}, std::size_t{50});
  for (std::size_t k = 0; k < names.size(); k += stride) {
    const auto scene = *scene::generate_scene(names[k].family, names[k].size, names[k].seed);
    const std::size_t n = k / stride;
    const StreamOptions options{outputs[n % 8 == 0 ? 1 : 0], both[n % 2], both[n / 2 % 2]};
    const auto drawn = run({.scene = scene, .view = whole_view(scene), .options = options, .check = true});
    ASSERT_TRUE(drawn) << names[k].family << "-" << names[k].size << "-" << names[k].seed << ": " << drawn.error().message();
    EXPECT_EQ(drawn->picture.counts, run_twin(drawn->stream.bytes).counts);
  }
}

// Faces that no scene has: crossing themselves and each other, with arbitrary planes. They include cycles, cuts and lines that
// are too
// full.
ProjectedScene random_faces(Dice& dice) {
  ProjectedScene scene;
  const int faces = dice(1, 24);
  const int size = dice(0, 2) == 0 ? 0xFF00 : dice(0x400, 0xFF00);
  for (int f = 0; f < faces; ++f) {
    SceneFace& face = scene.faces.emplace_back();
    face.level = static_cast<std::uint8_t>(dice(1, 7));
    const int rings = dice(0, 4) == 0 ? 2 : 1;
    const int from_x = dice(0, 0xFF00 - size);
    const int from_y = dice(0, 0xFF00 - size);
    for (int r = 0; r < rings; ++r) {
      auto& ring = face.rings.emplace_back();
      const int corners = dice(3, 7);
      for (int k = 0; k < corners; ++k) {
        const auto part = [&](int from) { return static_cast<std::uint16_t>(dice(0, 9) == 0 ? 0xFF00 : from + dice(0, size)); };
        ring.push_back({part(from_x), part(from_y), static_cast<std::uint16_t>(dice(0, 0xFF00))});
      }
    }
    face.a = dice(-5000, 5000);
    face.b = dice(-5000, 5000);
    face.c = dice(1, 6000);
    const Corner& on = face.rings[0][0];
    face.d = face.a * on.x + face.b * on.y + face.c * on.z;
  }
  return scene;
}

TEST(StripesGuest, EqualsItsTwinOnRandomFaces) {
  constexpr std::uint32_t seed = 20261124;
  Dice dice(seed);
  const int scenes = tests::effort(96, 24);
  int cut = 0;
  int full = 0;
  for (int n = 0; n < scenes; ++n) {
    const ProjectedScene scene = random_faces(dice);
    const StreamOptions options{n % 12 == 0 ? Output::vector : Output::raster, both[static_cast<std::size_t>(n) % 2],
                                n % 8 < 6 ? Computer::i8080 : Computer::host};
    const auto stream = encode(scene, options);
    if (!stream) continue;  // too many sides in a line
    const CheckedPicture picture = run_both(stream->bytes);
    ASSERT_EQ(picture.difference, "") << "scene " << n << " of seed " << seed;
    ASSERT_TRUE(picture.machine.ended);
    cut += picture.twin.cuts.empty() ? 0 : 1;
    full += picture.twin.status == Status::full ? 1 : 0;
  }
  EXPECT_GT(cut, scenes / 10);
  if (scenes >= 96) {
    EXPECT_GT(full, 0);  // one in some fifty scenes
  }
}

// The drawing consists of the border lines between dots of different faces, each drawn once: found here from the dots, and
// followed here
// from the plotter's commands.
using Link = std::array<int, 3>;  // x, y of its lower or west end; 0 to the east, 1 up

std::set<Link> borders_of(const std::vector<std::uint8_t>& items) {
  std::set<Link> links;
  const auto at = [&items](int x, int y) { return items[static_cast<std::size_t>(y * picture_size + x)]; };
  for (int y = 0; y < picture_size; ++y) {
    for (int x = 0; x < picture_size; ++x) {
      if (x > 0 && at(x - 1, y) != at(x, y)) links.insert({x, y, 1});
      if (y > 0 && at(x, y - 1) != at(x, y)) links.insert({x, y, 0});
    }
  }
  return links;
}

Link link_between(int x, int y, int dx, int dy) { return {dx < 0 ? x - 1 : x, dy < 0 ? y - 1 : y, dy != 0 ? 1 : 0}; }

void expect_drawn(std::set<Link> left, const std::vector<std::uint8_t>& commands, const std::string& name) {
  constexpr std::array<std::array<int, 2>, 8> moves{
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  int x = 0;
  int y = 0;
  bool down = false;
  for (const std::uint8_t command : commands) {
    if (command >= 8) {
      EXPECT_NE(down, command == 9) << name;
      down = command == 9;
      continue;
    }
    const auto [dx, dy] = moves[command];
    if (down && dx != 0 && dy != 0) {
      const std::array<Link, 2> over{link_between(x, y, dx, 0), link_between(x + dx, y, 0, dy)};
      const std::array<Link, 2> under{link_between(x, y, 0, dy), link_between(x, y + dy, dx, 0)};
      const bool first = left.count(over[0]) != 0 && left.count(over[1]) != 0;
      for (const Link& link : first ? over : under) EXPECT_EQ(left.erase(link), 1U) << name << " at " << x << ", " << y;
    } else if (down) {
      EXPECT_EQ(left.erase(link_between(x, y, dx, dy)), 1U) << name << " at " << x << ", " << y;
    }
    x += dx;
    y += dy;
  }
  EXPECT_FALSE(down) << name;
  EXPECT_TRUE(left.empty()) << name << ": " << left.size() << " links are not drawn";
}

TEST(StripesGuest, DrawsEveryBorderBetweenFacesOnce) {
  for (const std::string_view name : {"C1", "C3", "C5", "C7", "C8"}) {
    const compare::CommonScene scene = compare::common_scene(name);
    const auto drawn = run({.scene = scene.scene, .view = common_view(scene.views[0]), .options = {.output = Output::vector}, .check = true});
    ASSERT_TRUE(drawn) << name << ": " << drawn.error().message();
    expect_drawn(borders_of(run_twin(drawn->stream.bytes).items), drawn->picture.commands, std::string(name));
  }
}

TEST(StripesGuest, FitsInFourKilobytes) {
  EXPECT_LE(resident_program().memory.size(), program_room);
  EXPECT_EQ(program_room, 4096U);
  EXPECT_EQ(data_room, 48U * 1024);
}

// 20 boxes with three faces each towards the eye.
TEST(StripesGuest, DrawsSixtyFacesInAMinute) {
  const scene::PolyScene scene = scene_named("boxes-20");
  for (const Output output : outputs) {
    const auto drawn = run({.scene = scene, .view = whole_view(scene), .options = {.output = output}});
    ASSERT_TRUE(drawn) << drawn.error().message();
    EXPECT_EQ(drawn->scene.faces.size(), 60U);
    const MachinePicture& guest = drawn->picture;
    EXPECT_EQ(guest.status, Status::complete);
    EXPECT_LE(seconds(guest.receiving + guest.working()), 60);
  }
}

}  // namespace
}  // namespace sightline::programs::stripes
