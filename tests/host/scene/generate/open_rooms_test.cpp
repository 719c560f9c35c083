// Rooms with doors: counts computed by hand, and that they are valid scenes.
#include "host/scene/generate/open_rooms.hpp"

#include <gtest/gtest.h>

#include <set>

#include "host/scene/check/cell_scene.hpp"

namespace sightline::scene {
namespace {

// Four rooms have four walls between them. Of five doors one wall has two, the others one each. A wall with n doors is a lintel
// and n + 1
// piers.
TEST(OpenRooms, FiveDoorsInFourWalls) {
  ASSERT_EQ(walls_between_rooms(2), 4U);
  const CellScene scene = generate_open_rooms(2, 5, 7);
  EXPECT_EQ(scene.cells.size(), 4U);
  EXPECT_EQ(scene.openings.size(), 5U);
  EXPECT_EQ(scene.walls.size(), 4U + 3 * 2 + 3);  // lintels, piers
  std::multiset<std::array<std::size_t, 2>> between;
  for (const Opening& opening : scene.openings) between.insert(opening.cells);
  for (const auto& pair : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 3}, {2, 3}}) {
    EXPECT_GE(between.count(pair), 1U);
    EXPECT_LE(between.count(pair), 2U);
  }
}

// Two doors: their middles are at a quarter and three quarters of 400.
TEST(OpenRooms, DoorsAreEvenlySpaced) {
  const CellScene scene = generate_open_rooms(2, 8);
  const auto& first = scene.openings.at(0).place;
  const auto& second = scene.openings.at(1).place;
  ASSERT_EQ(first.axis, 0U);
  EXPECT_EQ(first.at, 400);
  EXPECT_EQ(first.sides[0], (geometry::Span{0, 210}));
  EXPECT_EQ(first.sides[1], (geometry::Span{80, 120}));
  EXPECT_EQ(second.sides[1], (geometry::Span{280, 320}));
}

TEST(OpenRooms, AreValidScenes) {
  for (const std::size_t rooms : {1U, 2U, 3U}) {
    const std::size_t walls = walls_between_rooms(rooms);
    for (const std::size_t doors : {std::size_t{0}, walls / 2, walls, 3 * walls + 1, most_doors * walls}) {
      if (doors > most_doors * walls) continue;
      const CellScene scene = generate_open_rooms(rooms, doors, 3);
      EXPECT_EQ(scene.openings.size(), doors);
      const auto errors = check_scene(scene);
      EXPECT_TRUE(errors.empty()) << rooms << " rooms a side, " << doors
                                  << " doors: " << errors.front().message();
    }
  }
}

TEST(OpenRooms, TheSeedSelectsTheWalls) {
  EXPECT_EQ(generate_open_rooms(3, 5, 1), generate_open_rooms(3, 5, 1));
  const CellScene one = generate_open_rooms(3, 5, 1);
  CellScene other = generate_open_rooms(3, 5, 2);
  other.name = one.name;
  EXPECT_NE(one, other);
}

}  // namespace
}  // namespace sightline::scene
