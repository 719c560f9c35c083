// See aim_camera.hpp.
#include "host/scene/model/aim_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {
namespace {

constexpr std::int64_t largest = camera_vector_limit - 1;

PolyPoint reduce(const geometry::Vector3& v) {
  const std::int64_t divisor = std::gcd(std::gcd(v[0], v[1]), v[2]);
  PolyPoint p{};
  for (std::size_t a = 0; a < 3; ++a) p[a] = static_cast<std::int32_t>(v[a] / divisor);
  return p;
}

// Empty unless the components are below camera_vector_limit.
std::optional<PolyPoint> small_vector(const geometry::Vector3& v) {
  const std::int64_t divisor = std::gcd(std::gcd(v[0], v[1]), v[2]);
  if (divisor == 0) return std::nullopt;
  for (const std::int64_t c : v)
    if (std::abs(c / divisor) > largest) return std::nullopt;
  return reduce(v);
}

constexpr double longest_direction = (1 << 20) - 1;

// The integers, below 2^20, that a direction with at most six decimals is a multiple of. A difference that
// the rounding of a sine or a quotient explains is ignored.
std::optional<PolyPoint> whole_direction(const std::array<double, 3>& direction) {
  constexpr double rounding = 1e-9;
  for (double factor = 1; factor <= 1e6; factor *= 10) {
    PolyPoint result{};
    bool whole = true;
    for (std::size_t a = 0; a < 3 && whole; ++a) {
      const double scaled = direction[a] * factor;
      if (!(std::abs(scaled) <= longest_direction)) return std::nullopt;
      whole = std::abs(scaled - std::round(scaled)) < rounding;
      result[a] = static_cast<std::int32_t>(std::round(scaled));
    }
    if (whole && result != PolyPoint{}) return result;
  }
  return std::nullopt;
}

// forward is (p m, q m) on the two axes after the vertical, and n upwards.
struct Aim {
  std::int64_t p = 0;
  std::int64_t q = 0;
  std::int64_t m = 0;
  std::int64_t n = 0;
};

// Keeps the nearest of the aims that are offered for each p and q.
class AimSearch {
 public:
  // The wanted direction on the two axes after the vertical, and upwards.
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
  // The best slopes n / m are the convergents of the wanted slope's continued fraction, and its last
  // intermediate one that keeps the vectors short.
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

  // Compares the squared sine of the angle to the wanted direction, times that direction's square.
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

// x; y if x is the vertical.
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

// The third vector of a camera: right x up is forward or its opposite.
geometry::Vector3 third_vector(const SceneFrame& frame, const geometry::Vector3& a, const geometry::Vector3& b) {
  return frame.forward_is_z ? geometry::cross(a, b) : geometry::cross(b, a);
}

// The camera with exactly these directions, if its vectors are below camera_vector_limit.
std::optional<PolyCamera> exact_camera(const SceneFrame& frame, const PolyPoint& eye, const std::array<double, 3>& direction,
                                       const std::array<double, 3>& up, bool perspective) {
  const auto forward = whole_direction(direction);
  const auto upwards = whole_direction(up);
  if (!forward || !upwards) return std::nullopt;
  using geometry::vector_of;
  PolyCamera camera{perspective, eye, reduce(vector_of(*forward)), {}, {}};
  const auto fits = [](const PolyPoint& p) {
    return std::all_of(p.begin(), p.end(), [](std::int32_t c) { return std::abs(c) <= largest; });
  };
  if (!fits(camera.forward)) return std::nullopt;
  // Below 2^15 times 2^20, times 2 for the difference: below 2^36. The second product is below 2^31.
  const auto right = small_vector(third_vector(frame, vector_of(reduce(vector_of(*upwards))), vector_of(camera.forward)));
  if (!right) return std::nullopt;
  camera.right = *right;
  const auto upright = small_vector(third_vector(frame, vector_of(camera.forward), vector_of(camera.right)));
  if (!upright) return std::nullopt;
  camera.up = *upright;
  return camera;
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
    camera.forward = reduce(forward);
    camera.right = reduce(right);
    camera.up = reduce(third_vector(frame, forward, right));
    return camera;
  }
  geometry::Vector3 forward = axis_vector(frame.vertical, upwards * aim->n);
  forward[first] = aim->p * aim->m;
  forward[second] = aim->q * aim->m;
  geometry::Vector3 up = axis_vector(frame.vertical, upwards * (aim->p * aim->p + aim->q * aim->q) * aim->m);
  up[first] = -aim->p * aim->n;
  up[second] = -aim->q * aim->n;
  camera.forward = reduce(forward);
  camera.right = reduce(third_vector(frame, up_of(frame), forward));
  camera.up = reduce(up);
  return camera;
}

PolyCamera turned_camera(const SceneFrame& frame, const PolyPoint& eye, const std::array<double, 3>& direction,
                         const std::array<double, 3>& up, bool perspective) {
  if (const auto exact = exact_camera(frame, eye, direction, up, perspective)) return *exact;
  const auto upwards = whole_direction(up);
  if (upwards && geometry::vector_of(reduce(geometry::vector_of(*upwards))) == up_of(frame))
    return aimed_camera(frame, eye, direction_of(direction), perspective);
  using geometry::RealVector;
  using geometry::unit;
  // The rows are right, up and right x up, which is forward or its opposite.
  RealVector third = unit(direction);
  if (!frame.forward_is_z)
    for (double& c : third) c = -c;
  const RealVector right = unit(geometry::cross(up, third));
  const std::array<RealVector, 3> rows{right, geometry::cross(third, right), third};
  // The quaternion of a rotation, from its largest component (Shepperd 1978).
  const double trace = rows[0][0] + rows[1][1] + rows[2][2];
  std::array<double, 4> q{1 + trace, 0, 0, 0};
  for (std::size_t a = 0; a < 3; ++a) q[a + 1] = 1 + 2 * rows[a][a] - trace;
  const auto largest_part = static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin());
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const double with_w = rows[b][c] - rows[c][b];
    if (largest_part == 0) q[a + 1] = with_w;
    if (largest_part == a + 1) q = {with_w, 0, 0, 0};
    if (largest_part == a + 1) {
      q[a + 1] = 1 + 2 * rows[a][a] - trace;
      q[b + 1] = rows[a][b] + rows[b][a];
      q[c + 1] = rows[a][c] + rows[c][a];
      break;
    }
  }
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& c : q) c /= size;
  PolyCamera best{perspective, eye, {}, {}, {}};
  double nearest = -1;
  constexpr double longest_quaternion = 400;  // longer ones are tried because rows sometimes have common divisors
  for (double length = 1; length < longest_quaternion; length += 0.05) {
    std::array<std::int64_t, 4> n{};
    double norm = 0;
    double along = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double rounded = std::round(q[i] * length);
      n[i] = static_cast<std::int64_t>(rounded);
      norm += rounded * rounded;
      along += rounded * q[i];
    }
    if (norm == 0 || along * along / norm <= nearest) continue;
    const auto& [w, x, y, z] = n;
    const std::array<geometry::Vector3, 3> matrix{
        geometry::Vector3{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
        geometry::Vector3{2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
        geometry::Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}};
    PolyCamera camera{perspective, eye, {}, {}, {}};
    bool fits = true;
    for (std::size_t row = 0; row < 3; ++row) {
      std::int64_t divisor = 0;
      for (const std::int64_t c : matrix[row]) divisor = std::gcd(divisor, c);
      for (const std::int64_t c : matrix[row]) fits = fits && std::abs(c) / divisor <= largest;
    }
    if (!fits) continue;
    nearest = along * along / norm;
    camera.right = reduce(matrix[0]);
    camera.up = reduce(matrix[1]);
    camera.forward = reduce(frame.forward_is_z ? matrix[2] : geometry::negated(matrix[2]));
    best = camera;
  }
  return best;
}

