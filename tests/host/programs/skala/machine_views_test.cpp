// Skala's program compared with its native twin on typical pictures: the eight functions from all sides, and the hard cases.
// Equal dots,
// equal masks, no device error; every shard prints the longest drawing time without a limit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "tests/host/programs/skala/machine_support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

const int rotations = tests::effort(24, 3);
const std::vector<double> hard_rotations =
    tests::effort<std::vector<double>>({0, 90, 180, 270, 44.999, 45.001, 130, 215, 340}, {0, 45.001, 250});
const std::vector<double> hard_elevations =
    tests::effort<std::vector<double>>({-90, -20, 0, 35, 90}, {-20, 35});
const scene::GridSize plotted_size = tests::effort(scene::GridSize{33, 33}, scene::GridSize{9, 9});
constexpr std::array<double, 3> elevations{-20, 0, 35};

scene::GridSize usual_size(Subject what) {
  return what == Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60};
}

class SkalaGuestViews : public testing::TestWithParam<std::tuple<std::string, Subject>> {};

TEST_P(SkalaGuestViews, GuestAndTwinAgree) {
  const auto& [function, what] = GetParam();
  const auto grid = scene::sample(*scene::height_function(function), usual_size(what));
  std::int64_t longest = 0;
  std::string longest_view;
  for (int turn = 0; turn < rotations; ++turn) {
    for (const double elevation : elevations) {
      View view = view_of(what, 360.0 / rotations * turn);
      view.elevation = elevation;
      const std::string described =
          "rotated " + std::to_string(view.rotation) + ", elevation " + std::to_string(elevation);
      SCOPED_TRACE(described);
      const auto bytes = stream_of(grid, view);
      const auto guest = run_machine(resident_program(), bytes);
      ASSERT_TRUE(same_as_twin(guest, run_twin(bytes), Device::ef9365));
      ASSERT_GT(points_lit(guest), 0U);
      if (guest.drawing.count() > longest) {
        longest = guest.drawing.count();
        longest_view = described;
      }
    }
  }
  std::printf("%-8s %-9s longest %.3f s (%s)\n", function.c_str(),
              std::string(skala_picture_names[static_cast<std::size_t>(what)]).c_str(),
              static_cast<double>(longest) / 3e6, longest_view.c_str());
}

INSTANTIATE_TEST_SUITE_P(
    TheEight, SkalaGuestViews,
    testing::Combine(testing::Values("sinc", "rogers", "peaks", "franke", "saddle", "cosr", "step", "rosen"),
                     testing::ValuesIn(skala_pictures)),
    [](const auto& p) {
      return std::get<0>(p.param) + "_" +
             std::string(skala_picture_names[static_cast<std::size_t>(std::get<1>(p.param))]);
    });

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Heights = std::vector<std::vector<double>>;

scene::HeightGrid grid_of(const Heights& rows) {
  scene::HeightGrid grid;
  grid.x = scene::even_positions(rows.front().size());
  grid.z = scene::even_positions(rows.size());
  for (const auto& row : rows) grid.heights.insert(grid.heights.end(), row.begin(), row.end());
  grid.range = scene::finite_range(grid.heights);
  return grid;
}

Heights fill_heights(std::size_t slices, std::size_t points, double (*value)(int slice, int point)) {
  Heights rows(slices, std::vector<double>(points));
  for (std::size_t j = 0; j < slices; ++j)
    for (std::size_t i = 0; i < points; ++i) rows[j][i] = value(static_cast<int>(j), static_cast<int>(i));
  return rows;
}

struct HardCase {
  const char* name;
  Heights heights;
};

