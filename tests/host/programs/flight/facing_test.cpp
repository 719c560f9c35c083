// The build with the facing test: the guest compared with its twin, its reaction to bad streams, and the pieces of the order
// compared with those that face the eye by exact arithmetic on the scene.
//
// SIGHTLINE_FLIGHTS=10 in the environment makes the random flights ten times as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "host/programs/flight/check.hpp"
#include "host/programs/flight/flight.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "tests/host/programs/flight/flight_support.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::flight {
namespace {

using jones::Dice;
using Coordinates = std::vector<std::uint32_t>;
namespace willis = algorithms::willis;

constexpr std::array precisions{Precision::bits_8, Precision::bits_12, Precision::bits_16};

const Program& program() { return resident_program(true); }

struct Entry {
  std::uint32_t limit = 0;
  int piece = 0;
  bool faces_beyond = false;
};

struct Stream {
  Precision precision = Precision::bits_8;
  std::vector<Coordinates> points;      // of pieces, then of planes, the origin and the directions
  std::vector<std::uint8_t> places;     // of planes
  std::vector<std::uint8_t> cells;      // of pieces
  std::vector<std::vector<Entry>> directions;
  std::vector<Coordinates> eyes;

  [[nodiscard]] std::vector<std::uint8_t> bytes() const {
    const std::size_t planes = places.size() / 3;
    StreamWriter writer(precision, points[0].size(), points.size() - 2 * planes - 1 - directions.size(), planes, directions.size());
    for (std::size_t i = points.size(); i > 0; --i) writer.point(points[i - 1]);
    for (const std::uint8_t place : places) writer.place(place);
    for (std::size_t i = cells.size(); i > 0; --i) writer.place(cells[i - 1]);
    for (const std::vector<Entry>& entries : directions) {
      writer.direction(entries.size());
      for (const Entry& entry : entries) writer.entry(entry.limit, static_cast<std::uint8_t>(entry.piece), entry.faces_beyond);
    }
    writer.check();
    for (const Coordinates& eye : eyes) writer.eye(eye);
    return writer.end();
  }
};

std::vector<int> priorities_of(const MachineFrame& frame, std::size_t pieces) {
  return {frame.priorities.begin() + 1, frame.priorities.begin() + 1 + static_cast<std::ptrdiff_t>(pieces)};
}

std::string difference_of(const std::vector<std::uint8_t>& stream) { return difference_from_twin(run_machine(program(), stream), run_twin(stream, true)); }

// By hand. One direction along x from (100, 0) to (103, 0): an eye at x has the value 6 (x - 100) - 9. Pieces 1 and 2 are seen
// from beyond x = 90 and 110, so their limits are those of 90 and 110; 3 and 4 from before 90 and 110.
Stream street(Precision precision) {
  const std::uint32_t zero = precision == Precision::bits_8 ? 0x8000U : precision == Precision::bits_12 ? 0x80'0000U : 0x8000'0000U;
  Stream stream;
  stream.precision = precision;
  stream.points = {{90, 0}, {110, 0}, {90, 10}, {110, 10}, {100, 0}, {103, 0}};
  stream.directions = {{{zero - 69, 1, true}, {zero - 69, 3, false}, {zero + 51, 2, true}, {zero + 51, 4, false}}};
  stream.eyes = {{80, 0}, {90, 0}, {91, 0}, {110, 3}, {111, 3}, {120, 8}, {100, 8}, {80, 0}};
  return stream;
}

TEST(FlightFacing, OnlyPiecesThatFaceTheEyeGetAPriority) {
  for (const Precision precision : precisions) {
    const auto stream = street(precision).bytes();
    const MachineFlight flight = run_machine(program(), stream);
    ASSERT_EQ(flight.status, Status::complete) << text_of(flight.status);
    ASSERT_EQ(flight.frames.size(), 8U);
    EXPECT_EQ(priorities_of(flight.frames[0], 4), (std::vector<int>{0, 0, 4, 3}));
    EXPECT_EQ(priorities_of(flight.frames[1], 4), (std::vector<int>{0, 0, 4, 3}));  // in the plane of 1 and 3: not passed
    EXPECT_EQ(priorities_of(flight.frames[2], 4), (std::vector<int>{4, 0, 0, 3}));
    EXPECT_EQ(priorities_of(flight.frames[3], 4), (std::vector<int>{3, 0, 0, 4}));
    EXPECT_EQ(priorities_of(flight.frames[4], 4), (std::vector<int>{3, 4, 0, 0}));
    EXPECT_EQ(priorities_of(flight.frames[5], 4), (std::vector<int>{3, 4, 0, 0}));
    // 4 comes back, at distance sqrt(104); 1 is at sqrt(164).
    EXPECT_EQ(priorities_of(flight.frames[6], 4), (std::vector<int>{3, 0, 0, 4}));
    EXPECT_EQ(priorities_of(flight.frames[7], 4), (std::vector<int>{0, 0, 4, 3}));
    EXPECT_EQ(flight.frames[0].listed, 2U);
    EXPECT_EQ(flight.frames[2].turned, (Turned{1, 1, 0}));
    EXPECT_EQ(flight.frames[4].turned, (Turned{1, 1, 0}));
    EXPECT_EQ(flight.frames[6].turned, (Turned{1, 1, 0}));
    EXPECT_EQ(flight.frames[7].turned, (Turned{1, 1, 0}));
    EXPECT_EQ(flight.writes_lost, 0U);
    EXPECT_EQ(difference_of(stream), "");
  }
}

// Pieces at one point: those that come to face the eye are put in front, the last one found first, and keep that order.
TEST(FlightFacing, APieceThatAppearsIsBeforeThoseWithTheSameKey) {
  Stream stream;
  stream.points = {{50, 50}, {50, 50}, {50, 50}, {50, 50}, {100, 0}, {101, 0}};
  stream.directions = {{{0x8000 - 61, 2, true}, {0x8000 - 41, 3, true}, {0xFFFF, 1, false}, {0xFFFF, 4, true}}};
  stream.eyes = {{60, 50}, {90, 50}, {71, 50}, {90, 50}};
  const MachineFlight flight = run_machine(program(), stream.bytes());
  ASSERT_EQ(flight.frames.size(), 4U);
  EXPECT_EQ(priorities_of(flight.frames[0], 4), (std::vector<int>{4, 0, 0, 0}));
  EXPECT_EQ(priorities_of(flight.frames[1], 4), (std::vector<int>{2, 3, 4, 0}));
  EXPECT_EQ(priorities_of(flight.frames[2], 4), (std::vector<int>{3, 4, 0, 0}));
  EXPECT_EQ(priorities_of(flight.frames[3], 4), (std::vector<int>{2, 3, 4, 0}));
  EXPECT_EQ(difference_of(stream.bytes()), "");
}

TEST(FlightFacing, NoPieceFacesTheEye) {
  for (const Precision precision : precisions) {
    Stream stream = street(precision);
    for (Entry& entry : stream.directions[0]) entry.faces_beyond = true;
    stream.eyes = {{0, 0}, {130, 3}, {0, 0}, {10, 0}, {130, 6}};
    const MachineFlight flight = run_machine(program(), stream.bytes());
    ASSERT_EQ(flight.status, Status::complete);
    EXPECT_EQ(priorities_of(flight.frames[0], 4), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(priorities_of(flight.frames[1], 4), (std::vector<int>{2, 4, 1, 3}));
    EXPECT_EQ(priorities_of(flight.frames[2], 4), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(priorities_of(flight.frames[3], 4), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(difference_of(stream.bytes()), "");
  }
}

// As many directions as numbers allow; only the last one has an entry.
TEST(FlightFacing, OnePieceAndTheMostDirections) {
  for (const Precision precision : precisions) {
    Stream stream = street(precision);
    const Entry last = stream.directions[0][0];
    stream.points = {{90, 0}, {100, 0}};
    stream.points.resize(255, {103, 0});
    stream.directions.assign(253, {});
    stream.directions.back() = {last};
    const MachineFlight flight = run_machine(program(), stream.bytes());
    ASSERT_EQ(flight.status, Status::complete) << text_of(flight.status);
    EXPECT_EQ(priorities_of(flight.frames.at(1), 1), std::vector<int>{0});
    EXPECT_EQ(priorities_of(flight.frames.at(2), 1), std::vector<int>{1});
    EXPECT_EQ(difference_of(stream.bytes()), "");
  }
}

int rounds() {
  const char* const wanted = std::getenv("SIGHTLINE_FLIGHTS");  // NOLINT(concurrency-mt-unsafe): nothing else runs
  return (wanted == nullptr ? 1 : std::atoi(wanted)) * tests::effort(90, 15);
}

// Random points, planes, directions and limits, whatever they mean; eyes that creep and jump.
Stream random_stream(Dice& dice, int number) {
  Stream stream;
  stream.precision = precisions[static_cast<std::size_t>(number) % 3];
  const int axes = dice(2, 3);
  const int bits = stream.precision == Precision::bits_8 ? 16 : stream.precision == Precision::bits_12 ? 24 : 32;
  // With precision 3 the squares of high bytes must sum to less than 2^16.
  std::int32_t most = stream.precision == Precision::bits_8 ? 255 : stream.precision == Precision::bits_12 ? 4095 : axes == 2 ? 46'335 : 37'887;
  if (dice(0, 3) == 0) most = dice(1, 20);
  const auto any = [&] {
    Coordinates point;
    for (int axis = 0; axis < axes; ++axis) point.push_back(static_cast<std::uint32_t>(dice(0, most)));
    return point;
  };
  const int planes = dice(0, 2) == 0 ? dice(1, 20) : 0;
  const int directions = number % 9 == 0 ? dice(60, 253 - 2 * planes) : dice(1, 12);
  const int room = 255 - 2 * planes - directions - 1;
  const int pieces = number % 9 == 1 ? room : number % 9 == 2 ? 1 : dice(1, std::min(room, 120));
  for (int i = 0; i < pieces + 2 * planes + directions + 1; ++i) stream.points.push_back(any());
  for (int plane = 1; plane <= planes; ++plane) {
    stream.places.push_back(static_cast<std::uint8_t>(2 * plane));
    stream.places.push_back(static_cast<std::uint8_t>(2 * plane + 1));
    stream.places.push_back(plane < planes ? static_cast<std::uint8_t>(0x81 + plane) : std::uint8_t{1});
  }
  for (int i = 0; planes > 0 && i < pieces; ++i) stream.cells.push_back(static_cast<std::uint8_t>(dice(1, 2 * planes + 2)));
  stream.directions.resize(static_cast<std::size_t>(directions));
  // Limits around the values that eyes have; equal ones, and the lowest and the highest.
  const auto half = std::uint32_t{1} << (bits - 1);
  for (int piece = 1; piece <= pieces; ++piece) {
    const int kind = dice(0, 5);
    std::uint32_t limit = kind == 0 ? 0 : kind == 1 ? half + (half - 1) : half + static_cast<std::uint32_t>(dice(-9, 9));
    if (kind > 2) {
      const std::int64_t spread = std::int64_t{most} * most;
      const std::int64_t value = std::int64_t{half} + (spread * dice(-1000, 1000)) / 2000;
      limit = static_cast<std::uint32_t>(std::clamp(value, std::int64_t{0}, 2 * std::int64_t{half} - 1));
    }
    stream.directions[static_cast<std::size_t>(dice(0, directions - 1))].push_back({limit, piece, dice(0, 1) == 1});
  }
  for (auto& entries : stream.directions)
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.limit < b.limit; });
  stream.eyes = {any()};
  for (int k = 0; k < 8; ++k) {
    Coordinates eye = dice(0, 2) == 0 ? any() : stream.eyes.back();
    for (std::uint32_t& value : eye)
      value = static_cast<std::uint32_t>(std::clamp(static_cast<std::int32_t>(value) + dice(-9, 9), 0, most));
    stream.eyes.push_back(eye);
  }
  return stream;
}

TEST(FlightFacing, EqualsItsTwinInRandomFlights) {
  constexpr std::uint32_t seed = 20261128;
  Dice dice(seed);
  std::uint64_t turned = 0;
  for (int n = 0; n < rounds(); ++n) {
    const auto stream = random_stream(dice, n).bytes();
    const MachineFlight flight = run_machine(program(), stream);
    ASSERT_EQ(difference_from_twin(flight, run_twin(stream, true)), "") << "flight " << n << " of seed " << seed;
    ASSERT_EQ(flight.status, Status::complete) << "flight " << n << " of seed " << seed << ": " << text_of(flight.status);
    for (std::size_t i = 1; i < flight.frames.size(); ++i) turned += flight.frames[i].turned.appeared + flight.frames[i].turned.vanished;
  }
  EXPECT_GT(turned, static_cast<std::uint64_t>(rounds()));
}

// --- Bad streams

Stream whole(Precision precision) {
  Stream stream = street(precision);
  for (Coordinates& point : stream.points) point.push_back(7);
  stream.eyes = {{80, 0, 3}, {120, 8, 3}};
  return stream;
}

DamagedStreams damaged() {
  return {true, [](Precision precision) { return whole(precision).bytes(); }};
}

TEST(DamagedFacing, EveryByteChanged) {
  for (const Precision precision : precisions) damaged().every_byte_changed(precision);
}

TEST(DamagedFacing, EveryByteLostOrDoubled) { damaged().every_byte_lost_or_doubled(Precision::bits_8); }

TEST(DamagedFacing, EveryBeginning) {
  for (const Precision precision : precisions) damaged().every_beginning(precision);
}

TEST(DamagedFacing, EveryStatusHasItsCause) {
  const auto status = [](const Stream& stream) {
    const auto bytes = stream.bytes();
    EXPECT_EQ(difference_of(bytes), "");
    return run_machine(program(), bytes).status;
  };
  const Stream right = whole(Precision::bits_8);
  EXPECT_EQ(status(right), Status::complete);
  const auto with = [&](auto&& change) {
    Stream stream = right;
    change(stream.directions);
    return status(stream);
  };
  using Directions = std::vector<std::vector<Entry>>;
  EXPECT_EQ(with([](Directions& d) { d[0][0].piece = 0; }), Status::out_of_range);
  EXPECT_EQ(with([](Directions& d) { d[0][0].piece = 5; }), Status::out_of_range);
  EXPECT_EQ(with([](Directions& d) { d[0][0].piece = 255; }), Status::out_of_range);
  EXPECT_EQ(with([](Directions& d) { d[0][1].piece = 1; }), Status::out_of_range);  // 1 twice
  EXPECT_EQ(with([](Directions& d) { d[0].pop_back(); }), Status::out_of_range);    // 4 has no entry: a piece without a normal
  EXPECT_EQ(with([](Directions& d) { d[0].clear(); }), Status::out_of_range);
  EXPECT_EQ(with([](Directions& d) { std::swap(d[0][1], d[0][2]); }), Status::out_of_range);  // not in order
  EXPECT_EQ(with([](Directions& d) { std::swap(d[0][0], d[0][1]); }), Status::complete);      // equal limits
  // The side, N, D and M, which is greater than 0.
  const auto changed = [&](std::size_t at, std::uint8_t value) {
    auto bytes = right.bytes();
    bytes[at] = value;
    EXPECT_EQ(difference_of(bytes), "");
    return run_machine(program(), bytes).status;
  };
  const std::size_t first_side = 7 + 6 * 3 + 1 + 3;
  ASSERT_EQ(right.bytes()[first_side], 1);
  EXPECT_EQ(changed(first_side, 2), Status::out_of_range);
  EXPECT_EQ(changed(6, 0), Status::out_of_range);
  EXPECT_EQ(changed(6, 251), Status::out_of_range);
  EXPECT_EQ(changed(4, 255), Status::out_of_range);
  EXPECT_EQ(changed(5, 125), Status::out_of_range);
  // Each build refuses the other's stream.
  EXPECT_EQ(changed(1, 'L'), Status::not_a_flight);
  EXPECT_EQ(run_machine(resident_program(), right.bytes()).status, Status::not_a_flight);
  MachineOptions blind;
  blind.display = false;
  EXPECT_EQ(run_machine(program(), right.bytes(), blind).status, Status::no_display);
}

// --- Flights

struct Flight {
  std::string name;
  scene::PolyScene scene;
  bool plan = false;
  std::optional<std::size_t> pieces = {};
  bool exact_directions = true;  // all normals are multiples of short vectors
};

const std::vector<Flight>& flights() {
  static const std::vector<Flight> all = [] {
    std::vector<Flight> list;
    list.push_back({"town-20", scene::generate_town(20)});
    list.push_back({"town-10", scene::generate_town(10, 7)});
    list.push_back({"prisms-25", scene::generate_prisms(25), true});
    list.push_back({"prisms-10", scene::generate_prisms(10), true});
    list.push_back({"touch-2", scene::generate_touch(2)});
    list.push_back({"roberts", scene::poly_scene_of(*scene::load_cell_scene("roberts"))});
    // Sheets in any position: their normals have components of 20 bits, and each has a direction of its own.
    list.push_back({"triangles-30", scene::generate_triangles(30), false, 100, false});
    return list;
  }();
  return all;
}

std::uint32_t frames() { return tests::effort(100U, 12U); }

// Of a face, the plane as its corners in the scene give it (Newell's sums), in exact integers.
struct Plane {
  std::array<std::int64_t, 3> normal{};
  scene::PolyPoint corner{};
};

std::vector<Plane> planes_of(const scene::PolyScene& scene) {
  std::vector<Plane> planes;
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      Plane plane;
      plane.corner = scene.vertices[face.outline[0]];
      for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const scene::PolyPoint& a = scene.vertices[face.outline[i]];
        const scene::PolyPoint& b = scene.vertices[face.outline[(i + 1) % face.outline.size()]];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t u = (axis + 1) % 3;
          const std::size_t v = (axis + 2) % 3;
          plane.normal[axis] += std::int64_t{a[u]} * b[v] - std::int64_t{a[v]} * b[u];
        }
      }
      planes.push_back(plane);
    }
  }
  return planes;
}

