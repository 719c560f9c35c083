// A traced search gives the same result as an untraced one, and reports as much as it has counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/trace.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/montani_re/trace.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/trace.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/trace.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/load.hpp"

namespace sightline {
namespace {

constexpr std::array<const char*, 6> scenes{"house", "roberts", "street4", "boxes-20", "bricks-6", "triangles-8"};

scene::PolyScene scene_named(const std::string& name) {
  auto found = scene::named_scene(name);
  return scene::load_scene(std::move(**found))->scene;
}

TEST(ExactTrace, ChangesNothing) {
  struct Counter final : algorithms::exact::Trace {
    void edge(const picture::LineEdge&) override { ++edges; }
    void compared(const picture::LineEdge&, std::uint32_t, std::span<const picture::LinePiece>) override { ++comparisons; }
    void result(const picture::LineEdge&, bool, std::span<const picture::LinePiece> seen) override { pieces += seen.size(); }
    std::size_t edges = 0, comparisons = 0, pieces = 0;
  };
  for (const char* const name : scenes) {
    const scene::PolyScene scene = scene_named(name);
    Counter counter;
    const auto traced = algorithms::exact::visible_edges(scene, scene.camera, counter);
    EXPECT_EQ(traced, algorithms::exact::visible_edges(scene, scene.camera)) << name;
    EXPECT_EQ(counter.pieces, traced.pieces.size()) << name;
    EXPECT_GT(counter.comparisons, 0U) << name;
  }
}

TEST(JonesTrace, ChangesNothing) {
  struct Counter final : algorithms::jones::Trace {
    void start(std::span<const scene::CellNumber>, bool) override { ++starts; }
    void entered(scene::CellNumber, std::uint32_t deep, std::span<const Plane>) override {
      ++visits;
      depth = std::max<std::uint64_t>(depth, deep);
    }
    void line(scene::VertexIndex, scene::VertexIndex, bool seen, double low, double high) override {
      ++lines;
      fragments += seen ? 1 : 0;
      if (seen) {
        EXPECT_LT(low, high);
      }
    }
    void portal(std::uint32_t, scene::CellNumber, algorithms::jones::PortalTest result, std::span<const Plane> mask) override {
      if (result == algorithms::jones::PortalTest::faces_away) return;
      ++tested;
      if (result != algorithms::jones::PortalTest::waits) return;
      ++masks;
      EXPECT_GE(mask.size(), 3U);
    }
    std::uint64_t starts = 0, visits = 0, depth = 0, lines = 0, fragments = 0, tested = 0, masks = 0;
  };
  for (const char* const name : scenes) {
    const scene::PolyScene scene = scene_named(name);
    const auto complex = scene::decompose(scene);
    ASSERT_TRUE(complex) << name;
    Counter counter;
    const auto traced = algorithms::jones::visible_edges(*complex, scene.camera, counter);
    const auto plain = algorithms::jones::visible_edges(*complex, scene.camera);
    ASSERT_TRUE(traced && plain) << name;
    EXPECT_EQ(traced->picture, plain->picture) << name;
    EXPECT_EQ(counter.starts, 1U);
    EXPECT_EQ(counter.visits, plain->counts.visits) << name;
    EXPECT_EQ(counter.depth, plain->counts.depth) << name;
    EXPECT_EQ(counter.lines, plain->counts.lines_clipped) << name;
    EXPECT_EQ(counter.fragments, plain->counts.fragments) << name;
    EXPECT_EQ(counter.tested, plain->counts.openings_tested) << name;
    EXPECT_EQ(counter.masks, plain->counts.masks) << name;
  }
}

TEST(SkalaTrace, ChangesNothing) {
  struct Counter final : algorithms::skala::Trace {
    void line(std::span<const algorithms::skala::Vertex> line, std::span<const algorithms::skala::Piece>) override {
      EXPECT_GE(line.size(), 2U);
      ++lines;
    }
    void row_ended(std::span<const float> top, std::span<const float> bottom) override {
      ++rows;
      ASSERT_EQ(top.size(), bottom.size());
      // The masks never shrink.
      for (std::size_t c = 0; c < before.size(); ++c) EXPECT_GE(top[c], before[c]);
      before.assign(top.begin(), top.end());
    }
    std::size_t lines = 0, rows = 0;
    std::vector<float> before;
  };
  for (const scene::HeightFunction& function : scene::height_functions()) {
    for (const auto family : {algorithms::skala::Family::automatic, algorithms::skala::Family::both}) {
      algorithms::skala::View view;
      view.rotation = 40;
      view.family = family;
      view.columns = 512;
      const scene::HeightGrid grid = scene::sample(function, {13, 9});
      Counter counter;
      const auto traced = algorithms::skala::draw(grid, view, counter);
      const auto plain = algorithms::skala::draw(grid, view);
      EXPECT_EQ(traced.points, plain.points) << function.name;
      EXPECT_EQ(traced.lines, plain.lines) << function.name;
      EXPECT_GE(counter.rows, 9U) << function.name;
      EXPECT_GT(counter.lines, 0U) << function.name;
    }
  }
}

TEST(MontaniReTrace, ChangesNothing) {
  struct Counter final : algorithms::montani_re::Trace {
    void faces(const algorithms::montani_re::FaceSet& set, bool) override { faces_ += set.faces.size(); }
    void related(const algorithms::montani_re::DepthRelations& found) override { relations += found.relations.size(); }
    void ranked(const algorithms::montani_re::PriorityClass& front, const algorithms::montani_re::PriorityClass& back) override {
      listed += front.size() + back.size();
      EXPECT_GT(front.size() + back.size(), 0U);
    }
    void cycle(const algorithms::montani_re::Relation&, bool cut) override { ++(cut ? cuts : spurious); }
    void subtracted(std::uint32_t, std::uint32_t, const algorithms::montani_re::TrapezoidPcs&) override { ++subtractions; }
    std::uint64_t faces_ = 0, relations = 0, listed = 0, cuts = 0, spurious = 0, subtractions = 0;
  };
  for (const char* const name : scenes) {
    const scene::PolyScene scene = scene_named(name);
    Counter counter;
    const auto traced = algorithms::montani_re::visible_edges(scene, scene.camera, &counter);
    const auto plain = algorithms::montani_re::visible_edges(scene, scene.camera);
    ASSERT_EQ(traced.has_value(), plain.has_value()) << name;
    if (!plain) continue;
    EXPECT_EQ(traced->picture, plain->picture) << name;
    EXPECT_EQ(counter.listed, counter.faces_) << name;
    EXPECT_EQ(counter.relations, plain->counts.relations) << name;
    EXPECT_EQ(counter.cuts, plain->counts.cuts) << name;
    EXPECT_EQ(counter.spurious, plain->counts.spurious) << name;
    EXPECT_GE(counter.subtractions, plain->counts.subtractions) << name;
  }
}

TEST(WillisTrace, ChangesNothing) {
  struct Counter final : algorithms::willis::Trace {
    void surfaces(std::span<const algorithms::willis::Surface> pieces, const algorithms::willis::OrderCells&) override { first = pieces.size(); }
    void clusters(std::span<const algorithms::willis::Surface> pieces, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) override {
      if (rounds++ == 0) clusters_ = pairs.size();
      last = pieces.size();
    }
    void cut(std::uint32_t, const std::array<algorithms::willis::Surface, 2>&, std::uint32_t) override { ++cuts; }
    std::size_t first = 0, last = 0, rounds = 0, clusters_ = 0, cuts = 0;
  };
  for (const char* const name : {"house", "roberts", "boxes-20", "bricks-4"}) {
    const scene::PolyScene scene = scene_named(name);
    Counter counter;
    const auto traced = algorithms::willis::make_model(scene, {}, &counter);
    const auto plain = algorithms::willis::make_model(scene);
    ASSERT_TRUE(traced && plain) << name;
    ASSERT_EQ(traced->pieces.size(), plain->pieces.size()) << name;
    for (std::size_t i = 0; i < plain->pieces.size(); ++i) EXPECT_EQ(traced->pieces[i].points, plain->pieces[i].points) << name;
    EXPECT_EQ(counter.clusters_, plain->clusters) << name;
    EXPECT_EQ(counter.first + counter.cuts, plain->pieces.size()) << name;
    EXPECT_EQ(counter.last, plain->pieces.size()) << name;
  }
}

namespace pl = algorithms::plantinga;

// Counts, and checks that the reports fit the model.
struct PlantingaCounter final : pl::Trace {
  explicit PlantingaCounter(const pl::RotationModel& m) : model(m), potentials(m.edges().size()) {}

