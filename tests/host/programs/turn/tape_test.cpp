// The contents of the tape, and models that have none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/host/programs/turn/turned_model.hpp"

namespace sightline::programs::turn {
namespace {

namespace plantinga = algorithms::plantinga;

TEST(TurnTape, EventsAreRoundedUpAndExactOnesAreNot) {
  for (const std::int64_t x : {-3LL, -2LL, -1LL, 0LL, 1LL, 2LL, 5LL})
    for (const std::int64_t z : {-7LL, -1LL, 1LL, 3LL}) {
      const auto direction = plantinga::rational_direction(x, z);
      const std::uint32_t word = event_word(direction);
      const double turns = std::atan2(static_cast<double>(x), static_cast<double>(z)) / (2 * std::numbers::pi) * (1 << 18);
      const double signed_word = word > (1U << 17U) ? static_cast<double>(word) - (1 << 18) : word;
      EXPECT_GE(signed_word, turns - 1e-6) << x << " " << z;
      EXPECT_LT(signed_word, turns + 1) << x << " " << z;
    }
  EXPECT_EQ(event_word(plantinga::rational_direction(0, 1)), 0U);
  EXPECT_EQ(event_word(plantinga::rational_direction(1, 1)), 1U << 15U);
  EXPECT_EQ(event_word(plantinga::rational_direction(1, 0)), 1U << 16U);
  EXPECT_EQ(event_word(plantinga::rational_direction(0, -1)), 1U << 17U);
  EXPECT_EQ(event_word(plantinga::rational_direction(-1, 1)), 7U << 15U);
}

TEST(TurnTape, SumOfAllWordsIsZero) {
  const Tape& tape = turned_model(star).tape;
  core::Word18 sum(static_cast<std::uint32_t>(tape.words.size()));
  for (const core::Word18 word : tape.words) sum = sum + word;
  EXPECT_EQ(sum + checksum(tape.words), core::Word18(0));
  EXPECT_EQ(punch(tape).size(), 3 * (tape.words.size() + 2));
}

TEST(TurnTape, LayoutAddsUp) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& model = turned_model(name);
    const Tape& tape = model.tape;
    EXPECT_EQ(tape.layout.model(), tape.words.size()) << name;
    EXPECT_EQ(tape.edges, model.model.edges().size()) << name;
    EXPECT_EQ(tape.layout.events, tape.events + tape.changes) << name;
    EXPECT_LE(model_base(Memory::words_8k) + tape.words.size() + 1 + tape.files * tape.file_words, 8192U) << name;
  }
  EXPECT_EQ(turned_model(star).tape.edges, 100U);
  EXPECT_EQ(turned_model(block).tape.edges, 24U);
}