// Every piece that faces the eye is in the order of the guest; and no piece of which the eye is farther behind than packed
// states. That is at most half a step of the eye along each axis, twice, and the rounding of the limit.
TEST(FlightFacing, EqualsExactFacingExceptForTheStatedError) {
  for (const Flight& flight : flights()) {
    const auto plan = plan_flight(flight.scene, flight.plan, frames(), flight.pieces, true);
    ASSERT_TRUE(plan) << flight.name << ": " << plan.error().message();
    const std::vector<Plane> planes = planes_of(flight.scene);
    std::vector<std::uint64_t> superfluous;
    for (const Precision precision : precisions) {
      const auto run = flight::run({.model = plan->model, .path = plan->path, .precision = precision, .facing = true, .check = true});
      ASSERT_TRUE(run) << flight.name << ": " << run.error().message();
      const double axes = static_cast<double>(run->packed.axes);
      if (flight.exact_directions) {
        EXPECT_LE(run->packed.facing_error_in_units, (std::sqrt(axes) + 0.5) * run->packed.step_in_units) << flight.name;
      }
      EXPECT_EQ(run->summary.hidden, 0U) << flight.name;
      std::uint64_t more = 0;
      std::uint64_t facing = 0;
      for (std::size_t i = 0; i < run->flight.frames.size(); ++i) {
        for (std::size_t piece = 0; piece < plan->model.pieces.size(); ++piece) {
          const willis::Surface& surface = plan->model.pieces[piece];
          Plane plane = planes[surface.face];
          // The other side of a sheet has the opposite normal.
          geometry::Int128 same = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) same += geometry::Int128{plane.normal[axis]} * surface.plane.normal[axis];
          for (std::int64_t& value : plane.normal) value = same < 0 ? -value : value;
          geometry::Int128 before = 0;
          double length = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            before += geometry::Int128{plane.normal[axis]} * (plan->path[i].eye[axis] - plane.corner[axis]);
            length = std::hypot(length, static_cast<double>(plane.normal[axis]));
          }
          const bool listed = run->flight.frames[i].priorities[piece + 1] != 0;
          facing += before > 0 ? 1 : 0;
          ASSERT_TRUE(listed || before <= 0) << flight.name << ", frame " << i << ", piece " << piece + 1;
          if (before > 0 || !listed) continue;
          more += 1;
          ASSERT_LE(-static_cast<double>(before) / length, run->packed.facing_error_in_units * (1 + 1e-9))
              << flight.name << ", precision " << static_cast<int>(precision) << ", frame " << i << ", piece " << piece + 1;
        }
      }
      EXPECT_GT(facing, 0U) << flight.name;
      superfluous.push_back(more);
    }
    EXPECT_GE(superfluous[0], superfluous[2]) << flight.name;
  }
}

