#include "host/programs/flight/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "host/scene/model/eye_place.hpp"

namespace sightline::programs::flight {

namespace {

using Place = std::array<double, 3>;
using scene::PolyCamera;
using scene::PolyPoint;

constexpr double pi = 3.14159265358979323846;
constexpr double path_begin = 1.3;  // times half the scene's width, before the middle
constexpr double path_end = 0.7;    // the same, after the middle

class Paths {
 public:
  Paths(const scene::PolyScene& scene, const scene::SceneFrame& frame, std::uint32_t frames)
      : scene_(scene), frame_(frame), frames_(frames), bounds_(scene::bounds_of(scene)), middle_(bounds_.middle()) {
    std::size_t next = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == frame.vertical) continue;
      level_[next++] = axis;
      half_ = std::max(half_, (double{1} * bounds_.high[axis] - bounds_.low[axis]) / 2);
    }
  }

  [[nodiscard]] std::optional<std::vector<PolyCamera>> between() const {
    const auto height = height_between();
    if (!height) return std::nullopt;
    constexpr int directions = 24;
    constexpr int aside = 8;  // tenths of half the width, to either side
    for (int j = 0; j <= 2 * aside; ++j) {
      const double offset = half_ / 10 * ((j + 1) / 2) * (j % 2 == 0 ? 1 : -1);
      for (int k = 0; k < directions; ++k) {
        auto way = straight(2 * pi * k / directions, offset, *height, 0);
        if (way && free(2 * pi * k / directions, offset, *height)) return way;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::vector<PolyCamera>> above() const {
    const std::size_t v = frame_.vertical;
    const double tall = double{1} * bounds_.high[v] - bounds_.low[v];
    const double over = std::max(tall, half_ / 4) / 2;
    return straight(pi / 6, 0, frame_.downwards ? bounds_.low[v] - over : bounds_.high[v] + over, 0.35);
  }
  // A path around the scene for a quarter of a turn.
  [[nodiscard]] std::optional<std::vector<PolyCamera>> around() const {
    const auto height = height_between();
    if (!height) return std::nullopt;
    std::vector<PolyCamera> cameras;
    for (std::uint32_t i = 0; i < frames_; ++i) {
      const double angle = pi / 2 * i / std::max(1U, frames_ - 1);
      const Place eye = place(1.6 * half_ * std::cos(angle), 1.6 * half_ * std::sin(angle), *height);
      if (!add(cameras, eye, -std::cos(angle), -std::sin(angle), 0)) return std::nullopt;
    }
    return cameras;
  }

 private:
  // The height between the feet and the tops of all faces that are not level; nullopt if there is none.
  [[nodiscard]] std::optional<double> height_between() const {
    const std::size_t v = frame_.vertical;
    std::int32_t feet = bounds_.low[v];
    std::int32_t tops = bounds_.high[v];
    for (const scene::PolyBody& body : scene_.bodies) {
      for (const scene::PolyFace& face : body.faces) {
        std::int32_t low = bounds_.high[v];
        std::int32_t high = bounds_.low[v];
        for (const scene::VertexIndex vertex : face.outline) {
          low = std::min(low, scene_.vertices[vertex][v]);
          high = std::max(high, scene_.vertices[vertex][v]);
        }
        if (low == high) continue;
        feet = std::max(feet, low);
        tops = std::min(tops, high);
      }
    }
    if (tops <= feet) return std::nullopt;
    return std::round((double{1} * feet + tops) / 2);
  }

  [[nodiscard]] Place place(double along_first, double along_second, double height) const {
    Place at{};
    at[level_[0]] = middle_[level_[0]] + along_first;
    at[level_[1]] = middle_[level_[1]] + along_second;
    at[frame_.vertical] = height;
    return at;
  }
  // The position at t, from 0, the beginning of the path, to 1.
  [[nodiscard]] Place on_way(double angle, double offset, double height, double t) const {
    const double along = half_ * (-path_begin + t * (path_begin + path_end));
    return place(along * std::cos(angle) - offset * std::sin(angle), along * std::sin(angle) + offset * std::cos(angle), height);
  }
  [[nodiscard]] static std::optional<PolyPoint> grid_point(const Place& at) {
    PolyPoint point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = std::round(at[axis]);
      if (!(std::abs(value) < scene::poly_coordinate_limit)) return std::nullopt;
      point[axis] = static_cast<std::int32_t>(value);
    }
    return point;
  }
  bool add(std::vector<PolyCamera>& cameras, const Place& eye, double first, double second, double down) const {
    const auto at = grid_point(eye);
    if (!at) return false;
    Place direction{};
    direction[level_[0]] = first;
    direction[level_[1]] = second;
    direction[frame_.vertical] = frame_.downwards ? down : -down;
    cameras.push_back(scene::aimed_camera(frame_, *at, scene::direction_of(direction)));
    return true;
  }
  [[nodiscard]] std::optional<std::vector<PolyCamera>> straight(double angle, double offset, double height, double down) const {
    std::vector<PolyCamera> cameras;
    for (std::uint32_t i = 0; i < frames_; ++i) {
      const double t = frames_ > 1 ? double{1} * i / (frames_ - 1) : 0;
      if (!add(cameras, on_way(angle, offset, height, t), std::cos(angle), std::sin(angle), down)) return std::nullopt;
    }
    return cameras;
  }
  [[nodiscard]] bool free(double angle, double offset, double height) const {
    const std::uint32_t looks = std::max(frames_, 200U);
    for (std::uint32_t i = 0; i < looks; ++i) {
      const double t = double{1} * i / std::max(1U, looks - 1);
      const auto at = grid_point(on_way(angle, offset, height, t));
      if (!at || scene::eye_place(scene_, *at).kind != scene::EyePlace::Kind::free) return false;
    }
    // Rounded like the positions of the frames.
    for (std::uint32_t i = 0; i < frames_; ++i) {
      const auto at = grid_point(on_way(angle, offset, height, frames_ > 1 ? double{1} * i / (frames_ - 1) : 0));
      if (!at || scene::eye_place(scene_, *at).kind != scene::EyePlace::Kind::free) return false;
    }
    return true;
  }

  const scene::PolyScene& scene_;
  scene::SceneFrame frame_;
  std::uint32_t frames_;
  scene::PolyBounds bounds_;
  PolyPoint middle_;
  std::array<std::size_t, 2> level_{};
  double half_ = 1;
};

}  // namespace

base::Result<std::vector<scene::PolyCamera>> path_through(const scene::PolyScene& scene, const scene::SceneFrame& frame,
                                                          std::uint32_t frames, bool level) {
  const Paths paths(scene, frame, frames);
  auto way = paths.between();
  if (!way) way = level ? paths.around() : paths.above();
  if (way) return std::move(*way);
  return base::Error{.found = level ? "no height is between the feet and the tops of all walls, or the path leaves the scene's coordinates"
                                    : "the path leaves the scene's coordinates",
                     .expected = "a scene with room for a flight"};
}

}  // namespace sightline::programs::flight
