// Antialiasing by the sides of stripes (SPECIFICATION, section 8), and overwriting (section 9): the 8080 compared with its twin,
// the twin with exact coverage, overwriting with the picture by differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/programs/stripes/views.hpp"
#include "tests/host/scene/generate/generated_set.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::stripes {
namespace {

using jones::Dice;

void expect_twin(Build build, std::span<const std::uint8_t> stream, const std::string& title) {
  const MachinePicture machine = run_machine(resident_program(build), stream);
  const TwinPicture twin = run_twin(stream, build);
  ASSERT_EQ(difference_from_twin(machine, twin), "") << title;
  EXPECT_TRUE(machine.ended) << title;
  EXPECT_TRUE(machine.faults.empty()) << title;
  EXPECT_EQ(machine.counts.dots, static_cast<std::uint32_t>(std::count_if(twin.raster.points().begin(), twin.raster.points().end(),
                                                                        [](std::uint8_t level) { return level != 0; })))
      << title;
}

constexpr std::array builds{Build::coverage, Build::overwrite};

TEST(StripesCoverage, MachineEqualsItsTwinOnScenes) {
  for (const std::string name : {"roberts", "house", "boxes-8", "street4", "boxes-20", "bricks-20"}) {
    const scene::PolyScene scene = scene_named(name);
    for (const Build build : builds) {
      for (const Computer priority : both) {
        const auto drawn = run({.scene = scene, .view = whole_view(scene), .options = {.priority = priority, .build = build}, .check = true});
        ASSERT_TRUE(drawn) << name << ": " << drawn.error().message();
        expect_twin(build, drawn->stream.bytes, name);
      }
    }
  }
}

// Random polygons, also with holes and crossing themselves, one in front of the other or in cycles.
ProjectedScene random_scene(Dice& dice, int most_faces, int most_corners) {
  ProjectedScene scene;
  const int faces = dice(1, most_faces);
  for (int f = 0; f < faces; ++f) {
    SceneFace& face = scene.faces.emplace_back();
    face.level = static_cast<std::uint8_t>(dice(1, 7));
    const int size = dice(0, 3) == 0 ? 0xFF00 : dice(0x200, 0x6000);
    const int west = dice(0, 0xFF00 - size);
    const int low = dice(0, 0xFF00 - size);
    for (int r = dice(0, 5) == 0 ? 2 : 1; r > 0; --r) {
      auto& ring = face.rings.emplace_back();
      for (int k = dice(3, most_corners); k > 0; --k) {
        ring.push_back({static_cast<std::uint16_t>(west + dice(0, size)), static_cast<std::uint16_t>(low + dice(0, size)),
                        static_cast<std::uint16_t>(dice(0, 0xFF00))});
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

TEST(StripesCoverage, MachineEqualsItsTwinOnRandomFaces) {
  constexpr std::uint32_t seed = 20261128;
  Dice dice(seed);
  constexpr int scenes = 160;
  int cut = 0;
  int full = 0;
  for (int n = 0; n < scenes; ++n) {
    const Build build = builds[static_cast<std::size_t>(n) % 2];
    const ProjectedScene scene = random_scene(dice, n % 4 < 2 ? 6 : 24, n % 3 == 0 ? 9 : 4);
    const auto stream = encode(scene, {.priority = n % 8 < 6 ? Computer::i8080 : Computer::host, .build = build});
    if (!stream) continue;  // too many sides in a line
    expect_twin(build, stream->bytes, "scene " + std::to_string(n) + " of seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
    const TwinPicture twin = run_twin(stream->bytes, build);
    cut += twin.cuts.empty() ? 0 : 1;
    full += twin.status == Status::full ? 1 : 0;
  }
  EXPECT_GT(cut, scenes / 20);
  EXPECT_GT(full, 0);
}

// Streams that a build does not accept, and limits.
TEST(StripesCoverage, ModesAndLengthsThatABuildDoesNotAccept) {
  const std::vector<std::uint8_t> body;
  for (const Build build : builds) {
    for (unsigned mode = 0; mode < 16; ++mode) {
      const auto stream = framed(static_cast<std::uint8_t>(mode), 0, body);
      const bool refused = mode > 7 || (mode & vector_output) != 0 || (build == Build::coverage && (mode & faces_are_stripes) != 0);
      const MachinePicture machine = run_machine(resident_program(build), stream);
      EXPECT_EQ(machine.status, refused ? Status::not_a_stream : Status::complete) << "mode " << mode;
      EXPECT_EQ(run_twin(stream, build).status, machine.status) << "mode " << mode;
    }
  }
  std::vector<std::uint8_t> longer = framed(0, 0, std::vector<std::uint8_t>(most_coverage_body_bytes + 1));
  EXPECT_EQ(run_machine(resident_program(Build::coverage), longer).status, Status::too_large);
  EXPECT_EQ(run_twin(longer, Build::coverage).status, Status::too_large);
}

// --- Exact coverage of one polygon, in units of 2^-40 of a dot. Shares no code with program and twin.

using Wide = geometry::Int128;
constexpr int bits = 40;

// Twice the integral from -infinity to s of the part of a dot of `dot` units, from 0 on, that is to the west of u.
Wide twice_integral(Wide s, Wide dot) {
  if (s <= 0) return 0;
  return s < dot ? s * s : 2 * dot * s - dot * dot;
}

struct Side {
  Wide low = 0;   // abscissas in 1/dot at both ends, the smaller first
  Wide high = 0;
  Wide dot = 1;   // 256 times the lines of the edge, so that they are whole
  double middle = 0;

  // How much of the dot of a column is to the east.
  [[nodiscard]] std::int64_t east(int column) const {
    const Wide end = (column + 1) * dot;
    if (low == high) return static_cast<std::int64_t>((std::clamp<Wide>(end - low, 0, dot) << bits) / dot);
    const Wide numerator = twice_integral(end - low, dot) - twice_integral(end - high, dot);
    return static_cast<std::int64_t>((numerator << bits) / (2 * (high - low) * dot));
  }
  [[nodiscard]] bool passes(int column) const { return low < (column + 1) * dot && high > column * dot; }
};

std::vector<Side> sides_of(const std::vector<Corner>& ring, int line) {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    Corner a = ring[k];
    Corner b = ring[(k + 1) % ring.size()];
    if (a.line() > b.line()) std::swap(a, b);
    if (line < a.line() || line >= b.line()) continue;
    const Wide lines = b.line() - a.line();
    const auto at = [&](int y) { return a.x * lines + (Wide{b.x} - a.x) * (y - a.line()); };
    const Wide bottom = at(line);
    const Wide top = at(line + 1);
    sides.push_back({std::min(bottom, top), std::max(bottom, top), 256 * lines,
                     static_cast<double>(bottom + top) / static_cast<double>(512 * lines)});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& one, const Side& other) { return one.middle < other.middle; });
  return sides;
}

TEST(StripesCoverage, LayersAreWithinTheirBoundOfExactCoverage) {
  constexpr std::uint32_t seed = 85;
  constexpr std::int64_t whole = std::int64_t{1} << bits;
  constexpr std::int64_t bound = whole / 8 + whole / 64 + 260 * (whole / 65536);
  Dice dice(seed);
  std::int64_t worst = 0;
  std::int64_t sum = 0;
  std::int64_t plain_sum = 0;
  std::int64_t edge_dots = 0;
  const int polygons = tests::effort(400, 60);
  for (int n = 0; n < polygons; ++n) {
    // Triangles: their sides meet at borders of stripes only, so that in a line they do not cross.
    ProjectedScene scene;
    SceneFace& face = scene.faces.emplace_back();
    face.level = 7;  // so that 0 to 4 layers are levels 0, 2, 4, 5, 7
    auto& ring = face.rings.emplace_back();
    const int size = n % 3 == 0 ? 0x400 : 0xFF00;
    const int west = dice(0, 0xFF00 - size);
    const int low = dice(0, 0xFF00 - size);
    for (int k = 0; k < 3; ++k)
      ring.push_back({static_cast<std::uint16_t>(west + dice(0, size)), static_cast<std::uint16_t>(low + dice(0, size)), 0});
    if (n % 5 == 0) ring[1].x = ring[0].x;  // a side of type 2
    face.c = 1;
    const auto stream = encode(scene, {.priority = Computer::i8080, .build = Build::coverage});
    ASSERT_TRUE(stream);
    const TwinPicture twin = run_twin(stream->bytes, Build::coverage);
    const TwinPicture plain = run_twin(stream->bytes);
    ASSERT_EQ(twin.status, Status::complete);
    for (int y = 0; y < picture_size; ++y) {
      const std::vector<Side> sides = sides_of(ring, y);
      for (int x = 0; x < picture_size; ++x) {
        std::int64_t exact = 0;
        std::int64_t here = 0;
        std::int64_t sign = 1;
        for (const Side& side : sides) {
          exact += sign * side.east(x);
          sign = -sign;
          here += side.passes(x) ? 1 : 0;
        }
        const auto at = [x, y](const TwinPicture& picture) {
          return picture.raster.points()[static_cast<std::size_t>(y * core::Raster::width + x)];
        };
        constexpr std::array<std::int64_t, 8> layers{0, -1, 1, -1, 2, 3, -1, 4};
        const std::int64_t part = layers[at(twin)] * (whole / 4);
        ASSERT_GE(part, 0);
        const std::int64_t error = std::abs(part - exact);
        // Floors of the exact parts are the last two units.
        ASSERT_LE(error, here * bound + 2) << "triangle " << n << " of seed " << seed << ", dot " << x << ", " << y;
        if (here == 0) continue;
        ++edge_dots;
        sum += error;
        plain_sum += std::abs((at(plain) != 0 ? whole : 0) - exact);
        if (here == 1) worst = std::max(worst, error);
      }
    }
  }
  EXPECT_GT(worst, whole / 8);      // the bound is not loose
  EXPECT_LT(3 * sum, plain_sum);    // a quarter instead of a whole: more than three times as near
  EXPECT_GT(edge_dots, 100 * polygons);
}

// Where no side passes, and with any number of faces, a dot shows what the plain build shows.
TEST(StripesCoverage, DotsWithoutSidesShowThePlainPicture) {
  for (const std::string name : {"house", "boxes-20"}) {
    const scene::PolyScene scene = scene_named(name);
    const auto plain = run({.scene = scene, .view = whole_view(scene)});
    const auto drawn = run({.scene = scene, .view = whole_view(scene), .options = {.build = Build::coverage}});
    ASSERT_TRUE(plain && drawn);
    const auto levels = plain->picture.raster.points();
    const auto greys = drawn->picture.raster.points();
    int different = 0;
    for (int y = 1; y < picture_size - 1; ++y) {
      for (int x = 1; x < picture_size - 1; ++x) {
        const auto index = [](int column, int row) { return static_cast<std::size_t>(row * core::Raster::width + column); };
        const std::uint8_t level = levels[index(x, y)];
        if (greys[index(x, y)] == level) continue;
        ++different;
        // Then there is another level beside the dot.
        bool other = false;
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy) other = other || levels[index(x + dx, y + dy)] != level;
        EXPECT_TRUE(other) << name << ": dot " << x << ", " << y;
      }
    }
    EXPECT_GT(different, 200) << name;
  }
}

TEST(StripesOverwrite, ThePictureIsThatOfDifferences) {
  const auto names = scene::generated_set();
  for (std::size_t k = 0; k < names.size(); k += tests::effort(std::size_t{7}, std::size_t{70})) {
    const auto scene = *scene::generate_scene(names[k].family, names[k].size, names[k].seed);
    const auto plain = run({.scene = scene, .view = whole_view(scene)});
    const auto drawn = run({.scene = scene, .view = whole_view(scene), .options = {.build = Build::overwrite}});
    ASSERT_TRUE(plain && drawn);
    EXPECT_EQ(drawn->picture.raster, plain->picture.raster) << names[k].family << '-' << names[k].size;
  }
}

}  // namespace
}  // namespace sightline::programs::stripes
