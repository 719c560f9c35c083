// The six models of Plantinga, Seales and Dyer through a full turn: the structure from the list of events equals that from
// scratch,
// between every two events of the small models and at ten thousand directions of the large ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

// After each event: edges that have just changed or are about to change, and random ones; about `samples` in all.
void expect_turn(const std::string& name, std::size_t samples) {
  const RotationModel model(model_scene(name));
  auto built = build_event_list(model);
  ASSERT_TRUE(built);
  const EventList& list = *built;
  EdgeStructureGraph graph(list);
  std::mt19937 random(1990);
  const std::size_t count = list.events.size();
  const double each = samples == 0 ? 0 : static_cast<double>(samples) / static_cast<double>(count);
  double due = 0;
  std::size_t done = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(graph.step_forward());
    const Event& before = list.events[i];
    const Event& after = list.events[(i + 1) % count];
    const auto check = [&](EdgeIndex edge) {
      ++done;
      ASSERT_EQ(graph.structure_of(edge),
                structure_between(model, edge, model.occluders_of(edge), before.direction, after.direction))
          << name << " after event " << i << ", edge " << edge;
    };
    if (samples == 0) {
      for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) check(edge);
      continue;
    }
    for (due += each; due >= 1; due -= 1) {
      const auto changes = list.changes_of(random() % 2 != 0 ? before : after);
      check(random() % 3 == 0 ? static_cast<EdgeIndex>(random() % model.edges().size())
                              : changes[random() % changes.size()].edge);
    }
  }
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    ASSERT_EQ(graph.structure_of(edge), list.first[edge]) << name;
  }
  EXPECT_GE(done, samples == 0 ? count * model.edges().size() : samples - 1);
}

TEST(ModelTurns, Squares) {
  expect_turn("squares", 0);
}
TEST(ModelTurns, Grid) {
  expect_turn("grid", 0);
}
TEST(ModelTurns, Objects) {
  expect_turn("objects", 10000);
}
TEST(ModelTurns, Bars) {
  expect_turn("bars", 10000);
}
TEST(ModelTurns, Tori) {
  expect_turn("tori", 10000);
}
TEST(ModelTurns, Spring) {
  expect_turn("spring", 10000);
}

// (X : Z) to (X : -Z).
Direction mirror(const Direction& direction) {
  if (direction.rational) return rational_direction(direction.form.xx, -direction.form.zz);
  const auto roots = roots_of(QuadraticForm{direction.form.xx, -direction.form.xz, direction.form.zz});
  const auto away = [&](const Direction& root) {
    return std::abs(std::remainder(root.angle - (std::numbers::pi - direction.angle), 2 * std::numbers::pi));
  };
  return *std::min_element(roots.begin(), roots.end(),
                           [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

// Tori is its own mirror image. Of equal crossings the lowest edge is named, which is not the same edge in the mirror image. So
// only
// events at which an edge gains or loses a piece must have exact mirror images.
TEST(PlantingaHardCases, P18AMirrorImageHasMirroredEvents) {
  const RotationModel model(model_scene("tori"));
  const auto built = build_event_list(model);
  const EventList& list = *built;
  for (const Event& event : list.events) {
    const auto changes = list.changes_of(event);
    if (std::all_of(changes.begin(), changes.end(), [&](const Change& change) {
          return list.added_by(change).size() == list.removed_by(change).size();
        }))
      continue;
    const Direction wanted = mirror(event.direction);
    const auto found =
        std::lower_bound(list.events.begin(), list.events.end(), wanted,
                         [](const Event& e, const Direction& d) { return less(e.direction, d); });
    ASSERT_TRUE(found != list.events.end() && found->direction == wanted) << event.direction.angle;
  }
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
