// Words and source tapes of scenes: sizes, formats read back by an independent decoder, and the tapes in files.
#include "host/programs/jones/encode.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "host/base/result.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/approve.hpp"

namespace sightline::programs::jones {
namespace {

using geometry::Point;

EncodedScene encode_default(const scene::CellScene& scene, std::optional<Point> eye = {}, std::uint32_t base = 0) {
  auto result = encode(scene, eye, base);
  if (!result) {
    ADD_FAILURE() << result.error().message();
    return {};
  }
  return *result;
}

// The sizes measured with the prototype of the specification.
TEST(Encode, TakesTheWordsOfTheSpecification) {
  const std::map<std::string_view, std::pair<std::size_t, std::size_t>> expected{{"house", {71, 30}},
                                                                                 {"roberts", {153, 313}},
                                                                                 {"street4", {376, 796}},
                                                                                 {"corridor8", {194, 70}},
                                                                                 {"corridor32", {794, 310}}};
  for (const auto& [name, words] : expected) {
    const EncodedScene result = encode_default(scene::builtin_scene(name));
    EXPECT_EQ(result.cell_words, words.first) << name;
    EXPECT_EQ(result.opening_words, words.second) << name;
    EXPECT_EQ(result.words.size(), words.first + words.second + scene_header_words) << name;
  }
}

// Reads elements as the program does, from core words alone.
class Core {
 public:
  Core(const EncodedScene& scene) : base_(scene.base) {
    for (const EncodedWord& word : scene.words) words_.push_back(word.value);
  }
  std::uint32_t operator[](std::uint32_t address) const { return words_.at(address - base_); }
  std::int32_t number(std::uint32_t address) const {
    const auto word = static_cast<std::int32_t>((*this)[address]);
    return word >= 0400000 ? word - 01000000 : word;
  }
  Point point(std::uint32_t a) const { return {number(a), number(a + 1), number(a + 2)}; }

  struct Vectors {
    std::vector<std::pair<Point, Point>> actual;
    Point end;
    std::uint32_t next;  // address after the last vector
    std::size_t count;
  };
  // X Y Z n and its vectors at `address`.
  Vectors vectors(std::uint32_t address) const {
    Vectors result{{}, point(address), address + 4, static_cast<std::size_t>(number(address + 3))};
    for (std::size_t n = 0; n < result.count; ++n) {
      const std::uint32_t word = (*this)[result.next++];
      const std::uint32_t field = word & 077777;
      const std::int32_t magnitude = static_cast<std::int32_t>(field) - (field >= 040000 ? 0100000 : 0);
      const std::size_t axis = (word >> 15 & 3U) - 1;
      const Point from = result.end;
      result.end.at(axis) += magnitude;
      if (word >> 17) result.actual.emplace_back(from, result.end);
    }
    return result;
  }

 private:
  std::uint32_t base_;
  std::vector<std::uint32_t> words_;
};

using Ends = std::pair<Point, Point>;
Ends ordered(const Point& a, const Point& b) {
  return a < b ? Ends{a, b} : Ends{b, a};
}

TEST(Encode, ElementsReadBackAsTheScene) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = scene::builtin_scene(name);
    const EncodedScene result = encode_default(scene, {}, 04000);
    const Core core(result);
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
      const auto chain = core.vectors(result.cell_addresses[c]);
      std::multiset<Ends> drawn;
      std::multiset<Ends> given;
      for (const auto& [from, to] : chain.actual) drawn.insert(ordered(from, to));
      for (const scene::Line& line : scene.cells[c].lines) given.insert(ordered(line.from, line.to));
      EXPECT_EQ(drawn, given) << name << " cell " << c;

