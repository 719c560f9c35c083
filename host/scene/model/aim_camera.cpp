// See aim_camera.hpp.
#include "host/scene/model/aim_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {
namespace {

constexpr std::int64_t largest = camera_vector_limit - 1;

PolyPoint reduced(const geometry::Vector3& v) {
  const std::int64_t divisor = std::gcd(std::gcd(v[0], v[1]), v[2]);
  PolyPoint p{};
  for (std::size_t a = 0; a < 3; ++a) p[a] = static_cast<std::int32_t>(v[a] / divisor);
  return p;
}

// forward is p m, q m on the two axes after the vertical, n upwards.
struct Aim {
  std::int64_t p = 0;
  std::int64_t q = 0;
  std::int64_t m = 0;
  std::int64_t n = 0;
};

// The aims for one p and q are offered to a search that keeps the nearest.
class AimSearch {
 public:
  // On the two axes after the vertical, and upwards.
  AimSearch(double first, double second, double up) : wanted_{first, second, up} {}

  [[nodiscard]] std::optional<Aim> best() {
    const double level = std::sqrt(wanted_[0] * wanted_[0] + wanted_[1] * wanted_[1]);
    for (int length = 1; length * length <= largest; ++length) {
      const auto p = static_cast<std::int64_t>(std::floor(wanted_[0] / level * length + 0.5));
      const auto q = static_cast<std::int64_t>(std::floor(wanted_[1] / level * length + 0.5));
      offer(p, q, wanted_[2] / level);
    }
    return best_;
  }

 private:
  // The slopes n / m that come near the wanted one are its continued fraction's, and the last step of it that
  // still keeps the vectors short.
  void offer(std::int64_t p, std::int64_t q, double slope) {
    const std::int64_t square = p * p + q * q;
    if (square == 0) return;
    const std::int64_t longest_m = largest / square;
    const std::int64_t longest_n = largest / std::max(std::abs(p), std::abs(q));
    double rest = std::abs(slope) * std::sqrt(static_cast<double>(square));
    std::array<std::int64_t, 2> n{0, 1};
    std::array<std::int64_t, 2> m{1, 0};
    for (bool more = true; more;) {
      const std::int64_t room_n = n[1] == 0 ? largest : (longest_n - n[0]) / n[1];
      const std::int64_t room_m = m[1] == 0 ? largest : (longest_m - m[0]) / m[1];
      const double whole = std::floor(rest);
      const std::int64_t room = std::min(room_n, room_m);
      const std::int64_t step = whole < static_cast<double>(room) ? static_cast<std::int64_t>(whole) : room;
      more = whole <= static_cast<double>(room) && rest > whole;
      n = {n[1], n[0] + step * n[1]};
      m = {m[1], m[0] + step * m[1]};
      if (m[1] == 0 || n[1] > longest_n || m[1] > longest_m) return;
      offer(Aim{p, q, m[1], slope < 0 ? -n[1] : n[1]});
      rest = 1 / (rest - whole);
    }
  }

  // By the square of the sine of the angle to the wanted direction, times that direction's square.
  void offer(const Aim& aim) {
    const std::array<double, 3> f{static_cast<double>(aim.p * aim.m), static_cast<double>(aim.q * aim.m),
                                  static_cast<double>(aim.n)};
    double cross = 0;
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3;
      const double part = f[a] * wanted_[b] - f[b] * wanted_[a];
      cross += part * part;
      square += f[a] * f[a];
    }
    const double error = cross / square;
    if (best_ && error >= least_) return;
    best_ = aim;
    least_ = error;
  }

  std::array<double, 3> wanted_;
  std::optional<Aim> best_;
  double least_ = 0;
};

// x, or y where x is the vertical.
std::size_t side_axis(const SceneFrame& frame) {
  return frame.vertical == 0 ? 1 : 0;
}

geometry::Vector3 axis_vector(std::size_t axis, std::int64_t length) {
  geometry::Vector3 v{};
  v[axis] = length;
  return v;
}

geometry::Vector3 up_of(const SceneFrame& frame) {
  return axis_vector(frame.vertical, frame.downwards ? -1 : 1);
}

// The third vector of a camera: right x up is forward, or its opposite.
geometry::Vector3 completed(const SceneFrame& frame, const geometry::Vector3& a, const geometry::Vector3& b) {
  return frame.forward_is_z ? geometry::cross(a, b) : geometry::cross(b, a);
}

}  // namespace

SceneFrame frame_of(const PolyCamera& camera) {
  using geometry::vector_of;
  SceneFrame frame;
  frame.vertical = geometry::dominant_axis(vector_of(camera.up));
  frame.downwards = camera.up[frame.vertical] < 0;
  frame.forward_is_z = geometry::wide_dot(geometry::cross(vector_of(camera.right), vector_of(camera.up)),
                                          vector_of(camera.forward)) > 0;
  return frame;
}

PolyCamera aimed_camera(const SceneFrame& frame, const PolyPoint& eye, const PolyPoint& direction,
                        bool perspective) {
  const std::size_t first = (frame.vertical + 1) % 3;
  const std::size_t second = (frame.vertical + 2) % 3;
  const std::int64_t upwards = frame.downwards ? -1 : 1;
  std::optional<Aim> aim;
  if (direction[first] != 0 || direction[second] != 0) {
    aim = AimSearch(direction[first], direction[second],
                    static_cast<double>(upwards * direction[frame.vertical]))
              .best();
  }
  PolyCamera camera{perspective, eye, {}, {}, {}};
  if (!aim) {
    const geometry::Vector3 forward = axis_vector(frame.vertical, direction[frame.vertical] < 0 ? -1 : 1);
    const geometry::Vector3 right = axis_vector(side_axis(frame), 1);
    camera.forward = reduced(forward);
    camera.right = reduced(right);
    camera.up = reduced(completed(frame, forward, right));
    return camera;
  }
  geometry::Vector3 forward = axis_vector(frame.vertical, upwards * aim->n);
  forward[first] = aim->p * aim->m;
  forward[second] = aim->q * aim->m;
  geometry::Vector3 up = axis_vector(frame.vertical, upwards * (aim->p * aim->p + aim->q * aim->q) * aim->m);
  up[first] = -aim->p * aim->n;
  up[second] = -aim->q * aim->n;
  camera.forward = reduced(forward);
  camera.right = reduced(completed(frame, up_of(frame), forward));
  camera.up = reduced(up);
  return camera;
}

PolyCamera three_quarter_camera(const SceneFrame& frame, const PolyScene& scene) {
  const PolyBounds bounds = bounds_of(scene);
  const std::int64_t half = bounds.half_size();
  const PolyPoint centre = bounds.middle();
  const geometry::Vector3 right = axis_vector(side_axis(frame), 1);
  const geometry::Vector3 away = completed(frame, right, up_of(frame));
  PolyPoint direction{};
  for (std::size_t a = 0; a < 3; ++a)
    direction[a] = static_cast<std::int32_t>(20 * away[a] - 12 * right[a] - 9 * up_of(frame)[a]);
  PolyPoint eye{};
  bool fits = true;
  // |direction| is 25: the eye is 25/8 of the half side away, the corners of the scene less than 14/8.
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t place = centre[a] - (direction[a] * half - 7) / 8;
    fits = fits && std::abs(place) < poly_coordinate_limit;
    eye[a] = static_cast<std::int32_t>(place);
  }
  return aimed_camera(frame, fits ? eye : centre, direction, fits);
}

}  // namespace sightline::scene