  void scratch_begins(pl::EdgeIndex edge, std::span<const pl::Occluder> occluders) override {
    EXPECT_EQ(edge, scratched);
    EXPECT_EQ(occluders.size(), model.occluders_of(edge).size());
  }
  void scratch_covers(pl::EdgeIndex edge, pl::FaceIndex face, double low, double high) override {
    EXPECT_EQ(edge, scratched);
    EXPECT_LT(face, model.faces().size());
    EXPECT_TRUE(0 <= low && low < high && high <= 1) << low << ' ' << high;
    ++hidden;
  }
  void scratch_ends(pl::EdgeIndex edge, bool compared, const pl::EdgeStructure& left) override {
    EXPECT_EQ(edge, scratched);
    if (!compared) {
      EXPECT_TRUE(left.empty());
    }
    ++scratched;
    pieces += left.size();
  }
  void study_begins(pl::EdgeIndex edge, std::span<const pl::Occluder>) override {
    EXPECT_EQ(edge, studied);
    comparisons = changed = 0;
  }
  // The faces reported as edge-on are exactly edge-on.
  void potential(const pl::PotentialEvent& event) override {
    EXPECT_EQ(event.edge, studied);
    potentials[event.edge].push_back(event.direction);
    ++kinds[event.kind];
    if (event.kind == pl::EventKind::own_face || event.kind == pl::EventKind::face_edge_on) {
      ASSERT_LT(event.first, model.faces().size());
      EXPECT_EQ(pl::sign_at(event.direction, pl::form_of(model.faces()[event.first].normal)), 0);
    }
  }
  void dropped(pl::EventKind, pl::EdgeIndex edge) override { EXPECT_EQ(edge, studied); }
  void compared(pl::EdgeIndex edge, const pl::Direction&, const pl::EdgeStructure& before,
                const pl::EdgeStructure& after) override {
    EXPECT_EQ(edge, studied);
    ++comparisons;
    changed += before == after ? 0 : 1;
  }
  void study_ends(pl::EdgeIndex edge, const pl::EdgeHistory& history) override {
    EXPECT_EQ(edge, studied);
    EXPECT_EQ(comparisons, history.candidates);
    EXPECT_EQ(changed, history.changes.size());
    pl::sort_and_group(potentials[edge]);
    EXPECT_EQ(potentials[edge].size(), history.candidates);
    for (const pl::EdgeChange& change : history.changes)
      EXPECT_EQ(std::count(potentials[edge].begin(), potentials[edge].end(), change.direction), 1);
    changes += history.changes.size();
    ++studied;
  }

