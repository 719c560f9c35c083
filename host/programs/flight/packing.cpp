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
#include "host/programs/flight/directions.hpp"

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
std::size_t points_of(const Model& model, const Cells& cells, bool facing) {
  return model.pieces.size() + 2 * cells.planes.size() + (facing ? directions_of(model).size() + 1 : 0);
}

std::optional<base::Error> without_normal(const Model& model) {
  for (std::size_t i = 0; i < model.pieces.size(); ++i)
    if (model.pieces[i].plane.normal == willis::Vector3{})
      return base::Error{.found = fmt::format("piece {}, of face {}, without a normal", i + 1, model.pieces[i].face),
                         .expected = "pieces that face a side",
                         .remedy = "a flight without the facing test"};
  return std::nullopt;
}

std::optional<base::Error> too_many(const Model& model, bool facing = false) {
  const Cells cells = cells_of(model);
  if (cells.planes.size() > most_planes || cells.cells > most_cells)
    return base::Error{.found = fmt::format("{} planes that part {} cells of solids that touch or are not convex", cells.planes.size(), cells.cells),
                       .expected = fmt::format("at most {} and {}", most_planes, most_cells),
                       .remedy = "a scene with fewer solids that touch"};
  const std::size_t points = points_of(model, cells, facing);
  if (points <= most_pieces) return std::nullopt;
  std::uint32_t bodies = 0;
  for (const willis::Surface& piece : model.pieces) bodies = std::max(bodies, piece.body + 1);
  std::vector<std::size_t> counts(bodies);
  for (const willis::Surface& piece : model.pieces) ++counts[piece.body];
  const auto most = std::max_element(counts.begin(), counts.end());
  const std::string planes = cells.planes.empty() ? std::string() : fmt::format(" and twice {} planes between solids that touch", cells.planes.size());
  const std::string directions = facing ? fmt::format(", turned to {} directions and their opposites", directions_of(model).size()) : std::string();
  return base::Error{.found = fmt::format("{} pieces{}{}, {} more than the machine holds; body {} is cut into most of them, {}", model.pieces.size(), planes,
                                          directions, points - most_pieces, most - counts.begin(), *most),
                     .expected = facing ? fmt::format("at most {} of pieces, points of planes, directions, and 1 more", most_pieces) : fmt::format("at most {}", most_pieces),
                     .remedy = facing ? "a flight past the nearest pieces (--pieces), in plan (--plan), without the facing test, or a smaller scene"
                                      : "a flight past the nearest pieces (--pieces), in plan (--plan), or a smaller scene"};
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
  [[nodiscard]] Place along_axes(const geometry::Vector3& normal) const {
    return among_axes([&](std::size_t axis) { return normal[axis]; });
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

// The coordinates of the machine: whole steps, the lowest place of a flight at `shift`.
struct Grid {
  std::size_t axes = 3;
  std::int64_t step = 1;     // in units of the space
  std::int64_t largest = 0;  // coordinate
  Space::Place low{};
  Space::Place high{};
  Space::Place shift{};  // 0 without the facing test

  [[nodiscard]] std::array<std::uint32_t, 3> rounded(const Space::Place& p) const {
    std::array<std::uint32_t, 3> coordinates{};
    for (std::size_t i = 0; i < axes; ++i) coordinates[i] = static_cast<std::uint32_t>((p[i] - low[i] + step / 2) / step + shift[i]);
    return coordinates;
  }
};

// A direction of the facing test: the middle of the grid is its origin, `vector` goes from there to its point.
struct Aimed {
  Space::Place vector{};
  // The length that `vector` would have if it were not rounded, and how much rounding changes the value of an eye against
  // that of a piece: half a step of the eye along each axis, and the direction's own rounding. The value is twice a product.
  double length = 1;
  std::int64_t doubt = 0;
};

class FacingTest {
 public:
  FacingTest(const Grid& grid, const std::vector<Space::Place>& eyes) : grid_(grid), middle_((grid.largest + 1) / 2) {
    for (const Space::Place& eye : eyes) {
      const auto rounded = grid.rounded(eye);
      for (std::size_t i = 0; i < grid.axes; ++i) reach_[i] = std::max(reach_[i], std::abs(rounded[i] - middle_));
    }
  }

  [[nodiscard]] std::array<std::uint32_t, 3> origin() const { return point_of({}); }
  [[nodiscard]] std::array<std::uint32_t, 3> point_of(const Space::Place& vector) const {
    std::array<std::uint32_t, 3> coordinates{};
    for (std::size_t i = 0; i < grid_.axes; ++i) coordinates[i] = static_cast<std::uint32_t>(middle_ + vector[i]);
    return coordinates;
  }

  // The longest vector that is an exact multiple of the normal, else the longest.
  [[nodiscard]] Aimed aim(const Space::Place& normal) const {
    std::int64_t greatest = 1;
    double square = 0;
    for (const std::int64_t value : normal) {
      greatest = std::max(greatest, std::abs(value));
      square += static_cast<double>(value) * static_cast<double>(value);
    }
    const auto scaled = [&](std::int64_t longest) {
      Aimed aimed;
      aimed.length = std::sqrt(square) * static_cast<double>(longest) / static_cast<double>(greatest);
      for (std::size_t i = 0; i < grid_.axes; ++i) {
        const std::int64_t size = (2 * std::abs(normal[i]) * longest + greatest) / (2 * greatest);
        aimed.vector[i] = normal[i] < 0 ? -size : size;
        aimed.doubt += size;
        if (normal[i] % greatest * longest % greatest != 0) aimed.doubt += (grid_.high[i] - grid_.low[i]) / grid_.step + 1;
      }
      return aimed;
    };
    for (std::int64_t longest = grid_.largest / greatest * greatest; longest > 0; longest -= greatest)
      if (const Aimed aimed = scaled(longest); fits(aimed.vector)) return aimed;
    for (std::int64_t longest = std::min(grid_.largest, greatest); longest > 1; --longest)
      if (const Aimed aimed = scaled(longest); fits(aimed.vector)) return aimed;
    return scaled(1);
  }

  // The limit of a piece with that corner. `along`: it faces the side to which the vector points.
  [[nodiscard]] std::uint32_t limit(const Aimed& aimed, const Space::Place& corner, bool along) const {
    std::int64_t product = 0;  // twice that of the vector and the corner, in units of the space
    std::int64_t whole = 0;    // the rest, in steps
    for (std::size_t i = 0; i < grid_.axes; ++i) {
      product += 2 * aimed.vector[i] * (corner[i] - grid_.low[i]);
      whole += 2 * aimed.vector[i] * (grid_.shift[i] - middle_) - aimed.vector[i] * aimed.vector[i];
    }
    // Never so that a piece that faces the eye is taken for one that does not.
    const std::int64_t value = along ? whole - aimed.doubt + floor_of(product, grid_.step) : whole + aimed.doubt - floor_of(-product, grid_.step) - 1;
    return static_cast<std::uint32_t>(std::clamp(value + most_value() + 1, std::int64_t{0}, 2 * most_value() + 1));
  }

 private:
  [[nodiscard]] std::int64_t most_value() const { return (grid_.largest + 1) * (grid_.largest + 1) / 2 - 1; }
  [[nodiscard]] static std::int64_t floor_of(std::int64_t value, std::int64_t divisor) {
    return value / divisor - (value % divisor < 0 ? 1 : 0);
  }

  // The point is on the grid, the value of no eye exceeds its word, and no key exceeds its own.
  [[nodiscard]] bool fits(const Space::Place& vector) const {
    std::int64_t value = 0;
    std::int64_t key = 0;
    for (std::size_t i = 0; i < grid_.axes; ++i) {
      const std::int64_t size = std::abs(vector[i]);
      if (size >= middle_) return false;
      value += 2 * size * reach_[i] + size * size;
      key += (reach_[i] + size) * (reach_[i] + size);
    }
    return value <= most_value() && key <= grid_.largest * grid_.largest;
  }

  const Grid& grid_;
  std::int64_t middle_;
  Space::Place reach_{};  // the greatest distance of an eye from the origin along each axis
};

struct Entry {
  std::uint32_t limit = 0;
  std::uint8_t piece = 0;
  bool faces_beyond = false;
};
struct SentDirection {
  std::array<std::uint32_t, 3> point{};
  std::vector<Entry> entries;  // in ascending order
};

double distance(const Space::Place& a, const Space::Place& b) {
  std::uint64_t square = 0;
  for (std::size_t i = 0; i < 3; ++i) square += static_cast<std::uint64_t>((a[i] - b[i]) * (a[i] - b[i]));
  return std::sqrt(static_cast<double>(square));
}

}  // namespace

base::Result<Model> flight_model(const scene::PolyScene& scene, const willis::ModelOptions& options, const scene::PolyPoint& eye,
                                 std::optional<std::size_t> pieces, bool facing) {
  auto made = willis::make_model(scene, options);
  if (!made) return made.error();
  Model model = std::move(*made);
  if (!pieces)
    if (auto error = too_many(model, facing)) return *error;
  if (model.pieces.empty()) return base::Error{.found = "no pieces", .expected = "at least one"};
  const willis::Point from = eye_point(model, eye);
  std::vector<std::size_t> order(model.pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::uint64_t> distances;
  for (const willis::Surface& piece : model.pieces) distances.push_back(willis::squared_distance(from, piece.points[0]));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  if (pieces) order.resize(std::min({order.size(), *pieces, most_pieces}));
  choose(model, order);
  // Planes between the remaining pieces, and their directions, take space too.
  while (pieces && model.pieces.size() > 1) {
    const std::size_t points = points_of(model, cells_of(model), facing);
    if (points <= most_pieces) break;
    order.resize(model.pieces.size() - std::min(model.pieces.size() - 1, points - most_pieces));
    std::iota(order.begin(), order.end(), std::size_t{0});
    choose(model, order);
  }
  if (auto error = too_many(model, facing)) return *error;
  if (facing)
    if (auto error = without_normal(model)) return *error;
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

namespace {

std::vector<SentDirection> sent_directions(const Model& model, const Space& space, const scene::PolyCamera& camera, const FacingTest& test, Packed& packed) {
  std::vector<SentDirection> sent;
  if (space.has_depth_only()) {
    // The eye moves along no direction, so no limit is ever passed.
    const geometry::Vector3 forward = geometry::vector_of(camera.forward);
    sent.push_back({test.point_of({1}), {}});
    const std::uint32_t never = packed.precision == Precision::bits_8 ? 0xFFFFU : packed.precision == Precision::bits_12 ? 0xFF'FFFFU : 0xFFFF'FFFFU;
    for (std::size_t i = 0; i < model.pieces.size(); ++i)
      sent.back().entries.push_back({never, static_cast<std::uint8_t>(i + 1), geometry::dot(model.pieces[i].plane.normal, forward) >= 0});
    return sent;
  }
  for (const Direction& direction : directions_of(model)) {
    const Aimed aimed = test.aim(space.along_axes(direction.normal));
    SentDirection made{test.point_of(aimed.vector), {}};
    for (const Direction::Piece& piece : direction.pieces)
      made.entries.push_back(
          {test.limit(aimed, space.of(model.pieces[piece.number].points[0]), piece.along), static_cast<std::uint8_t>(piece.number + 1), piece.along});
    std::stable_sort(made.entries.begin(), made.entries.end(), [](const Entry& a, const Entry& b) { return a.limit < b.limit; });
    packed.facing_error_in_units =
        std::max(packed.facing_error_in_units, static_cast<double>(2 * aimed.doubt + 1) / (2 * aimed.length) * packed.step_in_units);
    sent.push_back(std::move(made));
  }
  return sent;
}

}  // namespace

Packed pack(const Model& model, std::span<const scene::PolyCamera> cameras, Precision precision, bool facing) {
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
  Grid grid;
  grid.axes = packed.axes;
  grid.low = grid.high = points.front();
  const auto include = [&](const Space::Place& p) {
    for (std::size_t i = 0; i < packed.axes; ++i) {
      grid.low[i] = std::min(grid.low[i], p[i]);
      grid.high[i] = std::max(grid.high[i], p[i]);
    }
  };
  for (const Space::Place& point : points) include(point);
  std::vector<Space::Place> eyes;
  for (const scene::PolyCamera& camera : cameras) eyes.push_back(space.has_depth_only() ? grid.low : space.of(eye_point(model, camera.eye)));
  for (const Space::Place& eye : eyes) include(eye);
  double farthest = 0;
  if (!space.has_depth_only())
    for (const Space::Place& eye : eyes)
      for (const Space::Place& point : points) farthest = std::max(farthest, distance(eye, point));
  // No distance exceeds the largest number of that many bits, even if each difference is rounded up by one: 2 is more than
  // the square root of three.
  grid.largest = (std::int64_t{1} << bits_of(precision)) - 1;
  const auto steps_of = [](double length, std::int64_t most) {
    return static_cast<std::int64_t>(std::ceil(length / static_cast<double>(most)));
  };
  grid.step = std::max(std::int64_t{1}, steps_of(farthest, grid.largest - 2));
  for (std::size_t i = 0; i < packed.axes; ++i) grid.step = std::max(grid.step, steps_of(static_cast<double>(grid.high[i] - grid.low[i]), grid.largest - 1));
  // The directions go from the middle of the grid, so the flight must be there.
  for (std::size_t i = 0; facing && i < packed.axes; ++i) grid.shift[i] = (grid.largest - (grid.high[i] - grid.low[i]) / grid.step) / 2;
  packed.step = grid.step;
  packed.step_in_units = static_cast<double>(packed.step) * space.unit() / willis::lattice_unit;
  packed.error_in_units = 2 * std::sqrt(static_cast<double>(packed.axes)) * packed.step_in_units;
  const FacingTest test(grid, eyes);
  std::vector<SentDirection> directions;
  if (facing) directions = sent_directions(model, space, cameras.front(), test, packed);
  packed.directions = directions.size();
  StreamWriter writer(precision, packed.axes, model.pieces.size(), packed.planes, packed.directions);
  const auto write_point = [&](const std::array<std::uint32_t, 3>& point) { writer.point(std::span(point).first(packed.axes)); };
  for (std::size_t i = directions.size(); i > 0; --i) write_point(directions[i - 1].point);
  if (facing) write_point(test.origin());
  for (std::size_t i = points.size(); i > 0; --i) write_point(grid.rounded(points[i - 1]));
  for (const CellPlane& plane : cells.planes)
    for (const Place place : plane.places) writer.place(place);
  for (std::size_t i = cells.of_piece.size(); i > 0; --i) writer.place(cells.of_piece[i - 1]);
  for (const SentDirection& direction : directions) {
    writer.direction(direction.entries.size());
    for (const Entry& entry : direction.entries) writer.entry(entry.limit, entry.piece, entry.faces_beyond);
  }
  writer.check();
  for (const Space::Place& eye : eyes) {
    const auto at = grid.rounded(eye);
    writer.eye(std::span(at).first(packed.axes));
  }
  packed.stream = writer.end();
  return packed;
}

StreamWriter::StreamWriter(Precision precision, std::size_t axes, std::size_t pieces, std::size_t planes, std::size_t directions) : precision_(precision) {
  for (const char letter : {'F', directions > 0 ? 'F' : 'L'}) byte(static_cast<std::uint8_t>(letter));
  byte(static_cast<std::uint8_t>(precision));
  byte(static_cast<std::uint32_t>(axes));
  byte(static_cast<std::uint32_t>(pieces));
  byte(static_cast<std::uint32_t>(planes));
  if (directions > 0) byte(static_cast<std::uint32_t>(directions));
}

void StreamWriter::place(std::uint8_t place) { byte(place); }

void StreamWriter::direction(std::size_t entries) { byte(static_cast<std::uint32_t>(entries)); }

void StreamWriter::entry(std::uint32_t limit, std::uint8_t piece, bool faces_beyond) {
  for (int shift = 8 * static_cast<int>(precision_); shift >= 0; shift -= 8) byte(limit >> shift);
  byte(piece);
  byte(faces_beyond ? 1 : 0);
}

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
