// The list of events and the graph that steps through it: every structure equals hidden-line removal from scratch, forwards and
// backwards; a turn closes; a faulty list is detected; limits and tolerance.
#include "host/algorithms/plantinga/event_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

EventList list_of(const RotationModel& model, double tolerance = 0) {
  BuildOptions options;
  options.tolerance = tolerance;
  auto built = build_event_list(model, options);
  if (built) return std::move(*built);
  ADD_FAILURE() << built.error().message();
  return {};
}

// The number of edges whose structure in the graph after its last event differs from that from scratch.
std::size_t wrong_edges(const RotationModel& model, const EventList& list, const EdgeStructureGraph& graph) {
  const std::size_t count = list.events.size();
  const Direction& before = list.events[(graph.passed() + count - 1) % count].direction;
  const Direction& after = list.events[graph.passed() % count].direction;
  std::size_t wrong = 0;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    wrong +=
        graph.structure_of(edge) == structure_between(model, edge, model.occluders_of(edge), before, after)
            ? 0U
            : 1U;
  }
  return wrong;
}

// A full turn, checked between every two events.
void expect_turn(const scene::PolyScene& scene) {
  const RotationModel model(scene);
  const EventList list = list_of(model);
  ASSERT_FALSE(list.events.empty());
  EdgeStructureGraph graph(list);
  for (std::size_t i = 0; i < list.events.size(); ++i) {
    ASSERT_EQ(wrong_edges(model, list, graph), 0U) << "after " << i << " events";
    ASSERT_TRUE(graph.step_forward());
  }
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    ASSERT_EQ(graph.structure_of(edge), list.first[edge]);
  }
  for (std::size_t i = 0; i < list.events.size(); ++i) ASSERT_TRUE(graph.step_backward());
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    ASSERT_EQ(graph.structure_of(edge), list.first[edge]);
  }
}

TEST(EventList, ATurnOfBoxes) {
  expect_turn(two_boxes());
  expect_turn(three_boxes());
  expect_turn(boxes_on_the_ground());
}

TEST(EventList, ATurnOfTriangles) {
  expect_turn(scene::generate_triangles(12, 3));
}

TEST(EventList, TurnsOfScenesWithManyContacts) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_turn(scene::generate_bricks(5, seed));
  expect_turn(scene::generate_touch(2));
}

// A solid with a notch (reflex vertices), and a frame with a hole and an object visible through it.
TEST(EventList, ATurnOfHolesAndNotches) {
  scene::PolyScene scene = two_boxes();
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  for (const scene::PolyPoint& p : {scene::PolyPoint{-90, -70, 95},
                                    {90, -70, 95},
                                    {90, 75, 95},
                                    {-90, 75, 95},
                                    {-40, -31, 95},
                                    {-43, 40, 95},
                                    {40, 38, 95},
                                    {44, -33, 95}}) {
    scene.vertices.push_back(p);
  }
  scene::PolyFace frame;
  frame.outline = {first, first + 1, first + 2, first + 3};
  frame.holes = {{first + 4, first + 5, first + 6, first + 7}};
  scene.bodies.push_back({"frame", true, {frame}});
  const auto arrow = static_cast<scene::VertexIndex>(scene.vertices.size());
  for (const scene::PolyPoint& p :
       {scene::PolyPoint{-70, -20, -90}, {60, -55, -90}, {0, 10, -90}, {66, 58, -90}}) {
    scene.vertices.push_back(p);
  }
  scene.bodies.push_back({"arrow", true, {scene::PolyFace{{arrow, arrow + 1, arrow + 2, arrow + 3}, {}}}});
  expect_turn(scene);
}

TEST(EventList, OneConvexSolidHasNoJunctions) {
  scene::PolyScene scene;
  add_brick(scene, {-60, -31, -17}, {{{50, 7, 11}, {-6, 61, 9}, {-13, -5, 47}}});
  const RotationModel model(scene);
  const EventList list = list_of(model);
  EXPECT_EQ(list.events.size(), 6U);  // three pairs of faces turn over, twice each
  for (const Piece& piece : list.pieces) {
    EXPECT_EQ(piece.low.kind(), EndKind::vertex);
    EXPECT_EQ(piece.high.kind(), EndKind::vertex);
  }
}

TEST(EventList, EveryEventChangesSomething) {
  const RotationModel model(three_boxes());
  const EventList list = list_of(model);
  for (const Event& event : list.events) {
    EXPECT_GT(event.direction.angle, -std::numbers::pi - 1e-15);
    EXPECT_LE(event.direction.angle, std::numbers::pi);
    for (const Change& change : list.changes_of(event)) {
      const auto removed = list.removed_by(change);
      const auto added = list.added_by(change);
      EXPECT_FALSE(std::equal(removed.begin(), removed.end(), added.begin(), added.end()));
    }
  }
}

TEST(EventList, TheResultDoesNotDependOnTheNumberOfThreads) {
  const RotationModel model(three_boxes());
  BuildOptions options;
  options.threads = 1;
  const auto one = *build_event_list(model, options);
  options.threads = 4;
  const auto four = *build_event_list(model, options);
  ASSERT_EQ(one.events.size(), four.events.size());
  EXPECT_EQ(one.first, four.first);
  EXPECT_EQ(one.pieces, four.pieces);
  for (std::size_t i = 0; i < one.events.size(); ++i) {
    EXPECT_EQ(one.events[i].direction, four.events[i].direction);
  }
}