  const pl::RotationModel& model;
  std::vector<std::vector<pl::Direction>> potentials;
  std::map<pl::EventKind, std::size_t> kinds;
  std::size_t scratched = 0, hidden = 0, pieces = 0, studied = 0, comparisons = 0, changed = 0, changes = 0;
};

TEST(PlantingaTrace, ChangesNothing) {
  std::map<pl::EventKind, std::size_t> kinds;
  for (const char* const name : {"house", "roberts", "boxes-5", "bricks-4", "triangles-8", "town-3"}) {
    const scene::PolyScene scene = scene_named(name);
    const pl::RotationModel model(scene);
    PlantingaCounter counter(model);
    const pl::Sight sight{271, -314};
    const auto traced = pl::visible_edges(model, sight, counter);
    EXPECT_EQ(traced, pl::visible_edges(model, sight)) << name;
    EXPECT_EQ(traced, algorithms::exact::visible_edges(scene, pl::camera_of(sight))) << name;
    EXPECT_EQ(counter.scratched, model.edges().size()) << name;
    EXPECT_EQ(counter.pieces, traced.pieces.size()) << name;
    EXPECT_GT(counter.hidden, 0U) << name;

    pl::BuildOptions options;
    options.trace = &counter;
    const auto with = pl::build_event_list(model, options);
    const auto without = pl::build_event_list(model);
    ASSERT_TRUE(with && without) << name;
    EXPECT_EQ(with->first, without->first) << name;
    EXPECT_EQ(with->pieces, without->pieces) << name;
    ASSERT_EQ(with->events.size(), without->events.size()) << name;
    for (std::size_t i = 0; i < with->events.size(); ++i) {
      EXPECT_EQ(with->events[i].direction, without->events[i].direction) << name;
      EXPECT_EQ(with->events[i].change_count, without->events[i].change_count) << name;
    }
    EXPECT_EQ(counter.studied, model.edges().size()) << name;
    EXPECT_EQ(counter.changes, with->changes.size()) << name;
    for (const auto& [kind, count] : counter.kinds) kinds[kind] += count;
  }
  for (const pl::EventKind kind : {pl::EventKind::own_face, pl::EventKind::face_edge_on, pl::EventKind::vertex_in_front,
                                   pl::EventKind::vertex_behind, pl::EventKind::three_edges})
    EXPECT_GT(kinds[kind], 0U) << static_cast<int>(kind);
}

}  // namespace
}  // namespace sightline