std::vector<HardCase> hard_cases() {
  return {
      {"nearly_horizontal", fill_heights(2, 2, [](int j, int i) { return j == 0 ? i / 255.0 : 1.0; })},
      {"equal_heights", fill_heights(9, 9, [](int, int) { return 3.0; })},
      {"coincident_slices", fill_heights(9, 9, [](int, int i) { return static_cast<double>(i % 3); })},
      {"steep_lines", fill_heights(4, 40, [](int j, int i) { return static_cast<double>((i + j) % 2); })},
      {"spike", fill_heights(11, 11, [](int j, int i) { return j == 5 && i == 5 ? 1.0 : 0.0; })},
      {"pit", fill_heights(11, 11, [](int j, int i) { return j == 5 && i == 5 ? -1.0 : 0.0; })},
      {"cliff", fill_heights(11, 11, [](int j, int i) { return i < 5 || j < 3 ? 1.0 : 0.0; })},
      {"peak_at_a_joint", fill_heights(7, 3, [](int j, int i) { return i == 1 ? 1.0 + j : 0.0; })},
      {"falls_then_rises", fill_heights(7, 5, [](int j, int i) { return std::abs(i - 2) * (1.0 + j % 2); })},
      {"single_slice", fill_heights(1, 20, [](int, int i) { return std::sin(i); })},
      {"single_point", fill_heights(1, 1, [](int, int) { return 1.0; })},
      {"single_column", fill_heights(20, 1, [](int j, int) { return std::cos(j); })},
      {"two_by_two", fill_heights(2, 2, [](int j, int i) { return static_cast<double>(i * j); })},
      {"saddle_cell", fill_heights(2, 2, [](int j, int i) { return static_cast<double>((i + j) % 2); })},
      {"plateau", fill_heights(9, 9, [](int j, int i) { return j > 2 && j < 6 && i > 2 && i < 6 ? 1.0 : 0.0; })},
      {"levels_on_vertices", fill_heights(9, 9, [](int j, int i) { return static_cast<double>((i + j) % 9); })},
      {"loop_in_one_cell",
       fill_heights(4, 4, [](int j, int i) { return (j == 1 || j == 2) && (i == 1 || i == 2) ? 1.0 : 0; })},
      {"hole",
       fill_heights(9, 9, [](int j, int i) { return j == 4 && i > 2 && i < 6 ? nan : std::sin(i) * std::cos(j); })},
      {"lone_points", fill_heights(5, 5, [](int j, int i) { return (i + j) % 2 == 0 ? nan : 1.0 * i * j; })},
      {"away_from_the_eye", fill_heights(12, 12, [](int j, int) { return -3.0 * j; })},
  };
}

class SkalaHardCases : public testing::TestWithParam<HardCase> {};

TEST_P(SkalaHardCases, GuestAndTwinAgree) {
  const auto grid = grid_of(GetParam().heights);
  for (const Subject what : skala_pictures) {
    for (const double rotation : hard_rotations) {
      for (const double elevation : hard_elevations) {
        for (const double zoom : {1.0, 1.7}) {
          View view = view_of(what, rotation);
          view.elevation = elevation;
          view.zoom = zoom;
          view.family = what == Subject::lines && zoom == 1 ? Family::both : Family::automatic;
          SCOPED_TRACE(testing::Message()
                       << skala_picture_names[static_cast<std::size_t>(what)] << " rotated " << rotation
                       << " elevation " << elevation << " zoom " << zoom);
          ASSERT_TRUE(agrees(stream_of(grid, view)));
          view.visibility = false;
          if (zoom == 1) continue;
          ASSERT_TRUE(agrees(stream_of(grid, view))) << "without visibility";
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(HardCases, SkalaHardCases, testing::ValuesIn(hard_cases()),
                         [](const auto& p) { return std::string(p.param.name); });

class SkalaPlotterViews : public testing::TestWithParam<std::tuple<std::string, Subject, Device>> {};

TEST_P(SkalaPlotterViews, GuestAndTwinMakeTheSameMovements) {
  const auto& [function, what, device] = GetParam();
  for (const double rotation : {30.0, 200.0}) {
    const View view = view_of(what, rotation);
    SCOPED_TRACE(testing::Message() << "rotated " << rotation);
    MachineOptions options;
    options.device = device;
    EXPECT_TRUE(agrees(stream_of(function, plotted_size, view, {device}), options));
  }
}

INSTANTIATE_TEST_SUITE_P(Plotters, SkalaPlotterViews,
                         testing::Combine(testing::Values("sinc", "rogers", "step"),
                                          testing::ValuesIn(skala_pictures),
                                          testing::Values(Device::calcomp, Device::minigraf)),
                         [](const auto& p) {
                           return std::get<0>(p.param) + "_" +
                                  std::string(
                                      skala_picture_names[static_cast<std::size_t>(std::get<1>(p.param))]) +
                                  (std::get<2>(p.param) == Device::calcomp ? "_calcomp" : "_minigraf");
                         });

}  // namespace
}  // namespace sightline::programs::skala