double angle_to(const PolyCamera& camera, const std::array<double, 3>& direction) {
  // By the tangent, which is accurate for small angles.
  const std::array<double, 3> f{double(camera.forward[0]), double(camera.forward[1]), double(camera.forward[2])};
  double across = 0;
  double along = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const double part = f[a] * direction[b] - f[b] * direction[a];
    across += part * part;
    along += f[a] * direction[a];
  }
  return std::atan2(std::sqrt(across), along) * 180 / std::numbers::pi;
}

PolyPoint direction_of(const std::array<double, 3>& direction) {
  if (const auto whole = whole_direction(direction)) return *whole;
  double most = 0;
  for (const double c : direction) most = std::max(most, std::abs(c));
  PolyPoint result{};
  for (std::size_t a = 0; a < 3; ++a)
    result[a] = static_cast<std::int32_t>(std::round(direction[a] / most * longest_direction));
  return result;
}

SceneSides sides_of(const SceneFrame& frame) {
  const geometry::Vector3 right = axis_vector(side_axis(frame), 1);
  const geometry::Vector3 up = up_of(frame);
  const geometry::Vector3 away = third_vector(frame, right, up);
  SceneSides sides;
  for (std::size_t a = 0; a < 3; ++a) {
    sides.right[a] = static_cast<double>(right[a]);
    sides.up[a] = static_cast<double>(up[a]);
    sides.away[a] = static_cast<double>(away[a]);
  }
  return sides;
}

PolyCamera camera_outside(const SceneFrame& frame, const PolyScene& scene, const std::array<double, 3>& direction,
                          bool perspective) {
  const PolyBounds bounds = bounds_of(scene);
  const PolyPoint centre = bounds.middle();
  double length = 0;
  for (const double c : direction) length += c * c;
  PolyPoint eye = centre;
  // As far as three_quarter_camera: the corners of the scene are less than 14/25 of the distance from its
  // centre.
  const double away = 3.125 * static_cast<double>(bounds.half_size()) / std::sqrt(length);
  for (std::size_t a = 0; a < 3; ++a) {
    const double place = std::round(centre[a] - away * direction[a]);
    perspective = perspective && std::abs(place) < poly_coordinate_limit;
    if (perspective) eye[a] = static_cast<std::int32_t>(place);
  }
  return aimed_camera(frame, perspective ? eye : centre, direction_of(direction), perspective);
}

PolyCamera three_quarter_camera(const SceneFrame& frame, const PolyScene& scene) {
  const PolyBounds bounds = bounds_of(scene);
  const std::int64_t half = bounds.half_size();
  const PolyPoint centre = bounds.middle();
  const geometry::Vector3 right = axis_vector(side_axis(frame), 1);
  const geometry::Vector3 away = third_vector(frame, right, up_of(frame));
  PolyPoint direction{};
  for (std::size_t a = 0; a < 3; ++a)
    direction[a] = static_cast<std::int32_t>(20 * away[a] - 12 * right[a] - 9 * up_of(frame)[a]);
  PolyPoint eye{};
  bool fits = true;
  // direction| is 25: the eye is 25/8 of the half side away, the corners of the scene less than 14/8.
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t place = centre[a] - (direction[a] * half - 7) / 8;
    fits = fits && std::abs(place) < poly_coordinate_limit;
    eye[a] = static_cast<std::int32_t>(place);
  }
  return aimed_camera(frame, fits ? eye : centre, direction, fits);
}

}  // namespace sightline::scene
