// Flights through prisms and towns: guest and twin, order compared with exact distances, pictures, and the cost model of
// NOTES.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/programs/flight/path.hpp"
#include "host/programs/flight/flight.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "tests/host/programs/flight/flight_support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::flight {
namespace {

namespace willis = algorithms::willis;

constexpr std::array all_precisions{Precision::bits_8, Precision::bits_12, Precision::bits_16};

struct Flight {
  std::string name;
  scene::PolyScene scene;
  std::vector<scene::PolyCamera> path;
  willis::Model model;
};

Flight flight_through(const std::string& name, scene::PolyScene scene, bool plan, std::uint32_t frames, std::optional<std::size_t> pieces = {}) {
  const auto path = path_through(scene, scene::frame_of(scene.camera), frames, plan);
  EXPECT_TRUE(path) << name;
  willis::ModelOptions options;
  options.plan = plan;
  auto model = flight_model(scene, options, path->front().eye, pieces);
  EXPECT_TRUE(model) << name << ": " << (model ? "" : model.error().message());
  return {name, std::move(scene), *path, std::move(*model)};
}

std::uint32_t frames() { return tests::effort(100U, 10U); }

const std::vector<Flight>& all() {
  static const std::vector<Flight> made = [] {
    std::vector<Flight> list;
    list.push_back(flight_through("town-10", scene::generate_town(10), false, frames()));
    list.push_back(flight_through("town-20", scene::generate_town(20), false, frames()));
    list.push_back(flight_through("prisms-10", scene::generate_prisms(10), true, frames()));
    list.push_back(flight_through("prisms-25", scene::generate_prisms(25), true, frames()));
    return list;
  }();
  return made;
}

// Runs the flight with all checks; it must be complete.
Outcome fly(const Flight& flight, Precision precision, bool count_points = false,
              std::function<void(std::uint32_t frame, std::span<const std::uint32_t> picture)> picture = {}) {
  auto outcome = run({.model = flight.model, .path = flight.path, .precision = precision, .count_points = count_points, .check = true,
                      .picture = std::move(picture)});
  EXPECT_TRUE(outcome) << flight.name << ": " << (outcome ? "" : outcome.error().message());
  return outcome ? *outcome : Outcome{};
}

TEST(Flight, EqualsTheTwinInEveryPriorityOfEveryFrame) {
  for (const Flight& flight : all()) {
    for (const Precision precision : all_precisions) {
      const Outcome outcome = fly(flight, precision);
      EXPECT_EQ(outcome.flight.status, Status::complete) << flight.name;
      EXPECT_EQ(outcome.frames.size(), flight.path.size()) << flight.name;
    }
  }
}

// Through the scene, but not inside a building.
TEST(Flight, StaysInFreeSpace) {
  for (const Flight& flight : all())
    for (const scene::PolyCamera& camera : flight.path) EXPECT_FALSE(scene::eye_error(flight.scene, camera)) << flight.name;
}

// The error that pack() states: pieces whose distances differ by more are in the order of their true distances.
TEST(Flight, OrdersDistancesThatDifferByMoreThanTheStatedError) {
  for (const Flight& flight : all()) {
    for (const Precision precision : all_precisions) {
      const Outcome run = fly(flight, precision);
      const Packed& packed = run.packed;
      for (std::size_t i = 0; i < run.flight.frames.size(); ++i) {
        willis::Point eye = willis::on_lattice(flight.path[i].eye);
        if (flight.model.plan) eye[flight.model.vertical] = 0;
        struct Piece {
          int priority;
          double distance;
        };
        std::vector<Piece> pieces;
        for (std::size_t p = 0; p < flight.model.pieces.size(); ++p)
          pieces.push_back({run.flight.frames[i].priorities[p + 1],
                            std::sqrt(static_cast<double>(willis::squared_distance(eye, flight.model.pieces[p].points[0]))) / willis::lattice_unit});
        std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.priority > b.priority; });
        double farthest = 0;
        for (const Piece& piece : pieces) {
          ASSERT_GE(piece.distance, farthest - packed.error_in_units * (1 + 1e-9)) << flight.name << ", frame " << i;
          farthest = std::max(farthest, piece.distance);
        }
      }
    }
  }
}

// More bits give fewer wrong orders; the display shows the same as with the exact order, except for the points counted as wrong.
TEST(Flight, CountsWrongOrdersAgainstExactOnes) {
  std::vector<Flight> flights;
  flights.push_back(flight_through("town-20", scene::generate_town(20), false, tests::effort(25U, 3U)));
  flights.push_back(flight_through("prisms-25", scene::generate_prisms(25), true, tests::effort(25U, 3U)));
  for (const Flight& flight : flights) {
    std::vector<std::uint64_t> wrong;
    for (const Precision precision : all_precisions) {
      std::vector<std::uint64_t> other_points(flight.path.size());
      willis::Frames exact(flight.model);
      const auto compare_picture = [&](std::uint32_t frame, std::span<const std::uint32_t> picture) {
        const auto window = willis::window_ahead(flight.path[frame], 512, 512, 60);
        willis::FrameSpans spans;
        willis::make_spans(flight.model, exact.order(flight.path[frame]), flight.path[frame], window, spans);
        const auto faces = willis::resolve_priorities(spans, window);
        for (int row = 0; row < 512; ++row)
          for (int column = 0; column < 512; ++column)
            other_points[frame] += faces.values[faces.index(column, row)] != picture[static_cast<std::size_t>(511 - row) * 512 + static_cast<std::size_t>(column)] ? 1 : 0;
      };
      const Outcome run = fly(flight, precision, true, compare_picture);
      for (std::size_t i = 0; i < run.frames.size(); ++i)
        ASSERT_EQ(other_points[i], run.frames[i].wrong_points) << flight.name << ", frame " << i;
      wrong.push_back(run.summary.wrong_orders);
    }
    EXPECT_GE(wrong[0], wrong[1]) << flight.name;
    EXPECT_GE(wrong[1], wrong[2]) << flight.name;
    EXPECT_LT(static_cast<double>(wrong[2]), 1e-4 * static_cast<double>(flight.model.pieces.size() * flight.model.pieces.size() * flight.path.size())) << flight.name;
  }
}

