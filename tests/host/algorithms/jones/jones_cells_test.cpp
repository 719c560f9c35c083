// Native Jones compared with `exact` by ==, on the five scenes with given cells and openings: from anywhere in free space, in any
// direction, from outside, from openings and walls, in both projections.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "tests/host/algorithms/jones/box_complex.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::algorithms {
namespace {

using scene::PolyCamera;
using scene::PolyPoint;

class Cameras {
 public:
  explicit Cameras(std::uint32_t seed) : dice_(seed) {}

  std::int32_t number(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(dice_() % (static_cast<std::uint32_t>(high - low) + 1));
  }
  // Strictly inside.
  PolyPoint point_in(const geometry::Box& box) {
    PolyPoint p{};
    for (std::size_t a = 0; a < 3; ++a) p[a] = number(box.low[a] + 1, box.high[a] - 1);
    return p;
  }
  PolyCamera looking_anywhere(const PolyPoint& eye, bool perspective = true) {
    PolyCamera camera;
    camera.perspective = perspective;
    camera.eye = eye;
    PolyPoint& f = camera.forward;
    do {
      for (std::int32_t& part : f) part = number(-3, 3);
    } while (f[0] == 0 && f[1] == 0);
    const PolyPoint& r = camera.right = {f[1], -f[0], 0};
    camera.up = {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]};
    return camera;
  }

 private:
  std::mt19937 dice_;
};

// A complex with an unused plane of such large coefficients that views need wider numbers.
scene::CellComplex with_long_plane(scene::CellComplex complex, std::int64_t component) {
  complex.planes.push_back({{component, 1, 0}, 0});
  return complex;
}

class JonesCells : public testing::TestWithParam<std::string_view> {
 protected:
  void expect_exact(const PolyCamera& camera) { expect_exact(walker_, camera); }

  void expect_exact(jones::Walker& walker, const PolyCamera& camera) {
    const auto result = walker.visible_edges(camera);
    const std::string where = std::string(camera.perspective ? "perspective" : "orthographic") + " eye " +
                              testing::PrintToString(camera.eye) + " forward " +
                              testing::PrintToString(camera.forward);
    ASSERT_TRUE(result) << where << ": " << result.error().message();
    const picture::LinePicture exact = exact::visible_edges(scene_, camera);
    EXPECT_TRUE(result->picture == exact)
        << where << ": " << result->picture.pieces.size() << " pieces, exact " << exact.pieces.size();
  }

  const scene::CellScene cells_ = scene::builtin_scene(GetParam());
  const scene::PolyScene scene_ = scene::poly_scene_of(cells_);
  const scene::CellComplex complex_ = complex_by_hand(cells_, scene_);
  const jones::PreparedComplex prepared_{complex_};
  jones::Walker walker_{prepared_};
  Cameras cameras_{1};
};

TEST_P(JonesCells, DefaultView) {
  expect_exact(scene_.camera);
}

TEST_P(JonesCells, FromWithinEveryCell) {
  for (const scene::Cell& cell : cells_.cells) {
    for (int i = 0; i < 8; ++i) expect_exact(cameras_.looking_anywhere(cameras_.point_in(cell.box)));
  }
}

TEST_P(JonesCells, FromWithinEveryOpening) {
  for (const scene::Opening& opening : cells_.openings) {
    geometry::Box box = opening.place.bounds();
    box.low[opening.place.axis] -= 1;
    box.high[opening.place.axis] += 1;
    for (int i = 0; i < 4; ++i) expect_exact(cameras_.looking_anywhere(cameras_.point_in(box)));
  }
}

TEST_P(JonesCells, FromOutsideAndFromInfinity) {
  geometry::Box around = cells_.outer;
  for (std::size_t a = 0; a < 3; ++a) {
    around.low[a] -= 1000;
    around.high[a] += 1000;
  }
  for (int i = 0; i < 60; ++i) {
    const PolyPoint eye = cameras_.point_in(around);
    if (!cells_.outer.contains(eye)) expect_exact(cameras_.looking_anywhere(eye));
    expect_exact(cameras_.looking_anywhere(eye, false));
  }
}

TEST_P(JonesCells, WithNumbersOfAnyWidth) {
  for (const int bits : {10, 39}) {
    const scene::CellComplex complex = with_long_plane(complex_, std::int64_t{1} << bits);
    const jones::PreparedComplex prepared(complex);
    jones::Walker walker(prepared);
    for (int i = 0; i < 10; ++i) {
      const scene::Cell& cell = cells_.cells[static_cast<std::size_t>(i) % cells_.cells.size()];
      expect_exact(walker, cameras_.looking_anywhere(cameras_.point_in(cell.box)));
      expect_exact(walker, cameras_.looking_anywhere(scene_.camera.eye, false));
    }
    const auto view = walker.visible_edges(scene_.camera);
    EXPECT_EQ(view->counts.number_bits, bits == 39 ? 128U : 64U);
  }
}

std::string scene_name(const testing::TestParamInfo<std::string_view>& info) {
  return std::string(info.param);
}

INSTANTIATE_TEST_SUITE_P(Builtin, JonesCells, testing::ValuesIn(scene::builtin_scene_names()), scene_name);

}  // namespace
}  // namespace sightline::algorithms
