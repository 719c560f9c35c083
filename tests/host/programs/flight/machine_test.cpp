// The program on the emulated 8080 compared with its native twin, priority by priority; and its reaction to bad streams.
//
// SIGHTLINE_FLIGHTS=10 in the environment makes the random flights ten times as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/programs/flight/check.hpp"
#include "host/programs/flight/flight.hpp"
#include "tests/host/programs/flight/flight_support.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::flight {
namespace {

using jones::Dice;

constexpr std::array precisions{Precision::bits_8, Precision::bits_12, Precision::bits_16};

int flights() {
  const char* const wanted = std::getenv("SIGHTLINE_FLIGHTS");  // NOLINT(concurrency-mt-unsafe): nothing else runs
  return wanted == nullptr ? 1 : std::atoi(wanted);
}

using Coordinates = std::vector<std::uint32_t>;

std::vector<std::uint8_t> stream_of(Precision precision, std::size_t axes, const std::vector<Coordinates>& points,
                                    const std::vector<Coordinates>& eyes) {
  StreamWriter writer(precision, axes, points.size());
  for (std::size_t number = points.size(); number > 0; --number) writer.point(points[number - 1]);
  writer.check();
  for (const Coordinates& eye : eyes) writer.eye(eye);
  return writer.end();
}

std::vector<int> priorities_of(const MachineFrame& frame, std::size_t pieces) {
  return {frame.priorities.begin() + 1, frame.priorities.begin() + 1 + static_cast<std::ptrdiff_t>(pieces)};
}

// By hand: pieces 1 to 4 at x = 10, 20, 30, 40 of a street.
TEST(FlightGuest, TheNearestPieceHasTheHighestPriority) {
  for (const Precision precision : precisions) {
    const auto stream = stream_of(precision, 2, {{10, 0}, {20, 0}, {30, 0}, {40, 0}}, {{0, 0}, {50, 0}, {21, 0}, {25, 3}, {26, 3}, {200, 200}});
    const MachineFlight flight = run_machine(resident_program(), stream);
    ASSERT_EQ(flight.status, Status::complete);
    ASSERT_EQ(flight.frames.size(), 6U);
    EXPECT_EQ(priorities_of(flight.frames[0], 4), (std::vector<int>{4, 3, 2, 1}));
    EXPECT_EQ(priorities_of(flight.frames[1], 4), (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(priorities_of(flight.frames[2], 4), (std::vector<int>{2, 4, 3, 1}));
    // 20 and 30 are equally far from 25, as are 10 and 40: they keep their order, 20 before 30 and 10 before 40.
    EXPECT_EQ(priorities_of(flight.frames[3], 4), (std::vector<int>{2, 4, 3, 1}));
    EXPECT_EQ(priorities_of(flight.frames[4], 4), (std::vector<int>{1, 3, 4, 2}));
    EXPECT_EQ(priorities_of(flight.frames[5], 4), (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(flight.priorities, 24U);
    EXPECT_EQ(flight.writes_lost, 0U);
  }
}

// Random points, eyes that jump, equal keys, one piece and 255 pieces.
TEST(FlightGuest, EqualsItsTwinInRandomFlights) {
  constexpr std::uint32_t seed = 20261124;
  Dice dice(seed);
  const int rounds = flights() * tests::effort(60, 12);
  for (int n = 0; n < rounds; ++n) {
    const Precision precision = precisions[static_cast<std::size_t>(n) % 3];
    const auto axes = static_cast<std::size_t>(dice(2, 3));
    // With precision 3 the squares of high bytes must sum to less than 2^16.
    std::int32_t most = precision == Precision::bits_8 ? 255 : precision == Precision::bits_12 ? 4095 : axes == 2 ? 46'335 : 37'887;
    if (dice(0, 3) == 0) most = dice(0, 20);
    const std::size_t pieces = n % 9 == 0 ? 255 : n % 9 == 1 ? 1 : static_cast<std::size_t>(dice(2, 120));
    const auto any = [&] {
      Coordinates point;
      for (std::size_t axis = 0; axis < axes; ++axis) point.push_back(static_cast<std::uint32_t>(dice(0, most)));
      return point;
    };
    std::vector<Coordinates> points(pieces);
    for (Coordinates& point : points) point = any();
    std::vector<Coordinates> eyes{any()};
    for (int k = 0; k < 6; ++k) {
      Coordinates eye = dice(0, 2) == 0 ? any() : eyes.back();
      for (std::uint32_t& value : eye)
        value = static_cast<std::uint32_t>(std::clamp(static_cast<std::int32_t>(value) + dice(-9, 9), 0, most));
      eyes.push_back(eye);
    }
    const auto stream = stream_of(precision, axes, points, eyes);
    const MachineFlight flight = run_machine(resident_program(), stream);
    ASSERT_EQ(difference_from_twin(flight, run_twin(stream)), "") << "flight " << n << " of seed " << seed;
    ASSERT_EQ(flight.status, Status::complete);
  }
}

// By hand: a plane at x = 50; pieces 1 and 3 on its left, 2 on its right, 4 in it.
TEST(FlightGuest, TheEyesSideOfAPlaneComesFirst) {
  for (const Precision precision : precisions) {
    StreamWriter writer(precision, 2, 4, 1);
    // Piece 2 is nearer to the first eye than 1 and 3 are.
    for (const Coordinates& point : std::vector<Coordinates>{{80, 50}, {20, 50}, {50, 90}, {0, 60}, {52, 0}, {10, 50}}) writer.point(point);
    for (const std::uint8_t place : std::vector<std::uint8_t>{1, 2, 3}) writer.place(place);
    for (const std::uint8_t cell : std::vector<std::uint8_t>{2, 1, 3, 1}) writer.place(cell);
    writer.check();
    for (const Coordinates& eye : std::vector<Coordinates>{{40, 0}, {60, 0}, {49, 200}, {51, 200}, {50, 0}}) writer.eye(eye);
    const auto stream = writer.end();
    const MachineFlight flight = run_machine(resident_program(), stream);
    ASSERT_EQ(flight.status, Status::complete);
    ASSERT_EQ(flight.frames.size(), 5U);
    EXPECT_EQ(priorities_of(flight.frames[0], 4), (std::vector<int>{4, 1, 3, 2}));
    EXPECT_EQ(priorities_of(flight.frames[1], 4), (std::vector<int>{2, 4, 1, 3}));
    EXPECT_EQ(priorities_of(flight.frames[2], 4), (std::vector<int>{3, 1, 4, 2}));
    EXPECT_EQ(priorities_of(flight.frames[3], 4), (std::vector<int>{1, 4, 2, 3}));
    EXPECT_EQ(priorities_of(flight.frames[4], 4), (std::vector<int>{4, 1, 3, 2}));  // in the plane: as on its first side
    EXPECT_EQ(difference_from_twin(flight, run_twin(stream)), "");
  }
}

// Random trees of planes: cells and planes that no plane refers to are allowed.
TEST(FlightGuest, EqualsItsTwinWithRandomPlanes) {
  constexpr std::uint32_t seed = 20261125;
  Dice dice(seed);
  const int rounds = flights() * tests::effort(60, 12);
  for (int n = 0; n < rounds; ++n) {
    const Precision precision = precisions[static_cast<std::size_t>(n) % 3];
    const auto axes = static_cast<std::size_t>(dice(2, 3));
    const int most = precision == Precision::bits_8 ? 255 : precision == Precision::bits_12 ? 4095 : 37'887;
    const int planes = n % 7 == 0 ? 126 : dice(1, 30);
    const int pieces = n % 7 == 0 ? dice(1, 3) : dice(1, 255 - 2 * planes);
    StreamWriter writer(precision, axes, static_cast<std::size_t>(pieces), static_cast<std::size_t>(planes));
    const auto any = [&] {
      Coordinates point;
      for (std::size_t axis = 0; axis < axes; ++axis) point.push_back(static_cast<std::uint32_t>(dice(0, most)));
      return point;
    };
    for (int i = 0; i < pieces + 2 * planes; ++i) writer.point(any());
    std::vector<int> cells;
    for (int cell = 1; cell < 128; ++cell) cells.push_back(cell);
    int next_plane = 2;
    for (int plane = 1; plane <= planes; ++plane) {
      for (int i = 0; i < 3; ++i) {
        if (next_plane <= planes && (dice(0, 1) == 0 || n % 7 == 0)) {
          next_plane = std::max(next_plane, plane + 1);
          if (next_plane <= planes) {
            writer.place(static_cast<std::uint8_t>(0x80 + next_plane++));
            continue;
          }
        }
        if (dice(0, 4) == 0 || cells.empty()) {
          writer.place(0);
          continue;
        }
        const auto taken = cells.begin() + dice(0, static_cast<int>(cells.size()) - 1);
        writer.place(static_cast<std::uint8_t>(*taken));
        cells.erase(taken);
      }
    }
    for (int i = 0; i < pieces; ++i) writer.place(static_cast<std::uint8_t>(dice(1, 127)));
    writer.check();
    for (int k = 0; k < 5; ++k) writer.eye(any());
    const auto stream = writer.end();
    const MachineFlight flight = run_machine(resident_program(), stream);
    ASSERT_EQ(difference_from_twin(flight, run_twin(stream)), "") << "flight " << n << " of seed " << seed;
    ASSERT_EQ(flight.status, Status::complete) << n;
  }
}

std::vector<std::uint8_t> whole(Precision precision) {
  return stream_of(precision, 3, {{10, 20, 30}, {40, 5, 6}, {7, 8, 9}, {101, 120, 130}}, {{1, 2, 3}, {90, 80, 70}});
}

DamagedStreams damaged() { return {false, whole}; }

TEST(DamagedFlight, EveryByteChanged) {
  for (const Precision precision : {Precision::bits_8, Precision::bits_12}) damaged().every_byte_changed(precision);
}

TEST(DamagedFlight, EveryByteLostOrDoubled) { damaged().every_byte_lost_or_doubled(Precision::bits_8); }

TEST(DamagedFlight, EveryByteExchangedWithTheNext) {
  const auto right = whole(Precision::bits_8);
  for (std::size_t at = 0; at + 1 < right.size(); ++at) {
    if (right[at] == right[at + 1]) continue;
    auto exchanged = right;
    std::swap(exchanged[at], exchanged[at + 1]);
    damaged().refused(exchanged, Precision::bits_8, "bytes " + std::to_string(at) + " and the next exchanged");
  }
}

TEST(DamagedFlight, EveryBeginning) { damaged().every_beginning(Precision::bits_8); }

TEST(DamagedFlight, EveryStatusHasItsCause) {
  const auto right = whole(Precision::bits_8);
  const auto with = [&right](std::size_t at, std::uint8_t value) {
    auto stream = right;
    stream[at] = value;
    return stream;
  };
  const auto status = [](const std::vector<std::uint8_t>& stream) { return run_machine(resident_program(), stream).status; };
  EXPECT_EQ(status(right), Status::complete);
  EXPECT_EQ(status(with(0, 'f')), Status::not_a_flight);
  EXPECT_EQ(status(with(1, 'f')), Status::not_a_flight);
  for (const int precision : {0, 4, 255}) EXPECT_EQ(status(with(2, static_cast<std::uint8_t>(precision))), Status::out_of_range);
  for (const int axes : {0, 1, 4}) EXPECT_EQ(status(with(3, static_cast<std::uint8_t>(axes))), Status::out_of_range);
  EXPECT_EQ(status(with(4, 0)), Status::out_of_range);
  for (const int planes : {126, 127, 255}) EXPECT_EQ(status(with(5, static_cast<std::uint8_t>(planes))), Status::out_of_range);
  const auto places = [&status](const std::vector<std::uint8_t>& of_planes, const std::vector<std::uint8_t>& of_pieces) {
    StreamWriter writer(Precision::bits_8, 2, of_pieces.size(), of_planes.size() / 3);
    for (std::size_t i = 0; i < of_pieces.size() + of_planes.size() / 3 * 2; ++i) writer.point(Coordinates{1, 2});
    for (const std::uint8_t place : of_planes) writer.place(place);
    for (const std::uint8_t place : of_pieces) writer.place(place);
    writer.check();
    writer.eye(Coordinates{3, 4});
    const auto stream = writer.end();
    EXPECT_EQ(difference_from_twin(run_machine(resident_program(), stream), run_twin(stream)), "");
    return status(stream);
  };
  EXPECT_EQ(places({1, 0, 0x82, 2, 3, 127}, {1, 2, 127, 3}), Status::complete);
  EXPECT_EQ(places({1, 0, 2, 5, 3, 4}, {1, 2, 3, 5}), Status::complete);       // nothing refers to plane 2
  EXPECT_EQ(places({1, 0, 0x81, 2, 3, 4}, {1}), Status::out_of_range);          // a plane below itself
  EXPECT_EQ(places({1, 0, 0x82, 2, 3, 0x81}, {1}), Status::out_of_range);       // and above
  EXPECT_EQ(places({1, 0, 0x83, 2, 3, 4}, {1}), Status::out_of_range);          // there is no third plane
  EXPECT_EQ(places({1, 0, 0x80, 2, 3, 4}, {1}), Status::out_of_range);
  EXPECT_EQ(places({1, 0, 0x82, 2, 3, 1}, {1}), Status::out_of_range);          // a cell twice
  EXPECT_EQ(places({0x82, 0, 0x82, 2, 3, 1}, {1}), Status::out_of_range);       // a plane twice
  for (const int cell : {0, 128, 255}) EXPECT_EQ(places({1, 0, 2}, {1, static_cast<std::uint8_t>(cell), 2}), Status::out_of_range);
  EXPECT_EQ(status(with(9, 77)), Status::wrong_sum_of_pieces);
  EXPECT_EQ(status(with(21, 77)), Status::wrong_sum_of_packet);
  EXPECT_EQ(status(with(20, 77)), Status::unknown_packet);
  EXPECT_EQ(status(stream_of(Precision::bits_12, 2, {{1, 0x1000}}, {{1, 2}})), Status::out_of_range);
  EXPECT_EQ(status(stream_of(Precision::bits_12, 2, {{1, 0xFFF}}, {{0x1000, 2}})), Status::out_of_range);
  EXPECT_EQ(status(stream_of(Precision::bits_12, 2, {{1, 0xFFF}}, {{0xFFF, 2}})), Status::complete);
  MachineOptions blind;
  blind.display = false;
  EXPECT_EQ(run_machine(resident_program(), right, blind).status, Status::no_display);
}

}  // namespace
}  // namespace sightline::programs::flight