TEST(Flight, CostsAsMuchAsTheModelStates) {
  for (const Flight& flight : all()) {
    for (const Precision precision : all_precisions) {
      const Outcome run = fly(flight, precision);
      const Packed& packed = run.packed;
      for (std::size_t i = 1; i < run.frames.size(); ++i) {
        const auto measured = static_cast<double>(run.frames[i].computing.count());
        const double predicted = predicted_t_states(packed, run.frames[i]);
        EXPECT_NEAR(predicted / measured, 1, 0.1) << flight.name << ", precision " << static_cast<int>(precision) << ", frame " << i << ": " << measured;
      }
    }
  }
}

// 100 pieces; the paper requires 25 frames per second.
TEST(Flight, IsFastEnough) {
  const Flight flight = flight_through("town-20", scene::generate_town(20), false, frames(), 100);
  ASSERT_EQ(flight.model.pieces.size(), 100U);
  for (const Precision precision : all_precisions) {
    const Outcome run = fly(flight, precision);
    EXPECT_GE(run.summary.frames_per_second_worst, precision == Precision::bits_16 ? 12.49 : 24.99);
  }
}

TEST(Flight, ReportsWhatDoesNotFit) {
  const scene::PolyScene large = scene::generate_town(60);
  const auto model = flight_model(large, {}, large.camera.eye);
  ASSERT_FALSE(model);
  const std::string text = model.error().message();
  EXPECT_NE(text.find("more than the machine holds"), std::string::npos) << text;
  EXPECT_NE(text.find("is cut into most of them"), std::string::npos) << text;
  const auto all_pieces = willis::make_model(large);
  ASSERT_TRUE(all_pieces);
  EXPECT_EQ(text.find(std::to_string(all_pieces->pieces.size()) + " pieces, " + std::to_string(all_pieces->pieces.size() - most_pieces) + " more"), 0U) << text;
  const auto some = flight_model(large, {}, large.camera.eye, 40);
  ASSERT_TRUE(some);
  EXPECT_EQ(some->pieces.size(), 40U);
}

// Touching solids, and a non-convex one: planes separate them, and the order equals that of willis::Frames except for rounded
// distances.
TEST(Flight, SeparatesTouchingSolids) {
  std::vector<Flight> flights;
  flights.push_back(flight_through("touch-2", scene::generate_touch(2), false, tests::effort(40U, 5U)));
  flights.push_back(flight_through("roberts", scene::poly_scene_of(*scene::load_cell_scene("roberts")), false, tests::effort(40U, 5U)));
  for (const Flight& flight : flights) {
    ASSERT_GT(flight.model.cells.cells, 2U) << flight.name;
    EXPECT_EQ(flight.model.residual.size(), 0U) << flight.name;
    for (const Precision precision : all_precisions) {
      const Outcome run = fly(flight, precision, true);
      const Packed& packed = run.packed;
      ASSERT_GT(packed.planes, 0U) << flight.name;
      if (precision == Precision::bits_16) {
        EXPECT_EQ(run.summary.wrong_orders, 0U) << flight.name;
        EXPECT_EQ(run.summary.wrong_points, 0U) << flight.name;
      }
      for (std::size_t i = 1; i < run.frames.size(); ++i) {
        const auto measured = static_cast<double>(run.frames[i].computing.count());
        const double predicted = predicted_t_states(packed, run.frames[i]);
        EXPECT_NEAR(predicted / measured, 1, 0.1) << flight.name << ", precision " << static_cast<int>(precision) << ", frame " << i << ": " << measured;
      }
      RecordProperty(flight.name + "_" + std::to_string(static_cast<int>(precision)),
                     std::to_string(flight.model.pieces.size()) + " pieces " + std::to_string(packed.planes) + " planes, wrong " +
                         std::to_string(run.summary.wrong_orders) + " of " + std::to_string(run.summary.pairs) + ", T " + std::to_string(run.summary.t_states_mean));
    }
  }
}

TEST(Flight, ACheckedRunOfAWrongProgramFails) {
  const auto plan = plan_flight(scene::generate_town(10), false, 5);
  ASSERT_TRUE(plan) << plan.error().message();
  expect_wrong_programs_fail({.model = plan->model, .path = plan->path, .check = true}, 100, tests::effort(61U, 401U));
}

}  // namespace
}  // namespace sightline::programs::flight