// The first corners of the pieces that have a priority in `listed`, by descending priority in `frame`.
std::vector<willis::Point> order_of(const willis::Model& model, const MachineFrame& frame, const MachineFrame& listed) {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 1; number <= model.pieces.size(); ++number)
    if (listed.priorities[number] != 0) numbers.push_back(number);
  std::sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) { return frame.priorities[a] > frame.priorities[b]; });
  std::vector<willis::Point> corners;
  for (const std::size_t number : numbers) corners.push_back(model.pieces[number - 1].points[0]);
  return corners;
}

// Pieces that face the eye have the same places among each other as without the test. Only pieces with the same corner may be
// exchanged: with 16 bits no other keys are equal here.
TEST(FlightFacing, OrdersAsTheBuildWithoutItDoes) {
  for (const Flight& flight : flights()) {
    const auto plan = plan_flight(flight.scene, flight.plan, tests::effort(30U, 8U), flight.pieces, true);
    ASSERT_TRUE(plan) << flight.name << ": " << plan.error().message();
    const Order all{.model = plan->model, .path = plan->path, .precision = Precision::bits_16, .count_points = true, .check = true};
    Order facing = all;
    facing.facing = true;
    const auto without = flight::run(all);
    const auto with = flight::run(facing);
    ASSERT_TRUE(without) << flight.name << ": " << without.error().message();
    ASSERT_TRUE(with) << flight.name << ": " << with.error().message();
    ASSERT_EQ(with->flight.frames.size(), without->flight.frames.size()) << flight.name;
    for (std::size_t i = 0; i < with->flight.frames.size(); ++i) {
      const MachineFrame& frame = with->flight.frames[i];
      EXPECT_EQ(order_of(plan->model, frame, frame), order_of(plan->model, without->flight.frames[i], frame)) << flight.name << ", frame " << i;
    }
    EXPECT_EQ(with->summary.wrong_orders, without->summary.wrong_orders) << flight.name;
    EXPECT_EQ(with->summary.wrong_points, without->summary.wrong_points) << flight.name;
    EXPECT_LT(with->summary.listed_mean, 0.75 * without->summary.listed_mean) << flight.name;
    EXPECT_EQ(without->summary.turned_most, 0U) << flight.name;
  }
}

