#include "host/guests/flight/packing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::guests::flight {

namespace {

namespace willis = algorithms::willis;
using willis::Model;

willis::Point eye_point(const Model& model, const scene::PolyPoint& eye) {
  willis::Point point = willis::on_lattice(eye);
  if (model.plan) point[model.vertical] = 0;
  return point;
}

base::Error too_many(const Model& model) {
  std::uint32_t bodies = 0;
  for (const willis::Surface& piece : model.pieces) bodies = std::max(bodies, piece.body + 1);
  std::vector<std::size_t> counts(bodies);
  for (const willis::Surface& piece : model.pieces) ++counts[piece.body];
  const auto most = std::max_element(counts.begin(), counts.end());
  return {.found = fmt::format("{} pieces, {} more than the machine holds; body {} is cut into most of them, {}", model.pieces.size(),
                               model.pieces.size() - most_pieces, most - counts.begin(), *most),
          .expected = fmt::format("at most {}", most_pieces),
          .remedy = "a flight past the nearest pieces (--pieces), in plan (--plan), or a smaller scene"};
}

// Bits of a coordinate.
int bits_of(Precision precision) {
  switch (precision) {
    case Precision::bits_8: return 8;
    case Precision::bits_12: return 12;
    case Precision::bits_16: return 16;
  }
  return 8;
}

}  // namespace

base::Result<Model> flight_model(const scene::PolyScene& scene, const willis::ModelOptions& options, const scene::PolyPoint& eye,
                                 std::optional<std::size_t> pieces) {
  auto made = willis::make_model(scene, options);
  if (!made) return made.error();
  Model model = std::move(*made);
  if (model.cells.cells > 1) {
    return base::Error{.found = fmt::format("solids that touch, or are not convex: {} cells whose order is no matter of distance", model.cells.cells),
                       .expected = "1",
                       .remedy = "a scene of convex solids that do not touch; `sightline draw willis` draws this one"};
  }
  if (model.pieces.size() > most_pieces && !pieces) return too_many(model);
  if (model.pieces.empty()) return base::Error{.found = "no pieces", .expected = "at least one"};
  const willis::Point from = eye_point(model, eye);
  std::vector<std::size_t> order(model.pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::uint64_t> distances;
  for (const willis::Surface& piece : model.pieces) distances.push_back(willis::squared_distance(from, piece.points[0]));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  if (pieces) order.resize(std::min({order.size(), *pieces, most_pieces}));
  std::vector<willis::Surface> chosen;
  for (const std::size_t i : order) chosen.push_back(std::move(model.pieces[i]));
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
  return model;
}

Packed pack(const Model& model, std::span<const scene::PolyCamera> cameras, Precision precision) {
  Packed packed;
  packed.precision = precision;
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!model.plan || axis != model.vertical) axes.push_back(axis);
  packed.axes = axes.size();
  std::vector<willis::Point> eyes;
  for (const scene::PolyCamera& camera : cameras) eyes.push_back(eye_point(model, camera.eye));
  willis::Point low = eyes[0];
  willis::Point high = eyes[0];
  const auto include = [&](const willis::Point& p) {
    for (const std::size_t axis : axes) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  };
  std::uint64_t farthest = 0;
  for (const willis::Point& eye : eyes) {
    include(eye);
    for (const willis::Surface& piece : model.pieces) farthest = std::max(farthest, willis::squared_distance(eye, piece.points[0]));
  }
  for (const willis::Surface& piece : model.pieces) include(piece.points[0]);
  // No distance is above the largest number of so many bits, though each difference may be rounded up by one: 2 is more than the
  // root of three.
  const std::int64_t largest = (std::int64_t{1} << bits_of(precision)) - 1;
  const auto steps_of = [](double length, std::int64_t most) {
    return static_cast<std::int64_t>(std::ceil(length / static_cast<double>(most)));
  };
  packed.step = std::max(std::int64_t{1}, steps_of(std::sqrt(static_cast<double>(farthest)), largest - 2));
  for (const std::size_t axis : axes)
    packed.step = std::max(packed.step, steps_of(static_cast<double>(std::int64_t{high[axis]} - low[axis]), largest - 1));
  packed.step_in_units = static_cast<double>(packed.step) / willis::lattice_unit;
  packed.error_in_units = 2 * std::sqrt(static_cast<double>(axes.size())) * packed.step_in_units;
  const auto coordinates = [&](const willis::Point& p) {
    std::array<std::uint32_t, 3> rounded{};
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const std::int64_t from_low = std::int64_t{p[axes[i]]} - low[axes[i]];
      rounded[i] = static_cast<std::uint32_t>((from_low + packed.step / 2) / packed.step);
    }
    return rounded;
  };
  StreamWriter writer(precision, axes.size(), model.pieces.size());
  for (std::size_t i = model.pieces.size(); i > 0; --i) {
    const auto point = coordinates(model.pieces[i - 1].points[0]);
    writer.point(std::span(point).first(axes.size()));
  }
  writer.check();
  for (const willis::Point& eye : eyes) {
    const auto at = coordinates(eye);
    writer.eye(std::span(at).first(axes.size()));
  }
  packed.stream = writer.end();
  return packed;
}

StreamWriter::StreamWriter(Precision precision, std::size_t axes, std::size_t pieces) : precision_(precision) {
  for (const char letter : {'F', 'L'}) byte(static_cast<std::uint8_t>(letter));
  byte(static_cast<std::uint8_t>(precision));
  byte(static_cast<std::uint32_t>(axes));
  byte(static_cast<std::uint32_t>(pieces));
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

}  // namespace sightline::guests::flight
