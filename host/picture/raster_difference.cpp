#include "host/picture/raster_difference.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "host/picture/overlay.hpp"

namespace sightline::picture {
namespace {

constexpr std::int32_t no_point = std::numeric_limits<std::int32_t>::max() / 2;

// The distance from any point of a grid to its lit points: by column in advance, the rest on demand.
class NearestLit {
 public:
  explicit NearestLit(const PixelGrid& grid) : grid_(grid), in_column_(grid.values.size(), no_point) {
    const auto width = static_cast<std::size_t>(grid.width);
    for (std::size_t i = 0; i < in_column_.size(); ++i)
      in_column_[i] = grid.values[i] != 0 ? 0 : i >= width ? one_more(in_column_[i - width]) : no_point;
    for (std::size_t i = in_column_.size(); i-- > width;)
      in_column_[i - width] = std::min(in_column_[i - width], one_more(in_column_[i]));
  }

  // The squared distance. Precondition: some point is lit.
  [[nodiscard]] std::int64_t squared(int column, int row) const {
    std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
    const auto look = [&](int there) {
      if (there < 0 || there >= grid_.width) return;
      const std::int64_t up = in_column_[grid_.index(there, row)];
      const std::int64_t right = there - column;
      nearest = std::min(nearest, right * right + up * up);
    };
    for (int away = 0; std::int64_t{away} * away < nearest && away < grid_.width; ++away) {
      look(column - away);
      look(column + away);
    }
    return nearest;
  }

 private:
  static std::int32_t one_more(std::int32_t distance) { return std::min(distance, no_point - 1) + 1; }

  const PixelGrid& grid_;
  std::vector<std::int32_t> in_column_;  // distance to the nearest lit point in the same column
};

// Most differing points have a lit point within this distance, which is found without searching the whole grid.
constexpr int beside = 4;

// The squared distance; nullopt if no lit point is within `beside`.
std::optional<std::int64_t> squared_beside(const PixelGrid& grid, int column, int row) {
  std::optional<std::int64_t> nearest;
  for (int y = std::max(row - beside, 0); y <= std::min(row + beside, grid.height - 1); ++y) {
    for (int x = std::max(column - beside, 0); x <= std::min(column + beside, grid.width - 1); ++x) {
      if (grid.at(x, y) == 0) continue;
      const std::int64_t right = x - column;
      const std::int64_t up = y - row;
      nearest = std::min(nearest.value_or(std::numeric_limits<std::int64_t>::max()), right * right + up * up);
    }
  }
  // Beyond this distance, a point outside the square may be nearer.
  return nearest && *nearest <= beside * beside ? nearest : std::nullopt;
}

// One direction: from the lit points of one set to those of the other.
struct Direction {
  std::uint64_t lit = 0;
  DifferingPoints apart;
  HausdorffDistance distance;
};

Direction direction_of(const PixelGrid& from, const PixelGrid& to) {
  Direction direction;
  bool empty = true;
  for (std::size_t i = 0; i < from.values.size(); ++i) {
    direction.lit += from.values[i] != 0 ? 1U : 0U;
    direction.apart.all += from.values[i] != 0 && to.values[i] == 0 ? 1U : 0U;
    empty = empty && to.values[i] == 0;
  }
  if (direction.apart.all == 0) return direction;
  if (empty) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    direction.apart.beyond_1 = direction.apart.beyond_2 = direction.apart.all;
    direction.distance = {infinite, infinite};
    return direction;
  }
  std::optional<NearestLit> nearest;  // created on demand
  std::vector<std::int64_t> squares;  // squared distances of the differing points
  squares.reserve(static_cast<std::size_t>(direction.apart.all));
  for (int row = 0; row < from.height; ++row) {
    for (int column = 0; column < from.width; ++column) {
      const std::size_t i = from.index(column, row);
      if (from.values[i] == 0 || to.values[i] != 0) continue;
      auto square = squared_beside(to, column, row);
      if (!square) {
        if (!nearest) nearest.emplace(to);
        square = nearest->squared(column, row);
      }
      squares.push_back(*square);
      direction.apart.beyond_1 += squares.back() > 1 ? 1U : 0U;
      direction.apart.beyond_2 += squares.back() > 4 ? 1U : 0U;
    }
  }
  std::sort(squares.begin(), squares.end());
  // The distances of all lit points in order: the agreeing ones first.
  const std::uint64_t agreeing = direction.lit - direction.apart.all;
  const std::uint64_t usual = direction.lit - 1 - direction.lit / 1000;
  direction.distance.greatest = std::sqrt(static_cast<double>(squares.back()));
  if (usual >= agreeing)
    direction.distance.usual = std::sqrt(static_cast<double>(squares[static_cast<std::size_t>(usual - agreeing)]));
  return direction;
}

}  // namespace

RasterDifference raster_difference(const PixelGrid& reference, const PixelGrid& drawn) {
  assert(reference.width == drawn.width && reference.height == drawn.height);
  const Direction there = direction_of(reference, drawn);
  const Direction back = direction_of(drawn, reference);
  return {there.lit,
          back.lit,
          there.apart,
          back.apart,
          {std::max(there.distance.greatest, back.distance.greatest),
           std::max(there.distance.usual, back.distance.usual)}};
}

Image difference_image(const PixelGrid& reference, const PixelGrid& drawn, int pixels) {
  assert(reference.width == drawn.width && reference.height == drawn.height && pixels >= 1);
  Image image(reference.width * pixels, reference.height * pixels, 3);
  for (int y = 0; y < image.height; ++y) {
    const int row = reference.height - 1 - y / pixels;
    for (int x = 0; x < image.width; ++x) {
      const bool in_reference = reference.at(x / pixels, row) != 0;
      const bool in_drawn = drawn.at(x / pixels, row) != 0;
      const Colour colour = in_reference && in_drawn ? difference_colours::agreed
                            : in_reference           ? difference_colours::missing
                            : in_drawn           ? difference_colours::extra
                                                 : Colour{255, 255, 255};
      const std::size_t at = image.index(x, y);
      image.pixels[at] = colour.red;
      image.pixels[at + 1] = colour.green;
      image.pixels[at + 2] = colour.blue;
    }
  }
  return image;
}

}  // namespace sightline::picture