// The bytes of a tape decoded independently, from section 2 of the specification alone: what its words say of every vertex, edge
// and
// T-junction must be their position on the screen, by plain geometry in doubles.
TEST(TurnTape, PunchedWordsGiveThePositions) {
  for (const std::string& name : {block, crossed, lshape, star, std::string("boxes-8")}) {
    const TurnedModel& of = turned_model(name);
    const base::Bytes bytes = punch(of.tape);
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto line = static_cast<std::uint32_t>(bytes[i + k]);
        ASSERT_EQ(line & 0300U, 0200U) << name;  // a binary line, its eighth hole punched
        word = word << 6U | (line & 077U);
      }
      words.push_back(word);
    }
    ASSERT_EQ(words.size(), words.front() + 2);
    std::uint32_t sum = 0;
    for (const std::uint32_t word : words) sum = (sum + word) & 0777777U;
    EXPECT_EQ(sum, 0U) << name;
    constexpr std::uint32_t base = 02500;
    const auto at = [&words](std::uint32_t address) { return words.at(address - base + 1); };
    const auto negative = [&at](std::uint32_t word) { return (1U << 18U) - at(base + word); };
    ASSERT_EQ(at(base), 0401U);
    const auto value = [&at](std::uint32_t address, double turn) {
      return (at(address) - 65535.5) * std::cos(turn) + (at(address + 1) - 65535.5) * std::sin(turn);
    };
    const auto& vertices = of.scene.vertices;
    // The vertex of the scene for each vertex on the tape: the one with its three coordinates.
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
    const double middle = ((*low)[1] + (*high)[1]) / 2.0;
    double most = 0;
    for (const auto& v : vertices) most = std::max({most, std::hypot(v[0], v[2]), std::abs(v[1] - middle)});
    const double scale = 505 / most;
    std::vector<std::size_t> scene_vertex;
    for (std::uint32_t v = 0; v < negative(1); ++v) {
      const std::uint32_t form = at(base + 4) + 1 + 2 * v;
      const std::uint32_t place = at(base + 5) + 1 + 2 * v;
      EXPECT_EQ(at(place) & 0776000U, 0220000U);
      const auto found = std::find_if(vertices.begin(), vertices.end(), [&](const auto& p) {
        return std::abs(at(form) - 65535.5 - 128 * scale * p[0]) <= 0.51 && std::abs(at(form + 1) - 65535.5 + 128 * scale * p[2]) <= 0.51 &&
               std::abs((at(place) & 01777U) - 512.0 - scale * (p[1] - middle)) <= 0.51;
      });
      ASSERT_NE(found, vertices.end()) << name << " vertex " << v;
      scene_vertex.push_back(static_cast<std::size_t>(found - vertices.begin()));
    }
    // Two ends of an edge, at an angle.
    struct Point {
      double x, y;
    };
    const auto image = [&](std::size_t vertex, double turn) {
      const auto& p = vertices[vertex];
      return Point{p[0] * std::cos(turn) - p[2] * std::sin(turn), static_cast<double>(p[1])};
    };
    std::size_t compared = 0;
    for (std::uint32_t s = 0; s < negative(3); ++s) {
      const std::uint32_t slot = at(base + 6) + 4 * s;
      const auto end = [&](std::uint32_t field) { return scene_vertex.at((at(slot + field) - at(base + 5)) / 2); };
      const std::size_t first = end(1);
      const std::size_t second = end(2);
      const auto& partners = of.tape.partners[of.tape.slot_of[s].edge];
      for (std::uint32_t code = 2; code < partners.size() + 2; ++code) {
        const std::uint32_t junction = at(slot + 3) + 9 + 4 * (code - 2);
        const plantinga::End partner{partners[code - 2]};
        for (double turn = 0.05; turn < 6.28; turn += 0.37) {
          const Point p = image(first, turn);
          const Point q = image(second, turn);
          double expected = 0;
          if (partner.kind() == plantinga::EndKind::junction) {
            const auto& other = of.model.edges()[partner.index()];
            const Point r = image(other.from, turn);
            const Point t = image(other.to, turn);
            const double along = (q.x - p.x) * (t.y - r.y) - (q.y - p.y) * (t.x - r.x);
            expected = ((r.x - p.x) * (t.y - r.y) - (r.y - p.y) * (t.x - r.x)) / along;
          } else {
            expected = (image(partner.index(), turn).x - p.x) / (q.x - p.x);
          }
          const double d = value(junction + 2, turn);
          if (std::abs(d) < 1000 || !(std::abs(expected) < 2)) continue;
          EXPECT_NEAR(value(junction, turn) / d, expected, 3 / std::abs(d)) << name << " slot " << s << " code " << code;
          ++compared;
        }
      }
    }
    EXPECT_GT(compared, 100U) << name;
    // Events ascend through one turn, and each has a first and a last change.
    std::int64_t before = -1;
    for (std::uint32_t event = at(base + 7); event < at(base + 8);) {
      const std::int64_t turned_on = (at(event) + 0377777U) & 0777777U;  // 400001 is the first
      EXPECT_GT(turned_on, before) << name;
      before = turned_on;
      EXPECT_EQ(at(event + 1) & 2U, 2U);
      std::uint32_t change = event + 1;
      for (; (at(change) & 1U) == 0; ++change) {
        EXPECT_EQ(at(change + 1) & 2U, 0U);
      }
      event = change + 1;
    }
  }
}

// The exclusive or of all changes of a turn leaves every state unchanged.
TEST(TurnTape, AWholeTurnOfChangesCancels) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const Tape& tape = turned_model(name).tape;
    const std::uint32_t base = model_base(tape.memory);
    std::map<std::uint32_t, std::uint32_t> sums;
    for (std::uint32_t at = tape.words[7].value() - base; at < tape.words[8].value() - base;) {
      ++at;
      std::uint32_t word = 0;
      do {
        word = tape.words[at++].value();
        sums[word & 07774U] ^= word & 0770000U;
      } while ((word & 1U) == 0);
    }
    for (const auto& [end, sum] : sums) EXPECT_EQ(sum, 0U) << name << " end " << end;
  }
}

TEST(TurnTape, ReportsTheExcessWordsOfAModel) {
  const plantinga::RotationModel model(*stand_on_axis(scene_named(grid), false));
  const auto list = plantinga::build_event_list(model);
  const auto small = encode(model, *list, Memory::words_8k);
  ASSERT_FALSE(small);
  const std::string message = small.error().message();
  EXPECT_NE(message.find(" words too many for 8K"), std::string::npos) << message;
  EXPECT_NE(message.find("for T-junctions"), std::string::npos) << message;
  EXPECT_NE(message.find("--memory 32k"), std::string::npos) << message;
  EXPECT_TRUE(encode(model, *list, Memory::words_32k));
}

TEST(TurnTape, RejectsModelsThatTiltingMakesTooLarge) {
  scene::PolyScene scene = scene_named(cube);
  for (auto& vertex : scene.vertices)
    for (auto& coordinate : vertex) coordinate *= 300;
  EXPECT_FALSE(stand_on_axis(scene, true));
  EXPECT_TRUE(stand_on_axis(scene, false));
}

TEST(TurnTape, TiltedEdgesKeepTheirLengthsAndAngles) {
  const scene::PolyScene& standing = turned_model(cube).scene;
  const scene::PolyScene given = scene_named(cube);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j) {
      std::int64_t a = 0;
      std::int64_t b = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        a += std::int64_t{given.vertices[i][k]} * given.vertices[j][k];
        b += std::int64_t{standing.vertices[i][k]} * standing.vertices[j][k];
      }
      EXPECT_EQ(169 * a, b);
    }
}

}  // namespace
}  // namespace sightline::programs::turn