TEST(FlightFacing, CostsAsMuchAsTheModelStates) {
  for (const Flight& flight : flights()) {
    if (!flight.exact_directions) continue;
    const auto plan = plan_flight(flight.scene, flight.plan, frames(), flight.pieces, true);
    ASSERT_TRUE(plan) << flight.name << ": " << plan.error().message();
    for (const Precision precision : precisions) {
      const auto run = flight::run({.model = plan->model, .path = plan->path, .precision = precision, .facing = true});
      ASSERT_TRUE(run) << flight.name << ": " << run.error().message();
      for (std::size_t i = 1; i < run->frames.size(); ++i) {
        const auto measured = static_cast<double>(run->frames[i].computing.count());
        EXPECT_NEAR(predicted_t_states(run->packed, run->frames[i]) / measured, 1, 0.1)
            << flight.name << ", precision " << static_cast<int>(precision) << ", frame " << i << ": " << measured;
      }
    }
  }
}

// All pieces of a town with coordinates of 16 bits: without the test not half of them are shown at 25 frames a second.
TEST(FlightFacing, ShowsAWholeTownAt25FramesASecondWith16Bits) {
  const Flight& town = flights()[0];
  const auto plan = plan_flight(town.scene, false, 100, {}, true);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->model.pieces.size(), 201U);
  for (const Precision precision : precisions) {
    const auto run = flight::run({.model = plan->model, .path = plan->path, .precision = precision, .facing = true});
    ASSERT_TRUE(run);
    EXPECT_LE(run->summary.t_states_worst, 120'000);
  }
}

