#include "host/programs/flight/packing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/surface.hpp"
#include "host/programs/flight/cells.hpp"

namespace sightline::programs::flight {

namespace {

namespace willis = algorithms::willis;
using willis::Model;

willis::Point eye_point(const Model& model, const scene::PolyPoint& eye) {
  willis::Point point = willis::on_lattice(eye);
  if (model.plan) point[model.vertical] = 0;
  return point;
}

// The number of the machine's points that the model takes.
std::size_t points_of(const Model& model, const Cells& cells) { return model.pieces.size() + 2 * cells.planes.size(); }

std::optional<base::Error> too_many(const Model& model) {
  const Cells cells = cells_of(model);
  if (cells.planes.size() > most_planes || cells.cells > most_cells)
    return base::Error{.found = fmt::format("{} planes that part {} cells of solids that touch or are not convex", cells.planes.size(), cells.cells),
                       .expected = fmt::format("at most {} and {}", most_planes, most_cells),
                       .remedy = "a scene with fewer solids that touch"};
  const std::size_t points = points_of(model, cells);
  if (points <= most_pieces) return std::nullopt;
  std::uint32_t bodies = 0;
  for (const willis::Surface& piece : model.pieces) bodies = std::max(bodies, piece.body + 1);
  std::vector<std::size_t> counts(bodies);
  for (const willis::Surface& piece : model.pieces) ++counts[piece.body];
  const auto most = std::max_element(counts.begin(), counts.end());
  const std::string planes = cells.planes.empty() ? std::string() : fmt::format(" and twice {} planes between solids that touch", cells.planes.size());
  return base::Error{.found = fmt::format("{} pieces{}, {} more than the machine holds; body {} is cut into most of them, {}", model.pieces.size(), planes,
                                          points - most_pieces, most - counts.begin(), *most),
                     .expected = fmt::format("at most {}", most_pieces),
                     .remedy = "a flight past the nearest pieces (--pieces), in plan (--plan), or a smaller scene"};
}

// Keeps the pieces with these numbers, in this order.
void choose(Model& model, const std::vector<std::size_t>& order) {
  std::vector<willis::Surface> chosen;
  for (const std::size_t i : order) chosen.push_back(model.pieces[i]);
  std::vector<willis::Residual> residual;
  for (willis::Residual pair : model.residual) {
    const auto first = std::find(order.begin(), order.end(), pair.first);
    const auto second = std::find(order.begin(), order.end(), pair.second);
    if (first == order.end() || second == order.end()) continue;
    pair.first = static_cast<std::uint32_t>(first - order.begin());
    pair.second = static_cast<std::uint32_t>(second - order.begin());
    residual.push_back(pair);
  }
  model.pieces = std::move(chosen);
  model.residual = std::move(residual);
}

// The number of bits of a coordinate.
int bits_of(Precision precision) {
  switch (precision) {
    case Precision::bits_8: return 8;
    case Precision::bits_12: return 12;
    case Precision::bits_16: return 16;
  }
  return 8;
}

// Points in the space in which the machine measures: the axes of the scene or of its plan, or the depth along a direction.
class Space {
 public:
  using Place = std::array<std::int64_t, 3>;

  Space(const Model& model, const scene::PolyCamera& camera) : vertical_(model.plan ? model.vertical : 3) {
    if (!camera.perspective) forward_ = geometry::vector_of(camera.forward);
  }

  [[nodiscard]] std::size_t axes() const { return forward_ || vertical_ < 3 ? 2 : 3; }
  // A unit of its coordinates, in units of the lattice.
  [[nodiscard]] double unit() const {
    return forward_ ? 1 / std::sqrt(static_cast<double>(geometry::dot(*forward_, *forward_))) : 1;
  }
  [[nodiscard]] bool has_depth_only() const { return forward_.has_value(); }

  [[nodiscard]] Place of(const willis::Point& point) const {
    if (forward_) return {geometry::dot(*forward_, geometry::vector_of(point)), 0, 0};
    return among_axes([&](std::size_t axis) { return std::int64_t{point[axis]}; });
  }
  [[nodiscard]] Place of(const std::array<double, 3>& point) const {
    if (!forward_) return among_axes([&](std::size_t axis) { return std::llround(point[axis]); });
    double depth = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) depth += static_cast<double>((*forward_)[axis]) * point[axis];
    return {std::llround(depth), 0, 0};
  }

 private:
  template <class Coordinate>
  [[nodiscard]] Place among_axes(Coordinate&& coordinate) const {
    Place place{};
    std::size_t i = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != vertical_) place[i++] = coordinate(axis);
    return place;
  }

  std::size_t vertical_;
  std::optional<geometry::Vector3> forward_;
};

double distance(const Space::Place& a, const Space::Place& b) {
  std::uint64_t square = 0;
  for (std::size_t i = 0; i < 3; ++i) square += static_cast<std::uint64_t>((a[i] - b[i]) * (a[i] - b[i]));
  return std::sqrt(static_cast<double>(square));
}

}  // namespace