      std::set<std::uint32_t> neighbours;
      std::set<std::uint32_t> expected;
      for (std::uint32_t entry = chain.next;; ++entry) {
        const std::uint32_t address = core[entry] & 017777;
        if (address != 0) neighbours.insert(core[address] & 017777);
        if (core[entry] & 0400000) break;
      }
      for (const scene::Opening& o : scene.openings) {
        if (o.cells[0] == c) expected.insert(result.cell_addresses[o.cells[1]]);
        if (o.cells[1] == c) expected.insert(result.cell_addresses[o.cells[0]]);
      }
      EXPECT_EQ(neighbours, expected) << name << " cell " << c;
    }
  }
}

TEST(Encode, OpeningsFollowTheFormat) {
  const scene::CellScene scene = scene::builtin_scene("street4");
  const EncodedScene result = encode_default(scene, {}, 02000);
  const Core core(result);
  for (std::size_t o = 0; o < scene.openings.size(); ++o) {
    const std::uint32_t at = result.opening_addresses[o];
    EXPECT_EQ(core[at], 0400000 | result.cell_addresses[scene.openings[o].cells[0]]);
    EXPECT_EQ(core[at + 1], result.cell_addresses[scene.openings[o].cells[1]]);
    const auto ring = core.vectors(at + 2);
    EXPECT_EQ(core.point(at + 2), scene.openings[o].ring[0]);
    EXPECT_EQ(ring.end, scene.openings[o].ring[0]) << "the ring closes";
    EXPECT_EQ(ring.count, scene.openings[o].vectors.size());
  }
}

// The house by hand: living room limits x 1..599, y 1..249, z 1..399.
TEST(Encode, HeaderHoldsTheEyeAndItsLimits) {
  const EncodedScene result = encode_default(scene::builtin_scene("house"), {}, 01000);
  const std::vector<std::uint32_t> expected{01013, 3, 480, 160, 20, 1, 599, 1, 249, 1, 399};
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_EQ(result.words[n].value, expected[n]) << n;
  const EncodedScene kitchen = encode_default(scene::builtin_scene("house"), Point{100, 100, 500}, 01000);
  EXPECT_EQ(kitchen.view.cell, 1U);
  EXPECT_EQ(kitchen.words[0].value, kitchen.cell_addresses[1]);
  EXPECT_EQ(kitchen.words[9].value, 401U);
  EXPECT_EQ(kitchen.words[10].value, 749U);
}

TEST(Encode, ListEntriesPointToTheWordNamingTheFarCell) {
  const EncodedScene house = encode_default(scene::builtin_scene("house"));
  const Core core(house);
  const auto list_of = [&](std::size_t cell) { return core.vectors(house.cell_addresses[cell]).next; };
  EXPECT_EQ(core[list_of(0)], house.opening_addresses[0] + 1);
  EXPECT_EQ(core[list_of(0) + 1], 0400000 | (house.opening_addresses[1] + 1));
  EXPECT_EQ(core[list_of(1)], house.opening_addresses[0]);
  EXPECT_EQ(core[list_of(1) + 1], 0400000 | (house.opening_addresses[2] + 1));
}

scene::CellScene one_room(std::int32_t depth) {
  scene::CellScene scene;
  scene.name = "room";
  scene.outer = {{0, 0, 0}, {100, 100, depth}};
  scene.cells = {{scene.outer, {}}};
  scene.default_view = {50, 50, 10};
  return scene;
}

TEST(Encode, ACellWithoutLinesAndOpeningsIsFiveWords) {
  const EncodedScene result = encode_default(one_room(100));
  EXPECT_EQ(result.cell_words, 5U);
  EXPECT_EQ(result.words.back().value, 0400000U);
}

TEST(Encode, SplitsVectorsThatAWordCannotHold) {
  scene::CellScene scene = one_room(32767);
  scene.cells[0].lines = {{{0, 0, 32767}, {0, 0, 0}}, {{100, 0, 32767}, {100, 100, 32767}}};
  const EncodedScene result = encode_default(scene);
  const auto chain = Core(result).vectors(result.cell_addresses[0]);
  // the line: -16383 twice and -1; the way to the next: i, then k in three; the line
  EXPECT_EQ(chain.count, 3U + 1 + 3 + 1);
  EXPECT_EQ(chain.end, (Point{100, 100, 32767}));
  EXPECT_EQ(chain.actual.size(), 4U);
  EXPECT_EQ(result.words[scene_header_words + 4].value, 0740001U) << "F, k, -16383";
}