// In parallel projection the same pieces face the eye in all frames, exactly.
TEST(FlightFacing, ParallelProjectionKeepsItsPieces) {
  const scene::PolyScene town = scene::generate_town(10);
  for (const scene::PolyPoint& forward : std::vector<scene::PolyPoint>{{0, 0, 1}, {3, -1, 2}, {-2, -5, 7}}) {
    scene::PolyCamera camera = town.camera;
    camera.perspective = false;
    camera.forward = forward;
    const auto model = flight_model(town, {}, camera.eye, {}, true);
    ASSERT_TRUE(model) << model.error().message();
    const std::vector<scene::PolyCamera> path(3, camera);
    for (const Precision precision : precisions) {
      const auto run = flight::run({.model = *model, .path = path, .precision = precision, .facing = true, .check = true});
      ASSERT_TRUE(run) << run.error().message();
      EXPECT_EQ(run->packed.directions, 1U);
      EXPECT_EQ(run->packed.facing_error_in_units, 0);
      for (const MachineFrame& frame : run->flight.frames) {
        for (std::size_t piece = 0; piece < model->pieces.size(); ++piece) {
          std::int64_t product = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) product += model->pieces[piece].plane.normal[axis] * forward[axis];
          EXPECT_EQ(frame.priorities[piece + 1] != 0, product < 0) << piece;
        }
      }
    }
  }
}