base::Result<Model> flight_model(const scene::PolyScene& scene, const willis::ModelOptions& options, const scene::PolyPoint& eye,
                                 std::optional<std::size_t> pieces) {
  auto made = willis::make_model(scene, options);
  if (!made) return made.error();
  Model model = std::move(*made);
  if (!pieces)
    if (auto error = too_many(model)) return *error;
  if (model.pieces.empty()) return base::Error{.found = "no pieces", .expected = "at least one"};
  const willis::Point from = eye_point(model, eye);
  std::vector<std::size_t> order(model.pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::uint64_t> distances;
  for (const willis::Surface& piece : model.pieces) distances.push_back(willis::squared_distance(from, piece.points[0]));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  if (pieces) order.resize(std::min({order.size(), *pieces, most_pieces}));
  choose(model, order);
  // Planes between the remaining pieces take space too.
  while (pieces && model.pieces.size() > 1) {
    const std::size_t points = points_of(model, cells_of(model));
    if (points <= most_pieces) break;
    order.resize(model.pieces.size() - std::min(model.pieces.size() - 1, points - most_pieces));
    std::iota(order.begin(), order.end(), std::size_t{0});
    choose(model, order);
  }
  if (auto error = too_many(model)) return *error;
  return model;
}

base::Result<Model> view_model(const scene::PolyScene& scene, const willis::ModelOptions& options, const scene::PolyCamera& camera) {
  auto made = willis::make_model(scene, options);
  if (!made) return made.error();
  Model model = std::move(*made);
  // Frames orders the farthest first.
  willis::Frames frames(model);
  const auto facing = frames.order(camera);
  choose(model, {facing.rbegin(), facing.rend()});
  if (auto error = too_many(model)) return *error;
  if (model.pieces.empty()) return base::Error{.found = "no pieces turned to the eye", .expected = "at least one"};
  return model;
}

Packed pack(const Model& model, std::span<const scene::PolyCamera> cameras, Precision precision) {
  const Space space(model, cameras.front());
  const Cells cells = cells_of(model);
  Packed packed;
  packed.precision = precision;
  packed.axes = space.axes();
  packed.planes = cells.planes.size();
  std::vector<Space::Place> points;  // 1 to N + 2D
  for (const willis::Surface& piece : model.pieces) points.push_back(space.of(piece.points[0]));
  for (const CellPlane& plane : cells.planes)
    for (const auto& point : plane.points) points.push_back(space.of(point));
  Space::Place low = points.front();
  Space::Place high = points.front();
  const auto include = [&](const Space::Place& p) {
    for (std::size_t i = 0; i < packed.axes; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  };
  for (const Space::Place& point : points) include(point);
  std::vector<Space::Place> eyes;
  for (const scene::PolyCamera& camera : cameras) eyes.push_back(space.has_depth_only() ? low : space.of(eye_point(model, camera.eye)));
  for (const Space::Place& eye : eyes) include(eye);
  double farthest = 0;
  if (!space.has_depth_only())
    for (const Space::Place& eye : eyes)
      for (const Space::Place& point : points) farthest = std::max(farthest, distance(eye, point));
  // No distance exceeds the largest number of that many bits, even if each difference is rounded up by one: 2 is more than
  // the square root of three.
  const std::int64_t largest = (std::int64_t{1} << bits_of(precision)) - 1;
  const auto steps_of = [](double length, std::int64_t most) {
    return static_cast<std::int64_t>(std::ceil(length / static_cast<double>(most)));
  };
  packed.step = std::max(std::int64_t{1}, steps_of(farthest, largest - 2));
  for (std::size_t i = 0; i < packed.axes; ++i) packed.step = std::max(packed.step, steps_of(static_cast<double>(high[i] - low[i]), largest - 1));
  packed.step_in_units = static_cast<double>(packed.step) * space.unit() / willis::lattice_unit;
  packed.error_in_units = 2 * std::sqrt(static_cast<double>(packed.axes)) * packed.step_in_units;
  const auto coordinates = [&](const Space::Place& p) {
    std::array<std::uint32_t, 3> rounded{};
    for (std::size_t i = 0; i < packed.axes; ++i) rounded[i] = static_cast<std::uint32_t>((p[i] - low[i] + packed.step / 2) / packed.step);
    return rounded;
  };
  StreamWriter writer(precision, packed.axes, model.pieces.size(), packed.planes);
  for (std::size_t i = points.size(); i > 0; --i) {
    const auto point = coordinates(points[i - 1]);
    writer.point(std::span(point).first(packed.axes));
  }
  for (const CellPlane& plane : cells.planes)
    for (const Place place : plane.places) writer.place(place);
  for (std::size_t i = cells.of_piece.size(); i > 0; --i) writer.place(cells.of_piece[i - 1]);
  writer.check();
  for (const Space::Place& eye : eyes) {
    const auto at = coordinates(eye);
    writer.eye(std::span(at).first(packed.axes));
  }
  packed.stream = writer.end();
  return packed;
}

StreamWriter::StreamWriter(Precision precision, std::size_t axes, std::size_t pieces, std::size_t planes) : precision_(precision) {
  for (const char letter : {'F', 'L'}) byte(static_cast<std::uint8_t>(letter));
  byte(static_cast<std::uint8_t>(precision));
  byte(static_cast<std::uint32_t>(axes));
  byte(static_cast<std::uint32_t>(pieces));
  byte(static_cast<std::uint32_t>(planes));
}

void StreamWriter::place(std::uint8_t place) { byte(place); }

void StreamWriter::byte(std::uint32_t value) {
  bytes_.push_back(static_cast<std::uint8_t>(value));
  sum_ = static_cast<std::uint8_t>(sum_ + bytes_.back());
  sum_of_sums_ = static_cast<std::uint8_t>(sum_of_sums_ + sum_);
}

void StreamWriter::point(std::span<const std::uint32_t> coordinates) {
  for (const std::uint32_t value : coordinates) {
    byte(value & 0xFFU);
    if (precision_ != Precision::bits_8) byte(value >> 8U);
  }
}

void StreamWriter::check() {
  bytes_.push_back(sum_);
  bytes_.push_back(sum_of_sums_);
}

void StreamWriter::eye(std::span<const std::uint32_t> coordinates) {
  byte(1);
  point(coordinates);
  check();
}

std::vector<std::uint8_t> StreamWriter::end() {
  byte(0);
  check();
  return std::move(bytes_);
}

}  // namespace sightline::programs::flight