// Mutation: without any one event a turn is impossible, or ends in another view than it began.
TEST(EventList, EveryRemovedEventIsDetected) {
  const RotationModel model(three_boxes());
  const EventList list = list_of(model);
  for (std::size_t lost = 0; lost < list.events.size(); ++lost) {
    EventList mutant = list;
    mutant.events.erase(mutant.events.begin() + static_cast<std::ptrdiff_t>(lost));
    EdgeStructureGraph graph(mutant);
    bool fits = true;
    for (std::size_t i = 0; i < mutant.events.size() && fits; ++i) fits = graph.step_forward();
    for (EdgeIndex edge = 0; edge < model.edges().size() && fits; ++edge) {
      fits = graph.structure_of(edge) == mutant.first[edge];
    }
    EXPECT_FALSE(fits) << "event " << lost;
    // Compared with from scratch, the error shows at once, right after the removed event.
    EdgeStructureGraph to_place(mutant);
    for (std::size_t i = 0; i < lost; ++i) ASSERT_TRUE(to_place.step_forward());
    std::size_t wrong = 0;
    const Direction& before = list.events[lost].direction;
    const Direction& after = list.events[(lost + 1) % list.events.size()].direction;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      wrong += to_place.structure_of(edge) ==
                       structure_between(model, edge, model.occluders_of(edge), before, after)
                   ? 0U
                   : 1U;
    }
    EXPECT_GT(wrong, 0U) << "event " << lost;
  }
}

// P20: steps of 30 degrees over many events, in both directions, from any position.
TEST(EventList, LargeSteps) {
  const RotationModel model(model_scene("grid"));
  const EventList list = list_of(model);
  EdgeStructureGraph graph(list);
  constexpr double degree = std::numbers::pi / 180;
  for (const double angle : {100.0, 130.0, 160.0, 190.0, 220.0, 100.0, -300.0, 17.5, 359.0, 1.0}) {
    ASSERT_TRUE(graph.turn_to(angle * degree));
    EXPECT_EQ(wrong_edges(model, list, graph), 0U) << angle;
  }
  std::vector<EdgeStructure> before;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) before.push_back(graph.structure_of(edge));
  for (int i = 1; i <= 12; ++i) ASSERT_TRUE(graph.turn_to((1 + 30 * i) * degree));
  for (int i = 11; i >= 0; --i) ASSERT_TRUE(graph.turn_to((1 + 30 * i) * degree));
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    EXPECT_EQ(graph.structure_of(edge), before[edge]);
  }
}

TEST(EventList, LimitsReturnThePartialResult) {
  const RotationModel model(three_boxes());
  BuildOptions options;
  options.threads = 1;
  options.most_changes = 20;
  auto built = build_event_list(model, options);
  ASSERT_FALSE(built);
  const std::string stopped = built.error().message();
  unsigned long edges_done = 0;
  unsigned long edges = 0;
  unsigned long changes = 0;
  ASSERT_EQ(std::sscanf(stopped.c_str(),
                        "more than 20 changes of edges: stopped after %lu of %lu edges with %lu changes",
                        &edges_done, &edges, &changes),
            3)
      << stopped;
  EXPECT_GT(changes, 20U);
  EXPECT_GT(edges_done, 0U);
  EXPECT_LT(edges_done, edges);
  EXPECT_EQ(edges, model.edges().size());
  options.most_changes = 1000000;
  options.most_pieces = 5;
  built = build_event_list(model, options);
  ASSERT_FALSE(built);
}

TEST(EventList, ProgressCountsEdges) {
  const RotationModel model(two_boxes());
  std::size_t calls = 0;
  std::size_t last = 0;
  BuildOptions options;
  options.progress = [&](std::size_t done, std::size_t of) {
    ++calls;
    EXPECT_EQ(done, last + 1);
    last = done;
    EXPECT_EQ(of, 24U);
  };
  ASSERT_TRUE(build_event_list(model, options));
  EXPECT_EQ(calls, 24U);
}

// With a tolerance there are fewer events; the structure is wrong only at angles within the tolerance after a true event.
TEST(EventList, ToleranceMovesEventsByLessThanItself) {
  const RotationModel model(three_boxes());
  const EventList fine = list_of(model);
  const double tolerance = 2 * std::numbers::pi / 180;
  const EventList coarse = list_of(model, tolerance);
  EXPECT_LT(coarse.events.size(), fine.events.size());
  EXPECT_LE(coarse.events.size(), 180U);
  EdgeStructureGraph fine_graph(fine);
  EdgeStructureGraph coarse_graph(coarse);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-std::numbers::pi, std::numbers::pi);
  int far = 0;
  int different = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle = any(random);
    ASSERT_TRUE(fine_graph.turn_to(angle));
    ASSERT_TRUE(coarse_graph.turn_to(angle));
    bool near = false;
    for (const Event& event : fine.events) {
      near = near || (angle >= event.direction.angle && angle < event.direction.angle + tolerance);
    }
    bool same = true;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      same = same && fine_graph.structure_of(edge) == coarse_graph.structure_of(edge);
    }
    EXPECT_TRUE(near || same) << angle;
    far += near ? 0 : 1;
    different += same ? 0 : 1;
  }
  EXPECT_GT(far, 100);
  EXPECT_GT(different, 100);  // the tolerance has an effect
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