// Every piece of these sheets has a direction of its own, so the machine holds half as many.
TEST(FlightFacing, ReportsDirectionsThatDoNotFit) {
  const scene::PolyScene sheets = scene::generate_triangles(64);
  const auto without = flight_model(sheets, {}, sheets.camera.eye, 250);
  ASSERT_TRUE(without) << without.error().message();
  const auto with = flight_model(sheets, {}, sheets.camera.eye, 250, true);
  ASSERT_TRUE(with) << with.error().message();
  EXPECT_LT(with->pieces.size(), without->pieces.size());
  const auto town = flight_model(scene::generate_town(60), {}, {0, 0, 0}, {}, true);
  ASSERT_FALSE(town);
  EXPECT_NE(town.error().message().find("turned to 3 directions and their opposites"), std::string::npos) << town.error().message();
  EXPECT_NE(town.error().message().find("without the facing test"), std::string::npos) << town.error().message();
}

TEST(FlightFacing, ACheckedRunOfAWrongProgramFails) {
  const auto plan = plan_flight(scene::generate_town(10), false, 8, {}, true);
  ASSERT_TRUE(plan);
  expect_wrong_programs_fail({.model = plan->model, .path = plan->path, .facing = true, .check = true}, 0x2A00, tests::effort(41U, 197U));
}

}  // namespace
}  // namespace sightline::programs::flight