std::string refusal(const scene::CellScene& scene, std::optional<Point> eye, std::uint32_t base = 0) {
  const auto result = encode(scene, eye, base);
  return !result ? result.error().message() : "encoded";
}

TEST(Encode, RejectsAnEyeThatSeesThroughTheNearPlane) {
  const scene::CellScene house = scene::builtin_scene("house");
  EXPECT_EQ(
      refusal(house, Point{100, 100, 400}),
      "point (100, 100, 400): is too close to the faces of cell 0: expected x 1..599, y 1..249, z 1..399");
  EXPECT_EQ(refusal(house, Point{100, 100, 399}), "encoded");
  EXPECT_EQ(refusal(house, Point{0, 100, 20}),
            "point (0, 100, 20): is too close to the faces of cell 0: expected x 1..599, y 1..249, z 1..399");
  EXPECT_EQ(refusal(house, Point{0, 100, -20}), "point (0, 100, -20): is outside the outer box");
}

TEST(Encode, RejectsScenesThatDoNotFitIntoCore) {
  const scene::CellScene house = scene::builtin_scene("house");  // 112 words
  EXPECT_EQ(refusal(house, {}, 017620), "encoded");
  EXPECT_EQ(refusal(house, {}, 017621), "needs 112 words from address 017621; core ends at 017777");
  EXPECT_EQ(refusal(house, {}, 0777777), "needs at least 96 words from address 777777; core ends at 017777");
}

// Reads a source tape as a minimal assembler does: tags, octal numbers, +, / comments.
std::vector<std::uint32_t> assemble(const std::string& tape, std::uint32_t base) {
  std::map<std::string, std::uint32_t> symbols;
  std::vector<std::uint32_t> words;
  for (const bool second_pass : {false, true}) {
    std::istringstream lines(tape);
    std::uint32_t address = base;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream tokens(line.substr(0, line.find('/')));
      for (std::string token; tokens >> token;) {
        if (token.back() == ',') {
          token.pop_back();
          symbols[token] = address;
          continue;
        }
        std::uint32_t value = 0;
        std::istringstream terms(token);
        for (std::string term; second_pass && std::getline(terms, term, '+');) {
          const bool numeric = term.find_first_not_of("01234567") == std::string::npos;
          value += numeric ? static_cast<std::uint32_t>(std::stoul(term, nullptr, 8)) : symbols.at(term);
        }
        if (second_pass) words.push_back(value);
        ++address;
      }
    }
  }
  return words;
}

TEST(WriteTape, AssemblesToTheEncodedWords) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = scene::builtin_scene(name);
    const auto tape = *write_tape(scene);
    EXPECT_EQ(tape[0], '/');
    std::vector<std::uint32_t> expected;
    for (const EncodedWord& word : encode_default(scene, {}, 03456).words) expected.push_back(word.value);
    EXPECT_EQ(assemble(tape, 03456), expected) << name;
  }
}

TEST(WriteTape, EqualsTheTapeOfTheFirmware) {
  const std::string path = SIGHTLINE_SOURCE_DIR "/firmware/pdp7/jones/scenes/house.s";
  const auto tape = *write_tape(scene::builtin_scene("house"));
  if (tests::approving()) {
    EXPECT_TRUE(tests::write_whole(path, tape)) << path;
  }
  const std::string approved = tests::read_whole(path);
  EXPECT_TRUE(tape == approved) << path << ": " << tests::first_difference(approved, tape)
                                << "\n  SIGHTLINE_APPROVE=1 writes the new tape, if the change is intended";
}

}  // namespace
}  // namespace sightline::programs::jones
